//! One foot in the air over edges: the ankle's path is the law, and the leg follows.

use super::numbers::{LACK, SETTLED};
use super::swing::{Bump, Swing, Toes};
use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, LegPose};
use nalgebra::Vector3;
use solaris_profiles::{Boundary, Outside, Piecewise, ProfileError};
use std::f64::consts::PI;

/// Where toes first come to rest that have a riser close before them (rad): bent, so that the tip does not go through it.
const BEFORE_A_RISER: f64 = -20.0 * PI / 180.0;

/// How a path is kept off the ground: how often it is raised, half the width of a rise (parts of the swing), the least part of a rise's height
/// that its worst sample may have of it, from which part of the swing on the clearance is asked for in full, and how near to its ends not.
const MOST_BUMPS: usize = 4;
const REACH: f64 = 0.32;
const LEAST_PART: f64 = 0.3;
const FULL_FROM: f64 = 0.2;
const ENDS_KEPT: f64 = 0.04;

/// The end of the sole that passes an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SoleEnd {
    Tip,
    Heel,
}

/// One end of the sole passes above an edge.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passing {
    /// When, on the foot's own clock.
    pub(crate) at: f64,
    pub(crate) end: SoleEnd,
    /// Pitch of the foot then (rad, toe down).
    pub(crate) pitch: f64,
    /// Where the end is then: up and forward in the print's frame (m); nowhere in particular where there is no edge.
    pub(crate) place: Option<[f64; 2]>,
}

impl Passing {
    /// Height and way forward of the ankle then, where there is an edge.
    fn ankle(&self, leg: &LegGeometry) -> Option<[f64; 2]> {
        let place = self.place?;
        let (sin, cos) = self.pitch.sin_cos();
        let along = match self.end {
            SoleEnd::Tip => leg.ball_ahead + leg.toe,
            SoleEnd::Heel => -leg.heel_behind,
        };
        Some([
            place[0] + leg.ankle_height * cos + along * sin,
            place[1] - along * cos + leg.ankle_height * sin,
        ])
    }
}

/// Where the ankle is and how the foot is pitched at an end of a swing, with two derivatives.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FootJet {
    pub(crate) ankle: [Boundary; 3],
    pub(crate) pitch: Boundary,
    /// Pitch of the foot against its toes.
    pub(crate) extension: Boundary,
}

/// A swing whose ankle goes by quintic splines (C⁴ inside) from toe-off to contact through the passings of edges.
#[derive(Clone, Debug)]
pub(crate) struct PathSwing {
    ankle: [Piecewise; 3],
    pitch: Piecewise,
    extension: Piecewise,
    toe_off: f64,
    bumps: Vec<Bump>,
}

impl PathSwing {
    /// From one foothold to the next one, which lies `ahead` of it (m).
    pub(crate) fn new(
        leg: &LegGeometry,
        toe_off: f64,
        toes: Toes,
        passings: &[Passing],
        start: &FootJet,
        end: &FootJet,
        ahead: &Vector3<f64>,
    ) -> Result<Self, ProfileError> {
        let through = |points: &[(f64, f64)], start, end| {
            let (at, values): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
            let knots = [&[toe_off][..], &at, &[1.0]].concat();
            Ok::<_, ProfileError>(
                Piecewise::quintic_spline(&knots, &values, start, end)?.outside(Outside::Extrapolate),
            )
        };
        let edges = |axis: usize| -> Vec<(f64, f64)> {
            let at = |passing: &Passing| Some((passing.at, passing.ankle(leg)?[axis]));
            passings.iter().filter_map(at).collect()
        };
        let pitches: Vec<(f64, f64)> = passings.iter().map(|passing| (passing.at, passing.pitch)).collect();
        let climbs = passings.iter().any(|passing| passing.end == SoleEnd::Tip);
        let settled = if climbs { BEFORE_A_RISER } else { SETTLED };
        let landed = |axis: usize| {
            let jet = end.ankle[axis];
            Boundary { position: jet.position + ahead[axis], ..jet }
        };
        Ok(Self {
            ankle: [
                through(&[], start.ankle[0], landed(0))?,
                through(&edges(0), start.ankle[1], landed(1))?,
                through(&edges(1), start.ankle[2], landed(2))?,
            ],
            pitch: through(&pitches, start.pitch, end.pitch)?,
            extension: toes
                .spline(toe_off, settled, start.extension, Some(end.extension))?
                .outside(Outside::Extrapolate),
            toe_off,
            bumps: Vec::new(),
        })
    }

    /// 0 at toe-off, 1 at contact.
    fn phase(&self, v: f64) -> f64 {
        (v - self.toe_off) / (1.0 - self.toe_off)
    }

    /// Raises the ankle where the sole would come nearer than `height` (m) to the ground, a few times; `gap` is a point's height above it.
    pub(crate) fn clear_terrain(
        &mut self,
        leg: &LegGeometry,
        plane: &FootPlane,
        height: f64,
        samples: &[(f64, Vector3<f64>)],
        gap: impl Fn(&Vector3<f64>) -> f64,
    ) {
        for _ in 0..MOST_BUMPS {
            let missing = |&(v, hip): &(f64, Vector3<f64>)| {
                let x = self.phase(v);
                let wanted = height * (x.min(1.0 - x) / FULL_FROM).clamp(0.0, 1.0);
                let pose = self.pose(plane, leg, v, &hip);
                let points = plane.sole(leg, &hip, &pose, leg.ankle_below_hip(&pose));
                (wanted - points.iter().map(&gap).fold(f64::INFINITY, f64::min), x)
            };
            let inside =
                samples.iter().filter(|(v, _)| (ENDS_KEPT..1.0 - ENDS_KEPT).contains(&self.phase(*v)));
            let Some((worst, x)) =
                inside.map(missing).reduce(|best, next| if next.0 > best.0 { next } else { best })
            else {
                break;
            };
            if worst.is_nan() || worst <= LACK {
                break;
            }
            let unit = Bump { from: (x - REACH).max(0.0), to: (x + REACH).min(1.0), height: 1.0 };
            self.bumps.push(Bump { height: worst / unit.at(x).max(LEAST_PART), ..unit });
        }
    }

    /// The ankle at the foot's clock `v`, in the frame of the print that it has left.
    pub(crate) fn ankle(&self, v: f64) -> Vector3<f64> {
        let mut ankle = Vector3::from([0, 1, 2].map(|axis| self.ankle[axis].position(v)));
        ankle.y += self.bumps.iter().map(|bump| bump.at(self.phase(v))).sum::<f64>();
        ankle
    }

    fn pose(&self, plane: &FootPlane, leg: &LegGeometry, v: f64, hip: &Vector3<f64>) -> LegPose {
        let ankle = self.ankle(v);
        let pitch = self.pitch.position(v);
        plane.pose(leg, &(hip - ankle), pitch, pitch - self.extension.position(v))
    }
}

/// A foot in the air, one way or the other.
#[derive(Clone, Debug)]
pub(crate) enum Air {
    /// The joints' angles are the law.
    Joints(Swing),
    /// The ankle's path is.
    Path(PathSwing),
}

impl Air {
    /// The leg at the foot's clock `v`, for a hip in the frame of the print that it has left.
    pub(crate) fn pose(&self, plane: &FootPlane, leg: &LegGeometry, v: f64, hip: &Vector3<f64>) -> LegPose {
        match self {
            Self::Joints(swing) => swing.pose(leg, v),
            Self::Path(path) => path.pose(plane, leg, v, hip),
        }
    }
}
