//! Rows of a table to walks, on all cores.

use crate::args::{WalkArgs, parse, walk_options};
use crate::error::CliError;
use crate::pool::pool;
use crate::walk::{asked, figure, heading_first};
use clap::Command;
use rayon::ThreadPool;
use rayon::prelude::*;
use solaris::gait::sweep::{COLUMNS, metrics_of};
use solaris::io::csv::{Row, number_text};

/// Rows that a thread takes on before they are written.
const AT_A_TIME: usize = 32;

/// What became of a row.
pub(super) enum Done {
    /// Its measures.
    Walked(Vec<Option<f64>>),
    /// Why there is no such walk, in one line.
    Refused(String),
}

impl Done {
    /// The fields of its row: what was asked in as many columns as there are, the measures, the refusal.
    pub(super) fn fields(&self, row: &Row, columns: usize) -> Vec<String> {
        let asked = row.fields.iter().cloned().chain(std::iter::repeat(String::new()));
        let (measures, refusal) = match self {
            Self::Walked(numbers) => {
                (numbers.iter().map(|number| number.map_or_else(String::new, number_text)).collect(), "")
            }
            Self::Refused(why) => (vec![String::new(); COLUMNS.len()], why.as_str()),
        };
        asked.take(columns).chain(measures).chain([refusal.to_owned()]).collect()
    }
}

/// Walks rows of one table.
pub(super) struct Walker {
    columns: Vec<String>,
    rate: f64,
    options: Command,
    pool: ThreadPool,
}

impl Walker {
    /// For rows below these headings, measured at so many samples a second, by so many threads (0: one a core).
    pub(super) fn new(columns: &[String], rate: f64, threads: usize) -> Result<Self, CliError> {
        Ok(Self { columns: columns.to_vec(), rate, options: walk_options(), pool: pool(threads)? })
    }

    pub(super) fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Rows that are best handed over together.
    pub(super) fn at_a_time(&self) -> usize {
        AT_A_TIME * self.threads()
    }

    /// What becomes of these rows, in their order.
    pub(super) fn walk(&self, rows: &[Row]) -> Vec<Done> {
        let one = |row: &Row| self.one(row).map_or_else(Done::Refused, Done::Walked);
        self.pool.install(|| rows.par_iter().with_max_len(1).map(one).collect())
    }

    fn one(&self, row: &Row) -> Result<Vec<Option<f64>>, String> {
        let (found, expected) = (row.fields.len(), self.columns.len());
        if found != expected {
            return Err(format!("it has {found} fields, the header has {expected}"));
        }
        let given = self.columns.iter().zip(&row.fields).filter(|(_, field)| !field.is_empty());
        let words = given.map(|(column, field)| format!("--{column}={field}"));
        let args: WalkArgs = match parse(&self.options, words) {
            Ok(args) => args,
            Err(error) => {
                return Err(
                    CliError::of_clap(error).map_or_else(|clap| first_line(&clap), |own| own.to_string())
                );
            }
        };
        let walked = || -> Result<_, CliError> {
            let (asked, figure) = (asked(&args)?, figure(&args.who)?);
            let asked = asked.of(&figure, &args);
            let metrics = match metrics_of(&figure, &asked.request, self.rate) {
                Err(error) if error.turns_too_far() && args.who.figure.is_none() => {
                    metrics_of(&heading_first(&args.who.person)?, &asked.request, self.rate)
                }
                metrics => metrics,
            };
            metrics.map_err(|error| asked.refuse(error, &args))
        };
        walked().map_err(|error| error.to_string().split_whitespace().collect::<Vec<_>>().join(" "))
    }
}

/// What is wrong with a field, without the usage of a command that nobody typed.
fn first_line(error: &clap::Error) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    line.strip_prefix("error: ").unwrap_or(line).to_owned()
}
