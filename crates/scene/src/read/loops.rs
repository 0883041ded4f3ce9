//! Closed loops: points that are held together.

use super::SceneReader;
use solaris_model::text::{Fields, Node};
use solaris_modes::{Loop, LoopKind};

const KINDS: [&str; 2] = ["Connect", "Weld"];
const EXAMPLE: &str = "((\"hand\", (0, -0.08, 0)), (\"bar\", (0.2, 0, 0)))";

impl SceneReader<'_> {
    /// Gives the loops of the scene to the simulation: `[Connect(between: …), Weld(between: …)]`.
    pub(super) fn loops(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("loops") else { return };
        for item in self.reader.items(node, "loops", "[Connect(…), …]").unwrap_or_default() {
            let Some(closed) = self.closed(item) else { continue };
            if let Some(simulation) = &mut self.simulation {
                let result = simulation.add_loop(closed);
                self.setup(&item.place(), result);
            }
        }
    }

    fn closed(&mut self, node: &Node<'_>) -> Option<Loop> {
        let kind = match self.reader.kind(node, &KINDS)? {
            "Weld" => LoopKind::Weld,
            _ => LoopKind::Connect,
        };
        let fields = self.reader.fields(node, &KINDS, &["between"])?;
        let between = self.reader.required(&fields, "between", EXAMPLE)?;
        Some(Loop { between: self.two_anchors(between, "a loop", EXAMPLE)?, kind })
    }
}
