//! Limp people on the ground: nothing drives them, so that their energy only falls until they rest.

use crate::contact::G;
use solaris_dynamics::{Tree, Workspace, forward_kinematics, kinetic_energy, potential_energy};
use solaris_model::{Figure, Human, Vector3};
use solaris_modes::{
    ContactLaw, ContactPoint, GroundPlane, LimitLaw, Method, Rule, Run, Settings, Simulation, contact_points,
};
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};

/// Of the ground (N/m): a whole weight on one point sinks in by 7 mm, as into flesh.
const GROUND: f64 = 1e5;
/// Of limits (N m/rad).
const LIMITS: f64 = 1000.0;
/// The coefficient of friction, and the speed (m/s) at which friction has 71 % of its magnitude. Toes, feet and clavicles turn about
/// their long axes with next to no inertia, and friction on them has rates of some 10⁵ 1/s at this speed already.
const FRICTION: (f64, f64) = (0.8, 0.1);
/// Frames a second.
const RATE: f64 = 200.0;

/// Numbers in [0, 1), the same ones for the same seed.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// What a fall is measured by, beside its own report.
struct Meter {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    contact_points: Vec<ContactPoint>,
    figure: Figure,
}

impl Meter {
    fn new() -> Self {
        let figure = Human::new(1.75, 73.0).limp().build().expect("within range");
        let tree = Tree::new(&figure, Vector3::new(0.0, -G, 0.0)).expect("valid");
        let workspace = Workspace::new(&tree);
        Self { tree, workspace, contact_points: contact_points(&figure), figure }
    }

    /// Heights (m) of the lowest points.
    fn heights(&mut self, q: &[f64]) -> Vec<f64> {
        forward_kinematics(&self.tree, &mut self.workspace, q).expect("finite");
        let pose =
            |touch: &ContactPoint| self.workspace.pose(touch.link).transform(&touch.center).y - touch.radius;
        self.contact_points.iter().map(pose).collect()
    }

    /// Of motion, and all mechanical energy (J): of motion, in gravity, in the springs of ground and limits.
    fn energy(&mut self, q: &[f64], v: &[f64]) -> (f64, f64) {
        let depths = self.heights(q).into_iter().map(|height| (-height).max(0.0));
        let ground: f64 = depths.map(|depth| 0.5 * GROUND * depth * depth).sum();
        let excess = self.figure.limit_excess(q).into_iter();
        let limits: f64 = excess.map(|excess| 0.5 * LIMITS * excess.by * excess.by).sum();
        let kinetic = kinetic_energy(&self.tree, &mut self.workspace, q, v).expect("finite");
        let potential = potential_energy(&self.tree, &mut self.workspace, q).expect("finite");
        (kinetic, kinetic + potential + ground + limits)
    }

    /// In a random pose within its limits, its lowest point 1 m above the ground.
    fn dropped(&mut self, seed: u64) -> Simulation {
        let gravity = Vector3::new(0.0, -G, 0.0);
        let mut simulation = Simulation::new(&self.figure, gravity);
        simulation.set_limits(LimitLaw::Spring { stiffness: LIMITS, damping: 0.0 }).expect("valid");
        let mut numbers = Numbers(seed);
        for _ in 0..10 {
            numbers.next();
        }
        let mut q = vec![0.0; self.figure.layout().nq()];
        self.figure.random(&mut q, || numbers.next()).expect("a valid source");
        q[..3].fill(0.0);
        q[1] = 1.0 - self.heights(&q).into_iter().fold(f64::INFINITY, f64::min);
        simulation.set_start(&q, &vec![0.0; self.figure.layout().nv()]).expect("valid");
        let mut plane = GroundPlane::under(&self.figure, &gravity, FRICTION.0).expect("gravity");
        plane.law =
            ContactLaw::Compliant { stiffness: GROUND, damping: ContactLaw::DAMPING, slip: FRICTION.1 };
        simulation.set_ground(plane, self.contact_points.clone()).expect("valid");
        simulation
    }
}

/// What a fall came to. Energies are parts of the energy at play.
struct Fall {
    seed: u64,
    /// Of motion, in the last frame.
    left: f64,
    /// The last time (s) at which a thousandth of the energy was in motion.
    rest: f64,
    /// The most that the mechanical energy of a frame is above that of an earlier one.
    grown: f64,
    /// The greatest difference between energy and heat on one side and the energy at the beginning on the other.
    imbalance: f64,
    /// The deepest that a link went into the ground (m), and which.
    depth: (f64, String),
    /// The farthest that a joint went out of its limits (rad), and which.
    excess: (f64, String),
}

impl Fall {
    fn of(seed: u64, meter: &mut Meter, run: &Run) -> Self {
        let (motion, energy) = (&run.motion, &run.report.energy);
        let frames: Vec<(f64, f64)> =
            (0..motion.len()).map(|frame| meter.energy(motion.q(frame), motion.v(frame))).collect();
        assert!(frames.iter().all(|(_, all)| all.is_finite()), "pose {seed}: no number");
        let mut least = f64::INFINITY;
        let grown = frames.iter().map(|(_, all)| {
            least = least.min(*all);
            all - least
        });
        let grown = grown.fold(0.0, f64::max) / energy.scale;
        let moving = frames.iter().rposition(|(kinetic, _)| *kinetic > 1e-3 * energy.scale);
        let deepest = run.report.ground.as_ref().and_then(|ground| ground.deepest()).expect("it touches");
        let all: Vec<f64> = (0..motion.len()).flat_map(|frame| motion.q(frame).iter().copied()).collect();
        let excess = meter.figure.limit_excess(&all).into_iter().max_by(|a, b| a.by.total_cmp(&b.by));
        let excess = excess.map_or((0.0, String::new()), |worst| {
            (worst.by, meter.figure.layout().v_names()[worst.dof].clone())
        });
        Self {
            seed,
            left: frames[frames.len() - 1].0 / energy.scale,
            rest: moving.map_or(0.0, |frame| motion.time()[frame]),
            grown,
            imbalance: energy.imbalance / energy.scale,
            depth: (deepest.depth, deepest.link.clone()),
            excess,
        }
    }

    fn tell(&self) {
        let Self { seed, left, rest, grown, imbalance, depth, excess } = self;
        eprintln!(
            "pose {seed}: rest at {rest:.2} s, {left:.0e} left, grown {grown:.1e}, imbalance {imbalance:.1e}, deepest {:.1} mm ({}), \
             out of limits {:.0}° ({})",
            1e3 * depth.0,
            depth.1,
            excess.0.to_degrees(),
            excess.1
        );
    }

    /// What steps of order one leave.
    fn check_impulses(&self, step: f64) {
        let Self { seed, grown, imbalance, depth, excess, .. } = self;
        assert!(*grown < 1e-3, "the energy of pose {seed} grows by {grown:e}");
        assert!(*imbalance < 2e-2, "pose {seed}: {imbalance:e} of the energy comes from nowhere");
        assert!(depth.0 < 0.01, "pose {seed} goes {} m deep ({})", depth.0, depth.1);
        // Toes with 5e-5 kg m² under a body: a limit is as stiff as a step allows for the inertia that it holds.
        assert!(excess.0 < 200.0 * step, "pose {seed} goes {} rad out of limits ({})", excess.0, excess.1);
    }

    /// Energy may be missing from the balance up to this part of it.
    fn check(&self, tolerance: f64) {
        let Self { seed, left, grown, imbalance, depth, .. } = self;
        assert!(*left < 1e-3, "pose {seed} does not come to rest: {left:e} of the energy is in motion");
        assert!(*grown < 1e-9, "the energy of pose {seed} grows by {grown:e}");
        assert!(*imbalance < tolerance, "pose {seed}: {imbalance:e} of the energy comes from nowhere");
        assert!(depth.0 < 0.05, "pose {seed} goes {} m deep ({})", depth.0, depth.1);
    }
}

/// Drops the person in these poses, on all cores.
fn falls(seeds: std::ops::Range<u64>, duration: f64, method: Method) -> Vec<Fall> {
    let settings = Settings { method, estimate: false, forces: false, ..Settings::new(duration, RATE) };
    let (next, done) = (AtomicU64::new(seeds.start), Mutex::new(Vec::new()));
    let one = || {
        let mut meter = Meter::new();
        loop {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            if seed >= seeds.end {
                return;
            }
            let mut simulation = meter.dropped(seed);
            if let Method::Impulses { .. } = method {
                simulation.set_limits(LimitLaw::Hard { restitution: 0.0 }).expect("valid");
                let (plane, points) = simulation.grounded().expect("a ground");
                let (plane, points) = (GroundPlane { law: ContactLaw::Rigid, ..*plane }, points.to_vec());
                simulation.set_ground(plane, points).expect("valid");
            }
            let run = simulation.run(&settings);
            let run = run.unwrap_or_else(|error| panic!("pose {seed}: {error}"));
            let fall = Fall::of(seed, &mut meter, &run);
            fall.tell();
            done.lock().expect("no panic while it was held").push(fall);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, std::num::NonZero::get) {
            scope.spawn(one);
        }
    });
    done.into_inner().expect("no panic while it was held")
}

/// Runge and Kutta's rule.
fn fixed(step: f64) -> Method {
    Method::Fixed { rule: Rule::RungeKutta4, step }
}

/// The step is too long for friction on the smallest links, which costs up to a hundredth of the balance: see the last test.
#[test]
fn limp_people_come_to_rest_and_gain_no_energy() {
    for fall in falls(8..10, 1.5, fixed(4e-5)) {
        fall.check(1e-2);
    }
}

#[test]
#[ignore = "takes minutes: cargo lab falls"]
fn fifty_limp_people_come_to_rest_and_gain_no_energy() {
    let falls = falls(0..50, 3.0, fixed(2e-5));
    let most = |of: fn(&Fall) -> f64| falls.iter().map(of).fold(0.0, f64::max);
    eprintln!(
        "worst of {}: rest at {:.2} s, {:.0e} left, grown {:.1e}, imbalance {:.1e}, {:.1} mm deep, {:.0}° out of limits",
        falls.len(),
        most(|fall| fall.rest),
        most(|fall| fall.left),
        most(|fall| fall.grown),
        most(|fall| fall.imbalance),
        1e3 * most(|fall| fall.depth.0),
        most(|fall| fall.excess.0).to_degrees()
    );
    assert_eq!(falls.len(), 50);
    for fall in &falls {
        fall.check(5e-3);
    }
}

/// What is missing from the balance goes away with the step: nothing is left of it once the step resolves friction on the smallest
/// links.
#[test]
#[ignore = "takes minutes: cargo lab falls"]
fn the_energy_of_a_fall_balances_as_the_step_falls() {
    let imbalance = |step: f64| falls(0..1, 1.0, fixed(step))[0].imbalance;
    let found = [4e-5, 2e-5, 1e-5, 5e-6].map(imbalance);
    eprintln!("imbalance at 40, 20, 10, 5 µs: {found:?}");
    assert!(found[0] < 2e-2 && found[3] < 1e-7, "{found:?}");
}

/// With hard limits on hard ground, in steps fifty times as long.
#[test]
fn limp_people_come_to_rest_by_impulses() {
    for fall in falls(0..3, 2.0, Method::Impulses { step: 1e-3 }) {
        assert!(fall.left < 1e-3, "pose {} does not come to rest", fall.seed);
        fall.check_impulses(1e-3);
    }
}

#[test]
#[ignore = "a chore: cargo lab falls"]
fn fifty_limp_people_come_to_rest_by_impulses() {
    for step in [1e-3, 5e-4] {
        let begun = std::time::Instant::now();
        let falls = falls(0..50, 3.0, Method::Impulses { step });
        let most = |of: fn(&Fall) -> f64| falls.iter().map(of).fold(0.0, f64::max);
        eprintln!(
            "worst of {} in steps of {step} s: {:.1} s, rest at {:.2} s, {:.0e} left, grown {:.1e}, imbalance {:.1e}, {:.1} mm deep, {:.1}° out \
             of limits",
            falls.len(),
            begun.elapsed().as_secs_f64(),
            most(|fall| fall.rest),
            most(|fall| fall.left),
            most(|fall| fall.grown),
            most(|fall| fall.imbalance),
            1e3 * most(|fall| fall.depth.0),
            most(|fall| fall.excess.0).to_degrees()
        );
        for fall in &falls {
            fall.check_impulses(step);
        }
        // One that lies propped up on its limbs may tip over late.
        let moving = falls.iter().filter(|fall| fall.left >= 1e-3).count();
        assert!(moving <= 1, "{moving} of {} do not come to rest", falls.len());
    }
}
