//! What is asked of a walk in the thesis's style is what it does.

use solaris_gait::determinants::five::TrunkAmplitudes;
use solaris_gait::determinants::{Determinants, KeyPhase, Proportions};
use solaris_gait::{Extent, FEET, ThesisRequest, thesis_walk};
use solaris_model::{EventKind, Trajectory as _, human};

/// The sixth determinant brings the pelvis over the foot that stands alone.
#[test]
fn the_pelvis_sways_to_the_foot_that_stands() {
    let figure = human(1.75, 73.0).expect("a person");
    for determinants in Determinants::ALL {
        for left_first in [false, true] {
            let request = ThesisRequest {
                determinants,
                sway: 0.02,
                extent: Extent::Steps(8),
                left_first,
                ..ThesisRequest::default()
            };
            let walk = thesis_walk(&figure, &request).expect("it can be walked").walk;
            let events = walk.events();
            let mut q = vec![0.0; figure.layout().nq()];
            let mut alone = 0;
            // But for the first and the last two steps, over which the sway grows and dies away.
            for (i, event) in events.iter().enumerate().skip(4).take(events.len() - 10) {
                let EventKind::LiftOff { link } = &event.kind else { continue };
                let lands = |kind: &EventKind| *kind == EventKind::TouchDown { link: link.clone() };
                let down = events[i..].iter().find(|event| lands(&event.kind)).expect("it lands");
                walk.configuration(0.5 * (event.time + down.time), &mut q);
                let left_stands = link == FEET[1];
                let towards = if left_stands { q[0] } else { -q[0] };
                assert!(towards > 0.01, "{determinants:?}: {towards} m, {link} swings from {} s", event.time);
                alone += 1;
            }
            assert!(alone >= 3, "{alone} single supports");
        }
    }
}

#[test]
fn a_distance_is_met_with_any_step_length() {
    let figure = human(1.75, 73.0).expect("a person");
    let request = ThesisRequest {
        step_frequency: Some(100.0),
        extent: Extent::Distance(3.0),
        parameters: vec![("step-length", 0.65)],
        ..ThesisRequest::default()
    };
    let plan = thesis_walk(&figure, &request).expect("it can be walked");
    // As few steps as need none that is longer.
    assert_eq!((plan.steps, plan.step_length), (5, 0.6));
    assert!((plan.walk.prints().last().expect("prints") - 3.0).abs() < 1e-12);
}

/// A parameter that is the step length counts, and the pace follows from it.
#[test]
fn a_step_length_among_the_parameters_sets_the_pace() {
    let figure = human(1.75, 73.0).expect("a person");
    let request = ThesisRequest {
        speed: Some(1.1),
        step_length: Some(0.75),
        parameters: vec![("step-length", 0.66)],
        extent: Extent::Steps(2),
        ..ThesisRequest::default()
    };
    let plan = thesis_walk(&figure, &request).expect("it can be walked");
    assert!((plan.step_length * plan.step_frequency / 60.0 - 1.1).abs() < 1e-12);
    assert!((plan.step_length - 0.66).abs() < 1e-12);
}

#[test]
fn ranges_of_lengths_are_those_of_a_body() {
    for height in [1.2, 2.0] {
        let p = Proportions::of(&human(height, 23.8 * height * height).expect("a person")).expect("lengths");
        let longest = |determinants: Determinants| determinants.parameters(&p)[0].range.1;
        assert!((longest(Determinants::Three) - 2.0 * p.leg()).abs() < 1e-12);
        assert!((longest(Determinants::Five) - 2.0 * height / 1.75).abs() < 1e-12);
    }
}

/// The trunk's fits are to speeds in m/s: what lengths are in does not change the postures.
#[test]
fn the_trunk_follows_a_speed_in_any_unit() {
    let fit = Proportions::FIT;
    let metres = Proportions { unit: 1.0, ..fit.scaled(fit.unit) };
    assert!((metres.height - 1.75).abs() < 1e-12);
    let solved = |p: &Proportions| {
        let step = 0.004 * p.height * 110.0;
        let values = Determinants::Five.automatic(p, 110.0, step).expect("parameters");
        Determinants::Five.solve(p, &values, step * 110.0 / 60.0).expect("postures")
    };
    let [mine, theirs] = [solved(&fit), solved(&metres)];
    let trunks = |cycle: &[KeyPhase]| -> Vec<_> { cycle.iter().map(|phase| phase.end.trunk).collect() };
    for (a, b) in trunks(&mine.cycles[1]).iter().zip(trunks(&theirs.cycles[1])) {
        assert!((a.pelvis_bend - b.pelvis_bend).abs() < 1e-12, "{a:?} {b:?}");
    }
    // ν at 1.41 m/s, at the end of phase 3.
    let bend = trunks(&mine.cycles[1])[2].pelvis_bend;
    assert!(
        (bend - TrunkAmplitudes::at_speed(1.75 * 0.004 * 110.0 * 110.0 / 60.0).pelvis_bend).abs() < 1e-12
    );
}
