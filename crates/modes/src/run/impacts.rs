//! Jumps of the velocities: joints that are stopped, limits that are hit, and what rests at a limit.

use super::driven::Mode;
use super::guard;
use super::pass::{Meaning, Pass};
use crate::impact::{Side, strike};
use crate::phase::Role;
use crate::report::Impact;
use crate::trouble::RunError;
use crate::{LimitLaw, OutcomeKind};

/// A flight shorter than this (s) is none: the degree of freedom rests at its limit.
const SHORTEST_FLIGHT: f64 = 1e-6;

/// A velocity (rad/s or m/s) below which what is to stand still does.
const REST: f64 = 1e-12;

/// Positions (rad or m) this near to a limit are at it.
const AT_LIMIT: f64 = 1e-9;

impl Pass<'_> {
    /// Stops what has to stand still, turns back what has hit its limit, and lets go what a limit would have to pull.
    pub(crate) fn settle(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        let mut wanted: Vec<(usize, f64, &'static str)> = Vec::new();
        for (dof, driven) in self.driven.iter().enumerate() {
            if matches!(driven.mode, Mode::Still) && self.v[dof].abs() > REST && !self.simulation.figure.follows(dof) {
                wanted.push((dof, 0.0, "stop"));
            }
        }
        let mut hits: Vec<(usize, Side, f64)> = Vec::new();
        for event in events {
            if let Meaning::Release(dof) = *event {
                self.driven[dof].held = None;
                self.passed.jumps = true;
            }
        }
        for dof in 0..self.driven.len() {
            if let Some((side, limit)) = self.meets_limit(dof, events) {
                hits.push((dof, side, limit));
                if self.v[dof] * side.outward() > 0.0 {
                    let LimitLaw::Hard { restitution } = self.simulation.limits[dof] else { continue };
                    wanted.push((dof, -restitution * self.v[dof], "limit"));
                }
            }
        }
        for &(dof, _, limit) in &hits {
            if let Some(coordinate) = self.simulation.figure.layout().coordinate(dof) {
                self.q[coordinate] = limit;
            }
            if !self.driven[dof].hit {
                self.driven[dof].hit = true;
                self.outcome(dof, OutcomeKind::LimitHit);
            }
        }
        if !wanted.is_empty() {
            self.strike(&wanted)?;
        }
        if hits.is_empty() { Ok(()) } else { self.rest(&hits) }
    }

    /// The limit at which a degree of freedom that dynamics move is, if it does not move away from it.
    fn meets_limit(&self, dof: usize, events: &[Meaning]) -> Option<(Side, f64)> {
        if self.driven[dof].role() != Role::Dynamic || !matches!(self.simulation.limits[dof], LimitLaw::Hard { .. }) {
            return None;
        }
        let limits = self.limits_of(dof)?;
        let coordinate = self.simulation.figure.layout().coordinate(dof)?;
        let released = events.contains(&Meaning::Release(dof));
        [(Side::Lower, limits.lower), (Side::Upper, limits.upper)].into_iter().find(|&(side, limit)| {
            let told = events.contains(&Meaning::Limit(dof, side));
            let there = told || (self.q[coordinate] - limit).abs() <= AT_LIMIT * (1.0 + limit.abs());
            let outward = self.v[dof] * side.outward();
            there && limit.is_finite() && !released && outward >= 0.0
        })
    }

    /// Gives degrees of freedom new velocities, and all others what follows from it.
    fn strike(&mut self, wanted: &[(usize, f64, &'static str)]) -> Result<(), RunError> {
        let fixed: Vec<bool> = (0..self.driven.len())
            .map(|dof| {
                let prescribed = self.driven[dof].role() != Role::Dynamic && self.driven[dof].held.is_none();
                prescribed || self.simulation.figure.follows(dof)
            })
            .collect();
        let held: Vec<(usize, Side)> = self
            .driven
            .iter()
            .enumerate()
            .filter_map(|(dof, driven)| Some((dof, driven.held?.0)))
            .filter(|(dof, _)| wanted.iter().all(|(other, ..)| other != dof))
            .collect();
        let jumps: Vec<(usize, f64)> = wanted.iter().map(|&(dof, velocity, _)| (dof, velocity)).collect();
        let struck = strike(&mut self.body, &self.q, &self.v, &fixed, &held, &jumps)
            .map_err(|error| guard::of_dynamics(self.t, error))?;
        self.passed.counts.evaluations += 1;
        self.passed.jumps = true;
        let share = struck.loss / wanted.len() as f64;
        for &(dof, _, what) in wanted {
            self.passed.impacts.push(Impact {
                time: self.t,
                dof,
                what,
                velocity: (self.v[dof], struck.v[dof]),
                impulse: struck.impulse[dof],
                loss: share,
            });
        }
        self.passed.ledger.report.impacts += struck.loss;
        for dof in struck.released {
            self.driven[dof].held = None;
        }
        self.v.copy_from_slice(&struck.v);
        Ok(())
    }

    /// Of what is at a limit, what stays there.
    fn rest(&mut self, hits: &[(usize, Side, f64)]) -> Result<(), RunError> {
        // First with all of them free: how they would go on.
        let (prescribed, mut a, mut tau) = self.given();
        let failed = |t, error| RunError::from(guard::of_dynamics(t, error));
        self.body.hybrid(&self.q, &self.v, &prescribed, &mut a, &mut tau).map_err(|e| failed(self.t, e))?;
        self.passed.counts.evaluations += 1;
        for &(dof, side, limit) in hits {
            let (away, outwards) = (-self.v[dof] * side.outward(), a[dof] * side.outward());
            let flight = if outwards > 0.0 { 2.0 * away.max(0.0) / outwards } else { f64::INFINITY };
            if outwards > 0.0 && flight < SHORTEST_FLIGHT {
                self.driven[dof].held = Some((side, limit));
                self.v[dof] = 0.0;
                self.passed.jumps = true;
            } else if flight.is_finite() {
                // The next step has to see it off its limit.
                self.cap = self.cap.min(self.t + 0.5 * flight);
            }
        }
        self.release_pulled()
    }

    /// Lets go what a limit would have to pull, now that others rest as well.
    fn release_pulled(&mut self) -> Result<(), RunError> {
        for _ in 0..=self.driven.len() {
            let (prescribed, mut a, mut tau) = self.given();
            let drive = tau.clone();
            self.body
                .hybrid(&self.q, &self.v, &prescribed, &mut a, &mut tau)
                .map_err(|error| RunError::from(guard::of_dynamics(self.t, error)))?;
            self.passed.counts.evaluations += 1;
            // A limit pushes inwards only.
            let pulls = |(dof, driven): (usize, &super::driven::Driven)| {
                let (side, _) = driven.held?;
                ((tau[dof] - drive[dof]) * side.outward() > 0.0).then_some(dof)
            };
            let Some(dof) = self.driven.iter().enumerate().find_map(pulls) else { break };
            self.driven[dof].held = None;
        }
        Ok(())
    }
}
