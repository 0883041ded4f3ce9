//! Equations of a few lines, integrated apart from the library, as the answer for scenes without a closed form.

use crate::report::simulation::figures::G;
use crate::report::simulation::solutions::Solution;

/// Of the ground (s/m): what comes down does not come back faster than 0.1 m/s.
pub(super) const DAMPING: f64 = 10.0;
/// The leg's stiffness (N/m) and damping (N s/m), and its length without a force (m).
pub(super) const LEG: [f64; 2] = [500.0, 30.0];
pub(super) const REST: f64 = 0.4;

/// Steps (s) that leave no error worth the name at 1e7 N/m under 0.2 kg.
const STEP: f64 = 5e-6;

/// What falls straight down on springs: heights and velocities of foot and body (without a leg the body is not there).
type State = [f64; 4];

/// Masses (kg) of foot and body, and the stiffness of the ground (N/m).
#[derive(Clone, Copy)]
pub(super) struct Drop {
    pub(super) foot: f64,
    pub(super) body: Option<f64>,
    pub(super) stiffness: f64,
}

impl Drop {
    /// Its rate; the ground pushes where it `touches`, so that nothing has a kink within a step.
    fn rate(&self, [y, top, v, rise]: State, touches: bool) -> State {
        let ground = if touches { (self.stiffness * -y * (1.0 - DAMPING * v)).max(0.0) } else { 0.0 };
        match self.body {
            None => [v, 0.0, ground / self.foot - G, 0.0],
            Some(body) => {
                let leg = LEG[0] * (REST - (top - y)) - LEG[1] * (rise - v);
                [v, rise, (ground - leg) / self.foot - G, leg / body - G]
            }
        }
    }

    /// A step of the classical rule of order four.
    fn step(&self, y: State, h: f64, touches: bool) -> State {
        let after = |k: State, h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let a = self.rate(y, touches);
        let b = self.rate(after(a, 0.5 * h), touches);
        let c = self.rate(after(b, 0.5 * h), touches);
        let d = self.rate(after(c, h), touches);
        std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    }

    /// The state after `span` (s); a step ends where a touch begins or ends.
    fn advance(&self, mut y: State, span: f64, touches: &mut bool) -> State {
        let mut left = span;
        while left > 1e-15 {
            let h = left.min(STEP);
            let changes = |y: &State| (y[0] < 0.0) != *touches;
            let next = self.step(y, h, *touches);
            if !changes(&next) {
                (y, left) = (next, left - h);
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if changes(&self.step(y, middle, *touches)) { high = middle } else { low = middle }
            }
            (y, left) = (self.step(y, high, *touches), left - high);
            *touches = !*touches;
        }
        y
    }

    /// Its motion from `height` (m) above the ground at rest, as a figure has it: the body first, and the foot against the body.
    pub(super) fn motion(self, height: f64, duration: f64, rate: f64) -> Solution {
        let mut y = [height, height + REST, 0.0, 0.0];
        let (mut touches, mut frames) = (false, vec![y]);
        for _ in 0..(duration * rate).round() as usize {
            y = self.advance(y, rate.recip(), &mut touches);
            frames.push(y);
        }
        Box::new(move |t, q, v| {
            let [foot, body, sinks, rises] = frames[(t * rate).round() as usize];
            if self.body.is_none() {
                (q[0], v[0]) = (foot, sinks);
            } else {
                q.copy_from_slice(&[body, foot - body]);
                v.copy_from_slice(&[rises, sinks - rises]);
            }
        })
    }
}
