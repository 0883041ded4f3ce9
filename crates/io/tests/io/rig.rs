//! People on animators' bones: the same places as before, by the rig's names as another module reads them, in its rest pose.

mod axes;
mod track;

use nalgebra::Point3;
use solaris_gait::{WalkRequest, walk};
use solaris_io::bvh::{self, Unit};
use solaris_io::rig::{Rest, Rig, RigMap, Rigged};
use solaris_model::rig::{Segment, Side, bones};
use solaris_model::{Figure, FigureBuilder, Human, Joint, LinkSpec, Motion, MotionInfo, Vector3};
use solaris_skin::{Detail, Influence, Skin, skin};
use std::collections::BTreeSet;

fn walked() -> (Figure, Motion) {
    let figure = Human::new(1.75, 73.0).build().expect("a person");
    let request = WalkRequest { step_frequency: Some(110.0), ..WalkRequest::default() };
    let motion = walk(&figure, &request).expect("a walk").motion(&figure, 30.0).expect("a motion");
    (figure, motion)
}

#[test]
fn every_joint_and_centre_of_mass_is_where_it_was() {
    let (figure, motion) = walked();
    for rig in Rig::ALL {
        let on = Rigged::new(&figure, rig).expect("on the rig");
        let moved = on.motion(&figure, &motion).expect("a motion");
        for sample in (0..motion.len()).step_by(7) {
            let (ours, theirs) = (figure.places(motion.q(sample)), on.figure.places(moved.q(sample)));
            for (i, a) in ours.iter().enumerate() {
                let bone = on.bones[i];
                let b = &theirs[bone];
                assert!((a.translation.vector - b.translation.vector).norm() < 1e-12, "{rig:?}, link {i}");
                let com = |figure: &Figure, i: usize, place: &nalgebra::Isometry3<f64>| {
                    place * Point3::from(*figure.links()[i].com())
                };
                assert!((com(&figure, i, a) - com(&on.figure, bone, b)).norm() < 1e-12, "{rig:?}, link {i}");
            }
        }
        assert!((on.figure.mass() - figure.mass()).abs() < 1e-12);
    }
}

#[test]
fn at_zero_all_bones_stand_along_the_world_s_axes_in_the_rest_pose() {
    let (figure, _) = walked();
    for rig in Rig::ALL {
        let on = Rigged::new(&figure, rig).expect("on the rig");
        let mut q = vec![0.0; on.figure.layout().nq()];
        on.figure.neutral(&mut q).expect("the neutral posture");
        let places = on.figure.places(&q);
        assert!(places.iter().all(|place| place.rotation.angle() < 1e-12), "{rig:?}");
        let at = |link: &str| places[on.bones[figure.link_index(link).expect("a link")]].translation.vector;
        for (side, out) in [("left", 1.0), ("right", -1.0)] {
            let arm = at(&format!("{side}_hand")) - at(&format!("{side}_upper_arm"));
            let down = if rig == Rig::Unreal { -1.0 } else { 0.0 };
            let expected = Vector3::new(out, down, 0.0).normalize();
            // The elbow is a few millimetres off the line.
            assert!((arm.normalize() - expected).norm() < 0.02, "{rig:?}: {arm}");
            let leg = at(&format!("{side}_foot")) - at(&format!("{side}_thigh"));
            assert!((leg.normalize() + Vector3::y()).norm() < 0.02, "{rig:?}: {leg}");
        }
    }
}

/// The chain of bones from the pelvis up to this one, as the rig's own documents and files have it.
const UP: [(Rig, &str); 9] = [
    (
        Rig::Mixamo,
        "mixamorig:Hips mixamorig:Spine mixamorig:Spine1 mixamorig:Spine2 mixamorig:Neck mixamorig:Head mixamorig:HeadTop_End",
    ),
    (Rig::Mixamo, "mixamorig:Hips mixamorig:Spine mixamorig:Spine1 mixamorig:Spine2 mixamorig:LeftShoulder"),
    (Rig::Vrm, "hips spine chest upperChest neck head"),
    (Rig::Unreal, "root pelvis spine_01 spine_02 spine_03 spine_04 spine_05 neck_01 neck_02 head"),
    (Rig::Unreal, "root pelvis spine_01 spine_02 spine_03 spine_04 spine_05 clavicle_r"),
    (Rig::Unity, "Hips Spine Chest UpperChest Neck Head"),
    (Rig::Smpl, "pelvis spine1 spine2 spine3 left_collar left_shoulder left_elbow left_wrist left_hand"),
    (Rig::Cmu, "Hips LowerBack Spine Spine1 Neck Neck1 Head"),
    (Rig::Cmu, "Hips RHipJoint RightUpLeg RightLeg RightFoot RightToeBase"),
];

#[test]
fn bones_that_we_lack_are_in_the_chain_and_never_turn() {
    let (figure, motion) = walked();
    for (rig, chain) in UP {
        let on = Rigged::new(&figure, rig).expect("on the rig");
        let moved = on.motion(&figure, &motion).expect("a motion");
        let links = on.figure.links();
        let top = on.figure.link_index(chain.split(' ').next_back().expect("a name"));
        let mut up: Vec<usize> = std::iter::successors(top, |i| links[*i].parent()).collect();
        up.reverse();
        let names: Vec<&str> = up.iter().map(|i| links[*i].name()).collect();
        assert_eq!(names.join(" "), chain);
        let places = on.figure.places(moved.q(moved.len() / 2));
        for (below, bone) in up.iter().zip(&up[1..]).filter(|(_, bone)| !on.bones.contains(bone)) {
            let (below, bone) = (&places[*below], &places[*bone]);
            assert!(below.rotation.angle_to(&bone.rotation) < 1e-12);
            let step = (bone.translation.vector - below.translation.vector).norm();
            // CMU's have no length.
            let is_hip = links[up[1]].name().ends_with("HipJoint");
            assert!((0.02..0.25).contains(&step) || is_hip && step == 0.0, "{rig:?}: {step} m");
        }
    }
    // SMPL's own number of joints.
    assert_eq!(Rigged::new(&figure, Rig::Smpl).expect("on the rig").figure.links().len(), 24);
}

#[test]
fn names_say_the_segments_that_the_links_are() {
    let (figure, _) = walked();
    let segments = |link: &str| match link.trim_start_matches("left_").trim_start_matches("right_") {
        "pelvis" => Segment::Pelvis,
        "abdomen" | "thorax" => Segment::Trunk,
        "neck" => Segment::Neck,
        "head" => Segment::Head,
        "clavicle" => Segment::Clavicle,
        "upper_arm" => Segment::UpperArm,
        "forearm" => Segment::Forearm,
        "hand" => Segment::Hand,
        "thigh" => Segment::Thigh,
        "shank" => Segment::Shank,
        "foot" => Segment::Foot,
        _ => Segment::Toes,
    };
    for rig in Rig::ALL {
        let names: Vec<&str> =
            figure.links().iter().map(|link| rig.bone(link.name()).expect("a bone")).collect();
        for (link, bone) in figure.links().iter().zip(bones(&names)) {
            let bone = bone.unwrap_or_else(|| panic!("{rig:?} of {}", link.name()));
            let side = [("left_", Side::Left), ("right_", Side::Right)];
            let side = side.iter().find(|(prefix, _)| link.name().starts_with(prefix)).map(|(_, side)| *side);
            assert_eq!(
                (bone.segment, bone.side),
                (segments(link.name()), side),
                "{rig:?} of {}",
                link.name()
            );
        }
    }
}

#[test]
fn the_skin_is_bound_at_rest_and_where_it_was_but_about_the_shoulders() {
    let (figure, motion) = walked();
    let own = skin(&figure, Detail::Coarse);
    let on = Rigged::new(&figure, Rig::Mixamo).expect("on the rig");
    let moved = on.motion(&figure, &motion).expect("a motion");
    let theirs = on.skin(&figure, Detail::Coarse);
    assert!(theirs.bind.iter().all(|place| place.rotation.angle() < 1e-12));
    assert!((theirs.volume() / own.volume() - 1.0).abs() < 0.03, "{}", theirs.volume() / own.volume());
    assert!(theirs.normals.iter().all(|normal| (normal.norm() - 1.0).abs() < 1e-9));
    let (mut alone, mut shared): (f64, f64) = (0.0, 0.0);
    for sample in (0..motion.len()).step_by(20) {
        let a = own.posed(&figure.places(motion.q(sample)));
        let b = theirs.posed(&on.figure.places(moved.q(sample)));
        for ((a, b), influences) in a.iter().zip(&b).zip(&own.influences) {
            let off = (a - b).norm();
            if influences[0].share > 0.999_999 {
                alone = alone.max(off);
            } else {
                shared = shared.max(off);
            }
        }
    }
    assert!(alone < 1e-6, "{alone} m");
    assert!(shared < 0.04, "{shared} m");
}

#[test]
fn a_file_of_bones_reads_back_to_the_same_places() {
    let (figure, motion) = walked();
    for rig in [Rig::Vrm, Rig::Unreal] {
        let on = Rigged::new(&figure, rig).expect("on the rig");
        let moved = on.motion(&figure, &motion).expect("a motion");
        let mut text = Vec::new();
        bvh::write(&on.figure, &moved, Unit::Metres, &mut text).expect("written");
        let text = String::from_utf8(text).expect("text");
        let options = bvh::ReadOptions { unit: Some(Unit::Metres), ..Default::default() };
        let clip = bvh::read(&text, &options).expect("read");
        for sample in (0..motion.len()).step_by(11) {
            let (ours, theirs) = (figure.places(motion.q(sample)), clip.figure.places(clip.motion.q(sample)));
            for (link, place) in figure.links().iter().zip(&ours) {
                let name = rig.bone(link.name()).expect("a bone");
                let read = theirs[clip.figure.link_index(name).expect("a joint")];
                // Six decimals.
                assert!(
                    (place.translation.vector - read.translation.vector).norm() < 1e-5,
                    "{rig:?}: {name}"
                );
            }
        }
    }
}

#[test]
fn contacts_events_and_planted_points_go_along() {
    let (figure, motion) = walked();
    let on = Rigged::new(&figure, Rig::Smpl).expect("on the rig");
    let moved = on.motion(&figure, &motion).expect("a motion");
    assert_eq!(moved.events, motion.events);
    let (a, b) = (&motion.planted[1], &moved.planted[1]);
    let sample = motion.time().partition_point(|time| *time < a.start) + 1;
    let before = figure.places(motion.q(sample))[a.link] * Point3::from(a.point);
    let after = on.figure.places(moved.q(sample))[b.link] * Point3::from(b.point);
    assert!((before - after).norm() < 1e-12);
}

#[test]
fn what_is_no_person_is_refused_by_its_link() {
    let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(1.0);
    let pendulum = FigureBuilder::new("pendulum").link(bob).build().expect("a figure");
    let error = Rigged::new(&pendulum, Rig::Vrm).expect_err("no person").to_string();
    assert!(error.starts_with("the rig 'vrm' has no bone for link 'bob'"), "{error}");
}

#[test]
fn a_map_names_bones_and_says_how_they_rest() {
    let (figure, motion) = walked();
    let names = r#"bones: {"pelvis": "Root_M", "left_thigh": "Hip L", "head": "neck", "neck": "cervical"})"#;
    for (rest, expected, arm) in [
        ("rest: A, ", Rest::A, Vector3::new(1.0, -1.0, 0.0).normalize()),
        ("rest: own, ", Rest::Own, -Vector3::y()),
        ("rest: T, ", Rest::T, Vector3::x()),
        ("", Rest::T, Vector3::x()),
    ] {
        let map = RigMap::read(&format!("Rig({rest}{names}")).expect("a map");
        assert_eq!((map.rest(), map.rig()), (expected, None));
        let on = Rigged::new(&figure, &map).expect("on the bones");
        assert_eq!(on.figure.links().len(), figure.links().len());
        for (link, bone) in
            [("pelvis", "Root_M"), ("left_thigh", "Hip L"), ("head", "neck"), ("left_hand", "left_hand")]
        {
            let own = on.bones[figure.link_index(link).expect("a link")];
            assert_eq!(on.figure.links()[own].name(), bone);
        }
        let mut q = vec![0.0; on.figure.layout().nq()];
        on.figure.neutral(&mut q).expect("the neutral posture");
        let rest = on.figure.places(&q);
        let at = |link: &str| rest[on.bones[figure.link_index(link).expect("a link")]].translation.vector;
        let found = (at("left_hand") - at("left_upper_arm")).normalize();
        assert!((found - arm).norm() < 0.02, "{expected:?}: {found}");
        let moved = on.motion(&figure, &motion).expect("a motion");
        let (ours, theirs) = (figure.places(motion.q(9)), on.figure.places(moved.q(9)));
        for (a, bone) in ours.iter().zip(&on.bones) {
            assert!((a.translation.vector - theirs[*bone].translation.vector).norm() < 1e-12);
        }
    }
    assert_eq!(RigMap::from(Rig::Vrm).bone("left_thigh"), Some("leftUpperLeg"));
}

#[test]
fn a_map_s_faults_are_told_by_their_places() {
    for (text, place, why) in [
        (
            r#"Rig(rest: T, bones: {"pelvs": "Hips"})"#,
            "line 1, column 22:",
            "no link 'pelvs'; did you mean 'pelvis'?",
        ),
        (r#"Rig(bones: {"tail": "Tail"})"#, "line 1, column 13:", "its links are pelvis, abdomen"),
        (
            r#"Rig(bones: {"pelvis": "A", "head": "A"})"#,
            "line 1, column 36:",
            "'pelvis' and 'head' are both called 'A'",
        ),
        (
            r#"Rig(bones: {"pelvis": "head"})"#,
            "line 1, column 23:",
            "'head' and 'pelvis' are both called 'head'",
        ),
        (
            r#"Rig(bones: {"pelvis": "A", "pelvis": "B"})"#,
            "line 1, column 28:",
            "link 'pelvis' is given twice",
        ),
        (r#"Rig(bones: {"pelvis": " "})"#, "line 1, column 23:", "the bone of 'pelvis' is empty"),
        (r#"Rig(bones: {"pelvis": Hips})"#, "line 1, column 23:", "must stand in quotes"),
        ("Rig(rest: V, bones: {})", "line 1, column 11:", "'V' is not known here"),
        ("Rig(rest: T)", "line 1, column 1:", "has no bones"),
        ("Rig(bone: {})", "line 1, column 5:", "did you mean 'bones'?"),
    ] {
        let error = RigMap::read(text).expect_err(text).to_string();
        assert!(error.contains(place) && error.contains(why), "{text}: {error}");
    }
}

#[test]
fn fingers_and_eyes_are_bones_that_take_what_is_theirs_of_the_skin() {
    let (figure, motion) = walked();
    let own = skin(&figure, Detail::Rough);
    for (rig, bones, chain) in [
        (
            Rig::Mixamo,
            30,
            "mixamorig:LeftHand mixamorig:LeftHandPinky1 mixamorig:LeftHandPinky2 mixamorig:LeftHandPinky3",
        ),
        (Rig::Vrm, 32, "rightHand rightThumbMetacarpal rightThumbProximal rightThumbDistal"),
        (Rig::Unreal, 30, "hand_r index_01_r index_02_r index_03_r"),
        (Rig::Unity, 32, "Head RightEye"),
        (Rig::Smpl, 0, "left_wrist left_hand"),
        (Rig::Cmu, 4, "LeftForeArm LeftHand LeftFingerBase LeftHandIndex1"),
        (Rig::Cmu, 4, "RightHand RThumb"),
    ] {
        let on = Rigged::new(&figure, rig).expect("on the rig");
        let parts: BTreeSet<_> =
            own.parts.iter().filter_map(|part| on.figure.link_index(rig.part(&part.name)?)).collect();
        assert_eq!(parts.len(), bones, "{rig:?}");
        let links = on.figure.links();
        for (parent, bone) in chain.split(' ').zip(chain.split(' ').skip(1)) {
            let link = on.figure.link(bone).expect("a bone");
            assert_eq!(link.parent().map(|i| links[i].name()), Some(parent), "{rig:?}");
        }
        // Each has its vertices, and all go where they went.
        let theirs = on.skin(&figure, Detail::Rough);
        for part in &parts {
            let all = theirs.influences.iter().flatten();
            let share: f32 = all.filter(|i| usize::from(i.link) == *part).map(|i| i.share).sum();
            assert!(share > 4.0, "{rig:?}, {}: {share} vertices", links[*part].name());
        }
        let moved = on.motion(&figure, &motion).expect("a motion");
        let a = own.posed(&figure.places(motion.q(5)));
        let b = theirs.posed(&on.figure.places(moved.q(5)));
        for (vertex, _) in own.fine.iter().filter(|(v, _)| own.influences[*v as usize][0].share > 0.999_999) {
            let off = (a[*vertex as usize] - b[*vertex as usize]).norm();
            assert!(off < 1e-6, "{rig:?}: {off} m");
        }
        assert!(
            theirs
                .influences
                .iter()
                .all(|four| (four.iter().map(|i| i.share).sum::<f32>() - 1.0).abs() < 1e-5)
        );
    }
}

#[test]
fn a_finger_that_is_bent_bends_and_nothing_else_does() {
    let (figure, _) = walked();
    let on = Rigged::new(&figure, Rig::Vrm).expect("on the rig");
    let skin = on.skin(&figure, Detail::Coarse);
    let bone = on.figure.link_index("leftIndexProximal").expect("a bone");
    let mut places = skin.bind.clone();
    let joint = places[bone].translation.vector;
    // About z, a T pose's left palm looking down: fingers go down.
    let turn = solaris_model::UnitQuaternion::from_scaled_axis(Vector3::z() * -1.0);
    let bent = |place: &nalgebra::Isometry3<f64>| {
        let at = joint + turn * (place.translation.vector - joint);
        nalgebra::Isometry3::from_parts(at.into(), turn * place.rotation)
    };
    for name in ["leftIndexProximal", "leftIndexIntermediate", "leftIndexDistal"] {
        let link = on.figure.link_index(name).expect("a bone");
        places[link] = bent(&places[link]);
    }
    let moved = skin.posed(&places);
    let (mut far, mut most): (usize, f64) = (0, 0.0);
    for (a, b) in skin.points.iter().zip(&moved) {
        let off = (a - b).norm();
        (far, most) = (far + usize::from(off > 0.01), most.max(off));
        // The next finger's middle is as far away as a finger is wide.
        assert!(off < 1e-4 || (a - joint).norm() < 0.10 && a.x > joint.x - 0.03, "{a:?}: {off}");
    }
    assert!(far > 50 && most > 0.05 && most < 0.09, "{far} vertices, {most} m");
}

/// Somebody who stands and turns one joint to this angle (rad) within a second.
fn turns(figure: &Figure, joint: &str, to: f64) -> Motion {
    let layout = figure.layout();
    let index = layout.q_names().iter().position(|name| name == joint).expect("a coordinate");
    let frames = 31;
    let time: Vec<f64> = (0..frames).map(|i| f64::from(i) / 30.0).collect();
    let q = time.iter().flat_map(|time| {
        let mut row = vec![0.0; layout.nq()];
        row[index] = to * time;
        row
    });
    let still = vec![0.0; layout.nv() * time.len()];
    let columns = [q.collect(), still.clone(), still];
    Motion::new(figure, MotionInfo::on_earth(figure, 30.0), time, columns).expect("a motion")
}

#[test]
fn bones_of_twist_share_out_a_roll_along_the_limb() {
    let (figure, _) = walked();
    let on = Rigged::new(&figure, Rig::Unreal).expect("on the rig");
    let y = Vector3::y();
    let roll = |at: &nalgebra::Isometry3<f64>, before: &nalgebra::Isometry3<f64>| {
        // About the limb, which hangs: what of the turn is about the vertical.
        (at.rotation * before.rotation.inverse()).scaled_axis().dot(&y)
    };
    // A third of what the joint gives is in the first one, two thirds in the second, all of it in what comes then.
    for (joint, names, thirds) in [
        (
            "left_shoulder.ry",
            ["clavicle_l", "upperarm_twist_01_l", "upperarm_twist_02_l", "upperarm_l"],
            [0.0, 1.0, 2.0, 3.0],
        ),
        (
            "left_elbow.ry",
            ["upperarm_l", "lowerarm_twist_02_l", "lowerarm_twist_01_l", "hand_l"],
            [0.0, 1.0, 2.0, 3.0],
        ),
        (
            "left_elbow.ry",
            ["upperarm_twist_01_l", "upperarm_twist_02_l", "upperarm_l", "lowerarm_l"],
            [0.0, 0.0, 0.0, 3.0],
        ),
        ("right_hip.ry", ["pelvis", "thigh_twist_01_r", "thigh_twist_02_r", "thigh_r"], [0.0, 1.0, 2.0, 3.0]),
        ("right_ankle.ry", ["calf_r", "calf_twist_02_r", "calf_twist_01_r", "foot_r"], [0.0, 1.0, 2.0, 3.0]),
    ] {
        for most in [0.6, -2.4, 4.0] {
            let moved = on.motion(&figure, &turns(&figure, joint, most)).expect("a motion");
            let at = |sample: usize| on.figure.places(moved.q(sample));
            // Past half a turn the places say no more than the rest of a turn.
            let (before, after) = (at(0), at(if most > 3.0 { 20 } else { 30 }));
            let most = if most > 3.0 { most * 20.0 / 30.0 } else { most };
            for (name, third) in names.iter().zip(thirds) {
                let bone = on.figure.link_index(name).expect("a bone");
                let found = roll(&after[bone], &before[bone]);
                // Joints of arms and legs lie some millimetres beside the vertical.
                assert!(
                    (found - most * third / 3.0).abs() < 0.02 * most.abs(),
                    "{joint} by {most}, {name}: {found}"
                );
            }
        }
    }
}

#[test]
fn a_forearm_that_is_rolled_keeps_more_of_what_it_holds() {
    let (figure, _) = walked();
    let lost = |rig: Rig| {
        let on = Rigged::new(&figure, rig).expect("on the rig");
        let skin = on.skin(&figure, Detail::Coarse);
        let sum = |four: &[Influence; 4]| four.iter().map(|i| i.share).sum::<f32>();
        assert!(skin.influences.iter().all(|four| (sum(four) - 1.0).abs() < 1e-5));
        let moved = on.motion(&figure, &turns(&figure, "left_elbow.ry", 1.5)).expect("a motion");
        let volume = |sample: usize| {
            let points = skin.posed(&on.figure.places(moved.q(sample)));
            Skin { points, ..skin.clone() }.volume()
        };
        volume(0) - volume(30)
    };
    let (with, without) = (lost(Rig::Unreal), lost(Rig::Mixamo));
    assert!(without > 1e-4 && with < 0.3 * without, "{with:e} m³ of {without:e}");
}
