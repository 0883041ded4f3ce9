//! `solaris scale`: a generic figure to a person's size.

use crate::args::ScaleArgs;
use crate::error::{CliError, UsageError};
use crate::figure::TEXT;
use crate::output::Outputs;
use crate::print::{print, write_json};
use crate::subject;
use solaris::model::text;
use std::path::{Path, PathBuf};

pub(crate) fn run(args: &ScaleArgs) -> Result<(), CliError> {
    if !args.subject.is_asked() {
        return Err(UsageError::NothingToScale.into());
    }
    let outputs = Outputs::new(args.outputs.iter().map(|path| ("-o", path, TEXT)))?;
    outputs.keep_off([args.figure.as_path()])?;
    let trials: Vec<&Path> = args.trials.iter().map(PathBuf::as_path).collect();
    let body = subject::body(&args.figure, &args.subject, &args.markers, &args.frame, &trials)?;
    let text = text::write(&body.marked());
    outputs.write(|(), writer| writer.write_all(text.as_bytes()).map_err(CliError::other))?;
    print(|out| {
        if args.json {
            return write_json(out, &body.subject);
        }
        writeln!(out, "{} '{}'\n", body.language.name(), body.figure.name())?;
        body.subject.iter().try_for_each(|report| report.write(out))?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}
