//! Configurations: against the matrix exponential, there and back, group laws, and what is refused.

use nalgebra::{Matrix3, Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};
use proptest::prelude::*;
use solaris_model::{ConfigurationError, Figure, FigureBuilder, Joint, LinkSpec, human};
use std::f64::consts::{PI, TAU};

const EPSILON: f64 = f64::EPSILON;

/// One link that can do anything.
fn body() -> Figure {
    FigureBuilder::new("body")
        .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
        .build()
        .expect("valid")
}

/// A free root, a ball joint, and a joint of a turn with limits and a slide without: nq = 13, nv = 11.
fn mixed() -> Figure {
    FigureBuilder::new("mixed")
        .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::ball("hip")).mass(1.0))
        .link(LinkSpec::child("c", "b", Joint::new("knee").rx().limited(-2.5, 0.1).tz()).mass(1.0))
        .build()
        .expect("valid")
}

fn integrate(figure: &Figure, q: &[f64], step: &[f64]) -> Vec<f64> {
    let mut out = vec![f64::NAN; figure.layout().nq()];
    figure.integrate(q, step, &mut out).expect("finite");
    out
}

fn difference(figure: &Figure, from: &[f64], to: &[f64]) -> Vec<f64> {
    let mut out = vec![f64::NAN; figure.layout().nv()];
    figure.difference(from, to, &mut out).expect("finite");
    out
}

fn neutral(figure: &Figure) -> Vec<f64> {
    let mut q = vec![f64::NAN; figure.layout().nq()];
    figure.neutral(&mut q).expect("nq");
    q
}

/// The greatest difference of two slices.
fn off(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn bits(x: &[f64]) -> Vec<u64> {
    x.iter().map(|x| x.to_bits()).collect()
}

/// Place and rotation of a free joint's `q` as a homogeneous matrix, straight from the definition of a quaternion.
fn homogeneous(q: &[f64]) -> Matrix4<f64> {
    let (x, y, z, w) = (q[3], q[4], q[5], q[6]);
    #[rustfmt::skip]
    let matrix = Matrix4::new(
        1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y), q[0],
        2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x), q[1],
        2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y), q[2],
        0.0, 0.0, 0.0, 1.0,
    );
    matrix
}

/// `exp` of a twist as a matrix: its power series, halved first and squared after.
fn exponential(step: &[f64]) -> Matrix4<f64> {
    let mut twist = Matrix4::zeros();
    let turn = Matrix3::new(0.0, -step[5], step[4], step[5], 0.0, -step[3], -step[4], step[3], 0.0);
    twist.fixed_view_mut::<3, 3>(0, 0).copy_from(&turn);
    twist.fixed_view_mut::<3, 1>(0, 3).copy_from_slice(&step[..3]);
    let halvings = turn.norm().log2().ceil().clamp(0.0, 60.0) as i32 + 1;
    twist /= 2.0_f64.powi(halvings);
    let (mut sum, mut term) = (Matrix4::identity(), Matrix4::identity());
    for n in 1..25 {
        term = term * twist / f64::from(n);
        sum += term;
    }
    (0..halvings).for_each(|_| sum *= sum);
    sum
}

fn numbers<const N: usize>(range: f64) -> impl Strategy<Value = [f64; N]> {
    prop::array::uniform::<_, N>(-range..range)
}

/// A configuration of [`mixed`].
fn configuration() -> impl Strategy<Value = Vec<f64>> {
    numbers::<13>(1.0).prop_filter_map("no direction", |mut q| {
        let figure = mixed();
        let long = |q: &[f64]| q.iter().map(|x| x * x).sum::<f64>() > 0.01;
        (long(&q[3..7]) && long(&q[7..11]) && figure.normalize(&mut q).is_ok()).then(|| q.to_vec())
    })
}

/// A vector of this length.
fn along(direction: [f64; 3], length: f64) -> Vector3<f64> {
    Vector3::from(direction).normalize() * length
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    numbers::<3>(1.0).prop_filter("no direction", |d| d.iter().map(|x| x * x).sum::<f64>() > 1e-3)
}

/// Lengths of turns (rad) from nothing to just below half a turn.
const TURNS: [f64; 9] = [0.0, 1e-300, 1e-160, 1e-12, 1e-8, 1e-4, 1.0, PI - 1e-9, PI - 1e-13];

proptest! {
    #[test]
    fn a_step_of_a_free_joint_is_the_matrix_exponential(
        q in configuration(), slide in numbers::<3>(2.0), axis in direction(), angle in 0.0..12.0,
    ) {
        let turn = along(axis, angle);
        let step = [slide[0], slide[1], slide[2], turn.x, turn.y, turn.z];
        let ours = homogeneous(&integrate(&body(), &q[..7], &step));
        let error = (ours - homogeneous(&q[..7]) * exponential(&step)).amax();
        prop_assert!(error < 64.0 * EPSILON, "{error:e}");
    }

    #[test]
    fn small_turns_are_the_matrix_exponential_too(
        q in configuration(), slide in numbers::<3>(2.0), axis in direction(), digits in 0.0..20.0_f64,
    ) {
        let turn = along(axis, 10.0_f64.powf(-digits));
        let step = [slide[0], slide[1], slide[2], turn.x, turn.y, turn.z];
        let ours = homogeneous(&integrate(&body(), &q[..7], &step));
        let error = (ours - homogeneous(&q[..7]) * exponential(&step)).amax();
        prop_assert!(error < 32.0 * EPSILON, "{error:e}");
    }

    #[test]
    fn steps_come_back_from_neutral_with_all_digits(slide in numbers::<3>(2.0), axis in direction()) {
        let (figure, q) = (body(), neutral(&body()));
        for angle in TURNS {
            let turn = along(axis, angle);
            let step = [slide[0], slide[1], slide[2], turn.x, turn.y, turn.z];
            let back = difference(&figure, &q, &integrate(&figure, &q, &step));
            prop_assert!(off(&back[3..], &step[3..]) <= 4.0 * EPSILON * angle, "turn of {angle}: {back:?}");
            prop_assert!(off(&back[..3], &step[..3]) <= 16.0 * EPSILON, "turn of {angle}: {back:?}");
        }
    }

    #[test]
    fn steps_come_back_from_anywhere(q in configuration(), mut step in numbers::<11>(2.0), axes in [direction(), direction()]) {
        let figure = mixed();
        for angle in TURNS {
            step[3..6].copy_from_slice(along(axes[0], angle).as_slice());
            step[6..9].copy_from_slice(along(axes[1], angle).as_slice());
            let back = difference(&figure, &q, &integrate(&figure, &q, &step));
            prop_assert!(off(&back, &step) <= 32.0 * EPSILON, "turn of {angle}: {step:?} {back:?}");
        }
    }

    #[test]
    fn differences_lead_there_and_nowhere_else(from in configuration(), to in configuration()) {
        let figure = mixed();
        let step = difference(&figure, &from, &to);
        prop_assert!(Vector3::new(step[3], step[4], step[5]).norm() <= PI + 4.0 * EPSILON);
        let there = integrate(&figure, &from, &step);
        prop_assert!((homogeneous(&there) - homogeneous(&to)).amax() < 32.0 * EPSILON);
        prop_assert!(off(&difference(&figure, &there, &to), &[0.0; 11]) < 32.0 * EPSILON);
        prop_assert!(off(&there[11..], &to[11..]) < 2.0 * EPSILON);
        // The way back is the same way.
        let back: Vec<f64> = difference(&figure, &to, &from).iter().map(|s| -s).collect();
        prop_assert!(off(&back[3..9], &step[3..9]) < 16.0 * EPSILON);
    }

    #[test]
    fn steps_along_one_line_add_up(q in configuration(), step in numbers::<11>(4.0), part in -1.0..2.0) {
        let figure = mixed();
        let scaled = |by: f64| step.map(|s| s * by);
        let twice = integrate(&figure, &integrate(&figure, &q, &scaled(part)), &scaled(1.0 - part));
        let once = integrate(&figure, &q, &step);
        prop_assert!(off(&difference(&figure, &once, &twice), &[0.0; 11]) < 256.0 * EPSILON);
    }

    #[test]
    fn the_sign_of_a_quaternion_is_irrelevant(from in configuration(), to in configuration()) {
        let figure = mixed();
        let flip = |q: &[f64]| {
            let mut q = q.to_vec();
            q[3..11].iter_mut().for_each(|x| *x = -*x);
            q
        };
        let expected = bits(&difference(&figure, &from, &to));
        prop_assert_eq!(bits(&difference(&figure, &flip(&from), &to)), expected.clone());
        prop_assert_eq!(bits(&difference(&figure, &from, &flip(&to))), expected.clone());
        prop_assert_eq!(bits(&difference(&figure, &flip(&from), &flip(&to))), expected);
    }

    #[test]
    fn nothing_is_exactly_nothing(q in configuration()) {
        let figure = mixed();
        prop_assert_eq!(bits(&integrate(&figure, &q, &[0.0; 11])), bits(&q));
        prop_assert!(difference(&figure, &q, &q).iter().all(|x| *x == 0.0));
        let mut again = q.clone();
        figure.normalize(&mut again).expect("a configuration");
        prop_assert_eq!(bits(&again), bits(&q));
    }

    #[test]
    fn neighbours_differ_by_all_digits_they_hold(q in configuration(), changes in numbers::<4>(1e-9)) {
        let figure = mixed();
        let mut near = q.clone();
        (0..4).for_each(|i| near[7 + i] += changes[i]);
        figure.normalize(&mut near).expect("a configuration");
        // 2·vec(q⁻¹⊗δ), with δ as the numbers hold it.
        let turn = |q: &[f64]| Quaternion::from(Vector4::from_column_slice(&q[7..11]));
        let step = turn(&near) - turn(&q);
        let expected = (turn(&q).conjugate() * step).imag() * 2.0;
        let found = difference(&figure, &q, &near);
        let error = (Vector3::from_column_slice(&found[6..9]) - expected).norm();
        prop_assert!(error < 64.0 * EPSILON * expected.norm(), "{error:e} of {:e}", expected.norm());
    }

    #[test]
    fn the_rate_of_a_quaternion_is_half_itself_times_the_angular_velocity(q in configuration(), v in numbers::<11>(2.0)) {
        let figure = mixed();
        let h = 1e-4;
        let rate = |i: usize| {
            let at = |k: f64| integrate(&figure, &q, &v.map(|v| v * k * h))[i];
            (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
        };
        let omega = Quaternion::from_imag(Vector3::new(v[6], v[7], v[8]));
        let expected = Quaternion::from(Vector4::from_column_slice(&q[7..11])) * omega * 0.5;
        (0..4).for_each(|i| assert!((rate(7 + i) - expected.coords[i]).abs() < 1e-11));
        // The place goes with the velocity along the link's axes, ṗ = R·v.
        let expected = homogeneous(&q).fixed_view::<3, 3>(0, 0) * Vector3::new(v[0], v[1], v[2]);
        (0..3).for_each(|i| assert!((rate(i) - expected[i]).abs() < 1e-11));
        prop_assert!((rate(11) - v[9]).abs() < 1e-11);
    }

    #[test]
    fn interpolation_is_a_part_of_the_difference(from in configuration(), to in configuration(), part in 0.0..1.0) {
        let figure = mixed();
        let mut out = vec![f64::NAN; 13];
        figure.interpolate(&from, &to, part, &mut out).expect("finite");
        let step: Vec<f64> = difference(&figure, &from, &to).iter().map(|s| s * part).collect();
        prop_assert!(off(&difference(&figure, &from, &out), &step) < 32.0 * EPSILON);
        let length = figure.distance(&from, &to).expect("finite");
        let root = difference(&figure, &from, &to).iter().map(|s| s * s).sum::<f64>().sqrt();
        prop_assert!((length - root).abs() < 8.0 * EPSILON * root);
    }
}

#[test]
fn half_a_turn_goes_either_way_and_whole_turns_are_none() {
    let figure = body();
    for start in [[0.0, 0.0, 0.0, 1.0], [0.5, -0.5, 0.5, 0.5], [0.18, -0.36, 0.54, -0.738_647_413_180_653_7]]
    {
        let mut q = neutral(&figure);
        q[3..].copy_from_slice(&start);
        for axis in [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [1.0, 1.0, -1.0], [-0.3, 0.2, 0.9]] {
            let turn = |angle: f64| {
                let turn = along(axis, angle);
                let there = integrate(&figure, &q, &[0.0, 0.0, 0.0, turn.x, turn.y, turn.z]);
                Vector3::from_column_slice(&difference(&figure, &q, &there)[3..])
            };
            let half = turn(PI);
            assert!((half - along(axis, PI)).norm().min((half + along(axis, PI)).norm()) < 1e-15 * 8.0);
            for (angle, shortest) in
                [(TAU, 0.0), (TAU + 0.1, 0.1), (3.5, 3.5 - TAU), (-4.0, TAU - 4.0), (100.0 * TAU - 1.0, -1.0)]
            {
                let error = (turn(angle) - along(axis, shortest)).norm();
                assert!(error < 4.0 * EPSILON * (1.0 + angle.abs()), "{angle}: {error:e}");
            }
        }
    }
}

#[test]
fn at_exactly_half_a_turn_the_choice_is_the_same_for_all_signs() {
    let figure = body();
    for axis in [[1.0, 0.0, 0.0], [0.6, -0.8, 0.0], [-0.6, 0.0, 0.8]] {
        let mut all = Vec::new();
        for (sign, other) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let from = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, sign];
            let to = [0.0, 0.0, 0.0, other * axis[0], other * axis[1], other * axis[2], 0.0];
            all.push(bits(&difference(&figure, &from, &to).iter().map(|x| x + 0.0).collect::<Vec<_>>()));
        }
        assert!(all.iter().all(|one| *one == all[0]), "{axis:?}");
        let length =
            f64::from_bits(all[0][3]).hypot(f64::from_bits(all[0][4])).hypot(f64::from_bits(all[0][5]));
        assert!((length - PI).abs() < 1e-15);
    }
}

#[test]
fn far_away_nothing_is_lost_but_what_the_place_cannot_hold() {
    let figure = body();
    for far in [1e5, 1e12, 1e200] {
        let mut q = neutral(&figure);
        figure.integrate(&neutral(&figure), &[far, -far, 2.0 * far, 0.3, 1.2, -0.4], &mut q).expect("finite");
        let step = [far, 0.5 * far, -far, 0.2, -2.0, 0.7];
        let back = difference(&figure, &q, &integrate(&figure, &q, &step));
        assert!(off(&back[..3], &step[..3]) < 32.0 * EPSILON * far, "{back:?}");
        assert!(off(&back[3..], &step[3..]) < 8.0 * EPSILON, "{back:?}");
    }
}

#[test]
fn a_million_steps_keep_the_length_and_the_way() {
    let figure = body();
    let (mut q, mut next) = (neutral(&figure), neutral(&figure));
    let (steps, turn) = (1_000_000, Vector3::new(0.3, -0.5, 0.2));
    let step = [0.0, 0.0, 0.0, turn.x, turn.y, turn.z];
    for _ in 0..steps {
        figure.integrate(&q, &step, &mut next).expect("finite");
        q.copy_from_slice(&next);
    }
    assert!(figure.is_normalized(&q, 4.0 * EPSILON));
    let angle = (turn.norm() * f64::from(steps)).rem_euclid(TAU);
    let expected = UnitQuaternion::new(along(turn.into(), angle));
    let found = UnitQuaternion::new_unchecked(Quaternion::from(Vector4::from_column_slice(&q[3..])));
    assert!(found.angle_to(&expected) < 1e-9, "{:e}", found.angle_to(&expected));
}

#[test]
fn quaternions_of_any_length_are_normalised() {
    let figure = body();
    for length in [1e-320, 1e-200, 0.5, 1.0 + 1e-9, 7.0, 1e200, 1e308] {
        let mut q = neutral(&figure);
        q[3..].copy_from_slice(&[0.6 * length, 0.0, 0.0, -0.8 * length]);
        assert!(!figure.is_normalized(&q, 1e-10));
        let as_is = integrate(&figure, &q, &[0.0; 6]);
        figure.normalize(&mut q).expect("a direction");
        let tolerance = if length < 1e-300 { 1e-3 } else { 4.0 * EPSILON };
        assert!(off(&q, &[0.0, 0.0, 0.0, 0.6, 0.0, 0.0, -0.8]) < tolerance, "{q:?}");
        assert!(off(&q, &as_is) < 4.0 * EPSILON);
        assert!(figure.is_normalized(&q, 4.0 * EPSILON));
    }
}

/// A small generator of numbers uniform in [0, 1): Steele, Lea, Flood (2014), `SplitMix64`.
fn source(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / 2.0_f64.powi(53)
    }
}

#[test]
fn random_configurations_fill_their_ranges_evenly() {
    let figure = mixed();
    let (mut next, mut q, count) = (source(1), [0.0; 13], 40_000);
    let (mut least, mut most, mut second) = ([f64::MAX; 13], [f64::MIN; 13], nalgebra::Matrix4::zeros());
    let mut small_turns = 0;
    for _ in 0..count {
        figure.random(&mut q, &mut next).expect("a source");
        assert!(figure.is_normalized(&q, 4.0 * EPSILON));
        for i in 0..13 {
            least[i] = least[i].min(q[i]);
            most[i] = most[i].max(q[i]);
        }
        let turn = Vector4::from_column_slice(&q[7..11]);
        second += turn * turn.transpose() / f64::from(count);
        small_turns += i32::from(turn.w.abs() > (PI / 4.0).cos());
    }
    let (lower, upper) = ([-1.0, -2.5, -1.0], [1.0, 0.1, 1.0]);
    for (place, i) in [0, 11, 12].into_iter().enumerate() {
        assert!(least[i] >= lower[place] && least[i] < lower[place] + 1e-3, "{i}: {}", least[i]);
        assert!(most[i] <= upper[place] && most[i] > upper[place] - 1e-3, "{i}: {}", most[i]);
    }
    // Uniform on the sphere: second moments 1/4. A share (θ − sin θ)/π of all rotations turns by at most θ = π/2.
    assert!((second - Matrix4::identity() / 4.0).amax() < 5.0 / f64::from(count).sqrt() / 4.0, "{second}");
    let share = (PI / 2.0 - 1.0) / PI;
    assert!((f64::from(small_turns) / f64::from(count) - share).abs() < 0.01, "{small_turns}");
}

#[test]
fn limits_on_one_side_or_without_room_are_respected() {
    let infinity = f64::INFINITY;
    let joint =
        Joint::new("j").rx().limited(1.0, 1.0).ry().limited(5.0, infinity).rz().limited(-infinity, -9.0);
    let joint = joint.tx().limited(-1.5e308, 1.5e308).ty().limited(-infinity, infinity);
    let figure =
        FigureBuilder::new("f").link(LinkSpec::root("a", joint).mass(1.0)).build().expect("numbers in order");
    let (mut next, mut q) = (source(7), [0.0; 5]);
    for _ in 0..1000 {
        figure.random(&mut q, &mut next).expect("a source");
        assert!(q[0].to_bits() == 1.0_f64.to_bits() && (5.0..5.0 + TAU).contains(&q[1]));
        assert!(q[2] <= -9.0 && q[2] >= -9.0 - TAU && q[3].is_finite() && q[4].abs() <= 1.0);
    }
}

#[test]
fn the_neutral_human_stands_at_zero() {
    let figure = human(1.75, 73.0).expect("an ordinary human");
    assert!(neutral(&figure).iter().all(|x| *x == 0.0));
    assert_eq!(neutral(&mixed())[..11], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn what_is_no_configuration_is_refused_by_name() {
    let figure = mixed();
    let (good, step) = (neutral(&figure), [0.1; 11]);
    let with = |i: usize, value: f64| {
        let mut q = good.clone();
        q[i] = value;
        q
    };
    let mut out = [0.0; 13];
    let mut attempt =
        |q: &[f64], step: &[f64]| figure.integrate(q, step, &mut out).expect_err("no configuration");
    let (mut far, mut nan_step) = ([0.0; 11], [0.0; 11]);
    (far[0], nan_step[7]) = (1e308, f64::NAN);
    let mut answers = vec![
        attempt(&good[1..], &step),
        attempt(&good, &step[..10]),
        attempt(&with(11, f64::NAN), &step),
        attempt(&with(8, f64::INFINITY), &step),
        attempt(&with(10, 0.0), &step),
        attempt(&good, &nan_step),
        attempt(&with(0, 1e308), &far),
    ];
    let mut short = [0.0; 3];
    answers.push(figure.integrate(&good, &step, &mut short).expect_err("too short"));
    answers.push(figure.difference(&good, &with(6, 0.0), &mut [0.0; 11]).expect_err("no rotation"));
    answers.push(figure.difference(&good, &good, &mut short).expect_err("too short"));
    answers
        .push(figure.difference(&with(12, -1e308), &with(12, 1e308), &mut [0.0; 11]).expect_err("too far"));
    answers.push(figure.distance(&with(12, -1e308), &with(12, 1e308)).expect_err("too far"));
    answers.push(figure.interpolate(&good, &good, f64::NAN, &mut [0.0; 13]).expect_err("no part"));
    answers.push(figure.neutral(&mut short).expect_err("too short"));
    answers.push(figure.normalize(&mut with(10, 0.0)).expect_err("no rotation"));
    answers.push(figure.random(&mut [0.0; 13], || 1.0).expect_err("not below 1"));
    let answers: Vec<String> = answers.iter().map(ConfigurationError::to_string).collect();
    insta::assert_snapshot!(answers.join("\n"));
    assert!(!figure.is_normalized(&short, 1.0) && !figure.is_normalized(&with(0, f64::NAN), 1.0));
}
