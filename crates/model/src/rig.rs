//! Whose bone is this: the human segments that the bones of an animator's rig are, by their names.
//!
//! ```
//! use solaris_model::rig::{Bone, Segment, Side, bones};
//! let names = ["mixamorig:Hips", "mixamorig:LeftUpLeg", "mixamorig:LeftLeg", "Camera"];
//! let thigh = Bone { segment: Segment::Thigh, side: Some(Side::Left) };
//! assert_eq!(bones(&names)[1], Some(thigh));
//! assert_eq!(bones(&names)[3], None);
//! ```
//!
//! Rigs disagree on words: `LeftLeg` is the shank of Mixamo, and `left_shoulder` the upper arm of SMPL, the clavicle of
//! others. So names are read together: a word that may mean two things means the one that the rig has no other word for.
//!
//! | rig | thigh, shank, foot, toes | clavicle, upper arm, forearm, hand |
//! |---|---|---|
//! | Mixamo, LAFAN1, CMU (cgspeed) | `LeftUpLeg LeftLeg LeftFoot LeftToeBase` | `LeftShoulder LeftArm LeftForeArm LeftHand` |
//! | VRM, Unity | `leftUpperLeg leftLowerLeg leftFoot leftToes` | `leftShoulder leftUpperArm leftLowerArm leftHand` |
//! | Unreal | `thigh_l calf_l foot_l ball_l` | `clavicle_l upperarm_l lowerarm_l hand_l` |
//! | Rokoko | `LeftThigh LeftShin LeftFoot LeftToe` | `LeftShoulder LeftArm LeftForeArm LeftHand` |
//! | SMPL | `left_hip left_knee left_ankle left_foot` | `left_collar left_shoulder left_elbow left_wrist` |
//! | Biovision | `LeftHip LeftKnee LeftAnkle` | `LeftCollar LeftShoulder LeftElbow LeftWrist` |
//! | Biped | `Bip01 L Thigh`, `Calf`, `Foot`, `Toe0` | `Clavicle`, `UpperArm`, `Forearm`, `Hand` |

use crate::human::{Portion, portion};
use crate::lint::sides::words;
use std::collections::HashSet;

/// A side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Side {
    /// The body's own left.
    Left,
    /// Its right.
    Right,
}

/// A part of the human body, as rigs divide it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs, reason = "their names say what they are")]
pub enum Segment {
    Pelvis,
    /// All between pelvis and neck.
    Trunk,
    Neck,
    Head,
    Clavicle,
    UpperArm,
    Forearm,
    Hand,
    /// Of fingers and thumb, which are parts of the hand.
    Finger,
    Thigh,
    Shank,
    Foot,
    Toes,
}

/// A bone of a human rig.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Bone {
    /// What it is a part of.
    pub segment: Segment,
    /// Whose side, where there are two.
    pub side: Option<Side>,
}

impl Segment {
    /// What is known of it in adults (de Leva 1996, as in [`crate::human()`]): that of one side, where there are two.
    pub fn of_adult(self) -> Portion {
        let names: &[&str] = match self {
            Self::Pelvis => &["pelvis"],
            Self::Trunk => &["abdomen", "thorax"],
            Self::Neck => &["neck"],
            Self::Head => &["head"],
            Self::Clavicle => &["clavicle"],
            Self::UpperArm => &["upper_arm"],
            Self::Forearm => &["forearm"],
            Self::Hand | Self::Finger => &["hand"],
            Self::Thigh => &["thigh"],
            Self::Shank => &["shank"],
            Self::Foot => &["foot"],
            Self::Toes => &["toes"],
        };
        portion(names)
    }
}

/// What names say of bones, and nothing of those that are none of a human's; one a name, in their order.
pub fn bones(names: &[&str]) -> Vec<Option<Bone>> {
    let read: Vec<(Option<Side>, String)> = names.iter().map(|name| side_and_word(name)).collect();
    let known: HashSet<&str> = read.iter().map(|(_, word)| word.as_str()).collect();
    let has = |words: &[&str]| words.iter().any(|word| known.contains(word));
    let bone = |(side, word): &(Option<Side>, String)| {
        let segment = segment(word, side.is_some(), &has)?;
        let paired = segment >= Segment::Clavicle;
        (paired == side.is_some()).then_some(Bone { segment, side: *side })
    };
    read.iter().map(bone).collect()
}

/// Whether a bone is one of those between two joints of a limb that share out how it turns about its own axis: `LeftForeArmRoll`,
/// `thigh_twist_01_l`, `l_forearmtwist2`, `左腕捩`. Of rolls whole words count: of a troll or a controller there is nothing to share.
///
/// ```
/// use solaris_model::rig::is_twist;
/// assert!(is_twist("mixamorig:LeftForeArmRoll") && is_twist("l_upperarmtwist1"));
/// assert!(!is_twist("Troll_LeftArm") && !is_twist("Roll:LeftArm"));
/// ```
pub fn is_twist(name: &str) -> bool {
    let own = own(name);
    let is_word =
        |word: &str| word.contains("twist") || word.trim_end_matches(|c: char| c.is_ascii_digit()) == "roll";
    own.contains('捩') || words(own).into_iter().any(|range| is_word(&own[range].to_lowercase()))
}

/// A name without its namespace.
fn own(name: &str) -> &str {
    name.rsplit_once(':').map_or(name, |(_, own)| own)
}

/// Words for the thigh, and for the upper arm, that mean nothing else.
const THIGH: [&str; 4] = ["upleg", "upperleg", "thigh", "femur"];
const UPPER_ARM: [&str; 4] = ["arm", "upperarm", "uparm", "humerus"];
const CLAVICLE: [&str; 3] = ["clavicle", "collar", "collarbone"];
/// What fingers are called.
const FINGERS: [&str; 7] = ["thumb", "index", "middle", "ring", "pinky", "little", "finger"];
/// Words before the ones that matter.
const PREFIXES: [&str; 8] = ["mixamorig", "bip", "character", "def", "org", "jnt", "j", "b"];
/// Bones beside the body's own: what turns with a limb, what tools steer by, where a chain ends.
const ASIDE: [&str; 8] = ["twist", "roll", "ik", "pole", "end", "nub", "site", "target"];

/// The part of the body that a word is, given what words the rig `has`.
fn segment(word: &str, sided: bool, has: &impl Fn(&[&str]) -> bool) -> Option<Segment> {
    Some(match word {
        "hips" | "pelvis" => Segment::Pelvis,
        "hip" if !sided => Segment::Pelvis,
        "hip" if !has(&THIGH) => Segment::Thigh,
        _ if THIGH.contains(&word) => Segment::Thigh,
        "leg" | "lowerleg" | "lowleg" | "shin" | "calf" | "shank" | "knee" | "tibia" => Segment::Shank,
        // Where ankles are named, and no toes, the foot is what goes on from the ankle to them.
        "foot" if has(&["ankle"]) && !has(&["toe", "toes", "toebase", "ball"]) => Segment::Toes,
        "foot" | "ankle" => Segment::Foot,
        "toe" | "toes" | "toebase" | "ball" => Segment::Toes,
        "spine" | "chest" | "upperchest" | "lowerback" | "back" | "torso" | "abdomen" | "thorax"
        | "waist" | "lumbar" | "belly" => Segment::Trunk,
        "neck" => Segment::Neck,
        "head" => Segment::Head,
        _ if CLAVICLE.contains(&word) => Segment::Clavicle,
        "shoulder" if has(&CLAVICLE) || !has(&UPPER_ARM) => Segment::UpperArm,
        "shoulder" => Segment::Clavicle,
        _ if UPPER_ARM.contains(&word) => Segment::UpperArm,
        "forearm" | "lowerarm" | "lowarm" | "elbow" | "radius" => Segment::Forearm,
        "hand" | "wrist" => Segment::Hand,
        _ if FINGERS.iter().any(|finger| word.contains(finger)) => Segment::Finger,
        _ => return None,
    })
}

/// The side that a name says, and its words without it, in small letters, without numbers and prefixes; no word where the
/// bone is beside the body's own.
fn side_and_word(name: &str) -> (Option<Side>, String) {
    let own = own(name);
    let (mut side, mut word) = (None, String::new());
    for part in words(own).into_iter().map(|range| own[range].to_lowercase()) {
        let part = part.trim_end_matches(|c: char| c.is_ascii_digit());
        if ASIDE.contains(&part) {
            return (None, String::new());
        }
        let (found, rest) = match part {
            "l" | "left" => (Some(Side::Left), ""),
            "r" | "right" => (Some(Side::Right), ""),
            _ => match (part.strip_prefix("left"), part.strip_prefix("right")) {
                (Some(rest), _) => (Some(Side::Left), rest),
                (_, Some(rest)) => (Some(Side::Right), rest),
                _ => (None, part),
            },
        };
        side = side.or(found);
        // A single `c` is VRoid's centre.
        if !(word.is_empty() && (PREFIXES.contains(&rest) || rest == "c")) {
            word.push_str(rest);
        }
    }
    // CMU's helpers between pelvis and thigh have no length.
    if side.is_some() && word == "hipjoint" { (None, String::new()) } else { (side, word) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The segments of a left leg and arm under these names, among the names of a whole rig.
    fn left(names: &str) -> Vec<Segment> {
        let names: Vec<&str> = names.split(", ").collect();
        let found = bones(&names);
        found.iter().flatten().filter(|bone| bone.side == Some(Side::Left)).map(|bone| bone.segment).collect()
    }

    #[test]
    fn every_rig_of_the_table_is_known() {
        use Segment::{Clavicle, Foot, Forearm, Hand, Shank, Thigh, Toes, UpperArm};
        let all = [Thigh, Shank, Foot, Toes, Clavicle, UpperArm, Forearm, Hand];
        for rig in [
            "Hips, LeftUpLeg, LeftLeg, LeftFoot, LeftToeBase, LeftShoulder, LeftArm, LeftForeArm, LeftHand",
            "mixamorig1:LeftUpLeg, mixamorig1:LeftLeg, mixamorig1:LeftFoot, mixamorig1:LeftToeBase, \
             mixamorig1:LeftShoulder, mixamorig1:LeftArm, mixamorig1:LeftForeArm, mixamorig1:LeftHand",
            "LHipJoint, LeftUpLeg, LeftLeg, LeftFoot, LeftToeBase, LeftShoulder, LeftArm, LeftForeArm, LeftHand",
            "leftUpperLeg, leftLowerLeg, leftFoot, leftToes, leftShoulder, leftUpperArm, leftLowerArm, leftHand",
            "thigh_l, calf_l, foot_l, ball_l, clavicle_l, upperarm_l, lowerarm_l, hand_l, thigh_twist_01_l, ik_foot_l",
            "LeftThigh, LeftShin, LeftFoot, LeftToe, LeftShoulder, LeftArm, LeftForeArm, LeftHand",
            "left_hip, left_knee, left_ankle, left_foot, left_collar, left_shoulder, left_elbow, left_wrist",
            "J_Bip_L_UpperLeg, J_Bip_L_LowerLeg, J_Bip_L_Foot, J_Bip_L_ToeBase, J_Bip_L_Shoulder, J_Bip_L_UpperArm, \
             J_Bip_L_LowerArm, J_Bip_L_Hand",
            "Bip01 L Thigh, Bip01 L Calf, Bip01 L Foot, Bip01 L Toe0, Bip01 L Clavicle, Bip01 L UpperArm, \
             Bip01 L Forearm, Bip01 L Hand",
            "thigh.L, shin.L, foot.L, toe.L, shoulder.L, upper_arm.L, forearm.L, hand.L",
        ] {
            assert_eq!(left(rig), all, "{rig}");
        }
        let biovision =
            "Hips, LeftHip, LeftKnee, LeftAnkle, LeftCollar, LeftShoulder, LeftElbow, LeftWrist, RightHip";
        assert_eq!(left(biovision), [Thigh, Shank, Foot, Clavicle, UpperArm, Forearm, Hand]);
    }

    #[test]
    fn the_trunk_has_no_side_and_fingers_have_one() {
        let of = |name: &str| bones(&[name])[0];
        for (name, segment) in [
            ("Hips", Segment::Pelvis),
            ("pelvis", Segment::Pelvis),
            ("Spine2", Segment::Trunk),
            ("spine_03", Segment::Trunk),
            ("J_Bip_C_UpperChest", Segment::Trunk),
            ("LowerBack", Segment::Trunk),
            ("Neck1", Segment::Neck),
            ("Head", Segment::Head),
        ] {
            assert_eq!(of(name), Some(Bone { segment, side: None }), "{name}");
        }
        let finger = Some(Bone { segment: Segment::Finger, side: Some(Side::Right) });
        for name in ["RightHandIndex1", "RThumb", "RightFingerBase", "index_01_r", "rightLittleProximal"] {
            assert_eq!(of(name), finger, "{name}");
        }
        for name in
            ["Camera", "LHipJoint", "LeftHead", "Hand", "mixamorig:HeadTop_End", "lower_arm_twist_01_l", ""]
        {
            assert_eq!(of(name), None, "{name}");
        }
    }
}
