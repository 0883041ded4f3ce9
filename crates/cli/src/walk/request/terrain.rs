//! The ground that is walked on, out of the options and a file.

use crate::args::TerrainArgs;
use crate::error::CliError;
use crate::input;
use solaris::gait::{Foothold, Stairs, WalkGround};
use solaris::model::Relief;
use std::path::Path;

/// The columns of a relief.
const COLUMNS: [&str; 2] = ["z", "height"];

/// The ground.
pub(super) fn of(args: &TerrainArgs) -> Result<WalkGround, CliError> {
    if let Some(slope) = &args.slope {
        return Ok(WalkGround::Slope(slope.value.to_radians()));
    }
    if let Some(count) = args.stairs {
        let usual = Stairs::default();
        let rise = args.rise.as_ref().map_or(usual.rise, |rise| rise.value);
        let tread = args.tread.as_ref().map_or(usual.tread, |tread| tread.value);
        return Ok(WalkGround::Stairs(Stairs { count, rise, tread }));
    }
    if let Some(path) = &args.footholds {
        return Ok(WalkGround::Footholds(footholds(path)?));
    }
    match &args.ground {
        Some(path) => Ok(WalkGround::Relief(read(path)?)),
        None => Ok(WalkGround::Level),
    }
}

/// Reads footholds: only z must be there.
fn footholds(path: &Path) -> Result<Vec<Foothold>, CliError> {
    let table = input::table(path)?;
    let known = ["x", "z", "height", "pitch", "heading"];
    if let Some(strange) = table.columns.iter().find(|name| !known.contains(&name.as_str())) {
        let why = format!("a foothold has no '{strange}'; its columns are {}", known.join(", "));
        return Err(CliError::input(path, &why));
    }
    let [x, z, height, pitch, heading] = known.map(|name| table.column(name));
    let Some(z) = z else {
        let found = table.columns.join(", ");
        let why = format!("there is no column 'z'; footholds have z (ahead) in m, and here are {found}");
        return Err(CliError::input(path, &why));
    };
    let row = |row: usize| {
        let of = |column: Option<usize>| column.map(|column| table.row(row)[column]);
        Foothold {
            x: of(x),
            z: table.row(row)[z],
            height: of(height).unwrap_or_default(),
            pitch: of(pitch).unwrap_or_default().to_radians(),
            heading: of(heading).unwrap_or_default().to_radians(),
        }
    };
    Ok((0..table.len()).map(row).collect())
}

/// Reads the points of a relief.
fn read(path: &Path) -> Result<Relief, CliError> {
    let table = input::table(path)?;
    let column = |name: &str| {
        let found = table.columns.join(", ");
        let why = format!(
            "there is no column '{name}'; ground has z (ahead) and height in m, and here are {found}"
        );
        table.column(name).ok_or_else(|| CliError::input(path, &why))
    };
    let [z, height] = [column(COLUMNS[0])?, column(COLUMNS[1])?];
    let points: Vec<[f64; 2]> =
        (0..table.len()).map(|row| [table.row(row)[z], table.row(row)[height]]).collect();
    Relief::new(points).map_err(|error| CliError::input(path, &error))
}
