//! What may stand at a place of a scene: held against what stands in the fixtures, and against texts that are broken anywhere.

use crate::fixtures::{Beside, folder};
use proptest::prelude::*;
use solaris_model::text::{Content, Node, Value, parse};
use solaris_scene::{Completions, NoFiles, complete};
use std::sync::OnceLock;

/// The texts of all fixtures, by name.
fn fixtures() -> &'static [(String, String)] {
    static TEXTS: OnceLock<Vec<(String, String)>> = OnceLock::new();
    TEXTS.get_or_init(|| {
        let entries =
            std::fs::read_dir(folder()).expect("the fixtures").map(|entry| entry.expect("an entry").path());
        let mut texts: Vec<(String, String)> = entries
            .filter(|path| path.extension().is_some_and(|extension| extension == "ron"))
            .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).expect("a text")))
            .collect();
        texts.sort();
        texts
    })
}

/// What is offered where `|` stands.
fn at(text: &str) -> Completions {
    let offset = text.find('|').expect("a place");
    complete(&text.replacen('|', "", 1), offset, &mut NoFiles)
}

fn labels(found: &Completions) -> Vec<&str> {
    found.items.iter().map(|item| item.label.as_str()).collect()
}

/// Fields, and words that are no numbers, each with its first byte.
fn words<'a>(node: &Node<'a>, found: &mut Vec<(&'a str, usize)>) {
    if let Some(head) = node.head().filter(|head| !["deg", "Some", "None"].contains(&head.name)) {
        found.push((head.name, head.span.start));
    }
    let Value::Group(group) = &node.value else { return };
    match &group.content {
        Content::Fields(fields) => {
            for (named, value) in fields {
                found.push((named.name, named.span.start));
                words(value, found);
            }
        }
        Content::Tuple(items) | Content::List(items) => items.iter().for_each(|item| words(item, found)),
        Content::Map(entries) => entries.iter().for_each(|(_, value)| words(value, found)),
    }
}

#[test]
fn every_word_of_the_fixtures_is_offered_at_its_place() {
    let mut count = 0;
    for (name, text) in fixtures() {
        let tree = parse(text, "scene", "Scene(version: 1)").expect("a fixture");
        let mut found = Vec::new();
        words(&tree, &mut found);
        // Long fixtures say the same again and again.
        let step = found.len().div_ceil(60);
        for (word, start) in found.into_iter().step_by(step) {
            let offered = complete(text, start + 1, &mut Beside);
            assert_eq!(&text[offered.from..offered.to], word, "{name}");
            assert!(labels(&offered).contains(&word), "{name}: '{word}' at {start}: {offered:?}");
            count += 1;
        }
    }
    assert!(count > 500, "{count}");
}

#[test]
fn fields_are_those_of_the_thing_around_that_are_not_there_yet() {
    let found = at(
        "Scene(version: 1, figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"left_elbow\": Servo(to: 1, da| stiffness: 2)})",
    );
    assert_eq!(labels(&found), ["along", "damping", "limit", "until"]);
    assert!(found.items.iter().all(|item| item.detail == "field of Servo"));
    assert_eq!(found.items[1].insert, "damping: ");
    let scene = at("Scene(version: 1, | figures: {}, duration: 2)");
    assert!(labels(&scene).contains(&"drives") && !labels(&scene).contains(&"duration"), "{scene:?}");
    let walk = at("Scene(version: 1, figures: {\"a\": Human(height: 1.75, mass: 73)}, walk: Walk(ste|");
    assert!(labels(&walk).contains(&"step_frequency"), "{walk:?}");
    assert!(labels(&at("Scene(ground: Slope(|")).contains(&"rise"));
    // A colon that stands there is not written again.
    assert!(at("Scene(version: 1, dur|: 2)").items.iter().any(|item| item.insert == "duration"));
}

#[test]
fn words_are_kinds_of_what_stands_there() {
    for (text, expected) in [
        ("|", "Scene"),
        ("Scene(figures: {\"a\": |", "Human"),
        ("Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"neck\": [Frozen, |]})", "Servo"),
        (
            "Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"left_knee\": Kinematic(along: |",
            "MinimumJerk",
        ),
        (
            "Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"left_knee\": Kinematic(|",
            "along",
        ),
        ("Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"left_knee\": |", "MinimumJerk"),
        ("Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, ground: |\n, duration: 2)", "Flat"),
        ("Scene(method: R|, duration: 2)", "RungeKutta4"),
        (
            "Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"left_knee\": Move(to: 1, over: 2, by: |",
            "Cubic",
        ),
        ("Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, limits: |)", "Hard"),
    ] {
        assert!(labels(&at(text)).contains(&expected), "{text}: {:?}", at(text));
    }
}

#[test]
fn names_are_those_of_the_scenes_own_figures() {
    let one = at("Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {|");
    let knee = one.items.iter().find(|item| item.label == "left_knee.rx").expect("a knee");
    assert_eq!((&*knee.insert, &*knee.detail), ("\"left_knee.rx\": ", "degree of freedom"));
    assert!(one.items.iter().any(|item| item.label == "left_hip" && item.detail == "joint"));
    // Of several each begins with its figure.
    let two = at(
        "Scene(figures: {\"ann\": Human(height: 1.75, mass: 73), \"bob\": Human(height: 1.75, mass: 73)}, drives: {\"bob.left|\": Frozen})",
    );
    let knee = two.items.iter().find(|item| item.label == "bob.left_knee.rx").expect("a knee");
    assert_eq!(knee.insert, "bob.left_knee.rx");
    assert!(!labels(&two).contains(&"left_knee.rx"));
    let beside = at(
        "Scene(figures: {\"ann\": Human(height: 1.75, mass: 73), \"bob\": Human(height: 1.75, mass: 73)}, places: {\"bob\": (beside: |)})",
    );
    assert_eq!(labels(&beside), ["ann", "bob"]);
    let link = at(
        "Scene(figures: {\"a\": Human(height: 1.75, mass: 73)}, pushes: [Push(link: \"|\", force: (0, 0, 1))])",
    );
    assert!(labels(&link).contains(&"left_foot"), "{link:?}");
}

#[test]
fn what_is_broken_elsewhere_does_not_matter() {
    let found = at(
        "Scene(version: 1, rate: , figures: {\"a\": Human(height: 1.75, mass: 73)}, drives: {\"neck\": Servo(to: 5°, st| \"left_knee\": \n}",
    );
    assert!(labels(&found).contains(&"stiffness"), "{found:?}");
    for text in ["Scene(rate: 1|)", "Scene( // a dr|\n)", "Scene(rate: 1.5 |)", "Scene(rate: -|"] {
        assert_eq!(labels(&at(text)), Vec::<&str>::new(), "{text}");
    }
}

#[test]
fn what_faults_suggest_mends_the_text() {
    let text = "Scene(version: 1, figures: {
        \"ann\": Human(height: 1.75, mas: 73),
        \"box\": Figure(links: [Link(name: \"base\", joint: Joint(name: \"rail\", axes: [tx]), mass: 1), Link(name: \"flap\", parent: \"bas\", joint: Joint(name: \"hinge\", axes: [rx]), mass: 1)]),
    },
    places: {bxo: (beside: \"an\")},
    drives: {\"ann.left_kne\": Frozn, \"box.hinge\": Kinematic(MinimumJrk(from: 0, to: 1, duration: 1))},
    pushes: [Push(link: \"box.flp\", force: (0, 0, 1), from: 0, over: 1)],
    duration: 1)";
    let mut mended = text.to_owned();
    let mut rounds = 0;
    // A figure that cannot be used hides what is wrong with its names.
    while let Err(error) = solaris_scene::read(&mended, &mut NoFiles) {
        let mut found: Vec<_> =
            error.faults.iter().filter_map(solaris_model::text::TextFault::suggestion).collect();
        found.sort_by_key(|suggestion| std::cmp::Reverse(suggestion.span.start));
        rounds += 1;
        assert!(!found.is_empty() && rounds < 6, "{error}\n{mended}");
        for suggestion in found {
            mended.replace_range(suggestion.span, &suggestion.replacement);
        }
    }
    assert!(
        mended.contains("parent: \"base\"") && mended.contains("{\"box\": (beside: \"ann\")}"),
        "{mended}"
    );
    assert!(mended.contains("\"ann.left_knee\": Frozen") && mended.contains("MinimumJerk"), "{mended}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn no_place_of_no_text_is_too_much(
        which in any::<prop::sample::Index>(),
        place in any::<prop::sample::Index>(),
        cut in any::<prop::sample::Index>(),
        hole in 0_usize..12,
    ) {
        let (_, text) = which.get(fixtures());
        let place = place.index(text.len() + 2);
        let whole = complete(text, place, &mut NoFiles);
        prop_assert!(text.get(whole.from..whole.to).is_some());
        // The same with a hole in it, and cut off.
        let broken: String = text.chars().enumerate().filter(|(i, _)| !(place..place + hole).contains(i)).map(|(_, c)| c).collect();
        let short: String = broken.chars().take(cut.index(text.len() + 1)).collect();
        for text in [&broken, &short] {
            let found = complete(text, place, &mut NoFiles);
            prop_assert!(text.get(found.from..found.to).is_some());
        }
    }
}
