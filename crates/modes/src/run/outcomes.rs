//! Outcomes of drives.

use super::driven::{Mode, name};
use super::pass::Pass;
use crate::drive::force::Force;
use crate::{Drive, EndCondition, Outcome, OutcomeKind};
use std::sync::Arc;

/// How near (rad or m) a target counts as reached.
const REACHED: f64 = 1e-3;

impl Pass {
    /// What came of a drive that is done by itself.
    pub(crate) fn result(&self, dof: usize) -> OutcomeKind {
        let driven = &self.driven[dof];
        let position = self.position(dof).unwrap_or(0.0);
        match self.simulation.drives[dof].get(driven.step).map(|step| &step.drive) {
            Some(Drive::Simple { target, .. }) => {
                let same = (self.v[dof] - target.velocity).abs() <= 1e-9 * (1.0 + target.velocity.abs());
                if same { OutcomeKind::Reached } else { OutcomeKind::ReachedWithVelocity }
            }
            Some(Drive::Intensive { target, .. }) => {
                let off = (position - target.position).abs();
                match () {
                    () if off <= REACHED && (self.v[dof] - target.velocity).abs() <= 10.0 * REACHED => {
                        OutcomeKind::Reached
                    }
                    () if driven.limited => OutcomeKind::LimitedByTorque,
                    () if off <= REACHED => OutcomeKind::ReachedWithVelocity,
                    () => OutcomeKind::Missed,
                }
            }
            Some(Drive::Servo(_)) => {
                let Some((aim, rate)) = self.aim(dof) else { return OutcomeKind::Ended };
                let at_limit = self.is_at_its_limit(dof, position);
                match () {
                    () if (position - aim).abs() <= REACHED => {
                        let same = (self.v[dof] - rate).abs() <= 10.0 * REACHED;
                        if same { OutcomeKind::Reached } else { OutcomeKind::ReachedWithVelocity }
                    }
                    () if at_limit => OutcomeKind::LimitedByTorque,
                    () => OutcomeKind::Missed,
                }
            }
            Some(Drive::Torque(_) | Drive::FreeStyle { .. } | Drive::Sum(_)) => OutcomeKind::Ended,
            _ => OutcomeKind::Reached,
        }
    }

    /// What came of a drive that would go on, where the next one takes over or the run ends.
    pub(crate) fn result_of_lasting(&self, dof: usize) -> OutcomeKind {
        if self.aim(dof).is_some() { self.result(dof) } else { OutcomeKind::Ended }
    }

    /// Whether a servo asks for as much as its motor gives, or more.
    fn is_at_its_limit(&self, dof: usize, position: f64) -> bool {
        let Mode::Force(Force::Servo(servo)) = &self.driven[dof].mode else { return false };
        servo.demand(self.t, (position, self.v[dof])).abs() >= (1.0 - 1e-9) * servo.limit
    }

    /// Where a servo would have its degree of freedom now, and how fast.
    fn aim(&self, dof: usize) -> Option<(f64, f64)> {
        let Mode::Force(Force::Servo(servo)) = &self.driven[dof].mode else { return None };
        let aim = servo.aim.at(self.t);
        Some((aim.position, aim.velocity))
    }

    /// Writes down how a drive ended.
    pub(crate) fn outcome(&mut self, dof: usize, result: OutcomeKind) {
        let driven = &self.driven[dof];
        let drive = name(self.simulation.drives[dof].get(driven.step));
        let (start, acceleration) = (driven.start, driven.acceleration);
        self.note(dof, drive, start, result, acceleration);
    }

    fn note(
        &mut self,
        dof: usize,
        drive: &'static str,
        start: f64,
        result: OutcomeKind,
        acceleration: Option<f64>,
    ) {
        let (layout, position) = (self.simulation.figure.layout(), self.position(dof));
        let target = match self.simulation.drives[dof].get(self.driven[dof].step).map(|step| &step.drive) {
            Some(Drive::Intensive { target, .. }) if result == OutcomeKind::Missed => Some(target.position),
            Some(Drive::Servo(_)) if result == OutcomeKind::Missed => self.aim(dof).map(|(aim, _)| aim),
            _ => None,
        };
        self.passed.outcomes.push(Outcome {
            dof,
            name: layout.v_names()[dof].clone(),
            axis_kind: layout.axis_kind(dof),
            has_position: position.is_some(),
            drive,
            start,
            end: self.t,
            result,
            position: position.unwrap_or(0.0),
            velocity: self.v[dof],
            missed_by: position.zip(target).map(|(position, target)| (position - target).abs()),
            acceleration,
        });
    }

    /// The position of a degree of freedom that has one.
    fn position(&self, dof: usize) -> Option<f64> {
        self.simulation.figure.layout().coordinate(dof).map(|coordinate| self.q[coordinate])
    }

    /// Writes down what the end of the run has left undone.
    pub(crate) fn note_unfinished(&mut self) {
        for dof in 0..self.driven.len() {
            let simulation = Arc::clone(&self.simulation);
            let steps = &simulation.drives[dof];
            let (driven, follows) = (&self.driven[dof], simulation.figure.follows(dof));
            let at = driven.step;
            let Some(step) = steps.get(at).filter(|_| !follows) else { continue };
            // A record may go on for as long as it likes.
            let is_recorded = matches!(step.drive, Drive::Recorded(_));
            let lasts = driven.end.is_infinite() && step.until == EndCondition::Done;
            if lasts && !driven.waits && self.aim(dof).is_some() {
                self.outcome(dof, self.result(dof));
            } else if !(lasts || driven.waits || is_recorded) {
                self.outcome(dof, OutcomeKind::Unfinished);
            }
            // Of what comes again everything has begun, but for the first time round.
            let is_first = self.again[dof].is_infinite();
            for step in steps[at + 1..].iter().filter(|_| is_first) {
                self.note(dof, step.drive.name(), self.t, OutcomeKind::NotBegun, None);
            }
        }
    }
}
