//! As many states at once as a register has lanes, one group after the other.

use super::rows::{Columns, Output, squares};
use super::vector::{Register, Token};
use super::{Operation, Refused, States};
use crate::derivatives::Partials;
use crate::error::DynamicsError;
use crate::forward::{forward, forward_dynamics};
use crate::inverse::slopes::Slopes;
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

    /// Solves the states of the outputs' range; those that were refused, in order.
    fn solve(
        &mut self,
        operation: Operation,
        inputs: &States<'_, F>,
        outputs: &mut [Output<'_, F>],
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
    together: Kernel<R, 1>,
    /// For states that their group was refused for.
    alone: Kernel<R::Lane, 4>,
    /// Positions that the figure can have.
    rest: Vec<R::Lane>,
    /// The [`squares`] of positions, of what has an entry a degree of freedom, and of matrices.
    squares: [Vec<usize>; 3],
}

/// The kernel over one scalar, with room for a state; `LANES` is that of its [`Slopes`].
#[derive(Clone)]
struct Kernel<T, const LANES: usize> {
    tree: Tree<T>,
    workspace: Workspace<T>,
    q: Vec<T>,
    v: Vec<T>,
    given: Vec<T>,
    external: Vec<(usize, Wrench<T>)>,
    /// What is sought; its matrices have no entries until derivatives are asked for.
    sought: Partials<T>,
    slopes: Option<Slopes<T, LANES>>,
}

impl<T: Scalar, const LANES: usize> Kernel<T, LANES> {
    fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        let tree = Tree::new(figure, gravity)?;
        let zeros = vec![T::zero(); tree.nv()];
        Ok(Self {
            workspace: Workspace::new(&tree),
            q: vec![T::zero(); tree.nq()],
            v: zeros.clone(),
            given: zeros.clone(),
            external: Vec::new(),
            sought: Partials::new(zeros, 0),
            slopes: None,
            tree,
        })
    }

    /// Makes room for derivatives.
    fn prepare(&mut self) {
        self.slopes = Some(Slopes::new(&self.tree));
        self.sought = Partials::new(std::mem::take(&mut self.sought.value), self.tree.nv());
    }

    /// What was sought, in the order of the outputs.
    fn found(&self) -> [&[T]; 4] {
        let Partials { value, by_q, by_v, by_input } = &self.sought;
        [value, by_q.as_slice(), by_v.as_slice(), by_input.as_slice()]
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
        let (together, alone) = (Kernel::<R, 1>::new(figure, gravity)?, Kernel::new(figure, gravity)?);
        // A few lanes are filled one by one as fast.
        let few = R::LANES < 8;
        let dense = |width| if few { Vec::new() } else { squares(&vec![false; width], R::LANES) };
        let squares = [dense(together.tree.nq()), dense(together.tree.nv()), Vec::new()];
        Ok(Box::new(Self { token, together, alone, rest, squares }))
    }

    /// Makes room for derivatives where they are asked for the first time.
    fn prepare(&mut self, operation: Operation) {
        if operation != Operation::InverseDerivatives || self.together.slopes.is_some() {
            return;
        }
        self.together.prepare();
        self.alone.prepare();
        // What two degrees of freedom on different branches do to each other is zero.
        let tree = &self.together.tree;
        let (nv, mut are_zero) = (tree.nv(), vec![true; tree.nv() * tree.nv()]);
        for k in 0..nv {
            for i in std::iter::successors(Some(k), |&i| tree.before[i]) {
                (are_zero[k * nv + i], are_zero[i * nv + k]) = (false, false);
            }
        }
        self.squares[2] = squares(&are_zero, R::LANES);
    }

    /// Solves a group of which at least one state is refused: that one is told and a state at rest put in its place.
    #[cold]
    #[inline(never)]
    fn mend(
        &mut self,
        operation: Operation,
        inputs: &States<'_, R::Lane>,
        first: usize,
        outputs: &mut [Output<'_, R::Lane>],
        refused: &mut Vec<Refused>,
    ) {
        let lanes = R::LANES;
        let rows = first..outputs[0].range.end.min(first + lanes);
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
                for output in outputs.iter_mut() {
                    output.write(row, |_| R::Lane::zero() / R::Lane::zero());
                }
            } else if is_solved {
                for (output, found) in outputs.iter_mut().zip(self.together.found()) {
                    output.write(row, |k| found[k].lanes()[row - first]);
                }
            } else if self.one(operation, inputs, row).is_ok() {
                // Only in the other instructions' rounding is it beyond the precision.
                for (output, found) in outputs.iter_mut().zip(self.alone.found()) {
                    output.write(row, |k| found[k]);
                }
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
        let Kernel { tree, workspace, q, v, given, sought, external, slopes } = kernel;
        if operation == Operation::Forward {
            return forward_dynamics(tree, workspace, q, v, given, external, &mut sought.value);
        }
        inverse_dynamics(tree, workspace, q, v, given, external, &mut sought.value)?;
        match slopes {
            Some(slopes) if operation == Operation::InverseDerivatives => {
                slopes.find(tree, workspace, v, given, external, sought)
            }
            _ => Ok(()),
        }
    }

    /// Solves the states that are packed; whether none is refused.
    #[inline(never)]
    fn together(&mut self, operation: Operation) -> bool {
        let Kernel { tree, workspace, q, v, given, sought, external, slopes } = &mut self.together;
        if operation == Operation::Forward {
            return self.token.run(
                #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
                || forward(tree, workspace, q, v, given, external, &mut sought.value).is_ok(),
            );
        }
        let is_solved = self.token.run(
            #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
            || inverse(tree, workspace, q, v, given, external, &mut sought.value).is_ok(),
        );
        match slopes {
            Some(slopes) if is_solved && operation == Operation::InverseDerivatives => self.token.run(
                #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
                || slopes.differentiate(tree, workspace, v, given, external, sought).is_ok(),
            ),
            _ => is_solved,
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
        outputs: &mut [Output<'_, R::Lane>],
    ) -> Vec<Refused> {
        self.prepare(operation);
        let mut refused = Vec::new();
        for first in outputs[0].range.clone().step_by(R::LANES) {
            let Self { token, together, squares, .. } = self;
            token.run(
                #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
                || together.pack(inputs, first, squares),
            );
            // States that lie in memory take as long to come as others to be solved.
            for columns in [&inputs.q, &inputs.v, &inputs.given] {
                self.token.ahead(columns.stretch(first + R::LANES, R::LANES));
            }
            self.token.ahead(outputs[0].stretch(first, R::LANES));
            if !self.together(operation) {
                self.mend(operation, inputs, first, outputs, &mut refused);
                continue;
            }
            let Self { token, together, squares: [_, vector, matrix], .. } = self;
            for (i, (output, found)) in outputs.iter_mut().zip(together.found()).enumerate() {
                token.run(
                    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
                    || output.unpack(first, found, if i == 0 { vector } else { matrix }),
                );
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
            squares: self.squares.clone(),
        })
    }
}

impl<R: Register> Kernel<R, 1> {
    /// Takes the states from `first` on.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    fn pack(&mut self, inputs: &States<'_, R::Lane>, first: usize, [q, v, _]: &[Vec<usize>; 3]) {
        let States { q: positions, v: velocities, given, .. } = inputs;
        let all: [(&Columns<'_, _>, _, _); 3] =
            [(positions, &mut self.q, q), (velocities, &mut self.v, v), (given, &mut self.given, v)];
        for (columns, packed, squares) in all {
            columns.pack(first, packed, squares);
        }
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
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
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
