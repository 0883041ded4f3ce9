//! Positions as a table for OpenSim.

use solaris::io::Table;
use solaris::model::{AxisKind, Figure, Motion};

/// A column for each position, in degrees and m, as tools of biomechanics have them; quaternions as they are.
pub(crate) fn in_degrees(figure: &Figure, motion: &Motion) -> Table {
    let mut table = positions(figure, motion);
    let layout = figure.layout();
    let turning = (0..layout.nv()).filter(|dof| layout.axis_kind(*dof) == AxisKind::Rotation);
    let width = table.columns.len();
    for coordinate in turning.filter_map(|dof| layout.coordinate(dof)) {
        table.values.iter_mut().skip(1 + coordinate).step_by(width).for_each(|x| *x = x.to_degrees());
    }
    Table { in_degrees: Some(true), title: "Coordinates".to_owned(), ..table }
}

/// A column for each position, in rad and m, as CSV has them.
pub(crate) fn as_csv(figure: &Figure, motion: &Motion) -> Table {
    let mut table = positions(figure, motion);
    table.columns.iter_mut().skip(1).for_each(|name| name.push_str(".q"));
    table
}

/// A column for each position, in rad and m.
pub(crate) fn positions(figure: &Figure, motion: &Motion) -> Table {
    let names = figure.layout().q_names().iter().cloned();
    let columns = std::iter::once("time".to_owned()).chain(names).collect();
    let rows = motion.time().iter().enumerate();
    let values = rows.flat_map(|(frame, time)| std::iter::once(*time).chain(motion.q(frame).iter().copied()));
    let (values, lines) = (values.collect(), (1..).take(motion.len()).collect());
    let title = figure.name().to_owned();
    Table { title, in_degrees: Some(false), columns, values, lines, header_line: 1, ..Table::default() }
}
