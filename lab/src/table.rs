//! Tables of a page, written between marks.

#[cfg(test)]
mod currency;

use std::fmt::Write;

/// A table in Markdown.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Table {
    pub(crate) header: Vec<&'static str>,
    pub(crate) rows: Vec<Vec<Cell>>,
}

/// What a cell holds says how it is compared.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cell {
    /// Exactly.
    Text(String),
    /// To within a factor: other processors round sums in another order.
    Numbers(Vec<f64>),
    /// Not at all, but it has to be there.
    Time(String),
}

impl Cell {
    pub(crate) fn text(text: impl Into<String>) -> Self {
        Self::Text(text.into())
    }

    pub(crate) fn markdown(&self) -> String {
        match self {
            Self::Text(text) | Self::Time(text) => text.clone(),
            Self::Numbers(numbers) => numbers.iter().map(|x| number(*x)).collect::<Vec<_>>().join(" / "),
        }
    }
}

/// Two digits; infinity is the error of what has no answer.
pub(crate) fn number(x: f64) -> String {
    if x.is_finite() { format!("{x:.1e}") } else { "fails".to_owned() }
}

impl Table {
    pub(crate) fn markdown(&self) -> String {
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
pub(crate) fn block<'a>(page: &'a str, name: &str) -> Result<&'a str, String> {
    let (_, rest) = page.split_once(&mark(name)).ok_or_else(|| format!("no line '{}'", mark(name).trim()))?;
    rest.split_once(END).map(|(block, _)| block).ok_or_else(|| format!("table '{name}' has no end"))
}

/// The page with `text` between the marks of `name`.
pub(crate) fn replace(page: &str, name: &str, text: &str) -> Result<String, String> {
    let old = block(page, name)?;
    let mark = mark(name);
    Ok(page.replacen(&format!("{mark}{old}{END}"), &format!("{mark}{text}{END}"), 1))
}

fn mark(name: &str) -> String {
    format!("<!-- table: {name}, written by `cargo lab` -->\n")
}

const END: &str = "\n<!-- end of table -->";
