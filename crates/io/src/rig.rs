//! A person and a motion on the bones of an animator's rig: its names, its rest pose.
//!
//! The figure that comes of it has the person's joints at the same places, whose links are called as the rig's bones are and whose frames
//! are turned so that **with all joints at zero it stands in the rig's rest pose**, every bone along the world's axes: x left, y up, z forward, or, by
//! [`RigMap::with_own_axes`], as the rig's own characters have them: Mixamo's y along the bone, Unreal's x. So retargeting by names from a T pose (or the A pose of
//! Unreal) finds what it looks for, and with own axes a clip plays on such a character as it is. Joints turn by quaternions.
//!
//! | rig | names | rest |
//! |---|---|---|
//! | `Mixamo` | `mixamorig:LeftUpLeg` | T |
//! | `Vrm` | `leftUpperLeg` (VRM 1.0; [`crate::glb::Options::vrm`] writes its extension) | T |
//! | `Unreal` | `thigh_l` | A, arms 45° down |
//! | `Unity` | `LeftUpperLeg` (`HumanBodyBones`) | T |
//! | `Smpl` | `left_hip` | T |
//! | `Cmu` | `LeftUpLeg` (as the conversion of cgspeed has it) | T |
//!
//! A person here has two links between pelvis and neck, rigs three to five bones. The others are there, too: bones that never turn in
//! the one that they go on from, on the way to the next joint, and what hangs on that one hangs on the last of them.
//!
//! | rig | bones that never turn |
//! |---|---|
//! | `Mixamo` | `Spine2` in the thorax; the ends `HeadTop_End`, `LeftToe_End` |
//! | `Vrm`, `Unity` | `upperChest` in the thorax |
//! | `Unreal` | `spine_02` in the abdomen, `spine_04` and `spine_05` in the thorax, `neck_02` in the neck |
//! | `Smpl` | `spine2` in the abdomen; `left_hand` beyond the wrist |
//! | `Cmu` | `Spine` in the abdomen, `Neck1` in the neck; `LeftFingerBase` in the palm |
//!
//! CMU's `LHipJoint` is one of no length between pelvis and thigh. Unreal's `root` goes along the ground below the pelvis, faces where that faces, and does not
//! sway with the steps: it is the figure's first link, with slides and one turn for a joint, and has the root motion that games take from a clip. Where the others have no such bone, the pelvis has it all.
//!
//! Unreal's `upperarm_twist_01_l` and the like, two of them a limb at its thirds, turn about its axis: they share out how it is rolled, so that skin wrings nowhere
//! ([`solaris_retarget::Roll`]).
//!
//! Fingers and, of `Vrm` and `Unity`, eyes are such bones, too, each with what of the skin is its own, so that they can be posed: at rest fingers
//! hang as they do in the skin, a little bent, their frames along the world's axes. `Cmu` has a thumb and one bone for the four fingers, `Smpl` none.
//!
//! Names of one's own are a [`RigMap`], which has no fingers, no root, no bones of twist and no axes of its own.

mod axes;
mod map;
mod rigged;
mod track;
mod twist;

pub use map::RigMap;
pub use rigged::Rigged;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// A convention of names and rest pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "their names say whose they are; the module's table has the rest")]
pub enum Rig {
    Mixamo,
    Vrm,
    Unreal,
    Unity,
    Smpl,
    Cmu,
}

/// Names of bones by the names of a human's links, a rig a column.
const NAMES: &str = include_str!("rig/names.csv");
/// Bones that rigs have beyond our links, from below up: each goes on from a link, at a share of the way to the joint of another
/// one or to its own tip.
const BETWEEN: &str = include_str!("rig/between.csv");

/// Bones that share out how a limb turns about its own axis: each in a link, at a share of the way to the joint of the next.
const TWISTS: &str = include_str!("rig/twists.csv");

/// Names of fingers and eyes, [`solaris_skin::Part`]s of a person's skin, a rig a column; those that have none have no column or no name.
const PARTS: &str = include_str!("rig/parts.csv");

/// A bone that a rig has along a link.
struct Along {
    bone: &'static str,
    link: &'static str,
    toward: &'static str,
    share: f64,
}

impl Rig {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Mixamo, Self::Vrm, Self::Unreal, Self::Unity, Self::Smpl, Self::Cmu];

    /// What it is called: `mixamo`.
    pub fn name(self) -> &'static str {
        let heading = NAMES.lines().next().unwrap_or_default();
        heading.split(',').nth(1 + self as usize).unwrap_or_default()
    }

    /// What it calls a human's link.
    pub fn bone(self, link: &str) -> Option<&'static str> {
        let row = NAMES.lines().skip(1).find(|row| row.split(',').next() == Some(link))?;
        row.split(',').nth(1 + self as usize)
    }

    /// Its bones of a table.
    fn along(self, table: &'static str) -> impl Iterator<Item = Along> {
        table.lines().skip(1).filter_map(move |row| {
            let mut cells = row.split(',');
            let mut cell = || cells.next();
            let (rig, bone, link, toward, share) = (cell()?, cell()?, cell()?, cell()?, cell()?);
            (rig == self.name()).then_some(Along { bone, link, toward, share: share.parse().ok()? })
        })
    }

    /// What it calls the bone on the ground on which the pelvis hangs.
    pub fn root(self) -> Option<&'static str> {
        (self == Self::Unreal).then_some("root")
    }

    /// What it calls a bone of no length by which a human's link hangs on what is above it.
    fn hook(self, link: &str) -> Option<&'static str> {
        match (self, link) {
            (Self::Cmu, "left_thigh") => Some("LHipJoint"),
            (Self::Cmu, "right_thigh") => Some("RHipJoint"),
            _ => None,
        }
    }

    /// What it calls a part of a human's skin: a bone of a finger, an eye.
    pub fn part(self, part: &str) -> Option<&'static str> {
        let column = PARTS.lines().next()?.split(',').position(|rig| rig == self.name())?;
        let row = PARTS.lines().skip(1).find(|row| row.split(',').next() == Some(part))?;
        row.split(',').nth(column).filter(|bone| !bone.is_empty())
    }

    /// How it stands at rest.
    pub fn rest(self) -> Rest {
        if self == Self::Unreal { Rest::A } else { Rest::T }
    }
}

/// How a rig stands with all joints at zero: upright, soles flat.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Rest {
    /// Arms straight out.
    #[default]
    T,
    /// Arms 45° down.
    A,
    /// Arms down, as our own people have them.
    Own,
}

impl Rest {
    /// How far arms are raised to the side (rad).
    fn raised(self) -> f64 {
        match self {
            Self::T => FRAC_PI_2,
            Self::A => FRAC_PI_4,
            Self::Own => 0.0,
        }
    }
}
