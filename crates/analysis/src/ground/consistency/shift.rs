//! A motion with its root somewhere else.

use crate::ground::consistency::{Consistency, error::ShiftError};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use solaris_model::{AxisKind, Figure, JointKind, JointLayout, Motion};

/// Moves the whole figure by `found`'s shift, with its velocity and acceleration; everything else stays.
///
/// The root is free or begins with slides along three axes at right angles. Of a free root, whose velocities `v`, `ω` and
/// accelerations are along the link's axes, with `R` its turn against the world,
///
/// ```text
/// v' = v + Rᵀδ̇      a' = a + Rᵀδ̈ − ω × Rᵀδ̇
/// ```
///
/// since `a` is the rate of the numbers `v`, and those turn with the link.
///
/// # Errors
///
/// Numbers of frames that differ, roots of other kinds, slides that follow something or are followed, what is not finite.
/// The motion is then as it was.
pub fn shift_root(figure: &Figure, motion: &mut Motion, found: &Consistency) -> Result<(), ShiftError> {
    let frames = motion.len();
    let lengths = [
        ("the shift", found.shift.len()),
        ("the shift's velocity", found.velocity.len()),
        ("the shift's acceleration", found.acceleration.len()),
    ];
    if let Some((what, found)) = lengths.into_iter().find(|(_, found)| *found != frames) {
        return Err(ShiftError::Length { what, found, frames });
    }
    let (root, nq, nv) = (Root::of(figure)?, figure.layout().nq(), figure.layout().nv());
    let [mut q, mut v, mut a] = motion.columns().map(<[f64]>::to_vec);
    for frame in 0..frames {
        let by = [found.shift[frame], found.velocity[frame], found.acceleration[frame]];
        let (q, v) = (&mut q[frame * nq + root.at().q..], &mut v[frame * nv + root.at().v..]);
        root.shift(q, v, &mut a[frame * nv + root.at().v..], by);
    }
    motion.set_states(figure, [q, v, a])?;
    Ok(())
}

/// How a figure's root is moved.
enum Root {
    /// Slides along these axes of the world come first.
    Slides(JointLayout, [Vector3<f64>; 3]),
    /// Free, with the joint's frame turned like this against the world.
    Free(JointLayout, UnitQuaternion<f64>),
}

impl Root {
    fn of(figure: &Figure) -> Result<Self, ShiftError> {
        let (joint, at) = (figure.links()[0].joint(), figure.layout().joints()[0]);
        let none = || ShiftError::NoSlides { joint: joint.name().to_owned() };
        let turn = joint.placement().rotation;
        if let JointKind::Free { .. } = joint.kind() {
            return Ok(Self::Free(at, turn));
        }
        let slides = joint.kind().axes().iter().take_while(|dof| dof.axis.kind == AxisKind::Translation);
        let axes: Vec<Vector3<f64>> = slides.map(|dof| turn * dof.axis.direction).collect();
        let [x, y, z] = axes[..] else { return Err(none()) };
        let own = at.v..at.v + 3;
        let tied = |dof: usize| figure.follows(dof) || figure.followers().iter().any(|f| f.leader == dof);
        if [x.dot(&y), y.dot(&z), z.dot(&x)].iter().any(|cosine| cosine.abs() > 1e-9)
            || own.into_iter().any(tied)
        {
            return Err(none());
        }
        Ok(Self::Slides(at, [x, y, z]))
    }

    fn at(&self) -> &JointLayout {
        match self {
            Self::Slides(at, _) | Self::Free(at, _) => at,
        }
    }

    fn shift(&self, q: &mut [f64], v: &mut [f64], a: &mut [f64], by: [Vector3<f64>; 3]) {
        match self {
            Self::Slides(_, axes) => {
                for (k, axis) in axes.iter().enumerate() {
                    q[k] += axis.dot(&by[0]);
                    v[k] += axis.dot(&by[1]);
                    a[k] += axis.dot(&by[2]);
                }
            }
            Self::Free(_, turn) => {
                let place = turn.inverse() * by[0];
                let link = turn * UnitQuaternion::from_quaternion(Quaternion::new(q[6], q[3], q[4], q[5]));
                let velocity = link.inverse() * by[1];
                let turning = Vector3::new(v[3], v[4], v[5]).cross(&velocity);
                let acceleration = link.inverse() * by[2] - turning;
                for k in 0..3 {
                    q[k] += place[k];
                    v[k] += velocity[k];
                    a[k] += acceleration[k];
                }
            }
        }
    }
}
