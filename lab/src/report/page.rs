//! The tables of docs/accuracy.md and docs/operations.md.

use super::cases::{Case, Errors, HARD, ORDINARY};
use super::measured::Accuracy;
use super::speed::Speed;
use crate::table::{Cell, Table, number};
use std::time::{Duration, SystemTime};

/// All that is measured.
pub(super) struct Measured {
    /// Of [`ORDINARY`] and [`HARD`].
    pub(super) ordinary: Vec<Accuracy>,
    pub(super) hard: Vec<Accuracy>,
    /// Of [`ORDINARY`].
    pub(super) speeds: Vec<Speed>,
    /// Of a chain of [`LONG`] links.
    pub(super) long: Speed,
}

/// Growth is measured from [`ORDINARY`]'s shortest chain, of 10 links, to one of these.
pub(super) const LONG: usize = 300;

/// The calls, in the order of [`Speed`].
pub(super) const CALLS: [&str; 4] = ["chain-wise", "tree-wise", "Newton-Euler", "forward dynamics"];

impl Measured {
    /// The error of a call (f64, f32) for one of [`ORDINARY`].
    pub(super) fn error(&self, case: usize, call: usize) -> Errors {
        let Accuracy { inverse, forward, .. } = &self.ordinary[case];
        inverse.get(call).copied().unwrap_or(*forward)
    }

    /// Error, time and operations of each call for each of [`ORDINARY`].
    pub(super) fn calls(&self) -> Table {
        let row = |case: usize, call: usize| {
            let Speed { times, operations } = &self.speeds[case];
            let [double, single] = times[call].map(|time| Cell::Time(duration(time)));
            let (name, error) = (ORDINARY[case].name, self.error(case, call));
            let operations = Cell::text(thousands(operations[call]));
            vec![
                Cell::text(name),
                Cell::text(CALLS[call]),
                Cell::Numbers(error.into()),
                double,
                single,
                operations,
            ]
        };
        Table {
            header: vec!["figure", "call", "error, f64 / f32", "time, f64", "time, f32", "operations"],
            rows: (0..ORDINARY.len())
                .flat_map(|case| (0..CALLS.len()).map(move |call| row(case, call)))
                .collect(),
        }
    }

    fn cases(&self) -> impl Iterator<Item = (&'static Case, &Accuracy)> {
        ORDINARY.iter().zip(&self.ordinary).chain(HARD.iter().zip(&self.hard))
    }

    /// Inverse dynamics of every case, beside what others lose.
    pub(super) fn inverse(&self) -> Table {
        let row = |(case, accuracy): (&Case, &Accuracy)| {
            let mut row = vec![Cell::text(case.name)];
            row.extend(accuracy.inverse.iter().map(|errors| Cell::Numbers(errors.to_vec())));
            let others = case.inverse.map(|other| [other.lagrangian, other.local, other.world]);
            row.extend((0..3).map(|i| published(others.map(|others| others[i]))));
            row
        };
        Table {
            header: vec![
                "f64 / f32",
                "chain-wise",
                "tree-wise",
                "Newton-Euler",
                "elsewhere, 4×4",
                "elsewhere, links' frames",
                "elsewhere, world's frame",
            ],
            rows: self.cases().map(row).collect(),
        }
    }

    /// Forward dynamics of every case, beside the way by the mass matrix and what others lose.
    pub(super) fn forward(&self) -> Table {
        let row = |(case, accuracy): (&Case, &Accuracy)| {
            let dash = || Cell::text("–");
            vec![
                Cell::text(case.name),
                accuracy.condition.map_or_else(dash, |condition| Cell::Numbers(vec![condition])),
                Cell::Numbers(accuracy.forward.to_vec()),
                published(case.forward.map(|other| other.articulated)),
                accuracy.matrix.map_or_else(dash, |errors| Cell::Numbers(errors.to_vec())),
                published(case.forward.map(|other| other.matrix)),
            ]
        };
        Table {
            header: vec![
                "f64 / f32",
                "cond(M)",
                "`forward_dynamics`",
                "elsewhere, O(n)",
                "`mass_matrix`, Cholesky",
                "elsewhere, by matrix",
            ],
            rows: self.cases().map(row).collect(),
        }
    }

    /// How times grow from 10 to [`LONG`] links.
    pub(super) fn growth(&self) -> Table {
        let row = |call: usize| {
            let mut row = vec![Cell::text(CALLS[call])];
            for width in 0..2 {
                let (short, long) = (self.speeds[1].times[call][width], self.long.times[call][width]);
                let exponent = (long / short).ln() / (LONG as f64 / 10.0).ln();
                row.extend([duration(short), duration(long), format!("{exponent:.2}")].map(Cell::Time));
            }
            row
        };
        Table {
            header: vec![
                "call",
                "10, f64",
                "300, f64",
                "exponent, f64",
                "10, f32",
                "300, f32",
                "exponent, f32",
            ],
            rows: (0..CALLS.len()).map(row).collect(),
        }
    }

    /// Times of the formulations of inverse dynamics, for docs/operations.md.
    pub(super) fn times(&self) -> Table {
        let row = |call: usize| {
            let times = self.speeds.iter().flat_map(|speed| speed.times[call]);
            std::iter::once(Cell::text(CALLS[call]))
                .chain(times.map(|time| Cell::Time(duration(time))))
                .collect()
        };
        Table {
            header: vec![
                "time of a call",
                "human, 66, f64",
                "f32",
                "chain of 10, f64",
                "f32",
                "chain of 100, f64",
                "f32",
                "chain of 1000, f64",
                "f32",
            ],
            rows: (0..3).map(row).collect(),
        }
    }
}

fn published(errors: Option<Errors>) -> Cell {
    Cell::Text(errors.map_or_else(|| "–".to_owned(), |errors| errors.map(number).join(" / ")))
}

/// A time (given in ns) with three digits.
pub(crate) fn duration(ns: f64) -> String {
    let (value, unit) = match ns {
        ..1e3 => (ns, "ns"),
        ..1e6 => (ns / 1e3, "µs"),
        _ => (ns / 1e6, "ms"),
    };
    let decimals = usize::from(value < 100.0) + usize::from(value < 10.0);
    format!("{value:.decimals$} {unit}")
}

fn thousands(n: u64) -> String {
    if n < 1000 { n.to_string() } else { format!("{} {:03}", thousands(n / 1000), n % 1000) }
}

/// Where and when: the kind of machine, and the day.
pub(crate) fn circumstances() -> String {
    let (arch, os) = (std::env::consts::ARCH, std::env::consts::OS);
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or(Duration::ZERO);
    format!(
        "Measured on {} on one core of an {arch} machine under {os}, release build without options for the processor.",
        date(since.as_secs() / 86_400)
    )
}

/// The date that is `days` after 1970-01-01.
fn date(mut days: u64) -> String {
    let is_leap =
        |year: u64| year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let mut year = 1970;
    loop {
        let length = 365 + u64::from(is_leap(year));
        if days < length {
            break;
        }
        (days, year) = (days - length, year + 1);
    }
    let mut month = 1;
    for length in [31, 28 + u64::from(is_leap(year)), 31, 30, 31, 30, 31, 31, 30, 31, 30, 31] {
        if days < length {
            break;
        }
        (days, month) = (days - length, month + 1);
    }
    format!("{year}-{month:02}-{:02}", days + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [12.345, 123.4, 1234.0, 45_678.0, 7.89e6].map(duration).join(", "),
            "12.3 ns, 123 ns, 1.23 µs, 45.7 µs, 7.89 ms"
        );
        assert_eq!([7, 1234, 12_003_004].map(thousands).join(", "), "7, 1 234, 12 003 004");
    }

    #[test]
    fn days_have_dates() {
        assert_eq!(
            [0, 59, 11_016, 20_513].map(date).join(", "),
            "1970-01-01, 1970-03-01, 2000-02-29, 2026-03-01"
        );
    }
}
