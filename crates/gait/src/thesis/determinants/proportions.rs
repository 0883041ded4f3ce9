//! The lengths that key postures need.

use crate::body::LegGeometry;
use crate::error::GaitError;
use solaris_model::Figure;

/// Lengths of a body in the sagittal plane; any unit, as long as it is one.
///
/// The thesis's models have the ankle on the ground, and no heel: `ankle_height`, `heel_behind`, `ball_below` and
/// `ball_height` are 0 there. A foot that keeps its right angle to the shank only makes the shank longer by the ankle's
/// height, so the same closed forms serve real feet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proportions {
    /// Hip to knee (L₁).
    pub thigh: f64,
    /// Knee to ankle (L₂).
    pub shank: f64,
    /// Ankle above the sole.
    pub ankle_height: f64,
    /// Heel behind the ankle.
    pub heel_behind: f64,
    /// Ball of the foot, the joint of the toes, ahead of the ankle (L₃).
    pub ball_ahead: f64,
    /// Ball below the ankle.
    pub ball_below: f64,
    /// Ball above the sole.
    pub ball_height: f64,
    /// Ball to the tip of the toes (L₄).
    pub toe: f64,
    /// Distance of the hips (L).
    pub hips: f64,
    /// Standing height (H).
    pub height: f64,
    /// How long the unit of all these is (m): 1 where they are in metres. Closed forms do without, speeds of people do not.
    pub unit: f64,
}

/// Standing height (m) of the person whom what has no size of its own is taken for.
pub(crate) const USUAL_HEIGHT: f64 = 1.75;

impl Proportions {
    /// The proportions that give back the thesis's tables 7.7 and 7.8: 70 of 72 cells of the first and 12 of 15 statements of
    /// the second. The thesis does not print its own. In units of L₁ + L₂, which are those of a person of 1.75 m where
    /// metres are asked for; there are no toes.
    pub const FIT: Self = Self {
        thigh: 0.5022,
        shank: 0.4978,
        ankle_height: 0.0,
        heel_behind: 0.0,
        ball_ahead: 0.1753,
        ball_below: 0.0,
        ball_height: 0.0,
        toe: 0.0,
        hips: 0.3881,
        height: 2.16085,
        unit: USUAL_HEIGHT / 2.16085,
    };

    /// The thesis's foot (ankle on the ground) with the ratios of Drillis and Contini for a standing height (m): thigh
    /// 0.245·H, shank 0.246·H, foot 0.085·H to the ball and 0.035·H to the tip, hips 0.191·H apart.
    pub fn drillis_contini(height: f64) -> Self {
        Self {
            thigh: 0.245 * height,
            shank: 0.246 * height,
            ball_ahead: 0.085 * height,
            toe: 0.035 * height,
            hips: 0.191 * height,
            height,
            unit: 1.0,
            ..Self::FIT
        }
    }

    /// A figure's own (m).
    ///
    /// # Errors
    ///
    /// A figure that cannot walk, see [`crate::missing_for_walking()`].
    pub fn of(figure: &Figure) -> Result<Self, GaitError> {
        crate::body::missing::check(figure)?;
        let body = crate::body::Body::of(figure)?.with_legs_alike()?;
        Ok(Self::of_leg(&body.leg, body.height))
    }

    pub(crate) fn of_leg(leg: &LegGeometry, height: f64) -> Self {
        Self {
            thigh: leg.thigh,
            shank: leg.shank,
            ankle_height: leg.ankle_height,
            heel_behind: leg.heel_behind,
            ball_ahead: leg.ball_ahead,
            ball_below: leg.ball_below,
            ball_height: leg.ball_height,
            toe: leg.toe,
            hips: 2.0 * leg.hip.x,
            height,
            unit: 1.0,
        }
    }

    /// Another size: every length times a factor, in the same unit.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            thigh: self.thigh * factor,
            shank: self.shank * factor,
            ankle_height: self.ankle_height * factor,
            heel_behind: self.heel_behind * factor,
            ball_ahead: self.ball_ahead * factor,
            ball_below: self.ball_below * factor,
            ball_height: self.ball_height * factor,
            toe: self.toe * factor,
            hips: self.hips * factor,
            height: self.height * factor,
            unit: self.unit,
        }
    }

    /// Thigh and shank (L₁ + L₂).
    pub fn leg(&self) -> f64 {
        self.thigh + self.shank
    }

    /// Ankle to the tip of the toes (L₃ + L₄).
    pub fn forefoot(&self) -> f64 {
        self.ball_ahead + self.toe
    }
}
