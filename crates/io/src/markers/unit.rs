//! The unit of lengths: what a file calls it, and whether its points have a subject's size in it.

use solaris_model::Vector3;
use std::fmt;

/// A unit of lengths in files of markers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LengthUnit {
    /// mm, what most systems write.
    #[default]
    Millimetres,
    /// cm.
    Centimetres,
    /// dm.
    Decimetres,
    /// m.
    Metres,
    /// 2.54 cm.
    Inches,
    /// 30.48 cm.
    Feet,
}

impl LengthUnit {
    /// What one of it is in metres.
    pub fn metres(self) -> f64 {
        match self {
            Self::Millimetres => 1e-3,
            Self::Centimetres => 1e-2,
            Self::Decimetres => 0.1,
            Self::Metres => 1.0,
            Self::Inches => 0.0254,
            Self::Feet => 0.3048,
        }
    }

    /// The unit that `text` names, in any of the spellings that files have: `mm`, `MM `, `mete`, `Meters`, `[cm]`.
    ///
    /// ```
    /// use solaris_io::markers::LengthUnit;
    /// assert_eq!(LengthUnit::named("mete"), Some(LengthUnit::Metres));
    /// assert_eq!(LengthUnit::named("furlong"), None);
    /// ```
    pub fn named(text: &str) -> Option<Self> {
        let text = text.trim_matches(|c: char| !c.is_ascii_alphabetic()).to_ascii_lowercase();
        let begins = |starts: &[&str]| starts.iter().any(|start| text.starts_with(start));
        match text.as_str() {
            "mm" => Some(Self::Millimetres),
            "cm" => Some(Self::Centimetres),
            "dm" => Some(Self::Decimetres),
            "m" => Some(Self::Metres),
            "in" => Some(Self::Inches),
            "ft" => Some(Self::Feet),
            _ if begins(&["milli"]) => Some(Self::Millimetres),
            _ if begins(&["centi", "zenti"]) => Some(Self::Centimetres),
            _ if begins(&["deci", "dezi"]) => Some(Self::Decimetres),
            _ if begins(&["met", "mtr"]) => Some(Self::Metres),
            _ if begins(&["inch"]) => Some(Self::Inches),
            _ if begins(&["foot", "feet"]) => Some(Self::Feet),
            _ => None,
        }
    }
}

impl fmt::Display for LengthUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Millimetres => "mm",
            Self::Centimetres => "cm",
            Self::Decimetres => "dm",
            Self::Metres => "m",
            Self::Inches => "in",
            Self::Feet => "ft",
        })
    }
}

/// How large the cloud of markers is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent(f64);

impl Extent {
    /// Of points (in any unit) of frames of `markers` points each: the longest side of the box around a frame's points, the
    /// median over at most a hundred frames that have two of them or more.
    pub(crate) fn of(points: &[Vector3<f64>], markers: usize) -> Option<Self> {
        let frames = points.len().checked_div(markers)?;
        let mut sides: Vec<f64> = (0..frames)
            .step_by(frames.div_ceil(100).max(1))
            .filter_map(|frame| {
                let seen =
                    points[frame * markers..][..markers].iter().filter(|p| p.iter().all(|x| x.is_finite()));
                let (mut low, mut high, mut count) =
                    (Vector3::repeat(f64::MAX), Vector3::repeat(f64::MIN), 0);
                for point in seen {
                    (low, high, count) = (low.inf(point), high.sup(point), count + 1);
                }
                (count > 1).then(|| (high - low).max())
            })
            .filter(|side| *side > 0.0)
            .collect();
        sides.sort_by(f64::total_cmp);
        sides.get(sides.len() / 2).copied().map(Self)
    }
}

/// Sizes (m) that no subject has: below the first and above the second a unit is taken for wrong.
const IMPOSSIBLE: (f64, f64) = (0.02, 30.0);
/// Sizes (m) that a subject has whose whole body carries markers.
const USUAL: (f64, f64) = (0.2, 3.0);

/// The unit in which points of `extent` are of a subject's size, and what there is to say of it: `said` where that is possible,
/// else the one of mm, cm and m that makes it nearest to 1.7 m.
pub(crate) fn plausible(said: Option<LengthUnit>, extent: Option<Extent>) -> (LengthUnit, Option<String>) {
    const KNOWN: [LengthUnit; 3] = [LengthUnit::Millimetres, LengthUnit::Centimetres, LengthUnit::Metres];
    let Some(Extent(side)) = extent else {
        let unit = said.unwrap_or_default();
        let message = said.is_none().then(|| format!("not said and not to be seen; {unit} is taken"));
        return (unit, message);
    };
    let off = |unit: &LengthUnit| (side * unit.metres() / 1.7).ln().abs();
    let guess = KNOWN.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default();
    let size = |unit: LengthUnit| side * unit.metres();
    let is_usual = |unit| (USUAL.0..=USUAL.1).contains(&size(unit));
    match said {
        None => {
            let message =
                format!("not said; {guess} is taken, in which the markers spread over {:.3} m", size(guess));
            (guess, Some(message))
        }
        Some(unit) if is_usual(unit) => (unit, None),
        Some(unit) if (IMPOSSIBLE.0..=IMPOSSIBLE.1).contains(&size(unit)) || !is_usual(guess) => {
            let message = format!(
                "in {unit}, as the file says, the markers of a frame spread over {:.3} m, and not 0.2 to 3 m as a subject's; \
                 name the unit if it is another",
                size(unit)
            );
            (unit, Some(message))
        }
        Some(unit) => {
            let message = format!(
                "the file says {unit}, in which the markers of a frame spread over {} m; {guess} is taken, in which they \
                 spread over {:.3} m. Name the unit if that is wrong",
                short(size(unit)),
                size(guess)
            );
            (guess, Some(message))
        }
    }
}

fn short(value: f64) -> String {
    if value < 0.1 { format!("{value:.5}") } else { format!("{value:.0}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_of_a_unit_is_known() {
        for text in ["mm", "MM", " mm ", "[mm]", "Millimeters", "millimetre"] {
            assert_eq!(LengthUnit::named(text), Some(LengthUnit::Millimetres), "{text}");
        }
        for text in ["m", "M", "mete", "meters", "Metres"] {
            assert_eq!(LengthUnit::named(text), Some(LengthUnit::Metres), "{text}");
        }
        assert_eq!(LengthUnit::named(""), None);
    }

    #[test]
    fn a_unit_in_which_nobody_has_that_size_is_another() {
        use LengthUnit::{Centimetres, Metres, Millimetres};
        let extent = |side| Some(Extent(side));
        let of = |said, side| {
            let (unit, message) = plausible(said, extent(side));
            (unit, message.is_some())
        };
        assert_eq!(of(Some(Millimetres), 1700.0), (Millimetres, false));
        assert_eq!(of(Some(Metres), 1700.0), (Millimetres, true));
        assert_eq!(of(Some(Millimetres), 1.7), (Metres, true));
        assert_eq!(of(None, 170.0), (Centimetres, true));
        // A hand is small, and a court is large: said, and left.
        assert_eq!(of(Some(Millimetres), 100.0), (Millimetres, true));
        assert_eq!(of(Some(Metres), 10.0), (Metres, true));
        assert_eq!(plausible(None, None).0, Millimetres);
    }
}
