//! A chain of running steps that are not all alike, from a given state to another one.

mod basis;
mod bound;
mod carry;
mod fit;
mod footstep;
mod legs;
mod moving;
mod schedule;
mod seam;
mod step_forces;
mod stood;
mod walked;

use super::extremes::{RunExtremes, greatest};
use super::walk_side::WalkSide;
use crate::body::Body;
use crate::body::foot::{FootPlane, mirror};
use crate::body::leg::LegPose;
use crate::body::posture::Posture;
use crate::body::rotations::{self, Euler};
use crate::error::{GaitError, PlanError};
use crate::grid::{Ends, Grid};
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::request::RunResolution;
use crate::walking::{G, Stood};
pub(super) use bound::{Bound, Walked};
use carry::{Before, Carried, Laws};
use legs::Leg;
use nalgebra::Vector3;
pub(super) use schedule::Schedule;
use schedule::Upper;
use solaris_model::Contact;
use solaris_profiles::{ProfileError, UniformSpline};
use step_forces::{StepForces, pressures};

/// Passes in which legs and forces come to terms before the trunk turns, and by which part of its way it turns in a pass then.
const WARM: usize = 8;
const RELAXATION: f64 = 0.4;
/// By which part of what is missing, and by how much at most (m), the height at a contact changes in a pass.
const HEIGHT_GAIN: f64 = 0.7;
const MOST_HEIGHT: f64 = 0.012;
/// Centre of mass against the pelvis' origin before anything is known (m).
const OFFSET: Vector3<f64> = Vector3::new(0.0, 0.06, 0.0);

/// A planned chain of steps.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub(super) body: Body,
    schedule: Schedule,
    forces: Vec<StepForces>,
    legs: [Leg; 2],
    pelvis: UniformSpline<3>,
    thorax: UniformSpline<3>,
    plane: FootPlane,
    /// The first node's time and the nodes' distance (s).
    start: f64,
    step: f64,
    /// What the momentum's rate has more than the law's (N m), and the force that the body needs (N).
    excess: Vec<[Vector3<f64>; 2]>,
}

/// Where the body is: of each leg the hip (as that of a left leg), the pose, and by how much it is too short (m).
struct Place {
    pelvis: Vector3<f64>,
    upper: Upper,
    legs: [(Vector3<f64>, LegPose, f64); 2],
}

/// What a pass found.
struct Pass {
    forces: Vec<StepForces>,
    legs: [Leg; 2],
    pelvis: Vec<Vector3<f64>>,
    /// How far the centre of mass is from where the forces have it.
    off: Vec<Vector3<f64>>,
    momentum: Vec<Vector3<f64>>,
    rate: Vec<Vector3<f64>>,
    turn: Option<Vec<Euler>>,
    thorax: Vec<Euler>,
}

impl Pass {
    /// Moves all of it back along z (m).
    fn back(&mut self, by: f64) {
        self.forces.iter_mut().for_each(|forces| forces.along -= by);
        self.pelvis.iter_mut().for_each(|pelvis| pelvis.z -= by);
        self.legs.iter_mut().for_each(|leg| leg.back(by));
    }
}

fn rows(all: &[Vector3<f64>]) -> Vec<[f64; 3]> {
    all.iter().map(|&row| row.into()).collect()
}

impl Chain {
    pub(super) fn plan(
        body: Body,
        schedule: Schedule,
        resolution: RunResolution,
        contact_height: f64,
    ) -> Result<Self, GaitError> {
        let steps = &schedule.steps;
        let step = steps[0].style.stride_time / resolution.nodes as f64;
        // What is shown begins at a node.
        let (shown, end) = (schedule.shown.0, schedule.end);
        let start = shown - ((shown - schedule.start) / step + 1e-6).floor() * step;
        let n = ((end - start) / step - 1e-6).ceil() as usize + 1;
        let grid = Grid { count: n, step, ends: Ends::Open };
        let time = |i: usize| start + step * i as f64;
        let leg = body.leg;
        let seams = schedule.seams.each_ref().map(Option::as_deref);
        let laws = Laws::new(&body, steps, schedule.stands, seams, start, step, n);
        let walks: Vec<Option<(Posture, f64)>> = (0..n).map(|i| schedule.walks(time(i))).collect();
        let upper_of = |thorax: &[Euler]| {
            let all: Vec<Upper> =
                (0..n).map(|i| schedule.upper(time(i), thorax[i], walks[i].as_ref())).collect();
            UpperBody::new(&body, &grid, |i| all[i].carriage, |i| (all[i].trunk, all[i].arms, 0.0))
        };
        let drawn: Vec<Euler> = (0..n).map(|i| schedule.drawn(time(i), walks[i].as_ref())).collect();
        let mut thorax = drawn.clone();
        let mut upper = upper_of(&thorax);
        let plane = FootPlane::new(steps[0].style.foot_yaw);
        let mut kernel = MomentumKernel::new(&body, &grid, &upper, plane, |_, _| 0.0, |_, _| 0.0);
        let hips: [Vec<Vector3<f64>>; 2] =
            [0, 1].map(|side| (0..n).map(|i| upper.pelvis(i) * body.legs[side][0].offset).collect());
        // Of the centre of mass at each contact, and at rest in the end.
        let mut heights = vec![contact_height; steps.len()];
        let mut standing = contact_height;
        let mut offset = vec![OFFSET; n];
        let mut lost_before = vec![0.0; steps.len()];
        let mut last: Option<Pass> = None;
        for pass in 0..WARM + resolution.passes {
            if let Some(Pass { turn: Some(turn), .. }) = &last {
                for (angles, turn) in thorax.iter_mut().zip(turn) {
                    (0..3).for_each(|k| angles[k] += RELAXATION * turn[k]);
                }
                upper = upper_of(&thorax);
            }
            let before = last.as_ref().filter(|_| pass >= WARM).map(|pass| Before {
                momentum: &pass.momentum,
                thorax: &thorax,
                drawn: &drawn,
            });
            let (speed, gains) = schedule.gains(&lost_before);
            let carried = laws
                .lift(&heights, standing)
                .and_then(|(height, lifts)| laws.carry(&height, &lifts, (speed, &gains), before.as_ref()));
            let Carried { forces, com, lost, rate, turn } = carried.ok_or(PlanError::NoPath)?;
            lost_before.clone_from(&lost);
            let pelvis: Vec<Vector3<f64>> = (0..n).map(|i| com[i] - offset[i]).collect();
            let hip: [Vec<Vector3<f64>>; 2] = [0, 1].map(|side| {
                let hip = |i: usize| pelvis[i] + hips[side][i];
                (0..n).map(|i| if side == 0 { hip(i) } else { mirror(&hip(i)) }).collect()
            });
            let plan = |side: usize| {
                let spline = UniformSpline::resting(start, step, &rows(&hip[side]))?;
                let at = |t: f64| Vector3::from(spline.position(t));
                Leg::plan(&body, side, steps, &forces, seams, &at, (start, step, n))
            };
            let ((left, left_needs), (right, right_needs)) = (plan(0)?, plan(1)?);
            for (k, need) in left_needs.into_iter().chain(right_needs) {
                let height = heights.get_mut(k).unwrap_or(&mut standing);
                if pass > 0 {
                    *height -= (HEIGHT_GAIN * need).clamp(-MOST_HEIGHT, MOST_HEIGHT);
                }
            }
            let legs = [left, right];
            let momentum = kernel.momentum(&upper, |i| match &walks[i] {
                // The walk's, on its side of the seam.
                Some((posture, part)) if *part == 0.0 => posture.legs,
                _ => [0, 1].map(|side| legs[side].pose(&leg, time(i), &hip[side][i])),
            });
            let off = momentum.com.iter().zip(&offset).map(|(found, guessed)| found - guessed).collect();
            offset = momentum.com;
            last = Some(Pass {
                forces,
                legs,
                pelvis,
                off,
                momentum: momentum.angular,
                rate,
                turn,
                thorax: thorax.clone(),
            });
        }
        let Some(mut pass) = last else { unreachable!("at least one pass") };
        // The first print that is shown is the origin, but where a walk has come before it.
        let first = seams[0].map_or(pass.forces[*schedule.shown_steps.start()].along, |_| 0.0);
        pass.back(first);
        let excess = (0..n).map(|i| {
            let force = grid.second(i, |j| pass.off[j]) * body.mass;
            [grid.first(i, |j| pass.momentum[j]) - pass.rate[i], force]
        });
        Ok(Self {
            pelvis: UniformSpline::resting(start, step, &rows(&pass.pelvis))?,
            thorax: UniformSpline::resting(start, step, &pass.thorax)?,
            excess: excess.collect(),
            start,
            step,
            forces: pass.forces,
            legs: pass.legs,
            plane,
            schedule,
            body,
        })
    }

    fn place(&self, time: f64) -> Place {
        let pelvis = Vector3::from(self.pelvis.position(time));
        let walks = self.schedule.walks(time);
        let upper = self.schedule.upper(time, self.thorax.position(time), walks.as_ref());
        let rotation = rotations::matrix(upper.trunk[0]);
        let legs = [0, 1].map(|side| {
            let hip = pelvis + rotation * self.body.legs[side][0].offset;
            let hip = if side == 0 { hip } else { mirror(&hip) };
            (hip, self.legs[side].pose(&self.body.leg, time, &hip), self.legs[side].short(time, &hip))
        });
        Place { pelvis, upper, legs }
    }

    /// The posture at a time (s).
    pub(super) fn configuration(&self, time: f64, q: &mut [f64]) {
        let time = time + self.schedule.shown.0;
        let Place { pelvis, upper: Upper { trunk, arms, carriage }, legs } = self.place(time);
        let legs = legs.map(|(_, pose, _)| pose);
        let posture =
            Posture { pelvis, trunk, arms, cane: [0.0; 2], carriage, legs, heading: 0.0, feet: [0.0; 2] };
        posture.write(&self.body, &self.plane, q);
    }

    /// Prescribed wrenches of left and right foot at a time (s).
    pub(super) fn forces(&self, time: f64) -> [Contact; 2] {
        let time = time + self.schedule.shown.0;
        let mut feet = [Contact::default(); 2];
        let weight = self.body.mass * G;
        for (footstep, amplitudes) in self.schedule.steps.iter().zip(&self.forces) {
            if !footstep.stands(time) {
                continue;
            }
            let (side, basis) = (footstep.side, footstep.basis(time));
            let (force, free) = amplitudes.force(side, &basis);
            let other = amplitudes.other(&basis);
            let cops = pressures(&self.plane, self.body.leg.foot_length(), side, amplitudes, &basis);
            for (side, part, cop) in [(side, 1.0 - other, cops[0]), (1 - side, other, cops[1])] {
                if part != 0.0 {
                    let force = force * (weight * part);
                    let moment = cop.cross(&force) + Vector3::y() * (free * part);
                    feet[side] = Contact { force, moment, cop };
                }
            }
        }
        feet
    }

    /// The distance of the nodes (s).
    pub(super) fn resolution(&self) -> f64 {
        self.step
    }

    /// What it asks of soles and legs, at its nodes.
    pub(super) fn extremes(&self) -> RunExtremes {
        let (leg, weight) = (&self.body.leg, self.body.mass * G);
        let toe = leg.toe_polar();
        let nodes = (self.duration() / self.step) as usize;
        let mut found = RunExtremes::none();
        for i in 0..=nodes {
            let time = self.step * i as f64;
            let Place { legs, .. } = self.place(time + self.schedule.shown.0);
            for (hip, pose, short) in legs {
                let ankle = hip.y - leg.ankle_below_hip(&pose) * pose.side.cos();
                found.note_leg(pose.knee, -leg.lowest(toe, ankle, pose.pitch, pose.toes), short);
            }
            for contact in self.forces(time) {
                found.note_force(&contact.force, weight);
            }
        }
        let first = ((self.schedule.shown.0 - self.start) / self.step).round() as usize;
        let shown = &self.excess[first..=first + nodes];
        found.momentum_excess = greatest(shown.iter().map(|[moment, _]| moment.amax()));
        found.force_excess = greatest(shown.iter().map(|[_, force]| force.norm())) / weight;
        found
    }

    /// The walks before and after it, in the time of the whole motion.
    pub(super) fn walks(&self, from: &Bound, to: &Bound) -> Result<[Option<WalkSide>; 2], ProfileError> {
        let [before, after] = &self.schedule.seams;
        let before = match (from, before) {
            (Bound::Walking(Walked { walk, step }), Some(seam)) => {
                Some(WalkSide::before(walk, *step, seam.walked(seam.at))?)
            }
            _ => None,
        };
        let after = match (to, after) {
            (Bound::Walking(Walked { walk, step }), Some(seam)) => {
                let from = before.as_ref().map_or(0.0, |walk| walk.seen().end) + self.duration();
                let along = self.forces[self.forces.len() - 1].along;
                Some(WalkSide::after(walk, *step, from, seam.walked(seam.at), along)?)
            }
            _ => None,
        };
        Ok([before, after])
    }

    /// How long what is shown of it lasts (s).
    pub(super) fn duration(&self) -> f64 {
        self.schedule.shown.1 - self.schedule.shown.0
    }

    /// When each foot of what is shown stands (s).
    pub(super) fn stood(&self) -> impl Iterator<Item = (usize, Stood)> {
        let from = self.schedule.shown.0;
        let shown = self.schedule.shown_steps.clone();
        let stood = self
            .legs
            .iter()
            .enumerate()
            .flat_map(move |(side, leg)| leg.stood(from).map(move |stood| (side, stood)));
        stood.filter(move |(_, (k, _))| shown.contains(k)).map(|(side, (_, stood))| (side, stood))
    }

    /// Where the heel of each of them stands along z (m).
    pub(super) fn prints(&self) -> impl Iterator<Item = f64> + '_ {
        self.schedule.shown_steps.clone().map(|k| self.forces[k].along)
    }
}
