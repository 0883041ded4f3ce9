//! Walks: one and its parts, or several with standing in between.

use super::SceneReader;
use solaris_gait::{
    Extent, GaitError, PARAMETERS, PlanError, RequestError, STEPS, Unit, WalkPart, WalkRequest, WalkSegment,
};
use solaris_model::text::{Fields, Node};
use std::ops::Range;

/// What parts of a walk have, and walks.
const PART: [&str; 5] = ["steps", "step_frequency", "step_length", "speed", "turn"];
/// What only walks have, besides their style.
const WALK: [&str; 3] = ["distance", "then", "backward"];

/// A segment, beside where it is written.
pub(super) type Written<'n, 'a> = (Fields<'n, 'a>, WalkSegment);

impl SceneReader<'_> {
    /// `Walk(…)`, or a list of `Walk(…)` and `Stand(time: …)`.
    pub(super) fn segments<'n, 'a>(&mut self, node: &'n Node<'a>) -> Option<Vec<Written<'n, 'a>>> {
        let Some(items) = node.items() else {
            return Some(vec![self.segment(node, &["Walk"])?]);
        };
        // All of them are read, for their faults, before any is missed.
        let segments: Vec<Option<_>> =
            items.iter().map(|item| self.segment(item, &["Walk", "Stand"])).collect();
        segments.into_iter().collect()
    }

    fn segment<'n, 'a>(&mut self, node: &'n Node<'a>, kinds: &[&'static str]) -> Option<Written<'n, 'a>> {
        let fields = self.reader.fields(node, kinds, &[])?;
        if fields.kind == "Stand" {
            self.reader.only_known(&fields, &["time"]);
            let time = self.reader.required_number(&fields, "time", "2.0")?;
            return Some((fields, WalkSegment::Stand(time)));
        }
        let names: Vec<String> = PARAMETERS.iter().map(|parameter| written(parameter.name)).collect();
        let own = PART.into_iter().chain(WALK);
        let known: Vec<&str> = own.chain(names.iter().map(String::as_str)).collect();
        self.reader.only_known(&fields, &known);
        let request = self.request(&fields)?;
        Some((fields, WalkSegment::Walk(request)))
    }

    fn request(&mut self, fields: &Fields<'_, '_>) -> Option<WalkRequest> {
        let before = self.reader.count();
        let WalkPart { steps, step_frequency, step_length, speed, turn, .. } = self.part(fields);
        let distance = fields.get("distance").and_then(|node| self.reader.number(node, "distance"));
        let backward = fields.get("backward").and_then(|node| self.reader.flag(node)).unwrap_or_default();
        let mut request =
            WalkRequest { step_frequency, step_length, speed, turn, backward, ..WalkRequest::default() };
        if let (Some(_), Some(node)) = (fields.get("steps"), fields.get("distance")) {
            self.reader
                .fault(node.span.clone(), "a walk has steps or a distance, not both; remove one of them");
        }
        if let Some(distance) = distance {
            request.extent = Extent::Distance(distance);
        } else if fields.get("steps").is_some() {
            request.extent = Extent::Steps(steps);
        }
        for node in self.parts(fields) {
            let Some(part) = self.reader.fields(node, &["Part"], &PART) else { continue };
            self.reader.required(&part, "steps", "2");
            request.then.push(self.part(&part));
        }
        for parameter in PARAMETERS {
            let Some(node) = fields.get(&written(parameter.name)) else { continue };
            let value = match parameter.unit {
                Unit::Degrees => self.reader.angle(node, parameter.name).map(degrees),
                Unit::Metres => self.reader.number(node, parameter.name),
            };
            request.parameters.extend(value.map(|value| (parameter.name, value)));
        }
        (self.reader.count() == before).then_some(request)
    }

    /// What parts of a walk have; no steps where none are given.
    fn part(&mut self, fields: &Fields<'_, '_>) -> WalkPart {
        let mut number = |field: &str| fields.get(field).and_then(|node| self.reader.number(node, field));
        let (step_frequency, step_length, speed) =
            (number("step_frequency"), number("step_length"), number("speed"));
        let given = number("steps");
        let turn = fields.get("turn").and_then(|node| self.reader.angle(node, "turn")).unwrap_or_default();
        let (fewest, most) = STEPS;
        let mut steps = 0;
        if let (Some(given), Some(node)) = (given, fields.get("steps")) {
            if given.fract() == 0.0 && (fewest as f64..=most as f64).contains(&given) {
                steps = given as usize;
            } else {
                let message = format!("steps is {given}; it must be a whole number, {fewest} to {most}");
                self.reader.fault(node.span.clone(), message);
            }
        }
        WalkPart { steps, step_frequency, step_length, speed, turn, backward: false }
    }

    /// What comes next in a walk.
    fn parts<'n, 'a>(&mut self, fields: &Fields<'n, 'a>) -> &'n [Node<'a>] {
        let Some(node) = fields.get("then") else { return &[] };
        self.reader.items(node, "then", "[Part(steps: 2, turn: deg(15)), …]").unwrap_or_default()
    }

    /// Why there is no such walk, said of the number that is at fault where it can be told.
    pub(super) fn refuse_walk(&mut self, error: &GaitError, at: &Range<usize>, segments: &[Fields<'_, '_>]) {
        let (place, why) = match error {
            GaitError::InSegment { number, why } => match segments.get(number - 1) {
                Some(fields) => (place(why, fields), why.as_ref()),
                None => (at.clone(), error),
            },
            _ => (at.clone(), error),
        };
        self.reader.fault(place, why.to_string());
    }
}

/// Where in a segment the number stands that is at fault, or its part.
fn place(error: &GaitError, fields: &Fields<'_, '_>) -> Range<usize> {
    let found = match error {
        GaitError::Request(
            RequestError::Range { parameter, .. } | RequestError::StepLength { parameter, .. },
        ) => {
            // A stand has a time.
            let name = if *parameter == "stand" { "time".to_owned() } else { written(parameter) };
            fields.get(&name).map(|node| node.span.clone())
        }
        // The walk's own steps are its first part.
        GaitError::InPart { number: part, .. } | GaitError::Plan(PlanError::AbruptChange { part, .. }) => {
            let items = fields.get("then").and_then(Node::items);
            items.and_then(|items| items.get(part.checked_sub(2)?)).map(Node::place)
        }
        _ => None,
    };
    found.unwrap_or(fields.at.clone())
}

/// A name as it is written.
fn written(name: &str) -> String {
    name.replace(['-', ' '], "_")
}

/// An angle (rad) in degrees; one that was written in degrees comes back as it was written.
fn degrees(angle: f64) -> f64 {
    (angle.to_degrees() * 1e10).round() / 1e10
}
