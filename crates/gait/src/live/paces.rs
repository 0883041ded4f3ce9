//! The steady strides that a live walk is made of: one for each of some speeds, planned when the walker is built.
//!
//! What a stride says of a leg on its own clock `v` (0 at contact, 1 a stride later), of the pressure under a foot, and of the body, is kept as
//! curves; between two speeds everything is mixed in proportion.

use crate::body::Body;
use crate::body::foot::FootPlane;
use crate::body::leg::{LegGeometry, LegPose};
use crate::body::rotations;
use crate::error::GaitError;
use crate::limbs::sole::Sole;
use crate::request::{Resolution, WALK_RATIO};
use crate::smooth::laws::{self, Swings};
use crate::smooth::{Footfall, Manner, Standing, StridePlan, Style, StyleTable};
use crate::walking::G;
use nalgebra::Vector3;
use solaris_profiles::{UniformSpline, step};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Speeds at which strides are planned.
const COUNT: usize = 12;
/// The shortest step that is planned, over the leg: shorter ones are made of it.
const SHORTEST: f64 = 0.30;
/// Steps a minute of the slowest and of the fastest walk.
pub(super) const CADENCE: (f64, f64) = (62.0, 120.0);
/// How sharply the law of cadence bends from people's walk ratio to the slowest cadence.
const BEND: i32 = 8;
/// The step over the leg from which on a foot lands as people's do; shorter ones land flatter, and pelvis and arms swing less.
const SHORT: f64 = 0.45;
/// The least part of the pitch, and of the swings, that is left on the spot.
const LEAST: f64 = 0.15;
/// The step over the leg from which on, and to which, styles of unsteady steps go over to those of steady ones.
const STEADY: (f64, f64) = (0.36, 0.52);
/// What a thigh swings forward less in the shortest steps, and how much more bent its knee is late in swing (rad).
const SHORT_THIGH: f64 = 6.0 * DEGREE;
const SHORT_KNEE: f64 = 8.0 * DEGREE;
/// Nodes and passes of a stride.
const RESOLUTION: (usize, usize) = (160, 6);
/// The greatest rate of the angular momentum over the weight (m).
const STEEPEST_RATE: f64 = 0.13;
/// Until when the pressure under a foot is kept (own clock).
const PRESSED_UNTIL: f64 = 0.76;

/// One steady stride.
struct Pace {
    style: Style,
    /// Mean height of the centre of mass (m).
    mean_height: f64,
    /// Ankle against the heel's print, left, up and forward less what a stride goes (m); pitches of foot and toes (rad).
    leg: UniformSpline<5>,
    /// Centre of pressure along the foot from the heel, and outward of its axis (parts of its length).
    press: UniformSpline<2>,
    /// Centre of mass against the pelvis (m); rates of the angular momentum about x and z (N m).
    body: UniformSpline<5>,
    /// Way and velocity of the centre of mass at contact, against the landed heel: x and z (m, m/s).
    contact: [[f64; 2]; 2],
}

/// Steady strides of some speeds, and the posture in which the figure stands.
pub(super) struct Paces {
    pub(super) body: Body,
    pub(super) plane: FootPlane,
    pub(super) standing: Standing,
    sole: Sole,
    strides: Vec<Pace>,
    /// The least speed that was planned, and the distance of the speeds (m/s).
    slowest: f64,
    spacing: f64,
}

/// A speed between two of those that were planned: the first one and the part of the way to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Mix {
    first: usize,
    part: f64,
}

/// A leg by the tables.
#[derive(Clone, Copy, Debug)]
pub(super) struct LegLaw {
    /// Ankle against the heel of the last print in its frame, with what the stride goes (m).
    pub(super) ankle: Vector3<f64>,
    pub(super) pitch: f64,
    pub(super) toes: f64,
}

impl Paces {
    pub(super) fn new(body: Body) -> Result<Self, GaitError> {
        let fastest = WALK_RATIO * body.height * CADENCE.1 * CADENCE.1 / 60.0;
        let slowest = SHORTEST * body.leg.length() * CADENCE.0 / 60.0;
        let spacing = (fastest - slowest) / (COUNT - 1) as f64;
        let mut strides = Vec::with_capacity(COUNT);
        for i in 0..COUNT {
            strides.push(Pace::new(&body, slowest + i as f64 * spacing)?);
        }
        let standing = Standing::new(&body, &strides[0].style, 0.0);
        let plane = FootPlane::new(strides[0].style.foot_yaw);
        let sole = Sole::new(&body.leg, &plane, 0.0, Vector3::zeros());
        Ok(Self { body, plane, standing, sole, strides, slowest, spacing })
    }

    /// The sole of a left foot with its heel at the origin.
    pub(super) fn sole(&self) -> &Sole {
        &self.sole
    }

    /// The greatest speed (m/s).
    pub(super) fn fastest(&self) -> f64 {
        self.slowest + self.spacing * (self.strides.len() - 1) as f64
    }

    /// The mix for a speed (m/s), the nearest one that there is.
    pub(super) fn at(&self, speed: f64) -> Mix {
        let x = ((speed - self.slowest) / self.spacing).clamp(0.0, (self.strides.len() - 1) as f64);
        let first = (x as usize).min(self.strides.len() - 2);
        Mix { first, part: x - first as f64 }
    }

    fn pair(&self, mix: Mix) -> [&Pace; 2] {
        [&self.strides[mix.first], &self.strides[mix.first + 1]]
    }

    /// The style of a speed.
    pub(super) fn style(&self, mix: Mix) -> Style {
        let [a, b] = self.pair(mix);
        let mut style = a.style.mixed(&b.style, mix.part);
        style.stride_time += (b.style.stride_time - a.style.stride_time) * mix.part;
        style.step_frequency = 120.0 / style.stride_time;
        style.manner =
            Manner::of_people(2.0 * style.step_length / style.stride_time / self.body.scale().sqrt());
        style
    }

    /// Mean height of the centre of mass (m).
    pub(super) fn mean_height(&self, mix: Mix) -> f64 {
        let [a, b] = self.pair(mix);
        a.mean_height + (b.mean_height - a.mean_height) * mix.part
    }

    /// The leg on its own clock.
    pub(super) fn leg(&self, mix: Mix, v: f64) -> LegLaw {
        let [a, b] = self.pair(mix);
        let [x, y, z, pitch, toes] = mixed(a.leg.position(v), b.leg.position(v), mix.part);
        let length = a.style.step_length + (b.style.step_length - a.style.step_length) * mix.part;
        LegLaw { ankle: Vector3::new(x, y, z + 2.0 * length * v), pitch, toes }
    }

    /// Pitch of a foot that has just landed, with its rate and second derivative by the own clock (rad).
    pub(super) fn landing(&self, mix: Mix) -> [f64; 3] {
        let [a, b] = self.pair(mix).map(|pace| {
            let at = pace.leg.at(3, 0.0);
            [at.position, at.velocity, at.acceleration]
        });
        mixed(a, b, mix.part)
    }

    /// Length of the shortest step that was planned (m).
    pub(super) fn shortest(&self) -> f64 {
        self.strides[0].style.step_length
    }

    /// Centre of pressure along the foot and outward of its axis (m).
    pub(super) fn press(&self, mix: Mix, v: f64) -> [f64; 2] {
        let [a, b] = self.pair(mix);
        let length = self.body.leg.foot_length();
        mixed(a.press.position(v), b.press.position(v), mix.part).map(|part| part * length)
    }

    /// Centre of mass against the pelvis (m), and rates of the angular momentum about x and z (N m), at the clock `u` of a body whose
    /// left foot has landed last at 0.
    pub(super) fn carried(&self, mix: Mix, u: f64) -> (Vector3<f64>, [f64; 2]) {
        let [a, b] = self.pair(mix);
        let [x, y, z, hx, hz] = mixed(a.body.position(u), b.body.position(u), mix.part);
        (Vector3::new(x, y, z), [hx, hz])
    }

    /// Way and velocity of the centre of mass as the left foot lands, against its heel: x and z (m, m/s).
    pub(super) fn contact(&self, mix: Mix) -> [[f64; 2]; 2] {
        let [a, b] = self.pair(mix);
        [0, 1].map(|i| mixed(a.contact[i], b.contact[i], mix.part))
    }
}

fn mixed<const D: usize>(a: [f64; D], b: [f64; D], part: f64) -> [f64; D] {
    std::array::from_fn(|i| a[i] + (b[i] - a[i]) * part)
}

/// The style of a speed (m/s). Steps a minute follow people's walk ratio, `v = 0.0037·H·sf²/60`, and bend to the slowest cadence:
///
/// ```text
/// sf = (sf₀⁸ + (60 v/(0.0037 H))⁴)^⅛
/// ```
fn style_of(body: &Body, speed: f64) -> Style {
    let people = 60.0 * speed / (WALK_RATIO * body.height);
    let cadence = (CADENCE.0.powi(BEND) + people.powi(BEND / 2)).powf(1.0 / f64::from(BEND));
    let length = 60.0 * speed / cadence;
    let of = |table: &StyleTable| Style::from_table(table, &body.leg, body.height, cadence, length);
    let steady = step::quintic((length / body.leg.length() - STEADY.0) / (STEADY.1 - STEADY.0)).position;
    let mut style = of(&StyleTable::unsteady()).mixed(&of(&StyleTable::default()), steady);
    style.footfall = Footfall::PEOPLE;
    style.heel_off = style.heel_off.min(style.footfall.latest_heel_off);
    let part = LEAST + (1.0 - LEAST) * (length / (SHORT * body.leg.length())).min(1.0);
    for number in [
        &mut style.heel_strike_angle,
        &mut style.pelvic_rotation,
        &mut style.thorax_yaw,
        &mut style.arm_swing,
        &mut style.knee_contact_rate,
        &mut style.knee_contact_acc,
    ] {
        *number *= part;
    }
    style.thigh_swing -= (1.0 - part) * SHORT_THIGH;
    style.knee_late_swing += (1.0 - part) * SHORT_KNEE;
    style.knee_contact += (1.0 - part) * SHORT_KNEE;
    style
}

impl Pace {
    fn new(body: &Body, speed: f64) -> Result<Self, GaitError> {
        let style = style_of(body, speed);
        let (n, passes) = RESOLUTION;
        let resolution = Resolution { nodes: n, stride_passes: passes, ..Resolution::default() };
        let plan = StridePlan::plan(body.clone(), &style, resolution)?;
        let plane = FootPlane::new(style.foot_yaw);
        let step = 1.0 / n as f64;
        let heel = Vector3::new(style.step_width / 2.0, 0.0, 0.0);
        let mut legs = Vec::with_capacity(n);
        let mut carried = Vec::with_capacity(n);
        for i in 0..n {
            let u = i as f64 * step;
            let (pelvis, [pose, _]) = plan.place(u);
            let trunk = laws::trunk(&style, u, Swings::ALL);
            let hip = pelvis + rotations::matrix(trunk[0]) * body.leg.hip;
            let ankle = ankle_of(&body.leg, &plane, &hip, &pose) - heel;
            legs.push([ankle.x, ankle.y, ankle.z - 2.0 * style.step_length * u, pose.pitch, pose.toes]);
            let (offset, rate) = (plan.com_offset[i], plan.momentum_rate(i));
            // Single samples where a foot lands are steeper than any pressure would follow.
            let most = STEEPEST_RATE * body.mass * G;
            let [x, z] = [rate.x, rate.z].map(|rate| rate.clamp(-most, most));
            carried.push([offset.x, offset.y, offset.z, x, z]);
        }
        let way: Vec<[f64; 2]> = (0..n)
            .map(|i| [plan.com(i).x, plan.com(i).z - 2.0 * style.step_length * (i as f64 * step)])
            .collect();
        let [at, rate, _] = UniformSpline::periodic(0.0, step, &way)?.jet(0.0);
        let contact = [
            [at[0] - heel.x, at[1]],
            [rate[0] / style.stride_time, (rate[1] + 2.0 * style.step_length) / style.stride_time],
        ];
        let cop = laws::cop(&style)?;
        let pressed: Vec<[f64; 2]> = (0..=(PRESSED_UNTIL / step) as usize)
            .map(|i| {
                let v = (i as f64 * step).min(style.toe_off());
                [cop.at(v).position, style.footfall.outward(v, style.toe_off())]
            })
            .collect();
        Ok(Self {
            style,
            mean_height: plan.mean_height(),
            leg: UniformSpline::periodic(0.0, step, &legs)?,
            press: UniformSpline::resting(0.0, step, &pressed)?,
            body: UniformSpline::periodic(0.0, step, &carried)?,
            contact,
        })
    }
}

/// The ankle of a leg below a hip, both of the left side.
fn ankle_of(leg: &LegGeometry, plane: &FootPlane, hip: &Vector3<f64>, pose: &LegPose) -> Vector3<f64> {
    let (sin, cos) = pose.side.sin_cos();
    let up = Vector3::y() * cos + plane.left * sin;
    hip + plane.forward * leg.ankle_ahead_of_hip(pose) - up * leg.ankle_below_hip(pose)
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::Human;

    #[test]
    fn strides_of_all_speeds_land_as_they_go_on() {
        for height in [1.2, 1.5, 1.75, 1.95] {
            let figure = Human::new(height, 23.8 * height * height).build().expect("a person");
            let paces = Paces::new(Body::of(&figure).expect("a body")).expect("strides");
            for pace in &paces.strides {
                let mix = paces.at(2.0 * pace.style.step_length / pace.style.stride_time);
                let [before, after] = [1.0 - 1e-4, 1e-4].map(|v| paces.leg(mix, v));
                let way = after.ankle - before.ankle + Vector3::z() * (2.0 * pace.style.step_length);
                assert!(way.norm() < 2e-3, "{height} m, {:.0}/min: {way}", pace.style.step_frequency);
                assert!((after.pitch - before.pitch).abs() < 0.02);
            }
        }
    }
}
