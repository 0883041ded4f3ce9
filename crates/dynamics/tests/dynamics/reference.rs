//! Every operation against the numbers of another engine; see `fixtures/reference`.

use crate::support::reference::{Model, State, external, figure, models};
use crate::support::{Kernel, relative_error};
use nalgebra::Vector3;
use solaris_dynamics::Scalar;
use solaris_model::Figure;

/// Compares every quantity of every state, each relative to its own largest entry, and tells the worst of each.
fn compare<T: Scalar + Into<f64>>(tolerance: f64) {
    let mut worst: Vec<(&str, f64, String)> = Vec::new();
    for model in models() {
        let figure = figure(&model);
        let mut kernel = Kernel::<T>::new(&figure, Vector3::from(model.gravity));
        for (number, state) in model.states.iter().enumerate() {
            for (what, error) in errors(&mut kernel, &figure, &model, state) {
                let case = format!("{} state {number}", model.name);
                match worst.iter_mut().find(|(name, ..)| *name == what) {
                    Some(entry) if entry.1 < error => (entry.1, entry.2) = (error, case),
                    Some(_) => {}
                    None => worst.push((what, error, case)),
                }
            }
        }
    }
    assert_eq!(worst.len(), 8, "every quantity is compared");
    assert!(worst.iter().all(|(_, error, _)| *error <= tolerance), "worst errors: {worst:#?}");
}

fn errors<T: Scalar + Into<f64>>(
    kernel: &mut Kernel<T>,
    figure: &Figure,
    model: &Model,
    state: &State,
) -> Vec<(&'static str, f64)> {
    let narrow = |values: &[f64]| -> Vec<T> { values.iter().map(|&value| T::from_f64(value)).collect() };
    let error = |found: Vec<T>, expected: &[f64]| {
        relative_error(&found.into_iter().map(Into::into).collect::<Vec<f64>>(), expected)
    };
    let (q, v, a) = (narrow(&state.q), narrow(&state.qd), narrow(&state.qdd));
    let at_rest = vec![T::zero(); v.len()];
    let mut errors = vec![
        ("tau", error(kernel.inverse(&q, &v, &a, &[]).expect("valid"), &state.tau_id)),
        ("bias", error(kernel.bias_forces(&q, &v).expect("valid"), &state.bias)),
        ("gravity", error(kernel.bias_forces(&q, &at_rest).expect("valid"), &state.grav)),
        ("kinetic", error(vec![kernel.kinetic(&q, &v)], &[state.kinetic])),
    ];
    if let (Some(fext), Some(expected)) = (&state.fext, &state.tau_id_ext) {
        let external = external(kernel, &q, fext);
        errors.push((
            "tau with wrenches",
            error(kernel.inverse(&q, &v, &a, &external).expect("valid"), expected),
        ));
    }
    if let Some(expected) = &state.mass_matrix {
        errors.push(("M", error(kernel.mass_matrix(&q).expect("valid").as_slice().to_vec(), expected)));
    }
    let (potential, com) = (kernel.potential(&q).into(), kernel.center_of_mass(&q).map(Into::into));
    // Heights and places are relative to an arbitrary origin: their scale is the sum of the terms.
    let (mut energy_scale, mut com_scale) = (0.0, 0.0);
    for (i, link) in figure.links().iter().enumerate() {
        let center = kernel.workspace.pose(i).transform(&link.com().map(T::from_f64)).map(Into::<f64>::into);
        energy_scale += (link.mass() * Vector3::from(model.gravity).dot(&center)).abs();
        com_scale += link.mass() * center.norm() / figure.mass();
    }
    errors.push(("potential", (potential - state.potential).abs() / energy_scale));
    errors.push(("centre of mass", (com - Vector3::from(state.com)).amax() / com_scale));
    errors
}

#[test]
fn double_precision_agrees_to_thirteen_digits() {
    compare::<f64>(1e-13);
}

#[test]
fn single_precision_agrees_to_five_digits() {
    compare::<f32>(1e-5);
}
