//! Drives by degree of freedom.

use super::SceneReader;
use super::names::{Closeness, Meant, in_order};
use super::parts::Named;
use solaris_model::text::Fields;
use solaris_modes::{Drive, Step};
use std::collections::HashMap;
use std::ops::Range;

const EXAMPLE: &str = "{\"elbow.rx\": [Move(to: deg(80), over: 0.6), Free], \"neck.*\": Frozen}";

/// How many drives before one are looked at for the same place in the text.
const MOST_IN_REPEAT: usize = 100;

/// By degree of freedom: whether the scene says what drives it, and how.
pub(super) type Given = HashMap<usize, Vec<Step>>;

/// A drive and where it stands.
pub(super) type Placed = (Range<usize>, Step);

impl SceneReader<'_> {
    /// Reads the drives, gives them to the simulation, and tells which degrees of freedom have any; notes which of these are named by
    /// more than a pattern.
    pub(super) fn drives(&mut self, fields: &Fields<'_, '_>) -> Given {
        let (mut entries, mut closest) = (Vec::new(), Named::new());
        let mut named: HashMap<(Closeness, usize), String> = HashMap::new();
        for (key, value) in self.map(fields, "drives", EXAMPLE) {
            let before = self.reader.count();
            let meant = self.meant(key).map(|meant| self.leaders(meant));
            let turns = self.names.turn(meant.as_ref());
            let steps = self.sequence(value, turns);
            let Some(meant) = meant.filter(|_| self.reader.count() == before) else { continue };
            if let (Some(&first), true) = (meant.dofs.first(), meant.closeness != Closeness::Pattern) {
                let name = self.names.name(first).to_owned();
                if named.insert((meant.closeness, first), name.clone()).is_some() {
                    let message = format!("the drives of '{name}' are given twice; keep one of them");
                    self.reader.fault(key.span.clone(), message);
                }
            }
            if meant.closeness != Closeness::Pattern {
                closest.extend(meant.dofs.iter().map(|dof| (*dof, key.span.clone())));
            }
            entries.push((meant, steps));
        }
        let mut given: HashMap<usize, (Vec<Step>, Option<usize>)> = HashMap::new();
        for (meant, steps) in in_order(entries) {
            if !self.can_have(&meant.dofs, &steps.steps) {
                continue;
            }
            let again = steps.again;
            for dof in &meant.dofs {
                let steps = self.by_motor(*dof, &steps.steps);
                given.insert(*dof, (steps.into_iter().map(|(_, step)| step).collect(), again));
            }
        }
        if let Some(simulation) = &mut self.simulation {
            for (dof, (steps, again)) in &given {
                let (name, steps) = (self.names.name(*dof), steps.iter().cloned());
                // Cannot fail: each step has been tried.
                let _ = match again {
                    Some(first) => simulation.drive_again(name, steps, *first),
                    None => simulation.drive(name, steps),
                };
            }
        }
        self.named = closest;
        given.into_iter().map(|(dof, (steps, _))| (dof, steps)).collect()
    }

    /// What is meant, but for those that follow others: they have no drives. One that is named is kept, to be refused.
    pub(super) fn leaders(&self, mut meant: Meant) -> Meant {
        if let Some(figure) = self.figure().filter(|_| meant.closeness != Closeness::Dof) {
            meant.dofs.retain(|dof| !figure.follows(*dof));
        }
        meant
    }

    /// Whether these degrees of freedom can have these drives; each that they cannot have is a fault, once.
    pub(super) fn can_have(&mut self, dofs: &[usize], steps: &[Placed]) -> bool {
        // Each has its own; one of each is no more than the figure is.
        if let [.., (last, _)] = steps
            && !self.make(last.clone(), dofs.len().saturating_sub(1) * (steps.len() - 1))
        {
            return false;
        }
        let Some(mut trial) = self.simulation.clone() else { return false };
        let mut good = true;
        for (i, (span, step)) in steps.iter().enumerate() {
            // What is repeated stands in one place.
            if steps[..i].iter().rev().take(MOST_IN_REPEAT).any(|(other, _)| other == span) {
                continue;
            }
            let mut results = dofs.iter().map(|dof| trial.drive(self.names.name(*dof), [step.clone()]));
            let result = results.find(Result::is_err).unwrap_or(Ok(()));
            good &= self.setup(span, result).is_some();
        }
        good
    }

    /// Where a curve begins (position and velocity) that a degree of freedom follows from the beginning on.
    pub(super) fn begins(steps: &[Step]) -> Option<(f64, f64)> {
        let Drive::Kinematic(profile) = &steps.first()?.drive else { return None };
        let sample = solaris_profiles::Curve::at(&profile.curve::<f64>().ok()?, 0.0);
        Some((sample.position, sample.velocity))
    }
}
