//! Links that touch each other.

#[cfg(not(feature = "collide"))]
mod absent;

use crate::failure::SetupError;
use crate::range::check_not_negative;
#[cfg(not(feature = "collide"))]
pub(crate) use absent::Colliders;
#[cfg(feature = "collide")]
pub(crate) use solaris_collision::Colliders;
#[cfg(feature = "collide")]
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::Figure;

/// Which links of a figure, or of several, touch each other, and how rough they are.
///
/// Their shapes are convex: boxes, cylinders, capsules, spheres, ellipsoids. What touches does not pass through, slides by Coulomb's
/// law and does not bounce: [`Method::Impulses`](crate::Method::Impulses) alone knows it.
#[doc(alias = "self-collision")]
#[doc(alias = "self_contact")]
#[derive(Clone, Debug, PartialEq)]
pub struct Collisions {
    /// Pairs of links that can touch: [`Collisions::of`] has all of a figure.
    pub pairs: Vec<[usize; 2]>,
    /// `μ`, the coefficient of friction of all of them.
    pub friction: f64,
}

impl Collisions {
    /// All pairs of links of a figure that can come to each other: [`Figure::pairs_apart`], but for those that overlap with every
    /// joint at zero, as shapes about a joint do. What flies about by itself, with three slides or a free joint between it and the
    /// other, may begin anywhere, and is not left out for that.
    ///
    /// # Errors
    ///
    /// [`SetupError::CollisionsNotBuiltIn`] without this crate's feature `collide`, [`SetupError::Dynamics`] for figures that the kernel
    /// does not know.
    pub fn of(figure: &Figure, friction: f64) -> Result<Self, SetupError> {
        let mut pairs = figure.pairs_apart();
        let overlapping = overlapping(figure, &pairs)?;
        let mut index = 0;
        pairs.retain(|pair| {
            index += 1;
            !overlapping[index - 1] || figure.fly_apart(*pair)
        });
        Ok(Self { pairs, friction })
    }

    pub(crate) fn check(&self, figure: &Figure) -> Result<(), SetupError> {
        check_not_negative(|| "the friction of collisions".to_owned(), self.friction)?;
        colliders(figure, &self.pairs).map(|_| ())
    }
}

/// The shapes of pairs of links.
#[cfg(feature = "collide")]
fn colliders(figure: &Figure, pairs: &[[usize; 2]]) -> Result<Colliders, SetupError> {
    Ok(Colliders::of(figure, pairs)?)
}

#[cfg(not(feature = "collide"))]
fn colliders(_: &Figure, _: &[[usize; 2]]) -> Result<Colliders, SetupError> {
    Err(SetupError::CollisionsNotBuiltIn)
}

/// Which pairs overlap with every joint at zero.
#[cfg(feature = "collide")]
fn overlapping(figure: &Figure, pairs: &[[usize; 2]]) -> Result<Vec<bool>, SetupError> {
    let tree = Tree::<f64>::new(figure, nalgebra::Vector3::zeros())?;
    let mut workspace = Workspace::new(&tree);
    let mut q = vec![0.0; tree.nq()];
    // What is refused is a wrong length.
    let _ = figure.neutral(&mut q);
    forward_kinematics(&tree, &mut workspace, &q)?;
    let mut overlapping = vec![false; pairs.len()];
    let pose = |link: usize| placed(workspace.pose(link));
    colliders(figure, pairs)?.touches(pose, |_| 0.0, |touch| overlapping[touch.pair] |= touch.gap < 0.0);
    Ok(overlapping)
}

#[cfg(not(feature = "collide"))]
fn overlapping(_: &Figure, _: &[[usize; 2]]) -> Result<Vec<bool>, SetupError> {
    Err(SetupError::CollisionsNotBuiltIn)
}

/// A pose of the kernel as collisions take it.
pub(crate) fn placed(pose: &solaris_dynamics::Pose<f64>) -> nalgebra::Isometry3<f64> {
    let turn = nalgebra::Rotation3::from_matrix_unchecked(pose.rotation);
    nalgebra::Isometry3::from_parts(pose.translation.into(), nalgebra::UnitQuaternion::from_rotation_matrix(&turn))
}
