//! Pushes of the world on points of links.

use super::SceneReader;
use nalgebra::Vector3;
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_modes::{Push, PushLaw};

const EXAMPLE: &str = "[Push(link: \"pelvis\", force: (80, 0, 0), from: 1.0, over: 0.2)]";
const FIELDS: [&str; 7] = ["link", "at", "force", "impulse", "along", "from", "over"];

impl SceneReader<'_> {
    /// Gives the pushes of the scene to the simulation.
    pub(super) fn pushes(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("pushes") else { return };
        for item in self.reader.items(node, "pushes", EXAMPLE).unwrap_or_default() {
            let Some(push) = self.push(item) else { continue };
            if let Some(simulation) = &mut self.simulation {
                let result = simulation.add_push(push);
                self.setup(&item.place(), result);
            }
        }
    }

    /// What there is to say of pushes that begin when a scene of this length (s) is over.
    pub(super) fn late_pushes(&self, duration: f64) -> Vec<String> {
        let Some(simulation) = &self.simulation else { return Vec::new() };
        let late = simulation.pushes().iter().filter(|push| push.from >= duration);
        let name = |push: &Push| simulation.figure().links()[push.link].name();
        let said = |push: &Push| {
            format!(
                "the push on '{}' begins at {} s, and the scene is over at {duration} s: it does nothing",
                name(push),
                push.from
            )
        };
        late.map(said).collect()
    }

    /// What there is to say of blows on what dynamics do not move: they are over before any force could be told.
    pub(super) fn idle_blows(&self) -> Vec<String> {
        let Some(simulation) = &self.simulation else { return Vec::new() };
        let moved = self.moved_by_dynamics();
        let is_blow = |push: &&Push| matches!(push.law, PushLaw::Impulse { over, .. } if over <= 0.0);
        let idle = simulation.pushes().iter().filter(is_blow).filter(|push| !moved.contains(&push.link));
        let said = |push: &Push| {
            let name = simulation.figure().links()[push.link].name();
            format!(
                "the blow on '{name}' changes nothing: it moves as it is told, and so does what carries it; give the push a time, \
                 over: 0.1, for the forces that bear it"
            )
        };
        idle.map(said).collect()
    }

    /// `Push(link: "hand", at: (0, 0, 0), force: (x, y, z), from: 0, over: 0.2)`
    fn push(&mut self, node: &Node<'_>) -> Option<Push> {
        let fields = self.reader.fields(node, &["Push"], &FIELDS)?;
        let link = self.reader.required(&fields, "link", "\"pelvis\"");
        let link = link.and_then(|node| {
            let name = self.reader.name(node, "the name of a link")?;
            self.link(node, name, None)
        });
        let point = match fields.get("at") {
            Some(node) => self.reader.vector(node, "the point that is pushed"),
            None => Some(Vector3::zeros()),
        };
        let from = self.reader.number_or(&fields, "from", 0.0);
        let law = self.push_law(&fields);
        Some(Push { link: link?, point: point?, from: from?, law: law? })
    }

    /// How hard, which way and for how long.
    fn push_law(&mut self, fields: &Fields<'_, '_>) -> Option<PushLaw> {
        let over = match fields.get("over") {
            Some(node) => self.reader.number(node, "the time").map(Some),
            None => Some(None),
        };
        let (node, is_force) = match (fields.get("force"), fields.get("impulse")) {
            (Some(force), None) => (force, true),
            (None, Some(impulse)) => (impulse, false),
            (force, _) => {
                let what = if force.is_some() { "both; keep one of them" } else { "neither" };
                let message = format!(
                    "a push has a force: (x, y, z) in N, or an impulse: (x, y, z) in N s, along the world's axes; this has {what}"
                );
                self.reader.fault(force.map_or(fields.at.clone(), Node::place), message);
                return None;
            }
        };
        let vector = self.reader.vector(node, if is_force { "the force" } else { "the impulse" });
        let Some(along) = fields.get("along") else {
            let (vector, over) = (vector?, over?);
            return Some(if is_force {
                PushLaw::Force { force: vector, over: over.unwrap_or(f64::INFINITY) }
            } else {
                PushLaw::Impulse { impulse: vector, over: over.unwrap_or(0.0) }
            });
        };
        let profile = self.profile(along, false);
        if !is_force {
            let message = "a push along a curve has a force, of which the curve is the part over the time; not an impulse";
            self.reader.fault(along.place(), message);
            return None;
        }
        if let Some(over) = fields.get("over") {
            let message = "a push along a curve lasts as long as the curve; leave 'over' out";
            self.reader.fault(over.place(), message);
            return None;
        }
        Some(PushLaw::Along { force: vector?, profile: profile? })
    }
}
