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
}

/// A tree of `links` links: joints of 0 to 6 dofs of every kind, one in five links without mass, masses spread over
/// twice `decades` powers of ten.
pub(crate) fn tree(random: &mut Random, links: usize, decades: f64) -> Figure {
    tree_of(Joints::OneAxis, random, links, decades)
}

/// A tree as [`tree`] makes it, with the joints asked for; link `l3` has a frame `f3`, where there are more than one-axis
/// joints.
pub(crate) fn tree_of(joints: Joints, random: &mut Random, links: usize, decades: f64) -> Figure {
    let parents: Vec<usize> = (1..links).map(|i| random.below(i)).collect();
    let mut builder = FigureBuilder::new("random");
    for i in 0..links {
        let joint = joint(joints, random, &format!("j{i}")).placed(random.placement());
        let mut link = match i.checked_sub(1) {
            None => LinkSpec::root("l0", joint),
            Some(before) => LinkSpec::child(format!("l{i}"), format!("l{}", parents[before]), joint),
        };
        if joints != Joints::OneAxis {
            link = link.frame(format!("f{i}"), random.placement());
        }
        let massless = parents.contains(&i) && random.below(5) == 0;
        builder = builder.link(if massless { link } else { random.matter(link, decades) });
    }
    builder.build().expect("a valid figure")
}

fn joint(joints: Joints, random: &mut Random, name: &str) -> Joint {
    let whole = if joints == Joints::OneAxis { None } else { Some(random.below(6)) };
    let armature = match joints {
        Joints::OneAxis => 0.0,
        Joints::Every => 0.3 * random.below(2) as f64,
        Joints::EveryArmed => 0.3,
    };
    let mut joint = match whole {
        Some(0 | 1) => return Joint::ball(name).armature(armature),
        Some(2) => return Joint::free(name).armature(armature),
        _ => Joint::new(name),
    };
    for _ in 0..[0, 1, 1, 2, 3, 3, 6][random.below(7)] {
        joint = joint.axis(random.axis()).armature(armature);
    }
    // Half of the joints with room for them end in three turns about different coordinate axes.
    if joint.kind().nv() <= 3 && random.below(2) == 0 {
        let (first, step) = (random.below(3), 1 + random.below(2));
        for turn in 0..3 {
            joint =
                joint.axis(Axis::rotation(Vector3::ith((first + turn * step) % 3, 1.0))).armature(armature);
        }
    }
    joint
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
