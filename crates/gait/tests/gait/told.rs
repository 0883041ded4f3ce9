//! Limbs that a walker moves otherwise than its walk does: they reach, play clips and obey the caller, and the feet know nothing of it.

use crate::driven::{Driver, person};
use crate::live_random::{command, holds};
use crate::random::Random;
use crate::support::Walked;
use nalgebra::{Unit, UnitQuaternion, Vector3};
use solaris_analysis::Goal;
use solaris_gait::{Command, LiveError, Walker};
use solaris_model::{Figure, Motion, MotionInfo};
use solaris_modes::RecordedMotion;
use std::sync::Arc;

const PALM: Vector3<f64> = Vector3::new(0.0, -0.08, 0.0);

fn walk() -> Command {
    Command::velocity(0.0, 1.1)
}

/// Where a point of a link is, by products of matrices.
fn place(figure: &Figure, q: &[f64], link: &str, at: &Vector3<f64>) -> Vector3<f64> {
    let (place, turn) = Walked::poses(figure, q)[figure.link_index(link).expect("a link")];
    place + turn * at
}

fn index(figure: &Figure, name: &str) -> usize {
    figure.layout().q_names().iter().position(|known| known == name).expect("a coordinate")
}

#[test]
fn a_hand_slides_along_a_rail_while_one_walks() {
    let figure = person(1.75);
    let mut driver = Driver::new(&figure, 120.0);
    driver.go(&walk(), 2.0);
    let rail = |walker: &Walker| Vector3::new(-0.42, 0.98, walker.com().z + 0.1);
    for frame in 0..480 {
        driver.walker.reach("right_hand", PALM, &[], Goal::Place(rail(&driver.walker))).expect("a reach");
        let wanted = rail(&driver.walker);
        driver.go(&walk(), 1.0 / 120.0);
        let is = place(&figure, driver.walker.configuration(), "right_hand", &PALM);
        let off = (is - wanted).norm();
        assert!(frame < 40 || off < 1e-8, "{frame}: {off}");
        assert!(driver.walker.reached("right_hand").is_some());
    }
    driver.walker.withdraw("right_hand").expect("a link");
    assert_eq!(driver.walker.reached("right_hand"), None);
    driver.go(&walk(), 1.0);
    // It walks as if nothing had been, to the bit.
    let mut other = Driver::new(&figure, 120.0);
    other.go(&walk(), 7.0);
    let pairs = driver.walker.configuration().iter().zip(other.walker.configuration());
    assert!(pairs.into_iter().all(|(a, b)| a.to_bits() == b.to_bits()));
    holds(&driver.found, 1.75, "a rail");
    assert!(driver.found.change.0 < 700.0, "{:?}", driver.found.change);
}

#[test]
fn a_head_looks_and_a_hand_is_held_as_they_are_told() {
    let figure = person(1.75);
    let mut driver = Driver::new(&figure, 120.0);
    let (eyes, forward) = (Vector3::new(0.0, 0.1, 0.08), Vector3::z_axis());
    let lamp = Vector3::new(1.5, 1.4, 4.0);
    driver.go(&walk(), 1.0);
    driver.walker.reach("head", eyes, &[], Goal::Look { axis: forward, at: lamp }).expect("a look");
    let level = UnitQuaternion::from_euler_angles(0.0, 0.3, 0.0);
    driver
        .walker
        .reach("left_hand", Vector3::zeros(), &["left_wrist", "left_elbow"], Goal::Turned(level))
        .expect("a hold");
    driver.go(&walk(), 1.0);
    for _ in 0..60 {
        driver.go(&walk(), 1.0 / 120.0);
        let q = driver.walker.configuration();
        let poses = Walked::poses(&figure, q);
        let (at, turn) = poses[figure.link_index("head").expect("a head")];
        let off = (turn * forward.into_inner()).angle(&(lamp - at - turn * eyes));
        assert!(off < 1e-7, "{off}");
        let (_, hand) = poses[figure.link_index("left_hand").expect("a hand")];
        let off = UnitQuaternion::from_rotation_matrix(&hand).angle_to(&level);
        let told = driver.walker.reached("left_hand").expect("it reaches");
        assert!((off - told).abs() < 1e-7, "{off} {told}");
    }
    holds(&driver.found, 1.75, "a look");
}

/// A wave of the right arm.
fn wave(figure: &Figure) -> Arc<RecordedMotion> {
    let (nq, rate) = (figure.layout().nq(), 60.0);
    let time: Vec<f64> = (0..=90).map(|k| f64::from(k) / rate).collect();
    let (lift, bend) = (index(figure, "right_shoulder.rx"), index(figure, "right_elbow.rx"));
    let columns = [0, 1, 2].map(|k: usize| {
        let mut all = vec![0.0; nq * time.len()];
        for (row, t) in time.iter().enumerate() {
            let angle = 6.0 * t;
            let wave = [angle.sin(), 6.0 * angle.cos(), -36.0 * angle.sin()][k];
            let rest = if k == 0 { [-2.0, -0.9] } else { [0.0; 2] };
            all[row * nq + lift] = rest[0] + 0.2 * wave;
            all[row * nq + bend] = rest[1] + 0.4 * wave;
        }
        all
    });
    let motion = Motion::new(figure, MotionInfo::on_earth(figure, rate), time, columns).expect("a motion");
    Arc::new(RecordedMotion::new(motion).expect("samples"))
}

#[test]
fn a_clip_is_played_over_a_walk_and_ends() {
    let figure = person(1.75);
    let mut driver = Driver::new(&figure, 120.0);
    let clip = wave(&figure);
    driver.go(&walk(), 2.0);
    let mut other = driver.walker.clone();
    driver.walker.play(&clip, &["right_shoulder", "right_elbow"]).expect("a clip");
    let bend = index(&figure, "right_elbow.rx");
    for frame in 1..180 {
        driver.go(&walk(), 1.0 / 120.0);
        let walked = other.step(1.0 / 120.0, &walk()).expect("a frame");
        let (q, time) = (driver.walker.configuration(), f64::from(frame) / 120.0);
        let wanted = -0.9 + 0.4 * (6.0 * time).sin();
        assert!(frame < 40 || (q[bend] - wanted).abs() < 1e-6, "{frame}: {} {wanted}", q[bend]);
        // All else walks.
        let name = &figure.layout().q_names();
        let is_of = |i: usize| name[i].starts_with("right_shoulder") || name[i].starts_with("right_elbow");
        assert!((0..q.len()).all(|i| is_of(i) || q[i].to_bits() == walked[i].to_bits()), "{frame}");
    }
    assert!(driver.walker.plays());
    driver.go(&walk(), 0.5);
    assert!(!driver.walker.plays());
    for _ in 0..60 {
        other.step(1.0 / 120.0, &walk()).expect("a frame");
    }
    let last = other.step(1.0 / 120.0, &walk()).expect("a frame");
    assert!(
        last.iter()
            .zip(driver.go(&walk(), 1.0 / 120.0).walker.configuration())
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
    holds(&driver.found, 1.75, "a clip");
    assert!(driver.found.change.0 < 900.0, "{:?}", driver.found.change);
}

/// Whatever is told, and taken back, and told otherwise: nothing jumps, and the feet keep what they keep.
#[test]
fn half_a_minute_of_anything_told_holds() {
    for (height, seed, rate) in [(1.75, 31, 60.0), (1.6, 32, 120.0), (1.9, 33, 240.0)] {
        let figure = person(height);
        let mut driver = Driver::new(&figure, rate);
        let mut random = Random(seed);
        let clip = wave(&figure);
        let (mut now, mut until) = (Command::stop(), 0.0);
        while driver.time() < 30.0 {
            if driver.time() >= until {
                let (next, holds) = command(&mut random);
                (now, until) = (next, driver.time() + holds);
            }
            let here = driver.walker.com();
            let near = |random: &mut Random, by: f64| here + Vector3::from_fn(|_, _| random.within(-by, by));
            let place = near(&mut random, 0.9);
            match random.pick(7) {
                0 => driver.walker.reach("right_hand", PALM, &[], Goal::Place(place)).expect("a reach"),
                1 => driver
                    .walker
                    .reach("left_hand", PALM, &["thorax", "left_shoulder", "left_elbow"], Goal::Place(place))
                    .expect("a reach"),
                2 => {
                    let goal = Goal::Look { axis: Vector3::z_axis(), at: near(&mut random, 6.0) };
                    driver.walker.reach("head", Vector3::zeros(), &[], goal).expect("a look");
                }
                3 => {
                    let link = ["right_hand", "left_hand", "head"][random.pick(3)];
                    driver.walker.withdraw(link).expect("a link");
                }
                4 => drop(driver.walker.play(&clip, &["right_shoulder.rx", "right_elbow"])),
                5 => {
                    driver.walker.free("left_elbow.rx").expect("a coordinate");
                    driver.walker.set_freed("left_elbow.rx", random.within(-2.0, 0.0)).expect("a value");
                }
                _ => driver.walker.hold("left_elbow.rx").expect("a coordinate"),
            }
            driver.go(&now, (random.within(0.02, 0.8) * rate).ceil() / rate);
        }
        holds(&driver.found, height, &format!("{height} m, seed {seed}"));
        assert!(driver.found.rate.0 < 25.0, "{:?}", driver.found.rate);
    }
}

#[test]
fn what_cannot_be_told_is_refused_by_name() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    let here = Goal::Place(Vector3::new(0.3, 1.0, 0.3));
    let refused = |walker: &mut Walker, link: &str, by: &[&str], goal: Goal| {
        walker.reach(link, PALM, by, goal).expect_err("a refusal").to_string()
    };
    assert_eq!(
        refused(&mut walker, "right_hnd", &[], here),
        "there is no link 'right_hnd'; did you mean 'right_hand'?"
    );
    assert_eq!(
        refused(&mut walker, "right_hand", &["right_elbo"], here),
        "there is no coordinate 'right_elbo' that can be told; did you mean 'right_elbow'?; all but those of the root and the legs can"
    );
    let error = refused(&mut walker, "right_hand", &["left_elbow"], here);
    assert!(error.contains("nothing that is named moves 'right_hand'"), "{error}");
    let error = refused(&mut walker, "right_foot", &[], here);
    assert!(error.contains("nothing that is named moves 'right_foot'"), "{error}");
    for wrong in [f64::NAN, f64::INFINITY, 1e9] {
        let place = Vector3::new(0.0, wrong, 0.0);
        let axis = Unit::new_unchecked(Vector3::new(0.0, f64::NAN, 1.0));
        for goal in [Goal::Place(place), Goal::Look { axis, at: Vector3::z() }] {
            assert!(matches!(walker.reach("head", PALM, &[], goal), Err(LiveError::NotFinite { .. })));
        }
        assert!(walker.reach("head", place, &[], here).is_err());
    }
    let other = person(1.5);
    assert!(matches!(walker.play(&wave(&other), &[]), Err(LiveError::Clip { .. })));
    assert!(matches!(walker.play(&wave(&figure), &["left_knee"]), Err(LiveError::NotFree { .. })));
    for _ in 0..16 {
        walker.play(&wave(&figure), &[]).expect("a clip");
    }
    assert!(matches!(walker.play(&wave(&figure), &[]), Err(LiveError::Clip { .. })));
    walker.end_clips();
    walker.step(1.0 / 60.0, &walk()).expect("a frame");
}
