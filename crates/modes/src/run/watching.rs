//! Preparation of a stretch: motions, forces and events that a phase is given.

use super::active_contacts::SLACK;
use super::driven::{Meaning, Mode};
use super::pass::Pass;
use crate::body::{Pushing, pushing};
use crate::drive::force::Force;
use crate::drive::path::Path;
use crate::failure::SetupError;
use crate::impact::Side;
use crate::phase::{Phase, Role, Watched};
use crate::{EndCondition, LimitLaw};

impl Pass {
    /// Gives the phase the motions and forces of the drives, and what to watch for; the answer is what each event means.
    pub(crate) fn load(&self, phase: &mut Phase, end: f64) -> Result<Vec<Meaning>, SetupError> {
        let figure = &self.simulation.figure;
        let (mut watched, mut meanings, mut sides) = (Vec::new(), Vec::new(), Vec::new());
        let mut watch = |what, meaning| {
            watched.push(what);
            meanings.push(meaning);
            // A limit is not passed, and pushes inwards only.
            sides.push(match meaning {
                Meaning::Limit(_, side) | Meaning::Release(_, side) => -side.outward(),
                // Nothing goes into the ground or is pulled by it.
                Meaning::Touch(_) | Meaning::Pull(..) => 1.0,
                Meaning::DriveEnds(_) | Meaning::StageEnds | Meaning::Kink | Meaning::Push(_) => 0.0,
            });
        };
        for (dof, driven) in self.driven.iter().enumerate() {
            if figure.follows(dof) {
                continue;
            }
            match &driven.mode {
                Mode::Still => {}
                Mode::Path(path) => phase.set_path(dof, path.during(self.t, end)),
                Mode::Force(force) => phase.set_force(dof, force.during(self.t, end)),
                Mode::Track(_, force) => phase.set_force(dof, Force::Constant(*force)),
            }
            if let Some((side, position)) = driven.held {
                phase.set_path(dof, Path::Still(position));
                watch(Watched::Hold { dof }, Meaning::Release(dof, side));
            } else if driven.role() == Role::Dynamic {
                self.watch_limits(dof, &mut watch);
                watch_servos(dof, &driven.mode, &mut watch);
            }
            let steps = &self.simulation.drives[dof];
            match steps.get(driven.step).map(|step| &step.until) {
                Some(EndCondition::Position { dof: name, value }) => {
                    if let Some(of) = figure.layout().dof_index(name) {
                        watch(Watched::Position { dof: of, value: *value }, Meaning::DriveEnds(dof));
                    }
                }
                Some(EndCondition::Velocity { dof: name, value }) => {
                    if let Some(of) = figure.layout().dof_index(name) {
                        watch(Watched::Velocity { dof: of, value: *value }, Meaning::DriveEnds(dof));
                    }
                }
                Some(until) => {
                    if let Some(near) = self.watched_contact(until) {
                        watch(near, Meaning::DriveEnds(dof));
                    }
                }
                None => {}
            }
        }
        if let Some(stage) = self.watched_stage() {
            watch(stage, Meaning::StageEnds);
        }
        self.load_pushes(phase, end);
        phase.plant(&self.active.holds);
        for (hold, patch) in self.active.holds.iter().enumerate() {
            for lever in 0..patch.levers.len() {
                watch(Watched::Lever { hold, lever, slack: SLACK }, Meaning::Pull(hold, lever));
            }
        }
        for &(touch, below) in &self.active.open {
            watch(Watched::Gap { touch, below }, Meaning::Touch(touch));
        }
        for touch in self.touches_of_springs() {
            watch(Watched::Gap { touch, below: 0.0 }, Meaning::Kink);
        }
        phase.watch(watched, sides)?;
        if self.by_impulses() {
            // Steps do not end at limits: each asks the state which of them push.
            return Ok(meanings);
        }
        for dof in 0..self.driven.len() {
            let pushing = match self.passed_limit(dof) {
                None => Pushing::Inside,
                Some((side, _)) if self.driven[dof].lets_go => Pushing::LetGo(side),
                Some((side, _)) => Pushing::Back(side),
            };
            phase.hold_limit(dof, pushing);
        }
        Ok(meanings)
    }

    /// What dynamics move to a ground of springs and away from it: its force has a kink where it touches.
    fn touches_of_springs(&self) -> Vec<usize> {
        let surface = self.simulation.surface.as_ref();
        let Some(surface) = surface.filter(|surface| !surface.plants() && !self.by_impulses()) else {
            return Vec::new();
        };
        let parts = self.parts();
        let points = surface.contact_points.iter().enumerate();
        points.filter(|(_, point)| parts[point.link].is_some()).map(|(touch, _)| touch).collect()
    }

    /// Notes which limits that push back have let go: what comes back from beyond one so fast that its damper would pull. At the zero of the push its sign does not
    /// say it; the event before does. What goes outwards is pushed, though it be inside by a rounding.
    pub(crate) fn note_pushes(&mut self, events: &[Meaning]) {
        for dof in 0..self.driven.len() {
            let Some((side, Watched::Push { limit, stiffness, damping, .. })) = self.passed_limit(dof) else {
                self.driven[dof].lets_go = false;
                continue;
            };
            let Some(coordinate) = self.simulation.figure.layout().coordinate(dof) else { continue };
            let (spring, damper) = (stiffness * (self.q[coordinate] - limit), damping * self.v[dof]);
            let push = side.outward() * (spring + damper);
            if events.contains(&Meaning::Push(dof)) {
                self.driven[dof].lets_go = !self.driven[dof].lets_go;
            } else if push.abs() > 1e-9 * (spring.abs() + damper.abs()) {
                self.driven[dof].lets_go = push < 0.0 && side.outward() * self.v[dof] < 0.0;
            }
        }
    }

    /// The limit that pushes back and that a degree of freedom which dynamics move is beyond, with its push.
    fn passed_limit(&self, dof: usize) -> Option<(Side, Watched)> {
        let LimitLaw::Spring { stiffness, damping } = self.simulation.limits[dof] else { return None };
        let coordinate = self.simulation.figure.layout().coordinate(dof)?;
        let limits = self.limits_of(dof).filter(|_| self.driven[dof].role() == Role::Dynamic)?;
        // Times are rounded, and events with them.
        let rounded = 64.0 * f64::EPSILON * self.t * self.v[dof].abs();
        let side = pushing(limits, self.q[coordinate], self.v[dof], rounded)?;
        let limit = if side == Side::Upper { limits.upper } else { limits.lower };
        Some((side, Watched::Push { dof, limit, outwards: side.outward(), stiffness, damping }))
    }

    fn watch_limits(&self, dof: usize, watch: &mut impl FnMut(Watched, Meaning)) {
        let law = self.simulation.limits[dof];
        if self.by_impulses() {
            return;
        }
        let Some(limits) = self.limits_of(dof).filter(|_| law != LimitLaw::Ignore) else { return };
        for (side, value) in [(Side::Lower, limits.lower), (Side::Upper, limits.upper)] {
            if value.is_finite() {
                let is_hard = matches!(law, LimitLaw::Hard { .. });
                let meaning = if is_hard { Meaning::Limit(dof, side) } else { Meaning::Kink };
                watch(Watched::Position { dof, value }, meaning);
            }
        }
        if let Some((_, push @ Watched::Push { damping, .. })) = self.passed_limit(dof)
            && damping > 0.0
        {
            watch(push, Meaning::Push(dof));
        }
    }

    /// The range of a degree of freedom.
    pub(crate) fn limits_of(&self, dof: usize) -> Option<solaris_model::Limits> {
        let figure = &self.simulation.figure;
        let at = figure.layout().joints().partition_point(|at| at.v + at.nv <= dof);
        let joint = figure.layout().joints()[at];
        figure.links()[at].joint().kind().axes().get(dof - joint.v)?.limits
    }
}

/// Where a servo's force stops to grow, and where it falls again, it has a kink.
fn watch_servos(dof: usize, mode: &Mode, watch: &mut impl FnMut(Watched, Meaning)) {
    let Mode::Force(force) = mode else { return };
    for (servo, limit) in force.servos().map(|servo| servo.limit).enumerate().filter(|(_, x)| x.is_finite()) {
        for most in [limit, -limit] {
            watch(Watched::Saturation { dof, servo, most }, Meaning::Kink);
        }
    }
}
