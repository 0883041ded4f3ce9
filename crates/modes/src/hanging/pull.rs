//! What changes the velocities of limbs that hang loose.

use super::loose::Loose;
use crate::convex::cholesky::Envelope;
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::{DynamicsError, Tree, Workspace, Wrench, inverse_dynamics, mass_matrix};
use solaris_model::Figure;

/// What is added to inertias, as a part of them: where two axes of a joint come to be the same there is a way without any.
const MORE: f64 = 1e-3;

/// The dynamics of a figure of which most is prescribed.
#[derive(Clone, Debug)]
pub(super) struct Pull {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    matrix: DMatrix<f64>,
    tau: Vec<f64>,
    /// What pushes which link.
    pub(super) pushed: Option<(usize, Wrench<f64>)>,
    /// Of what is loose: factors, row by row, and what is sought.
    factors: Vec<f64>,
    envelope: Envelope,
    changes: Vec<f64>,
}

impl Pull {
    pub(super) fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        // What follows another is prescribed along with it.
        let untied = (!figure.followers().is_empty()).then(|| figure.untied());
        let tree = Tree::new(untied.as_ref().unwrap_or(figure), gravity)?;
        let nv = tree.nv();
        Ok(Self {
            workspace: Workspace::new(&tree),
            matrix: DMatrix::zeros(nv, nv),
            tau: vec![0.0; nv],
            pushed: None,
            factors: Vec::new(),
            envelope: Envelope::default(),
            changes: Vec::new(),
            tree,
        })
    }

    /// Room for so many that are loose.
    pub(super) fn make_room(&mut self, count: usize) {
        self.factors.resize(count * count, 0.0);
        self.envelope.resize(count);
        self.changes.resize(count, 0.0);
    }

    /// The changes of velocity that were found last.
    pub(super) fn changes(&self) -> &[f64] {
        &self.changes
    }

    /// Finds how the velocities of what is loose change over `h` (s), with the forces of a state (`a` without what is loose); springs, dampers and limits act with the velocity
    /// and the position that there are after the part `weight` of the step:
    ///
    /// ```text
    /// (M + w h D + w² h² K) Δv = h (−b − D v − K (x + w h v))
    /// ```
    pub(super) fn solve(
        &mut self,
        (q, v, a): (&[f64], &[f64], &[f64]),
        loose: &[Loose],
        damping: f64,
        (h, weight): (f64, f64),
    ) {
        let n = loose.len();
        let pushed = self.pushed.as_slice();
        let found = inverse_dynamics(&self.tree, &mut self.workspace, q, v, a, pushed, &mut self.tau)
            .and_then(|()| mass_matrix(&self.tree, &mut self.workspace, q, &mut self.matrix));
        if found.is_err() {
            // Numbers that overflow: what hangs stays as it is.
            self.changes.fill(0.0);
            return;
        }
        for (i, row) in loose.iter().enumerate() {
            for (j, column) in loose.iter().enumerate().take(i + 1) {
                self.factors[i * n + j] = self.matrix[(row.dof, column.dof)];
            }
            let inertia = self.factors[i * n + i];
            let ahead = weight * h;
            let load = if self.pushed.is_some() { self.tau[row.dof] } else { 0.0 };
            let held = row.held(ahead, inertia, load, damping);
            self.factors[i * n + i] += MORE * inertia + ahead * (held.damping + ahead * held.stiffness);
            let own = held.force + (held.damping + ahead * held.stiffness) * row.velocity;
            self.changes[i] = h * (-self.tau[row.dof] - own);
        }
        // Something may have been tightened since room was made.
        self.envelope.resize(n);
        self.envelope.factor(&mut self.factors);
        self.envelope.solve(&self.factors, &mut self.changes);
    }
}
