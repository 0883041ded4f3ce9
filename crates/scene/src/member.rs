//! One figure of several: what of the whole is its own, and where it stands.

use solaris_dynamics::Wrench;
use solaris_model::{
    Contact, ContactTrack, Event, EventKind, Figure, Interval, Known, Motion, MotionError, Placement,
};

/// A figure of several, with its part of what all of them do.
#[derive(Clone, Debug)]
pub struct OneOfSeveral {
    /// What the scene calls it.
    pub name: String,
    /// Its first link among those of all.
    pub first: usize,
    /// The figure as it is alone, at the world's origin.
    pub alone: Figure,
    /// The figure where its place is.
    pub figure: Figure,
    /// What that one does: positions, velocities, accelerations, joint forces, contacts, touch-downs and lift-offs.
    pub motion: Motion,
}

/// A figure of several.
#[derive(Clone, Debug)]
pub(crate) struct Member {
    pub(crate) name: String,
    /// As it is alone, at the world's origin.
    pub(crate) figure: Figure,
    pub(crate) place: Placement,
    /// Its first link, coordinate and degree of freedom in the whole.
    pub(crate) link: usize,
    pub(crate) q: usize,
    pub(crate) v: usize,
}

impl Member {
    /// All of them, in the order in which [`Figure::together`] has them.
    pub(crate) fn all(figures: impl IntoIterator<Item = (String, Figure, Placement)>) -> Vec<Self> {
        // The world's link comes first, and moves in no way.
        let (mut link, mut q, mut v) = (1, 0, 0);
        let mut members = Vec::new();
        for (name, figure, place) in figures {
            let (links, nq, nv) = (figure.links().len(), figure.layout().nq(), figure.layout().nv());
            members.push(Self { name, figure, place, link, q, v });
            (link, q, v) = (link + links, q + nq, v + nv);
        }
        members
    }

    /// Its coordinates and degrees of freedom in the whole.
    pub(crate) fn rows(&self) -> (std::ops::Range<usize>, std::ops::Range<usize>) {
        let layout = self.figure.layout();
        (self.q..self.q + layout.nq(), self.v..self.v + layout.nv())
    }

    /// Its part of a motion of all, as it would be alone at the world's origin.
    pub(crate) fn part(&self, motion: &Motion) -> Result<Motion, MotionError> {
        self.part_of(motion, &self.figure, &self.place.inverse())
    }

    /// What acts on its links of what acts on links of the whole, as it would be alone at the world's origin.
    pub(crate) fn acting(&self, all: &[(usize, Wrench<f64>)]) -> Vec<(usize, Wrench<f64>)> {
        let back = self.place.inverse();
        let links = self.link..self.link + self.figure.links().len();
        let own = all.iter().filter(|(link, _)| links.contains(link));
        own.map(|(link, wrench)| (link - self.link, moved_wrench(wrench, &back))).collect()
    }

    /// Itself where it stands, with its part of a motion of all.
    pub(crate) fn in_the_world(&self, motion: &Motion) -> Result<OneOfSeveral, MotionError> {
        let figure = self.figure.placed(&self.place);
        let mut own = self.part_of(motion, &figure, &Placement::identity())?;
        if let Some(taus) = motion.taus() {
            let (_, of_v) = self.rows();
            own.set_tau(
                taus.chunks_exact(motion.v(0).len()).flat_map(|row| row[of_v.clone()].to_vec()).collect(),
            )?;
        }
        own.events = motion.events.iter().filter_map(|event| self.own_event(event)).collect();
        let (name, first, alone) = (self.name.clone(), self.link, self.figure.clone());
        Ok(OneOfSeveral { name, first, alone, figure, motion: own })
    }

    /// Its part of a motion of all, of itself placed as `figure`, with its contacts brought where that has them.
    fn part_of(&self, motion: &Motion, figure: &Figure, back: &Placement) -> Result<Motion, MotionError> {
        let (of_q, of_v) = self.rows();
        let rows = |row: &dyn Fn(usize) -> Vec<f64>| (0..motion.len()).flat_map(row).collect::<Vec<f64>>();
        let columns = [
            rows(&|i| motion.q(i)[of_q.clone()].to_vec()),
            rows(&|i| motion.v(i)[of_v.clone()].to_vec()),
            rows(&|i| motion.a(i)[of_v.clone()].to_vec()),
        ];
        let known = motion.known();
        let known = Known { v: known.v[of_v.clone()].to_vec(), a: known.a[of_v].to_vec() };
        let info = solaris_model::MotionInfo { fingerprint: figure.fingerprint(), ..motion.info.clone() };
        let mut part = Motion::recorded(figure, info, motion.time().to_vec(), columns, known)?;
        let own = motion.contacts.iter().filter_map(|track| {
            Some(ContactTrack { link: self.own_name(&track.link)?, samples: moved(&track.samples, back) })
        });
        part.contacts.extend(own);
        let planted = motion.planted.iter().filter_map(|planted| {
            let link =
                planted.link.checked_sub(self.link).filter(|link| *link < self.figure.links().len())?;
            Some(Interval { link, ..planted.clone() })
        });
        part.planted.extend(planted);
        part.relief.clone_from(&motion.relief);
        Ok(part)
    }

    /// Writes what was found of its part into the motion of all: joint forces and contacts.
    pub(crate) fn put_back(&self, part: &Motion, motion: &mut Motion) -> Result<(), MotionError> {
        let (_, of_v) = self.rows();
        let nv = motion.v(0).len();
        if let (Some(taus), Some(own)) = (motion.taus(), part.taus()) {
            let mut taus = taus.to_vec();
            for (row, own) in taus.chunks_exact_mut(nv).zip(own.chunks_exact(of_v.len())) {
                row[of_v.clone()].copy_from_slice(own);
            }
            motion.set_tau(taus)?;
        }
        for track in &part.contacts {
            let (link, samples) = (self.link_name(&track.link), moved(&track.samples, &self.place));
            match motion.contacts.iter_mut().find(|other| other.link == link) {
                Some(other) => other.samples = samples,
                None => motion.contacts.push(ContactTrack { link, samples }),
            }
        }
        Ok(())
    }

    /// What the link of that name among all is called by itself, if it is its own.
    fn own_name(&self, link: &str) -> Option<String> {
        Some(link.strip_prefix(&self.name)?.strip_prefix('.')?.to_owned())
    }

    /// An event of all, if it is its own.
    fn own_event(&self, event: &Event) -> Option<Event> {
        let kind = match &event.kind {
            EventKind::TouchDown { link } => EventKind::TouchDown { link: self.own_name(link)? },
            EventKind::LiftOff { link } => EventKind::LiftOff { link: self.own_name(link)? },
            _ => return None,
        };
        Some(Event { kind, ..event.clone() })
    }

    /// What one of its links is called among all.
    fn link_name(&self, own: &str) -> String {
        format!("{}.{own}", self.name)
    }

    /// One of its planted points among all.
    pub(crate) fn interval(&self, own: &Interval) -> Interval {
        Interval { link: own.link + self.link, ..own.clone() }
    }

    /// An event of it among all.
    pub(crate) fn event(&self, own: &Event) -> Event {
        let kind = match &own.kind {
            EventKind::TouchDown { link } => EventKind::TouchDown { link: self.link_name(link) },
            EventKind::LiftOff { link } => EventKind::LiftOff { link: self.link_name(link) },
            EventKind::RootChange { link } => EventKind::RootChange { link: self.link_name(link) },
            other => other.clone(),
        };
        Event { kind, ..own.clone() }
    }
}

/// Contacts elsewhere: their forces turned, and moments about the world's origin.
/// A wrench about the world's origin, of links that are all brought by a placement.
fn moved_wrench(wrench: &Wrench<f64>, place: &Placement) -> Wrench<f64> {
    let force = place.rotation * wrench.force;
    Wrench { force, moment: place.rotation * wrench.moment + place.translation.vector.cross(&force) }
}

fn moved(samples: &[Contact], place: &Placement) -> Vec<Contact> {
    let one = |contact: &Contact| {
        let Wrench { force, moment } =
            moved_wrench(&Wrench { force: contact.force, moment: contact.moment }, place);
        let is_none = contact.force.norm_squared() == 0.0;
        // Without a force there is no centre of pressure.
        let cop = if is_none { contact.cop } else { place.transform_point(&contact.cop.into()).coords };
        Contact { force, moment, cop }
    };
    samples.iter().map(one).collect()
}
