//! The report on a given figure and motion, and how they were taken.

use super::read::Given;
use crate::input::extension;
use crate::markers::MarkersReport;
use crate::plausible::Finding;
use crate::subject::SubjectReport;
use serde::Serialize;
use solaris::analysis::plausibility::check_angles;
use solaris::io::TableNote;
use solaris::model::{AxisKind, FindingKind, MassDoubt};

/// What went in.
#[derive(Serialize)]
pub(crate) struct GivenReport {
    pub(super) figure: String,
    pub(super) format: &'static str,
    pub(super) dofs: usize,
    pub(super) mass_kg: f64,
    pub(crate) rows: usize,
    pub(crate) from_s: f64,
    pub(crate) to_s: f64,
    /// What the motion's angles are in, and who says so.
    pub(super) units: &'static str,
    pub(super) has_times: bool,
    pub(super) gravity_m_s2: [f64; 3],
    pub(super) gravity_from: &'static str,
    /// Degrees of freedom whose velocities and accelerations were found from the positions.
    pub(super) from_positions: usize,
    /// Degrees of freedom whose accelerations were found from the recorded velocities.
    pub(super) from_velocities: usize,
    pub(super) filter: Option<FilterReport>,
    /// What acts in the model and is not in the figure.
    pub(super) missing: Vec<String>,
    /// What looks wrong with what a file of bones says, or leaves to guess.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) guessed: Vec<String>,
    /// How the figure was brought to a person's size, if it was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) subject: Option<SubjectReport>,
    /// How well the markers fit, where the motion is markers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) markers: Option<MarkersReport>,
    pub(super) many_turns: Vec<String>,
    /// What of the figure's masses no matter can have; it was taken as it is.
    pub(super) mass_doubts: Vec<Doubt>,
    /// Angles whose ranges make no sense in the unit that they were read in; absent where they do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) suspect_angles: Option<Finding>,
    /// What is odd about the motion's table, and how it was read all the same.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) notes: Vec<String>,
    pub(super) outside_limits: Vec<Excess>,
    pub(super) ignored_columns: Vec<String>,
    /// Elements of the figure's file that were not read.
    pub(super) not_read: usize,
    /// Whether nothing holds the root in the world, so that the forces of its joint are errors.
    pub(crate) root_is_free: bool,
}

/// A finding of [`Figure::mass_doubts`](solaris::model::Figure::mass_doubts).
#[derive(Serialize)]
pub(super) struct Doubt {
    pub(super) subject: String,
    pub(super) message: String,
}

#[derive(Serialize)]
pub(super) struct FilterReport {
    pub(super) cutoff_hz: f64,
    pub(super) order: usize,
    pub(super) spoiled_s: f64,
}

#[derive(Serialize)]
pub(super) struct Excess {
    pub(super) dof: String,
    pub(super) by: f64,
    pub(super) at_s: f64,
    #[serde(skip)]
    pub(super) turns: bool,
}

impl GivenReport {
    pub(crate) fn new(given: &Given) -> Self {
        let Given { body, table, recorded, found, .. } = given;
        let (motion, time) = (&found.motion, found.motion.time());
        let figure = &body.figure;
        let (layout, names) = (figure.layout(), figure.layout().v_names());
        let excess = figure.limit_excess(motion.columns()[0]).into_iter().map(|found| Excess {
            dof: names[found.dof].clone(),
            by: found.by,
            at_s: time[found.row],
            turns: layout.axis_kind(found.dof) == AxisKind::Rotation,
        });
        let derived = |from_velocity: bool| {
            let dofs = found.found.iter().enumerate();
            dofs.filter(|(dof, here)| **here && recorded.motion.known().v[*dof] == from_velocity).count()
        };
        Self {
            figure: figure.name().to_owned(),
            format: body.language.name(),
            dofs: figure.layout().nv(),
            mass_kg: figure.mass(),
            rows: time.len(),
            from_s: time.first().copied().unwrap_or_default(),
            to_s: time.last().copied().unwrap_or_default(),
            units: match table.in_degrees {
                _ if given.markers.is_some() => "angles in rad, found from markers",
                _ if extension(&given.from) == "bvh" => "angles in degrees, as BVH has them",
                _ if table.notes.contains(&TableNote::OldDegrees) => "angles in degrees, as in SIMM",
                Some(true) => "angles in degrees, as its header says",
                Some(false) => "angles in rad, as its header says",
                None if table.header_line > 1 => "angles in rad, though its header does not say",
                None => "angles in rad",
            },
            has_times: table.column("time").is_some(),
            gravity_m_s2: body.gravity.into(),
            gravity_from: match (given.gravity_is_asked, body.gravity_is_given) {
                (true, _) => "as asked",
                (false, true) => "the file's",
                (false, false) => "standard, down in this format",
            },
            from_positions: derived(false),
            from_velocities: derived(true),
            filter: given.filter.map(|filter| FilterReport {
                cutoff_hz: filter.cutoff,
                order: filter.order,
                spoiled_s: found.unsettled,
            }),
            missing: said(&mut body.findings.iter().filter(|finding| finding.kind == FindingKind::Missing)),
            guessed: said(&mut given.doubtful.iter()),
            subject: given.subject.clone(),
            markers: given.markers.clone(),
            many_turns: figure
                .many_turns(motion.columns()[0])
                .into_iter()
                .map(|dof| names[dof].clone())
                .collect(),
            mass_doubts: figure.mass_doubts().iter().map(Doubt::of).collect(),
            suspect_angles: check_angles(figure, motion, table.in_degrees).as_ref().map(Finding::from),
            notes: recorded.notes.iter().map(ToString::to_string).collect(),
            outside_limits: excess.collect(),
            ignored_columns: recorded.ignored.clone(),
            not_read: body.findings.iter().filter(|f| f.kind == FindingKind::Unsupported).count(),
            root_is_free: figure.root_is_free(),
        }
    }
}

/// Findings in words, each once.
fn said(findings: &mut dyn Iterator<Item = &solaris::model::Finding>) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for finding in findings {
        let word = format!("{}: {}", finding.subject, finding.message);
        if !words.contains(&word) {
            words.push(word);
        }
    }
    words
}

impl Doubt {
    fn of(doubt: &MassDoubt) -> Self {
        let solaris::model::Finding { subject, message, .. } = doubt.finding();
        Self { subject, message }
    }
}
