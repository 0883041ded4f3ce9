//! Somebody who stands and breathes.

use crate::smooth::WalkPlan;
use solaris_model::{Figure, Trajectory};
use std::f64::consts::TAU;

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
