//! Parts of the numbers of a walk: its postures and its forces.

use serde::Serialize;
use solaris::analysis::RootReport;
use solaris::gait::{PostureComparison, WalkForces};

/// What the key postures of the thesis's style are.
#[derive(Debug, Serialize)]
pub(crate) struct KeyPostures {
    pub(crate) determinants: usize,
    /// Name, symbol, value, unit.
    pub(crate) parameters: Vec<(&'static str, &'static str, f64, &'static str)>,
    /// Symbol, what it is, degrees.
    pub(crate) angles_deg: Vec<(&'static str, &'static str, f64)>,
    /// What the thesis asks for besides, and these do not have.
    pub(crate) remarks: Vec<String>,
}

/// A smooth walk less the key postures of the same step.
#[derive(Debug, Serialize)]
pub(crate) struct BesideKeyPostures {
    pub(crate) determinants: usize,
    pub(crate) postures: Vec<PostureComparison>,
}

/// What is told of the forces.
#[derive(Debug, Serialize)]
pub(crate) struct Forces {
    #[serde(flatten)]
    pub(crate) found: WalkForces,
    /// Where they were computed from the foot that stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) roots: Option<RootReport>,
}
