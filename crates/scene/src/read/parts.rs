//! A sequence over several degrees of freedom at once.

use super::SceneReader;
use super::drives::Given;
use super::names::{Closeness, in_order};
use solaris_model::text::{Fields, Node};
use solaris_modes::{EndCondition, Part, Step};
use std::collections::BTreeMap;
use std::collections::HashMap;
use std::ops::Range;

const EXAMPLE: &str =
    "[Together({\"left_elbow.rx\": Move(to: deg(-90), over: 0.6)}), Wait(0.5), Together({…})]";
const PART: &str = "{\"left_elbow.rx\": Move(to: deg(-90), over: 0.6), \"neck.*\": Frozen}";
const KINDS: [&str; 3] = ["Together", "Wait", "When"];

/// Where drives are given by their closest names: degree of freedom, and place of the name.
pub(super) type Named = HashMap<usize, Range<usize>>;

/// What takes part in the sequence, and whether a part of it waits for the run's state.
#[derive(Default)]
pub(super) struct Sequenced {
    pub(super) dofs: Vec<usize>,
    pub(super) waits_for_state: bool,
}

impl SceneReader<'_> {
    /// Reads the sequence, gives it to the simulation, and adds its degrees of freedom to those that have drives; those that
    /// `drives` names are known.
    pub(super) fn sequence_of_parts(&mut self, fields: &Fields<'_, '_>, given: &mut Given) {
        let Some(node) = fields.get("sequence") else { return };
        let before = self.reader.count();
        let mut parts = Vec::new();
        let mut places = Vec::new();
        let mut all: BTreeMap<usize, Vec<Step>> = BTreeMap::new();
        for item in self.reader.items(node, "sequence", EXAMPLE).unwrap_or_default() {
            let Some(part) = self.one_part(item, &mut all) else { continue };
            parts.push(part);
            places.push(item.place());
        }
        if self.reader.count() > before {
            return;
        }
        if let Some(simulation) = &mut self.simulation {
            let result = simulation.sequence(parts);
            let place = match &result {
                Err(solaris_modes::SetupError::Sequence { part }) => places.get(part - 1).cloned(),
                _ => None,
            };
            self.setup(&place.unwrap_or_else(|| node.place()), result);
        }
        self.sequenced.dofs = all.keys().copied().collect();
        given.extend(all);
    }

    /// `Together({…})`, `Wait(0.5)` or `When(Passes("elbow.rx", deg(10)))`
    fn one_part(&mut self, node: &Node<'_>, all: &mut BTreeMap<usize, Vec<Step>>) -> Option<Part> {
        let kind = self.reader.kind(node, &KINDS)?;
        match (kind, node.tuple()) {
            ("Together", Some([map])) => self.together(map, all),
            ("Wait", Some([time])) => {
                let time = self.reader.number(time, "the time to wait")?;
                if time.is_finite() && time >= 0.0 {
                    return Some(Part::Until(EndCondition::Lasting(time)));
                }
                let message = format!("the time to wait is {time}; it must be a finite number, zero or more");
                self.reader.fault(node.place(), message);
                None
            }
            ("When", Some([condition])) => match self.until(condition)? {
                EndCondition::Done => {
                    let message = "a part waits for At(2.0), Lasting(0.5), Passes(\"elbow.rx\", deg(10)) or PassesSpeed(…), not Done";
                    self.reader.fault(condition.place(), message);
                    None
                }
                until => {
                    let is_time = matches!(until, EndCondition::Time(_) | EndCondition::Lasting(_));
                    self.sequenced.waits_for_state |= !is_time;
                    Some(Part::Until(until))
                }
            },
            _ => {
                let message = format!(
                    "a sequence is of Together({PART}), Wait(0.5) and When(Passes(\"left_elbow.rx\", deg(-60)))"
                );
                self.reader.fault(node.place(), message);
                None
            }
        }
    }

    fn together(&mut self, map: &Node<'_>, all: &mut BTreeMap<usize, Vec<Step>>) -> Option<Part> {
        let before = self.reader.count();
        let mut entries = Vec::new();
        for (key, value) in self.reader.entries(map, "a part", PART)? {
            let meant = self.meant(key).map(|meant| self.leaders(meant));
            let turns = self.names.turn(meant.as_ref());
            let steps = self.sequence(value, turns);
            if steps.again.is_some() {
                let message = "a part that is repeated without end never is over; say how many times";
                self.reader.fault(value.place(), message);
            }
            let Some(meant) = meant else { continue };
            if meant.closeness != Closeness::Pattern
                && let Some(dof) = meant.dofs.iter().find(|dof| self.named.contains_key(dof))
            {
                let name = self.names.name(*dof).to_owned();
                let message = format!("'{name}' is in 'drives' and in the sequence; keep it in one of them");
                self.reader.fault(key.span.clone(), message);
            }
            entries.push((meant, steps));
        }
        let mut own: BTreeMap<usize, Vec<Step>> = BTreeMap::new();
        for (meant, steps) in in_order(entries) {
            if !self.can_have(&meant.dofs, &steps.steps) {
                continue;
            }
            for dof in &meant.dofs {
                let steps = self.by_motor(*dof, &steps.steps);
                own.insert(*dof, steps.into_iter().map(|(_, step)| step).collect());
            }
        }
        if self.reader.count() > before {
            return None;
        }
        for (dof, steps) in &own {
            // What comes first says where it begins.
            all.entry(*dof).or_insert_with(|| steps.clone());
        }
        let names = own.into_iter().map(|(dof, steps)| (self.names.name(dof).to_owned(), steps));
        Some(Part::Together(names.collect()))
    }
}
