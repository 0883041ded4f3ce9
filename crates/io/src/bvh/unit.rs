//! The unit of lengths, which BVH does not name.

use std::fmt;

/// What one unit of length of the file is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Unit {
    /// 1 unit = 1 cm, what most tools assume.
    #[default]
    Centimetres,
    /// 1 unit = 1 m.
    Metres,
    /// 1 unit = 1 mm.
    Millimetres,
    /// 1 unit = 1 inch (2.54 cm).
    Inches,
    /// 1 unit = 1 inch / 0.45 (5.644 cm), that of the CMU motion capture database.
    Cmu,
    /// 1 unit is so many metres.
    Of(f64),
}

impl Unit {
    /// Units of the file in one metre (1/m).
    pub fn per_metre(self) -> f64 {
        match self {
            Self::Centimetres => 100.0,
            Self::Metres => 1.0,
            Self::Millimetres => 1000.0,
            Self::Inches => 1.0 / 0.0254,
            Self::Cmu => 0.45 / 0.0254,
            Self::Of(metres) => 1.0 / metres,
        }
    }

    /// The one of those that files have in which a person of `height` units is nearest to 1.72 m.
    pub(super) fn of_person(height: f64, is_cmu: bool) -> Self {
        let off = |unit: &Self| (height / unit.per_metre() / 1.72).ln().abs();
        let known = [Self::Centimetres, Self::Metres, Self::Millimetres, Self::Inches];
        let known = known.into_iter().chain(is_cmu.then_some(Self::Cmu));
        known.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default()
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Centimetres => f.write_str("1 cm"),
            Self::Metres => f.write_str("1 m"),
            Self::Millimetres => f.write_str("1 mm"),
            Self::Inches => f.write_str("1 inch"),
            Self::Cmu => f.write_str("5.644 cm (an inch over 0.45, as the CMU database has it)"),
            Self::Of(metres) => write!(f, "{metres} m"),
        }
    }
}
