//! Constraints that make a coordinate a function of another.

use super::curves::{compose, links};
use super::element::{child_flag, child_number, child_words, members};
use super::function;
use crate::xml::{Node, Reader, element, tag};
use solaris_model::Curve;
use std::collections::{HashMap, HashSet};

/// What such a constraint is called.
pub(super) const COUPLER: &str = "CoordinateCouplerConstraint";

/// Of each dependent coordinate, what it follows.
pub(super) type Couplers = HashMap<String, Lead>;

/// What a coordinate follows: one that follows none.
pub(super) struct Lead {
    pub(super) leader: String,
    pub(super) curve: Curve,
}

/// The couplers of a model with these coordinates. Every other constraint is listed.
pub(super) fn read(reader: &mut Reader, model: Node, coordinates: &HashSet<&str>) -> Couplers {
    let mut direct = HashMap::new();
    for node in members(model, "ConstraintSet", |tag| tag == COUPLER) {
        if node.tag_name().name() != COUPLER {
            reader.unread_element(node);
        } else if let Some((dependent, lead)) = coupler(reader, node, coordinates)
            && direct.insert(dependent.clone(), lead).is_some()
        {
            reader.fault(
                tag(node),
                format!("coordinate '{dependent}' depends on others by two constraints; remove one"),
            );
        }
    }
    resolve(reader, model, direct)
}

fn coupler(reader: &mut Reader, node: Node, coordinates: &HashSet<&str>) -> Option<(String, Lead)> {
    let name = node.attribute("name").unwrap_or_default();
    let subject = format!("constraint '{name}'");
    let enforced =
        child_flag(reader, node, "isEnforced", true) && !child_flag(reader, node, "isDisabled", false);
    let leaders: Vec<&str> =
        child_words(node, "independent_coordinate_names").unwrap_or_default().split_whitespace().collect();
    let dependent = child_words(node, "dependent_coordinate_name").unwrap_or_default();
    if !enforced {
        reader.unsupported(tag(node), subject, "it is not enforced in the file and left out");
        return None;
    }
    let unknown: Vec<&str> =
        leaders.iter().copied().chain([dependent]).filter(|name| !coordinates.contains(name)).collect();
    for coordinate in &unknown {
        let hint = reader.hint(coordinate, coordinates.iter().copied());
        let message = format!("{subject} names the coordinate '{coordinate}', which no joint has{hint}");
        reader.fault(tag(node), message);
    }
    if !unknown.is_empty() {
        return None;
    }
    let [leader] = leaders[..] else {
        let message = format!(
            "it makes '{dependent}' a function of {} coordinates, which is not read; the coordinate stays free",
            leaders.len()
        );
        reader.unsupported(tag(node), subject, message);
        return None;
    };
    let others = [
        "independent_coordinate_names",
        "dependent_coordinate_name",
        "scale_factor",
        "isEnforced",
        "isDisabled",
    ];
    let function = function::held(node, &others);
    // A function that is not read leaves the coordinate free, which is no fault.
    let mut trial = Reader::new(node.document().input_text());
    let curve = function.and_then(|function| function::read(&mut trial, function, &subject));
    let Some(curve) = curve else {
        let why = trial.error().and_then(|error| error.faults.into_iter().next());
        let why = why.map_or_else(|| "it has no function".to_owned(), |fault| fault.message);
        reader.unsupported(tag(node), subject, format!("{why}; the coordinate '{dependent}' stays free"));
        return None;
    };
    let curve = curve.scaled(child_number(reader, node, "scale_factor").unwrap_or(1.0));
    let message = format!(
        "coordinate '{dependent}' follows '{leader}', which feels its forces; OpenSim's inverse dynamics leaves such a \
         constraint out"
    );
    reader.note(tag(node), subject, message);
    Some((dependent.to_owned(), Lead { leader: leader.to_owned(), curve }))
}

/// The most bent functions in a row between a coordinate and the one that it follows in the end.
const LONGEST: usize = 16;

/// Lets every coordinate follow one that follows none.
fn resolve(reader: &mut Reader, model: Node, mut direct: Couplers) -> Couplers {
    let span = element(model, "ConstraintSet").map_or_else(|| tag(model), tag);
    let mut resolved = Couplers::new();
    let mut names: Vec<String> = direct.keys().cloned().collect();
    names.sort();
    for name in names {
        // From this coordinate on to one whose leader is known to follow none.
        let mut open = Vec::new();
        let mut next = name.clone();
        while let Some(lead) = direct.remove(&next) {
            let leader = lead.leader.clone();
            open.push((next, lead));
            next = leader;
        }
        if open.iter().any(|(coordinate, _)| *coordinate == next) {
            let message = format!("coordinate '{next}' depends on itself by constraints; remove one of them");
            reader.fault(span.clone(), message);
            continue;
        }
        for (coordinate, lead) in open.into_iter().rev() {
            let lead = match resolved.get(&lead.leader) {
                Some(Lead { leader, curve }) => {
                    Lead { leader: leader.clone(), curve: compose(&lead.curve, curve) }
                }
                None => lead,
            };
            if links(&lead.curve).len() > LONGEST {
                let message = format!(
                    "coordinate '{coordinate}' follows '{}' over more than {LONGEST} bent functions in a row; let it depend on \
                     '{}' by one",
                    lead.leader, lead.leader
                );
                reader.fault(span.clone(), message);
                return resolved;
            }
            resolved.insert(coordinate, lead);
        }
    }
    resolved
}
