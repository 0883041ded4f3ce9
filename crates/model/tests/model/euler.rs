//! The six orders of rotation: there and back, velocity maps, states, and the distance to gimbal lock.

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use solaris_model::{
    Axis, BallState, EulerError, EulerOrder, EulerState, Figure, FigureBuilder, Joint, LinkSpec,
};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const EPSILON: f64 = f64::EPSILON;

/// The rotation of a chain of three turns, one matrix at a time.
fn chain(order: EulerOrder, angles: &[f64; 3]) -> Matrix3<f64> {
    let turns = order.axes().into_iter().zip(angles).map(|(axis, angle)| {
        let (s, c) = angle.sin_cos();
        match axis {
            0 => Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c),
            1 => Matrix3::new(c, 0.0, s, 0.0, 1.0, 0.0, -s, 0.0, c),
            _ => Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0),
        }
    });
    turns.product()
}

fn matrix(rotation: &UnitQuaternion<f64>) -> Matrix3<f64> {
    rotation.to_rotation_matrix().into_inner()
}

/// The angular velocity along the link's axes, `[ω]× = Rᵀ·Ṙ`, from differences of the chain's rotation.
fn velocity(order: EulerOrder, angles: impl Fn(f64) -> [f64; 3], t: f64) -> Vector3<f64> {
    let h = 1e-3;
    let at = |k: f64| chain(order, &angles(t + k * h));
    let rate = ((at(1.0) - at(-1.0)) * 45.0 - (at(2.0) - at(-2.0)) * 9.0 + (at(3.0) - at(-3.0))) / (60.0 * h);
    let skew = at(0.0).transpose() * rate;
    Vector3::new(skew[(2, 1)] - skew[(1, 2)], skew[(0, 2)] - skew[(2, 0)], skew[(1, 0)] - skew[(0, 1)]) / 2.0
}

fn orders() -> impl Strategy<Value = EulerOrder> {
    prop::sample::select(&EulerOrder::ALL[..])
}

fn numbers<const N: usize>(range: f64) -> impl Strategy<Value = [f64; N]> {
    prop::array::uniform::<_, N>(-range..range)
}

fn rotations() -> impl Strategy<Value = UnitQuaternion<f64>> {
    numbers::<4>(1.0)
        .prop_filter("no direction", |q| q.iter().map(|x| x * x).sum::<f64>() > 0.01)
        .prop_map(|q| UnitQuaternion::from_quaternion(nalgebra::Quaternion::from(q)))
}

/// Distances (rad) from lock, down to lock itself.
const NEAR: [f64; 12] = [1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-14, 1e-16, 0.0];

proptest! {
    #[test]
    fn angles_make_the_rotation_of_the_chain(order in orders(), angles in numbers::<3>(7.0)) {
        prop_assert!((matrix(&order.rotation(&angles)) - chain(order, &angles)).amax() < 8.0 * EPSILON);
    }

    #[test]
    fn rotations_come_back_from_their_angles(order in orders(), rotation in rotations()) {
        for rotation in [rotation, UnitQuaternion::new_unchecked(-rotation.into_inner())] {
            let angles = order.angles(&rotation);
            prop_assert!(angles[1].abs() <= FRAC_PI_2 && angles[0].abs() <= PI && angles[2].abs() <= PI);
            prop_assert!((chain(order, &angles) - matrix(&rotation)).amax() < 16.0 * EPSILON);
            let by_matrix = order.angles_of_matrix(&rotation.to_rotation_matrix());
            prop_assert!((chain(order, &by_matrix) - matrix(&rotation)).amax() < 16.0 * EPSILON);
        }
    }

    #[test]
    fn angles_come_back_from_their_rotation(
        order in orders(), first in -3.1..3.1, middle in -1.5..1.5, last in -3.1..3.1,
    ) {
        let angles = [first, middle, last];
        let back = order.angles(&order.rotation(&angles));
        let (error, bound) = ((Vector3::from(back) - Vector3::from(angles)).amax(), 8.0 * EPSILON / f64::cos(middle));
        prop_assert!(error < bound, "{error:e} {bound:e}");
    }

    #[test]
    fn small_angles_keep_their_digits(order in orders(), angles in numbers::<3>(1.0), digits in 3..200_i32) {
        // Products of two angles are below rounding; at the large end of the range they show in the rotation itself.
        let small = angles.map(|angle| angle * 10.0_f64.powi(-digits));
        let error = (Vector3::from(order.angles(&order.rotation(&small))) - Vector3::from(small)).amax();
        prop_assert!(error < 8.0 * EPSILON * 10.0_f64.powi(-digits), "{error:e}");
    }

    #[test]
    fn near_lock_the_rotation_comes_back_and_so_does_the_distance(
        order in orders(), first in -3.0..3.0, last in -3.0..3.0, upper: bool,
    ) {
        for distance in NEAR {
            let middle = if upper { FRAC_PI_2 - distance } else { distance - FRAC_PI_2 };
            let angles = [first, middle, last];
            let rotation = order.rotation(&angles);
            let back = order.angles(&rotation);
            prop_assert!(back.iter().all(|angle| angle.is_finite()));
            prop_assert!((chain(order, &back) - chain(order, &angles)).amax() < 16.0 * EPSILON, "{distance:e}");
            prop_assert!((back[1] - middle).abs() < 4.0 * EPSILON, "{distance:e}: {:e}", back[1] - middle);
            let error = (back[0] - first).abs().max((back[2] - last).abs());
            prop_assert!(distance < 1e-14 || error < 16.0 * EPSILON / distance, "{distance:e}: {error:e}");
            prop_assert!(distance > 1e-16 || back[2] == 0.0, "the choice in lock: {back:?}");
            let near = order.angles_near(&rotation, &[first + 0.1, middle, last + 0.1]);
            prop_assert!((chain(order, &near) - chain(order, &angles)).amax() < 16.0 * EPSILON, "{distance:e}");
            // In lock the meaningless half of the sum or difference stays as it was.
            let kept = (near[0] - first - 0.1).abs().max((near[2] - last - 0.1).abs());
            prop_assert!(distance > 1e-16 || kept < 0.2, "{near:?} against {first} {last}");
        }
    }

    #[test]
    fn angles_follow_a_motion_through_whole_turns_and_past_lock(
        order in orders(), start in numbers::<3>(3.0), rates in numbers::<3>(4.0),
    ) {
        let mut near = start;
        for frame in 0..400 {
            let angles: [f64; 3] = std::array::from_fn(|i| start[i] + rates[i] * f64::from(frame) * 0.01);
            near = order.angles_near(&order.rotation(&angles), &near);
            let distance = angles[1].cos().abs();
            let error = (Vector3::from(near) - Vector3::from(angles)).amax();
            prop_assert!(distance < 1e-6 || error < 16.0 * EPSILON * (10.0 + 1.0 / distance), "{frame}: {near:?} {angles:?}");
        }
    }

    #[test]
    fn the_velocity_map_and_its_rate_are_the_derivatives(
        order in orders(), angles in numbers::<3>(3.0), rates in numbers::<3>(2.0), second in numbers::<3>(2.0),
    ) {
        let at = |t: f64| std::array::from_fn(|i| angles[i] + t * rates[i] + 0.5 * t * t * second[i]);
        let rates_at = |t: f64| std::array::from_fn(|i| rates[i] + t * second[i]);
        let map = |t: f64| order.velocity_map(&at(t)) * Vector3::from(rates_at(t));
        prop_assert!((map(0.0) - velocity(order, at, 0.0)).norm() < 1e-11);
        let h = 1e-3;
        let rate = ((map(h) - map(-h)) * 8.0 - (map(2.0 * h) - map(-2.0 * h))) / (12.0 * h);
        let acceleration =
            order.velocity_map(&angles) * Vector3::from(second) + order.velocity_map_rate(&angles, &rates) * Vector3::from(rates);
        prop_assert!((acceleration - rate).norm() < 1e-8, "{:e}", (acceleration - rate).norm());
    }

    #[test]
    fn rates_and_moments_undo_the_velocity_map(
        order in orders(), first in -3.0..3.0, last in -3.0..3.0, vector in numbers::<3>(2.0), upper: bool,
    ) {
        for distance in NEAR.iter().filter(|d| **d >= 1e-12).chain(&[0.3, 1.0, FRAC_PI_2, 2.0]) {
            let middle = if upper { FRAC_PI_2 - distance } else { distance - FRAC_PI_2 };
            let angles = [first, middle, last];
            let map = order.velocity_map(&angles);
            prop_assert!((map.determinant().abs() - middle.cos().abs()).abs() < 4.0 * EPSILON);
            let velocity = Vector3::from(vector);
            let rates = Vector3::from(order.rates(&angles, &velocity).expect("not in lock"));
            prop_assert!((map * rates - velocity).norm() < 16.0 * EPSILON * (velocity.norm() + rates.norm()));
            let moment = order.moment(&angles, &vector).expect("not in lock");
            prop_assert!((map.transpose() * moment - velocity).norm() < 16.0 * EPSILON * (velocity.norm() + moment.norm()));
            // Power is power.
            let (ours, theirs) = (moment.dot(&velocity), Vector3::from(vector).dot(&rates));
            prop_assert!((ours - theirs).abs() < 32.0 * EPSILON * (velocity.norm() + 1.0) * moment.norm().max(rates.norm()));
        }
    }

    #[test]
    fn states_go_both_ways(
        order in orders(), first in -3.0..3.0, middle in -1.3..1.3, last in -3.0..3.0, rest in numbers::<9>(3.0),
    ) {
        let three = |from: usize| [rest[from], rest[from + 1], rest[from + 2]];
        let state = EulerState { q: [first, middle, last], v: three(0), a: three(3), tau: three(6) };
        let ball = order.ball_state(&state).expect("not in lock");
        let back = order.euler_state(&ball).expect("not in lock");
        let error = |a: [f64; 3], b: [f64; 3]| (Vector3::from(a) - Vector3::from(b)).norm();
        prop_assert!(error(back.q, state.q) < 1e-14 && error(back.v, state.v) < 1e-13);
        prop_assert!(error(back.a, state.a) < 1e-11 && error(back.tau, state.tau) < 1e-13);
        // By a curve with these rates, and by the power of the moments.
        let at = |t: f64| std::array::from_fn(|i| state.q[i] + t * state.v[i] + 0.5 * t * t * state.a[i]);
        prop_assert!((Vector3::from(ball.v) - velocity(order, at, 0.0)).norm() < 1e-9);
        let h = 1e-3;
        let rate = (velocity(order, at, h) - velocity(order, at, -h)) / (2.0 * h);
        prop_assert!((Vector3::from(ball.a) - rate).norm() < 3e-3, "{:e}", (Vector3::from(ball.a) - rate).norm());
        let power = Vector3::from(ball.tau).dot(&Vector3::from(ball.v));
        prop_assert!((power - Vector3::from(state.tau).dot(&Vector3::from(state.v))).abs() < 1e-12);
        let turns = [TAU, 0.0, -TAU];
        let near = std::array::from_fn(|i| state.q[i] + turns[i] + 0.01);
        let far = order.euler_state_near(&ball, &near).expect("not in lock");
        prop_assert!((0..3).all(|i| (far.q[i] - state.q[i] - turns[i]).abs() < 1e-13), "{far:?}");
    }

    #[test]
    fn the_distance_is_the_volume_of_the_axes_against_its_greatest(
        axes in numbers::<9>(1.0), q in numbers::<4>(4.0),
    ) {
        let direction = |i: usize| Vector3::new(axes[3 * i], axes[3 * i + 1], axes[3 * i + 2]);
        let unit = [0, 1, 2].map(|i| direction(i).normalize());
        prop_assume!((0..3).all(|i| direction(i).norm() > 0.1));
        prop_assume!(unit[0].cross(&unit[1]).norm().min(unit[1].cross(&unit[2]).norm()) > 0.05);
        // A slide among the turns changes nothing.
        let joint = Joint::new("j").axis(Axis::rotation(unit[0])).tx();
        let figure = one(joint.axis(Axis::rotation(unit[1])).axis(Axis::rotation(unit[2])));
        let volume = |middle: f64| {
            let r1 = Rotation3::new(unit[0] * q[0]);
            let r2 = r1 * Rotation3::new(unit[1] * middle);
            unit[0].dot(&(r1 * unit[1]).cross(&(r2 * unit[2]))).abs()
        };
        // The greatest by trying: 4001 middle angles miss it by less than 1.3e-6 of its height.
        let greatest = (0..=4000).map(|k| volume(PI * f64::from(k) / 4000.0)).fold(0.0, f64::max);
        let distance = only(&figure, &q);
        prop_assert!((distance.sin() - volume(q[2]) / greatest).abs() < 2e-6, "{distance}");
        // At so far from here the axes lie in a plane.
        prop_assert!(volume(q[2] + distance).min(volume(q[2] - distance)) < 1e-14);
    }
}

fn one(joint: Joint) -> Figure {
    FigureBuilder::new("f").link(LinkSpec::root("a", joint).mass(1.0)).build().expect("valid")
}

fn only(figure: &Figure, q: &[f64]) -> f64 {
    let all: Vec<_> = figure.gimbal_distances(q).expect("finite").collect();
    assert_eq!((all.len(), all[0].joint), (1, 0));
    all[0].distance
}

#[test]
fn angles_follow_a_motion_through_lock_itself() {
    // The middle angle passes exactly π/2; the others hold. Past it the chosen branch goes on.
    for order in EulerOrder::ALL {
        let mut near = [0.4, 0.0, -0.7];
        for frame in 0..=40 {
            let angles = [0.4, FRAC_PI_2 * f64::from(frame) / 20.0, -0.7];
            near = order.angles_near(&order.rotation(&angles), &near);
            let error = (Vector3::from(near) - Vector3::from(angles)).amax();
            assert!(error < 1e-13, "{order} {frame}: {near:?}");
        }
    }
}

#[test]
fn the_distance_of_a_coordinate_order_is_that_of_the_middle_angle_from_a_quarter_turn() {
    let zyx = one(Joint::new("j").rz().ry().rx());
    let zxz = one(Joint::new("j").rz().rx().rz());
    let against = one(Joint::new("j").axis(Axis::rotation(-Vector3::x())).rz().ry());
    for (middle, tait_bryan) in [
        (0.0, FRAC_PI_2),
        (1.0, FRAC_PI_2 - 1.0),
        (-2.0, 2.0 - FRAC_PI_2),
        (PI, FRAC_PI_2),
        (7.0, FRAC_PI_2 - (7.0 - TAU)),
    ] {
        let q = [0.3, middle, -4.0];
        for figure in [&zyx, &against] {
            assert!((only(figure, &q) - tait_bryan).abs() < 4.0 * EPSILON, "{middle}");
        }
        assert!((only(&zxz, &q) - (FRAC_PI_2 - tait_bryan)).abs() < 4.0 * EPSILON, "{middle}");
    }
    for distance in NEAR {
        let found = only(&zyx, &[0.3, FRAC_PI_2 - distance, 2.0]);
        assert!((found - distance).abs() < 2.0 * EPSILON, "{distance:e}: {found:e}");
    }
}

#[test]
fn joints_without_three_rotations_have_no_distance_and_parallel_axes_none_to_give() {
    let child = |name: &str, joint: Joint| LinkSpec::child(name, "root", joint).mass(1.0);
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("root", Joint::free("root")).mass(1.0))
        .link(child("ball", Joint::ball("ball")))
        .link(child("two", Joint::new("two").rx().ry()))
        .link(child("parallel", Joint::new("parallel").rx().rx().ry()))
        .link(child("six", Joint::new("six").tx().ty().tz().rz().ry().rx()))
        .link(child("four", Joint::new("four").rz().ry().rx().rz()))
        .build()
        .expect("valid");
    let mut q = vec![0.0; figure.layout().nq()];
    figure.neutral(&mut q).expect("nq");
    let found: Vec<(&str, f64)> = figure
        .gimbal_distances(&q)
        .expect("neutral")
        .map(|at| (figure.links()[at.joint].joint().name(), at.distance))
        .collect();
    assert_eq!(found, [("parallel", 0.0), ("six", FRAC_PI_2)]);
    q[20] = f64::NAN;
    assert!(figure.gimbal_distances(&q).is_err() && figure.gimbal_distances(&q[1..]).is_err());
}

#[test]
fn an_order_is_read_from_a_joint_and_names_itself() {
    let zyx = Joint::new("j").rz().ry().rx();
    assert_eq!(EulerOrder::of(zyx.kind()), Some(EulerOrder::Zyx));
    for joint in [
        Joint::ball("j"),
        Joint::new("j").rz().ry(),
        Joint::new("j").rz().ry().rz(),
        Joint::new("j").rz().ry().axis(Axis::rotation(-Vector3::x())),
        Joint::new("j").rz().ry().tx(),
        Joint::new("j").rz().ry().rx().tx(),
    ] {
        assert_eq!(EulerOrder::of(joint.kind()), None);
    }
    let names = EulerOrder::ALL.map(|order| order.to_string());
    assert_eq!(names, ["X-Y-Z", "X-Z-Y", "Y-X-Z", "Y-Z-X", "Z-X-Y", "Z-Y-X"]);
}

#[test]
fn numbers_checked_by_hand() {
    // Upright, Z-Y-X: rates of x, y, z are the angular velocity, in reverse.
    let rates = [3.0, 2.0, 1.0];
    assert_eq!(EulerOrder::Zyx.velocity_map(&[0.0; 3]) * Vector3::from(rates), Vector3::new(1.0, 2.0, 3.0));
    // A quarter turn of flexion (x, last): the axis of z is the link's y, the axis of y is its −z.
    let found = EulerOrder::Zyx.velocity_map(&[0.0, 0.0, FRAC_PI_2]) * Vector3::from(rates);
    assert!((found - Vector3::new(1.0, 3.0, -2.0)).norm() < 1e-15);
    let quarter = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), FRAC_PI_2);
    let angles = EulerOrder::Zyx.angles(&quarter);
    assert!((angles[1] - FRAC_PI_2).abs() < 1e-15 && angles[0] == 0.0 && angles[2] == 0.0, "{angles:?}");
    assert!(EulerOrder::Xzy.angles(&UnitQuaternion::identity()).iter().all(|angle| *angle == 0.0));
}

#[test]
fn lock_and_numbers_that_are_none_are_refused() {
    let state = |middle: f64| EulerState { q: [0.1, middle, 0.2], v: [1.0; 3], a: [0.0; 3], tau: [1.0; 3] };
    let locked = state(FRAC_PI_2);
    let ball = BallState { q: [0.0, 1.0, 0.0, 1.0], v: [1.0; 3], a: [0.0; 3], tau: [1.0; 3] };
    let mut broken = ball;
    broken.tau[1] = f64::NAN;
    let zero = BallState { q: [0.0; 4], ..ball };
    let order = EulerOrder::Zyx;
    let answers = [
        order.ball_state(&locked).expect_err("locked"),
        order.euler_state(&ball).expect_err("locked"),
        order.rates(&locked.q, &Vector3::x()).expect_err("locked"),
        order.ball_state(&state(f64::NAN)).expect_err("a NaN"),
        order.euler_state(&broken).expect_err("a NaN"),
        order.euler_state(&zero).expect_err("no rotation"),
        order.euler_state_near(&ball, &[0.0, f64::INFINITY, 0.0]).expect_err("infinite"),
    ];
    let answers: Vec<String> = answers.iter().map(EulerError::to_string).collect();
    insta::assert_snapshot!(answers.join("\n"));
    // Without moments a locked posture has its angular velocity all the same.
    let still = EulerState { tau: [0.0; 3], ..locked };
    assert_eq!(order.ball_state(&still).map(|ball| ball.tau), Ok([0.0; 3]));
}
