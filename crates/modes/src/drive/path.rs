//! The prescribed motion of one degree of freedom, in the time of the run.

use super::Shape;
use crate::recorded::RecordedMotion;
use solaris_profiles::{
    Answers, Boundary, Clip, CubicHermite, Curve, Profile, ProfileError, Quantity, Quintic, Sample,
};
use std::sync::Arc;

/// A curve of a known beginning.
pub(crate) type CurveClip = Clip<Arc<dyn Curve + Send + Sync>>;

/// The prescribed motion of one degree of freedom.
#[derive(Clone)]
pub(crate) enum Path {
    /// It stands at a position.
    Still(f64),
    /// Along a curve that begins at a time of the run; at its ends it holds.
    Along(CurveClip),
    /// The same with the times of the run, inside of the curve, at which its acceleration jumps.
    Pieces { clip: CurveClip, inner: Arc<[f64]> },
    /// As in a record; the degree of freedom by its index in `v` and in `q`.
    Recorded { recorded: Arc<RecordedMotion>, dof: usize, coordinate: usize },
    /// A path over a stretch without breaks inside: at its ends what holds inside of it.
    During { path: Box<Path>, from: f64, to: f64 },
}

impl Path {
    /// Along a profile that begins at a time of the run.
    pub(crate) fn profile(profile: &Profile, start: f64) -> Result<Self, ProfileError> {
        let curve = profile.curve::<f64>()?;
        let all = [Quantity::Position, Quantity::Velocity, Quantity::Acceleration];
        let mut inner: Vec<f64> = all.into_iter().flat_map(|quantity| curve.critical(quantity)).collect();
        inner.retain(|&t| t > 0.0 && t < curve.duration() && jumps(&curve.before(t), &curve.at(t)));
        inner.sort_by(f64::total_cmp);
        inner.dedup();
        Self::pieces(curve, start, inner)
    }

    /// The path of [`Drive::Move`](super::Drive::Move) from a position with a velocity.
    pub(crate) fn moving(
        along: Shape,
        over: f64,
        (position, velocity): (f64, f64),
        to: f64,
        start: f64,
    ) -> Result<Self, ProfileError> {
        match along {
            Shape::MinimumJerk => {
                let begin = Boundary::new(position, velocity, 0.0);
                Self::pieces(Quintic::new(over, begin, Boundary::rest(to))?, start, Vec::new())
            }
            Shape::Cubic => {
                let curve = CubicHermite::new(over, (position, velocity), (to, 0.0))?;
                Self::pieces(curve, start, Vec::new())
            }
        }
    }

    /// A curve that begins at a time of the run, and the times since then at which its acceleration jumps.
    pub(crate) fn pieces(
        curve: impl Curve + Send + Sync + 'static,
        start: f64,
        inner: Vec<f64>,
    ) -> Result<Self, ProfileError> {
        let curve: Arc<dyn Curve + Send + Sync> = Arc::new(curve);
        let clip = Clip::new(curve).starting(start)?;
        let inner: Vec<f64> = inner.into_iter().map(|t| start + t).collect();
        Ok(if inner.is_empty() { Self::Along(clip) } else { Self::Pieces { clip, inner: inner.into() } })
    }

    /// Position, velocity, acceleration (the jerk is not used) at a time of the run.
    ///
    /// At a break, and within rounding of it, what holds inside of the curve, and inside of it what holds after the break;
    /// see [`during`](Self::during).
    pub(crate) fn at(&self, time: f64) -> Sample {
        match self {
            Self::Still(position) => Sample::rest(*position),
            Self::Along(clip) | Self::Pieces { clip, .. } => clip.at(onto_ends(clip, time)),
            Self::Recorded { recorded, dof, coordinate } => recorded.at(*dof, *coordinate, time),
            Self::During { path, from, to } => {
                if time <= *from {
                    path.after(*from)
                } else if time >= *to {
                    path.before(*to)
                } else {
                    path.at(time)
                }
            }
        }
    }

    /// The path over the stretch between two times, none of its [`breaks`](Self::breaks) inside: at the ends, where
    /// something may jump, it has what holds inside of the stretch. A rule that looks at both ends of its steps needs this to
    /// keep its order.
    pub(crate) fn during(&self, from: f64, to: f64) -> Self {
        let path = match self {
            Self::During { path, .. } => path.clone(),
            path => Box::new(path.clone()),
        };
        Self::During { path, from, to }
    }

    /// When its curve ends (s); one that stands still has no end.
    pub(crate) fn end(&self) -> f64 {
        self.breaks().last().copied().unwrap_or(f64::INFINITY)
    }

    /// The times of the run, rising, at which position, velocity or acceleration may jump.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Still(_) => Vec::new(),
            Self::Along(clip) => vec![clip.start(), clip.end()],
            Self::Pieces { clip, inner } => {
                [clip.start()].into_iter().chain(inner.iter().copied()).chain([clip.end()]).collect()
            }
            Self::Recorded { recorded, .. } => {
                let (first, last) = recorded.span();
                if first < last { vec![first, last] } else { vec![first] }
            }
            Self::During { path, from, to } => {
                path.breaks().into_iter().filter(|t| (*from..=*to).contains(t)).collect()
            }
        }
    }

    /// The first time of the run, after another, at which a record goes on by its next piece: only the jerk jumps there, so that it is
    /// no break.
    pub(crate) fn smooth_until(&self, time: f64) -> f64 {
        match self {
            Self::Recorded { recorded, .. } => recorded.next_sample(time),
            Self::During { path, .. } => path.smooth_until(time),
            _ => f64::INFINITY,
        }
    }

    /// What holds just after a time.
    fn after(&self, time: f64) -> Sample {
        match self {
            // At its end a curve holds.
            Self::Along(clip) | Self::Pieces { clip, .. } if onto_ends(clip, time) >= last_of(clip) => {
                Sample::rest(clip.at(last_of(clip)).position)
            }
            Self::Recorded { recorded, dof, coordinate } if time >= recorded.span().1 => {
                Sample::rest(recorded.at(*dof, *coordinate, recorded.span().1).position)
            }
            path => path.at(time),
        }
    }

    /// What holds just before a time.
    fn before(&self, time: f64) -> Sample {
        match self {
            Self::Along(clip) | Self::Pieces { clip, .. } => {
                let t = onto_ends(clip, time) - clip.start();
                if t <= 0.0 {
                    Sample::rest(clip.at(clip.start()).position)
                } else if t <= clip.curve().span() {
                    clip.curve().before(t)
                } else {
                    clip.at(time)
                }
            }
            Self::Recorded { recorded, dof, coordinate } if time <= recorded.span().0 => {
                Sample::rest(recorded.at(*dof, *coordinate, time).position)
            }
            path => path.at(time),
        }
    }
}

/// A time that is an end of the clip but for rounding is that end.
fn onto_ends(clip: &CurveClip, time: f64) -> f64 {
    let rounding = 4.0 * f64::EPSILON * (time.abs() + clip.start().abs());
    let end = last_of(clip);
    if (time - end).abs() <= rounding {
        end
    } else if (time - clip.start()).abs() <= rounding {
        clip.start()
    } else {
        time
    }
}

/// The last time that the clip takes as one of its curve.
fn last_of(clip: &CurveClip) -> f64 {
    last_within(clip.start(), clip.curve().span())
}

/// The time `start + duration`, such that it is not later than `duration` after `start` for rounding.
pub(crate) fn last_within(start: f64, duration: f64) -> f64 {
    let mut end = start + duration;
    while end - start > duration {
        end = end.next_down();
    }
    end
}

/// Whether position, velocity or acceleration differ by more than rounding.
fn jumps(before: &Sample, after: &Sample) -> bool {
    let differ = |x: f64, y: f64| (x - y).abs() > 1e-9 * (1.0 + x.abs() + y.abs());
    differ(before.position, after.position)
        || differ(before.velocity, after.velocity)
        || differ(before.acceleration, after.acceleration)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    #[test]
    fn a_trapezoid_breaks_where_its_phases_meet() {
        // 1 m at most 1 m/s with 2 m/s²: rises for 0.5 s, cruises for 0.5 s, falls for 0.5 s.
        let profile =
            Profile::Trapezoidal { from: 0.0, to: 1.0, largest_velocity: 1.0, largest_acceleration: 2.0 };
        let path = Path::profile(&profile, 0.25).expect("valid");
        let breaks = path.breaks();
        assert_eq!(breaks.len(), 4, "{breaks:?}");
        for (found, expected) in breaks.iter().zip([0.25, 0.75, 1.25, 1.75]) {
            assert_abs_diff_eq!(*found, expected, epsilon = 1e-15);
        }
        // A smooth curve has its ends alone.
        let smooth = Profile::MinimumJerk { from: 0.0, to: 1.0, duration: 2.0 };
        assert_eq!(Path::profile(&smooth, 0.25).expect("valid").breaks(), [0.25, 2.25]);
        assert!(Path::Still(1.0).breaks().is_empty());
    }

    #[test]
    fn splines_break_at_keys_where_the_acceleration_jumps() {
        let keys = vec![(0.0, 0.0), (1.0, 1.0), (2.0, 0.5), (3.0, 0.0)];
        let bent = Path::profile(&Profile::CatmullRom { keys: keys.clone() }, 0.0).expect("valid");
        assert_eq!(bent.breaks(), [0.0, 1.0, 2.0, 3.0]);
        let natural = Path::profile(&Profile::NaturalSpline { keys }, 0.0).expect("valid");
        assert_eq!(natural.breaks(), [0.0, 3.0]);
    }

    #[test]
    fn a_stretch_keeps_to_its_own_side_of_a_break() {
        let profile =
            Profile::Trapezoidal { from: 0.0, to: 1.0, largest_velocity: 1.0, largest_acceleration: 2.0 };
        let path = Path::profile(&profile, 0.0).expect("valid");
        let accelerations = |from: f64, to: f64| {
            let part = path.during(from, to);
            [part.at(from), part.at(0.5 * (from + to)), part.at(to)].map(|sample| sample.acceleration)
        };
        let expected =
            [(-1.0, 0.0, 0.0), (0.0, 0.5, 2.0), (0.5, 1.0, 0.0), (1.0, 1.5, -2.0), (1.5, 2.0, 0.0)];
        for (from, to, acceleration) in expected {
            for found in accelerations(from, to) {
                assert_abs_diff_eq!(found, acceleration, epsilon = 1e-14);
            }
        }
        assert_eq!(path.during(0.0, 0.5).during(0.5, 1.0).breaks(), [0.5, 1.0]);
    }

    #[test]
    fn rounding_does_not_take_a_time_off_the_end_of_a_curve() {
        // θ̇ is 1 at the end; just beyond it the curve would hold, at rest.
        for start in [0.1, 0.3, 1.7, 123.4] {
            for duration in [0.1, 0.7, 1.1, 3.3] {
                let line = Profile::Line { from: 0.0, to: duration, duration };
                let path = Path::profile(&line, start).expect("valid");
                for time in [start, start + duration, *path.breaks().last().expect("has an end")] {
                    assert_abs_diff_eq!(path.at(time).velocity, 1.0, epsilon = 1e-14);
                }
                assert_abs_diff_eq!(path.at(start + duration + 1e-9).velocity, 0.0, epsilon = 0.0);
                let end = start + duration;
                assert_abs_diff_eq!(path.during(start, end).at(end).velocity, 1.0, epsilon = 1e-14);
                assert_abs_diff_eq!(path.during(end, end + 1.0).at(end).velocity, 0.0, epsilon = 0.0);
                assert_abs_diff_eq!(path.during(end, end + 1.0).at(end).position, duration, epsilon = 1e-13);
            }
        }
    }

    #[test]
    fn a_move_begins_as_it_is_and_ends_at_rest() {
        for shape in [Shape::MinimumJerk, Shape::Cubic] {
            let path = Path::moving(shape, 0.5, (0.2, -1.0), 0.9, 3.0).expect("valid");
            assert_abs_diff_eq!(path.at(3.0).position, 0.2, epsilon = 1e-15);
            assert_abs_diff_eq!(path.at(3.0).velocity, -1.0, epsilon = 1e-14);
            assert_abs_diff_eq!(path.at(3.5).position, 0.9, epsilon = 1e-15);
            assert_abs_diff_eq!(path.at(3.5).velocity, 0.0, epsilon = 1e-14);
        }
    }
}
