//! Which bone of a skeleton is which part of a person.

use crate::error::RetargetError;
use crate::map::BoneMap;
use crate::skeleton::Skeleton;
use solaris_model::did_you_mean;
use solaris_model::rig::{self, Segment, Side, bones};

/// The roles, by the names of a human's links.
pub const ROLES: [&str; 21] = [
    "pelvis",
    "abdomen",
    "thorax",
    "neck",
    "head",
    "left_clavicle",
    "left_upper_arm",
    "left_forearm",
    "left_hand",
    "left_thigh",
    "left_shank",
    "left_foot",
    "left_toes",
    "right_clavicle",
    "right_upper_arm",
    "right_forearm",
    "right_hand",
    "right_thigh",
    "right_shank",
    "right_foot",
    "right_toes",
];

/// The bones of one side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "their names say what they are")]
pub struct Limbs {
    pub clavicle: Option<usize>,
    pub upper_arm: Option<usize>,
    pub forearm: Option<usize>,
    pub hand: Option<usize>,
    pub thigh: usize,
    pub shank: usize,
    pub foot: usize,
    pub toes: Option<usize>,
}

/// The bones of a skeleton by their roles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Roles {
    /// What the thighs hang on.
    pub pelvis: usize,
    /// What lies between it and the shoulders, from below up: however many bones there are.
    pub trunk: Vec<usize>,
    /// What lies between them and the head.
    pub neck: Vec<usize>,
    /// The head, where it has one.
    pub head: Option<usize>,
    /// Left and right.
    pub sides: [Limbs; 2],
}

impl Roles {
    /// Finds the roles: those that the `map` names, those that the skeleton's file says, and all others by the names of the bones
    /// ([`solaris_model::rig`]) and by what hangs on what. Of several bones of one name the uppermost has the role.
    ///
    /// # Errors
    ///
    /// [`RetargetError::NoBone`] with every role of the legs that no bone has; a map's bone that is not there; legs and arms whose bones do
    /// not hang on each other.
    pub fn find(skeleton: &Skeleton, map: &BoneMap) -> Result<Self, RetargetError> {
        let names: Vec<&str> =
            skeleton.bones.iter().map(|bone| if bone.is_bone { bone.name.as_str() } else { "" }).collect();
        let found = Found { skeleton, map, named: bones(&names) };
        found.check_map()?;
        let mut missing = Vec::new();
        let mut need = |role: &'static str| {
            found.one(role).unwrap_or_else(|| {
                missing.push(role);
                0
            })
        };
        let sides = [("left_thigh", "left_shank", "left_foot"), ("right_thigh", "right_shank", "right_foot")]
            .map(|(thigh, shank, foot)| [need(thigh), need(shank), need(foot)]);
        if !missing.is_empty() {
            let (skeleton, bones) = (skeleton.name.clone(), skeleton.names());
            return Err(RetargetError::NoBone { skeleton, roles: missing, bones });
        }
        let thighs = [sides[0][0], sides[1][0]];
        let pelvis = found.one("pelvis").or_else(|| skeleton.common(thighs[0], thighs[1]));
        let pelvis = pelvis.ok_or_else(|| RetargetError::NoBone {
            skeleton: skeleton.name.clone(),
            roles: vec!["pelvis"],
            bones: skeleton.names(),
        })?;
        let sides = [
            (sides[0], ["left_clavicle", "left_upper_arm", "left_forearm", "left_hand", "left_toes"]),
            (sides[1], ["right_clavicle", "right_upper_arm", "right_forearm", "right_hand", "right_toes"]),
        ]
        .map(|([thigh, shank, foot], others)| {
            let [clavicle, upper_arm, forearm, hand, toes] = others.map(|role| found.one(role));
            Limbs { clavicle, upper_arm, forearm, hand, thigh, shank, foot, toes }
        });
        let (trunk, neck, head) = found.middle(pelvis, &sides);
        let roles = Self { pelvis, trunk, neck, head, sides };
        roles.check(skeleton)?;
        Ok(roles)
    }

    /// The roles that have no bone, of those that a walker can do without.
    pub fn missing(&self) -> Vec<&'static str> {
        let mut missing = Vec::new();
        let mut without = |none: bool, role| {
            if none {
                missing.push(role);
            }
        };
        without(self.trunk.is_empty(), "thorax");
        without(self.head.is_none(), "head");
        for (limbs, [clavicle, upper_arm, forearm, hand, toes]) in self.sides.iter().zip([
            ["left_clavicle", "left_upper_arm", "left_forearm", "left_hand", "left_toes"],
            ["right_clavicle", "right_upper_arm", "right_forearm", "right_hand", "right_toes"],
        ]) {
            without(limbs.clavicle.is_none(), clavicle);
            without(limbs.upper_arm.is_none(), upper_arm);
            without(limbs.forearm.is_none(), forearm);
            without(limbs.hand.is_none(), hand);
            without(limbs.toes.is_none(), toes);
        }
        missing
    }

    /// How many bones have a role.
    pub fn count(&self) -> usize {
        let limbs = |limbs: &Limbs| {
            3 + [limbs.clavicle, limbs.upper_arm, limbs.forearm, limbs.hand, limbs.toes]
                .iter()
                .flatten()
                .count()
        };
        1 + self.trunk.len()
            + self.neck.len()
            + usize::from(self.head.is_some())
            + self.sides.iter().map(limbs).sum::<usize>()
    }

    /// Refuses limbs whose bones do not hang on each other.
    fn check(&self, skeleton: &Skeleton) -> Result<(), RetargetError> {
        for limbs in &self.sides {
            let chains = [
                (Some(limbs.shank), Some(limbs.thigh), "shank"),
                (Some(limbs.foot), Some(limbs.shank), "foot"),
                (limbs.toes, Some(limbs.foot), "toes"),
                (limbs.forearm, limbs.upper_arm, "forearm"),
                (limbs.hand, limbs.forearm, "hand"),
            ];
            for (lower, upper, role) in chains {
                let Some((lower, upper)) = lower.zip(upper) else { continue };
                if lower == upper || !skeleton.is_below(lower, upper) {
                    let name = |bone: usize| skeleton.bones[bone].name.clone();
                    return Err(RetargetError::Order {
                        skeleton: skeleton.name.clone(),
                        role,
                        lower: name(lower),
                        upper: name(upper),
                    });
                }
            }
        }
        Ok(())
    }
}

/// What is known of the roles of a skeleton's bones.
struct Found<'a> {
    skeleton: &'a Skeleton,
    map: &'a BoneMap,
    /// What the bones' names say.
    named: Vec<Option<rig::Bone>>,
}

impl Found<'_> {
    fn check_map(&self) -> Result<(), RetargetError> {
        for (role, bone) in &self.map.bones {
            if self.by_name(bone).is_none() {
                let names = self.skeleton.bones.iter().map(|bone| bone.name.as_str());
                return Err(RetargetError::Unknown {
                    skeleton: self.skeleton.name.clone(),
                    role: (*role).to_owned(),
                    bone: bone.clone(),
                    hint: did_you_mean(bone, names),
                    bones: self.skeleton.names(),
                });
            }
        }
        Ok(())
    }

    fn by_name(&self, name: &str) -> Option<usize> {
        self.skeleton.bones.iter().position(|bone| bone.name == name)
    }

    /// The bone of a role: by the map, by the file, or by its name.
    fn one(&self, role: &'static str) -> Option<usize> {
        if let Some(name) = self.map.bone(role) {
            return self.by_name(name);
        }
        let tagged = self.skeleton.bones.iter().position(|bone| bone.role == Some(role));
        let wanted = wanted(role)?;
        // Parents come before children: the first one is the uppermost.
        tagged.or_else(|| self.named.iter().position(|bone| *bone == Some(wanted)))
    }

    /// Trunk, neck and head: by what lies between pelvis, shoulders and head, whatever it is called.
    fn middle(&self, pelvis: usize, sides: &[Limbs; 2]) -> (Vec<usize>, Vec<usize>, Option<usize>) {
        let skeleton = self.skeleton;
        let arm = |limbs: &Limbs| limbs.clavicle.or(limbs.upper_arm);
        let is_middle = |i: usize| {
            self.named[i].is_some_and(|bone| matches!(bone.segment, Segment::Trunk | Segment::Neck))
        };
        let head = self.one("head");
        let shoulders =
            arm(&sides[0]).zip(arm(&sides[1])).and_then(|(left, right)| skeleton.common(left, right));
        // Without arms, the trunk ends where its names do.
        let last = |i: &usize| self.named[*i].is_some_and(|bone| bone.segment == Segment::Trunk);
        let chest = self.map.bone("thorax").and_then(|name| self.by_name(name)).or(shoulders);
        let chest = chest.or_else(|| (0..skeleton.bones.len()).rfind(last));
        let Some(chest) =
            chest.filter(|chest| *chest != pelvis && skeleton.common(*chest, pelvis) != Some(*chest))
        else {
            let neck = head.map_or_else(Vec::new, |head| skeleton.between(pelvis, head));
            return (Vec::new(), neck, head);
        };
        let mut trunk = skeleton.between(pelvis, chest);
        trunk.push(chest);
        // A head that has no name of its own is the last one of those that go on from the chest.
        let mut at = chest;
        let head = head.or_else(|| {
            // Parents come before children.
            for i in chest + 1..skeleton.bones.len() {
                if skeleton.bones[i].parent == Some(at) && is_middle(i) {
                    at = i;
                }
            }
            (at != chest).then_some(at)
        });
        let neck = head.map_or_else(Vec::new, |head| skeleton.between(chest, head));
        (trunk, neck, head)
    }
}

/// What a role is among the segments that names tell.
fn wanted(role: &str) -> Option<rig::Bone> {
    let (side, word) = match (role.strip_prefix("left_"), role.strip_prefix("right_")) {
        (Some(word), _) => (Some(Side::Left), word),
        (_, Some(word)) => (Some(Side::Right), word),
        _ => (None, role),
    };
    let segment = match word {
        "pelvis" => Segment::Pelvis,
        "head" => Segment::Head,
        "clavicle" => Segment::Clavicle,
        "upper_arm" => Segment::UpperArm,
        "forearm" => Segment::Forearm,
        "hand" => Segment::Hand,
        "thigh" => Segment::Thigh,
        "shank" => Segment::Shank,
        "foot" => Segment::Foot,
        "toes" => Segment::Toes,
        _ => return None,
    };
    Some(rig::Bone { segment, side })
}
