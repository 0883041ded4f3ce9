//! Long and deep texts: bounded time and memory, no stack overflow.

use solaris_model::text::{read, write};
use std::fmt::Write as _;
use std::time::Instant;

/// A comb of `count` links: each hangs on the one before it, or on the root.
fn long(count: usize, fault: &str) -> String {
    let mut text = String::from(
        "Figure(version: 1, links: [Link(name: \"l0\", joint: Joint(name: \"j0\", axes: [rx]), mass: 1.0),\n",
    );
    for i in 1..count {
        let parent = if i % 10 == 0 { 0 } else { i - 1 };
        let _ = writeln!(
            text,
            "Link(name: \"l{i}\", parent: \"l{parent}\", joint: Joint(name: \"j{i}\", at: (0, -0.3, 0.01), \
             axes: [rz, ry, rx(limits: (deg(-90), deg(90)))]), mass: 1.5{fault}, com: (0.0, -0.1, 0.0), \
             inertia: (0.01, 0.02, 0.02)),"
        );
    }
    text.push_str("])");
    text
}

/// Seconds to read `text`, at best.
fn seconds(text: &str, times: usize) -> f64 {
    let once = |_| {
        let start = Instant::now();
        // What is compared is time alone; whether it is read right is asked elsewhere.
        let read = read(text).is_ok();
        start.elapsed().as_secs_f64() + if read { 0.0 } else { f64::INFINITY }
    };
    (0..times).map(once).fold(f64::INFINITY, f64::min)
}

/// Ten times the links take about ten times as long; in a reader that looks back at every link they take a hundred.
#[test]
fn time_grows_with_the_text() {
    // A busy machine may slow down either; a quadratic reader is slow each time.
    let (short, long) = (long(2_000, ""), long(20_000, ""));
    let ratios = (0..6).map(|_| seconds(&long, 1) / seconds(&short, 3));
    let best = ratios.fold(f64::INFINITY, f64::min);
    assert!(best < 40.0, "{best} times as long");
}

#[test]
#[ignore = "a hundred thousand links, some seconds: cargo xtask nightly"]
fn time_grows_with_a_very_long_text() {
    let (some, many) = (seconds(&long(10_000, ""), 3), seconds(&long(100_000, ""), 1));
    assert!(many < 40.0 * some, "{some} s and {many} s");
}

#[test]
fn a_long_figure_comes_back() {
    let figure = read(&long(5_000, "")).expect("a long figure");
    assert_eq!((figure.links().len(), figure.layout().nv()), (5_000, 14_998));
    assert!(read(&write(&figure)).expect("what was written") == figure);
}

fn count_faults(count: usize) {
    let error = read(&long(count / 5, "kg")).expect_err("a unit");
    assert_eq!((error.faults.len(), error.faults[0].place.line), (1, 2));
    let error = read(&long(count, ", weight: 2")).expect_err("unknown fields");
    assert_eq!((error.faults.len(), error.omitted), (100, count - 101));
}

#[test]
fn ten_thousand_faults_are_counted() {
    count_faults(10_000);
}

#[test]
#[ignore = "some seconds: cargo xtask nightly"]
fn a_hundred_thousand_faults_are_counted() {
    count_faults(100_000);
}

#[test]
fn more_than_can_be_held_is_refused() {
    let text = |inside: &str, count| format!("Figure(version: 1, links: [{}])", inside.repeat(count));
    let refused = |text: &str| read(text).expect_err("too many").to_string();
    assert!(refused(&text("Link(),", 1 + (1 << 17))).contains("more than 131072 links"));
    assert!(refused(&text("0,", 4_000_000)).contains("more than 4000000 values"));
}

#[test]
fn brackets_within_brackets_are_refused_and_not_followed() {
    for open in ["(", "[", "{", "Some(", "a(b: "] {
        let error =
            read(&format!("Figure(version: 1, links: {}", open.repeat(200_000))).expect_err("too deep");
        assert!(error.to_string().contains("more than 64 deep"), "{open}: {error}");
    }
    let comments = "/*".repeat(500_000);
    assert!(read(&comments).expect_err("never closed").to_string().contains("never closed"));
}
