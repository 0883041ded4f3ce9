//! The assembly of the fused figure from what is locked.

use super::Fused;
use super::carried::{LinkPlace, absorb, compose, frame_names, moved};
use super::joint::{Left, Part, left};
use crate::anatomy::AnatomicalAngle;
use crate::figure::Figure;
use crate::follower::followers;
use crate::joint::{Joint, JointKind, Placement};
use crate::layout::{JointLayout, StateLayout, velocity_names};
use crate::link::Link;
use nalgebra::{Matrix3, Vector3};
use std::collections::HashSet;

/// The figure with those coordinates held that have a value in `held` (length `nq`).
pub(super) fn assemble(full: &Figure, held: &[Option<f64>]) -> Fused {
    let mut small = Small {
        full,
        links: Vec::new(),
        places: Vec::new(),
        frames: frame_names(&full.links),
        names: full.links.iter().flat_map(|link| [&link.name, &link.joint.name]).cloned().collect(),
    };
    let (mut dofs, mut kept_v) = (vec![None; full.layout.nv()], Vec::new());
    for (i, at) in full.layout.joints().iter().enumerate() {
        let held = &held[at.q..at.q + at.nq];
        for v in 0..at.nv {
            // A ball or free joint is held as a whole.
            if held[v].is_none() {
                dofs[at.v + v] = Some(kept_v.len());
                kept_v.push(at.v + v);
            }
        }
        if held.iter().all(Option::is_none) {
            small.keep(i);
        } else {
            small.reduce(i, at, held);
        }
    }
    let Small { links, places, .. } = small;
    let figure = with_links(full, links, &dofs);
    let kept_q = (0..held.len()).filter(|&q| held[q].is_none()).collect();
    Fused { figure, links: places, kept_q, kept_v, dofs, rest: rest(full, held) }
}

/// `q` with what is held in its place.
fn rest(full: &Figure, held: &[Option<f64>]) -> Vec<f64> {
    let mut rest: Vec<f64> = held.iter().map(|held| held.unwrap_or_default()).collect();
    for (link, at) in full.links.iter().zip(full.layout.joints()) {
        if let Some(quaternion) = link.joint.kind().quaternion().filter(|_| held[at.q].is_none()) {
            rest[at.q + quaternion + 3] = 1.0;
        }
    }
    rest
}

/// The figure of these links, with the angles whose degree of freedom is still there.
pub(crate) fn with_links(full: &Figure, links: Vec<Link>, dofs: &[Option<usize>]) -> Figure {
    let layout = StateLayout::of(&links);
    let angles = full.angles.iter().filter_map(|angle| {
        let dof = dofs[angle.dof]?;
        let coordinate = layout.coordinate(dof)?;
        Some(AnatomicalAngle { dof, coordinate, ..angle.clone() })
    });
    let angles = angles.collect();
    let by_name = links.iter().enumerate().map(|(i, link)| (link.name.clone(), i)).collect();
    let followers = followers(&links, &layout);
    let (name, stature, gravity) = (full.name.clone(), full.stature, full.gravity);
    Figure { name, links, layout, angles, followers, by_name, stature, gravity }
}

/// The links of the small figure, as far as they are there.
struct Small<'a> {
    full: &'a Figure,
    links: Vec<Link>,
    /// Of the full figure's links.
    places: Vec<LinkPlace>,
    frames: HashSet<String>,
    /// All names of links and joints.
    names: HashSet<String>,
}

impl Small<'_> {
    fn parent(&self, i: usize) -> Option<LinkPlace> {
        self.full.links[i].parent.map(|parent| self.places[parent])
    }

    /// Link `i` as it is.
    fn keep(&mut self, i: usize) {
        let (parent, mut link) = (self.parent(i), self.full.links[i].clone());
        if let Some(LinkPlace { link: parent, placement }) = parent {
            link.parent = Some(parent);
            link.joint.placement = compose(&placement, &link.joint.placement);
        }
        self.places.push(LinkPlace::at(self.links.len()));
        self.links.push(link);
    }

    /// Link `i` with what is left of its joint.
    fn reduce(&mut self, i: usize, at: &JointLayout, held: &[Option<f64>]) {
        let (parent, full) = (self.parent(i), self.full);
        let link = &full.links[i];
        let base = parent.map_or_else(Placement::identity, |parent| parent.placement);
        let placement = compose(&base, &link.joint.placement);
        let Left { parts, mut beyond } = left(&placement, link.joint.kind(), held);
        beyond.rotation.renormalize();
        let names = &full.layout.v_names()[at.v..at.v + at.nv];
        match (parts.is_empty(), parent) {
            (true, Some(LinkPlace { link: carrier, .. })) => {
                let content = moved(link, &beyond, &mut self.frames);
                absorb(&mut self.links[carrier], content, &mut self.frames);
                self.places.push(LinkPlace { link: carrier, placement: beyond });
            }
            // A root that no longer moves stays, welded to the world.
            (true, None) => {
                let joint = Joint::new(link.joint.name()).placed(beyond);
                self.places.push(LinkPlace::at(self.links.len()));
                self.links.push(Link { joint, ..link.clone() });
            }
            (false, _) => {
                let mut parent = parent.map(|parent| parent.link);
                let last = parts.len() - 1;
                for (number, part) in parts.into_iter().enumerate() {
                    let link = if number < last {
                        self.between(link, number + 1, part, names)
                    } else {
                        let joint = joint_of(link.joint.name().to_owned(), part, names);
                        Link { joint, ..moved(link, &beyond, &mut self.frames) }
                    };
                    let index = self.links.len();
                    self.links.push(Link { parent, ..link });
                    parent = Some(index);
                }
                self.places.push(LinkPlace { link: self.links.len() - 1, placement: beyond });
            }
        }
    }

    /// A link without mass, moved by the first degrees of freedom of a joint that is split.
    fn between(&mut self, link: &Link, number: usize, part: Part, names: &[String]) -> Link {
        let (name, joint) = self.unused(&link.name, &link.joint.name, number);
        Link {
            name,
            parent: None,
            joint: joint_of(joint, part, names),
            mass: 0.0,
            com: Vector3::zeros(),
            inertia: Matrix3::zeros(),
            shape: None,
            tip: None,
            sole: Vec::new(),
            frames: Vec::new(),
        }
    }

    /// `link~number` and `joint~number`, or with the next number that neither links nor joints have.
    fn unused(&mut self, link: &str, joint: &str, number: usize) -> (String, String) {
        let mut number = number;
        loop {
            let (link, joint) = (format!("{link}~{number}"), format!("{joint}~{number}"));
            if !self.names.contains(&link) && !self.names.contains(&joint) {
                self.names.extend([link.clone(), joint.clone()]);
                return (link, joint);
            }
            number += 1;
        }
    }
}

/// The joint of a part, its degrees of freedom called as before.
fn joint_of(name: String, part: Part, full_names: &[String]) -> Joint {
    let Part { placement, dofs, indices } = part;
    let mut joint = Joint { kind: JointKind::Axes(dofs), ..Joint::new(name).placed(placement) };
    name_dofs(&mut joint, indices.iter().map(|&i| &full_names[i]));
    joint
}

/// Gives the degrees of freedom of a joint of axes these names, where they would not have them by themselves.
pub(crate) fn name_dofs<'a>(joint: &mut Joint, names: impl Iterator<Item = &'a String>) {
    let own = velocity_names(&joint.name, &joint.kind);
    let JointKind::Axes(dofs) = &mut joint.kind else { return };
    for ((dof, own), name) in dofs.iter_mut().zip(own).zip(names) {
        if own != *name {
            dof.name = Some(name.clone());
        }
    }
}
