//! Names of drives, and checks of their numbers.

use super::{Course, Drive, Law, Servo, Target};
use crate::failure::SetupError;
use crate::range::{check_finite, check_not_negative, check_positive};

impl Drive {
    /// What it is called.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Frozen => "frozen",
            Self::Kinematic(_) => "kinematic",
            Self::Move { .. } => "move",
            Self::Recorded(_) => "recorded",
            Self::Torque(_) => "torque",
            Self::Simple { course, .. } => match course {
                Course::TargetAngle => "target-angle",
                Course::TimeOriented { .. } => "time-oriented",
                Course::BangBang => "accelerate-decelerate (i)",
                Course::HalfCosine => "accelerate-decelerate (ii)",
                Course::FullSine => "accelerate-decelerate (iii)",
            },
            Self::FreeStyle { .. } => "free-style",
            Self::Intensive { law, .. } => match law {
                Law::Literal => "intensive, literal",
                Law::Cubic => "intensive, cubic",
                Law::Quintic => "intensive, quintic",
            },
            Self::Servo(_) => "servo",
            Self::Sum(_) => "sum",
        }
    }

    /// The first servo in it.
    pub(crate) fn servo(&self) -> Option<&Servo> {
        match self {
            Self::Servo(servo) => Some(servo),
            Self::Sum(parts) => parts.iter().find_map(Self::servo),
            _ => None,
        }
    }

    /// The same, to be changed.
    pub(crate) fn servo_mut(&mut self) -> Option<&mut Servo> {
        match self {
            Self::Servo(servo) => Some(servo),
            Self::Sum(parts) => parts.iter_mut().find_map(Self::servo_mut),
            _ => None,
        }
    }

    /// Whether a velocity of a ball or free joint can be driven so.
    pub(crate) fn fits_ball_joints(&self) -> bool {
        match self {
            Self::Free | Self::Frozen | Self::Torque(_) => true,
            Self::Sum(parts) => parts.iter().all(Self::fits_ball_joints),
            _ => false,
        }
    }

    /// Refuses numbers that are out of range, for the degree of freedom `dof`.
    pub(crate) fn check(&self, dof: &str) -> Result<(), SetupError> {
        let of = |what: &str| format!("the {what} of '{dof}'");
        let target = |target: &Target| {
            let numbers = [target.position, target.velocity, target.acceleration];
            numbers.into_iter().try_for_each(|value| check_finite(|| of("target"), value))
        };
        match self {
            Self::Free | Self::Frozen | Self::Recorded(_) => Ok(()),
            Self::Kinematic(profile) | Self::Torque(profile) => {
                let source = profile.curve::<f64>().err();
                source.map_or(Ok(()), |source| Err(SetupError::Profile { dof: dof.to_owned(), source }))
            }
            Self::Move { to, over, .. } => {
                check_finite(|| of("aim"), *to)?;
                check_positive(|| of("duration"), *over)
            }
            Self::Simple { target: aim, course } => {
                target(aim)?;
                match course {
                    Course::TimeOriented { duration } => check_positive(|| of("duration"), *duration),
                    _ => Ok(()),
                }
            }
            Self::FreeStyle { target: aim, duration } => {
                aim.iter().try_for_each(target)?;
                check_positive(|| of("duration"), *duration)
            }
            Self::Intensive { target: aim, duration, limit, .. } => {
                target(aim)?;
                check_positive(|| of("duration"), *duration)?;
                limit.map_or(Ok(()), |limit| check_not_negative(|| of("greatest force"), limit))
            }
            Self::Servo(servo) => servo.check(dof),
            Self::Sum(parts) => parts.iter().try_for_each(|part| match part {
                Self::Torque(_) | Self::Servo(_) | Self::Sum(_) => part.check(dof),
                _ => Err(SetupError::NotInSum { dof: dof.to_owned(), drive: part.name() }),
            }),
        }
    }
}
