//! The five numbers that decide the postures, and whether they can be.

use crate::thesis::determinants::{KeyParameter, Proportions};

/// What three determinants are told (rad, and the unit of the proportions).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThreeParameters {
    /// From the ankle of one flat foot to that of the other (S; the thesis calls it stride).
    pub step_length: f64,
    /// By how much the pelvis drops on the side of the leg that lifts (δ).
    pub tilt: f64,
    /// Pitch of the stance leg's shank when the hip is above its ankle (χ).
    pub flexion: f64,
    /// Pitch of shank and foot at the lift-off of the starting cycle (θ₃).
    pub start_lift_off: f64,
    /// Pitch of shank and foot at lift-off in the other cycles (φ).
    pub lift_off: f64,
}

/// The parameters as people write them, in the order of [`ThreeParameters::values()`].
pub const PARAMETERS: &[KeyParameter] = &[
    KeyParameter {
        name: "step-length",
        symbol: "S",
        help: "from one ankle to the other when both feet are flat",
        unit: " m",
        range: (0.0, 2.0),
    },
    KeyParameter {
        name: "tilt",
        symbol: "δ",
        help: "by how much the pelvis drops on the side of the leg that lifts",
        unit: "°",
        range: (0.0, 90.0),
    },
    KeyParameter {
        name: "flexion",
        symbol: "χ",
        help: "pitch of the stance leg's shank when the hip is above its ankle",
        unit: "°",
        range: (0.0, 90.0),
    },
    KeyParameter {
        name: "start-lift-off",
        symbol: "θ₃",
        help: "pitch of shank and foot when the first foot lifts, from standing",
        unit: "°",
        range: (0.0, 90.0),
    },
    KeyParameter {
        name: "lift-off",
        symbol: "φ",
        help: "pitch of shank and foot when a foot lifts behind the body",
        unit: "°",
        range: (0.0, 90.0),
    },
];

impl ThreeParameters {
    /// In the units of [`PARAMETERS`].
    pub fn values(&self) -> [f64; 5] {
        [
            self.step_length,
            self.tilt.to_degrees(),
            self.flexion.to_degrees(),
            self.start_lift_off.to_degrees(),
            self.lift_off.to_degrees(),
        ]
    }

    /// From values in the units of [`PARAMETERS`].
    pub fn from_values(values: [f64; 5]) -> Self {
        let [step_length, tilt, flexion, start_lift_off, lift_off] = values;
        Self {
            step_length,
            tilt: tilt.to_radians(),
            flexion: flexion.to_radians(),
            start_lift_off: start_lift_off.to_radians(),
            lift_off: lift_off.to_radians(),
        }
    }
}

/// [`PARAMETERS`] with the step lengths that these legs could take at most.
pub fn parameters_of(p: &Proportions) -> Vec<KeyParameter> {
    let mut parameters = PARAMETERS.to_vec();
    parameters[0].range.1 = 2.0 * p.leg();
    parameters
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn values_are_in_degrees_and_come_back() {
        let values = [0.735, 5.0, 22.0, 70.0, 60.0];
        let there = ThreeParameters::from_values(values);
        assert_relative_eq!(there.tilt, 0.087_266, epsilon = 1e-6);
        for (back, value) in there.values().into_iter().zip(values) {
            assert_relative_eq!(back, value, epsilon = 1e-12);
        }
    }
}
