//! What the ground did in a run.

/// What the ground did, as far as dynamics computed what touches it.
///
/// With the feature `serde` its keys are `impulse_n_s`, `damping_j`, `friction_j`, `links`, and `landings` where there are any.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ContactReport {
    /// The impulse of the ground along the world's axes (N s). With it `impulse + m·g·T` is the change of momentum where dynamics
    /// move the whole figure.
    #[cfg_attr(feature = "serde", serde(rename = "impulse_n_s"))]
    pub impulse: [f64; 3],
    /// What its damping has taken (J); part of [`crate::EnergyReport::heat`].
    #[cfg_attr(feature = "serde", serde(rename = "damping_j"))]
    pub damping: f64,
    /// What its friction has taken (J); part of [`crate::EnergyReport::heat`].
    #[cfg_attr(feature = "serde", serde(rename = "friction_j"))]
    pub friction: f64,
    /// Every link that touches the ground in a frame, in the order of the figure.
    pub links: Vec<LinkContact>,
    /// Whether the ground [plants](crate::ContactLaw::Rigid) what touches it.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub planted: bool,
    /// What came down on a ground that [plants](crate::ContactLaw::Rigid) what touches it, in the order of time.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Vec::is_empty"))]
    pub landings: Vec<Landing>,
}

/// Something came down on the ground and stayed there: velocities jumped.
///
/// With the feature `serde` its keys are `time_s`, `links`, `impulse_n_s` and `loss_j`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Landing {
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "time_s"))]
    pub time: f64,
    /// The links that came down.
    pub links: Vec<String>,
    /// The impulse of the ground on all that stands on it, along the world's axes (N s); part of [`ContactReport::impulse`].
    #[cfg_attr(feature = "serde", serde(rename = "impulse_n_s"))]
    pub impulse: [f64; 3],
    /// The kinetic energy that was lost (J); part of [`crate::EnergyReport::impacts`]. Drives that keep their motion do work on it: it can be
    /// negative.
    #[cfg_attr(feature = "serde", serde(rename = "loss_j"))]
    pub loss: f64,
}

impl ContactReport {
    /// The link that went deepest.
    pub fn deepest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// The link that slid fastest.
    pub fn fastest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.slip.total_cmp(&b.slip))
    }

    /// The link that took the most friction.
    pub fn roughest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.friction.total_cmp(&b.friction))
    }

    /// The link that slid farthest.
    pub fn farthest(&self) -> Option<&LinkContact> {
        self.links.iter().max_by(|a, b| a.slid.total_cmp(&b.slid))
    }
}

/// How one link touched the ground, as the frames show it.
///
/// With the feature `serde` its keys are the fields' names with their units: `depth_m`, `depth_time_s`, `slip_m_s`, …
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LinkContact {
    /// Its name.
    pub link: String,
    /// How long it touched (s).
    #[cfg_attr(feature = "serde", serde(rename = "touching_s"))]
    pub touching: f64,
    /// How deep it was, at most (m).
    #[cfg_attr(feature = "serde", serde(rename = "depth_m"))]
    pub depth: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "depth_time_s"))]
    pub depth_time: f64,
    /// How fast its material slid along the ground, at most, at a touch that was pressed (m/s).
    #[cfg_attr(feature = "serde", serde(rename = "slip_m_s"))]
    pub slip: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "slip_time_s"))]
    pub slip_time: f64,
    /// The friction that it took, at most: the ratio of the force along the ground to that out of it.
    pub friction: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "friction_time_s"))]
    pub friction_time: f64,
    /// How long it took more than the ground's coefficient of friction (s): it ought to have slipped.
    #[cfg_attr(feature = "serde", serde(rename = "slipping_s"))]
    pub slipping: f64,
    /// How far it slid while it touched (m): the mean of its contact points, each with the weight of its pressure, added up over the time.
    #[cfg_attr(feature = "serde", serde(rename = "slid_m"))]
    pub slid: f64,
}
