//! Figures in which degrees of freedom follow others: a knee whose centre moves as it bends.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::mass_matrix;
use crate::inverse::inverse_dynamics;
use crate::spatial::Wrench;
use crate::tree::Tree;
use crate::workspace::{Workspace, check_length, check_result};
use nalgebra::{Cholesky, DMatrix, DVector};
use solaris_model::Figure;

/// Dynamics of a figure whose [followers](solaris_model::Follower) are bound to their leaders, with scratch memory.
///
/// The kernel knows the followers as degrees of freedom like others, and so do `q`, `v`, `a` and `tau`. Here they have none
/// of their own: what a caller says of them is not looked at, and what comes out obeys the curves. With `u` the free
/// velocities,
///
/// ```text
/// v = G(q)·u        a = G·u̇ + g        g_y = f″·ẋ²        τ_u = Gᵀ·τ
/// ```
///
/// where `G` has a 1 for each free degree of freedom and `f′` where a follower meets its leader. Curves are evaluated in
/// f64, and so is this.
#[doc(alias = "mimic")]
#[doc(alias = "coupled coordinate")]
#[doc(alias = "gear")]
#[doc(alias = "equality constraint")]
#[derive(Clone, Debug)]
pub struct Coupling {
    figure: Figure,
    /// The degrees of freedom that follow none.
    free: Vec<usize>,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
    slopes: Vec<f64>,
    whole: DMatrix<f64>,
    reduced: DMatrix<f64>,
    right: DVector<f64>,
}

impl Coupling {
    /// For `figure`, which may have no followers at all.
    pub fn new(figure: &Figure) -> Self {
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let free: Vec<usize> = (0..nv).filter(|&dof| !figure.follows(dof)).collect();
        let n = free.len();
        Self {
            figure: figure.clone(),
            free,
            q: vec![0.0; nq],
            v: vec![0.0; nv],
            a: vec![0.0; nv],
            tau: vec![0.0; nv],
            slopes: vec![0.0; figure.followers().len()],
            whole: DMatrix::zeros(nv, nv),
            reduced: DMatrix::zeros(n, n),
            right: DVector::zeros(n),
        }
    }

    /// The degrees of freedom that follow none, as indices in `v`.
    pub fn free(&self) -> &[usize] {
        &self.free
    }

    /// The forces `tau` that a motion needs: those of followers are with their leaders, and 0 for themselves.
    ///
    /// Slices and units are those of [`crate::inverse_dynamics`]; the entries of followers in `q`, `v`, `a` are not read.
    ///
    /// # Errors
    ///
    /// As for [`crate::inverse_dynamics`].
    #[expect(clippy::too_many_arguments, reason = "the state and what is sought are slices of their own")]
    pub fn inverse_dynamics(
        &mut self,
        tree: &Tree<f64>,
        workspace: &mut Workspace<f64>,
        q: &[f64],
        v: &[f64],
        a: &[f64],
        external: &[(usize, Wrench<f64>)],
        tau: &mut [f64],
    ) -> Result<(), DynamicsError> {
        self.set(q, v, a)?;
        check_length("tau", tau.len(), tree.nv())?;
        inverse_dynamics(tree, workspace, &self.q, &self.v, &self.a, external, tau)?;
        self.figure.fold_forces(&self.q, tau);
        Ok(())
    }

    /// The accelerations `a` that the forces `tau` of the free degrees of freedom bring about.
    ///
    /// ```text
    /// Gᵀ·M·G·u̇ = Gᵀ·(τ − h − M·g)
    /// ```
    ///
    /// The matrix is formed and factored: unlike in [`crate::forward_dynamics`] the work grows with the cube of the
    /// degrees of freedom and the error with the matrix' condition. Forces given for followers are not looked at.
    ///
    /// # Errors
    ///
    /// As for [`crate::forward_dynamics`].
    #[expect(clippy::too_many_arguments, reason = "the state and what is sought are slices of their own")]
    pub fn forward_dynamics(
        &mut self,
        tree: &Tree<f64>,
        workspace: &mut Workspace<f64>,
        q: &[f64],
        v: &[f64],
        tau: &[f64],
        external: &[(usize, Wrench<f64>)],
        a: &mut [f64],
    ) -> Result<(), DynamicsError> {
        check_length("tau", tau.len(), tree.nv())?;
        check_length("a", a.len(), tree.nv())?;
        a.fill(0.0);
        self.set(q, v, a)?;
        // What is needed at g, with the free degrees of freedom unaccelerated.
        inverse_dynamics(tree, workspace, &self.q, &self.v, &self.a, external, &mut self.tau)?;
        self.figure.fold_forces(&self.q, &mut self.tau);
        mass_matrix(tree, workspace, &self.q, &mut self.whole)?;
        self.reduce();
        for (i, &dof) in self.free.iter().enumerate() {
            if !tau[dof].is_finite() {
                let (dof, value) = (tree.v_name(dof), tau[dof].to_string());
                return Err(DynamicsError::NotFinite { what: "tau", dof, value });
            }
            self.right[i] = tau[dof] - self.tau[dof];
        }
        // Taken out and put back, so that nothing is allocated.
        let Some(factor) = Cholesky::new(std::mem::take(&mut self.reduced)) else {
            self.reduced = DMatrix::zeros(self.free.len(), self.free.len());
            self.take_free();
            let (i, inertia) = last_pivot(&mut self.reduced);
            let dof = self.free.get(i).map(|&dof| tree.v_name(dof)).unwrap_or_default();
            return Err(DynamicsError::NoInertia { dof, inertia });
        };
        factor.solve_mut(&mut self.right);
        self.reduced = factor.unpack_dirty();
        for (i, &dof) in self.free.iter().enumerate() {
            self.a[dof] = self.right[i];
        }
        self.figure.follow(&mut self.q, &mut self.v, &mut self.a);
        check_result("an acceleration", &self.a)?;
        a.copy_from_slice(&self.a);
        Ok(())
    }

    /// The full state that the free coordinates imply.
    fn set(&mut self, q: &[f64], v: &[f64], a: &[f64]) -> Result<(), DynamicsError> {
        check_length("q", q.len(), self.q.len())?;
        check_length("v", v.len(), self.v.len())?;
        check_length("a", a.len(), self.a.len())?;
        for f in self.figure.followers() {
            let led = [("q", q[f.leader_coordinate]), ("v", v[f.leader]), ("a", a[f.leader])];
            if let Some((what, value)) = led.into_iter().find(|(_, value)| !value.is_finite()) {
                let (dof, value) = (self.figure.layout().v_names()[f.leader].clone(), value.to_string());
                return Err(DynamicsError::NotFinite { what, dof, value });
            }
        }
        self.q.copy_from_slice(q);
        self.v.copy_from_slice(v);
        self.a.copy_from_slice(a);
        self.figure.follow(&mut self.q, &mut self.v, &mut self.a);
        Ok(())
    }

    /// `Gᵀ·M·G`: what belongs to a follower is given to its leader, first the columns, then the rows.
    fn reduce(&mut self) {
        let n = self.whole.nrows();
        for (slope, f) in self.slopes.iter_mut().zip(self.figure.followers()) {
            *slope = f.curve.at(self.q[f.leader_coordinate])[1];
        }
        for (slope, f) in self.slopes.iter().zip(self.figure.followers()) {
            for row in 0..n {
                let entry = self.whole[(row, f.dof)];
                self.whole[(row, f.leader)] += slope * entry;
            }
        }
        for (slope, f) in self.slopes.iter().zip(self.figure.followers()) {
            for column in 0..n {
                let entry = self.whole[(f.dof, column)];
                self.whole[(f.leader, column)] += slope * entry;
            }
        }
        self.take_free();
    }

    /// Rows and columns of the free degrees of freedom.
    fn take_free(&mut self) {
        for (i, &row) in self.free.iter().enumerate() {
            for (j, &column) in self.free.iter().enumerate() {
                self.reduced[(i, j)] = self.whole[(row, column)];
            }
        }
    }
}

/// The first pivot of a symmetric matrix that is not above zero, or the last one, with its row; the matrix is spoilt.
fn last_pivot(matrix: &mut DMatrix<f64>) -> (usize, f64) {
    let n = matrix.nrows();
    for i in 0..n {
        let pivot = matrix[(i, i)];
        if pivot.is_nan() || pivot <= 0.0 || i + 1 == n {
            return (i, pivot);
        }
        for row in i + 1..n {
            let factor = matrix[(row, i)] / pivot;
            for column in i + 1..n {
                matrix[(row, column)] -= factor * matrix[(i, column)];
            }
        }
    }
    (0, 0.0)
}
