//! Binary glTF, read by the crate gltf, which is not ours, and skinned here anew: nodes times inverse bind matrices.

mod read;

use read::Read;
use solaris_gait::{WalkRequest, walk};
use solaris_io::glb::{self, Actor, Clip, Detail, Options};
use solaris_io::{ClipProblem, IoError};
use solaris_model::{
    Event, EventKind, Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Shape, ShapeKind, SolePart,
    Vector3, human,
};

fn walked(figure: &Figure, rate: f64) -> Motion {
    let request = WalkRequest { step_frequency: Some(110.0), ..WalkRequest::default() };
    walk(figure, &request).expect("a walk").motion(figure, rate).expect("a motion")
}

fn written(figure: &Figure, motion: &Motion, options: Options) -> Vec<u8> {
    let mut bytes = Vec::new();
    let clip = Clip { name: "walk", motions: vec![(0, motion)] };
    glb::write(&[Actor { name: "Ann", figure, skin: None }], &[clip], options, &mut bytes).expect("written");
    bytes
}

const COARSE: Options = Options { skin: Some(Detail::Rough), forces: false, vrm: false };

#[test]
fn soles_are_where_the_motion_has_them() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann, 30.0);
    let file = Read::of(&written(&ann, &motion, COARSE));
    let foot = ann.link_index("left_foot").expect("a foot");
    let sole = ann.links()[foot].sole_point(SolePart::Heel).expect("a heel").y;
    // Vertices of the sole that go with the foot alone, in the foot's own frame.
    let binds = file.binds();
    let own: Vec<(usize, Vector3<f64>)> = (0..file.points.len())
        .filter(|i| file.joints[*i][0] == foot && file.weights[*i][0] > 0.99999)
        .map(|i| (i, (binds[foot] * file.points[i].push(1.0)).xyz()))
        .filter(|(_, local)| (local.y - sole).abs() < 0.002)
        .collect();
    assert!(own.len() >= 8, "{} vertices", own.len());
    let mut worst: f64 = 0.0;
    for sample in 0..motion.len() {
        let place = ann.places(motion.q(sample))[foot];
        let world = file.world("walk", motion.time()[sample] - motion.time()[0]);
        for (vertex, local) in &own {
            let expected = place * nalgebra::Point3::from(*local);
            worst = worst.max((file.skinned(*vertex, &world, &binds) - expected.coords).norm());
        }
    }
    assert!(worst < 1e-5, "{worst} m");
}

#[test]
fn every_vertex_is_where_the_skin_s_own_rule_has_it() {
    let ann = human(1.60, 80.0).expect("a person");
    let motion = walked(&ann, 24.0);
    let file = Read::of(&written(&ann, &motion, COARSE));
    let skin = solaris_skin::skin(&ann, Detail::Rough);
    let binds = file.binds();
    for sample in [0, 7, motion.len() / 2, motion.len() - 1] {
        let world = file.world("walk", motion.time()[sample]);
        let expected = skin.posed(&ann.places(motion.q(sample)));
        let off = (0..skin.points.len()).map(|i| (file.skinned(i, &world, &binds) - expected[i]).norm());
        let worst = off.fold(0.0, f64::max);
        assert!(worst < 2e-5, "{worst} m");
    }
}

#[test]
fn planted_feet_stand_still_at_samples_and_nearly_between() {
    let ann = human(1.75, 73.0).expect("a person");
    for (rate, between) in [(30.0, 4e-3), (60.0, 1.2e-3)] {
        let motion = walked(&ann, rate);
        let file = Read::of(&written(&ann, &motion, Options { skin: None, forces: false, vrm: false }));
        let keys = file.times("walk");
        let (mut at_samples, mut elsewhere): (f64, f64) = (0.0, 0.0);
        for planted in &motion.planted {
            let place = |time: f64| (file.world("walk", time)[planted.link] * planted.point.push(1.0)).xyz();
            let inside = |t: &f64| planted.start <= *t && *t <= planted.end;
            let (samples, events): (Vec<f64>, Vec<f64>) = keys
                .iter()
                .copied()
                .filter(inside)
                .partition(|t| (t * rate - (t * rate).round()).abs() < 1e-4);
            let Some(first) = samples.first() else { continue };
            let still = place(*first);
            let off = |time: f64| (place(time) - still).norm();
            at_samples = samples.iter().map(|t| off(*t)).fold(at_samples, f64::max);
            elsewhere = events.iter().map(|t| off(*t)).fold(elsewhere, f64::max);
            for pair in samples.windows(2) {
                elsewhere = elsewhere.max(off(f64::midpoint(pair[0], pair[1])));
            }
        }
        assert!(at_samples < 3e-5, "{rate}: {at_samples} m");
        assert!(elsewhere < between && elsewhere > 0.0, "{rate}: {elsewhere} m");
    }
}

#[test]
fn keys_are_the_samples_and_the_contacts_between_them() {
    let ann = human(1.75, 73.0).expect("a person");
    for rate in [24.0, 25.0, 30.0, 60.0] {
        let motion = walked(&ann, rate);
        let file = Read::of(&written(&ann, &motion, Options { skin: None, forces: false, vrm: false }));
        let keys = file.times("walk");
        assert!(keys[0].abs() < 1e-12 && keys.windows(2).all(|pair| pair[0] < pair[1]));
        for sample in 0..motion.len() {
            // The float that is nearest to it.
            let time = f64::from((sample as f64 / rate) as f32);
            assert!(keys.contains(&time), "{rate}: no key at {time} s");
        }
        let contact =
            |kind: &EventKind| matches!(kind, EventKind::TouchDown { .. } | EventKind::LiftOff { .. });
        let mut between = 0;
        for event in motion.events.iter().filter(|event| contact(&event.kind)) {
            let nearest = keys.iter().map(|t| (t - event.time).abs()).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.021 / rate, "{rate}: {nearest} s from an event at {} s", event.time);
            between += usize::from(nearest < 1e-6);
        }
        assert!(between > 0 && keys.len() > motion.len(), "{rate}");
    }
}

/// Many touches within a moment, as a heap has them, and a run so long that a file's numbers tell no two samples apart.
#[test]
fn keys_grow_where_the_file_s_numbers_cannot_tell_times_apart() {
    let ann = human(1.75, 73.0).expect("a person");
    let mut motion = walked(&ann, 30.0);
    let many = motion.events.iter().flat_map(|event| {
        [0.0, 1e-9, 1e-8, 1e-4].map(|later| Event { time: event.time + later, ..event.clone() })
    });
    motion.events = many.collect();
    let far = |time: &f64| time + if *time > 1.0 { 1e7 } else { 0.0 };
    let times: Vec<f64> = motion.time().iter().map(far).collect();
    let columns = [0, 1, 2].map(|which| {
        let row = |sample| [motion.q(sample), motion.v(sample), motion.a(sample)][which].to_vec();
        (0..motion.len()).flat_map(row).collect()
    });
    let long = Motion::new(&ann, motion.info.clone(), times, columns).expect("a motion");
    // At 1e7 s numbers of a file are a second apart.
    for (motion, least, most) in
        [(&motion, motion.len() + 1, motion.len() + motion.events.len() / 4), (&long, 31, long.len() / 2)]
    {
        for forces in [false, true] {
            let file = Read::of(&written(&ann, motion, Options { skin: None, forces, vrm: false }));
            let keys = file.times("walk");
            assert!(file.times_grow("walk"));
            assert!((least..=most).contains(&keys.len()), "{} keys", keys.len());
        }
    }
}

#[test]
fn rotations_are_of_unit_length_and_never_change_sign() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann, 30.0);
    let file = Read::of(&written(&ann, &motion, Options { skin: None, forces: false, vrm: false }));
    let mut channels = 0;
    for rows in file.rotations("walk") {
        channels += 1;
        assert!(rows.iter().all(|q| (q.norm() - 1.0).abs() < 1e-6));
        assert!(rows.windows(2).all(|pair| pair[0].dot(&pair[1]) > 0.0));
    }
    assert_eq!(channels, 21);
}

#[test]
fn a_whole_turn_and_more_is_turned_on() {
    let wheel = FigureBuilder::new("wheel").link(LinkSpec::root("rim", Joint::new("axle").rx()).mass(1.0));
    let wheel = wheel.build().expect("a figure");
    let angles: Vec<f64> = (0..40).map(|i| 0.5 * f64::from(i)).collect();
    let time = (0..40).map(|i| f64::from(i) / 30.0).collect();
    let motion = Motion::new(
        &wheel,
        MotionInfo::on_earth(&wheel, 30.0),
        time,
        [angles.clone(), vec![0.5 * 30.0; 40], vec![0.0; 40]],
    );
    let file = Read::of(&written(&wheel, &motion.expect("a motion"), COARSE));
    // Between two keys, too.
    for i in 0..39 {
        let world = file.world("walk", (f64::from(i) + 0.5) / 30.0);
        let expected = (0.5 * (f64::from(i) + 0.5)).cos();
        assert!((world[0][(1, 1)] - expected).abs() < 1e-5, "{i}");
    }
}

#[test]
fn hostile_names_come_back_as_they_are() {
    let names = ["a\"b\\c", "</script><!--", "Ünïcödé 歩く", "{\"x\":1}", "tab\tnew\nline\u{1}"];
    let mut builder = FigureBuilder::new(names[1]);
    for (i, name) in names.iter().enumerate() {
        let joint = Joint::new(format!("j{i}")).rx();
        builder = builder.link(match i {
            0 => LinkSpec::root(*name, joint),
            _ => LinkSpec::child(*name, names[i - 1], joint),
        });
    }
    let figure = builder.build().expect("a figure");
    let (q, v) = (vec![0.1; 5], vec![0.0; 5]);
    let motion = Motion::new(&figure, MotionInfo::on_earth(&figure, 30.0), vec![0.0], [q, v.clone(), v])
        .expect("a motion");
    let mut bytes = Vec::new();
    let clip = Clip { name: names[0], motions: vec![(0, &motion)] };
    glb::write(&[Actor { name: names[4], figure: &figure, skin: None }], &[clip], COARSE, &mut bytes)
        .expect("written");
    let file = Read::of(&bytes);
    let found: Vec<String> = file.gltf.nodes().filter_map(|node| node.name().map(str::to_owned)).collect();
    assert_eq!(&found[..5], names);
    assert_eq!(found[5], names[4]);
    assert_eq!(
        file.gltf.animations().next().and_then(|a| a.name().map(str::to_owned)),
        Some(names[0].to_owned())
    );
}

#[test]
fn several_figures_and_clips_stand_in_one_file() {
    let (ann, bo) = (human(1.65, 58.0).expect("a person"), human(1.90, 95.0).expect("a person"));
    let motions = [walked(&ann, 30.0), walked(&bo, 30.0), walked(&ann, 25.0)];
    let actors =
        [Actor { name: "Ann", figure: &ann, skin: None }, Actor { name: "Bo", figure: &bo, skin: None }];
    let clips = [
        Clip { name: "both", motions: vec![(0, &motions[0]), (1, &motions[1])] },
        Clip { name: "alone", motions: vec![(0, &motions[2])] },
    ];
    let mut bytes = Vec::new();
    glb::write(&actors, &clips, COARSE, &mut bytes).expect("written");
    let file = Read::of(&bytes);
    let gltf = &file.gltf;
    assert_eq!((gltf.skins().count(), gltf.meshes().count(), gltf.materials().count()), (2, 2, 1));
    let channels: Vec<usize> = gltf.animations().map(|animation| animation.channels().count()).collect();
    assert_eq!(channels, [44, 22]);
    // Each moves nodes of its own.
    let left = |name: &str| gltf.nodes().filter(|node| node.name() == Some(name)).count();
    assert_eq!((left("left_shank"), left("Ann"), left("Bo")), (2, 1, 1));
}

#[test]
fn a_world_with_z_up_is_turned_until_y_is() {
    let shape = Shape {
        kind: ShapeKind::Box { size: Vector3::new(0.4, 0.2, 0.1) },
        placement: nalgebra::Isometry3::identity(),
    };
    let robot = FigureBuilder::new("robot")
        .link(LinkSpec::root("base", Joint::free("flies")).mass(1.0).shape(shape))
        .build()
        .expect("a figure");
    let info = MotionInfo { gravity: Vector3::new(0.0, 0.0, -9.81), ..MotionInfo::on_earth(&robot, 30.0) };
    let q = vec![1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0];
    let motion = Motion::new(&robot, info, vec![0.0], [q, vec![0.0; 6], vec![0.0; 6]]).expect("a motion");
    let file = Read::of(&written(&robot, &motion, COARSE));
    let world = file.world("walk", 0.0);
    // Forward was x and is z, left was y and is x.
    assert!((world[0].column(3).xyz() - Vector3::new(2.0, 3.0, 1.0)).norm() < 1e-6, "{}", world[0]);
    let binds = file.binds();
    let most =
        (0..file.points.len()).map(|i| file.skinned(i, &world, &binds).z).fold(f64::NEG_INFINITY, f64::max);
    assert!((most - 1.2).abs() < 1e-6, "the long side points forward: {most}");
}

#[test]
fn forces_are_arrows_as_long_as_their_share_of_the_weight() {
    let ann = human(1.75, 73.0).expect("a person");
    let request = WalkRequest { step_frequency: Some(110.0), ..WalkRequest::default() };
    let plan = walk(&ann, &request).expect("a walk");
    let mut motion = plan.motion(&ann, 30.0).expect("a motion");
    solaris_analysis::ground_reactions(&ann, &mut motion, solaris_gait::FEET, &plan).expect("forces");
    let file = Read::of(&written(&ann, &motion, Options { skin: None, forces: true, vrm: false }));
    let sample = motion.len() / 2;
    let world = file.every("walk", motion.time()[sample]);
    let at = |name: &str| {
        let node = file.gltf.nodes().find(|node| node.name() == Some(name)).expect("a node");
        world[node.index()]
    };
    let mut total = Vector3::zeros();
    for track in &motion.contacts {
        let arrow = at(&format!("Ann force on {}", track.link));
        let contact = track.samples[sample];
        let tip = (arrow * Vector3::y().push(0.0)).xyz() * (ann.mass() * 9.80665);
        assert!((tip - contact.force).norm() < 0.2, "{tip} and {}", contact.force);
        assert!((arrow.column(3).xyz() - contact.cop).norm() < 1e-5);
        total += tip;
    }
    assert!(total.y > 300.0, "{total}");
    let centre = at("Ann centre of mass").column(3).xyz();
    assert!((0.8..1.2).contains(&centre.y), "{centre}");
}

#[test]
fn a_clip_that_cannot_be_is_refused_by_its_name() {
    let ann = human(1.75, 73.0).expect("a person");
    let motion = walked(&ann, 24.0);
    let actors = [Actor { name: "Ann", figure: &ann, skin: None }];
    let refused = |motions: Vec<(usize, &Motion)>| {
        let clip = Clip { name: "odd", motions };
        glb::write(&actors, &[clip], COARSE, &mut Vec::new()).expect_err("refused")
    };
    let problem = |error: IoError| match error {
        IoError::Clip { clip, problem } => (clip, problem),
        other => panic!("{other}"),
    };
    assert_eq!(
        problem(refused(vec![(1, &motion)])),
        ("odd".to_owned(), ClipProblem::NoActor { actor: 1, count: 1 })
    );
    assert_eq!(problem(refused(vec![(0, &motion), (0, &motion)])).1, ClipProblem::Twice { actor: 0 });
    let other = human(1.76, 73.0).expect("a person");
    let theirs = walked(&other, 24.0);
    assert!(matches!(refused(vec![(0, &theirs)]), IoError::Motion(_)));
    let none = Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), vec![], [vec![], vec![], vec![]])
        .expect("a motion");
    assert_eq!(problem(refused(vec![(0, &none)])).1, ClipProblem::Empty);
}

#[test]
fn a_file_without_clips_holds_bodies_that_stand() {
    let ann = human(1.75, 73.0).expect("a person");
    let mut bytes = Vec::new();
    glb::write(&[Actor { name: "Ann", figure: &ann, skin: None }], &[], COARSE, &mut bytes).expect("written");
    let file = Read::of(&bytes);
    assert_eq!((file.gltf.animations().count(), file.gltf.skins().count()), (0, 1));
    let mut nothing = Vec::new();
    glb::write(&[], &[], COARSE, &mut nothing).expect("written");
    assert_eq!(Read::of(&nothing).gltf.nodes().count(), 0);
}
