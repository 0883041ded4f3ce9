//! Metrics of any motion of any figure with feet: how its feet treat the ground, how it steps, how smooth it is.
//!
//! Unlike [`measure`](crate::measure()) nothing here knows whose motion it is: neither the walker's links nor its angles are
//! asked for, and forces may be missing. What has no meaning for a motion says why ([`NoValue`]).
//!
//! Numbers of a stride are those of one: from a touch-down of the first foot that makes strides to its next, the one nearest
//! to the middle of all touch-downs. Directions are that of gravity, and the way that the centre of mass goes in that
//! stride, as seen from the ground.

mod feet;
mod forces;
mod smooth;
mod spectrum;
mod stride;
mod tracks;

use crate::error::GaitError;
use nalgebra::Vector3;
use solaris_analysis::PreparedMotion;
use solaris_analysis::ground::{self, PlacedFeet, Sole, Stances};
use solaris_model::{ContactTrack, Figure};
use stride::Steps;
use tracks::Tracks;

/// What is known of a motion.
#[derive(Clone, Copy, Debug)]
pub struct MetricsInput<'a> {
    /// The motion of the figure.
    pub motion: &'a PreparedMotion<'a>,
    /// Its feet in this motion; `None` where it has none.
    pub feet: Option<&'a PlacedFeet<'a>>,
    /// When which foot stands, on a ground at which height and of which velocity; `None` where that is not known.
    pub stances: Option<&'a Stances>,
    /// What the ground does to each foot, one track a sole; `None` where that is not known.
    pub contacts: Option<&'a [ContactTrack]>,
}

impl<'a> MetricsInput<'a> {
    /// The soles of the feet.
    fn soles(&self) -> &'a [Sole] {
        self.feet.map_or(&[], |feet| feet.soles())
    }
}

/// A number of a motion.
///
/// With the feature `serde` its keys are `metric`, `name`, `value`, `unit`, `at_s`, and `why` there is no value where there is none.
#[derive(Clone, Debug, PartialEq)]
pub struct Metric {
    /// Its name for programs, with its unit.
    pub key: &'static str,
    /// Its name for people.
    pub name: &'static str,
    /// Its unit; empty for a mere number.
    pub unit: &'static str,
    /// How much, or why it has no meaning for this motion.
    pub value: Result<f64, NoValue>,
    /// When it is reached (s), where it is reached at one time.
    pub at: Option<f64>,
}

#[cfg(feature = "serde")]
impl serde::Serialize for Metric {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let mut metric = serializer.serialize_struct("Metric", 6)?;
        metric.serialize_field("metric", self.key)?;
        metric.serialize_field("name", self.name)?;
        metric.serialize_field("value", &self.value.ok())?;
        metric.serialize_field("unit", self.unit)?;
        metric.serialize_field("at_s", &self.at)?;
        metric.serialize_field("why", &self.value.err().map(|why| why.to_string()))?;
        metric.end()
    }
}

/// Why a motion has no such number.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what it means")]
pub enum NoValue {
    #[error("the figure has no feet")]
    NoFeet,
    #[error("no foot ever stands")]
    NoStance,
    #[error("no foot swings between two stances")]
    NoSwing,
    #[error("no foot touches down twice")]
    NoStride,
    #[error("only two feet make steps, and there are {feet}")]
    NotTwoFeet { feet: usize },
    #[error("the figure goes nowhere, so nothing is ahead")]
    NoHeading,
    #[error("no forces of the ground are given")]
    NoForces,
    #[error("the centre of mass does not move")]
    AtRest,
    #[error("there are too few samples")]
    TooFewSamples,
    #[error("there are more than {most} samples")]
    TooManySamples { most: usize },
    #[error("the samples are not equally far apart")]
    UnevenSamples,
}

impl Metric {
    fn new(
        (key, name, unit): (&'static str, &'static str, &'static str),
        value: Result<f64, NoValue>,
        at: Option<f64>,
    ) -> Self {
        // No NaN leaves: a window without samples has neither a most nor a least.
        let value =
            value.and_then(|value| if value.is_finite() { Ok(value) } else { Err(NoValue::TooFewSamples) });
        let at = at.filter(|_| value.is_ok());
        Self { key, name, unit, value, at }
    }
}

/// A foot stands while the ground presses on it with more than this share of the figure's weight.
const PRESSED: f64 = 1e-3;

/// Stances by forces that are known: a foot stands while the ground presses on it with more than a thousandth of the figure's
/// weight. `contacts` are by sole, with a sample at each `time` (s); height and velocity of the ground are those of `ground`.
pub fn stances_of_contacts(
    figure: &Figure,
    gravity: Vector3<f64>,
    time: &[f64],
    contacts: &[ContactTrack],
    ground: &Stances,
) -> Stances {
    let strength = gravity.norm();
    let up = if strength > 0.0 { -gravity / strength } else { Vector3::zeros() };
    let least = PRESSED * figure.mass() * strength;
    ground::stances_of_contacts(time, contacts, &up, least, (ground.belt, ground.level))
}

/// All numbers of a motion, in an order that does not depend on it.
///
/// # Errors
///
/// No gravity, tracks or stances that do not fit it, and the first state that the kernel refuses.
///
/// # Examples
///
/// Nobody who stands still makes steps, and says so:
///
/// ```
/// use solaris_gait::metrics::{MetricsInput, NoValue, metrics};
/// use solaris_analysis::PreparedMotion;
/// use solaris_model::{Motion, MotionInfo, human};
///
/// let ann = human(1.65, 58.0)?;
/// let (nq, nv) = (ann.layout().nq(), ann.layout().nv());
/// let columns = [vec![0.0; 2 * nq], vec![0.0; 2 * nv], vec![0.0; 2 * nv]];
/// let motion = Motion::new(&ann, MotionInfo::on_earth(&ann, 10.0), vec![0.0, 0.1], columns)?;
/// let motion = PreparedMotion::new(&ann, &motion)?;
/// let all = metrics(&MetricsInput { motion: &motion, feet: None, stances: None, contacts: None })?;
/// let of = |key: &str| all.iter().find(|metric| metric.key == key).map(|metric| metric.value);
/// assert_eq!(of("bob_cm"), Some(Ok(0.0)));
/// assert_eq!(of("step_length_m"), Some(Err(NoValue::NoFeet)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "foot skate")]
#[doc(alias = "smoothness")]
#[doc(alias = "sparc")]
#[doc(alias = "ldlj")]
pub fn metrics(given: &MetricsInput<'_>) -> Result<Vec<Metric>, GaitError> {
    let tracks = Tracks::of(given)?;
    let steps = Steps::of(given, &tracks);
    let mut all = feet::metrics(given, &tracks);
    all.extend(steps.metrics(given));
    all.extend(steps.centre(given, &tracks));
    all.extend(forces::metrics(given, &tracks, &steps));
    all.extend(smooth::metrics(given, &tracks, &steps));
    Ok(all)
}
