//! A crowd: people by chance, none like another, each from a seed.

use crate::request::variability::Chance;
use crate::request::{Change, Population, StyleSheet, Variability, WalkRequest};

/// Height of adults (m) and its standard deviation; the same of the body mass index (kg/m²). From memory, not looked up: about what
/// surveys of adults of both sexes have.
const HEIGHT: (f64, f64) = (1.70, 0.09);
const BODY_MASS_INDEX: (f64, f64) = (24.5, 3.2);
/// Bounds of what is drawn of the index.
const INDICES: (f64, f64) = (18.5, 36.0);
/// Median heights (m) at ages (years), from memory, not looked up.
const GROWTH: [(f64, f64); 7] =
    [(6.0, 1.16), (8.0, 1.28), (10.0, 1.39), (12.0, 1.50), (14.0, 1.62), (16.0, 1.69), (18.0, 1.70)];
/// Parts by which people differ (standard deviations): step frequency and length that nobody asked for, arm swing, and the turn and bend of
/// the thorax; then degrees of the foot's turn and of the thorax' lean. An artist's choice but for the first two, which are those of the
/// young people on a treadmill (Fukuchi 2018): 6.5 of 116 steps/min, 0.00028 of 0.00327.
const DIFFERENT: [(&str, f64, f64); 7] = [
    ("cadence", 0.04, 0.0),
    ("step_length", 0.03, 0.0),
    ("arm_swing", 0.12, 0.0),
    ("thorax_rotation", 0.10, 0.0),
    ("thorax_bend", 0.08, 0.0),
    ("foot_yaw", 0.0, 1.5),
    ("thorax_lean", 0.0, 1.2),
];
/// Ages up to which and from which a person walks as a child and as an older one (years).
const AGES: (f64, f64) = (14.0, 65.0);

/// Somebody of a crowd: what a seed draws where nothing else is asked for.
///
/// ```
/// use solaris_gait::{WalkRequest, crowd::Somebody, walk_in_part};
///
/// for seed in 0..3 {
///     let somebody = Somebody::drawn(seed, None);
///     let figure = solaris_model::human(somebody.height, somebody.mass)?;
///     let (plan, part) = walk_in_part(&figure, &somebody.dress(&WalkRequest::default()))?;
///     assert!(part > 0.0 && plan.steps() == 10);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Somebody {
    /// Whose differences.
    pub seed: u64,
    /// Standing height (m).
    pub height: f64,
    /// Mass (kg).
    pub mass: f64,
    /// Whose step length.
    pub population: Population,
    /// How the style differs from everybody's.
    pub sheet: StyleSheet,
}

impl Somebody {
    /// Of a seed, and of an age (years) if it is known.
    pub fn drawn(seed: u64, age: Option<f64>) -> Self {
        let chance = Chance(seed);
        // Steps have numbers; what is once for all has this one.
        let by = |which: u64| chance.normal(u64::MAX - 1, which);
        let (median, spread) = age.map_or(HEIGHT, |age| (grown(age), HEIGHT.1 * grown(age) / HEIGHT.0));
        let height = (median + spread * by(0)).clamp(0.9, 2.1);
        let index = (BODY_MASS_INDEX.0 + BODY_MASS_INDEX.1 * by(1)).clamp(INDICES.0, INDICES.1);
        // Children are leaner.
        let index = age.filter(|age| *age < 18.0).map_or(index, |age| index * (0.66 + 0.34 * age / 18.0));
        let sheet =
            DIFFERENT.iter().zip(2..).fold(StyleSheet::default(), |sheet, ((name, part, add), which)| {
                let chance = by(which);
                sheet.with(name, Change { factor: 1.0 + part * chance, add: add * chance })
            });
        let population = age.map_or(Population::Adult, population_of);
        Self { seed, height, mass: index * height * height, population, sheet }
    }

    /// A walk that is asked for, as this person walks it: in the manner that is asked for with the person's own on top, of the person's
    /// population where that of the request is the usual one, and with steps that differ, unless it is asked how.
    #[must_use]
    pub fn dress(&self, request: &WalkRequest) -> WalkRequest {
        let population = match request.population {
            Population::Adult => self.population,
            other => other,
        };
        let variability = request.variability.or(Some(Variability { scale: 1.0, seed: self.seed }));
        WalkRequest { population, sheet: request.sheet.plus(&self.sheet), variability, ..request.clone() }
    }
}

/// The population of somebody of this age (years).
fn population_of(age: f64) -> Population {
    if age < AGES.0 {
        Population::Child
    } else if age >= AGES.1 {
        Population::Older
    } else {
        Population::Adult
    }
}

/// Median height at an age (m).
fn grown(age: f64) -> f64 {
    let age = age.clamp(GROWTH[0].0, GROWTH[GROWTH.len() - 1].0);
    let above = GROWTH.partition_point(|(at, _)| *at < age).clamp(1, GROWTH.len() - 1);
    let ((a, low), (b, high)) = (GROWTH[above - 1], GROWTH[above]);
    low + (high - low) * (age - a) / (b - a)
}

/// The seed of the `index`-th person of a crowd.
pub fn seed_of(crowd: u64, index: u64) -> u64 {
    crate::request::variability::mixed(crowd.wrapping_mul(0x2545_f491_4f6c_dd1d).wrapping_add(index))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn people_are_drawn_within_people() {
        for index in 0..500 {
            let age = (index % 3 == 0).then_some(6.0 + (index % 80) as f64);
            let somebody = Somebody::drawn(seed_of(1, index), age);
            assert_eq!(somebody, Somebody::drawn(seed_of(1, index), age));
            assert!((0.9..=2.1).contains(&somebody.height), "{somebody:?}");
            let index = somebody.mass / somebody.height.powi(2);
            assert!((12.0..=36.0).contains(&index), "{somebody:?}");
        }
        assert!((grown(6.0) - 1.16).abs() < 1e-12 && (grown(13.0) - 1.56).abs() < 1e-12);
        assert!((grown(18.0) - grown(70.0)).abs() < 1e-12);
    }
}
