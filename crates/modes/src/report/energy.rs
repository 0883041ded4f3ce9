//! Where the energy of a run went.

/// Energy of the part of the figure whose motion is computed (J).
///
/// With the feature `serde` its keys are `kinetic`, `in_gravity`, `in_springs`, and their sum `total`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Of motion.
    pub kinetic: f64,
    /// In gravity.
    pub potential: f64,
    /// In springs.
    pub elastic: f64,
}

impl Energy {
    /// All of it.
    pub fn total(&self) -> f64 {
        self.kinetic + self.potential + self.elastic
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Energy {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let mut parts = serializer.serialize_struct("Energy", 4)?;
        parts.serialize_field("kinetic", &self.kinetic)?;
        parts.serialize_field("in_gravity", &self.potential)?;
        parts.serialize_field("in_springs", &self.elastic)?;
        parts.serialize_field("total", &self.total())?;
        parts.end()
    }
}

/// Where the energy of a run went (J), as far as dynamics computed it:
///
/// ```text
/// end = start + work + pushes − heat − impacts + moved
/// ```
///
/// but for the imbalance.
///
/// With the feature `serde` its keys are `start`, `end`, `work_of_drives`, `work_of_pushes` where there was any, `heat`, `lost_in_impacts`, `moved`, `imbalance` and
/// `at_play`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct EnergyReport {
    /// At the beginning.
    pub start: Energy,
    /// At the end.
    pub end: Energy,
    /// What the drives have done.
    #[cfg_attr(feature = "serde", serde(rename = "work_of_drives"))]
    pub work: f64,
    /// What pushes of the world have done.
    #[cfg_attr(feature = "serde", serde(rename = "work_of_pushes", skip_serializing_if = "is_none"))]
    pub pushes: f64,
    /// What dampers and friction have taken.
    pub heat: f64,
    /// What impacts have taken.
    #[cfg_attr(feature = "serde", serde(rename = "lost_in_impacts"))]
    pub impacts: f64,
    /// What came with links that were computed from then on, less what went with those that were not any more.
    pub moved: f64,
    /// The greatest difference between the energy that there was and the energy that there should have been.
    pub imbalance: f64,
    /// The energy at play: the greatest of what was exchanged, so that `imbalance/scale` says how bad it is.
    #[cfg_attr(feature = "serde", serde(rename = "at_play"))]
    pub scale: f64,
}

#[cfg(feature = "serde")]
#[allow(clippy::trivially_copy_pass_by_ref, reason = "as serde asks")]
fn is_none(pushes: &f64) -> bool {
    pushes.abs() <= 0.0
}
