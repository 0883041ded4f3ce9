//! Random figures and states from a seed.

use nalgebra::{Matrix3, Translation3, UnitQuaternion, Vector3};
use solaris_dynamics::Wrench;
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement};

/// A stream of random numbers (`SplitMix64`).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Between −1 and 1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    pub(crate) fn vector(&mut self, scale: f64) -> Vector3<f64> {
        Vector3::new(self.unit(), self.unit(), self.unit()) * scale
    }

    pub(crate) fn slice(&mut self, n: usize, scale: f64) -> Vec<f64> {
        (0..n).map(|_| self.unit() * scale).collect()
    }

    pub(crate) fn wrench(&mut self, links: usize) -> (usize, Wrench<f64>) {
        (self.below(links), Wrench { force: self.vector(50.0), moment: self.vector(20.0) })
    }

    /// Half of them a coordinate axis of either sense.
    fn axis(&mut self) -> Axis {
        let sense = if self.below(2) == 0 { 1.0 } else { -1.0 };
        let direction = match self.below(6) {
            i @ 0..3 => Vector3::ith(i, sense),
            _ => self.vector(1.0) + Vector3::new(0.1, 1.1, 0.0) * sense,
        };
        if self.below(3) == 0 { Axis::translation(direction) } else { Axis::rotation(direction) }
    }

    /// The three coordinate axes in any order.
    fn order(&mut self) -> [usize; 3] {
        let (first, step) = (self.below(3), 1 + self.below(2));
        std::array::from_fn(|i| (first + i * step) % 3)
    }

    /// Half of them without rotation.
    pub(crate) fn placement(&mut self) -> Placement {
        let turn = if self.below(2) == 0 { Vector3::zeros() } else { self.vector(2.0) };
        Placement::from_parts(Translation3::from(self.vector(0.5)), UnitQuaternion::from_scaled_axis(turn))
    }

    /// A mass between 10^−`decades` and 10^`decades` kg with any centre and any inertia that is possible.
    fn matter(&mut self, link: LinkSpec, decades: f64) -> LinkSpec {
        let mass = 10_f64.powf(self.unit() * decades);
        let root = Matrix3::from_fn(|_, _| self.unit()) * 0.2;
        let second = root * root.transpose() * mass;
        let inertia = Matrix3::identity() * second.trace() - second;
        link.mass(mass).com(self.vector(0.3)).inertia(Inertia::Tensor((inertia + inertia.transpose()) / 2.0))
    }
}

/// Which joints a random tree has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Joints {
    /// Joints of 0 to 6 one-axis dofs of every kind.
    OneAxis,
    /// Ball and free joints too, and half of the joints with an armature.
    Every,
    /// As `Every`, but all joints with an armature: every mass matrix is regular.
    EveryArmed,
    /// As `Every`, but some axes of a joint may have an armature and others none, and free joints have none: with one they
    /// cannot be turned round.
    Reversible,
}

/// How the root of a random tree is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Root {
    /// By a free joint.
    Free,
    /// By three slides and three turns about coordinate axes, in any order and sense.
    Six,
    /// By any joint.
    Any,
}

/// A tree of `links` links: joints of 0 to 6 dofs of every kind, one in five links that carry others without mass, masses
/// spread over twice `decades` powers of ten.
pub(crate) fn tree(random: &mut Random, links: usize, decades: f64) -> Figure {
    tree_of(Joints::OneAxis, random, links, decades)
}

/// A tree as [`tree`] makes it, with the joints asked for; where there are more than one-axis joints, link `l3` has a frame
/// `f3` and a tip opposite it.
pub(crate) fn tree_of(joints: Joints, random: &mut Random, links: usize, decades: f64) -> Figure {
    let parents: Vec<usize> = (1..links).map(|i| random.below(i)).collect();
    grown(Root::Any, joints, random, &parents, decades)
}

/// A tree of 2 to 9 links with [`Joints::Reversible`] whose root is moved as asked.
pub(crate) fn tree_on(root: Root, random: &mut Random) -> Figure {
    let links = 2 + random.below(8);
    // Long branches show more than wide ones.
    let parents: Vec<usize> = (1..links).map(|i| i - 1 - random.below(i.min(2))).collect();
    grown(root, Joints::Reversible, random, &parents, 0.25)
}

/// Link `i + 1` hangs on `parents[i]`.
fn grown(root: Root, joints: Joints, random: &mut Random, parents: &[usize], decades: f64) -> Figure {
    let mut builder = FigureBuilder::new("random");
    for i in 0..=parents.len() {
        let name = format!("j{i}");
        let joint = match (i, root) {
            (0, Root::Free) => Joint::free(name),
            (0, Root::Six) => six(random, name),
            _ => joint(joints, random, name),
        };
        let joint = joint.placed(random.placement());
        let mut link = match i.checked_sub(1) {
            None => LinkSpec::root("l0", joint),
            Some(before) => LinkSpec::child(format!("l{i}"), format!("l{}", parents[before]), joint),
        };
        if joints != Joints::OneAxis {
            let frame = random.placement();
            link = link.frame(format!("f{i}"), frame).tip(-frame.translation.vector);
        }
        let massless = parents.contains(&i) && random.below(5) == 0;
        builder = builder.link(if massless { link } else { random.matter(link, decades) });
    }
    builder.build().expect("a valid figure")
}

fn six(random: &mut Random, name: String) -> Joint {
    let mut joint = Joint::new(name);
    for kind in [Axis::translation, Axis::rotation] {
        for i in random.order() {
            let sense = if random.below(2) == 0 { 1.0 } else { -1.0 };
            joint = joint.axis(kind(Vector3::ith(i, sense)));
        }
    }
    joint
}

fn joint(joints: Joints, random: &mut Random, name: String) -> Joint {
    let whole = if joints == Joints::OneAxis { None } else { Some(random.below(6)) };
    let armature = match joints {
        Joints::OneAxis => 0.0,
        Joints::Every | Joints::Reversible => 0.3 * random.below(2) as f64,
        Joints::EveryArmed => 0.3,
    };
    match whole {
        Some(0 | 1) => return Joint::ball(name).armature(armature),
        Some(2) if joints == Joints::Reversible => return Joint::free(name),
        Some(2) => return Joint::free(name).armature(armature),
        _ => {}
    }
    let mut axes: Vec<Axis> = (0..[0, 1, 1, 2, 3, 3, 6][random.below(7)]).map(|_| random.axis()).collect();
    // Half of the joints with room for them end in three turns about different coordinate axes.
    if axes.len() <= 3 && random.below(2) == 0 {
        axes.extend(random.order().map(|i| Axis::rotation(Vector3::ith(i, 1.0))));
    }
    axes.into_iter().fold(Joint::new(name), |joint, axis| {
        let without = joints == Joints::Reversible && random.below(2) == 0;
        joint.axis(axis).armature(if without { 0.0 } else { armature })
    })
}

/// Position, velocity and acceleration of every degree of freedom.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
}

impl State {
    pub(crate) fn random(figure: &Figure, random: &mut Random) -> Self {
        let (q, n) = (random_configuration(random, figure), figure.layout().nv());
        Self { q, v: random.slice(n, 2.0), a: random.slice(n, 5.0) }
    }

    pub(crate) fn zeros(figure: &Figure) -> Self {
        let layout = figure.layout();
        Self { q: vec![0.0; layout.nq()], v: vec![0.0; layout.nv()], a: vec![0.0; layout.nv()] }
    }
}

/// A [`tree`] of 1 to 9 links in a wide range of states, with wrenches on its links.
pub(crate) struct Sample {
    pub(crate) figure: Figure,
    pub(crate) gravity: Vector3<f64>,
    pub(crate) state: State,
    pub(crate) external: [(usize, Wrench<f64>); 3],
}

impl Sample {
    pub(crate) fn random(seed: u64, decades: f64) -> Self {
        let mut random = Random::new(seed);
        let links = 1 + random.below(9);
        let figure = tree(&mut random, links, decades);
        let (n, gravity) = (figure.layout().nv(), random.vector(10.0));
        let state = State { q: random.slice(n, 2.0), v: random.slice(n, 3.0), a: random.slice(n, 10.0) };
        Self { figure, gravity, state, external: std::array::from_fn(|_| random.wrench(links)) }
    }
}

/// A configuration with coordinates to 1.2 either way and any rotation, its quaternion of unit length.
pub(crate) fn random_configuration(random: &mut Random, figure: &Figure) -> Vec<f64> {
    let layout = figure.layout();
    let mut q = random.slice(layout.nq(), 1.2);
    for (link, at) in figure.links().iter().zip(layout.joints()) {
        if let Some(from) = link.joint().kind().quaternion() {
            let turn = UnitQuaternion::from_scaled_axis(random.vector(2.0));
            q[at.q + from..][..4].copy_from_slice(turn.coords.as_slice());
        }
    }
    q
}
