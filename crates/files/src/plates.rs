//! Force plates of which nobody says who stands on them: in the motion's own file, or in a table; and the feet on them.

use crate::words::short;
use solaris_analysis::PreparedMotion;
use solaris_analysis::ground::{GroundError, PlacedFeet, PlateRecord, Sole, feet_on_plates};
use solaris_io::markers::{LoadOptions, Plate};
use solaris_io::{IoError, Table, record as table_record};
use solaris_model::{Contact, MeasuredForce, Motion};

/// What the plates of a recording do to the feet, and what there is to say about it.
#[derive(Clone, Debug, Default)]
pub struct OwnPlates {
    /// The forces on the feet.
    pub forces: Vec<MeasuredForce>,
    /// Which foot stood on which plate, and when.
    pub words: Vec<String>,
}

impl OwnPlates {
    /// Nothing where the recording has no plates; no forces where nobody knows the feet, and `unknown` is said then.
    ///
    /// # Errors
    ///
    /// Soles that are none.
    pub fn of(
        plates: &[Plate],
        (motion, prepared): (&Motion, &PreparedMotion<'_>),
        soles: Option<Vec<Sole>>,
        unknown: &str,
    ) -> Result<Self, GroundError> {
        let start = motion.time().first().copied().unwrap_or_default().min(0.0);
        let records: Vec<PlateRecord> = plates.iter().map(|plate| record(plate, start)).collect();
        Self::of_records(&records, prepared, soles, unknown)
    }

    /// The same of what plates recorded.
    ///
    /// # Errors
    ///
    /// As [`OwnPlates::of`].
    pub fn of_records(
        records: &[PlateRecord],
        prepared: &PreparedMotion<'_>,
        soles: Option<Vec<Sole>>,
        unknown: &str,
    ) -> Result<Self, GroundError> {
        if records.is_empty() {
            return Ok(Self::default());
        }
        let Some(soles) = soles else {
            return Ok(Self { forces: Vec::new(), words: vec![unknown.to_owned()] });
        };
        let feet = PlacedFeet::new(prepared, soles)?;
        let (forces, loads) = feet_on_plates(&feet, records);
        let mut words: Vec<String> = Vec::new();
        for loads in loads.chunk_by(|a, b| a.foot.is_some() && (a.plate, a.foot) == (b.plate, b.foot)) {
            let spans: Vec<String> = loads
                .iter()
                .map(|load| format!("{} to {}", short(load.span.0), short(load.span.1)))
                .collect();
            let (load, spans) = (&loads[0], spans.join(", "));
            let name = &records[load.plate].name;
            words.push(match load.foot {
                Some(foot) => format!("{name}: {} from {spans} s", feet.soles()[foot].name),
                None if load.distance.is_infinite() => {
                    format!("{name}: loaded from {spans} s, which the motion does not cover")
                }
                None => format!(
                    "{name}: loaded from {spans} s ({} N), {} m from the nearest foot: left out",
                    short(load.force),
                    short(load.distance)
                ),
            });
        }
        Ok(Self { forces, words })
    }
}

/// What a plate recorded, with moments about the world's origin.
fn record(plate: &Plate, start: f64) -> PlateRecord {
    let loads = plate.loads(&LoadOptions::default());
    let time = (0..loads.len()).map(|i| start + i as f64 / plate.rate).collect();
    let samples = loads.iter().map(|load| {
        let cop = load.centre.unwrap_or_default();
        Contact { force: load.force, moment: load.free_moment + cop.cross(&load.force), cop }
    });
    PlateRecord { name: format!("plate {}", plate.number), time, samples: samples.collect() }
}

/// What the force plates of a table recorded, numbered in its order, with what their columns' names begin with.
pub(crate) fn table_plates(table: &Table) -> Result<Vec<PlateRecord>, IoError> {
    let table = table.without_repeated_times();
    let record = |(i, prefix): (usize, &String)| {
        let MeasuredForce { time, samples, .. } = table_record::forces(&table, &[], prefix)?;
        let called = if prefix.is_empty() { String::new() } else { format!(" ('{prefix}')") };
        let name = format!("plate {}{called}", i + 1);
        Ok(PlateRecord { name, time, samples })
    };
    table_record::force_prefixes(&table).iter().enumerate().map(record).collect()
}
