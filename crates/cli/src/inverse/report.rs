//! The report of inverse dynamics, as text and as JSON.

use super::bands::BandsReport;
use crate::cycles::Cycles;
use crate::given::{Given, GivenReport};
use crate::ground::GroundReport;
use crate::plausible::Plausibility;
use crate::print::write_json;
use serde::Serialize;
use solaris::analysis::{DofLoad, InverseReport, Residual};
use std::io::{Result, Write};

/// What the command line said of the forces.
pub(super) struct Asked {
    pub(super) passive: bool,
    /// What the figure moves in.
    pub(super) medium: Option<String>,
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
    /// The strides, where means over them were asked for.
    pub(super) cycles: Option<Cycles>,
    /// How far angles and moments may be off, where that is known.
    pub(super) bands: Option<BandsReport>,
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
    /// What the figure moves in; absent where there is nothing.
    pub(super) medium: Option<String>,
    /// Without those that follow others.
    pub(super) joints: Vec<DofLoad>,
    /// Absent where the figure stands fixed in the world, which then bears what is left over.
    pub(super) residual: Option<Residual>,
    /// Absent where means over strides were not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) cycles: Option<Cycles>,
    /// Absent where nobody asked how far angles and moments may be off.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) bands: Option<BandsReport>,
}

impl Report {
    pub(super) fn new(given: &Given, asked: Asked, forces: &InverseReport) -> Self {
        let (figure, root_is_free) = (&given.body.figure, given.body.figure.root_is_free());
        let free = forces.dofs.iter().enumerate().filter(|(dof, _)| !figure.follows(*dof));
        Self {
            given: GivenReport::new(given),
            external_forces: asked.external,
            unused_forces: asked.unused,
            force_notes: asked.notes,
            ground: asked.ground,
            plausibility: asked.plausible,
            passive: asked.passive,
            medium: asked.medium,
            joints: free.map(|(_, load)| load.clone()).collect(),
            residual: root_is_free.then_some(forces.residual),
            cycles: asked.cycles,
            bands: asked.bands,
        }
    }

    /// What a person should look at, a sentence each.
    pub(super) fn findings(&self) -> Vec<String> {
        let given = self.given.doubts().into_iter().map(|(what, value)| format!("{what}: {value}"));
        let turned = self.given.turned().map(str::to_owned);
        let ground = self.ground.iter().flat_map(|ground| ground.warnings.iter().cloned());
        let plates = self.plausibility.iter().flat_map(|plausible| plausible.messages().map(str::to_owned));
        let strides = self.cycles.iter().filter_map(Cycles::doubt);
        given.chain(turned).chain(self.unused_words()).chain(ground).chain(plates).chain(strides).collect()
    }

    /// Measured forces that nothing makes use of.
    pub(super) fn unused_words(&self) -> Option<String> {
        let names: Vec<String> = self.unused_forces.iter().map(|prefix| format!("'{prefix}'")).collect();
        let names = names.join(", ");
        (!self.unused_forces.is_empty())
            .then(|| format!("not used: the forces of {names}; --external and --plate apply them"))
    }

    pub(super) fn write_json(&self, out: &mut dyn Write) -> Result<()> {
        write_json(out, self)
    }
}
