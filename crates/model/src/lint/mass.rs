//! Masses that no matter has: inertias that no distribution of mass gives, joints that move nothing.

use super::{digits, suspect};
use crate::figure::Figure;
use crate::fuse::carried::Matter;
use crate::inertia::second_moments;
use crate::link::Link;
use solaris_text::Finding;

/// How far below zero a second moment may be, of the greatest entry of its inertia: six printed digits leave as much.
pub(super) const PRINTED: f64 = 1e-5;
/// The most links that are named.
const NAMED: usize = 10;

/// What nothing that moves can weigh.
///
/// Inverse dynamics takes such numbers as they are. What solves for accelerations needs a positive mass matrix, which they
/// may or may not give.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MassDoubt {
    /// A link's inertia is that of no mass distribution.
    NotPhysical {
        /// The link, with all that is welded to it.
        link: String,
        /// Along which its second moment is negative, in the link's axes.
        axis: [f64; 3],
        /// `½ tr(I) − aᵀ·I·a` along this axis (kg m²).
        moment: f64,
        /// Its size by that of the inertia's greatest entry.
        relative: f64,
    },
    /// A link has rotational inertia and no mass.
    WithoutMass {
        /// The link, with all that is welded to it.
        link: String,
        /// The greatest entry of its inertia (kg m²).
        inertia: f64,
    },
    /// A joint moves neither mass nor inertia.
    MovesNothing {
        /// The joint.
        joint: String,
        /// All links that it moves.
        links: Vec<String>,
    },
}

impl MassDoubt {
    /// The link or joint that it is about.
    pub fn subject(&self) -> &str {
        match self {
            Self::NotPhysical { link, .. } | Self::WithoutMass { link, .. } => link,
            Self::MovesNothing { joint, .. } => joint,
        }
    }

    /// The same as a finding.
    pub fn finding(&self) -> Finding {
        suspect(self.subject(), self.message())
    }

    fn message(&self) -> String {
        match self {
            Self::NotPhysical { axis: [x, y, z], moment, relative, .. } => format!(
                "its inertia is not that of any mass distribution: its second moment along ({x:.3}, {y:.3}, {z:.3}) is {} kg m², \
                 {} % of the inertia (the sum of the other two principal moments is less than the one about this axis); \
                 inverse dynamics takes it as it is, forward dynamics needs a positive mass matrix: check units, the \
                 point of reference (the centre of mass) and the signs of the products",
                digits(*moment, 4),
                digits(relative * 100.0, 2)
            ),
            Self::WithoutMass { inertia, .. } => format!(
                "it has a rotational inertia of {} kg m² and no mass; inverse dynamics takes it as it is, forward dynamics \
                 needs a positive mass matrix: give it mass or drop the inertia",
                digits(*inertia, 4)
            ),
            Self::MovesNothing { links, .. } => format!(
                "it moves {}, which {} no mass: inverse dynamics finds no force for it but that of its springs and \
                 dampers, forward dynamics needs mass there, an armature, or the joint welded or driven by a motion",
                named(links),
                if links.len() == 1 { "has" } else { "together have" }
            ),
        }
    }
}

impl Figure {
    /// What of the figure's masses no matter can have; empty where all is as it must be.
    ///
    /// What moves is judged: a link with all that is welded to it, since only their sum acts on a joint. What is welded
    /// to the world is not, nor a joint whose free degrees of freedom have an armature. Numbers printed with six digits
    /// count as what they were printed from.
    ///
    /// Links come first, in order, then joints; of joints in each other that all move nothing the first is told.
    #[doc(alias = "validate")]
    pub fn mass_doubts(&self) -> Vec<MassDoubt> {
        let matter = moving_matter(self);
        let links = self.links.iter().zip(&matter).filter_map(|(link, matter)| doubt(link, matter.as_ref()?));
        links.chain(idle_joints(self, &matter)).collect()
    }
}

/// Of each link that moves, its matter with that of all that is welded to it.
fn moving_matter(figure: &Figure) -> Vec<Option<Matter>> {
    let mut matter: Vec<Option<Matter>> = figure.links.iter().map(|link| Some(Matter::of(link))).collect();
    for (i, link) in figure.links.iter().enumerate().rev() {
        if link.joint.kind().nv() > 0 {
            continue;
        }
        let own = matter[i].take();
        let carrier = link.parent.and_then(|parent| matter[parent].as_mut());
        if let (Some(carrier), Some(own)) = (carrier, own) {
            *carrier = carrier.with(&own.placed(link.joint.placement()));
        }
    }
    matter
}

fn doubt(link: &Link, matter: &Matter) -> Option<MassDoubt> {
    let scale = matter.inertia.amax();
    if matter.mass == 0.0 && scale > 0.0 {
        return Some(MassDoubt::WithoutMass { link: link.name.clone(), inertia: scale });
    }
    let (values, axes) = second_moments(&matter.inertia);
    let least = values.imin();
    let (moment, axis) = (values[least], axes.column(least));
    (moment < -PRINTED * scale).then(|| MassDoubt::NotPhysical {
        link: link.name.clone(),
        axis: [axis[0], axis[1], axis[2]],
        moment,
        relative: -moment / scale,
    })
}

/// The joints that oppose nothing to a force: of such that hang on each other, the one nearest to the root, with all links
/// that it moves.
fn idle_joints(figure: &Figure, matter: &[Option<Matter>]) -> Vec<MassDoubt> {
    let links = &figure.links;
    let mut moves_matter: Vec<bool> =
        matter.iter().map(|own| own.is_some_and(|own| own.mass > 0.0 || own.inertia.amax() > 0.0)).collect();
    for (i, link) in links.iter().enumerate().rev() {
        if let Some(parent) = link.parent {
            moves_matter[parent] |= moves_matter[i];
        }
    }
    let mut groups: Vec<(usize, Vec<String>)> = Vec::new();
    let mut group_of: Vec<Option<usize>> = vec![None; links.len()];
    for (i, link) in links.iter().enumerate() {
        group_of[i] = link.parent.and_then(|parent| group_of[parent]);
        let joint_of_group = group_of[i].map(|group| groups[group].0);
        if joint_of_group.is_none() && !moves_matter[i] && gives_way(link) {
            group_of[i] = Some(groups.len());
            groups.push((i, Vec::new()));
        }
        if let Some(group) = group_of[i] {
            groups[group].1.push(link.name.clone());
        }
    }
    let doubts = groups.into_iter();
    doubts
        .map(|(i, moved)| MassDoubt::MovesNothing { joint: links[i].joint.name().to_owned(), links: moved })
        .collect()
}

/// Whether a joint has a degree of freedom that is free and has no inertia of its own.
fn gives_way(link: &Link) -> bool {
    let kind = link.joint.kind();
    (0..kind.nv()).any(|k| {
        let follows = kind.axes().get(k).is_some_and(|dof| dof.follows.is_some());
        !follows && kind.armature(k) <= 0.0
    })
}

fn named(links: &[String]) -> String {
    let names: Vec<String> = links.iter().take(NAMED).map(|name| format!("'{name}'")).collect();
    let more = match links.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let what = if links.len() == 1 { "link" } else { "links" };
    format!("{what} {}{more}", names.join(", "))
}
