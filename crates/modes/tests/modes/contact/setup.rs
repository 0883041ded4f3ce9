//! What a ground asks for, and what is said of it.

use crate::contact::{G, at, fixed, floor, point, simulation};
use solaris_model::{Vector3, human};
use solaris_modes::{ContactLaw, ContactPoint, Drive, GroundPlane, SetupError, Simulation, contact_points};

#[test]
fn numbers_that_are_none_are_refused_by_name() {
    let figure = point();
    let law = |stiffness, damping, slip| ContactLaw::Compliant { stiffness, damping, slip };
    let good = floor(0.5, 1e4, 1.0, 1e-2);
    let planes = [
        ("friction", GroundPlane { friction: -0.1, ..good }),
        ("friction", GroundPlane { friction: f64::NAN, ..good }),
        ("place", GroundPlane { height: f64::INFINITY, ..good }),
        ("stiffness", GroundPlane { law: law(0.0, 1.0, 1e-2), ..good }),
        ("damping", GroundPlane { law: law(1e4, -1.0, 1e-2), ..good }),
        ("slip", GroundPlane { law: law(1e4, 1.0, 0.0), ..good }),
    ];
    for (what, plane) in planes {
        let error = Simulation::new(&figure, Vector3::zeros())
            .set_ground(plane, Vec::new())
            .expect_err("it is refused");
        assert!(matches!(&error, SetupError::Range { what: named, .. } if named.contains(what)), "{error}");
    }
    let contact_points = [
        ContactPoint { link: 1, center: Vector3::zeros(), radius: 0.0 },
        at(Vector3::new(0.0, f64::NAN, 0.0), 0.0),
        at(Vector3::zeros(), -1.0),
    ];
    for touch in contact_points {
        assert!(
            Simulation::new(&figure, Vector3::zeros()).set_ground(good, vec![touch]).is_err(),
            "{touch:?}"
        );
    }
}

#[test]
fn the_default_is_as_stiff_as_the_figure_is_heavy() {
    let figure = point();
    let plane = GroundPlane::under(&figure, &Vector3::new(0.0, -G, 0.0), 0.7).expect("gravity");
    let ContactLaw::Compliant { stiffness, .. } = plane.law else { panic!("a spring") };
    assert!(
        (stiffness - 2.0 * G / 2e-3).abs() < 1e-9
            && (plane.up.y - 1.0).abs() < 1e-15
            && (plane.friction - 0.7).abs() < 1e-15
    );
    assert_eq!(
        GroundPlane::under(&figure, &Vector3::zeros(), 0.7).expect_err("it is refused"),
        SetupError::NoGround
    );
}

/// What nothing moves by dynamics is not looked at; the plan says so.
#[test]
fn the_plan_says_which_touches_are_left_out() {
    let figure = human(1.75, 73.0).expect("within range");
    let gravity = Vector3::new(0.0, -G, 0.0);
    let mut simulation = Simulation::new(&figure, gravity);
    let plane = GroundPlane::under(&figure, &gravity, 0.8).expect("gravity");
    let all = contact_points(&figure);
    let of = |link: &str| {
        let link = figure.link_index(link);
        all.iter().filter(|touch| Some(touch.link) == link).count()
    };
    let loose = of("left_forearm") + of("left_hand");
    simulation.set_ground(GroundPlane { height: -1.1, ..plane }, all.clone()).expect("valid");
    for link in figure.links() {
        let drive = if link.name() == "left_forearm" { Drive::Free } else { Drive::Frozen };
        simulation.drive(link.joint().name(), [drive]).expect("a joint");
    }
    let run = simulation.run(&fixed(0.05, 100.0, 1e-3)).expect("runs");
    let told = format!("contact: {} of {} spheres", all.len() - loose, all.len());
    let omitted = &run.report.phases[0].omitted;
    assert!(omitted.iter().any(|text| text.starts_with(&told)), "{told}: {omitted:?}");
    assert!(!omitted.iter().any(|text| text.starts_with("velocities of links")), "{omitted:?}");
}

/// The same motion, whether what cannot matter is left out or not: a leg swings over the ground from a trunk that stands still,
/// and its foot drags.
#[test]
fn leaving_out_changes_no_contact() {
    let figure = human(1.75, 73.0).expect("within range");
    let gravity = Vector3::new(0.0, -G, 0.0);
    let mut simulation = Simulation::new(&figure, gravity);
    let plane = GroundPlane::under(&figure, &gravity, 0.8).expect("gravity");
    let softer = ContactLaw::Compliant { stiffness: 1e5, damping: 1.0, slip: 0.1 };
    simulation
        .set_ground(GroundPlane { height: -1.0135, law: softer, ..plane }, contact_points(&figure))
        .expect("valid");
    for link in figure.links() {
        let drive = if link.name() == "left_thigh" { Drive::Free } else { Drive::Frozen };
        simulation.drive(link.joint().name(), [drive]).expect("a joint");
    }
    let (mut q, mut v) = (simulation.state().0.to_vec(), simulation.state().1.to_vec());
    let hip = figure.layout().dof_index("left_hip.rx").expect("a dof");
    (q[hip], v[hip]) = (0.2, -1.0);
    simulation.set_start(&q, &v).expect("valid");
    let settings = fixed(0.3, 100.0, 5e-5);
    let mut whole = settings.clone();
    whole.leave_out = false;
    let [one, other] = [settings, whole].map(|settings| simulation.run(&settings).expect("runs"));
    assert!(one.motion.contact("left_foot").is_some());
    let last = one.motion.len() - 1;
    for (a, b) in one.motion.q(last).iter().zip(other.motion.q(last)) {
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
    let [one, other] = [one, other].map(|run| run.report.ground.expect("a ground"));
    assert!((one.friction - other.friction).abs() < 1e-6 && one.friction > 1e-2, "{one:?}");
}

/// Without anything that touches, a ground changes nothing.
#[test]
fn a_ground_far_below_changes_nothing() {
    let mut with = simulation(&point(), G, floor(0.5, 1e4, 1.0, 1e-2), vec![at(Vector3::zeros(), 0.0)]);
    with.set_start(&[0.0, 100.0], &[1.0, 0.0]).expect("valid");
    let mut without = Simulation::new(&point(), Vector3::new(0.0, -G, 0.0));
    without.set_start(&[0.0, 100.0], &[1.0, 0.0]).expect("valid");
    let [with, without] =
        [with, without].map(|simulation| simulation.run(&fixed(1.0, 100.0, 1e-2)).expect("runs"));
    for frame in 0..with.motion.len() {
        assert_eq!(with.motion.q(frame), without.motion.q(frame));
    }
    assert!(with.motion.contacts.is_empty() && with.motion.events.is_empty());
    assert!(with.report.ground.expect("a ground").links.is_empty() && without.report.ground.is_none());
}
