//! Closed forms.

use super::{G, colliding, cube, over_a_slab, settings, shape};
use approx::assert_relative_eq;
use solaris_model::{
    Figure, FigureBuilder, Human, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind, Vector3,
};
use solaris_modes::{
    Collisions, ContactLaw, Drive, GroundPlane, Method, Rule, Settings, SetupError, Simulation,
    contact_points,
};
use solaris_profiles::Profile;

#[test]
fn a_block_on_a_slab_stays_below_its_angle_of_friction_and_slides_above_it() {
    let figure = over_a_slab(&[(cube(0.4, 0.2, 0.3), 3.0)]);
    for friction in [0.2_f64, 0.5, 1.0] {
        let run = |angle: f64, step: f64| {
            // The slab lies level and gravity is turned.
            let gravity = Vector3::new(angle.sin(), -angle.cos(), 0.0) * G;
            let simulation = colliding(&figure, gravity, friction, &[Vector3::new(0.0, 0.1, 0.0)]);
            let run = simulation.run(&settings(1.0, 100.0, step)).expect("never refused");
            run.motion.q(100)[0]
        };
        let edge = friction.atan();
        let creep = run(0.98 * edge, 1e-3);
        assert!((0.0..1e-5).contains(&creep), "{creep:e}");
        let above = 1.02 * edge;
        let expected = 0.5 * G * (above.sin() - friction * above.cos());
        let errors = [2e-3, 1e-3].map(|step| (run(above, step) - expected).abs() / expected);
        assert!(errors[1] < 0.05 && errors[1] < 0.7 * errors[0], "{friction}: {errors:?}");
    }
}

/// Who rides a slab that is moved goes with it as long as friction can take him, and slides with what it has beyond that.
#[test]
fn a_rider_goes_with_what_moves_as_far_as_friction_takes_him() {
    let slab = Shape { kind: cube(8.0, 0.2, 4.0), placement: Placement::translation(0.0, -0.1, 0.0) };
    let rider = LinkSpec::child("rider", "world", Joint::free("rider")).mass(3.0);
    let kind = shape(cube(0.4, 0.2, 0.3));
    let figure = FigureBuilder::new("ride")
        .link(LinkSpec::root("world", Joint::new("world")))
        .link(LinkSpec::child("slab", "world", Joint::new("slide").tx()).mass(1.0).shape(slab))
        .link(rider.inertia(Inertia::Uniform(kind)).shape(kind))
        .build()
        .expect("valid");
    let friction = 0.5;
    for (part, tolerance) in [(0.8, 1e-5), (1.5, 5e-3)] {
        // Speeds up evenly over the second: x = ½·a·t².
        let acceleration = part * friction * G;
        let curve = Profile::CubicHermite {
            from: 0.0,
            to: 0.5 * acceleration,
            duration: 1.0,
            start_velocity: 0.0,
            end_velocity: acceleration,
        };
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        simulation.set_start(&[0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.0, 1.0], &[0.0; 7]).expect("valid");
        simulation.drive("slide.tx", [Drive::Kinematic(curve)]).expect("valid");
        simulation.set_collisions(Collisions::of(&figure, friction).expect("valid")).expect("valid");
        let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("never refused");
        let (q, v) = (run.motion.q(100), run.motion.v(100));
        let taken = acceleration.min(friction * G);
        // Of order one.
        assert_relative_eq!(q[1], 0.5 * taken, max_relative = 2e-3);
        assert_relative_eq!(v[1], taken, max_relative = tolerance);
        // The drive of the slab bears him: m·a, and what rubs.
        let work = 0.5 * acceleration * acceleration + 3.0 * taken * 0.5 * acceleration;
        assert_relative_eq!(run.report.energy.work, work, max_relative = 5e-3);
    }
}

/// A ball rolls down with 5/7 of `g·sin`.
#[test]
fn a_ball_rolls_down_a_slope() {
    let figure = over_a_slab(&[(ShapeKind::Sphere { radius: 0.1 }, 2.0)]);
    let angle = 0.2_f64;
    let gravity = Vector3::new(angle.sin(), -angle.cos(), 0.0) * G;
    let simulation = colliding(&figure, gravity, 0.5, &[Vector3::new(-1.5, 0.1, 0.0)]);
    let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("never refused");
    let expected = 5.0 / 7.0 * G * angle.sin();
    // Along axes that turn.
    let v = run.motion.v(100);
    assert_relative_eq!(v[0].hypot(v[1]), expected, max_relative = 1e-5);
    assert_relative_eq!(v[5], -expected / 0.1, max_relative = 1e-5);
    // Of order one.
    assert_relative_eq!(run.motion.q(100)[0] + 1.5, 0.5 * expected, max_relative = 2e-3);
}

/// Ten boxes on each other stay where they are, and each bears what lies on it.
#[test]
fn a_stack_of_ten_boxes_stands() {
    let size = 0.1;
    let figure = over_a_slab(&[(cube(size, size, size), 1.0); 10]);
    let places: Vec<Vector3<f64>> = (0..10).map(|i| Vector3::y() * size * (0.5 + f64::from(i))).collect();
    let simulation = colliding(&figure, Vector3::y() * -G, 0.5, &places);
    let run = simulation.run(&settings(3.0, 50.0, 1e-3)).expect("never refused");
    let last = run.motion.q(run.motion.len() - 1);
    for (i, place) in places.iter().enumerate() {
        let off = Vector3::from_column_slice(&last[7 * i..7 * i + 3]) - place;
        assert!(off.norm() < 3e-5, "{i}: {off}");
    }
    let report = run.report.collisions.iter().find(|pair| pair.links == ["slab", "b0"]).expect("they touch");
    assert_relative_eq!(report.force, 10.0 * G, max_relative = 0.05);
    assert!(report.depth < 1e-5, "{report:?}");
    let contact = run.motion.contact("b0").expect("a track");
    // The slab bears ten, and nine press on the lowest.
    assert_relative_eq!(contact.samples[150].force.y, G, max_relative = 1e-6);
}

/// Without gravity the momentum stays, and what meets goes on together, but for 1/40 of its speed: what it sank in by in a step that is
/// given back in the next.
#[test]
fn what_meets_keeps_its_momentum() {
    let figure = over_a_slab(&[(ShapeKind::Sphere { radius: 0.1 }, 2.0), (cube(0.2, 0.2, 0.2), 3.0)]);
    let places = [Vector3::new(-0.5, 1.0, 0.0), Vector3::new(0.0, 1.0, 0.0)];
    for friction in [0.0, 0.5] {
        let mut simulation = colliding(&figure, Vector3::zeros(), friction, &places);
        let (q, mut v) = (simulation.state().0.to_vec(), vec![0.0; 12]);
        v[0] = 2.0;
        simulation.set_start(&q, &v).expect("valid");
        let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("never refused");
        let v = run.motion.v(100);
        assert_relative_eq!(2.0 * v[0] + 3.0 * v[6], 2.0 * 2.0, max_relative = 1e-9);
        assert!((0.0..2.0 / 40.0).contains(&(v[6] - v[0])), "{v:?}");
        // Half of m₁m₂/(m₁ + m₂)·v² is gone.
        let energy = &run.report.energy;
        assert_relative_eq!(energy.heat, 0.5 * 6.0 / 5.0 * 4.0, max_relative = 1e-3);
        assert!(energy.imbalance < 1e-6 * energy.scale, "{energy:?}");
    }
}

/// Two fingers that close with a force hold a block by friction, or let it slip with what is left.
#[test]
fn a_gripper_holds_a_block_as_long_as_friction_does() {
    let finger = |name: &str, axis: Vector3<f64>| {
        let joint = Joint::new(name).at(axis * -0.2).tx();
        LinkSpec::child(name, "hand", joint).mass(0.2).shape(shape(cube(0.02, 0.1, 0.1)))
    };
    let block = LinkSpec::child("block", "hand", Joint::free("block")).mass(1.0);
    let block = block.inertia(Inertia::Uniform(shape(cube(0.1, 0.1, 0.1)))).shape(shape(cube(0.1, 0.1, 0.1)));
    let figure: Figure = FigureBuilder::new("gripper")
        .link(LinkSpec::root("hand", Joint::new("hand")).mass(1.0))
        .link(finger("left", Vector3::x()))
        .link(finger("right", -Vector3::x()))
        .link(block)
        .build()
        .expect("valid");
    let (friction, squeeze) = (0.5, 12.0);
    let falls = |squeeze: f64| {
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        let q = [0.14, -0.14, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        simulation.set_start(&q, &[0.0; 8]).expect("valid");
        for (name, force) in [("left.tx", squeeze), ("right.tx", -squeeze)] {
            simulation
                .drive(name, [Drive::Torque(Profile::Line { from: force, to: force, duration: 1.0 })])
                .expect("valid");
        }
        simulation.set_collisions(Collisions::of(&figure, friction).expect("valid")).expect("valid");
        let run = simulation.run(&settings(0.2, 100.0, 1e-3)).expect("never refused");
        (run.motion.q(20)[3], run.motion.v(20)[3])
    };
    let (fallen, speed) = falls(squeeze);
    assert!(fallen.abs() < 1e-5 && speed.abs() < 1e-4, "{fallen} {speed}");
    // 2·μ·F = 6 N of the 9.81 N.
    let (fallen, speed) = falls(6.0);
    assert_relative_eq!(speed, -(G - 6.0) * 0.2, max_relative = 0.02);
    assert_relative_eq!(fallen, -0.5 * (G - 6.0) * 0.04, max_relative = 0.04);
}

/// What moves as prescribed pushes what it meets, and its drive does the work.
#[test]
fn what_is_moved_pushes_what_it_meets() {
    let pusher =
        LinkSpec::root("pusher", Joint::new("pusher").tx()).mass(5.0).shape(shape(cube(0.2, 0.2, 0.2)));
    let kind = ShapeKind::Sphere { radius: 0.1 };
    let ball = LinkSpec::child("ball", "pusher", Joint::free("ball")).mass(2.0);
    let ball = ball.inertia(Inertia::Uniform(shape(kind))).shape(shape(kind));
    let figure = FigureBuilder::new("push").link(pusher).link(ball).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], &[0.0; 7]).expect("valid");
    let to = Drive::Move { to: 1.0, over: 1.0, along: solaris_modes::Shape::MinimumJerk };
    simulation.drive("pusher", [to]).expect("valid");
    simulation.set_collisions(Collisions::of(&figure, 0.3).expect("valid")).expect("valid");
    let run = simulation.run(&settings(1.0, 200.0, 5e-4)).expect("never refused");
    // From the middle on, where the pusher is fastest with 15/8 m/s, the ball flies ahead.
    let speed = run.motion.v(200)[0] + run.motion.v(200)[1];
    assert_relative_eq!(speed, 1.875, max_relative = 0.01);
    // m·v₁² where they meet, 30 cm on, of which half is lost, and what makes it faster from there.
    let (mut early, mut late) = (0.0_f64, 0.5_f64);
    while late - early > 1e-12 {
        let s = 0.5 * (early + late);
        let is_there = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s) > 0.3;
        *if is_there { &mut late } else { &mut early } = s;
    }
    let met = 30.0 * (early * (1.0 - early)).powi(2);
    assert_relative_eq!(
        run.report.energy.work,
        2.0 * met * met + (speed * speed - met * met),
        max_relative = 0.01
    );
}

/// Limbs of a person who falls do not go through each other, and the run says how deep they were.
#[test]
fn limbs_of_limp_people_do_not_pass_through_each_other() {
    let figure = Human::new(1.75, 73.0).limp().build().expect("within range");
    let (layout, mut deepest) = (figure.layout(), [0.0_f64; 2]);
    for (with, deepest) in [true, false].into_iter().zip(&mut deepest) {
        let mut simulation = Simulation::new(&figure, Vector3::y() * -G);
        let (mut q, mut v) = (simulation.state().0.to_vec(), vec![0.0; layout.nv()]);
        // A pirouette that is tipped over.
        q[1] = 1.0;
        (v[3], v[4]) = (2.0, 6.0);
        simulation.set_start(&q, &v).expect("valid");
        let plane = GroundPlane {
            law: ContactLaw::Rigid,
            ..GroundPlane::under(&figure, simulation.gravity(), 0.8).expect("valid")
        };
        simulation.set_ground(plane, contact_points(&figure)).expect("valid");
        let collisions = Collisions::of(&figure, 0.4).expect("valid");
        if with {
            simulation.set_collisions(collisions.clone()).expect("valid");
        }
        let run = simulation.run(&settings(1.0, 100.0, 1e-3)).expect("never refused");
        *deepest = crate::collisions::piles::deepest(&figure, &run.motion, &collisions);
        assert_eq!(with, !run.report.collisions.is_empty());
        assert!(run.report.collisions.iter().all(|pair| pair.depth < 5e-3), "{:?}", run.report.collisions);
        let energy = &run.report.energy;
        assert!(energy.imbalance < 0.05 * energy.scale, "{energy:?}");
    }
    assert!(deepest[0] < 5e-3 && deepest[1] > 2e-2, "{deepest:?}");
}

#[test]
fn what_cannot_be_asked_is_refused() {
    let figure = over_a_slab(&[(ShapeKind::Sphere { radius: 0.1 }, 2.0)]);
    let simulation = colliding(&figure, Vector3::zeros(), 0.5, &[Vector3::y()]);
    let fixed = Method::Fixed { rule: Rule::RungeKutta4, step: 1e-3 };
    for method in [fixed, Method::Automatic { tolerance: 1e-6 }] {
        let settings = Settings { method, ..Settings::new(1.0, 10.0) };
        let error = simulation.run(&settings).expect_err("impulses only");
        assert_eq!(
            error.to_string(),
            "links that touch each other need steps by impulses, of 1 ms to begin with (method: Impulses(step: 1e-3))"
        );
    }
    let usual = simulation.run(&Settings::new(1.0, 10.0)).expect("nobody has named another").report;
    assert_eq!(usual.why, "links that touch each other, or are held together, need it");
    let mut simulation = simulation;
    let mut refused = |pairs: Vec<[usize; 2]>, friction| {
        simulation.set_collisions(Collisions { pairs, friction }).expect_err("refused").to_string()
    };
    assert_eq!(
        refused(vec![[0, 7]], 0.5),
        "a pair names the link number 7, and figure 'scene' has 2 links, numbered from 0"
    );
    assert_eq!(
        refused(vec![[1, 1]], 0.5),
        "link 'b0' of figure 'scene' cannot touch itself; a pair has two links"
    );
    assert_eq!(
        refused(vec![[0, 1]], f64::NAN),
        "the friction of collisions is NaN; it must be a finite number, zero or more"
    );
    assert!(matches!(
        Simulation::new(&figure, Vector3::zeros())
            .set_collisions(Collisions { pairs: vec![], friction: -1.0 }),
        Err(SetupError::Range { .. })
    ));
}
