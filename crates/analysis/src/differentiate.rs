//! Velocities and accelerations of recorded positions: a filter, splines, quaternions.

mod turn;

use crate::differentiate::turn::Turning;
use solaris_model::{Figure, JointKind, JointLayout, Known, Motion, MotionError};
use solaris_profiles::{Boundary, Butterworth, FilterError, NaturalSpline, ProfileError, odd_extension};

/// A zero-phase Butterworth low-pass: see [`Butterworth`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filter {
    /// Frequency (Hz) at which each of the two passes halves the power.
    pub cutoff: f64,
    /// Poles of each pass, 1 to 10; `OpenSim` has 3.
    pub order: usize,
}

/// A motion of which velocities and accelerations are known, and how they were found.
#[derive(Clone, Debug)]
pub struct Differentiated {
    /// The motion.
    pub motion: Motion,
    /// How far (s) into each end of the motion the filter is still filled with what was guessed beyond the end; zero where
    /// nothing was filtered.
    pub unsettled: f64,
    /// Of each degree of freedom, whether its velocities or accelerations were found here; of the others all is as it was.
    pub found: Vec<bool>,
}

/// Why a motion cannot be differentiated.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DifferentiateError {
    /// The motion is another figure's, or what comes out is none.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// The filter refuses.
    #[error("the motion cannot be filtered: {0}")]
    Filter(#[from] FilterError),
    /// No curve goes through the samples.
    #[error("'{dof}' cannot be differentiated: {source}")]
    Curve {
        /// The degree of freedom or joint.
        dof: String,
        /// Why.
        source: ProfileError,
    },
    /// A joint that turns too far between samples.
    #[error(
        "joint '{joint}' turns by {degrees:.0}° from the sample before {time} s to that one, or filtering leaves nothing of its \
         quaternion: its velocities cannot be told from so few samples; give them with the positions, or record it faster"
    )]
    TurnsTooFar {
        /// The joint.
        joint: String,
        /// When (s).
        time: f64,
        /// How far (degrees).
        degrees: f64,
    },
}

/// Finds the velocities and accelerations that `motion` lacks.
///
/// What is known is used as it is, never filtered nor compared: of a degree of freedom with velocities and accelerations,
/// everything. Of any other, the positions are filtered where `filter` asks for it, and stand filtered in the result; they
/// are differentiated as the natural quintic spline through the samples ([`NaturalSpline`]). Where velocities are known and
/// accelerations are not, a filtered copy of the velocities is differentiated.
///
/// With a filter, half the motion is added on either side, turned about its end by half a turn (`x₋ₖ = 2 x₀ − xₖ`), the
/// filter runs over all of it and the spline goes through all of it; this is what `OpenSim` does. A motion that needs nothing
/// may have samples at any times.
///
/// Of ball and free joints the quaternions are given signs that follow each other, then each component is treated as
/// above. With `s = |q|²` of the spline,
///
/// ```text
/// ω = 2 vec(q̄ ⊗ q̇)/s      α = 2 vec(q̄ ⊗ q̈)/s − ω·(2 q·q̇)/s      v = Rᵀ·ṗ      a = Rᵀ·p̈ − ω × v
/// ```
///
/// along the link's axes, exact whatever the spline's length; filtered quaternions are normalised. Velocities of such a
/// joint count as known where all of them are.
///
/// Degrees of freedom that follow others ([`Figure::follow`]) are put where these lead them, last. Events, planted points and
/// contacts stay; forces do not.
///
/// # Errors
///
/// A motion of another figure, a filter or times that are none, a joint that turns by more than 120° between samples.
#[doc(alias = "complete")]
#[doc(alias = "derivative")]
#[doc(alias = "filter")]
pub fn differentiate(
    figure: &Figure,
    motion: &Motion,
    filter: Option<Filter>,
) -> Result<Differentiated, DifferentiateError> {
    motion.check_figure(figure)?;
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let [q, v, a] = motion.columns().map(<[f64]>::to_vec);
    let (mut out, mut found, mut unsettled) = (States { q, v, a }, vec![false; nv], 0.0);
    let mut smoother = None;
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let joint = link.joint();
        for part in parts(joint.kind(), at) {
            let all = |known: &[bool]| known[part.v..part.v + part.nv].iter().all(|known| *known);
            let known = (all(&motion.known().v), all(&motion.known().a));
            if known == (true, true) || figure.follows(part.v) {
                continue;
            }
            let smoother = match &mut smoother {
                Some(smoother) => smoother,
                none => none.insert(Smoother::new(motion.time(), filter)?),
            };
            found[part.v..part.v + part.nv].fill(true);
            let name = if part.nv == 1 { &figure.layout().v_names()[part.v] } else { joint.name() };
            let columns = Columns { motion, figure, name, smoother };
            match joint.kind().quaternion() {
                None => columns.coordinate(&part, known, &mut out)?,
                Some(_) => columns.joint(&part, known, &mut out)?,
            }
            unsettled = smoother.unsettled;
        }
    }
    if !figure.followers().is_empty() {
        for row in 0..motion.len() {
            let (q, v) = (&mut out.q[row * nq..][..nq], &mut out.v[row * nv..][..nv]);
            figure.follow(q, v, &mut out.a[row * nv..][..nv]);
        }
    }
    let columns = [out.q, out.v, out.a];
    let mut whole =
        Motion::recorded(figure, motion.info.clone(), motion.time().to_vec(), columns, Known::all(nv))?;
    whole.events.clone_from(&motion.events);
    whole.planted.clone_from(&motion.planted);
    whole.contacts.clone_from(&motion.contacts);
    Ok(Differentiated { motion: whole, unsettled, found })
}

/// The columns of all samples.
struct States {
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
}

/// What is differentiated together: each axis by itself, a ball or free joint as a whole.
fn parts(kind: &JointKind, at: &JointLayout) -> Vec<JointLayout> {
    match kind.quaternion() {
        None => (0..at.nv).map(|i| JointLayout { q: at.q + i, nq: 1, v: at.v + i, nv: 1 }).collect(),
        Some(_) => vec![*at],
    }
}

/// The filter and the times that its splines go through.
struct Smoother {
    filter: Option<Butterworth>,
    /// Samples added on either side.
    pad: usize,
    time: Vec<f64>,
    unsettled: f64,
}

impl Smoother {
    fn new(time: &[f64], filter: Option<Filter>) -> Result<Self, DifferentiateError> {
        let Some(Filter { cutoff, order }) = filter else {
            return Ok(Self { filter: None, pad: 0, time: time.to_vec(), unsettled: 0.0 });
        };
        let rate = Butterworth::rate_of(time)?;
        let filter = Butterworth::low_pass(order, cutoff, rate)?;
        let (samples, needed) = (time.len(), filter.fewest());
        if samples < needed {
            return Err(FilterError::TooShort { samples, order, needed }.into());
        }
        let pad = samples / 2;
        let unsettled = filter.settling(samples) as f64 / rate;
        Ok(Self { filter: Some(filter), pad, time: odd_extension(time, pad), unsettled })
    }

    /// Position, velocity and acceleration of one column at its rows, filtered.
    fn differentiate(&self, dof: &str, column: &[f64]) -> Result<Vec<Boundary>, DifferentiateError> {
        let smooth = match &self.filter {
            None => column.to_vec(),
            Some(filter) => filter.zero_phase(&odd_extension(column, self.pad))?,
        };
        let curve = NaturalSpline::new(&self.time, &smooth)
            .map_err(|source| DifferentiateError::Curve { dof: dof.to_owned(), source })?;
        Ok(curve.nodes()[self.pad..self.pad + column.len()].to_vec())
    }
}

/// The columns of one joint.
struct Columns<'a> {
    motion: &'a Motion,
    figure: &'a Figure,
    name: &'a str,
    smoother: &'a Smoother,
}

impl Columns<'_> {
    fn column(&self, from: &[f64], width: usize, index: usize) -> Vec<f64> {
        from.iter().skip(index).step_by(width).copied().take(self.motion.len()).collect()
    }

    fn widths(&self) -> (usize, usize) {
        (self.figure.layout().nq(), self.figure.layout().nv())
    }

    /// The accelerations of `nv` degrees of freedom from their given velocities.
    fn accelerate(&self, part: &JointLayout, out: &mut States) -> Result<(), DifferentiateError> {
        let (_, nv) = self.widths();
        for dof in part.v..part.v + part.nv {
            let nodes =
                self.smoother.differentiate(self.name, &self.column(self.motion.columns()[1], nv, dof))?;
            for (row, node) in nodes.iter().enumerate() {
                out.a[row * nv + dof] = node.velocity;
            }
        }
        Ok(())
    }

    /// One coordinate whose velocity is its rate.
    fn coordinate(
        &self,
        part: &JointLayout,
        (known_v, known_a): (bool, bool),
        out: &mut States,
    ) -> Result<(), DifferentiateError> {
        let (nq, nv) = self.widths();
        let nodes =
            self.smoother.differentiate(self.name, &self.column(self.motion.columns()[0], nq, part.q))?;
        for (row, node) in nodes.iter().enumerate() {
            out.q[row * nq + part.q] = node.position;
            if !known_v {
                out.v[row * nv + part.v] = node.velocity;
            }
            if !known_a {
                out.a[row * nv + part.v] = node.acceleration;
            }
        }
        if known_v { self.accelerate(part, out) } else { Ok(()) }
    }

    /// A ball or free joint.
    fn joint(
        &self,
        part: &JointLayout,
        (known_v, known_a): (bool, bool),
        out: &mut States,
    ) -> Result<(), DifferentiateError> {
        let (nq, nv) = self.widths();
        let mut columns: Vec<Vec<f64>> =
            (0..part.nq).map(|i| self.column(self.motion.columns()[0], nq, part.q + i)).collect();
        let quaternion = part.nq - 4;
        let too_far = |(row, degrees): (usize, f64)| DifferentiateError::TurnsTooFar {
            joint: self.name.to_owned(),
            time: self.motion.time()[row],
            degrees,
        };
        turn::align(&mut columns[quaternion..]).map_err(too_far)?;
        let nodes = columns.iter().map(|column| self.smoother.differentiate(self.name, column));
        let nodes = nodes.collect::<Result<Vec<_>, _>>()?;
        for row in 0..self.motion.len() {
            let turning = Turning::new([0, 1, 2, 3].map(|i| nodes[quaternion + i][row]))
                .ok_or_else(|| too_far((row, 180.0)))?;
            let mut state = [[0.0; 6]; 2];
            let turned = if part.nv == 6 { 3 } else { 0 };
            for i in 0..3 {
                state[0][turned + i] = turning.velocity[i];
                state[1][turned + i] = turning.acceleration[i];
            }
            if part.nv == 6 {
                let [velocity, acceleration] = turning.slide([0, 1, 2].map(|i| nodes[i][row]));
                state[0][..3].copy_from_slice(velocity.as_slice());
                state[1][..3].copy_from_slice(acceleration.as_slice());
            }
            if self.smoother.filter.is_some() {
                let q = &mut out.q[row * nq + part.q..][..part.nq];
                for (q, node) in q.iter_mut().zip(&nodes) {
                    *q = node[row].position;
                }
                q[quaternion..].copy_from_slice(&turning.orientation);
            }
            let from = row * nv + part.v;
            if !known_v {
                out.v[from..from + part.nv].copy_from_slice(&state[0][..part.nv]);
            }
            if !known_a {
                out.a[from..from + part.nv].copy_from_slice(&state[1][..part.nv]);
            }
        }
        if known_v { self.accelerate(part, out) } else { Ok(()) }
    }
}
