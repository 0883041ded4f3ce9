//! Contacts that can neither stay nor leave: named, with what keeps them.

use crate::contact::{ContactPatch, Surface};
use crate::failure::{FailureKind, Remedy, RunError, RunFailure};
use crate::phase::Role;
use crate::run::pass::Pass;

/// As much (a part of gravity and of the greatest acceleration) may contact patches be denied of what they ask for.
const DENIED: f64 = 1e-3;

/// Names of degrees of freedom in a message.
const MOST_NAMES: usize = 4;

/// What keeps a link from staying where it stands, the likeliest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Obstacle {
    Moves,
    Rests,
    Still,
}

impl Pass {
    /// Refuses contact patches that the body could not give what they ask for.
    pub(super) fn check_denied(
        &self,
        holds: &[ContactPatch],
        surface: &Surface,
        scale: f64,
    ) -> Result<(), RunError> {
        let (hold, missing) = self.body.missing();
        if missing <= DENIED * scale {
            return Ok(());
        }
        let link_of = |hold: &ContactPatch| surface.contact_points[hold.contact_points[0]].link;
        let link = holds.get(hold).map_or(0, link_of);
        let (why, first) = match self.obstacles(link, holds.iter().map(link_of)) {
            Some((Obstacle::Moves, names)) => {
                (format!("what has a motion of its own ({names}) moves it"), Remedy::Free)
            }
            Some((Obstacle::Rests, names)) => {
                (format!("what is at its limit ({names}) leaves it no way"), Remedy::SoftLimits)
            }
            Some((Obstacle::Still, names)) => {
                (format!("what stands still ({names}) leaves it no way"), Remedy::Free)
            }
            None => ("the figure cannot keep still all that stands at once".to_owned(), Remedy::OtherPosture),
        };
        let link = self.simulation.figure.links()[link].name().to_owned();
        let (cause, remedies) =
            (FailureKind::ContactLost { link, why, missing }, vec![first, Remedy::CompliantGround]);
        Err(RunFailure { time: self.t, dof: None, cause, remedies }.into())
    }

    /// What keeps links that stand from going where they have to, between them and the root, by the names of degrees of freedom,
    /// first those of `link`: what has a motion of its own, else what rests at a limit, else what stands still.
    fn obstacles(&self, link: usize, others: impl Iterator<Item = usize>) -> Option<(Obstacle, String)> {
        let figure = &self.simulation.figure;
        let roles = self.roles();
        let part = |link: usize| {
            let still = |link: &usize| {
                let at = figure.layout().joints()[*link];
                roles[at.v..at.v + at.nv].iter().all(|role| *role == Role::Still)
            };
            let carrier = |link: &usize| figure.links()[*link].parent().filter(|_| still(link));
            // What stands still within the part that stands is no obstacle.
            std::iter::successors(Some(link), carrier).last().unwrap_or(link)
        };
        let mut found: Vec<(Obstacle, usize)> = Vec::new();
        for start in std::iter::once(link).chain(others) {
            for link in std::iter::successors(Some(part(start)), |link| figure.links()[*link].parent()) {
                let at = figure.layout().joints()[link];
                for dof in at.v..at.v + at.nv {
                    let obstacle = match roles[dof] {
                        Role::Dynamic => continue,
                        Role::Prescribed if self.driven[dof].held.is_some() => Obstacle::Rests,
                        Role::Prescribed => Obstacle::Moves,
                        Role::Still => Obstacle::Still,
                    };
                    if !found.contains(&(obstacle, dof)) {
                        found.push((obstacle, dof));
                    }
                }
            }
        }
        let worst = found.iter().map(|(obstacle, _)| *obstacle).min()?;
        let names = found.iter().filter(|(obstacle, _)| *obstacle == worst);
        let mut names: Vec<String> =
            names.map(|(_, dof)| format!("'{}'", self.simulation.name(*dof))).collect();
        if names.len() > MOST_NAMES {
            names.truncate(MOST_NAMES);
            names.push("…".to_owned());
        }
        Some((worst, names.join(", ")))
    }
}
