//! The thesis's own way to θ₃ and φ, artefacts and all: **a record of the source, to recompute its tables only**.
//!
//! To plan anything use [`ThreeParameters`](super::ThreeParameters): this rule rejects half of what is feasible. It squares
//! (7.8) and (7.10) to (7.12), which turns roots past 90° back (asin), and takes the square root of a negative number where an
//! inequality holds for every angle. What it does accept is right.

use super::chain::{alpha, stance_height};
use crate::thesis::determinants::{Proportions, thesis_step_length};

/// A row of table 7.4, for roots ¹θ ≤ ²θ of the first and ³θ ≤ ⁴θ of the second inequality.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Which roots are not negative.
    pub positive: [bool; 4],
    /// The condition as printed.
    pub condition: &'static str,
    /// The solution as printed.
    pub solution: &'static str,
    holds: fn([f64; 4]) -> bool,
    value: Option<fn([f64; 4]) -> f64>,
}

fn same(a: f64, b: f64) -> bool {
    a.total_cmp(&b).is_eq()
}

const ALL: [bool; 4] = [true; 4];
/// The thesis's type 2.
const TYPE_2: [bool; 4] = [true, true, false, true];
const THIRD: [bool; 4] = [false, true, true, true];
/// The thesis's type 5, its fourth block.
const TYPE_5: [bool; 4] = [false, true, false, true];

macro_rules! row {
    ($signs:expr, $condition:literal, $solution:literal, $holds:expr, $value:expr) => {
        Row { positive: $signs, condition: $condition, solution: $solution, holds: $holds, value: $value }
    };
}

/// Table 7.4 as printed.
pub const ROWS: [Row; 16] = [
    row!(ALL, "1 > 3", "(1 + 3)/2", |[a, _, c, _]| a > c, Some(|[a, _, c, _]| 0.5 * (a + c))),
    row!(ALL, "3 = 1", "3", |[a, _, c, _]| same(c, a), Some(|[_, _, c, _]| c)),
    row!(ALL, "1 < 3 < 4 < 2", "none", |[a, b, c, d]| a < c && c < d && d < b, None),
    row!(ALL, "1 < 3 & 2 = 4", "2", |[a, b, c, d]| a < c && same(b, d), Some(|[_, b, _, _]| b)),
    row!(
        ALL,
        "1 < 3 < 2 < 4",
        "(4 + 2)/2",
        |[a, b, c, d]| a < c && c < b && b < d,
        Some(|[_, b, _, d]| 0.5 * (d + b))
    ),
    row!(TYPE_2, "1 ≥ 4", "4/2", |[a, _, _, d]| a >= d, Some(|[_, _, _, d]| 0.5 * d)),
    row!(TYPE_2, "4 > 1 & 4 < 2", "1/2", |[a, b, _, d]| d > a && d < b, Some(|[a, _, _, _]| 0.5 * a)),
    row!(TYPE_2, "4 ≥ 2", "1/2", |[_, b, _, d]| d >= b, Some(|[a, _, _, _]| 0.5 * a)),
    row!(THIRD, "3 < 2 & 4 < 2", "none", |[_, b, c, d]| c < b && d < b, None),
    row!(THIRD, "3 < 2 & 4 = 2", "2", |[_, b, c, d]| c < b && same(d, b), Some(|[_, b, _, _]| b)),
    row!(
        THIRD,
        "3 < 2 & 4 > 2",
        "(4 + 2)/2",
        |[_, b, c, d]| c < b && d > b,
        Some(|[_, b, _, d]| 0.5 * (d + b))
    ),
    row!(THIRD, "3 = 2", "2", |[_, b, c, _]| same(c, b), Some(|[_, b, _, _]| b)),
    row!(THIRD, "3 = 2", "(4 + 3)/2", |[_, b, c, _]| same(c, b), Some(|[_, _, c, d]| 0.5 * (d + c))),
    row!(TYPE_5, "4 < 2", "none", |[_, b, _, d]| d < b, None),
    row!(TYPE_5, "2 = 4", "2", |[_, b, _, d]| same(b, d), Some(|[_, b, _, _]| b)),
    row!(TYPE_5, "4 > 2", "(4 + 2)/2", |[_, b, _, d]| d > b, Some(|[_, b, _, d]| 0.5 * (d + b))),
];

/// What the rule says to one question.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// The row of [`ROWS`] that applies; none where a root is not real, or nothing is printed.
    pub row: Option<usize>,
    /// Whether all four roots are real.
    pub real: bool,
    /// The angle (rad), where there is one.
    pub angle: Option<f64>,
}

impl Choice {
    /// Whether the signs are those of type 5, which alone table 7.8 seems to accept.
    pub fn is_type_5(&self) -> bool {
        self.row.is_some_and(|row| ROWS[row].positive == TYPE_5)
    }
}

/// Both roots as printed, the lesser first; NaN where they are not real.
///
/// ```text
/// asin((Q L₃ ∓ L₂ √(L₂² + L₃² − Q²)) / (L₂² + L₃²))
/// ```
fn roots(q: f64, l2: f64, l3: f64) -> [f64; 2] {
    let squares = l2 * l2 + l3 * l3;
    let root = (squares - q * q).sqrt();
    // Rounding alone can lead past 1.
    let angle = |sine: f64| if sine.is_nan() { sine } else { sine.clamp(-1.0, 1.0).asin() };
    [angle((q * l3 - l2 * root) / squares), angle((q * l3 + l2 * root) / squares)]
}

fn choose([a, b]: [f64; 2], [c, d]: [f64; 2]) -> Choice {
    let all = [a, b, c, d];
    if all.iter().any(|root| root.is_nan()) {
        return Choice { row: None, real: false, angle: None };
    }
    let positive = all.map(|root| root >= 0.0);
    let row = ROWS.iter().position(|row| row.positive == positive && (row.holds)(all));
    let angle = row.and_then(|row| ROWS[row].value).map(|value| value(all));
    Choice { row, real: true, angle }
}

/// θ₃ by (7.9), (7.10) and table 7.4, for D and α: `Q = D − L₁ cos α`, `Q₁ = D − L₁`.
pub fn theta3(p: &Proportions, height: f64, alpha: f64) -> Choice {
    let root = |q| roots(q, p.shank, p.ball_ahead);
    choose(root(height - p.thigh * alpha.cos()), root(height - p.thigh))
}

/// φ by (7.13), (7.15) and table 7.4, for D. It does not know the step length.
pub fn phi(p: &Proportions, height: f64) -> Choice {
    choose(roots(height, p.leg(), p.ball_ahead), roots(height - p.thigh, p.shank, p.ball_ahead))
}

/// Step frequencies of the thesis's grid (steps/min).
pub const FREQUENCIES: [u32; 9] = [20, 40, 60, 80, 100, 120, 140, 160, 180];

/// Tilts of the thesis's grid (°): 1 to 10 by halves.
pub fn tilts() -> impl Iterator<Item = f64> {
    (0..19).map(|i| 1.0 + 0.5 * f64::from(i))
}

/// Flexions of the thesis's grid (°): 1 to 60.
pub const FLEXIONS: std::ops::RangeInclusive<u32> = 1..=60;

/// A point of the thesis's grid, and what the thesis makes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPoint {
    /// Steps/min; the step length is 0.004 of it times the height.
    pub step_frequency: u32,
    /// δ (°).
    pub tilt: f64,
    /// χ (°).
    pub flexion: u32,
    /// α (rad), from the step length.
    pub alpha: f64,
    /// D.
    pub height: f64,
    /// θ₃.
    pub theta3: Choice,
    /// φ.
    pub phi: Choice,
    /// Whether all four constraints hold with these θ₃ and φ.
    pub solvable: bool,
}

/// All 10 260 points: step frequencies, in these tilts, in these flexions. The feet of `p` are not looked at, but for L₃.
pub fn grid(p: &Proportions) -> Vec<GridPoint> {
    let mut points = Vec::with_capacity(10_260);
    for step_frequency in FREQUENCIES {
        let alpha = alpha(p, thesis_step_length(p.height, f64::from(step_frequency)));
        for tilt in tilts() {
            points.extend(FLEXIONS.map(|flexion| point(p, step_frequency, alpha, tilt, flexion)));
        }
    }
    points
}

fn point(p: &Proportions, step_frequency: u32, alpha: f64, tilt: f64, flexion: u32) -> GridPoint {
    let chi = f64::from(flexion).to_radians();
    let height = stance_height(p, chi) - p.hips * tilt.to_radians().sin();
    let (theta3, phi) = (theta3(p, height, alpha), phi(p, height));
    // (7.3) and (7.5).
    let thigh = |shank: f64| {
        ((height - p.shank * shank.cos() - p.ball_ahead * shank.sin()) / p.thigh).clamp(-1.0, 1.0).acos()
    };
    let solvable = theta3.angle.zip(phi.angle).is_some_and(|(theta3, phi)| {
        let (theta1, omega) = (thigh(theta3), thigh(phi));
        chi < alpha && theta1 < alpha && omega > alpha && phi > omega
    });
    GridPoint { step_frequency, tilt, flexion, alpha, height, theta3, phi, solvable }
}
