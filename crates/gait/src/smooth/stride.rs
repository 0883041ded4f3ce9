//! One periodic stride: two steps of steady walking.

mod leg;
mod nodes;

use crate::body::Body;
use crate::body::foot::{FootPlane, mirror};
use crate::body::leg::LegPose;
use crate::body::missing;
use crate::body::posture::Posture;
use crate::body::rotations;
use crate::error::GaitError;
use crate::grid::{Ends, Grid};
use crate::limbs::jet::LegJet;
use crate::limbs::path::Air;
use crate::limbs::stance::Stance;
use crate::momentum::MomentumKernel;
use crate::momentum::upper::UpperBody;
use crate::request::Resolution;
use crate::smooth::laws::{self, Swings};
use crate::smooth::prescribed::PrescribedNode;
use crate::smooth::style::Style;
use leg::{StrideLeg, spare_height};
use nalgebra::Vector3;
use nodes::Laws;
use solaris_analysis::FootSupport;
use solaris_model::{Contact, Figure};
use solaris_profiles::UniformSpline;

/// Part of the way to the momentum found that each pass goes but the first, which goes all of it.
const RELAXATION: f64 = 0.8;

/// A planned stride: left heel contact at u = 0 with its print at z = 0, right at u = ½ with its print one step ahead.
#[doc(alias = "gait cycle")]
pub struct StridePlan {
    pub(crate) body: Body,
    pub(crate) style: Style,
    stance: Stance,
    swing: Air,
    /// The pelvis in a frame that moves with the walk.
    pelvis: UniformSpline<3>,
    nodes: Vec<PrescribedNode>,
    /// Centre of mass against the pelvis' origin, by node.
    pub(crate) com_offset: Vec<Vector3<f64>>,
    pub(crate) contact: LegJet,
}

impl StridePlan {
    /// Plans a stride in this style: any parameters that solve are taken, [`crate::walk`] checks ranges.
    ///
    /// # Errors
    ///
    /// A figure that the walker does not know, and a stride that does not close.
    pub fn new(figure: &Figure, style: &Style, resolution: Resolution) -> Result<Self, GaitError> {
        missing::check(figure)?;
        Self::plan(Body::of(figure)?.with_legs_alike()?, style, resolution)
    }

    pub(crate) fn plan(body: Body, style: &Style, resolution: Resolution) -> Result<Self, GaitError> {
        resolution.check()?;
        style.check()?;
        let n = resolution.nodes;
        let half = n / 2;
        let grid = Grid { count: n, step: style.stride_time / n as f64, ends: Ends::Periodic };
        let clock = |i: usize| i as f64 / n as f64;
        let stride = Vector3::new(0.0, style.rise(), style.step_length) * 2.0;
        let leg = body.leg;
        let laws = Laws::new(&body, style, n)?;
        let upper = UpperBody::new(
            &body,
            &grid,
            |_| style.manner.carriage(),
            |i| {
                let (trunk, arms) = angles(style, clock(i));
                (trunk, arms, 0.0)
            },
        );
        let plane = FootPlane::new(style.foot_yaw);
        let mut kernel = MomentumKernel::new(&body, &grid, &upper, plane, |_, _| 0.0, |_, _| style.slope);
        let hips: Vec<Vector3<f64>> = (0..n).map(|i| upper.pelvis(i) * leg.hip).collect();
        let toe_off = style.toe_off();
        let swinging: Vec<f64> = (0..n).map(clock).filter(|&u| u > toe_off).collect();

        let mut com: Vec<Vector3<f64>> =
            (0..n).map(|i| Vector3::new(0.0, laws.height[i] + leg.length() * 1.026, 0.0)).collect();
        let mut offset = vec![Vector3::new(0.0, 0.05, 0.0); n];
        let mut momentum_rate = vec![Vector3::zeros(); n];
        let mut tilting = vec![Vector3::zeros(); n];
        let mut last = None;
        for pass in 0..resolution.stride_passes.max(1) {
            let own: Vec<Vector3<f64>> =
                momentum_rate.iter().zip(&tilting).map(|(rate, tilting)| rate - tilting).collect();
            laws.centre_of_mass(&grid, &own, &mut com)?;
            let hip_nodes: Vec<[f64; 3]> = (0..n).map(|i| (com[i] - offset[i] + hips[i]).into()).collect();
            let spline = UniformSpline::periodic(0.0, 1.0 / n as f64, &hip_nodes)?;
            let hip_at =
                |u: f64, rise: f64| Vector3::from(spline.position(u)) + Vector3::y() * rise + stride * u;
            let stance = Stance::new(&leg, &style.footing(), style.landing(), style.push());
            let rise = spare_height(&stance, style, &leg, |u| hip_at(u, 0.0));
            for com in &mut com {
                com.y += rise;
            }
            let hip = |u: f64| hip_at(u, rise);
            let StrideLeg { stance, swing, contact } = StrideLeg::new(style, &leg, stance, hip, &swinging)?;
            let poses: Vec<LegPose> = (0..n)
                .map(|i| match clock(i) {
                    u if u <= toe_off => stance.pose(u, &hip(u)),
                    u => swing.pose(&plane, &leg, u, &hip(u)),
                })
                .collect();
            let momentum = kernel.momentum(&upper, |i| [poses[i], poses[(i + half) % n]]);
            let rate: Vec<Vector3<f64>> = (0..n).map(|i| grid.first(i, |j| momentum.angular[j])).collect();
            let pelvis: Vec<Vector3<f64>> = (0..n).map(|i| com[i] - offset[i]).collect();
            let relaxation = if pass == 0 { 1.0 } else { RELAXATION };
            for (old, new) in momentum_rate.iter_mut().zip(&rate) {
                *old += (new - *old) * relaxation;
            }
            offset = momentum.com;
            let nodes: Vec<PrescribedNode> = (0..n)
                .map(|i| PrescribedNode {
                    com: pelvis[i] + offset[i] + stride * clock(i),
                    vertical: laws.vertical[i],
                    momentum_rate: rate[i],
                    feet: laws.feet[i],
                    cane: None,
                    tilting: tilting[i],
                })
                .collect();
            if style.slope != 0.0 {
                tilting = nodes.iter().map(|node| node.needed_tilting(style.pivot)).collect();
            }
            last = Some((stance, swing, contact, pelvis, nodes));
        }
        let Some((stance, swing, contact, pelvis, nodes)) = last else { unreachable!("at least one pass") };
        let pelvis_nodes: Vec<[f64; 3]> = pelvis.iter().map(|&p| p.into()).collect();
        let pelvis = UniformSpline::periodic(0.0, 1.0 / n as f64, &pelvis_nodes)?;
        Ok(Self { body, style: *style, stance, swing, pelvis, nodes, com_offset: offset, contact })
    }

    /// The style that was planned.
    pub fn style(&self) -> &Style {
        &self.style
    }

    /// Nodes a stride.
    pub fn node_count(&self) -> usize {
        self.nodes.len()
    }

    /// Mean height of the centre of mass above the line through the prints (m).
    pub fn mean_height(&self) -> f64 {
        let risen = |i: usize| 2.0 * self.style.rise() * i as f64 / self.nodes.len() as f64;
        self.nodes.iter().enumerate().map(|(i, node)| node.com.y - risen(i)).sum::<f64>()
            / self.nodes.len() as f64
    }

    /// Writes the figure's coordinates at the clock `u`, any number, to `q` (length `nq`).
    pub fn configuration(&self, u: f64, q: &mut [f64]) {
        let (pelvis, legs) = self.place(u);
        let (trunk, arms) = angles(&self.style, u);
        let carriage = self.style.manner.carriage();
        Posture { pelvis, trunk, arms, cane: [0.0; 2], carriage, legs, heading: 0.0, feet: [0.0; 2] }.write(
            &self.body,
            &self.stance.plane,
            q,
        );
    }

    /// World pitch of foot and toes (rad, toe down), left and right, at the clock `u`.
    pub fn foot_pitches(&self, u: f64) -> [(f64, f64); 2] {
        self.place(u).1.map(|pose| (pose.pitch, pose.toes))
    }

    /// Knee flexion (rad), left and right, at the clock `u`.
    pub fn knees(&self, u: f64) -> [f64; 2] {
        self.place(u).1.map(|pose| pose.knee)
    }

    /// How far a stride goes, upward and forward (m).
    fn advance(&self) -> Vector3<f64> {
        Vector3::new(0.0, self.style.rise(), self.style.step_length) * 2.0
    }

    /// The pelvis and both legs at the clock `u`; each leg's pose is one of a left leg.
    pub(crate) fn place(&self, u: f64) -> (Vector3<f64>, [LegPose; 2]) {
        let stride = self.advance();
        let pelvis = Vector3::from(self.pelvis.position(u)) + stride * u;
        let (trunk, _) = angles(&self.style, u);
        let rotation = rotations::matrix(trunk[0]);
        let legs = [0, 1].map(|side| {
            // Contacts of the left foot at 0, 1, …, of the right one at −½, ½, …
            let contact = if side == 0 { u.floor() } else { (u + 0.5).floor() - 0.5 };
            let hip = pelvis + rotation * self.body.legs[side][0].offset;
            let hip = if side == 0 { hip } else { mirror(&hip) };
            let v = u - contact;
            if v <= self.style.toe_off() {
                self.stance.pose(v, &(hip - stride * contact))
            } else {
                self.swing.pose(&self.stance.plane, &self.body.leg, v, &(hip - stride * contact))
            }
        });
        (pelvis, legs)
    }

    /// Centre of mass at a node (m).
    pub fn com(&self, node: usize) -> Vector3<f64> {
        self.nodes[node].com
    }

    /// Rate of the angular momentum about the centre of mass at a node (N m).
    pub fn momentum_rate(&self, node: usize) -> Vector3<f64> {
        self.nodes[node].momentum_rate
    }

    /// Share and centre of pressure of left and right foot at a node.
    pub fn support(&self, node: usize) -> [FootSupport; 2] {
        self.nodes[node].feet
    }

    /// Prescribed wrenches of left and right foot at a node.
    pub fn forces(&self, node: usize) -> [Contact; 2] {
        self.nodes[node].feet(self.style.pivot)
    }
}

/// Angles of trunk and both arms at the clock `u`.
fn angles(style: &Style, u: f64) -> ([rotations::Euler; 5], [[f64; 2]; 2]) {
    (laws::trunk(style, u, Swings::ALL), laws::arms(style, u, Swings::ALL))
}
