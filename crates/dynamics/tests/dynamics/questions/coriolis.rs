//! The Coriolis matrix, against bias forces, the rate of the mass matrix and Christoffel's symbols.

use crate::questions::case::{Case, derivative, difference, matrix, unit};
use crate::support::random::Joints;
use crate::support::reference::{figure, models};
use crate::support::{Kernel, relative_error};
use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use solaris_dynamics::{coriolis_matrix, gravity_torques};

impl Case {
    fn coriolis(&mut self) -> DMatrix<f64> {
        let mut c = matrix(self.nv(), self.nv());
        let Kernel { tree, workspace } = &mut self.kernel;
        coriolis_matrix(tree, workspace, &self.q, &self.v, &mut c).expect("valid");
        c
    }

    fn gravity_torques(&mut self) -> DVector<f64> {
        let mut tau = vec![f64::NAN; self.nv()];
        let Kernel { tree, workspace } = &mut self.kernel;
        gravity_torques(tree, workspace, &self.q, &mut tau).expect("valid");
        DVector::from_vec(tau)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn the_matrix_times_the_velocity_is_the_bias_without_gravity(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let sum = case.coriolis() * DVector::from_row_slice(&case.v) + case.gravity_torques();
        let bias = DVector::from_vec(case.kernel.bias_forces(&case.q, &case.v).expect("valid"));
        let error = difference(&sum, &bias, 1.0);
        prop_assert!(error < 1e-12, "{error:e}");
    }

    /// `Ṁ = C + Cᵀ`: then `Ṁ − 2·C` is skew.
    #[test]
    fn the_matrix_and_its_transpose_are_the_rate_of_the_mass_matrix(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let c = case.coriolis();
        let rate = derivative(|t| {
            let (q, _) = case.after(t);
            case.kernel.mass_matrix(&q).expect("valid")
        });
        let error = difference(&(&c + c.transpose()), &rate, 1.0);
        prop_assert!(error < 1e-8, "{error:e}");
    }

    /// With one-axis joints, `C_ij = Σ_k ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i)·v_k`.
    #[test]
    fn the_matrix_is_that_of_christoffel_s_symbols(seed in any::<u64>()) {
        let mut case = Case::with(Joints::OneAxis, seed);
        let (n, c) = (case.nv(), case.coriolis());
        let slopes: Vec<DMatrix<f64>> = (0..n)
            .map(|k| derivative(|t| {
                let q = case.moved(&unit(n, k), t);
                case.kernel.mass_matrix(&q).expect("valid")
            }))
            .collect();
        let expected = DMatrix::from_fn(n, n, |i, j| {
            let symbol = |k: usize| slopes[k][(i, j)] + slopes[j][(i, k)] - slopes[i][(j, k)];
            (0..n).map(|k| symbol(k) * case.v[k] / 2.0).sum()
        });
        let error = difference(&c, &expected, 1.0);
        prop_assert!(error < 1e-8, "{error:e}");
    }

    /// Gravity's torques are the slope of the potential energy along the tangent.
    #[test]
    fn gravity_torques_are_the_slope_of_the_potential(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let torques = case.gravity_torques();
        let slopes: Vec<f64> = (0..case.nv())
            .map(|k| derivative(|t| {
                let q = case.moved(&unit(case.nv(), k), t);
                case.kernel.potential(&q)
            }))
            .collect();
        let scale = DVector::from_vec(vec![case.figure.mass()]);
        let error = difference(&torques, &DVector::from_vec(slopes), scale[0]);
        prop_assert!(error < 1e-9, "{error:e}");
    }
}

/// The whole human, whose numbers other tests hold against another engine.
#[test]
fn the_human_s_matrix_gives_its_bias() {
    let figure = solaris_model::human(1.75, 73.0).expect("within range");
    let gravity = nalgebra::Vector3::new(0.0, -9.80665, 0.0);
    let mut case = Case::of(figure, gravity, crate::support::random::Random::new(1));
    let sum = case.coriolis() * DVector::from_row_slice(&case.v) + case.gravity_torques();
    let bias = case.kernel.bias_forces(&case.q, &case.v).expect("valid");
    assert!(relative_error(sum.as_slice(), &bias) < 1e-13);
}

/// Every state of every figure of another engine: its bias forces, and its torques of gravity.
#[test]
fn the_matrix_gives_the_reference_s_bias() {
    for model in models() {
        let mut kernel = Kernel::<f64>::new(&figure(&model), model.gravity.into());
        for state in &model.states {
            let n = state.qd.len();
            let (mut c, mut gravity) = (matrix(n, n), vec![f64::NAN; n]);
            let Kernel { tree, workspace } = &mut kernel;
            coriolis_matrix(tree, workspace, &state.q, &state.qd, &mut c).expect("valid");
            gravity_torques(tree, workspace, &state.q, &mut gravity).expect("valid");
            assert!(relative_error(&gravity, &state.grav) < 1e-13, "{}", model.name);
            let sum = c * DVector::from_row_slice(&state.qd) + DVector::from_vec(gravity);
            let error = relative_error(sum.as_slice(), &state.bias);
            assert!(error < 1e-13, "{}: {error:e}", model.name);
        }
    }
}
