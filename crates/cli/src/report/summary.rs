//! The table that a report prints.

use super::Subject;
use solaris::modes::study::Study;
use solaris::view::precision::{Table, report};
use std::fmt::Write;

/// Columns of the sentences.
const WIDTH: usize = 100;

/// What was found, and the tables.
pub(super) fn table(study: &Study, subject: &Subject, written: impl Iterator<Item = String>) -> String {
    let Subject { title, settings } = subject;
    let all = report(study, title, settings.duration, settings.rate);
    let mut text = format!("{}\n{}\n\n", all.diagram.title, all.diagram.subtitle);
    for finding in &all.findings {
        text.push_str(&wrapped(finding));
    }
    for table in &all.tables {
        let _ = write!(text, "\n{}\n{}\n{}", table.title, wrapped(&table.note), columns(table));
    }
    for (i, line) in written.enumerate() {
        let _ = writeln!(text, "{}{line}", if i == 0 { "\n" } else { "" });
    }
    text
}

/// The rows in columns; a row without numbers says what it has behind its name.
fn columns(table: &Table) -> String {
    let mut widths: Vec<usize> = table.header.iter().map(|name| name.chars().count()).collect();
    for row in &table.rows {
        let is_whole = row.len() == table.header.len();
        for (width, cell) in widths.iter_mut().zip(row).take(if is_whole { row.len() } else { 1 }) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let mut text = String::new();
    for (index, row) in std::iter::once(&table.header).chain(&table.rows).enumerate() {
        let is_marked = index > 0 && table.marked.contains(&(index - 1));
        let mut line = format!("{} {:<2$}", if is_marked { '*' } else { ' ' }, row[0], widths[0]);
        for (cell, width) in row.iter().zip(&widths).skip(1) {
            let _ = if row.len() == table.header.len() {
                write!(line, "  {cell:>width$}")
            } else {
                write!(line, "  {cell}")
            };
        }
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

/// Sentences in lines.
fn wrapped(sentences: &str) -> String {
    let (mut text, mut width) = (String::new(), 0);
    for word in sentences.split_whitespace() {
        let length = word.chars().count();
        if width > 0 && width + 1 + length > WIDTH {
            text.push('\n');
            width = 0;
        } else if width > 0 {
            text.push(' ');
            width += 1;
        }
        text.push_str(word);
        width += length;
    }
    if width > 0 {
        text.push('\n');
    }
    text
}
