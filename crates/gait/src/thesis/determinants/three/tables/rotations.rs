//! Tables 7.1 to 7.3 and 7.6: the rotations of each phase, as formulas.

use crate::thesis::determinants::GaitTable;

const LEGS: [&str; 8] = [
    "Phase",
    "Pelvic tilt",
    "Stance ankle",
    "Stance knee",
    "Stance hip",
    "Swing hip",
    "Swing knee",
    "Swing ankle",
];

const HIP: &str = "The stance hip's column is not printed. Without it the pelvis pitches by 2α each step, 54° at 105 steps/min.";
const ANKLE: &str = "Swing ankle, phase 2: the foot is to land flat, so it turns by α against the shank; with 0 it is left toe-up \
                     by α, and each pair of swing and stance loses α.";

pub(super) fn starting() -> GaitTable {
    GaitTable::corrected(
        ("7.1", "rotations in the starting cycle"),
        &LEGS,
        1,
        &[
            &["1", "δ", "χ", "−χ − ξ", "ξ|", "−θ₁", "θ₁ + θ₃", "0|"],
            &["2", "−δ", "α − χ", "χ + ξ", "−α − ξ|", "−90° + β + θ₁", "−θ₁ − θ₃", "α|"],
        ],
        &[
            HIP,
            "The swing ankle's column is not printed either: it keeps its right angle, and then lands flat.",
        ],
    )
}

pub(super) fn intermediate() -> GaitTable {
    GaitTable::corrected(
        ("7.2", "rotations in the intermediate cycle"),
        &LEGS,
        1,
        &[
            &["1", "δ", "90° − β + χ", "−χ − ξ", "ξ − α|", "ω − α", "φ − ω", "α"],
            &["2", "−δ", "α − χ", "χ + ξ", "−α − ξ|", "−90° + β − ω", "−φ + ω", "α|0"],
        ],
        &[HIP, ANKLE],
    )
}

pub(super) fn finishing() -> GaitTable {
    GaitTable::corrected(
        ("7.3", "rotations in the finishing cycle"),
        &LEGS,
        1,
        &[
            &["1", "δ", "90° − β + χ|90° − β", "−χ − ξ|0", "ξ − α|", "ω − α", "φ − ω", "α"],
            &["2", "−δ", "−χ|0", "χ + ξ|0", "−ξ|", "−ω", "−φ + ω", "0"],
        ],
        &[
            HIP,
            "The text says that phase 1 is that of the intermediate cycle, so the stance knee bends. The printed rows have χ = 0; \
             with ω and φ of a bent knee they leave the toes in the air, by 58 mm at χ = 22° and a height of 1.75 m.",
        ],
    )
}

pub(super) fn arms() -> GaitTable {
    GaitTable::corrected(
        ("7.6", "rotations of the arms"),
        &["Cycle", "Phase", "Arm", "Shoulder", "Elbow"],
        1,
        &[
            &["starting", "1|", "stance|", "−α₁", "−α₂"],
            &["starting", "1|", "swing|", "α₃|−α₃", "0"],
            &["starting", "2|", "stance|", "−α₄ + α₁", "0"],
            &["starting", "2|", "swing|", "α₅ − α₃|−α₅ − α₃", "0"],
            &["intermediate", "1|", "stance|", "−α₅ + α₆", "−α₇"],
            &["intermediate", "1|", "swing|", "α₄ − α₈|−α₄ − α₈", "α₂ − α₉"],
            &["intermediate", "2|", "stance|", "−α₆ − α₄", "−α₂ + α₇"],
            &["intermediate", "2|", "swing|", "α₈ + α₅", "α₉"],
            &["finishing", "1|", "stance|", "−α₅ + α₆", "−α₇"],
            &["finishing", "1|", "swing|", "α₄ − α₈", "α₂ − α₉"],
            &["finishing", "2|", "stance|", "−α₆", "α₇"],
            &["finishing", "2|", "swing|", "α₈", "α₉"],
        ],
        &[
            "Positive is backward. With the signs corrected each cycle ends at −α₄, −α₂ on the stance side and α₅, 0 on the swing \
             side, where the next one starts with the sides exchanged, and the finishing cycle ends at 0; its own row has the \
             corrected sign in print.",
            "In (7.22) α₄ = α₁ + k₂β and α₈ = α₅ − k₃β are read with 90° − β = α, the leg's angle against the vertical like all \
             others: at 105 steps/min and k = 0.5 α₄ is 23° instead of 41°. That is likely, and cannot be proved.",
        ],
    )
}
