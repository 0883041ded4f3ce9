//! Five determinants of gait: those three, pelvic rotation and the plantar flexion of the foot that leaves (thesis, chapter 8).
//!
//! Printed, the model does not close: three of its angles are picked out of inequalities. Here these inequalities' equations
//! take their place, so that eight parameters decide everything in closed form and feet neither slide nor float. The printed
//! model has its ankles on the ground; the same forms serve real feet, with heels.
//!
//! ```
//! use solaris_gait::determinants::{Cycle, Proportions, five};
//!
//! let body = Proportions::drillis_contini(1.75);
//! let parameters = five::FiveParameters::automatic(&body, 110.0, 0.77)?;
//! let angles = five::solve(&body, &parameters)?;
//! assert!(angles.alpha > angles.chi && angles.beta > parameters.heel_strike_angle);
//! let upper = five::Upper::automatic(&angles, 0.77 * 110.0 / 60.0);
//! assert_eq!(five::phases(&angles, &upper, Cycle::Intermediate).len(), 4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arms;
mod automatic;
mod closed;
mod conditions;
mod cycles;
mod parameters;
mod presets;
mod rise;
mod sides;
mod sway;
mod tables;
mod times;
mod trunk;

pub use arms::{ArmCoefficients, arm_remarks};
pub use automatic::AUTOMATIC_STEP;
pub use closed::{FiveAngles, close, solve};
pub use conditions::{conditions, remarks};
pub use cycles::{Upper, phases, posture_before};
pub use parameters::{FiveParameters, PARAMETERS, parameters_of};
pub use presets::Family;
pub use sway::{PelvicSway, sway_amplitude};
pub use tables::table;
pub use times::{Timing, pelvis_travel};
pub use trunk::{NECK, TrunkAmplitudes, thesis_speed};
