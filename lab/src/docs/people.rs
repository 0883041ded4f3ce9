//! Smooth walks beside people: the tables of docs/people.md.

use super::Tables;
use crate::table::{Cell, Table};
use solaris_gait::determinants::{Determinants, GaitTable};
use solaris_gait::people::{Compared, compare, curve_table, table};
use solaris_model::{Figure, human};

/// Step frequencies (steps/min).
const STEP_FREQUENCIES: [f64; 6] = [80.0, 95.0, 110.0, 118.0, 120.0, 130.0];
/// Height (m) and mass (kg) of the bodies.
const BODIES: [(f64, f64); 3] = [(1.5, 50.0), (1.75, 73.0), (1.95, 92.0)];

fn body((height, mass): (f64, f64)) -> Result<Figure, String> {
    human(height, mass).map_err(|error| error.to_string())
}

/// The tables of the page.
pub(super) fn tables(_: &str) -> Result<Tables, String> {
    let five = compare(&body(BODIES[1])?, Determinants::Five, &STEP_FREQUENCIES);
    let three = compare(&body(BODIES[1])?, Determinants::Three, &STEP_FREQUENCIES);
    let markdown = |table: GaitTable| table.markdown().trim_end().to_owned();
    Ok(vec![
        ("five", markdown(table(Determinants::Five, &five))),
        ("curves", markdown(curve_table(&five))),
        ("three", markdown(table(Determinants::Three, &three))),
        ("bodies", counts()?.markdown()),
    ])
}

/// How many facts lie inside, for all bodies and both numbers of determinants.
fn counts() -> Result<Table, String> {
    let mut rows = Vec::new();
    for (height, mass) in BODIES {
        let figure = body((height, mass))?;
        for determinants in [Determinants::Five, Determinants::Three] {
            eprintln!("docs: beside people, {height} m, {} determinants", determinants.count());
            let mut row =
                vec![Cell::text(format!("{height} m, {mass} kg, {} determinants", determinants.count()))];
            row.extend(STEP_FREQUENCIES.iter().map(|frequency| {
                let compared = Compared::of(&figure, determinants, *frequency);
                Cell::text(
                    compared
                        .inside()
                        .map_or_else(|| "refused".to_owned(), |(held, of)| format!("{held} of {of}")),
                )
            }));
            rows.push(row);
        }
    }
    Ok(Table {
        header: vec!["facts inside", "80 /min", "95 /min", "110 /min", "118 /min", "120 /min", "130 /min"],
        rows,
    })
}
