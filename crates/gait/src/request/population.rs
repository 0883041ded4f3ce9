//! Whose step length a walk has: people overground, on a treadmill, children, older people.

use super::pace::{DEFAULT_STEP_FREQUENCY, StepLaw, WALK_RATIO};
use super::sheet::{CADENCE, STEP_LENGTH, StyleSheet};
use crate::body::REFERENCE_HEIGHT;

/// Step length of people on a treadmill over height and step frequency (min): 0.0031 ± 0.0004.
const TREADMILL_RATIO: f64 = 0.0031;
/// Step length of older people over that of young ones at the same step frequency: 0.00295 over 0.00327.
const OLDER_OVER_YOUNG: f64 = 0.90;
/// How much longer each double support of older people is (parts of the stride).
const OLDER_DOUBLE_SUPPORT: f64 = 0.012;
/// Body mass indices up to which a gait is anybody's, and beyond which it changes at an even rate (kg/m²).
const HEAVY: (f64, f64) = (25.0, 30.0);

/// Length of a step backward over one forward at the same step frequency. People keep their step frequency and shorten their steps, older
/// ones more (Y. Laufer, *J. Gerontol. A* 60 (2005) 627–632, from its abstract, which does not say by how much): our choice, the ratio of
/// steps on a treadmill, at which walks forward are held against measured people.
const BACKWARD_STEP: f64 = TREADMILL_RATIO / WALK_RATIO;

/// By which part the step frequency that nobody asked for is lower at 35 kg/m².
const HEAVY_CADENCE: f64 = 0.05;

/// A law of the step length `S` at the step frequency `sf` for a person of the height `H`. With any one of speed, step frequency and
/// step length the other two follow from it.
///
/// ```
/// use solaris_gait::{Population, WalkRequest, walk};
///
/// let bo = solaris_model::human(1.75, 73.0)?;
/// let belt = WalkRequest { population: Population::Treadmill, speed: Some(1.2), ..WalkRequest::default() };
/// let style = *walk(&bo, &belt)?.style();
/// assert!((style.step_length / (1.75 * style.step_frequency) - 0.0031).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Population {
    /// Adults overground: `S = 0.0037·H·sf`.
    #[default]
    Adult,
    /// Adults on a treadmill: `S = 0.0031·H·sf`.
    Treadmill,
    /// Children, by their height: as adults of 1.741 m walk at the same Froude number. With `k = √(1.741/H)`, where that is above 1,
    /// the step frequency is k times as high and `S = 0.0037·H·sf/k`.
    Child,
    /// Older people overground: nine tenths of the adults' step at the same step frequency, and each double support longer by 1.2 % of
    /// the stride.
    Older,
}

impl Population {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Adult, Self::Treadmill, Self::Child, Self::Older];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Adult => "adult",
            Self::Treadmill => "treadmill",
            Self::Child => "child",
            Self::Older => "older",
        }
    }

    /// Where its law comes from.
    pub fn source(self) -> &'static str {
        match self {
            Self::Adult => "0.0065 m min of people of 1.75 m overground (Sekiya 1996)",
            Self::Treadmill => "thirty people at six speeds on a treadmill (Fukuchi 2018): 0.0031 ± 0.0004",
            Self::Child => {
                "dynamic similarity; Sutherland 1980 has 0.84 of the adults' ratio at 7 years, the law 0.83 (from memory, not looked up)"
            }
            Self::Older => {
                "fifteen people of 55 to 72 beside fifteen of 22 to 36 at six speeds on a treadmill (Fukuchi 2018): 0.00295 and 0.00327; \
                 double support from memory (Winter 1990), not looked up"
            }
        }
    }

    /// How many times as high as an adult's the step frequencies of somebody of this height (m) are.
    pub fn tempo(self, height: f64) -> f64 {
        match self {
            Self::Child => (REFERENCE_HEIGHT / height).max(1.0).sqrt(),
            Self::Adult | Self::Treadmill | Self::Older => 1.0,
        }
    }

    /// Step length over height and step frequency (min).
    #[doc(alias = "walk ratio")]
    pub fn walk_ratio(self, height: f64) -> f64 {
        match self {
            Self::Adult => WALK_RATIO,
            Self::Treadmill => TREADMILL_RATIO,
            Self::Child => WALK_RATIO / self.tempo(height),
            Self::Older => WALK_RATIO * OLDER_OVER_YOUNG,
        }
    }

    /// How much longer than an adult's one double support is (parts of the stride).
    pub(crate) fn longer_double_support(self) -> f64 {
        if self == Self::Older { OLDER_DOUBLE_SUPPORT } else { 0.0 }
    }
}

/// How heavy for its height a body is: 0 up to 25 kg/m², 1 at 35, and in between without a kink.
///
/// ```text
/// x = BMI − 25      x²/10 up to x = 5, then x − 2.5, both over 7.5
/// ```
pub(crate) fn heaviness(height: f64, mass: f64) -> f64 {
    let (from, knee) = HEAVY;
    let x = (mass / (height * height) - from).max(0.0);
    let width = knee - from;
    let risen = if x < width { 0.5 * x * x / width } else { x - 0.5 * width };
    risen / (1.5 * width)
}

impl StepLaw {
    /// Of a population, for a person of this height (m) and mass (kg) in some manner.
    pub(crate) fn new(population: Population, sheet: &StyleSheet, height: f64, mass: f64) -> Self {
        let tempo = population.tempo(height);
        let slower = 1.0 - HEAVY_CADENCE * heaviness(height, mass);
        Self {
            height,
            ratio: population.walk_ratio(height) * height * sheet.get(STEP_LENGTH).factor,
            adult_ratio: WALK_RATIO * height / tempo,
            tempo,
            step_frequency: DEFAULT_STEP_FREQUENCY * tempo * slower * sheet.get(CADENCE).factor,
        }
    }

    /// The same where it goes backward.
    #[must_use]
    pub(crate) fn going(self, backward: bool) -> Self {
        Self { ratio: if backward { BACKWARD_STEP * self.ratio } else { self.ratio }, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heaviness_begins_at_25_without_a_kink_and_is_1_at_35() {
        let of = |index: f64| heaviness(1.0, index);
        assert!(of(18.5) == 0.0 && of(25.0) == 0.0 && (of(35.0) - 1.0).abs() < 1e-15);
        let slope = |index: f64| (of(index + 1e-6) - of(index - 1e-6)) / 2e-6;
        assert!(slope(25.0 + 1e-5) < 1e-5 && (slope(30.0 - 1e-5) - slope(30.0 + 1e-5)).abs() < 1e-5);
    }

    #[test]
    fn a_child_walks_as_an_adult_at_the_same_froude_number() {
        let (child, adult) = (1.2, REFERENCE_HEIGHT);
        let sf = 110.0 * Population::Child.tempo(child);
        let speeds = [(child, sf), (adult, 110.0)]
            .map(|(h, sf)| Population::Child.walk_ratio(h) * h * sf * sf / (60.0 * f64::sqrt(h)));
        assert!((speeds[0] - speeds[1]).abs() < 1e-12);
        // Sutherland 1980: 143 steps/min of 0.48 m at 7 years and 1.2 m; adults 114 of 0.65 m at 1.73 m.
        let measured = (0.48 / (1.2 * 143.0)) / (0.65 / (1.73 * 114.0));
        let law = Population::Child.walk_ratio(1.2) / Population::Child.walk_ratio(1.73);
        assert!((measured - law).abs() < 0.03, "{measured} {law}");
    }
}
