//! Table 7.7: the largest θ₃ of the rule, and where it has none.

use crate::thesis::determinants::three::printed::{GridPoint, grid};
use crate::thesis::determinants::{Cell, GaitTable, Proportions};

/// What is printed: step frequency, δ, χ at the maximum, θ₃, and the flexions above and below which there is no solution.
#[rustfmt::skip]
const PRINTED: [(u32, u32, u32, u32, u32, Option<u32>); 18] = [
    ( 20, 1, 47, 90, 47, None),     ( 20, 10, 42, 90, 42, None),
    ( 40, 1, 47, 89, 47, None),     ( 40, 10, 42, 89, 42, None),
    ( 60, 1, 47, 88, 47, None),     ( 60, 10, 42, 88, 42, None),
    ( 80, 1, 48, 88, 48, None),     ( 80, 10, 43, 88, 43, None),
    (100, 1, 49, 87, 49, Some(10)), (100, 10, 44, 87, 44, Some(15)),
    (120, 1, 49, 85, 49, Some(16)), (120, 10, 45, 85, 45, Some(20)),
    (140, 1, 51, 84, 51, Some(21)), (140, 10, 46, 84, 46, Some(6)),
    (160, 1, 52, 81, 52, Some(27)), (160, 10, 47, 81, 47, Some(17)),
    (180, 1, 54, 79, 54, Some(32)), (180, 10, 49, 79, 49, Some(25)),
];

pub(super) fn theta3() -> GaitTable {
    let points = grid(&Proportions::FIT);
    let largest_phi = points.iter().filter_map(|point| point.phi.angle).fold(0.0, f64::max).to_degrees();
    let columns = ["sf", "δ", "χ at the largest θ₃", "θ₃", "none above χ", "none below χ"];
    GaitTable {
        number: "7.7",
        title: "analysis of θ₃ (steps/min, °)",
        columns: columns.map(str::to_owned).to_vec(),
        rows: PRINTED.iter().map(|printed| row(printed, &points)).collect(),
        notes: vec![
            "Computed with the proportions that fit this table and the next best; the thesis does not print its own. θ₃ counts as \
             agreeing when it is truncated or rounded to the printed one."
                .to_owned(),
            "The two cells that differ cannot be: D falls with δ, so the limit has to fall from δ = 1° to 10°, as it does at 140 \
             to 180 steps/min. At δ = 10° there is none."
                .to_owned(),
            "\"None\" is what the rule finds: it fails where an inequality holds for every θ₃ (below) and where a root passes 90° \
             (above). The exact intervals have no such gaps."
                .to_owned(),
            format!(
                "The text has a largest ω of 74° at all step frequencies. That is φ: {largest_phi:.2}°, and no formula of φ knows \
                 the step frequency."
            ),
        ],
    }
}

fn row(printed: &(u32, u32, u32, u32, u32, Option<u32>), points: &[GridPoint]) -> Vec<Cell> {
    let (frequency, tilt, at, angle, above, below) = *printed;
    let here =
        |point: &&GridPoint| point.step_frequency == frequency && (point.tilt - f64::from(tilt)).abs() < 0.1;
    let solved: Vec<(u32, f64)> = points
        .iter()
        .filter(here)
        .filter_map(|point| point.theta3.angle.map(|angle| (point.flexion, angle.to_degrees())))
        .collect();
    let largest = solved.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
    let last = solved.last().map_or(0, |(flexion, _)| *flexion);
    let first = solved.first().map(|(flexion, _)| *flexion).filter(|first| *first > 1);
    let text = |limit: Option<u32>| limit.map_or("none".to_owned(), |limit| limit.to_string());
    let beside = |computed: u32, printed: u32| {
        Cell::beside(computed.to_string(), printed.to_string(), computed == printed)
    };
    let agrees = [largest.1.trunc(), largest.1.round()].contains(&f64::from(angle));
    vec![
        Cell::plain(frequency.to_string()),
        Cell::plain(tilt.to_string()),
        beside(largest.0, at),
        Cell::beside(format!("{:.2}", largest.1), angle.to_string(), agrees),
        beside(last, above),
        Cell::beside(text(first), text(below), first == below),
    ]
}
