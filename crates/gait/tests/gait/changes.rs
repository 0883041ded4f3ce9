//! Walks that change on the way: pace, step length, direction.

use solaris_analysis::ground_reactions;
use solaris_gait::{
    Extent, FEET, FRICTION, GaitError, RequestError, WalkPart, WalkPlan, WalkRequest, measure, walk,
};
use solaris_model::{EventKind, Figure, Trajectory, Vector3, human};

fn more(steps: usize) -> WalkPart {
    WalkPart { steps, ..WalkPart::default() }
}

fn paced(steps: usize, step_frequency: f64) -> WalkPart {
    WalkPart { step_frequency: Some(step_frequency), ..more(steps) }
}

fn turning(steps: usize, degrees: f64) -> WalkPart {
    WalkPart { turn: degrees.to_radians(), ..more(steps) }
}

fn request(step_frequency: f64, steps: usize, then: &[WalkPart]) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        extent: Extent::Steps(steps),
        then: then.to_vec(),
        ..WalkRequest::default()
    }
}

fn ann() -> Figure {
    human(1.75, 73.0).expect("a person")
}

/// Times of touch-down.
fn contacts(plan: &WalkPlan) -> Vec<f64> {
    let touch = |event: &&solaris_model::Event| matches!(event.kind, EventKind::TouchDown { .. });
    plan.events().iter().filter(touch).map(|event| event.time).collect()
}

#[test]
fn the_laws_hold_through_every_change() {
    let figure = ann();
    let half = WalkPart { step_frequency: Some(95.0), step_length: Some(0.31), ..more(1) };
    let walks = [
        ("faster", request(80.0, 5, &[paced(6, 110.0)])),
        ("slower", request(115.0, 5, &[paced(6, 80.0)])),
        ("much faster at once", request(60.0, 4, &[paced(6, 115.0)])),
        ("another pace every step", request(90.0, 2, &[paced(1, 100.0), paced(1, 95.0), paced(3, 105.0)])),
        ("a half step", request(95.0, 4, &[half, paced(4, 95.0)])),
        ("to the left", request(110.0, 4, &[turning(4, 15.0), more(3)])),
        ("sharply to the right", request(95.0, 4, &[turning(2, -30.0), more(3)])),
        ("from the first step to the last", WalkRequest { turn: 0.2, ..request(100.0, 6, &[]) }),
        ("left and right", request(100.0, 2, &[turning(3, 20.0), turning(4, -20.0)])),
        (
            "slower round a corner",
            request(110.0, 5, &[WalkPart { turn: 0.35, ..paced(3, 95.0) }, paced(5, 110.0)]),
        ),
        (
            "left foot first",
            WalkRequest { left_first: true, ..request(105.0, 3, &[turning(3, 25.0), paced(3, 90.0)]) },
        ),
        ("as fast as it goes", request(130.0, 10, &[])),
    ];
    for (name, request) in walks {
        let plan = walk(&figure, &request).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut motion = plan.motion(&figure, 120.0).expect("sampled");
        let report = ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let prescribed = report.from_prescribed.expect("prescribed").value / plan.weight();
        let walk = measure(&figure, &motion).expect("measured");
        println!(
            "{name}: forces {:.1} %BW from those prescribed; friction {:.2}, a foot's {:.2}; slide {:.1e} m, sink {:.1e} m, \
             clearance {:.1} mm, pressed outside by {:.1} mm, least knee {:.1}°",
            100.0 * prescribed,
            walk.extremes.friction.value,
            walk.extremes.foot_friction.value,
            walk.extremes.slide.value,
            walk.extremes.sink.value,
            1e3 * walk.extremes.clearance.value,
            1e3 * walk.extremes.cop_outside.value,
            walk.extremes.least_knee.value.to_degrees()
        );
        assert!(prescribed < 0.05, "{name}");
        assert!(
            walk.extremes.friction.value < FRICTION.0 && walk.extremes.foot_friction.value < FRICTION.1,
            "{name}"
        );
        assert!(walk.extremes.slide.value < 1e-9 && walk.extremes.sink.value < 1e-4, "{name}");
        assert!(walk.extremes.cop_outside.value < 1e-3 && walk.extremes.clearance.value > 0.005, "{name}");
        assert!(walk.extremes.least_knee.value > -1.0_f64.to_radians(), "{name}");
        // From rest to rest, and the mean vertical force is the weight.
        let vertical: Vec<f64> = (0..motion.len())
            .map(|i| FEET.iter().map(|foot| motion.contact(foot).expect("a foot").samples[i].force.y).sum())
            .collect();
        let mean = vertical.iter().sum::<f64>() / vertical.len() as f64 / plan.weight();
        assert!((mean - 1.0).abs() < 2e-3, "{name}: {mean}");
        assert!((vertical[0] / plan.weight() - 1.0).abs() < 1e-6, "{name}");
        assert!((vertical[vertical.len() - 1] / plan.weight() - 1.0).abs() < 1e-6, "{name}");
    }
}

#[test]
fn steps_last_as_long_as_their_pace_says() {
    let plan =
        walk(&ann(), &request(90.0, 3, &[paced(3, 110.0), paced(2, 100.0)])).expect("it can be walked");
    let (slow, fast, last) = (60.0 / 90.0, 60.0 / 110.0, 60.0 / 100.0);
    let mean = |a: f64, b: f64| 0.5 * (a + b);
    let wanted = [slow, slow, mean(slow, fast), fast, fast, mean(fast, last), last, last];
    let times = contacts(&plan);
    for (k, (pair, wanted)) in times.windows(2).zip(wanted).enumerate() {
        assert!((pair[1] - pair[0] - wanted).abs() < 1e-12, "step {}: {} s", k + 2, pair[1] - pair[0]);
    }
    // Prints lie where the step lengths say, with the shorter first step and the two that brake.
    let people = |step_frequency: f64| 0.0037 * 1.75 * step_frequency;
    let [a, b, c] = [90.0, 110.0, 100.0].map(people);
    let lengths = [0.88 * a, a, a, b, b, b, 0.80 * c, 0.67 * c, 0.0];
    for (pair, wanted) in plan.prints().windows(2).zip(lengths) {
        assert!((pair[1] - pair[0] - wanted).abs() < 1e-12);
    }
}

#[test]
fn a_change_is_not_felt_long_before_nor_long_after() {
    let figure = ann();
    let even = walk(&figure, &request(100.0, 24, &[])).expect("it can be walked");
    let corner = walk(&figure, &request(100.0, 12, &[turning(2, 20.0), more(10)])).expect("it can be walked");
    let nq = figure.layout().nq();
    let (mut a, mut b) = (vec![0.0; nq], vec![0.0; nq]);
    for k in 0..100 {
        let t = 0.04 * f64::from(k);
        even.configuration(t, &mut a);
        corner.configuration(t, &mut b);
        let off = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-4, "{t} s: {off}");
    }
    // At the end the joints are as if nothing had been.
    let end = even.duration();
    for k in 0..60 {
        even.configuration(end - 0.04 * f64::from(k), &mut a);
        corner.configuration(end - 0.04 * f64::from(k), &mut b);
        let off = a[6..].iter().zip(&b[6..]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 2e-4, "{k}: {off}");
    }
    let (place, heading) = corner.destination();
    assert!((heading.to_degrees() - 40.0).abs() < 1e-12);
    assert!(place.x > 1.0 && place.z > 6.0);
}

#[test]
fn turning_left_first_is_the_mirror_image() {
    let figure = ann();
    let [right, left] = [(false, 12.0), (true, -12.0)].map(|(left_first, degrees)| {
        let request = WalkRequest { left_first, ..request(110.0, 2, &[turning(4, degrees)]) };
        walk(&figure, &request).expect("it can be walked")
    });
    let nq = figure.layout().nq();
    let (mut a, mut b) = (vec![0.0; nq], vec![0.0; nq]);
    for k in 0..200 {
        let t = right.duration() * f64::from(k) / 200.0;
        right.configuration(t, &mut a);
        left.configuration(t, &mut b);
        // The root: x, y, z, then turns about z, y, x.
        let off = [a[0] + b[0], a[1] - b[1], a[2] - b[2], a[3] + b[3], a[4] + b[4], a[5] - b[5]];
        assert!(off.iter().all(|off| off.abs() < 1e-12), "{t}: {off:?}");
    }
    let ((a, turned), (b, back)) = (right.destination(), left.destination());
    assert!((turned + back).abs() < 1e-15 && (a.x + b.x).abs() < 1e-15 && (a.z - b.z).abs() < 1e-15);
}

#[test]
fn nothing_jumps_where_the_pace_changes() {
    let figure = ann();
    let plan = walk(&figure, &request(80.0, 4, &[WalkPart { turn: 0.3, ..paced(2, 110.0) }, paced(4, 90.0)]))
        .expect("it can be walked");
    let nq = figure.layout().nq();
    let at = |t: f64| {
        let mut q = vec![0.0; nq];
        plan.configuration(t, &mut q);
        q
    };
    // Velocities just before and after: every contact, and in between.
    let h = 1e-6;
    let mut worst = 0.0_f64;
    for contact in contacts(&plan) {
        for part in [0.0, 0.12, 0.25, 0.37] {
            let t = contact + part;
            let (before, here, after) = (at(t - h), at(t), at(t + h));
            for i in 0..nq {
                let jump = (after[i] - here[i]) / h - (here[i] - before[i]) / h;
                worst = worst.max(jump.abs());
            }
        }
    }
    println!("greatest jump of a velocity {worst:.1e} rad/s");
    // An acceleration of 1000 rad/s² looks like 0.001 rad/s here.
    assert!(worst < 0.005);
}

#[test]
fn only_what_repeats_itself_has_a_loop() {
    let figure = ann();
    let stride =
        |request: &WalkRequest| walk(&figure, request).expect("it can be walked").stride_loop().is_some();
    assert!(stride(&request(100.0, 42, &[])) && stride(&request(125.0, 60, &[])));
    assert!(stride(&request(100.0, 42, &[paced(3, 90.0)])));
    assert!(!stride(&request(80.0, 20, &[paced(22, 100.0)])));
    assert!(!stride(&request(100.0, 22, &[turning(20, 2.0)])));
    let turned =
        walk(&figure, &request(100.0, 42, &[])).expect("it can be walked").moved(Vector3::zeros(), 1.0);
    assert!(turned.expect("a person who faces to the side").stride_loop().is_none());
    // A root that turns about z first cannot face back.
    let back = walk(&figure, &request(100.0, 4, &[])).expect("it can be walked").moved(Vector3::x(), 3.0);
    assert!(matches!(back, Err(RequestError::TurnInAll { .. })));
}

#[test]
fn a_time_that_is_none_gives_no_posture() {
    let figure = ann();
    let plan = walk(&figure, &request(80.0, 3, &[paced(3, 100.0)])).expect("it can be walked");
    let mut q = vec![0.0; figure.layout().nq()];
    plan.configuration(f64::NAN, &mut q);
    assert!(q[0].is_nan() && plan.clock_at(f64::NAN).is_nan());
}

#[test]
fn what_cannot_be_walked_is_refused_with_its_part() {
    let figure = ann();
    let refused = |request: &WalkRequest| walk(&figure, request).err().expect("a refusal").to_string();
    let mut distance = request(100.0, 1, &[more(3)]);
    distance.extent = Extent::Distance(4.0);
    let answers = [
        refused(&request(100.0, 3, &[paced(3, 200.0)])),
        refused(&request(100.0, 3, &[more(3), WalkPart { step_length: Some(1.2), ..paced(2, 100.0) }])),
        refused(&request(100.0, 3, &[more(0)])),
        refused(&request(100.0, 3, &[turning(2, 40.0)])),
        refused(&request(100.0, 3, &[turning(2, f64::NAN)])),
        refused(&request(100.0, 3, &[turning(5, 20.0)])),
        refused(&WalkRequest { turn: f64::INFINITY, ..request(100.0, 3, &[]) }),
        refused(&request(100.0, 9_000, &[more(2_000)])),
        refused(&distance),
        refused(&request(100.0, 600, &[more(401), paced(2, 90.0)])),
        refused(&request(120.0, 5, &[WalkPart { turn: 0.52, ..paced(2, 120.0) }, paced(5, 120.0)])),
    ];
    insta::assert_snapshot!(answers.join("\n"));
    let error = walk(&figure, &request(100.0, 3, &[paced(3, 10.0)])).err().expect("a refusal");
    assert!(matches!(error, GaitError::InPart { number: 2, .. }));
}
