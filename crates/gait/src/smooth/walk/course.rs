//! The course of a walk: where and in which order its feet stand.

use super::numbers::SETTLE;
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
}

impl Print {
    /// A point of the world as a left foot's print has it; a right foot's is mirrored.
    #[inline]
    pub(super) fn local(&self, side: usize, point: &Vector3<f64>) -> Vector3<f64> {
        let at = turned(-self.heading, &(point - self.place));
        if side == 0 { at } else { mirror(&at) }
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
    prints: Vec<Print>,
}

impl Course {
    /// Of some steps; the body begins to move at the clock `begin`.
    pub(super) fn new(steps: &[Step], begin: f64) -> Self {
        let mut print = Print::default();
        let mut prints = vec![print];
        for step in steps {
            // Along the chord of an arc.
            let along = turned(print.heading + 0.5 * step.turn, &Vector3::z()) * step.length;
            print = Print { place: print.place + along, heading: print.heading + step.turn };
            prints.push(print);
        }
        prints.push(print);
        let n = steps.len();
        Self { steps: n, begin, end: 0.5 * (n as f64 + 1.0) + SETTLE, prints }
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
        let t = x - k;
        let control = |offset: isize| {
            let index = (k as isize + offset).clamp(0, self.steps as isize + 1);
            self.prints[index as usize].heading
        };
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
            return Episode { side, contact, print: self.prints[0], kind: Kind::First, index: 0, next };
        }
        let index = 2 * j - side;
        let kind = match index {
            k if k < self.steps => Kind::Step,
            k if k == self.steps => Kind::Last,
            _ => Kind::Close,
        };
        Episode { side, contact: index as f64 / 2.0, print: self.prints[index], kind, index, next: index + 1 }
    }

    /// The print that a foot stands on or has left last, at the clock `u`.
    pub(super) fn episode_at(&self, side: usize, u: f64) -> usize {
        let j = if side == 0 { u.floor() } else { (u + 0.5).floor() };
        (j.max(0.0) as usize).min(self.episode_count(side) - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_even_turn_goes_round_a_circle_and_faces_along_it() {
        let turn = 0.3;
        let steps = [Step { pace: 0, length: 0.6, turn }; 20];
        let course = Course::new(&steps, -0.75);
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
        let print = Print { place: Vector3::new(0.2, 0.0, 1.0), heading: 0.7 };
        let point = Vector3::new(-0.4, 0.9, 1.7);
        for side in [0, 1] {
            assert!((print.world(side, &print.local(side, &point)) - point).norm() < 1e-15);
        }
    }
}
