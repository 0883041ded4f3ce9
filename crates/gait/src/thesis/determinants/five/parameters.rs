//! The eight parameters of five determinants, with their ranges.

use super::super::proportions::Proportions;
use crate::condition::KeyParameter;
use crate::error::{GaitError, RequestError};

/// The eight quantities that decide all others. Angles in rad, lengths in the unit of the [`Proportions`].
///
/// # Source
///
/// Vasilonikolidakis (1991), §8.6, asks for seven: θ, δ, φ, d, p, κ and S, and picks τ out of (8.25) for a β that its own
/// inequalities have picked. Three picks replaced by their equations, fourteen quantities less six equations leave eight: τ
/// is asked for too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveParameters {
    /// Step length, from heel print to heel print (S; the thesis calls it stride).
    pub step_length: f64,
    /// Pitch of the rear leg, straight, when the other one has stretched forward to strike (θ).
    pub heel_strike_angle: f64,
    /// Greatest pelvic tilt (δ): by how much the rear hip is lower at heel strike.
    pub tilt: f64,
    /// Pitch of the thigh that lifts off, backwards (φ).
    pub thigh_lift_off: f64,
    /// Pitch of the thigh of the leg that swings past, forwards (κ).
    pub thigh_swing: f64,
    /// Greatest pelvic rotation (τ).
    pub rotation: f64,
    /// Height of the swinging foot's lowest point while it passes (d).
    pub clearance: f64,
    /// Height of its flat sole before the last descent (p).
    pub landing_height: f64,
}

/// The parameters as people write them, in the order of [`FiveParameters::values`]. Lengths' ranges are for 1.75 m; see
/// [`parameters_of`].
pub const PARAMETERS: &[KeyParameter; 8] = &[
    parameter("step-length", "S", "heel print to heel print", " m", (0.0, 2.0)),
    parameter(
        "heel-strike-angle",
        "θ",
        "pitch of the rear leg before the other heel strikes",
        "°",
        (0.0, 60.0),
    ),
    parameter("tilt", "δ", "greatest pelvic tilt", "°", (0.0, 20.0)),
    parameter("thigh-lift-off", "φ", "backward pitch of the thigh that lifts off", "°", (-30.0, 80.0)),
    parameter("thigh-swing", "κ", "forward pitch of the thigh that swings past", "°", (0.0, 80.0)),
    parameter("rotation", "τ", "greatest pelvic rotation", "°", (0.0, 30.0)),
    parameter("clearance", "d", "height of the swinging foot while it passes", " m", (0.0, 0.2)),
    parameter("landing-height", "p", "height of the flat foot before it lands", " m", (0.0, 0.2)),
];

/// The height that [`PARAMETERS`] and the presets are for (m).
pub(super) const HEIGHT: f64 = 1.75;

const fn parameter(
    name: &'static str,
    symbol: &'static str,
    help: &'static str,
    unit: &'static str,
    range: (f64, f64),
) -> KeyParameter {
    KeyParameter { name, symbol, help, unit, range }
}

/// The parameters with lengths' ranges in proportion to a body's height.
pub fn parameters_of(p: &Proportions) -> [KeyParameter; 8] {
    PARAMETERS.map(|mut parameter| {
        if parameter.unit == " m" {
            let factor = p.height / HEIGHT;
            parameter.range = (parameter.range.0 * factor, parameter.range.1 * factor);
        }
        parameter
    })
}

impl FiveParameters {
    /// The values as people write them: degrees and lengths, in the order of [`PARAMETERS`].
    pub fn values(&self) -> [f64; 8] {
        [
            self.step_length,
            self.heel_strike_angle.to_degrees(),
            self.tilt.to_degrees(),
            self.thigh_lift_off.to_degrees(),
            self.thigh_swing.to_degrees(),
            self.rotation.to_degrees(),
            self.clearance,
            self.landing_height,
        ]
    }

    /// From values as people write them.
    pub fn from_values(values: [f64; 8]) -> Self {
        let [s, theta, delta, phi, kappa, tau, d, p] = values;
        Self {
            step_length: s,
            heel_strike_angle: theta.to_radians(),
            tilt: delta.to_radians(),
            thigh_lift_off: phi.to_radians(),
            thigh_swing: kappa.to_radians(),
            rotation: tau.to_radians(),
            clearance: d,
            landing_height: p,
        }
    }

    /// # Errors
    ///
    /// A value that is no number, or outside of its range.
    pub(super) fn check(&self, p: &Proportions) -> Result<(), GaitError> {
        check_proportions(p)?;
        for (parameter, value) in parameters_of(p).iter().zip(self.values()) {
            // A value that came through radians may be off by a rounding.
            let (lower, upper) = parameter.range;
            let slack = 1e-12 * (upper - lower);
            if !(lower - slack..=upper + slack).contains(&value) {
                return Err(out_of(parameter, value));
            }
        }
        Ok(())
    }
}

fn out_of(parameter: &KeyParameter, value: f64) -> GaitError {
    let (lower, upper) = parameter.range;
    RequestError::Range {
        parameter: parameter.name,
        value,
        unit: parameter.unit,
        lower,
        upper,
        why: String::new(),
    }
    .into()
}

/// # Errors
///
/// A length that is no number, or negative; bones, forefoot and height have to be positive.
pub(super) fn check_proportions(p: &Proportions) -> Result<(), GaitError> {
    let positive =
        [("thigh", p.thigh), ("shank", p.shank), ("ankle to ball", p.ball_ahead), ("height", p.height)];
    let others = [
        ("ankle height", p.ankle_height),
        ("ankle to heel", p.heel_behind),
        ("ball below the ankle", p.ball_below),
        ("ball above the sole", p.ball_height),
        ("toe", p.toe),
        ("distance of the hips", p.hips),
    ];
    let amiss = positive
        .iter()
        .find(|(_, value)| !(value.is_finite() && *value > 0.0))
        .or_else(|| others.iter().find(|(_, value)| !(value.is_finite() && *value >= 0.0)));
    match amiss {
        None => Ok(()),
        Some((name, value)) => Err(RequestError::Range {
            parameter: name,
            value: *value,
            unit: " m",
            lower: 0.0,
            upper: f64::INFINITY,
            why: "; proportions are finite, and bones, foot and height longer than nothing".to_owned(),
        }
        .into()),
    }
}

/// # Errors
///
/// A quantity that is no number within its bounds.
pub(super) fn check_range(
    parameter: &'static str,
    value: f64,
    unit: &'static str,
    (lower, upper): (f64, f64),
    why: &str,
) -> Result<(), GaitError> {
    if (lower..=upper).contains(&value) {
        return Ok(());
    }
    Err(RequestError::Range { parameter, value, unit, lower, upper, why: why.to_owned() }.into())
}
