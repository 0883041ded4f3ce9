//! Forces that were measured: plates named one by one, or OpenSim's description of them.

use crate::error::FileError;
use crate::files::Source;
use crate::plates::table_plates;
use solaris_analysis::ground::PlateRecord;
use solaris_io::{Table, TableNote, opensim, record};
use solaris_model::{Figure, Link, MeasuredForce, nearest};
use std::path::{Path, PathBuf};

/// Measured forces as they were read.
#[derive(Clone, Debug, Default)]
pub enum External {
    /// None.
    #[default]
    None,
    /// A table, and which of its columns push which links.
    Plates {
        /// The file of the table.
        path: PathBuf,
        /// The table.
        table: Table,
        /// One link or two, the foot and its toes, and what the names of the columns begin with. None: columns that are called by links push these; without
        /// any such they are of plates, and whoever stands on them is to be found ([`External::unassigned`]).
        plates: Vec<(Vec<String>, String)>,
    },
    /// OpenSim's description and the table that it names.
    Loads {
        /// The file of the description.
        path: PathBuf,
        /// The file of the table.
        data: PathBuf,
        /// The description.
        loads: opensim::ExternalLoads,
        /// The table.
        table: Table,
    },
}

/// Why measured forces cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExternalError {
    /// Their file is at fault.
    #[error(transparent)]
    File(#[from] FileError),
    /// What was said of a plate is.
    #[error("plate {links}={prefix}: {why}")]
    Plate {
        /// The links that it pushes, with `+` between them.
        links: String,
        /// What its columns begin with.
        prefix: String,
        /// What is wrong with it.
        why: String,
    },
}

impl External {
    /// Reads the forces of one motion: a table of `forces`, and which links its plates push, or a description of the `loads`.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, descriptions that name no table, and plates of the same columns.
    pub fn read(
        source: Source<'_>,
        plates: &[(Vec<String>, String)],
        [forces, loads]: [Option<&Path>; 2],
    ) -> Result<Self, ExternalError> {
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
                table: forces_of(source, path)?,
                plates: plates.to_vec(),
            });
        }
        let Some(path) = loads else { return Ok(Self::None) };
        let text = source.text(path)?;
        let loads =
            opensim::external_loads(&text).map_err(|faults| FileError::faulty(path, &text, faults))?;
        // The file of the data is named from where the description stands.
        let Some(named) = &loads.data_file else {
            return Err(FileError::input(
                path,
                &"it names no data file: <datafile> must hold the path of the forces",
            )
            .into());
        };
        let data = path.parent().unwrap_or_else(|| Path::new("")).join(named.trim());
        Ok(Self::Loads { path: path.to_owned(), table: forces_of(source, &data)?, data, loads })
    }

    /// The forces on the figure's links.
    ///
    /// # Errors
    ///
    /// Columns that are not there, and links that the figure has not.
    pub fn records(&self, figure: &Figure) -> Result<Vec<MeasuredForce>, ExternalError> {
        let (path, records) = match self {
            Self::None => return Ok(Vec::new()),
            Self::Plates { path, table, plates } => {
                let named = link_plates(table, figure);
                let plates = if plates.is_empty() { &named } else { plates };
                let records = plates.iter().map(|(links, prefix)| record::forces(table, links, prefix));
                (path, records.collect())
            }
            Self::Loads { path, data, loads, table } => {
                let records = loads.records(table).map_err(|error| FileError::input(data, &error))?;
                (path, Ok(records))
            }
        };
        let mut records: Vec<MeasuredForce> = records.map_err(|error| FileError::input(path, &error))?;
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
                    _ => FileError::input(path, &why).into(),
                }
            })?;
        }
        Ok(records)
    }

    /// What plates recorded of which nobody says what they push: all of a table, where none of its columns are called by links.
    ///
    /// # Errors
    ///
    /// Columns that are missing, all of them too: a table of no forces is none of plates.
    pub fn unassigned(&self, figure: &Figure) -> Result<Vec<PlateRecord>, ExternalError> {
        let Self::Plates { path, table, plates } = self else { return Ok(Vec::new()) };
        if !plates.is_empty() || !link_plates(table, figure).is_empty() {
            return Ok(Vec::new());
        }
        let plates = match table_plates(table) {
            Ok(plates) if plates.is_empty() => record::forces(table, &[], "").map(|_| plates),
            plates => plates,
        };
        Ok(plates.map_err(|error| FileError::input(path, &error))?)
    }

    /// Prefixes of force columns that push nothing: of the table of forces, or without one of the motion's own.
    pub fn unused(&self, motion: &Table) -> Vec<String> {
        match self {
            Self::None => record::force_prefixes(motion),
            // Whoever names none takes all.
            Self::Plates { plates, .. } if plates.is_empty() => Vec::new(),
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
    pub fn notes(&self) -> Vec<String> {
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
    pub fn describe(&self) -> String {
        let plate = |links: &str, of: &str| format!("{links} by {of}");
        let (file, plates): (&Path, Vec<String>) = match self {
            Self::None => return "none".to_owned(),
            Self::Plates { path, plates, .. } if plates.is_empty() => {
                return format!("{}: links by their names", path.display());
            }
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

/// Columns that are called by links of a figure, with these.
pub(crate) fn link_plates(table: &Table, figure: &Figure) -> Vec<(Vec<String>, String)> {
    let links = record::force_prefixes(table).into_iter().filter(|prefix| figure.locate(prefix).is_some());
    links.map(|link| (vec![link.clone()], link)).collect()
}

/// A table of forces, rows that repeat a time left out.
fn forces_of(source: Source<'_>, path: &Path) -> Result<Table, FileError> {
    Ok(source.table(path)?.without_repeated_times().into_owned())
}

/// What is wrong with a plate, said of the option.
fn of_plate(links: &str, prefix: &str, why: String) -> ExternalError {
    ExternalError::Plate { links: links.to_owned(), prefix: prefix.to_owned(), why }
}
