//! Force plates that stand in the motion's own file, and the feet on them.

use crate::error::CliError;
use crate::given::Given;
use crate::words::short;
use solaris::analysis::PreparedMotion;
use solaris::analysis::ground::{PlacedFeet, PlateRecord, Sole, feet_on_plates};
use solaris::io::markers::{LoadOptions, Plate};
use solaris::model::{Contact, MeasuredForce};

/// What the plates of a recording do to the feet, and what there is to say about it.
#[derive(Default)]
pub(super) struct OwnPlates {
    pub(super) forces: Vec<MeasuredForce>,
    /// Which foot stood on which plate, and when.
    pub(super) words: Vec<String>,
}

impl OwnPlates {
    /// Nothing where the recording has no plates or the figure no feet.
    pub(super) fn of(
        given: &Given,
        prepared: &PreparedMotion<'_>,
        soles: Option<Vec<Sole>>,
    ) -> Result<Self, CliError> {
        let plates = given.fitted.as_ref().map_or(&[][..], |fitted| &fitted.recording.plates);
        if plates.is_empty() {
            return Ok(Self::default());
        }
        let Some(soles) = soles else {
            let words =
                "the feet on them are not known; name soles by --soles, or plates by --plate".to_owned();
            return Ok(Self { forces: Vec::new(), words: vec![words] });
        };
        let feet = PlacedFeet::new(prepared, soles).map_err(|error| CliError::input(&given.from, &error))?;
        let start = given.motion().time().first().copied().unwrap_or_default().min(0.0);
        let records: Vec<PlateRecord> = plates.iter().map(|plate| record(plate, start)).collect();
        let (forces, loads) = feet_on_plates(&feet, &records);
        let words = loads.iter().map(|load| {
            let (from, to) = (short(load.span.0), short(load.span.1));
            let name = &records[load.plate].name;
            match load.foot {
                Some(foot) => format!("{name}: {} from {from} to {to} s", feet.soles()[foot].name),
                None if load.distance.is_infinite() => {
                    format!("{name}: loaded from {from} to {to} s, which the motion does not cover")
                }
                None => format!(
                    "{name}: loaded from {from} to {to} s ({} N), {} m from the nearest foot: left out",
                    short(load.force),
                    short(load.distance)
                ),
            }
        });
        Ok(Self { words: words.collect(), forces })
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
