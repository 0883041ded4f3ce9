//! Tables of a page, written between marks.

use std::fmt::Write;

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
    /// To within a factor: other processors round sums in another order.
    Numbers(Vec<f64>),
    /// Not at all, but it has to be there.
    Time(String),
}

impl Cell {
    pub(super) fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    pub(super) fn markdown(&self) -> String {
        match self {
            Self::Text(text) | Self::Time(text) => text.clone(),
            Self::Numbers(numbers) => numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(" / "),
        }
    }
}

/// Two digits; infinity is the error of what has no answer.
pub(super) fn number(x: f64) -> String {
    if x.is_finite() { format!("{x:.1e}") } else { "fails".to_owned() }
}

impl Table {
    pub(super) fn markdown(&self) -> String {
        let mut out =
            format!("| {} |\n|---{}|", self.header.join(" | "), "|--:".repeat(self.header.len() - 1));
        for row in &self.rows {
            let cells: Vec<String> = row.iter().map(Cell::markdown).collect();
            // Writing into a string does not fail.
            let _ = write!(out, "\n| {} |", cells.join(" | "));
        }
        out
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
    format!("<!-- table: {name}, written by `cargo lab report` -->\n")
}

const END: &str = "\n<!-- end of table -->";
