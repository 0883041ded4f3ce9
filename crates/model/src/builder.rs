//! The builder of figures, which finds everything that is wrong at once.

mod check;
mod hints;

use crate::anatomy::AnatomicalAngle;
use crate::fault::{Fault, FigureError};
use crate::figure::Figure;
use crate::follower::followers;
use crate::inertia::{Inertia, Shape};
use crate::joint::{Follow, Joint, Placement};
use crate::layout::{StateLayout, velocity_names};
use crate::link::{Link, NamedFrame, SolePart, SolePoint};
use hints::Hints;
use nalgebra::{Matrix3, Vector3};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap, HashSet};

/// A link as it is described, before it is checked.
#[doc(alias = "body")]
#[doc(alias = "segment")]
#[derive(Clone, Debug)]
pub struct LinkSpec {
    name: String,
    parent: Option<String>,
    joint: Joint,
    mass: f64,
    com: Vector3<f64>,
    inertia: Inertia,
    shape: Option<Shape>,
    tip: Option<Vector3<f64>>,
    sole: Vec<SolePoint>,
    frames: Vec<NamedFrame>,
}

impl LinkSpec {
    /// The root link, moved by `joint` against the world.
    pub fn root(name: impl Into<String>, joint: Joint) -> Self {
        Self {
            name: name.into(),
            parent: None,
            joint,
            mass: 0.0,
            com: Vector3::zeros(),
            inertia: Inertia::Point,
            shape: None,
            tip: None,
            sole: Vec::new(),
            frames: Vec::new(),
        }
    }

    /// A link moved by `joint` against the link called `parent`, which may be added later.
    pub fn child(name: impl Into<String>, parent: impl Into<String>, joint: Joint) -> Self {
        Self { parent: Some(parent.into()), ..Self::root(name, joint) }
    }

    /// Mass (kg); zero without this.
    pub fn mass(mut self, mass: f64) -> Self {
        self.mass = mass;
        self
    }

    /// Centre of mass in the link's frame (m); its origin without this.
    #[doc(alias = "center of mass")]
    pub fn com(mut self, com: Vector3<f64>) -> Self {
        self.com = com;
        self
    }

    /// Rotational inertia; that of a point without this. A uniform shape also sets the centre of mass.
    pub fn inertia(mut self, inertia: Inertia) -> Self {
        if let Inertia::Uniform(shape) = inertia {
            self.com = shape.placement.translation.vector;
            self.shape = self.shape.or(Some(shape));
        }
        self.inertia = inertia;
        self
    }

    /// What the link looks like; no effect on its mass or inertia.
    pub fn shape(mut self, shape: Shape) -> Self {
        self.shape = Some(shape);
        self
    }

    /// The far end of an end-effector in the link's frame (m).
    #[doc(alias = "end effector")]
    pub fn tip(mut self, tip: Vector3<f64>) -> Self {
        self.tip = Some(tip);
        self
    }

    /// A point that can touch the ground, in the link's frame (m).
    #[doc(alias = "contact point")]
    pub fn sole(mut self, part: SolePart, position: Vector3<f64>) -> Self {
        self.sole.push(SolePoint { part, position });
        self
    }

    /// A named frame fixed to the link.
    #[doc(alias = "site")]
    #[doc(alias = "marker")]
    pub fn frame(mut self, name: impl Into<String>, placement: Placement) -> Self {
        self.frames.push(NamedFrame { name: name.into(), placement });
        self
    }

    fn tensor(&self) -> Matrix3<f64> {
        match self.inertia {
            Inertia::Point => Matrix3::zeros(),
            Inertia::Tensor(tensor) => tensor,
            Inertia::Uniform(shape) => {
                let rotation = shape.placement.rotation.to_rotation_matrix();
                let principal = Matrix3::from_diagonal(&(shape.kind.gyration_squared() * self.mass));
                rotation.matrix() * principal * rotation.matrix().transpose()
            }
        }
    }

    /// The same without what rounding and few digits leave on one side of the diagonal alone.
    fn symmetric_tensor(&self) -> Matrix3<f64> {
        let inertia = self.tensor();
        (inertia + inertia.transpose()) / 2.0
    }
}

/// Collects links and names, and builds a [`Figure`] or says everything that is wrong.
///
/// ```
/// use solaris_model::{FigureBuilder, Joint, LinkSpec};
/// let error = FigureBuilder::new("broken")
///     .link(LinkSpec::root("trunk", Joint::new("root").tx()).mass(-1.0))
///     .link(LinkSpec::child("arm", "trnk", Joint::new("shoulder").rx()).mass(1.0))
///     .build()
///     .unwrap_err();
/// assert_eq!(error.faults.len(), 2);
/// assert!(error.to_string().contains("did you mean 'trunk'?"));
/// ```
#[doc(alias = "ModelBuilder")]
#[doc(alias = "urdf")]
#[derive(Clone, Debug)]
pub struct FigureBuilder {
    name: String,
    links: Vec<LinkSpec>,
    angles: Vec<(String, String, f64)>,
    stature: Option<f64>,
    gravity: Option<Vector3<f64>>,
}

impl FigureBuilder {
    /// An empty figure called `name`.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), links: Vec::new(), angles: Vec::new(), stature: None, gravity: None }
    }

    /// Adds a link. Links keep the order in which they are added, but that a parent always comes before its children.
    pub fn link(mut self, link: LinkSpec) -> Self {
        self.links.push(link);
        self
    }

    /// Names an anatomical angle: the degree of freedom `dof`, taken negative where `negative`.
    pub fn angle(mut self, name: impl Into<String>, dof: impl Into<String>, negative: bool) -> Self {
        self.angles.push((name.into(), dof.into(), if negative { -1.0 } else { 1.0 }));
        self
    }

    /// Says the standing height that the figure is made for (m); walking laws scale with it.
    pub fn stature(mut self, height: f64) -> Self {
        self.stature = Some(height);
        self
    }

    /// Says the gravity of the world that the figure is made in (m/s²).
    pub fn gravity(mut self, gravity: Vector3<f64>) -> Self {
        self.gravity = Some(gravity);
        self
    }

    /// The figure.
    ///
    /// # Errors
    ///
    /// [`FigureError`] with every fault that was found.
    pub fn build(mut self) -> Result<Figure, FigureError> {
        let (mut faults, mut hints) = (Vec::new(), Hints::default());
        // Names follow from the axes, so these come first.
        self.links.iter_mut().for_each(|link| link.joint.normalize_axes());
        if let Some(stature) = self.stature.filter(|h| !(*h > 0.0 && *h <= Figure::LONGEST)) {
            faults.push(Fault::Stature { stature });
        }
        faults.extend(self.gravity.as_ref().and_then(Fault::of_gravity));
        self.check_names(&mut faults);
        for link in &self.links {
            check::link(link, &mut faults);
        }
        let order = self.check_tree(&mut hints, &mut faults);
        let coordinates = self.coordinates();
        self.check_followers(&coordinates, &mut hints, &mut faults);
        let angles = self.check_angles(&coordinates, &mut hints, &mut faults);
        match order {
            Some(order) if faults.is_empty() => Ok(self.assemble(&order, angles)),
            _ => Err(FigureError { figure: self.name, faults }),
        }
    }

    fn check_names(&self, faults: &mut Vec<Fault>) {
        // Two joints of one name are a fault of their own.
        let mut joints = HashSet::new();
        let dofs: Vec<String> = self
            .links
            .iter()
            .filter(|link| joints.insert(link.joint.name()))
            .flat_map(|link| velocity_names(link.joint.name(), link.joint.kind()))
            .collect();
        let kinds: [(&'static str, Vec<&str>); 5] = [
            ("link", self.links.iter().map(|link| link.name.as_str()).collect()),
            ("joint", self.links.iter().map(|link| link.joint.name()).collect()),
            (
                "frame",
                self.links.iter().flat_map(|link| &link.frames).map(|frame| frame.name.as_str()).collect(),
            ),
            ("angle", self.angles.iter().map(|(name, ..)| name.as_str()).collect()),
            ("dof", dofs.iter().map(String::as_str).collect()),
        ];
        for (kind, names) in kinds {
            let mut counts: HashMap<&str, usize> = HashMap::new();
            for name in &names {
                *counts.entry(name).or_default() += 1;
            }
            for (index, name) in names.iter().enumerate() {
                if name.trim().is_empty() {
                    faults.push(Fault::EmptyName { kind, index });
                } else if let Some(count) = counts.remove(name).filter(|count| *count > 1) {
                    faults.push(Fault::DuplicateName { kind, name: (*name).to_owned(), count });
                }
            }
        }
    }

    /// The order of the links, parents first, or `None` where there is no tree.
    fn check_tree(&self, hints: &mut Hints, faults: &mut Vec<Fault>) -> Option<Vec<usize>> {
        let before = faults.len();
        let mut places: HashMap<&str, usize> = HashMap::new();
        for (i, link) in self.links.iter().enumerate() {
            places.entry(&link.name).or_insert(i);
        }
        let index = |name: &str| places.get(name).copied();
        let roots: Vec<String> =
            self.links.iter().filter(|link| link.parent.is_none()).map(|link| link.name.clone()).collect();
        match roots.len() {
            0 if self.links.is_empty() => faults.push(Fault::Empty),
            0 => faults.push(Fault::NoRoot),
            1 => {}
            _ => faults.push(Fault::ManyRoots { links: roots }),
        }
        for link in &self.links {
            if let Some(parent) = link.parent.as_deref().filter(|parent| index(parent).is_none()) {
                let nearest = hints.nearest(parent, self.links.iter().map(|link| link.name.as_str()));
                faults.push(Fault::UnknownParent {
                    link: link.name.clone(),
                    parent: parent.to_owned(),
                    nearest,
                });
            }
        }
        let mut order: Vec<usize> = Vec::new();
        let mut placed = vec![false; self.links.len()];
        let mut children = vec![Vec::new(); self.links.len()];
        // Links whose parent is placed, the first one on top; an unknown parent counts as placed, it has its own fault.
        let mut ready = BinaryHeap::new();
        for (i, link) in self.links.iter().enumerate() {
            match link.parent.as_deref().and_then(index) {
                Some(parent) => children[parent].push(i),
                None => ready.push(Reverse(i)),
            }
        }
        while let Some(Reverse(next)) = ready.pop() {
            placed[next] = true;
            order.push(next);
            ready.extend(children[next].iter().copied().map(Reverse));
        }
        if let Some(start) = placed.iter().position(|placed| !placed) {
            faults.push(Fault::Cycle { links: self.cycle_from(start, &index) });
        }
        (faults.len() == before).then_some(order)
    }

    /// The names on the cycle that the ancestors of `start` run into.
    fn cycle_from(&self, start: usize, index: &impl Fn(&str) -> Option<usize>) -> Vec<String> {
        let mut path = vec![start];
        let mut at = HashMap::from([(start, 0)]);
        loop {
            let last = path[path.len() - 1];
            let Some(parent) = self.links[last].parent.as_deref().and_then(index) else { return Vec::new() };
            if let Some(&from) = at.get(&parent) {
                return path[from..].iter().map(|&link| self.links[link].name.clone()).collect();
            }
            at.insert(parent, path.len());
            path.push(parent);
        }
    }

    /// The degrees of freedom that have a coordinate, each with what it follows; the velocities of a ball joint are the
    /// rates of none. A one-dof joint also answers to its own name.
    fn coordinates(&self) -> HashMap<String, Option<&Follow>> {
        let mut coordinates = HashMap::new();
        for link in &self.links {
            let dofs = link.joint.kind().axes();
            for (name, dof) in velocity_names(link.joint.name(), link.joint.kind()).into_iter().zip(dofs) {
                if dofs.len() == 1 {
                    coordinates.entry(link.joint.name().to_owned()).or_insert(dof.follows.as_ref());
                }
                coordinates.insert(name, dof.follows.as_ref());
            }
        }
        coordinates
    }

    fn check_followers(
        &self,
        coordinates: &HashMap<String, Option<&Follow>>,
        hints: &mut Hints,
        faults: &mut Vec<Fault>,
    ) {
        for link in &self.links {
            let dofs = link.joint.kind().axes();
            for (dof, follows) in velocity_names(link.joint.name(), link.joint.kind()).into_iter().zip(dofs) {
                let Some(Follow { dof: leader, curve }) = &follows.follows else { continue };
                let leader = leader.clone();
                if let Some(why) = curve.fault() {
                    faults.push(Fault::Curve { dof: dof.clone(), leader: leader.clone(), why });
                }
                match coordinates.get(&leader) {
                    None => {
                        let nearest = hints.nearest(&leader, coordinates.keys().map(String::as_str));
                        faults.push(Fault::UnknownLeader { dof, leader, nearest });
                    }
                    Some(Some(_)) => faults.push(Fault::FollowsFollower { dof, leader }),
                    Some(None) => {}
                }
            }
        }
    }

    fn check_angles(
        &self,
        coordinates: &HashMap<String, Option<&Follow>>,
        hints: &mut Hints,
        faults: &mut Vec<Fault>,
    ) -> Vec<(String, String, f64)> {
        for (angle, dof, _) in &self.angles {
            if !coordinates.contains_key(dof) {
                let nearest = hints.nearest(dof, coordinates.keys().map(String::as_str));
                faults.push(Fault::UnknownDof { angle: angle.clone(), dof: dof.clone(), nearest });
            }
        }
        self.angles.clone()
    }

    fn assemble(self, order: &[usize], angles: Vec<(String, String, f64)>) -> Figure {
        let place: HashMap<String, usize> =
            order.iter().enumerate().map(|(at, &i)| (self.links[i].name.clone(), at)).collect();
        let mut specs: Vec<Option<LinkSpec>> = self.links.into_iter().map(Some).collect();
        let links: Vec<Link> =
            order.iter().filter_map(|&i| specs[i].take()).map(|spec| finish(spec, &place)).collect();
        let layout = StateLayout::of(&links);
        let angles = angles
            .into_iter()
            .filter_map(|(name, dof, sign)| {
                let dof = layout.dof_index(&dof)?;
                layout.coordinate(dof).map(|coordinate| AnatomicalAngle { name, dof, coordinate, sign })
            })
            .collect();
        let followers = followers(&links, &layout);
        let (name, by_name, stature, gravity) = (self.name, place, self.stature, self.gravity);
        Figure { name, links, layout, angles, followers, by_name, stature, gravity }
    }
}

/// The link, with its rotation normalised in the working precision.
fn finish(spec: LinkSpec, place: &HashMap<String, usize>) -> Link {
    let inertia = spec.symmetric_tensor();
    let mut joint = spec.joint;
    joint.placement.rotation.renormalize();
    Link {
        parent: spec.parent.and_then(|parent| place.get(&parent).copied()),
        name: spec.name,
        joint,
        mass: spec.mass,
        com: spec.com,
        inertia,
        shape: spec.shape,
        tip: spec.tip,
        sole: spec.sole,
        frames: spec.frames,
    }
}
