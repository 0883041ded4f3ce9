//! The ground's forces of a motion, from the soles to what is wrong with them.

use crate::complete::Completed;
use crate::ground::{
    BalanceFrame, FootReport, GroundError, Sole, Split, StanceOptions, Stances, Unsupported,
};
use nalgebra::Vector3;
use solaris_model::{ContactTrack, Figure, ForceRecord};

/// How the ground's forces are to be found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GroundOptions {
    /// How feet share the wrench.
    pub split: Split,
    /// What counts as standing.
    pub stance: StanceOptions,
    /// Stances that are known; they are not looked for then.
    pub stances: Option<Stances>,
}

/// The ground's forces of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundForces {
    /// By sole, under its name: one contact a frame, zero where the foot does not stand.
    pub contacts: Vec<ContactTrack>,
    /// The whole wrench, frame by frame.
    pub total: Vec<BalanceFrame>,
    /// When which foot stands.
    pub stances: Stances,
    /// What is to be said of them.
    pub report: GroundReport,
    /// By sole, the links that carry the force.
    links: Vec<Vec<String>>,
}

/// What is to be said of forces that were found.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundReport {
    /// The figure's weight (N).
    pub weight: f64,
    /// How feet share the wrench.
    pub split: Split,
    /// Frames with several feet in which that split does not apply, and the pivot split stands in for it.
    pub replaced: usize,
    /// By sole.
    pub feet: Vec<FootReport>,
    /// Frames in which no foot stands.
    pub unsupported: Unsupported,
}

impl GroundForces {
    /// What acts on the figure, as [`crate::inverse_motion`] takes it: a record for each foot.
    pub fn records(&self) -> Vec<ForceRecord> {
        let records = self.contacts.iter().zip(&self.links).map(|(track, links)| ForceRecord {
            links: links.clone(),
            time: self.total.iter().map(|frame| frame.time).collect(),
            samples: track.samples.clone(),
        });
        records.collect()
    }
}

/// Finds the ground's forces in a motion of `figure` under `gravity` (m/s², world axes).
///
/// # Errors
///
/// Stub.
pub fn ground_forces(
    figure: &Figure,
    gravity: Vector3<f64>,
    states: &Completed,
    soles: &[Sole],
    options: &GroundOptions,
) -> Result<GroundForces, GroundError> {
    let _ = (figure, gravity, states, soles, options);
    Err(GroundError::Empty)
}
