//! The cost of one call: time, and operations.

use super::samples::{GRAVITY, Sample};
use crate::timing::{self, Operation};
use solaris_dynamics::scalar::{Counted, Operations};
use solaris_dynamics::{
    DynamicsError, Formulation, InverseDynamics, Scalar, Tree, Workspace, forward_dynamics,
};
use std::hint::black_box;

/// Length of a timed block (ms), and number of blocks of which the fastest counts.
const BLOCK: f64 = 4.0;
const BLOCKS: usize = 25;

/// The three formulations of inverse dynamics, then forward dynamics.
const CALLS: usize = 4;

/// What each call takes.
#[derive(Clone, Debug, Default)]
pub(super) struct Speed {
    /// In double and in single precision (ns).
    pub(super) times: [[f64; 2]; CALLS],
    /// Multiplications, additions and divisions together.
    pub(super) operations: [u64; CALLS],
}

/// Times and counts every call for a figure.
pub(super) fn measure(sample: &Sample) -> Result<Speed, DynamicsError> {
    let (double, single) = (times::<f64>(sample)?, times::<f32>(sample)?);
    let times = std::array::from_fn(|call| [double[call], single[call]]);
    Ok(Speed { times, operations: count(sample)? })
}

/// Counts what each call does.
pub(super) fn count(sample: &Sample) -> Result<[u64; CALLS], DynamicsError> {
    let mut calls = Calls::<Counted>::new(sample)?;
    let mut counts = [0; CALLS];
    for (count, (_, call)) in counts.iter_mut().zip(Calls::ALL) {
        let (done, Operations { multiplications, additions, divisions, .. }) =
            Counted::measure(|| call(&mut calls, 0));
        done?;
        *count = multiplications + additions + divisions;
    }
    Ok(counts)
}

fn times<T: Scalar>(sample: &Sample) -> Result<[f64; CALLS], DynamicsError> {
    let times = timing::run(&mut Calls::<T>::new(sample)?, &Calls::ALL, 1, BLOCK, BLOCKS)?;
    Ok(std::array::from_fn(|call| times[call].least))
}

/// A figure compiled for every call, with a state.
struct Calls<T> {
    inverse: [InverseDynamics<T>; 3],
    forward: (Tree<T>, Workspace<T>),
    q: Vec<T>,
    v: Vec<T>,
    a: Vec<T>,
    tau: Vec<T>,
    result: Vec<T>,
}

impl<T: Scalar> Calls<T> {
    const ALL: [(&'static str, Operation<Self, DynamicsError>); CALLS] = [
        ("chain-wise", |calls, _| calls.inverse(0)),
        ("tree-wise", |calls, _| calls.inverse(1)),
        ("Newton-Euler", |calls, _| calls.inverse(2)),
        ("forward", |calls, _| calls.forward()),
    ];

    fn new(sample: &Sample) -> Result<Self, DynamicsError> {
        let compile = |formulation| InverseDynamics::new(&sample.figure, GRAVITY, formulation);
        let [first, second, third] = Formulation::ALL;
        let tree = Tree::new(&sample.figure, GRAVITY)?;
        let cast = |numbers: &[f64]| numbers.iter().map(|x| T::from_f64(*x)).collect();
        Ok(Self {
            inverse: [compile(first)?, compile(second)?, compile(third)?],
            forward: (tree.clone(), Workspace::new(&tree)),
            q: cast(&sample.q),
            v: cast(&sample.v),
            a: cast(&sample.a),
            tau: cast(&sample.tau),
            result: vec![T::zero(); sample.v.len()],
        })
    }

    fn inverse(&mut self, formulation: usize) -> Result<(), DynamicsError> {
        let Self { inverse, q, v, a, result, .. } = self;
        inverse[formulation].solve(black_box(q), v, a, &[], result)?;
        black_box(result);
        Ok(())
    }

    fn forward(&mut self) -> Result<(), DynamicsError> {
        let Self { forward: (tree, workspace), q, v, tau, result, .. } = self;
        forward_dynamics(tree, workspace, black_box(q), v, tau, &[], result)?;
        black_box(result);
        Ok(())
    }
}
