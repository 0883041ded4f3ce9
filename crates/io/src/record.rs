//! Motions from tables, and the forces that were measured beside them.
//!
//! Two conventions are read, whatever the file's format:
//!
//! | | solaris | `OpenSim` |
//! |---|---|---|
//! | positions | `DOF.q` | `DOF` |
//! | velocities, accelerations | `DOF.v`, `DOF.a`, where they are known | – |
//! | forces on a link | `PREFIX.fx fy fz` | `PREFIXground_force_vx vy vz` |
//! | where they act | `PREFIX.px py pz`, where it is known | `PREFIXground_force_px py pz` |
//! | moments | `PREFIX.mx my mz`, about the world's origin | `PREFIXground_torque_x y z`, about that point |
//!
//! Files of forces have other names too, in which `NAME` is the prefix: `ground_force_NAME_vx`, `ground_force_NAME_px` with
//! `ground_torque_NAME_x`, `ground_force_NAME_mx` or `ground_moment_NAME_mx`; `ground_forceNAME_vx`; `NAME_force_vx` with
//! `NAME_torque_x`; `NAME_vx`, `NAME_px`.
//!
//! A table is of the first kind where any heading ends in `.q`, `.v` or `.a`. A one-dof joint's own name stands for its
//! degree of freedom in both, and `OpenSim`'s tables of states may head it `/jointset/JOINT/DOF/value` and `/speed`.
//! Columns of degrees of freedom that follow others may be missing and are not used: they are where their leaders put
//! them.
//!
//! Where the table's header says degrees, coordinates that turn (and their `.v`, `.a`) are turned into radians; slides,
//! quaternions and the velocities of ball and free joints never are.

mod columns;
mod force_table;
mod forces;
mod patterns;
mod positions;
mod row;

pub use force_table::{ForceHeadings, force_table};
pub use forces::{force_prefixes, forces};
pub use positions::{headed_positions, positions, positions_in_degrees};
pub use row::{headings, row};

use crate::error::IoError;
use crate::record::columns::Columns;
use crate::table::{CoordinateDefault, TIME, Table, TableNote};
use solaris_model::{Figure, Known, Motion, MotionInfo, Vector3};

/// How far (rad or m) a recorded follower may be from where its leader puts it: printed digits.
const FOLLOWS_TO: f64 = 1e-5;

/// A motion, and what of its table it does not use.
#[derive(Clone, Debug)]
pub struct ReadMotion {
    /// What was recorded.
    pub motion: Motion,
    /// Headings of columns that mean nothing for the figure. Columns of forces (`.tau`, contacts) are not among them.
    pub ignored: Vec<String>,
    /// What is odd about it, and how it was read all the same: the table's own notes, and more.
    pub notes: Vec<TableNote>,
}

/// What `table` says of the motion of `figure` under `gravity` (m/s², world axes).
///
/// The columns may come in any order. Every coordinate needs its position. `.v` and `.a` may be there or not for each
/// degree of freedom, of a ball or free joint whole or not at all. A table without `time` is taken where nothing has to
/// be differentiated: its rows are unrelated states, numbered 0, 1, 2 …. Quaternions must have unit length to within
/// [`Motion::UNIT_TOLERANCE`] and stay as they are.
///
/// # Errors
///
/// All missing columns at once; a column `.q`, `.v`, `.a` or `.tau` of nothing in the figure; two columns for one
/// coordinate; times that do not rise, and no times, where something has to be differentiated; quaternions that are none;
/// no rows.
///
/// # Examples
///
/// ```
/// use solaris_io::{csv, record};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let figure = FigureBuilder::new("arm").link(LinkSpec::root("arm", Joint::new("elbow").rx()).mass(1.0)).build()?;
/// let table = csv::read_table("time,elbow.q\n0,0.5\n0.1,0.6\n")?;
/// let motion = record::read(&figure, Vector3::zeros(), &table)?.motion;
/// assert_eq!((motion.q(1), motion.known().v[0]), (&[0.6][..], false));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(figure: &Figure, gravity: Vector3<f64>, table: &Table) -> Result<ReadMotion, IoError> {
    read_with_defaults(figure, gravity, table, &[])
}

/// As [`read`], of a model that says where coordinates are that have no column (`opensim::coordinate_defaults`).
///
/// A locked coordinate may always be missing. Others may where at most half of the coordinates are missing and none of the
/// columns that mean nothing is called nearly like one of them. A note says which were taken.
///
/// # Errors
///
/// Those of [`read`]; all missing columns at once.
pub fn read_with_defaults(
    figure: &Figure,
    gravity: Vector3<f64>,
    table: &Table,
    defaults: &[CoordinateDefault],
) -> Result<ReadMotion, IoError> {
    let columns = Columns::find(figure, table, defaults)?;
    let cleaned;
    let table = if columns.know_all(figure) {
        // Rows of which everything is known need not follow each other.
        table
    } else {
        cleaned = table.without_repeated_times();
        &*cleaned
    };
    let mut notes = table.notes.clone();
    if table.is_empty() {
        return Err(IoError::NoRows { line: table.header_line });
    }
    let part = |places: &[Option<usize>]| -> Vec<f64> {
        let rows = (0..table.len()).map(|row| table.row(row));
        rows.flat_map(|row| places.iter().map(|place| place.map_or(0.0, |place| row[place]))).collect()
    };
    let [mut q, mut v, mut a] = [&columns.q, &columns.v, &columns.a].map(|places| part(places));
    if table.in_degrees == Some(true) {
        for (dof, &coordinate) in &columns.turning {
            for (numbers, (place, width)) in [&mut q, &mut v, &mut a].into_iter().zip([
                (coordinate, columns.q.len()),
                (*dof, columns.v.len()),
                (*dof, columns.v.len()),
            ]) {
                numbers.iter_mut().skip(place).step_by(width).for_each(|x| *x = x.to_radians());
            }
        }
    }
    let (nq, nv) = (columns.q.len(), columns.v.len());
    for (coordinate, default) in &columns.defaulted {
        q.iter_mut().skip(*coordinate).step_by(nq).for_each(|x| *x = default.value);
    }
    if !columns.defaulted.is_empty() {
        let coordinates = columns.defaulted.iter().map(|(_, default)| default.clone()).collect();
        notes.push(TableNote::Defaults { coordinates });
    }
    let mut off = vec![0.0_f64; figure.followers().len()];
    for row in 0..table.len() {
        let q = &mut q[row * nq..][..nq];
        let given: Vec<f64> = figure.followers().iter().map(|follower| q[follower.coordinate]).collect();
        figure.follow(q, &mut v[row * nv..][..nv], &mut a[row * nv..][..nv]);
        for ((off, given), follower) in off.iter_mut().zip(given).zip(figure.followers()) {
            let there = q[follower.coordinate];
            // OpenSim 4 leaves the coordinates of kneecaps in radians, in tables in degrees too.
            let turned = table.in_degrees == Some(true) && columns.turning.contains_key(&follower.dof);
            let as_written = if turned { given.to_degrees() } else { given };
            *off = off.max((given - there).abs().min((as_written - there).abs()));
        }
        check_quaternions(figure, q, table.lines[row])?;
    }
    let known = |places: &[Option<usize>]| -> Vec<bool> { places.iter().map(Option::is_some).collect() };
    let (mut known_v, mut known_a) = (known(&columns.v), known(&columns.a));
    for follower in figure.followers() {
        known_v[follower.dof] = known_v[follower.leader];
        known_a[follower.dof] = known_v[follower.leader] && known_a[follower.leader];
    }
    let is_known = known_v.iter().chain(&known_a).all(|known| *known);
    let time = match table.column(TIME) {
        Some(column) if is_known => table.values_of(column).collect(),
        Some(column) => times(table, column)?,
        None => (0..table.len()).map(|row| row as f64).collect(),
    };
    let mut ignored = columns.ignored;
    let names = figure.layout().v_names();
    for (off, follower) in off.into_iter().zip(figure.followers()) {
        if columns.q[follower.coordinate].is_some() && off > FOLLOWS_TO {
            let [dof, leader] = [follower.dof, follower.leader].map(|dof| names[dof].as_str());
            ignored.push(format!("{dof} (it follows {leader}, and is off by up to {off:.1e})"));
        }
    }
    let info = MotionInfo::recorded(figure, gravity, &time);
    let motion = Motion::recorded(figure, info, time, [q, v, a], Known { v: known_v, a: known_a })?;
    Ok(ReadMotion { motion, ignored, notes })
}

/// The times, rising.
pub(crate) fn times(table: &Table, column: usize) -> Result<Vec<f64>, IoError> {
    let time: Vec<f64> = table.values_of(column).collect();
    match (1..time.len()).find(|&row| time[row] <= time[row - 1]) {
        None => Ok(time),
        Some(row) => Err(IoError::TimeOrder {
            line: table.lines[row],
            column: column + 1,
            time: time[row],
            before: time[row - 1],
        }),
    }
}

fn check_quaternions(figure: &Figure, q: &[f64], line: u64) -> Result<(), IoError> {
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let Some(first) = link.joint().kind().quaternion() else { continue };
        let quaternion = &q[at.q + first..][..4];
        let length = quaternion.iter().fold(0.0_f64, |length, x| length.hypot(*x));
        if (length - 1.0).abs() > Motion::UNIT_TOLERANCE {
            return Err(IoError::Quaternion { line, joint: link.joint().name().to_owned(), length });
        }
    }
    Ok(())
}
