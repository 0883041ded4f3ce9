//! Arms and trunk.

use super::super::super::table::GaitTable;

#[rustfmt::skip]
pub(super) fn arms() -> GaitTable {
    GaitTable::corrected(("8.6", "rotations of the arms"), &["cycle", "phase", "arm", "shoulder", "elbow"], 3, &[
        &["intermediate", "1", "stance", "α₁₂−α₁", "0"],
        &["intermediate", "1", "swing", "α₂−α₁₀", "α₃−α₁₁"],
        &["intermediate", "2", "stance", "α₁−α₄|α₁₁−α₄", "0"],
        &["intermediate", "2", "swing", "−α₂+α₅", "−α₃+α₆"],
        &["intermediate", "3", "stance", "α₄−α₇", "0"],
        &["intermediate", "3", "swing", "α₈−α₅|α₅−α₈", "−α₆+α₉"],
        &["intermediate", "4", "stance", "α₇+α₁₀", "α₁₁"],
        &["intermediate", "4", "swing", "−α₈−α₁₂", "−α₉"],
        &["starting", "3", "stance", "−α₇|α₇", "0"],
        &["starting", "3", "swing", "α₈", "α₉"],
        &["starting", "4", "stance", "α₇+α₁₀", "α₁₁"],
        &["starting", "4", "swing", "−α₈−α₁₂", "−α₉"],
        &["finishing", "1", "stance", "α₁₂−α₁|−α₁", "0"],
        &["finishing", "1", "swing", "α₂−α₁₀|α₂", "α₃−α₁₁|α₃"],
        &["finishing", "2", "stance", "α₁−α₄|α₁₁−α₄", "0"],
        &["finishing", "2", "swing", "−α₂+α₅", "−α₃+α₆"],
        &["finishing", "3", "stance", "α₄", "0"],
        &["finishing", "3", "swing", "−α₅", "−α₆"],
    ], &[
        "At the ends of phases 0 to 4 the stance arm is at −α₁₂, −α₁, −α₄, −α₇ and α₁₀, the swing arm at α₁₀, α₂, α₅, α₈ and \
         −α₁₂; its elbow at α₁₁, α₃, α₆, α₉ and 0. Entries are the differences; the printed ones that are not do not add up to \
         the arms' exchange. The finishing cycle starts from walking, not from rest.",
    ])
}

#[rustfmt::skip]
pub(super) fn trunk() -> GaitTable {
    GaitTable::corrected(("8.7", "movements of the trunk"), &["cycle", "phase", "pelvis-trunk", "torso-lower body", "sagittal"], 2, &[
        &["intermediate", "1", "−2ν/5|4ν/5", "6γ/5", "+ζ"],
        &["intermediate", "2", "−6ν/5", "2γ/5", "−ζ"],
        &["intermediate", "3", "0", "2γ/5|4γ/5", "−ζ"],
        &["intermediate", "4", "2ν/5", "0", "+ζ"],
        &["starting", "3", "−ν", "γ", "−ζ"],
        &["starting", "4", "2ν/5", "0", "+ζ"],
        &["finishing", "1", "−2ν/5|4ν/5", "6γ/5", "+ζ"],
        &["finishing", "2", "−6ν/5", "2γ/5", "−ζ"],
        &["finishing", "3", "ν", "−3γ/5|−γ", "0"],
    ], &[
        "Half an oscillation a step: γ goes from −γ to γ, in all 2γ, where 12γ/5 are printed. ν goes from 3ν/5 over ν/5, −ν and −ν to \
         −3ν/5, which is 3ν/5 for the next step's parts of the legs; the printed row comes back to where it began, and forgets \
         that these are exchanged.",
    ])
}
