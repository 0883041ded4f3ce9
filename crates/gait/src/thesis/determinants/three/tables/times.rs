//! Table 7.5: the durations of the phases.

use crate::thesis::determinants::three::times::{Division, parts_of_step};
use crate::thesis::determinants::{Cell, Cycle, DoubleSupport, GaitTable};

/// Step frequencies of the columns (steps/min).
const AT: [u32; 6] = [60, 80, 100, 110, 120, 180];

pub(super) fn times() -> GaitTable {
    let rows = [
        ("starting", Cycle::Starting, ["½ double support time", "swing time"]),
        ("intermediate", Cycle::Intermediate, ["double support time", "swing time"]),
        ("finishing", Cycle::Finishing, ["double support time", "½ swing time"]),
    ];
    let mut columns = vec!["Cycle".to_owned(), "Phase".to_owned(), "Time".to_owned()];
    columns.extend(AT.map(|frequency| format!("s at {frequency}/min")));
    let row = |(name, cycle, texts): (&str, Cycle, [&str; 2]), phase: usize| {
        let mut cells =
            vec![Cell::plain(name), Cell::plain((phase + 1).to_string()), Cell::plain(texts[phase])];
        cells.extend(AT.map(|frequency| {
            let frequency = f64::from(frequency);
            let parts = parts_of_step(cycle, DoubleSupport::Thesis, Division::Halved, frequency);
            Cell::plain(format!("{:.3}", parts[phase] * 60.0 / frequency))
        }));
        cells
    };
    GaitTable {
        number: "7.5",
        title: "how long the phases last",
        columns,
        rows: rows.into_iter().flat_map(|cycle| [row(cycle, 0), row(cycle, 1)]).collect(),
        notes: vec![
            "The text suggests for uniformity that the first phase of a walk lasts a whole double support; walks do so here, and \
             their last phase lasts a whole swing."
                .to_owned(),
            "(7.18) and (7.19) are printed per minute; in seconds t = 60/sf and V = 0.004·H·sf²/60. (7.20) has no double support \
             left at 181.75 steps/min, just below the 182 of (7.16), and is 0 from there on."
                .to_owned(),
        ],
    }
}
