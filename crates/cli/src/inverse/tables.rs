//! Joint forces as tables: our headings, and OpenSim's.

use crate::given::slides;
use solaris::analysis::InverseReport;
use solaris::io::Table;
use solaris::model::{Figure, Motion};

/// `DOF.tau`, as CSV has it.
pub(super) fn torques(figure: &Figure, motion: &Motion, forces: &InverseReport) -> Table {
    table(figure, motion, forces, |name, _| format!("{name}.tau"))
}

/// `DOF_moment` and `DOF_force`, as OpenSim has it.
pub(super) fn moments(figure: &Figure, motion: &Motion, forces: &InverseReport) -> Table {
    let heading = |name: &str, slides: bool| format!("{name}_{}", if slides { "force" } else { "moment" });
    let table = table(figure, motion, forces, heading);
    let title = "Inverse Dynamics Generalized Forces".to_owned();
    Table { title, in_degrees: Some(false), ..table }
}

/// A column for each degree of freedom that is free: what follows another has no force of its own.
fn table(
    figure: &Figure,
    motion: &Motion,
    forces: &InverseReport,
    heading: impl Fn(&str, bool) -> String,
) -> Table {
    let nv = figure.layout().nv();
    let slides = slides(figure);
    let free: Vec<usize> = (0..nv).filter(|&dof| !figure.follows(dof)).collect();
    let names = free.iter().map(|&dof| heading(&figure.layout().v_names()[dof], slides[dof]));
    let columns = std::iter::once("time".to_owned()).chain(names).collect();
    // A figure may have no degrees of freedom, and its rows no forces.
    let rows = motion.time().iter().enumerate().map(|(row, time)| (time, &forces.tau[row * nv..][..nv]));
    let values = rows.flat_map(|(time, tau)| std::iter::once(*time).chain(free.iter().map(|&dof| tau[dof])));
    let (values, lines) = (values.collect(), (1..).take(motion.len()).collect());
    Table { columns, values, lines, header_line: 1, ..Table::default() }
}
