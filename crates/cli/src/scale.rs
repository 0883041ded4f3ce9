//! `solaris scale`: a generic figure to a person's size.

use crate::args::ScaleArgs;
use crate::error::{CliError, UsageError};
use crate::input::{self, Body, Language};
use crate::output::{Formats, Outputs};
use crate::print::{print, write_json};
use crate::subject::{self, SubjectReport, bodies_in};
use solaris::io::opensim::{MarkerPlace, Rescaling, rescale};
use solaris::model::{Finding, MassShares, Vector3, text};
use std::path::{Path, PathBuf};

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Content {
    /// A figure's text.
    Ron,
    /// The model's own text, scaled.
    OpenSim,
}

const FORMATS: Formats<Content> = &[("ron", Content::Ron), ("osim", Content::OpenSim)];

pub(crate) fn run(args: &ScaleArgs) -> Result<(), CliError> {
    if !args.subject.is_asked() {
        return Err(UsageError::NothingToScale.into());
    }
    let outputs = Outputs::new(args.outputs.iter().map(|path| ("-o", path, FORMATS)))?;
    outputs.keep_off([args.figure.as_path()])?;
    let trials: Vec<&Path> = args.trials.iter().map(PathBuf::as_path).collect();
    let (body, subject) = subject::body(&args.figure, &args.subject, &args.markers, &args.frame, &trials)?;
    let wanted = args.outputs.iter().any(|path| input::extension(path) == "osim");
    let (model, findings) = match &subject {
        Some(report) if wanted => model(&args.figure, &body, report)?,
        _ => (String::new(), Vec::new()),
    };
    outputs.write(|content, writer| {
        let text = match content {
            Content::Ron => &text::write(&body.marked()),
            Content::OpenSim => &model,
        };
        writer.write_all(text.as_bytes()).map_err(CliError::other)
    })?;
    print(|out| {
        if args.json {
            return write_json(out, &subject);
        }
        writeln!(out, "{} '{}'\n", body.language.name(), body.figure.name())?;
        subject.iter().try_for_each(|report| report.write(out))?;
        crate::findings::list(out, &findings)?;
        outputs.written().try_for_each(|line| writeln!(out, "\n{line}"))
    })
}

/// The text of the model, scaled as its figure was.
fn model(path: &Path, body: &Body, report: &SubjectReport) -> Result<(String, Vec<Finding>), CliError> {
    if body.language != Language::OpenSim {
        let why = "only the text of an OpenSim model is scaled; write a figure's: -o FILE.ron";
        return Err(CliError::input(path, &why));
    }
    let text = input::decoded(path)?;
    let factors: Vec<(String, Vector3<f64>)> =
        report.factors().map(|(name, by)| (name.to_owned(), by)).collect();
    let markers = body.markers.markers.iter().map(|marker| {
        let own = body.figure.links()[marker.link].name();
        // A link between two joints of one child is no body, and wears nothing.
        let (_, placement) = body.figure.locate(own).unwrap_or_default();
        let position = placement.inverse_transform_point(&marker.position.into()).coords;
        MarkerPlace { name: marker.name.clone(), body: own.to_owned(), position, is_fixed: marker.is_fixed }
    });
    let removed = report.lost_markers().filter(|name| text.contains(&format!("<Marker name=\"{name}\"")));
    let rescaling = Rescaling {
        factors: bodies_in(&text, &factors),
        mass: Some(body.figure.mass()),
        shares: if report.grows_by_volume() { MassShares::Volumes } else { MassShares::Kept },
        markers: markers.collect(),
        removed: removed.map(str::to_owned).collect(),
    };
    rescale(&text, &rescaling).map_err(|faults| input::faulty(path, &text, faults))
}
