//! Laws of turns between orientations, and hard cases.
#![cfg(feature = "rotation")]

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use solaris_profiles::ProfileError;
use solaris_profiles::rotation::{Slerp, Squad, Turning};
use std::f64::consts::{FRAC_PI_2, PI};

type Orientation = UnitQuaternion<f64>;

fn orientation() -> impl Strategy<Value = Orientation> {
    prop::array::uniform4(-1.0..1.0_f64)
        .prop_filter("not zero", |q| q.iter().map(|x| x * x).sum::<f64>() > 0.01)
        .prop_map(|[w, x, y, z]| UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z)))
}

fn negated(q: &Orientation) -> Orientation {
    UnitQuaternion::new_unchecked(-q.into_inner())
}

fn about(axis: Vector3<f64>, angle: f64) -> Orientation {
    UnitQuaternion::from_scaled_axis(axis.normalize() * angle)
}

/// The angle between two orientations.
fn apart(p: &Orientation, q: &Orientation) -> f64 {
    2.0 * (p.inverse() * q).imag().norm().min(1.0).asin()
}

fn keys() -> impl Strategy<Value = Vec<(f64, Orientation)>> {
    (-5.0..5.0, prop::collection::vec((0.2..1.5, orientation()), 2..7)).prop_map(|(start, steps)| {
        let mut time: f64 = start;
        steps
            .into_iter()
            .map(|(step, q)| {
                time += step;
                (time, q)
            })
            .collect()
    })
}

/// Angular velocity and acceleration against differences: ω from q(t − h)⁻¹·q(t + h), its rate from ω.
fn assert_derivatives(at: impl Fn(f64) -> Turning, t: f64, h: f64, scale: f64) {
    let (before, here, after) = (at(t - h), at(t), at(t + h));
    // Both turns in the frame of the middle: its logarithms on either side.
    let turn = |q: &Orientation| {
        let q = here.orientation.inverse() * q;
        if q.w < 0.0 { negated(&q).scaled_axis() } else { q.scaled_axis() }
    };
    let velocity = (turn(&after.orientation) - turn(&before.orientation)) / (2.0 * h);
    let error = (velocity - here.velocity).norm();
    assert!(error <= 1e-6 * scale, "velocity at {t}: {velocity}, not {}", here.velocity);
    let acceleration = (after.velocity - before.velocity) / (2.0 * h);
    let error = (acceleration - here.acceleration).norm();
    assert!(error <= 1e-5 * scale, "acceleration at {t}: {acceleration}, not {}", here.acceleration);
}

/// How fast a squad is, for tolerances: the greatest of velocity, and of acceleration over a scan.
fn size(squad: &Squad) -> f64 {
    (0..=200)
        .map(|i| squad.at(f64::from(i) / 200.0 * squad.duration()))
        .map(|turning| 1.0 + turning.velocity.norm().powi(3) + turning.acceleration.norm().powf(1.5))
        .fold(1.0, f64::max)
}

proptest! {
    #[test]
    fn a_slerp_turns_from_end_to_end_at_constant_speed(p in orientation(), q in orientation(), u in 0.0..1.0) {
        let slerp = Slerp::new(2.0, &p, &q).expect("a turn");
        prop_assert!(apart(&slerp.at(0.0).orientation, &p) < 1e-15);
        prop_assert!(apart(&slerp.at(2.0).orientation, &q) < 4e-15);
        let angle = apart(&p, &q).min(2.0 * PI - apart(&p, &q));
        let here = slerp.at(2.0 * u);
        prop_assert!((here.velocity.norm() - angle / 2.0).abs() < 1e-7);
        prop_assert!((slerp.turn().norm() - 2.0 * here.velocity.norm()).abs() < 1e-14);
        prop_assert!(slerp.turn().norm() <= PI + 1e-15 && here.acceleration.norm() < 1e-300);
        if (1e-3..1.0 - 1e-3).contains(&u) {
            assert_derivatives(|t| slerp.at(t), 2.0 * u, 1e-4, 10.0);
        }
    }

    #[test]
    fn signs_of_quaternions_do_not_matter(p in orientation(), q in orientation(), r in orientation(), t in 0.0..2.0) {
        let slerp = |p: &Orientation, q: &Orientation| Slerp::new(2.0, p, q).expect("a turn").at(t);
        let (one, other) = (slerp(&p, &q), slerp(&negated(&p), &q));
        prop_assert!(apart(&one.orientation, &other.orientation) < 1e-14);
        prop_assert!((one.velocity - other.velocity).norm() < 1e-13);
        let squad = |q: Orientation| Squad::new(&[(0.0, p), (0.7, q), (2.0, r)]).expect("a turn").at(t);
        let (one, other) = (squad(q), squad(negated(&q)));
        prop_assert!(apart(&one.orientation, &other.orientation) < 1e-12);
        prop_assert!((one.velocity - other.velocity).norm() < 1e-11);
    }

    #[test]
    fn a_squad_meets_its_keys_and_its_velocity_does_not_jump(keys in keys()) {
        let squad = Squad::new(&keys).expect("a turn");
        let scale = size(&squad);
        for &(time, orientation) in &keys {
            let t = time - keys[0].0;
            prop_assert!(apart(&squad.at(t).orientation, &orientation) < 1e-13);
            if t > 0.0 && t < squad.duration() {
                let jump = squad.at(t).velocity - squad.at(t - 1e-9).velocity;
                prop_assert!(jump.norm() < 1e-6 * scale, "at {}: {}", t, jump);
            }
        }
    }

    #[test]
    fn a_squad_s_derivatives_are_those_of_its_orientation(keys in keys(), u in 0.01..0.99) {
        let squad = Squad::new(&keys).expect("a turn");
        let t = u * squad.duration();
        // Differences are of one span.
        let is_clear = keys.iter().all(|&(time, _)| f64::abs(time - keys[0].0 - t) > 1e-3);
        if is_clear {
            assert_derivatives(|t| squad.at(t), t, 1e-5, size(&squad));
        }
    }

    #[test]
    fn a_squad_through_two_keys_is_a_slerp(p in orientation(), q in orientation(), t in 0.0..3.0) {
        let (slerp, squad) = (Slerp::new(3.0, &p, &q), Squad::new(&[(1.0, p), (4.0, q)]));
        let (one, other) = (slerp.expect("a turn").at(t), squad.expect("a turn").at(t));
        prop_assert!(apart(&one.orientation, &other.orientation) < 1e-14);
        prop_assert!((one.velocity - other.velocity).norm() < 1e-13);
        prop_assert!(other.acceleration.norm() < 1e-12);
    }

    #[test]
    fn turned_keys_give_a_turned_squad(keys in keys(), by in orientation(), u in 0.0..1.0) {
        let turned: Vec<_> = keys.iter().map(|&(time, q)| (time, by * q)).collect();
        let (one, other) = (Squad::new(&keys).expect("a turn"), Squad::new(&turned).expect("a turn"));
        let t = u * one.duration();
        let scale = size(&one);
        prop_assert!(apart(&(by * one.at(t).orientation), &other.at(t).orientation) < 1e-11 * scale);
        prop_assert!((one.at(t).velocity - other.at(t).velocity).norm() < 1e-10 * scale);
    }
}

#[test]
fn about_one_axis_a_squad_at_even_times_is_the_known_curve() {
    // Angles 0, 1, 1.5 rad at 0, 1, 2 s. In the first span: Ω₀ = 1, Ω₁ = 3/4 (rad/s), and in half angles
    // q = u·L + 2u(1 − u)·(A₀ + u·(A₁ − A₀)) with A₀ = 0, A₁ = (1 − 3/4)/2.
    let axis = Vector3::new(0.0, 0.0, 1.0);
    let keys = [0.0, 1.0, 1.5].map(|angle| about(axis, angle));
    let squad = Squad::new(&[(0.0, keys[0]), (1.0, keys[1]), (2.0, keys[2])]).expect("a turn");
    for u in [0.0, 0.25, 0.5, 0.9] {
        let expected = u + 2.0 * u * (1.0 - u) * u * 0.125;
        let here = squad.at(u);
        assert!((here.orientation.scaled_axis().z - expected).abs() < 1e-14);
        assert!((here.velocity.z - (1.0 + 0.25 * (2.0 * u - 3.0 * u * u))).abs() < 1e-13);
        assert!((here.acceleration.z - 0.25 * (2.0 - 6.0 * u)).abs() < 1e-12);
    }
}

#[test]
fn equal_keys_rest() {
    let q = about(Vector3::new(1.0, -2.0, 0.5), 0.7);
    let slerp = Slerp::new(1.0, &q, &q).expect("a turn").at(0.4);
    assert!(apart(&slerp.orientation, &q) < 1e-15 && slerp.velocity.norm() < 1e-15);
    let squad = Squad::new(&[(0.0, q), (1.0, negated(&q)), (1.5, q)]).expect("a turn").at(0.4);
    assert!(apart(&squad.orientation, &q) < 1e-15 && squad.velocity.norm() < 1e-15);
    assert!(squad.acceleration.norm() < 1e-14);
}

#[test]
fn half_a_turn_goes_one_way_and_keeps_its_speed() {
    let identity = Orientation::identity();
    for angle in [PI, PI - 1e-9, PI - 1e-15] {
        let half = about(Vector3::new(0.3, -0.4, 1.2), angle);
        for to in [half, negated(&half)] {
            let slerp = Slerp::new(1.0, &identity, &to).expect("a turn");
            assert!((slerp.turn().norm() - angle).abs() < 1e-14);
            assert!((apart(&identity, &slerp.at(0.5).orientation) - angle / 2.0).abs() < 1e-14);
            assert!(apart(&slerp.at(1.0).orientation, &to) < 1e-14);
        }
    }
    // Exactly half a turn, whatever the signs.
    let half = UnitQuaternion::new_unchecked(Quaternion::new(0.0, 0.0, 1.0, 0.0));
    let slerp = |p: &Orientation, q: &Orientation| Slerp::new(1.0, p, q).expect("a turn").turn();
    let expected = slerp(&identity, &half);
    assert_eq!(slerp(&identity, &negated(&half)), expected);
    assert_eq!(slerp(&negated(&identity), &half), expected);
    assert!((expected.y - PI).abs() < 1e-15);
}

#[test]
fn tiny_turns_keep_all_their_digits() {
    for angle in [1e-3, 1e-8, 1e-160, 1e-300, 5e-324] {
        let near = UnitQuaternion::new_unchecked(Quaternion::new(1.0, 0.0, angle / 2.0, 0.0));
        let turn = Slerp::new(1.0, &Orientation::identity(), &near).expect("a turn").turn();
        let expected = 2.0 * near.imag().y.asin();
        assert!(
            (turn.y - expected).abs()
                <= 4e-16 * expected.abs() + if angle < 0.01 { angle.powi(3) } else { 0.0 }
        );
    }
}

#[test]
fn half_turns_back_and_forth_stay_on_the_sphere() {
    let keys: Vec<_> = (0..8)
        .map(|i| {
            let axis = Vector3::new(f64::from(i % 3), f64::from(i % 2), 1.0);
            (f64::from(i * i), about(axis, PI * f64::from(i % 2)))
        })
        .collect();
    let squad = Squad::new(&keys).expect("a turn");
    for i in 0..=4900 {
        let here = squad.at(f64::from(i) * 0.01);
        assert!(here.velocity.norm() < 100.0 && here.acceleration.norm() < 1e4, "{here:?}");
    }
}

#[test]
fn uneven_times_do_not_swing_wide() {
    // A fast quarter turn in a millisecond, then a long rest.
    let quarter = about(Vector3::new(1.0, 0.0, 0.0), FRAC_PI_2);
    let keys = [(0.0, Orientation::identity()), (1e-3, quarter), (10.0, quarter)];
    let squad = Squad::new(&keys).expect("a turn");
    for i in 0..=1000 {
        let here = squad.at(f64::from(i) * 0.01);
        assert!(apart(&here.orientation, &quarter) < FRAC_PI_2 + 1e-9);
    }
}

#[test]
fn what_is_no_turn_is_refused() {
    let (one, nan) = (Orientation::identity(), Quaternion::new(f64::NAN, 0.0, 0.0, 0.0));
    assert!(matches!(Slerp::new(0.0, &one, &one), Err(ProfileError::Duration { .. })));
    let nan = UnitQuaternion::new_unchecked(nan);
    assert!(matches!(Slerp::new(1.0, &one, &nan), Err(ProfileError::NotFinite { .. })));
    let long = UnitQuaternion::new_unchecked(Quaternion::new(2.0, 0.0, 0.0, 0.0));
    assert!(matches!(Slerp::new(1.0, &long, &one), Err(ProfileError::OutOfRange { .. })));
    assert!(matches!(
        Slerp::new(1e-320, &one, &about(Vector3::x(), 1.0)),
        Err(ProfileError::Overflow { .. })
    ));
    assert!(matches!(Squad::new(&[(0.0, one)]), Err(ProfileError::Count { found: 1, needed: 2, .. })));
    assert!(matches!(Squad::new(&[(0.0, one), (0.0, one)]), Err(ProfileError::Knots { index: 1, .. })));
    assert!(matches!(Squad::new(&[(0.0, one), (f64::NAN, one)]), Err(ProfileError::NotFinite { .. })));
    assert!(Slerp::new(1.0, &one, &one).expect("a turn").at(f64::NAN).velocity.x.is_nan());
    assert!(Squad::new(&[(0.0, one), (1.0, one)]).expect("a turn").at(f64::NAN).velocity.x.is_nan());
}
