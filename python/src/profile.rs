//! Profiles: curves of one degree of freedom over time, and exact answers about them.

use crate::arrays::contiguous;
use crate::errors::{self, argument, plain, value};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use solaris::model::nearest;
use solaris::profiles::{self, Answers, Curve, Kind, Parameter, ProfileCurve, Quantity, Turn, text};
use std::collections::BTreeMap;

/// Of more times than these others may run meanwhile.
const MANY: usize = 1000;

/// A curve of one degree of freedom over a span of time: its kind and its parameters, as `kinds()` lists them.
///
/// `Profile(kind, …)` takes the parameters by keyword, `from_` in place of `from`; those that are optional are zero. Kinds through keys have
/// `keys`, pairs of a time and a position. Positions are in rad or m, times in s. `from_text` reads any profile, also blends, sines and
/// repetitions; docs/profiles.md has the formulas.
///
/// >>> import solaris
/// >>> reach = solaris.Profile("minimum-jerk", from_=0.0, to=1.0, duration=2.0)
/// >>> reach(1.0), reach.peaks()["velocity"]
/// (array(0.5), (1.0, 0.9375))
/// >>> reach
/// <Profile MinimumJerk(from: 0.0, to: 1.0, duration: 2.0)>
#[pyclass(frozen, module = "solaris")]
pub(crate) struct Profile {
    pub(crate) profile: profiles::Profile,
    curve: ProfileCurve,
}

impl Profile {
    fn of(profile: profiles::Profile) -> PyResult<Self> {
        let curve = profile.curve().map_err(|error| plain("ProfileError")(&error))?;
        Ok(Self { profile, curve })
    }

    /// The samples at the times `t`: of each the position, or so many of its numbers in a last axis.
    fn each<'py>(
        &self,
        t: &Bound<'py, PyAny>,
        width: Option<usize>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let times = contiguous("t", t)?;
        // A single number has become a vector of one.
        let single = t.extract::<f64>().is_ok();
        let mut shape = if single { Vec::new() } else { times.shape().to_vec() };
        shape.extend(width);
        let width = width.unwrap_or(1);
        let sampled = |times: &[f64]| {
            let mut numbers = Vec::with_capacity(times.len() * width);
            for (i, time) in times.iter().enumerate() {
                if !time.is_finite() {
                    return Err(argument("t", format!("t holds {time} at {i}; it must be a finite number")));
                }
                numbers.extend_from_slice(&self.curve.at(*time).to_array()[..width]);
            }
            Ok(numbers)
        };
        let given = times.as_slice().unwrap_or_default();
        let numbers = if given.len() > MANY {
            // Others may write to the array meanwhile.
            let own = given.to_vec();
            t.py().detach(|| sampled(&own))?
        } else {
            sampled(given)?
        };
        PyArray1::from_vec(t.py(), numbers).reshape(&shape[..])
    }
}

/// A parameter's name in Python: `from` is a word of the language.
fn keyword(parameter: &Parameter) -> String {
    let field = parameter.field();
    if field == "from" { "from_".to_owned() } else { field }
}

#[pymethods]
impl Profile {
    #[new]
    #[pyo3(signature = (kind, *, keys=None, **parameters))]
    fn new(
        kind: &str,
        keys: Option<Vec<(f64, f64)>>,
        parameters: Option<BTreeMap<String, f64>>,
    ) -> PyResult<Self> {
        let known = Kind::named(kind).ok_or_else(|| {
            let near = nearest(kind, profiles::Profile::KINDS.iter().map(|known| known.name));
            let hint = near.map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
            argument("kind", format!("there is no profile '{kind}'{hint} Profile.kinds() lists them"))
        })?;
        let given = parameters.unwrap_or_default();
        let names: Vec<String> = known.parameters().map(keyword).collect();
        if let Some(name) = given.keys().find(|name| !names.contains(name)) {
            let names = names.join(", ");
            return Err(argument(
                name,
                format!("profile '{kind}' has no parameter '{name}'; it has {names}"),
            ));
        }
        if keys.is_some() && !known.has_keys() {
            return Err(argument("keys", format!("profile '{kind}' does not go through keys")));
        }
        if known.has_keys() && keys.is_none() {
            return Err(argument(
                "keys",
                format!("profile '{kind}' needs its keys: pairs of a time and a position"),
            ));
        }
        let profile =
            known.profile(|parameter| given.get(&keyword(parameter)).copied(), keys.unwrap_or_default());
        Self::of(profile.map_err(|error| plain("ProfileError")(&error))?)
    }

    /// Reads a profile from its text.
    ///
    /// >>> import solaris
    /// >>> wave = solaris.Profile.from_text("Sine(amplitude: 0.2, period: 1, cycles: 3)")
    /// >>> wave.duration, wave.is_monotone
    /// (3.0, False)
    #[staticmethod]
    fn from_text(source: &str) -> PyResult<Self> {
        let faulty =
            |faults: text::TextError| errors::text("ProfileError", "", &faults.to_string(), &[("", &faults)]);
        Self::of(text::read(source).map_err(faulty)?)
    }

    /// Its text, which `from_text` reads.
    fn to_text(&self) -> String {
        text::write(&self.profile)
    }

    /// The kinds that there are: what each is, its family, and the summaries of its parameters, the required ones first.
    ///
    /// >>> import solaris
    /// >>> list(solaris.Profile.kinds()["minimum-jerk"]["parameters"])
    /// ['from_', 'to', 'duration']
    #[staticmethod]
    fn kinds(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let all = PyDict::new(py);
        for kind in profiles::Profile::KINDS {
            let parameters = PyDict::new(py);
            for parameter in kind.parameters() {
                parameters.set_item(keyword(parameter), parameter.summary)?;
            }
            let one = PyDict::new(py);
            one.set_item("summary", kind.summary)?;
            one.set_item("family", format!("{:?}", kind.family).to_lowercase())?;
            one.set_item("required", kind.required.iter().map(|p| keyword(p)).collect::<Vec<_>>())?;
            one.set_item("parameters", parameters)?;
            one.set_item("keys", kind.has_keys())?;
            all.set_item(kind.name, one)?;
        }
        Ok(all)
    }

    /// How long it lasts (s).
    #[getter]
    fn duration(&self) -> f64 {
        self.curve.duration()
    }

    /// The positions at the times `t` (s), any shape of them; before its beginning and after its end those of the ends.
    fn __call__<'py>(&self, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.each(t, None)
    }

    /// Position, velocity, acceleration and jerk at the times `t` (s): four numbers a time, in a last axis. Where something jumps they are what
    /// holds after it.
    ///
    /// >>> import solaris
    /// >>> solaris.Profile("line", from_=0.0, to=3.0, duration=2.0).at([0.0, 1.0]).tolist()
    /// [[0.0, 1.5, 0.0, 0.0], [1.5, 1.5, 0.0, 0.0]]
    fn at<'py>(&self, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.each(t, Some(4))
    }

    /// The times inside of its span at which its velocity is zero or changes its sign, each with `"reversal"` where it turns round, or
    /// `"touch"`: none missing, none extra.
    fn stationary(&self) -> Vec<(f64, &'static str)> {
        let named = |turn| if turn == Turn::Reversal { "reversal" } else { "touch" };
        self.curve.stationary().points.iter().map(|point| (point.time, named(point.turn))).collect()
    }

    /// The spans of time (s) over which it rests.
    fn rests(&self) -> Vec<(f64, f64)> {
        self.curve.stationary().rests
    }

    /// The greatest magnitudes of `velocity`, `acceleration` and `jerk`, each with the first time at which it is reached: `(time, value)`;
    /// infinite where it grows without bound.
    fn peaks(&self) -> BTreeMap<&'static str, (f64, f64)> {
        let peaks = self.curve.peaks();
        let named =
            [("velocity", peaks.velocity), ("acceleration", peaks.acceleration), ("jerk", peaks.jerk)];
        named.into_iter().map(|(name, peak)| (name, (peak.time, peak.value))).collect()
    }

    /// The least and the greatest value of `"position"`, `"velocity"`, `"acceleration"` or `"jerk"` from a time to another (s).
    ///
    /// >>> import solaris
    /// >>> solaris.Profile.from_text("Sine(amplitude: 0.2, period: 1, cycles: 3)").range()
    /// (-0.2, 0.2)
    #[pyo3(signature = (quantity="position", start=None, end=None))]
    fn range(&self, quantity: &str, start: Option<f64>, end: Option<f64>) -> PyResult<(f64, f64)> {
        let of = match quantity {
            "position" => Quantity::Position,
            "velocity" => Quantity::Velocity,
            "acceleration" => Quantity::Acceleration,
            "jerk" => Quantity::Jerk,
            other => {
                let known = "'position', 'velocity', 'acceleration' or 'jerk'";
                return Err(argument("quantity", format!("quantity is '{other}'; it must be {known}")));
            }
        };
        let duration = self.duration();
        let (start, end) = (start.unwrap_or(0.0), end.unwrap_or(duration));
        if !(0.0 <= start && start <= end && end <= duration) {
            return Err(value(format!(
                "start is {start} and end is {end}; they must be times from 0 to {duration} s, one after the other"
            )));
        }
        Ok(self.curve.range(of, start, end))
    }

    /// Whether it never turns round: it may touch standstill and rest.
    #[getter]
    fn is_monotone(&self) -> bool {
        self.curve.is_monotone()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().profile == self.profile)
    }

    fn __repr__(&self) -> String {
        format!("<Profile {}>", text::line(&self.profile))
    }
}
