//! Where, within a step, an event function passes through zero.

use super::TimeError;

/// Values within this many roundings of zero at the beginning of a stretch are zero: where an event was located.
const AT_START: f64 = 4.0 * f64::EPSILON;
/// Values within this many roundings of zero at the end of a step have come to zero. More than [`AT_START`], so that
/// nothing can be too near to be seen from where it is going to, and too near to be seen from where it came.
const AT_END: f64 = 16.0 * f64::EPSILON;
/// Where in the first step it is seen to which side a function leaves zero.
const PROBE: f64 = 1.0 / 4096.0;

/// Event values at a fraction of the step that is looked at.
pub(super) type Probe<'a> = &'a mut dyn FnMut(f64, &mut [f64]) -> Result<(), TimeError>;

/// A step that is looked at.
#[derive(Clone, Copy)]
pub(super) struct Look {
    /// When it ends (s).
    pub(super) end: f64,
    /// Its length (s).
    pub(super) length: f64,
    /// The magnitude of the state, of which event functions have the rounding errors.
    pub(super) size: f64,
    /// The finest fraction of the step that can be told apart.
    pub(super) resolution: f64,
}

/// The sides on which event functions are.
#[derive(Clone, Debug)]
pub(super) struct Sides {
    /// The sign of each function where it last was not zero; 0 for one that has not left zero yet.
    side: Vec<f64>,
    /// The sign that a function has to have when it leaves zero; 0 where either will do.
    due: Vec<f64>,
    /// Whether a function leaves zero in the step that is looked at: it may be there, to rounding, at any time in it.
    leaves: Vec<bool>,
    tolerance: Vec<f64>,
    begin: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
    middle: Vec<f64>,
    /// Those that came to zero in the step that was looked at last.
    pub(super) crossed: Vec<usize>,
}

impl Sides {
    /// Functions with these values at the beginning of a stretch, and the sides that they are due on.
    pub(super) fn new(values: Vec<f64>, due: impl Fn(usize) -> f64) -> Self {
        let zeros = vec![0.0; values.len()];
        Self {
            side: zeros.clone(),
            due: (0..values.len()).map(due).collect(),
            leaves: vec![false; values.len()],
            tolerance: zeros.clone(),
            low: zeros.clone(),
            high: zeros.clone(),
            middle: zeros,
            crossed: Vec::with_capacity(values.len()),
            begin: values,
        }
    }

    /// Functions with these values from now on, whatever they were before.
    pub(super) fn begin_anew(&mut self, values: &[f64]) {
        self.side.fill(0.0);
        self.leaves.fill(false);
        self.begin.copy_from_slice(values);
    }

    /// The number of functions.
    #[cfg(feature = "stiff")]
    pub(super) fn len(&self) -> usize {
        self.side.len()
    }

    /// Looks at a step that ends with the values `end`: the fraction at which the first functions come to zero, which
    /// `crossed` names; none if no function does.
    ///
    /// The fraction is that of the zero, or the last one before it.
    pub(super) fn look(
        &mut self,
        step: Look,
        end: &[f64],
        probe: Probe<'_>,
    ) -> Result<Option<f64>, TimeError> {
        self.crossed.clear();
        for i in 0..end.len() {
            let slope = (end[i] - self.begin[i]).abs() / step.length;
            self.tolerance[i] = step.size + step.end.abs() * slope;
        }
        self.low.copy_from_slice(&self.begin);
        self.high.copy_from_slice(end);
        let (from, to) = self.take_sides(probe)?;
        if !self.any_beyond() {
            self.note_touching();
            self.begin.copy_from_slice(end);
            return Ok((!self.crossed.is_empty()).then_some(1.0));
        }
        let found = self.bracket(step.resolution, (from, to), probe)?;
        Ok(Some(found))
    }

    /// Tells the sides of functions that had none: by the beginning of the step, or, where they begin at zero, by how
    /// they leave it. The fractions between which the first zero is, if there is one.
    fn take_sides(&mut self, probe: Probe<'_>) -> Result<(f64, f64), TimeError> {
        let mut leaving = false;
        self.leaves.fill(false);
        for i in 0..self.side.len() {
            if self.side[i] == 0.0 && self.low[i].abs() > AT_START * self.tolerance[i] {
                self.side[i] = self.low[i].signum();
            }
            if self.side[i] == 0.0 && self.high[i].abs() > AT_END * self.tolerance[i] {
                self.side[i] = self.due[i];
                self.leaves[i] = true;
                leaving = true;
            }
        }
        if !leaving {
            return Ok((0.0, 1.0));
        }
        probe(PROBE, &mut self.middle)?;
        let early = (0..self.side.len()).any(|i| self.is_past(i, self.middle[i]));
        for i in 0..self.side.len() {
            if self.side[i] == 0.0 && self.high[i].abs() > AT_END * self.tolerance[i] {
                let left = self.middle[i].abs() > AT_START * self.tolerance[i];
                self.side[i] = if left { self.middle[i] } else { self.high[i] }.signum();
            }
        }
        if early {
            std::mem::swap(&mut self.high, &mut self.middle);
            return Ok((0.0, PROBE));
        }
        std::mem::swap(&mut self.low, &mut self.middle);
        for i in 0..self.side.len() {
            self.leaves[i] &= self.low[i].abs() <= AT_START * self.tolerance[i];
        }
        Ok((PROBE, 1.0))
    }

    /// Whether a function is beyond zero, or on it, at the upper end of the bracket.
    fn any_beyond(&self) -> bool {
        (0..self.side.len()).any(|i| self.is_beyond(i, self.high[i]))
    }

    /// Whether a function with this value is beyond zero.
    fn is_past(&self, i: usize, value: f64) -> bool {
        let least = if self.leaves[i] { AT_START * self.tolerance[i] } else { 0.0 };
        self.side[i] * value < -least
    }

    /// Whether a function with this value is beyond zero or on it; one that leaves zero has to be beyond.
    fn is_beyond(&self, i: usize, value: f64) -> bool {
        self.is_past(i, value) || (value == 0.0 && self.side[i] != 0.0 && !self.leaves[i])
    }

    /// Notes the functions that are beyond zero or at it, to rounding, at the upper end of the bracket.
    fn note_touching(&mut self) {
        for i in 0..self.side.len() {
            let value = self.high[i];
            let touches = self.side[i] != 0.0 && self.side[i] * value <= AT_END * self.tolerance[i];
            if self.is_past(i, value) || (touches && !self.leaves[i]) {
                self.crossed.push(i);
            }
        }
    }

    /// Brackets the first zero, by the method ITP: interpolation, cut short and projected so that it never needs more
    /// than one evaluation more than bisection.
    ///
    /// # Source
    ///
    /// I. F. D. Oliveira, R. H. C. Takahashi: An Enhancement of the Bisection Method Average Performance Preserving
    /// Minmax Optimality. ACM Transactions on Mathematical Software 47 (2021), 5:1–5:24. With κ₁ = 0.2, κ₂ = 2, n₀ = 1.
    /// Of several functions the one with the earliest interpolated zero leads.
    fn bracket(
        &mut self,
        resolution: f64,
        (from, to): (f64, f64),
        probe: Probe<'_>,
    ) -> Result<f64, TimeError> {
        let (mut a, mut b) = (from, to);
        let half_width = (0.5 * resolution).max(f64::EPSILON);
        let mut reach =
            half_width * 2.0_f64.powf(((b - a) / (2.0 * half_width)).log2().ceil().max(0.0) + 1.0);
        while b - a > 2.0 * half_width && !self.is_exact() {
            let (width, half) = (b - a, a + 0.5 * (b - a));
            let interpolated = a + width * self.earliest();
            let radius = reach - 0.5 * width;
            let towards = half - interpolated;
            let cut = 0.2 * width * width;
            let truncated = if cut <= towards.abs() { interpolated + cut.copysign(towards) } else { half };
            let middle =
                if (truncated - half).abs() <= radius { truncated } else { half - radius.copysign(towards) };
            if !(a < middle && middle < b) {
                break;
            }
            probe(middle, &mut self.middle)?;
            if (0..self.side.len()).any(|i| self.is_beyond(i, self.middle[i])) {
                b = middle;
                std::mem::swap(&mut self.high, &mut self.middle);
            } else {
                a = middle;
                std::mem::swap(&mut self.low, &mut self.middle);
            }
            reach *= 0.5;
        }
        // Those beyond zero at the upper end have passed it within the bracket, and with them those that are at it.
        let exact = self.is_exact();
        self.note_touching();
        Ok(if exact { b } else { a })
    }

    /// Where within the bracket, 0 to 1, the first zero is by linear interpolation.
    fn earliest(&self) -> f64 {
        let mut first = 1.0_f64;
        for i in 0..self.side.len() {
            if self.is_beyond(i, self.high[i]) {
                let (low, high) = (self.low[i].abs(), self.high[i].abs());
                first = first.min(low / (low + high).max(f64::MIN_POSITIVE));
            }
        }
        first
    }

    /// Whether all that are beyond zero at the upper end are exactly at it.
    fn is_exact(&self) -> bool {
        let all = || (0..self.side.len()).map(|i| (i, self.high[i]));
        all().any(|(i, value)| value == 0.0 && self.is_beyond(i, value))
            && !all().any(|(i, value)| self.is_past(i, value))
    }
}
