//! Where joints take their links: forward kinematics of positions alone.

use crate::figure::Figure;
use crate::joint::{AxisKind, Joint, Placement};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};

impl Joint {
    /// Where the joint takes its link, seen from its placement, with its own coordinates `q` (rad, m; `nq` of them at least).
    ///
    /// ```
    /// use solaris_model::{Joint, Vector3};
    /// let knee = Joint::new("knee").rx();
    /// let foot = knee.moved(&[std::f64::consts::FRAC_PI_2]) * nalgebra::Point3::new(0.0, -0.4, 0.0);
    /// assert!((foot.coords - Vector3::new(0.0, 0.0, -0.4)).norm() < 1e-15);
    /// ```
    #[doc(alias = "forward kinematics")]
    pub fn moved(&self, q: &[f64]) -> Placement {
        if let Some(first) = self.kind().quaternion() {
            let slide = if first == 3 { Vector3::new(q[0], q[1], q[2]) } else { Vector3::zeros() };
            // A motion keeps it near unit length.
            let turn = [q[first], q[first + 1], q[first + 2], q[first + 3]];
            return Isometry3::from_parts(slide.into(), UnitQuaternion::from_quaternion(turn.into()));
        }
        let mut place = Isometry3::identity();
        for (dof, value) in self.kind().axes().iter().zip(q) {
            let by = dof.axis.direction * *value;
            match dof.axis.kind {
                AxisKind::Translation => place.translation.vector += place.rotation * by,
                AxisKind::Rotation => place.rotation *= UnitQuaternion::from_scaled_axis(by),
            }
        }
        place
    }
}

impl Figure {
    /// Where all links are in the world, with the figure's coordinates `q` (`nq` of them), in the links' order.
    #[doc(alias = "forward kinematics")]
    pub fn places(&self, q: &[f64]) -> Vec<Placement> {
        let mut places: Vec<Placement> = Vec::with_capacity(self.links().len());
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            let own = link.joint().placement() * link.joint().moved(&q[at.q..]);
            places.push(link.parent().map_or(own, |parent| places[parent] * own));
        }
        places
    }
}
