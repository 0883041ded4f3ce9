//! The joint that is left when some of its degrees of freedom are locked.

use crate::joint::{Axis, AxisKind, Dof, JointKind, Placement};
use nalgebra::{Quaternion, Translation3, Unit, UnitQuaternion, Vector3};

/// A joint without the degrees of freedom that stand still.
pub(super) struct Left {
    /// What still moves, from the parent outwards; more than one where the joint has to be split.
    pub(super) parts: Vec<Part>,
    /// Where the link's frame stands in the last part's moved frame; without parts, in the parent's frame.
    pub(super) beyond: Placement,
}

/// Some of a joint's degrees of freedom, with what stands still before them.
pub(super) struct Part {
    pub(super) placement: Placement,
    pub(super) dofs: Vec<Dof>,
    /// Which of the joint's degrees of freedom they are.
    pub(super) indices: Vec<usize>,
}

/// What is left of a joint at `placement` when those of its coordinates that have a value are held there.
///
/// Ball and free joints are held as a whole.
pub(super) fn left(placement: &Placement, kind: &JointKind, held: &[Option<f64>]) -> Left {
    let value = |i: usize| held[i].unwrap_or_default();
    match kind {
        JointKind::Axes(dofs) => left_of_axes(placement, dofs, held),
        JointKind::Ball { .. } => {
            let turn = rotation([0, 1, 2, 3].map(value));
            Left { parts: Vec::new(), beyond: placement * turn }
        }
        JointKind::Free { .. } => {
            let pose = Placement::from_parts(
                Translation3::new(value(0), value(1), value(2)),
                rotation([3, 4, 5, 6].map(value)),
            );
            Left { parts: Vec::new(), beyond: placement * pose }
        }
    }
}

fn rotation([x, y, z, w]: [f64; 4]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z))
}

/// From the outermost degree of freedom inwards, collects in `still` what stands still and takes it to the left past what
/// moves:
///
/// ```text
/// E(e, q)·C = C·E(Cᵀ·e, q)
/// ```
///
/// holds for every slide, and for a turn whose axis is not displaced by `C`. Otherwise the displacement goes to the right,
/// past slides as far as the link; past turns it cannot go, and the joint is split.
fn left_of_axes(placement: &Placement, dofs: &[Dof], held: &[Option<f64>]) -> Left {
    // From the outside inwards; turned round at the end.
    let mut parts: Vec<Part> = Vec::new();
    let (mut still, mut beyond) = (Placement::identity(), Placement::identity());
    let mut open = Part { placement: Placement::identity(), dofs: Vec::new(), indices: Vec::new() };
    for (index, (dof, held)) in dofs.iter().zip(held).enumerate().rev() {
        if let Some(value) = held {
            still = displacement(&dof.axis, *value) * still;
            continue;
        }
        let (kind, axis) = (dof.axis.kind, dof.axis.direction);
        if kind == AxisKind::Rotation && displaces(&still, &axis) {
            // A split leaves a turn in the open part, so that only the link itself can be beyond these slides.
            if open.dofs.iter().all(|dof| dof.axis.kind == AxisKind::Translation) {
                let passed = still.rotation.inverse() * still.translation.vector;
                beyond.translation.vector += passed;
                still.translation = Translation3::identity();
            } else {
                let empty = Part { placement: Placement::identity(), dofs: Vec::new(), indices: Vec::new() };
                let closed = std::mem::replace(&mut open, empty);
                parts.push(Part { placement: still, ..closed });
                still = Placement::identity();
            }
        }
        let axis = Axis { kind, direction: turned(&still.rotation.inverse(), axis) };
        open.dofs.push(Dof { axis, ..dof.clone() });
        open.indices.push(index);
    }
    let first = placement * still;
    if open.dofs.is_empty() {
        return Left { parts, beyond: first };
    }
    parts.push(Part { placement: first, ..open });
    parts.reverse();
    for part in &mut parts {
        part.placement.rotation.renormalize();
        part.dofs.reverse();
        part.indices.reverse();
    }
    Left { parts, beyond }
}

/// What a degree of freedom does at `value`.
fn displacement(axis: &Axis, value: f64) -> Placement {
    match axis.kind {
        AxisKind::Rotation => {
            let turn = UnitQuaternion::from_axis_angle(&Unit::new_unchecked(axis.direction), value);
            Placement::from_parts(Translation3::identity(), turn)
        }
        AxisKind::Translation => {
            Placement::from_parts((axis.direction * value).into(), UnitQuaternion::identity())
        }
    }
}

/// Whether `still` moves something away from an axis, by more than rounding.
fn displaces(still: &Placement, axis: &Vector3<f64>) -> bool {
    let by = still.translation.vector;
    axis.cross(&by).norm() > 2.0 * f64::EPSILON * by.norm()
}

/// A unit vector turned; what is a coordinate axis but for rounding becomes one.
fn turned(turn: &UnitQuaternion<f64>, axis: Vector3<f64>) -> Vector3<f64> {
    if *turn == UnitQuaternion::identity() {
        return axis;
    }
    (turn * axis).map(|x| if x.abs() < 2.0 * f64::EPSILON { 0.0 } else { x }).normalize()
}
