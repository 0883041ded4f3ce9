//! Whether a motion, the forces that were measured beside it and the figure belong together.
//!
//! Swapped feet, the plates of another trial, a model of another person, angles in the wrong unit and a figure that lies on its side
//! all give joint forces that look like joint forces. Each check asks one thing that must be so where all fits, and what does not is a
//! [`MotionFinding`] with its value, the threshold and the likely cause. Nothing is refused.
//!
//! The thresholds are wide: they tell mistakes, not the errors of a good laboratory.

mod angles;
mod finding;
mod plates;
mod residual;
mod upright;

pub use angles::{GREATEST_DEGREES_OF_RADIANS, GREATEST_RADIANS, LEAST_RANGE, check_angles};
pub use finding::{FarCause, MotionFinding};
pub use plates::{
    AIRBORNE, AWAY, BORNE, FAR, FAR_SHARE, MISSING, OBLIQUE, PlateFit, PlateReport, SWAPPED, check_plates,
    soles_of_plates,
};
pub use residual::{RESIDUAL_FORCE, RESIDUAL_MOMENT, ResidualCheck, check_residual};
pub use upright::{TURNED, TURNED_SHARE, check_upright};
