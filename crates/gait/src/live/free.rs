//! Coordinates that the caller moves while the figure walks.

use crate::body::Body;
use crate::error::LiveError;
use solaris_model::Figure;
use solaris_profiles::step;
use std::sync::Arc;

/// How long a coordinate takes to come and go (s).
const EASES: f64 = 0.2;

/// The coordinates that may be freed, and how far each is.
#[derive(Clone)]
pub(super) struct Freed {
    names: Arc<[(String, usize)]>,
    states: Vec<State>,
}

/// How one is.
#[derive(Clone, Copy, Default)]
struct State {
    freed: bool,
    /// How far it is, 0 to 1.
    part: f64,
    value: f64,
    /// What was shown last, and how fast it changes (1/s).
    shown: f64,
    rate: f64,
}

impl Freed {
    /// All but those of the root and of the legs.
    pub(super) fn new(figure: &Figure, body: &Body) -> Self {
        let upper = body.middle[1..].iter().chain(body.arms.iter().flatten());
        let layout = figure.layout();
        let names: Vec<(String, usize)> = upper
            .flat_map(|segment| segment.q..segment.q + 3)
            .map(|q| (layout.q_names()[q].clone(), q))
            .collect();
        let states = vec![State::default(); names.len()];
        Self { names: names.into(), states }
    }

    fn find(&self, dof: &str) -> Result<usize, LiveError> {
        let found = self.names.iter().position(|(name, _)| name == dof);
        found.ok_or_else(|| LiveError::NotFree { dof: dof.to_owned() })
    }

    pub(super) fn free(&mut self, dof: &str, freed: bool) -> Result<(), LiveError> {
        let i = self.find(dof)?;
        self.states[i].freed = freed;
        Ok(())
    }

    pub(super) fn set(&mut self, dof: &str, value: f64) -> Result<(), LiveError> {
        let i = self.find(dof)?;
        if !value.is_finite() {
            return Err(LiveError::NotFinite { what: "value", value });
        }
        self.states[i].value = value;
        Ok(())
    }

    pub(super) fn step(&mut self, dt: f64) {
        for state in &mut self.states {
            let change = if state.freed { dt } else { -dt };
            state.part = (state.part + change / EASES).clamp(0.0, 1.0);
        }
    }

    /// Writes what is freed into a configuration, `dt` (s) after the last.
    pub(super) fn write(&mut self, q: &mut [f64], dt: f64) {
        for ((_, i), state) in self.names.iter().zip(&mut self.states) {
            if state.part > 0.0 {
                q[*i] += (state.value - q[*i]) * step::quintic(state.part).position;
            }
            // A coordinate that is freed and told a value in one frame has none before it.
            state.rate = if dt > 0.0 && state.part > 0.0 { (q[*i] - state.shown) / dt } else { 0.0 };
            state.shown = q[*i];
        }
    }

    /// Writes the velocities of what is freed (rad/s), and no accelerations.
    pub(super) fn write_derivatives(&self, v: &mut [f64], a: &mut [f64]) {
        // A walker's coordinates are as many as its degrees of freedom, and in their order.
        for ((_, i), state) in self.names.iter().zip(&self.states).filter(|(_, state)| state.part > 0.0) {
            (v[*i], a[*i]) = (state.rate, 0.0);
        }
    }
}
