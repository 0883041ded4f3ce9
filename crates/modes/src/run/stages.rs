//! Parts of a sequence: when the one that goes on is over.

use super::driven::Meaning;
use super::pass::Pass;
use super::record::near;
use crate::EndCondition;
use crate::phase::Watched;

impl Pass {
    /// How many parts of the sequence are over.
    pub(crate) fn stages_over(&self) -> usize {
        self.stages.len()
    }

    /// Whether the part that goes on is over now; then the next one goes on.
    pub(crate) fn pass_stage(&mut self, events: &[Meaning]) -> bool {
        let Some(stage) = self.simulation.stages.get(self.stages.len()) else { return false };
        let due = self.t + near(self.t);
        let over = match &stage.until {
            EndCondition::Time(time) => *time <= due,
            EndCondition::Lasting(time) => self.stage_begun() + time <= due,
            EndCondition::Position { .. }
            | EndCondition::Velocity { .. }
            | EndCondition::TouchDown { .. }
            | EndCondition::LiftOff { .. } => events.contains(&Meaning::StageEnds),
            EndCondition::Done | EndCondition::Part(_) => {
                let ready = |&(dof, last): &(usize, usize)| {
                    let driven = &self.driven[dof];
                    driven.step > last || (driven.step == last && (driven.waits || driven.end.is_infinite()))
                };
                let done =
                    |&(dof, last): &(usize, usize)| self.driven[dof].step > last || self.driven[dof].waits;
                stage.parties.iter().all(ready)
                    && (stage.parties.is_empty() || stage.parties.iter().any(done))
            }
        };
        if over {
            self.stages.push(self.t);
        }
        over
    }

    /// When the part that goes on began (s).
    fn stage_begun(&self) -> f64 {
        self.stages.last().copied().unwrap_or(0.0)
    }

    /// When the part that goes on ends by the clock (s).
    pub(crate) fn stage_end(&self) -> f64 {
        match self.simulation.stages.get(self.stages.len()).map(|stage| &stage.until) {
            Some(EndCondition::Time(time)) => *time,
            Some(EndCondition::Lasting(time)) => self.stage_begun() + time,
            _ => f64::INFINITY,
        }
    }

    /// What the part that goes on waits for.
    pub(crate) fn watched_stage(&self) -> Option<Watched> {
        let layout = self.simulation.figure.layout();
        match &self.simulation.stages.get(self.stages.len())?.until {
            EndCondition::Position { dof, value } => {
                Some(Watched::Position { dof: layout.dof_index(dof)?, value: *value })
            }
            EndCondition::Velocity { dof, value } => {
                Some(Watched::Velocity { dof: layout.dof_index(dof)?, value: *value })
            }
            until => self.watched_contact(until),
        }
    }
}
