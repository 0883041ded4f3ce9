//! Forces that plates measured, beside those that were found.

use super::predicted::Predicted;
use crate::args::{AskedPlate, GroundCommandArgs};
use crate::error::CliError;
use crate::given::Given;
use crate::input;
use crate::plausible::Plausibility;
use crate::words::short;
use serde::Serialize;
use solaris::analysis::PreparedMotion;
use solaris::analysis::ground::{PlacedFeet, Sole};
use solaris::files::{External, Source};
use solaris::io::record;
use solaris::model::{ContactTrack, Figure, MeasuredForce, Vector3, nearest};
use std::path::Path;

/// What plates measured under the soles.
pub(super) struct Plates {
    /// Index of the sole, and what was measured under it.
    feet: Vec<(usize, MeasuredForce)>,
}

/// How far forces are from measured ones, along the world's axes.
#[derive(Clone, Copy, Serialize)]
pub(crate) struct Beside {
    /// Root of the mean square of the difference.
    rms_n: [f64; 3],
    rms_of_weight: [f64; 3],
    /// Correlation; absent where one of the two does not change.
    r: [Option<f64>; 3],
    /// The frames that were compared.
    frames: usize,
}

impl Plates {
    /// What the options name, for these soles of the figure; none without any.
    pub(super) fn read(
        args: &GroundCommandArgs,
        figure: &Figure,
        soles: &[Sole],
    ) -> Result<Option<Self>, CliError> {
        if let Some(path) = &args.loads {
            return Self::described(path, figure, soles).map(Some);
        }
        let Some(path) = &args.against else { return Ok(None) };
        let table = input::table(path)?;
        let mut feet: Vec<(usize, MeasuredForce)> = Vec::new();
        for AskedPlate { foot, prefix } in &args.plates {
            let fault = |why: String| CliError::option("plate", format!("{foot}={prefix}"), why);
            let Some(sole) = soles.iter().position(|sole| sole.name == *foot) else {
                let names: Vec<&str> = soles.iter().map(|sole| &*sole.name).collect();
                let hint = nearest(foot, names.iter().copied())
                    .map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
                return Err(fault(format!("no sole has this name, but {}{hint}", names.join(", "))));
            };
            if feet.iter().any(|(other, _)| *other == sole) {
                return Err(fault("this sole has a plate already; name each once".to_owned()));
            }
            let links = [figure.links()[soles[sole].foot].name().to_owned()];
            let record =
                record::forces(&table, &links, prefix).map_err(|error| CliError::input(path, &error))?;
            feet.push((sole, record));
        }
        Ok(Some(Self { feet }))
    }

    /// What OpenSim's description names, by the links of the soles.
    fn described(path: &Path, figure: &Figure, soles: &[Sole]) -> Result<Self, CliError> {
        let mut feet: Vec<(usize, MeasuredForce)> = Vec::new();
        for record in External::read(Source::disk(), &[], [None, Some(path)])?.records(figure)? {
            let link = figure.link_index(&record.links[0]);
            let Some(sole) = soles.iter().position(|sole| Some(sole.foot) == link || sole.toes == link)
            else {
                let names: Vec<&str> = soles.iter().map(|sole| figure.links()[sole.foot].name()).collect();
                let why = format!("no sole is on '{}', but on {}", record.links[0], names.join(", "));
                return Err(CliError::input(path, &why));
            };
            if feet.iter().any(|(other, _)| *other == sole) {
                let why =
                    format!("two forces act on '{}'; one plate a sole is held against", record.links[0]);
                return Err(CliError::input(path, &why));
            }
            feet.push((sole, record));
        }
        Ok(Self { feet })
    }

    /// Whether they fit the motion, as the soles of the ground that was found stand in it.
    pub(super) fn plausibility(
        &self,
        given: &Given,
        prepared: &PreparedMotion<'_>,
        ground: &Predicted,
    ) -> Result<Plausibility, CliError> {
        let feet = PlacedFeet::new(prepared, &*ground.soles)
            .map_err(|error| CliError::input(&given.from, &error))?;
        let measured: Vec<MeasuredForce> = self.feet.iter().map(|(_, record)| record.clone()).collect();
        Plausibility::on(given, &feet, &ground.forces.stances, &measured)
    }

    /// Index of the sole, and what was measured under it.
    pub(super) fn feet(&self) -> impl Iterator<Item = (usize, &MeasuredForce)> {
        self.feet.iter().map(|(sole, record)| (*sole, record))
    }

    /// The forces of soles beside these: by sole, and of all of them that have a plate together.
    pub(super) fn beside(
        &self,
        time: &[f64],
        tracks: &[ContactTrack],
        weight: f64,
    ) -> (Vec<Option<Beside>>, Option<Beside>) {
        let mut each = vec![None; tracks.len()];
        let mut all: Vec<Option<[Vector3<f64>; 2]>> = vec![Some([Vector3::zeros(); 2]); time.len()];
        for (sole, record) in self.feet() {
            let pairs: Vec<Option<[Vector3<f64>; 2]>> = time
                .iter()
                .zip(&tracks[sole].samples)
                .map(|(time, found)| Some([found.force, force_at(record, *time)?]))
                .collect();
            for (sum, pair) in all.iter_mut().zip(&pairs) {
                *sum = sum.zip(*pair).map(|(sum, pair)| [sum[0] + pair[0], sum[1] + pair[1]]);
            }
            each[sole] = Beside::of(&pairs, weight);
        }
        (each, Beside::of(&all, weight))
    }
}

/// The force that was measured at a time, linear between two samples; none outside of them.
fn force_at(record: &MeasuredForce, time: f64) -> Option<Vector3<f64>> {
    let after = record.time.partition_point(|sample| *sample < time);
    let later = record.samples.get(after)?.force;
    let Some(before) = after.checked_sub(1) else { return (record.time[0] <= time).then_some(later) };
    let [from, to] = [record.time[before], record.time[after]];
    Some(record.samples[before].force.lerp(&later, (time - from) / (to - from)))
}

impl Beside {
    /// Of pairs of what was found and what was measured; none without any.
    fn of(pairs: &[Option<[Vector3<f64>; 2]>], weight: f64) -> Option<Self> {
        let pairs: Vec<[Vector3<f64>; 2]> = pairs.iter().copied().flatten().collect();
        let count = pairs.len() as f64;
        if pairs.is_empty() {
            return None;
        }
        let mean = pairs.iter().fold([Vector3::zeros(); 2], |sum, pair| [sum[0] + pair[0], sum[1] + pair[1]]);
        let mean = mean.map(|sum| sum / count);
        let along = |axis: usize| {
            let sum = |of: &dyn Fn(&[Vector3<f64>; 2]) -> f64| pairs.iter().map(of).sum::<f64>();
            let from_mean = |pair: &[Vector3<f64>; 2], k: usize| pair[k][axis] - mean[k][axis];
            let rms = (sum(&|pair| (pair[0][axis] - pair[1][axis]).powi(2)) / count).sqrt();
            let squares = sum(&|pair| from_mean(pair, 0).powi(2)) * sum(&|pair| from_mean(pair, 1).powi(2));
            let r = sum(&|pair| from_mean(pair, 0) * from_mean(pair, 1)) / squares.sqrt();
            (rms, r.is_finite().then_some(r))
        };
        let [x, y, z] = [0, 1, 2].map(along);
        let rms_n = [x.0, y.0, z.0];
        let rms_of_weight = rms_n.map(|rms| rms / weight);
        Some(Self { rms_n, rms_of_weight, r: [x.1, y.1, z.1], frames: pairs.len() })
    }

    /// In words: "2.1, 3.7, 2.2 % of the weight (rms) along x, y, z; r 0.95, 0.99, 0.81".
    pub(super) fn words(&self) -> String {
        let rms = self.rms_of_weight.map(|rms| short((1e4 * rms).round() / 1e2)).join(", ");
        let r = self.r.map(|r| r.map_or("-".to_owned(), |r| format!("{r:.3}"))).join(", ");
        format!("off by {rms} % of the weight (rms) along x, y, z; r {r}; {} frames", self.frames)
    }
}
