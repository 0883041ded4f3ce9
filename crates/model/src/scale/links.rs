//! Links with scaled lengths and masses.

use super::contents::contents;
use crate::figure::Figure;
use crate::joint::{AxisKind, Follow, Joint, JointKind};
use crate::link::Link;
use nalgebra::Vector3;

/// Of every link the distance from its joint to the farthest joint of its children, or else to its tip (m).
pub(super) fn reaches(figure: &Figure) -> Vec<Option<f64>> {
    let mut reaches = vec![0.0_f64; figure.links.len()];
    for link in &figure.links {
        if let Some(parent) = link.parent {
            reaches[parent] = reaches[parent].max(link.joint.placement.translation.vector.norm());
        }
    }
    let or_tip = |(reach, link): (f64, &Link)| {
        let reach = if reach > 0.0 { reach } else { link.tip.map_or(0.0, |tip| tip.norm()) };
        Some(reach).filter(|reach| *reach > 0.0)
    };
    reaches.into_iter().zip(&figure.links).map(or_tip).collect()
}

/// The links with their lengths times `lengths`, and the given masses; `root` is the factor of what the world carries.
pub(super) fn scaled(figure: &Figure, root: f64, lengths: &[f64], masses: &[f64]) -> Vec<Link> {
    let carrier = |link: usize| figure.links[link].parent.map_or(root, |parent| lengths[parent]);
    let mut links = figure.links.clone();
    for (i, link) in links.iter_mut().enumerate() {
        contents(link, &Vector3::repeat(lengths[i]), masses[i]);
        joint(&mut link.joint, carrier(i));
    }
    // What a leader that slides measures is scaled as well.
    let mut leaders = figure.followers.iter().map(|follower| {
        let link = figure.layout.joints().partition_point(|at| at.v + at.nv <= follower.leader);
        let leader = &figure.links[link].joint.kind.axes()[follower.leader - figure.layout.joints()[link].v];
        if leader.axis.kind == AxisKind::Translation { carrier(link) } else { 1.0 }
    });
    for (i, link) in links.iter_mut().enumerate() {
        let JointKind::Axes(dofs) = &mut link.joint.kind else { continue };
        for dof in dofs {
            let Some(Follow { curve, .. }) = &mut dof.follows else { continue };
            let slides = dof.axis.kind == AxisKind::Translation;
            *curve = curve.scaled(if slides { carrier(i) } else { 1.0 });
            curve.stretch(leaders.next().unwrap_or(1.0));
        }
    }
    links
}

/// Where the joint sits on a link scaled by `s`, and what its slides measure there.
fn joint(joint: &mut Joint, s: f64) {
    joint.placement.translation.vector *= s;
    let JointKind::Axes(dofs) = &mut joint.kind else { return };
    for dof in dofs.iter_mut().filter(|dof| dof.axis.kind == AxisKind::Translation) {
        if let Some(limits) = &mut dof.limits {
            limits.lower *= s;
            limits.upper *= s;
        }
        dof.passive.rest *= s;
    }
}

/// Whether all of the link's numbers are finite, and its shape has some size.
pub(super) fn is_finite(link: &Link) -> bool {
    let placements =
        [&link.joint.placement].into_iter().chain(link.frames.iter().map(|frame| &frame.placement));
    let mut vectors = placements
        .chain(link.shape.iter().map(|shape| &shape.placement))
        .map(|placement| &placement.translation.vector)
        .chain([&link.com])
        .chain(&link.tip)
        .chain(link.sole.iter().map(|point| &point.position));
    let dofs = link.joint.kind.axes();
    link.mass.is_finite()
        && link.inertia.iter().all(|x| x.is_finite())
        && vectors.all(|vector| vector.iter().all(|x| x.is_finite()))
        && link.shape.iter().flat_map(|shape| shape.kind.lengths()).all(|(_, x)| x > 0.0 && x.is_finite())
        && dofs.iter().all(|dof| {
            dof.passive.rest.is_finite()
                && dof.limits.is_none_or(|limits| !limits.lower.is_nan() && !limits.upper.is_nan())
                && dof.follows.as_ref().is_none_or(|follow| follow.curve.fault().is_none())
        })
}
