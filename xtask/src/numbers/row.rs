//! A row of the table: a number of a page, and what makes it.

use std::fmt;

/// What shows a number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Source {
    /// What the program prints.
    Solaris(Vec<String>),
    /// How long the program takes.
    Seconds(Vec<String>),
    /// What stands in a file.
    Text(String),
    /// How large a file is.
    Bytes(String),
    /// What cargo prints, after minutes of compiling.
    Cargo(Vec<String>),
}

impl Source {
    fn parse(command: &str) -> Result<Self, String> {
        let (first, rest) = command.split_once(' ').unwrap_or((command, ""));
        let words = |rest: &str| rest.split_whitespace().map(str::to_owned).collect();
        Ok(match (first, rest.strip_prefix("solaris ")) {
            ("solaris", _) => Self::Solaris(words(rest)),
            ("seconds", Some(rest)) => Self::Seconds(words(rest)),
            ("text", _) => Self::Text(rest.to_owned()),
            ("bytes", _) => Self::Bytes(rest.to_owned()),
            ("cargo", _) => Self::Cargo(words(rest)),
            _ => {
                return Err(format!(
                    "'{command}' is none of: solaris …, seconds solaris …, text FILE, bytes FILE, cargo …"
                ));
            }
        })
    }

    /// Whether it takes minutes.
    pub(super) fn is_long(&self) -> bool {
        matches!(self, Self::Cargo(_))
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Solaris(words) => write!(f, "`solaris {}`", words.join(" ")),
            Self::Seconds(words) => write!(f, "`seconds solaris {}`", words.join(" ")),
            Self::Text(path) => write!(f, "`text {path}`"),
            Self::Bytes(path) => write!(f, "`bytes {path}`"),
            Self::Cargo(words) => write!(f, "`cargo {}`", words.join(" ")),
        }
    }
}

/// A row.
#[derive(Debug)]
pub(super) struct Row {
    /// The line of the table.
    pub(super) line: String,
    /// The page.
    pub(super) page: String,
    /// What the page says.
    pub(super) says: String,
    /// What makes the number.
    pub(super) source: Source,
    /// What is shown, with `#` for the number and `*` for another one.
    pub(super) shows: String,
    /// The number that was shown.
    pub(super) is: f64,
    /// How far it may be off.
    pub(super) within: f64,
    /// When it was made.
    pub(super) day: String,
}

/// The rows of a page: the lines of its table that begin with a name in backticks.
pub(super) fn rows(text: &str) -> Result<Vec<Row>, String> {
    let lines = text.lines().enumerate().filter(|(_, line)| line.starts_with("| `"));
    lines.map(|(i, line)| row(line).map_err(|error| format!("line {}: {error}", i + 1))).collect()
}

fn row(line: &str) -> Result<Row, String> {
    let cells: Vec<&str> = line.trim().trim_matches('|').split(" | ").map(str::trim).collect();
    let [page, says, command, shows, is, within, day] = cells[..] else {
        return Err(format!("{} cells, and a row has seven", cells.len()));
    };
    let code = |cell: &str| {
        let inner = cell.strip_prefix('`').and_then(|cell| cell.strip_suffix('`'));
        // A bar in a cell is written `\|`.
        inner
            .map(|inner| inner.replace("\\|", "|"))
            .ok_or_else(|| format!("{cell} does not stand in backticks"))
    };
    let number = |cell: &str| {
        let number = cell.parse::<f64>().ok().filter(|number| number.is_finite());
        number.ok_or_else(|| format!("'{cell}' is no number"))
    };
    let shows = code(shows)?;
    if shows.matches('#').count() != 1 {
        return Err(format!("'{shows}' must have one #, for the number"));
    }
    if !is_day(day) {
        return Err(format!("'{day}' is no day such as 2026-11-27"));
    }
    Ok(Row {
        line: line.to_owned(),
        page: code(page)?,
        says: code(says)?,
        source: Source::parse(&code(command)?)?,
        shows,
        is: number(is)?,
        within: number(within)?,
        day: day.to_owned(),
    })
}

/// Whether it is written as a day.
pub(super) fn is_day(text: &str) -> bool {
    text.len() == 10
        && text
            .bytes()
            .enumerate()
            .all(|(i, byte)| if i == 4 || i == 7 { byte == b'-' } else { byte.is_ascii_digit() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wrong_with_a_row_is_said_with_its_line() {
        let good = "| `README.md` | `2 m` | `solaris walk` | `is # m` | 2 | 0 | 2026-11-27 |";
        assert_eq!(rows(&format!("# A page\n\n| page |\n|---|\n{good}\n")).expect("a row").len(), 1);
        for (from, to, why) in [
            ("| 2 |", "| two |", "'two' is no number"),
            ("is #", "is", "one #"),
            ("`solaris walk`", "`rm x`", "none of"),
            ("2026-11-27", "yesterday", "no day"),
            ("`2 m` | ", "", "6 cells"),
        ] {
            let error = rows(&good.replace(from, to)).expect_err(to);
            assert!(error.starts_with("line 1: ") && error.contains(why), "{error}");
        }
    }
}
