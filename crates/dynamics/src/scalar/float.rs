//! The floating-point numbers of the machine as scalars.

use super::Real;
use super::sine;

impl Real for f64 {
    const EPSILON: f64 = Self::EPSILON;

    fn from_f64(x: f64) -> Self {
        x
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if sine::is_moderate(self) { sine::sin_cos(self) } else { self.sin_cos() }
    }

    #[inline]
    fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
        if angles.iter().fold(true, |moderate, angle| moderate & sine::is_moderate(*angle)) {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = sine::sin_cos(*angle));
        } else {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = Real::sin_cos(*angle));
        }
    }

    fn is_finite(self) -> bool {
        self.is_finite()
    }

    fn greatest(self) -> f64 {
        if self.is_nan() { f64::NEG_INFINITY } else { self }
    }

    fn all_within(self, lower: f64, upper: f64) -> bool {
        (lower..=upper).contains(&self)
    }

    #[inline]
    fn recip_above(self, threshold: Self) -> Self {
        if self > threshold { 1.0 / self } else { 0.0 }
    }

    #[inline]
    fn recip_or_nan(self, threshold: Self) -> Self {
        if self > threshold { 1.0 / self } else { Self::NAN }
    }
}

impl Real for f32 {
    const EPSILON: f64 = Self::EPSILON as f64;

    fn from_f64(x: f64) -> Self {
        x as Self
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        if sine::is_moderate(f64::from(self)) { sine::sin_cos_single(self) } else { self.sin_cos() }
    }

    #[inline]
    fn sin_cos_all(angles: &[Self], pairs: &mut [(Self, Self)]) {
        if angles.iter().fold(true, |moderate, angle| moderate & sine::is_moderate(f64::from(*angle))) {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = sine::sin_cos_single(*angle));
        } else {
            angles.iter().zip(pairs).for_each(|(angle, pair)| *pair = Real::sin_cos(*angle));
        }
    }

    fn is_finite(self) -> bool {
        self.is_finite()
    }

    fn greatest(self) -> f64 {
        f64::from(self).greatest()
    }

    fn all_within(self, lower: f64, upper: f64) -> bool {
        (lower..=upper).contains(&f64::from(self))
    }

    #[inline]
    fn recip_above(self, threshold: Self) -> Self {
        if self > threshold { 1.0 / self } else { 0.0 }
    }

    #[inline]
    fn recip_or_nan(self, threshold: Self) -> Self {
        if self > threshold { 1.0 / self } else { Self::NAN }
    }
}
