//! The way of a point through places.

use nalgebra::Vector3;
use solaris_profiles::{Curve, Profile, ProfileCurve};

/// Where the point is to be, over the time since it began.
pub(super) struct Way {
    axes: [ProfileCurve; 3],
}

impl Way {
    /// From a place at rest, through others, to the last, where it rests, along a spline.
    pub(super) fn through(begin: Vector3<f64>, keys: &[(f64, Vector3<f64>)]) -> Result<Self, String> {
        let axis = |i: usize| {
            let profile = if let [(duration, to)] = keys {
                Profile::MinimumJerk { from: begin[i], to: to[i], duration: *duration }
            } else {
                let keys = keys.iter().map(|(time, place)| (*time, place[i]));
                let keys = std::iter::once((0.0, begin[i])).chain(keys).collect();
                Profile::ClampedSpline { keys, start_velocity: 0.0, end_velocity: 0.0 }
            };
            profile.curve::<f64>().map_err(|error| error.to_string())
        };
        Ok(Self { axes: [axis(0)?, axis(1)?, axis(2)?] })
    }

    /// The place (m, world) at a time since it began (s).
    pub(super) fn at(&self, time: f64) -> Vector3<f64> {
        Vector3::from_fn(|i, _| self.axes[i].at(time).position)
    }
}

/// How much of a change is done at a part `u` of its time, with the least jerk, and its first two derivatives by `u`: 0 before, 1 after.
pub(crate) fn share(u: f64) -> [f64; 3] {
    if !(0.0..1.0).contains(&u) {
        return [if u < 0.0 { 0.0 } else { 1.0 }, 0.0, 0.0];
    }
    let left = 1.0 - u;
    [u * u * u * (10.0 - u * (15.0 - 6.0 * u)), 30.0 * u * u * left * left, 60.0 * u * left * (1.0 - 2.0 * u)]
}
