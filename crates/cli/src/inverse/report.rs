//! The report of inverse dynamics, as text and as JSON.

use crate::given::{Given, GivenReport, slides};
use crate::ground::GroundReport;
use crate::plausible::Plausibility;
use crate::print::write_json;
use serde::Serialize;
use solaris::analysis::{DofLoad, InverseReport};
use std::io::{Result, Write};

/// What the command line said of the forces.
pub(super) struct Asked {
    pub(super) passive: bool,
    /// The forces from outside.
    pub(super) external: String,
    /// Prefixes of columns of forces that push nothing.
    pub(super) unused: Vec<String>,
    /// What is odd about the table of forces.
    pub(super) notes: Vec<String>,
    /// The ground, where its forces were found from the motion.
    pub(super) ground: Option<GroundReport>,
    /// Whether measured forces fit.
    pub(super) plausible: Option<Plausibility>,
}

/// The summary.
#[derive(Serialize)]
pub(super) struct Report {
    #[serde(flatten)]
    pub(super) given: GivenReport,
    pub(super) external_forces: String,
    pub(super) unused_forces: Vec<String>,
    /// What is odd about the table of forces, and how it was read all the same.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) force_notes: Vec<String>,
    /// Absent where the ground's forces were not asked for.
    pub(super) ground: Option<GroundReport>,
    /// Absent where no forces were measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) plausibility: Option<Plausibility>,
    pub(super) passive: bool,
    pub(super) joints: Vec<Load>,
    /// Absent where the figure stands fixed in the world, which then bears what is left over.
    pub(super) residual: Option<Residual>,
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
    pub(super) fn new(given: &Given, asked: Asked, forces: &InverseReport) -> Self {
        let figure = &given.body.figure;
        let (names, slides) = (figure.layout().v_names(), slides(figure));
        let root = figure.layout().joints()[0];
        let given = GivenReport::new(given);
        let root_is_free = given.root_is_free;
        let load = |(dof, load): (usize, &DofLoad)| Load {
            dof: names[dof].clone(),
            unit: if slides[dof] { "N" } else { "N m" },
            rms: load.rms,
            greatest: load.greatest,
            at_s: load.time,
            root: root_is_free && dof < root.nv,
        };
        let free = forces.dofs.iter().enumerate().filter(|(dof, _)| !figure.follows(*dof));
        let r = &forces.residual;
        Self {
            given,
            external_forces: asked.external,
            unused_forces: asked.unused,
            force_notes: asked.notes,
            ground: asked.ground,
            plausibility: asked.plausible,
            passive: asked.passive,
            joints: free.map(load).collect(),
            residual: root_is_free.then_some(Residual {
                force_rms_n: r.force_rms,
                force_greatest_n: r.force,
                force_at_s: r.force_time,
                moment_rms_nm: r.moment_rms,
                moment_greatest_nm: r.moment,
                moment_at_s: r.moment_time,
            }),
        }
    }

    pub(super) fn write_json(&self, out: &mut dyn Write) -> Result<()> {
        write_json(out, self)
    }
}
