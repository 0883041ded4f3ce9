//! The comparison of a smooth walk with the key postures of the same step: what it has at the same instants.

use crate::body::leg::LegPose;
use crate::error::GaitError;
use crate::smooth::WalkPlan;
use crate::thesis::determinants::{Determinants, KeySolution, LegAngles, Proportions};

/// A key posture and the walk's own at its instant.
///
/// With the feature `serde` its keys are `posture`, `at_s`, and the deviations of thigh, shank and foot `stance_deg` and `swing_deg`.
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "Beside")]
pub struct PostureComparison {
    /// What the posture is called.
    pub name: &'static str,
    /// When (s).
    pub time: f64,
    /// Pitches of stance and swing leg in the posture.
    pub posture: [LegAngles; 2],
    /// Those of the walk.
    pub walk: [LegAngles; 2],
}

impl PostureComparison {
    /// The walk's pitches less the posture's (rad): thigh, shank and foot of the stance leg, then of the swing leg.
    pub fn deviations(&self) -> [f64; 6] {
        let of = |leg: usize| {
            let (a, b) = (self.walk[leg], self.posture[leg]);
            [a.thigh - b.thigh, a.shank - b.shank, a.foot - b.foot]
        };
        let ([a, b, c], [d, e, f]) = (of(0), of(1));
        [a, b, c, d, e, f]
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for PostureComparison {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let [a, b, c, d, e, f] = self.deviations().map(f64::to_degrees);
        let mut posture = serializer.serialize_struct("PostureComparison", 4)?;
        posture.serialize_field("posture", self.name)?;
        posture.serialize_field("at_s", &self.time)?;
        posture.serialize_field("stance_deg", &[a, b, c])?;
        posture.serialize_field("swing_deg", &[d, e, f])?;
        posture.end()
    }
}

impl WalkPlan {
    /// The key postures of the same step length beside the walk's, in a step from its middle.
    ///
    /// An instant is that of what the posture is: *heel strike* and *stride* are the contact, *lift-off* of five determinants is the
    /// other foot's toe-off, *passing* and the *lift-off* of three are the hip above the standing ankle, *stretch* is the swinging
    /// shank upright before it lands. Parameters that are not given ([`Determinants::parameters`]) are chosen inside their bounds.
    ///
    /// # Errors
    ///
    /// A step that the postures do not fit.
    pub fn compare_postures(&self, determinants: Determinants) -> Result<Vec<PostureComparison>, GaitError> {
        // A step from the middle of what was planned, by the foot that lands; left is 0.
        let contact = self.laws.course.steps.div_ceil(2);
        let (style, leg) = (self.laws.style(contact), &self.body.leg);
        let p = Proportions::of_leg(leg, self.body.height);
        let values = determinants.automatic(&p, style.step_frequency, style.step_length)?;
        let speed = style.step_length * style.step_frequency / 60.0;
        let solution: KeySolution = determinants.solve(&p, &values, speed)?;
        let (stance, u) = (contact % 2, 0.5 * contact as f64);
        let legs = |u: f64| -> [LegPose; 2] {
            let both = self.hips_and_legs(u).1;
            [both[stance], both[1 - stance]]
        };
        let pitches = |pose: &LegPose| LegAngles {
            thigh: leg.thigh_lean - pose.thigh,
            shank: leg.shank_lean - (pose.thigh - pose.knee),
            foot: pose.pitch,
            toes: pose.toes,
        };
        let double = style.double_support;
        let midstance = || crossing((u + double, u + 0.5), |u| leg.ankle_ahead_of_hip(&legs(u)[0]));
        let stretch = || crossing((u + 0.28, u + 0.5), |u| pitches(&legs(u)[1]).shank);
        let [_, intermediate, _] = &solution.cycles;
        let all = intermediate.iter().map(|phase| {
            let at = match (determinants, phase.number) {
                (Determinants::Five, 2) => u + double,
                (Determinants::Five, 3) | (Determinants::Three, 1) => midstance(),
                (Determinants::Five, 4) => stretch(),
                // The stride of three determinants ends a step, with the parts of the legs as they were in it.
                (Determinants::Three, _) => u + 0.5,
                _ => u,
            };
            let walk = legs(at).map(|pose| pitches(&pose));
            PostureComparison { name: phase.end.name, time: self.time(at), posture: phase.end.legs, walk }
        });
        Ok(all.collect())
    }
}

/// Where a function that falls from one end to the other is zero, or the end that is nearer to it.
fn crossing((mut a, mut b): (f64, f64), f: impl Fn(f64) -> f64) -> f64 {
    if (f(a) > 0.0) == (f(b) > 0.0) {
        return if f(a).abs() < f(b).abs() { a } else { b };
    }
    let falls = f(a) > 0.0;
    for _ in 0..50 {
        let middle = 0.5 * (a + b);
        if (f(middle) > 0.0) == falls { a = middle } else { b = middle }
    }
    0.5 * (a + b)
}
