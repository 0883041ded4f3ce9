//! Force plates that stand in the motion's own file, and the feet on them.

use crate::words::short;
use solaris_analysis::PreparedMotion;
use solaris_analysis::ground::{GroundError, PlacedFeet, PlateRecord, Sole, feet_on_plates};
use solaris_io::markers::{LoadOptions, Plate};
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
        if plates.is_empty() {
            return Ok(Self::default());
        }
        let Some(soles) = soles else {
            return Ok(Self { forces: Vec::new(), words: vec![unknown.to_owned()] });
        };
        let feet = PlacedFeet::new(prepared, soles)?;
        let start = motion.time().first().copied().unwrap_or_default().min(0.0);
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
