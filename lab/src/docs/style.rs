//! The style's numbers on docs/walking.md, and what their fit brought.

use crate::fit::{self, stride};
use solaris_gait::StyleTable;
use std::fmt::Write;

/// Height (m) of the person, and step frequencies (1/min), of the comparison.
const HEIGHT: f64 = 1.75;
const FREQUENCIES: [f64; 6] = [70.0, 80.0, 95.0, 110.0, 120.0, 130.0];

/// Steady strides in the recipe's numbers and in those that ship.
pub(super) fn fit() -> Result<String, String> {
    let tables = [fit::recipe()?, StyleTable::default()];
    let mut text = "| steps/min | textbook bands of 21 | free moment, N m | clearance late in swing, mm | force beside two peaks and a \
                    valley, %BW | friction, one foot's |\n|---|---|---|---|---|---|"
        .to_owned();
    for frequency in FREQUENCIES {
        let case = stride::Case::new(HEIGHT, frequency, 1.0)?;
        let [before, after] =
            tables.each_ref().map(|table| stride::Found::of(&case, table).map(|found| cells(&found)));
        let cells = before?.into_iter().zip(after?).map(|(before, after)| format!(" {before} → {after} |"));
        // Writing into a string does not fail.
        let _ = write!(text, "\n| {frequency} |{}", cells.collect::<Vec<_>>().concat());
    }
    Ok(text)
}

fn cells(found: &stride::Found) -> [String; 5] {
    [
        found.bands.to_string(),
        format!("{:.1}", found.free_moment),
        format!("{:.1}", 1e3 * found.clearance),
        if found.detour < 9.95 { format!("{:.1}", found.detour) } else { format!("{:.0}", found.detour) },
        format!("{:.2}", found.friction.1),
    ]
}

/// The table of the style as it stands in `block` with the numbers that ship: what each one means stands on the page alone.
pub(super) fn numbers(block: &str) -> Result<String, String> {
    let table = StyleTable::default();
    let mut lines = block.lines();
    let mut text = lines.by_ref().take(2).collect::<Vec<_>>().join("\n");
    for ((name, unit), row) in StyleTable::NUMBERS.iter().zip(&table.rows) {
        let line = lines.next().unwrap_or_default();
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let [_, field, meaning, shown, ..] = cells[..] else {
            return Err(format!("the style has a number `{name}` that has no row"));
        };
        if field != format!("`{name}`") {
            return Err(format!("{field} stands where the style has `{name}`"));
        }
        let digits = fit::decimals(unit, row).max(1);
        let row = row.map(|c| format!("{c:.digits$}").replace('-', "−")).join(" | ");
        let _ = write!(text, "\n| {field} | {meaning} | {shown} | {row} |");
    }
    match lines.next() {
        None => Ok(text),
        Some(line) => Err(format!("the style has no such number: {line}")),
    }
}
