//! The parameters of a style that a user may set, each with its unit, range and default.

use crate::error::RequestError;
use crate::request::pace;
use crate::smooth::style::Style;

/// In what a parameter is written by people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Degrees; rad in a [`Style`].
    Degrees,
    /// Metres.
    Metres,
}

impl Unit {
    /// What stands behind a number.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Degrees => "°",
            Self::Metres => " m",
        }
    }

    /// The last place in which a value is told to people.
    pub(super) fn place(self) -> f64 {
        match self {
            Self::Degrees => 0.1,
            Self::Metres => 1e-3,
        }
    }

    fn to_si(self, value: f64) -> f64 {
        match self {
            Self::Degrees => value.to_radians(),
            Self::Metres => value,
        }
    }

    fn of_si(self, value: f64) -> f64 {
        match self {
            Self::Degrees => value.to_degrees(),
            Self::Metres => value,
        }
    }
}

/// One parameter.
#[derive(Debug)]
pub struct Parameter {
    /// Its name, in words.
    pub name: &'static str,
    /// Its symbol in the field, if it has one.
    pub symbol: &'static str,
    /// What it is.
    pub help: &'static str,
    /// Its unit.
    pub unit: Unit,
    /// Least and greatest value, in that unit.
    pub range: (f64, f64),
    place: fn(&mut Style) -> &mut f64,
}

/// All parameters. Those not given follow the step frequency and the step length as people's do.
pub const PARAMETERS: &[Parameter] = &[
    Parameter {
        name: "heel-strike-angle",
        symbol: "θ",
        help: "pitch of the foot at contact, toe up",
        unit: Unit::Degrees,
        range: (8.0, 26.0),
        place: |s| &mut s.heel_strike_angle,
    },
    Parameter {
        name: "rotation",
        symbol: "τ",
        help: "turn of the pelvis at contact, leading hip forward",
        unit: Unit::Degrees,
        range: (0.0, 12.0),
        place: |s| &mut s.pelvic_rotation,
    },
    Parameter {
        name: "tilt",
        symbol: "δ",
        help: "amplitude of the pelvis' side tilt (obliquity); the peak is about 0.92 of it",
        unit: Unit::Degrees,
        range: (0.0, 7.0),
        place: |s| &mut s.pelvic_obliquity,
    },
    Parameter {
        name: "anterior-tilt",
        symbol: "",
        help: "mean forward tilt of the pelvis",
        unit: Unit::Degrees,
        range: (-5.0, 15.0),
        place: |s| &mut s.anterior_tilt,
    },
    Parameter {
        name: "flexion",
        symbol: "χ",
        help: "pitch of the standing shank when the hip is above its ankle, at least; the body is lowered to it",
        unit: Unit::Degrees,
        range: (0.0, 12.0),
        place: |s| &mut s.flexion,
    },
    Parameter {
        name: "clearance",
        symbol: "d",
        help: "least height of the swinging foot over the ground in mid-swing",
        unit: Unit::Metres,
        range: (0.0, 0.05),
        place: |s| &mut s.clearance,
    },
    Parameter {
        name: "step-width",
        symbol: "w",
        help: "distance of the heels' lines",
        unit: Unit::Metres,
        range: (0.04, 0.20),
        place: |s| &mut s.step_width,
    },
    Parameter {
        name: "foot-yaw",
        symbol: "ψ",
        help: "outward turn of the feet",
        unit: Unit::Degrees,
        range: (0.0, 15.0),
        place: |s| &mut s.foot_yaw,
    },
    Parameter {
        name: "toe-roll",
        symbol: "",
        help: "pitch of the toes at toe-off",
        unit: Unit::Degrees,
        range: (28.0, 45.0),
        place: |s| &mut s.toe_roll,
    },
    Parameter {
        name: "swing-knee",
        symbol: "",
        help: "greatest flexion of the swinging knee",
        unit: Unit::Degrees,
        range: (55.0, 75.0),
        place: |s| &mut s.knee_peak,
    },
    Parameter {
        name: "arm-swing",
        symbol: "",
        help: "amplitude of the shoulders' flexion",
        unit: Unit::Degrees,
        range: (0.0, 45.0),
        place: |s| &mut s.arm_swing,
    },
    Parameter {
        name: "thorax-lean",
        symbol: "",
        help: "forward lean of the thorax",
        unit: Unit::Degrees,
        range: (-5.0, 10.0),
        place: |s| &mut s.thorax_lean,
    },
    Parameter {
        name: "thorax-rotation",
        symbol: "",
        help: "turn of the thorax against the pelvis' turn",
        unit: Unit::Degrees,
        range: (0.0, 12.0),
        place: |s| &mut s.thorax_yaw,
    },
];

impl Parameter {
    /// The parameter called `name`.
    pub fn named(name: &str) -> Option<&'static Self> {
        PARAMETERS.iter().find(|parameter| parameter.name == name)
    }

    /// Its value in a style, in its unit.
    pub fn get(&self, style: &Style) -> f64 {
        let mut copy = *style;
        self.unit.of_si(*(self.place)(&mut copy))
    }

    /// Sets it in a style, in its unit.
    ///
    /// # Errors
    ///
    /// A value out of range.
    pub fn set(&self, style: &mut Style, value: f64) -> Result<(), RequestError> {
        pace::range(self.name, value, self.unit.symbol(), self.range, String::new)?;
        *(self.place)(style) = self.unit.to_si(value);
        Ok(())
    }
}
