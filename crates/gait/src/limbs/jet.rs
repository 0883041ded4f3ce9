//! The angles of a leg with their derivatives, where one piece of its way ends and the next begins.

use crate::body::leg::LegPose;
use crate::grid::{FIRST, SECOND};
use solaris_profiles::Boundary;

/// A leg's five angles with their first two derivatives by the foot's clock.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LegJet {
    pub(crate) side: Boundary,
    pub(crate) thigh: Boundary,
    pub(crate) knee: Boundary,
    pub(crate) pitch: Boundary,
    pub(crate) toes: Boundary,
}

impl LegJet {
    /// The angles.
    pub(crate) fn pose(&self) -> LegPose {
        let [side, thigh, knee, pitch, toes] =
            [self.side, self.thigh, self.knee, self.pitch, self.toes].map(|jet| jet.position);
        LegPose { side, thigh, knee, pitch, toes, tilt: 0.0 }
    }
}

/// Values and first two derivatives of several functions at once, from seven points.
pub(crate) fn jets<const D: usize>(u: f64, h: f64, f: impl Fn(f64) -> [f64; D]) -> [Boundary; D] {
    let values: [[f64; D]; 7] = std::array::from_fn(|i| f(u + h * (i as f64 - 3.0)));
    std::array::from_fn(|d| {
        let sum = |weights: &[f64; 7]| (0..7).map(|i| weights[i] * values[i][d]).sum::<f64>();
        Boundary::new(values[3][d], sum(&FIRST) / (60.0 * h), sum(&SECOND) / (180.0 * h * h))
    })
}
