//! One frame at a time: what is left to compare where motions part for reasons of their own.

use super::compare::{Answer, compare};
use super::outlook::Outlook;
use super::reference::{Beside, Found};
use super::sensitivity::Sensitivity;
use crate::drive::Drive;
use crate::element::Loop;
use crate::settings::{Method, Settings};
use crate::simulation::Simulation;
use solaris_model::Motion;

/// Single frames, each begun from a state of the reference.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Agreement {
    /// How many.
    pub frames: usize,
    /// The greatest difference of positions at the end of a frame (rad or m).
    pub position: f64,
    /// Of velocities (rad/s or m/s).
    pub velocity: f64,
}

/// How many frames are tried.
const FRAMES: usize = 8;

/// Simulations of one frame each, with the motion that is right.
pub(super) struct Frames(Vec<(Simulation, Motion)>);

impl Frames {
    /// Frames of a motion that cannot be compared to its end, spread over it; nothing where it can be, or where drives
    /// have a clock, which a run from a later state would set back.
    pub(super) fn of(simulation: &Simulation, found: &Found, sensitivity: &Sensitivity) -> Option<Self> {
        let is_timed = |closed: &Loop| closed.from > 0.0 || closed.until.is_finite();
        let of_its_own = simulation.pushes.is_empty()
            && simulation.carries.is_empty()
            && !simulation.loops.iter().any(is_timed);
        let timeless = of_its_own && simulation.drives.iter().all(
            |steps| matches!(steps.as_slice(), [step] if matches!(step.drive, Drive::Free | Drive::Frozen)),
        );
        let beside = found.beside.as_ref().filter(|_| timeless && sensitivity.is_chaotic);
        let Beside { method, motion } = beside?;
        let rate = motion.info.rate;
        let settings =
            Settings { forces: false, estimate: false, method: *method, ..Settings::new(1.0 / rate, rate) };
        let frames = (0..FRAMES).filter_map(|index| {
            let sample = index * motion.len().saturating_sub(1) / FRAMES;
            let mut from = simulation.clone();
            from.set_start(motion.q(sample), motion.v(sample)).ok()?;
            let run = from.run(&settings).ok()?;
            Some((from, run.motion))
        });
        Some(Self(frames.collect()))
    }

    /// How far a method is off; nothing where a frame failed.
    pub(super) fn agreement(
        &self,
        settings: &Settings,
        method: Method,
        observer: &mut Outlook<'_>,
    ) -> Option<Agreement> {
        let settings = Settings { method, duration: 1.0 / settings.rate, ..settings.clone() };
        let mut worst = Agreement { frames: self.0.len(), ..Agreement::default() };
        for (simulation, right) in &self.0 {
            let run = simulation.run_observed(&settings, observer).ok()?;
            let answer = Answer::Motion(right);
            let (position, velocity) = compare(simulation.figure(), &run.motion, &answer, f64::INFINITY);
            worst.position = worst.position.max(position);
            worst.velocity = worst.velocity.max(velocity);
        }
        Some(worst)
    }
}
