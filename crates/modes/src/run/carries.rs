//! Loads that are taken up and let go, and loops that are closed and opened.

use super::closing;
use super::guard;
use super::pass::Pass;
use super::record::near;
use crate::body::{Body, Closure};
use crate::carry::Held;
use crate::element::{Loop, LoopKind};
use crate::failure::{OPEN, RunError, SetupError};
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
        let closure = |(_, closed): (usize, &Loop)| {
            let ends = closed.between.map(|anchor| (anchor.link, anchor.point));
            Closure::new(ends, closed.kind == LoopKind::Weld)
        };
        body.close(simulation.closed().filter_map(closure).collect());
    }
    Ok(body)
}

/// What is held from a time (s) on; nothing is said where nothing is held for a time only.
pub(crate) fn held(simulation: &Simulation, time: f64) -> Option<Held> {
    let is_timed = |closed: &Loop| closed.from > 0.0 || closed.until.is_finite();
    let any = !simulation.carries.is_empty() || simulation.loops.iter().any(is_timed);
    any.then(|| simulation.held(time, near(time)))
}

/// The whole figure with what it holds, by the frame.
#[derive(Clone)]
pub(crate) struct LoadedBody {
    held: Option<Held>,
    by_impulses: bool,
    pub(crate) body: Body<f64>,
}

impl LoadedBody {
    /// That at the time 0.
    pub(crate) fn new(simulation: &Simulation, by_impulses: bool) -> Result<Self, SetupError> {
        let held = held(simulation, 0.0);
        let body = match &held {
            None => whole_body(simulation, by_impulses),
            Some(held) => whole_body(&simulation.holding(held)?, by_impulses),
        };
        Ok(Self { held, by_impulses, body: body? })
    }

    /// Makes it that from a time (s) on.
    pub(crate) fn go_to(&mut self, simulation: &Simulation, time: f64) -> Result<(), SetupError> {
        let now = held(simulation, time);
        if now == self.held {
            return Ok(());
        }
        if let Some(held) = &now {
            self.body = whole_body(&simulation.holding(held)?, self.by_impulses)?;
        }
        self.held = now;
        Ok(())
    }
}

impl Pass {
    /// The times (s) at which something is taken hold of or let go.
    pub(crate) fn carry_breaks(&self) -> impl Iterator<Item = f64> {
        let loads = self.simulation.carries.iter().flat_map(|carry| [carry.from, carry.until]);
        loads.chain(self.simulation.loops.iter().flat_map(|closed| [closed.from, closed.until]))
    }

    /// Makes the whole figure, with what it holds, anew after other laws were set.
    pub(crate) fn rebuild(&mut self) -> Result<(), RunError> {
        if let Some(held) = &self.held {
            self.loaded = Some(Box::new(self.simulation.holding(held)?));
        }
        self.body = whole_body(self.loaded.as_deref().unwrap_or(&self.simulation), self.by_impulses())?;
        Ok(())
    }

    /// Takes hold of what is due, and lets go of it.
    pub(crate) fn carry(&mut self) -> Result<(), RunError> {
        let now = held(&self.simulation, self.t);
        if now == self.held {
            return Ok(());
        }
        let Some(held) = &now else { return Ok(()) };
        let (loaded, by_impulses) = (self.simulation.holding(held)?, self.by_impulses());
        let mut old = std::mem::replace(&mut self.body, whole_body(&loaded, by_impulses)?);
        self.loaded = Some(Box::new(loaded));
        self.forget_phase();
        let Some(before) = std::mem::replace(&mut self.held, now.clone()) else { return Ok(()) };
        let changed = |before: &[bool], now: &[bool], to: bool| -> Vec<usize> {
            (0..now.len()).filter(|i| before[*i] != to && now[*i] == to).collect()
        };
        let taken = changed(&before.loads, &held.loads, true);
        let left = changed(&before.loads, &held.loads, false);
        let closed = changed(&before.loops, &held.loops, true);
        let opened = changed(&before.loops, &held.loops, false);
        self.passed.jumps = true;
        for (carries, which) in [("takes up", &taken), ("lets go of", &left)] {
            for &i in which {
                let Load { link, mass, .. } = self.simulation.carries[i].load;
                let what = format!("{}: {carries} {mass} kg", self.simulation.figure.links()[link].name());
                self.say(what);
            }
        }
        for (holds, which) in [("takes hold of", &closed), ("lets go of", &opened)] {
            for &i in which {
                let [first, second] = closing::links(&self.simulation, &self.simulation.loops[i].between);
                self.say(format!("{first}: {holds} {second}"));
            }
        }
        if !by_impulses {
            self.check_closed(&closed)?;
        }
        // By impulses loops take their velocity in the step that follows.
        if taken.is_empty() && (closed.is_empty() || by_impulses) {
            Ok(())
        } else {
            self.take_up(&mut old, &taken)
        }
    }

    fn say(&mut self, what: String) {
        self.passed.record.events.push(Event { time: self.t, kind: EventKind::DriveChange { what } });
    }

    /// Forces would throw together what is far apart.
    fn check_closed(&mut self, closed: &[usize]) -> Result<(), RunError> {
        if closed.is_empty() {
            return Ok(());
        }
        self.body.velocities(&self.q, &self.v).map_err(|error| guard::of_dynamics(self.t, error))?;
        for &i in closed {
            let between = &self.simulation.loops[i].between;
            let apart = closing::apart(&self.body, between);
            if apart > OPEN {
                let links = closing::links(&self.simulation, between);
                return Err(SetupError::FarLoop { links, time: self.t, apart }.into());
            }
        }
        Ok(())
    }

    /// The impact in which loads that stood still are taken up, and loops close; `old` is the figure before.
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
