//! The frames of a pass.

use crate::between::Between;
use crate::failure::SetupError;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::{Event, Figure, Motion, MotionInfo};

/// The frames of a pass: times that are known beforehand, and the states that are found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Record {
    /// Times of all frames (s).
    pub(crate) times: Vec<f64>,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    /// How many are there.
    pub(crate) done: usize,
    pub(crate) events: Vec<Event>,
    /// What the ground does to what stands on it: frame, link and wrench (about the world's origin), in the order of the frames.
    pub(crate) planted: Vec<(usize, usize, Wrench<f64>)>,
    /// What links do to each other, by frame, in the order of the frames.
    pub(crate) between: Vec<(usize, Between)>,
}

impl Record {
    /// Frames at `rate` (1/s) from 0 to `duration` (s).
    pub(crate) fn new(duration: f64, rate: f64) -> Self {
        if duration.is_infinite() {
            // Whoever steps looks for himself.
            return Self::default();
        }
        // A duration of whole frames is one in spite of rounding.
        let last = (duration * rate * (1.0 + 1e-12) + 1e-9).floor();
        let times = (0..=last as usize).map(|k| (k as f64 / rate).min(duration)).collect();
        Self { times, ..Self::default() }
    }

    /// The time of the frame that is due next.
    pub(crate) fn due(&self) -> Option<f64> {
        self.times.get(self.done).copied()
    }

    /// The frames that are due before `end` (s).
    pub(crate) fn before(&self, end: f64) -> &[f64] {
        let count = self.times[self.done..].partition_point(|time| *time < end - near(end));
        &self.times[self.done..self.done + count]
    }

    /// The positions of the last frames, four at most.
    pub(crate) fn last(&self) -> &[f64] {
        let nq = self.q.len().checked_div(self.done).unwrap_or(0);
        &self.q[self.q.len() - nq * self.done.min(4)..]
    }

    /// The first frame later than `time` (s).
    pub(crate) fn after(&self, time: f64) -> Option<f64> {
        self.times.get(self.times.partition_point(|frame| *frame <= time + near(time))).copied()
    }

    /// Adds the frame that is due.
    pub(crate) fn push(&mut self, q: &[f64], v: &[f64], a: &[f64]) {
        self.q.extend_from_slice(q);
        self.v.extend_from_slice(v);
        self.a.extend_from_slice(a);
        self.done += 1;
    }

    /// What the ground does, in the frame that was added last, to links that stand on it, and what links do to each other.
    pub(crate) fn press(&mut self, active: impl Iterator<Item = (usize, Wrench<f64>)>, between: &[Between]) {
        let frame = self.done - 1;
        self.planted.extend(active.map(|(link, wrench)| (frame, link, wrench)));
        self.between.extend(between.iter().map(|between| (frame, *between)));
    }

    /// The positions of a frame.
    pub(crate) fn q(&self, frame: usize) -> &[f64] {
        let nq = self.q.len() / self.done;
        &self.q[frame * nq..][..nq]
    }

    /// The velocities of a frame.
    pub(crate) fn v(&self, frame: usize) -> &[f64] {
        let nv = self.v.len() / self.done;
        &self.v[frame * nv..][..nv]
    }

    /// The motion.
    pub(crate) fn motion(
        self,
        figure: &Figure,
        gravity: Vector3<f64>,
        rate: f64,
    ) -> Result<Motion, SetupError> {
        let info = MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate };
        let mut times = self.times;
        times.truncate(self.done);
        let mut motion = Motion::new(figure, info, times, [self.q, self.v, self.a])?;
        motion.events = self.events;
        Ok(motion)
    }
}

/// How near (s) two times are that are the same but for rounding.
pub(crate) fn near(time: f64) -> f64 {
    1e-12 * (1.0 + time.abs())
}
