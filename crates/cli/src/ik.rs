//! `solaris ik`: joint angles from markers.

use crate::animation::{self, BodyFormat, Bones};
use crate::args::IkArgs;
use crate::error::CliError;
use crate::markers::{self, Fitted, MarkersReport};
use crate::output::{Formats, Outputs};
use crate::print::{print, write_json};
use crate::progress::Progress;
use crate::subject;
use solaris::io::record::{headed_positions, positions_in_degrees};
use solaris::io::{IoError, bvh, csv, sto};
use solaris::model::Vector3;
use std::io::Write;

/// What is written.
#[derive(Clone, Copy, Debug)]
enum Content {
    /// In degrees.
    Sto,
    Csv,
    Bvh,
    Body(BodyFormat),
    Errors,
}

const MOTION: Formats<Content> = &[
    ("mot", Content::Sto),
    ("sto", Content::Sto),
    ("csv", Content::Csv),
    ("bvh", Content::Bvh),
    ("glb", Content::Body(BodyFormat::Glb)),
    ("usda", Content::Body(BodyFormat::Usda)),
];
const ERRORS: Formats<Content> = &[("csv", Content::Errors)];

pub(crate) fn run(args: &IkArgs) -> Result<(), CliError> {
    let motions = args.outputs.iter().map(|path| ("-o", path, MOTION));
    let errors = args.errors_out.iter().map(|path| ("--errors-out", path, ERRORS));
    let outputs = Outputs::new(motions.chain(errors))?;
    outputs.keep_off([args.figure.as_path(), args.trial.as_path()])?;
    let progress = Progress::new(3);
    progress.stage("reading");
    let (mut body, subject) =
        subject::body(&args.figure, &args.subject, &args.markers, &args.frame, &[&args.trial])?;
    if let Some(gravity) = &args.frame.gravity {
        body.gravity = gravity.vector;
    }
    progress.stage("finding the angles");
    let fitted = markers::fit(&body, &args.trial, &args.markers, None)?;
    let report = MarkersReport::of(&fitted, &body.figure);
    progress.stage("writing");
    let (figure, motion) = (&body.figure, &fitted.motion);
    outputs.write(|content, mut writer| {
        match content {
            Content::Sto => sto::write(&positions_in_degrees(figure, motion), &mut writer),
            Content::Csv => csv::write_table(&headed_positions(figure, motion), &mut writer),
            Content::Bvh => bvh::write(figure, motion, bvh::Unit::default(), &mut writer),
            Content::Body(how) => {
                return animation::body(how, figure, motion, "trial", &Bones::default(), writer);
            }
            Content::Errors => write_errors(&fitted, &mut writer),
        }
        .map_err(CliError::other)
    })?;
    drop(progress);
    print(|out| {
        if args.json {
            return write_json(out, &report);
        }
        writeln!(out, "{} '{}'\n", body.language.name(), figure.name())?;
        subject.iter().try_for_each(|subject| subject.write(out))?;
        report.write(out)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}

/// How far each marker is off in every frame (m); nothing stands where it was hidden.
fn write_errors(fitted: &Fitted, out: &mut impl Write) -> Result<(), IoError> {
    let found = &fitted.found;
    let names = found.markers.iter().map(|marker| marker.name.as_str());
    csv::write_row(["time", "rms"].into_iter().chain(names), out)?;
    let width = found.markers.len();
    for (i, frame) in found.frames.iter().enumerate() {
        let distances = found.offsets[i * width..][..width].iter().map(Vector3::norm);
        let cells = [frame.time, frame.rms].into_iter().chain(distances);
        csv::write_row(cells.map(|x| if x.is_nan() { String::new() } else { csv::number_text(x) }), out)?;
    }
    Ok(())
}
