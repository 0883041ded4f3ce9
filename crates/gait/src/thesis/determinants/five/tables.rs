//! Tables 8.1 to 8.7, corrected, beside what is printed.

mod picks;
mod upper;

use super::super::table::GaitTable;

/// A table of chapter 8 by its number, `8.1` to `8.7`.
///
/// 8.1, 8.2, 8.3, 8.6 and 8.7 are rotations of joints in the thesis's letters. 8.4 and 8.5 are rules by which the thesis
/// chooses angles; their notes count what these pick for the fifteen presets.
pub fn table(number: &str) -> Option<GaitTable> {
    match number {
        "8.1" => Some(intermediate()),
        "8.2" => Some(starting()),
        "8.3" => Some(finishing()),
        "8.4" => Some(picks::beta()),
        "8.5" => Some(picks::psi()),
        "8.6" => Some(upper::arms()),
        "8.7" => Some(upper::trunk()),
        _ => None,
    }
}

const JOINTS: [&str; 12] = [
    "phase",
    "root",
    "tilt",
    "rotation",
    "st. hip",
    "st. knee",
    "st. ankle",
    "st. toes",
    "sw. hip",
    "sw. knee",
    "sw. ankle",
    "sw. toes",
];

const HIPS: &str = "The hips' entries are what keeps the pelvis upright: the sum of a leg's turns from root to hip. With the \
    printed noughts it pitches by −(α + β) a step, 50.7° at 110 steps/min.";
const YAW: &str = "The rotation is τ, 3τ/5, 0, −3τ/5, −τ at the ends of phases 0 to 4, as the text has it: positive in phases 1 \
    and 2, negative and symmetric in 3 and 4. Printed signs of phases 1 and 2 would turn it away from that and not fit table \
    8.2.";
const SLAP: &str = "−α of the stance ankle in phase 2 is a turn of the whole foot about its heel; the ankle keeps its right angle.";

#[rustfmt::skip]
fn intermediate() -> GaitTable {
    GaitTable::corrected(("8.1", "rotations of joints in the intermediate cycle"), &JOINTS, 2, &[
        &["1", "swing ball", "δ", "−2τ/5|2τ/5", "α−χ", "χ", "0", "0", "β−θ|0", "0", "0", "θ−β"],
        &["2", "stance heel", "−3δ/5", "−3τ/5|3τ/5", "α−ξ|0", "ξ", "−α", "0", "β−φ", "φ−ω", "0", "−β"],
        &["3", "stance sole", "−2δ/5", "−3τ/5", "ξ−μ|0", "μ−ξ+ψ", "−ψ", "0", "κ+φ", "0", "0", "0"],
        &["4", "stance ball", "0", "−2τ/5", "μ+θ|0", "−μ−ψ", "ψ", "−θ", "χ−κ", "ω−χ−φ", "0", "0"],
    ], &[HIPS, YAW, SLAP])
}

#[rustfmt::skip]
fn starting() -> GaitTable {
    GaitTable::corrected(("8.2", "rotations of joints in the starting cycle"), &JOINTS, 2, &[
        &["3", "stance sole", "0|−2δ/5", "−3τ/5", "−μ|0", "ψ+μ", "−ψ", "0", "κ", "φ−ω", "0", "0"],
        &["4", "stance ball", "0", "−2τ/5", "μ+θ|0", "−μ−ψ", "ψ", "−θ", "χ−κ", "ω−χ−φ", "0", "0"],
    ], &[HIPS, "The pelvis is level at rest and in phase 3; the printed tilt would stay for ever."])
}

#[rustfmt::skip]
fn finishing() -> GaitTable {
    GaitTable::corrected(("8.3", "rotations of joints in the finishing cycle"), &JOINTS, 2, &[
        &["1", "swing ball", "δ", "−2τ/5|2τ/5", "α−χ", "χ", "0", "0", "β−θ|0", "0", "0", "θ−β"],
        &["2", "stance heel", "−3δ/5", "−3τ/5|3τ/5", "α−ξ|0", "ξ", "−α", "0", "β−φ", "φ−ω", "0", "−β"],
        &["3", "stance sole", "−2δ/5", "0|−τ", "ξ|0", "−ξ", "0", "0", "φ", "ω−φ", "0", "0"],
    ], &[HIPS, "The rotation goes from τ over 3τ/5 to 0, and stays there.", SLAP])
}
