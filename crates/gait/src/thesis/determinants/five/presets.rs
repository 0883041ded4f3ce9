//! Named sets of parameters over the step frequency.

use super::parameters::{FiveParameters, HEIGHT, check_range};
use crate::error::GaitError;

/// A family of closed sets. They differ in how the thigh that leaves goes on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Family {
    /// The swinging thigh goes past its place at landing and comes back; the knee flexes by 46° to 49°. Conditions (iv) and
    /// (vi) do not hold. Recommended (G).
    #[default]
    Retracting,
    /// The swinging thigh goes forward until it lands: (vi) holds, (iv) does not. The knee flexes by 60° to 70°, but toes scuff
    /// between phases 3 and 4 where nothing lifts them (V).
    Advancing,
    /// All six conditions of the thesis, the second one reversed, hold at the five sets, (vi) not quite between them: the
    /// swinging knee flexes by 1° to 10° only (A).
    Stiff,
}

/// Step frequency; θ, δ, φ, κ, τ (°); d, p (mm), for 1.75 m and S = 0.004·H·sf.
type Row = [f64; 8];

#[rustfmt::skip]
const RETRACTING: [Row; 5] = [
    [ 80.0, 17.0, 3.0,  6.0, 32.0, 3.0, 15.0, 10.0],
    [ 95.0, 19.0, 3.5, 10.5, 31.0, 4.0, 15.0, 11.0],
    [110.0, 19.0, 4.0, 14.0, 31.0, 5.0, 15.0, 18.0],
    [120.0, 19.0, 4.5, 16.5, 31.0, 6.0, 15.0, 24.0],
    [130.0, 19.0, 5.0, 19.5, 31.0, 8.0, 15.0, 27.0],
];

#[rustfmt::skip]
const ADVANCING: [Row; 5] = [
    [ 80.0, 17.0, 3.0, -2.5,  4.0, 3.0, 15.0, 10.0],
    [ 95.0, 19.0, 3.5, -2.5, 11.0, 4.0, 15.0, 11.0],
    [110.0, 19.0, 4.0,  0.5, 15.0, 5.0, 15.0, 18.0],
    [120.0, 19.0, 4.5,  3.0, 17.5, 6.0, 15.0, 24.0],
    [130.0, 19.0, 5.0,  6.0, 20.0, 8.0, 15.0, 30.0],
];

#[rustfmt::skip]
const STIFF: [Row; 5] = [
    [ 80.0, 11.0, 0.0, 29.5, 10.0, 4.5, 10.0, 20.0],
    [ 95.0, 19.0, 3.5, 34.0, 12.0, 4.0, 15.0, 12.0],
    [110.0, 19.0, 4.0, 34.5, 15.5, 5.0, 15.0, 19.0],
    [120.0, 19.0, 4.5, 36.5, 16.5, 6.0, 15.0, 24.0],
    [130.0, 19.0, 5.0, 39.0, 17.0, 8.0, 15.0, 27.0],
];

impl Family {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Retracting, Self::Advancing, Self::Stiff];

    fn rows(self) -> &'static [Row; 5] {
        match self {
            Self::Retracting => &RETRACTING,
            Self::Advancing => &ADVANCING,
            Self::Stiff => &STIFF,
        }
    }
}

impl FiveParameters {
    /// A family's parameters at a step frequency (80 to 130 steps/min), for a body of some height.
    ///
    /// The sets were found for the proportions of [`super::super::Proportions::drillis_contini`], ankles on the ground, at
    /// 80, 95, 110, 120 and 130 steps/min; between, each parameter is interpolated in a straight line, and all of them close.
    /// Angles are those of any height, lengths go with it. Other proportions need not close with them: a person's with real
    /// feet do from 125 steps/min only, and never as [`Family::Advancing`]. There is [`FiveParameters::automatic`] for these.
    ///
    /// # Errors
    ///
    /// A step frequency or height out of range.
    pub fn preset(family: Family, height: f64, step_frequency: f64) -> Result<Self, GaitError> {
        check_range("height", height, " m", (f64::MIN_POSITIVE, f64::MAX), "")?;
        let why = "; the automatic parameters go further";
        check_range("step frequency", step_frequency, " steps/min", (80.0, 130.0), why)?;
        let rows = family.rows();
        let k = rows.iter().rposition(|row| row[0] <= step_frequency).unwrap_or(0).min(rows.len() - 2);
        let part = (step_frequency - rows[k][0]) / (rows[k + 1][0] - rows[k][0]);
        let between = |i: usize| rows[k][i] + part * (rows[k + 1][i] - rows[k][i]);
        let length = |i: usize| between(i) / 1000.0 * (height / HEIGHT);
        Ok(Self::from_values([
            0.004 * height * step_frequency,
            between(1),
            between(2),
            between(3),
            between(4),
            between(5),
            length(6),
            length(7),
        ]))
    }
}
