//! The forces that a plan prescribes.

use crate::body::Cane;
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
    /// The part of the vertical force that a cane bears, its tip and the fist that holds it; the shares are of the rest.
    pub(crate) cane: Option<CaneNode>,
    /// Horizontal part of the free moments, which act about the ground's normals (N m): zero on level ground.
    pub(crate) tilting: Vector3<f64>,
}

/// What a cane does at one node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CaneNode {
    pub(crate) cane: Cane,
    pub(crate) share: f64,
    pub(crate) tip: Vector3<f64>,
    pub(crate) fist: Vector3<f64>,
}

impl CaneNode {
    /// By how much the hand is farther from the tip, or nearer to it, than the cane is long (m).
    pub(crate) fn beyond(&self) -> f64 {
        ((self.fist - self.tip).norm() - self.cane.length).abs()
    }

    /// The ground's force on it where all of the vertical force is so much: along the cane.
    pub(crate) fn contact(&self, vertical: f64) -> Contact {
        let Self { share, tip, fist, .. } = self;
        if *share == 0.0 {
            return Contact::default();
        }
        let along = fist - tip;
        let force = along * (share * vertical / along.y);
        Contact { force, moment: tip.cross(&force), cop: *tip }
    }
}

impl PrescribedNode {
    /// Centre of pressure of all that stands on the ground.
    fn centre(&self) -> Vector3<f64> {
        let feet = self.feet[0].cop * self.feet[0].share + self.feet[1].cop * self.feet[1].share;
        self.cane().map_or(feet, |cane| feet.lerp(&cane.tip, cane.share))
    }

    /// The floor's whole force, which carries the centre of mass over the centre of pressure `P = Σ sᵢ Pᵢ` and leaves the angular momentum
    /// its rate:
    ///
    /// ```text
    /// F_z = ((z − P_z) F_y − (Ḣ − T)_x − C_z)/y'     F_x = ((x − P_x) F_y + (Ḣ − T)_z − C_x)/y'     y' = y − P_y
    /// C = s_l s_r D_y D F_y/(κ y')      D = P_l − P_r
    /// ```
    ///
    /// Each foot's force points at κ times the height above P: where the feet stand at different heights C is what that does to the
    /// moment.
    pub(crate) fn force(&self, pivot: f64) -> Vector3<f64> {
        let centre = self.centre();
        let (c, h) = (self.com, self.momentum_rate - self.tilting);
        let y = c.y - centre.y;
        let spread = spread(&self.feet) * (self.vertical / (pivot * y));
        Vector3::new(
            ((c.x - centre.x) * self.vertical + h.z - spread.x) / y,
            self.vertical,
            ((c.z - centre.z) * self.vertical - h.x - spread.z) / y,
        )
    }

    /// The floor's whole wrench: that force, and the moment `c × F + Ḣ` about the world's origin.
    pub(crate) fn total(&self, pivot: f64) -> Wrench<f64> {
        let force = self.force(pivot);
        Wrench { force, moment: self.com.cross(&force) + self.momentum_rate }
    }

    /// None without the feature, so that nothing of it is compiled then.
    fn cane(&self) -> Option<CaneNode> {
        self.cane.filter(|_| cfg!(feature = "cane"))
    }

    /// What the ground does to a cane.
    fn cane_contact(&self) -> Contact {
        self.cane().map_or_else(Contact::default, |cane| cane.contact(self.vertical))
    }

    /// Each foot's part of the rest: forces that point at `pivot` times the height of the centre of mass.
    pub(crate) fn feet(&self, pivot: f64) -> [Contact; 2] {
        let (mut rest, cane) = (self.total(pivot), self.cane_contact());
        rest.force -= cane.force;
        rest.moment -= cane.moment;
        split_at_pivot(&rest, &self.com, &Vector3::y(), pivot, &self.feet).unwrap_or_default()
    }

    /// What the free moments' horizontal part has to be, for the wrench as it is: `T_y Σ sᵢ hᵢ`, see [`split_at_pivot`].
    pub(crate) fn needed_tilting(&self, pivot: f64) -> Vector3<f64> {
        let leaning: Vector3<f64> = self.feet.iter().map(|foot| lean(foot) * foot.share).sum();
        if leaning == Vector3::zeros() {
            return leaning;
        }
        let force = self.force(pivot);
        let (centre, c) = (self.centre(), self.com);
        let pull = self.vertical / (pivot * (c.y - centre.y));
        let twist: f64 = self
            .feet
            .iter()
            .map(|foot| {
                let apart = centre - foot.cop;
                let own = (force + Vector3::new(apart.x, 0.0, apart.z) * pull) * foot.share;
                (foot.cop - c).cross(&own).y
            })
            .sum();
        leaning * (self.momentum_rate.y - twist)
    }
}

/// By how much the ground's normal leans under a foot, for a vertical part of 1.
fn lean(foot: &FootSupport) -> Vector3<f64> {
    foot.normal.map_or(Vector3::zeros(), |n| n / n.y - Vector3::y())
}

/// `s_l s_r D_y D` with `D = P_l − P_r`: zero where both feet stand equally high.
pub(crate) fn spread(feet: &[FootSupport; 2]) -> Vector3<f64> {
    let apart = feet[0].cop - feet[1].cop;
    apart * (feet[0].share * feet[1].share * apart.y)
}

/// Normal of ground that rises by `slope` (rad) along z; the vertical for `None`.
pub(crate) fn normal_of(slope: f64) -> Option<Vector3<f64>> {
    (slope != 0.0).then(|| Vector3::new(0.0, slope.cos(), -slope.sin()))
}

/// Tangential over normal force, on ground with this normal.
pub(crate) fn friction_on(force: &Vector3<f64>, normal: &Vector3<f64>) -> f64 {
    let pressed = force.dot(normal);
    (force - normal * pressed).norm() / pressed
}

/// Tangential over normal force, on level ground.
pub(crate) fn friction(force: &Vector3<f64>) -> f64 {
    force.x.hypot(force.z) / force.y
}
