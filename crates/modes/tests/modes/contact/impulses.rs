//! Steps by impulses: closed forms, and that nothing is ever refused.

use crate::contact::planted::{forces, ground};
use crate::contact::{G, at, simulation};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::Unit;
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, ShapeKind, Vector3};
use solaris_modes::{Drive, GroundPlane, LimitLaw, Method, Run, Settings, Simulation, contact_points};

fn settings(duration: f64, rate: f64, step: f64) -> Settings {
    Settings { method: Method::Impulses { step }, estimate: false, ..Settings::new(duration, rate) }
}

fn block(size: Vector3<f64>, mass: f64) -> Figure {
    let shape = solaris_model::Shape { kind: ShapeKind::Box { size }, placement: Placement::identity() };
    let link = LinkSpec::root("box", Joint::free("root")).mass(mass);
    let link = link.inertia(Inertia::Uniform(shape)).shape(shape);
    FigureBuilder::new("box").link(link).build().expect("valid")
}

/// What a box of 3 kg does on a slope: how far it has gone down it after a second from rest.
fn on_a_slope(angle: f64, friction: f64, step: f64) -> Run {
    let figure = block(Vector3::new(0.4, 0.2, 0.3), 3.0);
    let up = Unit::new_normalize(Vector3::new(angle.sin(), angle.cos(), 0.0));
    let plane = GroundPlane { up, ..ground(friction) };
    let mut simulation = simulation(&figure, G, plane, contact_points(&figure));
    let (sin, cos) = (0.5 * angle).sin_cos();
    let height = up.into_inner() * 0.1;
    simulation.set_start(&[height.x, height.y, 0.0, 0.0, 0.0, -sin, cos], &[0.0; 6]).expect("valid");
    simulation.run(&settings(1.0, 100.0, step)).expect("never refused")
}

#[test]
fn a_block_stays_below_its_angle_of_friction_and_slides_above_it() {
    for friction in [0.2_f64, 0.5, 1.0] {
        let edge = friction.atan();
        let down = |run: &Run, angle: f64| {
            let q = run.motion.q(100);
            (q[0] - run.motion.q(0)[0]) * angle.cos() - (q[1] - run.motion.q(0)[1]) * angle.sin()
        };
        let below = 0.98 * edge;
        let creep = down(&on_a_slope(below, friction, 1e-3), below);
        assert!((0.0..1e-5).contains(&creep), "{creep:e}");
        let above = 1.02 * edge;
        let errors = [2e-3, 1e-3].map(|step| {
            let expected = 0.5 * G * (above.sin() - friction * above.cos());
            (down(&on_a_slope(above, friction, step), above) - expected).abs() / expected
        });
        // Of order one.
        assert!(errors[1] < 0.05 && errors[1] < 0.7 * errors[0], "{friction}: {errors:?}");
    }
}

#[test]
fn a_box_that_falls_flat_stays_and_presses_with_its_weight() {
    for mass in [1e-6, 3.0, 1e6] {
        let figure = block(Vector3::new(0.4, 0.2, 0.3), mass);
        let mut simulation = simulation(&figure, G, ground(0.5), contact_points(&figure));
        simulation.set_start(&[0.0, 0.6, 0.0, 0.0, 0.0, 0.0, 1.0], &[0.0; 6]).expect("valid");
        let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("never refused");
        let last = run.motion.len() - 1;
        assert_abs_diff_eq!(run.motion.q(last)[1], 0.1, epsilon = 1e-6);
        assert!(run.motion.v(last).iter().all(|v| v.abs() < 1e-6));
        let force = forces(&run.motion, "box")[last];
        assert_relative_eq!(force.y, mass * G, max_relative = 1e-6);
        // What was lost is accounted for, but for what a step of falling leaves out.
        let energy = &run.report.energy;
        assert!(energy.imbalance < 5e-3 * energy.scale, "{energy:?}");
        let ground = run.report.ground.as_ref().expect("a ground");
        assert_relative_eq!(ground.impulse[1], mass * G, max_relative = 1e-3);
        assert_relative_eq!(ground.damping, mass * G * 0.5, max_relative = 2e-2);
    }
}

/// `v + ⅖·r·ω = v₀` about a point of the ground, until it rolls with 5/7 of its speed.
#[test]
fn a_ball_slides_until_it_rolls_and_rolls_on() {
    let (radius, speed, friction) = (0.1, 2.0, 0.3);
    let inertia = 0.4 * 2.0 * radius * radius;
    let ball = LinkSpec::root("ball", Joint::new("root").tx().ty().rz()).mass(2.0);
    let ball = ball.inertia(Inertia::diagonal(inertia, inertia, inertia));
    let figure = FigureBuilder::new("ball").link(ball).build().expect("valid");
    let mut simulation = simulation(&figure, G, ground(friction), vec![at(Vector3::zeros(), radius)]);
    simulation.set_start(&[0.0, radius, 0.0], &[speed, 0.0, 0.0]).expect("valid");
    let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("never refused");
    let rolls = 2.0 * speed / (7.0 * friction * G);
    for frame in 0..run.motion.len() {
        let (v, t) = (run.motion.v(frame), run.motion.time()[frame]);
        assert_abs_diff_eq!(v[0] - 0.4 * radius * v[2], speed, epsilon = 1e-9);
        let expected = if t < rolls { speed - friction * G * t } else { 5.0 / 7.0 * speed };
        // Sliding begins a little above the ground, by μ·v·h.
        assert_abs_diff_eq!(v[0], expected, epsilon = 0.01);
    }
    assert_relative_eq!(run.motion.v(100)[0], 5.0 / 7.0 * speed, max_relative = 1e-3);
}

/// A rod that hangs on nothing falls into its limit and stays there; its limit bears what it has to.
#[test]
fn limits_hold_without_a_ground_and_without_events() {
    let hinge = Joint::new("hinge").rx().limited(-0.5, 2.0);
    let rod = LinkSpec::root("rod", hinge).mass(2.0).com(Vector3::new(0.0, 0.0, 0.5));
    let figure = FigureBuilder::new("rod").link(rod).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, G, 0.0));
    simulation.set_start(&[0.5], &[0.0]).expect("valid");
    simulation.set_limits(LimitLaw::Hard { restitution: 0.0 }).expect("valid");
    let run = simulation.run(&settings(2.0, 100.0, 1e-3)).expect("never refused");
    assert_abs_diff_eq!(run.motion.q(200)[0], -0.5, epsilon = 1e-6);
    assert!(run.report.impacts.is_empty());
    assert!(run.report.energy.imbalance < 5e-3 * run.report.energy.scale, "{:?}", run.report.energy);
}

#[test]
fn what_moves_as_prescribed_pushes_and_bears() {
    // A plate that is driven up at 0.5 m/s under a block cannot be: the ground does not move. A leg that is stretched lifts a body.
    let leg = Joint::new("leg").ty().at(Vector3::new(0.0, -0.5, 0.0));
    let body = LinkSpec::root("body", Joint::new("slide").ty()).mass(10.0);
    let figure = FigureBuilder::new("pogo").link(body).link(LinkSpec::child("foot", "body", leg).mass(1.0));
    let figure = figure.build().expect("valid");
    let foot = solaris_modes::ContactPoint { link: 1, center: Vector3::zeros(), radius: 0.0 };
    let mut simulation = simulation(&figure, G, ground(0.5), vec![foot]);
    simulation.set_start(&[0.5, 0.0], &[0.0; 2]).expect("valid");
    let along = solaris_modes::Shape::MinimumJerk;
    simulation.drive("leg", [Drive::Move { to: -0.3, over: 1.0, along }]).expect("valid");
    let run = simulation.run(&settings(1.5, 100.0, 1e-3)).expect("never refused");
    assert_abs_diff_eq!(run.motion.q(150)[0], 0.8, epsilon = 1e-5);
    // The leg has lifted 10 kg by 0.3 m.
    assert_relative_eq!(run.report.energy.work, 10.0 * G * 0.3, max_relative = 5e-3);
    let tau = run.motion.tau(150).expect("asked for");
    assert_relative_eq!(tau[1], -10.0 * G, max_relative = 1e-6);
}

/// What begins 2 cm in the ground is brought out at 0.1 m/s, and not thrown.
#[test]
fn what_begins_too_deep_comes_out_slowly() {
    let figure = block(Vector3::new(0.4, 0.2, 0.3), 3.0);
    let mut simulation = simulation(&figure, G, ground(0.5), contact_points(&figure));
    simulation.set_start(&[0.0, 0.08, 0.0, 0.0, 0.0, 0.0, 1.0], &[0.0; 6]).expect("valid");
    let run = simulation.run(&settings(0.5, 100.0, 1e-3)).expect("never refused");
    let fastest = (0..run.motion.len()).map(|frame| run.motion.v(frame)[1].abs()).fold(0.0, f64::max);
    assert!(fastest < 0.11, "{fastest} m/s");
    assert_abs_diff_eq!(run.motion.q(50)[1], 0.1, epsilon = 1e-5);
}

/// Between two limits, without gravity: `e` times the speed after each; under gravity it comes to rest at the lower one.
#[test]
fn what_meets_a_limit_bounces_by_its_restitution() {
    let joint = Joint::new("slide").ty().limited(0.0, 1.0);
    let figure =
        FigureBuilder::new("f").link(LinkSpec::root("block", joint).mass(2.0)).build().expect("valid");
    for restitution in [0.0, 0.3, 0.7, 1.0] {
        let mut simulation = Simulation::new(&figure, Vector3::zeros());
        simulation.set_limits(LimitLaw::Hard { restitution }).expect("valid");
        simulation.set_start(&[0.5], &[3.0]).expect("valid");
        let run = simulation.run(&settings(0.25, 1000.0, 1e-3)).expect("never refused");
        assert_abs_diff_eq!(run.motion.v(250)[0], -3.0 * restitution, epsilon = 1e-9);
        let energy = &run.report.energy;
        assert_abs_diff_eq!(energy.heat, 9.0 * (1.0 - restitution * restitution), epsilon = 1e-9);
    }
    let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
    simulation.set_limits(LimitLaw::Hard { restitution: 0.5 }).expect("valid");
    simulation.set_start(&[1.0], &[0.0]).expect("valid");
    let run = simulation.run(&settings(2.0, 100.0, 1e-3)).expect("never refused");
    // The first bounce comes back to a quarter, and 1.35 s on all is over.
    let highest = (46..80).map(|frame| run.motion.q(frame)[0]).fold(0.0, f64::max);
    assert_relative_eq!(highest, 0.25, max_relative = 0.02);
    assert!(run.motion.q(200)[0].abs() < 1e-6 && run.motion.v(200)[0].abs() < 1e-6);
}
