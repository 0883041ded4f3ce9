//! What links carry: for the whole run, or for a time.

use super::SceneReader;
use nalgebra::{Matrix3, Vector3};
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_model::{Figure, Load};
use solaris_modes::{Carry, Simulation};
use std::ops::Range;

const EXAMPLE: &str = "[Carry(mass: 5, in: \"right_hand\", from: 1.0, until: 3.0)]";
const FIELDS: [&str; 6] = ["mass", "inertia", "in", "at", "from", "until"];

impl SceneReader<'_> {
    /// Lets the simulation carry what the scene says. What is carried for the whole run is a part of the figure, which is the answer.
    pub(super) fn carries(&mut self, fields: &Fields<'_, '_>, figure: Option<Figure>) -> Option<Figure> {
        let mut figure = figure;
        let Some(node) = fields.get("carries") else { return figure };
        let mut timed: Vec<(Range<usize>, Carry)> = Vec::new();
        for item in self.reader.items(node, "carries", EXAMPLE).unwrap_or_default() {
            let Some(carry) = self.one_carry(item) else { continue };
            if carry.from > 0.0 || carry.until.is_finite() {
                timed.push((item.place(), carry));
            } else if let Some(loaded) = figure.as_ref().map(|figure| figure.carrying(&carry.load)) {
                figure = loaded
                    .map_err(|error| self.reader.fault(item.place(), error.to_string()))
                    .ok()
                    .or(figure);
            }
        }
        if let (Some(figure), Some(simulation)) = (&figure, &mut self.simulation) {
            *simulation = Simulation::new(figure, *simulation.gravity());
        }
        for (place, carry) in timed {
            if fields.get("walk").is_some() {
                let message = "a walk is planned with what is carried from its beginning to its end; leave 'from' and 'until' out";
                self.reader.fault(place, message);
            } else if let Some(simulation) = &mut self.simulation {
                let result = simulation.add_carry(carry);
                self.setup(&place, result);
            }
        }
        figure
    }

    /// `Carry(mass: 5, in: "right_hand", at: (0, -0.1, 0), inertia: (x, y, z), from: 0, until: 3)`
    fn one_carry(&mut self, node: &Node<'_>) -> Option<Carry> {
        let fields = self.reader.fields(node, &["Carry"], &FIELDS)?;
        let mass = self.reader.required_number(&fields, "mass", "5");
        let link = self.reader.required(&fields, "in", "\"right_hand\"");
        let link = link.and_then(|node| {
            let name = self.reader.name(node, "the name of a link")?;
            self.link(node, name, None)
        });
        let mut vector = |field, what| {
            let node = fields.get(field);
            node.map_or(Some(Vector3::zeros()), |node| self.reader.vector(node, what))
        };
        let (at, inertia) =
            (vector("at", "the place of the load"), vector("inertia", "the inertia of the load"));
        let from = self.reader.number_or(&fields, "from", 0.0);
        let until = match fields.get("until") {
            Some(node) => self.reader.number(node, "until"),
            None => Some(f64::INFINITY),
        };
        let inertia = Matrix3::from_diagonal(&inertia?);
        let load = Load { link: link?, at: at?, mass: mass?, inertia };
        Some(Carry { load, from: from?, until: until? })
    }
}
