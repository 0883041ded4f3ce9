//! Errors of writing motions and reading texts.

use crate::sto::StoFault;
use crate::table::Table;
use solaris_model::{MotionError, Vector3};

/// What is wrong with a clip of an animation file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ClipProblem {
    /// It moves a figure that the file does not have.
    #[error("it moves figure {actor} of the file, which has {count}; they are counted from 0")]
    NoActor {
        /// What was asked for.
        actor: usize,
        /// How many there are.
        count: usize,
    },
    /// It moves one figure twice.
    #[error("it moves figure {actor} of the file twice; give each motion a clip of its own")]
    Twice {
        /// Which figure.
        actor: usize,
    },
    /// A motion has no frame.
    #[error("a motion without frames; give at least one")]
    Empty,
}

/// Why a file cannot be one of VRM.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum VrmProblem {
    /// It has another number of figures.
    #[error("it is of one person, and {count} figures are to be written; give each a file of its own")]
    Count {
        /// How many there are.
        count: usize,
    },
    /// A figure lacks bones.
    #[error("figure '{figure}' has no {}; put it on the bones of the rig 'vrm'", bones.join(", "))]
    Missing {
        /// The figure.
        figure: String,
        /// The bones that VRM requires and it lacks.
        bones: Vec<&'static str>,
    },
    /// A bone hangs on a wrong one.
    #[error(
        "bone '{bone}' hangs on {}, and shall on {}; put the figure on the bones of the rig 'vrm'",
        found.unwrap_or("nothing"), expected.unwrap_or("nothing")
    )]
    Order {
        /// The bone.
        bone: &'static str,
        /// The bone that it hangs on.
        found: Option<&'static str>,
        /// The bone that it shall hang on.
        expected: Option<&'static str>,
    },
}

/// Why a motion cannot be written or a text is not one.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IoError {
    /// The writer failed: a full disk, a closed pipe.
    #[error("the motion could not be written: {0}")]
    Write(#[from] std::io::Error),
    /// The numbers are no motion, or not of this figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A number to be written is not finite; no format holds it.
    #[error("'{column}' at {time} s is {value}; a file holds finite numbers only")]
    NotFinite {
        /// The column, such as `left_knee.rx.tau`.
        column: String,
        /// When (s).
        time: f64,
        /// The number.
        value: f64,
    },
    /// A clip of an animation file that cannot be.
    #[error("clip '{clip}': {problem}")]
    Clip {
        /// The clip's name.
        clip: String,
        /// What is wrong and what to do.
        problem: ClipProblem,
    },
    /// A figure that no animator's rig is of.
    #[error(
        "the rig '{rig}' has no bone for link '{link}'; rigs are of people with the links of a human figure: the motion of other bones goes onto a character that has the rig (solaris retarget), and for other figures --rig is left out"
    )]
    NotOfRigs {
        /// The rig.
        rig: &'static str,
        /// The first link that it has no bone for.
        link: String,
    },
    /// A file cannot be one of VRM.
    #[error("a file cannot say by VRM which bone is which: {0}")]
    Vrm(#[from] VrmProblem),
    /// A figure could not be built.
    #[error(transparent)]
    Figure(#[from] solaris_model::FigureError),
    /// A glTF file that was to get an animation, and cannot be read.
    #[cfg(feature = "glb")]
    #[error(transparent)]
    Glb(#[from] crate::glb::GlbError),
    /// A node that an animation may not move.
    #[error(
        "node '{node}' says its place by a matrix, and glTF moves none that does; save it with translation, rotation and scale"
    )]
    MatrixNode {
        /// The node's name.
        node: String,
    },
    /// More than a binary glTF file can say of itself.
    #[error(
        "the file would have {bytes} bytes, and binary glTF ends at 4294967295; write fewer figures, fewer frames or a coarser skin"
    )]
    GlbSize {
        /// How large it would be.
        bytes: usize,
    },
    /// A contact track that does not fit its motion.
    #[error("contacts of link '{link}': {problem}")]
    Contacts {
        /// The link that the track names.
        link: String,
        /// What is wrong and what to do.
        problem: ContactProblem,
    },
    /// A table has no header.
    #[error("the table is empty; its first line must name the columns: time, DOF.q …, DOF.v …, DOF.a …")]
    NoHeader,
    /// A column that a motion needs is not in the header.
    #[error(
        "line 1: column '{column}' is missing; a motion needs `time` and `.q`, `.v`, `.a` of every degree of freedom, \
         and `.tau` and the nine numbers of a contact whole or not at all"
    )]
    MissingColumn {
        /// The missing column.
        column: String,
    },
    /// A column that means nothing for this figure.
    #[error(
        "line 1, column {column}: '{name}' is no column of a motion of figure '{figure}'; rename or remove it"
    )]
    UnknownColumn {
        /// Its number, from 1.
        column: usize,
        /// Its heading.
        name: String,
        /// The figure's name.
        figure: String,
    },
    /// A heading that stands twice.
    #[error(
        "line {line}, column {column}: '{name}' is also the heading of column {first}; remove one of them"
    )]
    DuplicateColumn {
        /// Line of the headings, from 1.
        line: u64,
        /// Number of the second, from 1.
        column: usize,
        /// The heading.
        name: String,
        /// Number of the first, from 1.
        first: usize,
    },
    /// A row with too few or too many fields.
    #[error("line {line} has {found} fields, the header has {expected}")]
    RowLength {
        /// Line, from 1.
        line: u64,
        /// Fields of the row.
        found: usize,
        /// Columns of the header.
        expected: usize,
    },
    /// A field that is no finite number.
    #[error("line {line}, column {column} ('{name}'): '{text}' is no finite number")]
    Number {
        /// Line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// Its heading.
        name: String,
        /// What stands there.
        text: String,
    },
    /// A time that is not one frame after the row before.
    #[error(
        "line {line}, column {column} ('time'): {time} s comes {step} s after the row before; at {rate} frames/s it must \
         be {} s: correct the rate or resample the table", 1.0 / .rate
    )]
    Time {
        /// Line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// The time (s).
        time: f64,
        /// Since the row before (s).
        step: f64,
        /// Frames a second (1/s).
        rate: f64,
    },
    /// A table of forces where positions are wanted.
    #[error(
        "column '{name}' holds forces; a table of positions is wanted here (solaris inverse reads forces as they are)"
    )]
    Forces {
        /// The first heading that says so.
        name: String,
    },
    /// A table in degrees, and nothing says which of its columns are angles.
    #[error(
        "its header says inDegrees=yes, and translations are never in degrees: name the figure that says which coordinates \
         turn (--figure)"
    )]
    DegreesWithoutFigure,
    /// Gravity that is no direction.
    #[error(
        "gravity ({}, {}, {}) m/s² says no direction that is down; BVH has one", .gravity.x, .gravity.y, .gravity.z
    )]
    BvhUp {
        /// The motion's gravity (m/s²).
        gravity: Vector3<f64>,
    },
    /// A header of a `.mot` or `.sto` table that is wrong.
    #[error("line {line}: {fault}")]
    Sto {
        /// Line, from 1.
        line: u64,
        /// What is wrong.
        fault: StoFault,
    },
    /// More columns than are read.
    #[error("line {line} has {found} fields; at most {} are read", Table::MOST_COLUMNS)]
    ManyColumns {
        /// Line, from 1.
        line: u64,
        /// How many fields it has.
        found: usize,
    },
    /// A table that cannot be a `.mot` or `.sto` one.
    #[error("a table without a column called 'time' cannot be written to a .sto table; add the times")]
    StoTime,
    /// A heading that a `.mot` or `.sto` table cannot hold.
    #[error("column '{name}' cannot be written to a .sto table: headings there are one word; rename it")]
    StoHeading {
        /// The heading.
        name: String,
    },
    /// A heading of CSV, or a marker's name, that would not be read as it is written.
    #[error(
        "'{name}' cannot be a name in {format}: one ends in its line, and blanks, quotes and byte order marks around it are lost; \
         rename it"
    )]
    Heading {
        /// The name.
        name: String,
        /// What was to be written.
        format: &'static str,
    },
    /// A force of an `ExternalLoads` file that its table cannot feed.
    #[error("external force '{force}': {problem}")]
    ExternalForce {
        /// The force's name.
        force: String,
        /// What is wrong and what to do.
        problem: ExternalForceProblem,
    },
    /// A table that is not separated by commas.
    #[error(
        "line {line}: the headings stand between {separator}, not commas; save the table with commas between fields and points in numbers"
    )]
    Separator {
        /// Line, from 1.
        line: u64,
        /// What stands between them.
        separator: &'static str,
    },
    /// A heading of no letters.
    #[error("line {line}, column {column}: the heading is empty; name the column or remove it")]
    EmptyHeading {
        /// Line of the headings, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
    },
    /// A heading with a line end in it.
    #[error("line {line}, column {column}: the heading does not end in its line; close its quotes")]
    OpenHeading {
        /// Line of the headings, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
    },
    /// A table without rows.
    #[error("line {line}: there are headings and no rows below them")]
    NoRows {
        /// Line of the headings, from 1.
        line: u64,
    },
    /// Columns that a record needs and does not have.
    #[error("line {line}: {}", missing_columns(.columns))]
    MissingColumns {
        /// Line of the headings, from 1.
        line: u64,
        /// Each with the heading that is most like it, among those that mean nothing else.
        columns: Vec<(String, Option<String>)>,
    },
    /// A table of states that has no times and cannot do without.
    #[error(
        "line {line}: there is no column 'time'; without it, velocities and accelerations cannot be found: add it, or give `.v` and `.a` of every degree of freedom (missing: '{missing}')"
    )]
    NoTime {
        /// Line of the headings, from 1.
        line: u64,
        /// The first column that is missing.
        missing: String,
    },
    /// A column of a degree of freedom that the figure does not have.
    #[error(
        "line {line}, column {column}: '{name}' is no coordinate of figure '{figure}'{}; rename or remove it",
        .nearest.as_ref().map_or_else(String::new, |name| format!(" (is '{name}' meant?)"))
    )]
    UnknownDof {
        /// Line of the headings, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// Its heading.
        name: String,
        /// The figure's name.
        figure: String,
        /// The heading that is most like it.
        nearest: Option<String>,
    },
    /// Two headings that mean the same coordinate.
    #[error("line {line}: columns '{first}' and '{second}' are the same coordinate; remove one of them")]
    SameCoordinate {
        /// Line of the headings, from 1.
        line: u64,
        /// The heading that stands first.
        first: String,
        /// The other.
        second: String,
    },
    /// A time that does not come after the one before it.
    #[error(
        "line {line}, column {column} ('time'): {time} s does not come after {before} s; times must rise"
    )]
    TimeOrder {
        /// Line, from 1.
        line: u64,
        /// Number of the column, from 1.
        column: usize,
        /// The time (s).
        time: f64,
        /// The time of the row before (s).
        before: f64,
    },
    /// A quaternion without unit length.
    #[error(
        "line {line}: the quaternion of joint '{joint}' (x, y, z, w) has the length {length}; it must be 1 to within {}: \
         normalise it",
        solaris_model::Motion::UNIT_TOLERANCE
    )]
    Quaternion {
        /// Line, from 1.
        line: u64,
        /// The joint's name.
        joint: String,
        /// Its length.
        length: f64,
    },
    /// A table without the forces that were asked for.
    #[error(
        "line {line}: no force is called '{prefix}': neither '{prefix}.fx' nor '{prefix}ground_force_vx' nor \
         'ground_force_{}_vx' is there; {}", .prefix.trim_end_matches('_'), prefixes(.known, .headings)
    )]
    NoForce {
        /// Line of the headings, from 1.
        line: u64,
        /// What was asked.
        prefix: String,
        /// The prefixes that the table has.
        known: Vec<String>,
        /// The first headings that it has.
        headings: Vec<String>,
    },
}

/// All missing columns in one sentence.
fn missing_columns(columns: &[(String, Option<String>)]) -> String {
    const MOST: usize = 12;
    let name = |(name, nearest): &(String, Option<String>)| match nearest {
        Some(nearest) => format!("'{name}' (is '{nearest}' meant?)"),
        None => format!("'{name}'"),
    };
    let shown: Vec<String> = columns.iter().take(MOST).map(name).collect();
    let more = match columns.len().saturating_sub(MOST) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let (what, verb, them) =
        if columns.len() == 1 { ("column", "is", "it") } else { ("columns", "are", "them") };
    format!("{what} {}{more} {verb} missing; add {them}, or rename what is meant", shown.join(", "))
}

/// Which prefixes a table of forces has.
fn prefixes(known: &[String], headings: &[String]) -> String {
    let quoted =
        |names: &[String]| names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    match (known, headings) {
        ([], []) => "the table holds no forces".to_owned(),
        ([], _) => format!("the table holds no forces, but {} …", quoted(headings)),
        _ => format!("its prefixes are {}", quoted(known)),
    }
}

/// What is wrong with a contact track.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactProblem {
    /// The figure has no such link.
    #[error("figure '{figure}' has no link of that name")]
    UnknownLink {
        /// The figure's name.
        figure: String,
    },
    /// Two tracks have the same link.
    #[error("there are two tracks of that name; merge them")]
    Duplicate,
    /// Not one contact a sample.
    #[error("{found} contacts for {samples} samples; give one a sample")]
    Length {
        /// Contacts of the track.
        found: usize,
        /// Samples of the motion.
        samples: usize,
    },
}

/// What keeps an external force from being read from a table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ExternalForceProblem {
    /// Not three columns.
    #[error(
        "its {what} is called '{identifier}', and {found} headings of the table begin so{}; there must be three",
        .nearest.as_ref().map_or_else(String::new, |name| format!(" (the nearest is '{name}')"))
    )]
    Columns {
        /// Force, point or torque.
        what: &'static str,
        /// What their headings begin with.
        identifier: String,
        /// How many do.
        found: usize,
        /// The heading that is most like it.
        nearest: Option<String>,
    },
    /// The table has no times.
    #[error("the table has no column 'time'")]
    NoTime,
}
