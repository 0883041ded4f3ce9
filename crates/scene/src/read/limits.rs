//! Laws of the joints' limits.

use super::SceneReader;
use super::names::in_order;
use solaris_model::text::{Fields, Node};
use solaris_modes::LimitLaw;

const LAWS: [&str; 3] = ["Ignore", "Hard", "Spring"];

impl SceneReader<'_> {
    /// Gives the simulation the law of its limits: one for all, or by name.
    pub(super) fn limits(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("limits") else { return };
        let Some(entries) = node.entries() else {
            let law = self.law(node);
            if let (Some(law), Some(simulation)) = (law, &mut self.simulation) {
                let result = simulation.set_limits(law);
                self.setup(&node.place(), result);
            }
            return;
        };
        let mut found = Vec::new();
        for (key, value) in entries {
            let (meant, law) = (self.meant(key), self.law(value));
            found.extend(meant.zip(law.map(|law| (law, value.place()))));
        }
        self.twice(entries, &found);
        for (meant, (law, place)) in in_order(found) {
            for dof in meant.dofs {
                let Some(simulation) = &mut self.simulation else { return };
                let result = simulation.set_limit(self.names.name(dof), law);
                // The law is at fault, for one as for all.
                if self.setup(&place, result).is_none() {
                    break;
                }
            }
        }
    }

    fn law(&mut self, node: &Node<'_>) -> Option<LimitLaw> {
        match self.reader.kind(node, &LAWS)? {
            "Hard" => {
                let fields = self.reader.fields(node, &LAWS, &["restitution"])?;
                Some(LimitLaw::Hard { restitution: self.reader.number_or(&fields, "restitution", 0.0)? })
            }
            "Spring" => {
                let fields = self.reader.fields(node, &LAWS, &["stiffness", "damping"])?;
                let stiffness = self.reader.required_number(&fields, "stiffness", "500");
                let damping = self.reader.number_or(&fields, "damping", 0.0);
                Some(LimitLaw::Spring { stiffness: stiffness?, damping: damping? })
            }
            ignore => self.reader.stands_alone(node, ignore).then_some(LimitLaw::Ignore),
        }
    }
}
