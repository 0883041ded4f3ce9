//! What plates measured as a table for OpenSim.

use super::plates::{LoadOptions, Plate};
use crate::table::{TIME, Table};

/// A table of what `plates` did, for a `.mot` file: a row a sample, and of plate n force `ground_force_n_vx` (N), centre of
/// pressure `ground_force_n_px` (m) and free moment `ground_torque_n_x` (N·m), x, y and z of each. All nine are zero while
/// nothing is on a plate. `None` where there is no plate, or where they have different rates.
///
/// [`record::forces`](crate::record::forces()) finds them as `1`, `2`, ….
pub fn ground_forces(plates: &[Plate], options: &LoadOptions) -> Option<Table> {
    let rate = plates.first()?.rate;
    if plates.iter().any(|plate| (plate.rate / rate - 1.0).abs() > 1e-9) {
        return None;
    }
    let mut columns = vec![TIME.to_owned()];
    for Plate { number: plate, .. } in plates {
        let headings = [
            format!("ground_force_{plate}_v"),
            format!("ground_force_{plate}_p"),
            format!("ground_torque_{plate}_"),
        ];
        columns.extend(
            headings.iter().flat_map(|heading| ["x", "y", "z"].map(|axis| format!("{heading}{axis}"))),
        );
    }
    let loads: Vec<_> = plates.iter().map(|plate| plate.loads(options)).collect();
    let rows = loads.iter().map(Vec::len).min()?;
    let mut values = Vec::with_capacity(rows * columns.len());
    for row in 0..rows {
        values.push(row as f64 / rate);
        for loads in &loads {
            let load = &loads[row];
            let parts = [load.force, load.centre.unwrap_or_default(), load.free_moment];
            // A sum with zero has no negative one.
            values.extend(parts.iter().flat_map(|part| part.iter().map(|value| value + 0.0)));
        }
    }
    Some(Table {
        title: "Ground reaction forces".to_owned(),
        in_degrees: Some(false),
        columns,
        values,
        lines: (1..).take(rows).collect(),
        header_line: 1,
        ..Table::default()
    })
}
