//! The trait of all curves.

use crate::Elementary;
use crate::error::{ProfileError, check_finite};
use crate::sample::Sample;
use alloc::boxed::Box;
use alloc::sync::Arc;

/// A curve of one degree of freedom over the span from 0 to its duration.
#[doc(alias = "easing")]
#[doc(alias = "trajectory")]
#[doc(alias = "interpolation")]
#[doc(alias = "motion profile")]
pub trait Curve<F: Elementary = f64> {
    /// How long it lasts: more than zero, but for a motion between limits that has no way to go.
    fn duration(&self) -> F;

    /// The same in double precision, for curves in f32 that are long: a spline does not round it.
    fn span(&self) -> f64 {
        self.duration().value()
    }

    /// Position, velocity, acceleration and jerk at `t`, a time since the curve's beginning. Allocates nothing.
    ///
    /// A time outside of the span is taken as the nearer end of it; what else a curve may do there, [`Clip`](crate::Clip)
    /// says. At an instant where something jumps, the answer is what holds after it, and at the end what holds before. A
    /// time that is NaN gives NaN; [`try_at`](Self::try_at) refuses it.
    fn at(&self, t: F) -> Sample<F>;

    /// The same at a time in double precision, for curves in f32 that are long: a spline finds its piece by it and rounds
    /// only what is left of the time.
    fn at_time(&self, t: f64) -> Sample<F> {
        self.at(F::from_f64(t))
    }

    /// What holds just before `t`; differs from [`at`](Self::at) only where something jumps.
    fn before(&self, t: F) -> Sample<F> {
        self.at(t)
    }

    /// The same beyond the ends: as the curve's own formula goes on where it is a polynomial, else with the velocity of
    /// the end.
    fn extrapolated(&self, t: F) -> Sample<F> {
        let zero = F::from_f64(0.0);
        let end = if t.value() < 0.0 { zero } else { self.duration() };
        if t.value().is_nan() || (0.0..=self.duration().value()).contains(&t.value()) {
            self.at(t)
        } else {
            self.at(end).straight_on(t - end)
        }
    }

    /// [`at`](Self::at), but refuses a time that is not finite or outside of the span.
    ///
    /// # Errors
    ///
    /// [`ProfileError::NotFinite`], [`ProfileError::OutOfRange`].
    fn try_at(&self, t: F) -> Result<Sample<F>, ProfileError> {
        check_finite("time", &[t])?;
        let range = crate::Range::closed(0.0, self.duration().value());
        crate::error::check_range("time", t, range)?;
        Ok(self.at(t))
    }
}

macro_rules! through {
    ($pointer:ty) => {
        impl<F: Elementary, C: Curve<F> + ?Sized> Curve<F> for $pointer {
            fn duration(&self) -> F {
                (**self).duration()
            }

            fn span(&self) -> f64 {
                (**self).span()
            }

            fn at(&self, t: F) -> Sample<F> {
                (**self).at(t)
            }

            fn at_time(&self, t: f64) -> Sample<F> {
                (**self).at_time(t)
            }

            fn before(&self, t: F) -> Sample<F> {
                (**self).before(t)
            }

            fn extrapolated(&self, t: F) -> Sample<F> {
                (**self).extrapolated(t)
            }
        }
    };
}

through!(&C);
through!(Box<C>);
through!(Arc<C>);

/// A time within the span `[0, duration]`: the nearer end for a time outside of it. NaN stays NaN.
#[inline]
pub(crate) fn within<F: Elementary>(t: F, duration: F) -> F {
    if t.value() < 0.0 {
        F::from_f64(0.0)
    } else if t.value() > duration.value() {
        duration
    } else {
        t
    }
}
