//! Figures and motions from one format to another and back.

use crate::inverse::{
    PLATES, column, difference, folder_with, json, names, number, read, refused, solaris, subject, succeeded,
    table, write,
};
use std::fs;
use std::path::Path;

/// The text that `solaris convert FROM TO` writes.
fn converted(folder: &Path, from: &str, to: &str) -> String {
    let printed = succeeded(&solaris(folder, &format!("convert {from} {to}")));
    let last = printed.lines().last().unwrap_or_default();
    assert!(last.starts_with(&format!("wrote {}", to.split(' ').next().expect("a name"))), "{printed}");
    read(&folder.join(to.split(' ').next().expect("a name")))
}

fn mass(folder: &Path, figure: &str) -> f64 {
    number(&json(&succeeded(&solaris(folder, &format!("check {figure} --json")))), "/mass_kg")
}

#[test]
fn the_text_of_a_subject_moves_as_the_subject() {
    let folder = subject();
    converted(folder.path(), "subject.osim", "subject.ron");
    let torques = |figure: &str| {
        let line = format!("inverse {figure} walk.mot {PLATES} --filter 6Hz -o tau.csv");
        succeeded(&solaris(folder.path(), &line));
        read(&folder.path().join("tau.csv"))
    };
    // Followers, frames and names too: the same text of the same numbers.
    assert!(torques("subject.osim") == torques("subject.ron"));
}

#[test]
fn the_text_of_a_robot_moves_as_the_robot() {
    let folder = folder_with(&["figures/arm.urdf"]);
    converted(folder.path(), "arm.urdf", "arm.ron");
    write(
        folder.path(),
        "swing.csv",
        "shoulder.q,elbow.q,shoulder.v,elbow.v,shoulder.a,elbow.a\n0.3,-0.5,1,2,-3,4\n-1,-2,0.5,-0.25,8,1\n",
    );
    let torques = |figure: &str, gravity: &str| {
        let line = format!("inverse {figure} swing.csv{gravity} -o tau.csv");
        succeeded(&solaris(folder.path(), &line));
        table(folder.path(), "tau.csv").values
    };
    // The text says which way is up: a robot's gravity is along −z.
    for gravity in ["", " --gravity 0,0,-9.81"] {
        assert_eq!(torques("arm.urdf", gravity), torques("arm.ron", gravity));
    }
    assert_ne!(torques("arm.ron", ""), torques("arm.ron", " --gravity 0,-9.80665,0"));
}

#[test]
fn the_worlds_of_other_programs_stay_with_their_figures() {
    let folder = subject();
    write(
        folder.path(),
        "ball.xml",
        "<mujoco model='ball'><option gravity='1 2 -3'/><worldbody><body name='b'><freejoint/><geom size='.1'/></body></worldbody></mujoco>",
    );
    for (from, gravity) in [("ball.xml", [1.0, 2.0, -3.0]), ("subject.osim", [0.0, -9.80665, 0.0])] {
        converted(folder.path(), from, "figure.ron");
        let facts = [from, "figure.ron"]
            .map(|file| json(&succeeded(&solaris(folder.path(), &format!("check {file} --json")))));
        for facts in &facts {
            for (axis, expected) in gravity.iter().enumerate() {
                assert!((number(facts, &format!("/gravity_m_s2/{axis}")) - expected).abs() < 1e-15, "{from}");
            }
        }
        assert_eq!(facts[0]["extent_m"], facts[1]["extent_m"]);
    }
}

#[test]
fn writing_what_was_read_gives_the_same_text() {
    let folder = subject();
    fs::copy(Path::new(crate::inverse::FIXTURES).join("figures/arm.urdf"), folder.path().join("arm.urdf"))
        .expect("copied");
    succeeded(&solaris(folder.path(), "figure human --height 1.8 -o human.ron"));
    let human = read(&folder.path().join("human.ron"));
    for (from, text) in [
        ("human.ron", human),
        ("first.ron", converted(folder.path(), "subject.osim", "first.ron")),
        ("arm.ron", converted(folder.path(), "arm.urdf", "arm.ron")),
    ] {
        assert_eq!(converted(folder.path(), from, "again.ron"), text, "{from}");
    }
    // Onto itself as well.
    let text = read(&folder.path().join("human.ron"));
    assert_eq!(converted(folder.path(), "human.ron", "human.ron"), text);
}

#[test]
fn a_mass_that_is_asked_for_is_met_to_the_last_bit() {
    let folder = subject();
    succeeded(&solaris(folder.path(), "figure human --mass 79 -o human.ron"));
    assert!(mass(folder.path(), "human.ron").to_bits() == 79f64.to_bits(), "from the start");
    for (from, kilograms) in [("subject.osim", 79.0), ("human.ron", 61.3), ("human.ron", 79.1)] {
        converted(folder.path(), from, &format!("scaled.ron --mass {kilograms}"));
        let found = mass(folder.path(), "scaled.ron");
        assert!(found.to_bits() == f64::to_bits(kilograms), "{from}: {found} for {kilograms} kg");
    }
}

#[test]
fn a_figure_takes_the_height_and_the_lengths_that_are_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    let facts = |line: &str| {
        succeeded(&solaris(folder.path(), line));
        json(&succeeded(&solaris(folder.path(), "check new.ron --json")))
    };
    let person = facts("figure human --height 1.62 --mass 54.3 --segment thigh=0.41 -o new.ron");
    assert!((number(&person, "/stature_m") - 1.62).abs() < 1e-12, "{person}");
    let before = read(&folder.path().join("new.ron"));
    for side in ["left", "right"] {
        // Along the thigh; the knee's centre lies a little behind.
        assert!((knee(&before, side)[1] + 0.41).abs() < 1e-12, "{:?}", knee(&before, side));
    }
    let longer = facts("convert new.ron new.ron --height 1.7 --segment left_thigh=0.5");
    assert!((number(&longer, "/stature_m") - 1.7).abs() < 1e-12, "{longer}");
    assert!((number(&longer, "/mass_kg") - 54.3).abs() < 1e-12, "{longer}");
    let after = read(&folder.path().join("new.ron"));
    let [left, right] = ["left", "right"].map(|side| length(&knee(&after, side)));
    assert!((left - 0.5).abs() < 1e-12, "{left}");
    assert!((right - length(&knee(&before, "right")) * 1.7 / 1.62).abs() < 1e-12, "{right}");
}

/// Where the knee sits in the thigh, by the figure's text (m).
fn knee(text: &str, side: &str) -> Vec<f64> {
    let joint = text.find(&format!("name: \"{side}_knee\"")).expect("a knee");
    let at = joint + text[joint..].find("at: (").expect("its place") + 5;
    let numbers = text[at..].split(')').next().expect("numbers");
    numbers.split(',').map(|word| word.trim().parse().expect("a number")).collect()
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn positions_keep_every_bit_on_the_way_to_opensim_and_back() {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), "walk --steps 2 --rate 30 -o walk.csv"));
    for kind in ["mot", "sto"] {
        let said = succeeded(&solaris(folder.path(), &format!("convert walk.csv walk.{kind}")));
        assert!(said.contains("left out") && said.contains("root.tx.v") && said.contains(" more"), "{said}");
        converted(folder.path(), &format!("walk.{kind}"), "back.csv");
        let [walk, middle, back] = [String::from("walk.csv"), format!("walk.{kind}"), "back.csv".into()]
            .map(|name| table(folder.path(), &name));
        assert_eq!((middle.in_degrees, middle.columns.len()), (Some(false), 67));
        assert_eq!(back.columns.len(), 67);
        for name in &back.columns {
            let bits = |table| column(table, name).iter().map(|x: &f64| x.to_bits()).collect::<Vec<_>>();
            assert!(bits(&walk) == bits(&back), "{name}");
        }
    }
}

#[test]
fn degrees_need_a_figure_that_says_what_turns() {
    let folder = subject();
    let said = refused(&solaris(folder.path(), "convert walk.mot walk.csv"));
    assert!(said.starts_with("error: walk.mot: ") && said.contains("--figure"), "{said}");
    assert!(!names(folder.path()).contains(&"walk.csv".to_owned()));
    converted(folder.path(), "walk.mot", "walk.csv --figure subject.osim");
    let [degrees, radians] = ["walk.mot", "walk.csv"].map(|name| table(folder.path(), name));
    for name in degrees.columns.iter().skip(1) {
        let slides = ["pelvis_tx", "pelvis_ty"].contains(&name.as_str());
        let turned = |value: f64| if slides { value } else { value.to_radians() };
        let expected: Vec<f64> = column(&degrees, name).into_iter().map(turned).collect();
        let found = column(&radians, &format!("{name}.q"));
        assert!(difference(&expected, &found) < 1e-15, "{name}");
    }
    // The motion of the one is the motion of the other.
    for motion in ["walk.mot", "walk.csv"] {
        succeeded(&solaris(folder.path(), &format!("inverse subject.osim {motion} -o {motion}.sto")));
    }
    let [one, other] = ["walk.mot.sto", "walk.csv.sto"].map(|name| table(folder.path(), name).values);
    assert!(difference(&one, &other) < 1e-6, "{:e}", difference(&one, &other));
}

#[test]
fn what_cannot_be_converted_says_why() {
    let folder = subject();
    for (line, code, why) in [
        ("convert subject.osim walk.mot", 1, "OUT walk.mot: IN subject.osim is a figure"),
        (
            "convert walk.mot walk.ron",
            1,
            "OUT walk.ron: its extension must be .csv, .sto, .mot, .bvh, .glb, .usda or .html",
        ),
        ("convert walk.mot walk.csv --mass 70", 2, "a motion has no size"),
        ("convert subject.osim s.ron --mass 0", 1, "mass"),
        ("convert subject.osim s.ron --mass -3", 1, "mass"),
        ("convert subject.osim s.ron --height 1.8", 1, "height"),
        ("convert subject.osim s.ron --segment femur", 2, "NAME=LENGTH"),
        ("convert subject.osim s.ron --segment femur_x=0.4", 1, "femur_"),
        ("convert subject.osim s.ron --segment femur_r=-1", 1, "femur_r"),
        ("convert loads.xml s.ron", 1, "loads.xml"),
        ("convert subject.osim", 2, "<OUT>"),
    ] {
        let said = crate::inverse::failed(&solaris(folder.path(), line), code);
        assert!(said.contains(why), "{line}: {said}");
    }
    assert_eq!(names(folder.path()), ["grf.mot", "loads.xml", "soles.ron", "subject.osim", "walk.mot"]);
}
