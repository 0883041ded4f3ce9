//! A person on force plates, in OpenSim's files: the measured one, and the project's own.

use crate::inverse::{
    PLATES, column, data, difference, json, largest, names, number, read, solaris, solaris_with, subject,
    succeeded, table, write,
};
use solaris::io::{Table, sto};

/// `solaris inverse` of the project's subject with these options.
fn inverse(options: &str) -> (tempfile::TempDir, String) {
    let folder = subject();
    let printed = succeeded(&solaris(folder.path(), &format!("inverse subject.osim walk.mot {options}")));
    (folder, printed)
}

#[test]
fn a_measured_walk_needs_the_moments_that_opensim_finds() {
    let files = [
        "gait10dof18musc_subject01.osim",
        "subject01_walk_ik_planar10.mot",
        "subject01_walk_grf.mot",
        "opensim46_id_planar10.sto",
    ];
    let [Some(model), Some(motion), Some(forces), Some(reference)] =
        files.map(|name| data(&format!("subject01_walk/{name}")))
    else {
        return;
    };
    let folder = tempfile::tempdir().expect("a folder");
    let [model, motion, forces] = [&model, &motion, &forces].map(|path| path.to_str().expect("UTF-8"));
    let line = "--plate calcn_r= --plate calcn_l=1_ --filter 6Hz --filter-order 3 -o m.sto";
    let mut args = vec!["inverse", model, motion, "--external", forces];
    args.extend(line.split(' '));
    succeeded(&solaris_with(folder.path(), &args));
    let (ours, theirs) = (table(folder.path(), "m.sto"), sto::read(&read(&reference)).expect("a table"));
    // One row a frame in both; OpenSim's times are half a microsecond early.
    let rows: Vec<usize> =
        (0..ours.len()).filter(|&row| (0.0999..=2.4001).contains(&ours.row(row)[0])).collect();
    assert_eq!((ours.len(), rows.len()), (theirs.len(), 139));
    for name in &theirs.columns[1..] {
        let [ours, theirs] = [&ours, &theirs].map(|table| column(table, name));
        let squares: f64 = rows.iter().map(|&row| (ours[row] - theirs[row]).powi(2)).sum();
        let rms = (squares / rows.len() as f64).sqrt();
        assert!(rms <= 0.02, "{name}: rms {rms} N m or N");
    }
    let mut columns = [&ours, &theirs].map(|table| table.columns.clone());
    columns[0].sort();
    columns[1].sort();
    assert_eq!(columns[0], columns[1]);
}

#[test]
fn plates_one_by_one_are_the_loads_of_one_file() {
    let (one, _) = inverse(&format!("{PLATES} --filter 6Hz -o tau.sto"));
    let (other, _) = inverse("--external-loads loads.xml --filter 6Hz -o tau.sto");
    assert_eq!(read(&one.path().join("tau.sto")), read(&other.path().join("tau.sto")));
    // Without the plates they are others.
    let (air, _) = inverse("--filter 6Hz -o tau.sto");
    let [one, air] =
        [one, air].map(|folder| column(&table(folder.path(), "tau.sto"), "ankle_angle_l_moment"));
    assert!(difference(&one, &air) > 50.0);
}

#[test]
fn loads_name_their_data_from_where_they_stand() {
    let (here, _) = inverse("--external-loads loads.xml -o tau.csv");
    let there = subject();
    std::fs::create_dir(there.path().join("trial")).expect("made");
    for name in ["loads.xml", "grf.mot"] {
        std::fs::rename(there.path().join(name), there.path().join("trial").join(name)).expect("moved");
    }
    let line = "inverse subject.osim walk.mot --external-loads trial/loads.xml -o tau.csv";
    succeeded(&solaris(there.path(), line));
    let [here, there] = [here, there].map(|folder| read(&folder.path().join("tau.csv")));
    assert!(here == there);
}

#[test]
fn both_formats_hold_the_same_numbers() {
    let (folder, printed) = inverse(&format!("{PLATES} --filter 6Hz -o tau.csv -o tau.sto"));
    let [ours, theirs] = ["tau.csv", "tau.sto"].map(|name| table(folder.path(), name));
    assert_eq!(ours.values, theirs.values, "bit for bit");
    assert_eq!((ours.len(), ours.columns.len()), (286, 11), "{:?}", ours.columns);
    for (ours, theirs) in ours.columns.iter().zip(&theirs.columns).skip(1) {
        let name = ours.strip_suffix(".tau").expect("our ending");
        let ending = if name.starts_with("pelvis_t") && name != "pelvis_tilt" { "force" } else { "moment" };
        assert_eq!(*theirs, format!("{name}_{ending}"));
    }
    for name in ["knee_angle_r_moment", "pelvis_tx_force", "lumbar_extension_moment"] {
        assert!(theirs.column(name).is_some(), "{name}");
    }
    // The header's units are not the motion's.
    assert_eq!(
        (theirs.in_degrees, theirs.title.as_str()),
        (Some(false), "Inverse Dynamics Generalized Forces")
    );
    assert!(printed.contains("wrote tau.csv") && printed.contains("wrote tau.sto"), "{printed}");
    assert_eq!(
        names(folder.path()),
        ["grf.mot", "loads.xml", "soles.ron", "subject.osim", "tau.csv", "tau.sto", "walk.mot"]
    );
}

#[test]
fn moments_are_those_of_a_walk() {
    let (folder, printed) = inverse(&format!("{PLATES} --filter 6Hz --filter-order 3 -o tau.csv --json"));
    let tau = table(folder.path(), "tau.csv");
    let largest_of = |name: &str| largest(&column(&tau, &format!("{name}.tau")));
    for side in ["l", "r"] {
        let [hip, knee, ankle] =
            ["hip_flexion", "knee_angle", "ankle_angle"].map(|joint| largest_of(&format!("{joint}_{side}")));
        assert!((60.0..150.0).contains(&ankle), "ankle {side}: {ankle} N m");
        assert!((20.0..130.0).contains(&knee), "knee {side}: {knee} N m");
        assert!((40.0..170.0).contains(&hip), "hip {side}: {hip} N m");
    }
    // Standing at first, all but the weight is carried by the plates.
    let (report, weight) = (json(&printed), 73.0 * 9.806_65);
    let vertical = column(&tau, "pelvis_ty.tau");
    assert!(largest(&vertical) < 0.06 * weight, "{} N", largest(&vertical));
    assert!(largest(&vertical[..5]) < 0.001 * weight, "{:?}", &vertical[..5]);
    assert!((number(&report, "/mass_kg") - 73.0).abs() < 1e-9);
    // What the summary says is what the table holds.
    let joints = report["joints"].as_array().expect("joints");
    assert_eq!(joints.len(), 10, "followers have no force of their own");
    for joint in joints {
        let values = column(&tau, &format!("{}.tau", joint["dof"].as_str().expect("a name")));
        assert!((number(joint, "/greatest").abs() - largest(&values)).abs() < 1e-12, "{joint}");
        let squares: f64 = values.iter().map(|value| value * value).sum();
        let rms = (squares / values.len() as f64).sqrt();
        assert!((number(joint, "/rms") - rms).abs() < 1e-9 * rms.max(1.0), "{joint}");
    }
}

/// The fixture's motion with its angles in radians.
fn in_radians(table: &Table) -> Table {
    let is_angle: Vec<bool> = table
        .columns
        .iter()
        .map(|name| !["time", "pelvis_tx", "pelvis_ty"].contains(&name.as_str()))
        .collect();
    let turn = |(i, value): (usize, &f64)| {
        if is_angle[i % is_angle.len()] { value.to_radians() } else { *value }
    };
    let values = table.values.iter().enumerate().map(turn).collect();
    Table { values, in_degrees: Some(false), ..table.clone() }
}

#[test]
fn degrees_and_radians_are_told_by_the_header() {
    let folder = subject();
    let motion = in_radians(&table(folder.path(), "walk.mot"));
    let mut text = Vec::new();
    sto::write(&motion, &mut text).expect("a table");
    write(folder.path(), "radians.sto", &String::from_utf8(text).expect("UTF-8"));
    let printed = ["walk.mot -o degrees.csv", "radians.sto -o radians.csv"]
        .map(|motion| succeeded(&solaris(folder.path(), &format!("inverse subject.osim {motion} {PLATES}"))));
    let [degrees, radians] = ["degrees.csv", "radians.csv"].map(|name| table(folder.path(), name));
    assert_eq!(degrees.values, radians.values);
    assert!(printed[0].contains("angles in degrees") && !printed[1].contains("degrees;"), "{printed:?}");
    assert!(!printed[1].contains("angles in degrees"), "{}", printed[1]);
}
