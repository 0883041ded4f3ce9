//! What is to be put onto another skeleton: a skeleton, its motion, and when which foot stands.

use crate::error::RetargetError;
use crate::feet::Sole;
use crate::heading::heading;
use crate::planted::{Stands, planted};
use crate::roles::Roles;
use crate::skeleton::Skeleton;
use solaris_model::{Figure, Motion, Placement, UnitQuaternion};

/// How far apart (rad, m) bones of one posture are.
const CLOSED: (f64, f64) = (1e-3, 1e-3);
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
    /// In each frame the places of all bones (m), in the frame of the heading.
    pub(crate) frames: Vec<Vec<Placement>>,
    pub(crate) soles: [Sole; 2],
    /// In each frame, which points of each foot stand.
    pub(crate) stands: Vec<[Stands; 2]>,
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
                if let Some(value) = place.translation.vector.iter().find(|x| !x.is_finite()) {
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
        Ok(Self { skeleton, roles: roles.clone(), heading: turn, time, frames, soles, stands })
    }

    /// Leaves out frames at the beginning, such as a reference pose; the last frame stays.
    #[must_use]
    pub fn without(mut self, frames: usize) -> Self {
        let first = frames.min(self.time.len() - 1);
        self.time.drain(..first);
        self.frames.drain(..first);
        self.stands.drain(..first);
        self
    }

    /// Of a motion that ends in the posture in which it begins, three rounds of it, one after the other: what is done about feet by what comes before and after is
    /// so the same at both ends of the round in the middle. Nothing of any other.
    pub(crate) fn rounds(&self) -> Option<Self> {
        let (first, last) = (self.frames.first()?, self.frames.last()?);
        let root = |places: &[Placement]| places[0].translation.vector;
        // A level way from round to round; one that turns, too, is none.
        let mut way = root(last) - root(first);
        let closes = first.iter().zip(last).all(|(a, b)| {
            let off = b.translation.vector - a.translation.vector - way;
            a.rotation.angle_to(&b.rotation) < CLOSED.0 && off.norm() < CLOSED.1
        });
        if self.len() < LEAST_ROUND || !closes || way.y.abs() > CLOSED.1 {
            return None;
        }
        way.y = 0.0;
        let (round, duration) = (self.len() - 1, self.time[self.len() - 1] - self.time[0]);
        let mut rounds = Self { time: Vec::new(), frames: Vec::new(), stands: Vec::new(), ..self.clone() };
        for k in 0..=3 * round {
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
        Some(rounds)
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
