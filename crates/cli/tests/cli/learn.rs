//! The pages of docs/learn are walked as a reader does: every command in its turn, in one folder, and what they quote is what was printed.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The blocks of a page: the word behind the fence, and what stands between the fences.
pub(crate) fn blocks(page: &str) -> Vec<(&str, String)> {
    let mut found: Vec<(&str, String)> = Vec::new();
    let mut inside = false;
    for line in page.lines() {
        match line.strip_prefix("```") {
            Some(_) if inside => inside = false,
            Some(word) => {
                inside = true;
                found.push((word, String::new()));
            }
            None if inside => {
                let (_, block) = found.last_mut().expect("a block");
                block.push_str(line);
                block.push('\n');
            }
            None => {}
        }
    }
    found
}

/// Somebody who does what pages say, in a folder of their own.
pub(crate) struct Reader {
    folder: tempfile::TempDir,
    path: String,
}

impl Reader {
    pub(crate) fn new() -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let fixtures = root().join("fixtures").canonicalize().expect("fixtures");
        std::os::unix::fs::symlink(fixtures, folder.path().join("fixtures")).expect("a link");
        let program = Path::new(env!("CARGO_BIN_EXE_solaris")).parent().expect("its folder");
        let path = format!("{}:{}", program.display(), std::env::var("PATH").expect("a path"));
        Self { folder, path }
    }

    /// Runs commands of a page, which have to succeed; what they print.
    pub(crate) fn run(&self, page: &str, commands: &str) -> String {
        let mut shell = Command::new("sh");
        shell.args(["-e", "-c", commands]).env("PATH", &self.path).current_dir(self.folder.path());
        let output = shell.output().expect("a shell");
        let told = String::from_utf8([output.stdout, output.stderr].concat()).expect("text");
        assert!(output.status.success(), "{page}: {commands}\n{told}");
        told
    }
}

/// Walks a page; gives how many commands and quotes it has.
fn walk(name: &str) -> [usize; 2] {
    let page = fs::read_to_string(root().join("docs/learn").join(name)).expect(name);
    let reader = Reader::new();
    let (mut printed, mut count) = (String::new(), [0; 2]);
    for (word, block) in blocks(&page) {
        match word {
            "sh" => {
                printed.push_str(&reader.run(name, &block));
                count[0] += 1;
            }
            "text" => {
                for line in block.lines() {
                    assert!(
                        printed.contains(line),
                        "{name} quotes\n{line}\nbut what was printed is\n{printed}"
                    );
                }
                count[1] += 1;
            }
            _ => {}
        }
    }
    count
}

#[test]
fn an_animator_gets_there() {
    assert_eq!(walk("animator.md"), [9, 6]);
}

#[test]
fn a_game_developer_gets_there() {
    assert_eq!(walk("game.md"), [2, 1]);
}

#[test]
fn a_biomechanist_gets_there() {
    assert_eq!(walk("biomechanics.md"), [8, 10]);
}

#[test]
fn a_roboticist_gets_there() {
    assert_eq!(walk("robotics.md"), [5, 6]);
}
