//! What a simulation leaves out, and that nobody sees it in the result.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use solaris_dynamics::scalar::Operations;
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Motion, human};
use solaris_modes::{
    Anchor, Drive, LimitLaw, Method, PhaseReport, PointSpring, Rule, Run, Settings, Shape, Simulation,
};

fn ann() -> Figure {
    human(1.65, 58.0).expect("a valid human")
}

/// Floating, its joints without limits.
fn floating(figure: &Figure) -> Simulation {
    let mut simulation = Simulation::new(figure, Vector3::zeros());
    simulation.set_limits(LimitLaw::Ignore).expect("no numbers");
    simulation
}

fn joints(figure: &Figure) -> Vec<String> {
    figure.links().iter().map(|link| link.joint().name().to_owned()).collect()
}

fn drive_all(simulation: &mut Simulation, drive: &Drive, loose: &[&str]) {
    for joint in joints(&simulation.figure().clone()) {
        let drive = if loose.contains(&joint.as_str()) { Drive::Free } else { drive.clone() };
        simulation.drive(&joint, [drive]).expect("a joint of the human");
    }
}

const ARM: [&str; 3] = ["left_shoulder", "left_elbow", "left_wrist"];
const LEG: [&str; 4] = ["left_hip", "left_knee", "left_ankle", "left_toes"];

fn swaying() -> Drive {
    Drive::Move { to: 0.2, over: 0.5, along: Shape::MinimumJerk }
}

fn settings(duration: f64, leave_out: bool) -> Settings {
    let method = Method::Fixed { rule: Rule::RungeKutta4, step: 1.0 / 240.0 };
    Settings { method, estimate: false, forces: false, leave_out, ..Settings::new(duration, 60.0) }
}

/// With and without leaving out what nothing depends on.
fn runs(simulation: &Simulation, duration: f64) -> [Run; 2] {
    [true, false].map(|leave_out| simulation.run(&settings(duration, leave_out)).expect("no trouble"))
}

/// The greatest difference of a coordinate.
fn difference(a: &Motion, b: &Motion) -> f64 {
    assert_eq!(a.len(), b.len());
    let frames = (0..a.len()).flat_map(|i| a.q(i).iter().zip(b.q(i)));
    frames.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// What was left out, for people.
fn plan(report: &PhaseReport) -> String {
    let PhaseReport { dynamic, prescribed, fused, dropped, omitted, .. } = report;
    let count = |operations: &Operations| {
        let (times, plus) = (operations.multiplications, operations.additions);
        format!("{times} products, {plus} sums")
    };
    format!(
        "dynamic: {dynamic:?}\nprescribed: {prescribed:?}\nfused: {fused:?}\ndropped: {dropped:?}\nwhole: {}\nleft: {}\n{}",
        count(&report.operations_of_all),
        count(&report.operations),
        omitted.join("\n"),
    )
}

#[test]
fn a_loose_arm_on_a_moving_body() {
    let mut simulation = floating(&ann());
    drive_all(&mut simulation, &swaying(), &ARM);
    let [left, whole] = runs(&simulation, 0.5);
    assert!(difference(&left.motion, &whole.motion) < 1e-11);
    let elbow = simulation.figure().layout().dof_index("left_elbow.rx").expect("a dof");
    let last = left.motion.len() - 1;
    assert!(left.motion.q(last)[elbow].abs() > 1e-3, "the arm has to move");
    assert!(whole.report.phases[0].dropped.is_empty());
    insta::assert_snapshot!(plan(&left.report.phases[0]));
}

#[test]
fn a_leg_on_a_frozen_body() {
    let mut simulation = Simulation::new(&ann(), Vector3::new(0.0, -9.81, 0.0));
    simulation.set_limits(LimitLaw::Ignore).expect("no numbers");
    drive_all(&mut simulation, &Drive::Frozen, &LEG);
    let (mut q, v) = (simulation.state().0.to_vec(), simulation.state().1.to_vec());
    for dof in ["left_hip.rx", "left_knee.rx", "right_knee.rx"] {
        q[simulation.figure().layout().dof_index(dof).expect("a dof")] = 0.3;
    }
    simulation.set_start(&q, &v).expect("valid");
    let [left, whole] = runs(&simulation, 0.2);
    assert!(difference(&left.motion, &whole.motion) < 1e-10);
    insta::assert_snapshot!(plan(&left.report.phases[0]));
}

#[test]
fn curves_alone_need_no_dynamics() {
    let mut simulation = floating(&ann());
    drive_all(&mut simulation, &swaying(), &[]);
    let [left, whole] = runs(&simulation, 0.5);
    assert_eq!(left.report.phases[0].operations, Operations::default());
    assert!(difference(&left.motion, &whole.motion) < 1e-15);
    insta::assert_snapshot!(plan(&left.report.phases[0]));
}

/// A cart on a rail with a pendulum; a second cart, prescribed, pulls at the pendulum by a spring.
#[test]
fn a_prescribed_link_that_pulls_by_a_spring_stays() {
    let bob = |name: &str, on: &str| {
        LinkSpec::child(name, on, Joint::new(format!("{name} hinge")).rz())
            .mass(1.0)
            .com(Vector3::new(0.0, -0.5, 0.0))
    };
    let slide = |name: &str| Joint::new(format!("{name} slide")).tx();
    let figure = FigureBuilder::new("carts")
        .link(LinkSpec::root("rail", Joint::new("weld")).mass(1.0))
        .link(LinkSpec::child("cart", "rail", slide("cart")).mass(2.0))
        .link(bob("bob", "cart"))
        .link(LinkSpec::child("tug", "rail", slide("tug")).mass(2.0))
        .link(bob("ornament", "tug"))
        .build()
        .expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let anchor = |link: &str| Anchor { link: figure.link_index(link), point: Vector3::new(0.0, -0.5, 0.0) };
    let spring =
        PointSpring { between: [anchor("bob"), anchor("tug")], stiffness: 30.0, damping: 1.0, rest: 0.2 };
    simulation.add_spring(spring).expect("valid");
    simulation.drive("cart slide", [Drive::Frozen]).expect("valid");
    for name in ["tug slide", "ornament hinge"] {
        simulation.drive(name, [Drive::Move { to: 0.7, over: 0.4, along: Shape::Cubic }]).expect("valid");
    }
    let [left, whole] = runs(&simulation, 0.5);
    assert!(difference(&left.motion, &whole.motion) < 1e-12);
    let report = &left.report.phases[0];
    assert_eq!(
        (&report.dynamic[..], &report.prescribed[..]),
        (&["bob hinge.rz".to_owned()][..], &["tug slide.tx".to_owned()][..])
    );
    assert_eq!(
        (&report.fused[..], &report.dropped[..]),
        (&["cart slide.tx".to_owned()][..], &["ornament".to_owned()][..])
    );
    // The tug has pulled: without it the bob hangs still.
    let hinge = figure.layout().dof_index("bob hinge").expect("a dof");
    assert!(left.motion.q(left.motion.len() - 1)[hinge] > 0.05);
    assert_relative_eq!(left.report.phases[0].start, 0.0);
}
