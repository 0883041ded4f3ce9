//! Sliding, sticking and rolling, beside closed forms.

use crate::contact::{G, at, fixed, floor, point, simulation};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::Unit;
use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{GroundPlane, Settings};

const STIFFNESS: f64 = 1e4;

/// How deep 2 kg rest.
const REST: f64 = 2.0 * G / STIFFNESS;

/// Friction is smooth, and so is the way: with `v̇ = −μ·g·v/√(v² + v_s²)`,
///
/// ```text
/// x = (v₀·√(v₀² + v_s²) + v_s²·asinh(v₀/v_s)) / (2·μ·g)      v = √(w² − v_s²) with w − v_s·… ≈ v₀ − μ·g·t while v ≫ v_s
/// ```
///
/// by hand `v₀²/(2·μ·g)` after `v₀/(μ·g)`.
#[test]
fn a_block_slides_to_rest_where_friction_says() {
    let (speed, friction, slip) = (2.0_f64, 0.4, 1e-2);
    let mut simulation =
        simulation(&point(), G, floor(friction, STIFFNESS, 1.0, slip), vec![at(Vector3::zeros(), 0.0)]);
    simulation.set_start(&[0.0, -REST], &[speed, 0.0]).expect("valid");
    let run = simulation.run(&Settings::new(1.0, 1000.0)).expect("runs");
    let (motion, ground) = (&run.motion, run.report.ground.expect("a ground"));
    let deceleration = friction * G;
    let way = (speed * speed.hypot(slip) + slip * slip * (speed / slip).asinh()) / (2.0 * deceleration);
    let last = motion.len() - 1;
    assert_abs_diff_eq!(motion.q(last)[0], way, epsilon = 2e-6);
    assert_relative_eq!(way, speed * speed / (2.0 * deceleration), max_relative = 1e-3);
    // At 0.1 m/s it is where constant friction has it, but for its softness.
    let stop = speed / deceleration;
    let slow = motion.time().iter().position(|t| *t >= stop - 0.1 / deceleration).expect("a frame");
    assert_abs_diff_eq!(motion.v(slow)[0], 0.1, epsilon = 5e-3);
    assert_relative_eq!(ground.friction, speed * speed, max_relative = 1e-5);
    assert_abs_diff_eq!(ground.damping, 0.0, epsilon = 1e-9);
    assert_relative_eq!(ground.impulse[0], -2.0 * speed, max_relative = 1e-5);
    assert_relative_eq!(ground.impulse[1], 2.0 * G, max_relative = 1e-9);
    let told = ground.farthest().expect("the point");
    assert_relative_eq!(told.slid, way, max_relative = 1e-5);
    assert_relative_eq!(told.slip, speed, max_relative = 1e-12);
    assert_relative_eq!(told.depth, REST, max_relative = 1e-9);
    assert_relative_eq!(told.touching, 1.0, max_relative = 1e-12);
    // Contacts and forces of the frames: nothing is left for drives that are none.
    let contact = motion.contact("point").expect("it touches").samples[100];
    assert_relative_eq!(contact.force, Vector3::new(-2.0 * deceleration, 2.0 * G, 0.0), epsilon = 1e-3);
    assert_relative_eq!(contact.cop, Vector3::new(motion.q(100)[0], 0.0, 0.0), epsilon = 1e-3);
    let left = (0..motion.len()).flat_map(|frame| motion.tau(frame).expect("forces").iter());
    assert!(left.fold(0.0_f64, |most, tau| most.max(tau.abs())) < 1e-9);
    assert_eq!(motion.info.ground.expect("a floor").friction, Some(friction));
}

/// A slope that it ought to stick on: it creeps with `v_s·s/√(1 − s²)` where the pull is the part `s` of the friction there is.
#[test]
fn what_sticks_creeps_as_slowly_as_is_told() {
    let (angle, friction, slip) = (20_f64.to_radians(), 0.8, 1e-3);
    let up = Unit::new_normalize(Vector3::new(-angle.sin(), angle.cos(), 0.0));
    let plane = GroundPlane { up, ..floor(friction, STIFFNESS, 1.0, slip) };
    let mut simulation = simulation(&point(), G, plane, vec![at(Vector3::zeros(), 0.0)]);
    // As deep as the part of its weight that presses on the slope makes it.
    let sunk = up.into_inner() * (-REST * angle.cos());
    simulation.set_start(&[sunk.x, sunk.y], &[0.0, 0.0]).expect("valid");
    let run = simulation.run(&fixed(0.5, 100.0, 1e-4)).expect("runs");
    let v = run.motion.v(50);
    let share = angle.tan() / friction;
    assert_relative_eq!(v[0].hypot(v[1]), slip * share / (1.0 - share * share).sqrt(), max_relative = 1e-6);
    assert!(v[0] < 0.0 && v[1] < 0.0, "downhill: {v:?}");
    assert!(run.motion.info.ground.is_none(), "a slope is no level ground");
}

/// A solid ball slides until it rolls: its momentum about a point of the ground stays, `v + ⅖·r·ω = v₀`.
#[test]
fn a_ball_slides_until_it_rolls() {
    let (radius, speed, friction) = (0.1, 2.0, 0.3);
    let inertia = 0.4 * 2.0 * radius * radius;
    let ball = LinkSpec::root("ball", Joint::new("root").tx().ty().rz()).mass(2.0);
    let ball = ball.inertia(Inertia::diagonal(inertia, inertia, inertia));
    let figure = FigureBuilder::new("ball").link(ball).build().expect("valid");
    let contact_points = vec![at(Vector3::zeros(), radius)];
    let mut simulation = simulation(&figure, G, floor(friction, STIFFNESS, 1.0, 1e-3), contact_points);
    simulation.set_start(&[0.0, radius - REST, 0.0], &[speed, 0.0, 0.0]).expect("valid");
    let run = simulation.run(&Settings::new(1.0, 1000.0)).expect("runs");
    let motion = &run.motion;
    let rolls = 2.0 * speed / (7.0 * friction * G);
    for frame in 0..motion.len() {
        let (v, t) = (motion.v(frame), motion.time()[frame]);
        assert_abs_diff_eq!(v[0] - 0.4 * radius * v[2], speed, epsilon = 1e-8);
        let expected = if t < rolls { speed - friction * G * t } else { 5.0 / 7.0 * speed };
        // It is soft where sliding ends, over a few v_s.
        assert_abs_diff_eq!(v[0], expected, epsilon = if (t - rolls).abs() < 0.01 { 3e-3 } else { 1e-4 });
    }
    let last = motion.v(motion.len() - 1);
    assert_relative_eq!(last[0], 5.0 / 7.0 * speed, max_relative = 1e-6);
    assert_relative_eq!(last[2], -last[0] / radius, max_relative = 1e-6);
    // 2/7 of the energy of sliding is lost.
    let lost = run.report.ground.expect("a ground").friction;
    assert_relative_eq!(lost, 2.0 / 7.0 * speed * speed, max_relative = 1e-5);
}
