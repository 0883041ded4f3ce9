//! The pendulum over ten seconds in single and in double precision, by the same kernel and the same rule.

use super::{figures, solutions};
use solaris_dynamics::{DynamicsError, Scalar, Tree, Workspace, forward_dynamics};
use std::f64::consts::FRAC_PI_2;

/// Steps (s).
pub(super) const STEPS: [f64; 5] = [5e-2, 2e-2, 1e-2, 1e-3, 1e-4];

/// The error (rad) after 10 s by the classical rule of order four.
pub(super) fn error<T: Scalar + Into<f64>>(step: f64) -> Result<f64, String> {
    let simulation = figures::pendulum()?;
    let tree = Tree::new(simulation.figure(), *simulation.gravity()).map_err(|error| error.to_string())?;
    let (mut q, mut v) = ([0.0], [0.0]);
    solutions::pendulum(FRAC_PI_2, 9.81_f64.sqrt())(10.0, &mut q, &mut v);
    let found: T = swing(&tree, step).map_err(|error| error.to_string())?;
    Ok((found.into() - q[0]).abs())
}

fn swing<T: Scalar>(tree: &Tree<T>, step: f64) -> Result<T, DynamicsError> {
    let mut workspace = Workspace::new(tree);
    let mut rate = |q: T, v: T| -> Result<(T, T), DynamicsError> {
        let mut a = [T::zero()];
        forward_dynamics(tree, &mut workspace, &[q], &[v], &[T::zero()], &[], &mut a)?;
        Ok((v, a[0]))
    };
    let of = |x: f64| -> T { Scalar::from_f64(x) };
    let (mut q, mut v) = (of(FRAC_PI_2), T::zero());
    let h = of(step);
    let (half, sixth) = (of(0.5) * h, h / of(6.0));
    for _ in 0..(10.0 / step).round() as usize {
        let (q1, v1) = rate(q, v)?;
        let (q2, v2) = rate(q + half * q1, v + half * v1)?;
        let (q3, v3) = rate(q + half * q2, v + half * v2)?;
        let (q4, v4) = rate(q + h * q3, v + h * v3)?;
        q += sixth * (q1 + (q2 + q3) * of(2.0) + q4);
        v += sixth * (v1 + (v2 + v3) * of(2.0) + v4);
    }
    Ok(q)
}
