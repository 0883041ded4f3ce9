//! The arc over its chord, in units of the chord's length.

use crate::Elementary;
use crate::range::{Range, Ranges};
use crate::segment::{segment, segment_by_cube};
use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use core::ops::Bound::{Excluded, Included};

/// An arc through (0, v₀), a third point and (T, v₁). Half its central angle has the sine σ, positive above the chord,
/// and the cosine γ: unlike its tangent ν = σ/γ, and unlike centre and radius, they are finite for a line and for a
/// semicircle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Arc<F> {
    /// L = √(T² + Δv²)
    chord: F,
    /// τ = T/L and δ = Δv/L, the chord's direction.
    direction: (F, F),
    sine: F,
    cosine: F,
    /// Half the central angle.
    half_angle: F,
    /// γτ − σδ and γτ + σδ: b at both ends, where it is not negative.
    ends: (F, F),
    /// L/T
    steepness: F,
}

/// What the arc adds to its chord.
pub(super) struct Bow<F> {
    /// z, the velocity above the chord.
    pub(super) height: F,
    /// Slope of the arc itself.
    pub(super) slope: F,
    /// Second derivative of the arc.
    pub(super) bend: F,
    /// The area between the arc so far and its own chord.
    pub(super) area: F,
}

impl<F: Elementary> Arc<F> {
    /// None where the arc is not part of one upper or lower semicircle.
    ///
    /// ```text
    /// ν = τ·ζ/d        d = u₁(1 − u₁) − ζ² − δ·(2u₁ − 1)·ζ        ζ = (vₘ − v₀ − Δv·u₁)/L
    /// |ν·δ| ≤ τ, ν·ζ ≥ 0    ⇔    |δ·ζ| ≤ d
    /// ```
    pub(super) fn new(duration: F, (v0, v1): (F, F), (third_time, third_velocity): (F, F)) -> Option<Self> {
        let rise = v1 - v0;
        let chord = length(duration, rise);
        let (tau, delta) = (duration / chord, rise / chord);
        let (u, rest) = (third_time / duration, (duration - third_time) / duration);
        let zeta = (third_velocity - v0 - rise * u) / chord;
        let below = u * rest - zeta * zeta - delta * (u - rest) * zeta;
        let limit = (delta * zeta).abs();
        // What rounding may take from a point on the limit.
        let size = (v0.value().abs() + v1.value().abs() + third_velocity.value().abs()) / chord.value();
        let slope = 2.0 * zeta.value().abs() + delta.value().abs();
        let slack = 8.0 * F::EPSILON * ((u * rest + zeta * zeta + limit).value() + size * slope);
        if (limit - below).value() > slack {
            return None;
        }
        let above = tau * zeta;
        let below = if below.value() < limit.value() { limit } else { below };
        let scale = if below.value() > above.value().abs() { below } else { above.abs() };
        let (above, below) = (above / scale, below / scale);
        let root = (above * above + below * below).sqrt();
        let (sine, cosine) = (above / root, below / root);
        let half_angle = if sine.value().abs() <= cosine.value() {
            (sine / cosine).atan()
        } else {
            F::from_f64(FRAC_PI_2.copysign(sine.value())) - (cosine / sine).atan()
        };
        let ends = (positive(cosine * tau - sine * delta), positive(cosine * tau + sine * delta));
        Some(Self {
            chord,
            direction: (tau, delta),
            sine,
            cosine,
            half_angle,
            ends,
            steepness: chord / duration,
        })
    }

    /// L.
    pub(super) fn chord(&self) -> F {
        self.chord
    }

    /// Numbers that are finite for every arc that there is.
    pub(super) fn numbers(&self) -> [F; 4] {
        [self.chord * self.chord, self.half_angle, self.steepness, F::from_f64(1.0) / self.chord]
    }

    pub(super) fn at(&self, t: F, duration: F) -> Bow<F> {
        let (two, zero) = (F::from_f64(2.0), F::from_f64(0.0));
        let ((tau, delta), (u, rest)) = (self.direction, (t / duration, (duration - t) / duration));
        // b and R of the formula for z, over L.
        let b = self.ends.0 * rest + self.ends.1 * u;
        let bow = two * self.sine * u * rest;
        let root = (b * b + two * self.sine * bow).sqrt();
        let below = b + root;
        // At a vertical tangent, both are zero at the end of the arc.
        let z = if below.value().abs() <= 0.0 { zero } else { bow / below };
        // q, half the central angle so far, is the angle at the far end of the arc between the chords to its start and
        // to the point; what is left to the whole is that at the start.
        let q = if u.value() <= 0.5 {
            (tau * z / (rest - delta * z)).atan()
        } else {
            self.half_angle - (tau * z / (u + delta * z)).atan()
        };
        let (run, climb) = (tau * u, delta * u + z);
        Bow {
            height: self.chord * z,
            slope: self.steepness * (delta + self.sine * ((rest - u) - two * delta * z) / root),
            bend: -(two * self.sine / (self.chord * root * root * root)),
            area: self.chord * self.chord * ((run * run + climb * climb) * segment_over_chord(q)),
        }
    }
}

impl Arc<f64> {
    /// The share of the duration at which the arc is level, where there is such.
    pub(super) fn apex(&self) -> Option<f64> {
        let (tau, delta) = self.direction;
        let (lean, width) = (delta * self.cosine, self.sine * tau);
        (lean.abs() < width.abs()).then(|| 0.5 + 0.5 * (lean / width))
    }

    /// How far the arc goes from its chord.
    pub(super) fn height(&self) -> f64 {
        self.chord * self.sine.abs() / (1.0 + self.cosine)
    }
}

/// For ζ of the sign of δ, |δ·ζ| ≤ d is ζ² + 2u₁·|δ·ζ| ≤ u₁(1 − u₁), for the other sign the same with 1 − u₁ in the
/// place of u₁: one range about the chord.
pub(super) fn third_velocity(duration: f64, (v0, v1): (f64, f64), third_time: f64) -> Ranges {
    let rise = v1 - v0;
    let chord = length(duration, rise);
    let (u, rest, delta) = (third_time / duration, (duration - third_time) / duration, (rise / chord).abs());
    let reach = |u1: f64| {
        let half = u1 * delta;
        chord * (u * rest / (half + Elementary::sqrt(half * half + u * rest)))
    };
    let (away, towards) = if rise < 0.0 { (reach(rest), reach(u)) } else { (reach(u), reach(rest)) };
    let line = v0 + rise * u;
    Ranges::from(Range::closed(line - towards, line + away))
}

/// With η = (vₘ − v₀)/L the same is τ²u² − u + η² ≤ 0 for ζ of the sign of δ, that is before the line has this
/// velocity, and the same from the other end after it.
pub(super) fn third_time(duration: f64, (v0, v1): (f64, f64), third_velocity: f64) -> Ranges {
    let rise = v1 - v0;
    let chord = length(duration, rise);
    let tau = duration / chord;
    let shares = |eta: f64| {
        let under_root = 1.0 - 4.0 * (tau * eta) * (tau * eta);
        let root = Elementary::sqrt(under_root.max(0.0));
        (under_root >= 0.0).then(|| (2.0 * eta * eta / (1.0 + root), (1.0 + root) / (2.0 * tau * tau)))
    };
    let from_start = shares((third_velocity - v0) / chord);
    let from_end = shares((third_velocity - v1) / chord).map(|(low, high)| (1.0 - high, 1.0 - low));
    // The line's own time, as a share; a level line has no other velocity than its own.
    let line = (third_velocity - v0) / rise;
    let range = if !line.is_finite() || line >= 1.0 {
        from_start
    } else if line <= 0.0 {
        from_end
    } else {
        from_start.zip(from_end).map(|((low, _), (_, high))| (low, high))
    };
    let Some((low, high)) = range else { return Ranges::NONE };
    let low = if low > 0.0 { Included(low * duration) } else { Excluded(0.0) };
    let high = if high < 1.0 { Included(high * duration) } else { Excluded(duration) };
    Ranges::from(Range::new(low, high))
}

/// √(T² + Δv²) without overflow.
fn length<F: Elementary>(duration: F, rise: F) -> F {
    let most = F::from_f64(duration.value().max(rise.value().abs()));
    let (x, y) = (duration / most, rise / most);
    most * (x * x + y * y).sqrt()
}

/// (2q − sin 2q)/(8 sin²q): the area of a segment over the square of its chord.
fn segment_over_chord<F: Elementary>(q: F) -> F {
    let (sine, cosine) = q.sin_cos();
    let two = F::from_f64(2.0);
    if q.value().abs() < FRAC_PI_4 {
        let stretch = if sine.value().abs() > 0.0 { q / sine } else { F::from_f64(1.0) };
        q * segment_by_cube(two * two * q * q) * stretch * stretch
    } else {
        segment(two * q, two * sine * cosine) / (F::from_f64(8.0) * sine * sine)
    }
}

/// The number, or zero for what rounding leaves below it.
fn positive<F: Elementary>(x: F) -> F {
    if x.value() < 0.0 { F::from_f64(0.0) } else { x }
}
