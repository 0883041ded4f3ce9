//! Sampling of ball and free joints: bodies that turn in closed form.

use nalgebra::{UnitQuaternion, Vector3};
use solaris_model::{
    EulerOrder, Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionError, MotionInfo, Trajectory,
};

/// What a trajectory does at a time.
struct State {
    place: [Vector3<f64>; 3],
    turn: UnitQuaternion<f64>,
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
}

/// A body with an axis of symmetry that no moment acts on, thrown: `R = exp(p·t·L)·exp(s·t·z)` turns about the axis of
/// its angular momentum `L` at `p` (rad/s) and about its own axis z at `s` (rad/s).
#[derive(Clone, Copy)]
struct Top {
    precession: f64,
    spin: f64,
}

impl Top {
    fn at(&self, t: f64) -> State {
        let (axis, place) = (Vector3::new(0.36, 0.48, 0.8), Vector3::new(1.0, 2.0, -1.0));
        let (throw, gravity) = (Vector3::new(0.5, 4.0, 1.0), Vector3::new(0.0, -9.80665, 0.0));
        let own = UnitQuaternion::new(Vector3::z() * (self.spin * t));
        // ω = exp(−s·t·z)·p·L + s·z along the body's axes, and ω̇ = −s·z × exp(−s·t·z)·p·L.
        let tilted = own.inverse() * axis * self.precession;
        State {
            place: [place + throw * t + gravity * (t * t / 2.0), throw + gravity * t, gravity],
            turn: UnitQuaternion::new(axis * (self.precession * t)) * own,
            velocity: tilted + Vector3::z() * self.spin,
            acceleration: -(Vector3::z() * self.spin).cross(&tilted),
        }
    }
}

/// A free root and a ball joint that follow a [`Top`], and a hinge; `change` makes other quaternions of the same rotation.
struct Thrown<F> {
    top: Top,
    change: F,
}

impl<F: Fn(f64) -> f64> Trajectory for Thrown<F> {
    fn duration(&self) -> f64 {
        1.0
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        let state = self.top.at(t);
        let turn = state.turn.coords * (self.change)(t);
        q[..3].copy_from_slice(state.place[0].as_slice());
        q[3..7].copy_from_slice(turn.as_slice());
        q[7..11].copy_from_slice(turn.as_slice());
        q[11] = (3.0 * t).sin();
    }
}

fn figure() -> Figure {
    FigureBuilder::new("thrown")
        .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::ball("hip")).mass(1.0))
        .link(LinkSpec::child("c", "b", Joint::new("knee").rx()).mass(1.0))
        .build()
        .expect("valid")
}

fn sample(trajectory: &impl Trajectory, rate: f64) -> Result<Motion, MotionError> {
    let figure = figure();
    Motion::sample(&figure, trajectory, MotionInfo::on_earth(&figure, rate))
}

fn vector(x: &[f64]) -> Vector3<f64> {
    Vector3::new(x[0], x[1], x[2])
}

#[test]
fn a_thrown_top_has_its_closed_form() {
    let top = Top { precession: 5.0, spin: -7.0 };
    for rate in [7.0, 30.0, 120.0, 1000.0] {
        let motion = sample(&Thrown { top, change: |_| 1.0 }, rate).expect("finite");
        for i in 0..motion.len() {
            let (state, v, a) = (top.at(motion.time()[i]), motion.v(i), motion.a(i));
            let near = |found: Vector3<f64>, exact: Vector3<f64>, bound: f64, what: &str| {
                let error = (found - exact).norm();
                assert!(error < bound, "{what} at {rate}/s, frame {i}: {error:e}");
            };
            // Steps of 1/120 s: truncation (|ω|·h)⁶·|ω|/140, twice that order for ω̇; the place is a parabola, which has none.
            near(vector(&v[3..]), state.velocity, 2e-7, "ω of the root");
            near(vector(&a[3..]), state.acceleration, 1e-6, "ω̇ of the root");
            near(vector(&v[6..]), state.velocity, 2e-7, "ω of the ball");
            near(vector(&a[6..]), state.acceleration, 1e-6, "ω̇ of the ball");
            let inwards = state.turn.inverse();
            let linear = inwards * state.place[1];
            near(vector(v), linear, 1e-11, "v");
            near(vector(a), inwards * state.place[2] - state.velocity.cross(&linear), 2e-6, "v̇");
            assert!((v[9] - 3.0 * (3.0 * motion.time()[i]).cos()).abs() < 1e-7, "the hinge");
        }
    }
}

#[test]
fn a_hinge_beside_them_has_the_plain_differences_to_the_bit() {
    let trajectory = Thrown { top: Top { precession: 5.0, spin: -7.0 }, change: |_| 1.0 };
    let motion = sample(&trajectory, 120.0).expect("finite");
    let first = [-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0].map(|weight| weight / 60.0);
    let second = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0].map(|weight| weight / 180.0);
    let h = 1.0 / 120.0;
    for i in 0..motion.len() {
        let values: [f64; 7] = std::array::from_fn(|k| {
            let mut q = [0.0; 12];
            trajectory.configuration((i as f64 + k as f64 - 3.0) * h, &mut q);
            q[11]
        });
        let sum = |weights: &[f64; 7]| (0..7).map(|k| weights[k] * (values[k] - values[3])).sum::<f64>();
        assert_eq!(motion.v(i)[9].to_bits(), (sum(&first) / h).to_bits(), "frame {i}");
        assert_eq!(motion.a(i)[9].to_bits(), (sum(&second) / (h * h)).to_bits(), "frame {i}");
    }
}

#[test]
fn an_even_turn_is_exact_however_fast_below_a_third_of_a_turn_a_step() {
    // 118° a step of 1/120 s, past half a turn within the formula.
    let speed = 118.0_f64.to_radians() * 120.0;
    let motion = sample(&Thrown { top: Top { precession: speed, spin: 0.0 }, change: |_| 1.0 }, 120.0)
        .expect("finite");
    for i in 0..motion.len() {
        let velocity = vector(&motion.v(i)[6..]);
        assert!((velocity - Vector3::new(0.36, 0.48, 0.8) * speed).norm() < 1e-9, "{velocity}");
        assert!(vector(&motion.a(i)[6..]).norm() < 1e-6);
    }
}

#[test]
fn signs_and_lengths_of_quaternions_do_not_matter() {
    let top = Top { precession: 5.0, spin: -7.0 };
    let plain = sample(&Thrown { top, change: |_| 1.0 }, 60.0).expect("finite");
    let flip = |t: f64| if (t * 997.0).sin() > 0.0 { 1.0 } else { -1.0 };
    let flipped = sample(&Thrown { top, change: flip }, 60.0).expect("finite");
    let scaled = sample(&Thrown { top, change: |t: f64| 3.0 * flip(t) + t }, 60.0).expect("finite");
    for i in 0..plain.len() {
        let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        // A change of all signs at once changes no product's size.
        assert_eq!(
            (bits(plain.v(i)), bits(plain.a(i))),
            (bits(flipped.v(i)), bits(flipped.a(i))),
            "frame {i}"
        );
        let error = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error(plain.v(i), scaled.v(i)) < 1e-12 && error(plain.a(i), scaled.a(i)) < 1e-9);
        assert!(figure().is_normalized(scaled.q(i), 4.0 * f64::EPSILON));
        let turn = |i: usize| scaled.q(i)[7..11].to_vec();
        let dot: f64 = if i == 0 { 1.0 } else { turn(i).iter().zip(turn(i - 1)).map(|(a, b)| a * b).sum() };
        assert!(dot > 0.0, "the written sign goes on from frame to frame");
    }
}

/// A posture that is held, its quaternions with changing signs.
struct Still;

impl Trajectory for Still {
    fn duration(&self) -> f64 {
        0.5
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        let sign = (300.0 * t).cos().signum();
        let turn = [0.1, -0.7, 0.3, 0.55].map(|x| sign * x);
        q[..3].copy_from_slice(&[0.1, 1.0 / 3.0, -7.7]);
        q[3..7].copy_from_slice(&turn);
        q[7..11].copy_from_slice(&turn);
        q[11] = 0.3;
    }
}

#[test]
fn rest_is_exactly_rest() {
    let motion = sample(&Still, 50.0).expect("finite");
    for i in 0..motion.len() {
        assert!(motion.v(i).iter().chain(motion.a(i)).all(|x| *x == 0.0), "frame {i}");
    }
}

#[test]
fn a_ball_joint_and_its_triple_have_the_same_samples() {
    /// Three angles, or the quaternion of the rotation that they make.
    struct Swing(bool);
    impl Trajectory for Swing {
        fn duration(&self) -> f64 {
            1.0
        }

        fn configuration(&self, t: f64, q: &mut [f64]) {
            let angles = [0.8 * (2.0 * t).sin(), 1.1 * (3.0 * t).cos(), 0.5 + t];
            if self.0 {
                q.copy_from_slice(EulerOrder::Zyx.rotation(&angles).coords.as_slice());
            } else {
                q.copy_from_slice(&angles);
            }
        }
    }
    let motions = [Joint::ball("j"), Joint::new("j").rz().ry().rx()].map(|joint| {
        let is_ball = joint.kind().nq() == 4;
        let figure =
            FigureBuilder::new("f").link(LinkSpec::root("a", joint).mass(1.0)).build().expect("valid");
        Motion::sample(&figure, &Swing(is_ball), MotionInfo::on_earth(&figure, 60.0)).expect("finite")
    });
    let [ball, triple] = motions;
    for i in 0..ball.len() {
        let angles: &[f64; 3] = triple.q(i).try_into().expect("three angles");
        let rates: &[f64; 3] = triple.v(i).try_into().expect("three rates");
        let map = EulerOrder::Zyx.velocity_map(angles);
        let (v, a) = (vector(triple.v(i)), vector(triple.a(i)));
        assert!((map * v - vector(ball.v(i))).norm() < 1e-8, "frame {i}");
        let acceleration = map * a + EulerOrder::Zyx.velocity_map_rate(angles, rates) * v;
        assert!((acceleration - vector(ball.a(i))).norm() < 1e-7, "frame {i}");
    }
}

#[test]
fn quaternions_that_are_none_are_refused_where_they_are() {
    let top = Top { precession: 1.0, spin: 1.0 };
    let answer =
        |change: fn(f64) -> f64| sample(&Thrown { top, change }, 10.0).expect_err("none").to_string();
    let mut answers = vec![
        answer(|t| if t > 0.45 && t < 0.55 { 0.0 } else { 1.0 }),
        answer(|t| if t > 0.45 && t < 0.55 { f64::NAN } else { 1.0 }),
    ];
    let figure = figure();
    let mut q = vec![0.0; 12];
    figure.neutral(&mut q).expect("nq");
    let new = |q: &[f64]| {
        let columns = [q.to_vec(), vec![0.0; 10], vec![0.0; 10]];
        Motion::new(&figure, MotionInfo::on_earth(&figure, 10.0), vec![0.25], columns)
    };
    q[10] = 1.000_5;
    assert_eq!(new(&q).expect("near enough").q(0), q);
    q[10] = 0.9;
    answers.push(new(&q).expect_err("too short").to_string());
    q[10] = 0.0;
    answers.push(new(&q).expect_err("zero").to_string());
    insta::assert_snapshot!(answers.join("\n"));
}
