//! The durations of the phases: the parts of a step's time.

use super::super::cycle::Cycle;
use super::super::posture::KeyPosture;
use super::super::proportions::Proportions;
use super::super::timing::DoubleSupport;
use super::closed::FiveAngles;
use super::cycles::{Upper, phases, posture_before};

/// How long the phases are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Timing {
    /// A quarter of a step each: Fig 8.1.
    Quarters,
    /// Phase 2 lasts the double support, for both feet are on the ground in it only; the rest is shared by the pelvis' way.
    DoubleSupport(DoubleSupport),
    /// All by the pelvis' way: it then goes on most evenly, by 0.86 to 1.11 of its mean speed.
    #[default]
    Travel,
}

/// Least part of a step that a phase takes.
const LEAST: f64 = 0.01;

impl Timing {
    /// Parts of a step's time that phases 1 to 4 take; their sum is 1.
    ///
    /// The starting cycle takes those of 3 and 4, the finishing one those of 1 to 3. A phase in which the pelvis hardly moves
    /// is given a hundredth of a step.
    pub fn parts(self, p: &Proportions, angles: &FiveAngles, step_frequency: f64) -> [f64; 4] {
        let way = pelvis_travel(p, angles).map(|way| (way / angles.parameters.step_length).max(LEAST));
        let sum: f64 = way.iter().sum();
        match self {
            Self::Quarters => [0.25; 4],
            Self::Travel => way.map(|way| way / sum),
            Self::DoubleSupport(law) => {
                let double = law.part_of_step(step_frequency).clamp(LEAST, 1.0 - 3.0 * LEAST);
                let rest = sum - way[1];
                let mut parts = way.map(|way| way / rest * (1.0 - double));
                parts[1] = double;
                parts
            }
        }
    }
}

/// How far the middle of the pelvis goes forward in phases 1 to 4; the sum is the step length.
pub fn pelvis_travel(p: &Proportions, angles: &FiveAngles) -> [f64; 4] {
    // Arms and trunk do not carry the pelvis.
    let upper = Upper::automatic(angles, 0.0);
    let mut before = posture_before(angles, &upper, Cycle::Intermediate);
    let mut way = [0.0; 4];
    for (way, phase) in way.iter_mut().zip(phases(angles, &upper, Cycle::Intermediate)) {
        let leg = usize::from(phase.root.swing);
        // The pelvis' middle from the root's point.
        let middle = |posture: &KeyPosture| {
            let hip = posture.legs[leg].hip_over(p, phase.root.point, [0.0, 0.0])[0];
            let half = 0.5 * posture.swing_hip(p)[0];
            if phase.root.swing { hip - half } else { hip + half }
        };
        *way = middle(&phase.end) - middle(&before);
        before = phase.end;
    }
    way
}
