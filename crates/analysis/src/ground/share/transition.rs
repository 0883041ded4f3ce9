//! The smooth transition assumption.

use super::pivot;
use super::sharing::{Double, Parts, Sharing};
use crate::ground::{GroundError, Split};
use nalgebra::Vector3;
use solaris_dynamics::Wrench;

pub(super) fn share(sharing: &Sharing<'_>) -> Result<Vec<Parts>, GroundError> {
    let time = sharing.prepared.time();
    let releases: Vec<_> =
        sharing.doubles().iter().filter_map(|double| Release::new(sharing, double)).collect();
    let frame = |row: usize| {
        let (t, feet) = (time[row], sharing.standing(row));
        if feet > 2 {
            return Err(GroundError::TooManyFeet { split: Split::Transition.name(), time: t, feet });
        }
        let release =
            releases.iter().find(|release| (release.double.start..=release.double.end).contains(&t));
        let Some(release) = release else {
            return Ok(pivot::share(sharing, row, sharing.supports(row).as_deref()));
        };
        let (trailing, mut parts) = (release.at(t), sharing.whole(row, release.double.leading));
        let leading = &mut parts[release.double.leading];
        leading.force -= trailing.force;
        leading.moment -= trailing.moment;
        parts[release.double.trailing] = trailing;
        Ok(parts)
    };
    (0..time.len()).map(frame).collect()
}

/// A trailing foot in double support.
struct Release {
    double: Double,
    /// When double support begins: its force (N), the point of the ground that it presses on (m), and its moment about
    /// the `normal` through that point (N m).
    force: Vector3<f64>,
    cop: Vector3<f64>,
    normal: Vector3<f64>,
    twist: f64,
    /// Velocity of the ground (m/s).
    belt: Vector3<f64>,
    /// How the centre of mass travels over the ground, of length 1; zero where it does not.
    forward: Vector3<f64>,
}

impl Release {
    /// `None` where nothing presses on the ground when double support begins.
    fn new(sharing: &Sharing<'_>, double: &Double) -> Option<Self> {
        let (up, belt) = (&sharing.prepared.up, sharing.stances.belt);
        let (wrench, from) = between(sharing, double.start);
        let (_, to) = between(sharing, double.end);
        let travel = to - from - belt * (double.end - double.start);
        let travel = travel - up * travel.dot(up);
        if wrench.force.dot(up) <= 0.0 {
            return None;
        }
        let ground = sharing.under(double.trailing, double.start);
        let cop = ground.center_of_pressure(&wrench);
        Some(Self {
            double: *double,
            force: wrench.force,
            cop,
            normal: ground.normal,
            twist: (wrench.moment - cop.cross(&wrench.force)).dot(&ground.normal),
            belt,
            forward: travel.try_normalize(1e-6).unwrap_or_default(),
        })
    }

    /// Its wrench at a time (s) of the double support.
    fn at(&self, t: f64) -> Wrench<f64> {
        let (passed, length) = (t - self.double.start, self.double.end - self.double.start);
        let (rest, fore_aft) = kept(passed / length);
        let along = self.forward * self.forward.dot(&self.force);
        let force = (self.force - along) * rest + along * fore_aft;
        let cop = self.cop + self.belt * passed;
        Wrench { force, moment: cop.cross(&force) + self.normal * (self.twist * rest) }
    }
}

/// What is kept after the fraction `x` of double support: of all components but the fore-aft force, and of that.
fn kept(x: f64) -> (f64, f64) {
    let k1 = (4.0_f64 / 9.0).exp();
    let k2 = k1 * (-16.0_f64 / 9.0).exp() / 2.0;
    let rest = (-(2.0 * x).powi(3)).exp();
    (rest, k1 * (-(2.0 * (x - 1.0 / 3.0)).powi(2)).exp() - 2.0 * k2 * x)
}

/// The whole wrench and the centre of mass (m) at a time (s) inside of the motion, on straight lines between frames.
fn between(sharing: &Sharing<'_>, t: f64) -> (Wrench<f64>, Vector3<f64>) {
    let total = sharing.total;
    let after = total.partition_point(|frame| frame.time < t).clamp(1, total.len().max(2) - 1);
    let (a, b) = (&total[after - 1], &total[after.min(total.len() - 1)]);
    let s = if b.time > a.time { (t - a.time) / (b.time - a.time) } else { 0.0 };
    let wrench = Wrench { force: a.force.lerp(&b.force, s), moment: a.moment.lerp(&b.moment, s) };
    (wrench, a.com.lerp(&b.com, s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// On a slope and on a belt, of a foot whose fore-aft force is along z.
    #[test]
    fn the_moment_about_the_normal_decays_like_the_rest_where_the_foot_has_gone() {
        let release = Release {
            double: Double { trailing: 0, leading: 1, start: 2.0, end: 2.4 },
            force: Vector3::new(30.0, 600.0, 80.0),
            cop: Vector3::new(0.1, 0.2, -0.3),
            normal: Vector3::new(0.0, 0.8, 0.6),
            twist: 6.0,
            belt: Vector3::new(0.0, 0.0, -1.5),
            forward: Vector3::z(),
        };
        for (t, z, rest) in [(2.0, -0.3, 1.0), (2.2, -0.6, (-1.0_f64).exp()), (2.4, -0.9, (-8.0_f64).exp())] {
            let wrench = release.at(t);
            assert_relative_eq!(wrench.force.xy(), release.force.xy() * rest, epsilon = 1e-9);
            let own = wrench.moment - Vector3::new(0.1, 0.2, z).cross(&wrench.force);
            assert_relative_eq!(own, Vector3::new(0.0, 4.8, 3.6) * rest, epsilon = 1e-9);
        }
    }

    #[test]
    fn the_trailing_foot_begins_with_all_and_ends_with_next_to_nothing() {
        assert_relative_eq!(kept(0.0).0, 1.0);
        assert_relative_eq!(kept(0.0).1, 1.0, epsilon = 1e-15);
        assert_relative_eq!(kept(1.0).0, (-8.0_f64).exp());
        assert_relative_eq!(kept(1.0).1, 0.0, epsilon = 1e-15);
        // After a third, the fore-aft force is at its greatest but for the line: e^(4/9) − e^(4/9 − 16/9)/3.
        assert_relative_eq!(kept(1.0 / 3.0).1, 1.559_623_5 - 0.263_597_1 / 3.0, epsilon = 1e-7);
        assert_relative_eq!(kept(1.0 / 3.0).0, (-8.0_f64 / 27.0).exp(), epsilon = 1e-15);
    }
}
