//! What keeps the links of a figure apart, in one configuration after another.

use super::NearnessError;
use super::flyers::Flyers;
use super::outlines::{Outlines, Pair};
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::Figure;

/// How far coordinates are moved (rad or m) for the slope of a distance.
const ASIDE: f64 = 1e-5;

/// How near links of a figure come that some degrees of freedom move against each other, and how these take them apart.
///
/// The pairs are those that [`nearness`](super::nearness) measures within what is joined, as it measures them.
#[doc(alias = "collision avoidance")]
pub struct Clearance {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    outlines: Outlines,
    pairs: Vec<Pair>,
    figure: Figure,
    /// By pair, the degrees of freedom among those that move, which move it.
    moved_by: Vec<Vec<usize>>,
    /// A configuration, and room for the velocities of what follows.
    q: Vec<f64>,
    rates: [Vec<f64>; 2],
}

impl Clearance {
    /// That of the links that these degrees of freedom (indices in `v`) move against each other, but for these pairs.
    ///
    /// # Errors
    ///
    /// [`NearnessError`]: what the kernel refuses.
    pub fn new(figure: &Figure, dofs: &[usize], but: &[[usize; 2]]) -> Result<Self, NearnessError> {
        let flyers = Flyers::of(figure, &[]);
        let layout = figure.layout();
        let moves = |pair: [usize; 2]| {
            let mut between = way(figure, pair);
            between.retain(|dof| dofs.contains(dof));
            between
        };
        let is_left_out = |[a, b]: [usize; 2]| but.contains(&[a, b]) || but.contains(&[b, a]);
        let candidates = flyers.groups().flat_map(|links| figure.pairs_apart_among(links));
        let mut pairs: Vec<Pair> = candidates
            .filter(|pair| !figure.fly_apart(*pair) && !is_left_out(*pair) && !moves(*pair).is_empty())
            .map(Pair::new)
            .collect();
        let tree = Tree::new(figure, Vector3::zeros())?;
        let mut workspace = Workspace::new(&tree);
        let mut outlines = Outlines::new(figure, flyers);
        let mut q = vec![0.0; tree.nq()];
        // What is refused is a wrong length.
        let _ = figure.neutral(&mut q);
        forward_kinematics(&tree, &mut workspace, &q)?;
        outlines.place(&workspace);
        pairs.retain_mut(|pair| outlines.between(pair, 0.0).is_none_or(|distance| distance >= 0.0));
        let moved_by = pairs.iter().map(|pair| moves(pair.links)).collect();
        let rates = [vec![0.0; layout.nv()], vec![0.0; layout.nv()]];
        Ok(Self { tree, workspace, outlines, pairs, figure: figure.clone(), moved_by, q, rates })
    }

    /// Leaves out the pairs of which `keep` says no; it is told their links, and all degrees of freedom that move them against each other.
    pub fn retain(&mut self, mut keep: impl FnMut([usize; 2], &[usize]) -> bool) {
        let kept: Vec<bool> =
            self.pairs.iter().map(|pair| keep(pair.links, &way(&self.figure, pair.links))).collect();
        let mut of_pairs = kept.iter();
        self.pairs.retain(|_| of_pairs.next().is_some_and(|keep| *keep));
        let mut of_moved = kept.iter();
        self.moved_by.retain(|_| of_moved.next().is_some_and(|keep| *keep));
    }

    /// Places the links, those that follow others as these say.
    fn place(&mut self, q: &[f64]) -> Result<(), NearnessError> {
        if self.figure.followers().is_empty() {
            forward_kinematics(&self.tree, &mut self.workspace, q)?;
        } else {
            self.q.clear();
            self.q.extend_from_slice(q);
            if q.len() == self.tree.nq() {
                let [v, a] = &mut self.rates;
                self.figure.follow(&mut self.q, v, a);
            }
            forward_kinematics(&self.tree, &mut self.workspace, &self.q)?;
        }
        self.outlines.place(&self.workspace);
        Ok(())
    }

    /// The links of each pair, by index.
    pub fn pairs(&self) -> impl ExactSizeIterator<Item = [usize; 2]> {
        self.pairs.iter().map(|pair| pair.links)
    }

    /// The degrees of freedom that move the links of a pair against each other.
    pub fn moved_by(&self, pair: usize) -> &[usize] {
        &self.moved_by[pair]
    }

    /// The pairs that are nearer than `limit` (m) in a configuration, with their distances (m), negative for the depth of an overlap.
    ///
    /// # Errors
    ///
    /// [`NearnessError`] for a configuration that is none.
    pub fn nearer(&mut self, q: &[f64], limit: f64) -> Result<Vec<(usize, f64)>, NearnessError> {
        self.place(q)?;
        let measured = self.pairs.iter_mut().enumerate();
        Ok(measured.filter_map(|(i, pair)| Some((i, self.outlines.between(pair, limit)?))).collect())
    }

    /// The distance of a pair (m) in a configuration.
    ///
    /// # Errors
    ///
    /// As for [`nearer`](Self::nearer).
    pub fn distance(&mut self, q: &[f64], pair: usize) -> Result<f64, NearnessError> {
        self.place(q)?;
        Ok(self.outlines.between(&mut self.pairs[pair], f64::INFINITY).unwrap_or(f64::INFINITY))
    }

    /// How the distance of a pair changes with each degree of freedom that [moves](Self::moved_by) it (m/rad, m/m), by differences.
    ///
    /// # Errors
    ///
    /// As for [`nearer`](Self::nearer).
    pub fn slopes(&mut self, q: &[f64], pair: usize) -> Result<Vec<(usize, f64)>, NearnessError> {
        let mut slopes = Vec::with_capacity(self.moved_by[pair].len());
        let mut aside = q.to_vec();
        for dof in self.moved_by[pair].clone() {
            // A ball joint has no coordinate to be moved alone; a configuration that is too short is refused where links are placed.
            let Some(coordinate) = self.figure.layout().coordinate(dof).filter(|x| *x < q.len()) else {
                continue;
            };
            let mut at = |by: f64| {
                aside[coordinate] = q[coordinate] + by;
                self.distance(&aside, pair)
            };
            let (after, before) = (at(ASIDE)?, at(-ASIDE)?);
            aside[coordinate] = q[coordinate];
            slopes.push((dof, (after - before) / (2.0 * ASIDE)));
        }
        Ok(slopes)
    }
}

/// The degrees of freedom that move two links against each other: those of all joints on the way from one to the other, or what they follow.
fn way(figure: &Figure, pair: [usize; 2]) -> Vec<usize> {
    let joints = figure.way(pair).map(|link| figure.layout().joints()[link]);
    let leader = |dof: usize| {
        let follower = figure.followers().iter().find(|follower| follower.dof == dof);
        follower.map_or(dof, |follower| follower.leader)
    };
    let mut found: Vec<usize> = joints.flat_map(|joint| joint.v..joint.v + joint.nv).map(leader).collect();
    found.sort_unstable();
    found.dedup();
    found
}
