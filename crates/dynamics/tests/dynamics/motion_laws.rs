//! Laws of mechanics that hold for every figure.

use crate::questions::case::derivative;
use crate::support::random::{Random, tree};
use crate::support::{Kernel, largest, relative_error};
use nalgebra::{DVector, Matrix3, Rotation3, Vector3};
use proptest::prelude::*;
use solaris_model::{Figure, human};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// A random tree with a random state.
struct Case {
    kernel: Kernel<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
}

impl Case {
    fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let links = 2 + random.below(8);
        let figure = tree(&mut random, links, 1.0);
        let gravity = random.vector(10.0);
        Self::of(&figure, gravity, &mut random)
    }

    fn human(seed: u64) -> Self {
        Self::of(&person(), GRAVITY, &mut Random::new(seed))
    }

    fn of(figure: &Figure, gravity: Vector3<f64>, random: &mut Random) -> Self {
        let n = figure.layout().nv();
        let (q, v, a) = (random.slice(n, 1.2), random.slice(n, 2.0), random.slice(n, 5.0));
        Self { kernel: Kernel::new(figure, gravity), q, v, a }
    }

    /// Position and velocity a time `t` later, with constant `a`.
    fn after(&self, t: f64) -> (Vec<f64>, Vec<f64>) {
        let q = (0..self.q.len()).map(|k| self.q[k] + self.v[k] * t + self.a[k] * t * t / 2.0).collect();
        (q, self.v.iter().zip(&self.a).map(|(v, a)| v + a * t).collect())
    }
}

fn person() -> Figure {
    human(1.75, 73.0).expect("within range")
}

/// A state or forces of the human seen in a mirror across the plane x = 0: left and right change places, and so do the
/// senses of slides along x and of turns about y and z.
fn mirror(figure: &Figure, values: &[f64]) -> Vec<f64> {
    let layout = figure.layout();
    let names = layout.v_names().iter();
    let other = names.map(|name| {
        let twin = if let Some(rest) = name.strip_prefix("left_") {
            format!("right_{rest}")
        } else {
            name.strip_prefix("right_").map_or_else(|| name.clone(), |rest| format!("left_{rest}"))
        };
        let flips = [".tx", ".ry", ".rz"].iter().any(|axis| name.ends_with(axis));
        let value = values[layout.dof_index(&twin).expect("a twin")];
        if flips { -value } else { value }
    });
    other.collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// The power of the joints is the rate of the energy.
    #[test]
    fn power_is_the_rate_of_energy(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &[]).expect("valid");
        let powers: Vec<f64> = tau.iter().zip(&case.v).map(|(tau, v)| tau * v).collect();
        let states = |t: f64| case.after(t);
        let kernel = &mut Kernel { tree: case.kernel.tree.clone(), workspace: case.kernel.workspace.clone() };
        let rate = derivative(|t| {
            let (q, v) = states(t);
            kernel.kinetic(&q, &v) + kernel.potential(&q)
        });
        let scale: f64 = powers.iter().map(|power| power.abs()).sum::<f64>() + 1.0;
        prop_assert!((powers.iter().sum::<f64>() - rate).abs() < 1e-7 * scale, "{powers:?} {rate}");
    }

    /// What holds the figure up is the slope of the potential energy.
    #[test]
    fn gravity_forces_are_the_slope_of_the_potential(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let tau = case.kernel.bias_forces(&case.q, &vec![0.0; case.v.len()]).expect("valid");
        let scale = largest(&tau) + 1.0;
        for (k, found) in tau.iter().enumerate() {
            let mut q = case.q.clone();
            let slope = derivative(|t| {
                q[k] = case.q[k] + t;
                case.kernel.potential(&q)
            });
            prop_assert!((found - slope).abs() < 1e-9 * scale, "dof {k}: {found} {slope}");
        }
    }

    /// `tau(a) − tau(0) = M·a`.
    #[test]
    fn forces_are_linear_in_accelerations(seed in any::<u64>()) {
        for mut case in [Case::random(seed), Case::human(seed)] {
            let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &[]).expect("valid");
            let bias = case.kernel.bias_forces(&case.q, &case.v).expect("valid");
            let matrix = case.kernel.mass_matrix(&case.q).expect("valid");
            let sum = matrix * DVector::from_vec(case.a.clone()) + DVector::from_vec(bias);
            prop_assert!(relative_error(sum.as_slice(), &tau) < 1e-12);
        }
    }

    /// `½ vᵀ·M·v` is the kinetic energy, and no velocity has less than none.
    #[test]
    fn the_mass_matrix_is_symmetric_and_gives_the_kinetic_energy(seed in any::<u64>()) {
        for mut case in [Case::random(seed), Case::human(seed)] {
            let matrix = case.kernel.mass_matrix(&case.q).expect("valid");
            prop_assert!(matrix == matrix.transpose());
            let v = DVector::from_vec(case.v.clone());
            let energy = case.kernel.kinetic(&case.q, &case.v);
            prop_assert!(energy >= 0.0 && relative_error(&[(&matrix * &v).dot(&v) / 2.0], &[energy]) < 1e-11);
        }
        let mut person = Case::human(seed);
        prop_assert!(person.kernel.mass_matrix(&person.q).expect("valid").cholesky().is_some());
    }

    /// A figure that falls freely, at rest in itself, needs no forces, whatever its speed.
    #[test]
    fn free_fall_needs_no_forces(seed in any::<u64>()) {
        let mut case = Case::human(seed);
        case.v[3..].fill(0.0);
        case.a.fill(0.0);
        case.a[..3].copy_from_slice(GRAVITY.as_slice());
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &[]).expect("valid");
        prop_assert!(largest(&tau) < 1e-11, "{tau:?}");
    }

    /// What the left side does, mirrored, takes of the right side the same forces, mirrored.
    #[test]
    fn a_mirrored_motion_takes_mirrored_forces(seed in any::<u64>()) {
        let mut case = Case::human(seed);
        let figure = person();
        let mirrored = |values: &[f64]| mirror(&figure, values);
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &[]).expect("valid");
        let [q, v, a] = [&case.q, &case.v, &case.a].map(|values| mirrored(values));
        let other = case.kernel.inverse(&q, &v, &a, &[]).expect("valid");
        prop_assert!(relative_error(&other, &mirrored(&tau)) < 1e-13);
        let found = case.kernel.forward(&q, &v, &other, &[]).expect("valid");
        prop_assert!(relative_error(&found, &a) < 1e-9);
    }

    /// Momentum changes at the rate of gravity, the wrenches from outside, and what the root's joint passes on.
    #[test]
    fn momentum_changes_at_the_rate_of_all_that_acts(seed in any::<u64>()) {
        let mut case = Case::human(seed);
        let mut random = Random::new(!seed);
        let external = [random.wrench(21), random.wrench(21)];
        let tau = case.kernel.inverse(&case.q, &case.v, &case.a, &external).expect("valid");
        let weight = GRAVITY * 73.0;
        let center = case.kernel.center_of_mass(&case.q);
        // The root's joint: a force in world axes, then moments about z, the turned y and the twice turned x.
        let force = Vector3::new(tau[0], tau[1], tau[2]);
        let about_z = Rotation3::from_axis_angle(&Vector3::z_axis(), case.q[3]);
        let about_y = about_z * Rotation3::from_axis_angle(&Vector3::y_axis(), case.q[4]);
        let (y, x) = (about_z * Vector3::y(), about_y * Vector3::x());
        let axes = Matrix3::from_rows(&[Vector3::z().transpose(), y.transpose(), x.transpose()]);
        let moment = axes.lu().solve(&Vector3::new(tau[3], tau[4], tau[5])).expect("far from the lock");
        let root = Vector3::new(case.q[0], case.q[1], case.q[2]);
        let forces = weight + force + external[0].1.force + external[1].1.force;
        let moments = center.cross(&weight) + root.cross(&force) + moment
            + external[0].1.moment + external[1].1.moment;
        let states = |t: f64| case.after(t);
        let mut kernel = Kernel { tree: case.kernel.tree.clone(), workspace: case.kernel.workspace.clone() };
        let linear = derivative(|t| { let (q, v) = states(t); kernel.momentum(&q, &v).linear });
        let angular = derivative(|t| { let (q, v) = states(t); kernel.momentum(&q, &v).angular });
        prop_assert!((linear - forces).amax() < 1e-8 * forces.amax().max(100.0), "{linear} {forces}");
        prop_assert!((angular - moments).amax() < 1e-8 * moments.amax().max(100.0), "{angular} {moments}");
    }
}
