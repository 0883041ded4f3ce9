//! Springs and dampers between two points.

use super::SceneReader;
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_modes::{Anchor, PointSpring};

const EXAMPLE: &str = "((\"world\", (0, 2, 0)), (\"hand\", (0, 0, 0)))";
const WORLD: &str = "world";

impl SceneReader<'_> {
    /// Gives the springs of the scene to the simulation.
    pub(super) fn springs(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("springs") else { return };
        for item in self.reader.items(node, "springs", "[Spring(…), …]").unwrap_or_default() {
            let Some(spring) = self.spring(item) else { continue };
            if let Some(simulation) = &mut self.simulation {
                let result = simulation.add_spring(spring);
                self.setup(&item.place(), result);
            }
        }
    }

    fn spring(&mut self, node: &Node<'_>) -> Option<PointSpring> {
        let known = ["between", "stiffness", "damping", "rest"];
        let fields = self.reader.fields(node, &["Spring"], &known)?;
        let between = self.reader.required(&fields, "between", EXAMPLE);
        let between = between.and_then(|node| self.two_anchors(node, "a spring", EXAMPLE));
        let stiffness = self.reader.required_number(&fields, "stiffness", "800");
        let damping = self.reader.number_or(&fields, "damping", 0.0);
        let rest = self.reader.number_or(&fields, "rest", 0.0);
        Some(PointSpring { between: between?, stiffness: stiffness?, damping: damping?, rest: rest? })
    }

    /// `(("base", (x, y, z)), ("rod", (x, y, z)))`
    pub(super) fn two_anchors(&mut self, node: &Node<'_>, what: &str, example: &str) -> Option<[Anchor; 2]> {
        let Some([first, second]) = node.items() else {
            let message = format!("{what} is between two points {example}, not {}", node.describe());
            self.reader.fault(node.place(), message);
            return None;
        };
        let (first, second) = (self.anchor(first), self.anchor(second));
        Some([first?, second?])
    }

    fn anchor(&mut self, node: &Node<'_>) -> Option<Anchor> {
        let Some([name_node, point]) = node.items() else {
            let message =
                format!("a point is a link and a place in it (\"hand\", (0, 0, 0)), not {}", node.describe());
            self.reader.fault(node.place(), message);
            return None;
        };
        let name = self.reader.name(name_node, "the name of a link");
        let point = self.reader.vector(point, "the point");
        let name = name?;
        if name == WORLD {
            return Some(Anchor { link: None, point: point? });
        }
        let link = self.link(name_node, name, Some(WORLD))?;
        Some(Anchor { link: Some(link), point: point? })
    }
}
