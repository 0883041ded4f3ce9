//! A cane on the way: where its tip stands, and what it bears.
//!
//! It goes with the foot of the other side, as people are taught to: it is set down as that foot lands, bears some of the weight while the foot
//! stands alone, and goes on as the foot lifts. What it bears is a part of the whole vertical force, along the cane. Before the first step of that foot
//! it bears nothing.

use super::course::{Course, Kind, Print};
use super::standing::Standing;
use crate::body::Body;
use crate::body::foot::turned;

use nalgebra::Vector3;
use solaris_profiles::step;

/// The tip beside its foot: so far ahead of the heel (m, of somebody of the reference height).
const AHEAD: f64 = 0.10;
/// When it is lifted, on the clock of its foot (u), and how long its first way takes at most.
const LIFTS: f64 = 0.56;
const FIRST_WAY: f64 = 0.45;
/// How high it is lifted (m, likewise).
const HEIGHT: f64 = 0.04;
/// When what it bears rises, as the other foot lifts, and falls, as it lands, on the clock of its foot: begin and duration (u); and where the walk ends,
/// so that it bears nothing any more as the other foot closes.
const RISES: (f64, f64) = (0.0, 0.14);
const FALLS: (f64, f64) = (0.42, 0.14);
const FALLS_LAST: (f64, f64) = (0.35, 0.15);

/// The tip on one place.
#[derive(Clone, Copy, Debug)]
struct Stand {
    /// Its clocks.
    from: f64,
    until: f64,
    at: Vector3<f64>,
    /// When what it bears falls, if it bears something.
    falls: Option<(f64, f64)>,
}

/// The tip over a walk.
#[derive(Clone, Debug)]
pub(super) struct CaneWay {
    stands: Vec<Stand>,
    height: f64,
    load: f64,
}

/// The clocks between which the cane of the foot on a side stands.
pub(super) fn stands(course: &Course, side: usize) -> impl Iterator<Item = (f64, f64)> {
    (0..course.episode_count(side)).map(move |j| {
        let episode = course.episode(side, j);
        match episode.kind {
            Kind::First => {
                (f64::NEG_INFINITY, (course.episode(side, 1).contact - FIRST_WAY).max(course.begin))
            }
            Kind::Step => (episode.contact, episode.contact + LIFTS),
            Kind::Last | Kind::Close => (episode.contact, f64::INFINITY),
        }
    })
}

impl CaneWay {
    /// Of somebody who stands first and last with the tip as these do, and bears the part `load` of the vertical force on it at most; none without a cane.
    pub(super) fn new(course: &Course, body: &Body, standing: [&Standing; 2], load: f64) -> Option<Self> {
        let (cane, [first, last]) = (body.cane?, [standing[0].cane?, standing[1].cane?]);
        // The foot that it helps.
        let side = 1 - cane.side;
        let aside = Vector3::new(first.x, 0.0, AHEAD * body.scale());
        let beside = |print: Print, tip: &Vector3<f64>| print.place + turned(print.heading, tip);
        let stands = stands(course, side).enumerate().map(|(j, (from, until))| {
            let episode = course.episode(side, j);
            let at = match episode.kind {
                Kind::First => beside(course.first(), &first),
                // As the body faces in the middle of it, to be as far from the shoulder before as after.
                Kind::Step => {
                    let facing = course.heading(episode.contact + 0.5 * LIFTS);
                    course.way(episode.index).place + turned(facing, &aside)
                }
                Kind::Last | Kind::Close => beside(course.last(), &last),
            };
            let falls = match episode.kind {
                Kind::Step => Some(FALLS),
                Kind::Last => Some(FALLS_LAST),
                Kind::First | Kind::Close => None,
            };
            Stand { from, until, at, falls }
        });
        Some(Self { stands: stands.collect(), height: HEIGHT * body.scale(), load })
    }

    /// The place that it stands on, or has left last.
    fn stand(&self, u: f64) -> usize {
        self.stands.partition_point(|stand| stand.from <= u).saturating_sub(1)
    }

    /// Where it is (m).
    pub(super) fn tip(&self, u: f64) -> Vector3<f64> {
        let k = self.stand(u);
        let from = &self.stands[k];
        let Some(to) = self.stands.get(k + 1).filter(|_| u > from.until) else { return from.at };
        let part = (u - from.until) / (to.from - from.until);
        let way = step::quintic(part).position;
        // C² at both ends.
        let up = (4.0 * part * (1.0 - part)).powi(3);
        from.at.lerp(&to.at, way) + Vector3::y() * (self.height * up)
    }

    /// The part of the vertical force that it bears.
    pub(super) fn share(&self, u: f64) -> f64 {
        let stand = &self.stands[self.stand(u)];
        let Some(falls) = stand.falls else { return 0.0 };
        let at = |(begin, time): (f64, f64)| step::quintic((u - stand.from - begin) / time).position;
        self.load * at(RISES) * (1.0 - at(falls))
    }
}
