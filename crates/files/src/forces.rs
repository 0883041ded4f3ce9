//! Joint forces of a motion under all that acts on it, and whether what was measured fits.

use crate::error::FileError;
use solaris_analysis::ground::{GroundError, PlacedFeet, Sole, StanceOptions, find_stances};
use solaris_analysis::plausibility::{PlateReport, check_plates, soles_of_plates};
use solaris_analysis::{InverseOptions, InverseReport, Loads, PreparedMotion, inverse_motion, medium_forces};
use solaris_model::{Figure, MeasuredForce, Medium, Motion};
use std::path::Path;

/// What acts on a figure in its motion.
#[derive(Debug)]
pub struct Acting<'a> {
    /// What was measured.
    pub measured: &'a [MeasuredForce],
    /// What the ground does, as it was found from the motion.
    pub ground: Option<Loads>,
    /// What resists and carries its bodies.
    pub medium: &'a Medium,
    /// Whether armature, damping, springs and friction of the joints, and the medium, count.
    pub passive: bool,
}

/// Joint forces, and what they were found with.
#[derive(Debug)]
pub struct JointForces {
    /// What was measured, at the motion's times.
    pub plates: Loads,
    /// All that acts from outside, at the motion's times.
    pub loads: Loads,
    /// The forces of the joints.
    pub forces: InverseReport,
}

/// The joint forces of a figure in a motion, which was read from `path` and is `prepared`; `progress` is told how many frames are done.
///
/// # Errors
///
/// Forces that do not cover the motion, and what inverse dynamics refuse.
pub fn joint_forces(
    path: &Path,
    (figure, motion): (&Figure, &Motion),
    prepared: &PreparedMotion<'_>,
    acting: Acting<'_>,
    progress: Option<&mut dyn FnMut(usize)>,
) -> Result<JointForces, FileError> {
    let Acting { measured, ground, medium, passive } = acting;
    let plates =
        Loads::at_times(figure, measured, motion.time()).map_err(|error| FileError::input(path, &error))?;
    let mut loads = plates.clone();
    if let Some(ground) = ground {
        loads = loads.and(ground);
    }
    if passive && !medium.is_empty() {
        let forces = medium_forces(prepared, medium).map_err(|error| FileError::input(path, &error))?;
        loads = loads.and(forces);
    }
    let options = InverseOptions { passive, progress };
    let forces = inverse_motion(prepared, &loads, options).map_err(|error| FileError::input(path, &error))?;
    Ok(JointForces { plates, loads, forces })
}

/// Whether measured forces on links of the figure fit the motion that they are given to; without soles by the links that they act on.
/// None without forces or gravity. Rows that have no times are not asked when feet stand.
///
/// # Errors
///
/// What the analysis of the ground refuses.
pub fn check_measured(
    figure: &Figure,
    prepared: &PreparedMotion<'_>,
    soles: Option<Vec<Sole>>,
    measured: &[MeasuredForce],
    has_times: bool,
) -> Result<Option<PlateReport>, GroundError> {
    if measured.is_empty() || prepared.up().is_none() {
        return Ok(None);
    }
    let soles = soles.unwrap_or_else(|| soles_of_plates(figure, measured));
    if soles.is_empty() || !has_times {
        return check_plates(prepared, None, measured).map(Some);
    }
    let feet = PlacedFeet::new(prepared, soles)?;
    let stances = find_stances(&feet, &StanceOptions::default())?;
    check_plates(prepared, Some((&feet, &stances)), measured).map(Some)
}
