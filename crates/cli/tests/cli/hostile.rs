//! Files of others, which mean no good: what their names would do to a terminal.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Sets a window's title, clears the screen in eight bits, turns the direction of writing, has no width, goes back to the line's start.
const NAME: &str = "a\u{1b}]0;owned\u{7}\u{9b}2J\u{202e}b\u{200b}c\rd";

/// Runs the program as on a terminal with colours.
fn run(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command
        .current_dir(folder)
        .args(arguments)
        .env("CLICOLOR_FORCE", "1")
        .output()
        .expect("the program starts")
}

/// What was printed, without colours; panics where anything else is left that a terminal would obey.
fn seen(bytes: &[u8]) -> String {
    let text = String::from_utf8(bytes.to_vec()).expect("text");
    let mut pieces = text.split("\u{1b}[");
    let mut shown = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find(|c: char| !c.is_ascii_digit() && c != ';').unwrap_or(piece.len());
        assert!(piece[end..].starts_with('m'), "not a colour: {piece:?} in {text:?}");
        shown.push_str(&piece[end + 1..]);
    }
    let bad = |c: char| (c.is_control() && c != '\n') || "\u{202e}\u{200b}".contains(c);
    assert!(!shown.contains(bad), "it reaches the terminal: {shown:?}");
    shown
}

fn figure() -> String {
    let name = NAME.escape_unicode();
    format!(
        "Figure(version: 1, name: \"{name}\", links: [Link(name: \"{name}\", joint: Joint(name: \"{name}\", \
         axes: [rx(name: \"{name}\")]), mass: 1.0, com: (0.0, -0.5, 0.0))])"
    )
}

#[test]
fn names_command_no_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("figure.ron"), figure()).expect("written");
    fs::write(folder.path().join("table.csv"), format!("time,{NAME}.q\n0,0\n0.1,0.1\n")).expect("written");
    for arguments in [&["check", "figure.ron"][..], &["check", "--dh", "figure.ron"]] {
        let output = run(folder.path(), arguments);
        assert!(output.status.success(), "{arguments:?}: {}", seen(&output.stderr));
        let shown = seen(&output.stdout);
        assert!(shown.contains(r"a\u{1b}]0;owned\u{7}\u{9b}2J\u{202e}b\u{200b}c\u{d}d"), "{shown}");
    }
    // A column that the figure does not have, an option and a file that are not there.
    let refused: [&[&str]; 4] = [
        &["inverse", "figure.ron", "table.csv", "-o", "x.csv"],
        &["check", NAME],
        &["check", "figure.ron", &format!("--{NAME}")],
        &["walk", "--height", NAME],
    ];
    for arguments in refused {
        let output = run(folder.path(), arguments);
        assert!(!output.status.success(), "{arguments:?}");
        assert!(!seen(&output.stderr).is_empty());
        seen(&output.stdout);
    }
}

#[test]
fn faults_in_names_command_no_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    // As they stand, and in escapes; known to nobody, and standing twice.
    let twice = figure().replace("links: [", "links: [Link(name: \"x\", parent: \"\\u{1b}[2J\\u{202e}\"), ");
    let texts =
        [twice, format!("Figure(version: 1, name: \"{NAME}\", \u{202e}: 1)"), "Figure(\r\u{9b}2J".to_owned()];
    for text in texts {
        fs::write(folder.path().join("figure.ron"), &text).expect("written");
        let output = run(folder.path(), &["check", "figure.ron"]);
        assert_eq!(output.status.code(), Some(1), "{text:?}");
        assert!(seen(&output.stderr).contains("figure.ron"), "{text:?}");
    }
}

#[test]
fn json_keeps_names_and_commands_no_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("figure.ron"), figure()).expect("written");
    let output = run(folder.path(), &["check", "--json", "figure.ron"]);
    let shown = seen(&output.stdout);
    let json: serde_json::Value = serde_json::from_str(&shown).expect("JSON");
    assert_eq!(json["name"], NAME);
}
