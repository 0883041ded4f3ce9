//! Positions as a table for OpenSim.

use solaris::io::Table;
use solaris::model::{Figure, Motion};

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
