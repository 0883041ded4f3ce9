//! The force of a drive on one degree of freedom, in the time of the run.

use super::path::Path;
use super::servo::ServoForce;
use solaris_profiles::Elementary;

/// What a drive does to a degree of freedom that dynamics move.
#[derive(Clone)]
pub(crate) enum Force {
    /// As much all the time (N m or N); zero for a free one.
    Constant(f64),
    /// A curve whose positions are forces; after its end, as at its end.
    Along(Path),
    /// What leads it back to a motion.
    Servo(Box<ServoForce>),
    /// Several at once, none of which is a sum.
    Sum(Vec<Force>),
}

impl Force {
    /// The force (N m or N) at a time of the run, in a state of its degree of freedom.
    pub(crate) fn at<T: Elementary>(&self, time: f64, (position, velocity): (T, T)) -> T {
        match self {
            Self::Constant(force) => T::from_f64(*force),
            Self::Along(path) => T::from_f64(path.at(time).position),
            Self::Servo(servo) => servo.at(time, (position, velocity)),
            Self::Sum(parts) => {
                parts.iter().fold(T::zero(), |sum, part| sum + part.at(time, (position, velocity)))
            }
        }
    }

    /// Whether it depends on the state.
    pub(crate) fn feels(&self) -> bool {
        self.servos().next().is_some()
    }

    /// What in it leads back to a motion.
    pub(crate) fn servos(&self) -> impl Iterator<Item = &ServoForce> {
        let parts = match self {
            Self::Sum(parts) => parts.as_slice(),
            one => std::slice::from_ref(one),
        };
        parts.iter().filter_map(|part| match part {
            Self::Servo(servo) => Some(&**servo),
            _ => None,
        })
    }

    /// The first servo in it, if it has one, leads to rest at a position (rad or m) from now on.
    pub(crate) fn lead_to(&mut self, to: f64) {
        let parts = match self {
            Self::Sum(parts) => parts.as_mut_slice(),
            one => std::slice::from_mut(one),
        };
        let first = parts.iter_mut().find_map(|part| match part {
            Self::Servo(servo) => Some(servo),
            _ => None,
        });
        if let Some(servo) = first {
            servo.aim = Path::Still(to);
        }
    }

    /// The force over a stretch without breaks inside: see [`Path::during`].
    pub(crate) fn during(&self, from: f64, to: f64) -> Self {
        match self {
            Self::Constant(_) => self.clone(),
            Self::Along(path) => Self::Along(path.during(from, to)),
            Self::Servo(servo) => Self::Servo(Box::new(servo.during(from, to))),
            Self::Sum(parts) => Self::Sum(parts.iter().map(|part| part.during(from, to)).collect()),
        }
    }

    /// The times of the run at which it may jump.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        match self {
            Self::Constant(_) => Vec::new(),
            Self::Along(path) => path.breaks(),
            Self::Servo(servo) => servo.breaks(),
            Self::Sum(parts) => parts.iter().flat_map(Self::breaks).collect(),
        }
    }
}
