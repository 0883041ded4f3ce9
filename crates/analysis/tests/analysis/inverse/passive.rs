//! Springs, dampers, friction and armature.

use crate::inverse::support::{GRAVITY, body, build, equally, pendulum, positions};
use crate::states::{States, complete, inverse_motion};
use solaris_analysis::InverseOptions;
use solaris_dynamics::add_passive_forces;
use solaris_model::{Curve, Figure, Joint, LinkSpec, Passive, UnitQuaternion, Vector3};

const ACTS: Passive = Passive { stiffness: 20.0, rest: 0.3, damping: 1.5, friction: 0.7 };

fn forces(figure: &Figure, motion: &States, passive: bool) -> Vec<f64> {
    let options = InverseOptions { passive, progress: None };
    inverse_motion(figure, GRAVITY, motion, &[], options).expect("finite").tau
}

#[test]
fn a_hinge_needs_its_spring_its_damper_its_friction_and_its_rotor() {
    let bob = |joint| build([LinkSpec::root("bob", joint).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0))]);
    let figure = bob(Joint::new("pivot").rx().armature(0.25).passive(ACTS));
    let record = positions(&figure, equally(40, 50.0), |t| vec![(3.0 * t).sin()]);
    let motion = complete(&figure, &record, None).expect("a record");
    let (with, without) = (forces(&figure, &motion, true), forces(&figure, &motion, false));
    let bare = forces(&bob(Joint::new("pivot").rx()), &motion, true);
    for row in 0..40 {
        let (q, v, a) = (motion.q[row], motion.v[row], motion.a[row]);
        let acts = 20.0 * (q - 0.3) + 1.5 * v + 0.7 * v.signum() + 0.25 * a;
        assert!((with[row] - bare[row] - acts).abs() < 1e-12, "row {row}");
        assert!((without[row] - bare[row]).abs() < 1e-13, "row {row}");
    }
}

#[test]
fn nothing_slides_at_rest() {
    let figure = build([LinkSpec::root("bob", Joint::new("pivot").rx().passive(ACTS)).mass(1.0)]);
    for (v, expected) in [(0.0, 0.0), (-0.0, 0.0), (1e-300, 0.7), (-2.0, -0.7 - 3.0)] {
        let mut tau = [0.0];
        add_passive_forces(&figure, &[0.3], &[v], &mut tau);
        assert!((tau[0] - expected).abs() < 1e-15, "{v}: {}", tau[0]);
    }
}

/// The spring of a ball joint is the gradient of `k·θ²/2`; either sign of the quaternion is the same place.
#[test]
fn a_balls_spring_pulls_along_the_rotation_vector() {
    let acts = Passive { stiffness: 20.0, rest: 0.0, damping: 1.5, friction: 0.7 };
    let figure = build([body(LinkSpec::root("ball", Joint::ball("j").passive(acts)))]);
    let turn = Vector3::new(0.4, -1.1, 0.7);
    let q = UnitQuaternion::new(turn).coords;
    let v = [1.0, -2.0, 0.0];
    for q in [q, -q] {
        let mut tau = [0.0; 3];
        add_passive_forces(&figure, q.as_slice(), &v, &mut tau);
        for (i, friction) in [0.7, -0.7, 0.0].into_iter().enumerate() {
            assert!((tau[i] - 20.0 * turn[i] - 1.5 * v[i] - friction).abs() < 1e-13);
        }
    }
    // Power against the spring is the rate of its potential.
    let (h, mut tau) = (1e-6, [0.0; 3]);
    let spring = build([body(LinkSpec::root(
        "ball",
        Joint::ball("j").passive(Passive { damping: 0.0, friction: 0.0, ..acts }),
    ))]);
    add_passive_forces(&spring, q.as_slice(), &v, &mut tau);
    let potential = |t: f64| {
        let turned = UnitQuaternion::new(turn) * UnitQuaternion::new(Vector3::from(v) * t);
        10.0 * turned.angle() * turned.angle()
    };
    let power: f64 = tau.iter().zip(v).map(|(tau, v)| tau * v).sum();
    assert!((power - (potential(h) - potential(-h)) / (2.0 * h)).abs() < 1e-7);
    let mut none = [0.0; 3];
    add_passive_forces(&spring, &[0.0, 0.0, 0.0, 1.0], &[0.0; 3], &mut none);
    assert_eq!(none.map(f64::to_bits), [0; 3]);
}

/// A spring on a follower is felt by its leader, times the slope: as a potential of the leader's coordinate.
#[test]
fn a_followers_spring_and_weight_are_felt_by_its_leader() {
    let curve = Curve::Polynomial(vec![0.1, 0.5, -0.3]);
    let spring = Passive { stiffness: 50.0, rest: 0.0, ..Passive::default() };
    let slide = Joint::new("knee").ty().named("slide").following("angle", curve.clone()).passive(spring);
    let figure = build([
        LinkSpec::root("thigh", Joint::new("hip").rx()).mass(1.0),
        LinkSpec::child("shank", "thigh", slide.rx().named("angle")).mass(2.0),
    ]);
    let mut q = vec![0.0, 0.0, 0.4];
    let (mut v, mut a) = (vec![0.0; 3], vec![0.0; 3]);
    figure.follow(&mut q, &mut v, &mut a);
    let motion = States { time: vec![0.0], q, v, a, ..States::default() };
    let tau = forces(&figure, &motion, true);
    let [y, slope, _] = curve.at(0.4);
    assert_eq!(tau[1].to_bits(), 0);
    assert!((tau[2] - slope * (50.0 * y + 2.0 * 9.80665)).abs() < 1e-12, "{tau:?}");
    assert!(pendulum().followers().is_empty());
}
