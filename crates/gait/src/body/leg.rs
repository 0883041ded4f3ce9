//! The geometry of a leg, and the closed forms that need nothing else.

use super::roles::SIDES;
use crate::error::BodyError;
use nalgebra::Vector3;
use solaris_model::{Figure, SolePart};

/// Places that are nearer than this are one (m).
const ALIKE: f64 = 1e-9;

/// By how much of the longer leg the other one may be shorter.
pub(crate) const UNEQUAL: f64 = 0.035;

/// How far from the shorter of two legs to the longer one is what both are planned by.
const LONGER: f64 = 0.3;

/// Lengths of a leg in the sagittal plane (m, rad): of the left one, or of the right one as its mirror image.
///
/// It is plain data, so that the closed forms can be tried with bare numbers too. The thesis's legs, with the ankle on
/// the ground, have `ankle_height` 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "segment lengths")]
#[doc(alias = "leg length")]
pub struct LegGeometry {
    /// Hip to knee (L1).
    pub thigh: f64,
    /// Knee to ankle (L2).
    pub shank: f64,
    /// Angle by which the line hip–knee leans backward of the thigh's own axis (ζ1).
    pub thigh_lean: f64,
    /// Angle by which the line knee–ankle leans backward of the shank's own axis (ζ2).
    pub shank_lean: f64,
    /// Height of the ankle above the sole (`h_a`).
    pub ankle_height: f64,
    /// Distance of the heel behind the ankle (hz).
    pub heel_behind: f64,
    /// Distance of the joint of the toes, the ball, ahead of the ankle (tz).
    pub ball_ahead: f64,
    /// Distance of the ball below the ankle (ty).
    pub ball_below: f64,
    /// Height of the ball above the sole.
    pub ball_height: f64,
    /// Length of the toes, from the ball to the tip.
    pub toe: f64,
    /// The left hip in the pelvis' frame.
    pub hip: Vector3<f64>,
}

/// A point of the foot against a joint of it, or the joint against the point: an angle (rad) and a distance (m).
pub(crate) type Polar = (f64, f64);

/// A leg's posture: five angles (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LegPose {
    /// Sideways angle of the line hip–ankle (η).
    pub(crate) side: f64,
    /// Forward angle of the thigh's axis (α).
    pub(crate) thigh: f64,
    /// Knee flexion (k).
    pub(crate) knee: f64,
    /// Foot pitch, toe down positive (γ).
    pub(crate) pitch: f64,
    /// Pitch of the toes (ε).
    pub(crate) toes: f64,
    /// Pitch of the ground that the foot is turned in (β), uphill positive: `γ + β` is the foot's pitch against it. Pitches are those
    /// of the world.
    pub(crate) tilt: f64,
}

impl LegGeometry {
    /// The left leg of a figure with the links of [`solaris_model::human()`].
    ///
    /// # Errors
    ///
    /// A figure that lacks a link or a sole point, whose legs are not mirror images, or whose knee and ankle do not lie
    /// in the leg's plane.
    pub fn of(figure: &Figure) -> Result<Self, BodyError> {
        let sides = Self::of_sides(figure)?;
        Self::check_alike(&sides)?;
        Ok(sides[0])
    }

    /// Both legs, the right one as its mirror image: they may be of unequal length, with thighs and shanks that are.
    ///
    /// # Errors
    ///
    /// As for [`LegGeometry::of`], but for thighs and shanks; these may differ by 3.5 % of the longer leg together.
    pub fn of_sides(figure: &Figure) -> Result<[Self; 2], BodyError> {
        let sides = [Self::of_side(figure, 0)?, Self::of_side(figure, 1)?];
        let [left, right] = &sides;
        let (difference, longest) = (left.length() - right.length(), left.length().max(right.length()));
        if difference.abs() > UNEQUAL * longest {
            return Err(BodyError::LegsTooUnequal { difference, most: UNEQUAL * longest });
        }
        Ok(sides)
    }

    /// Refuses legs that are not mirror images.
    pub(crate) fn check_alike([left, right]: &[Self; 2]) -> Result<(), BodyError> {
        for (joint, difference) in [
            ("knee", (left.thigh - right.thigh).abs().max((left.thigh_lean - right.thigh_lean).abs())),
            ("ankle", (left.shank - right.shank).abs().max((left.shank_lean - right.shank_lean).abs())),
        ] {
            if difference > ALIKE {
                return Err(BodyError::LegsDiffer { joint, difference });
            }
        }
        Ok(())
    }

    /// The leg between two, for what is asked of both together; of two that are one it is that one. It is nearer to the shorter one, which
    /// is straighter in a step of the same length.
    pub(crate) fn between([left, right]: &[Self; 2]) -> Self {
        let (short, long) = if left.length() <= right.length() { (left, right) } else { (right, left) };
        let between = |of: fn(&Self) -> f64| of(short) + LONGER * (of(long) - of(short));
        Self { thigh: between(|leg| leg.thigh), shank: between(|leg| leg.shank), ..*left }
    }

    fn of_side(figure: &Figure, side: usize) -> Result<Self, BodyError> {
        let link = |name: &str| {
            figure.link(name).ok_or_else(|| BodyError::MissingLinks {
                figure: figure.name().into(),
                links: vec![name.into()],
            })
        };
        let sole = |name: &'static str, part: SolePart| {
            link(name)?.sole_point(part).copied().ok_or(BodyError::MissingSolePoint { link: name, part })
        };
        let offset = |name: &str| link(name).map(|link| link.joint().placement().translation.vector);
        for (name, joint) in [("thigh", "hip"), ("shank", "knee"), ("foot", "ankle"), ("toes", "toes")] {
            let (left, right) = (offset(&format!("left_{name}"))?, offset(&format!("right_{name}"))?);
            let difference = (left - Vector3::new(-right.x, right.y, right.z)).amax();
            if matches!(name, "thigh" | "toes") && difference > ALIKE {
                return Err(BodyError::LegsDiffer { joint, difference });
            }
            let own = if side == 0 { left } else { right };
            if name != "thigh" && own.x.abs() > ALIKE {
                return Err(BodyError::OutOfPlane { joint, offset: own.x });
            }
        }
        let own = |name: &str| offset(&format!("{}{name}", SIDES[side]));
        let (knee, ankle, ball) = (own("shank")?, own("foot")?, own("toes")?);
        let (heel, tip) = (sole("left_foot", SolePart::Heel)?, sole("left_toes", SolePart::ToeTip)?);
        Ok(Self {
            thigh: knee.y.hypot(knee.z),
            shank: ankle.y.hypot(ankle.z),
            thigh_lean: (-knee.z).atan2(-knee.y),
            shank_lean: (-ankle.z).atan2(-ankle.y),
            ankle_height: -heel.y,
            heel_behind: -heel.z,
            ball_ahead: ball.z,
            ball_below: -ball.y,
            ball_height: -tip.y,
            toe: tip.z,
            hip: offset("left_thigh")?,
        })
    }

    /// Length of the leg: thigh, shank and ankle height.
    pub fn length(&self) -> f64 {
        self.thigh + self.shank + self.ankle_height
    }

    /// Length of the foot, from the heel to the tip of the toes.
    pub fn foot_length(&self) -> f64 {
        self.heel_behind + self.ball_ahead + self.toe
    }

    /// The angle between thigh and shank lines for a knee flexed by `knee`: k − ζ1 + ζ2.
    #[inline]
    pub(crate) fn geometric_knee(&self, knee: f64) -> f64 {
        knee - self.thigh_lean + self.shank_lean
    }

    /// Squared distance of hip and ankle for a knee flexed by `knee`:
    ///
    /// ```text
    /// ℓ² = L1² + L2² + 2 L1 L2 cos(k − ζ1 + ζ2)
    /// ```
    #[inline]
    pub fn reach_squared(&self, knee: f64) -> f64 {
        self.thigh * self.thigh
            + self.shank * self.shank
            + 2.0 * self.thigh * self.shank * self.geometric_knee(knee).cos()
    }

    /// The knee flexion that puts hip and ankle at this squared distance; straight or folded where it cannot be.
    #[inline]
    pub fn knee_for(&self, distance_squared: f64) -> f64 {
        let (l1, l2) = (self.thigh, self.shank);
        let cosine = (distance_squared - l1 * l1 - l2 * l2) / (2.0 * l1 * l2);
        cosine.clamp(-1.0, 1.0).acos() + self.thigh_lean - self.shank_lean
    }

    /// Angle of the thigh's axis against the line from hip to ankle.
    #[inline]
    pub(crate) fn thigh_against_leg(&self, geometric_knee: f64) -> f64 {
        let (sin, cos) = geometric_knee.sin_cos();
        (self.shank * sin).atan2(self.thigh + self.shank * cos) + self.thigh_lean
    }

    /// Just under the greatest squared distance of hip and ankle.
    pub(crate) fn almost_straight_squared(&self) -> f64 {
        ((self.thigh + self.shank) * 0.99999).powi(2)
    }

    /// Foot pitch (toe down positive) that lets a foot turning about its **heel** meet the knee flexion `knee`.
    ///
    /// ```text
    /// γ = atan2(h_a, hz) − atan2(h_y, h_f) + acos((h² + r_b² − q) / 2 h r_b)      r_b² = hz² + h_a²,  q = ℓ²(k) − h_s²
    /// ```
    ///
    /// `hip` is the hip against the heel: to the side, up, forward in the foot's vertical plane.
    #[inline]
    pub fn pitch_about_heel(&self, hip: [f64; 3], knee: f64) -> f64 {
        self.pitch_about(self.heel_polar(), hip, knee)
    }

    /// The same for the heel's polar form.
    #[inline]
    pub(crate) fn pitch_about(&self, (angle, rb): Polar, [hs, hy, hf]: [f64; 3], knee: f64) -> f64 {
        let h = hy.hypot(hf);
        let q = self.reach_squared(knee) - hs * hs;
        let cosine = (h * h + rb * rb - q) / (2.0 * rb * h);
        angle - hy.atan2(hf) + cosine.clamp(-1.0, 1.0).acos()
    }

    /// Foot pitch that lets a foot turning about its **ball** joint meet the knee flexion `knee`.
    ///
    /// ```text
    /// γ = atan2(t_f, t_y) + asin((t² + r_a² − q) / 2 r_a t) − atan2(ty, tz)      r_a² = tz² + ty²,  q = ℓ²(k) − t_s²
    /// ```
    ///
    /// `hip` is the hip against the ball joint: to the side, up, forward in the foot's vertical plane.
    #[inline]
    pub fn pitch_about_ball(&self, hip: [f64; 3], knee: f64) -> f64 {
        self.pitch_over(self.ball_polar(), hip, knee)
    }

    /// The same for the ball's polar form.
    #[inline]
    pub(crate) fn pitch_over(&self, (angle, ra): Polar, [hs, hy, hf]: [f64; 3], knee: f64) -> f64 {
        let h = hy.hypot(hf);
        let q = self.reach_squared(knee) - hs * hs;
        let sine = (h * h + ra * ra - q) / (2.0 * ra * h);
        hf.atan2(hy) + sine.clamp(-1.0, 1.0).asin() - angle
    }

    /// Polar form of the ankle about the heel: angle above the sole and radius.
    pub(crate) fn heel_polar(&self) -> Polar {
        (self.ankle_height.atan2(self.heel_behind), self.heel_behind.hypot(self.ankle_height))
    }

    /// Polar form of the ball joint about the ankle: angle below the sole's direction and radius.
    pub(crate) fn ball_polar(&self) -> Polar {
        (self.ball_below.atan2(self.ball_ahead), self.ball_ahead.hypot(self.ball_below))
    }

    /// Polar form of the toe's tip about the ball joint: angle below the toes' axis and radius.
    pub(crate) fn toe_polar(&self) -> Polar {
        (self.ball_height.atan2(self.toe), self.ball_height.hypot(self.toe))
    }

    /// How far the ankle is below the hip, in the leg's plane.
    #[inline]
    pub(crate) fn ankle_below_hip(&self, pose: &LegPose) -> f64 {
        self.thigh * (pose.thigh - self.thigh_lean).cos()
            + self.shank * (pose.thigh - pose.knee - self.shank_lean).cos()
    }

    /// How far the ankle is ahead of the hip, in the leg's plane.
    #[inline]
    pub(crate) fn ankle_ahead_of_hip(&self, pose: &LegPose) -> f64 {
        self.thigh * (pose.thigh - self.thigh_lean).sin()
            + self.shank * (pose.thigh - pose.knee - self.shank_lean).sin()
    }

    /// Height of the lowest point of the foot above the ground, for the toe's polar form, the ankle's height and the pitches of
    /// foot and toes.
    #[inline]
    pub(crate) fn lowest(&self, (b, r): Polar, ankle: f64, pitch: f64, toes: f64) -> f64 {
        let (sin, cos) = pitch.sin_cos();
        let ball = ankle - self.ball_ahead * sin - self.ball_below * cos;
        let heel = ankle - self.ankle_height * cos + self.heel_behind * sin;
        let foot_ball = ankle - self.ankle_height * cos - self.ball_ahead * sin;
        let toe_ball = ball - self.ball_height * toes.cos();
        let tip = ball - r * (b + toes).sin();
        heel.min(foot_ball).min(toe_ball).min(tip)
    }
}
