//! A cane in a hand: how the arm holds its handle over its tip.

use super::posture::ArmCarriage;
use super::rotations::{self, Euler};
use super::segments::{Body, Cane};
use nalgebra::{Matrix3, Vector2, Vector3};
use solaris_model::Figure;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

/// How far shoulder and elbow turn for it (rad, forward and bent are negative), and where the search begins.
const SHOULDER: (f64, f64) = (-FRAC_PI_2, FRAC_PI_3);
const ELBOW: (f64, f64) = (-150.0 * std::f64::consts::PI / 180.0, 0.0);
const BEGINS: Vector2<f64> = Vector2::new(0.25, -0.6);
/// Passes of Newton's method, of which five are enough to the last digit, and its differences (rad).
const PASSES: usize = 12;
const DIFFERENCE: f64 = 1e-7;

/// The side, left 0 or right 1, of the foot that the cane of a figure helps: the other side than its hand's. None where it holds none that the walker
/// knows what to do with.
pub fn helped_side(figure: &Figure) -> Option<usize> {
    Some(1 - Cane::of(figure).ok()??.side)
}

/// An arm that holds a cane: shoulder and elbow, the cane's angles in the fist, and where the fist is against the pelvis' origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Held {
    pub(crate) arm: [f64; 2],
    pub(crate) cane: [f64; 2],
    pub(crate) fist: Vector3<f64>,
}

impl Cane {
    /// Its rotation against the hand.
    pub(crate) fn rotation([aside, forward]: [f64; 2]) -> Matrix3<f64> {
        rotations::about_z(aside) * rotations::about_x(forward)
    }

    /// The arm that holds it with its tip there, against the pelvis' origin of a body that faces along z: the fist is as far from the tip as the
    /// cane is long, and seen from the side on the way from the shoulder to the tip, so that what the cane bears bends it neither forward nor backward:
    ///
    /// ```text
    /// |f − p| = L        ((f − s) × (p − s))·x = 0
    /// ```
    ///
    /// Where no fist comes so near the arm is any.
    pub(crate) fn hold(
        &self,
        body: &Body,
        trunk: &[Euler; 5],
        carriage: &ArmCarriage,
        tip: &Vector3<f64>,
    ) -> Held {
        let [pelvis, abdomen, thorax] = [0, 1, 2].map(|i| rotations::matrix(trunk[i]));
        let origin = pelvis * body.middle[1].offset + abdomen * body.middle[2].offset;
        let at = thorax.transpose() * (tip - origin);
        let misses = |arm: Vector2<f64>| {
            let [shoulder, fist] = self.shoulder_and_fist(body, carriage, arm);
            let across = (fist - shoulder).cross(&(at - shoulder)).x;
            Vector2::new((fist - at).norm_squared() - self.length.powi(2), across)
        };
        let mut arm = BEGINS;
        for _ in 0..PASSES {
            let missed = misses(arm);
            let column = |along: Vector2<f64>| (misses(arm + along * DIFFERENCE) - missed) / DIFFERENCE;
            let (a, b) = (column(Vector2::x()), column(Vector2::y()));
            // By Cramer's rule.
            let next = arm - Vector2::new(missed.perp(&b), a.perp(&missed)) / a.perp(&b);
            let next = Vector2::new(next.x.clamp(SHOULDER.0, SHOULDER.1), next.y.clamp(ELBOW.0, ELBOW.1));
            let moved = (next - arm).amax();
            arm = next;
            if moved < 1e-15 {
                break;
            }
        }
        let [_, fist] = self.shoulder_and_fist(body, carriage, arm);
        let [.., hand] = carriage.chain(self.side, &thorax, arm.into());
        let fist = origin + thorax * fist;
        let along = (hand.transpose() * (tip - fist)).normalize();
        // Rz(a) Rx(b) turns −y to (sin a cos b, −cos a cos b, −sin b).
        let cane = [along.x.atan2(-along.y), (-along.z).clamp(-1.0, 1.0).asin()];
        Held { arm: arm.into(), cane, fist }
    }

    /// Shoulder and fist in the thorax' frame, for the angles of shoulder and elbow.
    fn shoulder_and_fist(&self, body: &Body, carriage: &ArmCarriage, arm: Vector2<f64>) -> [Vector3<f64>; 2] {
        let [clavicle, upper_arm, forearm, hand] = body.arms[self.side].map(|segment| segment.offset);
        let about_x = |angle: f64, v: Vector3<f64>| {
            let (sin, cos) = angle.sin_cos();
            Vector3::new(v.x, cos * v.y - sin * v.z, sin * v.y + cos * v.z)
        };
        let below_elbow = about_x(arm.y, hand + about_x(carriage.hand(arm.y), self.segment.offset));
        let girdle = rotations::about_y(carriage.girdle(self.side, arm.x));
        let shoulder = clavicle + girdle * upper_arm;
        let fist = shoulder + girdle * (carriage.rotation(self.side, arm.x) * (forearm + below_elbow));
        [shoulder, fist]
    }

    /// How far to its own side its tip stands from the shoulder, on ground that is so far below it (m): the arm hangs as far outward.
    pub(crate) fn outward(carriage: &ArmCarriage, below: f64) -> f64 {
        below * carriage.abduction.tan()
    }

    /// Where its shoulder is, against the pelvis' origin, of an arm that hangs.
    pub(crate) fn shoulder(&self, body: &Body, trunk: &[Euler; 5]) -> Vector3<f64> {
        let [pelvis, abdomen, thorax] = [0, 1, 2].map(|i| rotations::matrix(trunk[i]));
        let [clavicle, upper_arm, ..] = body.arms[self.side].map(|segment| segment.offset);
        pelvis * body.middle[1].offset + abdomen * body.middle[2].offset + thorax * (clavicle + upper_arm)
    }
}
