//! VRM's extension, read as JSON beside the bones that the specification lists.

use serde_json::Value;
use solaris_io::glb::{self, Actor, Clip, Detail, Options};
use solaris_io::rig::{Rig, Rigged};
use solaris_io::{IoError, VrmProblem};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Vector3, human};

const VRM: Options = Options { skin: Some(Detail::Rough), forces: false, vrm: true };

/// The bones that `VRMC_vrm-1.0/humanoid.md` marks as required.
const REQUIRED: [&str; 15] = [
    "hips",
    "spine",
    "head",
    "leftUpperArm",
    "leftLowerArm",
    "leftHand",
    "leftUpperLeg",
    "leftLowerLeg",
    "leftFoot",
    "rightUpperArm",
    "rightLowerArm",
    "rightHand",
    "rightUpperLeg",
    "rightLowerLeg",
    "rightFoot",
];

/// The JSON of a file whose first chunk it is.
fn json(bytes: &[u8]) -> Value {
    let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    serde_json::from_slice(&bytes[20..20 + length]).expect("JSON")
}

/// Somebody who stands two metres ahead, and is at 3 m there.
fn ahead(figure: &Figure) -> Motion {
    let (mut q, v) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nv()]);
    q[..3].copy_from_slice(&[0.0, 3.0, 2.0]);
    Motion::new(figure, MotionInfo::on_earth(figure, 30.0), vec![0.0], [q, v.clone(), v]).expect("a motion")
}

#[test]
fn the_extension_names_the_node_of_every_bone_and_the_model() {
    let ann = human(1.65, 58.0).expect("a person");
    let on = Rigged::new(&ann, Rig::Vrm).expect("a rig");
    let motion = on.motion(&ann, &ahead(&ann)).expect("a motion");
    let skin = on.skin(&ann, Detail::Rough);
    let actor = Actor { name: "Ann", figure: &on.figure, skin: Some(&skin) };
    let mut bytes = Vec::new();
    let clips = ["stands", "stands again"].map(|name| Clip { name, motions: vec![(0, &motion)] });
    glb::write(&[actor], &clips, VRM, &mut bytes).expect("written");
    let file = json(&bytes);
    assert_eq!(file["extensionsUsed"], serde_json::json!(["VRMC_vrm"]));
    let vrm = &file["extensions"]["VRMC_vrm"];
    assert_eq!(vrm["specVersion"], "1.0");
    assert_eq!(vrm["meta"]["name"], "Ann");
    assert_eq!(vrm["meta"]["licenseUrl"], "https://vrm.dev/licenses/1.0/");
    assert!(vrm["meta"]["authors"][0].as_str().is_some_and(|author| !author.is_empty()));
    let bones = vrm["humanoid"]["humanBones"].as_object().expect("bones");
    assert!(REQUIRED.iter().all(|bone| bones.contains_key(*bone)));
    assert_eq!(bones.len(), on.figure.links().len());
    for (bone, at) in bones {
        let node = at["node"].as_u64().expect("a node") as usize;
        assert_eq!(file["nodes"][node]["name"], bone.as_str());
    }
    // At rest the model stands at the origin, whatever its clips do.
    let hips = &file["nodes"][bones["hips"]["node"].as_u64().expect("a node") as usize];
    let height = hips["translation"][1].as_f64().expect("a height");
    assert_eq!((hips["translation"][0].as_f64(), hips["translation"][2].as_f64()), (Some(0.0), Some(0.0)));
    let lowest = skin.points.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
    assert!((height + lowest).abs() < 2e-3, "soles at {} m", height + lowest);
    // Eyes turn: from between them one looks.
    let offset = &vrm["lookAt"]["offsetFromHeadBone"];
    let eyes = [0, 1, 2].map(|i| offset[i].as_f64().expect("a length"));
    assert!(eyes[0].abs() < 1e-6 && (0.05..0.12).contains(&eyes[1]) && eyes[2] > 0.04, "{eyes:?}");
    assert_eq!(vrm["lookAt"]["type"], "bone");
    // Whoever has no eyes has no way to look.
    let mut bytes = Vec::new();
    let links = on.figure.links();
    let blind = links.iter().filter(|link| !link.name().ends_with("Eye"));
    let blind = blind.fold(FigureBuilder::new("blind"), |builder, link| {
        let joint = Joint::new(link.joint().name());
        builder.link(match link.parent() {
            Some(parent) => LinkSpec::child(link.name(), links[parent].name(), joint),
            None => LinkSpec::root(link.name(), joint),
        })
    });
    let blind = blind.build().expect("a figure");
    glb::write(&[Actor { name: "Ann", figure: &blind, skin: None }], &[], VRM, &mut bytes).expect("written");
    assert!(json(&bytes)["extensions"]["VRMC_vrm"]["lookAt"].is_null());
}

#[test]
fn what_is_not_one_person_on_its_bones_is_refused() {
    let ann = human(1.65, 58.0).expect("a person");
    let refused = |figures: &[&Figure]| {
        let actors: Vec<Actor<'_>> =
            figures.iter().map(|figure| Actor { name: "Ann", figure, skin: None }).collect();
        match glb::write(&actors, &[], VRM, &mut Vec::new()).expect_err("refused") {
            IoError::Vrm(problem) => problem,
            other => panic!("{other}"),
        }
    };
    let on = Rigged::new(&ann, Rig::Vrm).expect("a rig").figure;
    assert_eq!(refused(&[&on, &on]), VrmProblem::Count { count: 2 });
    assert_eq!(refused(&[]), VrmProblem::Count { count: 0 });
    let VrmProblem::Missing { bones, .. } = refused(&[&ann]) else { panic!("her own bones") };
    // Her head is called so, too.
    assert_eq!(bones.len(), REQUIRED.len() - 1);
    let crossed = on.links().iter().fold(FigureBuilder::new("crossed"), |builder, link| {
        let parent = match link.name() {
            "leftFoot" => Some("rightLowerLeg"),
            _ => link.parent().map(|parent| on.links()[parent].name()),
        };
        let joint = Joint::new(link.joint().name()).at(Vector3::zeros());
        builder.link(match parent {
            Some(parent) => LinkSpec::child(link.name(), parent, joint),
            None => LinkSpec::root(link.name(), joint),
        })
    });
    let crossed = crossed.build().expect("a figure");
    let found =
        VrmProblem::Order { bone: "leftFoot", found: Some("rightLowerLeg"), expected: Some("leftLowerLeg") };
    assert_eq!(refused(&[&crossed]), found);
}
