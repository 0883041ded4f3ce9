//! What `solaris walk` writes goes back in: its figure, its motion, its forces.

use crate::inverse::{
    difference, folder_with, json, largest, number, read, refused, solaris, succeeded, table, write,
};
use std::path::Path;
use tempfile::TempDir;

/// The toes carry the force once the centre of pressure has passed the ball.
const FEET: &str =
    "--external walk.csv --plate left_foot+left_toes=left_foot --plate right_foot+right_toes=right_foot";

/// A short walk and the figure that walks it.
fn walked(person: &str) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    succeeded(&solaris(folder.path(), &format!("walk {person} --steps 3 --rate 60 -o walk.csv")));
    succeeded(&solaris(folder.path(), &format!("figure human {person} -o human.ron")));
    folder
}

/// What a column holds: `q`, `v`, `a`, `tau`, `fx` …; nothing for the time.
fn ending(column: &str) -> &str {
    column.rsplit_once('.').map_or("", |(_, ending)| ending)
}

/// The walk's own torques and those that `solaris inverse` finds, column by column.
fn both(folder: &Path, forces: &str) -> Vec<(String, Vec<f64>, Vec<f64>)> {
    succeeded(&solaris(folder, &format!("inverse human.ron walk.csv {forces} -o tau.csv")));
    let [walk, tau] = ["walk.csv", "tau.csv"].map(|name| table(folder, name));
    let torques = walk.columns.iter().enumerate().filter(|(_, name)| ending(name) == "tau");
    let pair = |(place, name): (usize, &String)| {
        let found = tau.column(name).expect(name);
        (name.clone(), walk.values_of(place).collect(), tau.values_of(found).collect())
    };
    torques.map(pair).collect()
}

fn gets_its_torques_back(person: &str) {
    let folder = walked(person);
    let columns = both(folder.path(), FEET);
    assert_eq!(columns.len(), 66, "the whole figure");
    let scale = columns.iter().map(|(_, walk, _)| largest(walk)).fold(0.0, f64::max);
    assert!(scale > 20.0, "{scale} N m");
    for (name, walk, found) in &columns {
        let off = difference(walk, found);
        assert!(off <= 1e-9 * scale, "{name}: {off:e} of {scale} N m");
    }
}

#[test]
fn a_walk_gets_its_torques_back() {
    gets_its_torques_back("--height 1.75 --mass 73");
}

#[test]
fn so_does_that_of_another_person() {
    gets_its_torques_back("--height 1.32 --mass 29.5");
}

#[test]
fn feet_without_toes_or_ground_do_not() {
    let folder = walked("--mass 73");
    let off = |forces: &str, column: &str| {
        let columns = both(folder.path(), forces);
        let (_, walk, found) = columns.iter().find(|(name, ..)| name == column).expect(column);
        difference(walk, found)
    };
    let rigid = "--external walk.csv --plate left_foot=left_foot --plate right_foot=right_foot";
    assert!(off(rigid, "left_toes.rx.tau") > 1.0, "the toes carry nothing");
    assert!(off(rigid, "left_ankle.rx.tau") < 1e-6, "above them nothing changes");
    assert!(off("", "left_ankle.rx.tau") > 50.0, "no ground");
}

#[test]
fn positions_alone_give_nearly_the_same() {
    // Velocities and accelerations of splines through the positions: not those of the plan, but close.
    let folder = walked("--mass 73");
    let walk = table(folder.path(), "walk.csv");
    let kept: Vec<usize> = (0..walk.columns.len())
        .filter(|&place| !["v", "a"].contains(&ending(&walk.columns[place])))
        .collect();
    let line = |words: Vec<String>| words.join(",") + "\n";
    let mut text = line(kept.iter().map(|&place| walk.columns[place].clone()).collect());
    for row in 0..walk.len() {
        text += &line(kept.iter().map(|&place| walk.row(row)[place].to_string()).collect());
    }
    let motion = folder.path().join("walk.csv");
    std::fs::remove_file(&motion).expect("removed");
    write(folder.path(), "walk.csv", &text);
    let columns = both(folder.path(), FEET);
    let (_, walk, found) = columns.iter().find(|(name, ..)| name == "left_knee.rx.tau").expect("a knee");
    let squares: f64 = walk.iter().zip(found).map(|(a, b)| (a - b).powi(2)).sum();
    let rms = (squares / walk.len() as f64).sqrt();
    assert!(rms > 1e-9 && rms < 0.05 * largest(walk), "rms {rms} N m of {}", largest(walk));
}

#[test]
fn a_figure_of_a_file_walks_as_the_person_it_was_made_of() {
    let person = "--height 1.62 --mass 55";
    let folder = walked(person);
    succeeded(&solaris(folder.path(), "walk --figure human.ron --steps 3 --rate 60 -o again.csv"));
    let [walk, again] = ["walk.csv", "again.csv"].map(|name| read(&folder.path().join(name)));
    assert!(walk == again, "not byte for byte");
    let printed = succeeded(&solaris(folder.path(), "walk --figure human.ron --steps 1 --json"));
    let report = json(&printed);
    for (pointer, value) in [("/person/height_m", 1.62), ("/person/mass_kg", 55.0)] {
        assert!((number(&report, pointer) - value).abs() < 1e-12, "{printed}");
    }
}

#[test]
fn a_figure_of_another_kind_cannot_walk() {
    let folder = folder_with(&["figures/arm.urdf"]);
    let said = refused(&solaris(folder.path(), "walk --figure arm.urdf -o walk.csv"));
    assert!(said.starts_with("error: arm.urdf: figure 'arm' cannot walk:\n  - "), "{said}");
    for lack in ["'pelvis'", "'left_toes'", "'left_hip.flexion'", "'pelvis.rotation'"] {
        assert!(said.contains(lack), "{lack}: {said}");
    }
    assert!(!folder.path().join("walk.csv").exists());
}

#[test]
fn a_figure_with_parts_missing_is_told_all_of_them() {
    let folder = walked("--mass 73");
    let human = read(&folder.path().join("human.ron"));
    // Of both toes the sole, of one knee the anatomical angle.
    let mut text = human.clone();
    for toes in ["left_toes", "right_toes"] {
        let from = text.find(&format!("name: \"{toes}\"")).expect("the toes");
        let sole = from + text[from..].find("sole: [").expect("their sole");
        let end = sole + text[sole..].find("],").expect("its end") + 2;
        text.replace_range(sole..end, "");
    }
    let angle = text.find("\"left_knee.flexion\"").expect("an angle");
    let end = angle + text[angle..].find('\n').expect("its end");
    text.replace_range(angle..end, "");
    write(folder.path(), "lame.ron", &text);
    succeeded(&solaris(folder.path(), "check lame.ron"));
    let said = refused(&solaris(folder.path(), "walk --figure lame.ron --steps 3 -o lame.csv"));
    for lack in ["left_toes", "right_toes", "'left_knee.flexion'"] {
        assert!(said.contains(lack), "{lack}: {said}");
    }
    assert!(
        !said.contains("right_knee") && said.lines().filter(|line| line.starts_with("  - ")).count() >= 2,
        "{said}"
    );
    assert!(!folder.path().join("lame.csv").exists());
}
