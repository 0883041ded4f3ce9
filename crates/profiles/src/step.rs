//! Smooth steps from 0 to 1 and a smooth bump, held outside of [0, 1].

use crate::sample::Sample;

/// `3t² − 2t³`: rises with zero velocity at both ends.
#[doc(alias = "smoothstep")]
#[inline]
pub fn cubic(t: f64) -> Sample {
    inside(t, |t| Sample {
        position: t * t * (3.0 - 2.0 * t),
        velocity: 6.0 * t * (1.0 - t),
        acceleration: 6.0 - 12.0 * t,
        jerk: -12.0,
    })
}

/// `10t³ − 15t⁴ + 6t⁵`: rises with zero velocity and acceleration at both ends.
#[doc(alias = "smootherstep")]
#[inline]
pub fn quintic(t: f64) -> Sample {
    inside(t, |t| Sample {
        position: t * t * t * (10.0 + t * (6.0 * t - 15.0)),
        velocity: 30.0 * t * t * (1.0 - t) * (1.0 - t),
        acceleration: 60.0 * t * (1.0 - t) * (1.0 - 2.0 * t),
        jerk: 60.0 * (1.0 - 6.0 * t * (1.0 - t)),
    })
}

/// `(4t(1 − t))²`: rises to 1 at ½ and falls again, with zero velocity at both ends.
#[inline]
pub fn bump(t: f64) -> Sample {
    inside(t, |t| Sample {
        position: 16.0 * t * t * (1.0 - t) * (1.0 - t),
        velocity: 32.0 * t * (1.0 - t) * (1.0 - 2.0 * t),
        acceleration: 32.0 * (1.0 - 6.0 * t * (1.0 - t)),
        jerk: 192.0 * (2.0 * t - 1.0),
    })
}

fn inside(t: f64, curve: impl Fn(f64) -> Sample) -> Sample {
    let clamped = t.clamp(0.0, 1.0);
    let sample = curve(clamped);
    // NaN is passed on, not hidden: its comparison with the span fails.
    if (0.0..=1.0).contains(&t) || t.is_nan() {
        sample
    } else {
        Sample { position: sample.position, ..Sample::default() }
    }
}
