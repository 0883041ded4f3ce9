//! One stride among the samples of a motion, and how it is chosen.

/// Samples of one stride.
pub(crate) struct Window<'a> {
    /// Times of all samples (s).
    pub(crate) time: &'a [f64],
    /// From when to when the stride lasts (s).
    pub(crate) span: (f64, f64),
}

impl Window<'_> {
    /// The greatest value at the samples in a part of the stride; −∞ where there are none.
    pub(crate) fn most(&self, (from, to): (f64, f64), f: &dyn Fn(usize) -> f64) -> f64 {
        let (start, end) = self.span;
        let inside = |i: &usize| {
            let u = (self.time[*i] - start) / (end - start);
            u >= from && u <= to
        };
        (0..self.time.len()).filter(inside).map(f).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The least value there; ∞ where there are none.
    pub(crate) fn least(&self, part: (f64, f64), f: &dyn Fn(usize) -> f64) -> f64 {
        -self.most(part, &|i| -f(i))
    }

    /// The range of the values over the whole stride.
    pub(crate) fn range(&self, f: &dyn Fn(usize) -> f64) -> f64 {
        self.most((0.0, 1.0), f) - self.least((0.0, 1.0), f)
    }

    /// The value at a time, linear between samples.
    pub(crate) fn at(&self, time: f64, f: &dyn Fn(usize) -> f64) -> f64 {
        let times = self.time;
        let next = times.partition_point(|t| *t < time).clamp(1, times.len() - 1);
        let share = (time - times[next - 1]) / (times[next] - times[next - 1]);
        f(next - 1) + (f(next) - f(next - 1)) * share
    }

    /// The mean over the stride: trapezoids between the samples and its ends.
    pub(crate) fn mean(&self, f: &dyn Fn(usize) -> f64) -> f64 {
        let points = self.points(f);
        let area = points.windows(2).map(|p| (p[1].0 - p[0].0) * (p[0].1 + p[1].1) / 2.0).sum::<f64>();
        area / (self.span.1 - self.span.0)
    }

    /// The part of the stride in which the value is above a threshold, linear between samples. It is zero at the times at which it begins
    /// and ends: a line from the sample before a beginning would rise too early. Of these times only those count beside which a sample is zero.
    pub(crate) fn part_above(
        &self,
        threshold: f64,
        begins_and_ends: &[f64],
        f: &dyn Fn(usize) -> f64,
    ) -> f64 {
        let mut points = self.points(f);
        for &zero in begins_and_ends {
            let next = self.time.partition_point(|t| *t < zero).clamp(1, self.time.len() - 1);
            let rests = [next - 1, next].into_iter().any(|i| f(i).abs() <= f64::EPSILON * threshold);
            if !rests || zero < self.span.0 || zero > self.span.1 {
                continue;
            }
            let place = points.partition_point(|(time, _)| *time < zero);
            match points.get_mut(place) {
                Some(point) if point.0 <= zero => point.1 = 0.0,
                _ => points.insert(place, (zero, 0.0)),
            }
        }
        let above = points.windows(2).map(|p| {
            let (duration, [a, b]) = (p[1].0 - p[0].0, [p[0].1 - threshold, p[1].1 - threshold]);
            match (a > 0.0, b > 0.0) {
                (true, true) => duration,
                (false, false) => 0.0,
                _ => duration * a.max(b) / (a - b).abs(),
            }
        });
        above.sum::<f64>() / (self.span.1 - self.span.0)
    }

    /// Times and values at the stride's ends and the samples between them.
    fn points(&self, f: &dyn Fn(usize) -> f64) -> Vec<(f64, f64)> {
        let (start, end) = self.span;
        let inside = (0..self.time.len()).filter(|&i| self.time[i] > start && self.time[i] < end);
        let mut points = vec![(start, self.at(start, f))];
        points.extend(inside.map(|i| (self.time[i], f(i))));
        points.push((end, self.at(end, f)));
        points
    }
}

/// The samples from one time to another, ends included.
pub(crate) fn samples_between(time: &[f64], (from, to): (f64, f64)) -> std::ops::Range<usize> {
    let first = time.partition_point(|t| *t < from);
    first..time.partition_point(|t| *t <= to).max(first)
}

/// The contact, of those at which a stride begins, whose stride lies nearest to the middle of `count` contacts.
pub(crate) fn middle_stride(begins: impl Iterator<Item = usize>, count: usize) -> Option<usize> {
    let middle = count as f64 / 2.0 - 1.5;
    begins.min_by(|a, b| (*a as f64 - middle).abs().total_cmp(&(*b as f64 - middle).abs()))
}

/// Middle of a swing: the part in which the toes must pass over the ground.
const MID_SWING: (f64, f64) = (0.20, 0.60);

/// The samples in the middle of a swing from lift-off to contact (s).
pub(crate) fn mid_swing(time: &[f64], (lift, contact): (f64, f64)) -> std::ops::Range<usize> {
    let at = |share: f64| lift + share * (contact - lift);
    samples_between(time, (at(MID_SWING.0), at(MID_SWING.1)))
}
