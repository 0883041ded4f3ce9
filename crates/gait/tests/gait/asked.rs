//! Walks and runs as plain data: the same as the planners' own requests, and what is wrong is said.

use solaris_gait::{
    Extent, GaitError, GaitKind, GaitOptions, PartOptions, Repeats, RunEndOptions, StairOptions, Stairs,
    StyledRequest, WalkGround, WalkPart, WalkRequest, WalkSegment, sheet_of,
};
use solaris_model::{Figure, human};

fn ann() -> Figure {
    human(1.65, 58.0).expect("a person")
}

fn request(options: &GaitOptions) -> StyledRequest {
    options.request(&ann()).expect("a request").request
}

#[test]
fn options_are_the_planners_request() {
    let usual = GaitOptions::default();
    assert_eq!(request(&usual), StyledRequest::Smooth(WalkRequest::default()));

    let options = GaitOptions {
        speed: Some(1.2),
        distance: Some(5.0),
        manner: Some("sad:0.6".into()),
        stairs: None,
        style: [("arm_swing".to_owned(), 5.0)].into(),
        ..usual.clone()
    };
    let expected = WalkRequest {
        speed: Some(1.2),
        extent: Extent::Distance(5.0),
        sheet: sheet_of("sad:0.6").expect("a manner"),
        parameters: vec![("arm-swing", 5.0)],
        ..WalkRequest::default()
    };
    assert_eq!(request(&options), StyledRequest::Smooth(expected));

    // The usual pace of stairs, and the inner foot of a turn.
    let stairs = StairOptions { count: Some(6), ..StairOptions::default() };
    let StyledRequest::Smooth(walk) = request(&GaitOptions { stairs: Some(stairs), ..usual.clone() }) else {
        panic!("one walk")
    };
    assert_eq!(walk.ground, WalkGround::Stairs(Stairs { count: 6, ..Stairs::default() }));
    assert_eq!(walk.step_frequency, Some(88.0));
    let StyledRequest::Smooth(walk) = request(&GaitOptions { turn: 0.1, ..usual.clone() }) else {
        panic!("one walk")
    };
    assert!(walk.left_first);

    // What comes next is of the same walk until it stands.
    let steps = |steps, speed| PartOptions { steps: Some(steps), speed, ..PartOptions::default() };
    let stand = PartOptions { stand: Some(2.0), ..PartOptions::default() };
    let then = vec![steps(2, Some(1.0)), stand, steps(3, None)];
    let StyledRequest::Sequence(stages) = request(&GaitOptions { then, ..usual }) else {
        panic!("three stages")
    };
    let first = WalkRequest {
        then: vec![WalkPart { steps: 2, speed: Some(1.0), ..WalkPart::default() }],
        ..WalkRequest::default()
    };
    let last = WalkRequest { speed: Some(1.0), extent: Extent::Steps(3), ..WalkRequest::default() };
    assert_eq!(stages, [WalkSegment::Walk(first), WalkSegment::Stand(2.0), WalkSegment::Walk(last)]);
}

#[test]
fn a_loop_ends_where_it_began_in_whole_frames() {
    for gait in [GaitKind::Walk, GaitKind::Run] {
        let options =
            GaitOptions { gait, repeats: Some(Repeats::InPlace), rate: Some(30.0), ..GaitOptions::default() };
        let made = options.make(&ann()).expect("a loop");
        let (first, last) = (made.motion.q(0), made.motion.q(made.motion.len() - 1));
        let worst = first.iter().zip(last).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(made.repeats && worst < 1e-6, "{gait:?}: {worst}");
        if gait == GaitKind::Walk {
            let length = made.motion.time()[made.motion.len() - 1];
            assert!((30.0 * length - (30.0 * length).round()).abs() < 1e-9, "{length}");
            assert!(made.notes[0].contains("frames of 30 a second"), "{:?}", made.notes);
        }
    }
}

#[test]
fn a_run_and_key_postures_are_made() {
    let run = GaitOptions {
        gait: GaitKind::Run,
        speed: Some(3.0),
        from: RunEndOptions::Standing,
        ..GaitOptions::default()
    };
    let made = run.make(&ann()).expect("a run");
    assert!(made.run.is_some() && made.plan.style_name() == "run");
    let soft = GaitOptions { from: RunEndOptions::Running, give: Some(0.012), ..run };
    let knee =
        |options: &GaitOptions| options.make(&ann()).expect("a run").run.expect("measures").knee_stance;
    let rigid = GaitOptions { give: Some(0.0), ..soft.clone() };
    assert!(knee(&soft) < knee(&rigid) - 2.0);
    let thesis = GaitOptions { determinants: Some(3), step_frequency: Some(95.0), ..GaitOptions::default() };
    let made = thesis.make(&ann()).expect("a walk");
    assert!(made.run.is_none() && made.plan.style_name() == "thesis" && made.measures.steps == 10);
}

#[test]
fn what_contradicts_itself_or_is_not_known_is_refused() {
    let usual = GaitOptions::default();
    let stairs = Some(StairOptions::default());
    let nothing = vec![PartOptions::default()];
    let distance = vec![PartOptions { distance: Some(2.0), ..PartOptions::default() }];
    let text = |name: &str| Some(name.to_owned());
    let cases = [
        (
            GaitOptions { steps: Some(3), distance: Some(2.0), ..usual.clone() },
            "steps and distance are both given",
        ),
        (GaitOptions { slope: Some(0.1), stairs, ..usual.clone() }, "slope and stairs are both given"),
        (
            GaitOptions { gait: GaitKind::Run, slope: Some(0.1), ..usual.clone() },
            "slope is given, which is not of a run",
        ),
        (
            GaitOptions { gait: GaitKind::Run, determinants: Some(3), ..usual.clone() },
            "determinants is given",
        ),
        (GaitOptions { forefoot: true, ..usual.clone() }, "forefoot is given, which is not of a walk"),
        (GaitOptions { give: Some(0.01), ..usual.clone() }, "give is given, which is not of a walk"),
        (
            GaitOptions { from: RunEndOptions::Standing, ..usual.clone() },
            "from is given, which is not of a walk",
        ),
        (
            GaitOptions { determinants: Some(4), ..usual.clone() },
            "there is no number of determinants '4'; it is 3 or 5",
        ),
        (GaitOptions { determinants: Some(5), manner: text("sad"), ..usual.clone() }, "manner is given"),
        (GaitOptions { population: text("adlt"), ..usual.clone() }, "did you mean adult?"),
        (GaitOptions { manner: text("sat"), ..usual.clone() }, "'sat'"),
        (
            GaitOptions { style: [("arm_swin".to_owned(), 1.0)].into(), ..usual.clone() },
            "did you mean arm-swing?",
        ),
        (GaitOptions { repeats: Some(Repeats::Moving), steps: Some(5), ..usual.clone() }, "loop and steps"),
        (GaitOptions { then: nothing, ..usual.clone() }, "says nothing"),
        (GaitOptions { then: distance, ..usual.clone() }, "number 1 is a distance of 2 m"),
        (GaitOptions { footholds: Some(vec![vec![1.0]]), ..usual.clone() }, "foothold 1: it has 1 numbers"),
        (GaitOptions { ground: Some(Vec::new()), ..usual.clone() }, "point"),
        (GaitOptions { step_frequency: Some(f64::NAN), ..usual.clone() }, "NaN"),
        (GaitOptions { rate: Some(0.0), ..usual.clone() }, "0"),
        (GaitOptions { rate: Some(f64::NAN), repeats: Some(Repeats::Moving), ..usual }, "NaN"),
    ];
    for (options, why) in cases {
        let found = options.make(&ann()).err().map(|error: GaitError| error.to_string());
        assert!(found.as_deref().is_some_and(|found| found.contains(why)), "{why}: {found:?}");
    }
}

#[cfg(feature = "serde")]
#[test]
fn options_are_read_and_written() {
    let text = r#"{"step_frequency": 100, "then": [{"steps": 3, "turn": 0.1}], "loop": null, "stairs": {"rise": -0.17}}"#;
    let options: GaitOptions = serde_json::from_str(text).expect("options");
    assert_eq!((options.step_frequency, options.then[0].steps), (Some(100.0), Some(3)));
    let written = serde_json::to_string(&options).expect("written");
    assert_eq!(serde_json::from_str::<GaitOptions>(&written).expect("read back"), options);
    let error =
        serde_json::from_str::<GaitOptions>(r#"{"cadence_": 3}"#).expect_err("no such key").to_string();
    assert!(error.contains("unknown field `cadence_`") && error.contains("step_frequency"), "{error}");
}
