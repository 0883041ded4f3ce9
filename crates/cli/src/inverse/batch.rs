//! Many motions of one figure, on all cores.

use super::plan::Many;
use super::report::Report;
use super::rows;
use crate::args::InverseArgs;
use crate::error::CliError;
use crate::pool::pool;
use crate::print::{print, write_json};
use crate::progress::{Progress, Rows as Bar};
use crate::subject;
use rayon::prelude::*;
use serde::Serialize;

/// What became of a motion.
#[derive(Serialize)]
pub(super) struct Done {
    /// Its file.
    pub(super) motion: String,
    #[serde(flatten)]
    pub(super) report: Option<Report>,
    /// Why there is no report.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) refusal: Option<String>,
}

pub(super) fn run(args: &InverseArgs, many: &Many) -> Result<(), CliError> {
    let body = subject::body(&args.figure, &args.subject, &args.record.markers, &args.frame, &args.trials())?;
    let bar = Bar::shown(many.trials.len());
    let all: Vec<Done> = pool(0)?.install(|| {
        let one = many.trials.par_iter().with_max_len(1).map(|trial| {
            let found = trial.analyse(args, body.clone(), &Progress::hidden());
            bar.add(1);
            let motion = trial.motion.display().to_string();
            match found {
                Ok(report) => Done { motion, report: Some(report), refusal: None },
                Err(error) => Done { motion, report: None, refusal: Some(reason(&error)) },
            }
        });
        one.collect()
    });
    drop(bar);
    many.tables.write(|format, writer| rows::write_table(&all, format, writer).map_err(CliError::other))?;
    print(|out| {
        if args.json {
            return write_json(out, &all);
        }
        rows::write(&all, out)?;
        let of_each = all.iter().zip(&many.trials).filter(|(done, _)| done.report.is_some());
        let files: usize = of_each.map(|(_, trial)| trial.outputs.paths().count()).sum();
        if files > 0 {
            writeln!(out, "\nwrote {files} files, of {} motions", rows::done(&all))?;
        }
        many.tables.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })?;
    match all.len() - rows::done(&all) {
        0 => Ok(()),
        failed => Err(CliError::Motions { failed, of: all.len() }),
    }
}

/// Why there is nothing of a motion, in one line.
fn reason(error: &CliError) -> String {
    let text = match error {
        CliError::Text { path, faults, .. } => format!("{}: {faults}", path.display()),
        other => other.to_string(),
    };
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
