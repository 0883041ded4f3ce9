//! The joints of a body, as joints of a figure.
//!
//! MuJoCo's joints act in sequence: joint i turns or moves the body's frame about its own anchor `pᵢ` and axis `aᵢ`,
//! which the joints before it have moved,
//!
//! ```text
//! B = P · T₁(q₁ − r₁) ⋯ Tₙ(qₙ − rₙ)        Tᵢ = Trans(pᵢ)·Rot(aᵢ, q)·Trans(−pᵢ)  or  Trans(aᵢ·q)
//! ```
//!
//! with the body's placement `P` in its parent and the coordinates `rᵢ` of that pose. A figure's joint has one centre, so
//! what stands between two turns is moved to where it can be said: fixed turns before the joint, fixed shifts past
//! slides; where that is not possible, a massless link stands between two joints.

use super::joint::{Joint, Kind};
use solaris_model::{Axis, Placement, UnitQuaternion, Vector3};

/// One joint of the figure.
pub(super) struct Segment<'j, 'a> {
    /// Where it stands in the frame before it.
    pub(super) placement: Placement,
    /// The file's joints, in order, with their axes in the segment's own frame; no axes for a ball or free joint.
    pub(super) joints: Vec<(&'j Joint<'a>, Option<Axis>)>,
}

/// The most degrees of freedom of a joint of axes.
const MOST: usize = 6;
/// Anchors that differ by less are one (m).
const SAME: f64 = 1e-14;

/// The joints of the figure between a parent and a body that stands at `placement` in it, and the body's frame in that
/// which the last one moves.
pub(super) fn segments<'j, 'a>(
    placement: Placement,
    joints: &'j [Joint<'a>],
) -> (Vec<Segment<'j, 'a>>, Placement) {
    let mut segments: Vec<Segment> = Vec::new();
    // What stands between the joint before and the next one.
    let mut gap = placement;
    for joint in joints {
        let axis = match joint.kind {
            Kind::Free => {
                // A free joint's coordinates are the place in the world.
                segments.push(Segment { placement: Placement::identity(), joints: vec![(joint, None)] });
                gap = Placement::identity();
                continue;
            }
            Kind::Ball => {
                gap *= shift(joint.anchor);
                segments.push(Segment { placement: gap, joints: vec![(joint, None)] });
                gap = shift(-joint.anchor);
                continue;
            }
            Kind::Hinge => {
                gap *= shift(joint.anchor);
                if joint.reference != 0.0 {
                    let axis = joint.axis.try_normalize(0.0).unwrap_or_else(Vector3::z);
                    gap *= UnitQuaternion::from_scaled_axis(-axis * joint.reference);
                }
                Axis::rotation(joint.axis)
            }
            Kind::Slide => {
                if joint.reference != 0.0 {
                    let axis = joint.axis.try_normalize(0.0).unwrap_or_else(Vector3::z);
                    gap *= shift(-axis * joint.reference);
                }
                Axis::translation(joint.axis)
            }
        };
        let after = if joint.kind == Kind::Hinge { shift(-joint.anchor) } else { Placement::identity() };
        if let Some(passed) = segments.last_mut().and_then(|segment| segment.append(joint, axis, &gap)) {
            gap = passed * after;
        } else {
            segments.push(Segment { placement: gap, joints: vec![(joint, Some(axis))] });
            gap = after;
        }
    }
    (segments, gap)
}

impl<'j, 'a> Segment<'j, 'a> {
    /// Takes one more degree of freedom that stands at `gap` behind those there, if it can be said in one joint; returns
    /// what of the gap stands behind it.
    fn append(&mut self, joint: &'j Joint<'a>, axis: Axis, gap: &Placement) -> Option<Placement> {
        let open = self.joints.len() < MOST && self.joints.iter().all(|(_, axis)| axis.is_some());
        if !open {
            return None;
        }
        if joint.kind == Kind::Slide {
            // Trans(c)·C·Trans(a·q) = Trans(C·a·q)·Trans(c)·C
            let along = Axis::translation(gap.rotation * axis.direction);
            self.joints.push((joint, Some(along)));
            return Some(*gap);
        }
        let slides = self.joints.iter().all(|(joint, _)| joint.kind == Kind::Slide);
        if !slides && gap.translation.vector.norm() > SAME {
            return None;
        }
        // T(a, q)·C = C·T(C⁻¹·a, q), and slides let shifts pass.
        let turn = UnitQuaternion::identity() != gap.rotation;
        if turn || slides {
            let shift = if slides { gap.translation.vector } else { Vector3::zeros() };
            self.placement *= Placement::from_parts(shift.into(), gap.rotation);
            for (_, axis) in &mut self.joints {
                if let Some(axis) = axis {
                    axis.direction = gap.rotation.inverse() * axis.direction;
                }
            }
        }
        self.joints.push((joint, Some(axis)));
        Some(Placement::identity())
    }
}

fn shift(by: Vector3<f64>) -> Placement {
    Placement::from_parts(by.into(), UnitQuaternion::identity())
}
