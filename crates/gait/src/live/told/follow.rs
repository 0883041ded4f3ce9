//! A coordinate that goes from one law over to another, or along one that jumps, without a jump of its own.

/// By how much a law may change its rate and be followed to the bit (rad/s²).
const MOST_CHANGE: f64 = 150.0;
/// A change of the rate that is so many times as much is none: the law has jumped.
const JUMPS: f64 = 3.0;
/// Accelerations are those over no less than this (s).
const LEAST_FRAME: f64 = 1e-6;
/// How long what is apart takes to come together (s).
const EASES: f64 = 0.3;

/// What follows a law `L` that is known frame by frame:
///
/// ```text
/// x = L + e        e(s) = (1 − s)² (p + (2p + v) s),  s = t/T
/// ```
///
/// Its rate `r` is the law's as far as that changes by no more than people's limbs do; what the law does beyond, jumps above all, is taken off `e`, which begins anew from
/// its present place and rate. So `x` never jumps, its rate changes by so much a second and by `e`'s, and a smooth law is followed to the bit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Follow {
    law: f64,
    rate: f64,
    /// `p`, `v` (per `T`) and for how long (s) `e` goes on.
    apart: [f64; 2],
    since: f64,
    jumped: bool,
    /// Rate and acceleration of `x` in the last frame.
    moves: [f64; 2],
}

impl Follow {
    /// At a value (rad), with a rate (rad/s).
    pub(super) fn from(value: f64, rate: f64) -> Self {
        Self { law: value, rate, apart: [0.0; 2], since: EASES, jumped: false, moves: [rate, 0.0] }
    }

    /// Goes on by `dt` (s) to where the law is then, or to another law.
    pub(super) fn step(&mut self, dt: f64, law: f64, is_another: bool) -> f64 {
        let [place, rate] = self.eased(dt);
        let change = (law - self.law) / dt - self.rate;
        let most = MOST_CHANGE * dt;
        // A jump tells nothing of the rate; of two on end the second does.
        self.jumped = is_another || (change.abs() > JUMPS * most && !self.jumped);
        let taken = if self.jumped { 0.0 } else { change.clamp(-most, most) };
        self.since += dt;
        if taken.to_bits() != change.to_bits() {
            let beyond = (law - self.law) - (self.rate + taken) * dt;
            self.apart = [place - beyond, rate * EASES];
            self.since = 0.0;
        }
        self.rate += taken;
        self.law = law;
        let [place, rate] = self.eased(0.0);
        let rate = self.rate + rate;
        self.moves = [rate, (rate - self.moves[0]) / dt.max(LEAST_FRAME)];
        law + place
    }

    /// Whether it is where the law is.
    pub(super) fn is_there(&self) -> bool {
        self.since >= EASES
    }

    /// Rate and acceleration in the last frame (rad/s, rad/s²).
    pub(super) fn moves(&self) -> [f64; 2] {
        self.moves
    }

    /// `e` and its rate so much later.
    fn eased(&self, later: f64) -> [f64; 2] {
        let s = (self.since + later) / EASES;
        if s >= 1.0 {
            return [0.0; 2];
        }
        let ([p, v], left) = (self.apart, 1.0 - s);
        let (line, slope) = (p + (2.0 * p + v) * s, 2.0 * p + v);
        [left * left * line, left * (left * slope - 2.0 * line) / EASES]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All frames of a law from rest at zero.
    fn followed(rate: f64, frames: usize, law: impl Fn(usize, f64) -> (f64, bool)) -> Vec<[f64; 3]> {
        let mut follow = Follow::from(0.0, 0.0);
        (1..=frames)
            .map(|k| {
                let (law, is_another) = law(k, k as f64 / rate);
                let x = follow.step(1.0 / rate, law, is_another);
                [law, x, follow.moves()[0]]
            })
            .collect()
    }

    #[test]
    fn a_smooth_law_is_followed_to_the_bit() {
        for rate in [30.0, 60.0, 240.0, 1000.0] {
            let frames = followed(rate, 500, |_, t| (1.2 - 1.2 * (8.0 * t).cos(), false));
            assert!(frames.iter().all(|[law, x, _]| law.to_bits() == x.to_bits()), "{rate}");
        }
    }

    /// It arrives after its time, exactly, and never faster than by the fade's own speed: at most 1.5 of what is apart a time.
    #[test]
    fn another_law_is_come_to_without_a_jump() {
        for (rate, is_told) in [(30.0, true), (60.0, true), (60.0, false), (400.0, true), (400.0, false)] {
            let frames = followed(rate, rate as usize, |k, _| (1.5, k == 1 && is_told));
            let mut before = [0.0; 2];
            for (k, [_, x, v]) in frames.iter().enumerate() {
                assert!((x - before[0]).abs() < 1.6 * 1.5 / EASES / rate, "{rate} {k}");
                // The fade's acceleration: 6p/T².
                assert!((v - before[1]).abs() < 1.05 * 6.0 * 1.5 / (EASES * EASES) / rate, "{rate} {k}: {v}");
                before = [*x, *v];
            }
            let arrived = (EASES * rate).ceil() as usize + 1;
            assert!(frames[arrived..].iter().all(|[law, x, _]| law.to_bits() == x.to_bits()), "{rate}");
        }
    }

    /// Whatever a law does, what follows it moves on without a jump and comes to it.
    #[test]
    fn a_law_that_leaps_about_is_followed_smoothly() {
        let rate = 60.0;
        let law = |k: usize| if k < 300 { ((k / 7 * 31) % 11) as f64 * 0.2 - 1.0 } else { 0.4 };
        let frames = followed(rate, 400, |k, _| (law(k), false));
        let mut last = [0.0; 2];
        for [_, x, v] in &frames {
            let change = (v - last[1]).abs() * rate;
            assert!(change < 500.0 && (x - last[0]).abs() < 0.4, "{change} {x}");
            last = [*x, *v];
        }
        assert!((frames[399][1] - 0.4).abs() < 1e-15 && frames.iter().all(|[_, x, _]| x.abs() < 2.0));
    }

    /// Frames of next to nothing, too, leave numbers.
    #[test]
    fn frames_of_next_to_nothing_are_frames() {
        let mut follow = Follow::from(0.3, -2.0);
        for (k, dt) in [1e-300, 0.02, 1e-12, 0.25, f64::MIN_POSITIVE, 0.01].into_iter().enumerate() {
            let x = follow.step(dt, if k % 2 == 0 { 1.0 } else { -1.0 }, k == 3);
            assert!(x.abs() < 3.0 && follow.moves().iter().all(|x| x.is_finite()), "{k}: {x} {follow:?}");
        }
    }

    /// Rates are those of the places, by differences.
    #[test]
    fn rates_are_those_of_the_places() {
        let rate = 2000.0;
        let frames = followed(rate, 1500, |_, t| if t < 0.2 { (t * t, false) } else { (1.0, t < 0.2006) });
        for pair in frames.windows(2) {
            let mean = (pair[1][1] - pair[0][1]) * rate;
            assert!((mean - 0.5 * (pair[0][2] + pair[1][2])).abs() < 0.08, "{mean} {pair:?}");
        }
    }
}
