//! What inverse dynamics came to, as text and as JSON.

use super::tables::slides;
use crate::input::Body;
use serde::Serialize;
use solaris::io::Table;
use solaris::io::record::Recorded;
use solaris::model::{AxisKind, FindingKind, JointKind};
use solaris::modes::{Completed, Filter, InverseReport};
use std::io::{Result, Write};

/// What the command line said of how to do it.
pub(super) struct Asked {
    pub(super) filter: Option<Filter>,
    pub(super) passive: bool,
    /// Whether gravity was given there.
    pub(super) gravity: bool,
    /// The forces from outside.
    pub(super) external: String,
    /// Prefixes of columns of forces that push nothing.
    pub(super) unused: Vec<String>,
}

/// The summary.
#[derive(Serialize)]
pub(super) struct Report {
    pub(super) figure: String,
    pub(super) format: &'static str,
    pub(super) dofs: usize,
    pub(super) mass_kg: f64,
    pub(super) rows: usize,
    pub(super) from_s: f64,
    pub(super) to_s: f64,
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
    pub(super) external_forces: String,
    pub(super) unused_forces: Vec<String>,
    pub(super) many_turns: Vec<String>,
    pub(super) passive: bool,
    pub(super) outside_limits: Vec<Excess>,
    pub(super) ignored_columns: Vec<String>,
    /// Elements of the figure's file that were not read.
    pub(super) not_read: usize,
    pub(super) joints: Vec<Load>,
    /// Absent where the figure stands fixed in the world, which then bears what is left over.
    pub(super) residual: Option<Residual>,
    /// Whether nothing holds the root in the world, so that the forces of its joint are errors.
    pub(super) root_is_free: bool,
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

#[derive(Serialize)]
pub(super) struct Load {
    pub(super) dof: String,
    pub(super) unit: &'static str,
    pub(super) rms: f64,
    pub(super) greatest: f64,
    pub(super) at_s: f64,
    /// Whether it belongs to the root's joint.
    pub(super) root: bool,
}

#[derive(Serialize)]
pub(super) struct Residual {
    pub(super) force_rms_n: f64,
    pub(super) force_greatest_n: f64,
    pub(super) force_at_s: f64,
    pub(super) moment_rms_nm: f64,
    pub(super) moment_greatest_nm: f64,
    pub(super) moment_at_s: f64,
}

impl Report {
    pub(super) fn new(
        body: &Body,
        asked: &Asked,
        table: &Table,
        recorded: &Recorded,
        (motion, forces): (&Completed, &InverseReport),
    ) -> Self {
        let figure = &body.figure;
        let (names, slides) = (figure.layout().v_names(), slides(figure));
        let root = figure.layout().joints()[0];
        let root_is_free = is_base(figure.links()[0].joint().kind());
        let load = |(dof, load): (usize, &solaris::modes::DofLoad)| Load {
            dof: names[dof].clone(),
            unit: if slides[dof] { "N" } else { "N m" },
            rms: load.rms,
            greatest: load.greatest,
            at_s: load.time,
            root: root_is_free && dof < root.nv,
        };
        let excess = figure.limit_excess(&motion.q).into_iter().map(|found| Excess {
            dof: names[found.dof].clone(),
            by: found.by,
            at_s: motion.time[found.row],
            turns: !slides[found.dof],
        });
        let derived = |from_velocity: bool| {
            let dofs = motion.differentiated.iter().enumerate();
            dofs.filter(|(dof, here)| **here && recorded.record.known_v[*dof] == from_velocity).count()
        };
        let free = forces.dofs.iter().enumerate().filter(|(dof, _)| !figure.follows(*dof));
        let r = &forces.residual;
        Self {
            figure: figure.name().to_owned(),
            format: body.language.name(),
            dofs: figure.layout().nv(),
            mass_kg: figure.mass(),
            rows: motion.time.len(),
            from_s: motion.time.first().copied().unwrap_or_default(),
            to_s: motion.time.last().copied().unwrap_or_default(),
            units: match table.in_degrees {
                Some(true) => "angles in degrees, as its header says",
                Some(false) => "angles in rad, as its header says",
                None if table.header_line > 1 => "angles in rad, though its header does not say",
                None => "angles in rad",
            },
            has_times: table.column("time").is_some(),
            gravity_m_s2: body.gravity.into(),
            gravity_from: match (asked.gravity, body.gravity_is_given) {
                (true, _) => "as asked",
                (false, true) => "the file's",
                (false, false) => "standard, down in this format",
            },
            from_positions: derived(false),
            from_velocities: derived(true),
            filter: asked.filter.map(|filter| FilterReport {
                cutoff_hz: filter.cutoff,
                order: filter.order,
                spoiled_s: motion.spoiled,
            }),
            external_forces: asked.external.clone(),
            unused_forces: asked.unused.clone(),
            many_turns: figure.many_turns(&motion.q).into_iter().map(|dof| names[dof].clone()).collect(),
            passive: asked.passive,
            outside_limits: excess.collect(),
            ignored_columns: recorded.ignored.clone(),
            not_read: body.findings.iter().filter(|f| f.kind == FindingKind::Unsupported).count(),
            joints: free.map(load).collect(),
            residual: root_is_free.then_some(Residual {
                force_rms_n: r.force_rms,
                force_greatest_n: r.force,
                force_at_s: r.force_time,
                moment_rms_nm: r.moment_rms,
                moment_greatest_nm: r.moment,
                moment_at_s: r.moment_time,
            }),
            root_is_free,
        }
    }

    pub(super) fn write_json(&self, out: &mut dyn Write) -> Result<()> {
        serde_json::to_writer_pretty(&mut *out, self).map_err(std::io::Error::from)?;
        writeln!(out)
    }
}

/// Whether a root's joint places the whole figure in the world, rather than hold it there as a hinge does.
fn is_base(root: &JointKind) -> bool {
    let slides = root.axes().iter().filter(|dof| dof.axis.kind == AxisKind::Translation).count();
    matches!(root, JointKind::Free { .. }) || (slides >= 2 && root.axes().len() > slides)
}
