//! A figure and its motion from the files and options of the command line.

use crate::args::{FrameArgs, RecordArgs, Span};
use crate::error::{CliError, UsageError};
use crate::input::{self, Body};
use crate::markers::{self, Fitted, MarkersReport};
use crate::progress::Progress;
use crate::recording;
use crate::subject::SubjectReport;
use crate::words::short;
use solaris::analysis::{Differentiated, Filter, PreparedMotion, differentiate};
use solaris::io::Table;
use solaris::io::record::headed_positions;
use solaris::io::record::{self, ReadMotion};
use solaris::model::{Base, Finding, FindingKind, Motion};
use std::path::{Path, PathBuf};

/// A figure in a motion, of which everything is known.
pub(crate) struct Given {
    /// The figure's file.
    pub(crate) of: PathBuf,
    /// The motion's file.
    pub(crate) from: PathBuf,
    pub(crate) body: Body,
    /// How the figure was brought to a person's size, if it was.
    pub(crate) subject: Option<SubjectReport>,
    /// Whether gravity was asked for.
    pub(crate) gravity_is_asked: bool,
    pub(crate) table: Table,
    /// What looks wrong with what a file of bones says, or leaves to guess.
    pub(crate) doubtful: Vec<Finding>,
    /// How well the markers fit, where the motion is markers.
    pub(crate) markers: Option<MarkersReport>,
    /// The markers, with force plates that stand in the same file.
    pub(crate) fitted: Option<Fitted>,
    pub(crate) recorded: ReadMotion,
    pub(crate) filter: Option<Filter>,
    pub(crate) found: Differentiated,
}

impl Given {
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
        (mut body, subject): (Body, Option<SubjectReport>),
        [of, from]: [&Path; 2],
        record: &RecordArgs,
        frame: &FrameArgs,
        progress: &Progress,
    ) -> Result<Self, CliError> {
        if let Some(base) = frame.base.map(Base::from) {
            if base == Base::Fixed && body.figure.links()[0].joint().kind().nv() > 0 {
                let why =
                    "its root joint moves, and --base fixed is for figures that stand fixed; leave it out";
                return Err(CliError::option("base", "fixed", why));
            }
            body.figure = body.figure.on_base(base).map_err(|error| CliError::input(of, &error))?;
        }
        if let Some(gravity) = &frame.gravity {
            body.gravity = gravity.vector;
        }
        let (table, recorded, mut doubtful, fitted) = motion(&body, from, record)?;
        if body.language.is_of_bones() {
            doubtful
                .extend(body.findings.iter().filter(|finding| finding.kind == FindingKind::Suspect).cloned());
        }
        let markers = fitted.as_ref().map(|fitted| MarkersReport::of(fitted, &body.figure));
        progress.stage("finding velocities and accelerations");
        let filter = record.filter.map(|cutoff| Filter { cutoff, order: record.filter_order.into() });
        let found = differentiate(&body.figure, &recorded.motion, filter)
            .map_err(|error| CliError::input(from, &error))?;
        let gravity_is_asked = frame.gravity.is_some();
        let (of, from) = (of.to_owned(), from.to_owned());
        Ok(Self {
            of,
            from,
            body,
            subject,
            gravity_is_asked,
            table,
            doubtful,
            markers,
            fitted,
            recorded,
            filter,
            found,
        })
    }
}

/// The motion in a file: its table, what is known of it, what looks wrong with it, and the markers if it is markers.
fn motion(
    body: &Body,
    from: &Path,
    record: &RecordArgs,
) -> Result<(Table, ReadMotion, Vec<Finding>, Option<Fitted>), CliError> {
    if recording::is_one(from) {
        let fitted = markers::fit(body, from, &record.markers, record.time.as_ref())?;
        let table = headed_positions(&body.figure, &fitted.motion);
        let recorded = ReadMotion { motion: fitted.motion.clone(), ignored: Vec::new(), notes: Vec::new() };
        return Ok((table, recorded, Vec::new(), Some(fitted)));
    }
    let (mut table, doubtful) = input::motion(from, &body.figure)?;
    if let Some(span) = &record.time {
        let time: Vec<f64> =
            table.column("time").into_iter().flat_map(|column| table.values_of(column)).collect();
        span.check(&time)?;
        table = table.within(span.from, span.to);
    }
    let recorded = record::read_with_defaults(&body.figure, body.gravity, &table, &body.defaults)
        .map_err(|error| CliError::input(from, &error))?;
    Ok((table, recorded, doubtful, None))
}

impl Span {
    /// Refuses a part in which a motion of these times (s) has less than two samples.
    pub(crate) fn check(&self, time: &[f64]) -> Result<(), CliError> {
        let within = time.iter().filter(|time| (self.from..=self.to).contains(*time)).count();
        let why = match time {
            [] => "the motion has no times".to_owned(),
            [first, .., last] if within < 2 => {
                format!("the motion lasts from {} to {} s", short(*first), short(*last))
            }
            _ => return Ok(()),
        };
        Err(CliError::option("time", &self.typed, why))
    }
}

/// Refuses a motion where the figure goes, and the figure where the motion goes.
pub(crate) fn in_order(command: &'static str, figure: &Path, motion: &Path) -> Result<(), UsageError> {
    if input::is_motion(figure) && !input::is_motion(motion) {
        let (figure, motion) = (motion.to_owned(), figure.to_owned());
        return Err(UsageError::Swapped { command, figure, motion });
    }
    Ok(())
}
