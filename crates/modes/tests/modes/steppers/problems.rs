//! Equations whose solutions are known, as systems.

use nalgebra::DMatrix;
use solaris_modes::time::{RateError, Stepping, Stopped, System, TimeError, advance};
use solaris_modes::{Counts, Rule};

/// `q̈ = a(t, q, q̇)` of one coordinate, with event functions of time, position and velocity.
pub(crate) struct Motion<A> {
    pub(crate) acceleration: A,
    pub(crate) events: Vec<fn(f64, f64, f64) -> f64>,
}

impl<A: Fn(f64, f64, f64) -> f64> Motion<A> {
    pub(crate) fn new(acceleration: A) -> Self {
        Self { acceleration, events: Vec::new() }
    }

    pub(crate) fn event(mut self, function: fn(f64, f64, f64) -> f64) -> Self {
        self.events.push(function);
        self
    }
}

impl<A: Fn(f64, f64, f64) -> f64> System for Motion<A> {
    fn len(&self) -> usize {
        2
    }

    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        rate[0] = y[1];
        rate[1] = (self.acceleration)(t, y[0], y[1]);
        Ok(())
    }

    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        let slope = |i: usize| {
            let h = 1e-6 * y[i].abs().max(1.0);
            let mut at = [y[0], y[1]];
            at[i] = y[i] + h;
            let above = (self.acceleration)(t, at[0], at[1]);
            at[i] = y[i] - h;
            (above - (self.acceleration)(t, at[0], at[1])) / (2.0 * h)
        };
        *jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, slope(0), slope(1)]);
        Ok(())
    }

    fn position_rate(&self, y: &[f64], rate: &mut [f64]) -> bool {
        rate[0] = y[1];
        true
    }

    fn events(&self) -> usize {
        self.events.len()
    }

    fn event_values(&mut self, t: f64, y: &[f64], values: &mut [f64]) {
        for (value, event) in values.iter_mut().zip(&self.events) {
            *value = event(t, y[0], y[1]);
        }
    }
}

/// `ẏ = f(t, y)` with its Jacobian.
pub(crate) struct Equations<F, J> {
    pub(crate) len: usize,
    pub(crate) rate: F,
    pub(crate) jacobian: J,
}

pub(crate) type Rate = fn(f64, &[f64], &mut [f64]) -> Result<(), RateError>;
pub(crate) type Jacobian = fn(f64, &[f64], &mut DMatrix<f64>);

impl<F, J> System for Equations<F, J>
where
    F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), RateError>,
    J: Fn(f64, &[f64], &mut DMatrix<f64>),
{
    fn len(&self) -> usize {
        self.len
    }

    fn rate(&mut self, t: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        (self.rate)(t, y, rate)
    }

    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        (self.jacobian)(t, y, jacobian);
        Ok(())
    }
}

pub(crate) fn fixed(rule: Rule, step: f64) -> Stepping {
    Stepping::Fixed { rule, step }
}

/// From 0 to `to`, without frames or limits.
pub(crate) fn run(
    system: &mut impl System,
    stepping: Stepping,
    to: f64,
    y: &mut [f64],
) -> Result<(Stopped, Counts), TimeError> {
    run_between(system, stepping, (0.0, to), y)
}

pub(crate) fn run_between(
    system: &mut impl System,
    stepping: Stepping,
    span: (f64, f64),
    y: &mut [f64],
) -> Result<(Stopped, Counts), TimeError> {
    let mut counts = Counts::default();
    let stopped = advance(system, stepping, span, y, &[], &mut |_, _, _| Ok(()), u64::MAX, &mut counts)?;
    Ok((stopped, counts))
}

/// From 0 to `to` with frames: the times and states that were shown.
pub(crate) fn frames_of(
    system: &mut impl System,
    stepping: Stepping,
    to: f64,
    y: &mut [f64],
    frames: &[f64],
) -> (Stopped, Vec<(f64, Vec<f64>)>) {
    let (mut counts, mut shown) = (Counts::default(), Vec::new());
    let mut show = |_: &mut _, time: f64, y: &[f64]| {
        shown.push((time, y.to_vec()));
        Ok(())
    };
    let stopped =
        advance(system, stepping, (0.0, to), y, frames, &mut show, u64::MAX, &mut counts).expect("runs");
    (stopped, shown)
}

/// A point mass on a rod of 1 m, released from the horizontal: the planar pendulum of the `IFToMM` library of benchmarks.
pub(crate) struct Pendulum {
    pub(crate) acceleration: fn(f64, f64, f64) -> f64,
    pub(crate) start: [f64; 2],
    /// Its period (s).
    pub(crate) period: f64,
    /// Where the mass is at 10 s (m), by elliptic functions.
    pub(crate) end: [f64; 2],
}

pub(crate) const PENDULUM: Pendulum = Pendulum {
    acceleration: |_, q, _| -9.81 * q.sin(),
    start: [-std::f64::consts::FRAC_PI_2, 0.0],
    period: 2.367_841_947_576_237,
    end: [-0.275_087_462_576_116_9, -0.961_419_205_099_125_3],
};
