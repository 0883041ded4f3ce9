//! Walks with standing still in between.

use solaris_analysis::ground_reactions;
use solaris_gait::{Extent, FEET, WalkPart, WalkRequest, WalkSegment, WalkSequence, measure};
use solaris_model::{EventKind, Figure, Trajectory, human};

fn ann() -> Figure {
    human(1.75, 73.0).expect("a person")
}

fn walk(step_frequency: f64, steps: usize) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        ..WalkRequest::default()
    }
}

/// Stands, walks round a corner, stands, takes a half step with the left foot, stops for an instant, and goes on faster.
fn segments() -> [WalkSegment; 6] {
    let corner =
        WalkRequest { then: vec![WalkPart { steps: 3, turn: 0.3, ..WalkPart::default() }], ..walk(90.0, 3) };
    let half = WalkRequest { extent: Extent::Distance(0.3), left_first: true, ..walk(80.0, 1) };
    let on = WalkRequest { turn: -0.1, ..walk(110.0, 5) };
    [
        WalkSegment::Stand(0.7),
        WalkSegment::Walk(corner),
        WalkSegment::Stand(1.2),
        WalkSegment::Walk(half),
        WalkSegment::Walk(on),
        WalkSegment::Stand(0.4),
    ]
}

#[test]
fn stopping_and_starting_again_obeys_the_laws() {
    let figure = ann();
    let sequence = WalkSequence::new(&figure, &segments()).expect("a sequence");
    let mut motion = sequence.motion(&figure, 120.0).expect("sampled");
    let report = ground_reactions(&figure, &mut motion, FEET, &sequence).expect("forces");
    let weight = sequence.first().weight();
    assert!(report.from_prescribed.expect("prescribed").value < 0.05 * weight);
    let walked = measure(&figure, &motion).expect("measured");
    assert!(walked.extremes.slide.value < 1e-6, "{}", walked.extremes.slide.value);
    assert!(walked.extremes.sink.value < 1e-4 && walked.extremes.cop_outside.value < 1e-3);
    assert!(walked.extremes.friction.value < 0.4 && walked.extremes.least_knee.value > 0.0);
    // Nine and a half steps: the last touch-down of each walk closes.
    let touch = motion.events.iter().filter(|e| matches!(e.kind, EventKind::TouchDown { .. })).count();
    assert_eq!(touch, (6 + 1) + (1 + 1) + (5 + 1));
    assert!(motion.events.windows(2).all(|pair| pair[0].time <= pair[1].time));
    // While standing each foot bears half, and nothing moves.
    let stands = |time: f64| motion.time().iter().position(|&t| t >= time).expect("a frame");
    let between = sequence.first().duration() + 0.7;
    for frame in [stands(0.3), stands(between + 0.6), motion.len() - 3] {
        for foot in FEET {
            let force = motion.contact(foot).expect("a foot").samples[frame].force;
            assert!((force.y / weight - 0.5).abs() < 1e-4, "{frame}: {force:?}");
        }
        assert!(motion.v(frame).iter().all(|v| v.abs() < 1e-6));
        assert!(
            motion
                .planted
                .iter()
                .filter(|p| p.start <= motion.time()[frame] && motion.time()[frame] <= p.end)
                .count()
                >= 8
        );
    }
}

#[test]
fn each_walk_begins_as_the_one_before_has_ended() {
    let figure = ann();
    let sequence = WalkSequence::new(&figure, &segments()).expect("a sequence");
    let nq = figure.layout().nq();
    let (mut before, mut after) = (vec![0.0; nq], vec![0.0; nq]);
    let mut end = 0.7;
    for (walk, stand) in sequence.walks().zip([1.2, 0.0, 0.4]) {
        end += walk.duration();
        sequence.configuration(end - 1e-9, &mut before);
        sequence.configuration(end + stand + 1e-9, &mut after);
        let off = before.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-6, "{end} s: {off}");
        end += stand;
    }
    assert!((sequence.duration() - end).abs() < 1e-12);
    // Where it ends: headings add up, and prints lie on the way.
    let (_, heading) = sequence.destination();
    assert!((heading - (3.0 * 0.3 - 5.0 * 0.1)).abs() < 1e-12);
    let first = sequence.first().destination();
    let second = sequence.walks().nth(1).expect("a half step").destination();
    assert!(((second.0 - first.0).norm() - 0.3).abs() < 1e-12);
}

#[test]
fn what_is_no_sequence_is_refused_with_its_segment() {
    let figure = ann();
    let refused =
        |segments: &[WalkSegment]| WalkSequence::new(&figure, segments).err().expect("a refusal").to_string();
    let splayed = WalkRequest { parameters: vec![("foot-yaw", 10.0)], ..walk(90.0, 2) };
    let answers = [
        refused(&[]),
        refused(&[WalkSegment::Stand(2.0)]),
        refused(&[WalkSegment::Walk(walk(90.0, 2)), WalkSegment::Stand(f64::NAN)]),
        refused(&[WalkSegment::Stand(-1.0), WalkSegment::Walk(walk(90.0, 2))]),
        refused(&[WalkSegment::Walk(walk(90.0, 2)), WalkSegment::Walk(walk(20.0, 2))]),
        refused(&[WalkSegment::Walk(walk(90.0, 2)), WalkSegment::Walk(splayed)]),
        refused(&[
            WalkSegment::Walk(WalkRequest { turn: 0.35, ..walk(100.0, 3) }),
            WalkSegment::Walk(WalkRequest { turn: 0.2, left_first: true, ..walk(100.0, 3) }),
        ]),
    ];
    insta::assert_snapshot!(answers.join("\n"));
}
