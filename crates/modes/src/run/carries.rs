//! Loads that are taken up and let go.

use super::guard;
use super::pass::Pass;
use super::record::near;
use crate::body::{Body, Closure};
use crate::element::{Loop, LoopKind};
use crate::failure::{RunError, SetupError};
use crate::impact::{Struck, strike};
use crate::simulation::Simulation;
use solaris_model::{Event, EventKind, Load};

/// The whole figure of a simulation with all that acts in it.
pub(crate) fn whole_body(simulation: &Simulation, by_impulses: bool) -> Result<Body<f64>, SetupError> {
    let Simulation { figure, gravity, springs, limits, surface, pushes, .. } = simulation;
    let on: Vec<_> = pushes.iter().map(|push| (push.link, push.point)).collect();
    let mut body = Body::new(figure, *gravity, springs, limits)?.on(surface.as_ref()).pushed(&on);
    body.touch_by_impulses(by_impulses);
    if !by_impulses {
        let closure = |closed: &Loop| {
            let ends = closed.between.map(|anchor| (anchor.link, anchor.point));
            Closure::new(ends, closed.kind == LoopKind::Weld)
        };
        body.close(simulation.loops.iter().filter_map(closure).collect());
    }
    Ok(body)
}

/// Which loads are carried from a time (s) on.
pub(crate) fn carried(simulation: &Simulation, time: f64) -> Vec<bool> {
    simulation.carries.iter().map(|carry| carry.holds(time, near(time))).collect()
}

/// The whole figure with what it carries, by the frame.
#[derive(Clone)]
pub(crate) struct LoadedBody {
    carried: Vec<bool>,
    by_impulses: bool,
    pub(crate) body: Body<f64>,
}

impl LoadedBody {
    /// That at the time 0.
    pub(crate) fn new(simulation: &Simulation, by_impulses: bool) -> Result<Self, SetupError> {
        let carried = carried(simulation, 0.0);
        let body = if carried.is_empty() {
            whole_body(simulation, by_impulses)
        } else {
            whole_body(&simulation.carrying(&carried)?, by_impulses)
        };
        Ok(Self { carried, by_impulses, body: body? })
    }

    /// Makes it that from a time (s) on.
    pub(crate) fn go_to(&mut self, simulation: &Simulation, time: f64) -> Result<(), SetupError> {
        let now = carried(simulation, time);
        if now != self.carried {
            self.body = whole_body(&simulation.carrying(&now)?, self.by_impulses)?;
            self.carried = now;
        }
        Ok(())
    }
}

impl Pass {
    /// The times (s) at which a load is taken up or let go.
    pub(crate) fn carry_breaks(&self) -> impl Iterator<Item = f64> {
        self.simulation.carries.iter().flat_map(|carry| [carry.from, carry.until])
    }

    /// Makes the whole figure, with what it carries, anew after other laws were set.
    pub(crate) fn rebuild(&mut self) -> Result<(), RunError> {
        if !self.carried.is_empty() {
            self.loaded = Some(Box::new(self.simulation.carrying(&self.carried)?));
        }
        self.body = whole_body(self.loaded.as_deref().unwrap_or(&self.simulation), self.by_impulses())?;
        Ok(())
    }

    /// Takes up and lets go what is due.
    pub(crate) fn carry(&mut self) -> Result<(), RunError> {
        let now = carried(&self.simulation, self.t);
        if now == self.carried {
            return Ok(());
        }
        let begins = self.carried.is_empty();
        let before = if begins { vec![false; now.len()] } else { std::mem::take(&mut self.carried) };
        let changed = |was: bool, is: bool| {
            let pairs = before.iter().zip(&now).enumerate();
            pairs.filter(move |(_, (a, b))| (**a, **b) == (was, is)).map(|(i, _)| i).collect::<Vec<_>>()
        };
        let (taken, left) = (changed(false, true), changed(true, false));
        let (loaded, by_impulses) = (self.simulation.carrying(&now)?, self.by_impulses());
        let mut old = std::mem::replace(&mut self.body, whole_body(&loaded, by_impulses)?);
        self.loaded = Some(Box::new(loaded));
        self.carried = now;
        self.forget_phase();
        if begins {
            return Ok(());
        }
        self.passed.jumps = true;
        for (carries, which) in [("takes up", &taken), ("lets go of", &left)] {
            for &i in which {
                let Load { link, mass, .. } = self.simulation.carries[i].load;
                let what = format!("{}: {carries} {mass} kg", self.simulation.figure.links()[link].name());
                self.passed.record.events.push(Event { time: self.t, kind: EventKind::DriveChange { what } });
            }
        }
        if taken.is_empty() { Ok(()) } else { self.take_up(&mut old, &taken) }
    }

    /// The impact in which loads that stood still are taken up; `old` is the figure before.
    ///
    /// With the loads as parts of the figure, `(M + M_load)·Δv = −M_load·v⁻`: what their momenta would be takes itself back.
    fn take_up(&mut self, old: &mut Body<f64>, taken: &[usize]) -> Result<(), RunError> {
        let fault = |t, error| RunError::from(guard::of_dynamics(t, error));
        let (fixed, held) = self.given_way();
        let kinetic = old.energy(&self.q, &self.v).map_err(|error| fault(self.t, error))?.kinetic;
        self.body.plant(&[]);
        self.active.forget();
        let loads: Vec<&Load> = taken.iter().map(|i| &self.simulation.carries[*i].load).collect();
        self.body.take_up(&self.q, &self.v, &loads).map_err(|error| fault(self.t, error))?;
        let struck = strike(&mut self.body, &self.q, &self.v, &fixed, &held);
        self.body.no_blow();
        let struck = struck.map_err(|error| fault(self.t, error))?;
        self.passed.counts.evaluations += 1;
        let after = self.body.energy(&self.q, &struck.v).map_err(|error| fault(self.t, error))?.kinetic;
        // With the energy of the figure alone before, and of both after.
        self.take_velocities(Struck { loss: kinetic - after, ..struck });
        Ok(())
    }
}
