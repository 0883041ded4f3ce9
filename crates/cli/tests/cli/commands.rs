//! The commands that pages show are run as they stand there, in one folder, with files of strangers made for them.

use crate::learn::{Reader, blocks};
use std::fs;

/// Runs the program's commands of a page, after others that make what the page takes for given; gives how many there were.
fn run(page: &str, given: &str) -> usize {
    let reader = Reader::new();
    let text = fs::read_to_string(crate::learn::root().join(page)).expect(page);
    reader.run(page, given);
    let mut count = 0;
    for (_, block) in blocks(&text).into_iter().filter(|(word, _)| *word == "sh") {
        // A crowd of a hundred is one of five here.
        let block = block.replace("\\\n", " ").replace("cargo run --release -- ", "solaris ");
        for line in block.replace("--count 100", "--count 5").lines() {
            let own = line.split('&').next().unwrap_or_default().trim_start();
            if own.starts_with("solaris ") && !own.starts_with("solaris studio") {
                reader.run(page, line);
                count += 1;
            }
        }
    }
    count
}

const STRANGERS: &str = "solaris walk --steps 3 --rate 30 -o dance.bvh
cp dance.bvh capture.bvh
solaris walk --steps 2 --height 1.4 --mass 38 --rig unreal -o hero.glb
solaris retarget dance.bvh --onto hero.glb --name run -o other.glb
cp other.glb clips.glb";

#[test]
fn of_the_first_page() {
    assert_eq!(run("README.md", STRANGERS), 13);
}

#[test]
fn of_animation() {
    assert_eq!(run("docs/animation.md", STRANGERS), 13);
}
