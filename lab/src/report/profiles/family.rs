//! The pairs: each curve as it is printed, beside the library's.

use super::printed::{self, Number, Printed};
use super::reference::Parameters;
use solaris_profiles::blend::{Fade, FadeKind};
use solaris_profiles::{Clip, Curve, Elementary, ProfileError, acceleration, displacement, velocity};

/// A kind of curve in both forms.
pub(super) trait Family {
    /// What the reference calls the profile of each.
    const PROFILES: [&'static str; 2];

    type Printed<F: Number>: Printed<F>;
    type Stable<F: Number + Elementary>: Stable<F>;

    fn printed<F: Number>(given: &Parameters<F>) -> Self::Printed<F>;

    fn stable<F: Number + Elementary>(given: &Parameters<F>) -> Result<Self::Stable<F>, ProfileError>;
}

/// What is asked of the library's form.
pub(super) trait Stable<F> {
    /// The kind of number that it takes times in.
    type Time: Copy;

    fn time(t: f64) -> Self::Time;

    /// Position, velocity, acceleration and jerk.
    fn at(&self, t: Self::Time) -> [F; 4];
}

/// A curve that begins at time 0.
pub(super) struct Motion<C>(C);

impl<F: Elementary, C: Curve<F>> Stable<F> for Motion<C> {
    type Time = F;

    fn time(t: f64) -> F {
        F::from_f64(t)
    }

    #[inline]
    fn at(&self, t: F) -> [F; 4] {
        Curve::at(&self.0, t).to_array()
    }
}

impl<F: Elementary> Stable<F> for Fade {
    type Time = f64;

    fn time(t: f64) -> f64 {
        t
    }

    #[inline]
    fn at(&self, t: f64) -> [F; 4] {
        self.alpha(t)
    }
}

impl<F: Elementary, C: Curve<F>> Stable<F> for Clip<C, F> {
    type Time = f64;

    fn time(t: f64) -> f64 {
        t
    }

    #[inline]
    fn at(&self, t: f64) -> [F; 4] {
        Clip::at(self, t).to_array()
    }
}

/// A family of curves that begin at time 0: its name, the profiles of the file, the forms and how they are made.
macro_rules! motion {
    ($name:ident, $profiles:expr, $printed:ident, $stable:ty, |$given:ident| $first:expr, $second:expr) => {
        pub(super) struct $name;

        impl Family for $name {
            const PROFILES: [&'static str; 2] = $profiles;

            type Printed<F: Number> = printed::$printed<F>;
            type Stable<F: Number + Elementary> = Motion<$stable>;

            #[inline]
            fn printed<F: Number>($given: &Parameters<F>) -> Self::Printed<F> {
                $first
            }

            #[inline]
            fn stable<F: Number + Elementary>(
                $given: &Parameters<F>,
            ) -> Result<Self::Stable<F>, ProfileError> {
                $second.map(Motion)
            }
        }
    };
}

motion!(
    Trigonometric,
    ["disp_trig"; 2],
    Trigonometric,
    displacement::Trigonometric<F>,
    |given| printed::Trigonometric::new(given.duration, given.from, given.to),
    displacement::Trigonometric::new(given.duration, given.from, given.to)
);
motion!(
    TrigonometricVelocities,
    ["disp_trig_vel"; 2],
    TrigonometricVelocities,
    displacement::TrigonometricVelocities<F>,
    |given| printed::TrigonometricVelocities::new(
        given.duration,
        (given.from, given.v0),
        (given.to, given.v1)
    ),
    displacement::TrigonometricVelocities::new(given.duration, (given.from, given.v0), (given.to, given.v1))
);
motion!(
    Exponential,
    ["disp_exp_s"; 2],
    Exponential,
    displacement::Exponential<F>,
    |given| printed::Exponential::new(given.duration, given.from, given.to, given.n.into(), given.s),
    displacement::Exponential::new(
        given.duration,
        given.from,
        given.to,
        F::from_f64(f64::from(given.n)),
        given.s
    )
);
motion!(
    ExponentialVelocities,
    ["disp_exp_vel"; 2],
    ExponentialVelocities,
    displacement::ExponentialVelocities<F>,
    |given| printed::ExponentialVelocities::new(
        given.duration,
        (given.from, given.v0),
        (given.to, given.v1),
        given.n.into(),
        given.s
    ),
    displacement::ExponentialVelocities::new(
        given.duration,
        (given.from, given.v0),
        (given.to, given.v1),
        given.n.into(),
        given.s
    )
);
motion!(
    HyperbolicVelocities,
    ["disp_sinh_vel_thesis", "disp_tension"],
    HyperbolicVelocities,
    displacement::Tension<F>,
    |given| printed::HyperbolicVelocities::new(given.duration, (given.from, given.v0), (given.to, given.v1)),
    displacement::Tension::new(given.duration, (given.from, given.v0), (given.to, given.v1), given.stiffness)
);
motion!(
    Sine,
    ["acc_trig"; 2],
    Sine,
    acceleration::Trigonometric<F>,
    |given| printed::Sine::new(given.duration, (given.from, given.v0), given.middle),
    acceleration::Trigonometric::new(given.duration, (given.from, given.v0), given.middle)
);
motion!(
    QuarterEllipse,
    ["acc_ellipse_quarter"; 2],
    QuarterEllipse,
    acceleration::Ellipse<F>,
    |given| printed::QuarterEllipse::new(given.duration, (given.from, given.v0), given.middle),
    acceleration::Ellipse::quarter(given.duration, (given.from, given.v0), given.middle)
);
motion!(
    Circle,
    ["vel_circle"; 2],
    Circle,
    velocity::Circle<F>,
    |given| printed::Circle::new(
        given.duration,
        given.from,
        (given.v0, given.v1),
        (given.third_time, given.third_velocity)
    ),
    velocity::Circle::new(
        given.duration,
        given.from,
        (given.v0, given.v1),
        (given.third_time, given.third_velocity)
    )
);

/// A fade of the thesis: its name, the profile of the file, the printed form and the library's.
macro_rules! fade {
    ($name:ident, $profile:expr, $kind:ident) => {
        pub(super) struct $name;

        impl Family for $name {
            const PROFILES: [&'static str; 2] = [$profile; 2];

            type Printed<F: Number> = printed::$name<F>;
            type Stable<F: Number + Elementary> = Fade;

            #[inline]
            fn printed<F: Number>(given: &Parameters<F>) -> Self::Printed<F> {
                printed::$name::new(given.start, given.end)
            }

            #[inline]
            fn stable<F: Number + Elementary>(given: &Parameters<F>) -> Result<Fade, ProfileError> {
                Fade::thesis(FadeKind::$kind { stiffness: 0.0 }, given.start.value(), given.end.value())
            }
        }
    };
}

fade!(SinhFade, "fade_sinh", Sinh);
fade!(ExponentialFade, "fade_exp", Exponential);

/// A line somewhere in time.
pub(super) struct Placed;

impl Family for Placed {
    const PROFILES: [&'static str; 2] = ["clip"; 2];

    type Printed<F: Number> = printed::Share<F>;
    type Stable<F: Number + Elementary> = Clip<displacement::Line<F>, F>;

    fn printed<F: Number>(given: &Parameters<F>) -> Self::Printed<F> {
        printed::Share { start: given.start, duration: given.duration }
    }

    fn stable<F: Number + Elementary>(given: &Parameters<F>) -> Result<Self::Stable<F>, ProfileError> {
        let line = displacement::Line::new(given.duration, F::from_f64(0.0), F::from_f64(1.0))?;
        Clip::new(line).starting(given.start.value())
    }
}
