//! The links of a re-rooted figure.

use super::reverse::reversed;
use super::{JointInView, RerootError, Rerooted};
use crate::anatomy::AnatomicalAngle;
use crate::figure::Figure;
use crate::follower::followers;
use crate::fuse::LinkPlace;
use crate::fuse::carried::{compose, frame_names, moved};
use crate::joint::{Joint, JointKind, Placement};
use crate::layout::StateLayout;
use crate::link::Link;
use nalgebra::Vector3;
use std::collections::HashSet;

/// The figure on its link `root`, whose point `origin` (in the link's frame) becomes the origin.
pub(super) fn rerooted(figure: &Figure, root: usize, origin: &Vector3<f64>) -> Result<Rerooted, RerootError> {
    let path: Vec<usize> = std::iter::successors(Some(root), |&link| figure.links[link].parent).collect();
    check(figure, &path)?;
    let links = order(figure, &path);
    let mut index = vec![0; links.len()];
    links.iter().enumerate().for_each(|(i, &link)| index[link] = i);
    let places = places(figure, &path, origin, &index);
    let view = View { figure, path: &path, places: &places };
    let mut frames = frame_names(&figure.links);
    let mut joints = vec![None; links.len()];
    let mut built: Vec<Link> = Vec::with_capacity(links.len());
    for (i, &link) in links.iter().enumerate() {
        let (parent, joint, source) = view.joint(link);
        if let Some((of, reversed)) = source {
            joints[of] = Some(JointInView { link: i, reversed });
        }
        let content = moved(&figure.links[link], &places[link].placement, &mut frames);
        built.push(Link { parent: parent.map(|parent| index[parent]), joint, ..content });
    }
    let figure = with_links(figure, built, &joints);
    Ok(Rerooted { figure, links: places, joints, path })
}

/// The path, then the other links in their order: parents first.
fn order(figure: &Figure, path: &[usize]) -> Vec<usize> {
    let on_path: HashSet<usize> = path.iter().copied().collect();
    path.iter().copied().chain((0..figure.links.len()).filter(|link| !on_path.contains(link))).collect()
}

/// Where the declared frames stand in those of the view.
fn places(figure: &Figure, path: &[usize], origin: &Vector3<f64>, index: &[usize]) -> Vec<LinkPlace> {
    let mut places: Vec<LinkPlace> = index.iter().map(|&link| LinkPlace::at(link)).collect();
    places[path[0]].placement.translation = (-origin).into();
    for pair in path.windows(2) {
        // What was the parent has the frame in which the joint was placed.
        places[pair[1]].placement = figure.links[pair[0]].joint.placement.inverse();
    }
    places
}

/// What the joints of the view are found from.
struct View<'a> {
    figure: &'a Figure,
    path: &'a [usize],
    places: &'a [LinkPlace],
}

/// A link's parent, its joint, and the declared link of that joint with whether it is turned round.
type Moving = (Option<usize>, Joint, Option<(usize, bool)>);

impl View<'_> {
    fn joint(&self, link: usize) -> Moving {
        let links = &self.figure.links;
        match self.path.iter().position(|&on_path| on_path == link) {
            Some(0) => (None, Joint::free(self.root_name()), None),
            Some(at) => {
                let before = self.path[at - 1];
                let layout = &self.figure.layout;
                let dofs = layout.joints()[before];
                let names = &layout.v_names()[dofs.v..dofs.v + dofs.nv];
                let joint = reversed(&links[before].joint, self.places[before].placement, names);
                (Some(before), joint, Some((before, true)))
            }
            None => {
                let parent = links[link].parent;
                let place = parent.map_or_else(Placement::identity, |parent| self.places[parent].placement);
                let joint = links[link].joint.clone();
                let placement = compose(&place, &joint.placement);
                (parent, joint.placed(placement), Some((link, false)))
            }
        }
    }

    /// `world~LINK`, with more of `~` where a joint has that name.
    fn root_name(&self) -> String {
        let mut name = format!("world~{}", self.figure.links[self.path[0]].name);
        while self.figure.links.iter().any(|link| link.joint.name == name) {
            name.push('~');
        }
        name
    }
}

/// The figure of these links, with the angles whose degree of freedom is still there.
fn with_links(declared: &Figure, links: Vec<Link>, joints: &[Option<JointInView>]) -> Figure {
    let layout = StateLayout::of(&links);
    let angle = |angle: &AnatomicalAngle| {
        let name = &declared.layout.v_names()[angle.dof];
        let link =
            declared.layout.joints().iter().position(|at| (at.v..at.v + at.nv).contains(&angle.dof))?;
        joints[link]?;
        let dof = layout.dof_index(name)?;
        let coordinate = layout.coordinate(dof)?;
        Some(AnatomicalAngle { dof, coordinate, ..angle.clone() })
    };
    let angles = declared.angles.iter().filter_map(angle).collect();
    let by_name = links.iter().enumerate().map(|(i, link)| (link.name.clone(), i)).collect();
    let followers = followers(&links, &layout);
    Figure {
        name: declared.name.clone(),
        links,
        layout,
        angles,
        followers,
        by_name,
        stature: declared.stature,
        gravity: declared.gravity,
    }
}

/// Refuses joints that cannot be turned round.
fn check(figure: &Figure, path: &[usize]) -> Result<(), RerootError> {
    let root = figure.links[path[0]].name.clone();
    if figure.mass() <= 0.0 {
        return Err(RerootError::Massless { joint: format!("world~{root}"), root });
    }
    // Without its leader a follower would be free.
    let of_root = figure.layout.joints()[0].nv;
    if let Some(tied) = figure.followers.iter().find(|tied| tied.dof.min(tied.leader) < of_root) {
        let [dof, leader] = [tied.dof, tied.leader].map(|dof| figure.layout.v_names()[dof].clone());
        return Err(RerootError::Follower { dof, leader, root });
    }
    // A link with mass is moved by the joint that is turned round unless it hangs on that joint.
    let mut hanging = vec![false; figure.links.len()];
    for &link in &path[..path.len() - 1] {
        let joint = &figure.links[link].joint;
        if matches!(joint.kind, JointKind::Free { armature, .. } if armature != 0.0) {
            return Err(RerootError::FreeArmature { joint: joint.name.clone(), root });
        }
        hanging[link] = true;
        for (i, other) in figure.links.iter().enumerate() {
            hanging[i] |= other.parent.is_some_and(|parent| hanging[parent]);
        }
        let moves_mass = figure.links.iter().zip(&hanging).any(|(link, hanging)| !hanging && link.mass > 0.0);
        if joint.kind.nv() > 0 && !moves_mass {
            return Err(RerootError::Massless { joint: joint.name.clone(), root });
        }
    }
    Ok(())
}
