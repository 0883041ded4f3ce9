//! Joint forces as tables: our headings, and OpenSim's.

use solaris::analysis::{DofLoad, InverseReport};
use solaris::io::Table;
use solaris::model::{Figure, Motion};

/// `DOF.tau`, as CSV has it, and `DOF.tau_se`, their standard `errors`, where these are known.
pub(super) fn torques(
    figure: &Figure,
    motion: &Motion,
    forces: &InverseReport,
    errors: Option<&[f64]>,
) -> Table {
    table(figure, motion, forces, errors, |load| format!("{}.tau", load.dof))
}

/// `DOF_moment` and `DOF_force`, as OpenSim has it.
pub(super) fn moments(figure: &Figure, motion: &Motion, forces: &InverseReport) -> Table {
    let what = |load: &DofLoad| if load.unit == "N" { "force" } else { "moment" };
    let table = table(figure, motion, forces, None, |load| format!("{}_{}", load.dof, what(load)));
    let title = "Inverse Dynamics Generalized Forces".to_owned();
    Table { title, in_degrees: Some(false), ..table }
}

/// A column for each degree of freedom that is free: what follows another has no force of its own.
fn table(
    figure: &Figure,
    motion: &Motion,
    forces: &InverseReport,
    errors: Option<&[f64]>,
    heading: impl Fn(&DofLoad) -> String,
) -> Table {
    let nv = figure.layout().nv();
    let free: Vec<usize> = (0..nv).filter(|&dof| !figure.follows(dof)).collect();
    let names = || free.iter().map(|&dof| heading(&forces.dofs[dof]));
    let of_errors = errors.iter().flat_map(|_| names().map(|name| format!("{name}_se")));
    let columns = std::iter::once("time".to_owned()).chain(names()).chain(of_errors).collect();
    let blocks: Vec<&[f64]> = std::iter::once(&*forces.tau).chain(errors).collect();
    let values = motion.time().iter().enumerate().flat_map(|(row, time)| {
        let of = |block: &[f64]| free.iter().map(|&dof| block[row * nv + dof]).collect::<Vec<_>>();
        std::iter::once(*time).chain(blocks.iter().flat_map(|block| of(block))).collect::<Vec<_>>()
    });
    let (values, lines) = (values.collect(), (1..).take(motion.len()).collect());
    Table { columns, values, lines, header_line: 1, ..Table::default() }
}
