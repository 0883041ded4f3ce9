//! A servo: the force that leads a degree of freedom back to a motion.

use super::path::Path;
use crate::failure::SetupError;
use crate::range::{check_finite, check_not_negative, check_positive};
use solaris_profiles::{Elementary, Profile};

/// A spring and damper between a degree of freedom and a motion that it is to have, as strong as its motor is:
///
/// ```text
/// τ = clamp(k·(q* − q) + d·(q̇* − q̇), ±limit)
/// ```
///
/// Unlike a [kinematic](super::Drive::Kinematic) drive it does not get there whatever it takes: what the figure weighs, hits and
/// carries leads it away. Its work is that of a drive; where it holds back it takes energy out, and no damper's heat is counted.
#[doc(alias = "PD controller")]
#[doc(alias = "position actuator")]
#[derive(Clone, Debug, PartialEq)]
pub struct Servo {
    /// Where to, and how fast: `q*` (rad or m) and `q̇*`.
    pub aim: Aim,
    /// `k` (N m/rad or N/m).
    pub stiffness: f64,
    /// `d` (N m s/rad or N s/m).
    pub damping: f64,
    /// The greatest force (N m or N), if it has one.
    pub limit: Option<f64>,
}

/// The motion that a [`Servo`] is to make.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Aim {
    /// To rest at a position (rad or m).
    At(f64),
    /// To follow a curve (rad or m) that begins when the drive begins; before it ends the drive is not done, and after its end it is
    /// held where it ends.
    Along(Profile),
}

impl Servo {
    /// Refuses numbers that are out of range, for the degree of freedom `dof`.
    pub(super) fn check(&self, dof: &str) -> Result<(), SetupError> {
        let of = |what: &str| format!("the {what} of the servo of '{dof}'");
        match &self.aim {
            Aim::At(position) => check_finite(|| of("aim"), *position)?,
            Aim::Along(profile) => {
                let source = profile.curve::<f64>().err();
                source.map_or(Ok(()), |source| Err(SetupError::Profile { dof: dof.to_owned(), source }))?;
            }
        }
        check_not_negative(|| of("stiffness"), self.stiffness)?;
        check_not_negative(|| of("damping"), self.damping)?;
        self.limit.map_or(Ok(()), |limit| check_positive(|| of("greatest force"), limit))
    }
}

/// A servo in the time of the run.
#[derive(Clone)]
pub(crate) struct ServoForce {
    pub(crate) aim: Path,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
    /// Infinite where it has none.
    pub(crate) limit: f64,
}

impl ServoForce {
    /// What it asks for (N m or N), whatever its motor can do.
    pub(crate) fn demand<T: Elementary>(&self, time: f64, (position, velocity): (T, T)) -> T {
        let aim = self.aim.at(time);
        let [stiffness, damping, to, rate] =
            [self.stiffness, self.damping, aim.position, aim.velocity].map(T::from_f64);
        stiffness * (to - position) + damping * (rate - velocity)
    }

    /// The force (N m or N).
    pub(crate) fn at<T: Elementary>(&self, time: f64, state: (T, T)) -> T {
        let demand = self.demand(time, state);
        // At its limit it does not change with the state: so the derivatives have it too.
        if demand.value() > self.limit {
            T::from_f64(self.limit)
        } else if demand.value() < -self.limit {
            T::from_f64(-self.limit)
        } else {
            demand
        }
    }

    pub(super) fn during(&self, from: f64, to: f64) -> Self {
        Self { aim: self.aim.during(from, to), ..self.clone() }
    }

    pub(super) fn breaks(&self) -> Vec<f64> {
        self.aim.breaks()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_dynamics::scalar::Dual;

    #[test]
    fn its_derivatives_are_minus_stiffness_and_damping_and_none_at_its_limit() {
        let servo = ServoForce { aim: Path::Still(0.5), stiffness: 40.0, damping: 3.0, limit: 30.0 };
        let state = |q, v| (Dual::<2>::variable(q, 0), Dual::<2>::variable(v, 1));
        // 40·(0.5 − 0.1) − 3·2 = 10.
        let free = servo.at(0.0, state(0.1, 2.0));
        assert!((free.value() - 10.0).abs() < 1e-14);
        assert_eq!((free.partial(0), free.partial(1)), (-40.0, -3.0));
        for (position, force) in [(-1.0, 30.0), (2.0, -30.0)] {
            let full = servo.at(0.0, state(position, 0.0));
            assert_eq!((full.value(), full.partial(0), full.partial(1)), (force, 0.0, 0.0));
        }
    }
}
