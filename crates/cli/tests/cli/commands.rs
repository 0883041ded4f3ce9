//! The commands that pages show are run as they stand there, in one folder, with files of strangers made for them.

use crate::learn::{Reader, blocks};
use std::fs;

/// Whether a command can be run as it stands: it names no placeholder (`MODEL.osim`, `FIGURE`), no files of others that do not come
/// with the project, and no picture, which other tests make.
fn is_whole(line: &str) -> bool {
    let command = line.split('#').next().unwrap_or_default();
    let is_placeholder =
        |word: &str| word.chars().take_while(char::is_ascii_uppercase).count() >= 4 && !word.contains('=');
    let is_left_out = |part: &&str| command.contains(*part);
    !command.split_whitespace().any(is_placeholder)
        && !["gait10dof18musc", "static.c3d", " -o strips/"].iter().any(is_left_out)
}

/// Runs the program's commands of a page, after others that make what the page takes for given; gives how many there were.
fn run(page: &str, given: &str) -> usize {
    let reader = Reader::new();
    let text = fs::read_to_string(crate::learn::root().join(page)).expect(page);
    reader.run(page, given);
    let mut count = 0;
    for (_, block) in blocks(&text).into_iter().filter(|(word, _)| *word == "sh") {
        let block = block.replace("\\\n", " ").replace("cargo run --release -- ", "solaris ");
        for line in block.lines().filter(|line| is_whole(line)) {
            let own = line.split('&').next().unwrap_or_default().trim_start();
            if own.starts_with("solaris ") && !own.starts_with("solaris studio") {
                // A crowd of a hundred is one of five here.
                reader.run(page, &line.replace("--count 100", "--count 5"));
                count += 1;
            }
        }
    }
    count
}

/// The block of a page that begins so.
fn quoted(page: &str, head: &str) -> String {
    let text = fs::read_to_string(crate::learn::root().join(page)).expect(page);
    let mut all = blocks(&text).into_iter().map(|(_, block)| block);
    all.find(|block| block.starts_with(head)).expect(head)
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

/// Subjects, trials and recordings of the pages are those of `fixtures`.
const SUBJECT: &str = "cp fixtures/subject/* .
mkdir trials loads
cp walk.mot trials/one.mot
cp walk.mot trials/two.mot
cp grf.mot loads
cp loads.xml loads/one.xml
cp loads.xml loads/two.xml
cp fixtures/figures/arm.urdf robot.urdf
cp fixtures/clips/walk.c3d .
solaris walk --steps 3 --rate 30 -o dance.bvh";

#[test]
fn of_bodies() {
    assert_eq!(run("docs/bodies.md", SUBJECT), 15);
}

#[test]
fn of_the_ground() {
    assert_eq!(run("docs/ground.md", &[SUBJECT, "cp fixtures/clips/dance* ."].join("\n")), 3);
}

#[test]
fn of_markers() {
    let given = "cp fixtures/markers/static.trc .
cp fixtures/markers/leg.osim generic.osim
cp fixtures/markers/swing.trc walk.trc";
    assert_eq!(run("docs/markers.md", given), 2);
}

#[test]
fn of_walks() {
    let way = "printf 'x,z\n0,3\n1.5,5\n' > way.csv";
    assert_eq!(run("docs/walking.md", way), 2);
    assert_eq!(run("docs/running.md", ""), 5);
    assert_eq!(run("docs/chair.md", ""), 1);
    let ground = [("profile.csv", "z,height"), ("stones.csv", "x,z,height")]
        .map(|(file, head)| format!("cat > {file} <<'end'\n{}end\n", quoted("docs/slopes.md", head)))
        .concat();
    assert_eq!(run("docs/slopes.md", &ground), 4);
}

#[test]
fn of_manners() {
    let people = "printf 'name,height,mass\nann,1.65,58\nbob,1.8,80\n' > people.csv";
    assert_eq!(run("docs/manners.md", people), 2);
}

#[test]
fn of_trust() {
    assert_eq!(run("docs/trust.md", "cp fixtures/scenes/pendulum.ron scene.ron"), 2);
}
