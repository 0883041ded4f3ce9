//! The schedule of the feet: touch-downs, lift-offs, and which points are planted.

use super::cane;
use super::course::{Episode, Kind};
use super::plan::WalkPlan;
use crate::body::{CANE, FEET};
use crate::smooth::style::Style;
use crate::walking::{G, Stood, Walking, sampled};
use nalgebra::Vector3;
use solaris_analysis::{ReactionError, Support, SupportLaw};
use solaris_model::{Contact, Event, EventKind, Figure, Interval, Motion, Trajectory};

impl WalkPlan {
    /// The body's weight (N).
    pub fn weight(&self) -> f64 {
        self.body.mass * G
    }

    /// The walk sampled `rate` times a second, with its events and planted points; forces are found by
    /// [`solaris_analysis::ground_reactions`], which takes the plan as its law.
    ///
    /// # Errors
    ///
    /// A rate that is none, and another figure than the plan's.
    pub fn motion(&self, figure: &Figure, rate: f64) -> Result<Motion, ReactionError> {
        let mut motion = sampled(figure, self, self.body.fingerprint, rate)?;
        motion.relief = self.relief().cloned();
        Ok(motion)
    }

    /// The side that a foot of the plan is on.
    fn seen_side(&self, side: usize) -> usize {
        if self.left_first { 1 - side } else { side }
    }

    /// The number among its foot's prints that a print of the whole walk has in the one that was planned.
    pub(super) fn planned_print(&self, episode: &Episode) -> usize {
        // A little after the contact, where rounding does not decide which print it is.
        self.laws.course.episode_at(episode.side, self.repeat.fold(episode.contact + 0.01).0)
    }

    /// The style in which a foot stands on a print of the whole walk and lifts from it.
    fn law(&self, episode: &Episode) -> &Style {
        let planned = self.laws.course.episode(episode.side, self.planned_print(episode));
        &self.laws.gaits.stance(&planned).style
    }

    /// Touch-downs and lift-offs in the order of time.
    pub fn events(&self) -> Vec<Event> {
        let mut events = Vec::new();
        for side in [0, 1] {
            let link = FEET[self.seen_side(side)];
            for j in 0..self.whole.episode_count(side) {
                let episode = self.whole.episode(side, j);
                let link = link.to_owned();
                let (lands, lifts) =
                    (EventKind::TouchDown { link: link.clone() }, EventKind::LiftOff { link });
                // In reversed time a foot lifts as it would have landed.
                let (lands, lifts) = if self.backward { (lifts, lands) } else { (lands, lifts) };
                if episode.kind != Kind::First {
                    events.push(Event { time: self.time(episode.contact), kind: lands });
                }
                if matches!(episode.kind, Kind::First | Kind::Step) {
                    let time = self.time(episode.contact + self.law(&episode).toe_off());
                    events.push(Event { time, kind: lifts });
                }
            }
        }
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        events
    }

    /// When the tip of the cane is planted, of a walk forward.
    fn cane_planted(&self, figure: &Figure) -> Vec<Interval> {
        let tip = |link: usize| Some((link, *figure.links()[link].tip()?));
        let (Some(cane), Some((link, point))) = (self.body.cane, figure.link_index(CANE).and_then(tip))
        else {
            return Vec::new();
        };
        let clock = |u: f64| self.forward_time(u.clamp(self.whole.begin - 1.0, self.whole.end + 1.0));
        let time = |u: f64| clock(u).clamp(0.0, self.duration());
        let spans = cane::stands(&self.whole, 1 - cane.side);
        spans.map(|(from, until)| Interval { link, point, start: time(from), end: time(until) }).collect()
    }

    /// When which point of the soles is planted.
    pub fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let mut planted = Vec::new();
        let end = self.duration();
        for side in [0, 1] {
            for j in 0..self.whole.episode_count(side) {
                let episode = self.whole.episode(side, j);
                let stance = &self.feet[side].stances[self.planned_print(&episode)];
                let style = self.law(&episode);
                let clock = |v: f64| self.forward_time(episode.contact + v).clamp(0.0, end);
                let pushes = matches!(episode.kind, Kind::First | Kind::Step);
                let landed = if matches!(episode.kind, Kind::First) { -1.0 } else { 0.0 };
                let flat =
                    if matches!(episode.kind, Kind::Step | Kind::Last) { style.foot_flat } else { landed };
                let last = |v: f64| if pushes { clock(v) } else { end };
                let stood = Stood {
                    landed: clock(landed),
                    flat: clock(flat),
                    on_ball: matches!(episode.kind, Kind::Step | Kind::Last) && stance.lands_on_ball(),
                    heel_off: last(stance.heel_off()),
                    tip_roll: last(stance.tip_roll_at()),
                    toe_off: last(style.toe_off()),
                };
                planted.extend(stood.planted(figure, self.seen_side(side)));
            }
        }
        planted.extend(self.cane_planted(figure));
        if self.backward {
            for interval in &mut planted {
                (interval.start, interval.end) = (end - interval.end, end - interval.start);
            }
        }
        planted.sort_by(|a, b| a.start.total_cmp(&b.start));
        planted
    }
}

impl SupportLaw for WalkPlan {
    fn support(&self, t: f64) -> Support {
        let u = self.clock_at(t);
        let pivot = self.laws.pivot(self.repeat.fold(u).0);
        let on_cane = self.cane(u).map_or_else(Vector3::zeros, |cane| cane.force);
        Support { feet: self.support(u), pivot, force: Some(self.force(u) - on_cane) }
    }

    fn beside(&self, t: f64) -> Option<(&str, Contact)> {
        Some((CANE, self.cane(self.clock_at(t))?))
    }
}

impl Walking for WalkPlan {
    fn events(&self) -> Vec<Event> {
        Self::events(self)
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        Self::planted(self, figure)
    }
}
