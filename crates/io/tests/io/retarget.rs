//! Motions on other people's characters, which are made by code: limbs point as the source's do, feet stand, and the file stays; where the
//! skeletons agree, rotations are the source's to 1e-6 rad.

pub(crate) mod made;

use made::Made;
use nalgebra::{Point3, UnitQuaternion, Vector3};
use solaris_gait::{Extent, WalkRequest, walk};
use solaris_io::clip::{Clip, ReadOptions};
use solaris_io::glb::{self, Actor, Character, Options, read};
use solaris_io::rig::{Rig, RigMap, Rigged};
use solaris_model::{Figure, Motion, MotionInfo, human};
use solaris_retarget::{BoneMap, Moved, RetargetError, Roles, Skeleton, Take, retarget};

fn walked(figure: &Figure) -> Motion {
    let request = WalkRequest { step_frequency: Some(110.0), ..WalkRequest::default() };
    walk(figure, &request).expect("a walk").motion(figure, 60.0).expect("a motion")
}

fn take(figure: &Figure, motion: &Motion) -> Take {
    let skeleton = Skeleton::of(figure);
    let roles = Roles::find(&skeleton, &BoneMap::default()).expect("roles");
    Take::of(&skeleton, &roles, figure, motion, None).expect("a take")
}

fn named(clip: &str) -> ReadOptions {
    ReadOptions { clip: Some(clip.to_owned()), ..ReadOptions::default() }
}

/// The walk on a character: its file with it, what was done, and the animation read again.
fn onto(bytes: &[u8], take: &Take) -> (Vec<u8>, Moved, Clip) {
    let character = Character::read(bytes, "hero").expect("a character");
    let roles = Roles::find(character.skeleton(), &BoneMap::default()).expect("roles");
    let moved = retarget(take, character.skeleton(), &roles).expect("moved");
    let mut out = Vec::new();
    let name = character.with_clip("walk", &moved, &mut out).expect("written");
    let clip = read(&out, &named(&name)).expect("read again");
    (out, moved, clip)
}

fn angle(a: &UnitQuaternion<f64>, b: &UnitQuaternion<f64>) -> f64 {
    2.0 * (a.inverse() * b).imag().norm()
}

/// The direction from one bone to another in a sample, in the frame in which the character looks along z.
fn direction(clip: &Clip, sample: usize, [from, to]: [&str; 2], facing: f64) -> Vector3<f64> {
    let places = clip.figure.places(clip.motion.q(sample));
    let at = |name: &str| places[clip.figure.link_index(name).expect("a bone")].translation.vector;
    UnitQuaternion::from_scaled_axis(Vector3::y() * -facing) * (at(to) - at(from)).normalize()
}

#[test]
fn a_skeleton_that_agrees_turns_as_the_source_does() {
    let ann = human(1.65, 58.0).expect("a person");
    let motion = walked(&ann);
    let take = take(&ann, &motion);
    let plain = [Rig::Mixamo, Rig::Unreal, Rig::Vrm].map(RigMap::from);
    let own = [Rig::Mixamo, Rig::Unreal].map(|rig| RigMap::from(rig).with_own_axes());
    for map in plain.into_iter().chain(own).map(Some).chain([None]) {
        let rig = map.as_ref().and_then(RigMap::rig);
        let on = map.map(|map| Rigged::new(&ann, map).expect("a rig"));
        let moved = on.as_ref().map(|on| on.motion(&ann, &motion).expect("a motion"));
        let (figure, own) =
            on.as_ref().zip(moved.as_ref()).map_or((&ann, &motion), |(on, moved)| (&on.figure, moved));
        let skin = on.as_ref().map(|on| on.skin(&ann, glb::Detail::Rough));
        let mut bytes = Vec::new();
        let vrm = rig == Some(Rig::Vrm);
        let options = Options { skin: Some(glb::Detail::Rough), forces: false, vrm };
        glb::write(&[Actor { name: "Ann", figure, skin: skin.as_ref() }], &[], options, &mut bytes)
            .expect("written");
        let character = Character::read(&bytes, "Ann").expect("a character");
        let roles = Roles::find(character.skeleton(), &BoneMap::default()).expect("roles");
        let moved = retarget(&take, character.skeleton(), &roles).expect("moved");
        assert!(moved.replanted.is_alike && (moved.replanted.scale - 1.0).abs() < 1e-6);
        let mut worst: f64 = 0.0;
        // Trunk and neck, which may be of more bones than the source's, by their turns as a whole; all others one by one.
        let middle = [&roles.trunk[..], &roles.neck[..]];
        let others = moved.turns.iter().map(|(bone, _)| std::slice::from_ref(bone));
        let others = others.filter(|bone| !middle.iter().any(|chain| chain.contains(&bone[0])));
        let chains: Vec<&[usize]> = others.chain(middle).collect();
        for sample in 0..own.len() {
            for chain in &chains {
                let (mut theirs, mut ours) = (UnitQuaternion::identity(), UnitQuaternion::identity());
                for bone in *chain {
                    let turns = moved.turns.iter().find(|(turned, _)| turned == bone).expect("it turns");
                    let link = figure.link_index(&character.skeleton().bones[*bone].name).expect("a link");
                    let joint = figure.links()[link].joint();
                    let q = &own.q(sample)[figure.layout().joints()[link].q..];
                    theirs *= turns.1[sample];
                    // Unreal's pelvis hangs on what goes along the ground.
                    if figure.links()[0].name() == "root" && figure.links()[link].parent() == Some(0) {
                        ours *= figure.places(own.q(sample))[0].rotation;
                    }
                    ours *= (joint.placement() * joint.moved(q)).rotation;
                }
                worst = worst.max(angle(&theirs, &ours));
            }
        }
        // Bones of twist as the rig has them itself.
        let twists = if rig == Some(Rig::Unreal) { 16 } else { 0 };
        assert_eq!(chains.len(), 20 + twists, "{rig:?}");
        assert!(worst < 1e-6, "{rig:?}: {worst} rad");
    }
}

/// Characters as programs write them.
fn strangers() -> Vec<(&'static str, Made)> {
    let mixamo = |name: &str| {
        format!("mixamorig1:{}", Rig::Mixamo.bone(name).expect("a bone").trim_start_matches("mixamorig:"))
    };
    let unreal = |name: &str| Rig::Unreal.bone(name).expect("a bone").to_owned();
    let blender = |name: &str| match name.split_once('_') {
        Some(("left", part)) => format!("DEF-{part}.L"),
        Some(("right", part)) => format!("DEF-{part}.R"),
        _ => name.to_owned(),
    };
    let short = [0.30, 0.36, 0.20, 0.22];
    vec![
        ("metres, T", Made::default()),
        ("centimetres", Made { names: mixamo, centimetres: true, lengths: short, ..Made::default() }),
        (
            "A pose, legs apart, five spine bones",
            Made { names: unreal, arms: 0.8, legs: 0.15, spine: 5, twists: true, ..Made::default() },
        ),
        ("any axes", Made { names: blender, rolled: true, centimetres: true, spine: 1, ..Made::default() }),
        (
            "looks back",
            Made {
                facing: std::f64::consts::PI,
                rolled: true,
                lengths: [0.55, 0.45, 0.3, 0.3],
                ankle: 0.14,
                ..Made::default()
            },
        ),
    ]
}

#[test]
fn limbs_point_as_the_source_s_whatever_axes_names_and_rest_poses() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann);
    let take = take(&ann, &motion);
    for (what, made) in strangers() {
        let (_, moved, clip) = onto(&made.bytes(), &take);
        let knees = moved.replanted.knee + moved.replanted.hip;
        assert!(knees < 0.7, "{what}: legs turn by {knees} rad");
        for sample in (0..motion.len()).step_by(7) {
            let places = ann.places(motion.q(sample));
            for (from, to, most) in [
                ("left_upper_arm", "left_forearm", 1e-5),
                ("right_forearm", "right_hand", 1e-5),
                ("left_thigh", "left_shank", knees + 1e-5),
                ("right_shank", "right_foot", knees + 1e-5),
            ] {
                let at = |name: &str| places[ann.link_index(name).expect("a link")].translation.vector;
                let expected = (at(to) - at(from)).normalize();
                let found = direction(&clip, sample, [&(made.names)(from), &(made.names)(to)], made.facing);
                let off = found.angle(&expected);
                assert!(off < most, "{what}: {from} is {off} rad off in sample {sample}");
            }
        }
    }
}

#[test]
fn what_stands_in_the_source_stands_on_other_legs() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann);
    let take = take(&ann, &motion);
    for (what, made) in strangers() {
        let (_, moved, clip) = onto(&made.bytes(), &take);
        let done = moved.replanted;
        assert!(done.stances > 5 && !done.is_alike, "{what}");
        assert!(done.slide < 1e-9, "{what}: {} m", done.slide);
        // Seen from outside: soles are on the ground and not below it.
        let facing = UnitQuaternion::from_scaled_axis(Vector3::y() * made.facing);
        let joints = made.joints();
        let mut q = vec![0.0; clip.figure.layout().nq()];
        clip.figure.neutral(&mut q).expect("as long");
        let rest = clip.figure.places(&q);
        let hips = clip.figure.link_index(&joints[0].name).expect("hips");
        let shift = facing * joints[0].at - rest[hips].translation.vector;
        let own: Vec<(usize, Point3<f64>)> = made
            .soles()
            .into_iter()
            .map(|(bone, point)| {
                let link = clip.figure.link_index(&joints[bone].name).expect("a bone");
                (link, rest[link].inverse() * Point3::from(facing * point - shift))
            })
            .collect();
        for sample in 0..clip.motion.len() {
            let places = clip.figure.places(clip.motion.q(sample));
            let lowest =
                own.iter().map(|(link, point)| (places[*link] * point).y).fold(f64::INFINITY, f64::min);
            assert!(lowest.abs() < 4e-3, "{what}: the lowest point is at {lowest} m in sample {sample}");
        }
    }
}

#[test]
fn nothing_of_the_file_is_written_anew() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann);
    let take = take(&ann, &motion);
    let before = Made { centimetres: true, ..Made::default() }.bytes();
    let (after, ..) = onto(&before, &take);
    let parts = |bytes: &[u8]| {
        let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four")) as usize;
        (String::from_utf8(bytes[20..20 + length].to_vec()).expect("text"), bytes[28 + length..].to_vec())
    };
    let ((old, data), (new, more)) = (parts(&before), parts(&after));
    assert_eq!(more[..data.len()], data[..]);
    // Every piece between two additions stands there to the letter.
    assert!(new.contains("0.12345678901234568") && new.contains("\"watts\":40"));
    let parsed = |text: &str| serde_json::from_str::<serde_json::Value>(text).expect("JSON");
    let (old, mut new) = (parsed(&old), parsed(&new));
    assert_eq!(new["animations"][1]["name"], "walk");
    for (key, list) in old.as_object().expect("an object") {
        if let (Some(list), Some(longer)) = (list.as_array(), new[key].as_array_mut()) {
            longer.truncate(list.len());
        }
    }
    new["buffers"][0]["byteLength"] = old["buffers"][0]["byteLength"].clone();
    assert_eq!(old, new);
    // Another reader takes it, and a second clip of that name gets another.
    gltf::Gltf::from_slice(&after).expect("a valid file");
    let (again, ..) = onto(&after, &take);
    assert!(parts(&again).0.contains("\"name\":\"walk 2\""));
}

#[test]
fn five_spine_bones_share_the_turn_of_two() {
    let ann = human(1.75, 73.0).expect("a person");
    let nq = ann.layout().nq();
    let mut q = vec![0.0; nq];
    for (name, value) in [("lumbar.rx", 0.2), ("thorax.rx", 0.4), ("root.ty", 1.0)] {
        q[ann.layout().q_names().iter().position(|dof| dof == name).expect("a dof")] = value;
    }
    let v = vec![0.0; ann.layout().nv()];
    let info = solaris_model::MotionInfo::on_earth(&ann, 30.0);
    let bent = Motion::new(&ann, info, vec![0.0], [q, v.clone(), v]).expect("a motion");
    let made = Made { spine: 5, ..Made::default() };
    let bytes = made.bytes();
    let character = Character::read(&bytes, "hero").expect("a character");
    let roles = Roles::find(character.skeleton(), &BoneMap::default()).expect("roles");
    let moved = retarget(&take(&ann, &bent), character.skeleton(), &roles).expect("moved");
    let turn = |name: &str| {
        let found = moved.turns.iter().find(|(bone, _)| character.skeleton().bones[*bone].name == name);
        found.expect("a bone").1[0].scaled_axis().x
    };
    let spine: Vec<f64> =
        ["abdomen1", "abdomen2", "abdomen3", "abdomen4", "thorax"].iter().map(|name| turn(name)).collect();
    // Two and a half of the five take each: 0.2 rad in pieces of 0.08, 0.4 rad in pieces of 0.16.
    let expected = [0.08, 0.08, 0.12, 0.16, 0.16];
    for (found, expected) in spine.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-6, "{spine:?}");
    }
}

#[test]
fn who_has_no_thigh_is_told_what_there_is() {
    let bytes = Made {
        names: |name| if name == "left_thigh" { "Oberschenkel".to_owned() } else { name.to_owned() },
        ..Made::default()
    }
    .bytes();
    let character = Character::read(&bytes, "hero").expect("a character");
    let error = Roles::find(character.skeleton(), &BoneMap::default()).expect_err("no thigh");
    let RetargetError::NoBone { roles, bones, .. } = &error else { panic!("{error}") };
    assert_eq!(roles, &["left_thigh"]);
    assert!(
        bones.contains("Oberschenkel") && error.to_string().contains("Bones(left_thigh: \"NAME\", …)"),
        "{error}"
    );
    let map = BoneMap::read("(left_thigh: \"Oberschenkel\")").expect("a map");
    assert!(Roles::find(character.skeleton(), &map).is_ok());
    let wrong = BoneMap::read("(left_thigh: \"Oberschenkl\")").expect("a map");
    let error = Roles::find(character.skeleton(), &wrong).expect_err("no such bone").to_string();
    assert!(error.contains("did you mean 'Oberschenkel'?") || error.contains("Oberschenkel"), "{error}");
}

#[test]
fn what_goes_round_and_round_does_so_on_other_legs() {
    let ann = human(1.75, 73.0).expect("a person");
    let request = WalkRequest { extent: Extent::Steps(60), ..WalkRequest::default() };
    let plan = walk(&ann, &request).expect("a walk");
    let round = plan.stride_loop().expect("a middle stride").motion(&ann, 30.0).expect("a motion");
    let take = take(&ann, &round);
    for (what, made) in strangers() {
        let (_, moved, _) = onto(&made.bytes(), &take);
        assert_eq!((moved.time.len(), moved.time[0]), (round.len(), round.time()[0]));
        for (bone, turns) in &moved.turns {
            let off = turns[0].angle_to(&turns[turns.len() - 1]);
            assert!(off < 1e-6, "{what}, bone {bone}: {off} rad from its beginning");
        }
        let [first, last] = [0, round.len() - 1].map(|frame| moved.root.1[frame]);
        let way = (last - first).norm() / moved.replanted.scale;
        assert!((last - first).y.abs() < 1e-9 && (way - 2.0 * 0.712_25).abs() < 0.01, "{what}: {way} m");
        // A foot that stands as the round ends is the one that stands as it begins.
        assert!(
            moved.replanted.stances >= 2 && moved.replanted.slide < 1e-9,
            "{what}: {:?}",
            moved.replanted
        );
    }
}

#[test]
fn who_walks_in_place_stands_on_ground_that_goes_by() {
    let ann = human(1.75, 73.0).expect("a person");
    let request = WalkRequest { extent: Extent::Steps(60), ..WalkRequest::default() };
    let plan = walk(&ann, &request).expect("a walk");
    let stride = plan.stride_loop().expect("a middle stride");
    // A whole number of frames.
    let lasts = stride.motion(&ann, 60.0).expect("a motion").time().last().copied().expect("frames");
    for frames in [66, 26] {
        goes_round_in_place(&ann, &stride.motion(&ann, f64::from(frames) / lasts).expect("a motion"));
    }
}

#[test]
fn who_glides_or_lies_beneath_is_seen_for_what_it_is() {
    let ann = human(1.75, 73.0).expect("a person");
    let skeleton = Skeleton::of(&ann);
    let roles = Roles::find(&skeleton, &BoneMap::default()).expect("roles");
    let (nq, nv) = (ann.layout().nq(), ann.layout().nv());
    let file = Made::default().bytes();
    let moved = |q: Vec<f64>, skip: usize| {
        let frames = q.len() / nq;
        let time = (0..frames).map(|frame| frame as f64 / 30.0).collect();
        let zeros = vec![0.0; nv * frames];
        let motion = Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), time, [q, zeros.clone(), zeros]);
        let take = Take::of(&skeleton, &roles, &ann, &motion.expect("a motion"), None).expect("a take");
        onto(&file, &take.without(skip)).1.replanted
    };
    // Both feet go by at one velocity, but so does the pelvis: no ground is made for it.
    let mut standing = vec![0.0; nq];
    standing[1] = 0.95;
    let glides = (0..60).flat_map(|frame| {
        let mut row = standing.clone();
        row[2] = 5.0 * f64::from(frame) / 30.0;
        row
    });
    let done = moved(glides.collect(), 0);
    assert_eq!((done.belt, done.stances), (0.0, 0));
    // A reference pose far below the ground, which is left out, hides no ground that goes by.
    let request = WalkRequest { extent: Extent::Steps(60), ..WalkRequest::default() };
    let plan = walk(&ann, &request).expect("a walk");
    let walked = plan.stride_loop().expect("a stride").motion(&ann, 30.0).expect("a motion");
    let speed = (walked.q(30)[2] - walked.q(0)[2]) / (walked.time()[30] - walked.time()[0]);
    let in_place = (0..walked.len()).flat_map(|frame| {
        let mut row = walked.q(frame).to_vec();
        row[2] -= speed * walked.time()[frame];
        row
    });
    let below = vec![0.0; nq];
    for (q, skip) in [(below.into_iter().chain(in_place.clone()).collect(), 1), (in_place.collect(), 0)] {
        let done = moved(q, skip);
        assert!((done.belt / done.scale - speed).abs() < 0.05 && done.stances >= 2, "{skip}: {done:?}");
    }
}

/// A stride, held back by its mean speed.
fn goes_round_in_place(ann: &Figure, round: &Motion) {
    let (time, last) = (round.time(), round.len() - 1);
    let speed = (round.q(last)[2] - round.q(0)[2]) / (time[last] - time[0]);
    // Nothing is said of it, with its last frame and without it.
    let (nq, nv) = (ann.layout().nq(), ann.layout().nv());
    let in_place = |frames: usize| {
        let mut q: Vec<f64> = (0..frames).flat_map(|frame| round.q(frame).to_vec()).collect();
        for (frame, row) in q.chunks_mut(nq).enumerate() {
            row[2] -= speed * (time[frame] - time[0]);
        }
        let zeros = vec![0.0; nv * frames];
        let info = MotionInfo::on_earth(ann, 60.0);
        let motion = Motion::new(ann, info, time[..frames].to_vec(), [q, zeros.clone(), zeros]);
        take(ann, &motion.expect("a motion"))
    };
    let (closed, open) = (in_place(round.len()), in_place(last));
    for (what, made) in strangers() {
        let (_, whole, _) = onto(&made.bytes(), &closed);
        let (_, moved, _) = onto(&made.bytes(), &open);
        let done = moved.replanted;
        assert!((done.belt - speed * done.scale).abs() < 0.01, "{what}: {} m/s", done.belt);
        // Points that roll over the ground slide as in the clip.
        assert!(
            done.stances >= 2 && done.slide < 1.5 * done.slid + 1e-6 && done.slid < 0.002,
            "{what}: {done:?}"
        );
        // Back where it began, but for what a frame goes by; and feet stand on the way round as they do with the last frame.
        let way = (moved.root.1[last - 1] - moved.root.1[0]).norm();
        assert!(way < 0.02, "{what}: {way} m");
        let file = made.bytes();
        let character = Character::read(&file, "hero").expect("a character");
        for ((bone, turns), (_, with)) in moved.turns.iter().zip(&whole.turns) {
            let bone = &character.skeleton().bones[*bone].name;
            for (frame, (a, b)) in turns.iter().zip(with).enumerate() {
                let off = a.angle_to(b);
                assert!(off < 0.01, "{what}, {bone}, frame {frame}: {off} rad");
            }
        }
        // Left and right alike.
        let (_, image, _) = onto(&made.bytes(), &open.clone().mirrored());
        assert!(
            (image.replanted.belt - done.belt).abs() < 1e-9
                && (image.replanted.slide - done.slide).abs() < 1e-6,
            "{what}"
        );
    }
}

/// On whoever is alike on both sides, what left does in the mirror image is what right does without it.
#[test]
fn a_mirror_image_turns_the_other_way() {
    let ann = human(1.75, 73.0).expect("a person");
    let request = WalkRequest { turn: 0.12, step_frequency: Some(110.0), ..WalkRequest::default() };
    let motion = walk(&ann, &request).expect("a walk").motion(&ann, 60.0).expect("a motion");
    let take = take(&ann, &motion);
    let across = |v: Vector3<f64>| Vector3::new(-v.x, v.y, v.z);
    let mut turned = 0;
    for (what, made) in strangers() {
        let (_, plain, clip) = onto(&made.bytes(), &take);
        let (_, moved, image) = onto(&made.bytes(), &take.clone().mirrored());
        assert_eq!(moved.replanted.stances, plain.replanted.stances, "{what}");
        let places = |clip: &Clip, sample: usize, name: &str| {
            let link = clip.figure.link_index(&(made.names)(name)).expect("a bone");
            clip.figure.places(clip.motion.q(sample))[link]
        };
        for sample in (0..clip.motion.len()).step_by(11) {
            for (name, other) in [
                ("pelvis", "pelvis"),
                ("head", "head"),
                ("left_forearm", "right_forearm"),
                ("right_hand", "left_hand"),
                ("left_foot", "right_foot"),
                ("right_shank", "left_shank"),
            ] {
                let at = [places(&clip, sample, name), places(&image, sample, other)];
                let [one, two] = at.map(|place| place.translation.vector);
                assert!((across(one) - two).norm() < 1e-5, "{what}: {name} in {sample}: {one} {two}");
            }
        }
        let last = clip.motion.len() - 1;
        let way =
            places(&clip, last, "pelvis").translation.vector - places(&clip, 0, "pelvis").translation.vector;
        turned += usize::from(way.x.abs() > 0.3);
        assert_eq!(take.clone().mirrored().mirrored().len(), take.len());
    }
    assert_eq!(turned, strangers().len());
}

#[test]
fn several_clips_go_into_one_file() {
    let ann = human(1.75, 73.0).expect("a person");
    let take = take(&ann, &walked(&ann));
    let bytes = Made::default().bytes();
    let character = Character::read(&bytes, "hero").expect("a character");
    let roles = Roles::find(character.skeleton(), &BoneMap::default()).expect("roles");
    let moved = [take.clone(), take.mirrored()]
        .map(|take| retarget(&take, character.skeleton(), &roles).expect("moved"));
    let mut out = Vec::new();
    let names = character.with_clips(moved.iter().map(|moved| ("walk", moved)), &mut out).expect("written");
    let before = glb::animations(&bytes).expect("glTF");
    assert_eq!(names, ["walk", "walk 2"]);
    assert_eq!(glb::animations(&out).expect("glTF"), [&before[..], &names].concat());
    // Each is what it would be alone.
    for (name, moved) in names.iter().zip(&moved) {
        let mut alone = Vec::new();
        character.with_clip("alone", moved, &mut alone).expect("written");
        let [one, other] = [(&out, name.as_str()), (&alone, "alone")]
            .map(|(bytes, name)| read(bytes, &named(name)).expect("read").motion);
        assert_eq!(one.len(), other.len());
        for frame in 0..one.len() {
            assert_eq!(one.q(frame), other.q(frame), "{name}");
        }
    }
}

/// Rotations of a bone of `skeleton` in `moved`, as turns from its rest in its parent's.
fn from_rest(skeleton: &Skeleton, moved: &Moved, name: &str) -> Vec<UnitQuaternion<f64>> {
    let bone = skeleton.bones.iter().position(|bone| bone.name == name).expect("a bone");
    let rest = |bone: usize| skeleton.bones[bone].rest.rotation;
    let above = rest(skeleton.bones[bone].parent.expect("a parent"));
    let (_, turns) = moved.turns.iter().find(|(of, _)| *of == bone).expect("it turns");
    turns.iter().map(|turn| above * turn * rest(bone).inverse()).collect()
}

/// Somebody in a T pose, each of these links turned about an axis by these angles (rad) at 30 frames a second.
fn rolls(links: &[(&str, Vector3<f64>)], angles: &[f64]) -> Take {
    let ann = human(1.75, 73.0).expect("a person");
    let source = Rigged::new(&ann, Rig::Vrm).expect("a rig").figure;
    let layout = source.layout();
    let mut standing = vec![0.0; layout.nq()];
    source.neutral(&mut standing).expect("its length");
    standing[1] = 0.95;
    let mut q = Vec::new();
    for by in angles {
        let mut row = standing.clone();
        for (link, axis) in links {
            let at = layout.joints()[source.link_index(link).expect("a link")];
            let turn = UnitQuaternion::from_scaled_axis(axis * *by);
            row[at.q..at.q + 4].copy_from_slice(turn.coords.as_slice());
        }
        q.extend(row);
    }
    let time: Vec<f64> = (0..angles.len()).map(|k| k as f64 / 30.0).collect();
    let zeros = vec![0.0; layout.nv() * time.len()];
    let info = MotionInfo::on_earth(&source, 30.0);
    let motion = Motion::new(&source, info, time, [q, zeros.clone(), zeros]).expect("a motion");
    take(&source, &motion)
}

#[test]
fn twist_bones_share_out_how_a_limb_turns_about_its_axis() {
    let made = Made { arms: 0.8, legs: 0.15, rolled: true, twists: true, ..Made::default() };
    let file = made.bytes();
    let character = Character::read(&file, "hero").expect("a character");
    let skeleton = character.skeleton();
    let arm =
        |by: f64| UnitQuaternion::from_scaled_axis(Vector3::new(0.8_f64.sin(), -0.8_f64.cos(), 0.0) * by);
    let leg =
        |by: f64| UnitQuaternion::from_scaled_axis(Vector3::new(0.15_f64.sin(), -0.15_f64.cos(), 0.0) * by);
    let angles: Vec<f64> = (0..30).map(|k| 0.1 * f64::from(k)).collect();
    // What turns about itself (the arm's outwards, the leg's upwards), and by how much of it which bones do in their parents. Bones that
    // stand beside the limb's axis, and legs of another stance, do it not quite.
    let (out, up) = (Vector3::x(), Vector3::y());
    let fore = "left_forearm";
    let cases: [(_, _, &[(&str, f64)]); 5] = [
        ("leftUpperArm", out, &[("left_upper_arm_twist", -0.75), (fore, 0.75)]),
        ("leftLowerArm", out, &[("left_upper_arm_twist", 0.0), (fore, 1.0), ("left_forearm_twist", -0.5)]),
        ("leftHand", out, &[("left_upper_arm_twist", 0.0), ("left_forearm_twist", 0.5), ("left_hand", 0.5)]),
        ("leftUpperLeg", up, &[("left_thigh_twist", 0.5), ("left_shank_twist", 0.0)]),
        ("leftFoot", up, &[("left_thigh_twist", 0.0), ("left_shank_twist", -0.75)]),
    ];
    for (turned, axis, expected) in cases {
        let (_, moved, _) = onto(&file, &rolls(&[(turned, axis)], &angles));
        for (name, share) in expected {
            let turn = if axis == out { arm } else { leg };
            for (by, found) in angles.iter().zip(from_rest(skeleton, &moved, name)) {
                let off = angle(&found, &turn(share * by));
                assert!(off < 0.05, "{name} while {turned} turns by {by} rad: off by {off} rad");
            }
        }
        // Bones that are only called so stay as they are.
        let named = |bone: &usize| skeleton.bones[*bone].name.contains("shield");
        assert!(moved.turns.iter().all(|(bone, _)| !named(bone)));
    }

    // A round of something ends as it begins, however often a limb turned in it.
    let round: Vec<f64> = (0..=30).map(|k| std::f64::consts::TAU * f64::from(k) / 30.0).collect();
    let (_, moved, _) = onto(&file, &rolls(&[("leftHand", out), ("leftUpperArm", out)], &round));
    for name in ["left_forearm_twist", "left_upper_arm_twist", "left_hand", "left_forearm"] {
        let turns = from_rest(skeleton, &moved, name);
        let off = angle(&turns[0], &turns[30]);
        assert!(off < 1e-3, "{name}: {off} rad");
    }

    let ann = human(1.75, 73.0).expect("a person");
    // A walk goes its way as without them, and what they do goes on from frame to frame.
    let walks = take(&ann, &walked(&ann));
    let made = Made { rolled: false, ..made };
    let (_, _, with) = onto(&made.bytes(), &walks);
    let (_, _, without) = onto(&Made { twists: false, ..made }.bytes(), &walks);
    let mut before: Option<Vec<UnitQuaternion<f64>>> = None;
    for sample in 0..with.motion.len() {
        let places = [&with, &without].map(|clip| clip.figure.places(clip.motion.q(sample)));
        for (link, place) in without.figure.links().iter().zip(&places[1]) {
            let own = places[0][with.figure.link_index(link.name()).expect("a bone")];
            assert!((own.translation.vector - place.translation.vector).norm() < 1e-5, "{}", link.name());
            assert!(angle(&own.rotation, &place.rotation) < 1e-5, "{}", link.name());
        }
        let turns: Vec<UnitQuaternion<f64>> = places[0].iter().map(|place| place.rotation).collect();
        if let Some(before) = before.replace(turns.clone()) {
            for ((link, a), b) in with.figure.links().iter().zip(&turns).zip(&before) {
                let is_twist = link.name().ends_with("twist");
                assert!(!is_twist || angle(a, b) < 0.2, "{} leaps in frame {sample}", link.name());
            }
        }
    }
}

/// Found by the fuzzer.
#[test]
fn a_clip_that_turns_by_more_than_has_a_sine_is_refused() {
    let ann = human(1.75, 73.0).expect("a person");
    let layout = ann.layout();
    let mut q = vec![0.0; layout.nq()];
    q[layout.dof_index("neck.rx").and_then(|dof| layout.coordinate(dof)).expect("a neck")] = 1.7e295;
    let zeros = vec![0.0; layout.nv()];
    let info = MotionInfo::on_earth(&ann, 30.0);
    let motion = Motion::new(&ann, info, vec![0.0], [q, zeros.clone(), zeros]).expect("a motion");
    let skeleton = Skeleton::of(&ann);
    let roles = Roles::find(&skeleton, &BoneMap::default()).expect("roles");
    let refused = Take::of(&skeleton, &roles, &ann, &motion, None);
    assert!(matches!(&refused, Err(RetargetError::NotFinite { bone, .. }) if bone == "neck"), "{refused:?}");
}
