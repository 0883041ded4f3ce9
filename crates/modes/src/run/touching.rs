//! Drives and parts that wait for a link to touch the ground, or to leave it.

use super::driven::Meaning;
use super::guard;
use super::pass::Pass;
use crate::EndCondition;
use crate::failure::{RunError, SetupError};
use crate::phase::Watched;
use crate::simulation::Simulation;

/// How far above the ground (m) a link is taken to touch it: farther than it sinks by impulses, or leaves by rounding while it stands.
const OFF: f64 = 1e-6;

/// The link that is waited for, and whether it is to come down.
fn awaited(until: &EndCondition) -> Option<(&str, bool)> {
    match until {
        EndCondition::TouchDown { link } => Some((link, true)),
        EndCondition::LiftOff { link } => Some((link, false)),
        _ => None,
    }
}

/// Refuses to wait for what never touches.
pub(super) fn check(simulation: &Simulation) -> Result<(), SetupError> {
    let drives = simulation.drives.iter().flatten().map(|step| &step.until);
    let all = drives.chain(simulation.stages.iter().map(|stage| &stage.until));
    for (name, _) in all.filter_map(awaited) {
        let link = simulation.figure.link_index(name);
        let points = simulation.surface.iter().flat_map(|surface| &surface.contact_points);
        if !points.map(|point| Some(point.link)).any(|of| of == link) {
            return Err(SetupError::NothingTouches { link: name.to_owned() });
        }
    }
    Ok(())
}

impl Pass {
    /// What is to be watched for the sake of a link that is waited for; nothing while dynamics do not move it.
    pub(super) fn watched_contact(&self, until: &EndCondition) -> Option<Watched> {
        let link = self.simulation.figure.link_index(awaited(until)?.0)?;
        self.parts()[link].map(|_| Watched::Near { link, off: OFF })
    }

    /// Forgets events of links that come down where they are to leave, or leave where they are to come down.
    pub(super) fn drop_wrong_ways(&mut self, events: &mut Vec<Meaning>) -> Result<(), RunError> {
        let mut wrong = Vec::new();
        for event in &*events {
            let until = match event {
                Meaning::DriveEnds(dof) => {
                    self.simulation.drives[*dof].get(self.driven[*dof].step).map(|step| &step.until)
                }
                Meaning::StageEnds => {
                    self.simulation.stages.get(self.stages_over()).map(|stage| &stage.until)
                }
                _ => None,
            };
            let Some((link, comes_down)) = until.and_then(awaited) else { continue };
            let Some(surface) = &self.simulation.surface else { continue };
            let link = self.simulation.figure.link_index(link);
            let points =
                self.body.touching(&self.q, &self.v).map_err(|error| guard::of_dynamics(self.t, error))?;
            let of_link = points.zip(&surface.contact_points).filter(|(_, point)| Some(point.link) == link);
            let lowest = of_link.map(|(pressed, _)| pressed).max_by(|a, b| a.depth.total_cmp(&b.depth));
            if lowest.is_some_and(|lowest| (lowest.rate > 0.0) != comes_down) {
                wrong.push(*event);
            }
        }
        events.retain(|event| !wrong.contains(event));
        Ok(())
    }
}
