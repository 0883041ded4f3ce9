//! A motion and its mirror image, in which left does what right did.

use crate::feet::Sole;
use crate::take::Take;
use nalgebra::Quaternion;
use solaris_model::{Placement, UnitQuaternion, Vector3};

impl Take {
    /// The mirror image of the motion, and of the skeleton that it is of, in the plane between left and right through its world's origin: who
    /// turned left turns right, and what the left bones did the right ones do.
    ///
    /// ```text
    /// x → M·x        R → M·R·M        M = diag(−1, 1, 1) where x points left
    /// ```
    #[must_use]
    pub fn mirrored(mut self) -> Self {
        // The skeleton's rest pose stands in the clip's own world.
        let (turn, back) = (self.heading, self.heading.inverse());
        for bone in &mut self.skeleton.bones {
            bone.rest = back * place(&(turn * bone.rest));
        }
        for (_, point) in &mut self.skeleton.surface {
            *point = back * across(&(turn * *point));
        }
        self.frames.iter_mut().flatten().for_each(|at| *at = place(at));
        if let Some(belt) = &mut self.belt {
            belt.velocity = across(&belt.velocity);
        }
        self.roles.sides.swap(0, 1);
        self.stands.iter_mut().for_each(|stands| stands.swap(0, 1));
        self.soles = Sole::both(&self.skeleton, &self.roles, &self.heading);
        self
    }
}

fn across(v: &Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.x, v.y, v.z)
}

fn place(at: &Placement) -> Placement {
    let turn = &at.rotation;
    // An axis of turning is mirrored and its turn goes the other way round.
    let turn = UnitQuaternion::new_unchecked(Quaternion::new(turn.w, turn.i, -turn.j, -turn.k));
    Placement::from_parts(across(&at.translation.vector).into(), turn)
}
