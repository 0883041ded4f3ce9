//! Tables of a page: written between marks, and compared with what stands there.

use std::fmt::Write;

/// How far a measured error on a page may be from what is measured now: other processors round sums in another order.
const FACTOR: f64 = 3.0;

/// A table in Markdown.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Table {
    pub(super) header: Vec<&'static str>,
    pub(super) rows: Vec<Vec<Cell>>,
}

/// What a cell holds says how it is compared.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Cell {
    /// Exactly.
    Text(String),
    /// To within [`FACTOR`]; in f64 and f32.
    Errors([f64; 2]),
    /// Not at all, but it has to be there.
    Time(String),
}

impl Cell {
    pub(super) fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    fn markdown(&self) -> String {
        match self {
            Self::Text(text) | Self::Time(text) => text.clone(),
            Self::Errors(errors) => errors.map(error).join(" / "),
        }
    }

    fn is_current(&self, found: &str) -> bool {
        match self {
            Self::Text(text) => text == found,
            Self::Time(_) => !found.is_empty(),
            Self::Errors(errors) => {
                let parts: Vec<&str> = found.split(" / ").collect();
                parts.len() == errors.len()
                    && parts.iter().zip(errors).all(|(part, error)| near(part, *error))
            }
        }
    }
}

/// Two digits; a dash where there is no number.
pub(super) fn error(x: f64) -> String {
    if x.is_finite() { format!("{x:.1e}") } else { "fails".to_owned() }
}

/// Whether a page's error is `error` to within [`FACTOR`].
fn near(found: &str, expected: f64) -> bool {
    match found.parse::<f64>() {
        Ok(found) => expected.is_finite() && found <= FACTOR * expected && expected <= FACTOR * found,
        Err(_) => found == error(expected),
    }
}

impl Table {
    pub(super) fn markdown(&self) -> String {
        let mut out = format!("| {} |\n|---{}|", self.header.join(" | "), "|--:".repeat(self.header.len() - 1));
        for row in &self.rows {
            let cells: Vec<String> = row.iter().map(Cell::markdown).collect();
            // Writing into a string does not fail.
            let _ = write!(out, "\n| {} |", cells.join(" | "));
        }
        out
    }

    /// What of the table in `text` is not as in this one.
    pub(super) fn differences(&self, text: &str) -> Vec<String> {
        let mut lines = text.lines();
        let mut differences = Vec::new();
        let expected = self.markdown();
        for line in expected.lines().take(2) {
            if lines.next() != Some(line) {
                differences.push(format!("the head should be {line}"));
            }
        }
        for row in &self.rows {
            let cells: Vec<&str> = lines.next().unwrap_or_default().trim_matches('|').split('|').map(str::trim).collect();
            for (i, cell) in row.iter().enumerate() {
                let found = cells.get(i).copied().unwrap_or_default();
                if !cell.is_current(found) {
                    differences.push(format!("{}: '{found}' should be {}", row[0].markdown(), cell.markdown()));
                }
            }
        }
        if lines.next().is_some() {
            differences.push("there are rows too many".to_owned());
        }
        differences
    }
}

/// What stands between the marks of `name` on a page.
pub(super) fn block<'a>(page: &'a str, name: &str) -> Result<&'a str, String> {
    let (_, rest) = page.split_once(&mark(name)).ok_or_else(|| format!("no line '{}'", mark(name).trim()))?;
    rest.split_once(END).map(|(block, _)| block).ok_or_else(|| format!("table '{name}' has no end"))
}

/// The page with `text` between the marks of `name`.
pub(super) fn replace(page: &str, name: &str, text: &str) -> Result<String, String> {
    let old = block(page, name)?;
    let mark = mark(name);
    Ok(page.replacen(&format!("{mark}{old}{END}"), &format!("{mark}{text}{END}"), 1))
}

fn mark(name: &str) -> String {
    format!("<!-- table: {name}, written by `cargo xtask report` -->\n")
}

const END: &str = "\n<!-- end of table -->";

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let row = |name: &str, errors| vec![Cell::text(name), Cell::Errors(errors), Cell::Time("1.0 µs".into())];
        Table { header: vec!["case", "error", "time"], rows: vec![row("a", [1e-16, 2e-7]), row("b", [3e-9, f64::INFINITY])] }
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
        insta::assert_snapshot!(answers.join("\n"), @"");
    }

    #[test]
    fn a_page_keeps_what_is_around_its_tables() {
        let page = "# Page\n\n<!-- table: x, written by `cargo xtask report` -->\nold\n<!-- end of table -->\n\nold";
        let new = replace(page, "x", "new").expect("marks");
        assert_eq!(block(&new, "x"), Ok("new"));
        assert_eq!(new, page.replacen("old", "new", 1));
        insta::assert_snapshot!(replace(page, "y", "new").expect_err("no such mark"), @"");
    }
}
