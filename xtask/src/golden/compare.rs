//! Two tables, column by column, each within its tolerance.

use super::case::Tolerances;
use super::table::Table;
use std::fmt;

/// Columns that are named before the rest is counted.
const SHOWN: usize = 10;

/// Tables that agree: how close the worst column came to its tolerance.
#[derive(Debug, PartialEq)]
pub(crate) struct Agreement {
    columns: usize,
    rows: usize,
    worst: Option<Difference>,
}

/// The greatest difference of one column.
#[derive(Clone, Debug, PartialEq)]
struct Difference {
    column: String,
    row: usize,
    time: String,
    expected: String,
    actual: String,
    tolerance: f64,
    /// Difference by tolerance; infinite for a number that is none.
    ratio: f64,
}

/// Compares `actual` with `expected`. Order of columns does not matter; everything else does.
///
/// # Errors
///
/// Every column that is missing, is new, has no tolerance or is off, with the row, the time and both values.
pub(crate) fn compare(
    expected: &Table,
    actual: &Table,
    tolerances: &Tolerances,
) -> Result<Agreement, String> {
    let mut faults = Vec::new();
    for (table, other, what) in [(expected, actual, "missing"), (actual, expected, "new")] {
        let lost: Vec<&str> =
            table.header.iter().filter(|name| !other.header.contains(name)).map(String::as_str).collect();
        if !lost.is_empty() {
            faults.push(format!("{what} columns: {}", shown(&lost)));
        }
    }
    let untold: Vec<&str> =
        expected.header.iter().filter(|name| tolerances.of(name).is_none()).map(String::as_str).collect();
    if !untold.is_empty() {
        faults.push(format!("no tolerance fits columns: {}", shown(&untold)));
    }
    if expected.rows.len() != actual.rows.len() {
        faults.push(format!("{} rows expected, {} found", expected.rows.len(), actual.rows.len()));
    }
    let worst: Vec<Difference> = (0..expected.header.len())
        .filter_map(|column| worst_of(column, expected, actual, tolerances))
        .collect();
    let off: Vec<String> =
        worst.iter().filter(|worst| worst.ratio > 1.0).map(Difference::to_string).collect();
    faults.extend(off.iter().take(SHOWN).cloned());
    if off.len() > SHOWN {
        faults.push(format!("… and {} more columns", off.len() - SHOWN));
    }
    if !faults.is_empty() {
        return Err(faults.join("\n"));
    }
    let worst = worst.into_iter().max_by(|a, b| a.ratio.total_cmp(&b.ratio));
    Ok(Agreement { columns: expected.header.len(), rows: expected.rows.len(), worst })
}

/// The greatest difference of a column that both tables have, by the expected one's index.
fn worst_of(column: usize, expected: &Table, actual: &Table, tolerances: &Tolerances) -> Option<Difference> {
    let name = &expected.header[column];
    let tolerance = tolerances.of(name)?;
    let other = actual.header.iter().position(|other| other == name)?;
    let time = expected.header.iter().position(|name| name == "time");
    let rows = expected.rows.iter().zip(&actual.rows).enumerate();
    let differences = rows.map(|(row, (expected, actual))| Difference {
        column: name.clone(),
        row: row + 1,
        time: time.map_or_else(|| "?".to_owned(), |time| expected[time].clone()),
        expected: expected[column].clone(),
        actual: actual[other].clone(),
        tolerance,
        ratio: ratio(&expected[column], &actual[other], tolerance),
    });
    differences.max_by(|a, b| a.ratio.total_cmp(&b.ratio))
}

/// The difference by the tolerance; infinite where a text is no finite number, and for any difference at tolerance zero.
fn ratio(expected: &str, actual: &str, tolerance: f64) -> f64 {
    let number = |text: &str| text.parse().ok().filter(|value: &f64| value.is_finite());
    let (Some(expected), Some(actual)) = (number(expected), number(actual)) else { return f64::INFINITY };
    let difference = (expected - actual).abs();
    if difference > 0.0 { difference / tolerance } else { 0.0 }
}

fn shown(names: &[&str]) -> String {
    let some = names.iter().take(SHOWN).copied().collect::<Vec<_>>().join(", ");
    if names.len() > SHOWN { format!("{some} … ({} in all)", names.len()) } else { some }
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let actual = if self.actual.is_empty() { "nothing" } else { &self.actual };
        write!(
            f,
            "column {}, row {}, time {} s: expected {}, found {actual}, tolerance {:e}",
            self.column, self.row, self.time, self.expected, self.tolerance
        )
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "ok, {} columns, {} rows", self.columns, self.rows)?;
        match &self.worst {
            Some(worst) if worst.ratio > 0.0 => {
                write!(f, ", worst at {:.2} of its tolerance: {worst}", worst.ratio)
            }
            _ => write!(f, ", all equal"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXPECTED: &str = "time,a.q,a.fx\n0,1,100\n0.5,2,200\n1,3,300\n";

    fn check(actual: &str) -> String {
        let tolerances = [("time", 0.0), ("*.q", 1e-9), ("*.fx", 1e-3)].map(|(p, t)| (p.to_owned(), t));
        let table = |text| Table::parse(text).expect("well-formed");
        match compare(&table(EXPECTED), &table(actual), &Tolerances(tolerances.to_vec())) {
            Ok(agreement) => agreement.to_string(),
            Err(faults) => faults,
        }
    }

    #[test]
    fn what_is_equal_within_tolerance_passes() {
        insta::assert_snapshot!(check(EXPECTED), @"ok, 3 columns, 3 rows, all equal");
        let near = "a.fx,time,a.q\n100,0.0,1\n200.0004,0.5,2\n300,1,3\n";
        insta::assert_snapshot!(check(near), @"ok, 3 columns, 3 rows, worst at 0.40 of its tolerance: column a.fx, row 2, time 0.5 s: expected 200, found 200.0004, tolerance 1e-3");
    }

    #[test]
    fn a_changed_number_fails_with_place_and_values() {
        insta::assert_snapshot!(check(&EXPECTED.replace("200", "200.002")), @"column a.fx, row 2, time 0.5 s: expected 200, found 200.002, tolerance 1e-3");
        insta::assert_snapshot!(check(&EXPECTED.replace("0.5", "0.50000001")), @"column time, row 2, time 0.5 s: expected 0.5, found 0.50000001, tolerance 0e0");
    }

    #[test]
    fn a_number_that_is_none_fails_on_either_side() {
        insta::assert_snapshot!(check(&EXPECTED.replace(",2,", ",NaN,")), @"column a.q, row 2, time 0.5 s: expected 2, found NaN, tolerance 1e-9");
        insta::assert_snapshot!(check(&EXPECTED.replace("300", "inf").replace(",1,", ",,")), @"
        column a.q, row 1, time 0 s: expected 1, found nothing, tolerance 1e-9
        column a.fx, row 3, time 1 s: expected 300, found inf, tolerance 1e-3
        ");
        let nan = Table::parse("time\nNaN\n").expect("well-formed");
        assert!(
            compare(&nan, &nan, &Tolerances(vec![("*".to_owned(), 1.0)])).is_err(),
            "and is never blessed"
        );
    }

    #[test]
    fn missing_and_new_columns_and_rows_fail() {
        insta::assert_snapshot!(check("time,a.q,b.q\n0,1,1\n0.5,2,1\n"), @"
        missing columns: a.fx
        new columns: b.q
        3 rows expected, 2 found
        ");
        insta::assert_snapshot!(check("time,a.q\n0,1\n0.5,2\n1,3\n"), @"missing columns: a.fx");
    }

    #[test]
    fn a_column_without_a_tolerance_fails() {
        let table = Table::parse(EXPECTED).expect("well-formed");
        let answer = compare(&table, &table, &Tolerances(vec![("*.q".to_owned(), 1.0)]));
        assert_eq!(answer, Err("no tolerance fits columns: time, a.fx".to_owned()));
    }
}
