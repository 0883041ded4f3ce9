//! USD text: its bones are where the figure's links are, and no name breaks it.

use solaris_io::usd::write;
use solaris_model::{
    Event, EventKind, Figure, FigureBuilder, Isometry3, Joint, LinkSpec, Motion, MotionInfo, UnitQuaternion,
    Vector3, human,
};
use solaris_skin::{Detail, Skin, skin};

fn written(figure: &Figure, skin: &Skin, clip: &str, motion: &Motion) -> String {
    let mut bytes = Vec::new();
    write(figure, skin, clip, motion, &mut bytes).expect("written");
    String::from_utf8(bytes).expect("text")
}

/// What stands between `[` and `]` of the line that begins with `name`.
fn row<'a>(text: &'a str, name: &str) -> &'a str {
    let line = text.lines().map(str::trim).find(|line| line.starts_with(name)).expect(name);
    let inside = line.split_once("= [").or_else(|| line.split_once(": [")).expect("a row").1;
    inside.split_once(']').expect("its end").0
}

fn numbers(row: &str) -> Vec<f64> {
    row.split([',', '(', ')', ' ']).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn bones_are_where_links_are() {
    let ann = human(1.65, 58.0).expect("a person");
    let (nq, nv) = (ann.layout().nq(), ann.layout().nv());
    let bent: Vec<f64> = (0..nq).map(|i| 0.05 * (i as f64).sin()).collect();
    let q = [vec![0.0; nq], bent.clone()].concat();
    let still = vec![0.0; 2 * nv];
    let info = MotionInfo::on_earth(&ann, 10.0);
    let mut motion = Motion::new(&ann, info, vec![0.0, 0.1], [q, still.clone(), still]).expect("a motion");
    motion.events.push(Event { time: 0.05, kind: EventKind::TouchDown { link: "left_foot".into() } });
    let text = written(&ann, &skin(&ann, Detail::Rough), "bends", &motion);

    let joints: Vec<&str> = row(&text, "uniform token[] joints").split(", ").collect();
    assert_eq!(joints.len(), ann.links().len());
    assert_eq!(joints[ann.link_index("left_shank").expect("it")], "\"pelvis/left_thigh/left_shank\"");
    // Two samples, and the instant of a touch-down half way.
    let samples = text
        .split("rotations.timeSamples = {")
        .nth(1)
        .expect("rotations")
        .split('}')
        .next()
        .expect("its end");
    assert_eq!(samples.trim().lines().count(), 3);
    assert!(samples.contains(" 0.5: ["));

    let turns = numbers(row(samples, "1: ["));
    let slides = text.split("translations.timeSamples = {").nth(1).expect("translations");
    let slides = numbers(row(slides, "1: ["));
    let mut places = Vec::new();
    for (i, link) in ann.links().iter().enumerate() {
        let [w, x, y, z] = [0, 1, 2, 3].map(|k| turns[4 * i + k]);
        let turn = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
        let slide = Vector3::new(slides[3 * i], slides[3 * i + 1], slides[3 * i + 2]);
        let local = Isometry3::from_parts(slide.into(), turn);
        places.push(link.parent().map_or(local, |parent| places[parent] * local));
    }
    for (found, expected) in places.iter().zip(ann.places(&bent)) {
        assert!((found.translation.vector - expected.translation.vector).norm() < 1e-6);
        assert!(found.rotation.angle_to(&expected.rotation) < 1e-6);
    }
    // A matrix acts on rows: the translation stands last.
    let bind = numbers(row(&text, "uniform matrix4d[] bindTransforms"));
    assert_eq!(bind.len(), 16 * joints.len());
    let head = &bind[16 * ann.link_index("head").expect("it")..][..16];
    assert!(head[3].abs() < 1e-12 && (head[15] - 1.0).abs() < 1e-12 && head[13] > 0.5, "{head:?}");
}

#[test]
fn names_cannot_break_it() {
    let joint = |name: &str| Joint::new(name);
    let figure = FigureBuilder::new("1\"\n) def Evil")
        .link(LinkSpec::root("a b", Joint::free("root")).mass(1.0))
        .link(LinkSpec::child("a_b", "a b", joint("x")).mass(1.0))
        .link(LinkSpec::child("\u{202e}/../</skin>", "a b", joint("y")).mass(1.0))
        .build()
        .expect("a figure");
    let (q, v) = (vec![0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0], vec![0.0; 6]);
    let info = MotionInfo::on_earth(&figure, 30.0);
    let motion = Motion::new(&figure, info, vec![0.0], [q, v.clone(), v]).expect("a motion");
    let text = written(&figure, &Skin::default(), "skin", &motion);
    assert!(text.contains("def SkelRoot \"_1____def_Evil\""), "{text}");
    assert!(text.contains("[\"a_b\", \"a_b/a_b_2\", \"a_b/_______skin_\"]"), "{text}");
    // Bones alone, and a clip of a name that was free.
    assert!(!text.contains("def Mesh") && text.contains("def SkelAnimation \"skin_2\""), "{text}");
}

#[test]
fn what_is_no_number_is_refused() {
    let ann = human(1.65, 58.0).expect("a person");
    let bo = human(1.75, 73.0).expect("a person");
    let (q, v) = (vec![0.0; ann.layout().nq()], vec![0.0; ann.layout().nv()]);
    let motion =
        Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), vec![0.0], [q.clone(), v.clone(), v.clone()])
            .expect("a motion");
    let mut out = Vec::new();
    assert!(write(&bo, &Skin::default(), "x", &motion, &mut out).is_err());
    let far = [vec![1e300; 3], q[3..].to_vec()].concat();
    let motion = Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), vec![0.0], [far, v.clone(), v])
        .expect("a motion");
    let error = write(&ann, &Skin::default(), "x", &motion, &mut out).expect_err("too far").to_string();
    assert!(error.contains("pelvis.place"), "{error}");
}
