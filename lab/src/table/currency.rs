//! Checks that a page's tables say what is measured now.

use super::{Cell, Table, number};

/// How far a number on a page may be from what is measured now.
const FACTOR: f64 = 3.0;

impl Cell {
    fn is_current(&self, found: &str) -> bool {
        match self {
            Self::Text(text) => text == found,
            Self::Time(_) => !found.is_empty(),
            Self::Numbers(numbers) => {
                let parts: Vec<&str> = found.split(" / ").collect();
                parts.len() == numbers.len() && parts.iter().zip(numbers).all(|(part, x)| near(part, *x))
            }
        }
    }
}

impl Table {
    /// What of the table in `text` is not as in this one.
    pub(crate) fn differences(&self, text: &str) -> Vec<String> {
        let mut lines = text.lines();
        let mut differences = Vec::new();
        let expected = self.markdown();
        for line in expected.lines().take(2) {
            if lines.next() != Some(line) {
                differences.push(format!("the head should be {line}"));
            }
        }
        for row in &self.rows {
            let cells: Vec<&str> =
                lines.next().unwrap_or_default().trim_matches('|').split('|').map(str::trim).collect();
            for (i, cell) in row.iter().enumerate() {
                let found = cells.get(i).copied().unwrap_or_default();
                if !cell.is_current(found) {
                    differences.push(format!(
                        "{}: '{found}' should be {}",
                        row[0].markdown(),
                        cell.markdown()
                    ));
                }
            }
        }
        if lines.next().is_some() {
            differences.push("there are rows too many".to_owned());
        }
        differences
    }
}

/// Whether a page's number is `expected` to within [`FACTOR`].
fn near(found: &str, expected: f64) -> bool {
    match found.parse::<f64>() {
        Ok(found) => expected.is_finite() && found <= FACTOR * expected && expected <= FACTOR * found,
        Err(_) => found == number(expected),
    }
}

mod tests {
    use super::*;
    use crate::table::{block, replace};

    fn table() -> Table {
        let row = |name: &str, errors: [f64; 2]| {
            vec![Cell::text(name), Cell::Numbers(errors.into()), Cell::Time("1.0 µs".into())]
        };
        Table {
            header: vec!["case", "error", "time"],
            rows: vec![row("a", [1e-16, 2e-7]), row("b", [3e-9, f64::INFINITY])],
        }
    }

    #[test]
    fn a_table_is_what_it_prints() {
        insta::assert_snapshot!(table().markdown(), @r"
        | case | error | time |
        |---|--:|--:|
        | a | 1.0e-16 / 2.0e-7 | 1.0 µs |
        | b | 3.0e-9 / fails | 1.0 µs |
        ");
        assert_eq!(table().differences(&table().markdown()), Vec::<String>::new());
    }

    #[test]
    fn what_is_out_of_date_is_named() {
        let text = table().markdown();
        let tried = |from: &str, to: &str| table().differences(&text.replacen(from, to, 1)).join("; ");
        assert_eq!(tried("1.0e-16", "2.9e-16"), "");
        assert_eq!(tried("1.0 µs", "7.3 ns"), "");
        let answers = [
            tried("1.0e-16", "3.1e-16"),
            tried("1.0e-16", "0.3e-16"),
            tried("fails", "1e-2"),
            tried("2.0e-7 |", "2.0e-7 / 1e-3 |"),
            tried("| a", "| c"),
            tried("1.0 µs", ""),
            tried("| error", "| loss"),
            table().differences(&format!("{text}\n| c |")).join("; "),
            table().differences(text.rsplit_once('\n').expect("lines").0).join("; "),
        ];
        insta::assert_snapshot!(answers.join("\n"), @r"
        a: '3.1e-16 / 2.0e-7' should be 1.0e-16 / 2.0e-7
        a: '0.3e-16 / 2.0e-7' should be 1.0e-16 / 2.0e-7
        b: '3.0e-9 / 1e-2' should be 3.0e-9 / fails
        a: '1.0e-16 / 2.0e-7 / 1e-3' should be 1.0e-16 / 2.0e-7
        a: 'c' should be a
        a: '' should be 1.0 µs
        the head should be | case | error | time |
        there are rows too many
        b: '' should be b; b: '' should be 3.0e-9 / fails; b: '' should be 1.0 µs
        ");
    }

    #[test]
    fn a_page_keeps_what_is_around_its_tables() {
        let page = "# Page\n\n<!-- table: x, written by `cargo lab` -->\nold\n<!-- end of table -->\n\nold";
        let new = replace(page, "x", "new").expect("marks");
        assert_eq!(block(&new, "x"), Ok("new"));
        assert_eq!(new, page.replacen("old", "new", 1));
        insta::assert_snapshot!(replace(page, "y", "new").expect_err("no such mark"), @"no line '<!-- table: y, written by `cargo lab` -->'");
    }
}
