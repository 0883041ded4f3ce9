//! The distance of joints of three rotations from gimbal lock.

use crate::configuration::ConfigurationError;
use crate::figure::Figure;
use crate::joint::AxisKind;
use nalgebra::{Rotation3, Vector3};

/// The distance of a joint from gimbal lock.
#[doc(alias = "singularity")]
#[doc(alias = "gimbal lock")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GimbalDistance {
    /// Index of the link that the joint moves.
    pub joint: usize,
    /// How far its middle rotation has to turn until the three axes lie in a plane (rad), 0 to π/2.
    pub distance: f64,
}

impl Figure {
    /// The distance to gimbal lock of every joint with exactly three rotations about any axes, among any slides, in the order of
    /// the links.
    ///
    /// With `e₁`, `e₂`, `e₃` the axes as the rotations before them have turned them, the volume `|e₁·(e₂×e₃)|` is 0 in lock. It
    /// depends on the middle angle alone, as the sine of the angle from lock does:
    ///
    /// ```text
    /// |e₁·(e₂×e₃)| = |e₁×e₂|·|e₂×e₃|·sin δ        δ = asin(volume / its greatest value)
    /// ```
    ///
    /// For three rotations about x, y, z in any order `δ = |π/2 − |b||`, for a repeated axis (X-Z-X) `δ = |b|`, with `b` the middle
    /// angle in (−π, π]. Where two axes that follow each other are parallel the joint is in lock everywhere, and `δ = 0`.
    ///
    /// `q` (rad or m) has length `nq`. Ball and free joints are never in lock and have no distance. What velocities and
    /// accelerations do near it: they grow as 1/δ.
    ///
    /// # Errors
    ///
    /// [`ConfigurationError`] for a wrong length, a number that is not finite and a zero quaternion.
    ///
    /// # Examples
    ///
    /// ```
    /// let ann = solaris_model::human(1.75, 73.0)?;
    /// let mut q = vec![0.0; ann.layout().nq()];
    /// q[ann.layout().dof_index("left_hip.ry").expect("a hip twists")] = -1.5;
    /// let hip = ann.joint_index("left_hip");
    /// let distance = ann.gimbal_distances(&q)?.find(|at| Some(at.joint) == hip).expect("three rotations").distance;
    /// assert!((distance - (std::f64::consts::FRAC_PI_2 - 1.5)).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn gimbal_distances<'a>(
        &'a self,
        q: &'a [f64],
    ) -> Result<impl Iterator<Item = GimbalDistance> + 'a, ConfigurationError> {
        self.check_configuration("q", q)?;
        let joints = self.links().iter().zip(self.layout().joints()).enumerate();
        Ok(joints.filter_map(|(joint, (link, at))| {
            let dofs = link.joint().kind().axes().iter().zip(&q[at.q..]);
            let mut turns = dofs.filter(|(dof, _)| dof.axis.kind == AxisKind::Rotation);
            let (first, (second, angle), third) = (turns.next()?, turns.next()?, turns.next()?);
            let axes = [first.0, second, third.0].map(|dof| dof.axis.direction);
            turns.next().is_none().then(|| GimbalDistance { joint, distance: distance(&axes, *angle) })
        }))
    }
}

/// `δ` for the axes of three rotations, each in the frame that those before it have turned, at the middle `angle` (rad).
fn distance(axes: &[Vector3<f64>; 3], angle: f64) -> f64 {
    let [e1, e2, e3] = axes;
    let across = [e1.cross(e2), e2.cross(e3)];
    // Unit axes that were meant to be parallel are so to rounding.
    if across.iter().any(|across| across.norm() < 1e-12) {
        return 0.0;
    }
    // e₁·(e₂×e₃), and the same a quarter turn of the middle rotation further: sin δ and cos δ, to one factor.
    let normal = Rotation3::new(e2 * angle) * across[1];
    e1.dot(&normal).abs().atan2(e1.dot(&e2.cross(&normal)).abs())
}
