//! The parameters of all kinds of profiles.

use crate::range::Range;
use alloc::string::String;
use core::fmt;

/// The dimension of a parameter, where positions are in some unit (rad, m) and times in s.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A position.
    Position,
    /// A position over a time.
    Velocity,
    /// A position over a time squared.
    Acceleration,
    /// A position over a time cubed.
    Jerk,
    /// A time.
    Time,
    /// A number without a unit.
    Number,
}

/// Its unit, of positions in `x`: "x/s".
impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Position => "x",
            Self::Velocity => "x/s",
            Self::Acceleration => "x/s²",
            Self::Jerk => "x/s³",
            Self::Time => "s",
            Self::Number => "",
        })
    }
}

/// A parameter of a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its name in words: "start velocity". Its field has underscores in place of spaces.
    pub name: &'static str,
    /// Its symbol: "v0".
    pub symbol: &'static str,
    /// What it measures.
    pub measure: Measure,
    /// What it may be, whatever the other parameters are.
    pub range: Range,
    /// What it is in a few words.
    pub summary: &'static str,
}

impl Parameter {
    /// Its name in texts: "`start_velocity`".
    pub fn field(&self) -> String {
        self.name.replace(' ', "_")
    }
}

macro_rules! parameters {
    ($($id:ident $name:literal $symbol:literal $measure:ident $range:expr, $summary:literal;)*) => {
        impl Parameter {
            $(
                #[doc = concat!($summary, " (", $symbol, ").")]
                pub const $id: Self = Self {
                    name: $name,
                    symbol: $symbol,
                    measure: Measure::$measure,
                    range: $range,
                    summary: $summary,
                };
            )*

            /// All parameters that a profile may have.
            pub const ALL: &'static [&'static Self] = &[$(&Self::$id),*];
        }
    };
}

parameters! {
    FROM "from" "x0" Position Range::ALL, "Position at the beginning";
    TO "to" "x1" Position Range::ALL, "Position at the end";
    DURATION "duration" "T" Time Range::POSITIVE, "How long it lasts";
    START_VELOCITY "start velocity" "v0" Velocity Range::ALL, "Velocity at the beginning";
    END_VELOCITY "end velocity" "v1" Velocity Range::ALL, "Velocity at the end";
    START_ACCELERATION "start acceleration" "a0" Acceleration Range::ALL, "Acceleration at the beginning";
    END_ACCELERATION "end acceleration" "a1" Acceleration Range::ALL, "Acceleration at the end";
    EXPONENT "exponent" "n" Number Range::at_least(1.0), "Exponent: the larger, the later the motion";
    WHOLE_EXPONENT "exponent" "n" Number Range::closed(3.0, 100.0), "Exponent, a whole number";
    SHAPE "shape" "s" Number Range::ALL, "Where the power has its root: at duration/shape";
    STIFFNESS "stiffness" "k" Number Range::NOT_NEGATIVE, "Stiffness: 0 is a polynomial; the larger, the sharper the bends";
    ACCELERATION "acceleration" "a" Acceleration Range::ALL, "The acceleration";
    PEAK_ACCELERATION "peak acceleration" "am" Acceleration Range::ALL, "The greatest acceleration, halfway";
    MIDDLE_ACCELERATION "middle acceleration" "am" Acceleration Range::ALL, "The acceleration halfway";
    THIRD_TIME "third time" "T1" Time Range::POSITIVE, "When the third velocity is met";
    THIRD_VELOCITY "third velocity" "vm" Velocity Range::ALL, "The velocity at the third time";
    VELOCITY "velocity" "V" Velocity Range::ALL, "The velocity between rise and fall";
    RISE "rise" "T1" Time Range::NOT_NEGATIVE, "When the velocity has risen";
    FALL "fall" "T2" Time Range::NOT_NEGATIVE, "When the velocity begins to fall";
    LARGEST_VELOCITY "largest velocity" "vmax" Velocity Range::POSITIVE, "Limit of the velocity";
    LARGEST_ACCELERATION "largest acceleration" "amax" Acceleration Range::POSITIVE, "Limit of the acceleration";
    LARGEST_JERK "largest jerk" "jmax" Jerk Range::POSITIVE, "Limit of the jerk";
    TENSION "tension" "tension" Number Range::ALL, "Tension at the keys: 1 stops there, less than 0 swings out";
    CONTINUITY "continuity" "continuity" Number Range::ALL, "Continuity at the keys: other than 0, the velocity jumps";
    BIAS "bias" "bias" Number Range::ALL, "Bias at the keys: more than 0 overshoots, less undershoots";
}
