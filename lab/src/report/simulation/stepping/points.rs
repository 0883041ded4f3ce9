//! Settings of a method, each with its time and its error, and the time that an error takes.

/// A method at its settings.
pub(super) struct Series {
    pub(super) name: &'static str,
    /// Whose it is.
    pub(super) is_ours: bool,
    /// The coarsest first.
    pub(super) points: Vec<Point>,
}

/// A setting and what came of it.
pub(super) struct Point {
    pub(super) setting: String,
    /// Steps; none where a method chooses them.
    pub(super) count: f64,
    pub(super) seconds: f64,
    /// Of positions (rad or m), and of velocities (rad/s or m/s), at the end.
    pub(super) error: [f64; 2],
}

/// Positions and velocities at the end of a motion.
pub(super) type End = (Vec<f64>, Vec<f64>);

/// The greatest difference of a position, and of a velocity.
pub(super) fn distance(one: &End, other: &End) -> [f64; 2] {
    let greatest = |one: &[f64], other: &[f64]| {
        let apart = one.iter().zip(other).map(|(a, b)| (a - b).abs());
        apart.fold(0.0, |most, x| if x.is_nan() { f64::INFINITY } else { x.max(most) })
    };
    [greatest(&one.0, &other.0), greatest(&one.1, &other.1)]
}

/// The least time (s) in which a series comes to an error of positions (0) or velocities (1), along straight lines between its settings on
/// logarithmic axes; none where it does not.
pub(super) fn time(series: &Series, error: f64, of: usize) -> Option<f64> {
    let points: Vec<(f64, f64)> =
        series.points.iter().map(|point| (point.seconds, point.error[of])).collect();
    let met = points.iter().filter(|point| point.1 <= error).map(|point| point.0);
    let between =
        points.windows(2).filter(|ends| ends[0].1 > error && ends[1].1 <= error && ends[0].1.is_finite());
    let crossed = between.map(|ends| {
        let [(slow, small), (fast, large)] =
            [ends[1], ends[0]].map(|(time, error)| (time.ln(), error.max(1e-16).ln()));
        (fast + (slow - fast) * (large - error.ln()) / (large - small)).exp()
    });
    met.chain(crossed).min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_lie_on_lines_between_settings() {
        let point = |seconds: f64, error: f64| Point {
            setting: String::new(),
            count: 0.0,
            seconds,
            error: [error; 2],
        };
        let points = vec![point(1.0, f64::INFINITY), point(2.0, 1e-2), point(4.0, 1e-6), point(8.0, 3e-6)];
        let series = Series { name: "", is_ours: true, points };
        let at = |error: f64| time(&series, error, 0);
        assert_eq!(at(1.0), Some(2.0));
        assert!(at(1e-4).is_some_and(|time| (time - 8.0_f64.sqrt()).abs() < 1e-12));
        assert_eq!(at(1e-7), None);
    }
}
