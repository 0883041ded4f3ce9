//! BVH files of other programs: what they hold, what is guessed, what is refused.

use crate::bvh_reader::parse;
use crate::motions::full_human;
use approx::assert_relative_eq;
use solaris_io::bvh::{self, Clip, ReadOptions, Unit, Up, read};
use solaris_model::{Figure, Vector3};

fn clip(text: &str) -> Clip {
    read(text, &ReadOptions::default()).expect("a clip")
}

fn written(clip: &Clip) -> String {
    let mut bytes = Vec::new();
    bvh::write(&clip.figure, &clip.motion, Unit::default(), &mut bytes).expect("a figure that fits");
    String::from_utf8(bytes).expect("text")
}

fn said(clip: &Clip) -> String {
    let lines: Vec<String> =
        clip.findings.iter().map(|finding| format!("{:?} {finding}", finding.kind)).collect();
    lines.join("\n")
}

/// The greatest distance of a joint in the one text from where it is in the other, over the size of the first's skeleton.
fn apart(one: &str, [metres, others]: [f64; 2], other: &str) -> f64 {
    let (one, other) = (parse(one), parse(other));
    assert_eq!((one.frames.len(), one.nodes.len()), (other.frames.len(), other.nodes.len()));
    let (mut apart, mut size) = (0.0_f64, 0.0_f64);
    for frame in 0..one.frames.len() {
        let root = Vector3::from(one.positions(frame)[0].0);
        for ((a, _), (b, _)) in one.positions(frame).into_iter().zip(other.positions(frame)) {
            apart = apart.max((Vector3::from(a) * metres - Vector3::from(b) * others).norm());
            size = size.max((Vector3::from(a) - root).norm() * metres);
        }
    }
    apart / size
}

#[test]
fn a_written_motion_comes_back_and_goes_out_again() {
    let (figure, motion) = full_human();
    let mut bytes = Vec::new();
    bvh::write(&figure, &motion, Unit::Centimetres, &mut bytes).expect("a human fits");
    let text = String::from_utf8(bytes).expect("text");
    let clip = clip(&text);
    assert_eq!(clip.unit, Unit::Centimetres);
    assert_eq!(clip.motion.info.rate.to_bits(), 30.0_f64.to_bits());
    assert_eq!(clip.motion.len(), motion.len());
    assert!(apart(&text, [0.01, 0.01], &written(&clip)) < 1e-8);
}

/// What is written of a figure is a motion of that figure again, under its own names.
#[test]
fn a_written_motion_is_its_figures() {
    let (figure, motion) = full_human();
    let mut bytes = Vec::new();
    bvh::write(&figure, &motion, Unit::Centimetres, &mut bytes).expect("a human fits");
    let clip = clip(std::str::from_utf8(&bytes).expect("text"));
    let table = clip.table_of(&figure).expect("its own");
    assert_eq!(table.columns[4], "root.rz.q");
    let again = solaris_io::record::read(&figure, motion.info.gravity, &table).expect("a motion").motion;
    for sample in 0..motion.len() {
        assert_relative_eq!(motion.q(sample), again.q(sample), epsilon = 1e-7);
    }
    let limp = solaris_model::Human::new(1.75, 73.0).limp().build().expect("a human");
    let error = clip.table_of(&limp).expect_err("a free root").to_string();
    assert_eq!(
        error,
        "it is no motion of figure 'human': link 'pelvis': its joint 'root' does not move as the clip's does (a ball or free joint)"
    );
    let other = clip_of(ODD).table_of(&figure).expect_err("another figure").to_string();
    assert_eq!(other, "it is no motion of figure 'human': link 'pelvis': the clip has no joint of that name");
}

fn clip_of(text: &str) -> Clip {
    clip(text)
}

/// A walk of the CMU database.
#[test]
fn a_measured_walk_goes_out_as_it_came() {
    let Some(text) = crate::data::text("motion/cmu_12_01_walk.bvh") else { return };
    let clip = clip(&text);
    assert_eq!((clip.unit, clip.motion.len(), clip.figure.links().len()), (Unit::Cmu, 524, 31));
    assert!(said(&clip).contains("'LeftArm' jumps by 79°"), "{}", said(&clip));
    let off = apart(&text, [0.0254 / 0.45, 0.01], &written(&clip));
    assert!(off < 1e-7, "{off}");
}

/// A person of 1.74 m in a rig of another program's names; lengths in `unit`s a metre.
fn person(unit: f64) -> String {
    let mut text = String::from(
        "HIERARCHY\nROOT mixamorig:Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n",
    );
    let joint = |name: &str, at: [f64; 3], inner: &str| {
        let [x, y, z] = at.map(|x| x * unit);
        format!(
            "JOINT mixamorig:{name}\n{{\nOFFSET {x} {y} {z}\nCHANNELS 3 Zrotation Xrotation Yrotation\n{inner}}}\n"
        )
    };
    let end = |at: [f64; 3]| {
        let [x, y, z] = at.map(|x| x * unit);
        format!("End Site\n{{\nOFFSET {x} {y} {z}\n}}\n")
    };
    let head = joint("Neck", [0.0, 0.3, 0.0], &joint("Head", [0.0, 0.1, 0.0], &end([0.0, 0.2, 0.0])));
    let arm = |side: &str, x: f64| {
        let hand = joint(&format!("{side}Hand"), [0.0, -0.27, 0.0], &end([0.0, -0.09, 0.0]));
        let forearm = joint(&format!("{side}ForeArm"), [0.0, -0.28, 0.0], &hand);
        joint(&format!("{side}Arm"), [x, 0.25, 0.0], &forearm)
    };
    let leg = |side: &str, x: f64| {
        let foot = joint(&format!("{side}Foot"), [0.0, -0.434, 0.0], &end([0.0, -0.06, 0.15]));
        let shank = joint(&format!("{side}Leg"), [0.0, -0.422, 0.0], &foot);
        joint(&format!("{side}UpLeg"), [x, -0.08, 0.0], &shank)
    };
    let inner = head + &arm("Left", 0.18) + &arm("Right", -0.18);
    text += &joint("Spine", [0.0, 0.1, 0.0], &joint("Spine1", [0.0, 0.1, 0.0], &inner));
    text += &(leg("Left", 0.085) + &leg("Right", -0.085));
    text += "}\n";
    let count = text.matches("rotation").count();
    let row = |angle: f64| {
        let turns = vec![angle.to_string(); count].join(" ");
        format!("0 {} 0 {turns}\n", 0.95 * unit)
    };
    text + "MOTION\nFrames: 3\nFrame Time: 0.0333\n" + &row(0.0) + &row(1.0) + &row(2.0)
}

fn mass(figure: &Figure, names: &[&str]) -> f64 {
    let is = |name: &str| names.iter().any(|wanted| name == format!("mixamorig:{wanted}"));
    figure.links().iter().filter(|link| is(link.name())).map(solaris_model::Link::mass).sum()
}

#[test]
fn a_person_has_a_persons_masses() {
    let clip = clip(&person(100.0));
    let figure = &clip.figure;
    let total = figure.mass();
    // 22 kg/m² at the height of which these legs are.
    assert_relative_eq!(total, 22.0 * 1.741 * 1.741, max_relative = 1e-9);
    for (names, share) in [
        (&["LeftUpLeg"][..], 0.1416),
        (&["RightLeg"], 0.0433),
        // The rig has no toes and no clavicles.
        (&["LeftFoot"], 0.0115 + 0.0022),
        (&["Spine", "Spine1"], 0.1633 + 0.1436 + 2.0 * 0.0080),
        (&["LeftArm"], 0.0271),
        (&["Head"], 0.0574),
    ] {
        // The published shares are a whole to their last digit.
        assert_relative_eq!(mass(figure, names) / total, share, max_relative = 1e-3);
    }
    let thigh = figure.links().iter().find(|link| link.name().ends_with("LeftUpLeg")).expect("a thigh");
    assert_relative_eq!(thigh.com().y, -0.4095 * 0.422, max_relative = 2e-3);
    let inertia = thigh.mass() * 0.422 * 0.422;
    assert_relative_eq!(thigh.inertia()[(0, 0)], inertia * 0.329 * 0.329, max_relative = 1e-9);
    assert_relative_eq!(thigh.inertia()[(1, 1)], inertia * 0.149 * 0.149, max_relative = 1e-9);
    let heavy = ReadOptions { mass: Some(90.0), ..ReadOptions::default() };
    assert_relative_eq!(
        read(&person(100.0), &heavy).expect("a clip").figure.mass(),
        90.0,
        max_relative = 1e-12
    );
}

/// Rigs of which the hand is where the elbow is.
#[test]
fn a_bone_of_no_length_has_a_mass() {
    let (whole, wrist) = (person(100.0), "OFFSET 0 -27 0");
    assert!(whole.contains(wrist));
    let figure = clip(&whole.replacen(wrist, "OFFSET 0 0 0", 1)).figure;
    let forearm = figure.link("mixamorig:LeftForeArm").expect("a forearm");
    assert!(forearm.mass() > 0.0 && forearm.inertia().iter().all(|x| x.is_finite()));
}

#[test]
fn the_unit_is_the_one_in_which_a_person_is_a_person() {
    for (per_metre, unit) in
        [(1.0, Unit::Metres), (100.0, Unit::Centimetres), (1000.0, Unit::Millimetres), (39.37, Unit::Inches)]
    {
        let clip = clip(&person(per_metre));
        assert_eq!(clip.unit, unit);
        assert_relative_eq!(clip.motion.q(0)[1], 0.95, max_relative = 1e-3);
    }
    // Who says the unit has it.
    let options = ReadOptions { unit: Some(Unit::Of(0.02)), ..ReadOptions::default() };
    assert_relative_eq!(
        read(&person(100.0), &options).expect("a clip").motion.q(0)[1],
        1.9,
        max_relative = 1e-12
    );
}

/// The same person in a world whose z is up: x forward, y left.
#[test]
fn a_world_with_z_up_is_turned() {
    let upright = person(100.0);
    let mut lying = upright.clone();
    for (axis, other) in [("X", "b"), ("Y", "c"), ("Z", "a")] {
        for kind in ["position", "rotation"] {
            lying = lying.replace(&format!("{axis}{kind}"), &format!("{other}{kind}"));
        }
    }
    for (other, axis) in [("a", "X"), ("b", "Y"), ("c", "Z")] {
        for kind in ["position", "rotation"] {
            lying = lying.replace(&format!("{other}{kind}"), &format!("{axis}{kind}"));
        }
    }
    let turned: Vec<String> = lying
        .lines()
        .map(|line| match line.strip_prefix("OFFSET ").map(|rest| rest.split(' ').collect::<Vec<_>>()) {
            Some(at) => format!("OFFSET {} {} {}", at[2], at[0], at[1]),
            None => line.to_owned(),
        })
        .collect();
    let lying = turned.join("\n");
    let clip = clip(&lying);
    assert!(said(&clip).contains("z points up"), "{}", said(&clip));
    assert!(apart(&upright, [0.01, 0.01], &written(&clip)) < 1e-8);
    let as_it_is = ReadOptions { up: Some(Up::Y), ..ReadOptions::default() };
    let off = apart(&lying, [0.01, 0.01], &written(&read(&lying, &as_it_is).expect("a clip")));
    assert!(off < 1e-8);
}

/// A joint that is moved about in its parent, one whose printed position never changes, angles that were cut, names that are no
/// names, a reference pose in front and too few rows.
const ODD: &str = "HIERARCHY\r\nROOT  left arm\r\n{\r\n OFFSET 1 2 3\r\n CHANNELS 4 Zrotation Xposition Xrotation Yrotation\r\n\
 JOINT\r\n {\r\n  OFFSET 0 -10 0\r\n  CHANNELS 6 Xposition Yposition Zposition Yrotation Xrotation Zrotation\r\n\
  JOINT tail{\r\n   OFFSET 0 -5 0\r\n   CHANNELS 4 Xposition Yposition Zposition Xrotation\r\n\
   JOINT tail\r\n   {\r\n    OFFSET 0 -5 0\r\n    End Site\r\n    {\r\n     OFFSET 0 -1 0\r\n    }\r\n   }\r\n  }\r\n }\r\n}\r\n\
MOTION\r\nFrames:\t9\r\nFrame Time:\t.04\r\n\
90 7 0 0   0 -10 0   0 0 0  1 -5 0 0\r\n\
170 7 0 0   0 -10 1   175 80 0  1 -5 0 1\r\n\
-175 7 0 0   0 -10 2   -3 89 -178  1 -5 0 2\r\n\
-171 7 0 0   0 -10 3   -1 85 -176  1 -5 0 2\r\n\
-168 7 0 0   0 -10 3   0 80 -175  1 -5 0 2\r\n";

#[test]
fn what_is_odd_is_read_and_said() {
    let clip = clip(ODD);
    let names = clip.figure.layout().q_names().join(" ");
    assert_eq!(
        names,
        "left_arm.tx left_arm.rz left_arm.rx left_arm.ry joint.tx joint.ty joint.tz joint.ry joint.rx joint.rz tail.rx"
    );
    let root = clip.figure.links()[0].joint().placement().translation.vector * clip.unit.per_metre();
    assert_relative_eq!(root, Vector3::new(0.0, 2.0, 3.0), epsilon = 1e-12);
    let rz: Vec<f64> = (0..5).map(|row| clip.motion.q(row)[1].to_degrees().round()).collect();
    assert_eq!(rz, [90.0, 170.0, 185.0, 189.0, 192.0]);
    let ry: Vec<f64> = (1..5).map(|row| clip.motion.q(row)[7].to_degrees().round()).collect();
    assert_eq!(ry, [175.0, 177.0, 179.0, 180.0]);
    assert_eq!(clip.motion.info.rate.to_bits(), 25.0_f64.to_bits());
    insta::assert_snapshot!(said(&clip));
    let plain = ODD
        .replace("left arm", "left_arm")
        .replace("JOINT\r\n", "JOINT joint\r\n")
        .replace("tail{", "tail {");
    let plain = plain.replace("Frames:\t9", "Frames: 5").replace("Time:\t", "Time: ");
    assert!(apart(&plain, [1.0 / clip.unit.per_metre(), 0.01], &written(&clip)) < 1e-7);
}

#[test]
fn a_table_of_masses_and_frames_that_are_left_out() {
    let masses = vec![("left_arm".to_owned(), 2.0), ("tail".to_owned(), 0.5), ("tail_2".to_owned(), 0.25)];
    let options = ReadOptions { masses, skip: 2, ..ReadOptions::default() };
    let clip = read(ODD, &options).expect("a clip");
    assert_eq!((clip.motion.len(), clip.figure.mass()), (3, 2.75));
    let wrong = |options: &ReadOptions| read(ODD, options).expect_err("refused").to_string();
    let named = |name: &str, mass: f64| ReadOptions {
        masses: vec![(name.to_owned(), mass)],
        ..ReadOptions::default()
    };
    let answers = [
        wrong(&named("tial", 1.0)),
        wrong(&named("tail", -1.0)),
        wrong(&ReadOptions { mass: Some(f64::NAN), ..ReadOptions::default() }),
        wrong(&ReadOptions { unit: Some(Unit::Of(0.0)), ..ReadOptions::default() }),
        wrong(&ReadOptions { skip: 5, ..ReadOptions::default() }),
    ];
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn a_skeleton_without_a_motion_is_a_figure() {
    let (skeleton, _) = ODD.split_once("MOTION").expect("two parts");
    let clip = clip(skeleton);
    assert_eq!((clip.figure.links().len(), clip.motion.len()), (4, 0));
}

#[test]
fn what_is_none_is_refused_with_its_place() {
    let change = |from: &str, to: &str| {
        let text = ODD.replacen(from, to, 1);
        assert_ne!(text, ODD, "{from}");
        read(&text, &ReadOptions::default()).expect_err(from).to_string()
    };
    let answers = [
        read("", &ReadOptions::default()).expect_err("nothing").to_string(),
        read("<robot/>", &ReadOptions::default()).expect_err("no BVH").to_string(),
        change("HIERARCHY\r\nROOT", "HIERARCHY\r\nJOINT"),
        change("OFFSET 1 2 3", "OFFSET 1 2"),
        change("OFFSET 0 -10 0", "OFFSET 0 nan 0"),
        change("CHANNELS 4", "CHANNELS 9"),
        change("CHANNELS 4", "CHANNELS 5"),
        change("Xrotation", "Wrotation"),
        change("Zrotation", "Xrotation"),
        change("MOTION", "}\r\nMOTION"),
        change("MOTION", "ROOT two\r\n{\r\n}\r\nMOTION"),
        change("Frames:\t9", "Frames:\tmany"),
        change("Frame Time:\t.04", "Frame Time:\t0"),
        change("Frame Time:", "Time:"),
        change("-171 7", "-171"),
        change("-171 7", "-171 1.#QNAN"),
        read(&ODD[..240], &ReadOptions::default()).expect_err("cut off").to_string(),
    ];
    insta::assert_snapshot!(answers.join("\n\n"));
}

/// Hostile texts end soon, with a fault or a figure.
#[test]
fn hostile_texts_end() {
    let joint = |i: usize| format!("JOINT j{i} {{ OFFSET 0 1 0 CHANNELS 1 Xrotation\n");
    let deep = (0..3_000).map(joint).collect::<Vec<_>>().concat();
    let deep = format!("HIERARCHY ROOT r\n{{ OFFSET 0 0 0\n{deep}{}}}", "}\n".repeat(3_000));
    assert_eq!(clip(&deep).figure.links().len(), 3_001);
    let same: String = (0..3_000).map(|_| "JOINT j\n{ OFFSET 0 1 0 }\n").collect();
    let same = clip(&format!("HIERARCHY ROOT r\n{{ OFFSET 0 0 0\n{same}}}"));
    assert_eq!(same.figure.links().len(), 3_001);
    assert!(same.findings.len() < 110, "{} findings", same.findings.len());
    assert!(said(&same).contains("2899 more are called otherwise here"));
    let many = "JOINT j\n{ OFFSET 0 1 0 }\n".repeat(1 + (1 << 17));
    let error = read(&format!("HIERARCHY ROOT r\n{{ OFFSET 0 0 0\n{many}}}"), &ReadOptions::default());
    assert!(error.expect_err("too many").to_string().contains("more than 131072 joints"));
    let many = ODD.replace("Frames:\t9", "Frames:\t99999999999999999");
    assert_eq!(clip(&many).motion.len(), 5);
    let none = "HIERARCHY ROOT r\n{ OFFSET 0 0 0 }\nMOTION\nFrames: 99999999999999\nFrame Time: 1\n";
    assert_eq!(clip(none).motion.len(), 0);
    for end in (0..ODD.len()).step_by(7) {
        let _ = read(&ODD[..end], &ReadOptions::default());
    }
}

/// A chain of bones of some hundred or thousand kilometres, whose names are no person's: rods of its lengths.
fn long_chain(length: &str) -> String {
    format!(
        "HIERARCHY\nROOT tail\n{{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n \
         JOINT tip\n {{\n  OFFSET {length} 0 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n  End Site\n  {{\n   OFFSET 0 -20 0\n  }}\n }}\n}}\n\
         MOTION\nFrames: 2\nFrame Time: 0.1\n0 0 0 0 0 0 0 0 0\n1 0 0 0 0 0 0 0 0\n"
    )
}

/// Of bones as long as a country the guessed mass is beyond what a link may have; the mass that is asked for is not written in the file.
#[test]
fn bones_that_would_weigh_more_than_any_link_are_refused_unless_their_mass_is_asked_for() {
    let heavy = long_chain("2e8");
    let unit = Some(Unit::default());
    let error =
        read(&heavy, &ReadOptions { unit, ..ReadOptions::default() }).expect_err("refused").to_string();
    assert!(error.contains("link 'tail': mass is ") && error.contains("it must be at most 1e20"), "{error}");
    let asked = ReadOptions { unit, mass: Some(70.0), ..ReadOptions::default() };
    let found = read(&heavy, &asked).expect("a clip");
    assert!((found.figure.mass() - 70.0).abs() < 1e-9);
    let again = read(&written(&found), &asked).expect("what was written");
    assert_eq!(again.motion.len(), found.motion.len());
    let light = read(&long_chain("1e7"), &ReadOptions { unit, ..ReadOptions::default() }).expect("a clip");
    assert!(light.figure.links().iter().all(|link| link.mass() <= Figure::HEAVIEST));
}

/// As many frames as no memory holds: times the channels they were more than a number of the machine.
#[test]
fn frames_beyond_counting_beside_lines_of_two_lengths_are_told_by_their_line() {
    let text = long_chain("20")
        .replace("Frames: 2", "Frames: 10000000004294967296")
        .replace("\n1 0 0 0 0 0 0 0 0\n", "\n1 0 0\n");
    let error = read(&text, &ReadOptions::default()).expect_err("refused").to_string();
    assert!(error.contains("the line has 3 numbers, and the hierarchy 9 channels"), "{error}");
}
