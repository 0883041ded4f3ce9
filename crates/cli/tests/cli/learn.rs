//! The pages of docs/learn are walked as a reader does: every command in its turn, in one folder, and what they quote is what was printed.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The blocks of a page: the word behind the fence, and what stands between the fences.
fn blocks(page: &str) -> Vec<(&str, String)> {
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

/// Walks a page; gives how many commands and quotes it has.
fn walk(name: &str) -> [usize; 2] {
    let page = fs::read_to_string(root().join("docs/learn").join(name)).expect(name);
    let folder = tempfile::tempdir().expect("a folder");
    let fixtures = root().join("fixtures").canonicalize().expect("fixtures");
    std::os::unix::fs::symlink(fixtures, folder.path().join("fixtures")).expect("a link");
    let program = Path::new(env!("CARGO_BIN_EXE_solaris")).parent().expect("its folder");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").expect("a path"));
    let (mut printed, mut count) = (String::new(), [0; 2]);
    for (word, block) in blocks(&page) {
        match word {
            "sh" => {
                let output = Command::new("sh")
                    .args(["-e", "-c", &block])
                    .env("PATH", &path)
                    .current_dir(folder.path())
                    .output()
                    .expect("a shell");
                let told = [output.stdout, output.stderr].concat();
                let told = String::from_utf8(told).expect("text");
                assert!(output.status.success(), "{name}: {block}\n{told}");
                printed.push_str(&told);
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
