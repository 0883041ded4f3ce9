//! What docs/drives.md and docs/ground.md quote is what their commands print and draw.
//!
//! `UPDATE_PICTURES=1 cargo test -p solaris-cli --test cli drives` draws the picture anew.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// What `solaris` prints in the project's folder.
fn solaris(words: &str) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_solaris"))
        .args(words.split_whitespace())
        .current_dir(root())
        .output()
        .expect("it runs");
    assert!(output.status.success(), "{words}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn the_pages_quote_what_is_printed() {
    for (page, count) in [("docs/drives.md", 3), ("docs/ground.md", 2)] {
        let page = fs::read_to_string(root().join(page)).expect(page);
        let mut quotes = 0;
        for part in page.split("<!-- output of `solaris ").skip(1) {
            let (command, rest) = part.split_once('`').expect("the end of a command");
            let quote =
                rest.split("```text\n").nth(1).and_then(|rest| rest.split("\n```").next()).expect("a block");
            let printed = solaris(command);
            assert!(printed.contains(quote), "`solaris {command}` does not print\n{quote}\nbut\n{printed}");
            quotes += 1;
        }
        assert_eq!(quotes, count);
    }
}

#[test]
fn the_picture_is_what_its_command_draws() {
    let folder = tempfile::tempdir().expect("a folder");
    let made = folder.path().join("literal.svg");
    solaris(&format!("run fixtures/scenes/literal.ron -o {}", made.display()));
    let (made, kept) = (fs::read_to_string(made).expect("a picture"), root().join("docs/drives/literal.svg"));
    if std::env::var_os("UPDATE_PICTURES").is_some() {
        fs::write(&kept, &made).expect("written");
    }
    assert!(fs::read_to_string(kept).unwrap_or_default() == made, "UPDATE_PICTURES=1 draws it anew");
}
