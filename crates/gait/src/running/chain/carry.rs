//! The whole force over a chain of steps and the way of the centre of mass under it.

mod trunk;

use super::basis::{Basis, Expected, LIFTS, Priors};
use super::fit::Fit;
use super::footstep::Footstep;
use super::seam::{MET, Seam};
use super::step_forces::{StepForces, pressures, sign};
use super::stood::STANDING_PRESSURE;
use crate::body::Body;
use crate::body::foot::FootPlane;
use crate::body::rotations::Euler;
use crate::grid::{Ends, Grid};
use crate::running::forces::trunk_inertia;
use crate::running::laws::TWIST;
use crate::running::open::Open;
use crate::walking::G;
use nalgebra::Vector3;
use trunk::{Column, Fitted};

/// How exactly the centre of mass is as high at a contact as the leg wants it (m).
const HEIGHT_SPREAD: f64 = 0.004;
/// What is not to differ at all does so by this (m, m/s, rad, N m and N m s over the trunk's inertia).
const EXACT: f64 = 1e-6;

/// Whether the chain begins and ends in standing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stands {
    pub(super) first: bool,
    pub(super) last: bool,
}

/// The laws over the nodes of a chain, for amplitudes that are still open.
pub(super) struct Laws<'a> {
    body: &'a Body,
    steps: &'a [Footstep],
    stands: Stands,
    /// With the walks before and after it.
    seams: [Option<&'a Seam>; 2],
    grid: Grid,
    priors: Vec<Priors>,
    start: f64,
    step: f64,
    open: Open,
    plane: FootPlane,
    /// Which step stands at a node, with its laws there.
    at: Vec<Option<(usize, Basis)>>,
    /// The nodes of each step: from the first to after the last.
    spans: Vec<(usize, usize)>,
    /// Of each step.
    waves: Vec<Waves>,
    /// Of the trunk: pitch, yaw, roll.
    inertia: Vector3<f64>,
}

/// The motion under forces.
pub(super) struct Carried {
    pub(super) forces: Vec<StepForces>,
    pub(super) com: Vec<Vector3<f64>>,
    /// How much less far each step goes than at the speed of the flight after it, by its braking and pushing (m).
    pub(super) lost: Vec<f64>,
    /// Rate of the angular momentum about it (N m).
    pub(super) rate: Vec<Vector3<f64>>,
    /// By how much the trunk turns (rad) to where that asks for it, about z, y, x.
    pub(super) turn: Option<Vec<Euler>>,
}

/// The body as the pass before left it.
pub(super) struct Before<'a> {
    pub(super) momentum: &'a [Vector3<f64>],
    pub(super) thorax: &'a [Euler],
    pub(super) drawn: &'a [Euler],
}

/// A force (N) for an amplitude of 1 over a step's nodes, and the way (m) that it makes from there on.
struct Wave {
    force: Vec<f64>,
    way: Vec<f64>,
}

/// The waves of a step's forces that have an amplitude.
#[derive(Default)]
struct Waves {
    lifts: Vec<Wave>,
    fore_aft: Vec<Wave>,
    lateral: Vec<Wave>,
}

impl<'a> Laws<'a> {
    pub(super) fn new(
        body: &'a Body,
        steps: &'a [Footstep],
        stands: Stands,
        seams: [Option<&'a Seam>; 2],
        start: f64,
        step: f64,
        nodes: usize,
    ) -> Self {
        let at: Vec<Option<(usize, Basis)>> = (0..nodes)
            .map(|i| {
                let time = start + step * i as f64;
                let found = steps.iter().position(|footstep| footstep.stands(time))?;
                Some((found, steps[found].basis(time)))
            })
            .collect();
        let stood = |i: usize, k: usize| at[i].as_ref().is_some_and(|(at, _)| *at == k);
        let spans = (0..steps.len()).map(|k| {
            let from = (0..nodes).find(|&i| stood(i, k)).unwrap_or(0);
            (from, (from..nodes).rfind(|&i| stood(i, k)).map_or(from, |last| last + 1))
        });
        let mut laws = Self {
            waves: Vec::new(),
            spans: spans.collect(),
            at,
            plane: FootPlane::new(steps[0].style.foot_yaw),
            open: Open::new(step),
            inertia: trunk_inertia(body),
            priors: steps.iter().map(Footstep::priors).collect(),
            body,
            steps,
            stands,
            seams,
            grid: Grid { count: nodes, step, ends: Ends::Open },
            start,
            step,
        };
        // No pass changes them.
        laws.waves = (0..steps.len())
            .map(|k| {
                let some =
                    |expected: &[Expected]| expected.iter().take_while(|(_, spread)| *spread > 0.0).count();
                let (side, priors) = (sign(steps[k].side), &laws.priors[k]);
                Waves {
                    lifts: (0..some(&priors.lifts)).map(|n| laws.wave(k, |basis| basis.lifts[n])).collect(),
                    fore_aft: (0..some(&priors.fore_aft))
                        .map(|n| laws.wave(k, |basis| basis.fore_aft[n]))
                        .collect(),
                    lateral: (0..some(&priors.lateral))
                        .map(|n| laws.wave(k, |basis| side * basis.lateral[n]))
                        .collect(),
                }
            })
            .collect();
        laws
    }

    fn nodes(&self) -> usize {
        self.at.len()
    }

    fn weight(&self) -> f64 {
        self.body.mass * G
    }

    /// A value by node from each stance's laws.
    fn each(&self, of: impl Fn(usize, &Basis) -> f64) -> Vec<f64> {
        self.at.iter().map(|at| at.as_ref().map_or(0.0, |(k, basis)| of(*k, basis))).collect()
    }

    fn moved(&self, force: &[f64]) -> Vec<f64> {
        self.open.of_second(&force.iter().map(|force| force / self.body.mass).collect::<Vec<f64>>())
    }

    /// The wave of one step's law.
    fn wave(&self, k: usize, of: impl Fn(&Basis) -> f64) -> Wave {
        let weight = self.weight();
        let force = self.each(|at, basis| if at == k { weight * of(basis) } else { 0.0 });
        Wave { way: self.moved(&force), force }
    }

    /// A value by node at any time within.
    fn value(&self, values: &[f64], time: f64) -> f64 {
        let x = ((time - self.start) / self.step).clamp(0.0, (values.len() - 1) as f64);
        let i = (x as usize).min(values.len() - 2);
        values[i] + (values[i + 1] - values[i]) * (x - i as f64)
    }

    fn time(&self, node: usize) -> f64 {
        self.step * node as f64
    }

    /// Amplitudes of the vertical force, and the height of the centre of mass: at each contact as near as can be to `heights`, and
    /// standing at the first and the last of these.
    pub(super) fn lift(&self, heights: &[f64], last: f64) -> Option<(Vec<f64>, Vec<[f64; LIFTS]>)> {
        let (count, nodes) = (self.steps.len(), self.nodes());
        let mut waves = Vec::new();
        for k in 0..count {
            for (n, &(value, spread)) in self.priors[k].lifts.iter().enumerate() {
                if spread > 0.0 {
                    waves.push((k, n, value, spread, &self.waves[k].lifts[n].way));
                }
            }
        }
        let fixed = self.each(|_, basis| self.weight() * basis.fixed);
        let fall: Vec<f64> =
            self.open.of_second(&fixed.iter().map(|f| f / self.body.mass - G).collect::<Vec<f64>>());
        // Amplitudes, then the height and its rate at the first node.
        let unknowns = waves.len();
        let mut fit = Fit::new(unknowns + 2);
        let row = |time: f64| {
            let mut row: Vec<f64> = waves.iter().map(|(.., way)| self.value(way, time)).collect();
            row.extend([1.0, time - self.start]);
            (row, self.value(&fall, time))
        };
        for (k, footstep) in self.steps.iter().enumerate() {
            if k == 0 && (self.stands.first || self.seams[0].is_some()) {
                continue;
            }
            let (row, fall) = row(footstep.time);
            fit.row(&row, heights[k] - fall, HEIGHT_SPREAD);
        }
        for (k, (_, _, value, spread, _)) in waves.iter().enumerate() {
            fit.expect(k, *value, *spread);
        }
        if self.stands.first {
            let only =
                |at: usize| (0..unknowns + 2).map(|k| if k == at { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
            fit.exactly(&only(unknowns), heights[0]);
            fit.exactly(&only(unknowns + 1), 0.0);
            // Which keeps them determined.
            fit.expect(unknowns, heights[0], 1.0);
            fit.expect(unknowns + 1, 0.0, 1.0);
        }
        if let Some((met, at, rate)) = self.met(1) {
            let mut row: Vec<f64> = waves.iter().map(|(.., way)| self.grid.first(met, |i| way[i])).collect();
            row.extend([0.0, 1.0]);
            fit.exactly(&row, rate.y - self.grid.first(met, |i| fall[i]));
            row = waves.iter().map(|(.., way)| way[met]).collect();
            row.extend([1.0, self.time(met)]);
            fit.exactly(&row, at.y - fall[met]);
        }
        if let Some((_, at, rate)) = self.met(0) {
            let mut row = vec![0.0; unknowns + 2];
            row[unknowns + 1] = 1.0;
            fit.exactly(&row, rate.y - self.grid.first(MET, |i| fall[i]));
            (row[unknowns], row[unknowns + 1]) = (1.0, self.time(MET));
            fit.exactly(&row, at.y - fall[MET]);
            fit.expect(unknowns, heights[0], 1.0);
            fit.expect(unknowns + 1, 0.0, 1.0);
        }
        if self.stands.last {
            let end = self.start + self.time(nodes - 1);
            let ((at, fallen), (before, fallen_before)) = (row(end), row(end - 10.0 * self.step));
            fit.exactly(&at, last - fallen);
            fit.exactly(&before, last - fallen_before);
        }
        let found = fit.solve()?;
        let height = |i: usize| {
            let risen: f64 = waves.iter().zip(&found).map(|((.., way), lift)| lift * way[i]).sum();
            fall[i] + risen + found[unknowns] + found[unknowns + 1] * self.time(i)
        };
        let mut lifts = vec![[0.0; LIFTS]; count];
        for ((k, n, ..), lift) in waves.iter().zip(&found) {
            lifts[*k][*n] = *lift;
        }
        Some(((0..nodes).map(height).collect(), lifts))
    }

    /// The motion under the laws: their amplitudes, and the prints, so that the trunk stays near to what it is drawn to.
    pub(super) fn carry(
        &self,
        height: &[f64],
        lifts: &[[f64; LIFTS]],
        (speed, gains): (f64, &[f64]),
        before: Option<&Before<'_>>,
    ) -> Option<Carried> {
        let nodes = self.nodes();
        let mut forces: Vec<StepForces> = lifts
            .iter()
            .zip(gains)
            .map(|(&lifts, &gain)| StepForces { lifts, gain, ..StepForces::default() })
            .collect();
        let vertical = self.each(|k, basis| self.weight() * forces[k].vertical(basis));
        let (com_z, lost, along) = self.along(height, &vertical, speed, &mut forces, before)?;
        let (com_x, aside) = self.sideways(height, &vertical, &mut forces, before)?;
        let about = self.about(&com_x, &com_z, &mut forces, before)?;
        let turn = match (along.turn, about.turn, aside.turn) {
            (Some(x), Some(y), Some(z)) => Some((0..nodes).map(|i| [z[i], y[i], x[i]]).collect()),
            _ => None,
        };
        Some(Carried {
            forces,
            lost,
            com: (0..nodes).map(|i| Vector3::new(com_x[i], height[i], com_z[i])).collect(),
            rate: (0..nodes).map(|i| Vector3::new(along.rate[i], about.rate[i], aside.rate[i])).collect(),
            turn,
        })
    }

    /// The way of the centre of mass along, how much less far each step goes for its braking and pushing, and the moments: the print of each
    /// step lies so far ahead of where the centre of mass is at its contact as the trunk asks for.
    fn along(
        &self,
        height: &[f64],
        vertical: &[f64],
        speed: f64,
        forces: &mut [StepForces],
        before: Option<&Before<'_>>,
    ) -> Option<(Vec<f64>, Vec<f64>, Fitted)> {
        let (nodes, count, foot) = (self.nodes(), self.steps.len(), self.body.leg.foot_length());
        let given = self.given(forces, 2);
        let way = self.moved(&given);
        let begun = self.begun(&way, 2);
        if let Some((_, speed)) = begun {
            // What carries it out of the walk makes it faster too.
            let (_, left) = self.spans[0];
            forces[0].gain -= speed + self.grid.first(left + 2, |i| way[i]);
        }
        if let Some((met, _, rate)) = self.met(1) {
            // What is missing to the walk's own speed.
            let before: f64 = forces[..count - 1].iter().map(|forces| forces.gain).sum();
            let speed = begun.map_or(speed, |(_, speed)| speed);
            forces[count - 1].gain = rate.z - speed - before - self.grid.first(met, |i| way[i]);
        }
        let faster: Vec<f64> = self
            .each(|k, basis| self.body.mass * forces[k].gain * basis.faster)
            .iter()
            .zip(&given)
            .map(|(faster, given)| faster + given)
            .collect();
        let way = self.moved(&faster);
        let (begin, speed) = self.begun(&way, 2).unwrap_or((0.0, speed));
        let mut com_z: Vec<f64> =
            way.iter().enumerate().map(|(i, way)| begin + way + speed * self.time(i)).collect();
        let contact = |k: usize| self.steps[k].time.max(self.start);
        let at_contact: Vec<f64> = (0..count).map(|k| self.value(&com_z, contact(k))).collect();
        let base: Vec<f64> = (0..nodes)
            .map(|i| {
                let Some((k, basis)) = &self.at[i] else { return 0.0 };
                let pressed =
                    basis.pressure * foot * self.plane.forward.z + basis.outward * self.plane.left.z;
                (com_z[i] - at_contact[*k] - pressed) * vertical[i] - height[i] * faster[i]
            })
            .collect();
        let (mut columns, mut waves) = (Vec::new(), Vec::new());
        for k in 0..count {
            let (from, to) = self.spans[k];
            for (n, &expected) in self.priors[k].fore_aft.iter().enumerate() {
                if expected.1 > 0.0 {
                    let wave = &self.waves[k].fore_aft[n];
                    // It has no impulse: afterwards it has only moved where the prints are.
                    let moment =
                        (from..to).map(|i| wave.way[i] * vertical[i] - height[i] * wave.force[i]).collect();
                    columns.push(Column { from, moment, expected: Some(expected) });
                    waves.push((k, n, columns.len() - 1, wave));
                }
            }
        }
        let mut rolls = Vec::new();
        let mut prints = Vec::new();
        for k in 0..count {
            let (from, to) = self.spans[k];
            for (n, &expected) in self.priors[k].rolls.iter().enumerate() {
                if expected.1 > 0.0 {
                    let along = foot * self.plane.forward.z;
                    let roll = |i: usize| self.at[i].as_ref().map_or(0.0, |(_, basis)| basis.rolls[n]);
                    let moment = (from..to).map(|i| -along * roll(i) * vertical[i]).collect();
                    rolls.push((k, n, columns.len()));
                    columns.push(Column { from, moment, expected: Some(expected) });
                }
            }
            prints.push(columns.len());
            let expected = match self.seams[0] {
                Some(seam) if k == 0 => Some((seam.print.z - at_contact[0], EXACT)),
                // Standing, it presses under the centre of mass.
                _ => (k == 0 && self.stands.first)
                    .then_some((-STANDING_PRESSURE * foot * self.plane.forward.z, EXACT)),
            };
            columns.push(Column { from, moment: (from..to).map(|i| -vertical[i]).collect(), expected });
        }
        let mut rows = Vec::new();
        if let (Some((met, at, _)), Some(seam)) = (self.met(1), self.seams[1]) {
            // In the walk it is where the walk has it over the last print.
            let touches = contact(count - 1);
            let mut row = vec![0.0; columns.len()];
            for (_, _, at, wave) in &waves {
                row[*at] = wave.way[met] - self.value(&wave.way, touches);
            }
            row[prints[count - 1]] = -1.0;
            rows.push((row, at.z - seam.print.z - com_z[met] + at_contact[count - 1]));
        }
        let along = self.fit(0, base, &columns, &rows, before)?;
        for &(k, n, at, wave) in &waves {
            let a = along.amplitudes[at];
            forces[k].fore_aft[n] = a;
            com_z.iter_mut().zip(&wave.way).for_each(|(z, way)| *z += a * way);
        }
        for (k, n, at) in rolls {
            forces[k].rolls[n] = along.amplitudes[at];
        }
        for k in 0..count {
            forces[k].along = self.value(&com_z, contact(k)) + along.amplitudes[prints[k]];
        }
        let mut lost = vec![0.0; count];
        for &(k, _, at, wave) in &waves {
            lost[k] -= along.amplitudes[at] * wave.way[nodes - 1];
        }
        Some((com_z, lost, along))
    }

    /// The way of the centre of mass to the side, and the moments.
    fn sideways(
        &self,
        height: &[f64],
        vertical: &[f64],
        forces: &mut [StepForces],
        before: Option<&Before<'_>>,
    ) -> Option<(Vec<f64>, Fitted)> {
        let (nodes, count) = (self.nodes(), self.steps.len());
        let (weight, foot) = (self.weight(), self.body.leg.foot_length());
        let sides: Vec<f64> = self.steps.iter().map(|footstep| sign(footstep.side)).collect();
        let base = self.each(|k, basis| {
            let pressed =
                forces[k].pressure(basis) * foot * self.plane.forward.x + basis.outward * self.plane.left.x;
            let own = 1.0 - basis.other;
            let out = own * pressed - basis.other * (pressed + 2.0 * self.priors[k].aside.0);
            weight * forces[k].vertical(basis) * sides[k] * out
        });
        let given = self.given(forces, 0);
        let given_way = self.moved(&given);
        let base: Vec<f64> =
            (0..nodes).map(|i| base[i] + height[i] * given[i] - given_way[i] * vertical[i]).collect();
        let (mut columns, mut waves, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for k in 0..count {
            let (from, to) = self.spans[k];
            for (n, &expected) in self.priors[k].lateral.iter().enumerate() {
                if expected.1 > 0.0 {
                    let wave = &self.waves[k].lateral[n];
                    let moment = (from..nodes)
                        .map(|i| height[i] * wave.force[i] - wave.way[i] * vertical[i])
                        .collect();
                    waves.push((k, n, columns.len(), wave));
                    columns.push(Column { from, moment, expected: Some(expected) });
                }
            }
            let of = |i: usize, of: &dyn Fn(&Basis) -> f64| {
                self.at[i].as_ref().map_or(0.0, |(_, basis)| of(basis))
            };
            // The other foot moves with it: they stand as far apart.
            let moment = (from..to).map(|i| sides[k] * vertical[i]).collect();
            let aside = columns.len();
            columns.push(Column { from, moment, expected: Some(self.priors[k].aside) });
            let shift = columns.len();
            if self.priors[k].shift.1 > 0.0 {
                let apart = |i: usize| {
                    let pressed = of(i, &|basis| forces[k].pressure(basis)) * foot * self.plane.forward.x;
                    -sides[k] * 2.0 * (self.priors[k].aside.0 + pressed)
                };
                let moment = (from..to).map(|i| weight * of(i, &|basis| basis.shift) * apart(i)).collect();
                columns.push(Column { from, moment, expected: Some(self.priors[k].shift) });
            }
            others.push((aside, shift));
        }
        // Where the centre of mass begins, and how fast.
        let begin = columns.len();
        let begun = self.begun(&given_way, 0).or(self.stands.first.then_some((0.0, 0.0)));
        columns.push(Column {
            from: 0,
            moment: vertical.iter().map(|force| -force).collect(),
            expected: begun.map(|(at, _)| (at, EXACT)),
        });
        let moment = (0..nodes).map(|i| -self.time(i) * vertical[i]).collect();
        columns.push(Column { from: 0, moment, expected: begun.map(|(_, rate)| (rate, EXACT)) });
        let mut rows = Vec::new();
        if self.stands.last {
            // In the end it is at rest.
            let mut row = vec![0.0; columns.len()];
            let rate = |way: &[f64]| (way[nodes - 1] - way[nodes - 2]) / self.step;
            for (_, _, at, wave) in &waves {
                row[*at] = rate(&wave.way);
            }
            row[begin + 1] = 1.0;
            rows.push((row, -rate(&given_way)));
        }
        if let Some((met, at, rate)) = self.met(1) {
            let mut row = vec![0.0; columns.len()];
            for (_, _, at, wave) in &waves {
                row[*at] = self.grid.first(met, |i| wave.way[i]);
            }
            row[begin + 1] = 1.0;
            rows.push((row, rate.x - self.grid.first(met, |i| given_way[i])));
            let mut row = vec![0.0; columns.len()];
            for (_, _, at, wave) in &waves {
                row[*at] = wave.way[met];
            }
            (row[begin], row[begin + 1]) = (1.0, self.time(met));
            rows.push((row, at.x - given_way[met]));
        }
        let aside = self.fit(2, base, &columns, &rows, before)?;
        let (x0, v0) = (aside.amplitudes[begin], aside.amplitudes[begin + 1]);
        let mut com_x: Vec<f64> = (0..nodes).map(|i| x0 + v0 * self.time(i) + given_way[i]).collect();
        for &(k, n, at, wave) in &waves {
            let a = aside.amplitudes[at];
            forces[k].lateral[n] = a;
            com_x.iter_mut().zip(&wave.way).for_each(|(x, way)| *x += a * way);
        }
        for k in 0..count {
            let (out, shift) = others[k];
            forces[k].aside = aside.amplitudes[out];
            forces[k].other_aside = 2.0 * self.priors[k].aside.0 - forces[k].aside;
            if self.priors[k].shift.1 > 0.0 {
                forces[k].shift = aside.amplitudes[shift];
            }
        }
        Some((com_x, aside))
    }

    /// The node at which the chain agrees with the walk before it or after it, and where the walk's centre of mass is there and how fast.
    fn met(&self, end: usize) -> Option<(usize, Vector3<f64>, Vector3<f64>)> {
        let node = if end == 0 { MET } else { self.nodes() - 1 - MET };
        let (at, rate) = self.seams[end]?.com(self.start + self.time(node));
        Some((node, at, rate))
    }

    /// The force along an axis that is in a walk's direction (N).
    fn given(&self, forces: &[StepForces], axis: usize) -> Vec<f64> {
        self.each(|k, basis| self.weight() * forces[k].vertical(basis) * basis.towards[axis])
    }

    /// Where the centre of mass is at the first node along an axis, and its rate there, where it comes out of a walk; the forces that are
    /// known have moved it by `way` since.
    fn begun(&self, way: &[f64], axis: usize) -> Option<(f64, f64)> {
        let (_, at, rate) = self.met(0)?;
        let rate = rate[axis] - self.grid.first(MET, |i| way[i]);
        Some((at[axis] - way[MET] - rate * self.time(MET), rate))
    }

    /// The free moments.
    fn about(
        &self,
        com_x: &[f64],
        com_z: &[f64],
        forces: &mut [StepForces],
        before: Option<&Before<'_>>,
    ) -> Option<Fitted> {
        let (nodes, count, weight) = (self.nodes(), self.steps.len(), self.weight());
        let base: Vec<f64> = (0..nodes)
            .map(|i| {
                let Some((k, basis)) = &self.at[i] else { return 0.0 };
                let (force, _) = forces[*k].force(self.steps[*k].side, basis);
                let cop = self.pressure(*k, &forces[*k], basis);
                weight * ((cop.z - com_z[i]) * force.x - (cop.x - com_x[i]) * force.z) + basis.given_twist
            })
            .collect();
        let mut columns = Vec::new();
        for k in 0..count {
            let (from, to) = self.spans[k];
            let side = sign(self.steps[k].side);
            for n in 0..TWIST {
                let law = |i: usize| self.at[i].as_ref().map_or(0.0, |(_, basis)| side * basis.twist[n]);
                let moment = (from..to).map(law).collect();
                columns.push(Column { from, moment, expected: Some(self.priors[k].twist[n]) });
            }
        }
        let about = self.fit(1, base, &columns, &[], before)?;
        for (k, forces) in forces.iter_mut().enumerate() {
            forces.twist = std::array::from_fn(|n| about.amplitudes[TWIST * k + n]);
        }
        Some(about)
    }

    /// Where both feet together press.
    fn pressure(&self, k: usize, forces: &StepForces, basis: &Basis) -> Vector3<f64> {
        let (side, foot) = (self.steps[k].side, self.body.leg.foot_length());
        let [own, other] = pressures(&self.plane, foot, side, forces, basis);
        own + (other - own) * forces.other(basis)
    }
}
