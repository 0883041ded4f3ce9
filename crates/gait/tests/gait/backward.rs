//! Walking backward: held against the walk forward that it is in reversed time, which is planned on its own here, against where it goes,
//! and against Newton's law. Random ones over all grounds stand in `anywhere.rs`.

use crate::posed::Posed;
use solaris_analysis::ground_reactions;
use solaris_gait::{
    Extent, FEET, GaitError, Next, PlanError, Population, RequestError, Stairs, StyledPlan, StyledRequest,
    WalkGround, WalkPart, WalkPlan, WalkRequest, band_reports, measure, on_the_spot, stages, walk,
};
use solaris_model::{EventKind, Figure, Human, Motion, RootOrder, Trajectory, Vector3};

fn person() -> Figure {
    Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person")
}

fn backward(steps: usize) -> WalkRequest {
    WalkRequest { backward: true, extent: Extent::Steps(steps), ..WalkRequest::default() }
}

/// Place and heading of the root.
fn root(plan: &WalkPlan, t: f64) -> (Vector3<f64>, f64) {
    let mut q = vec![0.0; 66];
    plan.configuration(t, &mut q);
    (Vector3::new(q[0], q[1], q[2]), q[3])
}

fn loaded(figure: &Figure, plan: &WalkPlan) -> Motion {
    let mut motion = plan.motion(figure, 120.0).expect("sampled");
    ground_reactions(figure, &mut motion, FEET, plan).expect("forces");
    motion
}

#[test]
fn postures_accelerations_and_forces_are_those_of_reversed_time() {
    let figure = person();
    for (steps, turn) in [(6, 0.0), (7, 0.0), (5, 0.2)] {
        let back = walk(&figure, &WalkRequest { turn, ..backward(steps) }).expect("backward");
        // The foot that would have closed goes first, and the other way round.
        let request = WalkRequest {
            population: Population::Treadmill,
            extent: Extent::Steps(steps),
            turn: -turn,
            left_first: steps % 2 == 1,
            ..WalkRequest::default()
        };
        let forward = walk(&figure, &request).expect("forward");
        let lasts = forward.duration();
        assert!((back.duration() - lasts).abs() < 1e-12);
        let [mut there, mut here] = [vec![0.0; 66], vec![0.0; 66]];
        for k in 0..=200 {
            let t = lasts * f64::from(k) / 200.0;
            forward.configuration(lasts - t, &mut there);
            back.configuration(t, &mut here);
            // All but where it is and which way it faces.
            for i in (4..66).chain([1]) {
                assert!(
                    (there[i] - here[i]).abs() < 1e-9,
                    "{steps} {turn} {t} {i}: {} {}",
                    there[i],
                    here[i]
                );
            }
            let [a, b] = [forward.force(forward.clock_at(lasts - t)), back.force(back.clock_at(t))];
            assert!((a.norm() - b.norm()).abs() < 1e-6 && (a.y - b.y).abs() < 1e-6, "{a} {b}");
        }
        // Every joint's moment, of inverse dynamics that know of no plan, at the same posture.
        let [one, other] = [loaded(&figure, &forward), loaded(&figure, &back)];
        let peaks = [&one, &other].map(|motion| measure(&figure, motion).expect("measured").joints);
        for (a, b) in peaks[0].iter().zip(&peaks[1]) {
            // Samples lie elsewhere, and power is the other way round.
            assert!((a.extension.value - b.extension.value).abs() < 0.02, "{a:?} {b:?}");
            assert!((a.generated.value + b.absorbed.value).abs() < 0.1, "{a:?} {b:?}");
        }
    }
}

#[test]
fn it_begins_where_it_is_told_to_and_goes_back_and_round() {
    let figure = person();
    for (turn, left_first, steps) in [(0.0, false, 10), (0.0, true, 5), (0.3, true, 7), (-0.2, false, 4)] {
        let request = WalkRequest { turn, left_first, ..backward(steps) };
        let plan = walk(&figure, &request).expect("backward");
        let (place, heading) = root(&plan, 0.0);
        assert!(
            place.xz().norm() < 0.15 && heading.abs() < 2e-2,
            "{:?} {heading} {request:?}",
            place.as_slice()
        );
        let (end, faced) = plan.destination();
        assert!((faced - turn * steps as f64).abs() < 1e-9, "{faced}");
        let (at, facing) = root(&plan, plan.duration());
        assert!(
            (at - end - Vector3::y() * at.y).xz().norm() < 0.15 && (facing - faced).abs() < 2e-2,
            "{at:?} {end:?} {facing} {faced}"
        );
        if turn == 0.0 {
            let far = plan.prints()[steps];
            assert!((end.z + far).abs() < 1e-9 && end.x.abs() < 1e-9 && far > 0.5 * steps as f64, "{end}");
            assert!(plan.prints().is_sorted() && plan.prints()[0] == 0.0);
        }
        let motion = loaded(&figure, &plan);
        let lifted = motion.events.iter().find_map(|event| match &event.kind {
            EventKind::LiftOff { link } => Some(link.as_str()),
            _ => None,
        });
        assert_eq!(lifted, Some(FEET[usize::from(!left_first)]));
        let found = measure(&figure, &motion).expect("measured");
        assert_eq!(found.steps, steps);
        assert!(found.extremes.slide.value < 1e-4 && found.extremes.cop_outside.value < 1e-3);
    }
}

#[test]
fn newton_holds_by_differences_of_positions() {
    let figure = person();
    let plan = walk(&figure, &backward(8)).expect("backward");
    let motion = loaded(&figure, &plan);
    let mut posed = Posed::new(&figure, &plan);
    let mut com = |t: f64| {
        posed.pose(t);
        let links = figure.links().iter().enumerate();
        links.map(|(i, link)| posed.at(i, link.com()) * link.mass()).sum::<Vector3<f64>>() / figure.mass()
    };
    let (h, weight) = (2e-3, figure.mass() * 9.80665);
    let mut off: Vec<f64> = (30..motion.len() - 30)
        .step_by(7)
        .map(|sample| {
            let t = motion.time()[sample];
            let acceleration = (com(t - h) - com(t) * 2.0 + com(t + h)) / (h * h);
            let needed = (acceleration + Vector3::y() * 9.80665) * figure.mass();
            let ground: Vector3<f64> = motion.contacts.iter().map(|track| track.samples[sample].force).sum();
            (needed - ground).norm() / weight
        })
        .collect();
    off.sort_by(f64::total_cmp);
    assert!(off[off.len() * 9 / 10] < 0.02, "{off:?}");
}

#[test]
fn it_is_measured_the_way_it_goes_and_held_against_no_band_of_walking_forward() {
    let figure = person();
    let plan = walk(&figure, &backward(10)).expect("backward");
    let found = measure(&figure, &loaded(&figure, &plan)).expect("measured");
    let stride = found.steady.expect("a steady stride");
    let length = plan.style().step_length;
    assert!((found.distance - plan.prints()[10]).abs() < 0.02, "{}", found.distance);
    assert!(stride.backward && (stride.step_length - length).abs() < 3e-3, "{stride:?}");
    // Braking is against the way, as in every gait.
    assert!(stride.braking < -5.0 && stride.pushing > 5.0, "{stride:?}");
    assert!(band_reports(&stride).is_empty());
    let forward = walk(&figure, &WalkRequest::default()).expect("forward");
    let stride = measure(&figure, &loaded(&figure, &forward)).expect("measured").steady.expect("a stride");
    assert!(!stride.backward && band_reports(&stride).len() == 2);
}

#[test]
fn steps_backward_are_shorter_at_the_same_step_frequency() {
    let figure = person();
    let [back, forward] = [true, false].map(|backward| {
        let request = WalkRequest { backward, ..WalkRequest::default() };
        *walk(&figure, &request).expect("a walk").style()
    });
    assert!((back.step_frequency - forward.step_frequency).abs() < 1e-12);
    assert!((back.step_length / forward.step_length - 0.0031 / 0.0037).abs() < 1e-12);
    // What is asked for is walked.
    let asked = WalkRequest { step_length: Some(0.7), step_frequency: Some(105.0), ..backward(6) };
    assert!((walk(&figure, &asked).expect("a walk").style().step_length - 0.7).abs() < 1e-12);
    let far = WalkRequest { extent: Extent::Distance(3.3), ..backward(1) };
    let plan = walk(&figure, &far).expect("a walk");
    assert!((plan.destination().0.z + 3.3).abs() < 1e-9, "{:?}", plan.destination());
}

#[test]
fn one_stride_of_it_repeats_itself() {
    let figure = person();
    for left_first in [false, true] {
        let request = StyledRequest::Smooth(WalkRequest { left_first, ..backward(42) });
        let plan = StyledPlan::of(&figure, &request).expect("backward");
        let (motion, _) = plan.loaded_stride(&figure, 120.0).expect("a stride");
        let last = motion.len() - 1;
        assert!((motion.q(last)[2] - motion.q(0)[2] + 2.0 * plan.step_length()).abs() < 1e-12);
        for i in (0..66).filter(|i| *i != 2) {
            let [a, b] = [motion.q(0)[i], motion.q(last)[i]];
            assert!((a - b).abs() < 1e-10, "{i}: {a} {b}");
        }
        for foot in FEET {
            let touches = motion.events.iter().filter(|event| match &event.kind {
                EventKind::TouchDown { link } => link == foot,
                _ => false,
            });
            assert_eq!(touches.count(), 1, "{foot}");
        }
        let still = on_the_spot(&figure, &motion).expect("the same figure");
        assert!((still.q(last)[2] - still.q(0)[2]).abs() < 1e-12);
    }
}

#[test]
fn slopes_and_stairs_rise_along_the_way_that_it_goes() {
    let figure = person();
    let up = WalkGround::Slope(6.0_f64.to_radians());
    let stairs = |rise| WalkGround::Stairs(Stairs { count: 4, rise, tread: 0.29 });
    for (ground, step_frequency, rises) in
        [(up, 95.0, true), (stairs(0.15), 90.0, true), (stairs(-0.15), 90.0, false)]
    {
        let request = WalkRequest { ground, step_frequency: Some(step_frequency), ..backward(8) };
        let plan = walk(&figure, &request).unwrap_or_else(|error| panic!("{error}: {request:?}"));
        let (first, last) = (root(&plan, 0.0).0, root(&plan, plan.duration()).0);
        assert!(last.z < first.z - 1.0, "{first} {last}");
        let climbed = last.y - first.y;
        assert!(if rises { climbed > 0.3 } else { climbed < -0.3 }, "{climbed}");
    }
}

#[test]
fn forward_a_stand_and_back_again_join() {
    let figure = person();
    let there = WalkRequest { extent: Extent::Steps(4), turn: 0.1, ..WalkRequest::default() };
    let back = WalkPart { steps: 4, backward: true, turn: 0.1, ..WalkPart::default() };
    let staged = stages(&there, &[Next::Stand(0.5), Next::Steps(back)]).expect("stages");
    let StyledPlan::Sequence(sequence) = StyledPlan::of(&figure, &staged.request).expect("planned") else {
        panic!("a sequence");
    };
    let motion = sequence.motion(&figure, 240.0).expect("sampled");
    for i in 0..motion.len() - 1 {
        let jump = (0..66).map(|k| (motion.q(i + 1)[k] - motion.q(i)[k]).abs()).fold(0.0, f64::max);
        // No joint is quicker than 40 rad/s.
        assert!(jump < 40.0 / 240.0, "{i} {jump}");
    }
    // Nothing moves as the one walk gives way to the other, and all of it is pressed under a sole.
    let (stop, stand) = (sequence.first().duration(), 0.5);
    let [mut stands, mut still] = [vec![0.0; 66], vec![0.0; 66]];
    sequence.configuration(stop - 1e-3, &mut stands);
    sequence.configuration(stop + stand + 1e-3, &mut still);
    for (i, (a, b)) in stands.iter().zip(&still).enumerate() {
        assert!((a - b).abs() < 1e-9, "{i}: {a} {b}");
    }
    let plan = StyledPlan::of(&figure, &staged.request).expect("planned");
    let (motion, _) = plan.loaded(&figure, 240.0).expect("forces");
    let found = measure(&figure, &motion).expect("measured").extremes;
    assert!(found.cop_outside.value < 5e-3 && found.slide.value < 1e-4, "{found:?}");
    let middle = motion.len() / 2;
    assert!(motion.q(middle)[2] > 2.0 && motion.q(motion.len() - 1)[2] < 1.0);
    assert!((sequence.destination().1 - 0.8).abs() < 1e-9);
}

#[test]
fn what_cannot_be_walked_backward_is_named() {
    let figure = person();
    let refused = |request: WalkRequest| walk(&figure, &request).err().expect("refused");
    let then = vec![WalkPart { steps: 2, turn: 0.2, ..WalkPart::default() }];
    assert!(matches!(
        refused(WalkRequest { then, ..backward(4) }),
        GaitError::Request(RequestError::NotBackward { .. })
    ));
    let stones = WalkGround::Footholds(Vec::new());
    let error = refused(WalkRequest { ground: stones, ..backward(4) });
    assert_eq!(
        error.to_string(),
        "footholds backward: not planned yet; walk forward there, or stop and stand before and after it"
    );
    let steep = WalkGround::Slope(-15.0_f64.to_radians());
    match refused(WalkRequest { ground: steep, step_frequency: Some(115.0), ..backward(8) }) {
        GaitError::Plan(PlanError::Backward { why }) => assert!(matches!(*why, PlanError::TooSteep { .. })),
        error => panic!("{error}"),
    }
    let on_the_way = [Next::Steps(WalkPart { steps: 2, backward: true, ..WalkPart::default() })];
    assert!(matches!(
        stages(&WalkRequest::default(), &on_the_way),
        Err(RequestError::BackwardOnTheWay { number: 1 })
    ));
}
