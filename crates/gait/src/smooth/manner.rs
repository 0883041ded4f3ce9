//! What a walker does besides what the fitted numbers say: toes, head, arms.

use crate::body::posture::ArmCarriage;
use crate::limbs::swing::Toes;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// How a walker carries what does not decide the walk (rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manner {
    /// What the toes do after toe-off.
    pub toes: Toes,
    /// The greatest part of the foot's pitch at toe-off that the toes may have.
    pub toe_roll_part: f64,
    /// Flexion of the elbows while standing; in a stride its mean, and how far it swings.
    pub elbow: [f64; 3],
    /// Amplitudes of the head's pitch, against the body's rise, and of its turn, against the body's sway: they keep the gaze steady.
    pub head: [f64; 2],
    /// How far the shoulder girdle turns about the vertical with the arm, as a part of the arm's angle.
    pub clavicle: f64,
    /// How far the hand swings on, as a part of the forearm's.
    pub wrist: f64,
    /// Mean forward pitch of the head.
    pub head_pitch: f64,
    /// Mean of the shoulders' flexion; backward is negative.
    pub shoulder: f64,
    /// Upper arms outward, and turned inward about their own length, so that bent forearms point across the body.
    pub arms_out: f64,
    /// See [`Self::arms_out`].
    pub arms_in: f64,
    /// How far left and right arm swing over the style's amplitude.
    pub arm_sides: [f64; 2],
    /// Lean of the thorax to the right, away from a load on the left.
    pub side_lean: f64,
    /// How far the pelvis hangs to the right, over a right leg that is shorter.
    pub pelvis_list: f64,
}

impl Manner {
    /// Of the recipe that the golden walks were made with: an upright head, stiff wrists.
    pub const RECIPE: Self = Self {
        toes: Toes::StraightAt(0.80),
        toe_roll_part: f64::MAX,
        elbow: [22.0 * DEGREE, 22.0 * DEGREE, 9.0 * DEGREE],
        head: [0.0; 2],
        clavicle: 0.0,
        wrist: 0.0,
        head_pitch: 0.0,
        shoulder: -3.0 * DEGREE,
        arms_out: ArmCarriage::WALKING.abduction,
        arms_in: 0.0,
        arm_sides: [1.0; 2],
        side_lean: 0.0,
        pelvis_list: 0.0,
    };

    /// Of people at this speed (m/s): the faster they walk, the more their elbows bend and swing.
    ///
    /// An artist's choice within what textbooks give: elbows between 20° and 65° from slow to fast, a head that pitches and turns by a
    /// degree or two against the trunk, toes that are a little extended in mid-swing.
    pub fn of_people(speed: f64) -> Self {
        let speed = speed.clamp(0.0, 2.2);
        Self {
            toes: Toes::Extended(5.0 * DEGREE),
            toe_roll_part: 0.6,
            elbow: [15.0 * DEGREE, (14.0 + 16.0 * speed) * DEGREE, (2.0 + 10.0 * speed) * DEGREE],
            head: [1.5 * DEGREE, 1.2 * DEGREE],
            clavicle: 0.08,
            wrist: 0.15,
            ..Self::RECIPE
        }
    }

    pub(crate) fn carriage(&self) -> ArmCarriage {
        let Self { clavicle, wrist, arms_out: abduction, arms_in: inward, side_lean: lean, .. } = *self;
        ArmCarriage { abduction, inward, clavicle, wrist, lean }
    }

    /// This, with arms, head and what else shows in standing as another one has them.
    pub(super) fn standing_as(self, other: &Self) -> Self {
        let Self { head_pitch, shoulder, arms_out, arms_in, side_lean, pelvis_list, .. } = *other;
        let elbow = [other.elbow[0], self.elbow[1], self.elbow[2]];
        Self { elbow, head_pitch, shoulder, arms_out, arms_in, side_lean, pelvis_list, ..self }
    }

    /// Of a walk whose left is right.
    pub(super) fn mirrored(self) -> Self {
        let [left, right] = self.arm_sides;
        let (side_lean, pelvis_list) = (-self.side_lean, -self.pelvis_list);
        Self { arm_sides: [right, left], side_lean, pelvis_list, ..self }
    }

    /// Its numbers with their names.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let toes = match self.toes {
            Toes::StraightAt(at) => at,
            Toes::Extended(by) => by,
        };
        let [standing, mean, swing] = self.elbow;
        let [pitch, turn] = self.head;
        [
            ("toes", toes),
            ("toe_roll_part", self.toe_roll_part),
            ("elbow", standing + mean + swing),
            ("head", pitch + turn),
            ("clavicle", self.clavicle),
            ("wrist", self.wrist),
            ("head_pitch", self.head_pitch),
            ("shoulder", self.shoulder),
            ("arms_out", self.arms_out),
            ("arms_in", self.arms_in),
            ("arm_sides", self.arm_sides[0] + self.arm_sides[1]),
            ("side_lean", self.side_lean),
            ("pelvis_list", self.pelvis_list),
        ]
        .into_iter()
    }
}
