//! The trunk's rise in place of a parameter: it decides how far the standing knee flexes and the other thigh swings.

use super::super::proportions::Proportions;
use super::closed::{close, hip_over_swing, infeasible, strike_angles};
use super::parameters::{FiveParameters, check_range, parameters_of};
use super::sides::cosine;
use super::trunk::{PARTS, TrunkAmplitudes};
use crate::condition::{Condition, Infeasible};
use crate::error::GaitError;

/// Where κ stands among the parameters.
const KAPPA: usize = 4;

impl FiveParameters {
    /// The same with the κ at which the neck rises by the trunk's Vd from the end of phase 1 to that of phase 3; κ itself is
    /// not looked at. ψ follows by [`super::solve`].
    ///
    /// ```text
    /// M = (a+h) cos α + hz sin α − L/2 sin δ + Vd + T(ν/5, γ/5, ζ) − T(−ν, γ, −ζ)   hip at the end of phase 3
    /// K = ω − φ,  A = L₁ + l cos K + F sin K,  B = l sin K − F cos K,  l = L₂ + h
    /// κ = atan2(B, A) + acos((M − d)/√(A² + B²))
    /// ```
    ///
    /// T is the neck over the pelvis. Where the heel is the lowest point (ε < 0), −hz takes F's place.
    /// T adds the bends with the signs of table 8.7, as the reference numbers do. The text has ν positive at one side and γ at
    /// the other, which would make the hip 2 to 7 mm higher at 80 to 130 steps/min.
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), §8.8.4, hopes to find δ from Vd. That equation has a solution, but a millimetre of Vd moves it
    /// by 0.7° to 3.7°, up or down depending on φ and κ: a larger tilt lowers the hip and the landing leg's angle raises it.
    /// The same Vd decides κ instead, and as well.
    ///
    /// With the thesis's feet and automatic parameters it serves bodies up to 1.75 m. Real feet have their hips higher at heel
    /// strike, on heel and ball, and the same rise is mostly more than a straight leg has: at 1.75 m only long steps, of 0.52
    /// of the height, close.
    ///
    /// # Errors
    ///
    /// A value out of its range, and parameters that have no postures with any κ.
    pub fn with_trunk_rise(self, p: &Proportions, trunk: &TrunkAmplitudes) -> Result<Self, GaitError> {
        let q = Self { thigh_swing: 0.5, ..self };
        q.check(p)?;
        for (name, value) in [("trunk rise", trunk.rise), ("trunk bend", trunk.pelvis_bend)] {
            check_range(name, value, "", (0.0, p.height), "")?;
        }
        check_range("torso bend", trunk.torso_bend, "", (-1.0, 1.0), "")?;
        check_range("lean", trunk.lean, "", (-1.0, 1.0), "")?;
        let fails = match with_rise(p, &q, trunk) {
            Ok(found) => match close(p, &found) {
                Ok(_) => return Ok(found),
                Err(fails) => fails,
            },
            Err(fails) => fails,
        };
        let others = |i: &usize| *i != KAPPA;
        let parameters: Vec<_> = (0..8).filter(others).map(|i| parameters_of(p)[i]).collect();
        let values: Vec<f64> = (0..8).filter(others).map(|i| q.values()[i]).collect();
        let feasible = |values: &[f64]| {
            let mut all = q.values();
            for (i, value) in (0..8).filter(others).zip(values) {
                all[i] = *value;
            }
            with_rise(p, &Self::from_values(all), trunk).is_ok_and(|found| close(p, &found).is_ok())
        };
        Err(infeasible(Infeasible::new(fails, &parameters, &values, feasible)))
    }
}

fn with_rise(
    p: &Proportions,
    q: &FiveParameters,
    trunk: &TrunkAmplitudes,
) -> Result<FiveParameters, Vec<Condition>> {
    // ω and what fails before it do not depend on κ.
    let (_, list) = super::closed::build(p, q);
    let before: Vec<Condition> =
        list.into_iter().filter(|condition| !condition.holds() && !condition.name.starts_with('ψ')).collect();
    let (Some((alpha, _)), Some(omega)) = (strike_angles(p, q), super::closed::lift_off_pitch(p, q)) else {
        return Err(before);
    };
    if !before.is_empty() {
        return Err(before);
    }
    let landing = (p.leg() + p.ankle_height) * alpha.cos() + p.heel_behind * alpha.sin();
    let neck = trunk.neck(p.height, PARTS[1]) - trunk.neck(p.height, PARTS[3]);
    let hip = landing - 0.5 * p.hips * q.tilt.sin() + trunk.rise + neck;
    swing_for(p, q, omega, hip)
}

/// κ for a height of the hip in phase 3.
pub(super) fn swing_for(
    p: &Proportions,
    q: &FiveParameters,
    omega: f64,
    hip: f64,
) -> Result<FiveParameters, Vec<Condition>> {
    let knee = omega - q.thigh_lift_off;
    let (sin, cos) = knee.sin_cos();
    let shank = p.shank + p.ankle_height;
    let found = |ahead: f64| {
        let (a, b) = (p.thigh + shank * cos + ahead * sin, shank * sin - ahead * cos);
        let cos_kappa = (hip - q.clearance) / a.hypot(b);
        (cos_kappa, b.atan2(a) + cos_kappa.acos())
    };
    // The tip is the lowest point of a foot whose toes point down, the heel of one whose toes point up.
    let (tip, heel) = (found(p.forefoot()), found(-p.heel_behind));
    let kappa = if knee - tip.1 >= 0.0 || !tip.1.is_finite() { tip } else { heel };
    let text = "|cos| < 1: the swinging leg can be as long as the trunk's rise has it";
    let domain = cosine("κ (8.11)", text, kappa.0);
    let found = FiveParameters { thigh_swing: kappa.1, ..*q };
    // Between the two, tip and heel are both above the clearance: none.
    let met = (hip_over_swing(p, &found, knee - kappa.1) - hip).abs() < 1e-9 * p.height;
    if domain.holds() && met { Ok(found) } else { Err(vec![domain]) }
}
