//! §5.6: the share α of the motion that fades out between t₀ and t₁, in absolute time.

use super::{Number, Printed};

/// ```text
/// α = a·cosh t + b·sinh t     a = sinh t₁/sinh(t₁ − t₀)     b = −cosh t₁/sinh(t₁ − t₀)
/// ```
pub(crate) struct SinhFade<F> {
    a: F,
    b: F,
}

impl<F: Number> SinhFade<F> {
    pub(crate) fn new(start: F, end: F) -> Self {
        let below = (end - start).sinh();
        Self { a: end.sinh() / below, b: -end.cosh() / below }
    }
}

impl<F: Number> Printed<F> for SinhFade<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let (cosh, sinh) = (t.cosh(), t.sinh());
        let alpha = self.a * cosh + self.b * sinh;
        [alpha, self.a * sinh + self.b * cosh, alpha]
    }
}

/// ```text
/// α = a·eᵗ + b·e²ᵗ     a = −e^(t₁)/(e^(2t₀) − e^(t₀ + t₁))     b = 1/(e^(2t₀) − e^(t₀ + t₁))
/// ```
pub(crate) struct ExponentialFade<F> {
    a: F,
    b: F,
}

impl<F: Number> ExponentialFade<F> {
    pub(crate) fn new(start: F, end: F) -> Self {
        let below = (start + start).exp() - (start + end).exp();
        Self { a: -end.exp() / below, b: below.recip() }
    }
}

impl<F: Number> Printed<F> for ExponentialFade<F> {
    #[inline]
    fn at(&self, t: F) -> [F; 3] {
        let once = t.exp();
        let (first, second) = (self.a * once, self.b * once * once);
        [first + second, first + second + second, first + F::number(4.0) * second]
    }
}
