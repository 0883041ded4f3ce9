//! The clock of a walk whose pace changes, and its time.
//!
//! The clock `u` counts strides: contact k is at `k/2` whatever the pace. Time is `τ`, in strides of the fastest pace:
//!
//! ```text
//! dτ/du = r_{k−1} + (r_k − r_{k−1})·S9(2u − k + 1)   in step k      r_k = stride time of contact k's pace over the shortest one
//! ```
//!
//! so that a step in which nothing changes lasts half its stride, and one in which the pace changes the mean of both. A step that lasts
//! longer for itself, by the part `e` of that, has besides
//!
//! ```text
//! e·(r_{k−1} + r_k)/2·B11(2u − k + 1)      B11 = 2772 t⁵(1 − t)⁵, whose integral is 1
//! ```
//!
//! What is
//! prescribed over the clock keeps four derivatives in time, as the splines over the nodes have them: with two, the rates of a
//! leg would jump by 3 % where they meet.

/// `S9 = 126t⁵ − 420t⁶ + 540t⁷ − 315t⁸ + 70t⁹` on [0, 1]: from 0 to 1 with four derivatives zero at both ends.
pub(super) fn smooth_step(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t.powi(5) * (126.0 + t * (-420.0 + t * (540.0 + t * (-315.0 + 70.0 * t))))
}

/// Clock and time of a walk.
#[derive(Clone, Debug)]
pub(super) struct Tempo {
    /// Relative stride times of the contacts, from the standing feet to the last step; none where all are 1.
    ratios: Vec<f64>,
    /// What each step lasts longer for itself, as a rate.
    longer: Vec<f64>,
    /// Times of the contacts.
    contacts: Vec<f64>,
}

impl Tempo {
    /// For the stride times of contacts 0 … n over the shortest of them, and by which parts the n steps between last longer for themselves.
    #[expect(clippy::float_cmp, reason = "a stride time over itself is 1")]
    pub(super) fn new(ratios: Vec<f64>, longer: impl Iterator<Item = f64>) -> Self {
        let longer: Vec<f64> =
            longer.zip(ratios.windows(2)).map(|(part, pair)| 0.5 * part * (pair[0] + pair[1])).collect();
        if ratios.iter().all(|&ratio| ratio == 1.0) && longer.iter().all(|&rate| rate == 0.0) {
            return Self { ratios: Vec::new(), longer: Vec::new(), contacts: Vec::new() };
        }
        let mut contacts = vec![0.0];
        for (pair, longer) in ratios.windows(2).zip(&longer) {
            contacts.push(contacts[contacts.len() - 1] + 0.25 * (pair[0] + pair[1]) + 0.5 * longer);
        }
        Self { ratios, longer, contacts }
    }

    /// The time at a clock.
    pub(super) fn time(&self, u: f64) -> f64 {
        let Some(last) = self.ratios.len().checked_sub(1) else { return u };
        let x = 2.0 * u;
        if x <= 0.0 {
            return self.ratios[0] * u;
        }
        let k = x as usize;
        if k >= last {
            return self.contacts[last] + self.ratios[last] * 0.5 * (x - last as f64);
        }
        self.contacts[k] + self.within(k, x - k as f64).0
    }

    /// The clock at a time.
    pub(super) fn clock(&self, time: f64) -> f64 {
        let Some(last) = self.ratios.len().checked_sub(1) else { return time };
        if time <= 0.0 {
            return time / self.ratios[0];
        }
        if time >= self.contacts[last] {
            return 0.5 * last as f64 + (time - self.contacts[last]) / self.ratios[last];
        }
        let k = self.contacts.partition_point(|&contact| contact <= time).saturating_sub(1);
        let wanted = time - self.contacts[k];
        // Newton's method: time rises everywhere, and nearly straight.
        let mut x = (wanted / (self.contacts[k + 1] - self.contacts[k])).clamp(0.0, 1.0);
        for _ in 0..20 {
            let (reached, rate) = self.within(k, x);
            let change = (wanted - reached) / rate;
            x = (x + change).clamp(0.0, 1.0);
            if change.abs() < 1e-15 {
                break;
            }
        }
        0.5 * (k as f64 + x)
    }

    /// Time since contact `k` after the part `x` of the step, and its derivative by `x`.
    fn within(&self, k: usize, x: f64) -> (f64, f64) {
        let (from, change) = (self.ratios[k], self.ratios[k + 1] - self.ratios[k]);
        // ∫ S9 = x⁶ (21 − 60x + 135x²/2 − 35x³ + 7x⁴)
        let risen = x.powi(6) * (21.0 + x * (-60.0 + x * (67.5 + x * (-35.0 + 7.0 * x))));
        // ∫ B11 = 2772 x⁶ (1/6 − 5x/7 + 5x²/4 − 10x³/9 + x⁴/2 − x⁵/11)
        let passed =
            x.powi(6) * (462.0 + x * (-1980.0 + x * (3465.0 + x * (-3080.0 + x * (1386.0 - 252.0 * x)))));
        let own = 2772.0 * (x * (1.0 - x)).powi(5);
        let longer = self.longer[k];
        (
            0.5 * (from * x + change * risen + longer * passed),
            0.5 * (from + change * smooth_step(x) + longer * own),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clock_and_time_are_each_others_inverse() {
        let tempo = Tempo::new(vec![1.3, 1.3, 1.0, 1.9, 1.9], [0.0, 0.0, 0.0, 0.06].into_iter());
        let mut before = f64::NEG_INFINITY;
        for i in -40..140 {
            let u = 0.025 * f64::from(i);
            let time = tempo.time(u);
            assert!(time > before && (tempo.clock(time) - u).abs() < 1e-14 * 4.0, "{u}");
            before = time;
        }
        // A step lasts half a stride, or the mean.
        assert!((tempo.time(0.5) - 0.65).abs() < 1e-15);
        assert!((tempo.time(1.0) - 0.65 - 0.575).abs() < 1e-15);
        // And longer by its own part.
        assert!((tempo.time(2.0) - tempo.time(1.5) - 0.95 * 1.06).abs() < 1e-14);
        let rate = |u: f64| (tempo.time(u + 1e-6) - tempo.time(u - 1e-6)) / 2e-6;
        assert!((rate(1.75) - 1.9 * (1.0 + 0.06 * 2772.0 / 1024.0)).abs() < 1e-8);
    }

    #[test]
    fn an_even_pace_is_the_clock_itself() {
        let tempo = Tempo::new(vec![1.0; 7], std::iter::repeat_n(0.0, 6));
        for u in [-0.75, 0.1, 1.0 / 3.0, 17.3] {
            assert!(tempo.time(u).to_bits() == u.to_bits() && tempo.clock(u).to_bits() == u.to_bits());
        }
    }
}
