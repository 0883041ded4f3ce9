//! Three determinants of gait: pelvic tilt, flexion of the stance knee, compass gait (thesis, chapter 7).
//!
//! A cycle covers one step in two phases. Phase 1 lowers the body onto the bent stance leg, hip above ankle, and brings the
//! other leg to lift-off; phase 2 stretches both legs and tilts the pelvis back, till both feet are flat and half a step from
//! the hips. The angles at the end of each phase follow in closed form from a step length and four angles:
//!
//! ```
//! use solaris_gait::determinants::{Cycle, Proportions, three};
//!
//! let p = Proportions::drillis_contini(1.75);
//! let parameters = three::ThreeParameters::automatic(&p, 0.735)?;
//! let angles = parameters.solve(&p)?;
//! let arms = three::ArmCoefficients::default();
//! let phases = three::phases(&angles, &arms, Cycle::Intermediate);
//! assert!((angles.alpha.to_degrees() - 25.32).abs() < 0.01);
//! assert_eq!(phases.len(), 2);
//! # Ok::<(), solaris_gait::determinants::Infeasible>(())
//! ```
//!
//! The thesis solves quadratic inequalities and picks a solution by a table of signs. Here the angle of the *thigh* is the free
//! choice: the shank follows in closed form and without jumps, and what is feasible is an interval ([`chi_range()`]). The
//! thesis's rule is kept in [`printed`], to recompute its tables.

mod angles;
mod arms;
mod automatic;
mod bounds;
mod chain;
mod parameters;
mod phases;
pub mod printed;
mod tables;
mod times;

pub use angles::ThreeAngles;
pub use arms::{ArmCoefficients, ArmRefusal};
pub use bounds::{LiftOffRanges, chi_range, lift_off_ranges, tilt_range};
pub use parameters::{PARAMETERS, ThreeParameters, parameters_of};
pub use phases::{phases, start};
pub use tables::{TABLES, table};
pub use times::{Division, parts_of_step};
