//! What is wrong with the words that lead, repeat, push, carry and reach, each with its place.

use crate::faults::{faults, listed, person};
use std::fmt::Write;

#[test]
fn of_pushes() {
    let text = listed(&[
        "pushes: Push(link: \"tip\", force: (1, 0, 0))",
        "pushes: [Push(force: (1, 0, 0))]",
        "pushes: [Push(link: \"tipp\", force: (1, 0, 0))]",
        "pushes: [Push(link: \"tip\")]",
        "pushes: [Push(link: \"tip\", force: (1, 0, 0), impulse: (1, 0, 0))]",
        "pushes: [Push(link: \"tip\", force: 3)]",
        "pushes: [Push(link: \"tip\", force: (1, 0, 0), over: -1)]",
        "pushes: [Push(link: \"tip\", force: (1, 0, 0), form: 1)]",
        "pushes: [Push(link: \"tip\", impulse: (1, 0, 0), along: Line(from: 0, to: 1, duration: 1))]",
        "pushes: [Push(link: \"tip\", force: (1, 0, 0), over: 1, along: Line(from: 0, to: 1, duration: 1))]",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_carries() {
    let mut text = listed(&[
        "carries: [Carry(in: \"tip\")]",
        "carries: [Carry(mass: 1)]",
        "carries: [Carry(mass: 1, in: \"tipp\")]",
        "carries: [Carry(mass: -1, in: \"tip\")]",
        "carries: [Carry(mass: 1, in: \"tip\", inertia: (1, 1, 3))]",
        "carries: [Carry(mass: 1, in: \"tip\", from: 2, until: 1)]",
        "carries: [Carry(mass: 1, in: \"tip\", form: 2)]",
        "carries: [Carry(mass: -1, in: \"tip\", from: 2)]",
    ]);
    let case =
        "walk: Walk(steps: 2, step_frequency: 110), carries: [Carry(mass: 1, in: \"left_hand\", from: 1)]";
    let _ = write!(text, "{case}\n{}\n", faults(&person(case)));
    insta::assert_snapshot!(text);
}

#[test]
fn of_sequences() {
    let text = listed(&[
        "sequence: Together({})",
        "sequence: [Togther({})]",
        "sequence: [Together([])]",
        "sequence: [Together({\"elbo.rx\": Free})]",
        "sequence: [Together({\"elbow.rx\": Move(to: 1)})]",
        "sequence: [Together({\"elbow.rx\": Move(to: 1, over: -1)})]",
        "sequence: [Together({\"elbow.rx\": Repeat([Move(to: 1, over: 1)])})]",
        "sequence: [Together({\"elbow.rx\": Free}), Together({\"elbow.rx\": Move(to: 1, over: 1)})]",
        "sequence: [Wait]",
        "sequence: [Wait(-1)]",
        "sequence: [When(Done)]",
        "sequence: [When(Passes(\"elbow.ry\", \"x\"))]",
        "drives: {\"elbow.rx\": Free}, sequence: [Together({\"elbow\": Move(to: 1, over: 1)})]",
        "drives: {\"elbow.rx\": When(Passes(\"elbow.rz\", 1))}",
        "drives: {\"elbow.rx\": When}",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_several_figures() {
    let scene = |fields: &str| {
        format!(
            "Scene(version: 1, duration: 1, figures: {{\"ann\": Human(height: 1.75, mass: 73), \"bob\": Human(height: 1.6, mass: 60)}},\n{fields})"
        )
    };
    let mut text = String::new();
    for case in [
        "drives: {\"bob.*\": Frozen, \"ann.left_knee.rx\": Free}, places: {\"bob\": (at: (0, 0, 1), facing: deg(180))}",
        "drives: {\"left_knee.rx\": Free}",
        "places: {\"bib\": (at: (0, 0, 1))}",
        "places: {\"visitor\": (at: (0, 0, 1))}",
        "pushes: [Push(link: \"left_hnd\", force: (1, 0, 0))]",
        "places: {\"bob\": (at: (0, 0, 1)), \"bob\": (facing: 1)}",
        "places: {\"bob\": (at: 3, facing: \"x\", side: 1)}",
        "walk: Walk(steps: 4, step_frequency: 110)",
        "walk: {\"bib\": Walk(steps: 4), \"bob\": Walk(steps: 4), \"bob\": Walk(steps: 6)}",
        "walk: {\"bob\": Walk(steps: 4, step_frequency: 300)}",
        "walk: {\"bob\": Walk(steps: 4)}, places: {\"bob\": (at: (0, 0.2, 1))}",
        "walk: {\"bob\": Walk(steps: 4)}, places: {\"bob\": (at: (1, 0, 1))}, ground: Stairs(friction: 0.8, count: 3)",
        "walk: {\"bob\": Walk(steps: 4)}, carries: [Carry(mass: 3, in: \"bob.left_hand\")]",
        "walk: {}",
    ] {
        let _ = write!(text, "{case}\n{}\n\n", faults(&scene(case)));
    }
    let twice = "Scene(version: 1, duration: 1, figures: {\"ann\": Human(height: 1.75, mass: 73), \"ann\": Human(height: 1.6, mass: 60)})";
    let _ = write!(text, "{twice}\n{}\n", faults(twice));
    insta::assert_snapshot!(text);
}

#[test]
fn of_reaches() {
    let text = listed(&[
        "reaches: Reach(tip: \"tip\")",
        "reaches: [Reach(tip: \"tipp\", by: [\"elbow\"], to: (0, 0, 0), over: 1)]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbo\"], to: (0, 0, 0), over: 1)]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0))]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbow\"])]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1, along: [])]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbow\"], along: [(0.5, (0, 0, 0)), (0.2, (0, 0, 0)), 3])]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1, from: -1)]",
        "reaches: [Reach(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1)]",
        "drives: {\"elbow.rx\": Free}, reaches: [Reach(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1)]",
        "drives: {\"*\": Frozen}, reaches: [Reach(tip: \"tip\", by: [\"shoulder\"], to: (0, 0, 0), over: 1)]",
        "drives: {\"*\": Frozen}, reaches: [Reach(tip: \"base\", by: [\"elbow\"], to: (0, 0, 0), over: 1)]",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_looks() {
    let mut text = listed(&[
        "reaches: [Lok(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0))]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"])]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], at: (0, 0), to: (0, 0, 0), axis: (0, 0, 0), along: 3)]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: Folow(\"tip\"))]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: Follow(\"tipp\"))]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: Follow(link: \"base\", of: (1, 2, 3)))]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: Follow(\"base\", (1, 2, 3), 4))]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), from: 1)]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 0)]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1, weight: 1.5)]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1, until: 0.5)]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), until: 0.5)]",
        "reaches: [Look(tip: \"tip\", by: [\"elbow\"], to: (0, 0, 0), over: 1, back: 0.5)]",
        "reaches: [Hold(tip: \"tip\", by: [\"elbow\"], turned: 3, to: (0, 0, 0))]",
        "reaches: [Hold(tip: \"tip\", by: [\"elbow\"], over: 1e4)]",
        "drives: {\"*\": Frozen, \"slide\": Free}, reaches: [Look(tip: \"base\", by: [\"elbow\"], to: Follow(\"tip\"))]",
        "drives: {\"*\": Frozen}, reaches: [Reach(tip: \"tip\", by: [\"forearm\"], to: Follow(\"tip\"), over: 1)]",
        "drives: {\"*\": Frozen}, reaches: [Hold(tip: \"tip\", by: [\"forearm\"], over: 1), Look(tip: \"tip\", by: [\"forearm\"], to: (0, 0, 0), over: 1, from: 0.5)]",
        "drives: {\"*\": Frozen}, sequence: [Together({\"elbow.ry\": Move(to: 1, over: 1)})], reaches: [Hold(tip: \"lower\", by: [\"elbow\"])]",
    ]);
    for case in [
        "reaches: [Reach(tip: \"left_hand\", by: [\"left_shoulder\"], to: Follow(\"right_hand\"), over: 1), Reach(tip: \"right_hand\", by: [\"right_shoulder\"], to: Follow(\"left_hand\"), over: 1)]",
        "start: {\"left_elbow.rx\": deg(40)}, reaches: [Reach(tip: \"left_hand\", by: [\"left_elbow.rx\"], to: (0, 0, 0), over: 1)]",
    ] {
        let case = format!("drives: {{\"*\": Frozen}}, duration: 1, {case}");
        let _ = write!(text, "{case}\n{}\n", faults(&person(&case)));
    }
    insta::assert_snapshot!(text);
}

#[test]
fn of_forces_and_repetitions() {
    let text = listed(&[
        "drives: {\"elbow.rx\": Servo(stiffness: 1)}",
        "drives: {\"elbow.rx\": Servo(to: 1, along: Line(from: 0, to: 1, duration: 1), stiffness: 1)}",
        "drives: {\"elbow.rx\": Servo(to: deg(3))}",
        "drives: {\"elbow.rx\": Servo(to: 1, stiffness: -1)}",
        "drives: {\"elbow.rx\": Servo(to: 1, stiffness: 1, limit: 0)}",
        "drives: {\"elbow.rx\": Servo(to: 1, stifness: 1)}",
        "drives: {\"slide.tx\": Servo(to: deg(1), stiffness: 1)}",
        "drives: {\"shoulder\": Servo(to: 1, stiffness: 1)}",
        "drives: {\"elbow.rx\": Serv(to: 1, stiffness: 1)}",
        "drives: {\"elbow.rx\": Sum([])}",
        "drives: {\"elbow.rx\": Sum(Free)}",
        "drives: {\"elbow.rx\": Sum([Move(to: 1, over: 1), Torqe(1)])}",
        "drives: {\"elbow.rx\": Sum([Servo(to: 1, stiffness: 1, until: At(1))])}",
        "drives: {\"elbow.rx\": Sine(amplitude: deg(3))}",
        "drives: {\"elbow.rx\": Sine(amplitude: 1, period: 0)}",
        "drives: {\"elbow.rx\": Repeat([])}",
        "drives: {\"elbow.rx\": Repeat(of: [Free], times: 1.5)}",
        "drives: {\"elbow.rx\": Repeat(of: [Move(to: 1, over: 1), Move(to: 0, over: 1)], times: 1e5)}",
        "drives: {\"elbow.rx\": [Repeat([Move(to: 1, over: 1)]), Free]}",
        "drives: {\"elbow.rx\": Repeat(of: [Repeat([Free])], times: 2)}",
        "drives: {\"elbow.rx\": Repeat(of: [Move(to: 1, over: -1)], times: 2)}",
        "drives: {\"elbow.rx\": MinimumJerk(from: 0, to: 1)}",
    ]);
    insta::assert_snapshot!(text);
}

#[test]
fn of_links_that_touch_and_loops() {
    let mut text = listed(&[
        "collisions: All",
        "collisions: Collisions(friktion: 1)",
        "collisions: Collisions(friction: -1)",
        "collisions: Collisions(friction: 1)",
        "loops: Connect(between: 1)",
        "loops: [Connect()]",
        "loops: [Conect(between: 1)]",
        "loops: [Connect(between: (1, 2))]",
        "loops: [Weld(between: ((\"tip\", (0, 0, 0)), (\"tip\", (0, 0, 1))))]",
        "loops: [Weld(between: ((\"tipp\", (0, 0, 0)), (\"world\", (0, 0, 1))))]",
        "loops: [Weld(between: ((\"tip\", (0, 0, 0)), (\"world\", (0, 0, 1))), stiffness: 3)]",
    ]);
    for case in [
        "duration: 1, collisions: Collisions(friction: 0.5, between: [(\"left_hand\", \"right_hnd\")])",
        "duration: 1, collisions: Collisions(friction: 0.5, between: [(\"left_hand\", \"wright_*\")])",
        "duration: 1, collisions: Collisions(friction: 0.5, between: [(\"left_hand\", \"left_forearm*\")])",
        "duration: 1, collisions: Collisions(friction: 0.5, except: [(\"*\", \"*\")])",
        "duration: 1, collisions: Collisions(friction: 0.5, except: [\"left_hand\"])",
        "duration: 1, method: RungeKutta4(step: 1e-3), collisions: Collisions(friction: 0.5)",
    ] {
        let _ = write!(text, "{case}\n{}\n", faults(&person(case)));
    }
    insta::assert_snapshot!(text);
}

/// Words of others, and of other places, say what to write; what is found out only when all is read has a place all the same.
#[test]
fn of_others() {
    let mut text = listed(&[
        "self_contact: true, contacts: 1, dt: 0.01, fps: 60, floor: true",
        "drives: {\"elbow.rx\": PD(to: 1), \"elbow.ry\": LetGo, \"slide\": Grasp(1)}",
        "sequence: [Sequence([])]",
        "drives: {\"elbow.rx\": [When(Touches(\"tip\")), Free]}",
        "loops: [Connect(between: ((\"tip\", (0, 0, 0)), (\"world\", (0, 5, 0))))], tolerance: 1e-6",
        "loops: [Connect(between: ((\"tip\", (0, 0, 0)), (\"world\", (0, 0, 0))), from: 0.3, until: 0.1)]",
        "rate: 1e6",
    ]);
    for case in [
        "walk: [Wait(1), Walk(steps: 2)]",
        "duration: 1, reaches: [Reach(tip: \"right_hand\", by: [\"right_shoulder\"], to: (0, 1, 0.4), over: 0.5, clearance: -1)]",
    ] {
        let _ = write!(text, "{case}\n{}\n\n", faults(&person(case)));
    }
    let limp = "Scene(version: 1, figures: {\"ann\": Human(height: 1.75, mass: 73, joints: Limp)}, walk: Walk(steps: 2))";
    let _ = write!(text, "{limp}\n{}\n", faults(limp));
    insta::assert_snapshot!(text);
}

/// By impulses, which are what is usual for loops, points that begin apart are drawn together; a name of a letter is near to none.
#[test]
fn loops_may_begin_open_by_impulses() {
    let open = "loops: [Connect(between: ((\"tip\", (0, 0, 0)), (\"world\", (0, 0.1, 0))))]";
    let text = listed(&[
        open,
        &format!("{open}, method: Impulses(step: 1e-3)"),
        "pushes: [Push(link: \"h\", force: (1, 0, 0))]",
    ]);
    assert_eq!(text.matches("no fault").count(), 2, "{text}");
    assert!(text.contains("has no link 'h'\n"), "{text}");
}

/// What is no fault and was hardly meant is noted.
#[test]
fn what_was_hardly_meant_is_noted() {
    let notes = |fields: &str| {
        let text = format!(
            "Scene(version: 1, duration: 0.1, rate: 60, figures: {{\"ann\": Human(height: 1.75, mass: 73)}}, {fields})"
        );
        let scene = solaris_scene::read(&text, &mut solaris_scene::NoFiles);
        scene.unwrap_or_else(|error| panic!("{error}")).notes().to_vec()
    };
    for (fields, said) in [
        (
            "drives: {\"*\": Free}, ground: Flat(friction: 0.8)",
            "begins 1.02 m in the ground: stand: true in the ground puts figures on it",
        ),
        ("method: Impulses(step: 10)", "a step of 10 s is cut to 1.667e-2 s, for 60 frames a second"),
        (
            "drives: {\"*\": Frozen}, pushes: [Push(link: \"head\", impulse: (0, 0, 3))]",
            "the blow on 'head' changes nothing",
        ),
    ] {
        let notes = notes(fields);
        assert!(notes.iter().any(|note| note.contains(said)), "{fields}: {notes:?}");
    }
    for fields in [
        "drives: {\"*\": Free}, ground: Flat(friction: 0.8, stand: true), method: Impulses(step: 1e-3)",
        "drives: {\"*\": Frozen}, ground: Flat(friction: 0.8)",
        "drives: {\"*\": Frozen}, pushes: [Push(link: \"head\", impulse: (0, 0, 3), over: 0.05)]",
        "drives: {\"*\": Free}, pushes: [Push(link: \"head\", impulse: (0, 0, 3))]",
    ] {
        assert_eq!(notes(fields), &[] as &[String], "{fields}");
    }
}
