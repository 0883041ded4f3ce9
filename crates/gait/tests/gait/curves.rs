//! Walks round bends, on the spot and along paths: planted points, friction, pressure, limbs that pass each other, and a heading that
//! goes on.

use crate::support::Walked;
use solaris_analysis::{ground_reactions, nearness};
use solaris_gait::{Extent, FEET, FRICTION, WalkPart, WalkPath, WalkPlan, WalkRequest, measure, walk};
use solaris_model::{Figure, Human, RootOrder, Trajectory, human};
use std::f64::consts::{PI, TAU};

fn walker(height: f64) -> Figure {
    Human::new(height, 23.8 * height * height).root(RootOrder::Yzx).build().expect("a person")
}

fn circle(radius: f64, turns: f64) -> Vec<[f64; 2]> {
    let points = 1..=(48.0 * turns) as usize;
    let at = |angle: f64| [radius * (1.0 - angle.cos()), radius * angle.sin()];
    points.map(|k| at(k as f64 * TAU / 48.0)).collect()
}

fn along(points: &[[f64; 2]], step_frequency: f64) -> WalkRequest {
    let path = WalkPath::through(points).expect("a way");
    let left_first = path.begins() > 0.0;
    let step_frequency = Some(step_frequency);
    WalkRequest { step_frequency, left_first, path: Some(path), ..WalkRequest::default() }
}

/// So many steps of a length (m; people's for none), each turning by so much (degrees), the inner foot first.
fn turning(steps: usize, degrees: f64, length: Option<f64>, step_frequency: f64) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        step_length: length,
        extent: Extent::Steps(steps),
        turn: degrees.to_radians(),
        left_first: degrees > 0.0,
        ..WalkRequest::default()
    }
}

/// What every walk keeps, and how far limbs go into each other at most (m).
fn keeps_the_laws(name: &str, figure: &Figure, request: &WalkRequest, limbs: f64) -> WalkPlan {
    let plan = walk(figure, request).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut motion = plan.motion(figure, 120.0).expect("sampled");
    let report = ground_reactions(figure, &mut motion, FEET, &plan).expect("forces");
    let prescribed = report.from_prescribed.expect("prescribed").value / plan.weight();
    let walk = measure(figure, &motion).expect("measured").extremes;
    let near = nearness(figure, &motion).expect("measured").expect("limbs").limbs(figure, motion.time());
    println!(
        "{name}: forces {:.1} %BW from those prescribed; friction {:.2}; sink {:.2} mm, pressed outside by {:.1} mm, least knee {:.1}°; \
         nearest limbs {:.1} mm, {:?}",
        100.0 * prescribed,
        walk.foot_friction.value,
        1e3 * walk.sink.value,
        1e3 * walk.cop_outside.value,
        walk.least_knee.value.to_degrees(),
        1e3 * near.distance,
        near.links
    );
    assert!(prescribed < 0.05, "{name}");
    assert!(walk.friction.value < FRICTION.0 && walk.foot_friction.value < FRICTION.1, "{name}");
    // As far as a leg may be too short for its foot, where the other one closes beside it.
    assert!(walk.slide.value < 1e-4 && walk.sink.value < 1e-3, "{name}");
    assert!(walk.cop_outside.value < 5e-3 && walk.clearance.value > 0.005, "{name}");
    assert!(walk.least_knee.value > -1.0_f64.to_radians(), "{name}");
    assert!(near.distance > -limbs, "{name}: {:?} by {} m", near.links, -near.distance);
    plan
}

#[test]
fn bends_of_any_radius_keep_the_laws() {
    let figure = walker(1.75);
    for step_frequency in [90.0, 100.0, 110.0] {
        for (name, points) in [
            ("a corner", vec![[0.0, 3.0], [3.0, 3.0]]),
            ("a U-turn", vec![[0.0, 3.0], [1.2, 3.0], [1.2, 0.0]]),
            ("there and back", vec![[0.0, 2.0], [0.0, 0.0]]),
            ("to and fro", vec![[0.5, 1.0], [-0.5, 2.0], [0.5, 3.0], [0.0, 5.0]]),
            ("a circle of 2 m", circle(2.0, 1.0)),
            ("a circle of 1 m", circle(1.0, 1.0)),
            ("two circles of 0.5 m", circle(0.5, 2.0)),
        ] {
            let plan = keeps_the_laws(
                &format!("{name}, {step_frequency}/min"),
                &figure,
                &along(&points, step_frequency),
                0.012,
            );
            let (place, last) = (plan.destination().0, points[points.len() - 1]);
            assert!((place.x - last[0]).hypot(place.z - last[1]) < 1e-9, "{name}");
        }
    }
}

#[test]
fn turning_on_the_spot_keeps_the_laws() {
    for (height, step_frequency) in [(1.75, 70.0), (1.75, 90.0), (1.6, 85.0), (1.9, 80.0)] {
        for (steps, degrees) in [(6, 30.0), (9, -20.0), (12, 30.0)] {
            let name = format!("{height} m, {steps} steps of {degrees}°, {step_frequency}/min");
            let request = turning(steps, degrees, Some(0.0), step_frequency);
            let plan = keeps_the_laws(&name, &walker(height), &request, 0.024);
            let (place, heading) = plan.destination();
            assert!(place.norm() < 1e-12 && (heading - steps as f64 * degrees.to_radians()).abs() < 1e-12);
        }
    }
}

#[test]
fn the_heading_goes_on_over_several_turns() {
    let figure = walker(1.75);
    let plan = walk(&figure, &turning(54, 20.0, Some(0.35), 95.0)).expect("three turns");
    let heading = figure.layout().q_names().iter().position(|name| name == "root.ry").expect("a heading");
    let q = |t: f64| {
        let mut q = vec![0.0; figure.layout().nq()];
        plan.configuration(t, &mut q);
        q
    };
    // No value jumps, and neither do the first two derivatives: differences over half the step are a quarter of the whole one's.
    let (h, n) = (1e-3, (plan.duration() / 1e-3) as usize);
    let of = |t: f64| q(t)[heading];
    let mut rate = 0.0_f64;
    for k in (2..n - 2).step_by(7) {
        let t = h * k as f64;
        let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|i: f64| of(t + i * h));
        assert!((d - b).abs() < 8.0 * h, "{t} s: it turns by {} rad", d - b);
        rate = rate.max(((d - b) / (2.0 * h)).abs());
        let [before, after] = [(a - 2.0 * b + c) / (h * h), (c - 2.0 * d + e) / (h * h)];
        assert!((after - before).abs() < 2.0, "{t} s: its acceleration jumps by {}", after - before);
    }
    let (first, last) = (of(0.0), of(plan.duration()));
    assert!((last - first - 6.0 * PI).abs() < 1e-6 && rate < 2.5, "{first} to {last}, {rate} rad/s");
}

#[test]
fn both_roots_walk_the_same_walk() {
    let (usual, yzx) = (human(1.75, 73.0).expect("a person"), Human::new(1.75, 73.0).root(RootOrder::Yzx));
    let yzx = yzx.build().expect("a person");
    let corner = WalkPart { steps: 3, turn: 0.35, ..WalkPart::default() };
    let request = WalkRequest { extent: Extent::Steps(4), then: vec![corner], ..WalkRequest::default() };
    let [a, b] = [&usual, &yzx].map(|figure| walk(figure, &request).expect("it can be walked"));
    let mut apart = 0.0_f64;
    for k in 0..60 {
        let t = 0.1 * f64::from(k);
        let [one, other] = [(&usual, &a), (&yzx, &b)].map(|(figure, plan)| {
            let mut q = vec![0.0; figure.layout().nq()];
            plan.configuration(t, &mut q);
            Walked::poses(figure, &q)
        });
        for ((place, turn), (place_too, turn_too)) in one.iter().zip(&other) {
            apart = apart.max((place - place_too).norm()).max((turn.matrix() - turn_too.matrix()).norm());
        }
    }
    println!("links of both figures are {apart:.1e} apart");
    assert!(apart < 1e-12);
}

#[test]
fn steps_lead_along_the_way() {
    let plan = walk(&walker(1.75), &along(&circle(1.0, 1.0), 95.0)).expect("a circle");
    let motion = plan.motion(&walker(1.75), 120.0).expect("sampled");
    // The heels are planted near the circle: half a step width beside it, the foot's middle on its line.
    let heels = motion.planted.iter().filter(|planted| planted.point.z < 0.0 && planted.start > 0.0);
    let mut count = 0;
    for heel in heels {
        let mut q = vec![0.0; motion.q(0).len()];
        plan.configuration(heel.start + 0.2, &mut q);
        let (place, turn) = Walked::poses(&walker(1.75), &q)[heel.link];
        let at = place + turn * heel.point;
        let off = (at.x - 1.0).hypot(at.z) - 1.0;
        assert!(off.abs() < 0.09, "{off} m beside the circle at {:.2} s", heel.start);
        count += 1;
    }
    assert!((15..=25).contains(&count), "{count} steps");
}

#[test]
fn what_cannot_be_walked_round_is_refused() {
    let yzx = walker(1.75);
    let refused = |figure: &Figure, request: &WalkRequest| walk(figure, request).err().expect("a refusal");
    let usual = human(1.75, 73.0).expect("a person");
    let error = refused(&usual, &turning(8, 20.0, None, 95.0));
    assert!(error.turns_too_far() && error.to_string().contains("root: Yzx"), "{error}");
    let error = refused(&usual, &along(&circle(1.0, 1.0), 95.0));
    assert!(error.turns_too_far(), "{error}");
    let path = along(&[[0.0, 3.0]], 95.0);
    let twice = refused(&yzx, &WalkRequest { turn: 0.1, ..path.clone() });
    assert!(twice.to_string().contains("path"), "{twice}");
    let fast = refused(&yzx, &WalkRequest { step_frequency: Some(120.0), ..path });
    assert!(fast.to_string().contains("110"), "{fast}");
    assert!(refused(&yzx, &turning(4, 40.0, Some(0.0), 90.0)).to_string().contains("30"));
    assert!(refused(&yzx, &turning(4, 0.0, Some(0.0), 90.0)).to_string().contains("step length"));
}

#[test]
fn a_stride_is_measured_alike_whichever_way_the_root_turns() {
    let request =
        WalkRequest { step_frequency: Some(100.0), extent: Extent::Steps(12), ..WalkRequest::default() };
    let [a, b] = [RootOrder::Zyx, RootOrder::Yzx].map(|order| {
        let figure = Human::new(1.75, 73.0).root(order).build().expect("a person");
        let plan = walk(&figure, &request).expect("a walk");
        let mut motion = plan.motion(&figure, 120.0).expect("sampled");
        ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        measure(&figure, &motion).expect("measured").steady.expect("a steady stride")
    });
    for (one, other) in [
        (a.pelvic_rotation, b.pelvic_rotation),
        (a.pelvic_obliquity, b.pelvic_obliquity),
        (a.pelvic_tilt, b.pelvic_tilt),
        (a.hip_extensor, b.hip_extensor),
        (a.second_peak, b.second_peak),
    ] {
        assert!((one - other).abs() < 1e-6 * one.abs(), "{one} {other}");
    }
}
