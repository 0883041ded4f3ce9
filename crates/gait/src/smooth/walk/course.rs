//! The course of a walk: where and in which order its feet stand.

use super::numbers::{OPENED, SETTLE};
use crate::body::foot::{mirror, turned};
use nalgebra::Vector3;

/// A step of a walk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    /// Which of the walk's strides it is a step of.
    pub(crate) pace: usize,
    /// Its length (m).
    pub(crate) length: f64,
    /// By how much its foot turns to the left of the other one (rad).
    pub(crate) turn: f64,
    /// Which way it goes, to the left of where the other foot points (rad): half the turn along an arc.
    pub(crate) bearing: f64,
    /// By how much its foot is turned to the left besides, which changes nothing of the way (rad).
    pub(crate) yaw: f64,
    /// By which part it lasts longer than its pace and the one before have it.
    pub(crate) slower: f64,
    /// By how much its print is higher than the one before (m).
    pub(crate) rise: f64,
    /// Pitch of the ground under it (rad).
    pub(crate) tilt: f64,
}

impl Step {
    /// On level ground, along the chord of an arc.
    pub(crate) fn along_an_arc(pace: usize, length: f64, turn: f64) -> Self {
        Self { pace, length, turn, bearing: 0.5 * turn, yaw: 0.0, slower: 0.0, rise: 0.0, tilt: 0.0 }
    }
}

/// What a foot does on one print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// It stands from the begin.
    First,
    /// It lands, rolls and pushes off.
    Step,
    /// It lands and stays.
    Last,
    /// It is set down flat beside the other one.
    Close,
}

/// A print's frame: both feet's lines lie half a step width beside it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Print {
    /// Point of the way beside the heel (m).
    pub(super) place: Vector3<f64>,
    /// Which way it points (rad, to the left of z).
    pub(super) heading: f64,
    /// Pitch of the ground along z (rad).
    pub(super) tilt: f64,
}

impl Print {
    /// A point of the world as a left foot's print has it; a right foot's is mirrored.
    #[inline]
    pub(super) fn local(&self, side: usize, point: &Vector3<f64>) -> Vector3<f64> {
        let at = turned(-self.heading, &(point - self.place));
        if side == 0 { at } else { mirror(&at) }
    }

    /// The same with a foot turned by `opened` to the left about its heel, which is `beside` the way (m).
    fn opened(&self, side: usize, opened: f64, beside: f64) -> Self {
        if opened == 0.0 {
            return *self;
        }
        let heel = if side == 0 { beside } else { -beside };
        let (heel, heading) = (Vector3::x() * heel, self.heading + opened);
        Self {
            place: self.place + turned(self.heading, &heel) - turned(heading, &heel),
            heading,
            tilt: self.tilt,
        }
    }

    /// The point of the world.
    #[inline]
    pub(super) fn world(&self, side: usize, local: &Vector3<f64>) -> Vector3<f64> {
        let at = if side == 0 { *local } else { mirror(local) };
        self.place + turned(self.heading, &at)
    }
}

/// One foot on one print.
#[derive(Clone, Copy, Debug)]
pub(super) struct Episode {
    pub(super) side: usize,
    /// Its contact on the walk's clock.
    pub(super) contact: f64,
    pub(super) print: Print,
    pub(super) kind: Kind,
    /// Number of the contact: odd ones are right.
    pub(super) index: usize,
    /// Number of the contact of the other foot before whose double support it lifts.
    pub(super) next: usize,
}

impl Episode {
    /// A point of the world as a left foot on this print has it.
    #[inline]
    pub(super) fn local(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.print.local(self.side, point)
    }
}

/// Prints and contacts of a walk of n steps: contact k is at the clock k/2, n + 1 closes.
pub(crate) struct Course {
    pub(crate) steps: usize,
    /// Rest before and after these clocks.
    pub(super) begin: f64,
    pub(super) end: f64,
    /// Points of the way and where it goes there.
    prints: Vec<Print>,
    /// The same for the feet, which are turned outward besides where the way turns.
    feet: Vec<Print>,
}

impl Course {
    /// Of steps of feet on lines `beside` the way (m), from feet that stand on ground of this pitch (rad); the body begins to move at the
    /// clock `begin`.
    pub(super) fn new(steps: &[Step], beside: f64, standing: f64, begin: f64) -> Self {
        let mut print = Print { tilt: standing, ..Print::default() };
        let mut prints = vec![print];
        for step in steps {
            let along = turned(print.heading + step.bearing, &Vector3::z()) * step.length;
            print = Print {
                place: print.place + along + Vector3::y() * step.rise,
                heading: print.heading + step.turn,
                tilt: step.tilt,
            };
            prints.push(print);
        }
        prints.push(print);
        let n = steps.len();
        let feet =
            prints.iter().enumerate().map(|(k, way)| way.opened(k % 2, opened(steps, k), beside)).collect();
        Self { steps: n, begin, end: 0.5 * (n as f64 + 1.0) + SETTLE, prints, feet }
    }

    /// Whether it turns at contact `k` or two steps before or after it.
    pub(super) fn turns_near(&self, k: usize) -> bool {
        (k.saturating_sub(2)..=k + 2).any(|near| self.turning(near) > 0.0)
    }

    /// Whether it goes straight on from begin to end.
    pub(super) fn is_straight(&self) -> bool {
        self.prints.iter().all(|print| print.heading == 0.0)
    }

    /// Length of the step to contact `k` (m).
    pub(super) fn step_length(&self, k: usize) -> f64 {
        (self.prints[k].place - self.prints[k.saturating_sub(1)].place).norm()
    }

    /// By how much the way turns at contact `k` (rad), whichever way: the mean of the steps before and after it.
    pub(super) fn turning(&self, k: usize) -> f64 {
        let at = |k: usize| self.prints[k.min(self.steps)].heading;
        0.5 * (at(k + 1) - at(k.saturating_sub(1))).abs()
    }

    /// Where it begins.
    pub(super) fn first(&self) -> Print {
        self.prints[0]
    }

    /// Which way its prints point (rad, to the left of z).
    pub(super) fn headings(&self) -> impl Iterator<Item = f64> {
        self.prints.iter().map(|print| print.heading)
    }

    /// The way at contact `k`.
    pub(super) fn way(&self, k: usize) -> Print {
        self.prints[k]
    }

    /// Where the walk ends.
    pub(super) fn last(&self) -> Print {
        self.prints[self.steps]
    }

    /// The clock that runs alike at the end of every walk.
    pub(super) fn finish(&self, u: f64) -> f64 {
        u - (self.steps as f64 - 1.0) / 2.0
    }

    /// Which way the body faces: at contact k midway between both feet, in between along a cubic B-spline (C²), which keeps an
    /// even rate where every step turns as much.
    pub(super) fn heading(&self, u: f64) -> f64 {
        let x = 2.0 * u - 0.5;
        let k = x.floor();
        self.blended(k as isize, x - k, |print| print.heading)
    }

    /// Height of the ground that the body follows: over contact k that of its print, in between along a cubic B-spline (C²), which is a
    /// line where prints rise evenly.
    pub(super) fn rise(&self, u: f64) -> f64 {
        let x = 2.0 * u;
        let k = x.floor();
        self.blended(k as isize, x - k, |print| print.place.y)
    }

    /// Cubic B-spline of a number of the prints, at the part `t` of the way from print `k` to the next one.
    fn blended(&self, k: isize, t: f64, of: impl Fn(&Print) -> f64) -> f64 {
        let control =
            |offset: isize| of(&self.prints[(k + offset).clamp(0, self.steps as isize + 1) as usize]);
        let s = 1.0 - t;
        let weights =
            [s * s * s, 3.0 * t * t * t - 6.0 * t * t + 4.0, 3.0 * s * s * s - 6.0 * s * s + 4.0, t * t * t];
        (-1..3).zip(weights).map(|(offset, weight)| control(offset) * weight).sum::<f64>() / 6.0
    }

    /// Number of prints of a foot.
    pub(super) fn episode_count(&self, side: usize) -> usize {
        (self.steps + 1 + side) / 2 + 1
    }

    /// A foot's `j`-th print; 0 is where it stands at first.
    pub(super) fn episode(&self, side: usize, j: usize) -> Episode {
        if j == 0 {
            let (contact, next) = if side == 0 { (0.0, 1) } else { (-0.5, 0) };
            return Episode { side, contact, print: self.feet[0], kind: Kind::First, index: 0, next };
        }
        let index = 2 * j - side;
        let kind = match index {
            k if k < self.steps => Kind::Step,
            k if k == self.steps => Kind::Last,
            _ => Kind::Close,
        };
        Episode { side, contact: index as f64 / 2.0, print: self.feet[index], kind, index, next: index + 1 }
    }

    /// The print that a foot stands on or has left last, at the clock `u`.
    pub(super) fn episode_at(&self, side: usize, u: f64) -> usize {
        let j = if side == 0 { u.floor() } else { (u + 0.5).floor() };
        (j.max(0.0) as usize).min(self.episode_count(side) - 1)
    }
}

/// By how much the foot of contact `k` is turned outward besides its own way: the inner foot opens into a turn, the outer one does
/// not follow all of it, so that knees and toes pass each other. Feet that stand at the ends are as ever.
fn opened(steps: &[Step], k: usize) -> f64 {
    let own = k.checked_sub(1).and_then(|step| steps.get(step)).map_or(0.0, |step| step.yaw);
    if k == 0 || k >= steps.len() {
        return own;
    }
    let turn = 0.5 * (steps[k - 1].turn + steps[k].turn);
    // Beside a foot that stands as ever it makes up for both.
    let alone = k == 1 || k + 1 == steps.len() || steps[k - 1].turn == 0.0 || steps[k].turn == 0.0;
    let outward = turn.abs() * if alone { OPENED.1 } else { OPENED.0 };
    own + if k % 2 == 1 { -outward } else { outward }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_even_turn_goes_round_a_circle_and_faces_along_it() {
        let turn = 0.3;
        let steps = [Step::along_an_arc(0, 0.6, turn); 20];
        let course = Course::new(&steps, 0.05, 0.0, -0.75);
        // Chords of 0.6 m that turn by 0.3: a circle of radius 0.3 m / sin 0.15 to the left.
        let radius = 0.3 / (0.5 * turn).sin();
        for print in &course.prints {
            assert!((print.place - Vector3::x() * radius).norm() - radius < 1e-12);
        }
        // Midway between the headings of two feet as the second one lands, and even in between.
        for u in [3.0, 3.1, 3.37, 4.9] {
            assert!((course.heading(u) - turn * (2.0 * u - 0.5)).abs() < 1e-12);
        }
        assert!(course.heading(-0.3).abs() < 1e-15 && (course.heading(11.0) - 20.0 * turn).abs() < 1e-12);
    }

    #[test]
    fn a_prints_frame_goes_there_and_back() {
        let print = Print { place: Vector3::new(0.2, 0.0, 1.0), heading: 0.7, tilt: 0.0 };
        let point = Vector3::new(-0.4, 0.9, 1.7);
        for side in [0, 1] {
            assert!((print.world(side, &print.local(side, &point)) - point).norm() < 1e-15);
        }
    }
}
