//! Named anatomical angles beside the raw degrees of freedom.

/// An anatomical angle: a degree of freedom with the sign that anatomists give it.
///
/// Flexion, abduction and internal rotation are positive, on both sides of the body; so are dorsiflexion of the ankle,
/// extension of the toes, forward flexion and side bend and rotation to the left of the trunk, anterior tilt, elevation
/// of the left side and forward rotation of the left side of the pelvis. `angle = sign · q[coordinate]`; moments and velocities
/// take the same sign.
#[doc(alias = "flexion")]
#[doc(alias = "abduction")]
#[doc(alias = "joint angle")]
#[derive(Clone, Debug, PartialEq)]
pub struct AnatomicalAngle {
    /// Its name, such as `left_knee.flexion`.
    pub name: String,
    /// Index of the degree of freedom in `v`.
    pub dof: usize,
    /// Index of its coordinate in `q`.
    pub coordinate: usize,
    /// +1 or −1.
    pub sign: f64,
}
