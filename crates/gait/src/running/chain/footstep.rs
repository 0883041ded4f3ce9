//! One stance in a chain of steps, and the laws of its forces: of one foot in full run, of both feet where the run begins or ends.

use super::basis::{Basis, Priors};
use super::stood::{Begin, Finish};
use super::walked::{Arrival, Launch};
use crate::running::forces::{FORE_AFT_SPREAD, LATERAL, LATERAL_SPREAD, TWIST_SPREAD};
use crate::running::laws::{ForceLaws, on_ground};
use crate::running::style::RunStyle;
use solaris_profiles::ProfileError;

/// How a stance's forces are made.
#[derive(Clone, Debug)]
enum Kind {
    /// Of one foot in full run.
    Stride {
        laws: ForceLaws,
        /// Its vertical impulse over the weight's of half a stride.
        share: f64,
        /// Impulse of the half wave that makes the body faster (s).
        half_wave: f64,
        /// How far it may lie beside its line (m).
        aside: f64,
    },
    Begin(Begin),
    Finish(Finish),
    Launch(Launch),
    Arrival(Arrival),
}

/// What a foot does in a stance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// It lands and leaves in full run.
    Runs,
    /// It stands and leaves, before the other or after it.
    LeavesFirst,
    LeavesLast,
    /// A walk has set it down, and it leaves in a run.
    Launches,
    /// It lands in a run, and a walk goes on from it.
    Arrives,
    /// It lands to stand, before the other or beside it.
    Stops,
    Closes,
}

/// One stance, named after the foot that bears most of it.
#[derive(Clone, Debug)]
pub(super) struct Footstep {
    /// Left 0, right 1.
    pub(super) side: usize,
    /// When it touches (s); its own clock counts strides from then on.
    pub(super) time: f64,
    /// The style of its stance.
    pub(super) style: RunStyle,
    kind: Kind,
}

/// Parts of a stance in which the half wave is summed.
const SUMMED: u32 = 1000;
/// By which part of itself a step's vertical impulse may differ, and how far a print may lie beside its line (m).
const LIFT_SPREAD: f64 = 0.02;
const ASIDE_SPREAD: f64 = 0.003;

impl Footstep {
    /// `around` is the time from the middle of the flight before to that after it (s), `beside` how far it may lie beside its line (m)
    /// where that is more than usual.
    pub(super) fn running(
        side: usize,
        time: f64,
        style: &RunStyle,
        around: f64,
        beside: f64,
        nodes: usize,
    ) -> Result<Self, ProfileError> {
        let laws = ForceLaws::new(style, nodes)?;
        let part = |i: u32| (f64::from(i) + 0.5) / f64::from(SUMMED);
        let mean = (0..SUMMED).map(|i| -laws.at(part(i)).lateral[0]).sum::<f64>() / f64::from(SUMMED);
        let share = around / (0.5 * style.stride_time);
        let kind = Kind::Stride {
            laws,
            share,
            half_wave: mean * style.contact_time(),
            aside: beside.max(ASIDE_SPREAD),
        };
        Ok(Self { side, time, style: *style, kind })
    }

    /// Both feet stand, and the one on `side` leaves last.
    pub(super) fn begin(side: usize, style: &RunStyle, begin: Begin) -> Self {
        Self { side, time: 0.0, style: *style, kind: Kind::Begin(begin) }
    }

    /// The foot on `side` lands, and the other beside it.
    pub(super) fn finish(side: usize, time: f64, style: &RunStyle, finish: Finish) -> Self {
        Self { side, time, style: *style, kind: Kind::Finish(finish) }
    }

    /// The foot on `side` stands as a walk has set it down, and leaves.
    pub(super) fn launch(style: &RunStyle, launch: Launch) -> Self {
        Self { side: launch.seam.side, time: 0.0, style: *style, kind: Kind::Launch(launch) }
    }

    /// The foot on `side` lands in a run, and a walk goes on from it.
    pub(super) fn arrival(style: &RunStyle, arrival: Arrival) -> Self {
        let (side, time) = (arrival.seam.side, arrival.lands);
        Self { side, time, style: *style, kind: Kind::Arrival(arrival) }
    }

    /// When the body is in the air again, or at rest (s).
    pub(super) fn end(&self) -> f64 {
        match &self.kind {
            Kind::Stride { .. } => self.time + self.style.contact_time(),
            Kind::Begin(begin) => begin.last,
            Kind::Launch(launch) => launch.last,
            Kind::Arrival(arrival) => arrival.seam.at,
            Kind::Finish(finish) => self.time + finish.rest,
        }
    }

    /// Which foot stands from when to when, and what it does; the end of a foot that stays is none.
    pub(super) fn feet(&self) -> Vec<(usize, Role, f64, Option<f64>)> {
        let (own, other) = (self.side, 1 - self.side);
        match &self.kind {
            Kind::Stride { .. } => vec![(own, Role::Runs, self.time, Some(self.end()))],
            Kind::Begin(begin) => vec![
                (other, Role::LeavesFirst, self.time, Some(begin.first)),
                (own, Role::LeavesLast, self.time, Some(begin.last)),
            ],
            Kind::Launch(launch) => vec![(own, Role::Launches, self.time, Some(launch.last))],
            Kind::Arrival(_) => vec![(own, Role::Arrives, self.time, None)],
            Kind::Finish(finish) => vec![
                (own, Role::Stops, self.time, None),
                (other, Role::Closes, self.time + finish.beside, None),
            ],
        }
    }

    pub(super) fn stands(&self, time: f64) -> bool {
        match &self.kind {
            Kind::Stride { .. } => on_ground(self.part(time)),
            Kind::Begin(_) | Kind::Launch(_) => time < self.end(),
            Kind::Finish(_) | Kind::Arrival(_) => time > self.time,
        }
    }

    fn part(&self, time: f64) -> f64 {
        (time - self.time) / self.style.contact_time()
    }

    pub(super) fn priors(&self) -> Priors {
        match &self.kind {
            Kind::Stride { aside, .. } => {
                let mut priors = Priors::default();
                let braking = [self.style.braking, 0.0, 0.0];
                for n in 0..3 {
                    priors.fore_aft[n] = (braking[n], FORE_AFT_SPREAD[n]);
                    priors.lateral[n] = (LATERAL[n], LATERAL_SPREAD[n]);
                }
                priors.twist = TWIST_SPREAD.map(|spread| (0.0, spread));
                priors.lifts[0] = (1.0, LIFT_SPREAD);
                priors.aside = (0.5 * self.style.step_width, *aside);
                priors
            }
            Kind::Begin(begin) => begin.priors(),
            Kind::Launch(launch) => launch.priors(),
            Kind::Arrival(arrival) => arrival.priors(),
            Kind::Finish(finish) => finish.priors(),
        }
    }

    pub(super) fn basis(&self, time: f64) -> Basis {
        match &self.kind {
            Kind::Begin(begin) => begin.basis(time),
            Kind::Launch(launch) => launch.basis(time),
            Kind::Arrival(arrival) => arrival.basis(time),
            Kind::Finish(finish) => finish.basis(time - self.time),
            Kind::Stride { laws, share, half_wave, .. } => {
                let part = self.part(time);
                if !on_ground(part) {
                    return Basis::default();
                }
                let at = laws.at(part);
                let mut basis = Basis {
                    lifts: [at.vertical * share, 0.0],
                    faster: -at.lateral[0] / half_wave,
                    twist: at.twist,
                    pressure: laws.pressure(part),
                    ..Basis::default()
                };
                basis.fore_aft[..3].copy_from_slice(&at.fore_aft);
                basis.lateral[..3].copy_from_slice(&at.lateral);
                basis
            }
        }
    }
}
