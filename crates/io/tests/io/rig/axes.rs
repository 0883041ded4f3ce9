//! Bones with the axes that a rig's own characters have.

use super::walked;
use nalgebra::{Isometry3, Point3};
use solaris_io::rig::{Rig, RigMap, Rigged};
use solaris_model::{Figure, Human, Vector3};
use solaris_skin::Detail;

const OWN: [Rig; 2] = [Rig::Mixamo, Rig::Unreal];

fn rest(figure: &Figure) -> Vec<Isometry3<f64>> {
    let mut q = vec![0.0; figure.layout().nq()];
    figure.neutral(&mut q).expect("the neutral posture");
    figure.places(&q)
}

#[test]
fn own_axes_turn_frames_and_move_nothing() {
    let (ann, motion) = walked();
    for rig in Rig::ALL {
        let plain = Rigged::new(&ann, rig).expect("on the rig");
        let own = Rigged::new(&ann, RigMap::from(rig).with_own_axes()).expect("on the rig");
        let (a, b) = [&plain, &own].map(|on| on.motion(&ann, &motion).expect("a motion")).into();
        let frames = rest(&own.figure);
        let turned = frames.iter().filter(|place| place.rotation.angle() > 0.1).count();
        assert!(if OWN.contains(&rig) { turned > 45 } else { turned == 0 }, "{rig:?}: {turned}");
        let skins = [&plain, &own].map(|on| on.skin(&ann, Detail::Rough));
        for sample in (0..motion.len()).step_by(13) {
            let places = plain.figure.places(a.q(sample));
            let ours = own.figure.places(b.q(sample));
            for (((link, place), found), frame) in
                own.figure.links().iter().zip(&places).zip(&ours).zip(&frames)
            {
                let off = (place.translation.vector - found.translation.vector).norm();
                let turn = (place.rotation * frame.rotation).angle_to(&found.rotation);
                assert!(off < 1e-12 && turn < 1e-7, "{rig:?}, {}: {off} m, {turn} rad", link.name());
            }
            for (a, b) in skins[0].posed(&places).iter().zip(&skins[1].posed(&ours)) {
                assert!((a - b).norm() < 1e-6, "{rig:?}");
            }
        }
        let places = [(&plain, &a), (&own, &b)].map(|(on, motion)| on.figure.places(motion.q(3)));
        for (a, b) in a.planted.iter().zip(&b.planted) {
            let off = places[1][b.link] * Point3::from(b.point) - places[0][a.link] * Point3::from(a.point);
            assert!(off.norm() < 1e-12);
        }
        let inertia = |figure: &Figure| figure.links().iter().map(|l| l.inertia().trace()).sum::<f64>();
        assert!((inertia(&plain.figure) - inertia(&own.figure)).abs() < 1e-12);
    }
}

/// Which way axes look at rest: left or right, up or down, front or back; with an arm, down along it.
#[test]
fn they_are_those_of_the_rigs_own_characters() {
    let [left, up, front] = [Vector3::x(), Vector3::y(), Vector3::z()];
    let low = (left - up).normalize();
    let out = (left + up).normalize();
    let expected = [
        (Rig::Mixamo, "mixamorig:Hips", left, up),
        (Rig::Mixamo, "mixamorig:Spine2", left, up),
        (Rig::Mixamo, "mixamorig:Head", left, up),
        (Rig::Mixamo, "mixamorig:LeftForeArm", -front, left),
        (Rig::Mixamo, "mixamorig:RightForeArm", front, -left),
        (Rig::Mixamo, "mixamorig:LeftHandIndex1", -front, left),
        (Rig::Mixamo, "mixamorig:RightHandPinky1", front, -left),
        (Rig::Mixamo, "mixamorig:LeftUpLeg", -left, -up),
        (Rig::Mixamo, "mixamorig:RightLeg", -left, -up),
        (Rig::Mixamo, "mixamorig:LeftToeBase", -left, front),
        (Rig::Mixamo, "mixamorig:RightToe_End", -left, front),
        (Rig::Unreal, "root", left, up),
        (Rig::Unreal, "pelvis", up, -left),
        (Rig::Unreal, "spine_05", up, -left),
        (Rig::Unreal, "head", up, -left),
        (Rig::Unreal, "clavicle_l", left, up),
        (Rig::Unreal, "clavicle_r", left, -up),
        (Rig::Unreal, "lowerarm_l", low, out),
        (Rig::Unreal, "upperarm_twist_02_l", low, out),
        (Rig::Unreal, "lowerarm_r", out, low),
        (Rig::Unreal, "hand_l", low, -front),
        (Rig::Unreal, "hand_r", out, front),
        (Rig::Unreal, "middle_01_l", low, -front),
        (Rig::Unreal, "thigh_l", up, -left),
        (Rig::Unreal, "thigh_r", -up, -left),
        (Rig::Unreal, "calf_twist_01_r", -up, -left),
        (Rig::Unreal, "foot_l", up, -left),
        (Rig::Unreal, "ball_l", front, -left),
        (Rig::Unreal, "ball_r", -front, -left),
    ];
    for human in [Human::new(1.75, 73.0), Human::new(1.1, 19.0)] {
        let ann = human.build().expect("a person");
        for rig in OWN {
            let on = Rigged::new(&ann, RigMap::from(rig).with_own_axes()).expect("on the rig");
            let places = rest(&on.figure);
            let of_rig = expected.iter().filter(|row| row.0 == rig);
            for (_, bone, x, y) in of_rig {
                let turn = places[on.figure.link_index(bone).expect("a bone")].rotation;
                let found = [turn * left, turn * up];
                // Clavicles rise, fingers are bent a little.
                let off = found[0].angle(x).max(found[1].angle(y));
                assert!(off < 0.45, "{rig:?}, {bone}: {found:?}");
            }
        }
    }
}

#[test]
fn an_axis_goes_to_the_next_joint_where_it_says_so() {
    let ann = Human::new(1.75, 73.0).build().expect("a person");
    for (rig, chain, way) in [
        (
            Rig::Mixamo,
            "mixamorig:LeftUpLeg mixamorig:LeftLeg mixamorig:LeftFoot mixamorig:LeftToeBase",
            Vector3::y(),
        ),
        (
            Rig::Mixamo,
            "mixamorig:RightShoulder mixamorig:RightArm mixamorig:RightForeArm mixamorig:RightHand",
            Vector3::y(),
        ),
        (
            Rig::Mixamo,
            "mixamorig:LeftHandThumb1 mixamorig:LeftHandThumb2 mixamorig:LeftHandThumb3",
            Vector3::y(),
        ),
        (Rig::Unreal, "clavicle_l upperarm_l lowerarm_l hand_l", Vector3::x()),
        (Rig::Unreal, "clavicle_r upperarm_r lowerarm_r hand_r", -Vector3::x()),
        (Rig::Unreal, "thigh_l calf_l foot_l", -Vector3::x()),
        (Rig::Unreal, "thigh_r calf_r foot_r", Vector3::x()),
        (Rig::Unreal, "pinky_01_r pinky_02_r pinky_03_r", -Vector3::x()),
    ] {
        let on = Rigged::new(&ann, RigMap::from(rig).with_own_axes()).expect("on the rig");
        for bone in chain.split(' ').skip(1) {
            let at = on.figure.link(bone).expect("a bone").joint().placement().translation.vector;
            assert!(at.angle(&way) < 1e-6, "{rig:?}, {bone}: {at}");
        }
    }
}
