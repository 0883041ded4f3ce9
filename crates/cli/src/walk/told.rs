//! Parts of the numbers of a walk: its postures and its forces.

use serde::Serialize;
use solaris::analysis::RootReport;

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
    pub(crate) postures: Vec<BesidePosture>,
}

/// A smooth walk less a key posture (degrees).
#[derive(Debug, Serialize)]
pub(crate) struct BesidePosture {
    pub(crate) posture: &'static str,
    pub(crate) at_s: f64,
    /// Thigh, shank, foot; backward and toe down are positive.
    pub(crate) stance_deg: [f64; 3],
    pub(crate) swing_deg: [f64; 3],
}

#[derive(Debug, Serialize)]
pub(crate) struct Extreme {
    pub(crate) value: f64,
    pub(crate) at_s: f64,
}

#[derive(Debug, Serialize)]
pub(crate) struct Forces {
    pub(crate) double_support_split: &'static str,
    pub(crate) root_residual_n: f64,
    pub(crate) root_residual_n_m: f64,
    /// How far the total force that the motion implies is from the one that was prescribed.
    pub(crate) from_prescribed_n: Option<Extreme>,
    pub(crate) cop_from_prescribed_m: Option<Extreme>,
    /// Where the ground would have to pull.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) pulls: Option<Pull>,
    /// Where they were computed from the foot that stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) roots: Option<Roots>,
}

/// The ground would have to pull at a foot.
#[derive(Debug, Serialize)]
pub(crate) struct Pull {
    pub(crate) least_percent_bw: f64,
    pub(crate) at_s: f64,
    /// Share of that foot's stance in which it would.
    pub(crate) share_of_stance: f64,
}

impl From<(f64, f64)> for Extreme {
    fn from((value, at_s): (f64, f64)) -> Self {
        Self { value, at_s }
    }
}

/// What computing from the foot that stands came to.
#[derive(Debug, Serialize)]
pub(crate) struct Roots {
    /// Link and time of each root.
    pub(crate) links: Vec<(String, f64)>,
    /// Greatest difference of a reaction, and of a joint's force, from those that the pelvis as the root gives.
    pub(crate) force_differs_n: f64,
    pub(crate) torque_differs_n_m: f64,
}

pub(super) fn roots(report: &RootReport) -> Roots {
    Roots {
        links: report.roots.iter().map(|(time, link)| (link.clone(), *time)).collect(),
        force_differs_n: report.reaction.0,
        torque_differs_n_m: report.torque,
    }
}
