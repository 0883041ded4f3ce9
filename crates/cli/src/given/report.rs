//! The report on a given figure and motion, and how they were taken.

use super::read::Given;
use crate::input::extension;
use serde::Serialize;
use solaris::model::{AxisKind, FindingKind};

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
    pub(super) many_turns: Vec<String>,
    pub(super) outside_limits: Vec<Excess>,
    pub(super) ignored_columns: Vec<String>,
    /// Elements of the figure's file that were not read.
    pub(super) not_read: usize,
    /// Whether nothing holds the root in the world, so that the forces of its joint are errors.
    pub(crate) root_is_free: bool,
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
                _ if extension(&given.from) == "bvh" => "angles in degrees, as BVH has them",
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
            many_turns: figure
                .many_turns(motion.columns()[0])
                .into_iter()
                .map(|dof| names[dof].clone())
                .collect(),
            outside_limits: excess.collect(),
            ignored_columns: recorded.ignored.clone(),
            not_read: body.findings.iter().filter(|f| f.kind == FindingKind::Unsupported).count(),
            root_is_free: figure.root_is_free(),
        }
    }
}
