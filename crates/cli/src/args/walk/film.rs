//! Options of film strips.

use crate::args::value::number;
use crate::args::wrap;
use clap::{Args, ValueEnum};
use solaris::view::Seen;

/// What a film strip shows.
#[derive(Debug, Args)]
pub(crate) struct FilmArgs {
    #[arg(long, value_name = "FROM:TO", value_parser = span, help = wrap(
        "What a film strip (.svg) shows: from when to when, in s [default: all of it]"
    ))]
    pub(crate) between: Option<(f64, f64)>,
    #[arg(long, value_name = "WHENCE", value_enum, hide_possible_values = true, help = wrap(
        "From where a film strip shows it: side, corner (from the right, in front and above) or above [default: side]"
    ))]
    pub(crate) seen: Option<Whence>,
}

impl FilmArgs {
    /// The first of these options that was given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let between = self.between.map(|_| "between");
        between.or(self.seen.map(|_| "seen"))
    }
}

/// From where it is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Whence {
    Side,
    Corner,
    Above,
}

impl From<Whence> for Seen {
    fn from(whence: Whence) -> Self {
        match whence {
            Whence::Side => Self::Side,
            Whence::Corner => Self::Corner,
            Whence::Above => Self::Above,
        }
    }
}

/// Two times, as `1.5:2.5`.
fn span(text: &str) -> Result<(f64, f64), String> {
    let span = text.split_once(':').and_then(|(from, to)| Some((number(from).ok()?, number(to).ok()?)));
    span.filter(|(from, to)| from <= to)
        .ok_or_else(|| "it must be two times in s, the earlier one first, such as 1.5:2.5".to_owned())
}
