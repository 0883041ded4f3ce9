//! Many states of one figure at once.
//!
//! The recursions are those of one state, written over vector registers whose lanes are states; instructions are chosen when
//! the program runs. A group of as many states as a register has lanes is packed, solved and unpacked while it is in the first cache.

mod group;
mod rows;
mod vector;

use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::Wrench;
use group::{Groups, Solver};
use nalgebra::Vector3;
use rows::{Columns, Output};
use solaris_model::Figure;
use std::fmt;
use vector::Token;
#[cfg(target_arch = "x86_64")]
use vector::{Avx2, Avx512, Doubles2, Doubles4, Doubles8, Singles4, Singles8, Singles16, Sse2};

/// The vector instructions that a [`Batch`] uses.
///
/// On x86-64 those of `Baseline` are there always (SSE2); `Avx2` comes with fused multiplication and addition. On other machines
/// states are solved one at a time, whatever is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Instructions {
    /// What every machine of this kind has.
    Baseline,
    /// AVX2 and FMA: four doubles at once.
    Avx2,
    /// AVX-512, of processors since 2019 (Ice Lake, Zen 4): eight doubles at once.
    Avx512,
}

impl Instructions {
    /// The best that this machine has.
    pub fn best() -> Self {
        Self::available().last().unwrap_or(Self::Baseline)
    }

    /// Those that this machine has, the best last.
    pub fn available() -> impl Iterator<Item = Self> {
        [Self::Baseline, Self::Avx2, Self::Avx512].into_iter().filter(|instructions| instructions.are_here())
    }

    #[cfg(target_arch = "x86_64")]
    fn are_here(self) -> bool {
        match self {
            Self::Baseline => true,
            Self::Avx2 => Avx2::new().is_some(),
            Self::Avx512 => Avx512::new().is_some(),
        }
    }

    #[cfg(not(target_arch = "x86_64"))]
    fn are_here(self) -> bool {
        self == Self::Baseline
    }
}

/// The precision of a batch: `f64` or `f32`. There are no others.
pub trait Precision: Scalar + Send + Sync + sealed::Precision {}

impl Precision for f64 {}
impl Precision for f32 {}

mod sealed {
    #[allow(clippy::wildcard_imports, reason = "which registers there are depends on the machine")]
    use super::*;

    pub trait Precision: Scalar {
        /// Scratch memory of one thread, with these instructions or with the next lower ones that the machine has.
        #[expect(private_interfaces, reason = "no one else makes one")]
        fn solver(
            instructions: Instructions,
            figure: &Figure,
            gravity: Vector3<f64>,
        ) -> Result<Box<dyn Solver<Self>>, DynamicsError>;
    }

    /// One precision: a register of it for each set of instructions.
    macro_rules! precision {
        ($lane:ident, $baseline:ident, $avx2:ident, $avx512:ident) => {
            impl Precision for $lane {
                // Compiled where it is asked for: who has no batches does not wait for them.
                #[cfg(target_arch = "x86_64")]
                #[inline]
                #[expect(private_interfaces, reason = "no one else makes one")]
                fn solver(
                    instructions: Instructions,
                    figure: &Figure,
                    gravity: Vector3<f64>,
                ) -> Result<Box<dyn Solver<Self>>, DynamicsError> {
                    if let Some(token) = Avx512::new().filter(|_| instructions >= Instructions::Avx512) {
                        return Groups::<$avx512>::boxed(token, figure, gravity);
                    }
                    if let Some(token) = Avx2::new().filter(|_| instructions >= Instructions::Avx2) {
                        return Groups::<$avx2>::boxed(token, figure, gravity);
                    }
                    let token = Sse2::new().expect("every processor of this kind has it");
                    Groups::<$baseline>::boxed(token, figure, gravity)
                }

                #[cfg(not(target_arch = "x86_64"))]
                #[inline]
                #[expect(private_interfaces, reason = "no one else makes one")]
                fn solver(
                    _: Instructions,
                    figure: &Figure,
                    gravity: Vector3<f64>,
                ) -> Result<Box<dyn Solver<Self>>, DynamicsError> {
                    Groups::<$lane>::boxed(vector::Plain::new().expect("always"), figure, gravity)
                }
            }
        };
    }
    precision!(f64, Doubles2, Doubles4, Doubles8);
    precision!(f32, Singles4, Singles8, Singles16);
}

/// How the numbers of many states lie in a slice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// State by state: entry `k` of state `i` at `i·n + k`, where a state has `n` entries.
    #[default]
    Rows,
    /// Entry by entry: entry `k` of state `i` of `m` at `k·m + i`.
    #[doc(alias = "structure of arrays")]
    #[doc(alias = "column-major")]
    Columns,
}

/// What acts on a link from outside in each state: the link's index, and a wrench a state, in world axes about the world's origin.
pub type LinkWrenches<'a, F> = (usize, &'a [Wrench<F>]);

/// Why states could not be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchError {
    /// A slice is not that of a whole number of states, or not of as many as the others.
    #[error("{what} has {found} entries; {states} states of {width} need {}", states * width)]
    Length {
        /// Which argument.
        what: &'static str,
        /// Its length.
        found: usize,
        /// The number of states, by the velocities.
        states: usize,
        /// The entries that a state needs.
        width: usize,
    },
    /// The figure or its gravity cannot be computed with, whatever the state.
    #[error(transparent)]
    Figure(DynamicsError),
    /// Some states were refused; all others are done.
    #[error(
        "{} of {states} states {} refused, the first in row {}: {first}; all others are done",
        .rows.len(), if .rows.len() == 1 { "was" } else { "were" }, .rows.first().copied().unwrap_or_default()
    )]
    Rows {
        /// The number of states.
        states: usize,
        /// Those that were refused, in order, from 0. What was asked of them is NaN.
        rows: Vec<usize>,
        /// Why the first was.
        first: DynamicsError,
    },
}

/// Where the forces of many states go, with their derivatives: [`crate::Partials`] of every state.
///
/// Of each state a matrix has `nv²` entries, column by column as nalgebra's: that in row `i` and column `j` is entry `j·nv + i`, the
/// derivative of force `i` by the `j`th direction. How the entries of many states lie is said by [`Layout`].
#[derive(Debug)]
pub struct BatchPartials<'a, F> {
    /// The forces `tau`.
    pub value: &'a mut [F],
    /// By the configuration, along the tangent.
    pub by_q: &'a mut [F],
    /// By the velocity.
    pub by_v: &'a mut [F],
    /// By the acceleration: the mass matrix.
    pub by_input: &'a mut [F],
}

/// Inverse and forward dynamics of many states of one figure: several times as fast as one at a time.
///
/// Numbers of many states are slices, a state a row unless [`Layout::Columns`] is asked for. States are independent: each has the same
/// result whatever stands beside it, and on any number of threads. Where the instructions have no fused multiplication and addition
/// ([`Instructions::Baseline`] on x86-64), that result has the very bits of the operation for one state; elsewhere it is rounded
/// less often, and the last digits are others.
///
/// Memory is allocated when it is made, when derivatives are first asked of it, and for what is said of states that are refused; a call
/// allocates nothing else on one thread.
///
/// # Examples
///
/// ```
/// use solaris_dynamics::batch::Batch;
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
/// let pendulum = FigureBuilder::new("pendulum").link(bob).build()?;
/// let mut batch = Batch::<f64>::new(&pendulum, Vector3::new(0.0, -9.81, 0.0))?;
/// // Hanging, at a twelfth of a turn, level: what holds it?
/// let q = [0.0, 30_f64.to_radians(), 90_f64.to_radians()];
/// let (rest, mut tau) = ([0.0; 3], [0.0; 3]);
/// batch.inverse_dynamics(&q, &rest, &rest, &[], &mut tau)?;
/// assert!(tau.iter().zip([0.0, 4.905, 9.81]).all(|(tau, expected)| (tau - expected).abs() < 1e-12));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "simd")]
#[doc(alias = "rneaInParallel")]
#[doc(alias = "abaInParallel")]
#[doc(alias = "rollout")]
pub struct Batch<F> {
    nq: usize,
    nv: usize,
    links: usize,
    /// The first degree of freedom that follows another, and that one.
    follower: Option<DynamicsError>,
    layout: Layout,
    instructions: Instructions,
    /// One for each thread.
    solvers: Vec<Box<dyn Solver<F>>>,
}

/// What is asked of every state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operation {
    /// From accelerations to forces.
    Inverse,
    /// From forces to accelerations.
    Forward,
    /// From accelerations to forces, with the derivatives of these.
    InverseDerivatives,
}

/// The states that something is asked of, and what is given besides.
#[derive(Clone, Copy)]
struct States<'a, F> {
    q: Columns<'a, F>,
    v: Columns<'a, F>,
    given: Columns<'a, F>,
    external: &'a [LinkWrenches<'a, F>],
}

/// A state that was refused, and why.
type Refused = (usize, DynamicsError);

impl<F> fmt::Debug for Batch<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { nq, nv, layout, instructions, solvers, .. } = self;
        f.debug_struct("Batch")
            .field("nq", nq)
            .field("nv", nv)
            .field("layout", layout)
            .field("instructions", instructions)
            .field("threads", &solvers.len())
            .finish_non_exhaustive()
    }
}

impl<F: Precision> Batch<F> {
    /// States of `figure` under the acceleration of `gravity` (m/s², world axes), in rows, on one thread, with the best instructions
    /// that the machine has.
    ///
    /// # Errors
    ///
    /// As for [`crate::Tree::new`].
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        Self::with_instructions(figure, gravity, Instructions::best())
    }

    /// As [`new`](Self::new), with these instructions, or with the next lower ones that the machine has: the lowest give every machine
    /// of its kind the same bits.
    ///
    /// # Errors
    ///
    /// As for [`crate::Tree::new`].
    pub fn with_instructions(
        figure: &Figure,
        gravity: Vector3<f64>,
        instructions: Instructions,
    ) -> Result<Self, DynamicsError> {
        let instructions = instructions.min(Instructions::best());
        let solver = F::solver(instructions, figure, gravity)?;
        let layout = figure.layout();
        let follower = figure.followers().first().map(|follower| DynamicsError::Follower {
            dof: layout.v_names()[follower.dof].clone(),
            leader: layout.v_names()[follower.leader].clone(),
        });
        Ok(Self {
            nq: layout.nq(),
            nv: layout.nv(),
            links: figure.links().len(),
            follower,
            layout: Layout::Rows,
            instructions,
            solvers: vec![solver],
        })
    }

    /// The same with numbers that lie in another way, in every slice.
    #[must_use]
    pub fn layout(mut self, layout: Layout) -> Self {
        self.layout = layout;
        self
    }

    /// The same on as many threads as this of rayon's pool; 0 stands for as many as the pool has.
    #[cfg(feature = "parallel")]
    #[must_use]
    pub fn threads(mut self, threads: usize) -> Self {
        let threads = if threads == 0 { rayon::current_num_threads() } else { threads };
        let one = self.solvers.swap_remove(0);
        self.solvers = (1..threads).map(|_| one.another()).collect();
        self.solvers.push(one);
        self
    }

    /// The instructions that are used.
    pub fn instructions(&self) -> Instructions {
        self.instructions
    }

    /// How many states are solved at once on each thread.
    pub fn lanes(&self) -> usize {
        self.solvers[0].lanes()
    }

    /// The generalized forces `tau` of motions: [`crate::inverse_dynamics`] of every state.
    ///
    /// A state has `nq` entries in `q` (rad, m) and `nv` in `v`, `a` (per s, per s²) and `tau` (N m, N).
    ///
    /// # Errors
    ///
    /// [`BatchError`]: lengths that do not belong together, a wrench on a link that does not exist, and states that are
    /// refused as [`crate::inverse_dynamics`] refuses them; all others are done even so.
    pub fn inverse_dynamics(
        &mut self,
        q: &[F],
        v: &[F],
        a: &[F],
        external: &[LinkWrenches<'_, F>],
        tau: &mut [F],
    ) -> Result<(), BatchError> {
        self.solve(Operation::Inverse, q, v, ("a", a), external, [("tau", tau, self.nv)])
    }

    /// The accelerations `a` that forces bring about: [`crate::forward_dynamics`] of every state.
    ///
    /// Shapes and units as for [`inverse_dynamics`](Self::inverse_dynamics).
    ///
    /// # Errors
    ///
    /// As for [`inverse_dynamics`](Self::inverse_dynamics), states being refused as [`crate::forward_dynamics`] refuses them;
    /// a figure with followers.
    pub fn forward_dynamics(
        &mut self,
        q: &[F],
        v: &[F],
        tau: &[F],
        external: &[LinkWrenches<'_, F>],
        a: &mut [F],
    ) -> Result<(), BatchError> {
        if let Some(follower) = &self.follower {
            return Err(BatchError::Figure(follower.clone()));
        }
        self.solve(Operation::Forward, q, v, ("tau", tau), external, [("a", a, self.nv)])
    }

    /// The generalized forces of motions and their derivatives by `q`, `v` and `a`: [`crate::Derivatives::inverse_dynamics`] of every
    /// state.
    ///
    /// Shapes and units as for [`inverse_dynamics`](Self::inverse_dynamics); every entry of `partials` is written. That alone is much of
    /// the work: ask for as many states at a time as fit the last cache, with `3·nv²` entries each.
    ///
    /// # Errors
    ///
    /// As for [`inverse_dynamics`](Self::inverse_dynamics), states being refused as [`crate::Derivatives::inverse_dynamics`] refuses
    /// them.
    #[doc(alias = "computeRNEADerivatives")]
    pub fn inverse_dynamics_derivatives(
        &mut self,
        q: &[F],
        v: &[F],
        a: &[F],
        external: &[LinkWrenches<'_, F>],
        partials: &mut BatchPartials<'_, F>,
    ) -> Result<(), BatchError> {
        let BatchPartials { value, by_q, by_v, by_input } = partials;
        let (nv, entries) = (self.nv, self.nv * self.nv);
        let sought: [(_, &mut [F], _); 4] = [
            ("the forces", value, nv),
            ("the derivatives by q", by_q, entries),
            ("the derivatives by v", by_v, entries),
            ("the derivatives by a", by_input, entries),
        ];
        self.solve(Operation::InverseDerivatives, q, v, ("a", a), external, sought)
    }

    /// What is `sought` comes with its name and with its entries a state.
    fn solve<const N: usize>(
        &mut self,
        operation: Operation,
        q: &[F],
        v: &[F],
        (given, x): (&'static str, &[F]),
        external: &[LinkWrenches<'_, F>],
        sought: [(&'static str, &mut [F], usize); N],
    ) -> Result<(), BatchError> {
        let (nq, nv, layout) = (self.nq, self.nv, self.layout);
        let states = v.len() / nv.max(1);
        let widths = [("v", v.len(), nv), ("q", q.len(), nq), (given, x.len(), nv)];
        let sought_widths = sought.iter().map(|(what, y, width)| (*what, y.len(), *width));
        let bad = widths.into_iter().chain(sought_widths).find(|(_, found, width)| *found != states * width);
        if let Some((what, found, width)) = bad {
            return Err(BatchError::Length { what, found, states, width });
        }
        for (index, &(link, wrenches)) in external.iter().enumerate() {
            if link >= self.links {
                let last = self.links - 1;
                return Err(BatchError::Figure(DynamicsError::NoSuchLink { index, link, last }));
            }
            if wrenches.len() != states {
                let (what, found) = ("the wrenches on a link", wrenches.len());
                return Err(BatchError::Length { what, found, states, width: 1 });
            }
        }
        let columns = |data, width| Columns { data, width, states, layout };
        let (q, v, given) = (columns(q, nq), columns(v, nv), columns(x, nv));
        let inputs = States { q, v, given, external };
        let refused = self.share(operation, &inputs, sought, states);
        let mut refused = refused.into_iter();
        let Some((row, first)) = refused.next() else { return Ok(()) };
        let rows = std::iter::once(row).chain(refused.map(|(row, _)| row)).collect();
        Err(BatchError::Rows { states, rows, first })
    }

    /// Gives every thread its share of the states, in whole groups.
    fn share<const N: usize>(
        &mut self,
        operation: Operation,
        inputs: &States<'_, F>,
        sought: [(&'static str, &mut [F], usize); N],
        states: usize,
    ) -> Vec<Refused> {
        let layout = self.layout;
        #[cfg(feature = "parallel")]
        if self.solvers.len() > 1 {
            use rayon::prelude::*;
            let groups = states.div_ceil(self.lanes());
            let share = groups.div_ceil(self.solvers.len()).max(1) * self.lanes();
            let mut shares: Vec<(_, Vec<Output<'_, F>>)> = self
                .solvers
                .iter_mut()
                .take(states.div_ceil(share))
                .map(|solver| (solver, Vec::new()))
                .collect();
            for (_, y, width) in sought {
                let outputs = Output::split(y, width, states, share, layout);
                shares.iter_mut().zip(outputs).for_each(|((_, all), output)| all.push(output));
            }
            let solved: Vec<Vec<Refused>> = shares
                .into_par_iter()
                .map(|(solver, mut outputs)| solver.solve(operation, inputs, &mut outputs))
                .collect();
            return solved.into_iter().flatten().collect();
        }
        let mut outputs = sought.map(|(_, y, width)| Output::whole(y, width, states, layout));
        self.solvers[0].solve(operation, inputs, &mut outputs)
    }
}
