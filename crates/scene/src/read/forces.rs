//! Drives that are forces: servos, and several at once.

use super::SceneReader;
use solaris_model::text::{Fields, Node};
use solaris_modes::{Aim, Drive, Servo};

/// An example of what a sum is of.
pub(super) const SUM: &str = "[Torque(Line(from: 0, to: 5, duration: 1)), Servo(to: 0.5, stiffness: 40)]";

/// What can stand in a sum.
const FORCES: [&str; 3] = ["Torque", "Servo", "Sum"];

impl SceneReader<'_> {
    /// `Servo(to: deg(30), stiffness: 40, damping: 3, limit: 20)`, or `along: CURVE`.
    pub(super) fn servo(&mut self, fields: &Fields<'_, '_>, turns: bool) -> Option<Drive> {
        let aim = self.aim(fields, turns);
        let stiffness = self.reader.required(fields, "stiffness", if turns { "40" } else { "2000" });
        let stiffness = stiffness.and_then(|node| self.reader.number(node, "the stiffness"));
        let damping = self.reader.number_or(fields, "damping", 0.0);
        let limit = fields.get("limit").map(|node| self.reader.number(node, "the greatest force"));
        let limit = limit.map_or(Some(None), |limit| limit.map(Some));
        Some(Drive::Servo(Servo { aim: aim?, stiffness: stiffness?, damping: damping?, limit: limit? }))
    }

    pub(super) fn aim(&mut self, fields: &Fields<'_, '_>, turns: bool) -> Option<Aim> {
        match (fields.get("to"), fields.get("along")) {
            (Some(to), None) => self.reader.coordinate(to, turns, "the aim").map(Aim::At),
            (None, Some(along)) => self.profile(along, turns).map(Aim::Along),
            (to, _) => {
                let place = to.map_or(fields.at.clone(), Node::place);
                let what = if to.is_some() { "both; keep one of them" } else { "neither" };
                let message = format!(
                    "a servo leads to a position, to: {}, or along a curve, along: MinimumJerk(…); this has {what}",
                    if turns { "deg(30)" } else { "0.1" }
                );
                self.reader.fault(place, message);
                None
            }
        }
    }

    /// `[FORCE, FORCE, …]`
    pub(super) fn sum(&mut self, list: &Node<'_>, turns: bool) -> Option<Drive> {
        let items = self.reader.items(list, "a sum", SUM)?;
        if items.is_empty() {
            self.reader.fault(list.place(), format!("there is no force in the sum; write {SUM}"));
            return None;
        }
        let parts: Vec<Option<Drive>> = items.iter().map(|item| self.force(item, turns)).collect();
        Some(Drive::Sum(parts.into_iter().collect::<Option<_>>()?))
    }

    fn force(&mut self, node: &Node<'_>, turns: bool) -> Option<Drive> {
        let before = self.reader.count();
        if let Some(head) = node.head()
            && super::drive::DRIVES.contains(&head.name)
            && !FORCES.contains(&head.name)
        {
            let message = format!("'{}' is no force; a sum can be of {}", head.name, FORCES.join(", "));
            self.reader.fault(head.span, message);
            return None;
        }
        self.reader.kind(node, &FORCES)?;
        let (_, step) = self.step(node, turns)?;
        if step.until != solaris_modes::EndCondition::Done {
            let message = "what is summed ends together: give the sum the until, Sum(of: […], until: …)";
            self.reader.fault(node.place(), message);
        }
        (self.reader.count() == before).then_some(step.drive)
    }
}
