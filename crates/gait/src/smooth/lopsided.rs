//! Bodies whose two sides are not alike. One is heavier, of a load in a hand or by its figure: the trunk leans to the other side, the pelvis
//! gives way, and the heavier arm swings less. One leg is shorter: the pelvis hangs down to it.

use crate::body::{Body, Segment};
use crate::momentum::upper;
use crate::smooth::laws::{self, Swings};
use crate::smooth::style::Style;

/// The most by which a trunk would lean aside for all of it (rad).
const MOST: f64 = 15.0 * std::f64::consts::PI / 180.0;
/// How much of the balance is the trunk's; the rest is the pelvis', which comes under the load. Leaning by all of it an arm that hangs goes
/// through the hip.
const LEANS: f64 = 0.5;
/// By how much arms are carried farther out, over the lean that would balance alone: so much clears the hip.
const CLEARS: f64 = 0.15;
/// Bodies whose arms' first moments differ by no more than this part have two sides that are alike, but for rounding.
const ALIKE: f64 = 1e-6;
/// Of a figure's middle: how far its centres of mass may be beside it (m).
const BESIDE: f64 = 1e-6;
/// Sine of the most that a pelvis hangs to one side for a leg that is shorter.
const STEEPEST: f64 = 0.5;

/// Whether a body is heavier on one side, or stands on legs of unequal lengths.
pub(crate) fn is_lopsided(body: &Body) -> bool {
    is_heavier(body) || legs_differ(body) || body.cane.is_some()
}

/// Whether thighs or shanks are of unequal length.
pub(crate) fn legs_differ(body: &Body) -> bool {
    let [left, right] = body.sides;
    (left.thigh - right.thigh).abs() > BESIDE || (left.shank - right.shank).abs() > BESIDE
}

/// How far the pelvis hangs to the right, so that each hip is as high over its foot as its own leg wants it:
///
/// ```text
/// 2·x·sin δ = Lₗ − Lᵣ        x half the distance of the hips
/// ```
fn list(body: &Body) -> f64 {
    let [left, right] = body.sides.map(|leg| leg.length());
    if (left - right).abs() < BESIDE {
        return 0.0;
    }
    (0.5 * (left - right) / body.leg.hip.x).clamp(-STEEPEST, STEEPEST).asin()
}

fn is_heavier(body: &Body) -> bool {
    let [left, right] = body.arms.each_ref().map(first_moment);
    let middle = body.middle.iter().any(|segment| segment.com.x.abs() > BESIDE);
    middle || (left - right).abs() > ALIKE * (left + right)
}

/// Sets the pelvis' list, lean and arms of a style as a body with two sides that differ has them; of others nothing changes.
///
/// ```text
/// Σ mᵢ xᵢ = 0 while standing, of which half      swing of an arm ~ least first moment of both / its own
/// ```
///
/// so that both arms have about the same angular momentum.
pub(crate) fn balance(style: &mut Style, body: &Body) {
    style.manner.pelvis_list = list(body);
    if !is_heavier(body) {
        return;
    }
    let moments = body.arms.each_ref().map(first_moment);
    let least = moments[0].min(moments[1]);
    for (side, moment) in style.manner.arm_sides.iter_mut().zip(moments) {
        *side *= least / moment;
    }
    // Nearly a straight line: some steps of the secant method along it.
    let beside = |style: &mut Style, lean: f64| {
        style.manner.side_lean = lean;
        let (trunk, arms) = (laws::trunk(style, 0.0, Swings::NONE), laws::arms(style, 0.0, Swings::NONE));
        upper::beside(body, &trunk, &arms, style.manner.carriage())
    };
    let (mut before, mut lean) = (0.0, 0.05);
    let mut off = beside(style, before);
    for _ in 0..8 {
        let now = beside(style, lean);
        if (now - off).abs() < 1e-12 {
            break;
        }
        (before, lean, off) = (lean, (lean - now * (lean - before) / (now - off)).clamp(-MOST, MOST), now);
    }
    style.manner.side_lean = LEANS * lean;
    style.manner.arms_out += CLEARS * lean.abs();
}

/// Mass times distance from the shoulder, of an arm that hangs straight down (kg m).
fn first_moment(arm: &[Segment; 4]) -> f64 {
    let mut down = 0.0;
    let mut sum = 0.0;
    for (i, segment) in arm.iter().enumerate().skip(1) {
        if i > 1 {
            down += segment.offset.norm();
        }
        sum += segment.mass * (down + segment.com.norm());
    }
    sum
}
