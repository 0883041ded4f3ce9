//! The walker: takes commands, makes steps, gives postures.

mod limbs;

use super::beat::Foot;
use super::command::{Command, ahead};
use super::ease::{Jets, jets};
use super::footholds::{Bends, Bent, Course};
use super::forces::Forces;
use super::loose::Limbs;
use super::paces::Paces;
use super::print::{Print, sign};
use super::push::Pushed;
use super::step::Step;
use super::told::Told;
use super::tried::Tried;
use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, LiveError};
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::{Contact, Figure, RootOrder};
use std::sync::Arc;

/// The longest frame (s).
const LONGEST_FRAME: f64 = 0.25;
/// Step of the difference formulas for velocities and accelerations (s).
const DIFFERENCE: f64 = 1e-3;
/// Parts of a change of speed that are tried.
const GAINS: [f64; 6] = [1.0, 0.75, 0.5, 0.3, 0.15, 0.0];

/// A figure that walks as it is told while it walks.
///
/// Every call of [`Walker::step`] goes on by a frame, under a [`Command`] that may be another one each time; a command takes effect at the next
/// footfall at the latest. Planted feet are exact at every time, whatever is told; where the feet land, and when, follows from the dynamics
/// of the centre of mass over the coming footholds. What cannot be walked is bent to the nearest that can, see [`Walker::bent`].
///
/// A clone is a snapshot: from the same commands it goes on to the same bits. What was planned when the walker was built is shared by all clones.
/// Frames do not allocate.
///
/// ```
/// use solaris_gait::{Command, Walker};
/// use solaris_model::{Human, RootOrder};
///
/// let ann = Human::new(1.65, 58.0).root(RootOrder::Yzx).build()?;
/// let mut walker = Walker::new(&ann)?;
/// for frame in 0..300 {
///     let command = if frame < 180 { Command::velocity(0.0, 1.2) } else { Command::stop() };
///     let q = walker.step(1.0 / 60.0, &command)?;
///     assert_eq!(q.len(), ann.layout().nq());
/// }
/// assert!(walker.place()[1] > 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "controller")]
#[doc(alias = "character")]
#[derive(Clone)]
pub struct Walker {
    paces: Arc<Paces>,
    step: Step,
    before: Step,
    /// Time in the step (s).
    time: f64,
    course: Course,
    bent: Bends,
    /// What nothing is told of yet, and what something is.
    own: Arc<Told>,
    told: Option<Box<Told>>,
    /// What nothing hangs from yet, and what does.
    tight: Arc<Limbs>,
    limbs: Option<Box<Limbs>>,
    /// Nobody who is pushed, and what is left of a push.
    alone: Arc<Pushed>,
    pushed: Option<Box<Pushed>>,
    /// What has been asked for forces.
    forces: Option<Box<Forces>>,
    q: Vec<f64>,
    /// Room for another posture.
    scratch: Vec<f64>,
}

impl Walker {
    /// A walker that stands at the origin and faces along z.
    ///
    /// It plans a few dozens of milliseconds: strides of all speeds.
    ///
    /// # Errors
    ///
    /// A figure that cannot walk, and one whose root does not turn by its heading first ([`RootOrder::Yzx`]).
    pub fn new(figure: &Figure) -> Result<Self, GaitError> {
        missing::check(figure)?;
        let body = Body::of(figure)?.with_legs_alike()?;
        if body.root_order != RootOrder::Yzx {
            return Err(LiveError::Root { figure: figure.name().to_owned() }.into());
        }
        let nq = body.nq;
        let own = Arc::new(Told::new(figure, &body));
        let tight = Arc::new(Limbs::new(figure, &body)?);
        let alone = Arc::new(Pushed::new(figure, &body)?);
        let paces = Arc::new(Paces::new(body)?);
        let half = 0.5 * paces.style(paces.at(0.0)).step_width;
        let foot = |side: usize| Foot {
            print: Print { heel: Vector3::new(sign(side) * half, 0.0, 0.0), heading: 0.0 },
            landed: None,
        };
        let course = Course {
            leading: 0,
            feet: [foot(0), foot(1)],
            headings: [0.0; 2],
            center: Vector3::zeros(),
            velocity: [0.0; 2],
            stands: true,
            closed: false,
            pace: 0.0,
            gain: 1.0,
        };
        let (beat, course) = course.next(&paces, &Command::stop(), &[[0.0]; 3], &mut Bends::default());
        let step = Step::standing(&beat);
        let mut walker = Self {
            paces,
            step,
            before: step,
            time: beat.time,
            course,
            bent: Bends::default(),
            own,
            told: None,
            tight,
            limbs: None,
            alone,
            pushed: None,
            forces: None,
            q: vec![0.0; nq],
            scratch: vec![0.0; nq],
        };
        walker.write(0.0);
        Ok(walker)
    }

    /// Goes on by `dt` (s) under a command, and gives the figure's coordinates there (`nq` of them, in its own order).
    ///
    /// # Errors
    ///
    /// A frame that is not longer than nothing or longer than a quarter of a second, and numbers that are none: the walker stays where it is.
    pub fn step(&mut self, dt: f64, command: &Command) -> Result<&[f64], LiveError> {
        if !(dt > 0.0 && dt <= LONGEST_FRAME) {
            return Err(LiveError::Frame { seconds: dt, most: LONGEST_FRAME });
        }
        command.check()?;
        self.time += dt;
        let command = &self.felt(dt, command);
        if self.step.beat.walks() {
            if self.time >= self.step.beat.time {
                self.next(self.step.beat.time, command);
            }
        } else if self.may_leave() && self.course.is_moved_by(command) {
            self.next(self.time, command);
        }
        self.write(dt);
        Ok(&self.q)
    }

    /// The figure's coordinates (`nq`).
    pub fn configuration(&self) -> &[f64] {
        &self.q
    }

    /// Writes velocities and accelerations of the coordinates (`nv` each; the figure has as many of both): differences backward in time over the
    /// walker's own motion, to the first and second order of a millisecond. Freed coordinates have those of the walk, loose ones their own, by
    /// the last frame.
    ///
    /// # Errors
    ///
    /// Slices of another length.
    pub fn derivatives(&mut self, v: &mut [f64], a: &mut [f64]) -> Result<(), LiveError> {
        let n = self.q.len();
        for given in [v.len(), a.len()] {
            if given != n {
                return Err(LiveError::Length { given, wanted: n });
            }
        }
        self.meant(v, a);
        if let Some(limbs) = &self.limbs {
            limbs.write_derivatives(v, a);
        }
        Ok(())
    }

    /// The same without what hangs.
    fn meant(&mut self, v: &mut [f64], a: &mut [f64]) {
        self.walked(v, a);
        if let Some(pushed) = &self.pushed {
            pushed.write_derivatives(v, a);
        }
        if let Some(told) = &self.told {
            told.write_derivatives(v, a);
        }
    }

    /// The same of the walk alone.
    fn walked(&mut self, v: &mut [f64], a: &mut [f64]) {
        let n = self.q.len();
        let mut at = std::mem::take(&mut self.scratch);
        v.fill(0.0);
        a.fill(0.0);
        for (k, (first, second)) in
            [(11.0 / 6.0, 2.0), (-3.0, -5.0), (1.5, 4.0), (-1.0 / 3.0, -1.0)].into_iter().enumerate()
        {
            self.configuration_before(k as f64 * DIFFERENCE, &mut at);
            for i in 0..n {
                v[i] += first * at[i] / DIFFERENCE;
                a[i] += second * at[i] / (DIFFERENCE * DIFFERENCE);
            }
        }
        self.scratch = at;
    }

    /// The coordinates a short time ago (s, within the last step).
    fn configuration_before(&self, ago: f64, q: &mut [f64]) {
        let t = self.time - ago;
        let (step, t) = if t < 0.0 { (&self.before, self.left() + t) } else { (&self.step, t) };
        step.placed(&self.paces, t).posture.write(&self.paces.body, &self.paces.plane, q);
    }

    /// When the step before was left, by its own time.
    fn left(&self) -> f64 {
        self.before.ended
    }

    /// Where it is: the middle between its feet's coming prints (x and z, m).
    pub fn place(&self) -> [f64; 2] {
        [self.course.center.x, self.course.center.z]
    }

    /// What the last frame asks of the ground and of the joints, by the laws of Newton and Euler: the force of the ground on each foot (left, right), about the world's
    /// origin, and in `tau` (`nv`) the forces of the degrees of freedom (N m, N). With clips, reaches, what hangs loose and pushes as they are shown.
    ///
    /// The feet's sum is the motion's own; between them it is split as in a planned walk, by the plan's shares ([`split_at_pivot`](solaris_analysis::split_at_pivot)), so that the
    /// root bears nothing but rounding. Each foot is pressed where that asks for, which outside of steady steps may lie beside its sole: see docs/live.md for how
    /// far. Where a frame would have to be held down, both forces are zero and what is missing stands at the root.
    ///
    /// The first call makes room; the ones after it allocate nothing.
    ///
    /// # Errors
    ///
    /// A slice of another length.
    #[doc(alias = "grf")]
    #[doc(alias = "inverse dynamics")]
    #[doc(alias = "torques")]
    pub fn forces(&mut self, tau: &mut [f64]) -> Result<[Contact; 2], LiveError> {
        let wanted = self.q.len();
        if tau.len() != wanted {
            return Err(LiveError::Length { given: tau.len(), wanted });
        }
        let refused = |error: String| LiveError::Forces { why: error };
        let mut forces = match self.forces.take() {
            Some(forces) => forces,
            None => Box::new(Forces::new(self.own.figure()).map_err(|error| refused(error.to_string()))?),
        };
        let (mut v, mut a) = (std::mem::take(&mut forces.v), std::mem::take(&mut forces.a));
        let known = self.derivatives(&mut v, &mut a);
        (forces.v, forces.a) = (v, a);
        let at = self.pressure();
        let supports = self.step.beat.supports(&self.paces, self.time, at);
        let pivot = self.step.beat.style.pivot;
        let solved = forces.solve(&self.q, self.push_felt(), &supports, pivot, tau);
        self.forces = Some(forces);
        known?;
        solved.map_err(|error| refused(error.to_string()))
    }

    /// Which way the body faces (rad, to the left of z, not wrapped).
    pub fn heading(&self) -> f64 {
        self.step.beat.heading(self.time)
    }

    /// The velocity that the present step makes: x and z of the world (m/s).
    pub fn velocity(&self) -> [f64; 2] {
        ahead(self.step.beat.faces[0], self.course.velocity)
    }

    /// Whether both feet stand and no step has begun.
    pub fn is_standing(&self) -> bool {
        !self.step.beat.walks()
    }

    /// In what the command was bent to what can be walked when the present step was decided.
    pub fn bent(&self) -> impl Iterator<Item = Bent> {
        self.bent.all()
    }

    /// The centre of mass (m).
    pub fn com(&self) -> Vector3<f64> {
        self.step.placed(&self.paces, self.time).com
    }

    /// The centre of pressure that the plan asks of the ground: x and z (m).
    pub fn pressure(&self) -> [f64; 2] {
        self.step.pressed(&self.paces, self.time)
    }

    /// Pushes a point of a link (m, in its frame) with a force of the world (N) from now on, until it is pushed otherwise or
    /// [let go](Self::let_go). Trunk and head give way at once, what is loose is taken along, and the next steps go along, for as long as it pushes and a
    /// second more: who stands makes a step where it would take him more than a little. Planted feet stay where they are.
    ///
    /// How somebody gives way is a law of ours, no measured one; steps go along by the horizontal part of the force alone.
    ///
    /// # Errors
    ///
    /// A link that the figure has not, a force that is none or greater than the weight, and a place that is none: it is pushed as before.
    #[doc(alias = "perturb")]
    #[doc(alias = "shove")]
    pub fn push(&mut self, link: &str, at: Vector3<f64>, force: Vector3<f64>) -> Result<(), LiveError> {
        let mut pushed = self.pushed.take().unwrap_or_else(|| Box::new((*self.alone).clone()));
        let taken = pushed.push(link, at, force);
        self.pushed = Some(pushed);
        taken
    }

    /// Pushes no more.
    pub fn let_go(&mut self) {
        if let Some(pushed) = &mut self.pushed {
            pushed.let_go();
        }
    }

    /// The link that was pushed in the last frame (its index), and the push about the world's origin: what an inverse dynamics of the walker needs beside the force of the
    /// ground.
    pub fn push_felt(&self) -> Option<(usize, Wrench<f64>)> {
        self.pushed.as_ref().and_then(|pushed| pushed.wrench())
    }

    /// Feels a push for `dt` (s): the command with where it takes the walker.
    fn felt(&mut self, dt: f64, command: &Command) -> Command {
        // Of what is long over nothing is left.
        self.pushed.take_if(|pushed| !pushed.is_felt());
        let Some(pushed) = &mut self.pushed else { return *command };
        pushed.step(dt, &self.q);
        command.drifting(pushed.drift())
    }

    /// Writes the configuration, `dt` (s) after the last.
    fn write(&mut self, dt: f64) {
        let placed = self.step.placed(&self.paces, self.time);
        placed.posture.write(&self.paces.body, &self.paces.plane, &mut self.q);
        if let Some(pushed) = &self.pushed {
            pushed.write(&mut self.q);
        }
        // What is long back in the walk costs nothing.
        if let Some(told) = self.told.as_mut().filter(|told| told.is_told()) {
            told.step(dt, &mut self.q);
        }
        // While nothing hangs nothing is done.
        if let Some(mut limbs) = self.limbs.take_if(|limbs| limbs.moves()) {
            let (mut v, mut a) = (std::mem::take(&mut limbs.v), std::mem::take(&mut limbs.a));
            self.meant(&mut v, &mut a);
            (limbs.v, limbs.a) = (v, a);
            limbs.step(dt, self.push_felt(), &mut self.q);
            self.limbs = Some(limbs);
        }
    }

    /// Whether somebody who comes to a stand may go on: both feet are flat.
    fn may_leave(&self) -> bool {
        self.step.beat.feet.iter().all(|foot| foot.is_flat(self.time))
    }

    /// Makes the next step, from the time `t` of this one on.
    fn next(&mut self, t: f64, command: &Command) {
        let paces = self.paces.clone();
        let paces = &*paces;
        let mut course = self.course;
        if !self.step.beat.walks() {
            course.feet = self.step.beat.feet.map(|foot| Foot { landed: None, ..foot });
        }
        let beat = &self.step.beat;
        let heading: Jets<1> = jets(t, |t| [beat.heading(t)]);
        let before = self.step.before(paces, t);
        // The whole change of speed at once, or as much of it as footholds and pressure can bear.
        let mut best: Option<Tried> = None;
        for gain in GAINS {
            course.gain = gain;
            let mut bent = Bends::default();
            let (beat, after) = course.next(paces, command, &heading, &mut bent);
            let tried = Tried::new(paces, &beat, after, command, &before, bent);
            let (is_borne, is_better) =
                (tried.strain <= 1.0, best.as_ref().is_none_or(|best| tried.strain < best.strain));
            if is_better {
                best = Some(tried);
            }
            if is_borne || !after.walks_on() {
                break;
            }
        }
        let Some(tried) = best else { return };
        let (step, course, bent) = tried.finished(paces, &before);
        self.bent = bent;
        self.step.ended = t;
        self.before = self.step;
        self.step = step;
        self.course = course;
        self.time -= t;
    }
}
