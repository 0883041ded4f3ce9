//! The stiff flyball governor, A05 of the multibody benchmarks of González, Dopico, Lugrís and Cuadrado (2006), as a tree with
//! two springs between points.
//!
//! The positions of the slider were computed by other programs, Radau at 1e-12 against BDF at 1e-11, and hold to 6e-10.

use solaris_model::{Axis, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{
    Anchor, FailureKind, Method, PointSpring, Remedy, Rule, Run, RunError, Settings, Simulation,
};

/// Time (s) and position of the slider (m).
const POSITIONS: [(f64, f64); 7] = [
    (0.5, 0.743_249_425),
    (1.0, 0.501_420_922),
    (2.0, 0.505_909_294),
    (3.0, 0.513_246_078),
    (5.0, 0.535_563_104),
    (8.0, 0.583_178_337),
    (10.0, 0.619_622_917),
];

/// Speed of the shaft at 10 s (rad/s).
const SPEED: f64 = 5.548_203_623;

/// Frames a second.
const RATE: f64 = 10.0;

/// The inertia (kg m²) of a box about its centre, by its half sizes (m).
fn cuboid(mass: f64, half: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = half.map(|h| h * h);
    [mass / 3.0 * (y + z), mass / 3.0 * (x + z), mass / 3.0 * (x + y)]
}

fn governor() -> Simulation {
    let inertia = |[x, y, z]: [f64; 3]| Inertia::diagonal(x, y, z);
    let shaft = LinkSpec::root("shaft", Joint::new("spin").rz())
        .mass(0.3)
        .inertia(inertia(cuboid(0.3, [0.005, 0.005, 0.5])));
    let base = LinkSpec::child("base", "shaft", Joint::new("slide").at(Vector3::new(0.0, 0.0, -0.5)).tz())
        .mass(3.0)
        .inertia(inertia(cuboid(3.0, [0.05; 3])));
    // A rod of 0.3 kg with a point of 5 kg at its far end.
    let (rod, ball) = (0.3, 5.0);
    let center = (rod * 0.5 + ball * 1.0) / (rod + ball);
    let apart = rod * ball / (rod + ball) * 0.25;
    let [x, y, z] = cuboid(rod, [0.005, 0.005, 0.5]);
    let arm = |name: &str, side: f64| {
        let joint = Joint::new(format!("{name} hinge"))
            .at(Vector3::new(side * 0.05, 0.0, 0.5))
            .axis(Axis::rotation(Vector3::new(0.0, -side, 0.0)));
        LinkSpec::child(name, "shaft", joint)
            .mass(rod + ball)
            .com(Vector3::new(0.0, 0.0, -center))
            .inertia(inertia([x + apart, y + apart, z]))
    };
    let figure = FigureBuilder::new("governor")
        .link(shaft)
        .link(base)
        .link(arm("right", 1.0))
        .link(arm("left", -1.0))
        .build()
        .expect("a valid figure");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, 0.0, -9.81));
    let third = 60_f64.to_radians();
    let q = [0.0, 0.5, third, third];
    simulation.set_start(&q, &[std::f64::consts::TAU, 0.0, 0.0, 0.0]).expect("a state");
    for (link, side) in [(2, 1.0), (3, -1.0)] {
        let on_base = Anchor { link: Some(1), point: Vector3::new(side * 0.05, 0.0, 0.0) };
        let on_rod = Anchor { link: Some(link), point: Vector3::new(0.0, 0.0, -0.5) };
        let spring = PointSpring { between: [on_base, on_rod], stiffness: 8e5, damping: 4e4, rest: 0.5 };
        simulation.add_spring(spring).expect("a spring");
    }
    simulation
}

fn run(method: Method) -> Result<Run, RunError> {
    governor().run(&Settings { method, estimate: false, ..Settings::new(10.0, RATE) })
}

/// How far the slider is from where it should be, at most (m).
fn error(run: &Run) -> f64 {
    POSITIONS.iter().fold(0.0_f64, |most, &(time, position)| {
        let frame = (time * RATE).round() as usize;
        most.max((run.motion.q(frame)[1] - position).abs())
    })
}

#[test]
fn a_step_within_stability_gives_the_published_positions() {
    let run = run(Method::Fixed { rule: Rule::RungeKutta4, step: 1e-4 }).expect("a stable step");
    assert!(error(&run) < 1e-8, "{:e}", error(&run));
    let shaft = run.motion.v(100)[0];
    assert!((shaft - SPEED).abs() < 1e-8, "{shaft}");
    // Nothing from outside turns the figure about the shaft.
    assert!(run.report.energy.imbalance < 1e-4 * run.report.energy.scale, "{:?}", run.report.energy);
}

#[test]
fn a_step_beyond_stability_ends_in_advice() {
    // −8117 1/s at the start: 2.785/8117 s and 2/8117 s.
    for (rule, step, stable) in [(Rule::RungeKutta4, 3.6e-4, 3.43e-4), (Rule::ExplicitEuler, 2.6e-4, 2.46e-4)]
    {
        let Err(RunError::Failed(failure)) = run(Method::Fixed { rule, step }) else {
            panic!("{rule} at {step} s has to be refused")
        };
        let FailureKind::StepTooLong { longest, eigenvalue, .. } = failure.cause else { panic!("{failure}") };
        assert!((longest - stable).abs() < 0.01 * stable, "{longest}");
        assert!((eigenvalue + 8117.0).abs() < 2.0, "{eigenvalue}");
        assert_eq!(failure.remedies, [Remedy::StepBelow { step: longest }, Remedy::StiffMethod], "{failure}");
        assert!(failure.to_string().contains("a step below"), "{failure}");
    }
}

#[cfg(feature = "stiff")]
#[test]
fn the_stiff_method_keeps_its_tolerance() {
    for (tolerance, evaluations) in [(1e-9, 60_000), (1e-10, 100_000)] {
        let run = run(Method::Stiff { tolerance }).expect("it comes to the end");
        println!("{tolerance:e}: {:e}, {:?}", error(&run), run.report.cost.counts);
        assert!(error(&run) < 1e-6, "{:e}", error(&run));
        assert!(run.report.cost.counts.evaluations < evaluations, "{:?}", run.report.cost.counts);
    }
}

#[cfg(feature = "stiff")]
#[test]
fn the_adaptive_explicit_method_takes_as_long_whatever_the_tolerance() {
    let counts = [1e-4, 1e-6].map(|tolerance| {
        let run = run(Method::Adaptive { tolerance }).expect("it comes to the end");
        println!("{tolerance:e}: {:e}, {:?}", error(&run), run.report.cost.counts);
        run.report.cost.counts.evaluations as f64
    });
    assert!(counts.iter().all(|count| (5e4..4e5).contains(count)), "{counts:?}");
    assert!((counts[1] / counts[0] - 1.0).abs() < 0.5, "{counts:?}");
}
