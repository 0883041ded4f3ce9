//! How many digits of an answer are right, against the same code run over twice the digits.

use super::cases::{Case, Errors};
use super::samples::{GRAVITY, Random, Sample};
use nalgebra::{DMatrix, DVector, RealField};
use solaris_dynamics::scalar::DoubleDouble;
use solaris_dynamics::{
    DynamicsError, Formulation, InverseDynamics, Scalar, Tree, Workspace, bias_forces, forward_dynamics,
    mass_matrix,
};

/// Figures and states of each case.
pub(super) const SAMPLES: u64 = 20;

/// Beyond this many degrees of freedom the mass matrix is not factorised: it takes time with the third power.
const LARGEST_MATRIX: usize = 300;

/// What a case loses: `‖x − x*‖ / ‖x*‖` in the Euclidean norm, as geometric means over the samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Accuracy {
    /// In the order of [`Formulation::ALL`].
    pub(super) inverse: [Errors; 3],
    pub(super) forward: Errors,
    /// Forward dynamics by a Cholesky factor of the mass matrix; infinite where a sample has none. `None` beyond
    /// [`LARGEST_MATRIX`].
    pub(super) matrix: Option<Errors>,
    /// The ratio of the largest and least eigenvalue of the mass matrix.
    pub(super) condition: Option<f64>,
}

/// Measures a case over [`SAMPLES`] figures and states.
pub(super) fn measure(case: &Case) -> Result<Accuracy, String> {
    let mut random =
        Random::new(case.name.bytes().fold(1, |seed, byte| seed * 31 % 65_521 + u64::from(byte)));
    let mut logarithms = [0.0; 11];
    for index in 0..SAMPLES {
        let sample = (case.sample)(&mut random)?;
        let numbers = one(&sample).map_err(|error| format!("{}, sample {index}: {error}", case.name))?;
        logarithms.iter_mut().zip(numbers).for_each(|(sum, number)| *sum += number.ln() / SAMPLES as f64);
    }
    let [c, c32, t, t32, n, n32, f, f32, m, m32, condition] = logarithms.map(f64::exp);
    let is_known = !condition.is_nan();
    Ok(Accuracy {
        inverse: [[c, c32], [t, t32], [n, n32]],
        forward: [f, f32],
        matrix: is_known.then_some([m, m32]),
        condition: is_known.then_some(condition),
    })
}

/// Errors of the formulations, of forward dynamics and of that by the matrix, f64 and f32 of each, then the condition; NaN
/// where the matrix is too large.
fn one(sample: &Sample) -> Result<[f64; 11], DynamicsError> {
    let mut numbers = [f64::NAN; 11];
    let tau: Vec<DoubleDouble> = inverse(sample, Formulation::NewtonEuler)?;
    for (i, formulation) in Formulation::ALL.into_iter().enumerate() {
        numbers[2 * i] = error(&inverse::<f64>(sample, formulation)?, &tau);
        numbers[2 * i + 1] = error(&inverse::<f32>(sample, formulation)?, &tau);
    }
    let a: Vec<DoubleDouble> = forward(sample)?;
    numbers[6] = error(&forward::<f64>(sample)?, &a);
    numbers[7] = error(&forward::<f32>(sample)?, &a);
    if a.len() <= LARGEST_MATRIX {
        numbers[8] = by_matrix::<f64>(sample)?.map_or(f64::INFINITY, |found| error(&found, &a));
        numbers[9] = by_matrix::<f32>(sample)?.map_or(f64::INFINITY, |found| error(&found, &a));
        numbers[10] = condition(sample)?;
    }
    Ok(numbers)
}

pub(super) fn inverse<T: Scalar>(sample: &Sample, formulation: Formulation) -> Result<Vec<T>, DynamicsError> {
    inverse_of(sample, formulation, &cast(&sample.a))
}

/// Inverse dynamics of a sample with accelerations `a` in place of its own.
pub(super) fn inverse_of<T: Scalar>(
    sample: &Sample,
    formulation: Formulation,
    a: &[T],
) -> Result<Vec<T>, DynamicsError> {
    let mut dynamics = InverseDynamics::new(&sample.figure, GRAVITY, formulation)?;
    let [q, v] = [&sample.q, &sample.v].map(|x| cast(x));
    let mut tau = vec![T::zero(); v.len()];
    dynamics.solve(&q, &v, a, &[], &mut tau)?;
    Ok(tau)
}

pub(super) fn forward<T: Scalar>(sample: &Sample) -> Result<Vec<T>, DynamicsError> {
    let tree = Tree::new(&sample.figure, GRAVITY)?;
    let [q, v, tau] = [&sample.q, &sample.v, &sample.tau].map(|x| cast(x));
    let mut a = vec![T::zero(); v.len()];
    forward_dynamics(&tree, &mut Workspace::new(&tree), &q, &v, &tau, &[], &mut a)?;
    Ok(a)
}

/// `M⁻¹·(τ − bias)`; nothing where rounding has taken from M that it is positive definite.
fn by_matrix<T: Scalar + RealField>(sample: &Sample) -> Result<Option<Vec<T>>, DynamicsError> {
    let tree = Tree::new(&sample.figure, GRAVITY)?;
    let mut workspace = Workspace::new(&tree);
    let [q, v, mut rest] = [&sample.q, &sample.v, &sample.tau].map(|x| cast(x));
    let n = v.len();
    let (mut matrix, mut forces) = (DMatrix::zeros(n, n), vec![T::zero(); n]);
    mass_matrix(&tree, &mut workspace, &q, &mut matrix)?;
    bias_forces(&tree, &mut workspace, &q, &v, &mut forces)?;
    rest.iter_mut().zip(forces).for_each(|(tau, bias)| *tau -= bias);
    let factor = matrix.cholesky();
    Ok(factor.map(|factor| factor.solve(&DVector::from_vec(rest)).as_slice().to_vec()))
}

fn condition(sample: &Sample) -> Result<f64, DynamicsError> {
    let tree = Tree::<f64>::new(&sample.figure, GRAVITY)?;
    let mut matrix = DMatrix::zeros(tree.nv(), tree.nv());
    mass_matrix(&tree, &mut Workspace::new(&tree), &sample.q, &mut matrix)?;
    let values = matrix.singular_values();
    Ok(values.max() / values.min())
}

fn cast<T: Scalar>(numbers: &[f64]) -> Vec<T> {
    numbers.iter().map(|x| T::from_f64(*x)).collect()
}

/// `‖found − right‖ / ‖right‖`; an exact answer counts as one of 1e-20.
/// `‖x − x*‖ / ‖x*‖`.
pub(super) fn error<T: Copy + Into<f64>>(found: &[T], right: &[DoubleDouble]) -> f64 {
    let norm = |numbers: &mut dyn Iterator<Item = f64>| numbers.map(|x| x * x).sum::<f64>().sqrt();
    let mut differences =
        found.iter().zip(right).map(|(x, right)| (DoubleDouble::from((*x).into()) - *right).to_f64());
    let (error, scale) = (norm(&mut differences), norm(&mut right.iter().map(|x| x.to_f64())));
    (error / scale).max(1e-20)
}
