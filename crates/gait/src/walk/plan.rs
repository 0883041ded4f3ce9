//! A whole walk, from standing to standing, as one solve from rest to rest.

use super::feet::Foot;
use super::laws::WalkLaws;
use super::numbers::REST;
use super::passes::{Passes, Solved, Timeline};
use super::repeat::Repeat;
use super::standing::Standing;
use crate::body::Body;
use crate::error::GaitError;
use crate::foot::{FootPlane, mirror};
use crate::grid::Grid;
use crate::laws;
use crate::leg::LegPose;
use crate::posture::Posture;
use crate::prescribed::PrescribedNode;
use crate::stride::{Resolution, StridePlan};
use crate::stride_loop::StrideLoop;
use nalgebra::Vector3;
use solaris_model::{Contact, Trajectory};
use solaris_modes::FootSupport;
use solaris_profiles::UniformSpline;

/// A planned walk: its posture, and what the ground is to do, at any time.
///
/// It rests a little before it begins and after it has ended. Left and right feet are 0 and 1. Of a walk of more than 42 steps
/// the middle stride is planned once and repeated; *nodes* are those that were planned.
pub struct WalkPlan {
    pub(crate) body: Body,
    /// Of the walk that was planned, and of the whole one.
    pub(crate) laws: WalkLaws,
    pub(super) whole: WalkLaws,
    pub(super) repeat: Repeat,
    /// Whether all is mirrored, so that the left foot goes first.
    pub(super) left_first: bool,
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
        let repeat = Repeat::new(steps, resolution.nodes, style.step_length);
        let of = |steps: usize| WalkLaws::new(&body, &style, steps, stride.mean_height(), standing);
        let (laws, whole) = (of(repeat.planned)?, of(steps)?);
        let timeline = Timeline::new(&laws, resolution.nodes, style.stride_time);
        let Solved { body, laws, timeline, feet, pelvis, nodes, corrections } =
            Passes::new(body, laws, stride, timeline).run(resolution.walk_passes)?;
        let (first, spacing) = (timeline.clock(0), 1.0 / timeline.rate as f64);
        let spline = |values: Vec<[f64; 3]>| UniformSpline::resting(first, spacing, &values);
        Ok(Self {
            pelvis: spline(pelvis.iter().map(|&p| p.into()).collect())?,
            force: spline(nodes.iter().map(|node| node.total().force.into()).collect())?,
            grid: timeline.grid,
            first,
            moving: timeline.moving,
            body,
            laws,
            whole,
            repeat,
            left_first: false,
            feet,
            nodes,
            corrections,
        })
    }

    /// The mirror image of the walk: the other foot goes first.
    #[must_use]
    pub fn mirrored(self) -> Self {
        Self { left_first: !self.left_first, ..self }
    }

    /// Of a pair, the left foot's first.
    fn sided<T>(&self, [a, b]: [T; 2]) -> [T; 2] {
        if self.left_first { [b, a] } else { [a, b] }
    }

    /// A vector as the walk has it.
    fn seen(&self, v: Vector3<f64>) -> Vector3<f64> {
        if self.left_first { mirror(&v) } else { v }
    }

    /// The style of the steady part.
    pub fn style(&self) -> &crate::Style {
        &self.laws.style
    }

    /// Whether the style's numbers are held at the ends of what they were fitted to, see [`crate::Style::is_extrapolated`].
    pub fn is_extrapolated(&self) -> bool {
        self.laws.style.is_extrapolated(&self.body.leg)
    }

    /// The standing height that the laws scale with (m): the figure's own, or what its legs suggest.
    pub fn stature(&self) -> f64 {
        self.body.height
    }

    /// Number of steps, without the closing one.
    pub fn steps(&self) -> usize {
        self.whole.steps
    }

    /// Heel prints along z (m): both feet standing, each step, and the closing foot.
    pub fn prints(&self) -> &[f64] {
        self.whole.prints()
    }

    /// Amplitudes of the shifts of load: fore and aft at start and end (m), sideways at start and end (step widths).
    pub fn amplitudes(&self) -> ([f64; 2], [f64; 2]) {
        (self.laws.amplitudes.sagittal, self.laws.amplitudes.lateral)
    }

    /// By how much each contact lowers the body (m), from the standing feet to the last step that was planned.
    pub fn height_corrections(&self) -> &[f64] {
        &self.corrections
    }

    /// Number of nodes, and the first and last between which the body moves.
    pub fn nodes(&self) -> (usize, (usize, usize)) {
        (self.nodes.len(), self.moving)
    }

    /// Clock of a node in the walk that was planned: 0 where left heel contact would have been before the first step.
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
        self.seen(self.nodes[node].com)
    }

    /// Rate of the angular momentum about the centre of mass at a node (N m).
    pub fn momentum_rate(&self, node: usize) -> Vector3<f64> {
        // It turns the other way in the mirror, but for what is about the axis across.
        let rate = self.nodes[node].momentum_rate;
        if self.left_first { -mirror(&rate) } else { rate }
    }

    /// Share and centre of pressure of both feet at a clock.
    pub fn support(&self, clock: f64) -> [FootSupport; 2] {
        let (u, advance) = self.repeat.fold(clock);
        let mut feet = self.laws.support(u);
        for foot in &mut feet {
            foot.cop = self.seen(foot.cop + Vector3::z() * advance);
        }
        self.sided(feet)
    }

    /// Prescribed wrenches of both feet at a node.
    pub fn forces(&self, node: usize) -> [Contact; 2] {
        let feet = self.nodes[node].feet(&self.laws.style).map(|foot| Contact {
            force: self.seen(foot.force),
            moment: if self.left_first { -mirror(&foot.moment) } else { foot.moment },
            cop: self.seen(foot.cop),
        });
        self.sided(feet)
    }

    /// Prescribed total force at a clock (N).
    pub fn force(&self, clock: f64) -> Vector3<f64> {
        self.seen(Vector3::from(self.force.position(self.repeat.fold(clock).0)))
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
        let (u, advance) = self.repeat.fold(self.moving_clock(clock));
        let (trunk, arms) = self.laws.angles(u);
        let pelvis = Vector3::from(self.pelvis.position(u));
        let legs = self.hips_and_legs(u).1;
        let posture = Posture { pelvis: pelvis + Vector3::z() * advance, trunk, arms, legs };
        if self.left_first { posture.mirrored() } else { posture }
    }

    /// Hips (in each foot's world: the right one mirrored) and poses of both legs at a clock of the walk that was planned.
    pub(crate) fn hips_and_legs(&self, u: f64) -> ([Vector3<f64>; 2], [LegPose; 2]) {
        let rotation = laws::rotation(self.laws.angles(u).0[0]);
        let pelvis = Vector3::from(self.pelvis.position(u));
        let hips = [0, 1].map(|side| {
            let hip = pelvis + rotation * self.body.legs[side][0].offset;
            if side == 0 { hip } else { mirror(&hip) }
        });
        (hips, [0, 1].map(|side| self.feet[side].pose(&self.laws, &self.body.leg, u, &hips[side])))
    }

    /// The middle stride, to be repeated; none of a walk of fewer than 42 steps, in which it still feels beginning or end.
    pub fn stride_loop(&self) -> Option<StrideLoop<'_, Self>> {
        let (body, style) = (&self.body, &self.laws.style);
        // A left contact, or a right one where all is mirrored.
        let contact = self.repeat.middle()?;
        let nq = body.nq;
        let span = (self.time(contact), style.stride_time);
        Some(StrideLoop::new(self, nq, body.root + 2, span, 2.0 * style.step_length))
    }

    /// The clock, or one at rest before or after the walk.
    fn moving_clock(&self, clock: f64) -> f64 {
        clock.clamp(self.whole.begin - 1.0, self.whole.end + 1.0)
    }
}

impl Trajectory for WalkPlan {
    fn duration(&self) -> f64 {
        self.time(self.whole.end + REST)
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.configuration_at(self.clock_at(t), q);
    }

    /// The distance of the nodes (s).
    fn resolution(&self) -> f64 {
        self.grid.step
    }
}
