//! A planned walk, or several with standing in between, that the figure follows where nothing else drives it.

use super::drives::Given;
use super::{GRAVITY, SceneReader};
use crate::scene::Walked;
use solaris_gait::WalkSequence;
use solaris_model::text::Fields;
use solaris_model::{Figure, Trajectory};
use solaris_modes::{Drive, RecordedMotion};
use std::sync::Arc;

/// Samples a second of the walk that is followed; between them it follows curves of degree five.
const RATE: f64 = 480.0;

/// What is walked, and how it begins.
pub(super) struct Planned {
    plan: Arc<WalkSequence>,
    recorded: Arc<RecordedMotion>,
    /// Degrees of freedom that follow it.
    followed: Vec<usize>,
}

impl Planned {
    /// How long it takes (s).
    pub(super) fn duration(&self) -> f64 {
        self.plan.duration()
    }

    /// Positions and velocities at the beginning.
    pub(super) fn first(&self) -> (&[f64], &[f64]) {
        let motion = self.recorded.motion();
        (motion.q(0), motion.v(0))
    }

    /// What the scene keeps of it; `reaching` are degrees of freedom that do something else over it.
    pub(super) fn into_walked(self, reaching: &[usize]) -> Walked {
        let motion = self.recorded.motion();
        let (planted, events) = (motion.planted.clone(), motion.events.clone());
        let followed = self.followed.iter().filter(|dof| !reaching.contains(dof)).count();
        Walked { plan: self.plan, planted, events, followed }
    }
}

impl SceneReader<'_> {
    /// Plans what is walked, and lets every degree of freedom follow it that has no drive of its own.
    pub(super) fn walk(
        &mut self,
        fields: &Fields<'_, '_>,
        figure: Option<&Figure>,
        given: &Given,
    ) -> Option<Planned> {
        let node = fields.get("walk")?;
        let before = self.reader.count();
        let segments = self.segments(node);
        let figure = figure?;
        let gravity = *self.simulation.as_ref()?.gravity();
        if (gravity - GRAVITY).norm() > 1e-6 {
            let message = format!(
                "a walk needs the gravity (0, −9.80665, 0) m/s²; here it is ({}, {}, {})",
                gravity.x, gravity.y, gravity.z
            );
            self.reader.fault(fields.get("gravity").map_or(node.place(), |node| node.span.clone()), message);
        }
        if self.reader.count() > before {
            return None;
        }
        let (written, segments): (Vec<_>, Vec<_>) = segments?.into_iter().unzip();
        let plan = WalkSequence::new(figure, &segments);
        let plan = plan.map_err(|error| self.refuse_walk(&error, &node.place(), &written)).ok()?;
        let motion = plan.motion(figure, RATE);
        let motion = motion.map_err(|error| self.reader.fault(node.place(), error.to_string())).ok()?;
        let recorded = self.setup(&node.place(), RecordedMotion::new(motion))?;
        let recorded = Arc::new(recorded);
        let simulation = self.simulation.as_mut()?;
        let free: Vec<usize> = (0..figure.layout().nv()).filter(|dof| !given.contains_key(dof)).collect();
        for dof in &free {
            let result = simulation.drive(self.names.name(*dof), [Drive::Recorded(Arc::clone(&recorded))]);
            if let Err(error) = result {
                self.reader.fault(node.place(), error.to_string());
                return None;
            }
        }
        Some(Planned { plan: Arc::new(plan), recorded, followed: free })
    }
}
