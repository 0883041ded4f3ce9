//! A planned walk, or several with standing in between, that the figure follows where nothing else drives it.

use super::drives::Given;
use super::{GRAVITY, SceneReader};
use crate::scene::Walked;
use solaris_gait::{GaitError, RequestError, WalkGround, WalkSegment, WalkSequence};
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

    /// What the scene keeps of it, with the friction of its ground; `reaching` are degrees of freedom that do something else over it.
    pub(super) fn into_walked(self, reaching: &[usize], friction: Option<f64>) -> Walked {
        let motion = self.recorded.motion();
        let (planted, events) = (motion.planted.clone(), motion.events.clone());
        let followed = self.followed.iter().filter(|dof| !reaching.contains(dof)).count();
        Walked { plan: self.plan, planted, events, followed, friction, relief: motion.relief.clone() }
    }
}

/// The error itself, not in which walk it is.
fn reason(error: &GaitError) -> &GaitError {
    match error {
        GaitError::InSegment { why, .. } => reason(why),
        _ => error,
    }
}

/// Whether it is a number of the ground that cannot be.
fn is_of_ground(error: &GaitError) -> bool {
    let GaitError::Request(RequestError::Range { parameter, .. }) = reason(error) else { return false };
    ["slope", "stairs", "rise", "tread"].contains(parameter)
}

impl SceneReader<'_> {
    /// Plans what is walked, and lets every degree of freedom follow it that has no drive of its own.
    pub(super) fn walk(
        &mut self,
        fields: &Fields<'_, '_>,
        figure: Option<&Figure>,
        given: &Given,
        terrain: Option<&WalkGround>,
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
        // To plan it takes a while, and who asks what may stand somewhere does not care.
        if self.reader.count() > before || self.reader.is_asked() {
            return None;
        }
        let (written, mut segments): (Vec<_>, Vec<_>) = segments?.into_iter().unzip();
        self.lay_under(fields, terrain?, &mut segments)?;
        let plan = WalkSequence::new(figure, &segments);
        let plan = plan.map_err(|error| match fields.get("ground").filter(|_| is_of_ground(&error)) {
            Some(ground) => self.reader.fault(ground.place(), reason(&error).to_string()),
            None => self.refuse_walk(&error, &node.place(), &written),
        });
        let plan = plan.ok()?;
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

    /// Lets a walk go over the scene's ground, where that is not level at the pace that people take there unless the walk says one.
    fn lay_under(
        &mut self,
        fields: &Fields<'_, '_>,
        ground: &WalkGround,
        segments: &mut [WalkSegment],
    ) -> Option<()> {
        if *ground == WalkGround::Level {
            return Some(());
        }
        let [WalkSegment::Walk(request)] = segments else {
            let message = "walks one after the other are on level ground; over a slope, stairs or a relief goes one Walk(…) alone";
            self.reader.fault(
                fields.get("ground").map_or(fields.at.clone(), solaris_model::text::Node::place),
                message,
            );
            return None;
        };
        if [request.step_frequency, request.step_length, request.speed] == [None; 3] {
            request.step_frequency = ground.usual_step_frequency();
        }
        request.ground = ground.clone();
        Some(())
    }
}
