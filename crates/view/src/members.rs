//! The figures that one is made of: each bears its own weight.

use solaris_model::{Figure, Link, Motion};

/// The parts of what [`Figure::together`] made, or the figure itself.
pub(crate) struct Members {
    names: Vec<String>,
    /// kg.
    masses: Vec<f64>,
    /// Of each link, which it belongs to.
    of: Vec<usize>,
}

impl Members {
    pub(crate) fn of(figure: &Figure) -> Self {
        let links = figure.links();
        // What stands before the first point in the name of a part's root: `ann` of `ann.pelvis`.
        let part = |link: usize| links[link].name().split_once('.').map(|(name, _)| name);
        let parts: Vec<usize> = (1..links.len()).filter(|i| links[*i].parent() == Some(0)).collect();
        let is_world = links[0].joint().kind().nv() == 0 && links[0].mass() <= 0.0;
        let are_several = is_world && parts.len() > 1 && parts.iter().all(|link| part(*link).is_some());
        if !are_several {
            let (names, masses) = (vec![figure.name().to_owned()], vec![figure.mass()]);
            return Self { names, masses, of: vec![0; links.len()] };
        }
        // The world has no mass: whose it is does not matter.
        let mut members = Self { names: Vec::new(), masses: Vec::new(), of: vec![0] };
        for (i, link) in links.iter().enumerate().skip(1) {
            let above = link.parent().filter(|parent| *parent != 0);
            let member = above.map_or(members.names.len(), |parent| members.of[parent]);
            if above.is_none() {
                members.names.push(part(i).unwrap_or_default().to_owned());
                members.masses.push(0.0);
            }
            members.masses[member] += link.mass();
            members.of.push(member);
        }
        members
    }

    /// Whether a link is the root of one of them.
    pub(crate) fn is_root(&self, link: &Link) -> bool {
        link.parent().is_none_or(|parent| self.are_several() && parent == 0)
    }

    pub(crate) fn are_several(&self) -> bool {
        self.names.len() > 1
    }

    pub(crate) fn name(&self, member: usize) -> &str {
        &self.names[member]
    }

    /// Which one a link belongs to.
    pub(crate) fn of_link(&self, link: usize) -> usize {
        self.of[link]
    }

    /// The mass (kg) of one of them.
    pub(crate) fn mass(&self, member: usize) -> f64 {
        self.masses[member]
    }

    /// The weight (N) of one of them under a gravity (m/s²); none without mass or gravity.
    pub(crate) fn weight(&self, member: usize, gravity: f64) -> Option<f64> {
        Some(self.masses[member] * gravity).filter(|weight| *weight > 0.0)
    }

    /// The weight (N) of the heaviest of those that touch something; where none does, of the heaviest.
    pub(crate) fn greatest_weight(&self, figure: &Figure, motion: &Motion) -> Option<f64> {
        let gravity = motion.info.gravity.norm();
        let touching = motion.contacts.iter().filter_map(|track| figure.link_index(&track.link));
        let weights = touching.filter_map(|link| self.weight(self.of_link(link), gravity));
        let all = || (0..self.names.len()).filter_map(|member| self.weight(member, gravity));
        weights.max_by(f64::total_cmp).or_else(|| all().max_by(f64::total_cmp))
    }
}
