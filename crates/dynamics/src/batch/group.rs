//! As many states at once as a register has lanes, one group after the other.

use super::rows::{Columns, Output};
use super::vector::{Register, Token};
use super::{Operation, Refused, States};
use crate::error::DynamicsError;
use crate::forward::{forward, forward_dynamics};
use crate::inverse::{inverse, inverse_dynamics};
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use crate::tree::Tree;
use crate::workspace::Workspace;
use nalgebra::Vector3;
use num_traits::Zero;
use solaris_model::Figure;

/// Scratch memory of one thread.
pub(super) trait Solver<F>: Send {
    /// How many states are solved at once.
    fn lanes(&self) -> usize;

    /// Solves the states of the output's range; those that were refused, in order.
    fn solve(
        &mut self,
        operation: Operation,
        inputs: &States<'_, F>,
        output: &mut Output<'_, F>,
    ) -> Vec<Refused>;

    /// The same for another thread.
    #[cfg(feature = "parallel")]
    fn another(&self) -> Box<dyn Solver<F>>;
}

/// The solver over the registers `R`.
///
/// Registers are private to the batches and are made and asked only by a solver that holds the token of their instructions; a token is
/// made only where the machine has them. That is why the operations of registers are safe.
pub(super) struct Groups<R: Register> {
    token: R::Token,
    together: Kernel<R>,
    /// For states that their group was refused for.
    alone: Kernel<R::Lane>,
    /// Positions that the figure can have.
    rest: Vec<R::Lane>,
}

/// The kernel over one scalar, with room for a state.
#[derive(Clone)]
struct Kernel<T> {
    tree: Tree<T>,
    workspace: Workspace<T>,
    q: Vec<T>,
    v: Vec<T>,
    given: Vec<T>,
    sought: Vec<T>,
    external: Vec<(usize, Wrench<T>)>,
}

impl<T: Scalar> Kernel<T> {
    fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        let tree = Tree::new(figure, gravity)?;
        let zeros = vec![T::zero(); tree.nv()];
        Ok(Self {
            workspace: Workspace::new(&tree),
            q: vec![T::zero(); tree.nq()],
            v: zeros.clone(),
            given: zeros.clone(),
            sought: zeros,
            external: Vec::new(),
            tree,
        })
    }
}

impl<R: Register> Groups<R> {
    pub(super) fn boxed(
        token: R::Token,
        figure: &Figure,
        gravity: Vector3<f64>,
    ) -> Result<Box<dyn Solver<R::Lane>>, DynamicsError> {
        let mut rest = vec![0.0; figure.layout().nq()];
        // Whatever is no quaternion may be zero for the kernel, within limits or not.
        figure.neutral(&mut rest).expect("the layout's own length");
        let rest = rest.into_iter().map(R::Lane::from_f64).collect();
        let (together, alone) = (Kernel::new(figure, gravity)?, Kernel::new(figure, gravity)?);
        Ok(Box::new(Self { token, together, alone, rest }))
    }

    /// Solves a group of which at least one state is refused: that one is told and a state at rest put in its place.
    #[cold]
    #[inline(never)]
    fn mend(
        &mut self,
        operation: Operation,
        inputs: &States<'_, R::Lane>,
        first: usize,
        output: &mut Output<'_, R::Lane>,
        refused: &mut Vec<Refused>,
    ) {
        let lanes = R::LANES;
        let rows = first..output.range.end.min(first + lanes);
        let already = refused.len();
        for row in rows.clone() {
            if let Err(error) = self.one(operation, inputs, row) {
                refused.push((row, error));
            }
        }
        let is_refused = |row: usize| refused[already..].iter().any(|(refused, _)| *refused == row);
        for lane in 0..lanes {
            // Lanes beyond the last state hold a copy of it.
            if !is_refused((first + lane).min(inputs.v.states - 1)) {
                continue;
            }
            let kernel = &mut self.together;
            for (entry, rest) in kernel.q.iter_mut().zip(&self.rest) {
                entry.lanes_mut()[lane] = *rest;
            }
            for entry in kernel.v.iter_mut().chain(&mut kernel.given) {
                entry.lanes_mut()[lane] = R::Lane::zero();
            }
            for (_, wrench) in &mut kernel.external {
                for entry in wrench.force.iter_mut().chain(wrench.moment.iter_mut()) {
                    entry.lanes_mut()[lane] = R::Lane::zero();
                }
            }
        }
        let is_solved = self.together(operation);
        for row in rows {
            if is_refused(row) {
                output.write(row, |_| R::Lane::zero() / R::Lane::zero());
            } else if is_solved {
                output.write(row, |k| self.together.sought[k].lanes()[row - first]);
            } else if self.one(operation, inputs, row).is_ok() {
                // Only in the other instructions' rounding is it beyond the precision.
                output.write(row, |k| self.alone.sought[k]);
            }
        }
    }

    /// Solves one state by itself.
    fn one(
        &mut self,
        operation: Operation,
        inputs: &States<'_, R::Lane>,
        row: usize,
    ) -> Result<(), DynamicsError> {
        let kernel = &mut self.alone;
        inputs.q.copy(row, &mut kernel.q);
        inputs.v.copy(row, &mut kernel.v);
        inputs.given.copy(row, &mut kernel.given);
        kernel.external.clear();
        kernel.external.extend(inputs.external.iter().map(|(link, wrenches)| (*link, wrenches[row])));
        let Kernel { tree, workspace, q, v, given, sought, external } = kernel;
        match operation {
            Operation::Inverse => inverse_dynamics(tree, workspace, q, v, given, external, sought),
            Operation::Forward => forward_dynamics(tree, workspace, q, v, given, external, sought),
        }
    }

    /// Solves the states that are packed; whether none is refused.
    #[inline(never)]
    fn together(&mut self, operation: Operation) -> bool {
        let Kernel { tree, workspace, q, v, given, sought, external } = &mut self.together;
        match operation {
            Operation::Inverse => self.token.run(
                #[inline(always)]
                || inverse(tree, workspace, q, v, given, external, sought).is_ok(),
            ),
            Operation::Forward => self.token.run(
                #[inline(always)]
                || forward(tree, workspace, q, v, given, external, sought).is_ok(),
            ),
        }
    }
}

impl<R: Register> Solver<R::Lane> for Groups<R> {
    fn lanes(&self) -> usize {
        R::LANES
    }

    fn solve(
        &mut self,
        operation: Operation,
        inputs: &States<'_, R::Lane>,
        output: &mut Output<'_, R::Lane>,
    ) -> Vec<Refused> {
        let (mut refused, lanes) = (Vec::new(), R::LANES);
        for first in output.range.clone().step_by(lanes) {
            self.together.pack(inputs, first);
            if self.together(operation) {
                output.unpack(first, &self.together.sought);
            } else {
                self.mend(operation, inputs, first, output, &mut refused);
            }
        }
        refused
    }

    #[cfg(feature = "parallel")]
    fn another(&self) -> Box<dyn Solver<R::Lane>> {
        Box::new(Self {
            token: self.token,
            together: self.together.clone(),
            alone: self.alone.clone(),
            rest: self.rest.clone(),
        })
    }
}

impl<R: Register> Kernel<R> {
    /// Takes the states from `first` on.
    #[inline(always)]
    fn pack(&mut self, inputs: &States<'_, R::Lane>, first: usize) {
        let pack = |columns: &Columns<'_, R::Lane>, packed: &mut [R]| columns.pack(first, packed);
        pack(&inputs.q, &mut self.q);
        pack(&inputs.v, &mut self.v);
        pack(&inputs.given, &mut self.given);
        if !inputs.external.is_empty() {
            self.external.clear();
            let last = inputs.v.states - 1;
            self.external.extend(
                inputs.external.iter().map(|(link, wrenches)| (*link, side_by_side(wrenches, first, last))),
            );
        }
    }
}

/// The wrenches of the states from `first` on, one a lane.
#[inline(always)]
fn side_by_side<R: Register>(wrenches: &[Wrench<R::Lane>], first: usize, last: usize) -> Wrench<R> {
    let mut packed: Wrench<R> = Wrench { force: Vector3::zeros(), moment: Vector3::zeros() };
    for lane in 0..R::LANES {
        let Wrench { force, moment } = &wrenches[(first + lane).min(last)];
        for i in 0..3 {
            packed.force[i].lanes_mut()[lane] = force[i];
            packed.moment[i].lanes_mut()[lane] = moment[i];
        }
    }
    packed
}
