//! The commands of docs/profiles.md, docs/determinants.md, docs/scenes.md and of the pages of walks make their pictures, and every
//! kind of profile has one.
//!
//! `UPDATE_PICTURES=1 cargo test -p solaris-cli --test cli pictures` writes them anew.

use solaris::profiles::Profile;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The words of a command line, with quotes around those that have spaces.
fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    for (i, part) in line.split('"').enumerate() {
        if i % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    words
}

/// Runs `solaris` with these words in a folder.
fn run(words: &[String], folder: &Path) {
    let output = Command::new(env!("CARGO_BIN_EXE_solaris"))
        .args(words)
        .current_dir(folder)
        .output()
        .expect("it runs");
    assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
}

fn page(name: &str) -> (PathBuf, String) {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let text = fs::read_to_string(docs.join(name)).expect("the page");
    (docs, text)
}

/// Copies a folder with all that is in it.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder") {
        let path = entry.expect("an entry").path();
        let to = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy(&path, &to);
        } else {
            fs::copy(&path, to).expect("copied");
        }
    }
}

/// Makes the pictures of a page by its commands, which put them into `pictures`, and compares them with those kept there; the
/// words of the commands.
fn made_and_kept(page_name: &str, pictures: &str) -> Vec<Vec<String>> {
    let (docs, text) = page(page_name);
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join(pictures)).expect("a folder");
    copy(&docs.join("../fixtures/scenes"), &folder.path().join("fixtures/scenes"));
    let mut commands = Vec::new();
    for line in text.lines().filter(|line| line.contains(&format!(" -o {pictures}/"))) {
        let words = words(line.strip_prefix("solaris ").expect("a command"));
        let name = words.last().expect("the picture").clone();
        assert!(text.contains(&format!("![]({name})")), "{name} is not shown");
        run(&words, folder.path());
        let made = fs::read_to_string(folder.path().join(&name)).expect("the picture");
        let kept = docs.join(&name);
        if std::env::var_os("UPDATE_PICTURES").is_some() {
            fs::write(&kept, &made).expect("written");
        }
        let kept = fs::read_to_string(&kept).unwrap_or_default();
        assert!(made == kept, "docs/{name} is another picture; UPDATE_PICTURES=1 writes it anew");
        commands.push(words);
    }
    commands
}

#[test]
fn the_pictures_of_the_determinants_are_what_the_commands_make() {
    let commands = made_and_kept("determinants.md", "walking");
    for asked in ["explain", "map"] {
        assert!(commands.iter().any(|words| words[1] == asked), "gait {asked} has no picture");
    }
}

#[test]
fn the_film_strips_are_what_the_commands_make() {
    for (page, count) in
        [("walking.md", 8), ("manners.md", 3), ("slopes.md", 3), ("running.md", 4), ("chair.md", 1)]
    {
        assert_eq!(made_and_kept(page, "strips").len(), count, "{page}");
    }
}

#[test]
fn words_of_scenes_have_pictures() {
    assert_eq!(made_and_kept("scenes.md", "strips").len(), 35);
    assert_eq!(made_and_kept("benchmarks.md", "strips").len(), 1);
}

#[test]
fn the_pictures_of_the_page_are_what_its_commands_make() {
    let kinds: Vec<String> =
        made_and_kept("profiles.md", "profiles").into_iter().map(|words| words[1].clone()).collect();
    for kind in Profile::KINDS.iter().map(|kind| kind.name).chain(["blend"]) {
        assert!(kinds.iter().any(|shown| shown == kind), "{kind} has no picture");
    }
}

#[test]
fn the_other_commands_of_the_page_run() {
    let (_, text) = page("profiles.md");
    let folder = tempfile::tempdir().expect("a folder");
    let block = text.split("```ron\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a profile");
    fs::write(folder.path().join("mix.ron"), block).expect("written");
    run(&words("profile read mix.ron"), folder.path());
    let commands = text.lines().filter(|line| line.starts_with("solaris profile"));
    for line in commands.filter(|line| !line.contains(" -o profiles/")) {
        let line = line.split('#').next().expect("the command");
        run(&words(line.strip_prefix("solaris ").expect("a command")), folder.path());
    }
}
