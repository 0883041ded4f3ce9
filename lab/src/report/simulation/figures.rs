//! The scenes that are measured.

use super::solutions::{self, Solution};
use solaris_model::{
    Axis, Figure, FigureBuilder, FigureError, HumanError, Inertia, Joint, LinkSpec, Passive, Placement,
    Shape, ShapeKind, Vector3,
};
use solaris_modes::study::{Study, StudyOptions, study};
use solaris_modes::{
    Anchor, Drive, LimitLaw, Method, PointSpring, RunError, Settings, SetupError, Simulation, Step,
};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

pub(super) const G: f64 = 9.81;
pub(super) const DOWN: Vector3<f64> = Vector3::new(0.0, -G, 0.0);

/// A scene with what is known of it.
pub(super) struct Case {
    pub(super) name: &'static str,
    pub(super) simulation: Simulation,
    /// How long (s), and in how many frames a second (1/s).
    pub(super) duration: f64,
    pub(super) rate: f64,
    /// None where only conserved quantities are known.
    pub(super) solution: Option<Solution>,
}

/// A case by some methods, its closed form or the finest run beside it.
pub(super) fn studied(case: &Case, methods: &[Method]) -> Result<Study, String> {
    let mut settings = Settings::new(case.duration, case.rate);
    settings.method = Method::Automatic { tolerance: 1e-6 };
    let options = StudyOptions {
        methods: methods.to_vec(),
        solution: case.solution.as_deref().map(|solution| solution as _),
        repeats: 1,
        evaluations: 600_000,
        ..StudyOptions::default()
    };
    study(&case.simulation, &settings, &options, &mut (), &mut |_| {})
        .map_err(|error| format!("{}: {error}", case.name))
}

/// Why a scene could not be made.
#[derive(Debug)]
pub(super) struct Faulty(String);

impl From<FigureError> for Faulty {
    fn from(error: FigureError) -> Self {
        Self(error.to_string())
    }
}

impl From<HumanError> for Faulty {
    fn from(error: HumanError) -> Self {
        Self(error.to_string())
    }
}

impl From<SetupError> for Faulty {
    fn from(error: SetupError) -> Self {
        Self(error.to_string())
    }
}

impl From<RunError> for Faulty {
    fn from(error: RunError) -> Self {
        Self(error.to_string())
    }
}

impl From<Faulty> for String {
    fn from(Faulty(why): Faulty) -> Self {
        why
    }
}

/// The scenes whose motion is known in closed form.
pub(super) fn closed() -> Result<Vec<Case>, Faulty> {
    let case = |name, simulation, duration, solution| Case {
        name,
        simulation,
        duration,
        rate: 100.0,
        solution: Some(solution),
    };
    let spin = Vector3::new(1.0, 0.0, 8.0);
    let velocity = Vector3::new(1.0, 4.0, 0.5);
    let (angles, rate) = solutions::chain_mode(10, 0.1, G, 1e-5);
    Ok(vec![
        case("pendulum, 10 s", pendulum()?, 10.0, solutions::pendulum(FRAC_PI_2, G.sqrt())),
        case("torque-free top, 5 s", top(spin)?, 5.0, solutions::top(0.02, 0.03, spin)),
        case("thrown body with spin, 2 s", thrown(velocity)?, 2.0, solutions::thrown(velocity, 6.0, DOWN)),
        case("damped spring, 5 s", damped()?, 5.0, solutions::damped(0.1, 10.0, 0.5)),
        case(
            "hanging chain of 10, 5 s, angles to 1e-5",
            chain(&angles)?,
            5.0,
            solutions::swinging(angles.clone(), rate),
        ),
        case("bouncing mass, 2 s", bouncing()?, 2.0, solutions::bouncing(1.0, 0.8, G)),
    ])
}

/// Scenes of which energy and momentum are known.
pub(super) fn conserved() -> Result<Vec<Case>, Faulty> {
    let case = |name, simulation, duration| Case { name, simulation, duration, rate: 100.0, solution: None };
    Ok(vec![case("tumbling body, 10 s", tumbling()?, 10.0), case("falling cat, 1 s", cat()?, 1.0)])
}

pub(super) fn built(name: &str, links: impl IntoIterator<Item = LinkSpec>) -> Result<Figure, FigureError> {
    links.into_iter().fold(FigureBuilder::new(name), FigureBuilder::link).build()
}

/// A point mass of 1 kg on a massless rod of 1 m, let go from the horizontal.
pub(super) fn pendulum() -> Result<Simulation, Faulty> {
    let bob = Vector3::new(0.0, -1.0, 0.0);
    let figure = built("pendulum", [LinkSpec::root("bob", Joint::new("pivot").rx()).mass(1.0).com(bob)])?;
    let mut simulation = Simulation::new(&figure, DOWN);
    simulation.set_start(&[FRAC_PI_2], &[0.0])?;
    Ok(simulation)
}

fn top(spin: Vector3<f64>) -> Result<Simulation, Faulty> {
    let body =
        LinkSpec::root("body", Joint::ball("pivot")).mass(1.0).inertia(Inertia::diagonal(0.02, 0.02, 0.03));
    let mut simulation = Simulation::new(&built("top", [body])?, Vector3::zeros());
    simulation.set_start(&[0.0, 0.0, 0.0, 1.0], spin.as_slice())?;
    Ok(simulation)
}

fn thrown(velocity: Vector3<f64>) -> Result<Simulation, Faulty> {
    let body =
        LinkSpec::root("body", Joint::free("root")).mass(2.0).inertia(Inertia::diagonal(0.02, 0.025, 0.03));
    let mut simulation = Simulation::new(&built("thrown", [body])?, DOWN);
    let [x, y, z] = velocity.into();
    simulation.set_start(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], &[x, y, z, 0.0, 0.0, 6.0])?;
    Ok(simulation)
}

/// 2 kg on a spring: 10 rad/s, decay 0.5 1/s.
fn damped() -> Result<Simulation, Faulty> {
    let passive = Passive { stiffness: 200.0, damping: 2.0, ..Passive::default() };
    let mass = LinkSpec::root("mass", Joint::new("slide").tx().passive(passive)).mass(2.0);
    let mut simulation = Simulation::new(&built("spring", [mass])?, Vector3::zeros());
    simulation.set_start(&[0.1], &[0.0])?;
    Ok(simulation)
}

fn chain(angles: &[f64]) -> Result<Simulation, Faulty> {
    let thread = Vector3::new(0.0, -0.1, 0.0);
    let name = |i: usize| format!("mass{i}");
    let links = (0..angles.len()).map(|i| {
        let joint = Joint::new(format!("joint{i}"));
        let link = if i == 0 {
            LinkSpec::root(name(0), joint.rx())
        } else {
            LinkSpec::child(name(i), name(i - 1), joint.at(thread).rx())
        };
        link.mass(0.1).com(thread)
    });
    let mut simulation = Simulation::new(&built("chain", links)?, DOWN);
    simulation.set_start(angles, &vec![0.0; angles.len()])?;
    Ok(simulation)
}

fn bouncing() -> Result<Simulation, Faulty> {
    let mass = LinkSpec::root("mass", Joint::new("fall").ty().limited(0.0, 10.0)).mass(1.0);
    let mut simulation = Simulation::new(&built("bouncing", [mass])?, DOWN);
    simulation.set_limits(LimitLaw::Hard { restitution: 0.8 })?;
    simulation.set_start(&[1.0], &[0.0])?;
    Ok(simulation)
}

/// Turned about its middle axis, and a little about another: it tumbles for ever.
fn tumbling() -> Result<Simulation, Faulty> {
    let body =
        LinkSpec::root("body", Joint::free("root")).mass(1.0).inertia(Inertia::diagonal(0.02, 0.03, 0.04));
    let mut simulation = Simulation::new(&built("tumbling", [body])?, Vector3::zeros());
    simulation.set_start(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], &[0.0, 0.0, 0.0, 5e-3, 5.0, 0.0])?;
    Ok(simulation)
}

/// Two halves on a universal joint that bends and turns: it lands on its feet with no momentum at any time.
fn cat() -> Result<Simulation, Faulty> {
    let half = |link: LinkSpec, side: f64| {
        let inertia = Inertia::diagonal(0.004, 0.004, 0.002);
        link.mass(1.5).com(Vector3::new(0.0, 0.0, 0.1 * side)).inertia(inertia)
    };
    let waist = Joint::new("waist").rx().ry();
    let links = [
        half(LinkSpec::root("front", Joint::free("root")), 1.0),
        half(LinkSpec::child("back", "front", waist), -1.0),
    ];
    let mut simulation = Simulation::new(&built("cat", links)?, DOWN);
    let moves = |angles: &[f64]| -> Vec<Step> {
        let along = solaris_modes::Shape::MinimumJerk;
        angles.iter().map(|&to| Drive::Move { to, over: 0.25, along }.into()).collect()
    };
    simulation.drive("waist.rx", moves(&[1.2, 1.2, 0.0, 0.0]))?;
    simulation.drive("waist.ry", moves(&[0.0, 0.9, 0.9, 0.0]))?;
    Ok(simulation)
}

/// The stiff flyball governor of the `IFToMM` benchmark (A05), z up; 10 s.
pub(super) fn governor() -> Result<Case, Faulty> {
    let solid = |x: f64, y: f64, z: f64, at: Vector3<f64>| {
        let kind = ShapeKind::Box { size: Vector3::new(x, y, z) };
        Inertia::Uniform(Shape { kind, placement: Placement::translation(at.x, at.y, at.z) })
    };
    let slim = |at| solid(0.01, 0.01, 1.0, at);
    let middle = Vector3::new(0.0, 0.0, -0.5);
    let mut links = vec![
        LinkSpec::root("shaft", Joint::new("spin").rz()).mass(0.3).inertia(slim(Vector3::zeros())),
        LinkSpec::child("base", "shaft", Joint::new("slide").at(middle).tz()).mass(3.0).inertia(solid(
            0.1,
            0.1,
            0.1,
            Vector3::zeros(),
        )),
    ];
    for (side, name) in [(1.0, "right"), (-1.0, "left")] {
        let hinge = Vector3::new(0.05 * side, 0.0, 0.5);
        let joint = Joint::new(format!("{name}_hinge")).at(hinge);
        let joint = joint.axis(Axis::rotation(Vector3::new(0.0, -side, 0.0))).named(format!("{name}.theta"));
        let rod = format!("{name}_rod");
        links.push(LinkSpec::child(rod.clone(), "shaft", joint).mass(0.3).inertia(slim(middle)));
        let weld = Joint::new(format!("{name}_weld")).at(2.0 * middle);
        links.push(LinkSpec::child(format!("{name}_ball"), rod, weld).mass(5.0));
    }
    let figure = built("governor", links)?;
    let link = |name: &str| figure.link_index(name).ok_or_else(|| Faulty(format!("no link {name}")));
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, 0.0, -G));
    for (side, name) in [(1.0, "right_rod"), (-1.0, "left_rod")] {
        let base = Anchor { link: Some(link("base")?), point: Vector3::new(0.05 * side, 0.0, 0.0) };
        let rod = Anchor { link: Some(link(name)?), point: middle };
        simulation.add_spring(PointSpring {
            between: [base, rod],
            stiffness: 8e5,
            damping: 4e4,
            rest: 0.5,
        })?;
    }
    simulation.set_start(&[0.0, 0.5, FRAC_PI_3, FRAC_PI_3], &[TAU, 0.0, 0.0, 0.0])?;
    Ok(Case { name: "governor, 10 s", simulation, duration: 10.0, rate: 100.0, solution: None })
}

/// Two rods of 1 m, the lower one with a mass so many times the upper one's 1 kg, let go from 1 rad and 2 rad.
pub(super) fn ratio(ratio: f64) -> Result<Simulation, Faulty> {
    let bob = Vector3::new(0.0, -1.0, 0.0);
    let rod = |link: LinkSpec, mass: f64| {
        link.mass(mass).com(bob).inertia(Inertia::diagonal(0.1 * mass, 0.01 * mass, 0.1 * mass))
    };
    let links = [
        rod(LinkSpec::root("upper", Joint::new("pivot").rx()), 1.0),
        rod(LinkSpec::child("lower", "upper", Joint::new("elbow").at(bob).rx()), ratio),
    ];
    let mut simulation = Simulation::new(&built("two rods", links)?, DOWN);
    simulation.set_start(&[1.0, 1.0], &[0.0, 0.0])?;
    Ok(simulation)
}

/// 1 kg on a spring of this stiffness (N/m) with a fifth of the critical damping, let go at 0.1 m.
pub(super) fn spring(stiffness: f64) -> Result<Simulation, Faulty> {
    let passive = Passive { stiffness, damping: 0.4 * stiffness.sqrt(), ..Passive::default() };
    let mass = LinkSpec::root("mass", Joint::new("slide").tx().passive(passive)).mass(1.0);
    let mut simulation = Simulation::new(&built("spring", [mass])?, Vector3::zeros());
    simulation.set_start(&[0.1], &[0.0])?;
    Ok(simulation)
}
