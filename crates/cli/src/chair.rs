//! `solaris chair`: a person stands up from a seat, or sits down.

mod report;
mod summary;

use crate::args::{ChairArgs, Number, RATE};
use crate::error::{CliError, Typed};
use crate::planned_files::{PlannedFiles, Shown};
use crate::print::print;
use crate::progress::Progress;
use crate::{limbs, walk};
use report::Report;
use solaris::gait::{ChairMotion, ChairRequest, chair, measure_chair};
use std::time::Instant;

/// Plans the motion, finds its forces, writes it, and says what it came to.
pub(crate) fn run(args: &ChairArgs) -> Result<(), CliError> {
    let files = PlannedFiles::new(&args.files, args.who.figure.as_deref())?;
    let figure = walk::figure(&args.who)?;
    let request = asked(args);

    let progress = Progress::new(4);
    let start = Instant::now();
    progress.stage("planning");
    let plan = chair(&figure, &request).map_err(|error| CliError::of_gait(error, args))?;
    let planning = start.elapsed();
    progress.stage("finding the forces");
    let rate = args.seat.rate.unwrap_or(RATE.0);
    let (motion, forces) = plan.loaded(&figure, rate).map_err(CliError::other)?;
    let solving = start.elapsed();
    progress.stage("measuring");
    let measures = measure_chair(&figure, &motion).map_err(CliError::other)?;
    let limbs = limbs::nearest(&figure, &motion, &[])?;
    let carried = args.who.person.loads.iter().map(|(_, load)| load).sum();
    let mass = (figure.mass(), carried);
    let report = Report::new(mass, &request, &plan, &motion, measures, &forces, limbs, [planning, solving]);
    progress.stage("writing");
    let shown = Shown {
        name: "chair",
        title: summary::title(&report),
        rows: summary::page_rows(&report),
        // Somebody who has sat down again may stand up as before.
        repeats: matches!(request.motion, ChairMotion::RiseAndSit(_)),
        report: &|writer| report.write(writer),
    };
    files.write(&figure, &motion, &shown)?;
    drop(progress);

    if args.files.json {
        print(|out| report.write(out))
    } else {
        print(|out| out.write_all(summary::table(&report, files.written()).as_bytes()))
    }
}

fn asked(args: &ChairArgs) -> ChairRequest {
    let seat = &args.seat;
    let value = |number: &Option<Number>| number.as_ref().map(|number| number.value);
    let usual = ChairRequest::default();
    ChairRequest {
        motion: match seat.times {
            Some(times) => ChairMotion::RiseAndSit(times),
            None if seat.sit => ChairMotion::Sit,
            None => ChairMotion::Rise,
        },
        seat: value(&seat.seat_height),
        duration: value(&seat.duration),
        shank: value(&seat.shank).map_or(usual.shank, f64::to_radians),
    }
}

impl Typed for ChairArgs {
    fn typed(&self, name: &str) -> Option<&str> {
        let number = match name {
            "seat height" => &self.seat.seat_height,
            "duration" => &self.seat.duration,
            "shank" => &self.seat.shank,
            other => return self.who.person.typed(other),
        };
        number.as_ref().map(|number| number.typed.as_str())
    }

    fn pace(&self) -> Vec<(&'static str, &Number)> {
        Vec::new()
    }
}
