//! No operation allocates once its workspace is there.

#[path = "support/allocations.rs"]
mod allocations;
mod support;

use allocations::allocations;
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics as dynamics;
use solaris_dynamics::{Derivatives, Formulation, Frame, InverseDynamics, JacobianAxes, Wrench};
use support::Kernel;
use support::random::{Joints, Random, random_configuration, tree, tree_of};

#[test]
fn the_counter_counts() {
    assert_eq!(allocations(|| drop(std::hint::black_box(vec![1, 2, 3]))), 1);
}

#[test]
fn no_question_allocates() {
    let mut random = Random::new(12);
    let figure = tree_of(Joints::EveryArmed, &mut random, 12, 1.0);
    let q = random_configuration(&mut random, &figure);
    let n = figure.layout().nv();
    let Kernel { tree, workspace: mut ws } = Kernel::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let (v, a, mut tau) = (random.slice(n, 1.0), random.slice(n, 1.0), vec![0.0; n]);
    let [mut three, mut six, mut square] = [3, 6, n].map(|rows| DMatrix::zeros(rows, n));
    let mut regressor = DMatrix::zeros(n, 10 * tree.link_count());
    let mut derivatives = Derivatives::new(&figure, Vector3::new(0.0, -9.81, 0.0)).expect("finite constants");
    let external: [(usize, Wrench<f64>); 2] = [random.wrench(12), random.wrench(12)];
    let (frame, axes, ws) = (Frame::at(7, Vector3::x()), JacobianAxes::Frame, &mut ws);
    let count = allocations(|| {
        let mut all = || {
            dynamics::jacobian(&tree, ws, &q, &frame, axes, &mut six)?;
            dynamics::jacobian_rate(&tree, ws, &q, &v, &frame, axes, &mut six)?;
            dynamics::joint_jacobians(&tree, ws, &q)?;
            dynamics::point_columns(&tree, ws, &frame, |dof, column| tau[dof] = column.linear.x);
            dynamics::accelerations(&tree, ws, &q, &v, &a)?;
            dynamics::bias_accelerations(&tree, ws, &q, &v)?;
            dynamics::composite_body(&tree, ws, &q)?;
            dynamics::center_of_mass_jacobian(&tree, ws, &q, &mut three)?;
            dynamics::centroidal_momentum_matrix(&tree, ws, &q, &mut six)?;
            dynamics::centroidal_momentum(&tree, ws, &q, &v)?;
            dynamics::centroidal_momentum_rate(&tree, ws, &q, &v, &a)?;
            dynamics::coriolis_matrix(&tree, ws, &q, &v, &mut square)?;
            dynamics::gravity_torques(&tree, ws, &q, &mut tau)?;
            dynamics::joint_reactions(&tree, ws, &q, &v, &a, &external, &mut tau)?;
            dynamics::torque_regressor(&tree, ws, &q, &v, &a, &mut regressor)?;
            derivatives.inverse_dynamics(&q, &v, &a, &external)?;
            derivatives.forward_dynamics(&q, &v, &tau, &external).map(|_| ())
        };
        assert_eq!(all(), Ok(()));
    });
    assert_eq!(count, 0);
}

#[test]
fn the_ground_allocates_nothing() {
    let figure = solaris_model::human(1.7, 70.0).expect("within range");
    let Kernel { tree, mut workspace } = Kernel::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let (rest, mut a, mut tau, force) = ([0.0; 66], [0.0; 66], [0.0; 66], Vector3::y());
    let count = allocations(|| {
        let ws = &mut workspace;
        let done = dynamics::ground_acceleration(&tree, ws, &rest, &rest, &mut a, &[], &force, &mut tau);
        assert_eq!(done, Ok(()));
        let react = |ws: &dynamics::Workspace<f64>, com: &Vector3<f64>| {
            let force = ws.base_wrench().force;
            Ok::<_, dynamics::DynamicsError>([(0, Wrench { force, moment: com.cross(&force) })])
        };
        let done = dynamics::inverse_dynamics_with(&tree, ws, &rest, &rest, &rest, react, &mut tau);
        assert_eq!(done, Ok(()));
    });
    assert_eq!(count, 0);
}

#[test]
fn maps_to_other_figures_allocate_nothing() {
    let figure = solaris_model::human(1.7, 70.0).expect("within range");
    let tree = dynamics::Tree::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0)).expect("finite");
    let view = dynamics::RootView::new(&figure, 12, solaris_model::RootAt::Joint).expect("massive links");
    let fused = figure.fuse(&[(9, 0.1), (10, 0.2), (11, 0.3)]).expect("dofs");
    let mut forces = dynamics::FusedForces::new(&fused, &tree).expect("its tree");
    let (state, mut q, mut v, mut a, mut tau) = ([0.1; 66], [0.0; 66], [0.0; 66], [0.0; 66], [0.0; 66]);
    let (mut q_view, mut v_view, mut a_view) = ([0.0; 67], [0.0; 66], [0.0; 66]);
    let base = Wrench { force: Vector3::x(), moment: Vector3::y() };
    let mut external = [(9, base)];
    let count = allocations(|| {
        let mut all = || {
            view.to_view(&state, &state, &state, &mut q_view, &mut v_view, &mut a_view)?;
            view.from_view(&q_view, &v_view, &a_view, &mut q, &mut v, &mut a)?;
            view.positions_to_view(&state, &mut q_view)?;
            view.forces_to_view(&state, &base, &q_view, &mut v_view)?;
            view.forces_from_view(&q_view, &v_view, &q, &a, &mut tau)?;
            forces.solve(&tree, &state[..63], &state[..63], &state[..63], &external, &mut tau)?;
            dynamics::relink(&mut external, fused.links())?;
            Ok::<(), dynamics::RootViewError>(())
        };
        assert_eq!(all(), Ok(()));
    });
    assert_eq!(count, 0);
}

#[test]
fn what_follows_allocates_nothing() {
    let joint = solaris_model::Joint::new("wire").tx().ty();
    let joint = joint.following("wire.tx", solaris_model::Curve::Polynomial(vec![0.0, 0.0, 1.0]));
    let bead = solaris_model::LinkSpec::root("bead", joint).mass(0.3);
    let figure = solaris_model::FigureBuilder::new("bead").link(bead).build().expect("valid");
    let Kernel { tree, workspace: mut ws } = Kernel::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let (mut coupling, state, mut a, mut tau) =
        (dynamics::Coupling::new(&figure), [0.3; 2], [0.0; 2], [0.0; 2]);
    let count = allocations(|| {
        let mut all = || {
            coupling.inverse_dynamics(&tree, &mut ws, &state, &state, &state, &[], &mut tau)?;
            coupling.forward_dynamics(&tree, &mut ws, &state, &state, &state, &[], &mut a)
        };
        assert_eq!(all(), Ok(()));
    });
    assert_eq!(count, 0);
}

#[test]
fn no_formulation_allocates() {
    let mut random = Random::new(13);
    let figure = tree_of(Joints::EveryArmed, &mut random, 12, 1.0);
    let (q, n) = (random_configuration(&mut random, &figure), figure.layout().nv());
    let (v, a, mut tau) = (random.slice(n, 1.0), random.slice(n, 1.0), vec![0.0; n]);
    let external: [(usize, Wrench<f64>); 2] = [random.wrench(12), random.wrench(12)];
    for formulation in Formulation::ALL {
        let mut kernel = InverseDynamics::new(&figure, Vector3::new(0.0, -9.81, 0.0), formulation)
            .expect("finite constants");
        let count = allocations(|| assert_eq!(kernel.solve(&q, &v, &a, &external, &mut tau), Ok(())));
        assert_eq!(count, 0, "{formulation:?}");
    }
}

#[test]
fn no_solution_for_accelerations_allocates() {
    let mut random = Random::new(14);
    let figure = tree_of(Joints::EveryArmed, &mut random, 12, 1.0);
    let (q, n) = (random_configuration(&mut random, &figure), figure.layout().nv());
    let Kernel { tree, workspace: mut ws } = Kernel::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let (v, mut a, mut tau) = (random.slice(n, 1.0), random.slice(n, 1.0), random.slice(n, 1.0));
    let (mut matrix, prescribed) = (DMatrix::zeros(n, n), vec![false; n]);
    let external: [(usize, Wrench<f64>); 2] = [random.wrench(12), random.wrench(12)];
    let held = [
        dynamics::ContactConstraint::point(11, Vector3::x()),
        dynamics::ContactConstraint::fixed(6, Vector3::y()),
    ];
    let mut contacts = dynamics::Contacts::new(&tree, held.to_vec());
    let ws = &mut ws;
    let count = allocations(|| {
        let mut all = || {
            dynamics::forward_dynamics(&tree, ws, &q, &v, &tau, &external, &mut a)?;
            dynamics::hybrid_dynamics(&tree, ws, &q, &v, &prescribed, &external, &mut a, &mut tau)?;
            dynamics::inverse_mass_matrix(&tree, ws, &q, &mut matrix)?;
            let (held, ext) = (&mut contacts, &external);
            dynamics::contact_dynamics(&tree, ws, held, &q, &v, &prescribed, ext, &mut a, &mut tau)
                .map(|_| ())
        };
        assert_eq!(all(), Ok(()));
    });
    assert_eq!(count, 0);
}

#[test]
fn no_operation_allocates() {
    let mut random = Random::new(11);
    let figure = tree(&mut random, 12, 1.0);
    let n = figure.layout().nv();
    let Kernel { tree, mut workspace } = Kernel::<f64>::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let (q, v, a) = (random.slice(n, 1.0), random.slice(n, 1.0), random.slice(n, 1.0));
    let (mut tau, mut matrix) = (vec![0.0; n], DMatrix::zeros(n, n));
    let external: [(usize, Wrench<f64>); 2] = [random.wrench(12), random.wrench(12)];
    let ws = &mut workspace;
    let count = allocations(|| {
        let mut all = || {
            dynamics::forward_kinematics(&tree, ws, &q)?;
            dynamics::velocities(&tree, ws, &q, &v)?;
            dynamics::inverse_dynamics(&tree, ws, &q, &v, &a, &external, &mut tau)?;
            dynamics::bias_forces(&tree, ws, &q, &v, &mut tau)?;
            dynamics::mass_matrix(&tree, ws, &q, &mut matrix)?;
            dynamics::kinetic_energy(&tree, ws, &q, &v)?;
            dynamics::potential_energy(&tree, ws, &q)?;
            dynamics::momentum(&tree, ws, &q, &v)?;
            dynamics::center_of_mass(&tree, ws, &q).map(|_| ())
        };
        assert_eq!(all(), Ok(()));
    });
    assert_eq!(count, 0);
}
