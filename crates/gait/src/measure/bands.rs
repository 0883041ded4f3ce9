//! Bands of human walking, held against a stride.

use super::SteadyStride;

/// A range that people's walking lies in.
#[derive(Clone, Copy, Debug)]
pub struct Band {
    /// What is measured.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The range.
    pub range: (f64, f64),
    value: fn(&SteadyStride) -> f64,
}

impl Band {
    /// A stride's value.
    pub fn value(&self, stride: &SteadyStride) -> f64 {
        (self.value)(stride)
    }
}

/// A band and where a stride lies.
///
/// With the feature `serde` its keys are `name`, `unit`, `value`, `lower`, `upper` and `inside`.
#[derive(Clone, Copy, Debug)]
pub struct BandCheck {
    /// What is measured.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The band.
    pub range: (f64, f64),
    /// The stride's value.
    pub value: f64,
    /// Whether it lies inside.
    pub inside: bool,
}

impl BandCheck {
    pub(super) fn new(name: &'static str, unit: &'static str, range: (f64, f64), value: f64) -> Self {
        Self { name, unit, range, value, inside: (range.0..=range.1).contains(&value) }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for BandCheck {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let (lower, upper) = &self.range;
        let mut check = serializer.serialize_struct("BandCheck", 6)?;
        check.serialize_field("name", self.name)?;
        check.serialize_field("unit", self.unit)?;
        check.serialize_field("value", &self.value)?;
        check.serialize_field("lower", lower)?;
        check.serialize_field("upper", upper)?;
        check.serialize_field("inside", &self.inside)?;
        check.end()
    }
}

/// A list of bands and where a stride lies in each.
///
/// With the feature `serde` its keys are the fields' names.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct BandReport {
    /// Which list: `recipe` or `textbook`, of a run `running`.
    pub name: &'static str,
    /// Where its bands come from.
    pub source: &'static str,
    /// How many hold.
    pub inside: usize,
    /// Of how many.
    pub of: usize,
    /// Each of them.
    pub checks: Vec<BandCheck>,
}

/// Holds a stride against [`RECIPE_BANDS`] and [`TEXTBOOK_BANDS`]; one that goes backward against none.
pub fn band_reports(stride: &SteadyStride) -> Vec<BandReport> {
    if stride.backward {
        return Vec::new();
    }
    let lists = [
        ("recipe", "the bands that the walk was fitted to", RECIPE_BANDS),
        ("textbook", "textbook range, not cited", TEXTBOOK_BANDS),
    ];
    let report = |(name, source, bands)| BandReport::new(name, source, check_bands(bands, stride));
    lists.into_iter().map(report).collect()
}

impl BandReport {
    pub(super) fn new(name: &'static str, source: &'static str, checks: Vec<BandCheck>) -> Self {
        let inside = checks.iter().filter(|check| check.inside).count();
        Self { name, source, inside, of: checks.len(), checks }
    }
}

/// Holds a stride against a list of bands.
pub fn check_bands(bands: &'static [Band], stride: &SteadyStride) -> Vec<BandCheck> {
    bands.iter().map(|band| BandCheck::new(band.name, band.unit, band.range, band.value(stride))).collect()
}

const fn band(
    name: &'static str,
    unit: &'static str,
    lower: f64,
    upper: f64,
    value: fn(&SteadyStride) -> f64,
) -> Band {
    Band { name, unit, range: (lower, upper), value }
}

/// The 22 bands that the walk's recipe was fitted to.
#[rustfmt::skip]
pub const RECIPE_BANDS: &[Band] = &[
    band("mean vertical force", "%BW", 99.5, 100.5, |s| s.mean_vertical),
    band("first vertical peak", "%BW", 100.0, 120.0, |s| s.first_peak),
    band("vertical valley", "%BW", 65.0, 85.0, |s| s.valley),
    band("second vertical peak", "%BW", 100.0, 120.0, |s| s.second_peak),
    band("braking force", "%BW", -25.0, -10.0, |s| s.braking),
    band("pushing force", "%BW", 10.0, 25.0, |s| s.pushing),
    band("knee at contact", "°", 0.0, 10.0, |s| s.knee_contact),
    band("knee in loading", "°", 12.0, 25.0, |s| s.knee_loading),
    band("knee in swing", "°", 55.0, 70.0, |s| s.knee_swing),
    band("hip range", "°", 38.0, 48.0, |s| s.hip_range),
    band("ankle plantarflexion", "°", -20.0, -10.0, |s| s.ankle_least),
    band("ankle dorsiflexion", "°", 8.0, 18.0, |s| s.ankle_greatest),
    band("pelvic rotation", "°", 6.0, 14.0, |s| s.pelvic_rotation),
    band("pelvic obliquity", "°", 6.0, 12.0, |s| s.pelvic_obliquity),
    band("pelvic sagittal tilt", "°", 2.0, 5.0, |s| s.pelvic_tilt),
    band("CoM rise", "cm", 3.0, 5.5, |s| s.com_vertical),
    band("CoM sway", "cm", 3.0, 6.0, |s| s.com_lateral),
    band("ankle plantarflexor moment", "N m/kg", 1.3, 1.8, |s| s.ankle_plantarflexor),
    band("knee extensor moment", "N m/kg", 0.3, 0.9, |s| s.knee_extensor),
    band("hip extensor moment", "N m/kg", 0.5, 1.0, |s| s.hip_extensor),
    band("hip flexor moment", "N m/kg", 0.5, 1.0, |s| s.hip_flexor),
    band("hip abductor moment", "N m/kg", 0.7, 1.1, |s| s.hip_abductor),
];

/// Textbook ranges; nobody has looked up where they come from.
#[rustfmt::skip]
#[doc(alias = "normative data")]
pub const TEXTBOOK_BANDS: &[Band] = &[
    band("first vertical peak", "%BW", 100.0, 120.0, |s| s.first_peak),
    band("vertical valley", "%BW", 65.0, 85.0, |s| s.valley),
    band("second vertical peak", "%BW", 100.0, 120.0, |s| s.second_peak),
    band("braking force", "%BW", -25.0, 25.0, |s| s.braking),
    band("pushing force", "%BW", -25.0, 25.0, |s| s.pushing),
    band("one double support", "% stride", 9.0, 13.0, |s| s.plate_double_support),
    band("hip range", "°", 38.0, 48.0, |s| s.hip_range),
    band("knee in swing", "°", 55.0, 70.0, |s| s.knee_swing),
    band("knee in stance", "°", 12.0, 25.0, |s| s.knee_loading),
    band("ankle plantarflexion", "°", -20.0, -10.0, |s| s.ankle_least),
    band("ankle dorsiflexion", "°", 8.0, 18.0, |s| s.ankle_greatest),
    band("pelvic obliquity", "°", 6.0, 12.0, |s| s.pelvic_obliquity),
    band("pelvic rotation", "°", 6.0, 14.0, |s| s.pelvic_rotation),
    band("pelvic sagittal tilt", "°", 2.0, 5.0, |s| s.pelvic_tilt),
    band("CoM rise", "cm", 3.0, 5.5, |s| s.com_vertical),
    band("CoM sway", "cm", 3.0, 6.0, |s| s.com_lateral),
    band("ankle plantarflexor moment", "N m/kg", 1.3, 1.8, |s| s.ankle_plantarflexor),
    band("knee extensor moment", "N m/kg", 0.3, 0.9, |s| s.knee_extensor),
    band("hip extensor moment", "N m/kg", 0.5, 1.0, |s| s.hip_extensor),
    band("hip flexor moment", "N m/kg", 0.5, 1.0, |s| s.hip_flexor),
    band("hip abductor moment", "N m/kg", 0.7, 1.1, |s| s.hip_abductor),
];
