//! What is to be put onto another skeleton: a skeleton, its motion, and when which foot stands.

use crate::belt::Belt;
use crate::error::RetargetError;
use crate::feet::Sole;
use crate::heading::heading;
use crate::planted::{Stands, planted, slow};
use crate::roles::Roles;
use crate::skeleton::Skeleton;
use solaris_model::{Figure, Motion, Placement, UnitQuaternion, Vector3};

/// How far apart (rad, m) bones of one posture are.
const CLOSED: (f64, f64) = (1e-3, 1e-3);
/// By how much longer a step from the last frame to the first may be than all others, and change more.
const SEAM: f64 = 1.5;
/// Rounds that leave out the last frame last no longer than this (s); what is longer is no loop of somebody who goes.
const LONGEST_OPEN: f64 = 10.0;
/// Motions of fewer frames are no rounds of anything.
const LEAST_ROUND: usize = 8;

/// A motion, ready to be put onto another skeleton.
#[derive(Clone, Debug)]
pub struct Take {
    pub(crate) skeleton: Skeleton,
    pub(crate) roles: Roles,
    /// From its world to x left, y up, z forward.
    pub(crate) heading: UnitQuaternion<f64>,
    /// Times of the frames (s).
    pub(crate) time: Vec<f64>,
    /// In each frame the places of all bones (m), in the frame of the heading, over ground that rests.
    pub(crate) frames: Vec<Vec<Placement>>,
    /// How the ground goes by in the clip, where it does.
    pub(crate) belt: Option<Belt>,
    pub(crate) soles: [Sole; 2],
    /// In each frame, which points of each foot stand.
    pub(crate) stands: Vec<[Stands; 2]>,
    /// Whether the clip says so, or it is seen.
    is_told: bool,
}

impl Take {
    /// A figure's motion. At rest the figure is as with all joints at zero, or as in the frame `rest`, in which it must stand upright.
    ///
    /// # Errors
    ///
    /// A motion of another figure or without frames, numbers that are not finite, a figure that does not stand at rest.
    pub fn of(
        skeleton: &Skeleton,
        roles: &Roles,
        figure: &Figure,
        motion: &Motion,
        rest: Option<usize>,
    ) -> Result<Self, RetargetError> {
        motion.check_figure(figure)?;
        if motion.is_empty() {
            return Err(RetargetError::Empty { skeleton: skeleton.name.clone() });
        }
        let mut skeleton = skeleton.clone();
        if let Some(frame) = rest {
            let frames = motion.len();
            if frame >= frames {
                return Err(RetargetError::Frame { frame, frames });
            }
            let places = figure.places(motion.q(frame));
            for (bone, point) in &mut skeleton.surface {
                let own = skeleton.bones[*bone].rest.inverse() * nalgebra::Point3::from(*point);
                *point = (places[*bone] * own).coords;
            }
            skeleton.bones.iter_mut().zip(places).for_each(|(bone, place)| bone.rest = place);
        }
        let turn = heading(&skeleton, roles)?;
        let soles = Sole::both(&skeleton, roles, &turn);
        let mut frames = Vec::with_capacity(motion.len());
        for sample in 0..motion.len() {
            let mut places = figure.places(motion.q(sample));
            for (place, bone) in places.iter_mut().zip(&skeleton.bones) {
                *place = turn * *place;
                // Of an angle of 1e295 rad nobody knows the sine.
                let mut numbers = place.translation.vector.iter().chain(place.rotation.coords.iter());
                if let Some(value) = numbers.find(|x| !x.is_finite()) {
                    return Err(RetargetError::NotFinite {
                        what: "a place",
                        bone: bone.name.clone(),
                        value: *value,
                    });
                }
            }
            frames.push(places);
        }
        let time = motion.time().to_vec();
        let stands = planted(&soles, &time, &frames, motion);
        let is_told = !motion.planted.is_empty();
        let (roles, belt) = (roles.clone(), None);
        let mut take = Self { skeleton, roles, heading: turn, time, frames, belt, soles, stands, is_told };
        take.find_belt();
        Ok(take)
    }

    /// Looks for ground that goes by, where nothing is told of the ground and none was found.
    fn find_belt(&mut self) {
        if self.is_told || self.belt.is_some() {
            return;
        }
        let (pelvis, soles) = (self.roles.pelvis, &self.soles);
        if let Some((belt, stands)) = Belt::found(soles, pelvis, &self.time, &mut self.frames, &self.stands) {
            (self.belt, self.stands) = (Some(belt), stands);
        }
    }

    /// Leaves out frames at the beginning, such as a reference pose; the last frame stays.
    #[must_use]
    pub fn without(mut self, frames: usize) -> Self {
        let first = frames.min(self.time.len() - 1);
        self.time.drain(..first);
        self.frames.drain(..first);
        self.stands.drain(..first);
        self.find_belt();
        self
    }

    /// Of a motion that goes on as it begins, three rounds of it, one after the other, and how many frames one has: what is done about feet by what comes
    /// before and after is so the same at both ends of the round in the middle. It ends in the posture in which it begins, or a frame before it. Nothing
    /// of any other, or of one that turns, too.
    pub(crate) fn rounds(&self) -> Option<(Self, usize)> {
        if self.len() < LEAST_ROUND {
            return None;
        }
        let last = self.len() - 1;
        let lasts = self.time[last] - self.time[0];
        let (round, way, duration) = match self.closing_way() {
            Some(way) => (last, way, lasts),
            None => (last + 1, self.open_way()?, lasts * (last + 1) as f64 / last as f64),
        };
        let mut rounds = Self { time: Vec::new(), frames: Vec::new(), stands: Vec::new(), ..self.clone() };
        // A last frame that is the first of the next round stands once in each, and at the end.
        for k in 0..3 * round + usize::from(round == last) {
            let (turn, frame) =
                if k == 3 * round { (1.0, round) } else { ((k / round) as f64 - 1.0, k % round) };
            rounds.time.push(self.time[frame] + turn * duration);
            rounds.stands.push(self.stands[frame]);
            let mut places = self.frames[frame].clone();
            for place in &mut places {
                place.translation.vector += way * turn;
            }
            rounds.frames.push(places);
        }
        // What goes on over the seam is seen there, too.
        if !self.is_told {
            rounds.stands = slow(&rounds.soles, &rounds.time, &rounds.frames);
        }
        Some((rounds, round))
    }

    /// The level way from the first frame to the last, where all bones are as in the first.
    fn closing_way(&self) -> Option<Vector3<f64>> {
        let (first, last) = (self.frames.first()?, self.frames.last()?);
        let pelvis = self.roles.pelvis;
        let mut way = last[pelvis].translation.vector - first[pelvis].translation.vector;
        // What the pelvis hangs on may stay where it is.
        let closes = (0..first.len()).filter(|bone| self.skeleton.is_below(*bone, pelvis)).all(|bone| {
            let (a, b) = (&first[bone], &last[bone]);
            let off = b.translation.vector - a.translation.vector - way;
            a.rotation.angle_to(&b.rotation) < CLOSED.0 && off.norm() < CLOSED.1
        });
        if !closes || way.y.abs() > CLOSED.1 {
            return None;
        }
        way.y = 0.0;
        Some(way)
    }

    /// The level way from the first frame to the one after the last, where that would be as the first: where no bone steps over the seam by much more than
    /// it does within the clip, nor do steps change there by much more, all of them together. A foot that lands there may change its own at once.
    fn open_way(&self) -> Option<Vector3<f64>> {
        let count = self.len();
        let lasts = self.time[count - 1] - self.time[0];
        if self.is_told || lasts > LONGEST_OPEN {
            return None;
        }
        let mean = lasts / (count - 1) as f64;
        let is_even = |pair: &[f64]| (pair[1] - pair[0] - mean).abs() < 0.01 * mean;
        if !self.time.windows(2).all(is_even) {
            return None;
        }
        let frame = |k: usize| &self.frames[k % count];
        let pelvis = self.roles.pelvis;
        let root = |k: usize| frame(k)[pelvis].translation.vector;
        let [first, last] = [0, count - 2].map(|k| root(k + 1) - root(k));
        let mut way = root(count - 1) - root(0) + (first + last) / 2.0;
        way.y = 0.0;
        // Steps from frame to frame: the last but one goes over the seam.
        let goes = |k: usize| root(k + 1) - root(k) + if k == count - 1 { way } else { Vector3::zeros() };
        let turns = |bone: usize| {
            move |k: usize| (frame(k)[bone].rotation.inverse() * frame(k + 1)[bone].rotation).scaled_axis()
        };
        let steps = |of: &dyn Fn(usize) -> Vector3<f64>| (0..=count).map(of).collect::<Vec<_>>();
        let bones: Vec<Vec<Vector3<f64>>> =
            (0..self.skeleton.bones.len()).map(|bone| steps(&turns(bone))).collect();
        let longest = |steps: &[Vector3<f64>]| steps.iter().map(Vector3::norm).fold(0.0, f64::max);
        let is_step = |steps: &Vec<Vector3<f64>>, least: f64| {
            steps[count - 1].norm() <= SEAM * longest(&steps[..count - 1]) + least
        };
        let step = |k: usize| bones.iter().map(|steps| steps[k].norm()).sum::<f64>();
        let is_near = step(count - 1) <= SEAM * (0..count - 1).map(step).fold(0.0, f64::max) + CLOSED.0;
        let change = |k: usize| bones.iter().map(|steps| (steps[k] - steps[k - 1]).norm()).sum::<f64>();
        let within = (1..count - 1).map(change).fold(0.0, f64::max);
        let is_smooth = change(count - 1).max(change(count)) <= SEAM * within + CLOSED.0;
        let is_level = is_step(&steps(&goes), CLOSED.1);
        (is_near && is_smooth && is_level && bones.iter().all(|steps| is_step(steps, CLOSED.0)))
            .then_some(way)
    }

    /// How many frames it has.
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Whether it has none, which it never does.
    pub fn is_empty(&self) -> bool {
        self.time.is_empty()
    }
}
