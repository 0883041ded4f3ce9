//! Constraints that make a coordinate a function of another.

use super::curves::compose;
use super::element::{child_flag, child_number, child_words, objects};
use super::function;
use crate::xml::{Node, Reader, element, tag};
use solaris_model::Curve;
use std::collections::{HashMap, HashSet};

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
    for node in objects(model, "ConstraintSet") {
        if node.tag_name().name() != "CoordinateCouplerConstraint" {
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
    resolve(reader, model, &direct)
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

/// Lets every coordinate follow one that follows none.
fn resolve(reader: &mut Reader, model: Node, direct: &Couplers) -> Couplers {
    let span = element(model, "ConstraintSet").map_or_else(|| tag(model), tag);
    let mut resolved = Couplers::new();
    let mut names: Vec<&String> = direct.keys().collect();
    names.sort();
    for name in names {
        let mut lead = Lead { leader: name.clone(), curve: Curve::linear(1.0, 0.0) };
        let mut bent = false;
        // No chain is longer than there are constraints.
        for _ in 0..=direct.len() {
            let Some(next) = direct.get(&lead.leader) else { break };
            let Some(curve) = compose(&lead.curve, &next.curve) else {
                let message = format!(
                    "coordinate '{name}' follows '{}', which is a bent function of '{}' itself; that cannot be kept: let both \
                     depend on '{}'",
                    lead.leader, next.leader, next.leader
                );
                reader.fault(span.clone(), message);
                bent = true;
                break;
            };
            lead = Lead { leader: next.leader.clone(), curve };
        }
        if direct.contains_key(&lead.leader) && !bent {
            reader.fault(
                span.clone(),
                format!("coordinate '{name}' depends on itself by constraints; remove one of them"),
            );
        } else if !bent {
            resolved.insert(name.clone(), lead);
        }
    }
    resolved
}
