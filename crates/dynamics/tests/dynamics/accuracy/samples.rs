//! Figures and states whose every number is exact in single precision, so that an error is one of arithmetic.

use nalgebra::{Matrix3, Vector3};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, Link, LinkSpec, human};
use std::f64::consts::{FRAC_PI_2, PI};

/// Acceleration of gravity (m/s²): the multiple of 1/16 next to the standard one.
pub(super) const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.8125, 0.0);

/// How far the joints of chains are bent (rad): a nearly straight chain has the worst mass matrix.
const STRAIGHT: f64 = 0.3;

/// A figure with a state, the accelerations asked of inverse dynamics and the forces given to forward dynamics.
pub(super) struct Sample {
    pub(super) figure: Figure,
    pub(super) q: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) a: Vec<f64>,
    pub(super) tau: Vec<f64>,
}

/// A stream of random numbers (`SplitMix64`).
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    /// A number of single precision between −`scale` and `scale`.
    fn number(&mut self, scale: f64) -> f64 {
        single(((self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0) * scale)
    }

    fn numbers(&mut self, n: usize, scale: f64) -> Vec<f64> {
        (0..n).map(|_| self.number(scale)).collect()
    }

    /// A multiple of 1/64 between −`steps`/64 and `steps`/64: products of three such have few digits.
    fn step(&mut self, steps: u64) -> f64 {
        (self.below(2 * steps + 1) as f64 - steps as f64) / 64.0
    }

    fn steps(&mut self, steps: u64) -> Vector3<f64> {
        Vector3::new(self.step(steps), self.step(steps), self.step(steps))
    }

    /// A mass of 1 to 2 kg.
    fn mass(&mut self) -> f64 {
        1.0 + self.below(9) as f64 / 8.0
    }
}

pub(super) fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

/// Links of 1 to 2 kg and about 0.3 m in a chain, each turning about a coordinate axis of either sense.
pub(super) fn chain(random: &mut Random, links: usize) -> Result<Sample, String> {
    weighted_chain(random, links, |mass, _| mass)
}

/// A chain whose last link weighs `factor` times as much as it would.
pub(super) fn tipped_chain(random: &mut Random, links: usize, factor: f64) -> Result<Sample, String> {
    weighted_chain(random, links, |mass, i| if i + 1 == links { mass * factor } else { mass })
}

/// A chain whose masses lie anywhere between 2⁻²⁰ and 2²⁰ kg, a millionth and a million.
pub(super) fn uneven_chain(random: &mut Random, links: usize) -> Result<Sample, String> {
    let exponents: Vec<i32> = (0..links).map(|_| random.below(40) as i32 - 20).collect();
    weighted_chain(random, links, |mass, i| mass * 2.0_f64.powi(exponents[i]))
}

/// A chain with every speed up to 1000 rad/s.
pub(super) fn fast_chain(random: &mut Random, links: usize) -> Result<Sample, String> {
    let sample = chain(random, links)?;
    Ok(Sample { v: random.numbers(links, 1e3), ..sample })
}

/// A chain on a root that slides and turns, `distance` (m) away from the world's origin along every axis.
pub(super) fn distant_chain(random: &mut Random, links: usize, distance: f64) -> Result<Sample, String> {
    let root = Joint::new("root").tx().ty().tz().rz().ry().rx();
    let figure = build(random, links, |i| (i == 0).then(|| root.clone()), |mass, _| mass)?;
    let mut sample = with_state(random, figure, STRAIGHT);
    sample.q[..3].fill(distance);
    Ok(sample)
}

/// One body on a joint Z-Y-X that is `d` (rad) short of gimbal lock.
pub(super) fn near_lock(random: &mut Random, d: f64) -> Result<Sample, String> {
    let figure = build(random, 1, |_| Some(Joint::new("joint").rz().ry().rx()), |mass, _| mass)?;
    let mut sample = with_state(random, figure, PI);
    sample.q[1] = single(FRAC_PI_2 - d);
    Ok(sample)
}

/// The human of 1.75 m and 73 kg in any posture, every constant rounded to few digits.
pub(super) fn person(random: &mut Random) -> Result<Sample, String> {
    let exact = human(1.75, 73.0).map_err(|error| error.to_string())?;
    let builder = exact.links().iter().fold(FigureBuilder::new("human"), |builder, link| {
        builder.link(rounded(link, link.parent().map(|parent| exact.links()[parent].name())))
    });
    let figure = builder.build().map_err(|error| error.to_string())?;
    Ok(with_state(random, figure, 1.0))
}

/// The human with a left shoulder that is `d` (rad) short of gimbal lock.
pub(super) fn person_near_lock(random: &mut Random, d: f64) -> Result<Sample, String> {
    let mut sample = person(random)?;
    let shoulder = sample.figure.layout().dof_index("left_shoulder.ry").ok_or("a human has shoulders")?;
    sample.q[shoulder] = single(FRAC_PI_2 - d);
    Ok(sample)
}

fn weighted_chain(
    random: &mut Random,
    links: usize,
    weigh: impl Fn(f64, usize) -> f64,
) -> Result<Sample, String> {
    let figure = build(random, links, |_| None, weigh)?;
    Ok(with_state(random, figure, STRAIGHT))
}

/// A chain with the joints that `joint` gives, and turns about coordinate axes where it gives none.
fn build(
    random: &mut Random,
    links: usize,
    joint: impl Fn(usize) -> Option<Joint>,
    weigh: impl Fn(f64, usize) -> f64,
) -> Result<Figure, String> {
    let mut builder = FigureBuilder::new("chain");
    for i in 0..links {
        let joint = joint(i).unwrap_or_else(|| {
            let sense = if random.below(2) == 0 { 1.0 } else { -1.0 };
            let axis = Vector3::ith(random.below(3) as usize, sense);
            Joint::new(format!("joint {i}")).axis(Axis::rotation(axis))
        });
        let aside = random.steps(3);
        let along = Vector3::new(0.0, -0.25 - random.below(9) as f64 / 64.0, 0.0);
        let joint = joint.at(aside + along);
        let link = match i.checked_sub(1) {
            None => LinkSpec::root("link 0", joint),
            Some(parent) => LinkSpec::child(format!("link {i}"), format!("link {parent}"), joint),
        };
        let mass = weigh(random.mass(), i);
        // Second moments of a body a few centimetres across.
        let root = Matrix3::from_fn(|_, _| random.step(4)) + Matrix3::identity() / 64.0;
        let second = root * root.transpose() * mass;
        let inertia = Matrix3::identity() * second.trace() - second;
        builder = builder
            .link(link.mass(mass).com(random.steps(4) + along / 2.0).inertia(Inertia::Tensor(inertia)));
    }
    builder.build().map_err(|error| error.to_string())
}

/// `figure` in a state with coordinates to `reach` either way.
fn with_state(random: &mut Random, figure: Figure, reach: f64) -> Sample {
    let n = figure.layout().nv();
    Sample {
        q: random.numbers(n, reach),
        v: random.numbers(n, 1.0),
        a: random.numbers(n, 1.0),
        tau: random.numbers(n, 1.0),
        figure,
    }
}

/// A link of the human: lengths to 4 mm, mass to 6 binary digits.
fn rounded(link: &Link, parent: Option<&str>) -> LinkSpec {
    let grid = |x: f64, step: f64| (x / step).round() * step;
    let place = |p: &Vector3<f64>| p.map(|x| grid(x, 1.0 / 256.0));
    let joint = link.joint().clone().at(place(&link.joint().placement().translation.vector));
    let spec = match parent {
        None => LinkSpec::root(link.name(), joint),
        Some(parent) => LinkSpec::child(link.name(), parent, joint),
    };
    let mass = grid(link.mass(), 2.0_f64.powi(link.mass().log2().floor() as i32 - 5));
    let moments = link.inertia().diagonal();
    let second = (Vector3::repeat(moments.sum() / 2.0) - moments).map(|x| grid(x, 2.0_f64.powi(-22)));
    let moments = Vector3::repeat(second.sum()) - second;
    spec.mass(mass).com(place(link.com())).inertia(Inertia::diagonal(moments.x, moments.y, moments.z))
}
