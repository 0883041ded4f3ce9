//! Rigid ground where nobody names a method: an answer whatever touches, and however it is moved.

use crate::contact::G;
use solaris_model::{
    Figure, FigureBuilder, Human, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind, Vector3,
};
use solaris_modes::{
    ContactLaw, Drive, GroundPlane, Method, Remark, Run, RunReport, Settings, Simulation, contact_points,
};

/// Figures that are dropped.
const FIGURES: u64 = 24;

/// Numbers in a range, the same ones for the same seed.
struct Numbers(u64);

impl Numbers {
    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        least + (most - least) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn below(&mut self, n: u64) -> u64 {
        self.between(0.0, n as f64) as u64
    }
}

/// On rigid ground that is level.
fn over_ground(figure: &Figure, friction: f64) -> Simulation {
    let gravity = Vector3::new(0.0, -G, 0.0);
    let mut simulation = Simulation::new(figure, gravity);
    let plane = GroundPlane::under(figure, &gravity, friction).expect("gravity");
    let plane = GroundPlane { law: ContactLaw::Rigid, ..plane };
    simulation.set_ground(plane, contact_points(figure)).expect("valid");
    simulation
}

/// A tree of up to six boxes and capsules, dropped with any posture and any velocity.
fn dropped(random: &mut Numbers) -> Simulation {
    let mut builder = FigureBuilder::new("heap");
    for i in 0..2 + random.below(5) {
        let mass = 10_f64.powf(random.between(-1.5, 1.0));
        let length = random.between(0.1, 0.5);
        let round = ShapeKind::Capsule { radius: 0.1 * length, length };
        let kind = if random.below(2) == 0 {
            round
        } else {
            ShapeKind::Box { size: Vector3::new(0.1, length, 0.06) }
        };
        let shape = Shape { kind, placement: Placement::translation(0.0, -0.5 * length, 0.0) };
        let spec = if i == 0 {
            LinkSpec::root("l0", Joint::free("root"))
        } else {
            let joint = Joint::new(format!("j{i}")).at(Vector3::new(0.0, -0.1, 0.0));
            let joint = if random.below(2) == 0 { joint.rx() } else { joint.rz().rx() };
            LinkSpec::child(format!("l{i}"), format!("l{}", random.below(i)), joint)
        };
        let spec = spec.mass(mass).com(Vector3::new(0.0, -0.5 * length, 0.0));
        builder = builder.link(spec.inertia(Inertia::Uniform(shape)).shape(shape));
    }
    let figure = builder.build().expect("valid");
    let mut simulation = over_ground(&figure, random.between(0.1, 1.2));
    let (mut q, mut v) = (simulation.state().0.to_vec(), simulation.state().1.to_vec());
    q[1] = random.between(0.6, 1.5);
    for q in &mut q[7..] {
        *q = random.between(-1.0, 1.0);
    }
    for v in &mut v {
        *v = random.between(-1.0, 1.0);
    }
    simulation.set_start(&q, &v).expect("valid");
    simulation
}

fn without_a_method(simulation: &Simulation, duration: f64) -> Run {
    simulation.run(&Settings::new(duration, 60.0)).unwrap_or_else(|error| panic!("never refused: {error}"))
}

fn is_by_impulses(report: &RunReport) -> bool {
    report.remarks.iter().any(|remark| matches!(remark, Remark::ImpulsesInstead { .. }))
}

/// The part of the energy at play that came from nowhere or is gone.
fn imbalance(report: &RunReport) -> f64 {
    report.energy.imbalance / report.energy.scale
}

#[test]
fn whatever_is_dropped_lands() {
    let mut by_impulses = 0;
    for seed in 0..FIGURES {
        let simulation = dropped(&mut Numbers(seed));
        let Run { motion, report } = without_a_method(&simulation, 1.5);
        by_impulses += u64::from(is_by_impulses(&report));
        assert!(imbalance(&report) < 0.05, "{seed}: {} {report:?}", imbalance(&report));
        let ground = report.ground.expect("a ground");
        let deepest = ground.deepest().expect("it has come down").depth;
        assert!(motion.len() == 91 && deepest < 1e-3, "{seed}: {deepest}");
    }
    // By forces all the others, to a millionth.
    assert!((FIGURES / 4..FIGURES).contains(&by_impulses), "{by_impulses} of {FIGURES} by impulses");
}

/// A person's hips turn while her feet stand, as far apart as they are: they are dragged over the ground.
fn dragging() -> Simulation {
    let figure = Human::new(1.75, 73.0).build().expect("within range");
    let mut simulation = over_ground(&figure, 0.8);
    simulation.stand().expect("it has soles");
    for name in figure.layout().v_names().to_vec() {
        let to = match name.as_str() {
            "left_hip.rx" => Some(-20.0_f64),
            "right_hip.rz" => Some(-15.0),
            _ => None,
        };
        let drive = match to {
            Some(to) => {
                Drive::Move { to: to.to_radians(), over: 1.0, along: solaris_modes::Shape::default() }
            }
            None if name.starts_with("root") => Drive::Free,
            None => Drive::Frozen,
        };
        simulation.drive(&name, [drive]).expect("valid");
    }
    simulation
}

#[test]
fn limp_people_and_feet_that_are_dragged_come_to_an_end() {
    let limp = Human::new(1.75, 73.0).limp().build().expect("within range");
    let mut falling = over_ground(&limp, 0.8);
    falling.stand().expect("it has soles");
    for simulation in [falling, dragging()] {
        let run = without_a_method(&simulation, 1.0);
        assert!(is_by_impulses(&run.report), "{:?}", run.report);
        assert!(imbalance(&run.report) < 0.01, "{} {:?}", imbalance(&run.report), run.report);
    }
}

/// Friction of one foot presses the other down, by more than its own bound: bounds that went to and fro gave or took several joules a step,
/// and the runs of a millisecond and of a fifth of one ended in the guard of the energy.
#[test]
fn legs_that_are_wedged_make_no_energy() {
    for step in [2e-3, 1e-3, 5e-4, 2e-4] {
        let settings = Settings { method: Method::Impulses { step }, ..Settings::new(1.0, 60.0) };
        let report = dragging().run(&settings).expect("never refused").report;
        assert!(report.energy.imbalance < 300.0 * step, "{step}: {:?}", report.energy);
    }
}
