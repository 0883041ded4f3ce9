//! How the commands treat their options, their outputs, and long files.

use crate::inverse::{
    PLATES, column, difference, failed, folder_with, json, names, number, read, refused, solaris, subject,
    succeeded, table, write,
};
use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

#[test]
fn options_that_cannot_be_understood() {
    let folder = subject();
    let before = names(folder.path());
    for (options, why) in [
        ("--external grf.mot --plate x", "LINK=PREFIX"),
        ("--external grf.mot --plate =1_", "one link"),
        ("--external grf.mot --plate a+b+c=", "one link"),
        ("--external grf.mot --plate calcn_r+=", "one link"),
        ("--plate calcn_r=", "--external"),
        ("--external grf.mot --plate calcn_r= --external-loads loads.xml", "cannot be used with"),
        ("--gravity 1,2", "three numbers"),
        ("--gravity 1,2,3,4", "three numbers"),
        ("--gravity down", "three numbers"),
        ("--gravity=0,nan,0", "three numbers"),
        ("--gravity=0,-inf,0", "three numbers"),
        ("--filter -3", "-3"),
        ("--filter=-3", "above zero"),
        ("--filter 0", "above zero"),
        ("--filter 6kHz", "such as 6Hz"),
        ("--filter inf", "above zero"),
        ("--filter 6 --filter-order 0", "0 is not in 1..=10"),
        ("--filter 6 --filter-order 11", "11 is not in 1..=10"),
        ("--filter 6 --filter-order 2.5", "2.5"),
        ("--filter-order 3", "--filter"),
        ("--base loose", "fixed, floating, free"),
        ("--passive perhaps", "on, off"),
        ("--ground --external grf.mot --plate calcn_r=", "cannot be used with"),
        ("--ground --external-loads loads.xml", "cannot be used with"),
        ("--soles soles.ron", "--ground"),
        ("--split pivot", "--ground"),
        ("--belt auto", "--ground"),
        ("--stance-height 0.02", "--ground"),
        ("--ground --split half", "transition, pivot, effort"),
        ("--ground --belt 0", "above zero"),
        ("--ground --belt -1.2", "above zero"),
        ("--ground --belt fast", "auto, or still"),
        ("--ground --stance-speed quick", "must be a number"),
        ("--fliter 6Hz", "--filter"),
    ] {
        let said =
            failed(&solaris(folder.path(), &format!("inverse subject.osim walk.mot -o x.csv {options}")), 2);
        assert!(said.starts_with("error: ") && said.contains(why), "{options}: {said}");
    }
    assert_eq!(names(folder.path()), before);
}

#[test]
fn plates_do_not_go_with_a_description_of_loads() {
    let folder = subject();
    let line = "inverse subject.osim walk.mot --external-loads loads.xml --plate calcn_r=";
    let said = failed(&solaris(folder.path(), line), 2);
    assert!(said.contains("--plate"), "{said}");
}

#[test]
fn a_frequency_may_have_its_unit() {
    let folder = subject();
    let tau = ["6", "6Hz", "6hz", "6.0Hz", "6e0"].map(|cutoff| {
        succeeded(&solaris(
            folder.path(),
            &format!("inverse subject.osim walk.mot --filter {cutoff} -o tau.csv"),
        ));
        read(&folder.path().join("tau.csv"))
    });
    assert!(tau.iter().all(|text| *text == tau[0]));
    // The order is 2 unless another is asked for.
    let order = |order: &str| {
        succeeded(&solaris(
            folder.path(),
            &format!("inverse subject.osim walk.mot --filter 6 {order} -o tau.csv"),
        ));
        read(&folder.path().join("tau.csv"))
    };
    assert!(order("--filter-order 2") == tau[0] && order("--filter-order 3") != tau[0]);
}

/// The elbow's torque of the arm that stretches forwards and rests, under a gravity.
fn elbow(folder: &Path, gravity: &str) -> f64 {
    let args = format!("inverse arm.urdf still.csv {gravity} -o tau.csv");
    succeeded(&solaris(folder, &args));
    column(&table(folder, "tau.csv"), "elbow.tau")[0]
}

#[test]
fn gravity_may_begin_with_a_minus() {
    let folder = folder_with(&["figures/arm.urdf"]);
    // Turned back by a quarter, the arm points forwards: along x.
    let quarter = -std::f64::consts::FRAC_PI_2;
    let heads = "shoulder.q,elbow.q,shoulder.v,elbow.v,shoulder.a,elbow.a";
    write(folder.path(), "still.csv", &format!("{heads}\n{quarter},0,0,0,0,0\n"));
    // The forearm's 1.2 kg, 0.2 m from the elbow, hang on it: a torque upwards, −y.
    let weight = |gravity: f64| -1.2 * 0.2 * gravity;
    for (option, gravity) in [
        ("", 9.806_65),
        ("--gravity 0,0,-9.81", 9.81),
        ("--gravity=0,0,-9.81", 9.81),
        ("--gravity -0.1,0,-9.8", 9.8),
        ("--gravity -1e-3,-2.0,-1.62", 1.62),
        ("--gravity 0,0,0", 0.0),
        ("--gravity 0,0,9.81", -9.81),
    ] {
        let found = elbow(folder.path(), option);
        assert!((found - weight(gravity)).abs() < 1e-12, "{option}: {found} N m");
    }
}

#[test]
fn floating_and_free_bases_carry_the_same_weight() {
    let folder = folder_with(&["figures/arm.urdf"]);
    let joints = "shoulder.q,elbow.q,shoulder.v,elbow.v,shoulder.a,elbow.a";
    let row = "0.3,-0.5,1,2,-3,4";
    let zeros = |count: usize| vec!["0"; count].join(",");
    let heads = |dofs: &str, ending: &str| {
        dofs.split(' ').map(|dof| format!("root.{dof}.{ending}")).collect::<Vec<_>>().join(",")
    };
    let turns = "tx ty tz rz ry rx";
    let floating = [heads(turns, "q"), heads(turns, "v"), heads(turns, "a")].join(",");
    write(folder.path(), "floating.csv", &format!("{joints},{floating}\n{row},{}\n", zeros(18)));
    let (place, moves) = ("px py pz qx qy qz qw", "vx vy vz wx wy wz");
    let free = [heads(place, "q"), heads(moves, "v"), heads(moves, "a")].join(",");
    write(folder.path(), "free.csv", &format!("{joints},{free}\n{row},{},1,{}\n", zeros(6), zeros(12)));
    write(folder.path(), "fixed.csv", &format!("{joints}\n{row}\n"));
    let torques = |base: &str| {
        let line = format!("inverse arm.urdf {base}.csv --base {base} -o tau.csv");
        succeeded(&solaris(folder.path(), &line));
        table(folder.path(), "tau.csv")
    };
    let [fixed, floating, free] = ["fixed", "floating", "free"].map(torques);
    for dof in ["shoulder.tau", "elbow.tau"] {
        let values = [&fixed, &floating, &free].map(|table| column(table, dof)[0]);
        assert!((values[0] - values[1]).abs() < 1e-12 && (values[0] - values[2]).abs() < 1e-12, "{values:?}");
    }
    let [slides, pushes] = [column(&floating, "root.tz.tau"), column(&free, "root.vz.tau")];
    assert!(slides[0] > 10.0 && difference(&slides, &pushes) < 1e-12, "{slides:?} {pushes:?}");
    assert_eq!((fixed.columns.len(), floating.columns.len(), free.columns.len()), (3, 9, 9));
}

#[test]
fn an_output_that_was_there_stays_when_it_cannot_be_done() {
    let folder = subject();
    write(folder.path(), "tau.csv", "old");
    let before = names(folder.path());
    for bad in ["--filter 31Hz", "--base free", "-o nowhere/tau.csv", "-o tau.txt", "-o ./tau.csv"] {
        refused(&solaris(
            folder.path(),
            &format!("inverse subject.osim walk.mot -o tau.csv -o tau.sto {bad}"),
        ));
        assert_eq!(
            (names(folder.path()), read(&folder.path().join("tau.csv"))),
            (before.clone(), "old".into())
        );
    }
    succeeded(&solaris(folder.path(), "inverse subject.osim walk.mot -o tau.csv -o tau.sto"));
    assert_eq!(names(folder.path()).len(), before.len() + 1);
    assert!(read(&folder.path().join("tau.csv")).starts_with("time,pelvis_tx.tau,"));
}

#[test]
fn what_is_read_is_not_written_over() {
    let folder = subject();
    std::fs::copy(folder.path().join("grf.mot"), folder.path().join("forces.sto")).expect("copied");
    for (line, input) in [
        ("subject.osim walk.mot -o walk.mot", "walk.mot"),
        ("subject.osim walk.mot -o ./walk.mot", "walk.mot"),
        ("subject.osim walk.mot --external forces.sto --plate calcn_r= -o forces.sto", "forces.sto"),
    ] {
        let before = read(&folder.path().join(input));
        let said = refused(&solaris(folder.path(), &format!("inverse {line}")));
        assert!(said.contains(input) && read(&folder.path().join(input)) == before, "{line}: {said}");
    }
}

#[test]
fn without_an_output_the_summary_is_all() {
    let folder = subject();
    let before = names(folder.path());
    let shown = succeeded(&solaris(folder.path(), &format!("inverse subject.osim walk.mot {PLATES}")));
    assert!(shown.contains("residual at the root") && !shown.contains("wrote"), "{shown}");
    assert!(shown.lines().all(|line| line.chars().count() <= 120), "{shown}");
    assert_eq!(names(folder.path()), before);
}

#[test]
fn limits_are_reported_and_not_enforced() {
    let folder = folder_with(&["figures/arm.urdf"]);
    write(
        folder.path(),
        "far.csv",
        "time,shoulder.q,elbow.q\n0,0,0.6\n0.1,0,0.6\n0.2,0,0.6\n0.3,0,0.6\n0.4,0,0.6\n0.5,0,0.6\n",
    );
    let report = json(&succeeded(&solaris(folder.path(), "inverse arm.urdf far.csv --json")));
    assert_eq!(report["outside_limits"].as_array().expect("a list").len(), 1);
    assert_eq!(report["outside_limits"][0]["dof"], "elbow");
    assert!((number(&report, "/outside_limits/0/by") - 0.5).abs() < 1e-12);
    // The torque is that of the pose outside: 0.6 rad of the forearm's weight.
    let torque = 1.2 * 0.2 * 9.806_65 * 0.6_f64.sin();
    assert!((number(&report, "/joints/1/greatest").abs() - torque).abs() < 1e-9, "{report}");
}

#[test]
fn many_rows_take_bounded_time() {
    let folder = folder_with(&["figures/arm.urdf"]);
    let rows = 100_000;
    let mut text = String::from("time,shoulder.q,elbow.q\n");
    for row in 0..rows {
        let t = row as f64 / 1000.0;
        writeln!(text, "{t},{},{}", t.sin(), -0.5 - (2.0 * t).cos()).expect("memory");
    }
    write(folder.path(), "long.csv", &text);
    let start = Instant::now();
    let shown = succeeded(&solaris(folder.path(), "inverse arm.urdf long.csv --filter 20Hz -o tau.csv"));
    // A second or two; what grew with the square of the rows would take hours.
    assert!(start.elapsed() < Duration::from_mins(1), "{:?}", start.elapsed());
    assert!(shown.contains("100000 rows"), "{shown}");
    assert_eq!(read(&folder.path().join("tau.csv")).lines().count(), rows + 1);
}

#[test]
fn every_example_of_the_help_runs() {
    let folder = folder_with(&[
        "subject/subject.osim",
        "subject/grf.mot",
        "subject/loads.xml",
        "subject/soles.ron",
        "figures/arm.urdf",
    ]);
    for (from, to) in [
        ("subject/walk.mot", "ik.mot"),
        ("subject/walk.mot", "walk.mot"),
        ("subject/grf.mot", "plates.mot"),
        ("figures/arm.urdf", "robot.urdf"),
        ("clips/walk.c3d", "walk.c3d"),
        ("clips/walk.c3d", "static.c3d"),
        ("markers/leg.osim", "generic.osim"),
        ("markers/static.trc", "static.trc"),
        ("markers/swing.trc", "walk.trc"),
        ("markers/swing.trc", "walk1.trc"),
        ("markers/swing.trc", "walk2.trc"),
        ("markers/ik.xml", "setup.xml"),
        ("markers/scale.xml", "Setup_Scale.xml"),
    ] {
        std::fs::copy(Path::new(crate::inverse::FIXTURES).join(from), folder.path().join(to))
            .expect("copied");
    }
    write(folder.path(), "trajectory.csv", "time,shoulder.q,elbow.q\n0,0,0\n1,0.1,0.2\n2,0.3,0\n3,0,0\n");
    let scene = Path::new(crate::inverse::FIXTURES).join("scenes/pendulum.ron");
    std::fs::copy(scene, folder.path().join("scene.ron")).expect("copied");
    succeeded(&solaris(folder.path(), "walk --steps 1 --rate 30 -o walk.csv -o dance.bvh"));
    std::fs::copy(folder.path().join("walk.csv"), folder.path().join("clip.csv")).expect("copied");
    // An animation is called as the motion that it was.
    succeeded(&solaris(folder.path(), "convert dance.bvh dancer.glb"));
    for name in ["trials", "loads"] {
        std::fs::create_dir(folder.path().join(name)).expect("made");
    }
    for (from, to) in [
        ("walk.mot", "trials/a.mot"),
        ("walk.mot", "trials/b.mot"),
        ("loads.xml", "loads/a.xml"),
        ("loads.xml", "loads/b.xml"),
        ("grf.mot", "loads/grf.mot"),
    ] {
        std::fs::copy(folder.path().join(from), folder.path().join(to)).expect("copied");
    }
    let mut run = 0;
    // The conversions late: one writes over the motion; and scaling last, which writes over the subject, to whom angles belong.
    for help in ["", "figure human", "check", "inverse", "ground", "convert", "scale", "ik"] {
        let help = succeeded(&solaris(folder.path(), &format!("{help} --help"))).replace("\\\n", " ");
        let examples = help.lines().filter_map(|line| line.strip_prefix("  solaris "));
        for example in examples.filter(|example| !example.starts_with("walk ")) {
            // As a shell would.
            let example = example.replace("trials/*.mot", "trials/a.mot trials/b.mot");
            succeeded(&solaris(folder.path(), &example));
            run += 1;
        }
    }
    assert!(run >= 20, "{run} examples");
}
