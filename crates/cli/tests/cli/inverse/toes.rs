//! Soles of a file: the toes bear the force past the ball.

use crate::inverse::ground::walked;
use crate::inverse::{
    column, difference, json, largest, number, read, solaris, subject, succeeded, table, write,
};
use solaris::io::sto;
use std::path::Path;

/// The figure's text without its soles.
fn bare(text: &str) -> String {
    let mut parts = text.split("            sole: [\n");
    let first = parts.next().expect("a figure").to_owned();
    parts.fold(first, |text, part| text + part.split_once("            ],\n").expect("the end of a sole").1)
}

#[test]
fn a_walk_on_soles_of_a_file_is_that_on_the_figures_own() {
    let folder = walked();
    let human = read(&folder.path().join("human.ron"));
    write(folder.path(), "bare.ron", &bare(&human));
    // The points as the figure has them.
    let point = |name: &str, link: &str| {
        let (_, link) = human.split_once(&format!("name: \"{link}\"")).expect("a link");
        let of = link.split(&format!("{name}(")).nth(1).expect("a point");
        format!("({})", of.split(')').next().expect("its end"))
    };
    let sole = |side: &str, toes: bool| {
        let (foot, tip) = (format!("{side}_foot"), format!("{side}_toes"));
        let [heel, ball, tip_at] = [point("Heel", &foot), point("Ball", &foot), point("ToeTip", &tip)];
        let toes = if toes { format!("toes: \"{tip}\", ") } else { String::new() };
        format!(
            "Sole(name: \"{side}\", foot: \"{foot}\", {toes}heel: {heel}, ball: {ball}, tip: {tip_at}, width: 0.09)"
        )
    };
    let soles = format!("Soles(version: 1, soles: [{}, {}])", sole("left", true), sole("right", true));
    write(folder.path(), "soles.ron", &soles);
    let own = "inverse human.ron walk.csv --ground -o own.csv --json";
    let told = "inverse bare.ron walk.csv --ground --soles soles.ron -o told.csv --json";
    let [_, report] = [own, told].map(|line| json(&succeeded(&solaris(folder.path(), line))));
    assert!(number(&report, "/residual/moment_greatest_nm") < 1e-8);
    let [own, told] = ["own.csv", "told.csv"].map(|name| table(folder.path(), name));
    assert_eq!(own.columns, told.columns);
    assert!(difference(&own.values, &told.values) < 1e-9 * largest(&own.values));
    let toes = own.columns.iter().find(|name| name.starts_with("left_toe") && name.ends_with("rx.tau"));
    let toes = largest(&column(&told, toes.unwrap_or_else(|| panic!("{:?}", own.columns))));
    assert!((1.0..60.0).contains(&toes), "{toes} N m");
}

/// The subject with toes of nearly no mass, on soles with toes and without: only the toes' joint knows the difference.
#[test]
fn toes_bear_the_force_and_the_whole_stays() {
    let folder = subject();
    succeeded(&solaris(folder.path(), "convert subject.osim subject.ron"));
    let mut figure = read(&folder.path().join("subject.ron"));
    let end = figure.rfind("    ],\n").expect("the end of the links");
    let toes = |side: &str| {
        format!(
            "        Link(name: \"toes_{side}\", parent: \"calcn_{side}\", mass: 1e-6, \
             joint: Joint(name: \"mtp_{side}\", at: (0.1407, -0.06, 0), axes: [rz])),\n"
        )
    };
    figure.insert_str(end, &(toes("r") + &toes("l")));
    write(folder.path(), "subject.ron", &figure);
    let mut walk = table(folder.path(), "walk.mot");
    let width = walk.columns.len();
    walk.columns.extend(["mtp_r".to_owned(), "mtp_l".to_owned()]);
    walk.values = walk.values.chunks(width).flat_map(|row| row.iter().copied().chain([0.0, 0.0])).collect();
    let mut text = Vec::new();
    sto::write(&walk, &mut text).expect("written");
    write(folder.path(), "walk.mot", &String::from_utf8(text).expect("UTF-8"));
    let flat = read(&folder.path().join("soles.ron"));
    let hinged = ["r", "l"].iter().fold(flat, |text, side| {
        text.replace(&format!("\"calcn_{side}\""), &format!("\"calcn_{side}\", toes: \"toes_{side}\""))
    });
    write(
        folder.path(),
        "hinged.ron",
        &hinged.replace("tip: (0.2111, -0.0784, 0)", "tip: (0.0704, -0.0184, 0)"),
    );
    let run = |soles: &str, out: &str| {
        let line =
            format!("inverse subject.ron walk.mot --ground --soles {soles} --filter 6Hz -o {out} --json");
        json(&succeeded(&solaris(folder.path(), &line)))
    };
    let [one, other] = [run("soles.ron", "foot.csv"), run("hinged.ron", "toes.csv")];
    for what in ["/residual/force_greatest_n", "/residual/moment_greatest_nm"] {
        assert!((number(&one, what) - number(&other, what)).abs() < 1e-9, "{what}");
    }
    assert_eq!(other["ground"]["feet"][0]["toes"], "toes_r");
    assert_no_other_joint_knows(folder.path());
}

fn assert_no_other_joint_knows(folder: &Path) {
    let [foot, toes] = ["foot.csv", "toes.csv"].map(|name| table(folder, name));
    assert_eq!(foot.columns, toes.columns);
    for name in foot.columns.iter().filter(|name| name.strip_suffix(".tau").is_some()) {
        let [foot, toes] = [&foot, &toes].map(|table| column(table, name));
        if name.starts_with("mtp") {
            assert!(largest(&foot) < 1e-4, "{name}: without toes {} N m", largest(&foot));
            assert!((5.0..60.0).contains(&largest(&toes)), "{name}: {} N m", largest(&toes));
            // Only past the ball: not all the time that the foot stands.
            let bears = toes.iter().filter(|tau| **tau != 0.0).count();
            assert!(bears > 20 && bears < toes.len() / 2, "{name}: {bears} of {} frames", toes.len());
        } else {
            assert!(difference(&foot, &toes) < 1e-9, "{name}: {:e} N m", difference(&foot, &toes));
        }
    }
}
