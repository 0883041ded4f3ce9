//! The table: error, energy and cost of a step by every model of contact.

use super::{MODELS, Point, Series};
use crate::report::page::duration;
use crate::table::{Cell, Table, block, number};

/// The steps (s) of which errors are shown, and the one of which the cost is.
const SHOWN: [f64; 3] = [1e-2, 1e-3, 1e-4];
const COST: f64 = 1e-3;

pub(super) fn table(series: &[Series]) -> Table {
    let row = |of: &Series| {
        let beside = series.iter().find(|other| other.scene == of.scene && other.model == 0);
        let model = &MODELS[of.model];
        let mut row = vec![Cell::text(of.scene), Cell::text(model.name)];
        row.extend(SHOWN.map(|step| error(at(of, step))));
        row.push(gained(of));
        let own = cost(of);
        row.push(Cell::Time(own.map_or("–".to_owned(), |seconds| duration(1e9 * seconds))));
        let ratio = own.zip(beside.and_then(cost)).map(|(own, ours)| own / ours);
        row.push(Cell::Time(ratio.map_or("–".to_owned(), |ratio| format!("{ratio:.2}"))));
        row
    };
    let header = vec![
        "scene",
        "by",
        "error, 1e-2 s",
        "1e-3 s",
        "1e-4 s",
        "energy gained (J)",
        "a step",
        "over ours by impulses",
    ];
    Table { header, rows: series.iter().map(row).collect() }
}

fn at(series: &Series, step: f64) -> Option<&Point> {
    series.points.iter().find(|point| (point.step / step - 1.0).abs() < 1e-9)
}

fn error(point: Option<&Point>) -> Cell {
    match point.map(|point| &point.found) {
        None => Cell::text("–"),
        Some(Err(_)) => Cell::text("refused"),
        // What is below is rounding, which other processors have otherwise.
        Some(Ok(found)) if found[1] < ROUNDING => Cell::text(format!("< {}", number(ROUNDING))),
        Some(Ok(found)) => Cell::Numbers(vec![found[1]]),
    }
}

/// Errors from here on are shown.
const ROUNDING: f64 = 1e-12;
/// Energies from here on are shown (J).
const NOTHING: f64 = 1e-9;

/// The most over all steps that are shown.
fn gained(series: &Series) -> Cell {
    let all = SHOWN.iter().filter_map(|step| at(series, *step)).filter_map(|point| point.found.as_ref().ok());
    let most = all.map(|found| found[2]).fold(0.0, f64::max);
    if most < NOTHING { Cell::text("0") } else { Cell::Numbers(vec![most]) }
}

/// Of a step (s), by the run of [`COST`], or the longest step below it that there is.
fn cost(series: &Series) -> Option<f64> {
    let short = series.points.iter().filter(|point| point.step <= 1.0001 * COST);
    let mut found = short.filter_map(|point| point.found.as_ref().ok().map(|found| found[0] / point.count));
    found.next()
}

/// The table as it goes onto the page `text`: rows of engines that are not at hand stay as they were.
pub(super) fn kept(text: &str, name: &str, table: &Table) -> Result<String, String> {
    let old = block(text, name)?;
    let new = table.markdown();
    let key = |line: &str| line.split('|').skip(1).take(2).map(str::trim).collect::<Vec<_>>().join("|");
    let known: Vec<String> = new.lines().map(key).collect();
    let is_kept = |line: &&str| {
        let theirs = MODELS.iter().any(|model| !model.is_ours() && line.contains(model.name));
        theirs && !known.contains(&key(line))
    };
    let mut lines: Vec<String> = new.lines().map(str::to_owned).collect();
    for line in old.lines().filter(is_kept) {
        // After the last row of its scene.
        let scene = key(line).split('|').next().unwrap_or_default().to_owned();
        let place = lines.iter().rposition(|row| key(row).split('|').next() == Some(&scene));
        lines.insert(place.map_or(lines.len(), |place| place + 1), line.to_owned());
    }
    Ok(lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(scene: &str, by: &str, error: &str) -> Vec<Cell> {
        [scene, by, error].map(Cell::text).to_vec()
    }

    #[test]
    fn rows_of_engines_that_are_not_at_hand_stay() {
        let all = |rows| Table { header: vec!["scene", "by", "error"], rows };
        let old = all(vec![
            row("one", "ours, impulses", "1"),
            row("one", "MuJoCo, hard", "2"),
            row("two", "ours, impulses", "3"),
            row("two", "Drake, SAP", "4"),
        ]);
        let page =
            format!("<!-- table: x, written by `cargo lab` -->\n{}\n<!-- end of table -->", old.markdown());
        let new = all(vec![
            row("one", "ours, impulses", "5"),
            row("two", "ours, impulses", "6"),
            row("two", "Drake, SAP", "7"),
        ]);
        insta::assert_snapshot!(kept(&page, "x", &new).expect("a table"), @r"
        | scene | by | error |
        |---|--:|--:|
        | one | ours, impulses | 5 |
        | one | MuJoCo, hard | 2 |
        | two | ours, impulses | 6 |
        | two | Drake, SAP | 7 |
        ");
    }
}
