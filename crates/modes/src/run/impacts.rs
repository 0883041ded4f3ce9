//! Jumps of the velocities: joints that are stopped, limits that are hit, and what rests at a limit.

use super::driven::{Meaning, Mode};
use super::guard;
use super::pass::Pass;
use crate::failure::RunError;
use crate::impact::{Side, strike};
use crate::phase::Role;
use crate::report::Impact;
use crate::{EndCondition, LimitLaw, OutcomeKind};

/// A flight shorter than this (s) is none: the degree of freedom rests at its limit.
const SHORTEST_FLIGHT: f64 = 1e-6;

/// A velocity (rad/s or m/s) below which what is to stand still does.
const REST: f64 = 1e-12;

/// Rounds of impacts at one instant, after which what touches stays together: elastic ones may go back and forth without end.
const MOST_IMPACTS: usize = 50;

/// Forces and accelerations smaller than this part of the greatest are none.
const ROUNDING: f64 = 1e-12;

/// As many bodies at their limits have each way of staying or going tried, if it comes to that.
const MOST_CHOICES: usize = 12;

/// Positions (rad or m) this near to a limit are at it.
const AT_LIMIT: f64 = 1e-9;

impl Pass<'_> {
    /// Stops what has to stand still, turns back what has hit its limit, and lets go what a limit would have to pull.
    pub(crate) fn settle(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        let mut wanted: Vec<(usize, f64, &'static str)> = Vec::new();
        for (dof, driven) in self.driven.iter().enumerate() {
            if matches!(driven.mode, Mode::Still)
                && self.v[dof].abs() > REST
                && !self.simulation.figure.follows(dof)
            {
                wanted.push((dof, 0.0, "stop"));
            }
        }
        let mut hits: Vec<(usize, Side, f64)> = Vec::new();
        for event in events {
            if let Meaning::Release(dof, _) = *event {
                self.driven[dof].held = None;
                self.passed.jumps = true;
            }
        }
        // One impact may bring about others: a row of links that meets its end.
        for round in 0..=MOST_IMPACTS {
            let inelastic = round == MOST_IMPACTS;
            for dof in 0..self.driven.len() {
                let Some((side, limit)) = self.meets_limit(dof, events) else { continue };
                if hits.iter().all(|(other, ..)| *other != dof) {
                    hits.push((dof, side, limit));
                }
                let least = if round == 0 { 0.0 } else { REST };
                if self.v[dof] * side.outward() > least {
                    let LimitLaw::Hard { restitution } = self.simulation.limits[dof] else { continue };
                    let kept = if inelastic { 0.0 } else { restitution };
                    wanted.push((dof, -kept * self.v[dof], "limit"));
                }
            }
            for &(dof, _, limit) in &hits {
                if let Some(coordinate) = self.simulation.figure.layout().coordinate(dof) {
                    self.q[coordinate] = limit;
                }
                let is_struck = wanted.iter().any(|(other, _, what)| *other == dof && *what == "limit");
                if is_struck && !self.driven[dof].hit {
                    self.driven[dof].hit = true;
                    self.outcome(dof, OutcomeKind::LimitHit);
                }
            }
            if wanted.is_empty() {
                break;
            }
            self.strike(&wanted, inelastic, events)?;
            wanted.clear();
        }
        // A drive that has changed may lift off what rests.
        let rests = self.driven.iter().any(|driven| driven.held.is_some());
        if hits.is_empty() && !rests { Ok(()) } else { self.rest(&hits, events) }
    }

    /// The limit at which a degree of freedom that dynamics move is, if it does not move away from it.
    fn meets_limit(&self, dof: usize, events: &[Meaning]) -> Option<(Side, f64)> {
        if self.driven[dof].role() != Role::Dynamic
            || !matches!(self.simulation.limits[dof], LimitLaw::Hard { .. })
        {
            return None;
        }
        let limits = self.limits_of(dof)?;
        let coordinate = self.simulation.figure.layout().coordinate(dof)?;
        let released = events.iter().any(|event| matches!(event, Meaning::Release(of, _) if *of == dof));
        [(Side::Lower, limits.lower), (Side::Upper, limits.upper)].into_iter().find(|&(side, limit)| {
            let told = events.contains(&Meaning::Limit(dof, side));
            let there = told || (self.q[coordinate] - limit).abs() <= AT_LIMIT * (1.0 + limit.abs());
            let outward = self.v[dof] * side.outward();
            there && limit.is_finite() && !released && outward >= 0.0
        })
    }

    /// Gives degrees of freedom new velocities, and all others what follows from it.
    ///
    /// Limits that something rests at stop it, as do those without restitution that it touches; with `inelastic`, all that it
    /// touches.
    fn strike(
        &mut self,
        wanted: &[(usize, f64, &'static str)],
        inelastic: bool,
        events: &[Meaning],
    ) -> Result<(), RunError> {
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
            .filter_map(|(dof, driven)| {
                let stops = inelastic || self.simulation.limits[dof] == LimitLaw::Hard { restitution: 0.0 };
                let contact_points = || self.meets_limit(dof, events).filter(|_| stops);
                Some((dof, driven.held.or_else(contact_points)?.0))
            })
            .filter(|(dof, _)| wanted.iter().all(|(other, ..)| other != dof))
            .collect();
        let mut jumps: Vec<(usize, f64)> = wanted.iter().map(|&(dof, velocity, _)| (dof, velocity)).collect();
        // What follows a leader that is stopped is stopped with it.
        for follower in self.simulation.figure.followers() {
            if let Some(&(_, velocity)) = jumps.iter().find(|(dof, _)| *dof == follower.leader) {
                let slope = follower.curve.at(self.q[follower.leader_coordinate])[1];
                jumps.push((follower.dof, slope * velocity));
            }
        }
        let struck = strike(&mut self.body, &self.q, &self.v, &fixed, &held, &jumps)
            .map_err(|error| guard::of_dynamics(self.t, error))?;
        self.passed.counts.evaluations += 1;
        self.passed.jumps = true;
        for &(dof, _, what) in wanted {
            let (velocity_before, velocity_after) = (self.v[dof], struck.v[dof]);
            let (layout, impulse) = (self.simulation.figure.layout(), struck.impulse[dof]);
            // −½·P·(v⁺ + v⁻): over all degrees of freedom, what the figure loses.
            let loss = -0.5 * impulse * (velocity_before + velocity_after);
            self.passed.impacts.push(Impact {
                time: self.t,
                dof,
                name: layout.v_names()[dof].clone(),
                axis_kind: layout.axis_kind(dof),
                what,
                velocity_before,
                velocity_after,
                impulse,
                loss,
            });
        }
        self.passed.ledger.lose(struck.loss);
        for dof in struck.released {
            self.driven[dof].held = None;
        }
        for (dof, driven) in self.driven.iter().enumerate() {
            let step = self.simulation.drives[dof].get(driven.step);
            if let Some(EndCondition::Velocity { dof: name, value }) = step.map(|step| &step.until)
                && let Some(of) = self.simulation.figure.layout().dof_index(name)
                && (self.v[of] - value) * (struck.v[of] - value) <= 0.0
                && self.v[of].to_bits() != struck.v[of].to_bits()
            {
                self.leapt.push(Meaning::DriveEnds(dof));
            }
        }
        self.v.copy_from_slice(&struck.v);
        Ok(())
    }

    /// Of what is at a limit, what stays there: what would go out of its range, and what its limit has not to pull.
    ///
    /// One that stays may press on others and make them stay, or lift them off, so this is a linear complementarity problem;
    /// the first that is wrong is turned round until none is, as for [impacts](strike).
    pub(crate) fn rest(&mut self, hits: &[(usize, Side, f64)], events: &[Meaning]) -> Result<(), RunError> {
        let count = hits.len() + self.driven.iter().filter(|driven| driven.held.is_some()).count();
        for _ in 0..1_usize << count.min(MOST_CHOICES) {
            let (prescribed, mut a, mut tau) = self.given();
            let drive = tau.clone();
            self.body
                .hybrid(&self.q, &self.v, &prescribed, &mut a, &mut tau)
                .map_err(|error| RunError::from(guard::of_dynamics(self.t, error)))?;
            self.passed.counts.evaluations += 1;
            let rounding = |x: &[f64]| ROUNDING * x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let (least_force, least) = (rounding(&tau), rounding(&a));
            self.cap = f64::INFINITY;
            let mut wrong = None;
            for dof in 0..self.driven.len() {
                if let Some((side, _)) = self.driven[dof].held {
                    // A limit pushes inwards only.
                    if (tau[dof] - drive[dof]) * side.outward() > least_force {
                        wrong = Some((dof, None));
                        break;
                    }
                } else if let Some(&(_, side, limit)) = hits.iter().find(|(hit, ..)| *hit == dof) {
                    let (away, outwards) = (-self.v[dof] * side.outward(), a[dof] * side.outward());
                    // What is not accelerated and stands still stays until something pulls it away, unless it would
                    // rather rebound from what strikes it.
                    let stays = self.simulation.limits[dof] == LimitLaw::Hard { restitution: 0.0 }
                        || events.contains(&Meaning::Limit(dof, side));
                    if outwards < -least || (outwards <= least && (away > REST || !stays)) {
                        continue;
                    }
                    let flight = if outwards > least { 2.0 * away.max(0.0) / outwards } else { 0.0 };
                    if flight < SHORTEST_FLIGHT {
                        wrong = Some((dof, Some((side, limit))));
                        break;
                    }
                    // The next step has to see it off its limit.
                    self.cap = self.cap.min(self.t + 0.5 * flight);
                }
            }
            let Some((dof, held)) = wrong else { break };
            self.driven[dof].held = held;
            if held.is_some() {
                self.v[dof] = 0.0;
                self.passed.jumps = true;
            }
        }
        Ok(())
    }
}
