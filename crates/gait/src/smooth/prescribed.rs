//! The forces that a plan prescribes.

use nalgebra::Vector3;
use solaris_analysis::{FootSupport, split_at_pivot};
use solaris_dynamics::Wrench;
use solaris_model::Contact;

/// What a plan prescribes at one node; world coordinates.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PrescribedNode {
    /// Centre of mass of the body (m).
    pub(crate) com: Vector3<f64>,
    /// Vertical force (N).
    pub(crate) vertical: f64,
    /// Rate of the angular momentum about the centre of mass (N m).
    pub(crate) momentum_rate: Vector3<f64>,
    /// Share and centre of pressure of each foot (left, right).
    pub(crate) feet: [FootSupport; 2],
}

impl PrescribedNode {
    /// The floor's whole wrench: forces that carry the centre of mass over the centre of pressure and leave the angular
    /// momentum its rate.
    ///
    /// ```text
    /// F_z = ((z − P_z) F_y − Ḣ_x)/y      F_x = ((x − P_x) F_y + Ḣ_z)/y      T_y = Ḣ_y − [(P − c) × F]_y
    /// ```
    pub(crate) fn total(&self) -> Wrench<f64> {
        let centre = self.feet[0].cop * self.feet[0].share + self.feet[1].cop * self.feet[1].share;
        let (c, h, y) = (self.com, self.momentum_rate, self.com.y);
        let force = Vector3::new(
            ((c.x - centre.x) * self.vertical + h.z) / y,
            self.vertical,
            ((c.z - centre.z) * self.vertical - h.x) / y,
        );
        let twist = h.y - (centre - c).cross(&force).y;
        Wrench { force, moment: centre.cross(&force) + Vector3::y() * twist }
    }

    /// Each foot's part of it: forces that point at `pivot` times the height of the centre of mass.
    pub(crate) fn feet(&self, pivot: f64) -> [Contact; 2] {
        split_at_pivot(&self.total(), &self.com, &Vector3::y(), pivot, &self.feet).unwrap_or_default()
    }
}

/// Tangential over normal force.
pub(crate) fn friction(force: &Vector3<f64>) -> f64 {
    force.x.hypot(force.z) / force.y
}
