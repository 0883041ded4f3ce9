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
    /// By degree of freedom, its coordinate.
    coordinates: Vec<Option<usize>>,
    /// By pair, the degrees of freedom among those that move, which move it.
    moved_by: Vec<Vec<usize>>,
    q: Vec<f64>,
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
        // What carries each link, of the degrees of freedom that move.
        let mut carried: Vec<Vec<usize>> = Vec::with_capacity(figure.links().len());
        for (link, joint) in figure.links().iter().zip(layout.joints()) {
            let mut own = link.parent().map_or_else(Vec::new, |parent| carried[parent].clone());
            own.extend((joint.v..joint.v + joint.nv).filter(|dof| dofs.contains(dof)));
            carried.push(own);
        }
        let moves = |[a, b]: [usize; 2]| {
            let of_one = |one: usize, other: usize| {
                carried[one].iter().copied().filter(|dof| !carried[other].contains(dof)).collect::<Vec<_>>()
            };
            [of_one(a, b), of_one(b, a)].concat()
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
        let coordinates = (0..layout.nv()).map(|dof| layout.coordinate(dof)).collect();
        Ok(Self { tree, workspace, outlines, pairs, coordinates, moved_by, q })
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
        forward_kinematics(&self.tree, &mut self.workspace, q)?;
        self.outlines.place(&self.workspace);
        let measured = self.pairs.iter_mut().enumerate();
        Ok(measured.filter_map(|(i, pair)| Some((i, self.outlines.between(pair, limit)?))).collect())
    }

    /// The distance of a pair (m) in a configuration.
    ///
    /// # Errors
    ///
    /// As for [`nearer`](Self::nearer).
    pub fn distance(&mut self, q: &[f64], pair: usize) -> Result<f64, NearnessError> {
        forward_kinematics(&self.tree, &mut self.workspace, q)?;
        self.outlines.place(&self.workspace);
        Ok(self.outlines.between(&mut self.pairs[pair], f64::INFINITY).unwrap_or(f64::INFINITY))
    }

    /// How the distance of a pair changes with each degree of freedom that [moves](Self::moved_by) it (m/rad, m/m), by differences.
    ///
    /// # Errors
    ///
    /// As for [`nearer`](Self::nearer).
    pub fn slopes(&mut self, q: &[f64], pair: usize) -> Result<Vec<(usize, f64)>, NearnessError> {
        let mut slopes = Vec::with_capacity(self.moved_by[pair].len());
        let mut aside = std::mem::take(&mut self.q);
        aside.copy_from_slice(q);
        for index in 0..self.moved_by[pair].len() {
            let dof = self.moved_by[pair][index];
            let Some(coordinate) = self.coordinates[dof] else { continue };
            let mut at = |by: f64| {
                aside[coordinate] = q[coordinate] + by;
                self.distance(&aside, pair)
            };
            let (after, before) = (at(ASIDE)?, at(-ASIDE)?);
            aside[coordinate] = q[coordinate];
            slopes.push((dof, (after - before) / (2.0 * ASIDE)));
        }
        self.q = aside;
        Ok(slopes)
    }
}
