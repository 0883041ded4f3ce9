//! The tree that links and joints form.

use super::joint::{Joint, Kind};
use super::link::{Inertial, Link};
use crate::tree::Body;
use crate::xml::{Node, Reader, tag};
use solaris_model::{Matrix3, Part, Place, Placement, SourceMap, Vector3};
use std::collections::HashMap;
use std::ops::Range;

/// The bodies, in the order of the joints but for the root, which is first. Where they form no tree, which is a fault, each
/// stands alone, so that what is wrong with itself is found too.
pub(super) fn bodies(
    reader: &mut Reader,
    robot: Node,
    links: Vec<Link>,
    joints: &[Joint],
    places: &mut SourceMap,
) -> Vec<Body> {
    let by_name = names(reader, "link", links.iter().map(|link| (link.name.as_str(), &link.span)));
    let joint_names = names(reader, "joint", joints.iter().map(|joint| (joint.name.as_str(), &joint.span)));
    if links.is_empty() {
        reader.fault(tag(robot), "the robot has no <link>");
        return Vec::new();
    }
    // What is the child of what is not known where names are not.
    let unique = by_name.len() == links.len() && joint_names.len() == joints.len();
    let tree = parents(reader, &links, joints, &by_name)
        .filter(|_| unique)
        .and_then(|parents| Some((root(reader, &links, &parents)?, parents)));
    let Some((root, parents)) = tree else {
        return alone(reader, links, joints, [&by_name, &joint_names], places);
    };
    say_about_joints(reader, joints, &joint_names);

    // Of each link, its place in the list of bodies: the root, then the children of the joints in their order.
    let mut order = vec![0; links.len()];
    let children = joints.iter().filter_map(|joint| by_name.get(joint.child.as_ref()?.0.as_str()).copied());
    for (i, link) in std::iter::once(root).chain(children).enumerate() {
        order[link] = i;
    }
    let place = |name: &str| by_name.get(name).map(|&link| order[link]);
    let mut bodies: Vec<Option<Body>> = links.iter().map(|_| None).collect();
    for (i, link) in links.into_iter().enumerate() {
        let joint = parents[i].map(|joint| &joints[joint]);
        let parent = joint.and_then(|joint| place(joint.parent.as_ref()?.0.as_str()));
        bodies[order[i]] = Some(body(reader, link, joint, parent, places));
    }
    bodies.into_iter().flatten().collect()
}

/// The bodies without their parents, each name once.
fn alone(
    reader: &mut Reader,
    links: Vec<Link>,
    joints: &[Joint],
    [link_names, joint_names]: [&HashMap<String, usize>; 2],
    places: &mut SourceMap,
) -> Vec<Body> {
    let is_first = |names: &HashMap<String, usize>, name: &str, i: usize| {
        !name.trim().is_empty() && names.get(name) == Some(&i)
    };
    let mut moved_by: HashMap<&str, &Joint> = HashMap::new();
    for (_, joint) in joints.iter().enumerate().filter(|(i, joint)| is_first(joint_names, &joint.name, *i)) {
        if let Some((child, _)) = &joint.child {
            moved_by.entry(child).or_insert(joint);
        }
    }
    let links = links.into_iter().enumerate().filter(|(i, link)| is_first(link_names, &link.name, *i));
    links
        .map(|(_, link)| {
            let joint = moved_by.get(link.name.as_str()).copied();
            body(reader, link, joint, None, places)
        })
        .collect()
}

/// The places of names in their list; a name that is empty or used before is a fault.
fn names<'a>(
    reader: &mut Reader,
    kind: &str,
    names: impl Iterator<Item = (&'a str, &'a Range<usize>)>,
) -> HashMap<String, usize> {
    let mut places: HashMap<String, (usize, Range<usize>)> = HashMap::new();
    let mut repeated = 0;
    for (i, (name, span)) in names.enumerate() {
        if let Some((_, first)) = places.get(name) {
            repeated += 1;
            // Lines are counted for the few that will be read.
            let before = if repeated <= 100 {
                format!(" (on line {})", Place::of(reader.text(), first.clone()).line)
            } else {
                String::new()
            };
            reader.fault(
                span.clone(),
                format!("{kind} '{name}' is there already{before}; names must be unique"),
            );
        } else {
            // A missing name has been reported.
            if name.trim().is_empty() && !reader.text()[span.clone()].starts_with('<') {
                reader.fault(span.clone(), format!("a {kind} has an empty name; give it one"));
            }
            places.insert(name.to_owned(), (i, span.clone()));
        }
    }
    places.into_iter().map(|(name, (i, _))| (name, i)).collect()
}

/// Of each link, the joint that it is the child of; `None` where a joint has no links.
fn parents(
    reader: &mut Reader,
    links: &[Link],
    joints: &[Joint],
    by_name: &HashMap<String, usize>,
) -> Option<Vec<Option<usize>>> {
    let mut parents: Vec<Option<usize>> = vec![None; links.len()];
    let mut sound = true;
    for (i, joint) in joints.iter().enumerate() {
        for (name, span) in joint.parent.iter().chain(&joint.child) {
            if !by_name.contains_key(name) {
                let hint = reader.hint(name, links.iter().map(|link| link.name.as_str()));
                reader.fault(
                    span.clone(),
                    format!("joint '{}' names the link '{name}', which is not there{hint}", joint.name),
                );
                sound = false;
            }
        }
        let Some((child, span)) = &joint.child else {
            sound = false;
            continue;
        };
        sound &= joint.parent.is_some();
        let Some(&link) = by_name.get(child) else { continue };
        if let Some(first) = parents[link] {
            let (this, first) = (&joint.name, &joints[first].name);
            let message = format!(
                "link '{child}' is the child of joint '{first}' already and cannot be that of joint '{this}'; a link has one \
                 parent (loops are not part of URDF)"
            );
            reader.fault(span.clone(), message);
            sound = false;
        } else {
            parents[link] = Some(i);
        }
    }
    // Every link knows its parent's place through its joint.
    let above = |link: usize| {
        let joint = &joints[parents[link]?];
        by_name.get(joint.parent.as_ref()?.0.as_str()).copied()
    };
    sound &= !find_cycles(reader, links, above);
    sound.then_some(parents)
}

/// Reports every cycle once, at its first link.
fn find_cycles(reader: &mut Reader, links: &[Link], above: impl Fn(usize) -> Option<usize>) -> bool {
    let mut seen: Vec<usize> = vec![usize::MAX; links.len()];
    let mut found = false;
    for start in 0..links.len() {
        let mut at = start;
        while seen[at] == usize::MAX {
            seen[at] = start;
            match above(at) {
                Some(parent) => at = parent,
                None => break,
            }
        }
        if seen[at] == start && above(at).is_some() {
            let mut names = vec![links[at].name.as_str()];
            let mut next = above(at).unwrap_or(at);
            while next != at {
                names.push(&links[next].name);
                next = above(next).unwrap_or(at);
            }
            let message = format!(
                "links {} are each other's ancestors (a cycle); one of them needs a parent outside of it",
                some(&names)
            );
            reader.fault(links[at].span.clone(), message);
            found = true;
        }
    }
    found
}

/// The link that no joint moves.
fn root(reader: &mut Reader, links: &[Link], parents: &[Option<usize>]) -> Option<usize> {
    let roots: Vec<usize> = (0..links.len()).filter(|&link| parents[link].is_none()).collect();
    if let [_, second, ..] = roots.as_slice() {
        let names: Vec<&str> = roots.iter().map(|&root| links[root].name.as_str()).collect();
        let message = format!(
            "links {} are the child of no joint; a robot has one root: connect the others",
            some(&names)
        );
        reader.fault(links[*second].span.clone(), message);
        return None;
    }
    roots.first().copied()
}

/// The first names, in quotes.
fn some(names: &[&str]) -> String {
    let list = names.iter().take(10).map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(10) {
        0 => list,
        more => format!("{list} and {more} more"),
    }
}

fn say_about_joints(reader: &mut Reader, joints: &[Joint], names: &HashMap<String, usize>) {
    for joint in joints {
        let Some(mimic) = &joint.mimic else { continue };
        if names.contains_key(&mimic.joint) {
            reader.note(mimic.span.clone(), &joint.name, Joint::mimicry(mimic));
        } else {
            let hint = reader.hint(&mimic.joint, names.keys().map(String::as_str));
            let message = format!("it mimics the joint '{}', which is not there{hint}", mimic.joint);
            reader.suspect(mimic.span.clone(), &joint.name, message);
        }
    }
    let fixed: Vec<&Joint> = joints.iter().filter(|joint| joint.kind == Kind::Fixed).collect();
    if let Some(first) = fixed.first() {
        let names: Vec<&str> =
            fixed.iter().filter_map(|joint| joint.child.as_ref()).map(|(name, _)| name.as_str()).collect();
        let message = format!(
            "what they hold is part of their parents' links, and a frame by its name ({}); the joints' own names are not kept",
            some(&names)
        );
        reader.note(first.span.clone(), "fixed joints", message);
    }
}

fn body(
    reader: &mut Reader,
    link: Link,
    joint: Option<&Joint>,
    parent: Option<usize>,
    places: &mut SourceMap,
) -> Body {
    let moved = joint.is_some_and(|joint| joint.kind != Kind::Fixed);
    if let Some(joint) = joint.filter(|_| link.inertial.is_none() && moved) {
        let message =
            format!("it has no <inertial>, though joint '{}' moves it: it counts as massless", joint.name);
        reader.suspect(link.span.clone(), &link.name, message);
    }
    let weld = || solaris_model::Joint::new("");
    let inertial = link.inertial.unwrap_or_else(|| Inertial {
        mass: 0.0,
        com: Vector3::zeros(),
        inertia: Matrix3::zeros(),
        spans: [link.span.clone(), link.span.clone()],
    });
    places.put(Part::Link, &link.name, link.span.clone());
    for (field, span) in ["mass", "inertia"].into_iter().zip(inertial.spans) {
        places.put_field(Part::Link, &link.name, field, span);
    }
    if let Some(joint) = joint.filter(|_| moved) {
        places.put(Part::Joint, &joint.name, joint.axis_span.clone());
        places.put(Part::Dof, &joint.name, joint.span.clone());
        places.put_field(Part::Dof, &joint.name, "limits", joint.limits_span.clone());
        for field in ["damping", "friction"] {
            places.put_field(Part::Dof, &joint.name, field, joint.dynamics_span.clone());
        }
    }
    Body {
        name: link.name,
        parent,
        joint: joint.map_or_else(weld, Joint::build),
        beyond: Placement::identity(),
        mass: inertial.mass,
        com: inertial.com,
        inertia: inertial.inertia,
        shape: link.shape,
        frames: Vec::new(),
        span: link.span,
    }
}
