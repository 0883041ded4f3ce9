//! Evaluations that are counted, limited, and never give what is not finite.

use super::{RateError, System, TimeError};
use crate::report::Counts;
#[cfg(feature = "stiff")]
use nalgebra::DMatrix;

/// A system as the methods see it during one stretch.
pub(super) struct Evaluator<'a, S: System + ?Sized> {
    pub(super) system: &'a mut S,
    pub(super) counts: &'a mut Counts,
    /// What `counts.evaluations` may not exceed.
    most: u64,
    /// The last instant at which anything is asked: just before the end of the stretch, so that a rate that jumps at the
    /// end is the one from before the jump.
    last: f64,
}

impl<'a, S: System + ?Sized> Evaluator<'a, S> {
    pub(super) fn new(system: &'a mut S, counts: &'a mut Counts, most: u64, span: (f64, f64)) -> Self {
        Self { system, counts, most, last: span.1.next_down().max(span.0) }
    }

    /// Writes the rate at `t` (s).
    pub(super) fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), TimeError> {
        if self.counts.evaluations >= self.most {
            return Err(TimeError::Evaluations { time: t, evaluations: self.counts.evaluations });
        }
        self.counts.evaluations += 1;
        self.system
            .rate(t.min(self.last), y, rate)
            .and_then(|()| finite(rate))
            .map_err(|source| TimeError::Rate { time: t, source })
    }

    /// Writes the state a step of `h` (s) after `y`, by impulses.
    pub(super) fn step_by_impulses(
        &mut self,
        t: f64,
        h: f64,
        y: &[f64],
        next: &mut [f64],
    ) -> Result<(), TimeError> {
        if self.counts.evaluations >= self.most {
            return Err(TimeError::Evaluations { time: t, evaluations: self.counts.evaluations });
        }
        self.counts.evaluations += 1;
        match self.system.step_by_impulses(t, h, y, next) {
            Ok(true) => Ok(()),
            Ok(false) => Err(TimeError::NoImpulses),
            Err(source) => Err(TimeError::Rate { time: t, source }),
        }
    }

    /// Writes the Jacobian at `t` (s).
    #[cfg(feature = "stiff")]
    pub(super) fn jacobian(
        &mut self,
        t: f64,
        y: &[f64],
        jacobian: &mut DMatrix<f64>,
    ) -> Result<(), TimeError> {
        self.counts.jacobians += 1;
        let at = |source| TimeError::Rate { time: t, source };
        self.system.jacobian(t.min(self.last), y, jacobian).map_err(at)?;
        let rows = jacobian.nrows();
        match jacobian.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(entry) => Err(at(RateError::NotFinite { index: entry % rows, value: jacobian[entry] })),
        }
    }

    /// Writes the values of the event functions at `t` (s).
    pub(super) fn event_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) -> Result<(), TimeError> {
        self.system.event_values(t.min(self.last), y, values);
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(index) => {
                let source = RateError::EventNotFinite { index, value: values[index] };
                Err(TimeError::Rate { time: t, source })
            }
        }
    }
}

/// Refuses numbers that are none.
pub(super) fn finite(values: &[f64]) -> Result<(), RateError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(RateError::NotFinite { index, value: values[index] }),
    }
}
