//! What is refused, and what the messages say.

use crate::questions::case::{Case, matrix};
use crate::support::Kernel;
use nalgebra::Vector3;
use solaris_dynamics as dynamics;
use solaris_dynamics::{Derivatives, DynamicsError, Frame, JacobianAxes, Workspace};
use solaris_model::human;

fn message<V: std::fmt::Debug>(result: Result<V, DynamicsError>) -> String {
    result.expect_err("refused").to_string()
}

#[test]
fn matrices_of_the_wrong_size_are_refused() {
    let mut case = Case::random(4);
    let n = case.nv();
    let Kernel { tree, workspace: ws } = &mut case.kernel;
    let (q, v, a, frame, world) = (&case.q, &case.v, &case.a, Frame::of_link(0), JacobianAxes::World);
    let tell = |what: &str, found: usize, expected: usize| {
        format!("{what} has {found} entries, but the figure needs {expected}")
    };
    let column = "each column of the Jacobian";
    assert_eq!(
        message(dynamics::jacobian(tree, ws, q, &frame, world, &mut matrix(5, n))),
        tell(column, 5, 6)
    );
    let rate = dynamics::jacobian_rate(tree, ws, q, v, &frame, world, &mut matrix(6, n + 1));
    assert_eq!(message(rate), tell("each row of the Jacobian", n + 1, n));
    let com = dynamics::center_of_mass_jacobian(tree, ws, q, &mut matrix(6, n));
    assert_eq!(message(com), tell("each column of the centre of mass's Jacobian", 6, 3));
    let momentum = dynamics::centroidal_momentum_matrix(tree, ws, q, &mut matrix(6, n + 2));
    assert_eq!(message(momentum), tell("each row of the momentum matrix", n + 2, n));
    let coriolis = dynamics::coriolis_matrix(tree, ws, q, v, &mut matrix(n + 1, n));
    assert_eq!(message(coriolis), tell("each column of the Coriolis matrix", n + 1, n));
    let regressor = dynamics::torque_regressor(tree, ws, q, v, a, &mut matrix(n, 10));
    assert_eq!(message(regressor), tell("each row of the regressor", 10, 10 * tree.link_count()));
}

#[test]
fn states_that_are_not_finite_are_refused() {
    let mut case = Case::random(4);
    let n = case.nv();
    let bad = vec![f64::NAN; n];
    let Kernel { tree, workspace: ws } = &mut case.kernel;
    let (q, v, a) = (&case.q, &case.v, &case.a);
    let refused = |result: Result<(), DynamicsError>| matches!(result, Err(DynamicsError::NotFinite { .. }));
    assert!(refused(dynamics::accelerations(tree, ws, q, v, &bad)));
    assert!(refused(dynamics::bias_accelerations(tree, ws, q, &bad)));
    assert!(refused(dynamics::coriolis_matrix(tree, ws, q, &bad, &mut matrix(n, n))));
    assert!(refused(dynamics::torque_regressor(
        tree,
        ws,
        q,
        v,
        &bad,
        &mut matrix(n, 10 * tree.link_count())
    )));
    let mut derivatives = Derivatives::new(&case.figure, case.gravity).expect("finite constants");
    assert!(refused(derivatives.inverse_dynamics(q, v, &bad, &[]).map(|_| ())));
    assert_eq!(
        message(derivatives.inverse_dynamics(q, v, &a[1..], &[])),
        format!("a has {} entries, but the figure needs {n}", n - 1)
    );
    // A force without end leaves no acceleration.
    let person = human(1.7, 70.0).expect("within range");
    let mut kernel = Kernel::<f64>::new(&person, Vector3::zeros());
    let (rest, mut a, mut tau) = (vec![0.0; 66], vec![0.0; 66], vec![0.0; 66]);
    let force = Vector3::new(f64::INFINITY, 0.0, 0.0);
    let Kernel { tree, workspace } = &mut kernel;
    let pushed = dynamics::ground_acceleration(tree, workspace, &rest, &rest, &mut a, &[], &force, &mut tau);
    assert!(message(pushed).contains("force"));
}

#[test]
fn frames_and_links_that_do_not_exist_are_refused() {
    let person = human(1.7, 70.0).expect("within range");
    assert_eq!(
        message(Frame::<f64>::named(&person, "left_fot")),
        "the figure has no frame and no link called 'left_fot'; did you mean 'left_foot'?"
    );
    assert_eq!(
        message(Frame::<f64>::named(&person, "xyzzyxyzzy")),
        "the figure has no frame and no link called 'xyzzyxyzzy'"
    );
    let mut kernel = Kernel::<f64>::new(&person, Vector3::zeros());
    let (frame, mut j) = (Frame::of_link(99), matrix(6, 66));
    let Kernel { tree, workspace } = &mut kernel;
    let asked = dynamics::jacobian(tree, workspace, &[0.0; 66], &frame, JacobianAxes::World, &mut j);
    let last = person.links().len() - 1;
    assert_eq!(message(asked), format!("there is no link 99: the figure's links are 0 to {last}"));
}

#[test]
fn a_workspace_of_another_tree_is_refused() {
    let mut case = Case::random(4);
    let other = Kernel::<f64>::new(&human(1.7, 70.0).expect("within range"), Vector3::zeros());
    case.kernel.workspace = Workspace::new(&other.tree);
    let Kernel { tree, workspace: ws } = &mut case.kernel;
    let (q, v) = (&case.q, &case.v);
    let n = v.len();
    assert_eq!(dynamics::bias_accelerations(tree, ws, q, v), Err(DynamicsError::Workspace));
    assert_eq!(dynamics::gravity_torques(tree, ws, q, &mut vec![0.0; n]), Err(DynamicsError::Workspace));
    let coriolis = dynamics::coriolis_matrix(tree, ws, q, v, &mut matrix(n, n));
    assert_eq!(coriolis, Err(DynamicsError::Workspace));
    assert_eq!(dynamics::composite_body(tree, ws, q).map(|_| ()), Err(DynamicsError::Workspace));
}
