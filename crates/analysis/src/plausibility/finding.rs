//! What does not fit, with its value, its threshold and the likely cause.

use super::{
    AIRBORNE, AWAY, BORNE, FAR, GREATEST_DEGREES_OF_RADIANS, GREATEST_RADIANS, MISSING, OBLIQUE, TURNED,
};
use std::fmt;

/// Something that cannot be so, or hardly, where figure, motion and measured forces belong together.
///
/// It prints as one line with value, threshold and likely cause.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MotionFinding {
    /// The mean force of all plates does not point up.
    Direction {
        /// Angle between it and up (rad).
        angle: f64,
        /// Its direction, in world axes.
        along: [f64; 3],
    },
    /// The plates bear, on average, another mass than the figure's.
    Mass {
        /// What the plates bear over what figure and motion need, in frames in which every standing foot is on a plate.
        borne: f64,
        /// The figure's mass (kg).
        mass: f64,
    },
    /// A force that acts far from the foot that it is given to.
    Far {
        /// The sole's name.
        foot: String,
        /// Greatest distance of the centre of pressure from the sole (m), while it bears.
        distance: f64,
        /// When (s).
        time: f64,
        /// Share of the frames in which it bears that are farther than [`FAR`].
        share: f64,
        /// Why, as far as the forces tell.
        cause: FarCause,
    },
    /// A force that bears while the foot that it is given to swings, farther than [`AWAY`] beside or above it.
    Airborne {
        /// The sole's name.
        foot: String,
        /// Share of its impulse that it bears then.
        share: f64,
        /// When first (s).
        time: f64,
        /// Why, as far as the forces tell.
        cause: FarCause,
    },
    /// A foot that stands with no plate under it, and the figure's weight is missing.
    NoPlate {
        /// The sole.
        foot: String,
        /// From when to when it stands so first (s).
        span: (f64, f64),
        /// How often it does.
        times: usize,
        /// Mean share of the weight that no plate bears then.
        missing: f64,
        /// Whether any plate is given to it.
        has_plate: bool,
    },
    /// A figure that lies on its side or stands on its head in nearly all frames.
    Turned {
        /// Mean angle between its own up and the world's (rad).
        angle: f64,
        /// Where its own up points on average, in world axes; zero where it points everywhere.
        along: [f64; 3],
        /// In how many frames it is turned by more than [`TURNED`].
        frames: usize,
        /// Of how many.
        of: usize,
    },
    /// Angles that are read as degrees and look like radians.
    RadiansAsDegrees {
        /// Greatest angle of all, in the unit that the table says (°).
        greatest: f64,
    },
    /// Angles that are read as radians and look like degrees.
    DegreesAsRadians {
        /// The degree of freedom that turns farthest.
        dof: String,
        /// How far (rad).
        greatest: f64,
    },
}

/// Why a force does not belong under its foot.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FarCause {
    /// It fits under another foot, whose force fits here.
    Swapped {
        /// The other sole's name.
        with: String,
    },
    /// It bears while the foot swings: it was measured in another trial, or at another time.
    OtherTrial,
    /// It is beside the foot by nearly the same way all the time.
    Shifted {
        /// That way (m, world axes), from the foot to the force.
        by: [f64; 3],
    },
    /// None of these.
    Unknown,
}

impl fmt::Display for FarCause {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Swapped { with } => write!(f, "the feet are swapped, the force on '{with}' fits here"),
            Self::OtherTrial => f.write_str("plates of another trial, or of another time"),
            Self::Shifted { by: [x, y, z] } => write!(
                f,
                "origin or axes of the plates are not those of the motion, it is off by ({x:.2}, {y:.2}, {z:.2}) m"
            ),
            Self::Unknown => f.write_str("another foot's plate, or another trial's, or other axes"),
        }
    }
}

impl MotionFinding {
    /// What was found, as one word for programs.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Direction { .. } => "direction",
            Self::Mass { .. } => "mass",
            Self::Far { .. } => "far",
            Self::Airborne { .. } => "airborne",
            Self::NoPlate { .. } => "no_plate",
            Self::Turned { .. } => "turned",
            Self::RadiansAsDegrees { .. } => "radians_as_degrees",
            Self::DegreesAsRadians { .. } => "degrees_as_radians",
        }
    }

    /// Value and threshold, in the unit of [`MotionFinding::unit`].
    pub fn value_and_threshold(&self) -> (f64, f64) {
        match self {
            Self::Direction { angle, .. } => (angle.to_degrees(), OBLIQUE.to_degrees()),
            Self::Mass { borne, .. } => ((borne - 1.0).abs(), BORNE),
            Self::Far { distance, .. } => (*distance, FAR),
            Self::Airborne { share, .. } => (*share, AIRBORNE),
            Self::NoPlate { missing, .. } => (*missing, MISSING),
            Self::Turned { angle, .. } => (angle.to_degrees(), TURNED.to_degrees()),
            Self::RadiansAsDegrees { greatest } => (*greatest, GREATEST_DEGREES_OF_RADIANS),
            Self::DegreesAsRadians { greatest, .. } => (*greatest, GREATEST_RADIANS),
        }
    }

    /// The unit of value and threshold; empty for shares.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Direction { .. } | Self::Turned { .. } | Self::RadiansAsDegrees { .. } => "°",
            Self::Far { .. } => "m",
            Self::DegreesAsRadians { .. } => "rad",
            Self::Mass { .. } | Self::Airborne { .. } | Self::NoPlate { .. } => "",
        }
    }

    /// The foot or degree of freedom that it is about; `None` for the whole figure.
    pub fn subject(&self) -> Option<&str> {
        match self {
            Self::Far { foot, .. } | Self::Airborne { foot, .. } | Self::NoPlate { foot, .. } => Some(foot),
            Self::DegreesAsRadians { dof, .. } => Some(dof),
            Self::Direction { .. }
            | Self::Mass { .. }
            | Self::Turned { .. }
            | Self::RadiansAsDegrees { .. } => None,
        }
    }
}

impl fmt::Display for MotionFinding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = |share: &f64| 100.0 * share;
        match self {
            Self::Direction { angle, along: [x, y, z] } => write!(
                f,
                "the mean force of the plates points along ({x:.2}, {y:.2}, {z:.2}), {:.0}° from up (threshold {:.0}°): {}",
                angle.to_degrees(),
                OBLIQUE.to_degrees(),
                if *angle > 2.5 {
                    "forces of the feet on the plates, whose signs must change, or up is another axis"
                } else {
                    "the axes of the plates are not those of the motion"
                }
            ),
            Self::Mass { borne, mass } => write!(
                f,
                "the plates bear {:.1} kg on average, the figure has {mass:.1} kg: {:.0} % off (threshold {:.0} %): {}",
                borne * mass,
                percent(&(borne - 1.0).abs()),
                percent(&BORNE),
                mass_cause(*borne)
            ),
            Self::Far { foot, distance, time, share, cause } => write!(
                f,
                "the force on '{foot}' acts {distance:.2} m beside the foot at {time:.3} s, and farther than {FAR} m in {:.0} % \
                 of the frames in which it bears: {cause}",
                percent(share)
            ),
            Self::Airborne { foot, share, time, cause } => write!(
                f,
                "the force on '{foot}' bears while the foot swings more than {AWAY} m away from it, {:.0} % of its impulse \
                 (threshold {:.0} %), first at {time:.3} s: {cause}",
                percent(share),
                percent(&AIRBORNE)
            ),
            Self::NoPlate { foot, span, times, missing, has_plate } => {
                let more = match times {
                    0 | 1 => String::new(),
                    2 => ", and once more,".to_owned(),
                    _ => format!(", and {} times more,", times - 1),
                };
                write!(
                    f,
                    "'{foot}' stands from {:.3} to {:.3} s{more} with no plate under it, {:.0} % of the weight is missing \
                     (threshold {:.0} %): {}",
                    span.0,
                    span.1,
                    percent(missing),
                    percent(&MISSING),
                    if *has_plate {
                        "it stepped beside its plate, or the plate is another's"
                    } else {
                        "no plate is given to it"
                    }
                )
            }
            Self::Turned { angle, frames, of, .. } => write!(
                f,
                "the figure is turned by {:.0}° from how it rests upright, and by more than {:.0}° in {frames} of {of} frames: \
                 another way was up, or somebody lies or hangs",
                angle.to_degrees(),
                TURNED.to_degrees()
            ),
            Self::RadiansAsDegrees { greatest } => write!(
                f,
                "no angle is greater than {greatest:.2}° (threshold {GREATEST_DEGREES_OF_RADIANS}°), yet they change as in a \
                 movement in radians: the header says degrees and the numbers are radians"
            ),
            Self::DegreesAsRadians { dof, greatest } => write!(
                f,
                "'{dof}' turns to {greatest:.1} rad (threshold {GREATEST_RADIANS} rad): the numbers are degrees and are read as \
                 radians (inDegrees=yes in the header of a .mot says so)"
            ),
        }
    }
}

/// Why plates bear so much of what is needed.
fn mass_cause(borne: f64) -> &'static str {
    match borne {
        b if (0.08..0.13).contains(&b) => "forces in kg instead of N",
        b if b < 0.01 => "forces in kN instead of N, or a plate that was off",
        b if (0.35..0.75).contains(&b) => "a plate is missing, or a model of another person",
        b if b > 2.0 => "the same plate is given twice, or forces are not in N",
        _ => "plates of another person, or a model that is not scaled to this one",
    }
}
