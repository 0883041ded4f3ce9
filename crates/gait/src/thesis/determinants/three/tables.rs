//! Tables 7.1 to 7.8, computed anew beside what is printed.

mod choice;
mod rotations;
mod solvable;
mod theta3;
mod times;

use crate::thesis::determinants::GaitTable;

/// Numbers of the tables that [`table()`] knows.
pub const TABLES: [&str; 8] = ["7.1", "7.2", "7.3", "7.4", "7.5", "7.6", "7.7", "7.8"];

/// A table of chapter 7 by its number, `None` for any other number.
///
/// Tables 7.4, 7.7 and 7.8 are computed with [`Proportions::FIT`](crate::thesis::determinants::Proportions::FIT) on the thesis's grid,
/// 7.5 with its times; the others are formulas, corrected where the printed ones do not add up.
pub fn table(number: &str) -> Option<GaitTable> {
    match number {
        "7.1" => Some(rotations::starting()),
        "7.2" => Some(rotations::intermediate()),
        "7.3" => Some(rotations::finishing()),
        "7.4" => Some(choice::choice()),
        "7.5" => Some(times::times()),
        "7.6" => Some(rotations::arms()),
        "7.7" => Some(theta3::theta3()),
        "7.8" => Some(solvable::solvable()),
        _ => None,
    }
}
