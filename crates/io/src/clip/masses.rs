//! Masses of bones, which files of bones do not know: a person's by published shares, others' by the size of their bones.

use super::ReadOptions;
use super::bones::Said;
use crate::bvh::BvhError;
use solaris_model::rig::{Bone, Segment};
use solaris_model::{
    FindingKind, Inertia, Matrix3, Placement, Shape, ShapeKind, UnitQuaternion, Vector3, did_you_mean,
};
use std::collections::{HashMap, HashSet};

/// Mass over squared height of a person of whom nothing else is known (kg/m²).
const BODY_MASS_INDEX: f64 = 22.0;
/// How thin bones are which nobody knows: radius over length; and their density (kg/m³).
const SLENDER: f64 = 0.125;
const DENSITY: f64 = 1060.0;
/// Cross-section of a finger over that of the palm, and of a bone that only helps another over that one's (chosen).
const FINGER: f64 = 0.1;
const HELPER: f64 = 0.01;
/// The share of its segment that a bone without length has.
const POINT: f64 = 1e-3;

/// A bone, in metres.
pub(crate) struct Length {
    pub(crate) parent: Option<usize>,
    /// From its joint to where it ends.
    pub(crate) along: Vector3<f64>,
    pub(crate) bone: Option<Bone>,
}

/// What a bone weighs.
pub(crate) struct Weight {
    pub(crate) mass: f64,
    pub(crate) com: Vector3<f64>,
    pub(crate) inertia: Inertia,
    pub(crate) shape: Option<Shape>,
}

/// Refuses a mass or a unit that is none.
pub(crate) fn check(options: &ReadOptions) -> Result<(), BvhError> {
    for (what, value) in [("mass", options.mass), ("unit", options.unit.map(|unit| 1.0 / unit.per_metre()))] {
        if let Some(value) = value.filter(|value| !(*value > 0.0 && value.is_finite())) {
            return Err(BvhError::Option { what, value });
        }
    }
    Ok(())
}

/// What the bones weigh.
pub(crate) fn weights(
    lengths: &[Length],
    names: &[String],
    options: &ReadOptions,
    said: &mut Said,
) -> Result<Vec<Weight>, BvhError> {
    if !options.masses.is_empty() {
        return table(lengths, names, &options.masses);
    }
    if let Some(height) = stature(lengths) {
        let weights = of_person(lengths, height, options.mass);
        let total: f64 = weights.iter().map(|weight| weight.mass).sum();
        let whose = if options.mass.is_some() {
            "as asked"
        } else {
            "as people of that height have; the file does not say it"
        };
        let message =
            format!("{total:.1} kg, {whose}; shared as an adult's is, by the names and lengths of the bones");
        said.say(FindingKind::Note, "masses", message, None);
        return Ok(weights);
    }
    let weights = of_unknown(lengths, options.mass);
    let total: f64 = weights.iter().map(|weight| weight.mass).sum();
    let message = format!(
        "the names are not those of a person, so each bone weighs what a rod of its length does, {total:.3} kg in all: forces are \
         of that size and no better; give the masses of the bones"
    );
    said.say(FindingKind::Suspect, "masses", message, None);
    Ok(weights)
}

/// The masses of a table, bone by bone.
fn table(lengths: &[Length], names: &[String], masses: &[(String, f64)]) -> Result<Vec<Weight>, BvhError> {
    let index: HashMap<&str, usize> = names.iter().enumerate().map(|(i, name)| (name.as_str(), i)).collect();
    let mut found = vec![0.0; lengths.len()];
    for (name, mass) in masses {
        let Some(&i) = index.get(name.as_str()) else {
            let hint = did_you_mean(name, names.iter().map(String::as_str));
            return Err(BvhError::UnknownBone { name: name.clone(), hint });
        };
        if !(*mass >= 0.0 && mass.is_finite()) {
            return Err(BvhError::BoneMass { name: name.clone(), mass: *mass });
        }
        found[i] = *mass;
    }
    Ok(of_table(lengths, &found))
}

/// Whether the bones are a person's: there is a pelvis, and thigh and shank of both sides.
pub(crate) fn is_person(bones: &[Option<Bone>]) -> bool {
    let found: HashSet<Bone> = bones.iter().flatten().copied().collect();
    let count = |segment| found.iter().filter(|bone| bone.segment == segment).count();
    count(Segment::Pelvis) == 1 && count(Segment::Thigh) == 2 && count(Segment::Shank) == 2
}

/// A person's height (m) by the lengths of thighs and shanks: people's legs are about as long as they are tall.
pub(crate) fn stature(bones: &[Length]) -> Option<f64> {
    let mean = |segment: Segment| {
        let lengths: Vec<f64> = bones
            .iter()
            .filter(|length| length.bone.is_some_and(|bone| bone.segment == segment))
            .map(|length| length.along.norm())
            .collect();
        (!lengths.is_empty()).then(|| lengths.iter().sum::<f64>() / 2.0)
    };
    let legs = mean(Segment::Thigh)? + mean(Segment::Shank)?;
    let height = legs / (Segment::Thigh.of_adult().length + Segment::Shank.of_adult().length);
    (height > 0.0).then_some(height)
}

/// What the bones of a person of this `height` (m) weigh, who weighs `mass` (kg) where that is known.
pub(crate) fn of_person(bones: &[Length], height: f64, mass: Option<f64>) -> Vec<Weight> {
    let total = mass.unwrap_or(BODY_MASS_INDEX * height * height);
    let present: HashSet<Bone> = bones.iter().filter_map(|length| length.bone).collect();
    // Each bone belongs to a segment: its own, that of the hand, or that of the bone it hangs on.
    let mut owners: Vec<Option<(Bone, f64)>> = Vec::new();
    for length in bones {
        let above = length.parent.and_then(|parent| owners[parent]);
        owners.push(match length.bone {
            Some(Bone { segment: Segment::Finger, side }) => {
                let hand = Bone { segment: Segment::Hand, side };
                if present.contains(&hand) {
                    Some((hand, FINGER))
                } else {
                    above.map(|(bone, _)| (bone, HELPER))
                }
            }
            Some(bone) => Some((bone, 1.0)),
            None => above.map(|(bone, _)| (bone, HELPER)),
        });
    }
    let mut shares: HashMap<Bone, f64> = HashMap::new();
    for (segment, bone) in all_bones() {
        let owner = owner(bone, &present);
        *shares.entry(owner).or_default() += segment.of_adult().mass;
    }
    let whole: f64 = shares.values().sum();
    // A bone's share of its segment goes with its length.
    let portions: Vec<f64> = bones
        .iter()
        .zip(&owners)
        .map(|(length, owner)| {
            owner.map_or(0.0, |(bone, section)| {
                section * (length.along.norm() + POINT * bone.segment.of_adult().length * height)
            })
        })
        .collect();
    let mut sums: HashMap<Bone, f64> = HashMap::new();
    for (owner, portion) in owners.iter().zip(&portions) {
        if let Some((bone, _)) = owner {
            *sums.entry(*bone).or_default() += portion;
        }
    }
    let weigh = |i: usize| match owners[i] {
        Some((bone, _)) => {
            let mass = total * shares.get(&bone).copied().unwrap_or(0.0) / whole * portions[i] / sums[&bone];
            let portion = bone.segment.of_adult();
            // A segment that is one bone, or nearly, is the published one.
            let alone = portions[i] > 0.9 * sums[&bone] && shares[&bone] < 1.5 * portion.mass;
            let has_length = bones[i].along.norm() > 0.0;
            match portion.limb.filter(|_| alone && has_length && bones[i].bone == Some(bone)) {
                Some(limb) => published(mass, bones[i].along, limb, portion.density),
                None => solid(mass, bones[i].along, portion.density),
            }
        }
        // Above the pelvis: what places the body in the world.
        None => solid(POINT * total, bones[i].along, DENSITY),
    };
    (0..bones.len()).map(weigh).collect()
}

/// Every segment of a body, with the bone that it is.
fn all_bones() -> impl Iterator<Item = (Segment, Bone)> {
    use Segment::{Clavicle, Foot, Forearm, Hand, Head, Neck, Pelvis, Shank, Thigh, Toes, Trunk, UpperArm};
    use solaris_model::rig::Side::{Left, Right};
    let middle = [Pelvis, Trunk, Neck, Head].map(|segment| (segment, Bone { segment, side: None }));
    let paired = [Clavicle, UpperArm, Forearm, Hand, Thigh, Shank, Foot, Toes]
        .into_iter()
        .flat_map(|segment| [Left, Right].map(|side| (segment, Bone { segment, side: Some(side) })));
    middle.into_iter().chain(paired)
}

/// The bone that carries the mass of `bone`, where the rig may not have it: the next one inwards.
fn owner(bone: Bone, present: &HashSet<Bone>) -> Bone {
    let mut at = bone;
    while !present.contains(&at) {
        let (segment, side) = match at.segment {
            Segment::Toes => (Segment::Foot, at.side),
            Segment::Foot => (Segment::Shank, at.side),
            Segment::Shank => (Segment::Thigh, at.side),
            Segment::Finger => (Segment::Hand, at.side),
            Segment::Hand => (Segment::Forearm, at.side),
            Segment::Forearm => (Segment::UpperArm, at.side),
            Segment::UpperArm => (Segment::Clavicle, at.side),
            Segment::Head => (Segment::Neck, None),
            Segment::Clavicle | Segment::Neck => (Segment::Trunk, None),
            Segment::Trunk | Segment::Thigh => (Segment::Pelvis, None),
            Segment::Pelvis => return at,
        };
        at = Bone { segment, side };
    }
    at
}

/// What bones weigh of which nobody knows anything: solids of one slenderness, of `mass` (kg) together where that is known.
pub(crate) fn of_unknown(bones: &[Length], mass: Option<f64>) -> Vec<Weight> {
    let size = bones.iter().map(|length| length.along.norm()).fold(0.0, f64::max);
    let volume = |length: &Length| {
        let long = length.along.norm().max(POINT.cbrt() * size);
        std::f64::consts::PI * SLENDER * SLENDER * long * long * long
    };
    let all: f64 = bones.iter().map(volume).sum();
    let density = mass.map_or(DENSITY, |mass| mass / all);
    bones.iter().map(|length| solid(density * volume(length), length.along, DENSITY)).collect()
}

/// Masses of a table (kg), one a bone; bones that it does not name have none.
pub(crate) fn of_table(bones: &[Length], masses: &[f64]) -> Vec<Weight> {
    bones.iter().zip(masses).map(|(length, mass)| solid(*mass, length.along, DENSITY)).collect()
}

/// A limb's segment as it was measured: `limb` as in [`solaris_model::Portion`].
fn published(mass: f64, along: Vector3<f64>, [com, across, lengthwise]: [f64; 3], density: f64) -> Weight {
    let length = along.norm();
    let Weight { shape, .. } = solid(mass, along, density);
    let axis = along / length;
    let [about, across] = [lengthwise, across].map(|radius| mass * (radius * length).powi(2));
    let inertia = Matrix3::identity() * across + axis * axis.transpose() * (about - across);
    Weight { mass, com: along * com, inertia: Inertia::Tensor(inertia), shape }
}

/// A cylinder from the joint to the end of the bone; a ball where that would be shorter than it is thick.
fn solid(mass: f64, along: Vector3<f64>, density: f64) -> Weight {
    let (length, volume) = (along.norm(), mass / density);
    if mass <= 0.0 {
        return Weight { mass: 0.0, com: Vector3::zeros(), inertia: Inertia::Point, shape: None };
    }
    let radius = (volume / (std::f64::consts::PI * length)).sqrt();
    let centre = along / 2.0;
    let (kind, rotation) = if radius.is_finite() && 2.0 * radius < length {
        let turn = UnitQuaternion::rotation_between(&Vector3::y(), &along)
            .unwrap_or_else(|| UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI));
        (ShapeKind::Cylinder { radius, length }, turn)
    } else {
        let radius = (volume * 0.75 / std::f64::consts::PI).cbrt();
        (ShapeKind::Sphere { radius }, UnitQuaternion::identity())
    };
    let shape = Shape { kind, placement: Placement::from_parts(centre.into(), rotation) };
    Weight { mass, com: centre, inertia: Inertia::Uniform(shape), shape: Some(shape) }
}
