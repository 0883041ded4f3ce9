//! `solaris inverse`: joint torques of a given motion, or of many.

mod bands;
mod batch;
mod plan;
mod report;
mod rows;
mod summary;
mod tables;
mod trial;

use crate::args::InverseArgs;
use crate::error::CliError;
use crate::print::print;
use crate::progress::Progress;
use crate::subject;
use plan::Plan;

pub(crate) fn run(args: &InverseArgs) -> Result<(), CliError> {
    let trial = match Plan::of(args)? {
        Plan::One(trial) => trial,
        Plan::Many(many) => return batch::run(args, &many),
    };
    let progress = Progress::new(if trial.wants_bands(args)? { 6 } else { 5 });
    progress.stage("reading");
    let report = trial.analyse(
        args,
        subject::body(&args.figure, &args.subject, &args.record.markers, &args.frame, &args.trials())?,
        &progress,
    )?;
    drop(progress);
    print(|out| {
        if args.json {
            return report.write_json(out);
        }
        report.write(out)?;
        trial.outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}
