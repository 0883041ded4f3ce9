//! Operations on configurations: a `q` is not a vector where a joint has a quaternion, and these are what replaces `+`
//! and `−`.

mod error;
mod random;
pub(crate) mod rotation;

pub use error::ConfigurationError;

use crate::figure::Figure;
use crate::joint::JointKind;
use nalgebra::{Quaternion, Vector3};
use rotation::{apply, exp, log, read, shortest, sweep, unit, unsweep};

/// The most velocity coordinates of a joint.
const MOST: usize = 6;

/// # Configurations
///
/// Slices of `q` have length `nq`, steps and differences length `nv`, in the order of [`Figure::layout`]; nothing is
/// allocated but in errors. A **step** is a velocity times a time (rad, m): a ball joint's turns about the link's own axes, a
/// free joint's slides along and turns about them, both evenly over the step.
///
/// Quaternions need not have unit length where `q` goes in: their direction counts, and zero is refused. Where `q` comes
/// out they have unit length to rounding. The names and conventions are those of Pinocchio's Lie-group operations; the
/// group of a free joint is SE(3).
impl Figure {
    /// Writes the configuration in which every joint is at zero: coordinates 0, quaternions (0, 0, 0, 1). Limits play no
    /// part.
    ///
    /// # Errors
    ///
    /// [`ConfigurationError::Length`].
    #[doc(alias = "neutral configuration")]
    #[doc(alias = "zero pose")]
    #[doc(alias = "rest pose")]
    #[doc(alias = "configuration")]
    pub fn neutral(&self, q: &mut [f64]) -> Result<(), ConfigurationError> {
        self.check_length("q", q.len(), self.layout().nq())?;
        q.fill(0.0);
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            if let Some(first) = link.joint().kind().quaternion() {
                q[at.q + first + 3] = 1.0;
            }
        }
        Ok(())
    }

    /// Gives every quaternion unit length; one that has it to rounding stays as it is, to the bit.
    ///
    /// # Errors
    ///
    /// [`ConfigurationError`] for a wrong length, a number that is not finite and a zero quaternion; `q` is then unchanged.
    #[doc(alias = "quaternion normalization")]
    pub fn normalize(&self, q: &mut [f64]) -> Result<(), ConfigurationError> {
        self.check_configuration("q", q)?;
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            if let Some(first) = link.joint().kind().quaternion() {
                let turn = &mut q[at.q + first..][..4];
                if let Some(unit) = unit(&read(turn)) {
                    turn.copy_from_slice(unit.coords.as_slice());
                }
            }
        }
        Ok(())
    }

    /// Whether `q` has length `nq`, is finite, and every quaternion has unit length to within `tolerance`.
    pub fn is_normalized(&self, q: &[f64], tolerance: f64) -> bool {
        let mut turns = self.links().iter().zip(self.layout().joints()).filter_map(|(link, at)| {
            link.joint().kind().quaternion().and_then(|first| q.get(at.q + first..at.q + first + 4))
        });
        q.len() == self.layout().nq()
            && q.iter().all(|x| x.is_finite())
            && turns.all(|turn| (read(turn).norm() - 1.0).abs() <= tolerance)
    }

    /// Writes to `out` the configuration that `step` leads to from `q`.
    ///
    /// ```text
    /// one axis   q′ = q + s
    /// ball       R′ = R·exp(φ)
    /// free       R′ = R·exp(φ),  p′ = p + R·V(φ)·s      V(φ) = ∫₀¹ exp(λφ) dλ
    /// ```
    ///
    /// with `φ` the turn (rad) and `s` the slide (m). A step of zero leaves a normalised `q` as it is, to the bit.
    ///
    /// # Source
    ///
    /// Solà, Deray, Atchuthan (2018), A micro Lie theory for state estimation in robotics, appendices B (ball) and D (free).
    ///
    /// # Errors
    ///
    /// [`ConfigurationError`] for wrong lengths, numbers that are not finite, zero quaternions, and results that overflow.
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_model::{FigureBuilder, Joint, LinkSpec};
    /// let figure = FigureBuilder::new("f").link(LinkSpec::root("a", Joint::free("root")).mass(1.0)).build()?;
    /// let (mut q, mut next) = ([0.0; 7], [0.0; 7]);
    /// figure.neutral(&mut q)?;
    /// // A car drives half a circle of radius 1 m to its left: π m forwards (z), half a turn about y.
    /// let pi = std::f64::consts::PI;
    /// figure.integrate(&q, &[0.0, 0.0, pi, 0.0, pi, 0.0], &mut next)?;
    /// assert!((next[0] - 2.0).abs() < 1e-15 && next[2].abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "mj_integratePos")]
    #[doc(alias = "retract")]
    #[doc(alias = "exponential map")]
    #[doc(alias = "boxplus")]
    pub fn integrate(&self, q: &[f64], step: &[f64], out: &mut [f64]) -> Result<(), ConfigurationError> {
        self.check_configuration("q", q)?;
        self.check_numbers("step", step, self.layout().v_names())?;
        self.check_length("out", out.len(), self.layout().nq())?;
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            let (q, step) = (&q[at.q..][..at.nq], &step[at.v..][..at.nv]);
            advance(link.joint().kind(), q, step, &mut out[at.q..][..at.nq]);
        }
        finite("the configuration", out, self.layout().q_names())
    }

    /// Writes to `out` the step that leads from `from` to `to`: [`Figure::integrate`] turned round.
    ///
    /// ```text
    /// one axis   s = q′ − q
    /// ball       φ = log(Rᵀ·R′)
    /// free       φ = log(Rᵀ·R′),  s = V(φ)⁻¹·Rᵀ·(p′ − p)
    /// ```
    ///
    /// Turns go the shortest way, `|φ| ≤ π`; the sign of a quaternion is irrelevant. At exactly half a turn either way is as
    /// short: one is taken, the same for all signs. Configurations that are equal differ by exactly zero.
    ///
    /// # Errors
    ///
    /// As [`Figure::integrate`].
    #[doc(alias = "mj_differentiatePos")]
    #[doc(alias = "local")]
    #[doc(alias = "logarithm")]
    #[doc(alias = "boxminus")]
    pub fn difference(&self, from: &[f64], to: &[f64], out: &mut [f64]) -> Result<(), ConfigurationError> {
        self.check_configuration("from", from)?;
        self.check_configuration("to", to)?;
        self.check_length("out", out.len(), self.layout().nv())?;
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            let (from, to) = (&from[at.q..][..at.nq], &to[at.q..][..at.nq]);
            lead(link.joint().kind(), from, to, &mut out[at.v..][..at.nv]);
        }
        finite("the difference", out, self.layout().v_names())
    }

    /// Writes to `out` the configuration at `fraction` of the way from `from` (0) to `to` (1), evenly along the shortest step;
    /// fractions beyond go on the same way.
    ///
    /// # Errors
    ///
    /// As [`Figure::integrate`], and for a fraction that is not finite.
    #[doc(alias = "slerp")]
    #[doc(alias = "geodesic")]
    pub fn interpolate(
        &self,
        from: &[f64],
        to: &[f64],
        fraction: f64,
        out: &mut [f64],
    ) -> Result<(), ConfigurationError> {
        if !fraction.is_finite() {
            let name = "fraction".to_owned();
            return Err(ConfigurationError::NotFinite { what: "the", name, value: fraction });
        }
        self.check_configuration("from", from)?;
        self.check_configuration("to", to)?;
        self.check_length("out", out.len(), self.layout().nq())?;
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            let (kind, from, to) = (link.joint().kind(), &from[at.q..][..at.nq], &to[at.q..][..at.nq]);
            let mut step = [0.0; MOST];
            lead(kind, from, to, &mut step[..at.nv]);
            let step = step.map(|s| s * fraction);
            advance(kind, from, &step[..at.nv], &mut out[at.q..][..at.nq]);
        }
        finite("the configuration", out, self.layout().q_names())
    }

    /// The length of [`Figure::difference`]: the root of the sum of its squares, radians and metres alike.
    ///
    /// # Errors
    ///
    /// As [`Figure::integrate`].
    #[doc(alias = "geodesic distance")]
    pub fn distance(&self, from: &[f64], to: &[f64]) -> Result<f64, ConfigurationError> {
        self.check_configuration("from", from)?;
        self.check_configuration("to", to)?;
        let mut length = 0.0_f64;
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            let (from, to) = (&from[at.q..][..at.nq], &to[at.q..][..at.nq]);
            let mut step = [0.0; MOST];
            lead(link.joint().kind(), from, to, &mut step[..at.nv]);
            finite("the difference", &step[..at.nv], &self.layout().v_names()[at.v..])?;
            length = step.iter().fold(length, |length, s| length.hypot(*s));
        }
        Ok(length)
    }
}

/// One joint's step. `q` has been checked.
fn advance(kind: &JointKind, q: &[f64], step: &[f64], out: &mut [f64]) {
    let turned = |q: &[f64], turn: &[f64]| (turn_of(q), Vector3::new(turn[0], turn[1], turn[2]));
    match kind {
        JointKind::Axes(_) => {
            out.iter_mut().zip(q.iter().zip(step)).for_each(|(out, (q, s))| *out = q + s);
        }
        JointKind::Ball { .. } => {
            let (from, turn) = turned(q, step);
            write_turn(&(from * exp(&turn)), out);
        }
        JointKind::Free { .. } => {
            let (from, turn) = turned(&q[3..], &step[3..]);
            let path = apply(&from, &sweep(&turn, &Vector3::new(step[0], step[1], step[2])));
            (0..3).for_each(|i| out[i] = q[i] + path[i]);
            write_turn(&(from * exp(&turn)), &mut out[3..]);
        }
    }
}

/// The step of one joint that leads from `from` to `to`. Both have been checked.
fn lead(kind: &JointKind, from: &[f64], to: &[f64], out: &mut [f64]) {
    match kind {
        JointKind::Axes(_) => {
            out.iter_mut().zip(to.iter().zip(from)).for_each(|(out, (to, from))| *out = to - from);
        }
        JointKind::Ball { .. } => {
            out.copy_from_slice(log(&shortest(&turn_of(from), &turn_of(to))).as_slice());
        }
        JointKind::Free { .. } => {
            let turn = turn_of(&from[3..]);
            let step = shortest(&turn, &turn_of(&to[3..]));
            let path = Vector3::from_fn(|i, _| to[i] - from[i]);
            out[..3].copy_from_slice(unsweep(&step, &apply(&turn.conjugate(), &path)).as_slice());
            out[3..].copy_from_slice(log(&step).as_slice());
        }
    }
}

/// The rotation that a checked quaternion stands for.
fn turn_of(q: &[f64]) -> Quaternion<f64> {
    let q = read(q);
    unit(&q).unwrap_or(q)
}

/// Writes a product of unit quaternions, its length kept at 1: rounding does not add up over many steps.
fn write_turn(q: &Quaternion<f64>, out: &mut [f64]) {
    out.copy_from_slice(unit(q).unwrap_or(*q).coords.as_slice());
}

/// Refuses a result that has overflowed.
fn finite(what: &'static str, out: &[f64], names: &[String]) -> Result<(), ConfigurationError> {
    match out.iter().position(|x| !x.is_finite()) {
        None => Ok(()),
        Some(i) => Err(ConfigurationError::Overflow { what, name: names[i].clone(), value: out[i] }),
    }
}
