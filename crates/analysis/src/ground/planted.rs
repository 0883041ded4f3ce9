//! The ground's forces of a motion that says itself where its feet are planted.

use crate::ground::{
    GroundError, GroundOptions, GroundReport, PlacedFeet, Split, ground_forces, soles, stances_of_planted,
};
use crate::inverse::{InverseError, InverseOptions, Residual, inverse_motion};
use crate::prepared::{PrepareError, PreparedMotion};
use solaris_model::{Figure, Motion, MotionError};

/// Why the forces of a planted motion cannot be found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlantedError {
    /// The ground's.
    #[error(transparent)]
    Ground(#[from] GroundError),
    /// The joints'.
    #[error(transparent)]
    Inverse(#[from] InverseError),
    /// The motion is not ready for it.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The forces are none.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// Finds the ground's wrench on each foot of `motion`, which stands while a point of it is planted, and the joints' forces, and
/// writes both to the motion.
///
/// The forces are whatever the motion needs: normal forces may be negative, and the report says so. The ground is the
/// motion's, at height 0 where it has none. What is left at the root is returned beside the report.
///
/// # Errors
///
/// Those of [`ground_forces`] and [`inverse_motion`], and a motion of another figure.
pub fn reactions_of_planted(
    figure: &Figure,
    motion: &mut Motion,
    split: Split,
) -> Result<(GroundReport, Residual), PlantedError> {
    let soles = soles(figure);
    let level = motion.info.ground.map_or(0.0, |ground| ground.height);
    let stances = stances_of_planted(&soles, &motion.planted, level);
    let options = GroundOptions { split, stances: Some(stances), ..GroundOptions::default() };
    let prepared = PreparedMotion::new(figure, motion)?;
    let found = ground_forces(&PlacedFeet::new(&prepared, soles)?, &options)?;
    let inverse = inverse_motion(&prepared, &found.loads(), InverseOptions::default())?;
    motion.set_tau(inverse.tau)?;
    motion.contacts.retain(|track| found.contacts.iter().all(|new| new.link != track.link));
    motion.contacts.extend(found.contacts);
    Ok((found.report, inverse.residual))
}
