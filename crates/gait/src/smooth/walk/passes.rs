//! The passes in which body and forces come to agree.

use super::feet::{Foot, Hip};
use super::heights::Needs;
use super::laws::{Amplitudes, WalkLaws};
use super::numbers::{GROUND_PASSES, GROUND_RELAXATION, KEPT_PASSES, RELAXATION};
use super::solve::{Way, factor, rest_to_rest};
use super::timeline::Timeline;
use crate::body::Body;
use crate::body::foot::turned;
use crate::body::leg::LegPose;
use crate::error::GaitError;
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::smooth::prescribed::{PrescribedNode, spread};
use crate::walking::G;
use nalgebra::Vector3;
use solaris_profiles::UniformSpline;

/// Part of the way to the free moments found that a pass goes.
const TILTING_FOLLOWS: f64 = 0.8;

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
    upper: UpperBody,
    kernel: MomentumKernel,
    /// Left and right hip against the pelvis.
    hips: [Vec<Vector3<f64>>; 2],
    /// Height without corrections and its second derivative, and the weights of the corrections, by node.
    height: Vec<(f64, f64)>,
    weights: Vec<Vec<CorrectionWeight>>,
    shapes: [Vec<f64>; 4],
    centre: Vec<Vector3<f64>>,
    /// Covariance of the feet's places, see [`spread`], and the height of the pivot; none on level ground.
    spread: Vec<(Vector3<f64>, f64)>,
    /// Horizontal part of the free moments.
    tilting: Vec<Vector3<f64>>,
    /// That of the pass before, which the way was solved with.
    solved_tilting: Vec<Vector3<f64>>,
    momentum_rate: Vec<Vector3<f64>>,
    /// Centre of mass against the pelvis' origin.
    offset: Vec<Vector3<f64>>,
    corrections: Vec<f64>,
}

impl Passes {
    pub(super) fn new(body: Body, laws: WalkLaws, timeline: Timeline) -> Self {
        let count = timeline.grid.count;
        let clocks = timeline.clocks();
        let upper = UpperBody::new(
            &body,
            &timeline.grid,
            |_| laws.style(0).manner.carriage(),
            |i| {
                let (trunk, arms) = laws.angles(clocks[i]);
                (trunk, arms, laws.course.heading(clocks[i]))
            },
        );
        let hips =
            [0, 1].map(|side| (0..count).map(|i| upper.pelvis(i) * body.legs[side][0].offset).collect());
        let heights = timeline.with_neighbours(|u| laws.height(u));
        let height = (0..count).map(|i| (heights[i + 3], timeline.second(|k| heights[i + k]))).collect();
        let reach = 3.0 / timeline.rate as f64;
        let weights = (0..count)
            .map(|i| {
                laws.heights
                    .near(clocks[i], reach)
                    .map(|contact| CorrectionWeight {
                        contact,
                        weight: laws.heights.weight(clocks[i], contact),
                        acceleration: timeline
                            .second(|k| laws.heights.weight(timeline.neighbour(i, k), contact)),
                    })
                    .collect()
            })
            .collect();
        let on_cane: Vec<(f64, Vector3<f64>)> = clocks.iter().map(|&u| laws.cane_share(u)).collect();
        // The feet bear what a cane does not.
        let shifts: Vec<[f64; 4]> = clocks
            .iter()
            .zip(&on_cane)
            .map(|(&u, (share, _))| laws.shifts(u).map(|shift| shift * (1.0 - share)))
            .collect();
        let shift = |shape: usize| shifts.iter().map(|shapes| shapes[shape]).collect();
        let spreads = clocks.iter().map(|&u| (spread(&laws.unshifted(u)), laws.pivot(u)));
        let spread = if laws.relief.is_some() { spreads.collect() } else { Vec::new() };
        let feet = |u: f64| laws.unshifted(u).iter().map(|foot| foot.cop * foot.share).sum::<Vector3<f64>>();
        let centre =
            clocks.iter().zip(&on_cane).map(|(&u, (share, tip))| feet(u).lerp(tip, *share)).collect();
        // First guess: the strides' own momentum and offset, faded in and out.
        let guess = |u: f64| {
            let (pace, other) = laws.gaits.at(u);
            let (mut rate, mut offset) = pace.steady(u);
            if let Some((next, part)) = other {
                let (rate_after, offset_after) = next.steady(u);
                (rate, offset) = (rate.lerp(&rate_after, part), offset.lerp(&offset_after, part));
            }
            let at_rest = pace.standing.com - pace.standing.pelvis;
            let heading = laws.course.heading(u);
            let offset = at_rest.lerp(&offset, laws.walking(u));
            (turned(heading, &(rate * laws.bobbing(u).powi(2))), turned(heading, &offset))
        };
        let (momentum_rate, offset) = clocks.iter().map(|&u| guess(u)).unzip();
        let heading = |i: usize, side: usize| laws.foot_heading(side, clocks[i]);
        let tilt = |i: usize, side: usize| laws.foot_tilt(side, clocks[i]);
        Self {
            kernel: MomentumKernel::new(&body, &timeline.grid, &upper, laws.plane, heading, tilt),
            hips,
            height,
            weights,
            shapes: [shift(0), shift(1), shift(2), shift(3)],
            centre,
            spread,
            tilting: vec![Vector3::zeros(); count],
            solved_tilting: vec![Vector3::zeros(); count],
            momentum_rate,
            offset,
            corrections: laws.heights.first_guess(),
            upper,
            body,
            laws,
            timeline,
        }
    }

    /// Runs the passes; the last one is the walk.
    pub(super) fn run(mut self, passes: usize) -> Result<Solved, GaitError> {
        let uneven = self.laws.relief.is_some();
        let passes = passes.max(if uneven { GROUND_PASSES } else { 1 });
        let mut last = None;
        for pass in 0..passes {
            last = Some(self.pass(pass, passes)?);
        }
        let Some(Pass { feet, pelvis, rate, vertical }) = last else { unreachable!("at least one pass") };
        let Self { body, laws, timeline, corrections, offset, solved_tilting, .. } = self;
        let nodes = (0..timeline.grid.count)
            .map(|i| PrescribedNode {
                com: pelvis[i] + offset[i],
                vertical: vertical[i],
                momentum_rate: rate[i],
                feet: laws.support(timeline.clock(i)),
                cane: laws.cane_at(&body, timeline.clock(i), &pelvis[i]),
                tilting: solved_tilting[i],
            })
            .collect();
        Ok(Solved { body, laws, timeline, feet, pelvis, nodes, corrections })
    }

    fn pass(&mut self, pass: usize, passes: usize) -> Result<Pass, GaitError> {
        let (count, legs) = (self.timeline.grid.count, self.body.sides);
        let (com, vertical) = self.centre_of_mass();
        let pelvis: Vec<Vector3<f64>> =
            com.iter().zip(&self.offset).map(|(com, offset)| com - offset).collect();
        self.hold_cane(&pelvis);
        let mut needs = Needs::new(self.laws.heights.count());
        let nodes = [0, 1].map(|side| -> Vec<[f64; 3]> {
            (0..count).map(|i| (pelvis[i] + self.hips[side][i]).into()).collect()
        });
        let mut foot = |side: usize| -> Result<Foot, GaitError> {
            let spacing = 1.0 / self.timeline.rate as f64;
            let spline = UniformSpline::resting(self.timeline.start(), spacing, &nodes[side])?;
            let hip = Hip { spline: &spline, nodes: &nodes[side], timeline: &self.timeline };
            Ok(Foot::new(&self.laws, &legs[side], side, &hip, &mut needs)?)
        };
        let feet = [foot(0)?, foot(1)?];
        let pose = |side: usize, i: usize| {
            feet[side].pose(&self.laws, &legs[side], self.timeline.clock(i), &nodes[side][i].into())
        };
        let poses: Vec<[LegPose; 2]> = (0..count).map(|i| [pose(0, i), pose(1, i)]).collect();
        let momentum = self.kernel.momentum(&self.upper, |i| poses[i]);
        let (first, last) = self.timeline.moving;
        let rate: Vec<Vector3<f64>> = (0..count)
            .map(|i| match i {
                i if i < first || i > last => Vector3::zeros(),
                i => self.timeline.grid.first(i, |j| momentum.angular[j]),
            })
            .collect();
        let uneven = self.laws.relief.is_some();
        let (first_part, firsts, later) = if uneven { GROUND_RELAXATION } else { RELAXATION };
        let relaxation = if pass < firsts { first_part } else { later };
        for (old, new) in self.momentum_rate.iter_mut().zip(&rate) {
            *old += (new - *old) * relaxation;
        }
        self.offset = momentum.com;
        self.solved_tilting.clone_from(&self.tilting);
        if uneven {
            for i in 0..count {
                let clock = self.timeline.clock(i);
                let node = PrescribedNode {
                    com: pelvis[i] + self.offset[i],
                    vertical: vertical[i],
                    momentum_rate: rate[i],
                    feet: self.laws.support(clock),
                    cane: None,
                    tilting: self.tilting[i],
                };
                let needed = node.needed_tilting(self.laws.pivot(clock));
                self.tilting[i] = self.tilting[i].lerp(&needed, TILTING_FOLLOWS);
            }
        }
        if pass >= KEPT_PASSES.0 && pass + KEPT_PASSES.1 < passes {
            self.laws.heights.correct(&mut self.corrections, &needs);
        }
        Ok(Pass { feet, pelvis, rate, vertical })
    }

    /// Has the arm that holds a cane follow the pelvis.
    fn hold_cane(&mut self, pelvis: &[Vector3<f64>]) {
        if !cfg!(feature = "cane") || self.laws.cane.is_none() {
            return;
        }
        let (body, laws, clocks) = (&self.body, &self.laws, self.timeline.clocks());
        let held: Vec<_> =
            clocks.iter().zip(pelvis).map(|(&u, pelvis)| laws.upper(body, u, pelvis)).collect();
        self.upper = UpperBody::holding(
            body,
            &self.timeline.grid,
            |_| laws.style(0).manner.carriage(),
            |i| (held[i].0, held[i].1, laws.course.heading(clocks[i])),
            |i| held[i].2,
        );
    }

    /// How much higher the shifts of the last pass put the centre of pressure at a node, where they go along a slope.
    fn shifted(&self, node: usize) -> f64 {
        let [along, across] = [self.laws.amplitudes.sagittal, self.laws.amplitudes.lateral];
        let axes = self.laws.shift_axes();
        let amplitudes = [along[0], along[1], across[0], across[1]];
        (0..4).map(|j| amplitudes[j] * self.shapes[j][node] * axes[j].y).sum()
    }

    /// The centre of mass and the vertical force at the nodes, for the present guess of the body's own momentum.
    fn centre_of_mass(&mut self) -> (Vec<Vector3<f64>>, Vec<f64>) {
        let count = self.timeline.grid.count;
        let mass = self.body.mass;
        let (mut heights, mut vertical, mut stiffness) = (Vec::new(), Vec::new(), Vec::new());
        // Heights above the centre of pressure.
        let mut levers = Vec::new();
        for i in 0..count {
            let (mut y, mut acceleration) = self.height[i];
            for weight in &self.weights[i] {
                y -= self.corrections[weight.contact] * weight.weight;
                acceleration -= self.corrections[weight.contact] * weight.acceleration;
            }
            let force = mass * (G + acceleration);
            heights.push(y);
            vertical.push(force);
            let lever = y - self.centre[i].y - self.shifted(i);
            levers.push(lever);
            stiffness.push(force / (mass * lever));
        }
        let unit = 1.0 / (180.0 * self.timeline.grid.step.powi(2));
        let moving = self.timeline.moving;
        let factored = factor(&stiffness, moving, unit);
        let own: Vec<Vector3<f64>> = (0..count)
            .map(|i| {
                let h = self.momentum_rate[i] - self.tilting[i];
                let spread = self
                    .spread
                    .get(i)
                    .map_or(Vector3::zeros(), |(spread, pivot)| spread * (vertical[i] / (pivot * levers[i])));
                Vector3::new(h.z - spread.x, 0.0, -h.x - spread.z) / (mass * levers[i])
            })
            .collect();
        let [start, end] = [0, self.laws.course.steps].map(|k| self.laws.gaits.of_contact(k).standing.com);
        let last = self.laws.course.last();
        let way = Way {
            centre: &self.centre,
            own: &own,
            shapes: [0, 1, 2, 3].map(|i| &self.shapes[i][..]),
            axes: self.laws.shift_axes(),
            rest: [start, last.place + turned(last.heading, &end)],
        };
        let (mut com, [a1, a2, c1, c2]) = rest_to_rest(&factored, &stiffness, moving, unit, &way);
        self.laws.amplitudes = Amplitudes { sagittal: [a1, a2], lateral: [c1, c2] };
        com.iter_mut().zip(&heights).for_each(|(com, &height)| com.y = height);
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
