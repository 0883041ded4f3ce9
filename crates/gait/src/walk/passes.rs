//! The passes in which body and forces come to agree.

use super::feet::{Foot, Hip};
use super::laws::{Amplitudes, WalkLaws};
use super::numbers::{CORRECTION, REST};
use super::solve::{Coordinate, factor, rest_to_rest};
use crate::body::Body;
use crate::error::GaitError;
use crate::foot::{FootPlane, mirror};
use crate::grid::{Ends, Grid, SECOND};
use crate::leg::LegPose;
use crate::momentum::MomentumKernel;
use crate::prescribed::{G, PrescribedNode};
use crate::stride::StridePlan;
use crate::upper::UpperBody;
use nalgebra::Vector3;
use solaris_profiles::UniformSpline;

/// The nodes of a walk.
pub(super) struct Timeline {
    pub(super) grid: Grid,
    /// Nodes a stride, and the first node's number.
    pub(super) rate: usize,
    first: isize,
    pub(super) moving: (usize, usize),
}

impl Timeline {
    pub(super) fn new(laws: &WalkLaws, rate: usize, stride_time: f64) -> Self {
        let n = rate as f64;
        let first = ((laws.begin - REST) * n).floor() as isize;
        let last = ((laws.end + REST) * n).ceil() as isize;
        let grid = Grid { count: (last - first + 1) as usize, step: stride_time / n, ends: Ends::Resting };
        let node = |u: f64| ((u * n).round() as isize - first) as usize;
        Self { grid, rate, first, moving: (node(laws.begin), node(laws.end)) }
    }

    pub(super) fn clock(&self, node: usize) -> f64 {
        (self.first + node as isize) as f64 / self.rate as f64
    }
}

/// Weight of one height correction at a node, and its second derivative in time.
struct CorrectionWeight {
    contact: usize,
    weight: f64,
    acceleration: f64,
}

/// The state that the passes improve.
pub(super) struct Passes {
    body: Body,
    laws: WalkLaws,
    timeline: Timeline,
    steady_thigh: f64,
    upper: UpperBody,
    kernel: MomentumKernel,
    /// Left and right hip against the pelvis, the right one mirrored.
    hips: [Vec<Vector3<f64>>; 2],
    /// Height without corrections and its second derivative, and the weights of the corrections, by node.
    height: Vec<(f64, f64)>,
    weights: Vec<Vec<CorrectionWeight>>,
    shapes: [Vec<f64>; 4],
    centre: [Vec<f64>; 2],
    momentum_rate: Vec<Vector3<f64>>,
    /// Centre of mass against the pelvis' origin.
    offset: Vec<Vector3<f64>>,
    corrections: Vec<f64>,
}

impl Passes {
    pub(super) fn new(body: Body, laws: WalkLaws, stride: &StridePlan, timeline: Timeline) -> Self {
        let count = timeline.grid.count;
        let clocks: Vec<f64> = (0..count).map(|i| timeline.clock(i)).collect();
        let upper = UpperBody::new(&body, &timeline.grid, |i| laws.angles(clocks[i]));
        let hips = [0, 1].map(|side| {
            let offset = body.legs[side][0].offset;
            let hip = |i: usize| upper.pelvis(i) * offset;
            (0..count).map(|i| if side == 0 { hip(i) } else { mirror(&hip(i)) }).collect()
        });
        let spacing = 1.0 / timeline.rate as f64;
        let unit = 1.0 / (180.0 * timeline.grid.step.powi(2));
        let second = |u: f64, f: &dyn Fn(f64) -> f64| -> f64 {
            (0..7).map(|k| SECOND[k] * unit * f(u + spacing * (k as f64 - 3.0))).sum()
        };
        let height = clocks.iter().map(|&u| (laws.height(u), second(u, &|u| laws.height(u)))).collect();
        let weights = clocks
            .iter()
            .map(|&u| {
                laws.corrections_near(u, 3.0 * spacing)
                    .map(|contact| CorrectionWeight {
                        contact,
                        weight: laws.correction(u, contact),
                        acceleration: second(u, &|u| laws.correction(u, contact)),
                    })
                    .collect()
            })
            .collect();
        let shift = |shape: usize| clocks.iter().map(|&u| laws.shifts(u)[shape]).collect();
        let pressed: Vec<Vector3<f64>> = clocks
            .iter()
            .map(|&u| laws.unshifted(u).iter().map(|foot| foot.cop * foot.share).sum())
            .collect();
        // First guess: the stride's own momentum and offset, faded in and out.
        let steady = |i: usize| (timeline.first + i as isize).rem_euclid(timeline.rate as isize) as usize;
        let at_rest = laws.standing.com - laws.standing.pelvis;
        let momentum_rate =
            (0..count).map(|i| stride.momentum_rate(steady(i)) * laws.swinging(clocks[i]).powi(2)).collect();
        let offset = (0..count)
            .map(|i| at_rest.lerp(&stride.com_offset[steady(i)], laws.walking(clocks[i])))
            .collect();
        Self {
            kernel: MomentumKernel::new(&body, &timeline.grid, &upper, FootPlane::new(laws.style.foot_yaw)),
            steady_thigh: stride.contact.thigh.position,
            hips,
            height,
            weights,
            shapes: [shift(0), shift(1), shift(2), shift(3)],
            centre: [pressed.iter().map(|p| p.x).collect(), pressed.iter().map(|p| p.z).collect()],
            momentum_rate,
            offset,
            corrections: vec![0.0; laws.steps + 1],
            upper,
            body,
            laws,
            timeline,
        }
    }

    /// Runs the passes; the last one is the walk.
    pub(super) fn run(mut self, passes: usize) -> Result<Solved, GaitError> {
        let passes = passes.max(1);
        let mut last = None;
        for pass in 0..passes {
            last = Some(self.pass(pass, passes)?);
        }
        let Some(Pass { feet, pelvis, rate, vertical }) = last else { unreachable!("at least one pass") };
        let Self { body, laws, timeline, corrections, offset, .. } = self;
        let nodes = (0..timeline.grid.count)
            .map(|i| PrescribedNode {
                com: pelvis[i] + offset[i],
                vertical: vertical[i],
                momentum_rate: rate[i],
                feet: laws.support(timeline.clock(i)),
            })
            .collect();
        Ok(Solved { body, laws, timeline, feet, pelvis, nodes, corrections })
    }

    fn pass(&mut self, pass: usize, passes: usize) -> Result<Pass, GaitError> {
        let (count, leg) = (self.timeline.grid.count, self.body.leg);
        let (com, vertical) = self.centre_of_mass();
        let pelvis: Vec<Vector3<f64>> =
            com.iter().zip(&self.offset).map(|(com, offset)| com - offset).collect();
        let mut need = vec![-9.0_f64; self.laws.steps + 1];
        let nodes = [0, 1].map(|side| -> Vec<[f64; 3]> {
            let place = |i: usize| if side == 0 { pelvis[i] } else { mirror(&pelvis[i]) };
            (0..count).map(|i| (place(i) + self.hips[side][i]).into()).collect()
        });
        let mut foot = |side: usize| -> Result<Foot, GaitError> {
            let first = self.timeline.clock(0);
            let rate = self.timeline.rate as f64;
            let spline = UniformSpline::resting(first, 1.0 / rate, &nodes[side])?;
            let hip = Hip { spline: &spline, nodes: &nodes[side], first, rate };
            Ok(Foot::new(&self.laws, &leg, side, &hip, self.steady_thigh, &mut need)?)
        };
        let feet = [foot(0)?, foot(1)?];
        let poses: Vec<[LegPose; 2]> = (0..count)
            .map(|i| {
                let u = self.timeline.clock(i);
                [0, 1].map(|side| feet[side].pose(&self.laws, &leg, u, &nodes[side][i].into()))
            })
            .collect();
        let momentum = self.kernel.momentum(&self.upper, |i| poses[i]);
        let (first, last) = self.timeline.moving;
        let rate: Vec<Vector3<f64>> = (0..count)
            .map(|i| match i {
                i if i < first || i > last => Vector3::zeros(),
                i => self.timeline.grid.first(i, |j| momentum.angular[j]),
            })
            .collect();
        let relaxation = if pass < 3 { 0.5 } else { 0.8 };
        for (old, new) in self.momentum_rate.iter_mut().zip(&rate) {
            *old += (new - *old) * relaxation;
        }
        self.offset = momentum.com;
        // The last passes keep the heights, so that the rest can settle.
        if pass >= 2 && pass + 4 < passes {
            let (share, most, lower, upper) = CORRECTION;
            for (correction, need) in self.corrections.iter_mut().zip(&need) {
                *correction = (*correction + (share * need).clamp(-most, most)).clamp(lower, upper);
            }
        }
        Ok(Pass { feet, pelvis, rate, vertical })
    }

    /// The centre of mass and the vertical force at the nodes, for the present guess of the body's own momentum.
    fn centre_of_mass(&mut self) -> (Vec<Vector3<f64>>, Vec<f64>) {
        let count = self.timeline.grid.count;
        let mass = self.body.mass;
        let (mut heights, mut vertical, mut stiffness) = (Vec::new(), Vec::new(), Vec::new());
        for i in 0..count {
            let (mut y, mut acceleration) = self.height[i];
            for weight in &self.weights[i] {
                y -= self.corrections[weight.contact] * weight.weight;
                acceleration -= self.corrections[weight.contact] * weight.acceleration;
            }
            let force = mass * (G + acceleration);
            heights.push(y);
            vertical.push(force);
            stiffness.push(force / (mass * y));
        }
        let unit = 1.0 / (180.0 * self.timeline.grid.step.powi(2));
        let moving = self.timeline.moving;
        let factored = factor(&stiffness, moving, unit);
        let own = |f: fn(&Vector3<f64>) -> f64| -> Vec<f64> {
            self.momentum_rate.iter().zip(&heights).map(|(h, y)| f(h) / (mass * y)).collect()
        };
        let (start, finish) = (self.laws.standing.com.z, self.laws.prints()[self.laws.steps]);
        let sagittal = Coordinate {
            centre: &self.centre[1],
            own: &own(|h| -h.x),
            shapes: [&self.shapes[0], &self.shapes[1]],
            rest: (start, finish + start),
        };
        let lateral = Coordinate {
            centre: &self.centre[0],
            own: &own(|h| h.z),
            shapes: [&self.shapes[2], &self.shapes[3]],
            rest: (0.0, 0.0),
        };
        let (z, along) = rest_to_rest(&factored, &stiffness, moving, unit, &sagittal);
        let (x, across) = rest_to_rest(&factored, &stiffness, moving, unit, &lateral);
        self.laws.amplitudes = Amplitudes { sagittal: along, lateral: across };
        let com = (0..count).map(|i| Vector3::new(x[i], heights[i], z[i])).collect();
        (com, vertical)
    }
}

/// A walk whose body and forces agree.
pub(super) struct Solved {
    pub(super) body: Body,
    pub(super) laws: WalkLaws,
    pub(super) timeline: Timeline,
    pub(super) feet: [Foot; 2],
    /// Pelvis at the nodes.
    pub(super) pelvis: Vec<Vector3<f64>>,
    pub(super) nodes: Vec<PrescribedNode>,
    pub(super) corrections: Vec<f64>,
}

/// What one pass found.
struct Pass {
    feet: [Foot; 2],
    pelvis: Vec<Vector3<f64>>,
    rate: Vec<Vector3<f64>>,
    vertical: Vec<f64>,
}
