//! A clip of a set.

use crate::smooth::WalkPlan;
use solaris_model::{EventKind, Figure, Motion, MotionError};

/// What a clip is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum ClipKind {
    /// Standing.
    Idle,
    /// From standing into the walk.
    Start,
    /// A stride that repeats itself.
    Walk,
    /// A turn.
    Turn,
    /// Out of the walk to a stand.
    Stop,
}

/// Where a clip begins or ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum Joint {
    /// In standing.
    Standing,
    /// In the walk, as the left foot is set down.
    LeftContact,
}

/// How far the posture in which one clip ends is from the one in which the next begins, but for where they are.
///
/// With the feature `serde` its keys are `angle_deg` and `height_m`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seam {
    /// Greatest difference of a joint's angle (rad).
    pub angle: f64,
    /// Difference of the root's height (m).
    pub height: f64,
}

impl Seam {
    pub(super) fn worse(self, other: Self) -> Self {
        Self { angle: self.angle.max(other.angle), height: self.height.max(other.height) }
    }
}

/// A clip of a set.
///
/// With the feature `serde` its keys carry units: `duration_s`, `speed_m_s`, `advance_m` (x, z), `turn_deg`; its motion is its number of `frames`, and
/// `events` with their `phase`, the part of the clip that is over.
#[derive(Clone, Debug)]
pub struct SetClip {
    /// Its name.
    pub name: String,
    /// What it is for.
    pub kind: ClipKind,
    /// Its samples; of a loop the last one is its first one again, farther on.
    pub motion: Motion,
    /// Whether it repeats itself.
    pub repeats: bool,
    /// Where it begins and ends.
    pub joints: [Joint; 2],
    /// Steps a minute, and length of a step (m), of its walk, negative where it goes backward; 0 in standing.
    pub step_frequency: f64,
    /// See `step_frequency`.
    pub step_length: f64,
    /// How far its root goes: to the left, and ahead (m).
    pub advance: [f64; 2],
    /// By how much it turns to the left (rad).
    pub turn: f64,
    /// How well it fits the usual loop; none where it is not in the walk.
    pub seam: Option<Seam>,
}

impl SetClip {
    pub(super) fn new(name: &str, kind: ClipKind, motion: Motion, joints: [Joint; 2]) -> Self {
        let last = motion.q(motion.len() - 1);
        let advance = [last[0] - motion.q(0)[0], last[2] - motion.q(0)[2]];
        Self {
            name: name.to_owned(),
            kind,
            motion,
            repeats: false,
            joints,
            step_frequency: 0.0,
            step_length: 0.0,
            advance,
            turn: 0.0,
            seam: None,
        }
    }

    pub(super) fn paced(&mut self, plan: &WalkPlan) {
        self.step_frequency = plan.style().step_frequency;
        self.step_length = if plan.is_backward() { -1.0 } else { 1.0 } * plan.style().step_length;
    }

    /// How long it lasts (s).
    pub fn duration(&self) -> f64 {
        self.motion.time().last().copied().unwrap_or_default()
    }

    /// Speed of its walk (m/s), negative where it goes backward.
    pub fn speed(&self) -> f64 {
        self.step_length * self.step_frequency / 60.0
    }

    /// What happens in it: which foot is set down or lifted, whether it is set down, and when (s).
    pub fn footfalls(&self) -> impl Iterator<Item = (&str, bool, f64)> {
        self.motion.events.iter().filter_map(|event| match &event.kind {
            EventKind::TouchDown { link } => Some((link.as_str(), true, event.time)),
            EventKind::LiftOff { link } => Some((link.as_str(), false, event.time)),
            _ => None,
        })
    }

    /// How its end fits the beginning of another one. The root's x, y, z and the three turns after them come first.
    pub(super) fn seam_to(&self, next: &Self) -> Seam {
        let (end, begin) = (self.motion.q(self.motion.len() - 1), next.motion.q(0));
        let wrapped = |angle: f64| {
            (angle + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
        };
        let turned = |at: usize| if at == 3 { self.turn } else { 0.0 };
        let angle =
            (3..end.len()).map(|at| wrapped(end[at] - begin[at] - turned(at)).abs()).fold(0.0, f64::max);
        Seam { angle, height: (end[1] - begin[1]).abs() }
    }
}

/// A motion that begins at the origin: without where its root stands along x and z at first.
pub(super) fn at_origin(figure: &Figure, motion: Motion) -> Result<Motion, MotionError> {
    let nq = figure.layout().nq();
    // The root of a walker slides along x, y, z first.
    let root = figure.layout().joints()[0].q;
    let [mut q, v, a] = motion.columns().map(<[f64]>::to_vec);
    let (x, z) = (q[root], q[root + 2]);
    for row in q.chunks_exact_mut(nq) {
        row[root] -= x;
        row[root + 2] -= z;
    }
    let mut moved = motion;
    moved.set_states(figure, [q, v, a])?;
    Ok(moved)
}

#[cfg(feature = "serde")]
mod written {
    use super::{Seam, SetClip};
    use serde::ser::{Serialize, SerializeStruct as _, Serializer};

    #[derive(serde::Serialize)]
    struct Footfall<'a> {
        link: &'a str,
        what: &'static str,
        at_s: f64,
        phase: f64,
    }

    impl Serialize for Seam {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            let mut fields = serializer.serialize_struct("Seam", 2)?;
            fields.serialize_field("angle_deg", &self.angle.to_degrees())?;
            fields.serialize_field("height_m", &self.height)?;
            fields.end()
        }
    }

    impl Serialize for SetClip {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            let duration = self.duration();
            let events: Vec<Footfall<'_>> = self
                .footfalls()
                .map(|(link, is_down, at_s)| Footfall {
                    link,
                    what: if is_down { "touch_down" } else { "lift_off" },
                    at_s,
                    phase: at_s / duration,
                })
                .collect();
            let mut fields = serializer.serialize_struct("SetClip", 14)?;
            fields.serialize_field("name", &self.name)?;
            fields.serialize_field("kind", &self.kind)?;
            fields.serialize_field("loop", &self.repeats)?;
            // The last one of a loop is its first one.
            fields.serialize_field("frames", &(self.motion.len() - usize::from(self.repeats)))?;
            fields.serialize_field("duration_s", &duration)?;
            fields.serialize_field("speed_m_s", &self.speed())?;
            fields.serialize_field("step_frequency_per_min", &self.step_frequency)?;
            fields.serialize_field("step_length_m", &self.step_length)?;
            fields.serialize_field("advance_m", &self.advance)?;
            fields.serialize_field("turn_deg", &self.turn.to_degrees())?;
            fields.serialize_field("begins", &self.joints[0])?;
            fields.serialize_field("ends", &self.joints[1])?;
            fields.serialize_field("seam", &self.seam)?;
            fields.serialize_field("events", &events)?;
            fields.end()
        }
    }
}
