//! The leg of a stride: how its foot stands and swings below a hip whose way is known.

use crate::body::leg::LegGeometry;
use crate::error::GaitError;
use crate::limbs::jet::LegJet;
use crate::limbs::midstance::above_flexion;
use crate::limbs::numbers::LANDING_RANGE;
use crate::limbs::path::{Air, PathSwing};
use crate::limbs::stance::{Landing, Stance};
use crate::smooth::legs::Aim;
use crate::smooth::style::Style;
use nalgebra::Vector3;
use solaris_profiles::{Boundary, step};

/// The slope from which on the landing knee is as bent as the leg needs it (rad).
const UPHILL: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Instants at which a flat foot's leg is looked at for it.
const INSTANTS: i32 = 30;

/// How a leg stands, swings and lands.
pub(super) struct StrideLeg {
    pub(super) stance: Stance,
    pub(super) swing: Air,
    pub(super) contact: LegJet,
}

impl StrideLeg {
    /// With the foot's print at the origin and its hip by the clock; `swinging` are clocks between toe-off and contact.
    pub(super) fn new(
        style: &Style,
        leg: &LegGeometry,
        mut stance: Stance,
        hip: impl Fn(f64) -> Vector3<f64> + Copy,
        swinging: &[f64],
    ) -> Result<Self, GaitError> {
        let (knee, lowered) = contact_knee(style, leg, &stance, &hip(0.0));
        let knee = (style.landing() == Landing::Heel).then_some(knee);
        if let Some(knee) = knee {
            stance.set_contact(knee, hip)?;
        }
        stance.set_push(hip)?;
        let contact = stance.contact_jet(knee, hip);
        if let Some(stairs) = &style.stairs {
            let (start, end) = (stance.toe_off_path(hip), stance.contact_path(hip));
            let passings = stairs.passings(style.step_length, leg.foot_length());
            let stride = Vector3::new(0.0, style.rise(), style.step_length) * 2.0;
            let swing =
                PathSwing::new(leg, style.toe_off(), style.manner.toes, &passings, &start, &end, &stride)?;
            return Ok(Self { stance, swing: Air::Path(swing), contact });
        }
        let aim = Aim {
            thigh: style.thigh_swing,
            late_knee: style.knee_late_swing + lowered,
            unstretched: 0.0,
            beside: false,
            tilt: [style.slope; 2],
            sideways: [0.0; 2],
        };
        let mut swing = style.swing(&stance.toe_off_jet(hip), &contact, &aim)?;
        let clearance = style.ground_clearance(0.0);
        if style.slope == 0.0 {
            let heights: Vec<(f64, f64)> = swinging.iter().map(|&u| (u, hip(u).y)).collect();
            swing.clear_ground(leg, &clearance, &heights);
        } else {
            let hips: Vec<(f64, Vector3<f64>)> = swinging.iter().map(|&u| (u, hip(u))).collect();
            let slope = style.slope.tan();
            swing.clear_terrain(leg, &stance.plane, &clearance, &hips, |p| p.y - slope * p.z);
        }
        Ok(Self { stance, swing: Air::Joints(swing), contact })
    }
}

/// The knee as the heel lands, and by how much more than its style's it is bent to be there with a flexed leg.
fn contact_knee(style: &Style, leg: &LegGeometry, stance: &Stance, hip: &Vector3<f64>) -> (Boundary, f64) {
    let pitch = -style.heel_strike_angle;
    let knee = style.contact_knee();
    if style.flexion > 0.0 {
        let knee = stance.landing_knee(knee, style.knee_contact, pitch, LANDING_RANGE, hip);
        return (knee, knee.position - style.knee_contact);
    }
    // Uphill the standing leg, not the landing one, limits the height: the pitch is kept, and the knee follows.
    let ankle = stance.ankle_on_heel(pitch);
    let bent = leg.knee_for((hip - ankle).norm_squared()) - style.knee_contact;
    let part = step::cubic((style.slope / UPHILL).clamp(0.0, 1.0)).position;
    (Boundary { position: knee.position + part * bent.max(0.0), ..knee }, 0.0)
}

/// How far the body must rise until the first leg, at contact or on a flat foot, is as straight as it may be.
pub(super) fn spare_height(
    stance: &Stance,
    style: &Style,
    leg: &LegGeometry,
    hip: impl Fn(f64) -> Vector3<f64>,
) -> f64 {
    let spare = |u: f64, ankle: Vector3<f64>, knee: f64| {
        let d = hip(u) - ankle;
        (leg.reach_squared(knee) - d.x * d.x - d.z * d.z).max(1e-6).sqrt() - d.y
    };
    let contact = spare(0.0, stance.landing_ankle(-style.heel_strike_angle), style.knee_contact);
    let (from, to) = (style.foot_flat, style.heel_off);
    let flexed = if style.flexion > 0.0 {
        -above_flexion(leg, stance, style.flexion, (from, to), &hip).1
    } else {
        f64::INFINITY
    };
    (0..INSTANTS)
        .map(|i| {
            spare(
                from + (to - from) * f64::from(i) / f64::from(INSTANTS - 1),
                stance.flat_ankle(),
                style.least_knee,
            )
        })
        .fold(contact.min(flexed), f64::min)
}
