//! What cannot be done, though it can be understood: exit code 1, the file or option at fault, what to do, and no file
//! left.

use crate::inverse::{names, read, refused, solaris, subject, succeeded, write};
use std::path::Path;

/// Runs a line that must fail; its message must hold these words, and no file may appear.
fn refuses(folder: &Path, options: &str, words: &[&str]) {
    let before = names(folder);
    let said = refused(&solaris(folder, &format!("inverse {options} -o tau.csv -o tau.sto")));
    for word in words {
        assert!(said.contains(word), "{options}: '{word}' is not in: {said}");
    }
    assert!(said.starts_with("error: ") && !said.contains("panicked"), "{said}");
    assert_eq!(names(folder), before, "{options}");
}

/// The fixture's table of that name with its first rows only, and a header that says so.
fn cut(folder: &Path, from: &str, to: &str, rows: usize) {
    let text = read(&folder.join(from));
    let header = text.lines().position(|line| line == "endheader").expect("a header");
    let mut lines: Vec<String> = text.lines().take(header + 2 + rows).map(str::to_owned).collect();
    let count = lines.iter_mut().find(|line| line.starts_with("nRows=")).expect("their count");
    *count = format!("nRows={rows}");
    write(folder, to, &(lines.join("\n") + "\n"));
}

#[test]
fn filters_that_there_cannot_be() {
    let folder = subject();
    let run = |options: &str, words: &[&str]| refuses(folder.path(), options, words);
    run("subject.osim walk.mot --filter 31Hz", &["walk.mot: ", "31 Hz", "30 Hz"]);
    // Half of the samples a second is no cut-off either.
    run("subject.osim walk.mot --filter 30", &["30 Hz"]);
    cut(folder.path(), "walk.mot", "short.mot", 6);
    run("subject.osim short.mot --filter 6Hz", &["short.mot: ", "6 samples", "too few"]);
    run("subject.osim short.mot --filter 6Hz --filter-order 10", &["6 samples", "too few"]);
    // Samples at unequal times.
    let text = read(&folder.path().join("walk.mot")).replace("\n0.5\t", "\n0.505\t");
    write(folder.path(), "uneven.mot", &text);
    run("subject.osim uneven.mot --filter 6Hz", &["uneven.mot: ", "0.505"]);
}

#[test]
fn motions_without_what_is_needed() {
    let folder = subject();
    let run = |options: &str, words: &[&str]| refuses(folder.path(), options, words);
    cut(folder.path(), "walk.mot", "none.mot", 0);
    run("subject.osim none.mot", &["none.mot: ", "no rows"]);
    // All that is missing at once, with what is near.
    let text = read(&folder.path().join("walk.mot"));
    let renamed = text
        .replace("knee_angle_r", "knee_angel_r")
        .replace("pelvis_tx", "pelvis_x")
        .replace("lumbar_extension", "trunk");
    write(folder.path(), "renamed.mot", &renamed);
    run(
        "subject.osim renamed.mot",
        &["renamed.mot: ", "'knee_angle_r'", "knee_angel_r", "'pelvis_tx'", "'lumbar_extension'", "missing"],
    );
    run("subject.osim grf.mot", &["grf.mot: ", "'pelvis_tx'", "'ankle_angle_l'", "missing"]);
    // Times that do not rise.
    write(folder.path(), "back.mot", &text.replace("\n0.5\t", "\n0.4\t"));
    run("subject.osim back.mot", &["back.mot: line ", "0.4 s", "rise"]);
    // A cell that is no number.
    write(folder.path(), "cell.mot", &text.replacen("\n0.5\t", "\n0.5s\t", 1));
    run("subject.osim cell.mot", &["cell.mot: line ", "0.5s"]);
    write(folder.path(), "nan.mot", &text.replacen("\n0.5\t", "\nNaN\t", 1));
    run("subject.osim nan.mot", &["nan.mot: line ", "NaN"]);
    // Cut off in a row; after one it is read and said.
    let end = text.len() / 2 + text[text.len() / 2..].find('\n').expect("a row");
    write(folder.path(), "broken.mot", &text[..end - 20]);
    run("subject.osim broken.mot", &["broken.mot: line 150 ", "the header has 11"]);
    write(folder.path(), "broken.mot", &text[..end]);
    let printed = succeeded(&solaris(folder.path(), "inverse subject.osim broken.mot"));
    assert!(printed.contains("line 3: the header says 286 rows, there are 14"), "{printed}");
}

#[test]
fn forces_that_do_not_fit() {
    let folder = subject();
    let run = |options: &str, words: &[&str]| refuses(folder.path(), options, words);
    cut(folder.path(), "grf.mot", "brief.mot", 100);
    run(
        "subject.osim walk.mot --external brief.mot --plate calcn_r=",
        &["4.75 s", "'calcn_r'", "0.825 s", "cut the motion"],
    );
    run(
        "subject.osim walk.mot --external grf.mot --plate calcn=",
        &["no link and no frame 'calcn'", "did you mean 'calcn_"],
    );
    run("subject.osim walk.mot --external grf.mot --plate calcn_r+toes_r=", &["no frame 'toes_r'"]);
    run(
        "subject.osim walk.mot --external grf.mot --plate calcn_r=2_",
        &["grf.mot: line 7: ", "'2_'", "its prefixes are '', '1_'"],
    );
    // Two links, but nothing says where the one ends.
    run(
        "subject.osim walk.mot --external grf.mot --plate tibia_r+calcn_r=",
        &["'calcn_r'", "ball", "name one link"],
    );
    let text = read(&folder.path().join("grf.mot"));
    write(folder.path(), "lacks.mot", &text.replace("\tground_force_vy", "\tforce_up"));
    run(
        "subject.osim walk.mot --external lacks.mot --plate calcn_r=",
        &["lacks.mot: ", "'ground_force_vy'", "missing"],
    );
    run("subject.osim walk.mot --external none.mot --plate calcn_r=", &["none.mot: there is no such file"]);
}

#[test]
fn descriptions_of_loads_that_do_not_fit() {
    let folder = subject();
    let run = |options: &str, words: &[&str]| refuses(folder.path(), options, words);
    let text = read(&folder.path().join("loads.xml"));
    let with = |name: &str, from: &str, to: &str| write(folder.path(), name, &text.replace(from, to));
    with("link.xml", "<applied_to_body>calcn_r<", "<applied_to_body>calcnr<");
    run("subject.osim walk.mot --external-loads link.xml", &["'calcnr'", "did you mean 'calcn_r'?"]);
    with("data.xml", "<datafile>grf.mot<", "<datafile>plates.mot<");
    run("subject.osim walk.mot --external-loads data.xml", &["plates.mot: there is no such file"]);
    with("nodata.xml", "<datafile>grf.mot</datafile>", "");
    run("subject.osim walk.mot --external-loads nodata.xml", &["nodata.xml: ", "<datafile>"]);
    with("column.xml", "<force_identifier>1_ground", "<force_identifier>3_ground");
    run("subject.osim walk.mot --external-loads column.xml", &["3_ground_force_v"]);
    with("frame.xml", "<force_expressed_in_body>ground<", "<force_expressed_in_body>tibia_r<");
    run("subject.osim walk.mot --external-loads frame.xml", &["frame.xml", "tibia_r", "ground"]);
    run("subject.osim walk.mot --external-loads nothing.xml", &["nothing.xml: there is no such file"]);
}

#[test]
fn bases_that_there_cannot_be() {
    let folder = subject();
    let run = |options: &str, words: &[&str]| refuses(folder.path(), options, words);
    for base in ["free", "floating"] {
        run(
            &format!("subject.osim walk.mot --base {base}"),
            &["subject.osim: ", "'ground_pelvis'", "'pelvis'", "pelvis_tilt"],
        );
    }
}

#[test]
fn forces_that_push_nothing_are_said() {
    let folder = subject();
    let run = |options: &str| {
        succeeded(&solaris(folder.path(), &format!("inverse subject.osim walk.mot {options}")))
    };
    let one = run("--external grf.mot --plate calcn_r=");
    assert!(one.contains("not used: the forces of '1_'"), "{one}");
    let both = run("--external grf.mot --plate calcn_r= --plate calcn_l=1_");
    assert!(!both.contains("not used"), "{both}");
}

#[test]
fn the_same_plate_twice_is_no_force_twice() {
    let folder = subject();
    refuses(
        folder.path(),
        "subject.osim walk.mot --external grf.mot --plate calcn_r= --plate calcn_r=",
        &["--plate", "calcn_r="],
    );
}
