//! Loops: as many frames a second as are asked for, and no frame twice.

use super::{read, solaris, succeeded};

/// Frames, and the lines of a BVH file's motion.
fn bvh(text: &str) -> (f64, Vec<Vec<f64>>) {
    let (_, motion) = text.split_once("Frame Time: ").expect("a motion");
    let (time, rows) = motion.split_once('\n').expect("rows");
    let row = |line: &str| line.split_whitespace().map(|x| x.parse().expect("a number")).collect();
    (time.parse().expect("a time"), rows.lines().map(row).collect())
}

#[test]
fn a_loop_has_the_rate_that_is_asked_for_and_ends_before_it_begins_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["walk", "--loop", "in-place", "--rate", "30", "-o", "loop.bvh", "-o", "loop.csv"];
    let said = succeeded(&solaris(folder.path(), &args));
    let (time, rows) = bvh(&read(&folder.path().join("loop.bvh")));
    assert!((time - 1.0 / 30.0).abs() < 1e-15, "{time}");
    assert!(said.contains(&format!("{} frames, 30 a second", rows.len())), "{said}");
    // From the last frame to the first is as far as from any frame to the next, and never nothing.
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let steps: Vec<f64> = rows.windows(2).map(|two| apart(&two[0], &two[1])).collect();
    let back = apart(&rows[rows.len() - 1], &rows[0]);
    let (least, most) =
        (steps.iter().copied().fold(f64::MAX, f64::min), steps.iter().copied().fold(0.0, f64::max));
    assert!((0.5 * least..1.5 * most).contains(&back), "{back} beside {least} to {most}");
    let table = read(&folder.path().join("loop.csv"));
    assert_eq!(
        table.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())).count(),
        rows.len()
    );
}

/// The last frame is cut after the root has its track from the whole loop.
#[test]
fn the_root_of_a_loop_s_bones_goes_straight_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let args = ["walk", "--loop", "moving", "--rig", "unreal", "--rate", "60", "-o", "loop.bvh"];
    succeeded(&solaris(folder.path(), &args));
    let (_, rows) = bvh(&read(&folder.path().join("loop.bvh")));
    // To the left, up, ahead (cm); about three axes (°). Six digits are written.
    for two in rows.windows(2) {
        let steps: Vec<f64> = (0..6).map(|k| two[1][k] - two[0][k]).collect();
        let still = [0, 1, 3, 4, 5].map(|k| steps[k].abs()).into_iter().fold(0.0, f64::max);
        assert!(still < 1e-5 && (steps[2] - (rows[1][2] - rows[0][2])).abs() < 1e-5, "{steps:?}");
    }
}

#[test]
fn a_walk_has_the_rate_that_is_asked_for() {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), &["walk", "--steps", "2", "--rate", "30", "-o", "walk.bvh"]));
    let (time, _) = bvh(&read(&folder.path().join("walk.bvh")));
    assert!((time - 1.0 / 30.0).abs() < 1e-15, "{time}");
}
