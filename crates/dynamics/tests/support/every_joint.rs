//! Random figures with joints of every kind, and random states of them.

#![allow(dead_code, reason = "each test uses a part of it")]

use crate::support::random::Random;
use nalgebra::{Matrix3, Translation3, UnitQuaternion, Vector3};
use solaris_model::{
    Axis, Figure, FigureBuilder, FigureError, Inertia, Joint, JointKind, LinkSpec, Placement,
};

/// How the root is moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Root {
    /// By a free joint.
    Free,
    /// By three slides and three turns about coordinate axes, in any order and sense.
    Six,
    /// By any joint.
    Any,
}

/// A tree with joints of every kind; one in five links that carry others is without mass.
pub(crate) fn figure(random: &mut Random, root: Root) -> Figure {
    let links = 2 + random.below(8);
    // Long branches show more than wide ones.
    let parents: Vec<usize> = (1..links).map(|i| i - 1 - random.below(i.min(2))).collect();
    let mut builder = FigureBuilder::new("random");
    for i in 0..links {
        let kind = match (i, root) {
            (0, Root::Free) => Joint::free("j0"),
            (0, Root::Six) => six(random),
            _ => joint(random, &format!("j{i}")),
        };
        let joint = kind.placed(placement(random));
        let link = match i.checked_sub(1) {
            None => LinkSpec::root("l0", joint),
            Some(before) => LinkSpec::child(format!("l{i}"), format!("l{}", parents[before]), joint),
        };
        let massless = parents.contains(&i) && random.below(5) == 0;
        let link = if massless { link } else { matter(random, link) };
        let frame = placement(random);
        builder = builder.link(link.tip(random.vector(0.5)).frame(format!("f{i}"), frame));
    }
    builder.build().expect("a valid figure")
}

fn joint(random: &mut Random, name: &str) -> Joint {
    match random.below(8) {
        0 | 1 => Joint::ball(name).armature(0.1 * random.below(2) as f64),
        2 => Joint::free(name),
        _ => {
            let mut joint = Joint::new(name);
            for _ in 0..[0, 1, 2, 3, 4, 6][random.below(6)] {
                let sense = if random.below(2) == 0 { 1.0 } else { -1.0 };
                let direction = match random.below(5) {
                    i @ 0..3 => Vector3::ith(i, sense),
                    _ => random.vector(1.0) + Vector3::new(0.1, 1.1, 0.0) * sense,
                };
                joint = joint.axis(if random.below(3) == 0 {
                    Axis::translation(direction)
                } else {
                    Axis::rotation(direction)
                });
                if random.below(4) == 0 {
                    joint = joint.armature(0.2);
                }
            }
            joint
        }
    }
}

fn six(random: &mut Random) -> Joint {
    let mut joint = Joint::new("j0");
    for kind in [Axis::translation, Axis::rotation] {
        let (first, step) = (random.below(3), 1 + random.below(2));
        for i in 0..3 {
            let sense = if random.below(2) == 0 { 1.0 } else { -1.0 };
            joint = joint.axis(kind(Vector3::ith((first + i * step) % 3, sense)));
        }
    }
    joint
}

fn placement(random: &mut Random) -> Placement {
    let turn = if random.below(2) == 0 { Vector3::zeros() } else { random.vector(2.0) };
    Placement::from_parts(Translation3::from(random.vector(0.5)), UnitQuaternion::from_scaled_axis(turn))
}

fn matter(random: &mut Random, link: LinkSpec) -> LinkSpec {
    let mass = 2.0 + random.unit();
    let root = Matrix3::from_fn(|_, _| random.unit()) * 0.2;
    let second = root * root.transpose() * mass;
    let inertia = Matrix3::identity() * second.trace() - second;
    link.mass(mass).com(random.vector(0.3)).inertia(Inertia::Tensor((inertia + inertia.transpose()) / 2.0))
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
        let layout = figure.layout();
        let mut q = random.slice(layout.nq(), 1.2);
        for (link, at) in figure.links().iter().zip(layout.joints()) {
            if let Some(from) = link.joint().kind().quaternion() {
                let turn = UnitQuaternion::from_scaled_axis(random.vector(2.0));
                q[at.q + from..][..4].copy_from_slice(turn.coords.as_slice());
            }
        }
        Self { q, v: random.slice(layout.nv(), 2.0), a: random.slice(layout.nv(), 5.0) }
    }

    pub(crate) fn zeros(figure: &Figure) -> Self {
        let layout = figure.layout();
        Self { q: vec![0.0; layout.nq()], v: vec![0.0; layout.nv()], a: vec![0.0; layout.nv()] }
    }
}

/// Whether a joint can stand still only as a whole.
pub(crate) fn is_whole(kind: &JointKind) -> bool {
    kind.quaternion().is_some()
}

/// The figure built once more by the builder, which checks everything.
pub(crate) fn rebuilt(figure: &Figure) -> Result<Figure, FigureError> {
    let mut builder = FigureBuilder::new(figure.name());
    for link in figure.links() {
        let (name, joint) = (link.name(), link.joint().clone());
        let parent = link.parent().map(|parent| figure.links()[parent].name());
        let spec = parent.map_or_else(
            || LinkSpec::root(name, joint.clone()),
            |parent| LinkSpec::child(name, parent, joint.clone()),
        );
        let spec = spec.mass(link.mass()).com(*link.com()).inertia(Inertia::Tensor(*link.inertia()));
        let spec = link.frames().iter().fold(spec, |spec, frame| spec.frame(&frame.name, frame.placement));
        builder = builder.link(spec);
    }
    builder.build()
}
