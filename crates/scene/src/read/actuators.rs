//! Motors that a figure's file says: drives that take their numbers from there, and the greatest forces of servos.

use super::SceneReader;
use super::drives::{Given, Placed};
use solaris_model::text::{Fields, Node};
use solaris_model::{Actuator, ActuatorLaw};
use solaris_modes::{Aim, Drive, Servo, Step};
use solaris_profiles::Profile;
use std::collections::HashMap;

/// How long a velocity is aimed at (s): longer than any run.
const LONG: f64 = 1e7;

/// The motors of a scene.
#[derive(Default)]
pub(super) struct Motors {
    /// Those that are asked for, each with the figure that its name is of, where there are several.
    asked: Vec<(String, Actuator)>,
    /// By degree of freedom.
    known: HashMap<usize, Actuator>,
    /// Where drives stand that take their numbers from the file, by their first bytes, and whether a velocity is aimed at.
    words: HashMap<usize, bool>,
}

impl SceneReader<'_> {
    /// Keeps the actuators of a file for the figure of this name, if the scene asks for them.
    pub(super) fn ask_for_actuators(&mut self, figure: &str, node: &Node<'_>) {
        let Some(Some(flag)) = node.tuple().is_none().then(|| self.reader.fields(node, &["File"], &[]))
        else {
            return;
        };
        let Some(asked) = flag.get("actuators").filter(|node| self.reader.flag(node) == Some(true)) else {
            return;
        };
        let path = flag.get("path").and_then(|node| self.reader.name(node, "the path of a figure"));
        let Some(path) = path else { return };
        match self.loader.actuators(path) {
            Ok(found) => self.motors.asked.extend(found.into_iter().map(|one| (figure.to_owned(), one))),
            Err(why) => self.reader.fault(asked.span.clone(), format!("'{path}': {why}")),
        }
    }

    /// Finds the degrees of freedom of the actuators; what there is to say of those that have none.
    pub(super) fn place_actuators(&mut self) -> Vec<String> {
        let mut said = Vec::new();
        for (figure, actuator) in std::mem::take(&mut self.motors.asked) {
            let of = |names: &super::names::Names, name: &str| {
                names.one(name).or_else(|| names.one(&format!("{figure}.{name}")))
            };
            let Some(dof) = of(&self.names, &actuator.dof) else {
                said.push(format!(
                    "the actuator '{}' is left out: it drives no degree of freedom of '{figure}'",
                    actuator.name
                ));
                continue;
            };
            if let Some(first) = self.motors.known.get(&dof) {
                said.push(format!(
                    "the actuator '{}' is left out: '{}' drives the same degree of freedom",
                    actuator.name, first.name
                ));
                continue;
            }
            self.motors.known.insert(dof, actuator);
        }
        said
    }

    /// `Actuator(to: deg(30))`, `Actuator(along: CURVE)` or `Actuator(velocity: 2.0)`, whose gains the file says.
    pub(super) fn actuator(&mut self, place: usize, fields: &Fields<'_, '_>, turns: bool) -> Option<Drive> {
        if let Some(node) = fields.get("velocity") {
            if let Some(other) = fields.get("to").or(fields.get("along")) {
                let message = "a motor goes to a position, to: or along:, or at a velocity; keep one of them";
                self.reader.fault(other.place(), message);
            }
            let velocity = self.reader.coordinate(node, turns, "the velocity")?;
            self.motors.words.insert(place, true);
            let aim = Aim::Along(Profile::Line { from: 0.0, to: velocity * LONG, duration: LONG });
            return Some(Drive::Servo(Servo { aim, stiffness: 0.0, damping: 0.0, limit: None }));
        }
        let aim = self.aim(fields, turns)?;
        self.motors.words.insert(place, false);
        Some(Drive::Servo(Servo { aim, stiffness: 0.0, damping: 0.0, limit: None }))
    }

    /// The drives as the motor of a degree of freedom does them; those that it cannot do are faults.
    pub(super) fn by_motor(&mut self, dof: usize, steps: &[Placed]) -> Vec<Placed> {
        steps
            .iter()
            .map(|(span, step)| {
                let mut step = step.clone();
                if let Some(&is_velocity) = self.motors.words.get(&span.start) {
                    match (self.gains(dof, is_velocity), &mut step.drive) {
                        (Ok([stiffness, damping]), Drive::Servo(servo)) => {
                            (servo.stiffness, servo.damping) = (stiffness, damping);
                        }
                        (Err(why), _) => self.reader.fault(span.clone(), why),
                        _ => {}
                    }
                }
                if let Some(limit) = self.motors.known.get(&dof).and_then(|actuator| actuator.limit) {
                    bound(&mut step.drive, limit);
                }
                (span.clone(), step)
            })
            .collect()
    }

    /// Stiffness and damping of a degree of freedom's motor.
    fn gains(&self, dof: usize, is_velocity: bool) -> Result<[f64; 2], String> {
        let name = self.names.name(dof);
        let Some(actuator) = self.motors.known.get(&dof) else {
            return Err(format!(
                "'{name}' has no actuator of a file; ask for them, File(path: \"arm.xml\", actuators: true), or take Servo(to: …, stiffness: …)"
            ));
        };
        let own = &actuator.name;
        match (&actuator.law, is_velocity) {
            (ActuatorLaw::Position { stiffness, damping }, false) => Ok([*stiffness, *damping]),
            (ActuatorLaw::Velocity { damping }, true) => Ok([0.0, *damping]),
            (ActuatorLaw::Position { .. }, true) => {
                Err(format!("the actuator '{own}' of '{name}' goes to positions; write Actuator(to: …)"))
            }
            (ActuatorLaw::Velocity { .. }, false) => Err(format!(
                "the actuator '{own}' of '{name}' goes at velocities; write Actuator(velocity: …)"
            )),
            (ActuatorLaw::Other(what), _) => {
                Err(format!("the actuator '{own}' of '{name}' is {what}; take Servo(…) or Torque(…)"))
            }
            _ => Err(format!(
                "the actuator '{own}' of '{name}' has a force and no gains; take Servo(to: …, stiffness: …) or Torque(…)"
            )),
        }
    }

    /// Lets motors that nothing is said of do what they do unasked: lead to zero, or brake.
    pub(super) fn idle_motors(&mut self, given: &mut Given) {
        let mut idle: Vec<usize> =
            self.motors.known.keys().copied().filter(|dof| !given.contains_key(dof)).collect();
        idle.sort_unstable();
        for dof in idle {
            let is_velocity = matches!(self.motors.known[&dof].law, ActuatorLaw::Velocity { .. });
            let Ok([stiffness, damping]) = self.gains(dof, is_velocity) else { continue };
            let limit = self.motors.known[&dof].limit;
            let steps: Vec<Step> =
                vec![Drive::Servo(Servo { aim: Aim::At(0.0), stiffness, damping, limit }).into()];
            let name = self.names.name(dof).to_owned();
            if let Some(simulation) = &mut self.simulation
                && let Err(error) = simulation.drive(&name, steps.clone())
            {
                self.reader.fault(0..0, format!("the actuator of '{name}': {error}"));
            }
            given.insert(dof, steps);
        }
    }
}

/// Lets a servo be no stronger than a motor is.
fn bound(drive: &mut Drive, most: f64) {
    match drive {
        Drive::Servo(servo) => servo.limit = Some(servo.limit.map_or(most, |limit| limit.min(most))),
        Drive::Sum(parts) => parts.iter_mut().for_each(|part| bound(part, most)),
        _ => {}
    }
}
