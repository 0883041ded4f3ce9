//! Motions: what every planner hands on and every exporter reads.

mod sample;

pub use sample::{DifferenceStep, Trajectory};

use crate::configuration::rotation::read;
use crate::figure::Figure;
use crate::relief::Relief;
use nalgebra::Vector3;
use std::cmp::Ordering;
use std::ops::Range;

/// The ground: a horizontal plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Its height along the direction against gravity (m).
    pub height: f64,
    /// Coefficient of friction, if one is known.
    pub friction: Option<f64>,
}

/// An event, which happens at an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// When (s).
    pub time: f64,
    /// What.
    pub kind: EventKind,
}

/// The kind of an event.
#[doc(alias = "heel strike")]
#[doc(alias = "toe off")]
#[doc(alias = "gait event")]
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EventKind {
    /// A link meets the ground.
    TouchDown {
        /// The link's name.
        link: String,
    },
    /// A link leaves the ground.
    LiftOff {
        /// The link's name.
        link: String,
    },
    /// The figure is computed from another link outwards from here on.
    RootChange {
        /// The new root's name.
        link: String,
    },
    /// Something moves a joint in another way from here on.
    DriveChange {
        /// What changes.
        what: String,
    },
}

/// A time during which a point of a link is planted on the ground: it neither slides nor lifts.
#[doc(alias = "stance phase")]
#[doc(alias = "support phase")]
#[derive(Clone, Debug, PartialEq)]
pub struct Interval {
    /// Index of the link.
    pub link: usize,
    /// The planted point in the link's frame (m).
    pub point: Vector3<f64>,
    /// From when (s).
    pub start: f64,
    /// Until when (s).
    pub end: f64,
}

/// The contact of one link with the ground at one instant, as a wrench: world axes, moment about the world's origin.
#[doc(alias = "grf")]
#[doc(alias = "ground reaction force")]
#[doc(alias = "cop")]
#[doc(alias = "center of pressure")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Contact {
    /// Force on the link (N).
    pub force: Vector3<f64>,
    /// Moment on the link about the world's origin (N m).
    pub moment: Vector3<f64>,
    /// Centre of pressure (m): the point of the ground about which the moment is normal to it. Zero without force.
    pub cop: Vector3<f64>,
}

/// The contact of one link over the samples of a motion.
#[doc(alias = "grf")]
#[doc(alias = "force plate")]
#[derive(Clone, Debug, PartialEq)]
pub struct ContactTrack {
    /// Name of the link that the columns carry (`LINK.fx …`).
    pub link: String,
    /// One contact a sample.
    pub samples: Vec<Contact>,
}

/// The metadata of a motion: what holds for the whole of it.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionInfo {
    /// Fingerprint of the figure that moves, see [`Figure::fingerprint`].
    pub fingerprint: u64,
    /// Gravity (m/s²).
    pub gravity: Vector3<f64>,
    /// The ground, if there is one.
    pub ground: Option<Ground>,
    /// Samples a second (1/s).
    pub rate: f64,
}

impl MotionInfo {
    /// The most samples a second of a motion (1/s).
    pub const HIGHEST_RATE: f64 = 1e5;

    /// Standard gravity along −y and a ground at y = 0: the world of generated figures (x left, y up, z forward).
    pub fn on_earth(figure: &Figure, rate: f64) -> Self {
        Self {
            fingerprint: figure.fingerprint(),
            gravity: Vector3::new(0.0, -9.806_65, 0.0),
            ground: Some(Ground { height: 0.0, friction: None }),
            rate,
        }
    }

    /// What is known of a recorded motion without a ground: samples at these times (s) under `gravity` (m/s²). Its rate is the
    /// mean one, 1/s where the times tell none.
    pub fn recorded(figure: &Figure, gravity: Vector3<f64>, time: &[f64]) -> Self {
        let span = time.last().zip(time.first()).map_or(0.0, |(last, first)| last - first);
        let rate = (time.len() as f64 - 1.0) / span;
        let rate = if rate.is_finite() && rate > 0.0 { rate } else { 1.0 };
        Self { fingerprint: figure.fingerprint(), gravity, ground: None, rate }
    }

    pub(crate) fn check_figure(&self, figure: &Figure) -> Result<(), MotionError> {
        let (expected, found) = (self.fingerprint, figure.fingerprint());
        if expected == found {
            Ok(())
        } else {
            Err(MotionError::OtherFigure { figure: figure.name().to_owned(), expected, found })
        }
    }
}

/// A sampled motion of one figure: planned, simulated or recorded.
///
/// Positions are always known. Velocities and accelerations are where [`Motion::known`] says so, forces and contacts where a
/// layer has found them. Rows are samples; `q` has `nq` numbers a sample, `v`, `a` and `tau` have `nv`, in the order of the figure's
/// [`crate::StateLayout`] and always of the figure's declared root. `tau` is empty until a layer has found it.
#[doc(alias = "animation")]
#[doc(alias = "animation clip")]
#[doc(alias = "trajectory")]
#[doc(alias = "mot")]
#[doc(alias = "trc")]
#[doc(alias = "bvh")]
#[derive(Clone, Debug)]
pub struct Motion {
    /// What holds throughout.
    pub info: MotionInfo,
    /// Events in the order of time.
    pub events: Vec<Event>,
    /// When which point is planted.
    pub planted: Vec<Interval>,
    /// Contact wrenches by link; empty until a layer has found them.
    pub contacts: Vec<ContactTrack>,
    /// The ground's heights above y = 0, where it is not level.
    pub relief: Option<Relief>,
    nq: usize,
    nv: usize,
    time: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
    known: Known,
}

/// Of which degrees of freedom velocities and accelerations are known, `nv` each.
///
/// A planner knows all of them, a recorded table often none: whoever differentiates the positions makes them known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Known {
    /// Whether the velocities of a degree of freedom are known; they are zero where they are not.
    pub v: Vec<bool>,
    /// Whether its accelerations are; they are zero where they are not.
    pub a: Vec<bool>,
}

impl Known {
    /// Velocities and accelerations of all `nv` degrees of freedom.
    pub fn all(nv: usize) -> Self {
        Self { v: vec![true; nv], a: vec![true; nv] }
    }

    /// Of none of the `nv` degrees of freedom.
    pub fn none(nv: usize) -> Self {
        Self { v: vec![false; nv], a: vec![false; nv] }
    }

    /// Whether nothing is missing.
    pub fn is_all(&self) -> bool {
        self.v.iter().chain(&self.a).all(|known| *known)
    }
}

/// The error of a motion: why numbers are none of a figure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MotionError {
    /// The rate is not one.
    #[error("rate {rate} frames/s: it must be more than zero and at most 100000")]
    Rate {
        /// What was asked (1/s).
        rate: f64,
    },
    /// The duration is not one, or needs too many samples.
    #[error(
        "duration {duration} s at {rate} frames/s: it must be finite and need at most {} samples",
        Motion::MOST_SAMPLES
    )]
    Duration {
        /// What the trajectory says (s).
        duration: f64,
        /// Samples a second (1/s).
        rate: f64,
    },
    /// The times do not rise.
    #[error("sample {sample} is at {time} s; times must be finite and rise")]
    Time {
        /// Index of the sample.
        sample: usize,
        /// Its time (s).
        time: f64,
    },
    /// A column has the wrong length.
    #[error("{what} has {found} numbers; {samples} samples of {width} make {expected}", expected = .samples * .width)]
    Length {
        /// Which column.
        what: &'static str,
        /// Numbers that were given.
        found: usize,
        /// Number of samples.
        samples: usize,
        /// Numbers a sample.
        width: usize,
    },
    /// A number is not finite.
    #[error("{what} of '{dof}' at {time} s is {value}; it must be a finite number")]
    NotFinite {
        /// Which column.
        what: &'static str,
        /// Whose.
        dof: String,
        /// When (s).
        time: f64,
        /// The number.
        value: f64,
    },
    /// A quaternion does not have unit length.
    #[error(
        "the quaternion of joint '{joint}' at {time} s has the length {length}; it must be 1 to within {}: normalise it",
        Motion::UNIT_TOLERANCE
    )]
    Quaternion {
        /// The joint's name.
        joint: String,
        /// When (s).
        time: f64,
        /// Its length.
        length: f64,
    },
    /// The motion belongs to another figure.
    #[error(
        "the motion was made for a figure with fingerprint {expected:016x}, not for '{figure}' ({found:016x})"
    )]
    OtherFigure {
        /// Name of the figure at hand.
        figure: String,
        /// The motion's fingerprint.
        expected: u64,
        /// The figure's.
        found: u64,
    },
}

impl Motion {
    /// Version of this structure, written by exporters that keep all of it.
    pub const VERSION: u32 = 1;

    /// The most samples that a trajectory is turned into.
    pub const MOST_SAMPLES: usize = 100_000_000;

    /// How far from 1 the length of a quaternion may be: tables are often printed with few digits.
    pub const UNIT_TOLERANCE: f64 = 1e-3;

    /// A motion of which positions, velocities and accelerations are known, from its columns: `time` (s), `q` (`nq` a
    /// sample), `v` and `a` (`nv` a sample). Quaternions stay as they are.
    ///
    /// # Errors
    ///
    /// Columns of the wrong length, times that do not rise, numbers that are not finite, and quaternions whose length is not
    /// 1 to within [`Motion::UNIT_TOLERANCE`].
    pub fn new(
        figure: &Figure,
        info: MotionInfo,
        time: Vec<f64>,
        columns: [Vec<f64>; 3],
    ) -> Result<Self, MotionError> {
        if let Some(sample) = (1..time.len()).find(|&i| time[i] <= time[i - 1]) {
            return Err(MotionError::Time { sample, time: time[sample] });
        }
        Self::recorded(figure, info, time, columns, Known::all(figure.layout().nv()))
    }

    /// A motion of which velocities and accelerations may be missing: as [`Motion::new`], with what is `known` of them.
    ///
    /// The times of samples of which everything is known need not rise: they may be states that have nothing to do with each
    /// other.
    ///
    /// # Errors
    ///
    /// As [`Motion::new`].
    pub fn recorded(
        figure: &Figure,
        info: MotionInfo,
        time: Vec<f64>,
        [q, v, a]: [Vec<f64>; 3],
        known: Known,
    ) -> Result<Self, MotionError> {
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        for (what, flags) in [("known v", &known.v), ("known a", &known.a)] {
            if flags.len() != nv {
                return Err(MotionError::Length { what, found: flags.len(), samples: 1, width: nv });
            }
        }
        let may_jump = known.is_all();
        let bad = |i: &usize| !time[*i].is_finite() || (*i > 0 && !may_jump && time[*i] <= time[*i - 1]);
        if let Some(sample) = (0..time.len()).find(bad) {
            return Err(MotionError::Time { sample, time: time[sample] });
        }
        check_states(figure, &time, [&q, &v, &a])?;
        let (events, planted, contacts, tau) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        Ok(Self { info, events, planted, contacts, relief: None, nq, nv, time, q, v, a, tau, known })
    }

    /// Which velocities and accelerations are known.
    pub fn known(&self) -> &Known {
        &self.known
    }

    /// Replaces positions, velocities and accelerations of all samples, which are known then.
    ///
    /// # Errors
    ///
    /// A motion of another figure, columns of the wrong length, numbers that are not finite, quaternions that are none. The
    /// motion is then as it was.
    pub fn set_states(&mut self, figure: &Figure, [q, v, a]: [Vec<f64>; 3]) -> Result<(), MotionError> {
        self.check_figure(figure)?;
        check_states(figure, &self.time, [&q, &v, &a])?;
        self.known = Known::all(self.nv);
        (self.q, self.v, self.a) = (q, v, a);
        Ok(())
    }

    /// Gives the motion its generalized forces, `nv` a sample.
    ///
    /// # Errors
    ///
    /// A column of the wrong length, numbers that are not finite.
    pub fn set_tau(&mut self, tau: Vec<f64>) -> Result<(), MotionError> {
        self.check_column("tau", &tau)?;
        self.tau = tau;
        Ok(())
    }

    /// It without its last sample, forces and contacts as well: of a loop the first one again, which who plays frame after frame shall not see twice. Events and
    /// planted points stay; of one sample nothing is left.
    ///
    /// ```
    /// use solaris_model::{Motion, MotionInfo, human};
    /// let ann = human(1.65, 58.0)?;
    /// let still = |width: usize| vec![0.0; 2 * width];
    /// let (q, v) = (still(ann.layout().nq()), still(ann.layout().nv()));
    /// let stands = Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), vec![0.0, 0.1], [q, v.clone(), v])?;
    /// assert_eq!(stands.without_last().time(), [0.0]);
    /// assert_eq!(stands.without_last().without_last().len(), 0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn without_last(&self) -> Self {
        let mut shorter = self.clone();
        let samples = shorter.time.len().saturating_sub(1);
        shorter.time.truncate(samples);
        shorter.q.truncate(self.nq * samples);
        for column in [&mut shorter.v, &mut shorter.a, &mut shorter.tau] {
            column.truncate(self.nv * samples);
        }
        shorter.contacts.iter_mut().for_each(|track| track.samples.truncate(samples));
        shorter
    }

    /// Replaces the accelerations, `nv` a sample.
    ///
    /// # Errors
    ///
    /// A column of the wrong length, numbers that are not finite.
    pub fn set_a(&mut self, a: Vec<f64>) -> Result<(), MotionError> {
        self.check_column("a", &a)?;
        self.a = a;
        Ok(())
    }

    fn check_column(&self, what: &'static str, column: &[f64]) -> Result<(), MotionError> {
        if column.len() != self.len() * self.nv {
            let (samples, width) = (self.len(), self.nv);
            return Err(MotionError::Length { what, found: column.len(), samples, width });
        }
        match column.iter().position(|x| !x.is_finite()) {
            None => Ok(()),
            Some(i) => {
                let (dof, time, value) = (format!("dof {}", i % self.nv), self.time[i / self.nv], column[i]);
                Err(MotionError::NotFinite { what, dof, time, value })
            }
        }
    }

    /// Refuses a figure that the motion was not made for.
    ///
    /// # Errors
    ///
    /// [`MotionError::OtherFigure`] when the fingerprints differ.
    pub fn check_figure(&self, figure: &Figure) -> Result<(), MotionError> {
        self.info.check_figure(figure)
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.time.len()
    }

    /// Whether there are no samples.
    pub fn is_empty(&self) -> bool {
        self.time.is_empty()
    }

    /// Times of the samples (s).
    pub fn time(&self) -> &[f64] {
        &self.time
    }

    /// Positions at a sample, length `nq`.
    pub fn q(&self, sample: usize) -> &[f64] {
        &self.q[Self::row(sample, self.nq)]
    }

    /// Velocities at a sample, length `nv`.
    pub fn v(&self, sample: usize) -> &[f64] {
        &self.v[Self::row(sample, self.nv)]
    }

    /// Accelerations at a sample, length `nv`.
    pub fn a(&self, sample: usize) -> &[f64] {
        &self.a[Self::row(sample, self.nv)]
    }

    /// Positions, velocities and accelerations of all samples, one after the other: `nq`, `nv` and `nv` numbers a sample.
    pub fn columns(&self) -> [&[f64]; 3] {
        [&self.q, &self.v, &self.a]
    }

    /// Generalized forces at a sample, length `nv`; `None` where they were not asked for.
    pub fn tau(&self, sample: usize) -> Option<&[f64]> {
        (!self.tau.is_empty()).then(|| &self.tau[Self::row(sample, self.nv)])
    }

    /// Generalized forces of all samples, one after the other: `nv` numbers a sample; `None` where they were not asked for.
    pub fn taus(&self) -> Option<&[f64]> {
        (!self.tau.is_empty()).then_some(&*self.tau)
    }

    /// The contact track of the link called `link`.
    pub fn contact(&self, link: &str) -> Option<&ContactTrack> {
        self.contacts.iter().find(|track| track.link == link)
    }

    fn row(sample: usize, width: usize) -> Range<usize> {
        sample * width..(sample + 1) * width
    }
}

/// Refuses columns that are no states of the figure at these times.
fn check_states(figure: &Figure, time: &[f64], [q, v, a]: [&[f64]; 3]) -> Result<(), MotionError> {
    let layout = figure.layout();
    let columns = [
        ("q", q, layout.nq(), layout.q_names()),
        ("v", v, layout.nv(), layout.v_names()),
        ("a", a, layout.nv(), layout.v_names()),
    ];
    for (what, column, width, names) in columns {
        if column.len() != time.len() * width {
            return Err(MotionError::Length { what, found: column.len(), samples: time.len(), width });
        }
        if let Some(i) = column.iter().position(|x| !x.is_finite()) {
            let (dof, time, value) = (names[i % width].clone(), time[i / width], column[i]);
            return Err(MotionError::NotFinite { what, dof, time, value });
        }
    }
    check_quaternions(figure, time, q)
}

/// Refuses quaternions that are far from unit length.
fn check_quaternions(figure: &Figure, time: &[f64], q: &[f64]) -> Result<(), MotionError> {
    let nq = figure.layout().nq();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let Some(first) = link.joint().kind().quaternion() else { continue };
        for (row, &time) in q.chunks_exact(nq).zip(time) {
            let length = read(&row[at.q + first..]).norm();
            if (length - 1.0).abs().partial_cmp(&Motion::UNIT_TOLERANCE).is_none_or(Ordering::is_gt) {
                return Err(MotionError::Quaternion { joint: link.joint().name().to_owned(), time, length });
            }
        }
    }
    Ok(())
}
