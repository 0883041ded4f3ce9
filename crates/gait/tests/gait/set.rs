//! Sets of clips: they fit together, last whole frames, and their feet stand.

use solaris_gait::set::{ClipKind, ClipSet, Joint, SetRequest, clip_set};
use solaris_gait::{Population, WalkRequest, sheet_of};
use solaris_model::{Figure, Human, RootOrder, human};

fn person(height: f64, mass: f64) -> Figure {
    Human::new(height, mass).root(RootOrder::Yzx).build().expect("a person")
}

/// Seams, whole frames, planted points.
fn check(figure: &Figure, set: &ClipSet, seams: f64) {
    for clip in &set.clips {
        let (name, motion, last) = (&clip.name, &clip.motion, clip.motion.len() - 1);
        let frames = clip.duration() * set.rate;
        assert!((frames - frames.round()).abs() < 1e-6, "{name}: {frames} frames");
        assert!(motion.q(0)[0].abs() < 1e-12 && motion.q(0)[2].abs() < 1e-12 && motion.q(0)[3].abs() < 0.2);
        if clip.repeats {
            let all = (0..figure.layout().nq()).filter(|at| ![0, 2].contains(at));
            let worst = all.map(|at| (motion.q(0)[at] - motion.q(last)[at]).abs()).fold(0.0, f64::max);
            assert!(worst < 1e-6, "{name}: {worst}");
        }
        let in_walk = clip.joints.contains(&Joint::LeftContact) && !clip.repeats;
        assert_eq!(clip.seam.is_some(), in_walk, "{name}");
        if let Some(seam) = clip.seam {
            assert!(seam.angle.to_degrees() < seams && seam.height < 2e-3, "{name}: {seam:?}");
        }
        // What is planted stands, in every clip that is not walked on the spot.
        for planted in &motion.planted {
            let within = |time: f64| (planted.start - 1e-9..=planted.end + 1e-9).contains(&time);
            let places = (0..motion.len()).filter(|sample| within(motion.time()[*sample]));
            let places: Vec<_> = places
                .map(|sample| {
                    figure.places(motion.q(sample))[planted.link] * nalgebra::Point3::from(planted.point)
                })
                .collect();
            let slide = places.iter().map(|place| (place - places[0]).norm()).fold(0.0, f64::max);
            assert!(slide < 1e-4, "{name}: a planted point moves by {slide} m");
        }
        assert!(motion.planted.iter().any(|planted| planted.start == 0.0), "{name}: nothing stands at first");
    }
    let loops: Vec<f64> = set
        .clips
        .iter()
        .filter(|clip| clip.kind == ClipKind::Walk)
        .map(|clip| clip.advance[1] / clip.duration())
        .collect();
    assert!(loops.windows(2).all(|pair| pair[0] + 0.1 < pair[1]), "from slow to fast: {loops:?}");
    let is_usual = set.clips.iter().any(|clip| clip.name == set.usual && clip.kind == ClipKind::Walk);
    assert!(is_usual, "{}", set.usual);
}

#[test]
fn everybodys_clips_fit_together() {
    let sad = WalkRequest { sheet: sheet_of("sad:0.5").expect("a manner"), ..WalkRequest::default() };
    let child = WalkRequest { population: Population::Child, ..WalkRequest::default() };
    let cases = [
        (person(1.75, 73.0), SetRequest::default(), 1.0),
        (person(1.62, 55.0), SetRequest { walk: sad, rate: 24.0, ..SetRequest::default() }, 2.5),
        (
            Human::new(1.25, 26.0).age(8.0).root(RootOrder::Yzx).build().expect("a child"),
            SetRequest { walk: child, rate: 60.0, ..SetRequest::default() },
            1.0,
        ),
    ];
    for (figure, request, seams) in cases {
        let set = clip_set(&figure, &request).expect("a set");
        assert_eq!(set.clips.len(), 18, "{:?}", set.notes);
        check(&figure, &set, seams);
        // A quarter turn is one.
        let turn = set.clips.iter().find(|clip| clip.name == "turn_left_90").expect("a turn");
        let turned = turn.motion.q(turn.motion.len() - 1)[3] - turn.motion.q(0)[3];
        assert!((turned - std::f64::consts::FRAC_PI_2).abs() < 1e-9, "{turned}");
    }
}

#[test]
fn speeds_may_be_asked_for_and_loops_stay() {
    let figure = person(1.75, 73.0);
    let request = SetRequest { speeds: Some(vec![1.5, -0.7, 0.8]), in_place: true, ..SetRequest::default() };
    let set = clip_set(&figure, &request).expect("a set");
    let loops: Vec<_> = set.clips.iter().filter(|clip| clip.kind == ClipKind::Walk).collect();
    // Of whole frames; the speed stays.
    let off = loops.iter().zip([-0.7, 0.8, 1.5]).map(|(clip, asked)| (clip.speed() - asked).abs());
    assert!(loops.len() == 3 && off.fold(0.0, f64::max) < 1e-9);
    assert_eq!(loops[0].name, "walk_backward_1");
    for clip in loops {
        let q = |sample: usize| clip.motion.q(sample)[2];
        assert!((q(0) - q(clip.motion.len() - 1)).abs() < 1e-9);
        assert!((clip.advance[1] / clip.duration() - clip.speed()).abs() < 1e-6);
    }
}

#[test]
fn a_root_that_cannot_turn_has_no_turns_and_bad_numbers_are_refused() {
    let figure = human(1.75, 73.0).expect("a person");
    let set = clip_set(&figure, &SetRequest::default()).expect("a set");
    assert!(
        set.clips.iter().all(|clip| clip.kind != ClipKind::Turn)
            && set.notes[0].contains("turns are left out")
    );
    for (request, why) in [
        (SetRequest { rate: f64::NAN, ..SetRequest::default() }, "rate NaN"),
        (SetRequest { rate: 0.0, ..SetRequest::default() }, "rate 0"),
        (SetRequest { speeds: Some(Vec::new()), ..SetRequest::default() }, "number of speeds 0"),
        (SetRequest { speeds: Some(vec![9.0]), ..SetRequest::default() }, "speed 9"),
        (SetRequest { speeds: Some(vec![f64::NAN]), ..SetRequest::default() }, "speed NaN"),
    ] {
        let found = clip_set(&figure, &request).err().map(|error| error.to_string());
        assert!(found.as_deref().is_some_and(|found| found.contains(why)), "{why}: {found:?}");
    }
}

#[cfg(feature = "serde")]
#[test]
fn a_set_is_written_with_units_in_its_keys() {
    let set = clip_set(&person(1.75, 73.0), &SetRequest::default()).expect("a set");
    let written = serde_json::to_value(&set).expect("written");
    assert_eq!((&written["rate_per_s"], &written["usual"]), (&30.0.into(), &"walk_4".into()));
    let stride = &written["clips"][8];
    assert_eq!(
        (&stride["name"], &stride["loop"], &stride["frames"]),
        (&"walk_4".into(), &true.into(), &33.into())
    );
    assert_eq!(
        stride["events"][0],
        serde_json::json!({"link": "left_foot", "what": "touch_down", "at_s": 0.0, "phase": 0.0})
    );
    assert_eq!(written["clips"][1]["begins"], "standing");
    assert!(written["clips"][1]["seam"]["angle_deg"].as_f64().expect("a number") < 0.5);
}
