//! Reversed joints, which move what was their parent.

use crate::joint::{Axis, Dof, Joint, JointKind, Placement};

/// The joint that moves the parent against the link: its degrees of freedom in the opposite order along opposite axes.
///
/// ```text
/// E(e, q)⁻¹ = E(−e, q)
/// ```
///
/// It starts where the link's frame stands, at `placement` in the frame that carries it now, and ends in the frame in which
/// the joint was placed. `names` are those of its degrees of freedom as declared.
pub(super) fn reversed(joint: &Joint, placement: Placement, names: &[String]) -> Joint {
    let kind = match &joint.kind {
        JointKind::Axes(dofs) => JointKind::Axes(dofs.iter().rev().map(opposite).collect()),
        free_or_ball => free_or_ball.clone(),
    };
    let mut reversed = Joint { kind, ..joint.clone().placed(placement) };
    crate::fuse::name_dofs(&mut reversed, names.iter().rev());
    reversed
}

fn opposite(dof: &Dof) -> Dof {
    // Adding zero takes the sign off a zero.
    let direction = dof.axis.direction.map(|x| 0.0 - x);
    Dof { axis: Axis { direction, ..dof.axis }, ..dof.clone() }
}
