//! What is known of the forces of a sampled walk.

use crate::measure::Peak;
use solaris_analysis::ground::{GroundReport, Worst};
use solaris_analysis::{ReactionReport, Residual};

/// What is known of the forces of a sampled walk, besides the forces in it.
///
/// With the feature `serde` its keys are those of [`ReactionReport`] whichever it is, and `pulls` where the ground would have to.
#[derive(Clone, Debug, PartialEq)]
pub enum WalkForces {
    /// The plan prescribes them.
    Prescribed(ReactionReport),
    /// They are what the motion needs, and what is left at its root.
    Needed(Box<GroundReport>, Residual),
    /// The plan prescribes all of them, and what is left at the root says how far the motion is from them.
    Law(Residual),
}

/// The ground would have to pull at a foot.
///
/// With the feature `serde` its keys are `least_percent_bw`, `at_s` and `share_of_stance`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pull {
    /// The least normal force (% of body weight); negative.
    #[cfg_attr(feature = "serde", serde(rename = "least_percent_bw"))]
    pub percent: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
    /// Share of that foot's stance in which the ground would have to pull.
    #[cfg_attr(feature = "serde", serde(rename = "share_of_stance"))]
    pub share: f64,
}

impl WalkForces {
    /// Name of the rule that shares the load in double support; none where there is no double support.
    pub fn split(&self) -> Option<&'static str> {
        match self {
            Self::Prescribed(report) => Some(report.split),
            Self::Needed(report, _) => Some(report.split.name()),
            Self::Law(_) => None,
        }
    }

    /// Greatest force (N) and moment (N m) that is left at the root.
    pub fn root_residual(&self) -> [f64; 2] {
        match self {
            Self::Prescribed(report) => [report.root_force, report.root_moment],
            Self::Needed(_, residual) | Self::Law(residual) => [residual.force, residual.moment],
        }
    }

    /// How far the total force that the motion implies is from the one that was prescribed (N).
    pub fn from_prescribed(&self) -> Option<Peak> {
        match self {
            Self::Prescribed(report) => report.from_prescribed,
            Self::Law(residual) => Some(Peak { value: residual.force, time: residual.force_time }),
            Self::Needed(..) => None,
        }
    }

    /// How far the total centre of pressure is from the one that was prescribed (m).
    pub fn cop_from_prescribed(&self) -> Option<Peak> {
        match self {
            Self::Prescribed(report) => Some(report.cop_from_nominal),
            Self::Needed(..) | Self::Law(_) => None,
        }
    }

    /// Where the ground would have to pull, at worst.
    pub fn pull(&self) -> Option<Pull> {
        let Self::Needed(report, _) = self else { return None };
        let least = report.feet.iter().filter_map(|foot| foot.least);
        let Worst { value, time, share } = least.min_by(|a, b| a.value.total_cmp(&b.value))?;
        (value < 0.0).then_some(Pull { percent: 100.0 * value / report.weight, time, share })
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for WalkForces {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let ([force, moment], pull) = (self.root_residual(), self.pull());
        let mut forces = serializer.serialize_struct("WalkForces", 5 + usize::from(pull.is_some()))?;
        forces.serialize_field("double_support_split", &self.split())?;
        forces.serialize_field("root_residual_n", &force)?;
        forces.serialize_field("root_residual_n_m", &moment)?;
        forces.serialize_field("from_prescribed_n", &self.from_prescribed())?;
        forces.serialize_field("cop_from_prescribed_m", &self.cop_from_prescribed())?;
        if let Some(pull) = &pull {
            forces.serialize_field("pulls", pull)?;
        }
        forces.end()
    }
}
