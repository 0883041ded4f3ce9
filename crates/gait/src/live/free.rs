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
    /// For each: whether it is freed, how far it is (0 to 1), its value.
    states: Vec<(bool, f64, f64)>,
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
        let states = vec![(false, 0.0, 0.0); names.len()];
        Self { names: names.into(), states }
    }

    fn find(&self, dof: &str) -> Result<usize, LiveError> {
        let found = self.names.iter().position(|(name, _)| name == dof);
        found.ok_or_else(|| LiveError::NotFree { dof: dof.to_owned() })
    }

    pub(super) fn free(&mut self, dof: &str, freed: bool) -> Result<(), LiveError> {
        let i = self.find(dof)?;
        self.states[i].0 = freed;
        Ok(())
    }

    pub(super) fn set(&mut self, dof: &str, value: f64) -> Result<(), LiveError> {
        let i = self.find(dof)?;
        if !value.is_finite() {
            return Err(LiveError::NotFinite { what: "value", value });
        }
        self.states[i].2 = value;
        Ok(())
    }

    pub(super) fn step(&mut self, dt: f64) {
        for (freed, part, _) in &mut self.states {
            let change = if *freed { dt } else { -dt };
            *part = (*part + change / EASES).clamp(0.0, 1.0);
        }
    }

    pub(super) fn write(&self, q: &mut [f64]) {
        for ((_, i), (_, part, value)) in self.names.iter().zip(&self.states) {
            if *part > 0.0 {
                q[*i] += (value - q[*i]) * step::quintic(*part).position;
            }
        }
    }
}
