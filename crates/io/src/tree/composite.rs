//! Bodies that cannot move against each other, as one link.

use super::{
    Body, Fault, Inertia, Joint, LinkSpec, Lump, Matrix3, NamedFrame, Names, Placement, Vector3, combined,
};

/// A link in the making: bodies by their places in its frame.
pub(super) struct Composite {
    name: String,
    parent: Option<String>,
    joint: Joint,
    parts: Vec<(Placement, Body)>,
    frames: Vec<NamedFrame>,
}

impl Composite {
    /// The links of these bodies, depth first. What is wrong with the mass of a body that will not be seen any more is
    /// put into `faults`, and the mass of its link replaced, so that what else is wrong is found too.
    pub(super) fn of(bodies: Vec<Body>, faults: &mut Vec<Fault>) -> Vec<Self> {
        let order = depth_first(&bodies);
        let roots = bodies.iter().filter(|body| body.parent.is_none()).count();
        let mut links = Vec::new();
        // Of each body: its link and its place in it.
        let mut places: Vec<Option<(usize, Placement)>> = bodies.iter().map(|_| None).collect();
        if roots > 1 {
            let name = Names::of(bodies.iter().map(|body| body.name.as_str())).take("world");
            links.push(Self::empty(name, None, weld(&bodies)));
        }
        let root_weld = weld(&bodies);
        let mut bodies: Vec<Option<Body>> = bodies.into_iter().map(Some).collect();
        for i in order {
            let Some(mut body) = bodies[i].take() else { continue };
            let above = match body.parent {
                Some(parent) => places[parent],
                None => (roots > 1).then(|| (0, Placement::identity())),
            };
            let placement = body.joint.placement();
            let at = above.map_or(*placement, |(_, within)| product(&within, placement));
            let beyond = body.beyond;
            let place = match above {
                Some((link, _)) if body.is_fixed() => (link, product(&at, &beyond)),
                None if body.is_fixed() => {
                    let joint = root_weld.clone().placed(product(&at, &beyond));
                    links.push(Self::empty(body.name.clone(), None, joint));
                    (links.len() - 1, Placement::identity())
                }
                _ => {
                    let parent = above.map(|(link, _)| links[link].name.clone());
                    let joint = std::mem::replace(&mut body.joint, Joint::new("")).placed(at);
                    links.push(Self::empty(body.name.clone(), parent, joint));
                    (links.len() - 1, beyond)
                }
            };
            places[i] = Some(place);
            links[place.0].parts.push((place.1, body));
        }
        name_frames(&mut links);
        for link in &mut links {
            link.check(faults);
        }
        links
    }

    fn empty(name: String, parent: Option<String>, joint: Joint) -> Self {
        Self { name, parent, joint, parts: Vec::new(), frames: Vec::new() }
    }

    /// Fusing hides what is wrong with a single body, so it is looked at before.
    fn check(&mut self, faults: &mut Vec<Fault>) {
        if self.parts.len() < 2 {
            return;
        }
        let before = faults.len();
        self.parts.iter().for_each(|(_, body)| check_mass(body, faults));
        if faults.len() > before {
            for (_, body) in &mut self.parts {
                (body.mass, body.com, body.inertia) = (1.0, Vector3::zeros(), Matrix3::zeros());
            }
        }
    }

    /// What the builder wants to know.
    pub(super) fn spec(self) -> LinkSpec {
        let Lump { mass, com, inertia } = self.matter();
        let mut spec = match self.parent {
            Some(parent) => LinkSpec::child(self.name, parent, self.joint),
            None => LinkSpec::root(self.name, self.joint),
        };
        spec = spec.mass(mass).com(com).inertia(Inertia::Tensor(inertia));
        // A tool frame with a little box to see it by is not what the link looks like.
        let matter = self.parts.iter().filter(|(_, body)| body.mass > 0.0);
        let shape = matter.into_iter().find_map(|(within, body)| body.shape.map(|shape| (within, shape)));
        if let Some((within, mut shape)) = shape {
            shape.placement = product(within, &shape.placement);
            spec = spec.shape(shape);
        }
        self.frames.into_iter().fold(spec, |spec, frame| spec.frame(frame.name, frame.placement))
    }

    /// Mass, centre of mass and inertia in the link's frame; a body at the frame itself keeps its numbers, to the bit.
    fn matter(&self) -> Lump {
        let moved = |within: &Placement, body: &Body| {
            let lump = Lump { mass: body.mass, com: body.com, inertia: body.inertia };
            if is_identity(within) {
                return lump;
            }
            let turn = *within.rotation.to_rotation_matrix().matrix();
            let com = within.rotation * body.com + within.translation.vector;
            Lump { com, inertia: turn * body.inertia * turn.transpose(), ..lump }
        };
        let massive = self.parts.iter().filter(|(_, body)| body.mass != 0.0 || body.inertia.amax() != 0.0);
        let lumps: Vec<Lump> = massive.map(|(within, body)| moved(within, body)).collect();
        combined(&lumps.iter().collect::<Vec<_>>())
    }
}

/// Parents before children, each body followed by what hangs on it, children in the order of the list.
fn depth_first(bodies: &[Body]) -> Vec<usize> {
    let mut children = vec![Vec::new(); bodies.len()];
    let mut open = Vec::new();
    for (i, body) in bodies.iter().enumerate().rev() {
        match body.parent {
            Some(parent) => children[parent].push(i),
            None => open.push(i),
        }
    }
    let mut order = Vec::with_capacity(bodies.len());
    while let Some(next) = open.pop() {
        order.push(next);
        open.extend(&children[next]);
    }
    order
}

/// A weld to the world whose name no other joint has.
fn weld(bodies: &[Body]) -> Joint {
    let moved = bodies.iter().filter(|body| !body.is_fixed());
    Joint::new(Names::of(moved.map(|body| body.joint.name())).take("root"))
}

/// Keeps the frames of bodies that are no link's, by names that differ; those of bodies come first.
fn name_frames(links: &mut [Composite]) {
    let mut names = Names::default();
    for link in links.iter_mut() {
        for (within, body) in &link.parts {
            if body.name != link.name || !is_identity(within) {
                link.frames.push(NamedFrame { name: names.take(&body.name), placement: *within });
            }
        }
    }
    for link in links {
        for (within, body) in &mut link.parts {
            for frame in std::mem::take(&mut body.frames) {
                let placement = product(within, &frame.placement);
                link.frames.push(NamedFrame { name: names.take(&frame.name), placement });
            }
        }
    }
}

/// What the builder says about the mass of a link, about a body.
fn check_mass(body: &Body, faults: &mut Vec<Fault>) {
    let link = || body.name.clone();
    if body.mass < 0.0 {
        faults.push(Fault::NegativeMass { link: link(), mass: body.mass });
    }
    if let Some(&value) = body.inertia.iter().find(|entry| !entry.is_finite()) {
        faults.push(Fault::NotFinite { link: link(), what: "inertia".into(), value });
    }
}

/// `a·b`, to the bit where one of them is the identity.
pub(crate) fn product(a: &Placement, b: &Placement) -> Placement {
    if is_identity(a) {
        *b
    } else if is_identity(b) {
        *a
    } else {
        a * b
    }
}

fn is_identity(placement: &Placement) -> bool {
    *placement == Placement::identity()
}
