//! What VRM 1.0 adds to a file: which node is which bone of a person, and whose model it is.
//!
//! # Source
//!
//! VRM Consortium, `VRMC_vrm-1.0`: `humanoid.md`, `meta.md`, `tpose.md`, `lookAt.md` (2022).

use super::Actor;
use super::skeleton::Skeleton;
use crate::error::{IoError, VrmProblem};
use serde_json::{Map, Value, json};
use solaris_model::Figure;

/// A bone of the specification, the one that it hangs on, and whether every person must have it.
type Bone = (&'static str, Option<&'static str>, bool);

/// All but the jaw, which our people do not have.
const BONES: [Bone; 54] = [
    ("hips", None, true),
    ("spine", Some("hips"), true),
    ("chest", Some("spine"), false),
    ("upperChest", Some("chest"), false),
    ("neck", Some("upperChest"), false),
    ("head", Some("neck"), true),
    ("leftShoulder", Some("upperChest"), false),
    ("leftUpperArm", Some("leftShoulder"), true),
    ("leftLowerArm", Some("leftUpperArm"), true),
    ("leftHand", Some("leftLowerArm"), true),
    ("leftUpperLeg", Some("hips"), true),
    ("leftLowerLeg", Some("leftUpperLeg"), true),
    ("leftFoot", Some("leftLowerLeg"), true),
    ("leftToes", Some("leftFoot"), false),
    ("rightShoulder", Some("upperChest"), false),
    ("rightUpperArm", Some("rightShoulder"), true),
    ("rightLowerArm", Some("rightUpperArm"), true),
    ("rightHand", Some("rightLowerArm"), true),
    ("rightUpperLeg", Some("hips"), true),
    ("rightLowerLeg", Some("rightUpperLeg"), true),
    ("rightFoot", Some("rightLowerLeg"), true),
    ("rightToes", Some("rightFoot"), false),
    ("leftThumbMetacarpal", Some("leftHand"), false),
    ("leftThumbProximal", Some("leftThumbMetacarpal"), false),
    ("leftThumbDistal", Some("leftThumbProximal"), false),
    ("leftIndexProximal", Some("leftHand"), false),
    ("leftIndexIntermediate", Some("leftIndexProximal"), false),
    ("leftIndexDistal", Some("leftIndexIntermediate"), false),
    ("leftMiddleProximal", Some("leftHand"), false),
    ("leftMiddleIntermediate", Some("leftMiddleProximal"), false),
    ("leftMiddleDistal", Some("leftMiddleIntermediate"), false),
    ("leftRingProximal", Some("leftHand"), false),
    ("leftRingIntermediate", Some("leftRingProximal"), false),
    ("leftRingDistal", Some("leftRingIntermediate"), false),
    ("leftLittleProximal", Some("leftHand"), false),
    ("leftLittleIntermediate", Some("leftLittleProximal"), false),
    ("leftLittleDistal", Some("leftLittleIntermediate"), false),
    ("leftEye", Some("head"), false),
    ("rightThumbMetacarpal", Some("rightHand"), false),
    ("rightThumbProximal", Some("rightThumbMetacarpal"), false),
    ("rightThumbDistal", Some("rightThumbProximal"), false),
    ("rightIndexProximal", Some("rightHand"), false),
    ("rightIndexIntermediate", Some("rightIndexProximal"), false),
    ("rightIndexDistal", Some("rightIndexIntermediate"), false),
    ("rightMiddleProximal", Some("rightHand"), false),
    ("rightMiddleIntermediate", Some("rightMiddleProximal"), false),
    ("rightMiddleDistal", Some("rightMiddleIntermediate"), false),
    ("rightRingProximal", Some("rightHand"), false),
    ("rightRingIntermediate", Some("rightRingProximal"), false),
    ("rightRingDistal", Some("rightRingIntermediate"), false),
    ("rightLittleProximal", Some("rightHand"), false),
    ("rightLittleIntermediate", Some("rightLittleProximal"), false),
    ("rightLittleDistal", Some("rightLittleIntermediate"), false),
    ("rightEye", Some("head"), false),
];

/// Refuses what is not one person on VRM's bones.
pub(super) fn check(actors: &[Actor]) -> Result<(), IoError> {
    let [actor] = actors else { return Err(VrmProblem::Count { count: actors.len() }.into()) };
    let figure = actor.figure;
    let has = |bone: &str| figure.link_index(bone).is_some();
    let needs = |(bone, _, required): &Bone| *required || (*bone == "chest" && has("upperChest"));
    let missing: Vec<&str> = BONES.iter().filter(|bone| needs(bone) && !has(bone.0)).map(|b| b.0).collect();
    if !missing.is_empty() {
        return Err(VrmProblem::Missing { figure: figure.name().to_owned(), bones: missing }.into());
    }
    for (bone, ..) in BONES {
        let Some(link) = figure.link_index(bone) else { continue };
        let (found, expected) = (above(figure, link), parent(figure, bone));
        if found != expected {
            return Err(VrmProblem::Order { bone, found, expected }.into());
        }
    }
    Ok(())
}

/// The bone that one hangs on in a figure: the next one above it.
fn above(figure: &Figure, link: usize) -> Option<&'static str> {
    let parents = std::iter::successors(figure.links()[link].parent(), |i| figure.links()[*i].parent());
    let bone = |i: usize| BONES.iter().map(|bone| bone.0).find(|bone| *bone == figure.links()[i].name());
    parents.into_iter().find_map(bone)
}

/// The bone that one shall hang on: the next one of the specification that the figure has.
fn parent(figure: &Figure, bone: &str) -> Option<&'static str> {
    let of = |bone: &str| BONES.iter().find(|known| known.0 == bone).and_then(|known| known.1);
    std::iter::successors(of(bone), |parent| of(parent)).find(|parent| figure.link_index(parent).is_some())
}

/// The extension. Of the licence's terms none is granted beyond what it grants by default: that is for whoever publishes the file.
pub(super) fn extension(actor: &Actor, skeleton: &Skeleton) -> Value {
    let bones = BONES.iter().filter_map(|(bone, ..)| {
        let link = actor.figure.link_index(bone)?;
        Some(((*bone).to_owned(), json!({ "node": skeleton.nodes[link] })))
    });
    let name = if actor.name.is_empty() { "person" } else { actor.name };
    let mut extension = json!({
        "specVersion": "1.0",
        "meta": {
            "name": name,
            "version": "1.0",
            "authors": ["Solaris"],
            "licenseUrl": "https://vrm.dev/licenses/1.0/",
        },
        "humanoid": { "humanBones": bones.collect::<Map<_, _>>() },
    });
    if let Some(look) = look(actor.figure) {
        extension["lookAt"] = look;
    }
    extension
}

/// How far (°) eyes turn to the side, up and down: as far as what they look at is, up to there.
const ASIDE: f64 = 35.0;
const UP: f64 = 25.0;

/// That eyes turn to what is looked at, if there are eyes.
fn look(figure: &Figure) -> Option<Value> {
    let [head, left, right] = ["head", "leftEye", "rightEye"].map(|bone| figure.link_index(bone));
    let mut q = vec![0.0; figure.layout().nq()];
    // The length is the figure's own.
    let _ = figure.neutral(&mut q);
    let places = figure.places(&q);
    let at = |bone: usize| places[bone].translation.vector;
    let middle = places[head?].rotation.inverse() * ((at(left?) + at(right?)) / 2.0 - at(head?));
    let upto = |most: f64| json!({ "inputMaxValue": most, "outputScale": most });
    Some(json!({
        "type": "bone",
        "offsetFromHeadBone": middle.map(|x| x as f32).as_slice(),
        "rangeMapHorizontalInner": upto(ASIDE),
        "rangeMapHorizontalOuter": upto(ASIDE),
        "rangeMapVerticalDown": upto(UP),
        "rangeMapVerticalUp": upto(UP),
    }))
}
