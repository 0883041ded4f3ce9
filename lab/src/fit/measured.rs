//! A measured stride: a person on a treadmill between force plates; the recording is no part of the project.
//!
//! Angles of joints are those of the three-dimensional model, whose record covers a whole stride only in parts of two: what is
//! known of a clock is its mean over both legs and all strides. The treadmill's person leans back by 20°; only legs and loads are taken.

use super::stride::Case;
use crate::workspace;
use solaris_io::{Table, sto};
use std::fs;
use std::path::Path;

/// Height (m) and mass (kg), step frequency (1/min) and step length (m): of `reference_facts.json`.
const PERSON: [f64; 4] = [1.803, 72.6, 97.8, 0.696];
/// First contacts of the right and the left foot, and their strides' times (s).
const CONTACTS: [(f64, f64); 2] = [(0.6183, 1.2350), (1.2467, 1.2133)];
/// Frames a second of the forces; their times are rounded.
const RATE: f64 = 600.0;
/// The part of the joints' record that a filter left alone (s).
const JOINTS: (f64, f64) = (0.42, 1.58);

/// A person's stride: the same numbers as of ours.
pub(crate) struct Measured {
    pub(crate) case: Case,
    /// Hip, knee and ankle at 0, 5, … 95 % (°).
    pub(crate) curves: Vec<f64>,
    /// Vertical force at 0, 2, … 98 % (%BW).
    pub(crate) vertical: Vec<f64>,
}

impl Measured {
    /// The person's stride, or nothing where the data is not there.
    pub(crate) fn read() -> Result<Option<Self>, String> {
        let folder = workspace::root().join("../shared/data/subject01_walk");
        if !folder.is_dir() {
            eprintln!("fit: no {}: nobody measured is fitted to", folder.display());
            return Ok(None);
        }
        let [height, mass, step_frequency, step_length] = PERSON;
        let case = Case::of_person(height, mass, step_frequency, step_length)?;
        let joints = read(&folder.join("subject01_walk_ik_3d23.mot"))?;
        let forces = read(&folder.join("subject01_walk_grf.mot"))?;
        let mut curves = Vec::new();
        for (name, sign) in [("hip_flexion", 1.0), ("knee_angle", -1.0), ("ankle_angle", 1.0)] {
            for k in 0..20 {
                let mut known = Vec::new();
                for (side, (contact, stride)) in ["r", "l"].iter().zip(CONTACTS) {
                    let value = column(&joints, &format!("{name}_{side}"))?;
                    let time = column(&joints, "time")?;
                    for turn in [-1.0, 0.0, 1.0] {
                        let at = contact + (f64::from(k) / 20.0 + turn) * stride;
                        if (JOINTS.0..=JOINTS.1).contains(&at) {
                            known.push(sign * between(&time, &value, at));
                        }
                    }
                }
                curves.push(known.iter().sum::<f64>() / known.len() as f64);
            }
        }
        let weight = mass * 9.80665;
        let mut vertical = vec![0.0; 50];
        for (name, (contact, stride)) in ["ground_force_vy", "1_ground_force_vy"].iter().zip(CONTACTS) {
            let value = column(&forces, name)?;
            let time: Vec<f64> = (0..value.len()).map(|i| i as f64 / RATE).collect();
            for (k, sum) in vertical.iter_mut().enumerate() {
                *sum += 50.0 * between(&time, &value, contact + k as f64 / 50.0 * stride) / weight;
            }
        }
        Ok(Some(Self { case, curves, vertical }))
    }

    /// What curves differ by from the person's, the hip's but for their mean: the person's pelvis was marked some 9° otherwise than
    /// the leg's length allows.
    pub(crate) fn differences(&self, curves: &[f64]) -> Vec<f64> {
        let mut all: Vec<f64> = curves.iter().zip(&self.curves).map(|(ours, theirs)| ours - theirs).collect();
        let mean = all[..20].iter().sum::<f64>() / 20.0;
        for difference in &mut all[..20] {
            *difference -= mean;
        }
        all
    }
}

fn read(path: &Path) -> Result<Table, String> {
    let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
    sto::read(&text).map_err(|error| format!("{}: {error}", path.display()))
}

fn column(table: &Table, name: &str) -> Result<Vec<f64>, String> {
    let width = table.columns.len();
    let at = table.columns.iter().position(|column| column == name).ok_or(format!("no column '{name}'"))?;
    Ok(table.values.iter().skip(at).step_by(width).copied().collect())
}

fn between(time: &[f64], value: &[f64], at: f64) -> f64 {
    let i = time.partition_point(|t| *t <= at).clamp(1, time.len() - 1);
    let part = (at - time[i - 1]) / (time[i] - time[i - 1]);
    value[i - 1] + part * (value[i] - value[i - 1])
}

/// Root of the mean square.
pub(crate) fn apart(differences: &[f64]) -> f64 {
    (differences.iter().map(|x| x * x).sum::<f64>() / differences.len() as f64).sqrt()
}
