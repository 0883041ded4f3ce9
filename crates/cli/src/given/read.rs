//! A figure and its motion from the files and options of the command line.

use crate::args::{BASES, Gravity};
use crate::error::CliError;
use crate::input::{self, Body};
use crate::progress::Progress;
use clap::ArgMatches;
use solaris::analysis::{Differentiated, Filter, PreparedMotion, differentiate};
use solaris::io::Table;
use solaris::io::record::{self, ReadMotion};
use solaris::model::{Base, Motion};
use std::path::{Path, PathBuf};

/// Order of the filter when none is asked for.
const FILTER_ORDER: u8 = 2;

/// A figure in a motion, of which everything is known.
pub(crate) struct Given {
    /// The figure's file.
    pub(crate) of: PathBuf,
    /// The motion's file.
    pub(crate) from: PathBuf,
    pub(crate) body: Body,
    /// Whether gravity was asked for.
    pub(crate) gravity_is_asked: bool,
    pub(crate) table: Table,
    pub(crate) recorded: ReadMotion,
    pub(crate) filter: Option<Filter>,
    pub(crate) found: Differentiated,
}

impl Given {
    /// Reads the figure `of` and the motion `from`, as the options say.
    pub(crate) fn read(
        matches: &ArgMatches,
        of: &Path,
        from: &Path,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        Self::of(matches, input::body(of)?, of, from, progress)
    }

    /// The motion, of which everything is known.
    pub(crate) fn motion(&self) -> &Motion {
        &self.found.motion
    }

    /// The motion, ready for questions.
    pub(crate) fn prepared(&self) -> Result<PreparedMotion<'_>, CliError> {
        PreparedMotion::new(&self.body.figure, self.motion())
            .map_err(|error| CliError::input(&self.of, &error))
    }

    /// A figure that is at hand and is called `of`, in the motion `from`.
    pub(crate) fn of(
        matches: &ArgMatches,
        mut body: Body,
        of: &Path,
        from: &Path,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        if let Some(base) = base(matches) {
            if base == Base::Fixed && body.figure.links()[0].joint().kind().nv() > 0 {
                let why =
                    "its root joint moves, and --base fixed is for figures that stand fixed; leave it out"
                        .to_owned();
                return Err(CliError::Option { option: "base".to_owned(), value: "fixed".to_owned(), why });
            }
            body.figure = body.figure.on_base(base).map_err(|error| CliError::input(of, &error))?;
        }
        if let Some(Gravity(gravity)) = matches.get_one("gravity") {
            body.gravity = *gravity;
        }
        let table = input::table(from)?;
        let recorded = record::read(&body.figure, body.gravity, &table)
            .map_err(|error| CliError::input(from, &error))?;
        progress.stage("finding velocities and accelerations");
        let filter = filter(matches);
        let found = differentiate(&body.figure, &recorded.motion, filter)
            .map_err(|error| CliError::input(from, &error))?;
        let gravity_is_asked = matches.contains_id("gravity");
        let (of, from) = (of.to_owned(), from.to_owned());
        Ok(Self { of, from, body, gravity_is_asked, table, recorded, filter, found })
    }
}

fn base(matches: &ArgMatches) -> Option<Base> {
    let asked = matches.get_one::<String>("base")?;
    BASES.iter().find(|(name, _)| name == asked).map(|(_, base)| *base)
}

fn filter(matches: &ArgMatches) -> Option<Filter> {
    let cutoff = *matches.get_one::<f64>("filter")?;
    let order = *matches.get_one::<u8>("filter-order").unwrap_or(&FILTER_ORDER);
    Some(Filter { cutoff, order: order.into() })
}
