//! External forces: plates named one by one, or OpenSim's description of them.

use crate::error::CliError;
use crate::input;
use solaris::io::{Table, TableNote, opensim, record};
use solaris::model::{Figure, Link, MeasuredForce, nearest};
use std::path::{Path, PathBuf};

/// Measured forces as they were read.
pub(crate) enum External {
    None,
    /// A table, and which of its columns push which links.
    Plates {
        path: PathBuf,
        table: Table,
        plates: Vec<(Vec<String>, String)>,
    },
    /// OpenSim's description and the table that it names.
    Loads {
        path: PathBuf,
        data: PathBuf,
        loads: opensim::ExternalLoads,
        table: Table,
    },
}

impl External {
    /// What the options say; the files are those of one motion.
    pub(crate) fn read(
        plates: &[(Vec<String>, String)],
        [forces, loads]: [Option<&Path>; 2],
    ) -> Result<Self, CliError> {
        if let Some(path) = forces {
            for (i, (links, prefix)) in plates.iter().enumerate() {
                if let Some((other, _)) = plates[..i].iter().find(|(_, before)| before == prefix) {
                    let (links, other) = (links.join("+"), other.join("+"));
                    let why =
                        format!("the same columns push {other} already; give each plate its own prefix");
                    return Err(of_plate(&links, prefix, why));
                }
            }
            return Ok(Self::Plates {
                path: path.to_owned(),
                table: forces_of(path)?,
                plates: plates.to_vec(),
            });
        }
        let Some(path) = loads else { return Ok(Self::None) };
        let text = input::text(path)?;
        let loads = opensim::external_loads(&text).map_err(|faults| input::faulty(path, &text, faults))?;
        // The file of the data is named from where the description stands.
        let Some(named) = &loads.data_file else {
            return Err(CliError::input(
                path,
                &"it names no data file: <datafile> must hold the path of the forces",
            ));
        };
        let data = path.parent().unwrap_or_else(|| Path::new("")).join(named.trim());
        Ok(Self::Loads { path: path.to_owned(), table: forces_of(&data)?, data, loads })
    }

    /// The forces on the figure's links.
    pub(crate) fn records(&self, figure: &Figure) -> Result<Vec<MeasuredForce>, CliError> {
        let (path, records) = match self {
            Self::None => return Ok(Vec::new()),
            Self::Plates { path, table, plates } => {
                let records = plates.iter().map(|(links, prefix)| record::forces(table, links, prefix));
                (path, records.collect())
            }
            Self::Loads { path, data, loads, table } => {
                let records = loads.records(table).map_err(|error| CliError::input(data, &error))?;
                (path, Ok(records))
            }
        };
        let mut records: Vec<MeasuredForce> = records.map_err(|error| CliError::input(path, &error))?;
        for (i, link) in
            records.iter_mut().enumerate().flat_map(|(i, r)| r.links.iter_mut().map(move |l| (i, l)))
        {
            let found = figure.locate(link).map(|(index, _)| figure.links()[index].name().to_owned());
            *link = found.ok_or_else(|| {
                let names = figure.links().iter().map(Link::name);
                let hint =
                    nearest(link, names).map_or_else(String::new, |name| format!("; did you mean '{name}'?"));
                let why =
                    format!("figure '{}' has no link and no frame '{link}' to push{hint}", figure.name());
                match self {
                    Self::Plates { plates, .. } => of_plate(&plates[i].0.join("+"), &plates[i].1, why),
                    _ => CliError::input(path, &why),
                }
            })?;
        }
        Ok(records)
    }

    /// Prefixes of force columns that push nothing: of the table of forces, or without one of the motion's own.
    pub(super) fn unused(&self, motion: &Table) -> Vec<String> {
        match self {
            Self::None => record::force_prefixes(motion),
            Self::Plates { table, plates, .. } => {
                let all = record::force_prefixes(table).into_iter();
                let bare = |name: &str| name.trim_end_matches('_').to_owned();
                all.filter(|prefix| plates.iter().all(|(_, used)| bare(used) != bare(prefix))).collect()
            }
            // OpenSim's description says what is meant.
            Self::Loads { .. } => Vec::new(),
        }
    }

    /// What is odd about the table, and how it was read all the same.
    pub(super) fn notes(&self) -> Vec<String> {
        match self {
            Self::None => Vec::new(),
            Self::Plates { table, .. } | Self::Loads { table, .. } => table
                .notes
                .iter()
                .filter(|note| **note != TableNote::OldDegrees)
                .map(ToString::to_string)
                .collect(),
        }
    }

    /// What the summary says of it.
    pub(super) fn describe(&self) -> String {
        let plate = |links: &str, of: &str| format!("{links} by {of}");
        let (file, plates): (&Path, Vec<String>) = match self {
            Self::None => return "none".to_owned(),
            Self::Plates { path, plates, .. } => (
                path,
                plates
                    .iter()
                    .map(|(links, prefix)| plate(&links.join("+"), &format!("'{prefix}'")))
                    .collect(),
            ),
            Self::Loads { data, loads, .. } => {
                (data, loads.forces.iter().map(|force| plate(&force.body, &force.name)).collect())
            }
        };
        format!("{}: {}", file.display(), plates.join(", "))
    }
}

/// A table of forces, rows that repeat a time left out.
fn forces_of(path: &Path) -> Result<Table, CliError> {
    Ok(input::table(path)?.without_repeated_times().into_owned())
}

/// What is wrong with a plate, said of the option.
fn of_plate(links: &str, prefix: &str, why: String) -> CliError {
    CliError::option("plate", format!("{links}={prefix}"), why)
}
