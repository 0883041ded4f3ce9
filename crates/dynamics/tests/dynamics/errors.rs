//! What is refused, and what the messages say.

use crate::support::Kernel;
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, forward_kinematics, mass_matrix};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, human};

fn slider() -> Figure {
    let joint = Joint::new("rail").tx().rz();
    let link = LinkSpec::root("cart", joint).mass(1.0).com(Vector3::new(0.1, 0.0, 0.0));
    FigureBuilder::new("slider").link(link).build().expect("a valid figure")
}

fn kernel() -> Kernel<f64> {
    Kernel::new(&slider(), Vector3::new(0.0, -9.81, 0.0))
}

#[test]
fn a_value_that_is_not_finite_is_named() {
    let (ok, nan, inf) = ([0.0, 1.0], [0.0, f64::NAN], [f64::INFINITY, 0.0]);
    let message = |result: Result<Vec<f64>, DynamicsError>| result.expect_err("refused").to_string();
    assert_eq!(
        message(kernel().inverse(&nan, &ok, &ok, &[])),
        "q of dof 'rail.rz' is NaN; it must be a finite number"
    );
    assert_eq!(
        message(kernel().inverse(&ok, &inf, &ok, &[])),
        "v of dof 'rail.tx' is inf; it must be a finite number"
    );
    assert_eq!(
        message(kernel().inverse(&ok, &ok, &nan, &[])),
        "a of dof 'rail.rz' is NaN; it must be a finite number"
    );
    assert_eq!(
        message(kernel().bias_forces(&ok, &nan)),
        "v of dof 'rail.rz' is NaN; it must be a finite number"
    );
}

#[test]
fn a_wrong_length_is_named() {
    let message = kernel().inverse(&[0.0, 0.0], &[0.0], &[0.0, 0.0], &[]).expect_err("refused").to_string();
    assert_eq!(message, "v has 1 entries, but the figure needs 2");
    let mut kernel = kernel();
    let mut small = DMatrix::zeros(2, 1);
    let error =
        mass_matrix(&kernel.tree, &mut kernel.workspace, &[0.0, 0.0], &mut small).expect_err("refused");
    assert_eq!(error.to_string(), "each row of the mass matrix has 1 entries, but the figure needs 2");
}

#[test]
fn a_bad_wrench_is_named() {
    let (state, force) = ([0.0, 0.0], Vector3::new(0.0, f64::NAN, 0.0));
    let wrench = Wrench { force, moment: Vector3::zeros() };
    let message =
        |link| kernel().inverse(&state, &state, &state, &[(link, wrench)]).expect_err("refused").to_string();
    assert_eq!(message(3), "external wrench 0 acts on link 3, but the figure's links are 0 to 0");
    assert!(
        message(0).starts_with("external wrench 0 on link 'cart' is force [0.0, NaN, 0.0]"),
        "{}",
        message(0)
    );
}

/// Finite numbers whose result is not: no infinity leaves without a word.
#[test]
fn an_overflow_is_named() {
    let mut kernel = kernel();
    let rest = [0.0, 0.0];
    let error = kernel.inverse(&rest, &[0.0, 1e200], &rest, &[]).expect_err("refused");
    assert!(error.to_string().starts_with("the force of dof 'rail.tx' came out as"), "{error}");
    assert!(
        solaris_dynamics::kinetic_energy(&kernel.tree, &mut kernel.workspace, &rest, &[1e200, 0.0]).is_err()
    );
    let mut narrow = Kernel::<f32>::new(&slider(), Vector3::new(0.0, -9.81, 0.0));
    assert!(solaris_dynamics::potential_energy(&narrow.tree, &mut narrow.workspace, &[0.0, 0.0]).is_ok());
    assert!(Tree::<f32>::new(&slider(), Vector3::new(0.0, -1e300, 0.0)).is_err());
    assert!(Tree::<f64>::new(&slider(), Vector3::new(0.0, f64::NAN, 0.0)).is_err());
}

/// Two slides that are each within range, and together beyond it; the link after them is where it has to be said.
#[test]
fn a_place_beyond_all_range_is_named() {
    let slide = |name: &str| Joint::new(name).tx();
    let figure = FigureBuilder::new("crane")
        .link(LinkSpec::root("beam", slide("rail")).mass(1.0))
        .link(LinkSpec::child("cart", "beam", slide("trolley")).mass(1.0))
        .link(LinkSpec::child("hook", "cart", Joint::new("cable").at(Vector3::y())).mass(1.0))
        .build()
        .expect("a figure");
    let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
    let mut place = |q: &[f64]| forward_kinematics(&kernel.tree, &mut kernel.workspace, q);
    assert_eq!(place(&[1.7e308, 0.0]), Ok(()));
    let error = place(&[1.7e308, 1.7e308]).expect_err("beyond").to_string();
    assert!(error.starts_with("the position of a link came out as"), "{error}");
}

#[test]
fn a_workspace_of_another_tree_is_refused() {
    let person =
        Tree::<f64>::new(&human(1.75, 73.0).expect("within range"), Vector3::zeros()).expect("finite");
    let mut other = kernel();
    other.workspace = Workspace::new(&person);
    assert_eq!(other.inverse(&[0.0; 2], &[0.0; 2], &[0.0; 2], &[]), Err(DynamicsError::Workspace));
    assert_eq!(other.bias_forces(&[0.0; 2], &[0.0; 2]), Err(DynamicsError::Workspace));
}
