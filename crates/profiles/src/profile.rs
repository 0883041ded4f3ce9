//! All kinds of curves as values of one type, which can be listed, written and read.

mod curve;
mod kind;
mod parameter;
mod questions;

pub use curve::ProfileCurve;
pub use kind::{Family, Kind};
pub use parameter::{Measure, Parameter};

use crate::blend::{Fade, Leaving};
use crate::clip::Outside;
use alloc::boxed::Box;
use alloc::vec::Vec;

/// The type, the table of its kinds and the ways between values and names, from one list.
///
/// An entry is `Variant "name" Family, "summary", [required parameters], [parameters that are zero when not given]`.
macro_rules! profiles {
    (
        curves: {$(
            $variant:ident $name:literal $family:ident, $summary:literal,
            [$($field:ident: $parameter:ident),*], [$($option:ident: $default:ident),*];
        )*}
        through_keys: {$(
            $spline:ident $spline_name:literal, $spline_summary:literal,
            [$($spline_option:ident: $spline_default:ident),*];
        )*}
    ) => {
        /// A curve as it is asked for: which kind, and its parameters. Nothing is checked before [`Profile::curve`].
        ///
        /// With the feature `text` it can be written and read as a text, with the feature `serde` in other ways too; parameters
        /// that are zero may be left out:
        ///
        /// ```text
        /// Tension(from: 0.0, to: 1.2, duration: 0.8, stiffness: 3.0, end_velocity: 0.5)
        /// ```
        ///
        /// [`Profile::KINDS`] describes all kinds: names, parameters, units and ranges.
        #[doc(alias = "easing")]
        #[doc(alias = "motion profile")]
        #[doc(alias = "trajectory")]
        #[derive(Clone, Debug, PartialEq)]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
        #[non_exhaustive]
        pub enum Profile {
            $(
                #[doc = concat!($summary, ".")]
                $variant {
                    $(#[doc = concat!("[`Parameter::", stringify!($parameter), "`].")] $field: f64,)*
                    $(
                        #[doc = concat!("[`Parameter::", stringify!($default), "`].")]
                        #[cfg_attr(feature = "serde", serde(default))]
                        $option: f64,
                    )*
                },
            )*
            $(
                #[doc = concat!($spline_summary, ".")]
                $spline {
                    /// Times (s), rising, and positions.
                    keys: Vec<(f64, f64)>,
                    $(
                        #[doc = concat!("[`Parameter::", stringify!($spline_default), "`].")]
                        #[cfg_attr(feature = "serde", serde(default))]
                        $spline_option: f64,
                    )*
                },
            )*
            /// One motion fades into another.
            Blend {
                /// What fades out.
                first: Box<ProfileLayer>,
                /// What fades in.
                second: Box<ProfileLayer>,
                /// When and how.
                fade: Fade,
                /// What to do where the share of the first leaves 0 to 1.
                #[cfg_attr(feature = "serde", serde(default))]
                leaving: Leaving,
            },
            /// The mean of two motions or more, with weights that may fade in and out.
            Weighted {
                /// The motions.
                layers: Vec<ProfileLayer>,
            },
            /// A sine about an offset; see [`Sine`](crate::cyclic::Sine).
            Sine {
                /// How far to either side (rad or m).
                amplitude: f64,
                /// How long one cycle takes (s).
                period: f64,
                /// How many cycles, whole or not.
                cycles: f64,
                /// Where in its cycle it begins (rad).
                #[cfg_attr(feature = "serde", serde(default))]
                phase: f64,
                /// Its middle (rad or m).
                #[cfg_attr(feature = "serde", serde(default))]
                offset: f64,
            },
            /// A motion several times, one after the other; see [`Repeat`](crate::cyclic::Repeat).
            Repeat {
                /// The motion.
                of: Box<Profile>,
                /// How many times.
                times: u32,
            },
        }

        impl Profile {
            /// All kinds, in the order of the thesis, then those it has not.
            pub const KINDS: &'static [Kind] = &[
                $(Kind {
                    name: $name,
                    variant: stringify!($variant),
                    family: Family::$family,
                    summary: $summary,
                    required: &[$(&Parameter::$parameter),*],
                    optional: &[$(&Parameter::$default),*],
                    make: |get, _| Self::$variant {
                        $($field: get(&Parameter::$parameter),)* $($option: get(&Parameter::$default),)*
                    },
                },)*
                $(Kind {
                    name: $spline_name,
                    variant: stringify!($spline),
                    family: Family::Keys,
                    summary: $spline_summary,
                    required: &[],
                    optional: &[$(&Parameter::$spline_default),*],
                    make: |get, keys| {
                        let _ = &get;
                        Self::$spline { keys, $($spline_option: get(&Parameter::$spline_default),)* }
                    },
                },)*
            ];

            /// The name of its variant, as it is written: `MinimumJerk`.
            pub fn variant(&self) -> &'static str {
                match self {
                    $(Self::$variant { .. } => stringify!($variant),)*
                    $(Self::$spline { .. } => stringify!($spline),)*
                    Self::Blend { .. } => "Blend",
                    Self::Weighted { .. } => "Weighted",
                    Self::Sine { .. } => "Sine",
                    Self::Repeat { .. } => "Repeat",
                }
            }

            /// Its parameters with their values; a blend, a sine and what is repeated have none in this list.
            pub fn values(&self) -> Vec<(&'static Parameter, f64)> {
                match self {
                    $(Self::$variant { $($field,)* $($option,)* } => alloc::vec![
                        $((&Parameter::$parameter, *$field),)* $((&Parameter::$default, *$option),)*
                    ],)*
                    $(Self::$spline { $($spline_option,)* .. } => alloc::vec![
                        $((&Parameter::$spline_default, *$spline_option),)*
                    ],)*
                    Self::Blend { .. } | Self::Weighted { .. } | Self::Sine { .. } | Self::Repeat { .. } => {
                        Vec::new()
                    }
                }
            }
        }
    };
}

profiles! {
    curves: {
    Trigonometric "trigonometric" Displacement, "From rest to rest along half a cosine",
        [from: FROM, to: TO, duration: DURATION], [];
    TrigonometricVelocities "trigonometric-velocities" Displacement, "A sine on a line, with both end velocities",
        [from: FROM, to: TO, duration: DURATION], [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    Power "power" Displacement, "A power of the time: from rest, ever faster",
        [from: FROM, to: TO, duration: DURATION, exponent: EXPONENT], [];
    Exponential "exponential" Displacement, "A power of the time with its root moved by the shape",
        [from: FROM, to: TO, duration: DURATION, exponent: EXPONENT, shape: SHAPE], [];
    ExponentialVelocities "exponential-velocities" Displacement, "Three powers, with both end velocities",
        [from: FROM, to: TO, duration: DURATION, exponent: WHOLE_EXPONENT, shape: SHAPE],
        [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    Hyperbolic "hyperbolic" Displacement, "A hyperbolic sine: like a line at first, ever faster",
        [from: FROM, to: TO, duration: DURATION, stiffness: STIFFNESS], [];
    Tension "tension" Displacement, "Hyperbolic with both end velocities, from the cubic to the line",
        [from: FROM, to: TO, duration: DURATION, stiffness: STIFFNESS],
        [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    Line "line" Displacement, "Constant velocity",
        [from: FROM, to: TO, duration: DURATION], [];
    LegacyHyperbolic "legacy-hyperbolic" Displacement, "The thesis's own hyperbolic basis; its shape depends on the unit of time",
        [from: FROM, to: TO, duration: DURATION], [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    ConstantAcceleration "constant-acceleration" Acceleration, "Constant acceleration",
        [from: FROM, duration: DURATION, acceleration: ACCELERATION], [start_velocity: START_VELOCITY];
    TrigonometricAcceleration "trigonometric-acceleration" Acceleration, "The acceleration is half a sine",
        [from: FROM, duration: DURATION, peak_acceleration: PEAK_ACCELERATION], [start_velocity: START_VELOCITY];
    QuarterEllipse "quarter-ellipse" Acceleration, "The acceleration rises along a quarter of an ellipse",
        [from: FROM, duration: DURATION, middle_acceleration: MIDDLE_ACCELERATION], [start_velocity: START_VELOCITY];
    HalfEllipse "half-ellipse" Acceleration, "The acceleration rises and falls along half an ellipse",
        [from: FROM, duration: DURATION, peak_acceleration: PEAK_ACCELERATION], [start_velocity: START_VELOCITY];
    LinearVelocity "linear-velocity" Velocity, "The velocity changes along a line",
        [from: FROM, duration: DURATION], [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    CircularVelocity "circular-velocity" Velocity, "The velocity follows an arc of a circle through a third point",
        [from: FROM, duration: DURATION, third_time: THIRD_TIME, third_velocity: THIRD_VELOCITY],
        [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    FairedVelocity "faired-velocity" Velocity, "Constant velocity between two quarters of a sine, from rest to rest",
        [from: FROM, duration: DURATION, velocity: VELOCITY, rise: RISE, fall: FALL], [];
    MinimumJerk "minimum-jerk" Polynomial, "From rest to rest with the least jerk",
        [from: FROM, to: TO, duration: DURATION], [];
    Quintic "quintic" Polynomial, "Degree five: position, velocity and acceleration at both ends",
        [from: FROM, to: TO, duration: DURATION],
        [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY,
         start_acceleration: START_ACCELERATION, end_acceleration: END_ACCELERATION];
    CubicHermite "cubic" Polynomial, "Degree three: position and velocity at both ends",
        [from: FROM, to: TO, duration: DURATION], [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    Trapezoidal "trapezoidal" Limits, "From rest to rest in the least time between limits of velocity and acceleration",
        [from: FROM, to: TO, largest_velocity: LARGEST_VELOCITY, largest_acceleration: LARGEST_ACCELERATION], [];
    SCurve "s-curve" Limits, "The same with a limit of the jerk: seven phases",
        [from: FROM, to: TO, largest_velocity: LARGEST_VELOCITY, largest_acceleration: LARGEST_ACCELERATION,
         largest_jerk: LARGEST_JERK], [];
    }
    through_keys: {
    CatmullRom "catmull-rom", "Through keys, with the velocity of the chord between the neighbours", [];
    Centripetal "centripetal", "Catmull-Rom that follows the shorter move at each key", [];
    MonotoneCubic "monotone-cubic", "Through keys, turning only at keys", [];
    KochanekBartels "kochanek-bartels", "Through keys, with tension, continuity and bias",
        [tension: TENSION, continuity: CONTINUITY, bias: BIAS, start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    NaturalSpline "natural-spline", "Through keys with continuous acceleration, which is zero at the ends", [];
    ClampedSpline "clamped-spline", "Through keys with continuous acceleration and given end velocities",
        [start_velocity: START_VELOCITY, end_velocity: END_VELOCITY];
    }
}

/// A profile as a part of a blend.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct ProfileLayer {
    /// The motion.
    pub profile: Profile,
    /// When it begins (s).
    #[cfg_attr(feature = "serde", serde(default))]
    pub start: f64,
    /// What it does before and after.
    #[cfg_attr(feature = "serde", serde(default))]
    pub outside: Outside,
    /// Its weight beside the others of [`Profile::Weighted`].
    #[cfg_attr(feature = "serde", serde(default = "one"))]
    pub amount: f64,
    /// Its weight rises from zero in this window.
    #[cfg_attr(feature = "serde", serde(default))]
    pub fade_in: Option<Fade>,
    /// Its weight falls to zero in this window.
    #[cfg_attr(feature = "serde", serde(default))]
    pub fade_out: Option<Fade>,
}

#[cfg(feature = "serde")]
fn one() -> f64 {
    1.0
}

impl From<Profile> for ProfileLayer {
    fn from(profile: Profile) -> Self {
        Self { profile, start: 0.0, outside: Outside::Hold, amount: 1.0, fade_in: None, fade_out: None }
    }
}
