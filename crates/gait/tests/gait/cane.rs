//! A cane in a hand: its tip stands, it is as long as it is, it bears what it is asked to along itself, and the laws hold with it, judged by the
//! motion's own inverse dynamics.

use super::load::walked;
use super::random::Random;
use solaris_gait::{
    CANE, CANE_LOADS, ChairRequest, Extent, FEET, FRICTION, RunRequest, StyleSheet, WalkGround, WalkRequest,
    WalkSegment, WalkSequence, Walker, chair, helped_side, measure, run, walk,
};
use solaris_model::{Figure, Human, Motion, RootOrder, Trajectory, Vector3};

fn walker(height: f64, hand: &str) -> Figure {
    let human = Human::new(height, 23.8 * height * height).root(RootOrder::Yzx);
    human.cane(hand).build().expect("a person with a cane")
}

fn request(figure: &Figure, step_frequency: f64) -> WalkRequest {
    WalkRequest {
        step_frequency: Some(step_frequency),
        left_first: helped_side(figure) == Some(0),
        ..WalkRequest::default()
    }
}

/// Fist and tip of the cane in a frame.
fn cane(figure: &Figure, motion: &Motion, frame: usize) -> [Vector3<f64>; 2] {
    let link = figure.link_index(CANE).expect("a cane");
    let place = figure.places(motion.q(frame))[link];
    let tip = figure.links()[link].tip().expect("a tip");
    [place.translation.vector, (place * nalgebra::Point3::from(*tip)).coords]
}

/// What the ground does in a frame, of feet and cane together.
fn force(motion: &Motion, frame: usize) -> Vector3<f64> {
    motion.contacts.iter().map(|track| track.samples[frame].force).sum()
}

#[test]
fn whoever_walks_with_a_cane_obeys_the_laws() {
    for (height, hand, step_frequency, turn, load) in [
        (1.75, "right", 85.0, 0.0, None),
        (1.6, "left", 70.0, 0.2, Some(0.25)),
        (1.9, "right", 100.0, -0.3, Some(0.1)),
        (1.2, "left", 110.0, 0.0, Some(0.2)),
    ] {
        let figure = walker(height, hand);
        let asked = WalkRequest { turn, cane_load: load, ..request(&figure, step_frequency) };
        let (plan, motion) = walked(&figure, &asked);
        let found = measure(&figure, &motion).expect("measured").extremes;
        let who = format!("{height} m, {hand}, {step_frequency}: {found:?}");
        assert!(found.slide.value < 1e-4 && found.sink.value < 1e-3, "{who}");
        assert!(found.cop_outside.value < 5e-3 && found.least_knee.value > 0.0, "{who}");
        assert!(found.friction.value < FRICTION.0 && found.foot_friction.value < FRICTION.1, "{who}");

        let length = figure.link(CANE).and_then(|link| link.tip()).expect("a tip").norm();
        let track = motion.contacts.iter().find(|track| track.link == CANE).expect("a track");
        let mut most = 0.0_f64;
        for (frame, contact) in track.samples.iter().enumerate() {
            let [fist, tip] = cane(&figure, &motion, frame);
            let law = plan.cane(plan.clock_at(motion.time()[frame])).expect("a cane");
            assert!(law.force == Vector3::zeros() || (law.cop - tip).norm() < 1e-9, "{who}: {tip}");
            // Seen from the side the fist is between shoulder and tip, unless it is out of reach.
            assert!(((fist - tip).norm() - length).abs() < 1e-12 && tip.y > -1e-9, "{who}");
            let [shoulder, thorax] = ["upper_arm", "thorax"].map(|name| {
                let name = if name == "thorax" { name.to_owned() } else { format!("{hand}_{name}") };
                figure.places(motion.q(frame))[figure.link_index(&name).expect("a link")]
            });
            let aside = thorax.rotation * Vector3::x();
            let from = shoulder.translation.vector;
            let across = (fist - from).cross(&(tip - from)).dot(&aside);
            assert!(across.abs() < 1e-9, "{who}: {across}");
            if contact.force == Vector3::zeros() {
                continue;
            }
            let tilted = contact.force.x.hypot(contact.force.z) / contact.force.y;
            assert!(tilted < FRICTION.0, "{who}: {tilted}");
            // Along the cane, at its tip on the ground.
            assert!((contact.cop - tip).norm() < 1e-9 && tip.y < 1e-9, "{who}: {tip}");
            assert!(contact.force.cross(&(fist - tip)).norm() < 1e-7 * contact.force.norm(), "{who}");
            most = most.max(contact.force.y / force(&motion, frame).y);
        }
        assert!((most - load.unwrap_or(0.15)).abs() < 5e-3, "{who}: {most}");
        // The tip stays where it is planted, and the others' share of the weight is the feet's.
        let link = figure.link_index(CANE).expect("a cane");
        let planted: Vec<_> = motion.planted.iter().filter(|planted| planted.link == link).collect();
        assert!(planted.len() >= plan.steps() / 2, "{who}: {planted:?}");
        for planted in planted {
            let frames = |time: &f64| (planted.start..=planted.end).contains(time);
            let tips: Vec<_> = (0..motion.len())
                .filter(|frame| frames(&motion.time()[*frame]))
                .map(|frame| cane(&figure, &motion, frame)[1])
                .collect();
            assert!(tips.iter().all(|tip| (tip - tips[0]).norm() < 1e-9), "{who}");
        }
    }
}

/// By how much (N) feet and cane miss what the body's own momentum asks for, m c̈ = F + m g, at a motion's samples.
fn unbalanced(figure: &Figure, motion: &Motion) -> f64 {
    let com = |frame: usize| {
        let places = figure.places(motion.q(frame));
        let of = |(link, place): (&solaris_model::Link, &solaris_model::Isometry3<f64>)| {
            (place * nalgebra::Point3::from(*link.com())).coords * link.mass()
        };
        figure.links().iter().zip(&places).map(of).sum::<Vector3<f64>>()
    };
    let (rate, weight) = (motion.info.rate, figure.mass() * motion.info.gravity);
    let seven = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0];
    let at = |frame: usize| {
        let sum: Vector3<f64> = seven.iter().zip(frame - 3..).map(|(w, at)| com(at) * *w).sum();
        (sum * (rate * rate / 180.0) - weight - force(motion, frame)).norm()
    };
    (3..motion.len() - 3).step_by(7).map(at).fold(0.0, f64::max)
}

#[test]
fn the_ground_carries_the_body_with_its_cane() {
    let figure = walker(1.75, "left");
    let usual = || request(&figure, 90.0);
    let limp = solaris_gait::side_sheet_of("limp").expect("a manner");
    for (name, asked) in [
        ("straight on", usual()),
        ("the other foot first", WalkRequest { left_first: !usual().left_first, ..usual() }),
        ("in a bend", WalkRequest { turn: -0.25, extent: Extent::Steps(7), ..usual() }),
        ("repeated", WalkRequest { extent: Extent::Steps(50), ..usual() }),
        ("backward", WalkRequest { backward: true, extent: Extent::Steps(4), ..usual() }),
        ("a limp", WalkRequest { sides: [StyleSheet::default(), limp], ..usual() }),
        ("one step", WalkRequest { extent: Extent::Steps(1), ..usual() }),
    ] {
        let plan = walk(&figure, &asked).unwrap_or_else(|error| panic!("{name}: {error}"));
        // At the nodes' own distance, at which the plan is differenced.
        let mut motion = plan.motion(&figure, 1.0 / plan.resolution()).expect("sampled");
        solaris_analysis::ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let beside = unbalanced(&figure, &motion);
        assert!(beside < 1e-5, "{name}: {beside} N");
        assert_eq!(motion.contacts.len(), 3, "{name}");
        // Whichever foot the forces are computed from.
        let rooted =
            solaris_analysis::reactions_from_feet(&figure, &mut motion, FEET).expect("from the feet");
        assert!(rooted.torque < 1e-8 && rooted.reaction_force < 1e-8, "{name}: {rooted:?}");
    }
}

#[test]
fn a_stride_with_a_cane_repeats_itself_and_walks_follow_each_other() {
    let figure = walker(1.75, "right");
    let long = WalkRequest { extent: Extent::Steps(42), ..request(&figure, 90.0) };
    let plan = walk(&figure, &long).expect("a walk");
    let stride = plan.stride_loop().expect("a stride");
    let mut motion = stride.balanced_motion(&figure, 120.0).expect("sampled");
    let report = solaris_analysis::ground_reactions(&figure, &mut motion, FEET, &stride).expect("forces");
    assert!(report.from_prescribed.expect("prescribed").value < 0.02 * plan.weight(), "{report:?}");
    let bears = motion.contacts.iter().find(|track| track.link == CANE).expect("a cane");
    let most = bears.samples.iter().map(|cane| cane.force.y).fold(0.0, f64::max);
    assert!(most > 0.12 * plan.weight(), "{most}");

    let short = WalkRequest { extent: Extent::Steps(3), ..request(&figure, 90.0) };
    let segments = [WalkSegment::Walk(short.clone()), WalkSegment::Stand(0.5), WalkSegment::Walk(short)];
    let journey = WalkSequence::new(&figure, &segments).expect("two walks");
    let mut motion = journey.motion(&figure, 240.0).expect("sampled");
    solaris_analysis::ground_reactions(&figure, &mut motion, FEET, &journey).expect("forces");
    let tips: Vec<_> = (0..motion.len()).map(|frame| cane(&figure, &motion, frame)[1]).collect();
    let jump = tips.windows(2).map(|pair| (pair[1] - pair[0]).norm()).fold(0.0, f64::max);
    assert!(jump < 0.03, "{jump} m in a frame");
    // Standing in between nothing moves, and nothing rests on it.
    let stands =
        motion.time().partition_point(|time| *time < journey.walks().next().expect("one").duration());
    assert!((tips[stands] - tips[stands + 60]).norm() < 1e-9);
}

#[test]
fn a_cane_helps_the_hip_of_the_other_side() {
    let figure = walker(1.75, "right");
    let alone = Human::new(1.75, 23.8 * 1.75 * 1.75).root(RootOrder::Yzx).build().expect("a person");
    let peak = |figure: &Figure, load: Option<f64>| {
        let asked = WalkRequest { cane_load: load, ..request(&walker(1.75, "right"), 80.0) };
        let (_, motion) = walked(figure, &asked);
        let at =
            |name: &str| figure.layout().v_names().iter().position(|known| known == name).expect("a joint");
        let middle = motion.len() / 3..2 * motion.len() / 3;
        let most = |dof: usize| {
            middle.clone().map(|frame| motion.tau(frame).expect("forces")[dof].abs()).fold(0.0, f64::max)
        };
        [most(at("left_hip.rz")), most(at("right_hip.rz"))]
    };
    let [left, right] = peak(&alone, None);
    let mut before = peak(&figure, Some(0.0));
    assert!((before[0] / left - 1.0).abs() < 0.03 && (before[1] / right - 1.0).abs() < 0.05, "{before:?}");
    // Peak moments about the hip fall with what the cane bears (docs/manners.md).
    for load in [0.10, 0.15, 0.20] {
        let now = peak(&figure, Some(load));
        assert!(now[0] < before[0] - 0.02 * left, "{load}: {now:?} after {before:?}");
        assert!((now[1] / right - 1.0).abs() < 0.08, "{load}: {now:?}");
        before = now;
    }
    assert!((0.5..0.7).contains(&(before[0] / left)), "{before:?} of {left}");
}

#[test]
fn the_other_hand_is_the_mirror_image() {
    let [left, right] = ["left", "right"].map(|hand| {
        let figure = walker(1.75, hand);
        let (_, motion) = walked(&figure, &request(&figure, 95.0));
        (figure, motion)
    });
    let column = |figure: &Figure, name: &str| {
        figure.layout().v_names().iter().position(|known| known == name).expect("a coordinate")
    };
    for (name, other, sign) in [
        ("left_elbow.rx", "right_elbow.rx", 1.0),
        ("cane.rx", "cane.rx", 1.0),
        ("cane.rz", "cane.rz", -1.0),
        ("root.tx", "root.tx", -1.0),
        ("left_knee.rx", "right_knee.rx", 1.0),
    ] {
        let (a, b) = (column(&left.0, name), column(&right.0, other));
        for frame in (0..left.1.len()).step_by(11) {
            let [a, b] = [left.1.q(frame)[a], sign * right.1.q(frame)[b]];
            assert!((a - b).abs() < 1e-9, "{name} at {frame}: {a} {b}");
        }
    }
}

#[test]
fn what_a_cane_cannot_do_is_refused() {
    let figure = walker(1.75, "right");
    let refused = |asked: WalkRequest| walk(&figure, &asked).err().expect("refused").to_string();
    let usual = || request(&figure, 90.0);
    for load in [-0.01, 0.26, f64::NAN] {
        let error = refused(WalkRequest { cane_load: Some(load), ..usual() });
        assert!(error.contains("cane load") && error.contains("0 to 0.25 of the vertical force"), "{error}");
    }
    for load in [CANE_LOADS.0, CANE_LOADS.1] {
        assert!(walk(&figure, &WalkRequest { cane_load: Some(load), ..usual() }).is_ok());
    }
    let error = refused(WalkRequest { ground: WalkGround::Slope(0.1), ..usual() });
    assert!(error.contains("holds a cane") && error.contains("level"), "{error}");
    let error = refused(WalkRequest { step_frequency: Some(130.0), ..usual() });
    assert!(error.contains("reach its cane"), "{error}");
    let alone = Human::new(1.75, 73.0).build().expect("a person");
    let error = walk(&alone, &WalkRequest { cane_load: Some(0.1), ..usual() }).err().expect("refused");
    assert!(error.to_string().contains("holds no cane"), "{error}");
    for error in [
        run(&figure, &RunRequest::default()).err().map(|error| error.to_string()),
        chair(&figure, &ChairRequest::default()).err().map(|error| error.to_string()),
        Walker::new(&figure).err().map(|error| error.to_string()),
    ] {
        let error = error.expect("refused");
        assert!(error.contains("holds a cane"), "{error}");
    }
}

#[test]
fn many_with_a_cane_obey_the_laws() {
    let held = held_of(40, 7);
    assert!(held >= 34, "{held} of 40");
}

/// What docs/manners.md says of it.
#[test]
#[ignore = "400 walks: cargo xtask nightly"]
fn hundreds_with_a_cane_obey_the_laws() {
    println!("{} of 400 are walked", held_of(400, 1));
}

/// How many random walks of so many are walked, of which none breaks a law.
fn held_of(all: usize, seed: u64) -> usize {
    let mut random = Random(seed);
    let mut held = 0;
    for i in 0..all {
        let hand = if random.often(0.5) { "left" } else { "right" };
        let figure = walker(random.within(1.1, 2.0), hand);
        let turn = if random.often(0.5) { 0.0 } else { random.within(-0.35, 0.35) };
        let usual = request(&figure, random.within(60.0, 120.0));
        let asked = WalkRequest {
            turn,
            extent: Extent::Steps(1 + random.pick(14)),
            cane_load: Some(random.within(0.0, 0.25)),
            left_first: usual.left_first ^ random.often(0.2),
            ..usual
        };
        let Ok(plan) = walk(&figure, &asked) else { continue };
        held += 1;
        let mut motion = plan.motion(&figure, 960.0).expect("sampled");
        solaris_analysis::ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        let found = measure(&figure, &motion).expect("measured").extremes;
        assert!(found.cop_outside.value < 5e-3 && found.slide.value < 1e-4, "{i}, {asked:?}: {found:?}");
    }
    held
}
