//! The scenes, each with what it ought to come to.

use solaris_model::{
    Figure, FigureBuilder, FigureError, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind, Vector3,
};
use solaris_modes::{Collisions, ContactLaw, ContactPoint, Drive, GroundPlane, Rule, SetupError, Simulation};
use solaris_profiles::Profile;

pub(super) const G: f64 = 9.81;
const DOWN: Vector3<f64> = Vector3::new(0.0, -G, 0.0);

/// A scene, ready for every engine.
pub(super) struct Scene {
    pub(super) name: &'static str,
    /// By impulses, on rigid ground; and by springs, where nothing but the ground is touched.
    pub(super) rigid: Simulation,
    pub(super) springs: Option<Simulation>,
    /// Under which gravity it is left for half a second first, so that each engine begins as deep in the ground as it likes.
    pub(super) settle: Option<Vector3<f64>>,
    /// How long (s).
    pub(super) duration: f64,
    /// Links that are looked at.
    pub(super) watched: Vec<usize>,
    /// Constant forces (N) by degree of freedom.
    pub(super) forces: Vec<(String, f64)>,
    /// Of a spring without a damper (N/m) that it bounces on; 0 where nothing does.
    pub(super) elastic: f64,
    pub(super) error: Measure,
}

/// How far off what a run came to is.
type Measure = Box<dyn Fn(&Told) -> f64>;

/// What a run came to.
pub(super) struct Told {
    /// How long its steps took (s).
    pub(super) seconds: f64,
    /// By frame, from the beginning to the end, and by watched link: where it is (m).
    pub(super) places: Vec<Vec<Vector3<f64>>>,
    /// By frame: of motion, and in gravity from some height on (J).
    pub(super) energy: Vec<[f64; 2]>,
}

impl Told {
    /// How far the first watched link went.
    fn way(&self) -> Vector3<f64> {
        match &self.places[..] {
            [first, .., last] => last[0] - first[0],
            _ => Vector3::zeros(),
        }
    }

    /// The most that the mechanical energy of a frame is above that of the first (J).
    pub(super) fn gained(&self) -> f64 {
        let all: Vec<f64> = self.energy.iter().map(|[kinetic, potential]| kinetic + potential).collect();
        all.iter().map(|energy| energy - all[0]).fold(0.0, f64::max)
    }
}

/// Why a scene could not be made.
#[derive(Debug)]
pub(super) struct Faulty(String);

impl From<FigureError> for Faulty {
    fn from(error: FigureError) -> Self {
        Self(error.to_string())
    }
}

impl From<SetupError> for Faulty {
    fn from(error: SetupError) -> Self {
        Self(error.to_string())
    }
}

impl From<Faulty> for String {
    fn from(Faulty(why): Faulty) -> Self {
        why
    }
}

/// All of them.
pub(super) fn all() -> Result<Vec<Scene>, Faulty> {
    Ok(vec![
        slope("block on a slope, tan α = 0.9 μ", 0.9)?,
        slope("block on a slope, tan α = μ", 1.0)?,
        slope("block on a slope, tan α = 1.1 μ", 1.1)?,
        rolling()?,
        bouncing()?,
        stack()?,
        gripper("gripper, 0.9 of what holds", 0.9)?,
        gripper("gripper, 1.1 of what holds", 1.1)?,
        gripper("gripper, twice what holds", 2.0)?,
    ])
}

/// The rule by which springs are stepped.
pub(super) const RULE: Rule = Rule::RungeKutta4;

/// Of the block and what it lies on.
const FRICTION: f64 = 0.5;
/// Of the ball (m), its speed (m/s) and what it slides on.
const RADIUS: f64 = 0.1;
const SPEED: f64 = 2.0;
const ROUGH: f64 = 0.3;
/// From which it falls (m), and on which spring (N/m).
const HEIGHT: f64 = 0.5;
const STIFFNESS: f64 = 1e4;
/// Between fingers and block.
const GRIP: f64 = 0.8;

fn solid(kind: ShapeKind) -> Inertia {
    Inertia::Uniform(Shape { kind, placement: Placement::identity() })
}

fn boxed(x: f64, y: f64, z: f64) -> ShapeKind {
    ShapeKind::Box { size: Vector3::new(x, y, z) }
}

/// 1 kg that flies.
fn flying(kind: ShapeKind) -> Result<Figure, FigureError> {
    let link = LinkSpec::root("body", Joint::free("root")).mass(1.0).inertia(solid(kind));
    FigureBuilder::new("body").link(link).build()
}

/// Over a floor by both laws, from a height (m) on and with a velocity (m/s) along x.
fn grounded(
    figure: &Figure,
    gravity: Vector3<f64>,
    friction: f64,
    touches: &[ContactPoint],
    (height, speed): (f64, f64),
) -> Result<[Simulation; 2], SetupError> {
    let of = |law: Option<ContactLaw>| {
        let mut simulation = Simulation::new(figure, gravity);
        let plane = GroundPlane::under(figure, &DOWN, friction)?;
        let law = law.unwrap_or(plane.law);
        simulation.set_ground(GroundPlane { law, ..plane }, touches.to_vec())?;
        let at = [0.0, height, 0.0, 0.0, 0.0, 0.0, 1.0];
        simulation.set_start(&at, &[speed, 0.0, 0.0, 0.0, 0.0, 0.0])?;
        Ok::<_, SetupError>(simulation)
    };
    Ok([of(Some(ContactLaw::Rigid))?, of(None)?])
}

/// A cube of 1 kg that touches with the corners of its lower face; the slope is a level floor under a gravity that leans.
///
/// ```text
/// x = ½·g·(sin α − μ·cos α)·t²    where that is above zero, or else 0
/// ```
fn slope(name: &'static str, part: f64) -> Result<Scene, Faulty> {
    let half = 0.1;
    let alpha = (part * FRICTION).atan();
    let gravity = G * Vector3::new(alpha.sin(), -alpha.cos(), 0.0);
    let corners = [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)];
    let touches = corners.map(|(x, z)| {
        let center = half * Vector3::new(x, -1.0, z);
        ContactPoint { link: 0, center, radius: 0.0 }
    });
    let figure = flying(boxed(2.0 * half, 2.0 * half, 2.0 * half))?;
    let [rigid, springs] = grounded(&figure, gravity, FRICTION, &touches, (half, 0.0))?;
    let duration: f64 = 1.0;
    let pull = G * (alpha.sin() - FRICTION * alpha.cos()).max(0.0);
    Ok(Scene {
        name,
        rigid,
        springs: Some(springs),
        settle: Some(DOWN),
        duration,
        watched: vec![0],
        forces: Vec::new(),
        elastic: 0.0,
        error: Box::new(move |told| (told.way().x - 0.5 * pull * duration * duration).abs()),
    })
}

fn ball() -> Result<(Figure, [ContactPoint; 1]), FigureError> {
    let figure = flying(ShapeKind::Sphere { radius: RADIUS })?;
    Ok((figure, [ContactPoint { link: 0, center: Vector3::zeros(), radius: RADIUS }]))
}

/// A ball of 1 kg that slides until it rolls, from `t₁ = 2v/(7μg)` on with 5/7 of its speed.
///
/// ```text
/// x = v·t − ½·μ·g·t²   until t₁,    then  x₁ + (5/7)·v·(t − t₁)
/// ```
fn rolling() -> Result<Scene, Faulty> {
    let (figure, touches) = ball()?;
    let [rigid, springs] = grounded(&figure, DOWN, ROUGH, &touches, (RADIUS, SPEED))?;
    let duration = 0.5;
    let rolls = 2.0 * SPEED / (7.0 * ROUGH * G);
    let slid = SPEED * rolls - 0.5 * ROUGH * G * rolls * rolls;
    let answer = slid + 5.0 / 7.0 * SPEED * (duration - rolls);
    Ok(Scene {
        name: "ball that slides until it rolls",
        rigid,
        springs: Some(springs),
        settle: Some(DOWN),
        duration,
        watched: vec![0],
        forces: Vec::new(),
        elastic: 0.0,
        error: Box::new(move |told| (told.way().x - answer).abs()),
    })
}

/// The ball, dropped on a spring without a damper: 0.6 s later it is on its way up, with all its energy. The error is a share of it.
fn bouncing() -> Result<Scene, Faulty> {
    let (figure, touches) = ball()?;
    let [rigid, mut springs] = grounded(&figure, DOWN, 0.0, &touches, (RADIUS + HEIGHT, 0.0))?;
    let law = ContactLaw::Compliant { stiffness: STIFFNESS, damping: 0.0, slip: ContactLaw::SLIP };
    springs.set_ground(GroundPlane { law, ..GroundPlane::under(&figure, &DOWN, 0.0)? }, touches.to_vec())?;
    let error = |told: &Told| match &told.energy[..] {
        [first, .., last] => ((last[0] + last[1] - first[0] - first[1]) / (G * HEIGHT)).abs(),
        _ => f64::INFINITY,
    };
    Ok(Scene {
        name: "ball that bounces",
        rigid,
        springs: Some(springs),
        settle: None,
        duration: 0.6,
        watched: vec![0],
        forces: Vec::new(),
        elastic: STIFFNESS,
        error: Box::new(error),
    })
}

/// Ten cubes of 0.2 m and 2 kg on each other: the error is how far one of them went in 2 s.
fn stack() -> Result<Scene, Faulty> {
    const COUNT: usize = 10;
    let side = 0.2;
    let slab = Shape { kind: boxed(4.0, 0.2, 4.0), placement: Placement::translation(0.0, -0.1, 0.0) };
    let mut builder =
        FigureBuilder::new("boxes").link(LinkSpec::root("slab", Joint::new("slab")).mass(1.0).shape(slab));
    let cube = boxed(side, side, side);
    for i in 0..COUNT {
        let link = LinkSpec::child(format!("box{i}"), "slab", Joint::free(format!("box{i}")));
        builder = builder.link(link.mass(2.0).inertia(solid(cube)));
    }
    let figure = builder.build()?;
    let mut rigid = Simulation::new(&figure, DOWN);
    let at = |i: usize| [0.0, side * (i as f64 + 0.5), 0.0, 0.0, 0.0, 0.0, 1.0];
    rigid.set_start(&(0..COUNT).flat_map(at).collect::<Vec<_>>(), &[0.0; 6 * COUNT])?;
    rigid.set_collisions(Collisions::of(&figure, FRICTION)?)?;
    let error = |told: &Told| match &told.places[..] {
        [first, .., last] => first.iter().zip(last).map(|(a, b)| (b - a).norm()).fold(0.0, f64::max),
        _ => f64::INFINITY,
    };
    Ok(Scene {
        name: "stack of ten boxes",
        rigid,
        springs: None,
        settle: None,
        duration: 2.0,
        watched: (1..=COUNT).collect(),
        forces: Vec::new(),
        elastic: 0.0,
        error: Box::new(error),
    })
}

/// A cube of 1 kg between two fingers on slides that press it with `part` of what holds its weight: it stays, or it slides down.
///
/// ```text
/// F = part·m·g/(2μ) on each finger,    y = −½·(1 − part)·g·t²    where part < 1
/// ```
fn gripper(name: &'static str, part: f64) -> Result<Scene, Faulty> {
    let finger = |name: &str, x: f64| {
        let link = LinkSpec::child(name, "stand", Joint::new(name).at(Vector3::x() * x).tx());
        link.mass(0.2).inertia(solid(boxed(0.02, 0.6, 0.1)))
    };
    let block = LinkSpec::child("block", "stand", Joint::free("block")).mass(1.0);
    let figure = FigureBuilder::new("gripper")
        .link(LinkSpec::root("stand", Joint::new("stand")).mass(1.0))
        .link(finger("left", -0.06))
        .link(finger("right", 0.06))
        .link(block.inertia(solid(boxed(0.1, 0.1, 0.1))))
        .build()?;
    let mut rigid = Simulation::new(&figure, DOWN);
    rigid.set_collisions(Collisions { pairs: vec![[1, 3], [2, 3]], friction: GRIP })?;
    let force = part * G / (2.0 * GRIP);
    let forces = vec![("left.tx".to_owned(), force), ("right.tx".to_owned(), -force)];
    let duration: f64 = 0.5;
    for (dof, force) in &forces {
        let curve = Profile::Line { from: *force, to: *force, duration: 10.0 };
        rigid.drive(dof, [Drive::Torque(curve)])?;
    }
    let fall = 0.5 * G * (1.0 - part).max(0.0) * duration * duration;
    Ok(Scene {
        name,
        rigid,
        springs: None,
        settle: Some(Vector3::zeros()),
        duration,
        watched: vec![3],
        forces,
        elastic: 0.0,
        error: Box::new(move |told| (told.way().y + fall).abs()),
    })
}
