//! The positions of a motion as tables.

use crate::table::{TIME, Table, heading};
use solaris_model::{AxisKind, Figure, Motion};

/// A column for each position, in degrees and m, as tools of biomechanics have them; quaternions as they are.
pub fn positions_in_degrees(figure: &Figure, motion: &Motion) -> Table {
    let mut table = positions(figure, motion);
    let layout = figure.layout();
    let turning = (0..layout.nv()).filter(|dof| layout.axis_kind(*dof) == AxisKind::Rotation);
    let width = table.columns.len();
    for coordinate in turning.filter_map(|dof| layout.coordinate(dof)) {
        table.values.iter_mut().skip(1 + coordinate).step_by(width).for_each(|x| *x = x.to_degrees());
    }
    Table { in_degrees: Some(true), title: "Coordinates".to_owned(), ..table }
}

/// A column for each position, in rad and m, headed `DOF.q` as CSV has them.
pub fn headed_positions(figure: &Figure, motion: &Motion) -> Table {
    let mut table = positions(figure, motion);
    table.columns.iter_mut().skip(1).for_each(|name| *name = heading(name, "q"));
    table
}

/// A column for each position, in rad and m.
pub fn positions(figure: &Figure, motion: &Motion) -> Table {
    let names = figure.layout().q_names().iter().cloned();
    let columns = std::iter::once(TIME.to_owned()).chain(names).collect();
    let rows = motion.time().iter().enumerate();
    let values = rows.flat_map(|(frame, time)| std::iter::once(*time).chain(motion.q(frame).iter().copied()));
    let (values, lines) = (values.collect(), (1..).take(motion.len()).collect());
    let title = figure.name().to_owned();
    Table { title, in_degrees: Some(false), columns, values, lines, header_line: 1, ..Table::default() }
}
