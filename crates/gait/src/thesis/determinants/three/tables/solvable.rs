//! Table 7.8: for which δ and χ all four constraints can be kept.

use super::choice::solvable_as_type_5;
use crate::thesis::determinants::three::printed::{GridPoint, grid, tilts};
use crate::thesis::determinants::{Cell, GaitTable, Proportions};

/// What a statement of the table says, in a form that can be computed.
#[derive(Clone, Copy)]
enum Says {
    /// Every flexion below α is solvable at every tilt.
    All,
    /// … at every tilt from this one on and at none below (°).
    AllFrom,
    /// The first solvable flexion at this tilt (°).
    First(f64),
    /// The first tilt at which anything is solvable, with its first flexion.
    FirstTilt,
    /// The only tilt at which anything is solvable, with its first flexion.
    OnlyTilt,
    /// All tilts are solvable somewhere; the flexions.
    Around,
}

/// Step frequency, printed upper limit of χ (°), of what it speaks, and what it says.
#[rustfmt::skip]
const PRINTED: [(u32, &str, Says, &str); 15] = [
    ( 20, "4.96",  Says::All,         "all δ"),
    ( 40, "9.95",  Says::AllFrom,     "all δ but 1"),
    ( 40, "9.95",  Says::First(1.0),  "3"),
    ( 60, "15",    Says::First(1.0),  "9"),
    ( 60, "15",    Says::AllFrom,     "from δ = 4"),
    ( 80, "20.2",  Says::First(1.0),  "13"),
    ( 80, "20.2",  Says::AllFrom,     "from δ = 8"),
    (100, "25.6",  Says::First(1.0),  "21"),
    (100, "25.6",  Says::AllFrom,     "only δ = 10"),
    (120, "31.24", Says::First(1.0),  "30"),
    (120, "31.2",  Says::First(10.0), "22"),
    (140, "37.2",  Says::FirstTilt,   "δ = 4, 37"),
    (140, "37.2",  Says::First(10.0), "34"),
    (160, "43.75", Says::OnlyTilt,    "only δ = 10, 43"),
    (180, "51",    Says::Around,      "all δ, around 51"),
];

pub(super) fn solvable() -> GaitTable {
    let points = grid(&Proportions::FIT);
    let columns = ["sf", "α, upper limit of χ", "Of", "Solvable"];
    let rows = PRINTED.iter().map(|(frequency, limit, says, printed)| {
        let here: Vec<&GridPoint> =
            points.iter().filter(|point| point.step_frequency == *frequency).collect();
        let alpha = here.first().map_or(0.0, |point| point.alpha.to_degrees());
        let computed = says.compute(&here);
        let agrees = match says {
            // "Around 51" is no limit: all tilts have solutions, up to 51.
            Says::Around => computed.starts_with("all δ") && computed.ends_with(" 51"),
            _ => computed == *printed,
        };
        vec![
            Cell::plain(frequency.to_string()),
            Cell::plain(format!("{alpha:.2} (printed {limit})")),
            Cell::plain(says.text()),
            Cell::beside(computed, *printed, agrees),
        ]
    });
    GaitTable {
        number: "7.8",
        title: "solvable parameters (steps/min, °)",
        columns: columns.map(str::to_owned).to_vec(),
        rows: rows.collect(),
        notes: vec![
            "Computed with the thesis's rule and the proportions that fit best; only θ₃ of the last block of table 7.4 counts, \
             which rescues the first flexions at δ = 1° of 40, 60 and 80 steps/min. The upper limits are α."
                .to_owned(),
            "4 and 8 at 60 and 80 steps/min are the places of 3.0 and 5.0 in a list of tilts that starts with 0 at 1°; as degrees \
             they would need a pelvis that table 7.7 rules out. 4 at 140 is 4.5 truncated. All three are guesses."
                .to_owned(),
            "160 steps/min has one solvable point and 180 has all tilts because χ goes by whole degrees: α is 43.75° and 51.07°."
                .to_owned(),
            "Exactly, 2679 points are feasible and not 1259: see table 7.4.".to_owned(),
        ],
    }
}

/// Whether every flexion below α is solvable at this tilt (°).
fn whole(here: &[&GridPoint], tilt: f64) -> bool {
    let mut below = here.iter().filter(|point| {
        (point.tilt - tilt).abs() < 0.1 && f64::from(point.flexion).to_radians() < point.alpha
    });
    below.all(|point| solvable_as_type_5(point))
}

/// First solvable flexion (°) at each tilt.
fn firsts(here: &[&GridPoint]) -> Vec<(f64, Option<u32>)> {
    let first = |tilt: f64| {
        let mut at = here.iter().filter(|point| (point.tilt - tilt).abs() < 0.1);
        at.find(|point| solvable_as_type_5(point)).map(|point| point.flexion)
    };
    tilts().map(|tilt| (tilt, first(tilt))).collect()
}

impl Says {
    fn text(self) -> &'static str {
        match self {
            Self::All | Self::AllFrom => "tilts with all χ",
            Self::First(tilt) if tilt > 5.0 => "first χ at δ = 10",
            Self::First(_) => "first χ at δ = 1",
            Self::FirstTilt => "first tilt, its first χ",
            Self::OnlyTilt | Self::Around => "tilts, their χ",
        }
    }

    fn compute(self, here: &[&GridPoint]) -> String {
        let firsts = firsts(here);
        let solved: Vec<(f64, u32)> =
            firsts.iter().filter_map(|(tilt, first)| first.map(|first| (*tilt, first))).collect();
        let every = |tilts: &[(f64, u32)]| tilts.len() == firsts.len();
        match self {
            Self::All | Self::AllFrom => {
                // From there on: what is whole further down does not count.
                let all: Vec<f64> = tilts().collect();
                let last_broken = all.iter().rposition(|tilt| !whole(here, *tilt));
                match all.get(last_broken.map_or(0, |i| i + 1)) {
                    Some(from) if *from < 1.25 => "all δ".to_owned(),
                    Some(from) if *from < 1.75 => "all δ but 1".to_owned(),
                    Some(from) if *from > 9.75 => "only δ = 10".to_owned(),
                    Some(from) => format!("from δ = {from:.1}"),
                    None => "none".to_owned(),
                }
            }
            Self::First(at) => firsts
                .iter()
                .find(|(tilt, _)| (tilt - at).abs() < 0.1)
                .and_then(|(_, first)| *first)
                .map_or("none".to_owned(), |first| first.to_string()),
            Self::FirstTilt => {
                solved.first().map_or("none".to_owned(), |(tilt, first)| format!("δ = {tilt}, {first}"))
            }
            Self::OnlyTilt => {
                let tilts: Vec<String> = solved.iter().map(|(tilt, _)| tilt.to_string()).collect();
                let first = solved.first().map_or(0, |(_, first)| *first);
                format!("only δ = {}, {first}", tilts.join(" and "))
            }
            Self::Around => {
                let (low, high) =
                    solved.iter().fold((u32::MAX, 0), |(low, high), (_, f)| (low.min(*f), high.max(*f)));
                let which = if every(&solved) { "all δ" } else { "some δ" };
                format!("{which}, {low} to {high}")
            }
        }
    }
}
