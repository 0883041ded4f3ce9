//! Inequalities that a posture asks of its parameters, and the refusal where one does not hold.

use std::fmt;

/// One inequality that has to hold, in the numbers of a request.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Its short name: `(i)`, `ψ (8.11)`.
    pub name: &'static str,
    /// The inequality: `α > χ`, `the swinging leg clears the ground`.
    pub text: &'static str,
    /// The lesser and the greater side, in the unit of `symbol`.
    pub sides: [f64; 2],
    /// Unit of the sides: `°`, ` m`, or nothing for a cosine.
    pub symbol: &'static str,
}

impl Condition {
    /// By how much it holds, in its unit; what is negative fails, and what is none fails too.
    pub fn room(&self) -> f64 {
        let room = self.sides[1] - self.sides[0];
        if room.is_nan() { f64::NEG_INFINITY } else { room }
    }

    /// Whether it holds: strictly, for the sides are not to meet.
    pub fn holds(&self) -> bool {
        self.room() > 0.0
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [lesser, greater] = self.sides;
        let is = if self.holds() { "<" } else { "is not less than" };
        let decimals = if self.symbol == "°" { 2 } else { 4 };
        let unit = self.symbol;
        write!(f, "{} {}: {lesser:.decimals$}{unit} {is} {greater:.decimals$}{unit}", self.name, self.text)
    }
}

/// A parameter of the key postures as people write it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyParameter {
    /// In words: `heel-strike-angle`.
    pub name: &'static str,
    /// In the thesis: `θ`.
    pub symbol: &'static str,
    /// What it is.
    pub help: &'static str,
    /// `°` or ` m`.
    pub unit: &'static str,
    /// Least and greatest value that is looked at, in its unit.
    pub range: (f64, f64),
}

/// The nearest value of one parameter at which all would hold, the others as they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Which parameter.
    pub parameter: KeyParameter,
    /// Its value, in its unit.
    pub value: f64,
    /// The nearest feasible one; none where no value of this parameter alone helps.
    pub feasible: Option<f64>,
}

/// Why a set of parameters has no postures.
#[derive(Clone, Debug, PartialEq)]
pub struct Infeasible {
    /// What fails, the first first.
    pub fails: Vec<Condition>,
    /// What each parameter alone could do about it.
    pub nearest: Vec<Nearest>,
}

impl fmt::Display for Infeasible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fails = self.fails.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ");
        write!(f, "{fails}")?;
        let helps = self.nearest.iter().filter_map(|n| n.feasible.map(|value| (n, value)));
        let helps: Vec<String> = helps
            .map(|(n, value)| {
                let decimals = n.decimals();
                let (name, unit, was) = (n.parameter.name, n.parameter.unit, n.value);
                format!("{name} {value:.decimals$}{unit} (instead of {was:.decimals$})")
            })
            .collect();
        if helps.is_empty() {
            write!(f, "; no single parameter mends it")
        } else {
            write!(f, "; one of these alone would do: {}", helps.join(", "))
        }
    }
}

impl std::error::Error for Infeasible {}

impl Nearest {
    /// Decimals with which its values are written.
    fn decimals(&self) -> usize {
        if self.parameter.unit == "°" { 2 } else { 4 }
    }

    /// The feasible value as it is written, and if it does not work so, values a few last digits farther from what failed.
    fn written(&self) -> impl Iterator<Item = f64> {
        let unit = 10f64.powi(self.decimals() as i32);
        let values = self.feasible.into_iter().flat_map(move |feasible| {
            let (sign, at) = ((feasible - self.value).signum(), feasible * unit);
            // Rounded away from the value that failed, whatever a bisection left.
            let first = if sign < 0.0 { (at + 1e-4).floor() } else { (at - 1e-4).ceil() };
            FARTHER.into_iter().map(move |farther| (first + sign * farther) / unit)
        });
        let (lower, upper) = self.parameter.range;
        values.filter(move |value| (lower..=upper).contains(value))
    }
}

/// How many last digits farther a feasible value is tried.
const FARTHER: [f64; 5] = [0.0, 1.0, 2.0, 5.0, 20.0];

/// Places at which a parameter is tried on its way to its ends.
const PLACES: usize = 240;

impl Infeasible {
    /// Of conditions that fail, with the nearest feasible value of each parameter alone.
    ///
    /// `feasible` is asked with all parameters' values in their units. Each parameter is tried at 240 places on either side, up
    /// to the ends of its range, and the boundary is then found to 1e-9 of the range by bisection, on its feasible side.
    pub fn new(
        fails: Vec<Condition>,
        parameters: &[KeyParameter],
        values: &[f64],
        feasible: impl Fn(&[f64]) -> bool,
    ) -> Self {
        let nearest = parameters.iter().enumerate().map(|(i, parameter)| {
            let mut trial = values.to_vec();
            let mut holds = |value: f64| {
                trial[i] = value;
                feasible(&trial)
            };
            let one_way = |end: f64, holds: &mut dyn FnMut(f64) -> bool| {
                let at = |k: usize| values[i] + (end - values[i]) * k as f64 / PLACES as f64;
                let k = (1..=PLACES).find(|k| holds(at(*k)))?;
                let (mut bad, mut good) = (at(k - 1), at(k));
                while (good - bad).abs() > 1e-9 * (parameter.range.1 - parameter.range.0) {
                    let middle = 0.5 * (bad + good);
                    if holds(middle) { good = middle } else { bad = middle }
                }
                Some(good)
            };
            let found = [one_way(parameter.range.0, &mut holds), one_way(parameter.range.1, &mut holds)];
            let distance = |value: &f64| (value - values[i]).abs();
            let nearest = found.into_iter().flatten().min_by(|a, b| distance(a).total_cmp(&distance(b)));
            Nearest { parameter: *parameter, value: values[i], feasible: nearest }
        });
        // What has no number follows from what fails before it.
        let has_numbers = |condition: &Condition| condition.sides.iter().all(|side| side.is_finite());
        let nearest = nearest.collect();
        let (told, rest): (Vec<_>, Vec<_>) = fails.into_iter().partition(has_numbers);
        Self { nearest, fails: if told.is_empty() { rest } else { told } }
    }

    /// The same with feasible values as people type them: rounded to the digits that are written, on their feasible side, and
    /// left out where a request with such a value would be refused all the same, as when a choice of the other values depends
    /// on it. `works` is asked with a parameter's name and value.
    #[must_use]
    pub fn checked(mut self, works: impl Fn(&'static str, f64) -> bool) -> Self {
        for nearest in &mut self.nearest {
            let found = *nearest;
            nearest.feasible = found.written().find(|value| works(found.parameter.name, *value));
        }
        self
    }
}
