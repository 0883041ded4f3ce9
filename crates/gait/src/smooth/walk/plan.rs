//! A whole walk, from standing to standing, as one solve from rest to rest.

use super::course::{Course, Print};
use super::feet::Foot;
use super::laws::WalkLaws;
use super::numbers::{REST, WalkNumbers};
use super::passes::{Passes, Solved};
use super::repeat::Repeat;
use super::steps::{self, Steps};
use super::tempo::Tempo;
use super::timeline::Timeline;
use crate::body::Body;
use crate::body::foot::{FootPlane, mirror, turned};
use crate::body::leg::LegPose;
use crate::body::posture::Posture;
use crate::body::rotations::{self, Euler};
use crate::error::{GaitError, RequestError};
use crate::limbs::stance::Stance;
use crate::request::{CANE_LOAD, Resolution, check_turned};
use crate::smooth::prescribed::{CaneNode, PrescribedNode};
use crate::smooth::stride::StridePlan;
use crate::smooth::style::Style;
use crate::walking::StrideLoop;
use nalgebra::Vector3;
use solaris_analysis::FootSupport;
use solaris_model::{Contact, Relief, Trajectory};
use solaris_profiles::UniformSpline;

/// A planned walk: its posture, and what the ground is to do, at any time.
///
/// It rests a little before it begins and after it has ended. Left and right feet are 0 and 1. Of a walk of more than 42 steps
/// of one pace the middle stride is planned once and repeated; *nodes* are those that were planned. The *clock* counts strides:
/// a step lasts half a stride, whatever its pace.
///
/// A walk backward is one forward in reversed time: postures, accelerations and forces are the same at the mirrored instant, so that it
/// obeys the same laws. Its clock runs down.
#[doc(alias = "gait")]
#[doc(alias = "locomotion")]
pub struct WalkPlan {
    pub(crate) body: Body,
    /// Of the walk that was planned.
    pub(crate) laws: WalkLaws,
    /// Of the whole walk: its course, its time, and how far along each of its prints lies (m).
    pub(super) whole: Course,
    tempo: Tempo,
    prints: Vec<f64>,
    /// The style that the walk is called after.
    steady: Style,
    pub(super) repeat: Repeat,
    /// The clock from which on a stride repeats itself, where there is one.
    loops: Option<f64>,
    /// Whether all is mirrored, so that the left foot goes first.
    pub(super) left_first: bool,
    /// Whether it is walked in reversed time.
    pub(super) backward: bool,
    /// Where and which way it begins.
    from: Print,
    pub(super) feet: [Foot; 2],
    /// Over the time in strides of the fastest pace, as the force is.
    pelvis: UniformSpline<3>,
    pub(super) timeline: Timeline,
    nodes: Vec<PrescribedNode>,
    /// Prescribed total force.
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
        Self::with_numbers(stride, steps, WalkNumbers::default(), resolution)
    }

    /// The same, begun and ended by other numbers than those that ship.
    ///
    /// # Errors
    ///
    /// A walk that does not close.
    pub fn with_numbers(
        stride: &StridePlan,
        steps: usize,
        numbers: WalkNumbers,
        resolution: Resolution,
    ) -> Result<Self, GaitError> {
        let of = |steps: usize| steps::even(steps, stride.style.step_length);
        let (whole, planned) = (of(steps), Steps::repeated(steps).map(of));
        let strides = std::slice::from_ref(stride);
        let steps = Steps {
            strides,
            standing: 0,
            steady: 0,
            numbers,
            cane_load: CANE_LOAD,
            whole: &whole,
            planned: planned.as_deref(),
            ground: None,
        };
        Self::of_steps(&steps, resolution)
    }

    /// Plans steps of several paces, right foot first, the other foot closing beside.
    ///
    /// # Errors
    ///
    /// A walk that does not close.
    pub(crate) fn of_steps(steps: &Steps<'_>, resolution: Resolution) -> Result<Self, GaitError> {
        let Steps { strides, standing, steady, numbers, cane_load, whole, planned, ground } = *steps;
        let planned = planned.unwrap_or(whole);
        let steady = strides[steady].style;
        let repeat = Repeat::new(whole.len(), planned.len(), resolution.nodes, steady.step_length);
        let body = strides[standing].body.clone();
        let laws = WalkLaws::new(&body, strides, standing, planned, (&numbers, cane_load), ground)?;
        let timeline = Timeline::new(&laws, resolution.nodes);
        let Solved { body, laws, timeline, feet, pelvis, nodes, corrections } =
            Passes::new(body, laws, timeline).run(resolution.walk_passes)?;
        let (first, spacing) = (timeline.start(), 1.0 / timeline.rate as f64);
        let spline = |values: Vec<[f64; 3]>| UniformSpline::resting(first, spacing, &values);
        let mut prints = vec![0.0];
        prints.extend(whole.iter().scan(0.0, |way, step| {
            *way += step.length;
            Some(*way)
        }));
        prints.push(prints[whole.len()]);
        Ok(Self {
            pelvis: spline(pelvis.iter().map(|&p| p.into()).collect())?,
            force: spline(
                nodes
                    .iter()
                    .enumerate()
                    .map(|(i, node)| node.force(laws.pivot(timeline.clock(i))).into())
                    .collect(),
            )?,
            timeline,
            body,
            tempo: if ground.is_some() {
                laws.gaits.tempo.clone()
            } else {
                laws.gaits.tempo_of(standing, whole)
            },
            whole: Course::new(
                whole,
                0.5 * strides[standing].style.step_width,
                ground.map_or(0.0, |ground| ground.standing),
                laws.course.begin,
            ),
            laws,
            loops: steps.loop_at(repeat.middle()).filter(|_| ground.is_none()),
            steady,
            prints,
            repeat,
            left_first: false,
            backward: false,
            from: Print::default(),
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

    /// The same in reversed time: it goes backward from where it would have come to, and begins where it would have begun, but over ground
    /// that is not level, which stays where it is.
    #[must_use]
    pub(crate) fn reversed(self) -> Self {
        let (place, heading) = self.destination();
        let from = if self.is_level() {
            let Print { place: begin, heading: faced, tilt } = self.from;
            Print {
                place: begin + turned(faced - heading, &(begin - place)),
                heading: 2.0 * faced - heading,
                tilt,
            }
        } else {
            self.from
        };
        // The last print is that of both feet before the first step, and the first one that of both after the last.
        let landed = &self.prints[..self.prints.len() - 1];
        let far = landed[landed.len() - 1];
        let prints = landed.iter().rev().map(|print| far - print).chain([far]).collect();
        Self { backward: !self.backward, from, prints, ..self }
    }

    /// The left foot's plane against the way the foot points.
    pub(crate) fn plane(&self) -> FootPlane {
        self.laws.plane
    }

    /// When the heel of step `step` rises (s).
    pub(crate) fn heel_rises(&self, step: usize) -> f64 {
        self.forward_time(0.5 * step as f64 + self.stance(step).heel_off())
    }

    /// How a foot stands in step `step`, in its print's frame.
    pub(crate) fn stance(&self, step: usize) -> &Stance {
        let side = step % 2;
        let episode = self.whole.episode(side, self.whole.episode_at(side, 0.5 * step as f64 + 0.01));
        &self.feet[side].stances[self.planned_print(&episode)]
    }

    /// When step `step` lands (s).
    pub(crate) fn lands(&self, step: usize) -> f64 {
        self.forward_time(0.5 * step as f64)
    }

    pub(crate) fn left_first(&self) -> bool {
        self.left_first
    }

    /// When step `step` has the other foot off the ground (s).
    pub(crate) fn stands_alone(&self, step: usize) -> f64 {
        self.forward_time(0.5 * step as f64 + self.laws.style(step).double_support)
    }

    /// Whether it goes backward.
    pub fn is_backward(&self) -> bool {
        self.backward
    }

    /// The same walk from another place on, turned to the left of where it pointed (m, rad).
    ///
    /// # Errors
    ///
    /// A root that turns in the order Z-Y-X and would face across, and a way along ground that is not level: that does not move.
    pub fn moved(self, place: Vector3<f64>, turn: f64) -> Result<Self, RequestError> {
        if !self.is_level() && (turn != 0.0 || place.y != 0.0 || place.z != 0.0) {
            return Err(RequestError::NotOnTerrain { what: "another place along it, or another heading," });
        }
        let Print { place: from, heading, tilt } = self.from;
        let heading = heading + turn;
        let turns = self.whole.headings().map(|turn| if self.left_first { -turn } else { turn });
        let widest = turns.fold(0.0, |widest: f64, turn| widest.max((heading + turn).abs()));
        check_turned(self.body.root_order, widest)?;
        Ok(Self {
            from: Print { place: place + turned(heading - self.from.heading, &from), heading, tilt },
            ..self
        })
    }

    /// Of a pair, the left foot's first.
    fn sided<T>(&self, [a, b]: [T; 2]) -> [T; 2] {
        if self.left_first { [b, a] } else { [a, b] }
    }

    /// A vector as the walk has it.
    fn seen(&self, v: Vector3<f64>) -> Vector3<f64> {
        turned(self.from.heading, &if self.left_first { mirror(&v) } else { v })
    }

    /// An axial vector, which the mirror turns the other way.
    fn seen_axial(&self, v: Vector3<f64>) -> Vector3<f64> {
        turned(self.from.heading, &if self.left_first { -mirror(&v) } else { v })
    }

    /// A point as the walk has it.
    fn seen_point(&self, p: Vector3<f64>) -> Vector3<f64> {
        self.from.place + self.seen(p)
    }

    /// The style of the steady part; where the pace changes, of the middle of the first part.
    pub fn style(&self) -> &Style {
        &self.steady
    }

    /// The style of a step, which count from 1; 0 is that of the standing feet.
    pub fn style_of_step(&self, step: usize) -> &Style {
        let step = if self.backward { (self.whole.steps + 1).saturating_sub(step) } else { step };
        // A little after the contact, where rounding does not decide which step it is.
        let (u, _) = self.repeat.fold(0.5 * step as f64 + 0.01);
        self.laws.style((2.0 * u) as usize)
    }

    /// Whether the style's numbers are held at the ends of what they were fitted to, see [`crate::Style::is_extrapolated`].
    pub fn is_extrapolated(&self) -> bool {
        (1..=self.laws.course.steps).any(|k| self.laws.style(k).is_extrapolated(&self.body.leg))
    }

    /// The standing height that the laws scale with (m): the figure's own, or what its legs suggest.
    pub fn stature(&self) -> f64 {
        self.body.height
    }

    /// Number of steps, without the closing one.
    pub fn steps(&self) -> usize {
        self.whole.steps
    }

    /// How far along the way heels are set down (m): both feet standing, each step, and the closing foot.
    pub fn prints(&self) -> &[f64] {
        &self.prints
    }

    /// Where the walk ends and which way it points there, to the left of z (m, rad).
    pub fn destination(&self) -> (Vector3<f64>, f64) {
        if self.backward {
            return (self.from.place, self.from.heading);
        }
        let last = self.whole.last();
        let turn = if self.left_first { -last.heading } else { last.heading };
        (self.seen_point(last.place), self.from.heading + turn)
    }

    /// Whether it goes over a horizontal plane.
    pub fn is_level(&self) -> bool {
        self.laws.relief.is_none()
    }

    /// The ground's heights along z, where it is not level.
    pub fn relief(&self) -> Option<&Relief> {
        self.laws.relief.as_ref()
    }

    /// Normals of the ground under left and right foot at a clock.
    pub(crate) fn normals(&self, clock: f64) -> [Vector3<f64>; 2] {
        self.support(clock).map(|foot| foot.normal.unwrap_or_else(Vector3::y))
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
        (self.nodes.len(), self.timeline.moving)
    }

    /// Clock of a node in the walk that was planned: 0 where left heel contact would have been before the first step.
    pub fn clock(&self, node: usize) -> f64 {
        self.timeline.clock(node)
    }

    /// Time (s) of a clock.
    pub fn time(&self, clock: f64) -> f64 {
        let time = self.forward_time(clock);
        if self.backward { self.duration() - time } else { time }
    }

    /// Time (s) of a clock where the walk goes forward.
    pub(super) fn forward_time(&self, clock: f64) -> f64 {
        let gaits = &self.laws.gaits;
        (self.tempo.time(clock) - self.tempo.time(self.whole.begin) + REST) * gaits.stride_time
    }

    /// Clock at a time (s).
    pub fn clock_at(&self, time: f64) -> f64 {
        let time = if self.backward { self.duration() - time } else { time };
        let gaits = &self.laws.gaits;
        self.tempo.clock(time / gaits.stride_time + self.tempo.time(self.whole.begin) - REST)
    }

    /// Centre of mass at a node (m).
    pub fn com(&self, node: usize) -> Vector3<f64> {
        self.seen_point(self.nodes[node].com)
    }

    /// Rate of the angular momentum about the centre of mass at a node (N m).
    pub fn momentum_rate(&self, node: usize) -> Vector3<f64> {
        self.seen_axial(self.nodes[node].momentum_rate)
    }

    /// Share and centre of pressure of both feet at a clock.
    pub fn support(&self, clock: f64) -> [FootSupport; 2] {
        let (u, advance) = self.repeat.fold(clock);
        let mut feet = self.laws.support(u);
        for foot in &mut feet {
            foot.cop = self.seen_point(foot.cop + Vector3::z() * advance);
        }
        self.sided(feet)
    }

    /// Prescribed wrenches of both feet at a node.
    pub fn forces(&self, node: usize) -> [Contact; 2] {
        let pivot = self.laws.pivot(self.clock(node));
        let feet = self.nodes[node].feet(pivot).map(|foot| {
            let force = self.seen(foot.force);
            let moment = self.seen_axial(foot.moment) + self.from.place.cross(&force);
            Contact { force, moment, cop: self.seen_point(foot.cop) }
        });
        self.sided(feet)
    }

    /// Prescribed total force at a clock (N).
    pub fn force(&self, clock: f64) -> Vector3<f64> {
        self.seen(self.planned_force(self.repeat.fold(clock).0))
    }

    fn planned_force(&self, u: f64) -> Vector3<f64> {
        Vector3::from(self.force.position(self.planned_time(u)))
    }

    /// What the ground does to the cane at a clock; none without a cane.
    pub fn cane(&self, clock: f64) -> Option<Contact> {
        let (u, advance) = self.repeat.fold(self.moving_clock(clock));
        let held = self.held_cane(u)?;
        let advance = Vector3::z() * advance;
        let [tip, fist] = [held.tip, held.fist].map(|at| self.seen_point(at + advance));
        Some(CaneNode { tip, fist, ..held }.contact(self.planned_force(u).y))
    }

    /// The cane at a clock of the walk that was planned.
    fn held_cane(&self, u: f64) -> Option<CaneNode> {
        self.body.cane?;
        let pelvis = Vector3::from(self.pelvis.position(self.planned_time(u)));
        self.laws.cane_at(&self.body, u, &pelvis)
    }

    /// By how much the hand that holds it is farther from its tip then than it is long (m); nothing without a cane.
    pub(super) fn beyond_cane(&self, u: f64) -> f64 {
        self.held_cane(u).map_or(0.0, |held| held.beyond())
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
        self.posture(clock).write(&self.body, &self.laws.plane, q);
    }

    /// The posture at a clock.
    pub(crate) fn posture(&self, clock: f64) -> Posture {
        let (u, advance) = self.repeat.fold(self.moving_clock(clock));
        let pelvis = Vector3::from(self.pelvis.position(self.planned_time(u)));
        let (trunk, arms, cane) = self.laws.upper(&self.body, u, &pelvis);
        let heading = self.laws.course.heading(u);
        let hips = self.hips(&pelvis, trunk[0], heading);
        let legs = self.legs_below(u, &hips);
        let feet = [0, 1].map(|side| self.laws.foot_heading(side, u) - heading);
        let pelvis = pelvis + Vector3::z() * advance;
        let carriage = self.laws.style(0).manner.carriage();
        let ahead = Posture { pelvis, trunk, arms, cane, carriage, legs, heading, feet };
        let seen = if self.left_first { ahead.mirrored() } else { ahead };
        let pelvis = self.from.place + turned(self.from.heading, &seen.pelvis);
        Posture { pelvis, heading: self.from.heading + seen.heading, ..seen }
    }

    /// Hips and poses of both legs at a clock of the walk that was planned.
    pub(crate) fn hips_and_legs(&self, u: f64) -> ([Vector3<f64>; 2], [LegPose; 2]) {
        let pelvis = Vector3::from(self.pelvis.position(self.planned_time(u)));
        let hips = self.hips(&pelvis, self.laws.angles(u).0[0], self.laws.course.heading(u));
        (hips, self.legs_below(u, &hips))
    }

    /// Hips of a pelvis with these angles against the way the body faces.
    fn hips(&self, pelvis: &Vector3<f64>, angles: Euler, heading: f64) -> [Vector3<f64>; 2] {
        let rotation = rotations::matrix(angles);
        let hip = |side: usize| pelvis + turned(heading, &(rotation * self.body.legs[side][0].offset));
        [hip(0), hip(1)]
    }

    /// Poses of both legs at a clock of the walk that was planned.
    fn legs_below(&self, u: f64, hips: &[Vector3<f64>; 2]) -> [LegPose; 2] {
        let pose = |side: usize| self.feet[side].pose(&self.laws, &self.body.sides[side], u, &hips[side]);
        [pose(0), pose(1)]
    }

    /// Time of a clock in strides of the fastest pace.
    fn planned_time(&self, u: f64) -> f64 {
        self.laws.gaits.tempo.time(u)
    }

    /// The middle stride, to be repeated; none of a walk of fewer than 42 steps, in which it still feels beginning or end.
    pub fn stride_loop(&self) -> Option<StrideLoop<'_, Self>> {
        let (body, style) = (&self.body, self.style());
        // A left contact, or a right one where all is mirrored.
        let contact = self.loops.filter(|_| self.from.heading == 0.0)?;
        // Of one backward, where the foot would have lifted.
        let (contact, way) = if self.backward { (contact + style.toe_off(), -2.0) } else { (contact, 2.0) };
        let nq = body.nq;
        let span = (self.time(contact), style.stride_time);
        Some(StrideLoop::new(self, nq, body.root + 2, span, way * style.step_length))
    }

    /// The style in which it ends.
    pub(crate) fn last_style(&self) -> &Style {
        self.laws.style(if self.backward { 0 } else { self.laws.course.steps })
    }

    /// The clock, or one at rest before or after the walk.
    fn moving_clock(&self, clock: f64) -> f64 {
        clock.clamp(self.whole.begin - 1.0, self.whole.end + 1.0)
    }
}

impl Trajectory for WalkPlan {
    fn duration(&self) -> f64 {
        self.forward_time(self.whole.end + REST)
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.configuration_at(self.clock_at(t), q);
    }

    /// The distance of the nodes (s).
    fn resolution(&self) -> f64 {
        self.timeline.grid.step
    }
}
