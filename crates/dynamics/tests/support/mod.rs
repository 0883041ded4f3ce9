//! What the tests share.

#![allow(dead_code, reason = "each test uses a part of it")]

pub(crate) mod chain;
pub(crate) mod oracle;
pub(crate) mod random;
pub(crate) mod reference;

use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::{DynamicsError, Scalar, Tree, Workspace, Wrench};
use solaris_model::{Figure, FigureBuilder, FigureError, Inertia, JointKind, LinkSpec};

/// A figure compiled in the precision `T`, with its workspace, and results returned by value.
pub(crate) struct Kernel<T> {
    pub(crate) tree: Tree<T>,
    pub(crate) workspace: Workspace<T>,
}

impl<T: Scalar> Kernel<T> {
    pub(crate) fn new(figure: &Figure, gravity: Vector3<f64>) -> Self {
        let tree = Tree::new(figure, gravity).expect("finite constants");
        let workspace = Workspace::new(&tree);
        Self { tree, workspace }
    }

    pub(crate) fn inverse(
        &mut self,
        q: &[T],
        v: &[T],
        a: &[T],
        external: &[(usize, Wrench<T>)],
    ) -> Result<Vec<T>, DynamicsError> {
        let mut tau = vec![T::zero(); self.tree.nv()];
        solaris_dynamics::inverse_dynamics(&self.tree, &mut self.workspace, q, v, a, external, &mut tau)?;
        Ok(tau)
    }

    pub(crate) fn forward(
        &mut self,
        q: &[T],
        v: &[T],
        tau: &[T],
        external: &[(usize, Wrench<T>)],
    ) -> Result<Vec<T>, DynamicsError> {
        let mut a = vec![T::zero(); self.tree.nv()];
        solaris_dynamics::forward_dynamics(&self.tree, &mut self.workspace, q, v, tau, external, &mut a)?;
        Ok(a)
    }

    /// Accelerations and forces; what is not given comes in as NaN, so that it would show if it were read.
    pub(crate) fn hybrid(
        &mut self,
        [q, v]: [&[T]; 2],
        prescribed: &[bool],
        [a, tau]: [&[T]; 2],
        external: &[(usize, Wrench<T>)],
    ) -> Result<[Vec<T>; 2], DynamicsError> {
        let nan = T::from_f64(f64::NAN);
        let keep = |values: &[T], given: bool| -> Vec<T> {
            values.iter().zip(prescribed).map(|(x, p)| if *p == given { *x } else { nan }).collect()
        };
        let (mut a, mut tau) = (keep(a, true), keep(tau, false));
        solaris_dynamics::hybrid_dynamics(
            &self.tree,
            &mut self.workspace,
            q,
            v,
            prescribed,
            external,
            &mut a,
            &mut tau,
        )?;
        Ok([a, tau])
    }

    pub(crate) fn inverse_mass_matrix(&mut self, q: &[T]) -> Result<DMatrix<T>, DynamicsError> {
        // Whatever it held before means nothing.
        let unknown = T::from_f64(f64::NAN);
        let mut matrix = DMatrix::from_element(self.tree.nv(), self.tree.nv(), unknown);
        solaris_dynamics::inverse_mass_matrix(&self.tree, &mut self.workspace, q, &mut matrix)?;
        Ok(matrix)
    }

    pub(crate) fn bias_forces(&mut self, q: &[T], v: &[T]) -> Result<Vec<T>, DynamicsError> {
        let mut tau = vec![T::zero(); self.tree.nv()];
        solaris_dynamics::bias_forces(&self.tree, &mut self.workspace, q, v, &mut tau)?;
        Ok(tau)
    }

    pub(crate) fn mass_matrix(&mut self, q: &[T]) -> Result<DMatrix<T>, DynamicsError> {
        let mut matrix = DMatrix::zeros(self.tree.nv(), self.tree.nv());
        solaris_dynamics::mass_matrix(&self.tree, &mut self.workspace, q, &mut matrix)?;
        Ok(matrix)
    }

    pub(crate) fn kinetic(&mut self, q: &[T], v: &[T]) -> T {
        solaris_dynamics::kinetic_energy(&self.tree, &mut self.workspace, q, v).expect("a valid state")
    }

    pub(crate) fn potential(&mut self, q: &[T]) -> T {
        solaris_dynamics::potential_energy(&self.tree, &mut self.workspace, q).expect("a valid state")
    }

    pub(crate) fn momentum(&mut self, q: &[T], v: &[T]) -> solaris_dynamics::Momentum<T> {
        solaris_dynamics::momentum(&self.tree, &mut self.workspace, q, v).expect("a valid state")
    }

    pub(crate) fn center_of_mass(&mut self, q: &[T]) -> Vector3<T> {
        solaris_dynamics::center_of_mass(&self.tree, &mut self.workspace, q).expect("a valid state")
    }

    pub(crate) fn place(&mut self, q: &[T]) {
        solaris_dynamics::forward_kinematics(&self.tree, &mut self.workspace, q).expect("a valid state");
    }

    pub(crate) fn velocities(&mut self, q: &[T], v: &[T]) {
        solaris_dynamics::velocities(&self.tree, &mut self.workspace, q, v).expect("a valid state");
    }
}

/// The largest magnitude in `values`.
pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// The greatest difference between two vectors, relative to the largest entry of the second.
pub(crate) fn relative_error(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len(), "lengths");
    let differences: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    assert!(differences.iter().all(|difference| difference.is_finite()), "not finite: {found:?}");
    let (error, scale) = (largest(&differences), largest(expected));
    if scale > 0.0 { error / scale } else { error }
}

/// Whether a joint can stand still only as a whole.
pub(crate) fn is_whole(kind: &JointKind) -> bool {
    kind.quaternion().is_some()
}

/// The figure built once more by the builder, which checks everything.
pub(crate) fn rebuilt(figure: &Figure) -> Result<Figure, FigureError> {
    let mut builder = FigureBuilder::new(figure.name());
    for link in figure.links() {
        let (name, joint) = (link.name(), link.joint().clone());
        let parent = link.parent().map(|parent| figure.links()[parent].name());
        let spec = parent.map_or_else(
            || LinkSpec::root(name, joint.clone()),
            |parent| LinkSpec::child(name, parent, joint.clone()),
        );
        let spec = spec.mass(link.mass()).com(*link.com()).inertia(Inertia::Tensor(*link.inertia()));
        let spec = link.frames().iter().fold(spec, |spec, frame| spec.frame(&frame.name, frame.placement));
        builder = builder.link(spec);
    }
    builder.build()
}
