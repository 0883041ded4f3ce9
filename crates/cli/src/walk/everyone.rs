//! Whose walk it is and in which manner, out of the options.

use crate::args::EveryoneArgs;
use crate::error::CliError;
use crate::input;
use solaris::gait::{Population, StyleSheet, Variability, WalkRequest, read_sheet, sheet_of, side_sheet_of};
use std::path::Path;

/// A request with population, manner and variability of the options.
pub(crate) fn dressed(request: WalkRequest, args: &EveryoneArgs) -> Result<WalkRequest, CliError> {
    let mut sheet = StyleSheet::default();
    for manner in &args.manner {
        let more = sheet_of(manner).map_err(|why| CliError::option("manner", manner, why.to_string()))?;
        sheet = sheet.plus(&more);
    }
    for path in &args.style_file {
        sheet = sheet.plus(&of_file(path)?);
    }
    let variability = match (&args.variability, args.seed) {
        (None, None) => None,
        (None, Some(seed)) => {
            let why = "nothing is by chance without --variability; add it";
            return Err(CliError::option("seed", seed.to_string(), why));
        }
        (Some(scale), seed) => Some(Variability { scale: scale.value, seed: seed.unwrap_or_default() }),
    };
    let side = |option: &str, asked: &Option<String>| match asked {
        None => Ok(StyleSheet::default()),
        Some(path) if input::extension(Path::new(path)) == "ron" => of_file(Path::new(path)),
        Some(blend) => {
            let known = side_sheet_of(&blend.replace('-', "_"));
            known.map_err(|why| CliError::option(option, blend, why.to_string()))
        }
    };
    let sides = [side("left", &args.left)?, side("right", &args.right)?];
    let population = args.population.map_or_else(Population::default, Population::from);
    let cane_load = args.cane_load.as_ref().map(|load| load.value);
    Ok(WalkRequest { population, sheet, sides, cane_load, variability, ..request })
}

/// A manner in a file of its own.
fn of_file(path: &Path) -> Result<StyleSheet, CliError> {
    if input::extension(path) != "ron" {
        return Err(CliError::input(path, &"its extension says nothing; a manner is a text, .ron"));
    }
    let text = input::text(path)?;
    read_sheet(&text).map_err(|faults| input::faulty(path, &text, faults))
}
