//! Questions about a profile before it is a curve: which values of a parameter would do.

use super::{Parameter, Profile};
use crate::Elementary;
use crate::answers::{Answers, Turn};
use crate::error::{ProfileError, check_range};
use crate::polynomial::CubicHermite;
use crate::range::{Range, Ranges};
use crate::{acceleration, displacement, velocity};

/// The parameters that may be free, in the order in which one is looked for that could help.
const FREE: [&Parameter; 5] = [
    &Parameter::START_VELOCITY,
    &Parameter::END_VELOCITY,
    &Parameter::SHAPE,
    &Parameter::THIRD_VELOCITY,
    &Parameter::THIRD_TIME,
];

impl Profile {
    /// The values of one parameter, all others as they are, with which the motion never turns round.
    ///
    /// In closed form (the thesis searches on a grid, §5.3). A velocity with which the motion only touches standstill
    /// belongs to them where that is at an end, and not where it is inside. Free may be
    ///
    /// - the start velocity and the end velocity of `TrigonometricVelocities`, `ExponentialVelocities` (shape below 1),
    ///   `Tension`, `CubicHermite` and `LinearVelocity`;
    /// - the start velocity where an acceleration is given;
    /// - the shape of `Exponential`;
    /// - the third time and the third velocity of `CircularVelocity`: there, the values for which there is an arc.
    ///
    /// # Errors
    ///
    /// [`ProfileError::NotFree`] for all others; what the kind's constructor refuses of the other parameters.
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_profiles::{Parameter, Profile};
    ///
    /// let (start_velocity, end_velocity) = (0.0, 5.0);
    /// let profile = Profile::CubicHermite { from: 0.0, to: 5.0, duration: 2.0, start_velocity, end_velocity };
    /// let feasible = profile.feasible(&Parameter::START_VELOCITY)?;
    /// assert!(feasible.contains(0.0) && feasible.contains(9.33) && !feasible.contains(9.34));
    /// # Ok::<(), solaris_profiles::ProfileError>(())
    /// ```
    pub fn feasible(&self, free: &Parameter) -> Result<Ranges, ProfileError> {
        for (parameter, value) in self.values() {
            if parameter.symbol != free.symbol {
                check_range(parameter.name, value, parameter.range)?;
            }
        }
        match free.symbol {
            symbol if symbol == Parameter::START_VELOCITY.symbol => self.feasible_start_velocity(),
            symbol if symbol == Parameter::END_VELOCITY.symbol => self.feasible_end_velocity(),
            _ => self.feasible_other(free),
        }
        .unwrap_or_else(|| {
            let kind = self.kind().map_or(self.variant(), |kind| kind.name);
            Err(ProfileError::NotFree { kind, parameter: free.name, instead: self.free() })
        })
    }

    fn feasible_start_velocity(&self) -> Option<Result<Ranges, ProfileError>> {
        Some(match *self {
            Self::TrigonometricVelocities { from, to, duration, end_velocity, .. } => {
                displacement::TrigonometricVelocities::feasible_start_velocity(
                    duration,
                    from,
                    to,
                    end_velocity,
                )
            }
            Self::ExponentialVelocities { from, to, duration, exponent, shape, end_velocity, .. } => {
                super::curve::whole("exponent", exponent).and_then(|n| {
                    displacement::ExponentialVelocities::feasible_start_velocity(
                        duration,
                        from,
                        to,
                        end_velocity,
                        n,
                        shape,
                    )
                })
            }
            Self::Tension { from, to, duration, stiffness, end_velocity, .. } => {
                displacement::Tension::feasible_start_velocity(duration, from, to, end_velocity, stiffness)
            }
            Self::CubicHermite { from, to, duration, end_velocity, .. } => {
                CubicHermite::feasible_start_velocity(duration, from, to, end_velocity)
            }
            Self::ConstantAcceleration { duration, acceleration, .. } => {
                acceleration::Constant::feasible_start_velocity(duration, acceleration)
            }
            Self::TrigonometricAcceleration { duration, peak_acceleration, .. } => {
                acceleration::Trigonometric::feasible_start_velocity(duration, peak_acceleration)
            }
            Self::QuarterEllipse { duration, middle_acceleration, .. } => {
                acceleration::Ellipse::quarter_feasible_start_velocity(duration, middle_acceleration)
            }
            Self::HalfEllipse { duration, peak_acceleration, .. } => {
                acceleration::Ellipse::half_feasible_start_velocity(duration, peak_acceleration)
            }
            Self::LinearVelocity { end_velocity, .. } => {
                velocity::Line::feasible_start_velocity(end_velocity)
            }
            _ => return None,
        })
    }

    fn feasible_end_velocity(&self) -> Option<Result<Ranges, ProfileError>> {
        Some(match *self {
            Self::TrigonometricVelocities { from, to, duration, start_velocity, .. } => {
                displacement::TrigonometricVelocities::feasible_end_velocity(
                    duration,
                    from,
                    to,
                    start_velocity,
                )
            }
            Self::ExponentialVelocities { from, to, duration, exponent, shape, start_velocity, .. } => {
                super::curve::whole("exponent", exponent).and_then(|n| {
                    displacement::ExponentialVelocities::feasible_end_velocity(
                        duration,
                        from,
                        to,
                        start_velocity,
                        n,
                        shape,
                    )
                })
            }
            Self::Tension { from, to, duration, stiffness, start_velocity, .. } => {
                displacement::Tension::feasible_end_velocity(duration, from, to, start_velocity, stiffness)
            }
            Self::CubicHermite { from, to, duration, start_velocity, .. } => {
                CubicHermite::feasible_end_velocity(duration, from, to, start_velocity)
            }
            Self::LinearVelocity { start_velocity, .. } => {
                velocity::Line::feasible_end_velocity(start_velocity)
            }
            _ => return None,
        })
    }

    fn feasible_other(&self, free: &Parameter) -> Option<Result<Ranges, ProfileError>> {
        match *self {
            // The root of the power, at T/s, is not inside.
            Self::Exponential { .. } if free.symbol == Parameter::SHAPE.symbol => {
                Some(Ok(Range::at_most(1.0).into()))
            }
            Self::CircularVelocity { duration, third_time, start_velocity, end_velocity, .. }
                if free.symbol == Parameter::THIRD_VELOCITY.symbol =>
            {
                let ends = (start_velocity, end_velocity);
                Some(velocity::Circle::feasible_third_velocity(duration, ends, third_time))
            }
            Self::CircularVelocity { duration, third_velocity, start_velocity, end_velocity, .. }
                if free.symbol == Parameter::THIRD_TIME.symbol =>
            {
                let ends = (start_velocity, end_velocity);
                Some(velocity::Circle::feasible_third_time(duration, ends, third_velocity))
            }
            _ => None,
        }
    }

    /// What may be free, in words.
    fn free(&self) -> &'static str {
        match self {
            Self::TrigonometricVelocities { .. }
            | Self::ExponentialVelocities { .. }
            | Self::Tension { .. }
            | Self::CubicHermite { .. }
            | Self::LinearVelocity { .. } => "v0 and v1 may be free",
            Self::ConstantAcceleration { .. }
            | Self::TrigonometricAcceleration { .. }
            | Self::QuarterEllipse { .. }
            | Self::HalfEllipse { .. } => "v0 may be free",
            Self::Exponential { .. } => "s may be free",
            Self::CircularVelocity { .. } => "vm and T1 may be free",
            _ => "none of its parameters may be free",
        }
    }

    /// Refuses a profile whose motion turns round, with the values that would keep it from that.
    ///
    /// # Errors
    ///
    /// [`ProfileError::Infeasible`] with the first free parameter that can, [`ProfileError::TurnsRound`] where none can; what
    /// the kind's constructor refuses.
    pub fn refuse_reversal(&self) -> Result<(), ProfileError> {
        let stationary = self.curve::<f64>()?.stationary();
        let Some(point) = stationary.points.iter().find(|point| point.turn == Turn::Reversal) else {
            return Ok(());
        };
        for free in FREE {
            let Some(&(_, value)) =
                self.values().iter().find(|(parameter, _)| parameter.symbol == free.symbol)
            else {
                continue;
            };
            match self.feasible(free) {
                Ok(feasible) if !feasible.is_empty() && !feasible.contains(value) => {
                    let why = "the motion turns round";
                    return Err(ProfileError::Infeasible { what: free.name, value, why, feasible });
                }
                _ => {}
            }
        }
        Err(ProfileError::TurnsRound { time: point.time })
    }

    /// The same profile with the amplitude that ends at `to`: the acceleration, or the velocity (of `LinearVelocity` the end
    /// velocity, of `FairedVelocity` the velocity between rise and fall).
    ///
    /// # Errors
    ///
    /// [`ProfileError::NotFree`] for kinds whose end is given, or that have no one amplitude; what the kind's constructor
    /// refuses.
    pub fn reach(self, to: f64) -> Result<Self, ProfileError> {
        let mut profile = self;
        match &mut profile {
            Self::ConstantAcceleration { from, duration, acceleration, start_velocity } => {
                *acceleration =
                    acceleration::Constant::reaching(*duration, (*from, *start_velocity), to)?.acceleration();
            }
            Self::TrigonometricAcceleration { from, duration, peak_acceleration, start_velocity } => {
                *peak_acceleration =
                    acceleration::Trigonometric::reaching(*duration, (*from, *start_velocity), to)?
                        .peak_acceleration();
            }
            Self::QuarterEllipse { from, duration, middle_acceleration, start_velocity } => {
                let start = (*from, *start_velocity);
                let peak = acceleration::Ellipse::quarter_reaching(*duration, start, to)?.peak_acceleration();
                *middle_acceleration = peak * Elementary::sqrt(0.75);
            }
            Self::HalfEllipse { from, duration, peak_acceleration, start_velocity } => {
                *peak_acceleration =
                    acceleration::Ellipse::half_reaching(*duration, (*from, *start_velocity), to)?
                        .peak_acceleration();
            }
            Self::LinearVelocity { from, duration, start_velocity, end_velocity } => {
                *end_velocity =
                    velocity::Line::reaching(*duration, (*from, *start_velocity), to)?.end_velocity();
            }
            Self::FairedVelocity { from, duration, velocity, rise, fall } => {
                *velocity = velocity::Faired::reaching(*duration, *from, to, (*rise, *fall))?.velocity();
            }
            other => {
                let kind = other.kind().map_or("a blend", |kind| kind.name);
                let instead = "only accelerations and velocities have an amplitude that follows from an end";
                return Err(ProfileError::NotFree { kind, parameter: "amplitude", instead });
            }
        }
        Ok(profile)
    }
}
