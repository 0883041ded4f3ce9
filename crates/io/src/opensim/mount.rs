//! Which joint moves which body, from ground on outward.

use super::joint::JointAt;
use crate::xml::{Node, Reader, tag};

/// Of each body, what moves it.
pub(super) struct Mounts {
    pub(super) of: Vec<Mount>,
    /// Whether every body hangs on ground in the end.
    pub(super) whole: bool,
}

/// What moves a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mount {
    /// Nothing that is known.
    None,
    /// No joint of the file: it floats.
    Free,
    /// The joint with this number, from its parent to its child.
    Forward(usize),
    /// The joint with this number, whose child is nearer to ground than its parent.
    Backward(usize),
}

/// Hangs the bodies on ground. `lost`: there are joints of which it is not known what they join.
///
/// A body that no joint has as its child, in a part of the model that does not hang on ground, floats (as in OpenSim).
/// Loops are faults.
pub(super) fn mount(reader: &mut Reader, bodies: &[(&str, Node)], joints: &[JointAt], lost: bool) -> Mounts {
    let ground = bodies.len();
    let ends = |joint: &JointAt| [&joint.parent, &joint.child].map(|anchor| anchor.body.unwrap_or(ground));
    let mut at_body: Vec<Vec<usize>> = vec![Vec::new(); ground + 1];
    let mut is_child = vec![false; ground + 1];
    for (j, joint) in joints.iter().enumerate() {
        let [parent, child] = ends(joint);
        at_body[parent].push(j);
        at_body[child].push(j);
        is_child[child] = true;
    }
    let mut of = vec![Mount::None; ground];
    let mut used = vec![false; joints.len()];
    let mut whole = true;
    let floating = (0..ground).filter(|&body| !is_child[body] && !lost);
    for start in [ground].into_iter().chain(floating) {
        if start < ground {
            if of[start] != Mount::None {
                continue;
            }
            of[start] = Mount::Free;
            let (name, node) = bodies[start];
            let message = "no joint moves it: it floats, as in OpenSim; give it a joint if it should not";
            reader.suspect(tag(node), format!("body '{name}'"), message);
        }
        let mut next = std::collections::VecDeque::from([start]);
        while let Some(body) = next.pop_front() {
            for &j in &at_body[body] {
                if std::mem::replace(&mut used[j], true) {
                    continue;
                }
                let [parent, child] = ends(&joints[j]);
                let (outer, how) =
                    if parent == body { (child, Mount::Forward(j)) } else { (parent, Mount::Backward(j)) };
                if outer == ground || outer == body || of[outer] != Mount::None {
                    name_loop(reader, bodies, joints, j, [child, parent].map(|end| of.get(end)));
                } else {
                    of[outer] = how;
                    next.push_back(outer);
                }
            }
        }
    }
    let hanging = |of: &[Mount], body: usize| of[body] != Mount::None;
    for start in 0..ground {
        if hanging(&of, start) {
            continue;
        }
        whole = false;
        if !lost {
            name_cycle(reader, bodies, joints, start);
            break;
        }
    }
    Mounts { of, whole }
}

fn name_loop(
    reader: &mut Reader,
    bodies: &[(&str, Node)],
    joints: &[JointAt],
    index: usize,
    ends: [Option<&Mount>; 2],
) {
    let joint = &joints[index];
    let other = ends.into_iter().flatten().find_map(|mount| match *mount {
        Mount::Forward(j) | Mount::Backward(j) => Some(joints[j].name.as_str()),
        _ => None,
    });
    let body = joint.child.body.or(joint.parent.body).map_or("ground", |body| bodies[body].0);
    let other = other.map_or_else(|| "something else".to_owned(), |other| format!("joint '{other}'"));
    let message = format!(
        "joint '{}' moves body '{body}', which {other} moves already; a loop is not read: remove one of them",
        joint.name
    );
    reader.fault(tag(joint.node), message);
}

/// Names the bodies of a circle of joints that does not hang on ground, above a body that does not either.
fn name_cycle(reader: &mut Reader, bodies: &[(&str, Node)], joints: &[JointAt], start: usize) {
    let mut above = vec![None; bodies.len()];
    for joint in joints {
        if let Some(child) = joint.child.body {
            above[child] = above[child].or(joint.parent.body);
        }
    }
    // After as many steps as there are bodies, the walk goes round.
    let mut at = start;
    for _ in 0..bodies.len() {
        at = above[at].unwrap_or(at);
    }
    let mut names = vec![format!("'{}'", bodies[at].0)];
    let first = at;
    while let Some(parent) = above[at]
        && parent != first
        && names.len() < 5
    {
        names.push(format!("'{}'", bodies[parent].0));
        at = parent;
    }
    let message = format!(
        "bodies {} are each other's ancestors (a cycle); one of them needs a joint to ground",
        names.join(", ")
    );
    reader.fault(tag(bodies[first].1), message);
}
