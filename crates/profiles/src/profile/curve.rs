//! The curve of any profile, which evaluates and answers.

use super::{Profile, ProfileLayer};
use crate::Elementary;
use crate::answers::{Answers, Peaks, Quantity, Stationary};
use crate::blend::{self, Blend};
use crate::clip::Clip;
use crate::curve::Curve;
use crate::error::{ProfileError, check_range};
use crate::polynomial::{CubicHermite, Quintic};
use crate::range::Range;
use crate::sample::{Boundary, Sample};
use crate::spline::{Bend, CubicSpline};
use crate::{acceleration, cyclic, displacement, legacy, limited, velocity};
use alloc::boxed::Box;
use alloc::vec::Vec;

/// The curve of any [`Profile`], ready to be evaluated.
#[derive(Clone, Debug)]
pub struct ProfileCurve<F: Elementary = f64>(Any<F>);

macro_rules! any {
    ($($variant:ident($curve:ty)),* $(,)?) => {
        #[derive(Clone, Debug)]
        enum Any<F: Elementary> {
            $($variant($curve),)*
        }

        $(impl<F: Elementary> From<$curve> for ProfileCurve<F> {
            fn from(curve: $curve) -> Self {
                Self(Any::$variant(curve))
            }
        })*

        impl<F: Elementary> Any<F> {
            #[inline]
            fn curve(&self) -> &dyn Curve<F> {
                match self {
                    $(Self::$variant(curve) => curve,)*
                }
            }
        }

        impl Any<f64> {
            fn answers(&self) -> &dyn Answers {
                match self {
                    $(Self::$variant(curve) => curve,)*
                }
            }
        }
    };
}

any! {
    Trigonometric(displacement::Trigonometric<F>),
    TrigonometricVelocities(displacement::TrigonometricVelocities<F>),
    Power(displacement::Power<F>),
    Exponential(displacement::Exponential<F>),
    ExponentialVelocities(Box<displacement::ExponentialVelocities<F>>),
    Hyperbolic(displacement::Hyperbolic<F>),
    Tension(displacement::Tension<F>),
    Line(displacement::Line<F>),
    LegacyHyperbolic(legacy::Hyperbolic<F>),
    ConstantAcceleration(acceleration::Constant<F>),
    TrigonometricAcceleration(acceleration::Trigonometric<F>),
    Ellipse(acceleration::Ellipse<F>),
    LinearVelocity(velocity::Line<F>),
    CircularVelocity(velocity::Circle<F>),
    FairedVelocity(velocity::Faired<F>),
    Quintic(Quintic<F>),
    CubicHermite(CubicHermite<F>),
    Trapezoidal(limited::Trapezoidal<F>),
    SCurve(limited::SCurve<F>),
    Spline(CubicSpline<F>),
    Blend(Box<Blend<ProfileCurve<F>, F>>),
    Sine(cyclic::Sine<F>),
    Repeat(Box<cyclic::Repeat<ProfileCurve<F>>>),
}

impl<F: Elementary> Curve<F> for ProfileCurve<F> {
    fn duration(&self) -> F {
        self.0.curve().duration()
    }

    fn span(&self) -> f64 {
        self.0.curve().span()
    }

    fn at(&self, t: F) -> Sample<F> {
        self.0.curve().at(t)
    }

    fn at_time(&self, t: f64) -> Sample<F> {
        self.0.curve().at_time(t)
    }

    fn before(&self, t: F) -> Sample<F> {
        self.0.curve().before(t)
    }

    fn extrapolated(&self, t: F) -> Sample<F> {
        self.0.curve().extrapolated(t)
    }
}

impl Answers for ProfileCurve {
    fn stationary(&self) -> Stationary {
        self.0.answers().stationary()
    }

    fn critical(&self, quantity: Quantity) -> Vec<f64> {
        self.0.answers().critical(quantity)
    }

    fn breaks(&self) -> Vec<f64> {
        self.0.answers().breaks()
    }

    fn range(&self, quantity: Quantity, from: f64, to: f64) -> (f64, f64) {
        self.0.answers().range(quantity, from, to)
    }

    fn peaks(&self) -> Peaks {
        self.0.answers().peaks()
    }
}

impl Profile {
    /// The curve, in the scalar asked for.
    ///
    /// # Errors
    ///
    /// What the constructor of that curve refuses.
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_profiles::{Curve, Profile};
    ///
    /// let curve = Profile::MinimumJerk { from: 0.0, to: 1.0, duration: 2.0 }.curve::<f32>()?;
    /// assert!((curve.at(1.0).velocity - 15.0 / 16.0).abs() < 1e-6);
    /// # Ok::<(), solaris_profiles::ProfileError>(())
    /// ```
    #[allow(clippy::too_many_lines, reason = "one arm for each kind")]
    pub fn curve<F: Elementary>(&self) -> Result<ProfileCurve<F>, ProfileError> {
        let f = F::from_f64;
        let pair = |x: f64, y: f64| (f(x), f(y));
        Ok(match *self {
            Self::Trigonometric { from, to, duration } => {
                displacement::Trigonometric::new(f(duration), f(from), f(to))?.into()
            }
            Self::TrigonometricVelocities { from, to, duration, start_velocity, end_velocity } => {
                let (start, end) = (pair(from, start_velocity), pair(to, end_velocity));
                displacement::TrigonometricVelocities::new(f(duration), start, end)?.into()
            }
            Self::Power { from, to, duration, exponent } => {
                displacement::Power::new(f(duration), f(from), f(to), f(exponent))?.into()
            }
            Self::Exponential { from, to, duration, exponent, shape } => {
                displacement::Exponential::new(f(duration), f(from), f(to), f(exponent), f(shape))?.into()
            }
            Self::ExponentialVelocities {
                from,
                to,
                duration,
                exponent,
                shape,
                start_velocity,
                end_velocity,
            } => {
                let (start, end) = (pair(from, start_velocity), pair(to, end_velocity));
                let exponent = whole("exponent", exponent)?;
                let curve =
                    displacement::ExponentialVelocities::new(f(duration), start, end, exponent, f(shape))?;
                Box::new(curve).into()
            }
            Self::Hyperbolic { from, to, duration, stiffness } => {
                displacement::Hyperbolic::new(f(duration), f(from), f(to), f(stiffness))?.into()
            }
            Self::Tension { from, to, duration, stiffness, start_velocity, end_velocity } => {
                let (start, end) = (pair(from, start_velocity), pair(to, end_velocity));
                displacement::Tension::new(f(duration), start, end, f(stiffness))?.into()
            }
            Self::Line { from, to, duration } => displacement::Line::new(f(duration), f(from), f(to))?.into(),
            Self::LegacyHyperbolic { from, to, duration, start_velocity, end_velocity } => {
                let (start, end) = (pair(from, start_velocity), pair(to, end_velocity));
                legacy::Hyperbolic::new(f(duration), start, end)?.into()
            }
            Self::ConstantAcceleration { from, duration, acceleration, start_velocity } => {
                acceleration::Constant::new(f(duration), pair(from, start_velocity), f(acceleration))?.into()
            }
            Self::TrigonometricAcceleration { from, duration, peak_acceleration, start_velocity } => {
                let start = pair(from, start_velocity);
                acceleration::Trigonometric::new(f(duration), start, f(peak_acceleration))?.into()
            }
            Self::QuarterEllipse { from, duration, middle_acceleration, start_velocity } => {
                let start = pair(from, start_velocity);
                acceleration::Ellipse::quarter(f(duration), start, f(middle_acceleration))?.into()
            }
            Self::HalfEllipse { from, duration, peak_acceleration, start_velocity } => {
                let start = pair(from, start_velocity);
                acceleration::Ellipse::half(f(duration), start, f(peak_acceleration))?.into()
            }
            Self::LinearVelocity { from, duration, start_velocity, end_velocity } => {
                velocity::Line::new(f(duration), f(from), pair(start_velocity, end_velocity))?.into()
            }
            Self::CircularVelocity {
                from,
                duration,
                third_time,
                third_velocity,
                start_velocity,
                end_velocity,
            } => {
                let (ends, third) = (pair(start_velocity, end_velocity), pair(third_time, third_velocity));
                velocity::Circle::new(f(duration), f(from), ends, third)?.into()
            }
            Self::FairedVelocity { from, duration, velocity, rise, fall } => {
                velocity::Faired::new(f(duration), f(from), f(velocity), pair(rise, fall))?.into()
            }
            Self::MinimumJerk { from, to, duration } => {
                Quintic::minimum_jerk(f(duration), f(from), f(to))?.into()
            }
            Self::Quintic {
                from,
                to,
                duration,
                start_velocity,
                end_velocity,
                start_acceleration,
                end_acceleration,
            } => {
                let start = Boundary::new(f(from), f(start_velocity), f(start_acceleration));
                let end = Boundary::new(f(to), f(end_velocity), f(end_acceleration));
                Quintic::new(f(duration), start, end)?.into()
            }
            Self::CubicHermite { from, to, duration, start_velocity, end_velocity } => {
                CubicHermite::new(f(duration), pair(from, start_velocity), pair(to, end_velocity))?.into()
            }
            Self::Trapezoidal { from, to, largest_velocity, largest_acceleration } => {
                let (velocity, acceleration) = pair(largest_velocity, largest_acceleration);
                limited::Trapezoidal::new(f(from), f(to), velocity, acceleration)?.into()
            }
            Self::SCurve { from, to, largest_velocity, largest_acceleration, largest_jerk } => {
                let (velocity, acceleration) = pair(largest_velocity, largest_acceleration);
                limited::SCurve::new(f(from), f(to), velocity, acceleration, f(largest_jerk))?.into()
            }
            Self::CatmullRom { ref keys } => CubicSpline::catmull_rom(&converted(keys))?.into(),
            Self::Centripetal { ref keys } => CubicSpline::centripetal(&converted(keys))?.into(),
            Self::MonotoneCubic { ref keys } => CubicSpline::monotone(&converted(keys))?.into(),
            Self::KochanekBartels { ref keys, tension, continuity, bias, start_velocity, end_velocity } => {
                let bend = Bend { tension: f(tension), continuity: f(continuity), bias: f(bias) };
                let ends = pair(start_velocity, end_velocity);
                CubicSpline::kochanek_bartels(&converted(keys), bend, ends)?.into()
            }
            Self::NaturalSpline { ref keys } => CubicSpline::natural(&converted(keys))?.into(),
            Self::ClampedSpline { ref keys, start_velocity, end_velocity } => {
                CubicSpline::clamped(&converted(keys), f(start_velocity), f(end_velocity))?.into()
            }
            Self::Blend { ref first, ref second, fade, leaving } => {
                self.check_depth()?;
                Box::new(Blend::between(first.clip()?, second.clip()?, fade, leaving)?).into()
            }
            Self::Weighted { ref layers } => {
                self.check_depth()?;
                let layers = layers.iter().map(ProfileLayer::weighted).collect::<Result<Vec<_>, _>>()?;
                Box::new(Blend::weighted(layers)?).into()
            }
            Self::Sine { amplitude, period, cycles, phase, offset } => {
                cyclic::Sine::new(f(amplitude), f(period), cycles, f(phase), f(offset))?.into()
            }
            Self::Repeat { ref of, times } => {
                cyclic::check_times("times", f64::from(times) * of.laps(), 1.0)?;
                Box::new(cyclic::Repeat::new(of.curve()?, times)?).into()
            }
        })
    }
}

impl ProfileLayer {
    fn clip<F: Elementary>(&self) -> Result<Clip<ProfileCurve<F>, F>, ProfileError> {
        Ok(Clip::new(self.profile.curve()?).starting(self.start)?.outside(self.outside))
    }

    fn weighted<F: Elementary>(&self) -> Result<blend::Layer<ProfileCurve<F>, F>, ProfileError> {
        Ok(blend::Layer {
            clip: self.clip()?,
            amount: self.amount,
            fade_in: self.fade_in,
            fade_out: self.fade_out,
        })
    }
}

/// The most blends that may stand in each other: answers about each are found from those about the motions within.
const MOST_IN_EACH_OTHER: f64 = 6.0;

impl Profile {
    /// Refuses blends that stand deeper in each other than their answers can be found in a moment.
    fn check_depth(&self) -> Result<(), ProfileError> {
        check_range("number of blends in each other", self.depth() as f64, Range::at_most(MOST_IN_EACH_OTHER))
    }

    /// How many blends stand in each other.
    fn depth(&self) -> usize {
        let deepest = |layers: &mut dyn Iterator<Item = &ProfileLayer>| {
            1 + layers.map(|layer| layer.profile.depth()).max().unwrap_or_default()
        };
        match self {
            Self::Blend { first, second, .. } => deepest(&mut [&**first, &**second].into_iter()),
            Self::Weighted { layers } => deepest(&mut layers.iter()),
            Self::Repeat { of, .. } => of.depth(),
            _ => 0,
        }
    }

    /// How often something in it comes again, one in another counted as often as both together.
    fn laps(&self) -> f64 {
        match self {
            Self::Sine { cycles, .. } => cycles.max(1.0),
            Self::Repeat { of, times } => f64::from(*times) * of.laps(),
            _ => 1.0,
        }
    }
}

/// Keys with their positions in the scalar of the curve.
fn converted<F: Elementary>(keys: &[(f64, f64)]) -> Vec<(f64, F)> {
    keys.iter().map(|&(time, position)| (time, F::from_f64(position))).collect()
}

/// A whole number that is not negative.
pub(super) fn whole(what: &'static str, value: f64) -> Result<u32, ProfileError> {
    check_range(what, value, Range::closed(0.0, f64::from(u32::MAX)))?;
    let whole = value as u32;
    if f64::from(whole) < value { Err(ProfileError::NotWhole { what, value }) } else { Ok(whole) }
}
