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
}

/// The pivot split:
///
/// ```text
/// Fᵢ = sᵢ [ (c − Pᵢ)_t Fₙ/(κ y_c) + R_t + Fₙ n ]      R = F − (c − P) Fₙ/(κ y_c)
/// ```
///
/// `sᵢ` share, `Pᵢ` centre of pressure of foot i, `P` of both, `c` centre of mass and `y_c` its height, `κ` = `pivot`, `n`
/// = `up`, `t` tangential. The moment normal to the ground that the forces leave is shared by `sᵢ`. Where the given centres
/// of pressure do not add up to the wrench's, both are moved by the difference.
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
    let height = feet[0].cop.dot(up) * feet[0].share + feet[1].cop.dot(up) * feet[1].share;
    let centre = total.center_of_pressure(up, height)?;
    let shift = centre - feet[0].cop * feet[0].share - feet[1].cop * feet[1].share;
    let mut parts = [Wrench::zero(); 2];
    pivot_parts(total, up, 1.0 / (pivot * (com.dot(up) - height)), feet, &mut parts);
    let mut contacts = [Contact::default(); 2];
    for ((contact, part), foot) in contacts.iter_mut().zip(parts).zip(feet) {
        if foot.share > 0.0 {
            *contact = Contact { force: part.force, moment: part.moment, cop: foot.cop + shift };
        }
    }
    Some(contacts)
}

/// The parts of any number of feet, also where nothing presses on the ground. With `k` = `pull` = `1/(κ y_c)`, `N = Σ sᵢ Pᵢ` of
/// the given centres of pressure, and `m` the moment that the wrench has about `N`, the pivot split without a division by the
/// normal force is
///
/// ```text
/// Fᵢ = sᵢ [ F + k Fₙ (N − Pᵢ)_t ]
/// Mᵢ = Pᵢ × Fᵢ + sᵢ [ m_t + n (T − k m_t·(N − Pᵢ)) ]      T = n·m − Σ n·((Pᵢ − N) × Fᵢ)
/// ```
///
/// The sums are exact where all centres are at one height and the shares add up to 1.
pub(crate) fn pivot_parts(
    total: &Wrench<f64>,
    up: &Vector3<f64>,
    pull: f64,
    feet: &[FootSupport],
    parts: &mut [Wrench<f64>],
) {
    let tangential = |v: Vector3<f64>| v - up * v.dot(up);
    let nominal: Vector3<f64> = feet.iter().map(|foot| foot.cop * foot.share).sum();
    let about = total.moment - nominal.cross(&total.force);
    let (normal, tilting) = (total.force.dot(up), tangential(about));
    let mut twist = about.dot(up);
    for (part, foot) in parts.iter_mut().zip(feet) {
        part.force = (total.force + tangential(nominal - foot.cop) * (pull * normal)) * foot.share;
        twist -= (foot.cop - nominal).cross(&part.force).dot(up);
    }
    for (part, foot) in parts.iter_mut().zip(feet) {
        let own = twist - pull * tilting.dot(&(nominal - foot.cop));
        part.moment = foot.cop.cross(&part.force) + (tilting + up * own) * foot.share;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn feet(share: f64) -> [FootSupport; 2] {
        [
            FootSupport { share, cop: Vector3::new(0.1, 0.0, 0.3) },
            FootSupport { share: 1.0 - share, cop: Vector3::new(-0.1, 0.0, -0.2) },
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
