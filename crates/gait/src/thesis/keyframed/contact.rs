//! Touch-downs, lift-offs and planted points of a keyframed walk.

use super::KeyframedWalk;
use super::foot::Free;
use crate::body::roles::{FEET, TOES};
use crate::thesis::determinants::Root;
use crate::walking::{Walking, annotate};
use solaris_model::{
    Event, EventKind, Figure, Interval, Motion, MotionError, MotionInfo, SolePart, Trajectory as _,
};

/// Points of a foot on the ground while it turns about one of them: whether of the toes' link, and which.
fn touching(point: Root) -> &'static [(bool, SolePart)] {
    match point {
        Root::Heel => &[(false, SolePart::Heel)],
        Root::Sole => &[
            (false, SolePart::Heel),
            (false, SolePart::Ball),
            (true, SolePart::Ball),
            (true, SolePart::ToeTip),
        ],
        Root::Ball => &[(true, SolePart::Ball), (true, SolePart::ToeTip)],
        Root::Tip => &[(true, SolePart::ToeTip)],
    }
}

impl KeyframedWalk {
    /// The walk sampled `rate` times a second, with its events and planted points.
    ///
    /// # Errors
    ///
    /// A rate that is none, and another figure than the walk's.
    pub fn motion(&self, figure: &Figure, rate: f64) -> Result<Motion, MotionError> {
        let info = MotionInfo { fingerprint: self.body.fingerprint, ..MotionInfo::on_earth(figure, rate) };
        let mut motion = Motion::sample(figure, self, info)?;
        annotate(&mut motion, self, figure);
        Ok(motion)
    }

    /// What each foot stands on: side, point, from when, until when (s); in the order of time.
    fn stands(&self) -> Vec<(usize, Root, f64, f64)> {
        let (begin, end) = (self.phases[0].start, self.end());
        let mut stands = vec![(0, Root::Sole, 0.0, begin), (1, Root::Sole, 0.0, begin)];
        for phase in &self.phases {
            let span = (phase.start, phase.start + phase.duration);
            let root = usize::from(phase.root.swing);
            stands.push((phase.side(root), phase.root.point, span.0, span.1));
            if let Free::Pinned { point, .. } = phase.free {
                stands.push((phase.side(1 - root), point, span.0, span.1));
            }
        }
        stands.extend([(0, Root::Sole, end, self.duration()), (1, Root::Sole, end, self.duration())]);
        stands
    }

    /// Touch-downs and lift-offs in the order of time.
    pub fn events(&self) -> Vec<Event> {
        let mut events = Vec::new();
        for (side, link) in FEET.iter().enumerate() {
            let own: Vec<_> = self.stands().into_iter().filter(|stand| stand.0 == side).collect();
            for pair in own.windows(2) {
                let (lift, touch) = (pair[0].3, pair[1].2);
                // A foot that lands as another phase begins has been in the air all through the one before.
                if touch - lift > 1e-9 {
                    let link = (*link).to_owned();
                    events.push(Event { time: lift, kind: EventKind::LiftOff { link: link.clone() } });
                    events.push(Event { time: touch, kind: EventKind::TouchDown { link } });
                }
            }
        }
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        events
    }

    /// When which point of the soles is planted.
    pub fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let mut planted: Vec<Interval> = Vec::new();
        for (side, root, start, end) in self.stands() {
            for &(toes, part) in touching(root) {
                let name = if toes { TOES[side] } else { FEET[side] };
                let Some(link) = figure.link_index(name) else { continue };
                let Some(&point) = figure.links()[link].sole_point(part) else { continue };
                let goes_on = |known: &&mut Interval| {
                    known.link == link && known.point == point && (known.end - start).abs() < 1e-9
                };
                match planted.iter_mut().rev().find(goes_on) {
                    Some(known) => known.end = end,
                    None => planted.push(Interval { link, point, start, end }),
                }
            }
        }
        planted.sort_by(|a, b| a.start.total_cmp(&b.start));
        planted
    }
}

impl Walking for KeyframedWalk {
    fn events(&self) -> Vec<Event> {
        Self::events(self)
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        Self::planted(self, figure)
    }
}
