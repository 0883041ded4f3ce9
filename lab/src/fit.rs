//! The numbers of the smooth style: what they come to, and their fit to people's walking.

mod baseline;
mod measured;
mod solve;
pub(crate) mod stride;
mod targets;
mod walk;

use crate::workspace;
use serde_json::Value;
use solaris_gait::{Footfall, PelvicList, StyleTable};
use std::fmt::Write;
use std::fs;

/// Where the recipe's own coefficients stand.
const RECIPE: &str = "fixtures/reference/smooth/golden.json";

/// Steps of the fit.
const ITERATIONS: usize = 60;
/// Steps at each of the thresholds on the way, in parts of the last one.
const SOME: usize = 10;
const STAGES: [f64; 6] = [0.002, 0.02, 0.1, 0.3, 0.6, 1.0];

/// What is asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Options {
    measure_only: bool,
    from_recipe: bool,
    in_stages: bool,
    beside: Beside,
}

/// What strides are held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beside {
    Bands,
    /// People's curves over a stride, too.
    BandsAndCurves,
}

impl Options {
    pub(crate) fn parse(options: &[&str]) -> Result<Self, String> {
        let mut parsed =
            Self { measure_only: false, from_recipe: false, in_stages: false, beside: Beside::Bands };
        for option in options {
            match *option {
                "--measure" => parsed.measure_only = true,
                "--stages" => parsed.in_stages = true,
                "--recipe" => parsed.from_recipe = true,
                "--curves" => parsed.beside = Beside::BandsAndCurves,
                other => {
                    return Err(format!(
                        "fit: unknown option '{other}'; there are --measure, --recipe, --stages and --curves"
                    ));
                }
            }
        }
        Ok(parsed)
    }

    fn stages(&self) -> &'static [f64] {
        if self.in_stages { &STAGES } else { &STAGES[STAGES.len() - 1..] }
    }
}

/// Fits the numbers, or only measures what they come to.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let mut table = if options.from_recipe { recipe()? } else { StyleTable::default() };
    if !options.measure_only {
        let recipe = recipe()?;
        let targets = targets::targets(&recipe, options.beside)?;
        // What plates see of a stance changes all of it: the force from which on they do comes to be by and by.
        for &part in options.stages() {
            table.footfall.threshold = part * Footfall::PEOPLE.threshold;
            eprintln!("fit: threshold {} N", table.footfall.threshold);
            let start = table.clone();
            table = solve::fit(&start, &table, &targets, if part < 1.0 { SOME } else { ITERATIONS })?;
        }
        table = rounded(&table);
        println!("{}", rows(&table));
    }
    baseline::print(&table)
}

/// The recipe's coefficients. The file has them in the order of the table, but JSON has no order.
pub(crate) fn recipe() -> Result<StyleTable, String> {
    #[rustfmt::skip]
    const NAMES: [&str; StyleTable::NUMBERS.len()] = [
        "theta", "a1", "u1", "a2", "b2", "a3", "b3", "delta", "obu", "uff", "kc", "kc1", "kc2", "kp", "kto", "kto1", "kto2",
        "toe", "kpk", "upk", "aw", "dwp", "cf", "cho", "c40", "c50", "uho", "lean", "kw2", "tb", "tbc", "ttr", "arm", "se",
        "w", "utk", "tau", "vpp", "armlag", "ttu",
    ];
    let text =
        fs::read_to_string(workspace::root().join(RECIPE)).map_err(|error| format!("{RECIPE}: {error}"))?;
    let file: Value = serde_json::from_str(&text).map_err(|error| format!("{RECIPE}: {error}"))?;
    let mut table =
        StyleTable { footfall: Footfall::RECIPE, list: PelvicList::RECIPE, ..StyleTable::default() };
    for (row, name) in table.rows.iter_mut().zip(NAMES) {
        for (k, c) in row.iter_mut().enumerate() {
            *c = file["style_table"][name][k].as_f64().ok_or_else(|| format!("{RECIPE}: no {name}[{k}]"))?;
        }
    }
    Ok(table)
}

/// Decimals that a row is written with, by its unit and its greatest coefficient.
pub(crate) fn decimals(unit: &str, row: &[f64; 4]) -> usize {
    let most = row.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
    match most {
        m if m >= 1000.0 => 0,
        m if m >= 100.0 => 1,
        _ if unit != "1.0" => 2,
        m if m >= 0.02 => 4,
        _ => 5,
    }
}

fn rounded(table: &StyleTable) -> StyleTable {
    let mut rounded = table.clone();
    for (row, (_, unit)) in rounded.rows.iter_mut().zip(StyleTable::NUMBERS) {
        let unit = 10.0_f64.powi(decimals(unit, row) as i32);
        *row = row.map(|c| (c * unit).round() / unit);
    }
    rounded
}

/// The rows as `crates/gait/src/smooth/style.rs` has them, without what they mean.
fn rows(table: &StyleTable) -> String {
    let mut text = String::new();
    for ((name, unit), row) in StyleTable::NUMBERS.iter().zip(&table.rows) {
        let digits = decimals(unit, row);
        let row = row.map(|c| format!("{c:.*}", digits.max(1))).join(", ");
        // Writing into a string does not fail.
        let _ = writeln!(text, "    {name}: {unit}, [{row}];");
    }
    text
}
