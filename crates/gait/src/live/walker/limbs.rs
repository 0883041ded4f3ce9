//! Limbs of a walker that do something else than it walks: freed, reaching, playing a clip, or loose.

use super::Walker;
use crate::error::LiveError;
use crate::live::told::Told;
use nalgebra::Vector3;
use solaris_analysis::Goal;
use solaris_modes::RecordedMotion;
use std::sync::Arc;

impl Walker {
    /// Frees a coordinate for the caller: from now on it has the value that [`Walker::set_freed`] gives it, to which it goes over within 0.3 s, and so again
    /// wherever that jumps. The dofs of the root and of the legs cannot be freed, for the feet stand by them.
    ///
    /// # Errors
    ///
    /// A name that is none of a coordinate that can be freed.
    #[doc(alias = "mask")]
    pub fn free(&mut self, dof: &str) -> Result<(), LiveError> {
        self.telling().0.free(dof, true)
    }

    /// Takes a coordinate back into the walk, within 0.3 s.
    ///
    /// # Errors
    ///
    /// A name that is none of a coordinate that can be freed.
    pub fn hold(&mut self, dof: &str) -> Result<(), LiveError> {
        self.telling().0.free(dof, false)
    }

    /// Gives a freed coordinate its value (rad). One that moves with at most 150 rad/s² is followed to the bit.
    ///
    /// # Errors
    ///
    /// A name that is none of a coordinate that can be freed, and a value that is none.
    pub fn set_freed(&mut self, dof: &str, value: f64) -> Result<(), LiveError> {
        self.telling().0.set(dof, value)
    }

    /// A point of a link (m, in its frame) reaches for a goal in the world from now on, while it walks: by the coordinates or joints `by`, or, where none are named, by those
    /// of its arm, or of neck and head. It goes over to it within 0.3 s and then meets it exactly in every frame, where limits and lengths let it, else as nearly as
    /// steps lead; [`Walker::reached`] tells what is missing. Told again of the same point and joints it goes on to another goal, so that one that moves is told
    /// anew each frame, without allocating.
    ///
    /// ```
    /// use solaris_analysis::Goal;
    /// use solaris_gait::{Command, Walker};
    /// use solaris_model::{Human, RootOrder, Vector3};
    ///
    /// let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
    /// let mut walker = Walker::new(&ann)?;
    /// let (palm, rail) = (Vector3::new(0.0, -0.08, 0.0), |z| Vector3::new(-0.4, 0.95, z));
    /// for _ in 0..180 {
    ///     walker.reach("right_hand", palm, &[], Goal::Place(rail(walker.com().z + 0.15)))?;
    ///     walker.step(1.0 / 60.0, &Command::velocity(0.0, 1.0))?;
    /// }
    /// assert!(walker.reached("right_hand") < Some(1e-9));
    /// walker.withdraw("right_hand")?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// Names that are none, coordinates that do not move the link, goals that are no numbers: what was told before stays.
    #[doc(alias = "ik")]
    pub fn reach(
        &mut self,
        link: &str,
        point: Vector3<f64>,
        by: &[&str],
        goal: Goal,
    ) -> Result<(), LiveError> {
        let (told, q) = self.telling();
        told.reach((link, point), by, goal, q)
    }

    /// What is missing to the goal of a link that reaches (m for a place, rad for a direction), in the last frame; `None` for one that does not reach.
    pub fn reached(&self, link: &str) -> Option<f64> {
        self.told.as_ref().and_then(|told| told.off(link))
    }

    /// A link that reaches comes back into the walk, within 0.3 s.
    ///
    /// # Errors
    ///
    /// A link that the figure has not.
    pub fn withdraw(&mut self, link: &str) -> Result<(), LiveError> {
        self.telling().0.withdraw(link)
    }

    /// Plays a recorded motion of this figure over the walk, once from its beginning to its end: its coordinates or joints `by`, or, where none are named, all of trunk,
    /// head and arms. It is gone over to within 0.3 s, and back again from its end on.
    ///
    /// # Errors
    ///
    /// A motion of another figure or without velocities, and names that are none.
    #[doc(alias = "layer")]
    #[doc(alias = "montage")]
    pub fn play(&mut self, clip: &Arc<RecordedMotion>, by: &[&str]) -> Result<(), LiveError> {
        self.telling().0.play(clip, by)
    }

    /// Whether a clip is played.
    pub fn plays(&self) -> bool {
        self.told.as_ref().is_some_and(|told| told.plays())
    }

    /// Ends all clips, within 0.3 s.
    pub fn end_clips(&mut self) {
        if let Some(told) = &mut self.told {
            told.end_clips();
        }
    }

    /// What is told, to tell more, and the configuration that is shown.
    fn telling(&mut self) -> (&mut Told, &[f64]) {
        if self.told.as_ref().is_none_or(|told| !told.is_told()) {
            let mut told = self.told.take().unwrap_or_else(|| Box::new((*self.own).clone()));
            let n = self.q.len();
            let (mut v, mut a) = (vec![0.0; n], vec![0.0; n]);
            self.meant(&mut v, &mut a);
            told.begin(&self.q, &v);
            self.told = Some(told);
        }
        let Self { told, q, .. } = self;
        (told.as_mut().expect("made above"), q)
    }

    /// Lets a joint of the trunk, the head or an arm hang loose from now on, by its name (`left_elbow`): it swings from the walk by gravity and inertia, with the damping and
    /// the limits of [`Hanging`](solaris_modes::Hanging), from where it is and as fast as it moves. An arm is `left_shoulder`, `left_elbow` and `left_wrist`.
    /// What is loose already stays so.
    ///
    /// The walk does not feel it: the centre of mass is the plan's.
    ///
    /// # Errors
    ///
    /// A name that is none of a joint that can be loosened.
    #[doc(alias = "ragdoll")]
    pub fn loosen(&mut self, joint: &str) -> Result<(), LiveError> {
        let mut limbs = self.limbs.take().unwrap_or_else(|| Box::new((*self.tight).clone()));
        let (mut v, mut a) = (std::mem::take(&mut limbs.v), std::mem::take(&mut limbs.a));
        self.meant(&mut v, &mut a);
        (limbs.v, limbs.a) = (v, a);
        let loosened = limbs.loosen(joint, &self.q);
        self.limbs = Some(limbs);
        loosened
    }

    /// Takes a loose joint back into the walk, over half a second.
    ///
    /// # Errors
    ///
    /// A name that is none of a joint that can be loosened.
    pub fn tighten(&mut self, joint: &str) -> Result<(), LiveError> {
        match &mut self.limbs {
            Some(limbs) => limbs.tighten(joint),
            None => self.tight.find(joint).map(|_| ()),
        }
    }
}
