//! Laws of timing, the thesis's and measured ones: how long a step and its double support last, and how far it goes.

/// Step length over height and step frequency in the thesis (min): `S = 0.004·H·sf`, (7.17). People's is
/// [`crate::WALK_RATIO`].
pub const THESIS_WALK_RATIO: f64 = 0.004;

/// The highest step frequency (steps/min) that has a double support by the thesis's law: 29.08/0.16 = 181.75; its (7.16)
/// says 182, where (7.20) is negative.
pub fn highest_step_frequency() -> f64 {
    29.08 / 0.16
}

/// Step length by (7.17), in the unit of the height.
pub fn thesis_step_length(height: f64, step_frequency: f64) -> f64 {
    THESIS_WALK_RATIO * height * step_frequency
}

/// How long both feet are on the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DoubleSupport {
    /// The thesis's (7.20): `2·(29.08 − 0.16·sf)` % of a step.
    #[default]
    Thesis,
    /// Measured on people: `29.4 − 0.149·sf` % of a stride, each of two.
    Measured,
}

impl DoubleSupport {
    /// As a part of a step; never less than nothing.
    ///
    /// A part of a step that one double support takes is twice the part of a stride, so both laws read alike.
    pub fn part_of_step(self, step_frequency: f64) -> f64 {
        let part_of_stride = match self {
            Self::Thesis => 29.08 - 0.16 * step_frequency,
            Self::Measured => 29.4 - 0.149 * step_frequency,
        };
        (2.0 * part_of_stride / 100.0).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_step_at_110_has_23_per_cent_of_double_support() {
        assert_relative_eq!(DoubleSupport::Thesis.part_of_step(110.0), 0.2296, max_relative = 1e-12);
        assert_relative_eq!(DoubleSupport::Measured.part_of_step(110.0), 0.2602, max_relative = 1e-12);
        assert_relative_eq!(thesis_step_length(1.75, 110.0), 0.77, max_relative = 1e-12);
        // (7.16) is past the end of (7.20).
        assert_relative_eq!(DoubleSupport::Thesis.part_of_step(182.0), 0.0);
        assert_relative_eq!(highest_step_frequency(), 181.75, max_relative = 1e-12);
    }
}
