//! The pivot split of the ground's reaction between two feet.
//!
//! The laws of motion give the sum of the two wrenches and nothing else. The split here is an assumption with a name, the
//! **pivot split**: each foot bears a given share of the vertical force, and points its force at one point above the
//! centre of mass, as people's feet do; what is left is shared the same way. It is exact in the sum, and passes
//! continuously into single support.

use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::Contact;

/// What is known of one foot before the forces are: its share of the load and about where it is pressed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FootSupport {
    /// Share of the vertical force, 0 to 1; the feet's shares add up to 1.
    pub share: f64,
    /// Nominal centre of pressure (m), on the ground.
    pub cop: Vector3<f64>,
    /// Normal of the ground under the foot; the vertical for `None`.
    pub normal: Option<Vector3<f64>>,
}

impl FootSupport {
    /// On level ground.
    pub fn level(share: f64, cop: Vector3<f64>) -> Self {
        Self { share, cop, normal: None }
    }

    /// By how much the normal leans, for a vertical part of 1: `n/(n·up) − up`.
    fn lean(&self, up: &Vector3<f64>) -> Vector3<f64> {
        self.normal.map_or(Vector3::zeros(), |n| n / n.dot(up) - up)
    }
}

/// The pivot split:
///
/// ```text
/// Fᵢ = sᵢ [ (c − Pᵢ)_t F_v/(κ y) + R_t + F_v e ]      R = F − (c − P) F_v/(κ y)
/// ```
///
/// `sᵢ` share, `Pᵢ` centre of pressure of foot i, `P = Σ sᵢ Pᵢ`, `c` centre of mass and `y` its height above `P`, `κ` = `pivot`, `e`
/// = `up`, `t` horizontal. The vertical moment that the forces leave is shared by `sᵢ`, as free moments about the ground's normals.
/// Where the given centres of pressure leave a horizontal one, each is moved in its ground's plane.
///
/// `None` where nothing presses on the ground.
#[doc(alias = "load sharing")]
#[doc(alias = "double support")]
pub fn split_at_pivot(
    total: &Wrench<f64>,
    com: &Vector3<f64>,
    up: &Vector3<f64>,
    pivot: f64,
    feet: &[FootSupport; 2],
) -> Option<[Contact; 2]> {
    let pressed = total.force.dot(up) > 0.0;
    let height = feet[0].cop.dot(up) * feet[0].share + feet[1].cop.dot(up) * feet[1].share;
    let mut parts = [Wrench::zero(); 2];
    pivot_parts(total, up, 1.0 / (pivot * (com.dot(up) - height)), feet, &mut parts);
    let mut contacts = [Contact::default(); 2];
    for ((contact, part), foot) in contacts.iter_mut().zip(parts).zip(feet) {
        if foot.share > 0.0 {
            let normal = foot.normal.unwrap_or(*up);
            let own = part.moment - foot.cop.cross(&part.force);
            let cop = foot.cop + normal.cross(&own) / part.force.dot(&normal);
            *contact = Contact { force: part.force, moment: part.moment, cop };
        }
    }
    pressed.then_some(contacts)
}

/// The parts of any number of feet, also where nothing presses on the ground. With `k` = `pull` = `1/(κ y)` and `N = Σ sᵢ Pᵢ` of
/// the given centres of pressure the pivot split without a division by the vertical force is
///
/// ```text
/// Fᵢ = sᵢ [ F + k F_v (N − Pᵢ)_t ]           m = M − Σ Pᵢ × Fᵢ      T = m·e
/// Mᵢ = Pᵢ × Fᵢ + sᵢ [ m_t − T Σ sⱼ hⱼ + T hᵢ + e (T − k m_t·(N − Pᵢ)) ]      hᵢ = nᵢ/(nᵢ·e) − e
/// ```
///
/// The sums are exact where the shares add up to 1.
pub(crate) fn pivot_parts(
    total: &Wrench<f64>,
    up: &Vector3<f64>,
    pull: f64,
    feet: &[FootSupport],
    parts: &mut [Wrench<f64>],
) {
    let horizontal = |v: Vector3<f64>| v - up * v.dot(up);
    let nominal: Vector3<f64> = feet.iter().map(|foot| foot.cop * foot.share).sum();
    let vertical = total.force.dot(up);
    let mut left = total.moment;
    for (part, foot) in parts.iter_mut().zip(feet) {
        part.force = (total.force + horizontal(nominal - foot.cop) * (pull * vertical)) * foot.share;
        left -= foot.cop.cross(&part.force);
    }
    let twist = left.dot(up);
    let leaning: Vector3<f64> = feet.iter().map(|foot| foot.lean(up) * foot.share).sum();
    let tilting = horizontal(left) - leaning * twist;
    for (part, foot) in parts.iter_mut().zip(feet) {
        let own = twist - pull * tilting.dot(&(nominal - foot.cop));
        part.moment = foot.cop.cross(&part.force) + (tilting + foot.lean(up) * twist + up * own) * foot.share;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn feet(share: f64) -> [FootSupport; 2] {
        [
            FootSupport::level(share, Vector3::new(0.1, 0.0, 0.3)),
            FootSupport::level(1.0 - share, Vector3::new(-0.1, 0.0, -0.2)),
        ]
    }

    #[test]
    fn the_parts_add_up_to_the_whole() {
        let total =
            Wrench { force: Vector3::new(20.0, 700.0, -90.0), moment: Vector3::new(-40.0, 12.0, 30.0) };
        for share in [0.0, 0.2, 0.5, 1.0] {
            let [a, b] =
                split_at_pivot(&total, &Vector3::new(0.0, 1.0, 0.1), &Vector3::y(), 1.4, &feet(share))
                    .expect("pressed");
            assert_relative_eq!(a.force + b.force, total.force, epsilon = 1e-12);
            assert_relative_eq!(a.moment + b.moment, total.moment, epsilon = 1e-11);
            assert_relative_eq!(a.force.y, share * 700.0, epsilon = 1e-12);
        }
    }

    #[test]
    fn the_normal_of_a_slope_leans_by_its_tangent() {
        let lean = |normal| FootSupport { normal, ..feet(0.5)[0] }.lean(&Vector3::y());
        let angle = 0.3_f64;
        let expected = Vector3::new(0.0, 0.0, -angle.tan());
        assert_relative_eq!(
            lean(Some(Vector3::new(0.0, angle.cos(), -angle.sin()))),
            expected,
            epsilon = 1e-15
        );
        assert_eq!(lean(Some(Vector3::y())), Vector3::zeros());
        assert_eq!(lean(None), Vector3::zeros());
    }

    /// A step up, each foot on a slope of its own.
    #[test]
    fn on_slopes_the_free_moments_are_normal_to_the_ground() {
        let total =
            Wrench { force: Vector3::new(20.0, 700.0, -90.0), moment: Vector3::new(-40.0, 12.0, 30.0) };
        let mut feet = feet(0.3);
        feet[0].cop.y = 0.2;
        feet[0].normal = Some(Vector3::new(0.0, 1.0, -0.2).normalize());
        feet[1].normal = Some(Vector3::new(0.1, 1.0, 0.0).normalize());
        let up = Vector3::y();
        let contacts =
            split_at_pivot(&total, &Vector3::new(0.0, 1.1, 0.1), &up, 1.4, &feet).expect("pressed");
        assert_relative_eq!(contacts[0].force + contacts[1].force, total.force, epsilon = 1e-12);
        assert_relative_eq!(contacts[0].moment + contacts[1].moment, total.moment, epsilon = 1e-11);
        for (contact, foot) in contacts.iter().zip(feet) {
            let normal = foot.normal.expect("a slope");
            assert!((contact.cop - foot.cop).dot(&normal).abs() < 1e-12);
            let free = contact.moment - contact.cop.cross(&contact.force);
            assert!(free.cross(&normal).norm() < 1e-10 * total.moment.norm(), "{free}");
        }
    }

    #[test]
    fn with_one_foot_everything_is_its_own() {
        let total = Wrench { force: Vector3::new(5.0, 500.0, 9.0), moment: Vector3::new(-50.0, 3.0, -20.0) };
        let [a, b] = split_at_pivot(&total, &Vector3::new(0.0, 1.0, 0.1), &Vector3::y(), 1.4, &feet(1.0))
            .expect("pressed");
        assert_relative_eq!(a.force, total.force, epsilon = 1e-12);
        // (P × F) = M: −P_z F_y = −50 and P_x F_y = −20.
        assert_relative_eq!(a.cop, Vector3::new(-0.04, 0.0, 0.1), epsilon = 1e-12);
        assert_eq!(b, Contact::default());
    }

    #[test]
    fn in_flight_there_is_nothing_to_split() {
        let total = Wrench { force: Vector3::new(0.0, -1.0, 0.0), moment: Vector3::zeros() };
        assert_eq!(
            split_at_pivot(&total, &Vector3::new(0.0, 1.0, 0.0), &Vector3::y(), 1.4, &feet(0.5)),
            None
        );
    }
}
