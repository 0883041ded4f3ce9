//! Calls one kernel so and so often, for whoever counts what a call takes: `calls KERNEL COUNT`. See `cargo xtask instructions`.

use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::batch::{Batch, Instructions};
use solaris_dynamics::{
    Derivatives, DynamicsError, Frame, JacobianAxes, Tree, Workspace, centroidal_momentum_matrix,
    forward_dynamics, inverse_dynamics, inverse_mass_matrix, jacobian, mass_matrix,
};
use solaris_model::human;
use std::error::Error;
use std::hint::black_box;

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);
/// States of a batch.
const STATES: usize = 64;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    // `cargo test --benches` and `cargo bench` have nothing to count.
    let [kernel, count] = &arguments[..] else { return Ok(()) };
    let (Ok(count), figure) = (count.parse::<usize>(), human(1.75, 73.0)?) else { return Ok(()) };
    let tree = Tree::<f64>::new(&figure, GRAVITY)?;
    let (n, mut ws) = (tree.nv(), Workspace::new(&tree));
    let series = |scale: f64, step: f64| -> Vec<f64> {
        (0..n * STATES).map(|i| scale * (step * (i + 1) as f64).sin()).collect()
    };
    let (qs, vs, inputs) = (series(1.3, 0.7), series(2.0, 1.1), series(10.0, 1.9));
    let (q, v, input) = (&qs[..n], &vs[..n], &inputs[..n]);
    let (mut results, mut matrix) = (vec![0.0; n * STATES], DMatrix::zeros(n, n));
    let mut six = DMatrix::zeros(6, n);
    let tip = Frame::of_link(tree.link_count() - 1);
    let mut derivatives = Derivatives::new(&figure, GRAVITY)?;
    let instructions = if kernel.ends_with("plain") { Instructions::Baseline } else { Instructions::Avx2 };
    let mut batch = Batch::<f64>::with_instructions(&figure, GRAVITY, instructions)?;
    for _ in 0..count {
        let (q, out) = (black_box(q), &mut results[..n]);
        match kernel.as_str() {
            "inverse dynamics" => inverse_dynamics(&tree, &mut ws, q, v, input, &[], out)?,
            "forward dynamics" => forward_dynamics(&tree, &mut ws, q, v, input, &[], out)?,
            "mass matrix" => mass_matrix(&tree, &mut ws, q, &mut matrix)?,
            "inverse mass matrix" => inverse_mass_matrix(&tree, &mut ws, q, &mut matrix)?,
            "derivatives of inverse dynamics" => done(derivatives.inverse_dynamics(q, v, input, &[]))?,
            "derivatives of forward dynamics" => done(derivatives.forward_dynamics(q, v, input, &[]))?,
            "Jacobian" => jacobian(&tree, &mut ws, q, &tip, JacobianAxes::World, &mut six)?,
            "centroidal momentum matrix" => centroidal_momentum_matrix(&tree, &mut ws, q, &mut six)?,
            "64 inverse dynamics, plain" | "64 inverse dynamics, AVX2" => {
                batch.inverse_dynamics(black_box(&qs), &vs, &inputs, &[], &mut results)?;
            }
            "64 forward dynamics, AVX2" => {
                batch.forward_dynamics(black_box(&qs), &vs, &inputs, &[], &mut results)?;
            }
            unknown => return Err(format!("there is no kernel '{unknown}'").into()),
        }
        black_box((&mut results, &mut matrix, &mut six));
    }
    Ok(())
}

/// Keeps the compiler from leaving out what nobody looks at.
fn done<T>(result: Result<&T, DynamicsError>) -> Result<(), DynamicsError> {
    result.map(|found| {
        black_box(found);
    })
}
