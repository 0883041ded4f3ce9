//! A whole figure by one word.

use super::FigureReader;
use crate::fault::Fault;
use crate::figure::Figure;
use crate::human::{Human, HumanError, RootOrder};
use solaris_text::{Fields, Node};
use std::collections::HashSet;
use std::ops::Range;

impl FigureReader<'_> {
    /// `Human(height: 1.75, mass: 73.0, age: 9, segments: {"left_thigh": 0.45}, load: {"right": 5.0}, joints: Limp, root: Yzx,
    /// limits: {"left_elbow.rx": (deg(-150), deg(0))})`
    pub(super) fn body(
        &mut self,
        node: &Node<'_>,
        name: Option<&str>,
        stature: Option<f64>,
    ) -> Option<Figure> {
        if let Some(stature) = stature.filter(|height| *height <= 0.0) {
            let place = self.places.of(&Fault::Stature { stature });
            self.fault(place, Fault::Stature { stature }.to_string());
        }
        let known =
            ["height", "mass", "age", "segments", "load", "shorter_leg", "cane", "joints", "root", "limits"];
        let fields = self.fields(node, &["Human"], &known)?;
        let height_node = self.required(&fields, "height", "1.75");
        let mass_node = self.required(&fields, "mass", "73.0");
        let height = height_node.and_then(|node| self.number(node, "the height"));
        let mass = mass_node.and_then(|node| self.number(node, "the mass"));
        let segments = fields.get("segments").map(|node| self.amounts(node, &SEGMENTS)).unwrap_or_default();
        let sided = self.sided(&fields);
        let age_node = fields.get("age");
        let age = age_node.map(|node| self.number(node, "the age"));
        let limits = fields.get("limits").map(|node| self.own_limits(node)).unwrap_or_default();
        let joints = fields.get("joints").map(|node| self.is_limp(node));
        let root = fields.get("root").map(|node| self.root_order(node));
        let (height, mass, is_limp) = (height?, mass?, joints.unwrap_or(Some(false))?);
        let root = root.unwrap_or(Some(RootOrder::default()))?;
        if let Some(node) = fields.get("root").filter(|_| is_limp) {
            let message = "joints: Limp makes the root a free joint, which turns in no order; leave out root or joints: Limp";
            self.fault(node.place(), message.to_owned());
            return None;
        }
        let place = |node: Option<&Node<'_>>| node.map_or(fields.at.clone(), |node| node.span.clone());
        let mut human = Human::new(height, mass).root(root);
        if is_limp {
            human = human.limp();
        }
        if let Some(age) = age {
            human = human.age(age?);
        }
        if let Err(error) = human.build() {
            let field = match error {
                HumanError::Height { .. } => height_node,
                HumanError::Age { .. } => age_node,
                _ => mass_node,
            };
            self.fault(place(field), error.to_string());
            return None;
        }
        // Each length alone, so that all that are wrong are found.
        let mut good = true;
        for segment in &segments {
            let alone = Human::new(height, mass).segment_length(&segment.name, segment.amount);
            if let Err(error) = alone.build() {
                let wrong_name = matches!(error, HumanError::Segment { .. });
                let place = if wrong_name { &segment.name_at } else { &segment.amount_at };
                self.fault(place.clone(), error.to_string());
                good = false;
            }
            human = human.segment_length(&segment.name, segment.amount);
        }
        for (with, named) in sided? {
            let with = with(human.clone(), &named);
            match with.build() {
                Err(
                    error @ (HumanError::Load { .. }
                    | HumanError::ShorterLeg { .. }
                    | HumanError::Cane { .. }),
                ) => {
                    let is_side = ["left", "right"].contains(&named.name.as_str());
                    self.fault(if is_side { named.amount_at } else { named.name_at }, error.to_string());
                    good = false;
                }
                _ => human = with,
            }
        }
        for (dof, [lower, upper], at) in limits {
            let with = human.clone().limits(dof, lower, upper);
            match with.build() {
                Err(error @ HumanError::Limits { .. }) => {
                    self.fault(at, error.to_string());
                    good = false;
                }
                _ => human = with,
            }
        }
        if !good {
            return None;
        }
        match human.build() {
            Ok(mut figure) => {
                if let Some(name) = name {
                    name.clone_into(&mut figure.name);
                }
                figure.stature = stature.or(figure.stature);
                Some(figure)
            }
            Err(error) => {
                self.fault(fields.at.clone(), error.to_string());
                None
            }
        }
    }

    fn root_order(&mut self, node: &Node<'_>) -> Option<RootOrder> {
        let kind = self.kind(node, &["Zyx", "Yzx"])?;
        let order = if kind == "Yzx" { RootOrder::Yzx } else { RootOrder::Zyx };
        self.stands_alone(node, kind).then_some(order)
    }

    fn is_limp(&mut self, node: &Node<'_>) -> Option<bool> {
        let kind = self.kind(node, &["Angles", "Limp"])?;
        self.stands_alone(node, kind).then_some(kind == "Limp")
    }

    /// What a side has, each with what it does to a human; none where that is not told.
    fn sided(&mut self, fields: &Fields<'_, '_>) -> Option<Vec<(Sided, Named)>> {
        let loads = fields.get("load").map(|node| self.amounts(node, &LOAD)).unwrap_or_default();
        let shorter = fields.get("shorter_leg").map(|node| self.amounts(node, &SHORTER)).unwrap_or_default();
        let cane = fields.get("cane").map(|node| self.hand(node));
        let with_load: Sided = |human, load| human.load(&load.name, load.amount);
        let with_leg: Sided = |human, leg| human.shorter_leg(&leg.name, leg.amount);
        let with_cane: Sided = |human, hand| human.cane(&hand.name);
        let mut sided: Vec<(Sided, Named)> = loads.into_iter().map(|load| (with_load, load)).collect();
        sided.extend(shorter.into_iter().map(|leg| (with_leg, leg)));
        if let Some(hand) = cane {
            sided.push((with_cane, hand?));
        }
        Some(sided)
    }

    /// The hand that holds something.
    fn hand(&mut self, node: &Node<'_>) -> Option<Named> {
        let name = self.name(node, "left or right")?.to_owned();
        Some(Named { name, name_at: node.span.clone(), amount: 0.0, amount_at: node.span.clone() })
    }

    /// Limits by the name of a degree of freedom, and where the name stands.
    fn own_limits(&mut self, node: &Node<'_>) -> Vec<(String, [f64; 2], Range<usize>)> {
        let Some(entries) = node.entries() else {
            let message = format!(
                "limits must be a map {{\"left_elbow.rx\": (deg(-150), deg(0))}}, not {}",
                node.describe()
            );
            self.fault(node.place(), message);
            return Vec::new();
        };
        let mut found: Vec<(String, [f64; 2], Range<usize>)> = Vec::new();
        for (key, value) in entries {
            let name = self.name(key, "the name of a degree of freedom");
            let Some((name, limits)) = name.zip(self.limits(value, true)) else { continue };
            if found.iter().any(|(known, ..)| known == name) {
                self.fault(key.span.clone(), format!("the limits of '{name}' are given twice; keep one"));
            }
            found.push((name.to_owned(), limits, key.span.clone()));
        }
        found
    }

    /// Amounts by the names of what has them.
    fn amounts(&mut self, node: &Node<'_>, of: &Amounts) -> Vec<Named> {
        let entries = self.entries(node, of.field, of.example).unwrap_or_default();
        let mut found = Vec::new();
        let mut seen = HashSet::new();
        for (key, value) in entries {
            let name = self.name(key, of.name);
            let amount = self.number(value, of.amount);
            let (Some(name), Some(amount)) = (name, amount) else { continue };
            if !seen.insert(name) {
                self.fault(
                    key.span.clone(),
                    format!("{} '{name}' is given twice; keep one of them", of.noun),
                );
            }
            let (name_at, amount_at) = (key.span.clone(), value.span.clone());
            found.push(Named { name: name.to_owned(), amount, name_at, amount_at });
        }
        found
    }
}

/// A person with what a side has of its own.
type Sided = fn(Human, &Named) -> Human;

/// A segment's own length or what a side has, and where it stands.
struct Named {
    name: String,
    amount: f64,
    name_at: Range<usize>,
    amount_at: Range<usize>,
}

/// What a map of amounts is about, for messages.
struct Amounts {
    field: &'static str,
    example: &'static str,
    noun: &'static str,
    name: &'static str,
    amount: &'static str,
}

const SEGMENTS: Amounts = Amounts {
    field: "segments",
    example: "{\"thigh\": 0.45}",
    noun: "segment",
    name: "the name of a segment",
    amount: "the length of a segment",
};

const SHORTER: Amounts = Amounts {
    field: "shorter_leg",
    example: "{\"left\": 0.02}",
    noun: "leg",
    name: "left or right",
    amount: "by how much a leg is shorter (m)",
};

const LOAD: Amounts = Amounts {
    field: "load",
    example: "{\"right\": 5.0}",
    noun: "hand",
    name: "left or right",
    amount: "the load of a hand (kg)",
};
