//! Dual numbers, which are those of the curves, as a scalar of the recursions.

use super::Real;
pub use solaris_profiles::Dual;

impl<const N: usize> Real for Dual<N> {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn from_f64(x: f64) -> Self {
        Self::constant(x)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Real::sin_cos(self.value());
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.partials().iter().fold(self.value().is_finite(), |finite, partial| finite & partial.is_finite())
    }

    #[inline]
    fn greatest(self) -> f64 {
        self.value().greatest()
    }

    fn all_within(self, lower: f64, upper: f64) -> bool {
        self.value().all_within(lower, upper)
    }

    #[inline]
    fn recip_above(self, threshold: Self) -> Self {
        // Zero below the threshold, and the slope with it.
        let reciprocal = self.value().recip_above(threshold.value());
        self.chain(reciprocal, -(reciprocal * reciprocal))
    }

    #[inline]
    fn recip_or_nan(self, threshold: Self) -> Self {
        let reciprocal = self.value().recip_or_nan(threshold.value());
        self.chain(reciprocal, -(reciprocal * reciprocal))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use num_traits::Zero;

    #[test]
    fn sine_and_cosine_are_those_of_its_value() {
        let (sine, cosine) = Real::sin_cos(Dual::<1>::variable(0.7, 0));
        let (s, c) = Real::sin_cos(0.7_f64);
        assert_eq!((sine, cosine), (Dual::new(s, [c]), Dual::new(c, [-s])));
    }

    #[test]
    fn a_reciprocal_above_a_threshold_has_the_derivatives_of_its_side() {
        let (a, b) = (Dual::<2>::variable(0.7, 0), Dual::variable(-1.3, 1));
        let found = a.recip_above(b);
        assert_relative_eq!(found.value(), 1.0 / 0.7, max_relative = 1e-15);
        assert_relative_eq!(found.partial(0), -1.0 / 0.49, max_relative = 1e-14);
        assert!(found.partial(1).is_zero());
        assert_eq!(a.recip_above(Dual::constant(0.7)), Dual::zero());
        assert_eq!(b.recip_above(a), Dual::zero());
        assert_eq!(Dual::<1>::variable(f64::NAN, 0).recip_above(Dual::zero()).value().to_bits(), 0);
    }

    #[test]
    fn derivatives_count_for_what_is_finite_and_zero_but_not_for_what_is_within() {
        assert!(
            !Real::is_finite(Dual::new(1.0, [f64::NAN])) && !Real::is_finite(Dual::new(f64::INFINITY, [0.0]))
        );
        assert!(Real::is_finite(Dual::new(1.0, [2.0])));
        assert!(
            Dual::new(1.0, [9.0]).all_within(1.0, 2.0) && !Dual::new(f64::NAN, [0.0]).all_within(-1.0, 1.0)
        );
        assert!(!Dual::new(0.0, [1.0]).is_zero() && Dual::<1>::constant(0.0).is_zero());
    }
}
