//! `--against`: how far the found forces are from those of plates, and both in a picture.

use crate::inverse::{column, data, failed, json, number, refused, solaris, subject, succeeded, table};
use std::path::Path;

/// Files have six decimals.
fn same(found: f64, expected: f64, room: f64) {
    assert!((found - expected).abs() <= room, "{found} is not {expected}");
}

const FILES: &str = "ground subject.osim walk.mot --soles soles.ron --filter 6Hz --against grf.mot";

/// What is said is what the two files differ by, the measured forces linear between their samples.
#[test]
fn what_is_said_is_what_the_files_differ_by() {
    let folder = subject();
    let line = format!("{FILES} --plate right= --plate left=1_ -o found.mot --json");
    let report = json(&succeeded(&solaris(folder.path(), &line)));
    let (found, plates) = (table(folder.path(), "found.mot"), table(folder.path(), "grf.mot"));
    let (time, sampled) = (column(&found, "time"), column(&plates, "time"));
    let weight = number(&report, "/ground/weight_n");
    let at = |values: &[f64], t: f64| {
        let k = sampled.partition_point(|s| *s < t).clamp(1, sampled.len() - 1);
        let part = (t - sampled[k - 1]) / (sampled[k] - sampled[k - 1]);
        values[k - 1] + part * (values[k] - values[k - 1])
    };
    for (foot, (ours, theirs)) in [("right_", ""), ("left_", "1_")].into_iter().enumerate() {
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            let a = column(&found, &format!("{ours}ground_force_v{name}"));
            let b = column(&plates, &format!("{theirs}ground_force_v{name}"));
            let b: Vec<f64> = time.iter().map(|t| at(&b, *t)).collect();
            let n = a.len() as f64;
            let rms = (a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>() / n).sqrt();
            let said =
                |what: &str| number(&report, &format!("/ground/feet/{foot}/beside_plate/{what}/{axis}"));
            same(said("rms_n"), rms, 1e-5);
            same(said("rms_of_weight"), rms / weight, 1e-7);
            let mean = |x: &[f64]| x.iter().sum::<f64>() / n;
            let (ma, mb) = (mean(&a), mean(&b));
            let sum =
                |f: &dyn Fn(f64, f64) -> f64| a.iter().zip(&b).map(|(a, b)| f(a - ma, b - mb)).sum::<f64>();
            let r = sum(&|a, b| a * b) / (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt();
            same(said("r"), r, 1e-5);
        }
    }
    assert!(number(&report, "/ground/beside_plates/rms_of_weight/1") < 0.02);
    same(number(&report, "/ground/beside_plates/frames"), time.len() as f64, 0.0);
}

#[test]
fn a_picture_shows_each_foot_and_its_plate() {
    let folder = subject();
    let printed = succeeded(&solaris(folder.path(), &format!("{FILES} --plate left=1_ -o forces.svg")));
    assert_eq!(printed.matches("beside its plate").count(), 1, "{printed}");
    assert!(printed.contains("beside all plates"), "{printed}");
    let svg = std::fs::read_to_string(folder.path().join("forces.svg")).expect("the picture");
    for (text, count) in [
        ("along x (N)", 1),
        ("along z (N)", 1),
        (">right<", 1),
        (">left<", 1),
        (">left, plate<", 1),
        // In the legend and in each of the three panels, in the colour of its foot.
        ("<path class=\"thin s0\"", 4),
        ("<path class=\"line s0\"", 4),
        ("NaN", 0),
    ] {
        assert_eq!(svg.matches(text).count(), count, "{text}");
    }
    // Without plates nothing is held against anything.
    let alone = "ground subject.osim walk.mot --soles soles.ron --filter 6Hz -o alone.svg";
    let printed = succeeded(&solaris(folder.path(), alone));
    assert!(!printed.contains("plate"), "{printed}");
}

/// With the measured data at hand: the command of docs/ground.md makes its picture, and its numbers are those of the page.
/// `UPDATE_PICTURES=1` writes it anew.
#[test]
fn the_picture_of_the_page_is_what_its_command_makes() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let page = std::fs::read_to_string(docs.join("ground.md")).expect("the page").replace("\\\n", " ");
    let command = page.lines().find(|line| line.contains("-o ground/plates.svg")).expect("the command");
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("ground")).expect("a folder");
    let is_read = |word: &&str| Path::new(word).extension().is_some_and(|end| end == "mot" || end == "osim");
    for word in command.split_whitespace().filter(is_read) {
        let Some(from) = data(&format!("subject01_walk/{word}")) else { return };
        std::fs::copy(from, folder.path().join(word)).expect("copied");
    }
    let printed = succeeded(&solaris(folder.path(), command.strip_prefix("solaris ").expect("a command")));
    for said in ["off by 1.76, 7.9,", "off by 2.81, 5.89,", "off by 3.29, 3.35,"] {
        assert!(printed.contains(said), "{printed}");
    }
    let made = std::fs::read_to_string(folder.path().join("ground/plates.svg")).expect("the picture");
    let kept = docs.join("ground/plates.svg");
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        std::fs::write(&kept, &made).expect("written");
    }
    assert!(
        made == std::fs::read_to_string(&kept).unwrap_or_default(),
        "docs/ground/plates.svg is another picture"
    );
}

#[test]
fn plates_that_are_none_are_refused_by_name() {
    let folder = subject();
    for (options, said) in [
        ("--plate rigt=", "--plate rigt=: no sole has this name, but right, left; did you mean 'right'?"),
        ("--plate right= --plate right=1_", "this sole has a plate already"),
        ("--plate right=2_", "no force is called '2_'"),
    ] {
        let message = refused(&solaris(folder.path(), &format!("{FILES} {options}")));
        assert!(message.contains(said), "{options}: {message}");
    }
    let message = failed(&solaris(folder.path(), &format!("{FILES} --plate right")), 2);
    assert!(message.contains("it must be FOOT=PREFIX"), "{message}");
}
