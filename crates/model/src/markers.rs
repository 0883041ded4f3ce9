//! Markers: points on a figure, and where a camera saw them.

use crate::figure::Figure;
use crate::joint::Placement;
use crate::link::NamedFrame;
use nalgebra::{UnitQuaternion, Vector3};
use std::collections::HashSet;

/// A point of a figure that cameras follow.
#[derive(Clone, Debug, PartialEq)]
pub struct Marker {
    /// Its name, by which it is found in a trial.
    pub name: String,
    /// Index of its link.
    pub link: usize,
    /// Where it sits, in the link's frame (m).
    pub position: Vector3<f64>,
    /// Whether its place is known (on a bone that can be felt, say), so that a static trial does not move it.
    pub is_fixed: bool,
}

impl Figure {
    /// The figure with its markers as named frames, along the axes of their links; a frame that had a marker's name before is
    /// gone.
    ///
    /// # Panics
    ///
    /// For a marker on a link that the figure does not have.
    #[must_use]
    pub fn with_markers(&self, markers: &[Marker]) -> Self {
        let mut figure = self.clone();
        for Marker { name, link, position, .. } in markers {
            for other in &mut figure.links {
                other.frames.retain(|frame| frame.name != *name);
            }
            let placement = Placement::from_parts((*position).into(), UnitQuaternion::identity());
            figure.links[*link].frames.push(NamedFrame { name: name.clone(), placement });
        }
        figure
    }
}

/// Where points were seen: a name a marker, a time a frame, and a place for each of both unless it was hidden.
///
/// ```
/// use solaris_model::{MarkerTrial, Vector3};
/// let hidden = Vector3::repeat(f64::NAN);
/// let trial = MarkerTrial::new(
///     vec!["heel".into(), "toe".into()],
///     vec![0.0, 0.01],
///     vec![Vector3::new(0.1, 0.0, 0.0), hidden, Vector3::new(0.2, 0.0, 0.0), Vector3::new(0.4, 0.0, 0.0)],
/// )?;
/// assert_eq!(trial.point(0, 1), None);
/// assert_eq!(trial.point(1, 1), Some(Vector3::new(0.4, 0.0, 0.0)));
/// assert_eq!(trial.seen(1), 1);
/// # Ok::<(), solaris_model::MarkerTrialError>(())
/// ```
#[doc(alias = "trc")]
#[doc(alias = "c3d")]
#[doc(alias = "trajectories")]
#[derive(Clone, Debug)]
pub struct MarkerTrial {
    names: Vec<String>,
    time: Vec<f64>,
    points: Vec<Vector3<f64>>,
}

/// Why names, times and points are no trial.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MarkerTrialError {
    /// Two markers of one name.
    #[error("two markers are called '{name}'; rename one of them")]
    Twice {
        /// The name.
        name: String,
    },
    /// Times that do not grow.
    #[error("the time {after} s of frame {frame} does not come after {before} s; sort the frames by time")]
    Time {
        /// The frame, from 1.
        frame: usize,
        /// Its time.
        after: f64,
        /// The time of the frame before it.
        before: f64,
    },
    /// A time that is no number.
    #[error("the time of frame {frame} is {time}, which is no time")]
    NotATime {
        /// The frame, from 1.
        frame: usize,
        /// What its time is.
        time: f64,
    },
    /// Not one point for each marker and frame.
    #[error(
        "there are {points} points for {markers} markers in {frames} frames; each marker needs one in each frame"
    )]
    Count {
        /// How many points there are.
        points: usize,
        /// How many markers.
        markers: usize,
        /// How many frames.
        frames: usize,
    },
}

impl MarkerTrial {
    /// The trial of markers called `names`, seen at `time` (s) at `points` (m, world axes): frame after frame, in each all
    /// markers in the order of their names. A point that has a coordinate which is not finite was not seen.
    ///
    /// # Errors
    ///
    /// [`MarkerTrialError`] for names that are there twice, times that do not grow, and another number of points.
    pub fn new(
        names: Vec<String>,
        time: Vec<f64>,
        mut points: Vec<Vector3<f64>>,
    ) -> Result<Self, MarkerTrialError> {
        let mut known = HashSet::new();
        if let Some(name) = names.iter().find(|name| !known.insert(name.as_str())) {
            return Err(MarkerTrialError::Twice { name: name.clone() });
        }
        if let Some(bad) = time.iter().position(|time| !time.is_finite()) {
            return Err(MarkerTrialError::NotATime { frame: bad + 1, time: time[bad] });
        }
        if let Some(bad) = time.windows(2).position(|pair| pair[1] <= pair[0]) {
            let (before, after) = (time[bad], time[bad + 1]);
            return Err(MarkerTrialError::Time { frame: bad + 2, after, before });
        }
        let (markers, frames) = (names.len(), time.len());
        if points.len() != markers * frames {
            return Err(MarkerTrialError::Count { points: points.len(), markers, frames });
        }
        for point in &mut points {
            if !point.iter().all(|x| x.is_finite()) {
                *point = Vector3::repeat(f64::NAN);
            }
        }
        Ok(Self { names, time, points })
    }

    /// The markers' names.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The frames' times (s).
    pub fn time(&self) -> &[f64] {
        &self.time
    }

    /// How many frames there are.
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Whether there is no frame.
    pub fn is_empty(&self) -> bool {
        self.time.is_empty()
    }

    /// Index of the marker called `name`.
    pub fn marker(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|known| known == name)
    }

    /// Where the markers of a frame were seen (m, world axes), in the order of their names; NaN where one was not.
    ///
    /// # Panics
    ///
    /// Where there is no such frame.
    pub fn frame(&self, frame: usize) -> &[Vector3<f64>] {
        &self.points[frame * self.names.len()..][..self.names.len()]
    }

    /// Where a marker was seen in a frame (m, world axes), if it was.
    ///
    /// # Panics
    ///
    /// Where there is no such frame or marker.
    pub fn point(&self, frame: usize, marker: usize) -> Option<Vector3<f64>> {
        Some(self.frame(frame)[marker]).filter(|point| !point.x.is_nan())
    }

    /// In how many frames a marker was seen.
    ///
    /// # Panics
    ///
    /// Where there are frames and no such marker.
    pub fn seen(&self, marker: usize) -> usize {
        (0..self.len()).filter(|frame| self.point(*frame, marker).is_some()).count()
    }

    /// Frames a second (Hz); `None` of fewer than two frames.
    pub fn rate(&self) -> Option<f64> {
        let (first, last) = (self.time.first()?, self.time.last()?);
        (self.len() > 1).then(|| (self.len() - 1) as f64 / (last - first))
    }

    /// Gives each of two markers the other's places in these frames.
    ///
    /// # Panics
    ///
    /// Where there are no such markers or frames.
    pub fn exchange(&mut self, [a, b]: [usize; 2], frames: std::ops::RangeInclusive<usize>) {
        let width = self.names.len();
        for frame in frames {
            self.points.swap(frame * width + a, frame * width + b);
        }
    }

    /// The frames between two times: from the last one that is not after `start` to the first one that is not before `end`, as
    /// OpenSim chooses them; of what is before or after the trial, its first or last frame.
    #[must_use]
    pub fn within(&self, start: f64, end: f64) -> Self {
        let last = self.len().saturating_sub(1);
        let first = self.time.iter().rposition(|time| *time <= start).unwrap_or(0);
        let until = self.time.iter().position(|time| *time >= end).unwrap_or(last).max(first);
        let width = self.names.len();
        Self {
            names: self.names.clone(),
            time: self.time.get(first..=until).map_or_else(Vec::new, <[f64]>::to_vec),
            points: self.points.get(first * width..(until + 1) * width).map_or_else(Vec::new, <[_]>::to_vec),
        }
    }

    /// The trial's mean as one frame, at its first time: of each marker the mean of where it was seen.
    #[must_use]
    pub fn mean(&self) -> Self {
        let point = |marker: usize| {
            let seen = (0..self.len()).filter_map(|frame| self.point(frame, marker));
            let (sum, count) = seen.fold((Vector3::zeros(), 0_usize), |(sum, n), point| (sum + point, n + 1));
            sum / count as f64
        };
        let time: Vec<f64> = self.time.first().copied().into_iter().collect();
        let points = time.iter().flat_map(|_| (0..self.names.len()).map(point)).collect();
        Self { names: self.names.clone(), time, points }
    }

    /// The same trial with every point moved by `map`: into other axes, say, or other units.
    #[must_use]
    pub fn mapped(mut self, map: impl Fn(&Vector3<f64>) -> Vector3<f64>) -> Self {
        for point in self.points.iter_mut().filter(|point| !point.x.is_nan()) {
            *point = map(point);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn what_is_no_trial_is_refused() {
        let origin = Vector3::zeros;
        let two = || vec!["a".to_owned(), "b".to_owned()];
        let said = |names, time, points| MarkerTrial::new(names, time, points).unwrap_err().to_string();
        assert!(said(vec!["a".into(), "a".into()], vec![], vec![]).contains("two markers are called 'a'"));
        assert!(said(two(), vec![0.0, 0.0], vec![origin(); 4]).contains("of frame 2"));
        assert!(said(two(), vec![f64::NAN], vec![origin(); 2]).contains("is NaN"));
        assert!(said(two(), vec![0.0], vec![origin(); 3]).contains("3 points for 2 markers in 1 frames"));
    }

    #[test]
    fn a_part_and_its_mean_leave_out_what_was_hidden() {
        let hidden = Vector3::repeat(f64::NAN);
        let points = vec![Vector3::x(), hidden, Vector3::x() * 3.0, hidden, Vector3::y(), hidden];
        let trial = MarkerTrial::new(vec!["a".into(), "b".into()], vec![0.0, 0.1, 0.2], points).unwrap();
        assert_eq!(trial.within(0.05, 0.06).time(), [0.0, 0.1]);
        assert_eq!(trial.within(-1.0, 9.0).len(), 3);
        assert_eq!(trial.within(0.1, 0.1).time(), [0.1]);
        let mean = trial.within(0.0, 0.1).mean();
        assert_eq!(
            (mean.time(), mean.point(0, 0), mean.point(0, 1)),
            (&[0.0][..], Some(Vector3::x() * 2.0), None)
        );
        let none = MarkerTrial::new(vec!["a".into()], vec![], vec![]).unwrap();
        assert!(none.within(0.0, 1.0).is_empty() && none.mean().is_empty());
    }

    #[test]
    fn a_point_that_is_known_in_part_was_not_seen() {
        let half = Vector3::new(1.0, f64::INFINITY, 0.0);
        let trial = MarkerTrial::new(vec!["a".into()], vec![0.0, 0.5], vec![half, Vector3::x()]).unwrap();
        assert_eq!((trial.point(0, 0), trial.seen(0), trial.rate()), (None, 1, Some(2.0)));
        let mut both =
            MarkerTrial::new(vec!["a".into(), "b".into()], vec![0.0], vec![Vector3::x(), Vector3::y()])
                .unwrap();
        both.exchange([0, 1], 0..=0);
        assert_eq!(both.point(0, 0), Some(Vector3::y()));
        let moved = trial.mapped(|point| point * 1e-3);
        assert_eq!((moved.point(0, 0), moved.point(1, 0).unwrap().x), (None, 1e-3));
    }
}
