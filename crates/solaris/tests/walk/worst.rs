//! The worst value of every criterion, and where it was met.

use std::fmt;

struct Row {
    criterion: &'static str,
    value: f64,
    limit: f64,
    at: String,
}

/// Greatest values by criterion; a criterion holds while its value is at most its limit, and NaN never is.
#[derive(Default)]
pub(crate) struct Worst {
    rows: Vec<Row>,
}

impl Worst {
    /// Notes a value that must be at most `limit`.
    pub(crate) fn note(&mut self, criterion: &'static str, value: f64, limit: f64, at: impl Fn() -> String) {
        let excess = |value: f64, limit: f64| if value.is_nan() { f64::INFINITY } else { value - limit };
        match self.rows.iter_mut().find(|row| row.criterion == criterion) {
            Some(row) if excess(value, limit) > excess(row.value, row.limit) => {
                *row = Row { criterion, value, limit, at: at() };
            }
            Some(_) => {}
            None => self.rows.push(Row { criterion, value, limit, at: at() }),
        }
    }

    /// Takes over another's rows, as met in `case`.
    pub(crate) fn merge(&mut self, case: &str, other: &Self) {
        for row in &other.rows {
            self.note(row.criterion, row.value, row.limit, || format!("{case}, {}", row.at));
        }
    }

    /// The criteria that do not hold, one a line; empty if all do.
    pub(crate) fn broken(&self) -> String {
        let broken = self.rows.iter().filter(|row| row.value.is_nan() || row.value > row.limit);
        broken.map(ToString::to_string).collect::<Vec<_>>().join("\n")
    }

    /// Whether this criterion is among the broken ones.
    pub(crate) fn breaks(&self, criterion: &str) -> bool {
        assert!(self.rows.iter().any(|row| row.criterion == criterion), "nobody noted '{criterion}'");
        self.broken().lines().any(|line| line.starts_with(criterion))
    }

    /// Shows the table (with `--nocapture`) and asserts that all criteria hold.
    pub(crate) fn assert_all(&self, title: &str) {
        self.show(title);
        assert!(self.broken().is_empty(), "{title}\n{}", self.broken());
    }

    /// Shows the table.
    #[expect(clippy::print_stdout, reason = "captured unless somebody asks for it")]
    pub(crate) fn show(&self, title: &str) {
        println!("== {title}");
        self.rows.iter().for_each(|row| println!("{row}"));
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:<34} {:>11.3e}  (at most {:.3e})  {}", self.criterion, self.value, self.limit, self.at)
    }
}
