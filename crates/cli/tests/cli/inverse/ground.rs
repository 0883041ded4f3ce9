//! The ground's forces from the motion alone: of a planned walk, of the project's subject, of measured ones.

use crate::inverse::{
    DATA, column, data, difference, failed, folder_with, json, largest, names, number, read, refused,
    solaris, solaris_with, subject, succeeded, table, write,
};
use serde_json::Value;
use solaris::io::{Table, record, sto};
use solaris::model::{
    Axis, FigureBuilder, Inertia, Isometry3, Joint, LinkSpec, Matrix3, Rotation3, UnitQuaternion, Vector3,
    text,
};
use std::path::Path;

/// Shown with `--nocapture`.
#[expect(clippy::print_stderr, reason = "captured unless somebody asks for it")]
fn say(text: &str) {
    eprintln!("{text}");
}

/// A walk of `solaris walk`, its figure, and the figure's soles on it.
pub(crate) fn walked() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), "walk --height 1.75 --mass 73 --steps 4 --rate 120 -o walk.csv"));
    succeeded(&solaris(folder.path(), "figure human --height 1.75 --mass 73 -o human.ron"));
    folder
}

/// The greatest difference of a foot's force, over the weight, along x, y and z.
fn off(ours: &Table, theirs: &Table, [foot, link]: [&str; 2], weight: f64) -> [f64; 3] {
    ["fx", "fy", "fz"].map(|end| {
        let [ours, theirs] =
            [(ours, foot), (theirs, link)].map(|(table, of)| column(table, &format!("{of}.{end}")));
        difference(&ours, &theirs) / weight
    })
}

#[test]
fn a_walk_gets_its_own_forces_back() {
    let folder = walked();
    let printed = succeeded(&solaris(folder.path(), "ground human.ron walk.csv -o grf.csv --json"));
    let report = json(&printed);
    let weight = number(&report, "/ground/weight_n");
    let [walk, grf] = ["walk.csv", "grf.csv"].map(|name| table(folder.path(), name));
    assert_eq!(grf.columns.len(), 19, "{:?}", grf.columns);
    for foot in ["left_foot", "right_foot"] {
        let off = off(&grf, &walk, [foot, foot], weight);
        say(&format!("{foot}: off by {off:.3?} of the weight"));
        assert!(off.iter().zip([0.04, 0.21, 0.06]).all(|(off, limit)| *off < limit), "{foot}: {off:?}");
    }
    // The sum is no assumption. The plan's own forces are those of its samples.
    let sum = |table: &Table, end: &str| -> Vec<f64> {
        let [left, right] = ["left_foot", "right_foot"].map(|foot| column(table, &format!("{foot}.{end}")));
        left.iter().zip(&right).map(|(left, right)| left + right).collect()
    };
    for end in ["fx", "fy", "fz", "mx", "my", "mz"] {
        let off = difference(&sum(&grf, end), &sum(&walk, end));
        assert!(off < 1e-6 * weight, "{end}: {off:e}");
    }
    assert_eq!(number(&report, "/ground/unsupported/frames") as usize, 0);
    assert_eq!(report["ground"]["belt_m_s"], serde_json::json!([0.0, 0.0, 0.0]));
}

#[test]
fn with_the_ground_nothing_is_left_at_the_root() {
    let folder = walked();
    for split in ["transition", "pivot", "effort"] {
        let line = format!("inverse human.ron walk.csv --ground --split {split} -o tau.csv --json");
        let report = json(&succeeded(&solaris(folder.path(), &line)));
        assert_eq!(report["ground"]["split"], split);
        for what in ["force_greatest_n", "moment_greatest_nm"] {
            let left = number(&report, &format!("/residual/{what}"));
            say(&format!("{split}: {what} {left:e}"));
            assert!(left < 1e-8, "{split}: {what} {left:e}");
        }
    }
}

#[test]
fn what_is_written_is_what_inverse_reads() {
    let folder = subject();
    let options = "--soles soles.ron --filter 6Hz";
    succeeded(&solaris(
        folder.path(),
        &format!("ground subject.osim walk.mot {options} -o found.mot -o found.csv"),
    ));
    let plates = "--filter 6Hz --plate calcn_r=right";
    for line in [
        format!("inverse subject.osim walk.mot --ground {options} -o one.csv"),
        format!(
            "inverse subject.osim walk.mot --external found.mot {plates}_ --plate calcn_l=left_ -o two.csv"
        ),
        format!(
            "inverse subject.osim walk.mot --external found.csv {plates} --plate calcn_l=left -o three.csv"
        ),
    ] {
        succeeded(&solaris(folder.path(), &line));
    }
    let [one, two, three] = ["one.csv", "two.csv", "three.csv"].map(|name| table(folder.path(), name));
    let scale = largest(&column(&one, "ankle_angle_r.tau"));
    for other in [&two, &three] {
        assert_eq!(one.columns, other.columns);
        assert!(difference(&one.values, &other.values) < 1e-9 * scale);
    }
    assert!(scale > 50.0, "{scale} N m");
}

#[test]
fn ground_that_is_not_level_is_told_and_carries_no_shift() {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), "figure human --height 1.75 --mass 73 -o human.ron"));
    for (ground, [low, high]) in [("--stairs 4", [0.0, 0.68]), ("--slope 8", [0.0, 0.81])] {
        succeeded(&solaris(
            folder.path(),
            &format!("walk --height 1.75 --mass 73 {ground} --rate 120 -o walk.csv"),
        ));
        let report = json(&succeeded(&solaris(folder.path(), "ground human.ron walk.csv --json")));
        let [from, to] = [0, 1].map(|i| number(&report, &format!("/ground/feet_stand_m/{i}")));
        assert!((from - low).abs() < 0.02 && to > high - 0.02, "{ground}: {from} to {to} m");
        assert_eq!(report["ground"]["belt_m_s"], serde_json::json!([0.0, 0.0, 0.0]), "{ground}");
        let told = succeeded(&solaris(folder.path(), "ground human.ron walk.csv"));
        assert!(told.contains("not level: feet stand 0"), "{told}");
        let said =
            refused(&solaris(folder.path(), "ground human.ron walk.csv --consistent --motion-out m.csv"));
        assert!(said.contains("a shift of the root is found on level ground alone"), "{said}");
        // Measures of the same motion by the same forces.
        let metrics = json(&succeeded(&solaris(
            folder.path(),
            "metrics human.ron walk.csv --stances feet --ground --json",
        )));
        let all = metrics["metrics"].as_array().expect("a list");
        let peak = all.iter().find(|metric| metric["metric"] == "vertical_first_percent_bw").expect("a peak");
        let peak = peak["value"].as_f64().expect("a number");
        assert!((95.0..160.0).contains(&peak), "{ground}: {peak} %BW");
    }
    // On a floor there is nothing of it.
    succeeded(&solaris(folder.path(), "walk --height 1.75 --mass 73 --steps 4 --rate 120 -o walk.csv"));
    let report = json(&succeeded(&solaris(folder.path(), "ground human.ron walk.csv --json")));
    assert!(report["ground"].get("feet_stand_m").is_none_or(Value::is_null));
}

#[test]
fn a_motion_before_its_figure_is_told_to_swap() {
    let folder = subject();
    for command in ["ground", "inverse", "metrics"] {
        let line = format!("{command} walk.mot subject.osim --filter 6Hz");
        let said = failed(&solaris(folder.path(), &line), 2);
        let right = format!("swap them, give the figure first: solaris {command} subject.osim walk.mot");
        assert!(said.contains(&right), "{said}");
    }
}

#[test]
fn a_belt_has_the_speed_that_is_asked_for_and_the_way_of_the_feet() {
    let folder = subject();
    let run = |options: &str| {
        solaris(folder.path(), &format!("ground subject.osim walk.mot --soles soles.ron {options}"))
    };
    // The same walk on a belt: the ground, and all on it, goes back at 1.2 m/s.
    let mut walk = table(folder.path(), "walk.mot");
    let (time, place) = (walk.column("time").expect("time"), walk.column("pelvis_tx").expect("a place"));
    let width = walk.columns.len();
    for row in walk.values.chunks_exact_mut(width) {
        row[place] -= 1.2 * row[time];
    }
    let mut text = Vec::new();
    sto::write(&walk, &mut text).expect("written");
    let still = json(&succeeded(&run("--filter 6Hz --json")));
    let said = refused(&run("--filter 6Hz --belt 1.2"));
    assert!(said.starts_with("error: --belt 1.2: the feet do not move with a belt"), "{said}");
    write(folder.path(), "walk.mot", &String::from_utf8(text).expect("UTF-8"));
    for (options, speed) in [("--belt 1.2", 1.2), ("--belt 1.3", 1.3), ("", 1.2)] {
        let report = json(&succeeded(&run(&format!("--filter 6Hz --json {options}"))));
        let belt = number(&report, "/ground/belt_m_s/0");
        assert!((belt + speed).abs() < if options.is_empty() { 0.1 } else { 1e-3 }, "{options}: {belt} m/s");
        // A belt changes no force but through its speed, and no stance.
        if (speed - 1.2_f64).abs() < 1e-9 {
            for foot in ["/ground/feet/0", "/ground/feet/1"] {
                let [a, b] = [&still, &report].map(|report| number(report, &format!("{foot}/greatest_n")));
                assert!((a - b).abs() < 0.03 * a, "{a} N, {b} N");
            }
        }
    }
}

#[test]
fn options_out_of_range_are_named() {
    let folder = subject();
    let before = names(folder.path());
    for (options, said) in [
        ("--stance-height 0", "error: --stance-height 0: it must be "),
        ("--stance-height=-0.1", "error: --stance-height -0.1: it must be "),
        ("--stance-speed 0", "error: --stance-speed 0: it must be "),
        ("--stance-shortest=-1", "error: --stance-shortest -1: it must be "),
        ("--stance-shortest inf", "error: --stance-shortest inf: it must be "),
        ("--gravity 0,0,0", "error: --gravity 0,0,0: "),
        ("--soles nowhere.ron", "error: nowhere.ron: there is no such file"),
        ("-o soles.ron", "error: -o soles.ron: its extension must be "),
        ("-o walk.mot", "error: -o walk.mot: it is what is read here"),
    ] {
        let line = format!("ground subject.osim walk.mot --soles soles.ron -o grf.mot {options}");
        let line = if options.starts_with("--soles") { line.replace("--soles soles.ron ", "") } else { line };
        let text = refused(&solaris(folder.path(), &line));
        assert!(text.starts_with(said), "{options}: {text}");
        assert_eq!(names(folder.path()), before);
    }
    failed(&solaris(folder.path(), "ground walk.mot"), 2);
}

/// What is said of the measured subject's feet.
fn feet(printed: &str) -> Vec<(String, f64)> {
    let report = json(printed);
    let feet = report["ground"]["feet"].as_array().expect("feet").clone();
    feet.iter()
        .map(|foot| (foot["name"].as_str().expect("a name").to_owned(), number(foot, "/greatest_of_weight")))
        .collect()
}

#[test]
fn a_measured_subject_needs_no_plates() {
    let files =
        ["gait10dof18musc_subject01.osim", "subject01_walk_ik_planar10.mot", "subject01_walk_grf.mot"];
    let [Some(model), Some(motion), Some(forces)] = files.map(|name| data(&format!("subject01_walk/{name}")))
    else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let [model, motion] = [&model, &motion].map(|path| path.to_str().expect("UTF-8"));
    let run = |more: &[&str]| {
        let mut args = more.to_vec();
        args.extend(["--filter", "6Hz", "--filter-order", "3", "--json"]);
        succeeded(&solaris_with(folder.path(), &args))
    };
    let printed = run(&["inverse", model, motion, "--ground", "-o", "free.csv"]);
    let report = json(&printed);
    assert_eq!(report["ground"]["soles_from"], "guessed by the bodies' names");
    for (name, greatest) in feet(&printed) {
        say(&format!("{name}: {greatest:.3} of the weight"));
        assert!((1.0..1.5).contains(&greatest), "{name}: {greatest}");
    }
    let belt = number(&report, "/ground/belt_m_s/0");
    say(&format!("belt {belt} m/s, {} frames in the air", number(&report, "/ground/unsupported/frames")));
    assert!((-1.4..-0.9).contains(&belt), "{belt} m/s");
    // Beside the moments with plates, where the filter has not spoilt them.
    let plates = forces.to_str().expect("UTF-8");
    run(&[
        "inverse",
        model,
        motion,
        "--external",
        plates,
        "--plate",
        "calcn_r=",
        "--plate",
        "calcn_l=1_",
        "-o",
        "plates.csv",
    ]);
    let [free, plates] = ["free.csv", "plates.csv"].map(|name| table(folder.path(), name));
    let rows: Vec<usize> = (0..free.len()).filter(|&row| (0.3..=2.2).contains(&free.row(row)[0])).collect();
    for (joint, limit) in [("ankle_angle", 20.0), ("knee_angle", 16.0), ("hip_flexion", 15.0)] {
        for side in ["r", "l"] {
            let name = format!("{joint}_{side}.tau");
            let [a, b] = [&free, &plates].map(|table| column(table, &name));
            let squares: f64 = rows.iter().map(|&row| (a[row] - b[row]).powi(2)).sum();
            let rms = (squares / rows.len() as f64).sqrt();
            say(&format!("{name}: rms {rms:.1} N m of {:.1}", largest(&b)));
            assert!(rms < limit, "{name}: {rms} N m");
        }
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().expect("a number")],
    }
}

/// The measured model in three dimensions as a figure's text; its links are called as the bodies that they carry.
fn spatial() -> Option<String> {
    let json = json(&read(&data("subject01_walk/gait2354_pinned.json")?));
    let links = json["links"].as_array().expect("links");
    let vector = |value: &Value| Vector3::from_row_slice(&numbers(value));
    let name = |index: usize| {
        let body = json["body_of"]
            .as_object()
            .expect("bodies")
            .iter()
            .find(|(_, at)| at.as_u64() == Some(index as u64));
        body.map_or_else(
            || format!("link_{}", links[index]["name"].as_str().expect("a name")),
            |(body, _)| body.clone(),
        )
    };
    let mut builder = FigureBuilder::new("gait2354");
    for (i, link) in links.iter().enumerate() {
        let matrix = |key: &str| Matrix3::from_row_slice(&numbers(&link[key]));
        let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix("R")));
        let (axis, dof) = (vector(&link["axis"]), link["name"].as_str().expect("a name"));
        let axis = if link["type"] == "prismatic" { Axis::translation(axis) } else { Axis::rotation(axis) };
        let placed = Isometry3::from_parts(vector(&link["p"]).into(), turn);
        let joint = Joint::new(dof).placed(placed).axis(axis).named(dof);
        let spec = match link["parent"].as_i64().expect("an index") {
            -1 => LinkSpec::root(name(i), joint),
            parent => LinkSpec::child(name(i), name(parent as usize), joint),
        };
        let mass = link["mass"].as_f64().expect("a mass");
        let inertia = Inertia::Tensor(matrix("inertia_com"));
        builder = builder.link(spec.mass(mass).com(vector(&link["com"])).inertia(inertia));
    }
    let figure = builder.build().expect("valid");
    Some(text::write(&figure))
}

#[test]
fn a_measured_subject_in_three_dimensions_needs_none_either() {
    let (Some(figure), Some(motion)) = (spatial(), data("subject01_walk/subject01_walk_ik_3d23.mot")) else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    write(folder.path(), "subject.ron", &figure);
    let motion = motion.to_str().expect("UTF-8");
    for split in ["transition", "pivot", "effort"] {
        let args = [
            "inverse",
            "subject.ron",
            motion,
            "--ground",
            "--split",
            split,
            "--filter",
            "6Hz",
            "--json",
            "-o",
            "tau.sto",
        ];
        let printed = succeeded(&solaris_with(folder.path(), &args));
        let report = json(&printed);
        let left = number(&report, "/ground/unsupported/frames");
        for (name, greatest) in feet(&printed) {
            say(&format!("{split}, {name}: {greatest:.3} of the weight, {left} frames in the air"));
            assert!((0.9..1.6).contains(&greatest), "{split}, {name}: {greatest}");
        }
    }
    // OpenSim's names come back as contacts.
    let args = ["ground", "subject.ron", motion, "--filter", "6Hz", "-o", "grf.mot"];
    let shown = succeeded(&solaris_with(folder.path(), &args));
    assert!(shown.lines().all(|line| line.chars().count() <= 120 || line.contains(DATA)), "{shown}");
    let found = record::forces(&table(folder.path(), "grf.mot"), &["calcn_r".to_owned()], "calcn_r_")
        .expect("forces");
    assert!(found.samples.iter().any(|contact| contact.force.y > 500.0));
    assert!(Path::new(motion).is_file());
}

/// Stances that are told are taken as they are, in `ground` and in `inverse`, and what is wrong with them is said with its line.
#[test]
fn stances_of_a_file_are_taken_as_they_are() {
    let folder = subject();
    let told = "foot,from,to\n\nright,0.1,0.9 # the first step\nleft,0.8,1.5\nright,1.4,2.2\n";
    write(folder.path(), "stances.csv", told);
    let line = "ground subject.osim walk.mot --soles soles.ron --filter 6Hz --stances stances.csv --json";
    let report = json(&succeeded(&solaris(folder.path(), line)));
    assert_eq!(report["ground"]["feet"][0]["stances_s"], serde_json::json!([[0.1, 0.9], [1.4, 2.2]]));
    assert_eq!(report["ground"]["feet"][1]["stances_s"], serde_json::json!([[0.8, 1.5]]));
    assert_eq!(report["ground"]["stances_from"], "the file of --stances");
    let line =
        "inverse subject.osim walk.mot --ground --soles soles.ron --filter 6Hz --stances stances.csv --json";
    let moments = json(&succeeded(&solaris(folder.path(), line)));
    assert_eq!(moments["ground"]["feet"], report["ground"]["feet"]);
    for (text, why) in [
        ("rihgt,0,1\n", "line 1: no sole is called 'rihgt', but right, left; did you mean 'right'?"),
        ("foot,from,to\nright,1\n", "line 2: it has 2 cells"),
        ("right,0,soon\n", "line 1: 'soon' is no time in s"),
        ("right,0,nan\n", "line 1: 'nan' is no time in s"),
        ("right,1,1\n", "line 1: the stance begins at 1 s and ends at 1 s"),
        ("right,0,1\nright,0.9,2\n", "line 2: right stands already from 0 to 1 s"),
        ("foot,from,to\n", "it has no stance"),
    ] {
        write(folder.path(), "stances.csv", text);
        let said = refused(&solaris(folder.path(), &line.replace(" --json", "")));
        assert!(said.contains("stances.csv: ") && said.contains(why), "{said}");
    }
    let needs = failed(&solaris(folder.path(), "inverse subject.osim walk.mot --stances stances.csv"), 2);
    assert!(needs.contains("--ground"), "{needs}");
}

/// Where no foot stands nothing can be made consistent; guessed soles have a breadth and can.
#[test]
fn consistency_needs_a_stance() {
    let folder = folder_with(&["clips/dancer.ron", "clips/dance.csv"]);
    write(folder.path(), "stances.csv", "feet,7,8\n");
    let line = "ground dancer.ron dance.csv --consistent --stances stances.csv";
    let said = refused(&solaris(folder.path(), line));
    assert!(said.contains("no foot stands in any frame"), "{said}");
}
