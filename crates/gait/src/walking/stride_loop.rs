//! One stride of a walk, exactly as long as it is, to be repeated for ever: what games ask for.

use super::{Prescribing, Walking};
use nalgebra::Vector3;
use solaris_analysis::{ReactionError, Support, SupportLaw, balance_momentum};
use solaris_model::{Contact, Figure, Motion, MotionError, MotionInfo, Trajectory};

/// The stride of a walk from a time on, as a curve that repeats itself a stride farther along z.
///
/// Before it begins and after its end it goes on, so that velocities and accelerations are those of a walk that never ends.
#[doc(alias = "gait cycle")]
#[doc(alias = "walk cycle")]
#[doc(alias = "looped animation")]
pub struct StrideLoop<'a, W> {
    walk: &'a W,
    /// When it begins in the walk, and how long it lasts (s).
    from: f64,
    period: f64,
    /// How far it goes (m).
    advance: f64,
    /// Place of the root's way along z in `q`.
    along: usize,
    /// Where the root is as it begins (m).
    start: f64,
}

impl<'a, W: Walking> StrideLoop<'a, W> {
    pub(crate) fn new(
        walk: &'a W,
        nq: usize,
        along: usize,
        (from, period): (f64, f64),
        advance: f64,
    ) -> Self {
        let mut q = vec![0.0; nq];
        walk.configuration(from, &mut q);
        Self { walk, from, period, advance, along, start: q[along] }
    }

    /// Speed along z (m/s).
    pub fn speed(&self) -> f64 {
        self.advance / self.period
    }

    /// The stride sampled at the rate next to `rate` (1/s) that has a whole number of frames; the last frame is the first one a
    /// stride later.
    ///
    /// # Errors
    ///
    /// A rate that is none, and another figure than the walk's.
    pub fn motion(&self, figure: &Figure, rate: f64) -> Result<Motion, MotionError> {
        let frames = (self.period * rate).round().max(2.0);
        let fitted = if rate.is_finite() { frames / self.period } else { rate };
        let mut motion = Motion::sample(figure, self, MotionInfo::on_earth(figure, fitted))?;
        let within = |time: f64| time - self.from;
        motion.events = self.walk.events();
        // What happens as the stride begins happens again as it ends: it is told once, whatever the rounding.
        let slack = 1e-9 * self.period;
        motion.events.iter_mut().for_each(|event| event.time = within(event.time));
        motion.events.retain(|event| (-slack..self.period - slack).contains(&event.time));
        motion.events.iter_mut().for_each(|event| event.time = event.time.max(0.0));
        motion.planted = self.walk.planted(figure);
        for planted in &mut motion.planted {
            (planted.start, planted.end) =
                (within(planted.start).max(0.0), within(planted.end).min(self.period));
        }
        motion.planted.retain(|planted| planted.start < planted.end);
        Ok(motion)
    }

    /// Where a time lies in the walk, and how much farther along that is (m).
    fn fold(&self, t: f64) -> (f64, f64) {
        let strides = (t / self.period).floor();
        (self.from + t - strides * self.period, strides * self.advance - self.start)
    }
}

impl<W: Walking> Trajectory for StrideLoop<'_, W> {
    fn duration(&self) -> f64 {
        self.period
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        let (time, advance) = self.fold(t);
        self.walk.configuration(time, q);
        q[self.along] += advance;
    }

    fn resolution(&self) -> f64 {
        self.walk.resolution()
    }
}

impl<W: Walking + SupportLaw> SupportLaw for StrideLoop<'_, W> {
    fn support(&self, t: f64) -> Support {
        let (time, advance) = self.fold(t);
        let mut support = self.walk.support(time);
        support.feet.iter_mut().for_each(|foot| foot.cop.z += advance);
        support
    }

    fn beside(&self, t: f64) -> Option<(&str, Contact)> {
        let (time, advance) = self.fold(t);
        let (link, contact) = self.walk.beside(time)?;
        Some((link, ahead(&contact, advance)))
    }
}

impl<W: Walking + Prescribing> Prescribing for StrideLoop<'_, W> {
    fn contacts(&self, t: f64) -> [Contact; 2] {
        let (time, advance) = self.fold(t);
        self.walk.contacts(time).map(|contact| ahead(&contact, advance))
    }
}

/// A contact `advance` farther along z (m).
fn ahead(contact: &Contact, advance: f64) -> Contact {
    let Contact { force, moment, cop } = *contact;
    if force == Vector3::zeros() {
        return Contact::default();
    }
    let shift = Vector3::new(0.0, 0.0, advance);
    Contact { force, moment: moment + shift.cross(&force), cop: cop + shift }
}

impl<W: Walking> StrideLoop<'_, W> {
    /// The same as [`Self::motion`], with accelerations that carry the centre of mass exactly.
    ///
    /// # Errors
    ///
    /// A rate that is none, and another figure than the walk's.
    pub fn balanced_motion(&self, figure: &Figure, rate: f64) -> Result<Motion, ReactionError> {
        let mut motion = self.motion(figure, rate)?;
        balance_momentum(figure, self, &mut motion)?;
        Ok(motion)
    }
}
