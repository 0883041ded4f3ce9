//! A whole walk, from standing to standing, as one solve from rest to rest.

use super::feet::{Foot, Hip};
use super::laws::{Amplitudes, WalkLaws};
use super::numbers::CORRECTION;
use super::solve::{Coordinate, factor, rest_to_rest};
use super::standing::Standing;
use crate::body::Body;
use crate::error::GaitError;
use crate::foot::{FootPlane, LegPose, mirror};
use crate::grid::{Ends, Grid, SECOND};
use crate::laws;
use crate::momentum::MomentumKernel;
use crate::posture::Posture;
use crate::prescribed::{G, PrescribedNode};
use crate::stride::{Resolution, StridePlan};
use crate::upper::UpperBody;
use nalgebra::Vector3;
use solaris_model::{Contact, Trajectory};
use solaris_modes::FootSupport;
use solaris_profiles::UniformSpline;

/// Rest before and after the movement, in strides: longer than any difference formula reaches, and long enough for the
/// splines to have come to rest (they ring by 0.43 a node).
const REST: f64 = 0.2;

/// A planned walk: its posture, and what the ground is to do, at any time.
///
/// It rests a little before it begins and after it has ended. Left and right feet are 0 and 1.
pub struct WalkPlan {
    pub(super) body: Body,
    pub(super) laws: WalkLaws,
    pub(super) feet: [Foot; 2],
    pelvis: UniformSpline<3>,
    grid: Grid,
    /// Clock of the first node.
    first: f64,
    /// Nodes between which the body moves.
    moving: (usize, usize),
    nodes: Vec<PrescribedNode>,
    /// Prescribed total force over the clock.
    force: UniformSpline<3>,
    corrections: Vec<f64>,
}

impl WalkPlan {
    /// Plans `steps` steps in the style of a stride, right foot first, the other foot closing beside.
    ///
    /// # Errors
    ///
    /// A walk that does not close.
    pub fn new(stride: &StridePlan, steps: usize, resolution: Resolution) -> Result<Self, GaitError> {
        let (body, style) = (stride.body.clone(), stride.style);
        let standing = Standing::new(&body, &style);
        let laws = WalkLaws::new(&body, &style, steps, stride.mean_height(), standing)?;
        let timeline = Timeline::new(&laws, resolution.nodes, style.stride_time);
        Passes::new(body, laws, stride, timeline).run(resolution.walk_passes)
    }

    /// The style of the steady part.
    pub fn style(&self) -> &crate::Style {
        &self.laws.style
    }

    /// Whether the style's numbers are held at the ends of what they were fitted to, see [`crate::Style::is_extrapolated`].
    pub fn is_extrapolated(&self) -> bool {
        self.laws.style.is_extrapolated(&self.body.leg)
    }

    /// Number of steps, without the closing one.
    pub fn steps(&self) -> usize {
        self.laws.steps
    }

    /// Heel prints along z (m): both feet standing, each step, and the closing foot.
    pub fn prints(&self) -> &[f64] {
        self.laws.prints()
    }

    /// Amplitudes of the shifts of load: fore and aft at start and end (m), sideways at start and end (step widths).
    pub fn amplitudes(&self) -> ([f64; 2], [f64; 2]) {
        (self.laws.amplitudes.sagittal, self.laws.amplitudes.lateral)
    }

    /// By how much each contact lowers the body (m), from the standing feet to the last step.
    pub fn height_corrections(&self) -> &[f64] {
        &self.corrections
    }

    /// Number of nodes, and the first and last between which the body moves.
    pub fn nodes(&self) -> (usize, (usize, usize)) {
        (self.nodes.len(), self.moving)
    }

    /// Clock of a node: 0 where left heel contact would have been before the first step.
    pub fn clock(&self, node: usize) -> f64 {
        self.first + node as f64 * self.grid.step / self.laws.style.stride_time
    }

    /// Time (s) of a clock.
    pub fn time(&self, clock: f64) -> f64 {
        (clock - self.laws.begin + REST) * self.laws.style.stride_time
    }

    /// Clock at a time (s).
    pub fn clock_at(&self, time: f64) -> f64 {
        time / self.laws.style.stride_time + self.laws.begin - REST
    }

    /// Centre of mass at a node (m).
    pub fn com(&self, node: usize) -> Vector3<f64> {
        self.nodes[node].com
    }

    /// Rate of the angular momentum about the centre of mass at a node (N m).
    pub fn momentum_rate(&self, node: usize) -> Vector3<f64> {
        self.nodes[node].momentum_rate
    }

    /// Share and centre of pressure of both feet at a clock.
    pub fn support(&self, clock: f64) -> [FootSupport; 2] {
        self.laws.support(clock)
    }

    /// Prescribed wrenches of both feet at a node.
    pub fn forces(&self, node: usize) -> [Contact; 2] {
        self.nodes[node].feet(&self.laws.style)
    }

    /// Prescribed total force at a clock (N).
    pub fn force(&self, clock: f64) -> Vector3<f64> {
        Vector3::from(self.force.position(clock))
    }

    /// Pitches of foot and toes (rad, toe down), left and right, at a clock.
    pub fn foot_pitches(&self, clock: f64) -> [(f64, f64); 2] {
        self.posture(clock).legs.map(|pose| (pose.pitch, pose.toes))
    }

    /// Knee flexion (rad), left and right, at a clock.
    pub fn knees(&self, clock: f64) -> [f64; 2] {
        self.posture(clock).legs.map(|pose| pose.knee)
    }

    /// Writes the figure's coordinates at a clock to `q` (length `nq`).
    pub fn configuration_at(&self, clock: f64, q: &mut [f64]) {
        self.posture(clock).write(&self.body, &FootPlane::new(self.laws.style.foot_yaw), q);
    }

    fn posture(&self, clock: f64) -> Posture {
        let u = self.moving_clock(clock);
        let (trunk, arms) = angles(&self.laws, u);
        let pelvis = Vector3::from(self.pelvis.position(u));
        Posture { pelvis, trunk, arms, legs: self.hips_and_legs(u).1 }
    }

    /// Hips (in each foot's world: the right one mirrored) and poses of both legs at a clock.
    pub(super) fn hips_and_legs(&self, clock: f64) -> ([Vector3<f64>; 2], [LegPose; 2]) {
        let u = self.moving_clock(clock);
        let rotation = laws::rotation(angles(&self.laws, u).0[0]);
        let pelvis = Vector3::from(self.pelvis.position(u));
        let hips = [0, 1].map(|side| {
            let hip = pelvis + rotation * self.body.legs[side][0].offset;
            if side == 0 { hip } else { mirror(&hip) }
        });
        (hips, [0, 1].map(|side| self.feet[side].pose(&self.laws, &self.body.leg, u, &hips[side])))
    }

    /// The clock, or one at rest before or after the walk.
    fn moving_clock(&self, clock: f64) -> f64 {
        clock.clamp(self.laws.begin - 1.0, self.laws.end + 1.0)
    }
}

impl Trajectory for WalkPlan {
    fn duration(&self) -> f64 {
        self.time(self.laws.end + REST)
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.configuration_at(self.clock_at(t), q);
    }

    /// The distance of the nodes (s).
    fn resolution(&self) -> f64 {
        self.grid.step
    }
}

/// Angles of trunk and both arms at a clock.
fn angles(laws: &WalkLaws, u: f64) -> ([laws::Euler; 5], [[f64; 2]; 2]) {
    let envelope = laws.swinging(u);
    let style = &laws.style;
    (laws::trunk(style, u, envelope), [laws::arm(style, u, envelope), laws::arm(style, u + 0.5, envelope)])
}

/// The nodes of a walk.
struct Timeline {
    grid: Grid,
    /// Nodes a stride, and the first node's number.
    rate: usize,
    first: isize,
    moving: (usize, usize),
}

impl Timeline {
    fn new(laws: &WalkLaws, rate: usize, stride_time: f64) -> Self {
        let n = rate as f64;
        let first = ((laws.begin - REST) * n).floor() as isize;
        let last = ((laws.end + REST) * n).ceil() as isize;
        let grid = Grid { count: (last - first + 1) as usize, step: stride_time / n, ends: Ends::Resting };
        let node = |u: f64| ((u * n).round() as isize - first) as usize;
        Self { grid, rate, first, moving: (node(laws.begin), node(laws.end)) }
    }

    fn clock(&self, node: usize) -> f64 {
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
struct Passes {
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
    fn new(body: Body, laws: WalkLaws, stride: &StridePlan, timeline: Timeline) -> Self {
        let count = timeline.grid.count;
        let clocks: Vec<f64> = (0..count).map(|i| timeline.clock(i)).collect();
        let upper = UpperBody::new(&body, &timeline.grid, |i| angles(&laws, clocks[i]));
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

    fn run(mut self, passes: usize) -> Result<WalkPlan, GaitError> {
        let passes = passes.max(1);
        let mut last = None;
        for pass in 0..passes {
            last = Some(self.pass(pass, passes)?);
        }
        let Some(Pass { feet, pelvis, rate, vertical }) = last else { unreachable!("at least one pass") };
        let Self { body, laws, timeline, corrections, offset, .. } = self;
        let count = timeline.grid.count;
        let nodes: Vec<PrescribedNode> = (0..count)
            .map(|i| PrescribedNode {
                com: pelvis[i] + offset[i],
                vertical: vertical[i],
                momentum_rate: rate[i],
                feet: laws.support(timeline.clock(i)),
            })
            .collect();
        let (first, spacing) = (timeline.clock(0), 1.0 / timeline.rate as f64);
        let spline = |values: Vec<[f64; 3]>| UniformSpline::resting(first, spacing, &values);
        Ok(WalkPlan {
            pelvis: spline(pelvis.iter().map(|&p| p.into()).collect())?,
            force: spline(nodes.iter().map(|node| node.total().force.into()).collect())?,
            grid: timeline.grid,
            first,
            moving: timeline.moving,
            body,
            laws,
            feet,
            nodes,
            corrections,
        })
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

/// What one pass found.
struct Pass {
    feet: [Foot; 2],
    pelvis: Vec<Vector3<f64>>,
    rate: Vec<Vector3<f64>>,
    vertical: Vec<f64>,
}
