//! `--consistent`: what is reported of the change is what the files differ by, and the ground can do what is left.

use crate::inverse::ground::walked;
use crate::inverse::{
    FIXTURES, column, difference, failed, folder_with, json, largest, names, number, read, refused, solaris,
    subject, succeeded, table, write,
};
use solaris::io::{Table, csv};
use std::f64::consts::TAU;
use std::path::Path;

fn save(folder: &Path, name: &str, table: &Table) {
    let mut text = Vec::new();
    csv::write_table(table, &mut text).expect("written");
    write(folder, name, &String::from_utf8(text).expect("UTF-8"));
}

/// The walk's positions, with a root that trembles as clips do: by 8 mm up and down, and 6 mm across, six times a second.
fn trembling(walk: &Table) -> Table {
    let is_kept = |name: &str| name == "time" || name.strip_suffix(".q").is_some();
    let kept: Vec<usize> = (0..walk.columns.len()).filter(|&c| is_kept(&walk.columns[c])).collect();
    let columns: Vec<String> = kept.iter().map(|&c| walk.columns[c].clone()).collect();
    let place = |name: &str| columns.iter().position(|column| column == name).expect(name);
    let (up, across) = (place("root.ty.q"), place("root.tx.q"));
    let mut values = Vec::new();
    for row in 0..walk.len() {
        let (first, phase) = (values.len(), TAU * 6.0 * walk.row(row)[0]);
        values.extend(kept.iter().map(|&c| walk.row(row)[c]));
        values[first + up] += 0.008 * phase.sin();
        values[first + across] += 0.006 * phase.cos();
    }
    Table { columns, values, ..walk.clone() }
}

#[test]
fn what_is_reported_is_what_the_files_differ_by() {
    let folder = walked();
    let clip = trembling(&table(folder.path(), "walk.csv"));
    save(folder.path(), "clip.csv", &clip);
    let files = "--motion-out moved.csv --motion-out moved.mot --motion-out moved.bvh -o grf.csv";
    let line = format!("ground human.ron clip.csv --consistent --consistent-limit inf {files} --json");
    let report = json(&succeeded(&solaris(folder.path(), &line)));
    let at = |pointer: &str| number(&report, &format!("/ground/consistent/{pointer}"));
    assert_eq!(report["ground"]["consistent"]["outcome"], "reached");
    assert!(report["ground"]["consistent"]["limit_mm"].is_null());
    assert!(at("before/frames") > 20.0 && at("before/pull_n") > 10.0, "{:?}", report["ground"]["consistent"]);
    assert!(at("after/frames") == 0.0 && at("after/pull_n") == 0.0);

    let moved = table(folder.path(), "moved.csv");
    let time = column(&clip, "time");
    let mut squares = 0.0;
    for (k, axis) in ["root.tx.q", "root.ty.q", "root.tz.q"].iter().enumerate() {
        let way: Vec<f64> = column(&moved, axis)
            .iter()
            .zip(column(&clip, axis))
            .map(|(new, old)| (new - old) * 1e3)
            .collect();
        let rms = (way.iter().map(|mm| mm * mm).sum::<f64>() / way.len() as f64).sqrt();
        let greatest = (0..way.len()).max_by(|&a, &b| way[a].abs().total_cmp(&way[b].abs())).expect("frames");
        let said = |what: &str| at(&format!("axes/{k}/{what}"));
        assert!((said("rms_mm") - rms).abs() < 1e-9, "{axis}: {rms} mm");
        assert!((said("greatest/mm") - way[greatest]).abs() < 1e-9, "{axis}: {} mm", way[greatest]);
        assert!((said("greatest/at_s") - time[greatest]).abs() < 1e-12, "{axis}");
        squares += rms * rms;
    }
    assert!((at("rms_mm") - squares.sqrt()).abs() < 1e-9);
    assert!(at("rms_mm") > 1.0 && at("greatest/mm") < 50.0, "{} mm", at("greatest/mm"));
    let rest = clip.columns.iter().filter(|name| !name.starts_with("root.t"));
    rest.for_each(|name| assert!(column(&clip, name) == column(&moved, name), "{name} is not as it was"));

    // The forces are those of the moved motion: both feet together are never pulled.
    let grf = table(folder.path(), "grf.csv");
    let normal: Vec<f64> =
        column(&grf, "left_foot.fy").iter().zip(column(&grf, "right_foot.fy")).map(|(l, r)| l + r).collect();
    let least = normal.iter().copied().filter(|normal| *normal != 0.0).fold(f64::INFINITY, f64::min);
    assert!(least > 0.0099 * number(&report, "/ground/weight_n"), "{least} N");
    // The same positions in every format.
    let bare = table(folder.path(), "moved.mot");
    assert!(difference(&column(&bare, "root.tz"), &column(&moved, "root.tz.q")) == 0.0);
    let frames = format!("Frames: {}", clip.len());
    assert!(read(&folder.path().join("moved.bvh")).contains(&frames));
}

#[test]
fn what_was_moved_goes_on_as_it_was_reported() {
    let folder = folder_with(&["clips/dancer.ron", "clips/dance.csv"]);
    let line = "inverse dancer.ron dance.csv --ground --consistent --motion-out moved.csv -o one.csv --json";
    let report = json(&succeeded(&solaris(folder.path(), line)));
    assert!(number(&report, "/residual/force_greatest_n") < 1e-9);
    succeeded(&solaris(folder.path(), "inverse dancer.ron moved.csv --ground -o two.csv"));
    succeeded(&solaris(folder.path(), "inverse dancer.ron dance.csv --ground -o three.csv"));
    let [one, two, three] = ["one.csv", "two.csv", "three.csv"].map(|name| table(folder.path(), name).values);
    assert!(difference(&one, &two) < 1e-9 * largest(&one), "{:e}", difference(&one, &two));
    assert!(difference(&one, &three) > 1.0, "nothing was changed");
    // What is possible needs no change.
    let still = json(&succeeded(&solaris(folder.path(), "ground dancer.ron moved.csv --consistent --json")));
    assert!(number(&still, "/ground/consistent/greatest/mm") < 1e-2);
    assert!(number(&still, "/ground/consistent/before/frames") < 1.0);
    // A limit that does not suffice is told, with when and by how much.
    let line = "ground dancer.ron dance.csv --consistent --consistent-limit 0.01 --json";
    let short = json(&succeeded(&solaris(folder.path(), line)));
    let at = |pointer: &str| number(&short, &format!("/ground/consistent/{pointer}"));
    assert_eq!(short["ground"]["consistent"]["outcome"], "short");
    assert!((at("greatest/mm") - 10.0).abs() < 1e-9 && at("beyond_limit/mm") > 1.0);
    assert!(at("after/frames") > 0.0 && at("after/pull_n") < at("before/pull_n"));
    let warned = short["ground"]["warnings"].to_string();
    assert!(warned.contains("stopped at its limit") && warned.contains("at 1.06 s"), "{warned}");
}

#[test]
fn what_cannot_be_moved_is_refused_with_what_to_do_and_nothing_is_written() {
    let folder = subject();
    let run = |options: &str| {
        let line = format!(
            "ground subject.osim walk.mot --filter 6Hz --consistent --motion-out moved.csv {options}"
        );
        refused(&solaris(folder.path(), &line))
    };
    let said = run("--soles soles.ron");
    assert!(
        said.contains("subject.osim: --consistent moves the root along three axes")
            && said.contains("tx, ty and tz")
    );
    assert!(said.contains("joint 'ground_pelvis'"), "{said}");
    let soles = read(&Path::new(FIXTURES).join("subject/soles.ron"));
    write(folder.path(), "lines.ron", &soles.replace(", width: 0.095", ""));
    let said = run("--soles lines.ron");
    assert!(
        said.contains("lines.ron: --consistent")
            && said.contains("sole 'right' has no breadth; give it a width"),
        "{said}"
    );
    write(folder.path(), "thin.ron", &soles.replace("width: 0.095", "width: 0.008"));
    let said = run("--soles thin.ron");
    assert!(said.contains("thin.ron: --consistent keeps the centre of pressure 5 mm inside"), "{said}");
    for limit in ["0", "-0.01"] {
        let said = run(&format!("--soles soles.ron --consistent-limit {limit}"));
        assert!(said.contains(&format!("--consistent-limit {limit}: it must be more than 0 m")), "{said}");
    }
    assert!(!names(folder.path()).iter().any(|name| name.starts_with("moved")));
    for line in [
        "inverse subject.osim walk.mot --consistent",
        "inverse subject.osim walk.mot --ground --consistent-limit 0.1",
        "ground subject.osim walk.mot --motion-out moved.csv",
    ] {
        failed(&solaris(folder.path(), line), 2);
    }
}

#[test]
fn a_root_that_is_fixed_is_told_of_the_base() {
    let folder = folder_with(&["figures/arm.urdf"]);
    let row = |k: u32| format!("{},{},-0.3\n", 0.1 * f64::from(k), 0.01 * f64::from(k * k));
    let rows = (0..9).map(row).collect::<Vec<_>>().concat();
    write(folder.path(), "swing.csv", &format!("time,shoulder.q,elbow.q\n{rows}"));
    let sole = "Sole(name: \"hand\", foot: \"forearm\", heel: (0, 0, -0.5), ball: (0.1, 0, -0.5), tip: (0.2, 0, -0.5), width: 0.1)";
    write(folder.path(), "soles.ron", &format!("Soles(version: 1, soles: [{sole}])"));
    let line = "ground arm.urdf swing.csv --soles soles.ron --stance-height 9 --stance-speed 9 --consistent";
    let said = refused(&solaris(folder.path(), line));
    assert!(said.contains("--base floating or --base free lets it go"), "{said}");
}

#[test]
fn a_clip_with_a_gap_or_of_two_frames_is_refused() {
    let folder = folder_with(&["clips/dancer.ron", "clips/dance.csv"]);
    let text = read(&folder.path().join("dance.csv"));
    let lines: Vec<&str> = text.lines().collect();
    for (kept, why) in [
        (
            [&lines[..26], &lines[27..]].concat(),
            "gap.csv: frame 25, at 0.52 s, is not where equal frames have it",
        ),
        (lines[..3].to_vec(), "gap.csv: the motion has too few frames for accelerations: 2; give 3 or more"),
        (lines[..2].to_vec(), "gap.csv: the motion has too few frames for accelerations: 1; give 3 or more"),
    ] {
        write(folder.path(), "gap.csv", &(kept.join("\n") + "\n"));
        let said = refused(&solaris(folder.path(), "ground dancer.ron gap.csv --consistent"));
        assert!(said.contains(why), "{said}");
    }
}
