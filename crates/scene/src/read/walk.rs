//! A planned walk that the figure follows where nothing else drives it.

use super::drives::Given;
use super::{GRAVITY, SceneReader};
use crate::scene::Walked;
use solaris_gait::{Extent, GaitError, PARAMETERS, STEPS, Unit, WalkPlan, WalkRequest, walk};
use solaris_model::text::{Fields, Node};
use solaris_model::{Figure, Trajectory};
use solaris_modes::{Drive, Recorded};
use std::sync::Arc;

/// Samples a second of the walk that is followed; between them it follows curves of degree five.
const RATE: f64 = 480.0;

/// A walk, and how it begins.
pub(super) struct Planned {
    plan: Arc<WalkPlan>,
    recorded: Arc<Recorded>,
    followed: usize,
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

    /// What the scene keeps of it.
    pub(super) fn into_walked(self) -> Walked {
        let motion = self.recorded.motion();
        let (planted, events) = (motion.planted.clone(), motion.events.clone());
        Walked { plan: self.plan, planted, events, followed: self.followed }
    }
}

impl SceneReader<'_> {
    /// Plans the walk, and lets every degree of freedom follow it that has no drive of its own.
    pub(super) fn walk(
        &mut self,
        fields: &Fields<'_, '_>,
        figure: Option<&Figure>,
        given: &Given,
    ) -> Option<Planned> {
        let node = fields.get("walk")?;
        let before = self.reader.count();
        let names: Vec<String> = PARAMETERS.iter().map(|parameter| written(parameter.name)).collect();
        let own = ["steps", "distance", "step_frequency", "step_length", "speed"];
        let known: Vec<&str> = own.into_iter().chain(names.iter().map(String::as_str)).collect();
        let options = self.reader.fields(node, &["Walk"], &known)?;
        let request = self.request(&options);
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
        let plan = walk(figure, &request?).map_err(|error| self.refuse_walk(&error, &options)).ok()?;
        let motion = plan.motion(figure, RATE);
        let motion = motion.map_err(|error| self.reader.fault(node.place(), error.to_string())).ok()?;
        let recorded = self.setup(&node.place(), Recorded::new(motion))?;
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
        Some(Planned { plan: Arc::new(plan), recorded, followed: free.len() })
    }

    fn request(&mut self, fields: &Fields<'_, '_>) -> Option<WalkRequest> {
        let before = self.reader.count();
        let mut number = |field: &str| fields.get(field).and_then(|node| self.reader.number(node, field));
        let (step_frequency, step_length, speed) =
            (number("step_frequency"), number("step_length"), number("speed"));
        let (steps, distance) = (number("steps"), number("distance"));
        let mut request = WalkRequest { step_frequency, step_length, speed, ..WalkRequest::default() };
        if let (Some(_), Some(node)) = (steps, fields.get("distance")) {
            self.reader
                .fault(node.span.clone(), "a walk has steps or a distance, not both; remove one of them");
        }
        if let Some(distance) = distance {
            request.extent = Extent::Distance(distance);
        } else if let (Some(steps), Some(node)) = (steps, fields.get("steps")) {
            let (fewest, most) = STEPS;
            if steps.fract() == 0.0 && (fewest as f64..=most as f64).contains(&steps) {
                request.extent = Extent::Steps(steps as usize);
            } else {
                let message = format!("steps is {steps}; it must be a whole number, {fewest} to {most}");
                self.reader.fault(node.span.clone(), message);
            }
        }
        for parameter in PARAMETERS {
            let Some(node) = fields.get(&written(parameter.name)) else { continue };
            let value = match parameter.unit {
                Unit::Degrees => self.reader.angle(node, parameter.name).map(degrees),
                Unit::Metres => self.reader.number(node, parameter.name),
            };
            request.parameters.extend(value.map(|value| (parameter.name, value)));
        }
        (self.reader.count() == before).then_some(request)
    }

    /// Why there is no such walk, said of the number that is at fault where it can be told.
    fn refuse_walk(&mut self, error: &GaitError, fields: &Fields<'_, '_>) {
        let name = match error {
            GaitError::Range { parameter, .. } | GaitError::StepLength { parameter, .. } => {
                written(parameter)
            }
            _ => String::new(),
        };
        let place = fields.get(&name).map_or(fields.at.clone(), |node: &Node<'_>| node.span.clone());
        self.reader.fault(place, error.to_string());
    }
}

/// A name as it is written.
fn written(name: &str) -> String {
    name.replace(['-', ' '], "_")
}

/// An angle (rad) in degrees; one that was written in degrees comes back as it was written.
fn degrees(angle: f64) -> f64 {
    (angle.to_degrees() * 1e10).round() / 1e10
}
