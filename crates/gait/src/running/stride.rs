//! One periodic stride of a run.

use super::extremes::{RunExtremes, greatest};
use super::forces::{Before, Carried, Prescribed};
use super::laws::{Amplitudes, ForceLaws};
use super::prints::left_pressure;
use super::style::RunStyle;
use super::trunk;
use crate::body::foot::{FootPlane, mirror};
use crate::body::leg::LegPose;
use crate::body::posture::Posture;
use crate::body::rotations::{self, Euler};
use crate::body::{Body, missing};
use crate::error::GaitError;
use crate::grid::{Ends, Grid};
use crate::limbs::stance::{Landing, Stance};
use crate::limbs::swing::Swing;
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::request::RunResolution;
use crate::walking::G;
use nalgebra::Vector3;
use solaris_model::{Contact, Figure};
use solaris_profiles::UniformSpline;

/// Part of the way that the trunk turns in a pass to where the angular momentum asks for it: with more, roll and yaw take each other
/// away.
const RELAXATION: f64 = 0.45;
/// Centre of mass against the pelvis' origin before anything is known (m).
const OFFSET: Vector3<f64> = Vector3::new(0.0, 0.06, 0.0);

/// A planned stride of a run: left contact at u = 0 with its print at z = 0, right at u = ½ with its print one step ahead; *u* is
/// the time since left contact over the stride's.
///
/// The force of the ground, its centre of pressure and its free moment are prescribed; so the centre of mass and the angular
/// momentum about it are known at all times, ballistic and constant in flight. The legs close in closed form, and the thorax turns
/// so that the whole body has that momentum.
#[doc(alias = "gait cycle")]
#[derive(Clone, Debug)]
pub struct RunStride {
    pub(crate) body: Body,
    style: RunStyle,
    laws: ForceLaws,
    amplitudes: Amplitudes,
    stance: Stance,
    swing: Swing,
    /// The pelvis in a frame that moves with the run, and the thorax' angles.
    pelvis: UniformSpline<3>,
    thorax: UniformSpline<3>,
    /// Centre of mass in that frame and angular momentum about it, by node; what the momentum's rate has more than the law's.
    com: Vec<Vector3<f64>>,
    momentum: Vec<Vector3<f64>>,
    excess: Vec<Vector3<f64>>,
}

/// Where the body is.
struct Place {
    pelvis: Vector3<f64>,
    trunk: [Euler; 5],
    /// Of each leg (left, right), seen as a left one from its print, which is lower where the sole gives: the hip and the pose.
    legs: [(Vector3<f64>, LegPose); 2],
}

/// What a pass found.
struct Pass {
    stance: Stance,
    swing: Swing,
    pelvis: Vec<Vector3<f64>>,
    thorax: Vec<Euler>,
    amplitudes: Amplitudes,
    momentum: Vec<Vector3<f64>>,
    rate: Vec<Vector3<f64>>,
}

impl RunStride {
    /// Plans a stride in this style: any numbers that solve are taken, [`crate::run`] checks ranges and laws.
    ///
    /// # Errors
    ///
    /// A figure that the planner does not know, numbers that are none, and a stride that does not close.
    pub fn new(figure: &Figure, style: &RunStyle, resolution: RunResolution) -> Result<Self, GaitError> {
        missing::check(figure)?;
        Self::plan(Body::of(figure)?.with_legs_alike()?, style, resolution)
    }

    pub(crate) fn plan(body: Body, style: &RunStyle, resolution: RunResolution) -> Result<Self, GaitError> {
        resolution.check()?;
        style.check()?;
        let n = resolution.nodes;
        let half = n / 2;
        let grid = Grid { count: n, step: style.stride_time / n as f64, ends: Ends::Periodic };
        let clock = |i: usize| i as f64 / n as f64;
        let leg = body.leg;
        let laws = ForceLaws::new(style, n)?;
        let prescribed = Prescribed::new(&body, style, &laws, n);
        let upper_of = |thorax: &[Euler]| {
            UpperBody::new(
                &body,
                &grid,
                |_| trunk::carriage(style),
                |i| {
                    let u = clock(i);
                    (trunk::trunk(style, u, thorax[i]), trunk::arms(style, u), 0.0)
                },
            )
        };
        let drawn: Vec<Euler> = (0..n).map(|i| trunk::thorax(style, clock(i))).collect();
        let mut thorax = drawn.clone();
        let mut upper = upper_of(&thorax);
        let plane = FootPlane::new(style.foot_yaw);
        // The pelvis' law does not change, and it is all that the kernel takes of the trunk.
        let mut kernel = MomentumKernel::new(&body, &grid, &upper, plane, |_, _| 0.0, |_, _| 0.0);
        let hips: Vec<Vector3<f64>> = (0..n).map(|i| upper.pelvis(i) * leg.hip).collect();

        let mut height: Vec<f64> = prescribed.height.iter().map(|height| height + leg.length()).collect();
        let mut offset = vec![OFFSET; n];
        let mut last: Option<Pass> = None;
        for _ in 0..resolution.passes {
            let before = last.as_ref();
            if let Some(Pass { momentum, rate, .. }) = before {
                turn(&prescribed, &mut thorax, &drawn, rate, momentum);
                upper = upper_of(&thorax);
            }
            let before =
                before.map(|pass| Before { momentum: &pass.momentum, thorax: &thorax, drawn: &drawn });
            let Carried { amplitudes, mut com, momentum_rate } = prescribed.carry(&height, before.as_ref());
            let hip_nodes: Vec<[f64; 3]> = (0..n).map(|i| (com[i] - offset[i] + hips[i]).into()).collect();
            let spline = UniformSpline::periodic(0.0, 1.0 / n as f64, &hip_nodes)?;
            let hip_at = |u: f64, rise: f64| {
                Vector3::from(spline.position(u)) + Vector3::new(0.0, rise, 2.0 * style.step_length * u)
            };
            let landing = style.landing();
            let mut stance = Stance::new(&leg, &style.footing(), landing, style.push());
            // At contact the hip is where the foot's pitch and the knee of the style put it.
            let from_ankle = hip_at(0.0, 0.0) - stance.landing_ankle(-style.heel_strike_angle);
            let reach = leg.reach_squared(style.knee_contact) - from_ankle.x.powi(2) - from_ankle.z.powi(2);
            let rise = reach.max(1e-6).sqrt() - from_ankle.y;
            for (height, com) in height.iter_mut().zip(&mut com) {
                *height += rise;
                com.y += rise;
            }
            // A sole that gives is lower under the body: seen from it the hip is higher.
            let hip = |u: f64| hip_at(u, rise + style.given(u));
            // On the ball the pitch of the foot is a law, and the knee follows.
            let knee = (landing == Landing::Heel).then(|| style.contact_knee());
            if let Some(knee) = knee {
                stance.set_contact(knee, hip)?;
            }
            stance.set_push(hip)?;
            let contact = stance.contact_jet(knee, hip);
            let mut swing = style.swing(&stance.toe_off_jet(hip), &contact)?;
            let swinging = (0..n).filter(|&i| clock(i) > style.duty);
            let heights: Vec<(f64, f64)> = swinging.map(|i| (clock(i), hip_nodes[i][1] + rise)).collect();
            swing.clear_ground(&leg, &style.ground_clearance(), &heights);
            let poses: Vec<LegPose> = (0..n)
                .map(|i| match clock(i) {
                    u if u <= style.duty => stance.pose(u, &hip(u)),
                    u => swing.pose(&leg, u),
                })
                .collect();
            let momentum = kernel.momentum(&upper, |i| [poses[i], poses[(i + half) % n]]);
            let pelvis = (0..n).map(|i| com[i] - offset[i]).collect();
            offset = momentum.com;
            last = Some(Pass {
                stance,
                swing,
                pelvis,
                thorax: thorax.clone(),
                amplitudes,
                momentum: momentum.angular,
                rate: momentum_rate,
            });
        }
        let Some(pass) = last else { unreachable!("at least one pass") };
        let rows = |all: &[Vector3<f64>]| all.iter().map(|&row| row.into()).collect::<Vec<[f64; 3]>>();
        let excess = (0..n).map(|i| grid.first(i, |j| pass.momentum[j]) - pass.rate[i]);
        Ok(Self {
            pelvis: UniformSpline::periodic(0.0, 1.0 / n as f64, &rows(&pass.pelvis))?,
            thorax: UniformSpline::periodic(0.0, 1.0 / n as f64, &pass.thorax)?,
            com: pass.pelvis.iter().zip(&offset).map(|(pelvis, offset)| pelvis + offset).collect(),
            excess: excess.collect(),
            momentum: pass.momentum,
            amplitudes: pass.amplitudes,
            stance: pass.stance,
            swing: pass.swing,
            style: *style,
            laws,
            body,
        })
    }

    /// The style that was planned.
    pub fn style(&self) -> &RunStyle {
        &self.style
    }

    /// Nodes of the stride.
    pub fn node_count(&self) -> usize {
        self.com.len()
    }

    /// Centre of mass at a node (m).
    pub fn com(&self, node: usize) -> Vector3<f64> {
        let u = node as f64 / self.com.len() as f64;
        self.com[node] + Vector3::z() * (2.0 * self.style.step_length * u)
    }

    /// Angular momentum about the centre of mass at a node (N m s).
    pub fn angular_momentum(&self, node: usize) -> Vector3<f64> {
        self.momentum[node]
    }

    /// By how much the rate of the body's angular momentum differs from the law's at a node (N m).
    pub fn momentum_excess(&self, node: usize) -> Vector3<f64> {
        self.excess[node]
    }

    /// Angles of the thorax in the world about z, y, x at the clock `u` (rad).
    pub fn thorax(&self, u: f64) -> [f64; 3] {
        self.thorax.position(u)
    }

    /// Writes the figure's coordinates at the clock `u`, any number, to `q` (length `nq`).
    pub fn configuration(&self, u: f64, q: &mut [f64]) {
        self.posture(u).write(&self.body, &self.stance.plane, q);
    }

    /// Writes the mirror image, in which the right foot touches at u = 0, to `q`.
    pub(super) fn mirrored_configuration(&self, u: f64, q: &mut [f64]) {
        self.posture(u).mirrored().write(&self.body, &self.stance.plane, q);
    }

    /// World pitch of foot and toes (rad, toe down), left and right, at the clock `u`.
    pub fn foot_pitches(&self, u: f64) -> [(f64, f64); 2] {
        self.posture(u).legs.map(|pose| (pose.pitch, pose.toes))
    }

    fn posture(&self, u: f64) -> Posture {
        let Place { pelvis, trunk, legs } = self.place(u);
        let legs = legs.map(|(_, pose)| pose);
        let arms = trunk::arms(&self.style, u);
        Posture {
            pelvis,
            trunk,
            arms,
            cane: [0.0; 2],
            carriage: trunk::carriage(&self.style),
            legs,
            heading: 0.0,
            feet: [0.0; 2],
        }
    }

    fn place(&self, u: f64) -> Place {
        let advance = Vector3::z() * (2.0 * self.style.step_length);
        let pelvis = Vector3::from(self.pelvis.position(u)) + advance * u;
        let trunk = trunk::trunk(&self.style, u, self.thorax.position(u));
        let rotation = rotations::matrix(trunk[0]);
        let legs = [0, 1].map(|side| {
            let contact = contact(side, u);
            let hip = pelvis + rotation * self.body.legs[side][0].offset;
            let hip = if side == 0 { hip } else { mirror(&hip) };
            let v = u - contact;
            let hip = hip - advance * contact;
            if v > self.style.duty {
                return (hip, self.swing.pose(&self.body.leg, v));
            }
            let hip = hip + Vector3::y() * self.style.given(v);
            (hip, self.stance.pose(v, &hip))
        });
        Place { pelvis, trunk, legs }
    }

    /// What it asks of soles and legs, at `instants` clocks.
    pub fn extremes(&self, instants: usize) -> RunExtremes {
        let leg = &self.body.leg;
        let toe = leg.toe_polar();
        let mut found = RunExtremes::none();
        found.momentum_excess = greatest(self.excess.iter().map(Vector3::amax));
        for i in 0..instants {
            // Left and right are mirror images: one leg says it all.
            let u = i as f64 / instants as f64;
            let (hip, pose) = self.place(u).legs[0];
            let ankle = hip.y - leg.ankle_below_hip(&pose) * pose.side.cos();
            let short = if u <= self.style.duty { self.stance.short(u, &hip) } else { 0.0 };
            found.note_leg(pose.knee, -leg.lowest(toe, ankle, pose.pitch, pose.toes), short);
            found.note_force(&self.forces(u)[0].force, self.body.mass * G);
        }
        found
    }

    /// Prescribed wrenches of left and right foot at the clock `u`, any number: all zero in flight.
    #[doc(alias = "grf")]
    #[doc(alias = "ground reaction force")]
    pub fn forces(&self, u: f64) -> [Contact; 2] {
        [0, 1].map(|side| {
            let contact = contact(side, u);
            let part = (u - contact) / self.style.duty;
            if !super::laws::on_ground(part) {
                return Contact::default();
            }
            let (laws, weight) = (self.laws.at(part), self.body.mass * G);
            let sum = |laws: &[f64], by: &[f64]| laws.iter().zip(by).map(|(law, a)| law * a).sum::<f64>();
            let Amplitudes { fore_aft, lateral, twist } = &self.amplitudes;
            let force = Vector3::new(
                weight * sum(&laws.lateral, lateral),
                weight * laws.vertical,
                weight * sum(&laws.fore_aft, fore_aft),
            );
            let free = sum(&laws.twist, twist);
            let cop = left_pressure(&self.style, &self.laws, self.body.leg.foot_length(), part);
            // The mirror turns an axial vector the other way.
            let (force, free, cop) =
                if side == 0 { (force, free, cop) } else { (mirror(&force), -free, mirror(&cop)) };
            let cop = cop + Vector3::z() * (2.0 * self.style.step_length * contact);
            Contact { force, moment: cop.cross(&force) + Vector3::y() * free, cop }
        })
    }
}

/// When the foot of a side touched last: contacts of the left one at 0, 1, …, of the right one at −½, ½, …
fn contact(side: usize, u: f64) -> f64 {
    if side == 0 { u.floor() } else { (u + 0.5).floor() - 0.5 }
}

/// Turns the thorax towards where the angular momentum asks for it; the mean of its angles is what it is drawn to.
fn turn(
    prescribed: &Prescribed,
    thorax: &mut [Euler],
    drawn: &[Euler],
    rate: &[Vector3<f64>],
    momentum: &[Vector3<f64>],
) {
    for (angles, turn) in thorax.iter_mut().zip(prescribed.turn(rate, momentum)) {
        (0..3).for_each(|k| angles[k] += RELAXATION * turn[k]);
    }
    let count = drawn.len() as f64;
    for k in 0..3 {
        let mean = |rows: &[Euler]| rows.iter().map(|row| row[k]).sum::<f64>() / count;
        let shift = mean(drawn) - mean(thorax);
        for angles in thorax.iter_mut() {
            angles[k] += shift;
        }
    }
}
