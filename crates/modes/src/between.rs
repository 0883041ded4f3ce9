//! What links do to each other: where they touch, and where they are held together.

use nalgebra::Vector3;
use solaris_dynamics::Wrench;

/// What one link does to another, or the world to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Between {
    /// In the full figure; none for the world.
    pub(crate) links: [Option<usize>; 2],
    /// Where it acts on each, in the world (m).
    pub(crate) points: [Vector3<f64>; 2],
    /// On the first link (N), and the opposite on the second.
    pub(crate) force: Vector3<f64>,
    /// Besides, on the first link (N m).
    pub(crate) moment: Vector3<f64>,
    pub(crate) kind: Kind,
}

/// By what.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Kind {
    /// They touch, `gap` (m) apart, negative where they overlap.
    Touch {
        /// How far.
        gap: f64,
    },
    /// They are held together by a loop of the simulation.
    Loop {
        /// Which.
        index: usize,
        /// How far apart the points are (m).
        apart: f64,
    },
}

impl Between {
    /// What acts on each of two links, by these indices of them: wrenches about the world's origin.
    pub(crate) fn wrenches<L: Copy>(&self, links: [Option<L>; 2]) -> impl Iterator<Item = (L, Wrench<f64>)> {
        let both = [(self.force, self.moment), (-self.force, -self.moment)];
        let on = both.into_iter().zip(self.points).map(|((force, moment), point)| Wrench::at(&point, force, moment));
        links.into_iter().zip(on).filter_map(|(link, wrench)| Some((link?, wrench)))
    }
}
