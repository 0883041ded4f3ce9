//! Random figures and scenes, for tests.

use crate::contact::{ContactLaw, ContactPoint, GroundPlane, Surface};
use crate::element::{Anchor, LimitLaw, PointSpring};
use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, Limits, LinkSpec, Passive, Placement};

/// A source of numbers: the same seed, the same numbers (`SplitMix64`).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Uniform in [0, 1).
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        #[allow(clippy::cast_precision_loss, reason = "53 bits")]
        let uniform = ((z ^ (z >> 31)) >> 11) as f64;
        uniform / 9_007_199_254_740_992.0
    }

    /// Uniform between two numbers.
    pub(crate) fn between(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.next()
    }

    /// With this probability.
    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.next() < probability
    }

    /// Below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        #[allow(
            clippy::cast_precision_loss,
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "small"
        )]
        let index = (self.next() * end as f64) as usize;
        index
    }

    /// Each entry between −`most` and `most`.
    pub(crate) fn vector(&mut self, most: f64) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.between(-most, most))
    }

    /// So many numbers between −`most` and `most`.
    pub(crate) fn numbers(&mut self, count: usize, most: f64) -> Vec<f64> {
        (0..count).map(|_| self.between(-most, most)).collect()
    }
}

/// A figure of two to eight links, serial or branched, with all kinds of joints, and what acts in them.
pub(crate) fn figure(random: &mut Random) -> Figure {
    let count = 2 + random.below(7);
    let mut builder = FigureBuilder::new("random");
    for i in 0..count {
        let (name, joint) = (format!("l{i}"), joint(random, i));
        let link = if i == 0 {
            LinkSpec::root(name, joint)
        } else {
            LinkSpec::child(name, format!("l{}", random.below(i)), joint)
        };
        let spread = Matrix3::from_fn(|_, _| random.between(-0.3, 0.3));
        // With a positive second moment of its mass, so that it is that of a body.
        let second = spread * spread.transpose() + Matrix3::identity() * 0.01;
        let mass = random.between(0.2, 5.0);
        let tensor = (Matrix3::identity() * second.trace() - second) * mass;
        builder = builder.link(link.mass(mass).com(random.vector(0.3)).inertia(Inertia::Tensor(tensor)));
    }
    builder.build().expect("a valid figure")
}

fn joint(random: &mut Random, i: usize) -> Joint {
    let (name, some) = (format!("j{i}"), random.chance(0.5));
    let passive = Passive {
        stiffness: random.between(0.0, 30.0),
        rest: random.between(-0.3, 0.3),
        damping: random.between(0.0, 2.0),
        friction: random.between(0.0, 0.5),
    };
    let turn = UnitQuaternion::from_scaled_axis(random.vector(1.0));
    let placement = Placement::from_parts(random.vector(0.4).into(), turn);
    let armature = if random.chance(0.3) { 0.05 } else { 0.0 };
    let whole = |joint: Joint, stiffness: f64| {
        let joint = joint.placed(placement).armature(armature);
        if some { joint.passive(Passive { stiffness, rest: 0.0, ..passive }) } else { joint }
    };
    match random.below(8) {
        0 => return whole(Joint::ball(name), passive.stiffness),
        1 => return whole(Joint::free(name), 0.0),
        // A weld, but not at the root: something has to move.
        2 if i > 0 => return Joint::new(name).placed(placement),
        _ => {}
    }
    let mut joint = Joint::new(name).placed(placement);
    let (first, oblique) = (random.below(3), if random.chance(0.5) { 0.0 } else { 0.4 });
    for k in 0..=random.below(3) {
        // Never along the one before it.
        let direction = Vector3::ith((first + k) % 3, 1.0) + random.vector(oblique);
        let axis = if random.chance(0.7) { Axis::rotation(direction) } else { Axis::translation(direction) };
        joint = joint.axis(axis).armature(armature);
        if random.chance(0.3) {
            joint = joint.passive(passive);
        }
        if random.chance(0.5) {
            joint = joint.limited(random.between(-1.0, -0.1), random.between(0.1, 1.0));
        }
    }
    joint
}

/// Springs between points of the figure and of the world.
pub(crate) fn springs(random: &mut Random, figure: &Figure) -> Vec<PointSpring> {
    let anchor = |random: &mut Random| {
        let link = random.below(figure.links().len() + 1).checked_sub(1);
        Anchor { link, point: random.vector(0.5) }
    };
    let count = random.below(4);
    let spring = |_| PointSpring {
        between: [anchor(random), anchor(random)],
        stiffness: random.between(0.0, 200.0),
        damping: random.between(0.0, 10.0),
        rest: if random.chance(0.5) { random.between(0.0, 1.0) } else { 0.0 },
    };
    (0..count).map(spring).collect()
}

/// A slope through the middle of things, in two of three cases, and spheres of any links that can touch it.
pub(crate) fn ground(random: &mut Random, figure: &Figure) -> Option<Surface> {
    let law = ContactLaw::Compliant {
        stiffness: random.between(50.0, 500.0),
        damping: random.between(0.0, 2.0),
        slip: random.between(0.1, 1.0),
    };
    let up = Unit::new_normalize(random.vector(1.0));
    let plane =
        GroundPlane { up, height: random.between(-0.5, 0.5), friction: random.between(0.0, 1.0), law };
    let touch = |_| ContactPoint {
        link: random.below(figure.links().len()),
        center: random.vector(0.5),
        radius: if random.chance(0.5) { random.between(0.0, 0.2) } else { 0.0 },
    };
    let contact_points = (0..6).map(touch).collect();
    random.chance(0.67).then(|| Surface::new(figure, plane, contact_points).expect("valid"))
}

/// What the limits do, by degree of freedom.
pub(crate) fn limits(random: &mut Random, figure: &Figure) -> Vec<LimitLaw> {
    let law = |_| {
        let (stiffness, damping) = (random.between(10.0, 100.0), random.between(0.0, 5.0));
        if random.chance(0.5) { LimitLaw::Spring { stiffness, damping } } else { LimitLaw::Ignore }
    };
    (0..figure.layout().nv()).map(law).collect()
}

/// A configuration, beyond the limits of some joints.
pub(crate) fn configuration(random: &mut Random, figure: &Figure) -> Vec<f64> {
    let mut q = vec![0.0; figure.layout().nq()];
    figure.random(&mut q, || random.next()).expect("a valid source");
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        for (dof, q) in link.joint().kind().axes().iter().zip(&mut q[at.q..]) {
            if let Some(Limits { upper, .. }) = dof.limits.filter(|_| random.chance(0.3)) {
                *q = upper + random.between(0.01, 0.5);
            }
        }
    }
    q
}
