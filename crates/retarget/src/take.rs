//! What is to be put onto another skeleton: a skeleton, its motion, and when which foot stands.

use crate::error::RetargetError;
use crate::feet::Sole;
use crate::heading::heading;
use crate::planted::{Stands, planted};
use crate::roles::Roles;
use crate::skeleton::Skeleton;
use solaris_model::{Figure, Motion, Placement, UnitQuaternion};

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

    /// How many frames it has.
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Whether it has none, which it never does.
    pub fn is_empty(&self) -> bool {
        self.time.is_empty()
    }
}
