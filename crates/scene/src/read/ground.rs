//! The ground, and what can touch it: what lies under a walk, and what pushes what dynamics move.

use super::{GRAVITY, SceneReader};
use nalgebra::{Unit, Vector3};
use solaris_gait::{Stairs, WalkGround};
use solaris_model::Relief;
use solaris_model::text::{Fields, Node, ReadSpatial as _};
use solaris_modes::{ContactLaw, ContactPoint, Drive, GroundPlane, SetupError, Step, contact_points};

/// What a ground can be.
const KINDS: [&str; 4] = ["Flat", "Slope", "Stairs", "Relief"];
const POINTS: &str = "[(2.0, 0.0), (6.0, 0.2), (6.0, 0.1)]";

fn known(kind: &str) -> &'static [&'static str] {
    match kind {
        "Slope" => &["friction", "rise", "height", "contact", "touches", "stand"],
        "Stairs" => &["friction", "count", "rise", "tread"],
        "Relief" => &["friction", "points"],
        _ => &["friction", "height", "up", "contact", "touches", "stand"],
    }
}

/// Laws of contact, and the words that older scenes have for them.
const LAWS: [&str; 4] = ["Compliant", "Rigid", "Spring", "Planted"];
const EXAMPLE: &str = "(\"foot\", (0, -0.08, 0.1), 0.02)";

/// What begins deeper in the ground (m) was hardly meant to.
const BELOW: f64 = 0.05;

impl SceneReader<'_> {
    /// What the scene's ground is to one who walks over it.
    pub(super) fn terrain(&mut self, fields: &Fields<'_, '_>) -> Option<WalkGround> {
        let Some(node) = fields.get("ground") else { return Some(WalkGround::Level) };
        let kind = self.reader.kind(node, &KINDS)?;
        let own = self.reader.fields(node, &KINDS, known(kind))?;
        match kind {
            "Slope" => {
                let rise = self.reader.required(&own, "rise", "deg(5)");
                let rise = rise.and_then(|node| self.reader.angle(node, "the rise"))?;
                if rise.abs() < std::f64::consts::FRAC_PI_2 {
                    return Some(WalkGround::Slope(rise));
                }
                let message =
                    format!("the rise is {:.1}°; a slope is less than 90° steep", rise.to_degrees());
                self.reader.fault(own.get("rise").map_or(node.place(), |node| node.span.clone()), message);
                None
            }
            "Stairs" => {
                let usual = Stairs::default();
                let count = self
                    .reader
                    .required(&own, "count", "6")
                    .and_then(|_| self.whole(&own, "count", 1.0, 1.0, 1e3));
                let rise = self.reader.number_or(&own, "rise", usual.rise);
                let tread = self.reader.number_or(&own, "tread", usual.tread);
                Some(WalkGround::Stairs(Stairs { count: count? as usize, rise: rise?, tread: tread? }))
            }
            "Relief" => {
                let points = self.reader.required(&own, "points", POINTS)?;
                let mut found = Vec::new();
                for item in self.reader.items(points, "points", POINTS)? {
                    found.push(self.reader.numbers(item, "a point of the ground", ["z", "height"]));
                }
                let found: Option<Vec<[f64; 2]>> = found.into_iter().collect();
                let relief =
                    Relief::new(found?).map_err(|error| self.reader.fault(points.place(), error.to_string()));
                relief.ok().map(WalkGround::Relief)
            }
            _ => Some(WalkGround::Level),
        }
    }

    /// Gives the simulation its ground, `Flat(friction: 0.8)` or `Slope(friction: 0.8, rise: deg(5))`; where there is a walk, to what it
    /// does not move. The friction, and what there is to say.
    pub(super) fn ground(
        &mut self,
        fields: &Fields<'_, '_>,
        terrain: Option<&WalkGround>,
    ) -> (Option<f64>, Vec<String>) {
        let Some((ground, terrain)) = fields.get("ground").zip(terrain) else { return Default::default() };
        let Some(kind) = self.reader.kind(ground, &KINDS) else { return Default::default() };
        // What it has not has been said.
        let Some(own) = self.reader.fields(ground, &KINDS, &[]) else { return Default::default() };
        let friction = self.reader.required_number(&own, "friction", "0.8");
        let walks = fields.get("walk").is_some();
        if matches!(kind, "Stairs" | "Relief") {
            if !walks {
                let message = format!(
                    "what dynamics move touches planes, Flat(…) or Slope(…); {kind}(…) is ground to be walked over, walk: Walk(…)"
                );
                self.reader.fault(ground.place(), message);
            }
            let through = self
                .moved_by_dynamics()
                .first()
                .and_then(|link| Some(self.figure()?.links()[*link].name().to_owned()));
            let note = through.map(|link| {
                format!(
                    "'{link}', and what else dynamics move, touches planes alone, and goes through {}",
                    kind.to_lowercase()
                )
            });
            return (friction, note.into_iter().collect());
        }
        let up = if let WalkGround::Slope(rise) = terrain {
            self.up_of_slope(ground, *rise)
        } else {
            self.up(&own)
        };
        self.plane(ground, &own, friction, up, walks);
        (friction, Vec::new())
    }

    /// Lays a plane under what dynamics move.
    fn plane(
        &mut self,
        ground: &Node<'_>,
        own: &Fields<'_, '_>,
        friction: Option<f64>,
        up: Option<Unit<Vector3<f64>>>,
        walks: bool,
    ) {
        let height = self.reader.number_or(own, "height", 0.0);
        let law = self.contact(own, ground);
        let mut touching = self.touches(own);
        if walks {
            self.under_a_walk(own);
            let moved = self.moved_by_dynamics();
            touching =
                touching.map(|all| all.into_iter().filter(|touch| moved.contains(&touch.link)).collect());
        }
        if let (Some(friction), Some(height), Some(up), Some(law), Some(touching), Some(simulation)) =
            (friction, height, up, law, touching, &mut self.simulation)
            && !(walks && touching.is_empty())
        {
            let result = simulation.set_ground(GroundPlane { up, height, friction, law }, touching);
            self.setup(&ground.place(), result);
        }
        if let Some(node) = own.get("stand")
            && self.reader.flag(node) == Some(true)
            && !walks
            && let Some(simulation) = &mut self.simulation
        {
            let result = simulation.stand();
            self.setup(&node.place(), result);
        }
    }

    /// What there is to say of what dynamics move and begins far in the ground, where no walk stands on it.
    pub(super) fn begins_below(&self) -> Option<String> {
        let simulation = self.simulation.as_ref()?;
        let (link, depth) = simulation.begins_in_ground(&self.moved_by_dynamics()).ok().flatten()?;
        let link = simulation.figure().links()[link].name();
        (depth > BELOW).then(|| {
            format!(
                "'{link}' begins {depth:.2} m in the ground: stand: true in the ground puts figures on it, or let it \
                 begin higher (start, places)"
            )
        })
    }

    /// Refuses what a walk decides by itself.
    fn under_a_walk(&mut self, own: &Fields<'_, '_>) {
        for (field, why) in [
            ("height", "a walk begins on ground at height 0; leave 'height' out"),
            ("up", "a walk goes over ground against gravity, or over Slope(rise: deg(5)); leave 'up' out"),
            ("stand", "a walk stands on its ground; leave 'stand' out"),
        ] {
            if let Some(node) = own.get(field) {
                self.reader.fault(node.span.clone(), why);
            }
        }
    }

    /// Links that are moved by anything but a motion that is given.
    pub(super) fn moved_by_dynamics(&self) -> Vec<usize> {
        let Some(simulation) = &self.simulation else { return Vec::new() };
        let figure = simulation.figure();
        let mut moved = vec![false; figure.links().len()];
        for (i, (link, joint)) in figure.links().iter().zip(figure.layout().joints()).enumerate() {
            let is_motion = |step: &Step| {
                matches!(
                    step.drive,
                    Drive::Frozen | Drive::Kinematic(_) | Drive::Move { .. } | Drive::Recorded(_)
                )
            };
            let own = (joint.v..joint.v + joint.nv)
                .any(|dof| !figure.follows(dof) && !simulation.driven_by(dof).iter().all(is_motion));
            moved[i] = own || link.parent().is_some_and(|parent| moved[parent]);
        }
        (0..moved.len()).filter(|link| moved[*link]).collect()
    }

    /// Out of a slope that rises along z, the way that walkers go.
    fn up_of_slope(&mut self, ground: &Node<'_>, rise: f64) -> Option<Unit<Vector3<f64>>> {
        let gravity = self.simulation.as_ref().map_or(GRAVITY, |simulation| *simulation.gravity());
        if gravity.y < 0.0 && gravity.x.hypot(gravity.z) <= 1e-9 * gravity.norm() {
            return Some(Unit::new_normalize(Vector3::new(0.0, rise.cos(), -rise.sin())));
        }
        let message = format!(
            "a slope rises along z where gravity is along −y, and here it is ({}, {}, {}); say which way is out of it, Flat(up: (x, y, z))",
            gravity.x, gravity.y, gravity.z
        );
        self.reader.fault(ground.place(), message);
        None
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
