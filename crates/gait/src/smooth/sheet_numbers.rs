//! The numbers of a style that a sheet may change, each with its unit and range.

use crate::error::RequestError;
use crate::request::pace;
use crate::request::sheet::{CADENCE, Change, STEP_LENGTH, StyleSheet};
use crate::smooth::parameter::Parameter;
use crate::smooth::style::Style;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// In what a number of a sheet is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SheetUnit {
    /// Degrees.
    Degrees,
    /// Metres.
    Metres,
    /// None: a part of something.
    Part,
    /// None, and it is multiplied alone.
    Factor,
}

impl SheetUnit {
    /// What stands behind a number.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Degrees => "°",
            Self::Metres => " m",
            Self::Part | Self::Factor => "",
        }
    }
}

/// A number that a sheet may change.
#[derive(Debug)]
pub struct SheetNumber {
    /// Its name in a sheet.
    pub name: &'static str,
    /// What it is.
    pub help: &'static str,
    /// Its unit.
    pub unit: SheetUnit,
    /// Least and greatest value after the change, in that unit; of a factor, of the factor itself.
    pub range: (f64, f64),
    place: Place,
}

#[derive(Debug)]
enum Place {
    /// Of the pace.
    Pace,
    /// A parameter of the style by its own name.
    Parameter(&'static str),
    DoubleSupport,
    /// Of the thorax to the side.
    Bend,
    Number(fn(&mut Style) -> &mut f64),
}

/// Changes how long both feet stand by some part of the stride. The body is farther ahead when the foot leaves then, and the leg the
/// longer: its knee is straighter at toe-off by as much as it would have bent in that time, or the foot would have to point down
/// without end.
pub(super) fn stand_longer(style: &mut Style, by: f64) {
    style.double_support += by;
    style.knee_toe_off -= by * style.knee_toe_off_rate;
}

/// A row that is a parameter of the style, too.
const fn parameter(
    name: &'static str,
    of: &'static str,
    unit: SheetUnit,
    range: (f64, f64),
    help: &'static str,
) -> SheetNumber {
    SheetNumber { name, help, unit, range, place: Place::Parameter(of) }
}

const fn number(
    name: &'static str,
    unit: SheetUnit,
    range: (f64, f64),
    help: &'static str,
    place: fn(&mut Style) -> &mut f64,
) -> SheetNumber {
    SheetNumber { name, help, unit, range, place: Place::Number(place) }
}

use SheetUnit::{Degrees, Factor, Metres, Part};

/// All numbers that a sheet may change. Those that are options of a walk have the options' names with `_`, and the options' ranges.
pub const SHEET_NUMBERS: &[SheetNumber] = &[
    SheetNumber {
        name: STEP_LENGTH,
        help: "step length over the population's at the same step frequency",
        unit: Factor,
        range: (0.6, 1.12),
        place: Place::Pace,
    },
    SheetNumber {
        name: CADENCE,
        help: "step frequency where no pace is asked for, over the usual one",
        unit: Factor,
        range: (0.6, 1.15),
        place: Place::Pace,
    },
    parameter(
        "heel_strike_angle",
        "heel-strike-angle",
        Degrees,
        (8.0, 26.0),
        "pitch of the foot at contact, toe up",
    ),
    parameter("rotation", "rotation", Degrees, (0.0, 12.0), "turn of the pelvis at contact"),
    parameter("tilt", "tilt", Degrees, (0.0, 7.0), "amplitude of the pelvis' side tilt"),
    parameter("anterior_tilt", "anterior-tilt", Degrees, (-5.0, 15.0), "mean forward tilt of the pelvis"),
    parameter(
        "flexion",
        "flexion",
        Degrees,
        (0.0, 12.0),
        "pitch of the standing shank under the hip, at least: the body is lowered",
    ),
    parameter("clearance", "clearance", Metres, (0.0, 0.05), "least height of the swinging foot"),
    parameter("step_width", "step-width", Metres, (0.04, 0.20), "distance of the heels' lines"),
    parameter("foot_yaw", "foot-yaw", Degrees, (0.0, 15.0), "outward turn of the feet"),
    parameter("toe_roll", "toe-roll", Degrees, (28.0, 45.0), "pitch of the toes at toe-off"),
    parameter("swing_knee", "swing-knee", Degrees, (55.0, 75.0), "greatest flexion of the swinging knee"),
    parameter("arm_swing", "arm-swing", Degrees, (0.0, 45.0), "amplitude of the shoulders' flexion"),
    parameter("thorax_rotation", "thorax-rotation", Degrees, (0.0, 12.0), "turn of the thorax"),
    number("thorax_lean", Degrees, (-8.0, 18.0), "forward lean of the thorax", |s| &mut s.thorax_lean),
    SheetNumber {
        name: "thorax_bend",
        help: "amplitude of the thorax' side bend",
        unit: Degrees,
        range: (0.0, 12.0),
        place: Place::Bend,
    },
    number(
        "bounce",
        Part,
        (0.004, 0.03),
        "rise of the centre of mass: its first harmonic over the leg's length",
        |s| &mut s.height1,
    ),
    SheetNumber {
        name: "double_support",
        help: "one double support, over the stride",
        unit: Part,
        range: (0.06, 0.24),
        place: Place::DoubleSupport,
    },
    number("ankle_swing", Degrees, (-15.0, 15.0), "dorsiflexion in late swing", |s| &mut s.ankle_swing),
    number("head_pitch", Degrees, (-15.0, 35.0), "mean forward pitch of the head", |s| {
        &mut s.manner.head_pitch
    }),
    number("head_nod", Degrees, (0.0, 6.0), "amplitude of the head's pitch against the body's rise", |s| {
        &mut s.manner.head[0]
    }),
    number("head_turn", Degrees, (0.0, 8.0), "amplitude of the head's turn against the body's sway", |s| {
        &mut s.manner.head[1]
    }),
    number("shoulder", Degrees, (-20.0, 25.0), "mean flexion of the shoulders; backward is negative", |s| {
        &mut s.manner.shoulder
    }),
    number("arms_out", Degrees, (2.0, 25.0), "upper arms outward", |s| &mut s.manner.arms_out),
    number("arms_in", Degrees, (-30.0, 45.0), "upper arms turned inward about their own length", |s| {
        &mut s.manner.arms_in
    }),
    number("elbow", Degrees, (5.0, 100.0), "mean flexion of the elbows in a stride", |s| {
        &mut s.manner.elbow[1]
    }),
    number("elbow_swing", Degrees, (0.0, 40.0), "amplitude of the elbows' flexion", |s| {
        &mut s.manner.elbow[2]
    }),
    number("elbow_standing", Degrees, (5.0, 100.0), "flexion of the elbows in standing", |s| {
        &mut s.manner.elbow[0]
    }),
    number("clavicle", Part, (0.0, 0.3), "turn of the shoulder girdle over the arm's angle", |s| {
        &mut s.manner.clavicle
    }),
    number("wrist", Part, (0.0, 0.5), "swing of the hand over the forearm's", |s| &mut s.manner.wrist),
];

impl SheetNumber {
    /// The number called `name`.
    pub fn named(name: &str) -> Option<&'static Self> {
        SHEET_NUMBERS.iter().find(|number| number.name == name)
    }

    /// Its value in a style, in its unit; 1 for a factor of the pace, which a style has no place for.
    pub fn get(&self, style: &Style) -> f64 {
        match self.place {
            Place::Pace => 1.0,
            Place::DoubleSupport => style.double_support,
            Place::Bend => style.thorax_bend_sin.hypot(style.thorax_bend_cos) / DEGREE,
            Place::Parameter(name) => {
                Parameter::named(name).map_or(f64::NAN, |parameter| parameter.get(style))
            }
            Place::Number(place) => {
                let mut copy = *style;
                *place(&mut copy) / self.si()
            }
        }
    }

    fn si(&self) -> f64 {
        if self.unit == Degrees { DEGREE } else { 1.0 }
    }

    fn change(&self, style: &mut Style, change: Change) -> Result<(), RequestError> {
        let usual = self.get(style);
        let value = change.factor * usual + change.add;
        // Where everybody's number is beyond the range already, as the bounce of steps on the spot is, it may be half of it further.
        let further = 0.5 * usual.abs();
        let range = match self.range {
            (lower, upper) if usual < lower => (usual - further, upper),
            (lower, upper) if usual > upper => (lower, usual + further),
            range => range,
        };
        pace::range(self.name, value, self.unit.symbol(), range, || {
            " in the manner that is asked for".to_owned()
        })?;
        match self.place {
            Place::Pace => {}
            Place::DoubleSupport => stand_longer(style, value - style.double_support),
            Place::Bend => {
                let before = self.get(style);
                if before > 0.0 {
                    style.thorax_bend_sin *= value / before;
                    style.thorax_bend_cos *= value / before;
                } else {
                    style.thorax_bend_sin = value * DEGREE;
                }
            }
            Place::Parameter(name) => {
                if let Some(parameter) = Parameter::named(name) {
                    parameter.set(style, value)?;
                }
            }
            Place::Number(place) => *place(style) = value * self.si(),
        }
        Ok(())
    }
}

/// Changes a style as a sheet says.
pub(super) fn apply(sheet: &StyleSheet, style: &mut Style) -> Result<(), RequestError> {
    for (name, change) in sheet.changes() {
        let number = SheetNumber::named(name).ok_or_else(|| {
            let known = SHEET_NUMBERS.iter().map(|number| number.name).collect::<Vec<_>>().join(", ");
            RequestError::UnknownParameter { name: (*name).to_owned(), known }
        })?;
        if *change != Change::NONE {
            number.change(style, *change)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::smooth::parameter::Unit;

    #[test]
    fn parameters_are_those_of_the_style() {
        for number in SHEET_NUMBERS {
            if let Place::Parameter(name) = number.place {
                let parameter = Parameter::named(name).expect("a parameter of the style");
                assert_eq!(parameter.range, number.range, "{name}");
                let metres = parameter.unit == Unit::Metres;
                assert_eq!(metres, number.unit == Metres, "{name}");
            }
        }
    }
}
