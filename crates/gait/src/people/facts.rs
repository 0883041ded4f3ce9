//! The facts that are known of people's walking.

use crate::measure::{Band, SteadyStride, TEXTBOOK_BANDS};

/// Who walks, and how fast the steps are asked.
#[derive(Clone, Copy, Debug)]
pub struct Person {
    /// Standing height (m).
    pub height: f64,
    /// Steps a minute.
    pub step_frequency: f64,
}

/// Where a range comes from.
#[derive(Clone, Copy, Debug)]
enum Range {
    /// A textbook's, by the name of its band.
    Textbook(&'static str),
    /// A law with our margin, of the stride and the person.
    Law(fn(&SteadyStride, &Person) -> f64, fn(&SteadyStride, &Person) -> (f64, f64)),
}

/// A fact of people's walking.
#[derive(Clone, Copy, Debug)]
pub struct Fact {
    /// What it is.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Decimals to write it with.
    pub decimals: usize,
    /// Who says so.
    pub source: &'static str,
    /// Whether somebody has looked it up.
    pub looked_up: bool,
    /// What it is, where it is no fixed range.
    pub law: &'static str,
    /// One measured walk: a person of 1.80 m and 72.6 kg on a treadmill at 97.8 steps/min and 1.135 m/s.
    pub trial: Option<f64>,
    range: Range,
}

impl Fact {
    /// The walker's value.
    pub fn value(&self, stride: &SteadyStride, person: &Person) -> f64 {
        match self.range {
            Range::Textbook(name) => textbook(name).map_or(f64::NAN, |band| band.value(stride)),
            Range::Law(value, _) => value(stride, person),
        }
    }

    /// People's range.
    pub fn band(&self, stride: &SteadyStride, person: &Person) -> (f64, f64) {
        match self.range {
            Range::Textbook(name) => textbook(name).map_or((f64::NAN, f64::NAN), |band| band.range),
            Range::Law(_, range) => range(stride, person),
        }
    }
}

fn textbook(name: &str) -> Option<&'static Band> {
    TEXTBOOK_BANDS.iter().find(|band| band.name == name)
}

const TEXTBOOK: &str = "textbook range, not looked up";

const fn of_textbook(name: &'static str, unit: &'static str, decimals: usize, trial: Option<f64>) -> Fact {
    Fact {
        name,
        unit,
        decimals,
        source: TEXTBOOK,
        looked_up: false,
        law: "",
        trial,
        range: Range::Textbook(name),
    }
}

/// All facts that a steady stride has. The trial's figures were computed from its record and its force plates.
pub const FACTS: &[Fact] = &[
    Fact {
        name: "step length over height and cadence",
        unit: "1e-5 min",
        decimals: 0,
        source: "overground: Sekiya 1996 and others 0.0037 to 0.0040; 30 people on a treadmill 0.0031 ± 0.0004",
        looked_up: true,
        law: "",
        trial: Some(395.0),
        range: Range::Law(|s, p| 1e5 * s.step_length / (p.height * s.cadence), |_, _| (370.0, 400.0)),
    },
    Fact {
        name: "stance",
        unit: "% stride",
        decimals: 1,
        source: "Kirtley, Whittle and Jefferson 1985: 64.2 − 3.5 v; the margin of 2 is ours",
        looked_up: true,
        law: "64.2 − 3.5 v ± 2",
        trial: Some(63.7),
        range: Range::Law(|s, _| s.plate_stance, |s, _| (62.2 - 3.5 * s.speed, 66.2 - 3.5 * s.speed)),
    },
    Fact {
        name: "one double support, by cadence",
        unit: "% stride",
        decimals: 1,
        source: "measured: 29.4 − 0.15 sf; the margin of 1 is ours",
        looked_up: true,
        law: "29.4 − 0.15 sf ± 1",
        trial: Some(13.5),
        range: Range::Law(
            |s, _| s.plate_double_support,
            |_, p| (28.4 - 0.15 * p.step_frequency, 30.4 - 0.15 * p.step_frequency),
        ),
    },
    of_textbook("one double support", "% stride", 1, Some(13.5)),
    of_textbook("first vertical peak", "%BW", 1, Some(107.9)),
    of_textbook("vertical valley", "%BW", 1, Some(81.7)),
    of_textbook("second vertical peak", "%BW", 1, Some(111.0)),
    of_textbook("braking force", "%BW", 1, Some(-14.3)),
    of_textbook("pushing force", "%BW", 1, Some(19.0)),
    of_textbook("hip range", "°", 1, Some(43.0)),
    of_textbook("knee in swing", "°", 1, Some(68.5)),
    of_textbook("knee in stance", "°", 1, Some(22.4)),
    of_textbook("ankle plantarflexion", "°", 1, Some(-6.6)),
    of_textbook("ankle dorsiflexion", "°", 1, Some(15.1)),
    of_textbook("pelvic obliquity", "°", 1, Some(7.2)),
    of_textbook("pelvic rotation", "°", 1, Some(8.7)),
    of_textbook("pelvic sagittal tilt", "°", 1, Some(2.8)),
    of_textbook("CoM rise", "cm", 1, Some(3.3)),
    of_textbook("CoM sway", "cm", 1, Some(6.5)),
    of_textbook("ankle plantarflexor moment", "N m/kg", 2, Some(1.77)),
    of_textbook("knee extensor moment", "N m/kg", 2, Some(0.53)),
    of_textbook("hip extensor moment", "N m/kg", 2, Some(0.80)),
    of_textbook("hip flexor moment", "N m/kg", 2, Some(0.54)),
    of_textbook("hip abductor moment", "N m/kg", 2, Some(0.58)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_textbook_band_is_a_fact() {
        for band in TEXTBOOK_BANDS {
            let fact = FACTS.iter().find(|fact| fact.name == band.name).expect(band.name);
            assert!(fact.unit == band.unit && !fact.looked_up);
        }
        assert_eq!(FACTS.len(), TEXTBOOK_BANDS.len() + 3);
    }
}
