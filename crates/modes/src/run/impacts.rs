//! Jumps of the velocities: joints that are stopped, limits that are hit, and what rests at a limit.

use super::driven::{Meaning, Mode};
use super::guard;
use super::pass::Pass;
use crate::failure::RunError;
use crate::impact::{Side, Struck, Wanted, strike};
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

/// A degree of freedom that is at a limit: which, on which side, and where (rad or m).
type AtLimit = (usize, Side, f64);

impl Pass {
    /// Stops what has to stand still, turns back what has hit its limit, and lets go what a limit would have to pull.
    pub(crate) fn settle(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        let mut stopped: Vec<usize> = Vec::new();
        for (dof, driven) in self.driven.iter().enumerate() {
            if matches!(driven.mode, Mode::Still)
                && self.v[dof].abs() > REST
                && !self.simulation.figure.follows(dof)
            {
                stopped.push(dof);
            }
        }
        for event in events {
            if let Meaning::Release(dof, _) = *event {
                self.driven[dof].held = None;
                self.passed.jumps = true;
            }
        }
        let at_limits = self.at_limits(events);
        // One impact may bring about others: a row of links that meets its end.
        for round in 0..=MOST_IMPACTS {
            let inelastic = round == MOST_IMPACTS;
            let mut strikes: Vec<(usize, Wanted, &'static str)> =
                stopped.drain(..).map(|dof| (dof, Wanted::Velocity(0.0), "stop")).collect();
            for &(dof, side, limit) in &at_limits {
                let least = if round == 0 { 0.0 } else { REST };
                let LimitLaw::Hard { restitution } = self.simulation.limits[dof] else { continue };
                let hits = self.v[dof] * side.outward() > least && self.driven[dof].held.is_none();
                if hits {
                    let kept = if inelastic { 0.0 } else { restitution };
                    strikes.push((dof, Wanted::Limit(side, -kept * self.v[dof]), "limit"));
                }
                if (hits || self.v[dof] * side.outward() >= 0.0)
                    && let Some(coordinate) = self.simulation.figure.layout().coordinate(dof)
                {
                    self.q[coordinate] = limit;
                }
                if hits && !self.driven[dof].hit {
                    self.driven[dof].hit = true;
                    self.outcome(dof, OutcomeKind::LimitHit);
                }
            }
            if strikes.is_empty() {
                break;
            }
            // Limits that something rests at stop it, as do those without restitution that it touches.
            for &(dof, side, _) in &at_limits {
                let stops = inelastic
                    || self.driven[dof].held.is_some()
                    || self.simulation.limits[dof] == LimitLaw::Hard { restitution: 0.0 };
                if stops && strikes.iter().all(|(other, ..)| *other != dof) {
                    strikes.push((dof, Wanted::Limit(side, 0.0), "rest"));
                }
            }
            self.strike(&strikes)?;
        }
        if at_limits.is_empty() { Ok(()) } else { self.rest(events) }
    }

    /// All that dynamics move, or would if it were not held, and that is at a hard limit.
    fn at_limits(&self, events: &[Meaning]) -> Vec<AtLimit> {
        (0..self.driven.len()).filter_map(|dof| self.at_limit(dof, events)).collect()
    }

    /// The limit at which a degree of freedom is.
    fn at_limit(&self, dof: usize, events: &[Meaning]) -> Option<AtLimit> {
        if let Some((side, limit)) = self.driven[dof].held {
            return Some((dof, side, limit));
        }
        if self.driven[dof].role() != Role::Dynamic
            || self.simulation.figure.follows(dof)
            || self.by_impulses()
            || !matches!(self.simulation.limits[dof], LimitLaw::Hard { .. })
        {
            return None;
        }
        let limits = self.limits_of(dof)?;
        let coordinate = self.simulation.figure.layout().coordinate(dof)?;
        let sides = [(Side::Lower, limits.lower), (Side::Upper, limits.upper)];
        sides.into_iter().filter(|(_, limit)| limit.is_finite()).find_map(|(side, limit)| {
            let told = events.contains(&Meaning::Limit(dof, side));
            let there = told || (self.q[coordinate] - limit).abs() <= AT_LIMIT * (1.0 + limit.abs());
            there.then_some((dof, side, limit))
        })
    }

    /// Gives degrees of freedom new velocities, and all others what follows from it.
    fn strike(&mut self, strikes: &[(usize, Wanted, &'static str)]) -> Result<(), RunError> {
        let fixed: Vec<bool> = (0..self.driven.len())
            .map(|dof| {
                let prescribed = self.driven[dof].role() != Role::Dynamic && self.driven[dof].held.is_none();
                prescribed || self.simulation.figure.follows(dof)
            })
            .collect();
        let mut wanted: Vec<(usize, Wanted)> = strikes.iter().map(|&(dof, what, _)| (dof, what)).collect();
        // What follows a leader that is stopped is stopped with it.
        for follower in self.simulation.figure.followers() {
            let leader = wanted.iter().find(|(dof, _)| *dof == follower.leader);
            if let Some(&(_, Wanted::Velocity(velocity))) = leader {
                let slope = follower.curve.at(self.q[follower.leader_coordinate])[1];
                wanted.push((follower.dof, Wanted::Velocity(slope * velocity)));
            }
        }
        let struck = strike(&mut self.body, &self.q, &self.v, &fixed, &wanted)
            .map_err(|error| guard::of_dynamics(self.t, error))?;
        self.passed.counts.evaluations += 1;
        self.passed.jumps = true;
        for &(dof, _, what) in strikes.iter().filter(|(.., what)| *what != "rest") {
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
        self.take_velocities(struck);
        Ok(())
    }

    /// Takes the velocities after an impact.
    pub(crate) fn take_velocities(&mut self, struck: Struck) {
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
    }

    /// Of what is at a limit, what stays there: what would otherwise go out of its range, at once or after a flight too short to
    /// be one. With `δ` half of the shortest flight, and outwards positive, each has
    ///
    /// ```text
    /// v + δ·a ≤ 0 and the limit's force inwards, one of them zero        M·a + h = τ + f
    /// ```
    ///
    /// for from `v < 0` it is back after `−2·v/a`. One that stays may press on others and make them stay, or lift them off: a linear
    /// complementarity problem with a positive definite matrix, in which the first that is wrong is turned round until none is, as
    /// for [impacts](strike). What stays with a velocity then loses it by an impulse.
    pub(crate) fn rest(&mut self, events: &[Meaning]) -> Result<(), RunError> {
        const DELTA: f64 = 0.5 * SHORTEST_FLIGHT;
        let released =
            |dof: usize| events.iter().any(|event| matches!(event, Meaning::Release(of, _) if *of == dof));
        let candidates: Vec<AtLimit> =
            self.at_limits(events).into_iter().filter(|(dof, ..)| !released(*dof)).collect();
        if candidates.is_empty() {
            return Ok(());
        }
        // What was pulled is not taken for still again.
        let mut pulled: Vec<usize> = Vec::new();
        for _ in 0..1_usize << candidates.len().min(MOST_CHOICES) {
            let (prescribed, mut a, mut tau) = self.given();
            for &(dof, ..) in candidates.iter().filter(|(dof, ..)| self.driven[*dof].held.is_some()) {
                a[dof] = -self.v[dof] / DELTA;
            }
            let drive = tau.clone();
            self.body
                .hybrid(&self.q, &self.v, &prescribed, &mut a, &mut tau)
                .map_err(|error| RunError::from(guard::of_dynamics(self.t, error)))?;
            self.passed.counts.evaluations += 1;
            let rounding = |x: &[f64]| ROUNDING * x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let (least_force, least) = (rounding(&tau), rounding(&a));
            self.cap = f64::INFINITY;
            let mut wrong = None;
            for &(dof, side, limit) in &candidates {
                if self.driven[dof].held.is_some() {
                    // A limit pushes inwards only.
                    if (tau[dof] - drive[dof]) * side.outward() > least_force {
                        wrong = Some((dof, None));
                        pulled.push(dof);
                        break;
                    }
                    continue;
                }
                let (away, outwards) = (-self.v[dof] * side.outward(), a[dof] * side.outward());
                // What is not accelerated and stands still stays until something pulls it away, unless it would rather
                // rebound from what strikes it.
                let stays = self.simulation.limits[dof] == LimitLaw::Hard { restitution: 0.0 }
                    || events.contains(&Meaning::Limit(dof, side));
                let is_still =
                    outwards.abs() <= least && away.abs() <= REST && stays && !pulled.contains(&dof);
                if is_still || (outwards > least && DELTA * outwards > away) {
                    wrong = Some((dof, Some((side, limit))));
                    break;
                }
                if outwards > least {
                    // The next step has to see it off its limit.
                    self.cap = self.cap.min(self.t + away / outwards);
                }
            }
            let Some((dof, held)) = wrong else { break };
            self.driven[dof].held = held;
            self.passed.jumps |= held.is_some();
        }
        self.stop_what_stays(&candidates)
    }

    /// What stays at its limit, of what is at one, comes to rest there; nothing else goes out of its range for that.
    fn stop_what_stays(&mut self, candidates: &[AtLimit]) -> Result<(), RunError> {
        let stays = |dof: usize| self.driven[dof].held.is_some();
        if candidates.iter().all(|(dof, ..)| !stays(*dof) || self.v[*dof] == 0.0) {
            return Ok(());
        }
        let strikes: Vec<(usize, Wanted, &'static str)> = candidates
            .iter()
            .map(|&(dof, side, _)| {
                let wanted = if stays(dof) { Wanted::Velocity(0.0) } else { Wanted::Limit(side, 0.0) };
                (dof, wanted, "rest")
            })
            .collect();
        self.strike(&strikes)?;
        for &(dof, _, limit) in candidates {
            if let Some(coordinate) = self.simulation.figure.layout().coordinate(dof)
                && self.driven[dof].held.is_some()
            {
                (self.q[coordinate], self.v[dof]) = (limit, 0.0);
            }
        }
        Ok(())
    }
}
