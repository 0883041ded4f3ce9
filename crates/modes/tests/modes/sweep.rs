//! Stiff and extreme scenes at random: each ends right, as right as it says, or in an error that says why.
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Motion, Passive, Vector3};
use solaris_modes::{
    Anchor, Guard, LimitLaw, Method, PointSpring, Rule, Run, RunError, RunFailure, Settings, Simulation,
};

/// Scenes of the sweep, and of the one that every run of the tests makes.
const SCENES: u64 = 200;
const FEW: u64 = 60;
/// How long each lasts (s).
const DURATION: f64 = 0.1;
/// How many times its own estimate a result may be off.
const FACTOR: f64 = 10.0;
/// What rounding leaves of a position (rad or m) where an estimate says nothing is lost.
const ROUNDING: f64 = 1e-11;

/// Numbers that look random: a linear congruential generator (D. E. Knuth, MMIX).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.unit()
    }

    /// A power of ten.
    fn decades(&mut self, least: f64, most: f64) -> f64 {
        10_f64.powf(self.between(least, most))
    }

    fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n - 1)
    }
}

/// A chain of one to four links whose masses differ by up to 1e±6, with springs of 1 to 1e9 in its joints and to the world.
fn scene(random: &mut Random) -> Simulation {
    let links = 1 + random.below(4);
    let mut builder = FigureBuilder::new("chain");
    for i in 0..links {
        let mass = if i == 0 { 1.0 } else { random.decades(-6.0, 6.0) };
        let length = random.between(0.2, 0.6);
        let mut joint =
            Joint::new(format!("j{i}")).at(Vector3::new(0.0, if i == 0 { 0.0 } else { -length }, 0.0));
        joint = match random.below(4) {
            0 => joint.ty(),
            1 => joint.rz().rx(),
            2 => joint.ry().rz(),
            _ => joint.rx(),
        };
        if random.below(3) == 0 {
            let stiffness = random.decades(0.0, 9.0);
            let damping = if random.below(2) == 0 { 0.0 } else { random.decades(-2.0, 3.0) };
            let friction = if random.below(4) == 0 { random.decades(-2.0, 1.0) } else { 0.0 };
            joint = joint.passive(Passive { stiffness, rest: random.between(-0.2, 0.2), damping, friction });
        }
        if random.below(4) == 0 {
            joint = joint.limited(-0.3, 0.3);
        }
        let inertia = Inertia::diagonal(0.02 * mass, 0.01 * mass, 0.02 * mass);
        let spec = if i == 0 {
            LinkSpec::root("l0", joint)
        } else {
            LinkSpec::child(format!("l{i}"), format!("l{}", i - 1), joint)
        };
        builder = builder.link(spec.mass(mass).com(Vector3::new(0.0, -0.5 * length, 0.0)).inertia(inertia));
    }
    let figure: Figure = builder.build().expect("a valid chain");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let layout = figure.layout();
    let q: Vec<f64> = (0..layout.nq()).map(|_| random.between(-0.25, 0.25)).collect();
    let v: Vec<f64> = (0..layout.nv()).map(|_| random.between(-2.0, 2.0)).collect();
    simulation.set_start(&q, &v).expect("a state");
    if random.below(2) == 0 {
        let point = Vector3::new(0.05, -0.1, 0.02);
        let world = Anchor { link: None, point: Vector3::new(0.4, -0.5, 0.3) };
        let between = [Anchor { link: Some(links - 1), point }, world];
        let (stiffness, damping) = (random.decades(0.0, 9.0), random.decades(-3.0, 4.0));
        simulation.add_spring(PointSpring { between, stiffness, damping, rest: 0.3 }).expect("a spring");
    }
    let law = match random.below(3) {
        0 => LimitLaw::Hard { restitution: random.unit() },
        1 => LimitLaw::Spring { stiffness: random.decades(2.0, 7.0), damping: random.decades(0.0, 3.0) },
        _ => LimitLaw::Ignore,
    };
    simulation.set_limits(law).expect("a law");
    simulation
}

/// Steps from far too long to tiny, or a tolerance.
fn method(random: &mut Random) -> Method {
    if random.below(2) == 0 {
        return Method::Automatic { tolerance: random.decades(-8.0, -2.0) };
    }
    Method::Fixed { rule: Rule::ALL[random.below(4)], step: random.decades(-5.0, 0.0) }
}

fn run(simulation: &Simulation, method: Method) -> Result<Run, RunError> {
    let guard = Guard { evaluations: 300_000, ..Guard::default() };
    simulation.run(&Settings { method, guard, ..Settings::new(DURATION, 100.0) })
}

/// The greatest difference of positions (rad or m).
fn apart(figure: &Figure, one: &Motion, other: &Motion) -> f64 {
    let mut step = vec![0.0; figure.layout().nv()];
    (0..one.len()).fold(0.0_f64, |most, frame| {
        figure.difference(one.q(frame), other.q(frame), &mut step).expect("two configurations");
        step.iter().fold(most, |most, x| most.max(x.abs()))
    })
}

/// The failure says when, and what to do.
fn check_failure(scene: u64, failure: &RunFailure) {
    assert!(failure.time.is_finite() && (0.0..=DURATION).contains(&failure.time), "scene {scene}: {failure}");
    assert!(!failure.remedies.is_empty(), "scene {scene}: {failure}");
}

/// What came of some of the scenes.
#[derive(Default)]
struct Sweep {
    right: usize,
    compared: usize,
    /// Farther off than their own estimate.
    beyond: usize,
    /// The greatest share of the bound, [`FACTOR`] estimates, that an error came to, and its scene.
    worst: (f64, u64),
    refused: usize,
    evaluations: u64,
}

/// Runs one scene and holds it to what it says of itself.
fn check(seed: u64, sweep: &mut Sweep) {
    let mut random = Random(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5851_f42d);
    let simulation = scene(&mut random);
    let method = method(&mut random);
    let found = match run(&simulation, method) {
        Ok(found) => found,
        Err(RunError::Failed(failure)) => {
            check_failure(seed, &failure);
            sweep.refused += 1;
            return;
        }
        Err(other) => panic!("scene {seed}: {other}"),
    };
    assert_eq!(found.motion.len(), 11, "scene {seed}");
    sweep.evaluations = sweep.evaluations.max(found.report.cost.counts.evaluations);
    let Some(estimate) = found.report.error else {
        assert!(!found.report.remarks.is_empty(), "scene {seed} has no estimate and does not say why");
        return;
    };
    sweep.right += 1;
    // The same scene, a hundred times more exact than it says that it is.
    let tolerance = match method {
        Method::Automatic { tolerance } => tolerance.min(estimate.position),
        _ => estimate.position,
    };
    let finer = Method::Automatic { tolerance: (0.01 * tolerance).clamp(1e-13, 1.0) };
    let Ok(reference) = run(&simulation, finer) else { return };
    sweep.compared += 1;
    let error = apart(simulation.figure(), &found.motion, &reference.motion);
    sweep.beyond += usize::from(error > estimate.position + ROUNDING);
    let share = error / (FACTOR * estimate.position + ROUNDING);
    if share > sweep.worst.0 {
        sweep.worst = (share, seed);
    }
    assert!(
        error <= FACTOR * estimate.position + ROUNDING,
        "scene {seed}, {method:?} ({}): off by {error:e}, said {:e}",
        found.report.method,
        estimate.position
    );
}

/// Runs the first scenes.
fn sweep(scenes: u64) {
    let mut sweep = Sweep::default();
    for seed in 0..scenes {
        check(seed, &mut sweep);
    }
    let Sweep { right, compared, beyond, worst, refused, evaluations } = sweep;
    println!(
        "{right} came to the end, {compared} of them compared, {beyond} farther off than they say, at most {:.2} of the bound in scene {}; \
         {refused} were refused with a reason; at most {evaluations} evaluations",
        worst.0, worst.1
    );
    let share = |part: usize| part as f64 / scenes as f64;
    // Of all two hundred 127 come to the end, 119 are compared and 8 are off by more than their own estimate, by a tenth and mostly of
    // rules of order one; of the first sixty 35, 33 and 2.
    assert!(share(right) >= 0.53, "{right} of {scenes} scenes are solved");
    assert!(share(compared) >= 0.48, "{compared} of {scenes} scenes are compared");
    assert!(share(beyond) <= 0.04, "{beyond} of {scenes} scenes are farther off than they say");
    // Two microseconds each: five seconds at the very most.
    assert!(evaluations <= 2_000_000, "{evaluations}");
}

#[test]
fn stiff_and_extreme_scenes_end_right_or_say_why() {
    sweep(FEW);
}

#[test]
#[ignore = "half a minute: cargo xtask nightly"]
fn many_stiff_and_extreme_scenes_end_right_or_say_why() {
    sweep(SCENES);
}
