//! Numbers and names as people read them, and lines of a summary.

use std::io::{Result, Write};

/// A line of a summary; what has no name goes on with the line before it.
pub(crate) fn row(out: &mut dyn Write, what: &str, value: &str) -> Result<()> {
    writeln!(out, "  {what:<18}{value}")
}

/// A mass as people read it: to a milligram. JSON has all digits.
pub(crate) fn rounded(mass: f64) -> String {
    let text = format!("{mass:.6}");
    text.trim_end_matches('0').trim_end_matches('.').trim_start_matches('-').to_owned()
}

/// Names as far as a person reads them.
pub(crate) fn some(names: &[String]) -> String {
    const MANY: usize = 8;
    let shown = names[..names.len().min(MANY)].join(", ");
    if names.len() > MANY { format!("{shown} and {} more", names.len() - MANY) } else { shown }
}

/// A number with as many digits as a person reads.
pub(crate) fn short(value: f64) -> String {
    let size = value.abs();
    if size >= 1e6 || (size > 0.0 && size < 1e-3) {
        return format!("{value:.2e}");
    }
    let digits = if size >= 100.0 {
        1
    } else if size >= 10.0 {
        2
    } else {
        3
    };
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A count with its noun.
pub(crate) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
