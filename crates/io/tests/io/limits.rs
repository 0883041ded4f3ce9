//! Limits of docs/limits.md: taken at the limit, refused by name one beyond.

use solaris_io::{csv, mjcf, opensim, sdf, urdf};

/// What an element in this many others is read as.
fn deep(depth: usize, head: &str, open: &str, close: &str, tail: &str) -> String {
    format!("{head}{}{}{tail}", open.repeat(depth), close.repeat(depth))
}

/// Panics unless the text for `most` says nothing with `word` in it, and that for one more does.
fn ends_at(most: usize, word: &str, said: impl Fn(usize) -> String) {
    let (at, beyond) = (said(most), said(most + 1));
    assert!(!at.contains(word), "at {most}: {at}");
    assert!(beyond.contains(word), "beyond {most}: {beyond}");
}

fn message<T, E: ToString>(read: Result<T, E>) -> String {
    read.err().map_or_else(String::new, |error| error.to_string())
}

#[test]
fn elements_stand_in_each_other_as_deep_as_the_limits_say() {
    // The root is one of them.
    let of_urdf = |depth| {
        message(urdf::read(&deep(depth - 1, "<robot name='r'><link name='a'/>", "<x>", "</x>", "</robot>")))
    };
    ends_at(1000, "deep", |depth| if depth < 2 { String::new() } else { of_urdf(depth) });
    let of_sdf = |depth| {
        let head = "<sdf version='1.9'><model name='m'><link name='a'/>";
        message(sdf::read(&deep(depth - 2, head, "<plugin>", "</plugin>", "</model></sdf>")))
    };
    ends_at(200, "deep", of_sdf);
    let of_opensim = |depth| {
        let head = "<OpenSimDocument Version='40000'><Model name='m'>";
        message(opensim::read(&deep(depth - 2, head, "<x>", "</x>", "</Model></OpenSimDocument>")))
    };
    ends_at(100, "deep", of_opensim);
}

/// All that is written of some numbers, one after the other.
fn listed(numbers: std::ops::Range<usize>, write: impl Fn(usize) -> String) -> String {
    numbers.map(write).collect::<Vec<_>>().concat()
}

#[test]
fn models_and_copies_are_nested_as_deep_as_the_limits_say() {
    let models = |depth: usize| {
        let open = listed(0..depth, |i| format!("<model name='m{i}'><link name='a'/>"));
        message(sdf::read(&format!("<sdf version='1.9'>{open}{}</sdf>", "</model>".repeat(depth))))
    };
    ends_at(50, "nested in each other", models);
    let copies = |depth: usize| {
        let (open, close) = ("<replicate count='1'>".repeat(depth), "</replicate>".repeat(depth));
        let body = "<body name='b'><joint/><geom size='.1'/></body>";
        message(mjcf::read(&format!("<mujoco><worldbody>{open}{body}{close}</worldbody></mujoco>")))
    };
    ends_at(100, "nested more than 100 deep", copies);
}

#[test]
fn attributes_and_namespaces_are_counted() {
    let attributes = |count: usize| {
        let all = listed(0..count, |i| format!(" a{i}='1'"));
        message(urdf::read(&format!("<robot{all}><link name='a'/></robot>")))
    };
    ends_at(4096, "more than 4096 attributes", attributes);
    let namespaces = |count: usize| {
        let all = listed(0..count, |i| format!("<x xmlns:n{i}='u'/>"));
        message(urdf::read(&format!("<robot name='r'><link name='a'/>{all}</robot>")))
    };
    ends_at(1000, "more than 1000 namespaces", namespaces);
}

#[test]
fn columns_of_a_table_are_counted() {
    let columns = |count: usize| {
        let more = listed(1..count, |i| format!(",{i}"));
        message(csv::read_table(&format!("time{more}\n")))
    };
    ends_at(1_000_000, "1000000", columns);
}
