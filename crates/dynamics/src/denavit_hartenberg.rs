//! Denavit-Hartenberg frames of any figure, in the standard (distal) form: degree of freedom i turns about, or slides
//! along, the z axis of the frame before its own.
//!
//! Every degree of freedom gets a *rationalised link*, a body of its own with one frame. α and θ⁰ are derived from the axes,
//! never typed in, and z always points along the degree of freedom's own axis, so that its coordinate enters with +1.
//!
//! ```text
//! X_PL = B·A(q)        A(q) = Rz(θ⁰ + q)·T(a, 0, s)·Rx(α)   for a turn, with s + q in place of s for a slide
//! ```
//!
//! with `X_PL` from the rationalised link's frame L to the frame P of the one before it. A frame has **one** z axis, so it
//! serves the axis of one child; the constant `B` moves z onto the axis of any other, and from the world onto the axes of
//! the root. Everything is linear in the number of degrees of freedom.

mod derive;
mod rule;
mod step;
mod summary;
mod tables;

pub use rule::{Row, rows};
pub use summary::Summary;
pub use tables::{about_fixed_axes, heterogeneous, homogeneous};

use crate::error::DynamicsError;
use crate::workspace::{check, check_quaternion};
use nalgebra::{IsometryMatrix3, Quaternion, Rotation3, Translation3, UnitQuaternion, Vector3};
use solaris_model::Figure;

/// The rationalised links of a figure.
///
/// There is one for each entry of `v`, in the same order, so that rationalised link k is moved by degree of freedom k.
#[doc(alias = "DH")]
#[doc(alias = "DH parameters")]
#[derive(Clone, Debug)]
pub struct DenavitHartenberg {
    /// The rationalised links, parents first.
    pub links: Vec<Rationalized>,
    /// Links of the figure that nothing moves: welded to the world, directly or through each other.
    pub grounded: Vec<Carried>,
    nq: usize,
    q_names: Vec<String>,
    v_names: Vec<String>,
    link_names: Vec<String>,
}

/// One degree of freedom with the frame behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Rationalized {
    /// Index of the rationalised link before it, always smaller than its own; `None` after the world.
    pub parent: Option<usize>,
    /// Index of the figure's link whose joint it belongs to.
    pub joint: usize,
    /// Index in `q` of its coordinate. `None` for those of ball and free joints, whose `q` is in their base: their
    /// coordinate is zero at every configuration and only its rates differ from zero.
    pub coordinate: Option<usize>,
    /// Whether it slides; otherwise it turns.
    pub slides: bool,
    /// What stands between the frame before and the axis.
    pub base: Base,
    /// α: angle from z of the frame before (after the base) to z of this frame, about x of this frame (rad).
    pub alpha: f64,
    /// θ⁰: angle from x of the frame before (after the base) to x of this frame, about z of the frame before, at zero (rad).
    pub theta: f64,
    /// a: distance of the two origins along x of this frame (m). x has a sense of its own, so a has a sign.
    pub a: f64,
    /// s⁰: distance of the two origins along z of the frame before, at zero (m).
    pub s: f64,
    /// The figure's links that move with this frame, with their mass: on the last rationalised link of a joint the
    /// joint's own link first, then those welded to it; on the others none.
    pub carried: Vec<Carried>,
}

/// A link of the figure on a rationalised link's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Carried {
    /// Index of the figure's link.
    pub link: usize,
    /// Where the link's frame stands in the Denavit-Hartenberg frame (or in the world), always.
    pub placement: IsometryMatrix3<f64>,
}

/// The transform between a frame and the axis of the degree of freedom after it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Base {
    /// Nothing: z of the frame before is the axis.
    Identity,
    /// A constant that moves z onto the axis.
    Constant(IsometryMatrix3<f64>),
    /// The motion of a ball or free joint: `before · X(q) · after`, with `X` the joint's turn and translation. The three
    /// (six) rationalised links after it are turns about (slides along, then turns about) the link's own x, y, z and
    /// stay at zero, so that their rates are the joint's `v`.
    Moved {
        /// Where the joint's frame stands in the frame before.
        before: IsometryMatrix3<f64>,
        /// Index in `q` of the joint's unit quaternion (x, y, z, w).
        quaternion: usize,
        /// Index in `q` of the link's origin in the joint's frame (m); `None` for a ball joint.
        position: Option<usize>,
        /// The first axis in the link's frame.
        after: IsometryMatrix3<f64>,
    },
}

impl Base {
    /// The transform `B` at `q`, which has length `nq` and unit quaternions (up to rounding).
    pub fn at(&self, q: &[f64]) -> IsometryMatrix3<f64> {
        match self {
            Self::Identity => IsometryMatrix3::identity(),
            Self::Constant(base) => *base,
            Self::Moved { before, quaternion, position, after } => {
                let turn = &q[*quaternion..][..4];
                let turn = UnitQuaternion::new_normalize(Quaternion::new(turn[3], turn[0], turn[1], turn[2]));
                let origin =
                    position.map_or_else(Vector3::zeros, |at| Vector3::from_column_slice(&q[at..][..3]));
                before
                    * IsometryMatrix3::from_parts(Translation3::from(origin), turn.to_rotation_matrix())
                    * after
            }
        }
    }
}

impl Rationalized {
    /// The transform `A` from this frame to the one before it (after the base).
    ///
    /// ```text
    ///     | cθ  −sθ·cα   sθ·sα  a·cθ |
    /// A = | sθ   cθ·cα  −cθ·sα  a·sθ |       θ = θ⁰ + q for a turn, s = s⁰ + q for a slide
    ///     |  0      sα      cα     s |
    ///     |  0       0       0     1 |
    /// ```
    ///
    /// `q` is the coordinate of the degree of freedom (rad or m).
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), §3.2, eq. (3.1). The thesis orders coordinates (1 x y z)ᵀ; here they are (x y z 1)ᵀ, so its
    /// row and column 0 are row and column 3.
    pub fn transform(&self, q: f64) -> IsometryMatrix3<f64> {
        let (theta, s) = if self.slides { (self.theta, self.s + q) } else { (self.theta + q, self.s) };
        let (st, ct) = exact_sin_cos(theta);
        IsometryMatrix3::from_parts(
            Translation3::new(self.a * ct, self.a * st, s),
            Rotation3::from_matrix_unchecked(Row { alpha: self.alpha, theta }.rotation()),
        )
    }
}

/// Sine and cosine, exactly 0 and ±1 at multiples of 90° (as they are in `f64`).
pub fn exact_sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    if (quarters - quarters.round()).abs() > 0.0 || quarters.abs() > 8.0 {
        return angle.sin_cos();
    }
    match (quarters as i64).rem_euclid(4) {
        0 => (0.0, 1.0),
        1 => (1.0, 0.0),
        2 => (0.0, -1.0),
        _ => (-1.0, 0.0),
    }
}

impl DenavitHartenberg {
    /// The rationalised links of `figure`.
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Joint`] for a kind of joint that is not known.
    pub fn of(figure: &Figure) -> Result<Self, DynamicsError> {
        derive::derive(figure)
    }

    /// Where the frame of every rationalised link stands in the world at `q` (length `nq`): the matrices `W` of the thesis.
    ///
    /// ```text
    /// W_j = W_(j−1)·B_j·A_j        (4.5), with B
    /// ```
    ///
    /// # Errors
    ///
    /// [`DynamicsError`] for a slice of the wrong length, an entry that is not finite or a quaternion that is no rotation.
    #[doc(alias = "forward kinematics")]
    #[doc(alias = "fk")]
    pub fn frames(&self, q: &[f64]) -> Result<Vec<IsometryMatrix3<f64>>, DynamicsError> {
        self.check(q)?;
        let mut frames: Vec<IsometryMatrix3<f64>> = Vec::with_capacity(self.links.len());
        for link in &self.links {
            let before = link.parent.map_or_else(IsometryMatrix3::identity, |parent| frames[parent]);
            let coordinate = link.coordinate.map_or(0.0, |index| q[index]);
            frames.push(before * link.base.at(q) * link.transform(coordinate));
        }
        Ok(frames)
    }

    fn check(&self, q: &[f64]) -> Result<(), DynamicsError> {
        check("q", q, self.nq, |index| self.q_names[index].clone())?;
        for link in &self.links {
            let Base::Moved { quaternion, .. } = link.base else { continue };
            let entries = [0, 1, 2, 3].map(|i| q[quaternion + i]);
            check_quaternion(&entries, || self.q_names[quaternion].clone())?;
        }
        Ok(())
    }

    /// Where the figure's links stand in the world at `q` (length `nq`), by their index.
    ///
    /// # Errors
    ///
    /// As for [`Self::frames`].
    pub fn poses(&self, q: &[f64]) -> Result<Vec<IsometryMatrix3<f64>>, DynamicsError> {
        let frames = self.frames(q)?;
        let mut poses = vec![IsometryMatrix3::identity(); self.link_names.len()];
        for carried in &self.grounded {
            poses[carried.link] = carried.placement;
        }
        for (link, frame) in self.links.iter().zip(&frames) {
            for carried in &link.carried {
                poses[carried.link] = frame * carried.placement;
            }
        }
        Ok(poses)
    }

    /// The rationalised chains, one for each frame that has none after it: the links from the root's first one to that
    /// one, and how many of them an earlier chain has as well. These always stand first.
    pub fn chains(&self) -> Vec<RationalizedChain> {
        let mut is_last = vec![true; self.links.len()];
        self.links.iter().filter_map(|link| link.parent).for_each(|parent| is_last[parent] = false);
        let mut seen = vec![false; self.links.len()];
        let ends = (0..self.links.len()).filter(|k| is_last[*k]);
        ends.map(|end| {
            let mut links: Vec<usize> = std::iter::successors(Some(end), |k| self.links[*k].parent).collect();
            links.reverse();
            let shared = links.iter().filter(|k| std::mem::replace(&mut seen[**k], true)).count();
            RationalizedChain { links, shared }
        })
        .collect()
    }
}

/// A chain of rationalised links without branches.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RationalizedChain {
    /// Their indices, from the root to the end.
    pub links: Vec<usize>,
    /// How many of the first ones belong to an earlier chain.
    pub shared: usize,
}
