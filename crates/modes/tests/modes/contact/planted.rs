//! A ground that plants what touches it: forces in closed form, plastic impacts, what lets go, what is refused.

use crate::contact::{G, at, fixed, simulation};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::Unit;
use solaris_model::{
    Event, EventKind, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Motion, Placement, ShapeKind, Vector3,
};
use solaris_modes::{
    ContactLaw, ContactPoint, Drive, FailureKind, GroundPlane, RunError, Simulation, contact_points,
};
use solaris_profiles::Profile;

/// A floor at height 0, with a coefficient of friction that is only reported.
pub(crate) fn ground(friction: f64) -> GroundPlane {
    GroundPlane { up: Unit::new_unchecked(Vector3::y()), height: 0.0, friction, law: ContactLaw::Rigid }
}

pub(crate) fn kinds(events: &[Event]) -> Vec<(bool, &str)> {
    let kind = |event: &Event| match &event.kind {
        EventKind::TouchDown { link } => Some((true, link.clone())),
        EventKind::LiftOff { link } => Some((false, link.clone())),
        _ => None,
    };
    // Leaked so that tests can compare with literals.
    events.iter().filter_map(kind).map(|(down, link)| (down, &*link.leak())).collect()
}

/// A uniform body in a plane: along x, up along y, turning about z.
fn flat(mass: f64, inertia: f64) -> Figure {
    let joint = Joint::new("slide").tx().ty().rz();
    let link = LinkSpec::root("body", joint).mass(mass).inertia(Inertia::diagonal(inertia, inertia, inertia));
    FigureBuilder::new("body").link(link).build().expect("valid")
}

pub(crate) fn forces(motion: &Motion, link: &str) -> Vec<Vector3<f64>> {
    motion.contact(link).expect("it touches").samples.iter().map(|contact| contact.force).collect()
}

/// `impulse + m·g·T = 0` from rest to rest.
#[test]
fn a_box_that_falls_flat_loses_all_and_stays() {
    let kind = ShapeKind::Box { size: Vector3::new(0.4, 0.2, 0.3) };
    let shape = solaris_model::Shape { kind, placement: Placement::identity() };
    let link =
        LinkSpec::root("box", Joint::free("root")).mass(3.0).inertia(Inertia::Uniform(shape)).shape(shape);
    let figure = FigureBuilder::new("box").link(link).build().expect("valid");
    let mut simulation = simulation(&figure, G, ground(0.5), contact_points(&figure));
    simulation.set_start(&[0.0, 0.6, 0.0, 0.0, 0.0, 0.0, 1.0], &[0.0; 6]).expect("valid");
    let run = simulation.run(&fixed(1.0, 100.0, 1e-2)).expect("runs");
    let ground = run.report.ground.as_ref().expect("a ground");
    let time = (2.0 * 0.5 / G).sqrt();
    let [landing] = &ground.landings[..] else { panic!("{:?}", ground.landings) };
    assert_relative_eq!(landing.time, time, max_relative = 1e-12);
    assert_relative_eq!(landing.loss, 3.0 * G * 0.5, max_relative = 1e-12);
    assert_relative_eq!(landing.impulse[1], 3.0 * G * time, max_relative = 1e-12);
    assert_relative_eq!(ground.impulse[1], 3.0 * G, max_relative = 1e-12);
    assert_relative_eq!(run.report.energy.impacts, landing.loss, max_relative = 1e-12);
    let last = run.motion.len() - 1;
    assert_abs_diff_eq!(run.motion.q(last)[1], 0.1, epsilon = 1e-12);
    assert!(run.motion.v(last).iter().all(|v| v.abs() < 1e-12));
    assert_relative_eq!(forces(&run.motion, "box")[last], Vector3::new(0.0, 3.0 * G, 0.0), epsilon = 1e-9);
    assert_eq!(kinds(&run.motion.events), [(true, "box")]);
    assert!(run.report.energy.imbalance < 1e-10 * run.report.energy.scale);
}

/// G. W. Housner, "The behavior of inverted pendulum structures during earthquakes" (1963): a uniform block of half width `b` and half
/// height `h` rocks from corner to corner, and each impact leaves `r = 1 − (3/2)·sin²α` of its angular velocity, `tan α = b/h`.
#[test]
fn a_block_rocks_to_rest_as_housner_says() {
    let (b, h, mass) = (0.15_f64, 0.5, 2.0);
    let (alpha, r) = (b.atan2(h), b.hypot(h));
    let figure = flat(mass, mass / 3.0 * r * r);
    let corners = vec![at(Vector3::new(-b, -h, 0.0), 0.0), at(Vector3::new(b, -h, 0.0), 0.0)];
    let mut simulation = simulation(&figure, G, ground(1.0), corners);
    // Turned about its right corner, to the right.
    let tilt = 0.5 * alpha;
    let (x, y) = (r * (alpha - tilt).sin(), r * (alpha - tilt).cos());
    simulation.set_start(&[-x, y, -tilt], &[0.0; 3]).expect("valid");
    let run = simulation.run(&fixed(12.0, 100.0, 1e-3)).expect("runs");
    let landings = &run.report.ground.as_ref().expect("a ground").landings;
    let left = 1.0 - 1.5 * alpha.sin().powi(2);
    let mut energy = mass * G * r * ((alpha - tilt).cos() - alpha.cos());
    assert!(landings.len() > 10, "{}", landings.len());
    // Until flights are too short to be any.
    for landing in &landings[..10] {
        assert_relative_eq!(landing.loss, energy * (1.0 - left * left), max_relative = 1e-8);
        energy *= left * left;
    }
    let last = run.motion.len() - 1;
    assert!(run.motion.v(last).iter().all(|v| v.abs() < 1e-9), "{:?}", run.motion.v(last));
    assert_abs_diff_eq!(run.motion.q(last)[2], 0.0, epsilon = 1e-6);
    // It lost all that it had: nothing bounces and nothing slides.
    let all = mass * G * r * ((alpha - tilt).cos() - alpha.cos());
    assert_relative_eq!(run.report.energy.impacts, all, max_relative = 1e-6);
}

/// A uniform rod of half length `l` on a point that does not slip, from `θ₀` off the vertical:
///
/// ```text
/// θ̈ = (3g/4l)·sin θ      θ̇² = (3g/2l)·(cos θ₀ − cos θ)      N = m·(g − l·(sin θ·θ̈ + cos θ·θ̇²))      F = m·l·(cos θ·θ̈ − sin θ·θ̇²)
/// ```
#[test]
fn a_rod_that_tips_over_presses_as_by_hand() {
    let (l, mass, tilt) = (0.5, 1.5, 0.2_f64);
    let figure = flat(mass, mass * l * l / 3.0);
    let mut simulation = simulation(&figure, G, ground(0.3), vec![at(Vector3::new(0.0, -l, 0.0), 0.0)]);
    simulation.set_start(&[l * tilt.sin(), l * tilt.cos(), -tilt], &[0.0; 3]).expect("valid");
    let run = simulation.run(&fixed(0.6, 500.0, 1e-3)).expect("runs");
    let found = forces(&run.motion, "body");
    let mut greatest = (0.0, 0.0);
    for (frame, force) in found.iter().enumerate() {
        let theta: f64 = -run.motion.q(frame)[2];
        let turning = 0.75 * G / l * theta.sin();
        let squared = 1.5 * G / l * (tilt.cos() - theta.cos());
        let normal = mass * (G - l * (theta.sin() * turning + theta.cos() * squared));
        let along = mass * l * (theta.cos() * turning - theta.sin() * squared);
        assert_abs_diff_eq!(force.y, normal, epsilon = 1e-7);
        assert_abs_diff_eq!(force.x, along, epsilon = 1e-7);
        greatest = if (along / normal).abs() > greatest.0 {
            ((along / normal).abs(), run.motion.time()[frame])
        } else {
            greatest
        };
    }
    let told = &run.report.ground.as_ref().expect("a ground").links[0];
    assert_relative_eq!(told.friction, greatest.0, max_relative = 1e-6);
    assert_relative_eq!(told.friction_time, greatest.1);
    assert!(told.slipping > 0.0 && told.slipping < 0.6, "{}", told.slipping);
    assert!(run.report.energy.imbalance < 1e-9 * run.report.energy.scale);
    assert!(told.depth < 1e-9);
}

/// `a = (5/7)·g·sin α`, and it takes the friction `(2/7)·tan α`.
#[test]
fn a_ball_rolls_down_a_slope() {
    let (angle, radius, mass) = (0.3_f64, 0.1, 2.0);
    let figure = flat(mass, 0.4 * mass * radius * radius);
    let up = Unit::new_normalize(Vector3::new(angle.sin(), angle.cos(), 0.0));
    let plane = GroundPlane { up, ..ground(0.5) };
    let mut simulation = simulation(&figure, G, plane, vec![at(Vector3::zeros(), radius)]);
    let start = up.into_inner() * radius;
    simulation.set_start(&[start.x, start.y, 0.0], &[0.0; 3]).expect("valid");
    let run = simulation.run(&fixed(1.0, 100.0, 1e-2)).expect("runs");
    let last = run.motion.len() - 1;
    let down = Vector3::new(angle.cos(), -angle.sin(), 0.0);
    let way = 0.5 * 5.0 / 7.0 * G * angle.sin();
    let moved = Vector3::new(run.motion.q(last)[0], run.motion.q(last)[1], 0.0) - start;
    assert_relative_eq!(moved, down * way, epsilon = 1e-9);
    assert_relative_eq!(run.motion.q(last)[2], -way / radius, max_relative = 1e-9);
    let told = &run.report.ground.as_ref().expect("a ground").links[0];
    assert_relative_eq!(told.friction, 2.0 / 7.0 * angle.tan(), max_relative = 1e-9);
}

/// Two feet under a trunk, on hips that are held: six degrees of freedom and twelve conditions.
fn table(hips: &Drive) -> Simulation {
    let pole = |x: f64| Joint::new(if x > 0.0 { "right" } else { "left" }).at(Vector3::new(x, 0.0, 0.0)).rz();
    let small = Inertia::diagonal(0.02, 0.02, 0.02);
    let trunk =
        LinkSpec::root("trunk", Joint::free("root")).mass(4.0).inertia(Inertia::diagonal(0.2, 0.2, 0.2));
    let foot = |name: &str, x| LinkSpec::child(name, "trunk", pole(x)).mass(1.0).inertia(small);
    let figure = FigureBuilder::new("table")
        .link(trunk)
        .link(foot("left_foot", -0.3))
        .link(foot("right_foot", 0.3))
        .build()
        .expect("valid");
    let corners = |link| {
        [[-0.1, -0.2], [-0.1, 0.2], [0.1, -0.2], [0.1, 0.2]].map(|[x, z]| ContactPoint {
            link,
            center: Vector3::new(x, -0.5, z),
            radius: 0.0,
        })
    };
    let mut simulation = simulation(&figure, G, ground(0.5), [corners(1), corners(2)].concat());
    for name in ["left", "right"] {
        simulation.drive(name, [hips.clone()]).expect("valid");
    }
    simulation.set_start(&[0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0], &[0.0; 8]).expect("valid");
    simulation
}

#[test]
fn two_feet_of_a_stiff_table_bear_its_weight_together() {
    let along = Profile::Line { from: 0.0, to: 0.0, duration: 1.0 };
    for hips in [Drive::Frozen, Drive::Kinematic(along)] {
        let simulation = table(&hips);
        let run = simulation.run(&fixed(0.5, 100.0, 1e-2)).expect("runs");
        let last = run.motion.len() - 1;
        let sum: Vector3<f64> = run.motion.contacts.iter().map(|track| track.samples[last].force).sum();
        assert_relative_eq!(sum, Vector3::new(0.0, 6.0 * G, 0.0), epsilon = 1e-9);
        if hips != Drive::Frozen {
            for track in &run.motion.contacts {
                assert_relative_eq!(track.samples[last].force.y, 3.0 * G, epsilon = 1e-9);
            }
        }
        for frame in 0..run.motion.len() {
            assert!(run.motion.v(frame).iter().all(|v| v.abs() < 1e-12));
            // No drive of the root does anything: it has none.
            let tau = run.motion.tau(frame).expect("forces");
            assert!(tau[..6].iter().all(|tau| tau.abs() < 1e-9), "{tau:?}");
        }
        assert!(run.motion.events.is_empty());
    }
}

/// A block that slides onto the ground with its whole weight keeps nothing of its speed; one that leaves keeps all.
#[test]
fn a_start_that_cannot_be_kept_is_stopped() {
    let figure = flat(2.0, 0.1);
    let mut simulation = simulation(&figure, G, ground(0.5), vec![at(Vector3::zeros(), 0.0)]);
    simulation.set_start(&[0.0, 0.0, 0.0], &[1.5, 0.0, 0.0]).expect("valid");
    let run = simulation.run(&fixed(0.2, 100.0, 1e-2)).expect("runs");
    assert_abs_diff_eq!(run.motion.v(0)[0], 0.0, epsilon = 1e-15);
    assert_relative_eq!(run.report.energy.impacts, 2.25, max_relative = 1e-12);
    simulation.set_start(&[0.0, 0.0, 0.0], &[1.5, 1.0, 0.0]).expect("valid");
    let run = simulation.run(&fixed(0.1, 100.0, 1e-2)).expect("runs");
    assert_relative_eq!(run.motion.v(10)[0], 1.5, max_relative = 1e-12);
    assert!(run.report.ground.as_ref().expect("a ground").landings.is_empty());
}

/// On a slope, with a root that is turned, whether it slides along its axes or is free.
#[test]
fn a_figure_is_put_on_the_ground() {
    let up = Unit::new_normalize(Vector3::new(0.3, 1.0, -0.2));
    let plane = GroundPlane { up, height: 0.25, ..ground(0.5) };
    let kind = ShapeKind::Capsule { radius: 0.1, length: 0.6 };
    let shape = solaris_model::Shape { kind, placement: Placement::translation(0.0, 0.1, 0.0) };
    let of = |joint: Joint| {
        let link = LinkSpec::root("rod", joint).mass(1.0).inertia(Inertia::Uniform(shape)).shape(shape);
        FigureBuilder::new("rod").link(link).build().expect("valid")
    };
    for (figure, q) in [
        (of(Joint::free("root")), vec![0.4, 2.0, -1.0, 0.1, 0.7, 0.1, 0.7]),
        (of(Joint::new("root").rz().tx().ty().rx()), vec![0.6, 0.3, -0.4, 0.2]),
    ] {
        let mut simulation = simulation(&figure, G, plane, contact_points(&figure));
        simulation.set_start(&q, &vec![0.0; figure.layout().nv()]).expect("valid");
        let before = simulation.state().0.to_vec();
        let lifted = simulation.stand().expect("it slides");
        assert!(lifted.abs() > 0.1, "{lifted}");
        let run = simulation.run(&fixed(0.0, 100.0, 1e-2)).expect("runs");
        let tree = solaris_dynamics::Tree::<f64>::new(&figure, Vector3::zeros()).expect("valid");
        let workspace = &mut solaris_dynamics::Workspace::new(&tree);
        solaris_dynamics::forward_kinematics(&tree, workspace, run.motion.q(0)).expect("finite");
        let gap = |touch: &ContactPoint| {
            workspace.pose(0).transform(&touch.center).dot(&up) - touch.radius - plane.height
        };
        let least = contact_points(&figure).iter().map(gap).fold(f64::INFINITY, f64::min);
        assert_abs_diff_eq!(least, 0.0, epsilon = 1e-14);
        // Again it is there already.
        assert_abs_diff_eq!(simulation.stand().expect("it slides"), 0.0, epsilon = 1e-14);
        assert_ne!(before, simulation.state().0);
    }
    let welded = of(Joint::new("root").rz());
    let mut simulation = simulation(&welded, G, plane, contact_points(&welded));
    let error = simulation.stand().expect_err("it does not slide").to_string();
    assert!(error.contains("'root'") && error.contains("give the root a free joint"), "{error}");
}

#[test]
fn a_foot_that_a_curve_drags_along_is_refused() {
    // Beside a block that stands as it should.
    let block = LinkSpec::child("block", "field", Joint::new("block").tx().ty()).mass(1.0);
    let cart = LinkSpec::child("cart", "field", Joint::new("rail").tx()).mass(1.0);
    let foot = LinkSpec::child("foot", "cart", Joint::new("lift").ty()).mass(1.0);
    let field = LinkSpec::root("field", Joint::new("place"));
    let figure =
        FigureBuilder::new("plough").link(field).link(block).link(cart).link(foot).build().expect("valid");
    let contact_points = [1, 3].map(|link| ContactPoint { link, ..at(Vector3::zeros(), 0.0) });
    let mut simulation = simulation(&figure, G, ground(0.5), contact_points.to_vec());
    let along = Profile::Line { from: 0.0, to: 1.0, duration: 1.0 };
    simulation.drive("rail", [Drive::Kinematic(along)]).expect("valid");
    simulation.set_start(&[0.0, 0.0, 0.0, 0.1], &[0.0, 0.0, 1.0, 0.0]).expect("valid");
    let error = simulation.run(&fixed(0.5, 100.0, 1e-2)).expect_err("it cannot stay");
    let RunError::Failed(failure) = &error else { panic!("{error}") };
    assert!(matches!(&failure.cause, FailureKind::ContactLost { link, .. } if link == "foot"), "{error}");
    let error = error.to_string();
    assert!(error.contains("a motion of its own ('rail.tx') moves it"), "{error}");
    assert!(error.ends_with("a ground of springs, where everything slides a little"), "{error}");
}

/// Two links stretched out on their ends, whose joint flies up: the ends would have to come nearer to each other at once, and no
/// joint can do that. The advice was to let dynamics move joints that they moved already.
#[test]
fn what_no_free_joint_can_keep_still_is_told_from_what_a_curve_drags() {
    let small = Inertia::diagonal(0.01, 0.01, 0.01);
    let upper = LinkSpec::root("upper", Joint::new("slide").tx().ty().rz()).mass(1.0).inertia(small);
    let knee = Joint::new("knee").at(Vector3::new(0.5, 0.0, 0.0)).rz();
    let lower = LinkSpec::child("lower", "upper", knee).mass(1.0).inertia(small);
    let figure = FigureBuilder::new("stretched").link(upper).link(lower).build().expect("valid");
    let contact_points =
        [at(Vector3::zeros(), 0.0), ContactPoint { link: 1, ..at(Vector3::new(0.5, 0.0, 0.0), 0.0) }];
    let mut simulation = simulation(&figure, G, ground(0.5), contact_points.to_vec());
    simulation.set_start(&[0.0; 4], &[0.0, 0.0, 1.0, -2.0]).expect("valid");
    let error = simulation.run(&fixed(0.1, 100.0, 1e-3)).expect_err("it cannot stay");
    let RunError::Failed(failure) = &error else { panic!("{error}") };
    assert!(matches!(&failure.cause, FailureKind::ContactLost { .. }), "{error}");
    let error = error.to_string();
    assert!(
        error.contains("free already")
            && error.ends_with("a ground of springs, where everything slides a little"),
        "{error}"
    );
    assert!(!error.contains("motion of its own") && !error.contains("let dynamics"), "{error}");
}
