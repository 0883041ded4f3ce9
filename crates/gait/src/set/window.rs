//! Parts of a walk, from the origin on.

use crate::smooth::WalkPlan;
use crate::walking::Walking;
use solaris_model::{Event, Figure, Interval, Motion, MotionError, MotionInfo, Trajectory};
use std::f64::consts::TAU;

/// A walk from a time to a later one; it goes on before and after.
pub(super) struct Window<'a> {
    walk: &'a WalkPlan,
    from: f64,
    to: f64,
}

impl<'a> Window<'a> {
    pub(super) fn new(walk: &'a WalkPlan, from: f64, to: f64) -> Self {
        Self { walk, from, to }
    }

    /// Its samples, with what happens in it.
    pub(super) fn motion(&self, figure: &Figure, rate: f64) -> Result<Motion, MotionError> {
        let mut motion = Motion::sample(figure, self, MotionInfo::on_earth(figure, rate))?;
        motion.events = self.events();
        motion.planted = self.planted(figure);
        Ok(motion)
    }
}

impl Trajectory for Window<'_> {
    fn duration(&self) -> f64 {
        self.to - self.from
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.walk.configuration(self.from + t, q);
    }

    fn resolution(&self) -> f64 {
        self.walk.resolution()
    }
}

impl Walking for Window<'_> {
    fn events(&self) -> Vec<Event> {
        let slack = 1e-9;
        let mut events = self.walk.events();
        for event in &mut events {
            event.time -= self.from;
        }
        events.retain(|event| (-slack..=self.duration() + slack).contains(&event.time));
        for event in &mut events {
            event.time = event.time.clamp(0.0, self.duration());
        }
        events
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let mut planted = self.walk.planted(figure);
        // Before the walk and after it feet stand where they do.
        let lasts = self.walk.duration() - 1e-9;
        for interval in &mut planted {
            let (start, end) = (interval.start, interval.end);
            interval.start = if start <= 0.0 { 0.0 } else { (start - self.from).max(0.0) };
            interval.end =
                if end >= lasts { self.duration() } else { (end - self.from).min(self.duration()) };
        }
        planted.retain(|interval| interval.start < interval.end);
        planted
    }
}

/// Somebody who stands as a walk begins, and breathes: the thorax leans back and comes again, and the neck holds the head.
pub(super) struct Breath {
    q: Vec<f64>,
    thorax: Option<usize>,
    neck: Option<usize>,
    period: f64,
}

/// How far the thorax leans back (rad); an artist's choice.
const BREATH: f64 = 0.012;

impl Breath {
    pub(super) fn new(figure: &Figure, walk: &WalkPlan, period: f64) -> Self {
        let mut q = vec![0.0; figure.layout().nq()];
        walk.configuration(0.0, &mut q);
        let at = |name: &str| figure.layout().coordinate(figure.layout().dof_index(name)?);
        Self { q, thorax: at("thorax.rx"), neck: at("neck.rx"), period }
    }
}

impl Trajectory for Breath {
    fn duration(&self) -> f64 {
        self.period
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        q.copy_from_slice(&self.q);
        let breath = 0.5 * BREATH * (1.0 - (TAU * t / self.period).cos());
        if let (Some(thorax), Some(neck)) = (self.thorax, self.neck) {
            q[thorax] -= breath;
            q[neck] += breath;
        }
    }

    fn resolution(&self) -> f64 {
        0.01
    }
}

/// A motion that begins at the origin: without where its root stands along x and z at first.
pub(super) fn at_origin(figure: &Figure, motion: Motion) -> Result<Motion, MotionError> {
    let nq = figure.layout().nq();
    // The root of a walker slides along x, y, z first.
    let root = figure.layout().joints()[0].q;
    let [mut q, v, a] = motion.columns().map(<[f64]>::to_vec);
    let (x, z) = (q[root], q[root + 2]);
    for row in q.chunks_exact_mut(nq) {
        row[root] -= x;
        row[root + 2] -= z;
    }
    let mut moved = motion;
    moved.set_states(figure, [q, v, a])?;
    Ok(moved)
}
