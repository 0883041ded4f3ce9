//! Skins that move with their links.

use nalgebra::{Isometry3, Vector3};
use solaris_model::{Figure, human};
use solaris_skin::{Detail, Skin, skin};

fn volume(points: &[Vector3<f64>], skin: &Skin) -> f64 {
    let of = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| points[i as usize]);
        a.dot(&b.cross(&c)) / 6.0
    };
    skin.triangles.iter().map(of).sum()
}

/// The figure with these anatomical angles (degrees).
fn places(figure: &Figure, angles: &[(&str, f64)]) -> Vec<Isometry3<f64>> {
    let mut q = vec![0.0; figure.layout().nq()];
    for (name, degrees) in angles {
        let angle = figure.anatomical_angle(name).expect("an angle");
        q[angle.coordinate] = angle.sign * degrees.to_radians();
    }
    figure.places(&q)
}

#[test]
fn shares_are_of_at_most_four_links_and_one_together() {
    let man = human(1.75, 73.0).expect("a person");
    let skin = skin(&man, Detail::Fine);
    for influences in &skin.influences {
        let total: f32 = influences.iter().map(|i| i.share).sum();
        assert!((total - 1.0).abs() < 1e-5);
        assert!(influences.windows(2).all(|pair| pair[0].share >= pair[1].share));
        assert!(influences.iter().all(|i| (i.link as usize) < man.links().len() && i.share >= 0.0));
    }
}

#[test]
fn no_vertex_goes_with_both_legs_below_the_crotch_nor_with_both_arms() {
    let man = human(1.75, 73.0).expect("a person");
    let skin = skin(&man, Detail::Fine);
    let name = |i: &solaris_skin::Influence| man.links()[i.link as usize].name();
    let of = |influences: &[solaris_skin::Influence; 4], words: &[&str], side: &str| -> f32 {
        let own = influences
            .iter()
            .filter(|i| name(i).starts_with(side) && words.iter().any(|w| name(i).ends_with(w)));
        own.map(|i| i.share).sum()
    };
    for (p, influences) in skin.points.iter().zip(&skin.influences) {
        for words in [&["thigh", "shank", "foot", "toes"][..], &["upper_arm", "forearm", "hand"][..]] {
            let (left, right) = (of(influences, words, "left_"), of(influences, words, "right_"));
            assert!(left.min(right) == 0.0 || p.y > -0.26 && p.x.abs() < 0.06, "{p:?}: {left} and {right}");
        }
        // And none of the trunk with a hand.
        assert!(p.x.abs() > 0.2 || of(influences, &["hand", "forearm"], "") < 0.02, "{p:?}");
    }
}

#[test]
fn the_middle_of_a_limb_goes_with_its_own_link_alone() {
    let man = human(1.75, 73.0).expect("a person");
    let skin = skin(&man, Detail::Fine);
    for name in ["left_forearm", "right_upper_arm", "left_hand", "left_thigh", "right_shank"] {
        let link = man.link_index(name).expect("a link");
        let shape = man.links()[link].shape().expect("a shape");
        let middle = skin.bind[link] * nalgebra::Point3::from(shape.placement.translation.vector);
        let near =
            skin.points.iter().zip(&skin.influences).filter(|(p, _)| (*p - middle.coords).norm() < 0.10);
        let own = near.filter(|(p, _)| {
            let local = skin.bind[link].inverse_transform_point(&nalgebra::Point3::from(**p));
            (local.y - shape.placement.translation.y).abs() < 0.02
        });
        let own: Vec<_> = own.collect();
        assert!(own.len() > 15, "{name}: {} vertices", own.len());
        assert!(own.iter().all(|(_, i)| i[0].link as usize == link && i[0].share > 0.95), "{name}");
    }
}

#[test]
fn where_it_was_made_it_is() {
    let man = human(1.75, 73.0).expect("a person");
    let skin = skin(&man, Detail::Coarse);
    let posed = skin.posed(&skin.bind);
    assert!(posed.iter().zip(&skin.points).all(|(a, b)| (a - b).norm() < 1e-6));
}

#[test]
fn a_body_that_walks_keeps_its_volume() {
    let man = human(1.75, 73.0).expect("a person");
    let skin = skin(&man, Detail::Fine);
    let own = skin.volume();
    // Angles as walking people have them, all phases of them and more, by steps that share no period.
    let mut worst: f64 = 0.0;
    for i in 0..200 {
        let wave = |k: f64, from: f64, to: f64| from + (to - from) * (0.5 + 0.5 * (f64::from(i) * k).sin());
        let angles = [
            ("left_hip.flexion", wave(0.7, -15.0, 35.0)),
            ("right_hip.flexion", wave(1.1, -15.0, 35.0)),
            ("left_knee.flexion", wave(1.3, 0.0, 65.0)),
            ("right_knee.flexion", wave(1.7, 0.0, 65.0)),
            ("left_ankle.dorsiflexion", wave(1.9, -20.0, 12.0)),
            ("right_ankle.dorsiflexion", wave(2.3, -20.0, 12.0)),
            ("left_shoulder.flexion", wave(0.3, -25.0, 25.0)),
            ("right_shoulder.flexion", wave(0.5, -25.0, 25.0)),
            ("left_elbow.flexion", wave(0.9, 5.0, 50.0)),
            ("right_elbow.flexion", wave(2.9, 5.0, 50.0)),
            ("pelvis.rotation", wave(3.1, -6.0, 6.0)),
            ("thorax.rotation", wave(3.7, -6.0, 6.0)),
        ];
        worst = worst.max((volume(&skin.posed(&places(&man, &angles)), &skin) / own - 1.0).abs());
    }
    assert!(worst < 0.04, "{:.2} %", worst * 100.0);
}

#[test]
fn knees_and_elbows_bend_without_turning_triangles_over() {
    let man = human(1.75, 73.0).expect("a person");
    let skin = skin(&man, Detail::Fine);
    let still = places(&man, &[]);
    let normals = |points: &[Vector3<f64>]| -> Vec<Vector3<f64>> {
        let of = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|i| points[i as usize]);
            (b - a).cross(&(c - a))
        };
        skin.triangles.iter().map(of).collect()
    };
    let before = normals(&skin.posed(&still));
    for (name, link, degrees) in
        [("left_knee.flexion", "left_shank", 65.0), ("right_elbow.flexion", "right_forearm", 70.0)]
    {
        let bent = places(&man, &[(name, degrees)]);
        let after = normals(&skin.posed(&bent));
        let link = man.link_index(link).expect("a link");
        let parent = man.links()[link].parent().expect("a parent");
        let mut turned = 0;
        for (t, (a, b)) in skin.triangles.iter().zip(before.iter().zip(&after)) {
            // Each triangle beside what a rigid one of its mean share would do.
            let share: f64 = t
                .iter()
                .flat_map(|i| &skin.influences[*i as usize])
                .filter(|i| i.link as usize == link)
                .map(|i| f64::from(i.share) / 3.0)
                .sum();
            let turn = bent[link].rotation * still[link].rotation.inverse();
            let rigid = nalgebra::UnitQuaternion::identity().slerp(&turn, share)
                * (bent[parent].rotation * still[parent].rotation.inverse() * a);
            turned += usize::from(share > 0.01 && rigid.dot(b) < 0.0);
        }
        assert_eq!(turned, 0, "{name}");
    }
}
