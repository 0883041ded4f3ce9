//! Joint forces as tables: our headings, and OpenSim's.

use solaris::analysis::{DofLoad, InverseReport};
use solaris::io::Table;
use solaris::model::{Figure, Motion};

/// `DOF.tau`, as CSV has it.
pub(super) fn torques(figure: &Figure, motion: &Motion, forces: &InverseReport) -> Table {
    table(figure, motion, forces, |load| format!("{}.tau", load.dof))
}

/// `DOF_moment` and `DOF_force`, as OpenSim has it.
pub(super) fn moments(figure: &Figure, motion: &Motion, forces: &InverseReport) -> Table {
    let what = |load: &DofLoad| if load.unit == "N" { "force" } else { "moment" };
    let table = table(figure, motion, forces, |load| format!("{}_{}", load.dof, what(load)));
    let title = "Inverse Dynamics Generalized Forces".to_owned();
    Table { title, in_degrees: Some(false), ..table }
}

/// A column for each degree of freedom that is free: what follows another has no force of its own.
fn table(
    figure: &Figure,
    motion: &Motion,
    forces: &InverseReport,
    heading: impl Fn(&DofLoad) -> String,
) -> Table {
    let nv = figure.layout().nv();
    let free: Vec<usize> = (0..nv).filter(|&dof| !figure.follows(dof)).collect();
    let names = free.iter().map(|&dof| heading(&forces.dofs[dof]));
    let columns = std::iter::once("time".to_owned()).chain(names).collect();
    let rows = motion.time().iter().zip(forces.tau.chunks_exact(nv.max(1)));
    let values = rows.flat_map(|(time, tau)| std::iter::once(*time).chain(free.iter().map(|&dof| tau[dof])));
    let (values, lines) = (values.collect(), (1..).take(motion.len()).collect());
    Table { columns, values, lines, header_line: 1, ..Table::default() }
}
