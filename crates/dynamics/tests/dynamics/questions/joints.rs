//! Ball and free joints: against the same figures with one-axis joints, laws of mechanics and closed forms.

use crate::questions::case::{Case, derivative};
use crate::support::random::{Joints, Random, random_configuration};
use crate::support::{Kernel, relative_error};
use nalgebra::{DMatrix, Matrix3, UnitQuaternion, Vector3};
use proptest::prelude::*;
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// The power of the joints and of the wrenches is the rate of the energy.
    #[test]
    fn power_is_the_rate_of_energy(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &case.external).expect("valid");
        case.kernel.velocities(&case.q, &case.v);
        let ws = &case.kernel.workspace;
        let wrenches = case.external.iter().map(|(link, wrench)| {
            let (pose, twist) = (ws.pose(*link), ws.velocity(*link));
            wrench.force.dot(&twist.linear) + wrench.moment_about(&pose.translation).dot(&twist.angular)
        });
        let powers: Vec<f64> = tau.iter().zip(&case.v).map(|(tau, v)| tau * v).chain(wrenches).collect();
        let rate = derivative(|t| {
            let (q, v) = case.after(t);
            case.kernel.kinetic(&q, &v) + case.kernel.potential(&q)
        });
        let scale: f64 = powers.iter().map(|power| power.abs()).sum::<f64>() + 1.0;
        prop_assert!((powers.iter().sum::<f64>() - rate).abs() < 1e-8 * scale, "{powers:?} {rate}");
    }

    /// `½ vᵀ·M·v` is the kinetic energy, `M` is symmetric and `M·a` what `a` adds to the forces.
    #[test]
    fn the_mass_matrix_is_that_of_energy_and_forces(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let m = case.kernel.mass_matrix(&case.q).expect("valid");
        prop_assert!((&m - m.transpose()).amax() <= 0.0, "symmetric to the last bit");
        let mut armed = Case::with(Joints::EveryArmed, seed);
        let regular = armed.kernel.mass_matrix(&armed.q).expect("valid");
        prop_assert!(regular.is_empty() || regular.cholesky().is_some(), "positive definite");
        let v = nalgebra::DVector::from_row_slice(&case.v);
        let energy = case.kernel.kinetic(&case.q, &case.v);
        prop_assert!((v.dot(&(&m * &v)) / 2.0 - energy).abs() < 1e-12 * energy.max(1.0));
        let with = case.kernel.inverse(&case.q, &case.v, &case.a, &[]).expect("valid");
        let without = case.kernel.bias_forces(&case.q, &case.v).expect("valid");
        let added: Vec<f64> = with.iter().zip(&without).map(|(a, b)| a - b).collect();
        let product = &m * nalgebra::DVector::from_row_slice(&case.a);
        let scale = with.iter().chain(&without).fold(1.0_f64, |s, x| s.max(x.abs()));
        prop_assert!(added.iter().zip(product.iter()).all(|(a, b)| (a - b).abs() < 1e-12 * scale));
    }

    /// Forward dynamics undoes inverse dynamics, whatever the joints.
    #[test]
    fn forward_dynamics_undoes_inverse_dynamics(seed in any::<u64>()) {
        let mut case = Case::with(Joints::EveryArmed, seed);
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &case.external).expect("valid");
        let a = case.kernel.forward(&case.q, &case.v, &tau, &case.external).expect("valid");
        prop_assert!(relative_error(&a, &case.a) < 1e-10);
    }

    /// A figure of ball joints moves as the same figure of Z-Y-X triples, and the triples' torques are `Eᵀ` times the ball's
    /// (with `ω = E·θ̇` along the link's axes). Where the root is a free joint, it has three translations before its triple.
    #[test]
    fn a_ball_joint_is_a_triple(seed in any::<u64>(), afloat in any::<bool>()) {
        let mut random = Random::new(seed);
        let [balls, triples] = twins(&mut random, afloat);
        let gravity = random.vector(10.0);
        let mut ball = Kernel::<f64>::new(&balls, gravity);
        let mut triple = Kernel::<f64>::new(&triples, gravity);
        let n = triples.layout().nv();
        let (angles, rates, second) = (random.slice(n, 1.2), random.slice(n, 2.0), random.slice(n, 5.0));
        let wrenches = [random.wrench(3), random.wrench(3)];

        let (mut q, mut v, mut a) = (Vec::new(), Vec::new(), Vec::new());
        let mut map = DMatrix::<f64>::zeros(n, n);
        for (i, joint) in triples.layout().joints().iter().enumerate() {
            let at = joint.v + joint.nv - 3;
            let theta = three(&angles[at..]);
            let (e, slope) = (rate_matrix(&theta), derivative(|t| rate_matrix(&(theta + three(&rates[at..]) * t))));
            let turn = rotation(&theta);
            if i == 0 && afloat {
                // Position and velocity of the origin, then along the link's axes: u = Rᵀ·ẋ, u̇ = Rᵀ·ẍ − ω × u.
                q.extend(&angles[..3]);
                let u = turn.inverse() * three(&rates[..3]);
                v.extend(u.iter());
                a.extend((turn.inverse() * three(&second[..3]) - (e * three(&rates[at..])).cross(&u)).iter());
                map.view_mut((0, 0), (3, 3)).copy_from(turn.inverse().to_rotation_matrix().matrix());
            }
            q.extend(turn.coords.iter());
            v.extend((e * three(&rates[at..])).iter());
            a.extend((e * three(&second[at..]) + slope * three(&rates[at..])).iter());
            map.view_mut((at, at), (3, 3)).copy_from(&e);
        }
        let torques = ball.inverse(&q, &v, &a, &wrenches).expect("valid");
        let mapped = map.transpose() * nalgebra::DVector::from_vec(torques);
        let expected = triple.inverse(&angles, &rates, &second, &wrenches).expect("valid");
        let error = relative_error(mapped.as_slice(), &expected);
        prop_assert!(error < 1e-10, "{error:e}");
        prop_assert!((ball.kinetic(&q, &v) - triple.kinetic(&angles, &rates)).abs() < 1e-11);
        prop_assert!((ball.potential(&q) - triple.potential(&angles)).abs() < 1e-11);
    }
}

/// Three links in a chain, joined by ball joints and by Z-Y-X triples; `afloat`, the root flies.
fn twins(random: &mut Random, afloat: bool) -> [Figure; 2] {
    let shapes: Vec<_> = (0..3)
        .map(|_| {
            let root = Matrix3::from_fn(|_, _| random.unit()) * 0.2;
            let second = root * root.transpose();
            (random.placement(), random.vector(0.3), Matrix3::identity() * second.trace() - second)
        })
        .collect();
    [true, false].map(|ball| {
        let mut builder = FigureBuilder::new("chain");
        for (i, (placement, com, inertia)) in shapes.iter().enumerate() {
            let name = format!("j{i}");
            let flies = afloat && i == 0;
            let joint = match (ball, flies) {
                (true, false) => Joint::ball(name),
                (true, true) => Joint::free(name),
                (false, false) => Joint::new(name).rz().ry().rx(),
                (false, true) => Joint::new(name).tx().ty().tz().rz().ry().rx(),
            };
            let joint = joint.placed(*placement);
            let link = match i {
                0 => LinkSpec::root("l0", joint),
                _ => LinkSpec::child(format!("l{i}"), format!("l{}", i - 1), joint),
            };
            let inertia = (inertia + inertia.transpose()) / 2.0;
            builder = builder.link(link.mass(1.5).com(*com).inertia(Inertia::Tensor(inertia)));
        }
        builder.build().expect("a valid figure")
    })
}

fn three(values: &[f64]) -> Vector3<f64> {
    Vector3::new(values[0], values[1], values[2])
}

/// `R = R_z·R_y·R_x`
fn rotation(theta: &Vector3<f64>) -> UnitQuaternion<f64> {
    let turn = |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle);
    turn(Vector3::z(), theta.x) * turn(Vector3::y(), theta.y) * turn(Vector3::x(), theta.z)
}

/// `E` of `ω = E·θ̇` along the axes of the turned frame.
fn rate_matrix(theta: &Vector3<f64>) -> Matrix3<f64> {
    let after = |axis: Vector3<f64>, angle: f64| UnitQuaternion::from_scaled_axis(axis * angle).inverse();
    let (y, x) = (after(Vector3::y(), theta.y), after(Vector3::x(), theta.z));
    Matrix3::from_columns(&[x * (y * Vector3::z()), x * Vector3::y(), Vector3::x()])
}

/// A body afloat without forces: its origin is the centre of mass, and Euler's equations hold along its axes.
#[test]
fn a_free_body_obeys_euler_s_equations() {
    let moments = Vector3::new(0.3, 0.5, 0.7);
    let body = LinkSpec::root("body", Joint::free("air"))
        .mass(2.0)
        .inertia(Inertia::Tensor(Matrix3::from_diagonal(&moments)));
    let figure = FigureBuilder::new("stone").link(body).build().expect("a valid figure");
    let gravity = Vector3::new(1.0, -9.0, 2.0);
    let mut kernel = Kernel::<f64>::new(&figure, gravity);
    let q = random_configuration(&mut Random::new(2), &figure);
    let (u, w) = (Vector3::new(0.4, -0.6, 1.1), Vector3::new(1.0, 2.0, -3.0));
    let v: Vec<f64> = u.iter().chain(w.iter()).copied().collect();
    let found = kernel.forward(&q, &v, &[0.0; 6], &[]).expect("valid");
    let spin = -w.cross(&moments.component_mul(&w)).component_div(&moments);
    kernel.place(&q);
    // u̇ = Rᵀ·g − ω × u
    let linear = kernel.workspace.pose(0).rotation.transpose() * gravity - w.cross(&u);
    let expected: Vec<f64> = linear.iter().chain(spin.iter()).copied().collect();
    assert!(relative_error(&found, &expected) < 1e-14, "{found:?} {expected:?}");
    assert!(relative_error(&kernel.inverse(&q, &v, &expected, &[]).expect("valid"), &[0.0; 6]) < 1e-13);
}

/// A top on a ball joint, spinning about its axis at 300 rad/s: slow precession at m·g·l/(C·ω), from the forces alone.
#[test]
fn a_fast_top_precesses() {
    let (mass, arm, axial, spin, gravity) = (0.5, 0.04, 2e-4, 300.0, 9.81);
    let top = LinkSpec::root("top", Joint::ball("tip"))
        .mass(mass)
        .com(Vector3::new(0.0, 0.0, arm))
        .inertia(Inertia::Tensor(Matrix3::from_diagonal(&Vector3::new(3e-4, 3e-4, axial))));
    let figure = FigureBuilder::new("top").link(top).build().expect("a valid figure");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::new(0.0, 0.0, -gravity));
    // Its axis lies level along x; steady precession about z at Ω turns it with ω = spin·x + Ω·z and asks for no torque where
    // Ω·C·spin = m·g·l: then ω̇ = Ω·z × ω, which stands still along the axes of the precessing frame.
    let rate = mass * gravity * arm / (axial * spin);
    let turn = UnitQuaternion::from_scaled_axis(Vector3::y() * std::f64::consts::FRAC_PI_2);
    let (world, drift) = (Vector3::new(spin, 0.0, rate), Vector3::z() * rate);
    let (w, wd) = (turn.inverse() * world, turn.inverse() * drift.cross(&world));
    let found = kernel.forward(turn.coords.as_slice(), w.as_slice(), &[0.0; 3], &[]).expect("valid");
    assert!((Vector3::from_column_slice(&found) - wd).amax() < 1e-10 * spin * rate, "{found:?} {wd}");
}
