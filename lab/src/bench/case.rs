//! The kernel's operations, each as one call.

use crate::peers::states::States;
use crate::timing::{self, Time};
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::batch::{Batch, Instructions};
use solaris_dynamics::{
    Derivatives, DynamicsError, Frame, JacobianAxes, Tree, Workspace, centroidal_momentum_matrix,
    forward_dynamics, inverse_dynamics, inverse_mass_matrix, jacobian, jacobian_rate, mass_matrix,
    torque_regressor,
};
use solaris_model::Figure;
use std::fmt::Display;
use std::hint::black_box;

/// The states that are timed one by one come from the first rows: the peers' programs stop here too.
const MOST_TIMED: usize = 1024;
/// The matrices of longer figures take longer than all the rest.
const MOST_DENSE: usize = 300;

type Operation = timing::Operation<Case, String>;

/// Operations on vectors, by the names that robotics gives them.
pub(crate) const VECTORS: [(&str, Operation); 2] = [("rnea", Case::rnea), ("aba", Case::aba)];
/// Operations on matrices.
pub(crate) const MATRICES: [(&str, Operation); 8] = [
    ("crba", Case::crba),
    ("minverse", Case::minverse),
    ("rnea_derivatives", Case::rnea_derivatives),
    ("aba_derivatives", Case::aba_derivatives),
    ("jacobian", Case::jacobian),
    ("jacobian_rate", Case::jacobian_rate),
    ("centroidal_map", Case::centroidal_map),
    ("regressor", Case::regressor),
];
/// Batches, by instructions: of inverse dynamics, of forward dynamics, both in single precision.
const BATCHES: [[Operation; 4]; 3] = [batches::<0>(), batches::<1>(), batches::<2>()];
pub(crate) const BATCH_NAMES: [&str; 4] = ["rnea_batch", "aba_batch", "rnea_batch_f32", "aba_batch_f32"];

const fn batches<const I: usize>() -> [Operation; 4] {
    [Case::rnea_batch::<I>, Case::aba_batch::<I>, Case::rnea_batch_f32::<I>, Case::aba_batch_f32::<I>]
}

/// A figure with its states, and room for results.
pub(crate) struct Case {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    pub(crate) states: States,
    pub(crate) tau: Vec<f64>,
    pub(crate) a: Vec<f64>,
    tip: Frame<f64>,
    six: DMatrix<f64>,
    dense: Option<Dense>,
    batches: Vec<Batch<f64>>,
    all: Vec<f64>,
    singles: Vec<Batch<f32>>,
    single_states: [Vec<f32>; 4],
    all_single: Vec<f32>,
}

struct Dense {
    matrix: DMatrix<f64>,
    regressor: DMatrix<f64>,
    derivatives: Derivatives,
}

impl Case {
    pub(crate) fn new(figure: &Figure, gravity: Vector3<f64>, states: States) -> Result<Self, DynamicsError> {
        let tree = Tree::new(figure, gravity)?;
        let nv = tree.nv();
        let dense = || {
            let links = figure.links().len();
            let (matrix, regressor) = (DMatrix::zeros(nv, nv), DMatrix::zeros(nv, 10 * links));
            Ok::<_, DynamicsError>(Dense {
                matrix,
                regressor,
                derivatives: Derivatives::new(figure, gravity)?,
            })
        };
        let single = |values: &[f64]| values.iter().map(|x| *x as f32).collect::<Vec<_>>();
        let all = |count: usize| vec![0.0; count * nv];
        let instructions = Instructions::available;
        Ok(Self {
            workspace: Workspace::new(&tree),
            tau: all(1),
            a: all(1),
            tip: Frame::of_link(figure.links().len() - 1),
            six: DMatrix::zeros(6, nv),
            dense: (nv <= MOST_DENSE).then(dense).transpose()?,
            batches: instructions()
                .map(|one| Batch::<f64>::with_instructions(figure, gravity, one))
                .collect::<Result<_, _>>()?,
            all: all(states.count),
            singles: instructions()
                .map(|one| Batch::with_instructions(figure, gravity, one))
                .collect::<Result<_, _>>()?,
            single_states: [&states.q, &states.v, &states.a, &states.tau].map(|values| single(values)),
            all_single: vec![0.0; states.count * nv],
            tree,
            states,
        })
    }

    /// Times everything that this figure can be asked: names, times of a state.
    pub(crate) fn time(&mut self, block: f64, rounds: usize) -> Result<Vec<(String, Time)>, String> {
        let mut operations = VECTORS.to_vec();
        if self.dense.is_some() {
            operations.extend(MATRICES);
        }
        let count = self.states.count.min(MOST_TIMED);
        let times = timing::run(self, &operations, count, block, rounds)?;
        let mut all: Vec<_> =
            operations.iter().zip(times).map(|((name, _), time)| ((*name).to_owned(), time)).collect();
        let mut batches = Vec::new();
        for (index, instructions) in Instructions::available().enumerate() {
            let named = BATCH_NAMES.iter().zip(BATCHES[index]);
            batches.extend(named.map(|(name, operation)| (format!("{name} {instructions:?}"), operation)));
        }
        let operations: Vec<_> =
            batches.iter().map(|(name, operation)| (name.as_str(), *operation)).collect();
        let times = timing::run(self, &operations, 1, block, rounds)?;
        let states = self.states.count as f64;
        let each = |Time { median, least }| Time { median: median / states, least: least / states };
        all.extend(batches.iter().zip(times).map(|((name, _), time)| (name.clone(), each(time))));
        Ok(all)
    }

    pub(crate) fn rnea(&mut self, state: usize) -> Result<(), String> {
        let (q, v, a) = (self.states.q(state), self.states.v(state), self.states.a(state));
        let done = inverse_dynamics(&self.tree, &mut self.workspace, black_box(q), v, a, &[], &mut self.tau);
        black_box(&mut self.tau);
        said(done)
    }

    pub(crate) fn aba(&mut self, state: usize) -> Result<(), String> {
        let (q, v, tau) = (self.states.q(state), self.states.v(state), self.states.tau(state));
        let done = forward_dynamics(&self.tree, &mut self.workspace, black_box(q), v, tau, &[], &mut self.a);
        black_box(&mut self.a);
        said(done)
    }

    fn crba(&mut self, state: usize) -> Result<(), String> {
        let q = black_box(self.states.q(state));
        let Dense { matrix, .. } = self.dense.as_mut().ok_or(LONG)?;
        said(mass_matrix(&self.tree, &mut self.workspace, q, black_box(matrix)))
    }

    fn minverse(&mut self, state: usize) -> Result<(), String> {
        let q = black_box(self.states.q(state));
        let Dense { matrix, .. } = self.dense.as_mut().ok_or(LONG)?;
        said(inverse_mass_matrix(&self.tree, &mut self.workspace, q, black_box(matrix)))
    }

    fn rnea_derivatives(&mut self, state: usize) -> Result<(), String> {
        let (q, v, a) = (self.states.q(state), self.states.v(state), self.states.a(state));
        let Dense { derivatives, .. } = self.dense.as_mut().ok_or(LONG)?;
        said(derivatives.inverse_dynamics(black_box(q), v, a, &[]).map(used))
    }

    fn aba_derivatives(&mut self, state: usize) -> Result<(), String> {
        let (q, v, tau) = (self.states.q(state), self.states.v(state), self.states.tau(state));
        let Dense { derivatives, .. } = self.dense.as_mut().ok_or(LONG)?;
        said(derivatives.forward_dynamics(black_box(q), v, tau, &[]).map(used))
    }

    fn jacobian(&mut self, state: usize) -> Result<(), String> {
        let (q, tip, six) = (black_box(self.states.q(state)), &self.tip, black_box(&mut self.six));
        said(jacobian(&self.tree, &mut self.workspace, q, tip, JacobianAxes::World, six))
    }

    fn jacobian_rate(&mut self, state: usize) -> Result<(), String> {
        let (q, v) = (black_box(self.states.q(state)), self.states.v(state));
        let (tip, six) = (&self.tip, black_box(&mut self.six));
        said(jacobian_rate(&self.tree, &mut self.workspace, q, v, tip, JacobianAxes::World, six))
    }

    fn centroidal_map(&mut self, state: usize) -> Result<(), String> {
        let (q, six) = (black_box(self.states.q(state)), black_box(&mut self.six));
        said(centroidal_momentum_matrix(&self.tree, &mut self.workspace, q, six))
    }

    fn regressor(&mut self, state: usize) -> Result<(), String> {
        let (q, v, a) = (self.states.q(state), self.states.v(state), self.states.a(state));
        let Dense { regressor, .. } = self.dense.as_mut().ok_or(LONG)?;
        said(torque_regressor(&self.tree, &mut self.workspace, black_box(q), v, a, black_box(regressor)))
    }

    fn rnea_batch<const I: usize>(&mut self, _: usize) -> Result<(), String> {
        let States { q, v, a, .. } = &self.states;
        said(self.batches[I].inverse_dynamics(black_box(q), v, a, &[], black_box(&mut self.all)))
    }

    fn aba_batch<const I: usize>(&mut self, _: usize) -> Result<(), String> {
        let States { q, v, tau, .. } = &self.states;
        said(self.batches[I].forward_dynamics(black_box(q), v, tau, &[], black_box(&mut self.all)))
    }

    fn rnea_batch_f32<const I: usize>(&mut self, _: usize) -> Result<(), String> {
        let [q, v, a, _] = &self.single_states;
        said(self.singles[I].inverse_dynamics(black_box(q), v, a, &[], black_box(&mut self.all_single)))
    }

    fn aba_batch_f32<const I: usize>(&mut self, _: usize) -> Result<(), String> {
        let [q, v, _, tau] = &self.single_states;
        said(self.singles[I].forward_dynamics(black_box(q), v, tau, &[], black_box(&mut self.all_single)))
    }
}

const LONG: &str = "the figure is too long for its matrices";

/// Keeps the compiler from leaving out what nobody looks at.
fn used<T>(result: &T) {
    black_box(result);
}

fn said(done: Result<(), impl Display>) -> Result<(), String> {
    done.map_err(|error| error.to_string())
}
