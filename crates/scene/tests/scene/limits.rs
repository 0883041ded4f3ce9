//! Limits of docs/limits.md: taken at the limit, refused by name one beyond.

use solaris_model::Figure;
use solaris_scene::{Loader, NoFiles, read};

const PENDULUM: &str = r#"Figure(name: "f", links: [Link(name: "a", joint: Joint(name: "hinge", axes: [rx]), mass: 1, com: (0, -1, 0))])"#;

/// What is at fault in a scene of a pendulum with these fields.
fn said(fields: &str) -> String {
    let text = format!("Scene(version: 1, duration: 1, figures: {{\"f\": {PENDULUM}}}, {fields})");
    read(&text, &mut NoFiles).err().map_or_else(String::new, |error| error.to_string())
}

/// Panics unless the text for `most` has no fault, and that for one more has one with `word` in it.
fn ends_at(most: usize, word: &str, said: impl Fn(usize) -> String) {
    let (at, beyond) = (said(most), said(most + 1));
    assert!(at.is_empty(), "at {most}: {at}");
    assert!(beyond.contains(word), "beyond {most}: {beyond}");
}

#[test]
fn drives_of_a_degree_of_freedom_are_counted_with_all_their_repeats() {
    let one = |times: usize| said(&format!("drives: {{\"hinge\": Repeat(of: [Free], times: {times})}}"));
    ends_at(100_000, "a whole number from 1 to 100000", one);
    let two = |times: usize| {
        let first = "Repeat(of: [Free, Frozen], times: 30000)";
        said(&format!("drives: {{\"hinge\": [{first}, Repeat(of: [Free], times: {times})]}}"))
    };
    ends_at(40_000, "more than 100000 drives", two);
}

/// A scene of eighty bytes made 6.6 million drives of a person's joints, of 3.5 GB.
#[test]
fn drives_that_a_pattern_makes_of_a_repeat_are_counted_together() {
    let person = |times: usize| {
        let text = format!(
            "Scene(version: 1, duration: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73.0)}}, drives: {{\"*\": Repeat(of: [Free], times: {times})}})"
        );
        read(&text, &mut NoFiles).err().map_or_else(String::new, |error| error.to_string())
    };
    // 66 degrees of freedom: times + 65·(times − 1) of them are made.
    ends_at(300_065 / 66, "comes to more than 300000 drives in this scene", person);
}

#[test]
fn reaches_take_ten_minutes_at_most() {
    let one = |seconds: usize| {
        said(&format!(
            "drives: {{\"hinge\": Frozen}}, reaches: [Reach(tip: \"a\", at: (0, -1, 0), by: [\"hinge\"], to: (0, 0, 1), over: {seconds})]"
        ))
    };
    ends_at(600, "a reach takes 600 s at most", one);
}

/// Found by the fuzzer: nobody stands farther away than figures can be.
#[test]
fn who_stands_too_far_away_is_named() {
    let far = |figures: &str, places: &str| {
        crate::faults::faults(&format!("Scene(version: 1, figures: {{{figures}}}, duration: 1{places})"))
    };
    let crowd = far("\"c\": Crowd(count: 3, apart: 1e154)", "");
    assert!(
        crowd.contains("'c1' stands 5e153 m from the world's origin; it may be 5e8 m at most"),
        "{crowd}"
    );
    let two = "\"a\": Human(height: 1.7, mass: 60), \"b\": Human(height: 1.7, mass: 60)";
    let place = far(two, ", places: {\"b\": Place(at: (0, 0, 5.000001e8))}");
    assert!(place.contains("'b' stands 5.000001e8 m"), "{place}");
    let near = format!(
        "Scene(version: 1, figures: {{{two}}}, duration: 1, places: {{\"b\": Place(at: (0, 0, 5e8))}})"
    );
    assert!(solaris_scene::read(&near, &mut solaris_scene::NoFiles).is_ok());
}

#[test]
fn people_of_a_crowd_are_counted() {
    let crowd = |count: usize| {
        let text = format!("Scene(version: 1, duration: 1, figures: {{\"all\": Crowd(count: {count})}})");
        read(&text, &mut NoFiles).err().map_or_else(String::new, |error| error.to_string())
    };
    ends_at(200, "200", crowd);
}

/// Texts that say nothing.
struct Empty;

impl Loader for Empty {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("there is none".to_owned())
    }

    fn text(&mut self, _path: &str) -> Result<String, String> {
        Ok("Scene(version: 1)".to_owned())
    }
}

#[test]
fn texts_that_a_scene_includes_are_counted() {
    let included = |count: usize| {
        let names: Vec<String> = (0..count).map(|i| format!("\"{i}.ron\"")).collect();
        let names = names.join(", ");
        let text =
            format!("Scene(version: 1, duration: 1, include: [{names}], figures: {{\"f\": {PENDULUM}}})");
        read(&text, &mut Empty).err().map_or_else(String::new, |error| error.to_string())
    };
    ends_at(200, "a scene includes 200 texts at most", included);
}

/// A loader of texts of so many bytes.
struct Long(usize);

impl Loader for Long {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("there is none".to_owned())
    }

    fn text(&mut self, _path: &str) -> Result<String, String> {
        let scene = "Scene(version: 1)";
        Ok(" ".repeat(self.0 - scene.len()) + scene)
    }
}

/// Each used to be kept behind as many blanks as all before it were long: two hundred took gigabytes.
#[test]
fn texts_that_a_scene_includes_are_weighed_together() {
    let included = |bytes: usize| {
        let head = format!(
            "Scene(version: 1, duration: 1, include: [\"a.ron\", \"b.ron\"], figures: {{\"f\": {PENDULUM}}})"
        );
        let half = (bytes - head.len() - 2) / 2;
        read(&head, &mut Long(half)).err().map_or_else(String::new, |error| error.to_string())
    };
    let most = 16 << 20;
    assert!(included(most).is_empty(), "{}", included(most));
    assert!(
        included(most + 2).contains("the texts of a scene have 16777216 bytes at most"),
        "{}",
        included(most + 2)
    );
}
