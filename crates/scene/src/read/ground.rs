//! The ground, and what can touch it.

use super::SceneReader;
use nalgebra::{Unit, Vector3};
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_modes::{ContactLaw, ContactPoint, GroundPlane, SetupError, contact_points};

const FIELDS: [&str; 6] = ["friction", "height", "up", "contact", "touches", "stand"];
/// Laws of contact, and the words that older scenes have for them.
const LAWS: [&str; 4] = ["Compliant", "Rigid", "Spring", "Planted"];
const EXAMPLE: &str = "(\"foot\", (0, -0.08, 0.1), 0.02)";

impl SceneReader<'_> {
    /// Gives the simulation its ground: `Flat(friction: 0.8)`.
    pub(super) fn ground(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("ground") else { return };
        if let Some(walk) = fields.get("walk") {
            let message = "a walk is planned with a ground of its own; remove ground or walk";
            self.reader.fault(walk.span.clone(), message);
        }
        let Some(fields) = self.reader.fields(node, &["Flat"], &FIELDS) else { return };
        let friction = self.reader.required_number(&fields, "friction", "0.8");
        let height = self.reader.number_or(&fields, "height", 0.0);
        let up = self.up(&fields);
        let law = self.contact(&fields, node);
        let touching = self.touches(&fields);
        if let (Some(friction), Some(height), Some(up), Some(law), Some(touching), Some(simulation)) =
            (friction, height, up, law, touching, &mut self.simulation)
        {
            let result = simulation.set_ground(GroundPlane { up, height, friction, law }, touching);
            self.setup(&node.place(), result);
        }
        if let Some(node) = fields.get("stand")
            && self.reader.flag(node) == Some(true)
            && let Some(simulation) = &mut self.simulation
        {
            let result = simulation.stand();
            self.setup(&node.place(), result);
        }
    }

    /// Against gravity, or as the scene says; along y without either.
    fn up(&mut self, fields: &Fields<'_, '_>) -> Option<Unit<Vector3<f64>>> {
        let Some(node) = fields.get("up") else {
            let gravity =
                self.simulation.as_ref().map_or_else(Vector3::zeros, |simulation| *simulation.gravity());
            return Some(Unit::try_new(-gravity, 0.0).unwrap_or_else(Vector3::y_axis));
        };
        let up = self.reader.vector(node, "up")?;
        let unit = Unit::try_new(up, 0.0);
        if unit.is_none() {
            self.reader.fault(node.place(), "up has no direction; it must not be zero");
        }
        unit
    }

    /// `Compliant(stiffness: 3e5, damping: 1, slip: 0.01)`, each as needed, or `Rigid`; `Spring` and `Planted` mean the same.
    fn contact(&mut self, fields: &Fields<'_, '_>, ground: &Node<'_>) -> Option<ContactLaw> {
        let node = fields.get("contact");
        let given = match node {
            Some(node) => {
                let kind = self.reader.kind(node, &LAWS)?;
                let is_rigid = matches!(kind, "Rigid" | "Planted");
                let known: &[&str] = if is_rigid { &[] } else { &["stiffness", "damping", "slip"] };
                let fields = self.reader.fields(node, &[kind], known)?;
                if is_rigid {
                    let flawed = self.reader.only_known(&fields, known);
                    return (!flawed).then_some(ContactLaw::Rigid);
                }
                Some(fields)
            }
            None => None,
        };
        let given = given.as_ref();
        let mut number = |field, default| {
            let node = given.and_then(|fields| fields.get(field));
            node.map_or(default, |node| self.reader.number(node, field))
        };
        let (damping, slip) =
            (number("damping", Some(ContactLaw::DAMPING)), number("slip", Some(ContactLaw::SLIP)));
        let stiffness = if given.is_some_and(|fields| fields.get("stiffness").is_some()) {
            number("stiffness", None)
        } else {
            let simulation = self.simulation.as_ref()?;
            let stiffness = ContactLaw::stiffness_for(simulation.figure(), simulation.gravity());
            self.setup(
                &node.map_or_else(|| ground.place(), Node::place),
                stiffness.ok_or(SetupError::NoGround),
            )
        };
        Some(ContactLaw::Compliant { stiffness: stiffness?, damping: damping?, slip: slip? })
    }

    /// `[("foot", (x, y, z), radius), …]`, or what the figure says of itself.
    fn touches(&mut self, fields: &Fields<'_, '_>) -> Option<Vec<ContactPoint>> {
        let Some(node) = fields.get("touches") else { return self.figure().map(contact_points) };
        let items = self.reader.items(node, "touches", &format!("[{EXAMPLE}, …]"))?;
        let found: Vec<Option<ContactPoint>> = items.iter().map(|item| self.touch(item)).collect();
        found.into_iter().collect()
    }

    /// `("foot", (x, y, z), radius)`, the radius as needed.
    fn touch(&mut self, node: &Node<'_>) -> Option<ContactPoint> {
        let (name_node, point, radius) = match node.items() {
            Some([name, point]) => (name, point, None),
            Some([name, point, radius]) => (name, point, Some(radius)),
            _ => {
                let message = format!(
                    "what can touch is a link, a point of it and a radius {EXAMPLE}, not {}",
                    node.describe()
                );
                self.reader.fault(node.place(), message);
                return None;
            }
        };
        let name = self.reader.name(name_node, "the name of a link");
        let center = self.reader.vector(point, "the point");
        let radius = radius.map_or(Some(0.0), |node| self.reader.number(node, "the radius"));
        let link = self.link(name_node, name?, None);
        Some(ContactPoint { link: link?, center: center?, radius: radius? })
    }
}
