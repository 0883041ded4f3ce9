//! Random configurations.

use super::ConfigurationError;
use crate::figure::Figure;
use crate::joint::{AxisKind, Dof, JointKind, Limits};
use std::f64::consts::{PI, TAU};

impl Figure {
    /// Half the range (m) of a slide without limits, and of a free joint's place.
    pub const RANDOM_SLIDE: f64 = 1.0;

    /// Writes a random configuration, from a source of numbers that are uniform in [0, 1).
    ///
    /// One-axis degrees of freedom are uniform between their limits; without limits, rotations in [−π, π) and slides in
    /// [−1, 1) m; with one limit, over a range as long as that from there. Rotations of ball and free joints are uniform over all
    /// rotations; places of free joints are uniform in [−1, 1) m on each axis.
    ///
    /// The source is asked once for each coordinate but three times for each quaternion, in the order of `q`, so the same
    /// source gives the same configuration.
    ///
    /// # Source
    ///
    /// Shoemake (1992), Uniform random rotations, Graphics Gems III, pp. 124–132.
    ///
    /// # Errors
    ///
    /// [`ConfigurationError`] for a wrong length and a source that gives anything else.
    #[doc(alias = "randomConfiguration")]
    pub fn random(&self, q: &mut [f64], mut source: impl FnMut() -> f64) -> Result<(), ConfigurationError> {
        self.check_length("q", q.len(), self.layout().nq())?;
        let mut next = || match source() {
            value if (0.0..1.0).contains(&value) => Ok(value),
            value => Err(ConfigurationError::RandomSource { value }),
        };
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            let q = &mut q[at.q..][..at.nq];
            let kind = link.joint().kind();
            if let JointKind::Free { .. } = kind {
                for q in &mut q[..3] {
                    *q = Self::RANDOM_SLIDE * (2.0 * next()? - 1.0);
                }
            }
            if let Some(first) = kind.quaternion() {
                q[first..].copy_from_slice(&rotation([next()?, next()?, next()?]));
            }
            for (q, dof) in q.iter_mut().zip(kind.axes()) {
                let (fraction, Limits { lower, upper }) = (next()?, range(dof));
                // Each limit by its own share: their difference may overflow.
                *q = (lower * (1.0 - fraction) + upper * fraction).clamp(lower, upper);
            }
        }
        Ok(())
    }
}

/// A rotation, uniform over all rotations, from three numbers that are uniform in [0, 1).
fn rotation([share, first, second]: [f64; 3]) -> [f64; 4] {
    let ((s1, c1), (s2, c2)) = ((TAU * first).sin_cos(), (TAU * second).sin_cos());
    let (r1, r2) = ((1.0 - share).sqrt(), share.sqrt());
    [r1 * s1, r1 * c1, r2 * s2, r2 * c2]
}

/// The finite interval that a degree of freedom is drawn from.
fn range(dof: &Dof) -> Limits {
    let half = match dof.axis.kind {
        AxisKind::Rotation => PI,
        AxisKind::Translation => Figure::RANDOM_SLIDE,
    };
    let Limits { lower, upper } =
        dof.limits.unwrap_or(Limits { lower: -f64::INFINITY, upper: f64::INFINITY });
    match (lower.is_finite(), upper.is_finite()) {
        (true, true) => Limits { lower, upper },
        (true, false) => Limits { lower, upper: lower + 2.0 * half },
        (false, true) => Limits { lower: upper - 2.0 * half, upper },
        (false, false) => Limits { lower: -half, upper: half },
    }
}
