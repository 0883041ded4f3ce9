//! Runs that come out of a walk and go over into one, by laws that know no plan.

use super::random::Random;
use super::running_changes::{off, planned};
use solaris_gait::{
    Extent, GaitError, RUN_FRICTION, RunEnd, RunPlan, RunRequest, RunWalk, StyledPlan, WalkRequest, Walking,
    least_run_steps, measure, run, walk,
};
use solaris_model::{EventKind, Figure, Trajectory, human};

fn walking(steps: usize, speed: f64) -> RunEnd {
    RunEnd::Walking(RunWalk { steps, speed: Some(speed) })
}

fn request(speed: f64, steps: usize, from: RunEnd, to: RunEnd) -> RunRequest {
    RunRequest { speed, extent: Extent::Steps(steps), from, to, ..RunRequest::default() }
}

/// People and requests: out of a walk, into one, and both, with either foot first.
fn all() -> Vec<(Figure, RunRequest)> {
    let person = |height: f64, mass: f64| human(height, mass).expect("a person");
    vec![
        (person(1.75, 73.0), request(3.0, 14, walking(4, 1.6), walking(4, 1.6))),
        (person(1.75, 73.0), request(2.2, 8, walking(3, 1.2), RunEnd::Standing)),
        (person(1.6, 55.0), request(2.0, 7, walking(5, 1.3), walking(3, 1.1))),
        (person(1.6, 55.0), request(2.4, 9, RunEnd::Standing, walking(6, 1.5))),
        (
            person(1.9, 95.0),
            RunRequest { left_first: true, ..request(2.6, 9, walking(4, 1.75), RunEnd::Running) },
        ),
        (
            person(1.9, 95.0),
            RunRequest { left_first: true, ..request(2.0, 6, RunEnd::Running, walking(4, 1.4)) },
        ),
    ]
}

/// The body needs what the laws prescribe: within 6 % of its weight for a frame or two where pieces join in the walks, which are not sampled at
/// their own nodes, and within 3 % in flight.
#[test]
fn the_body_needs_the_prescribed_forces() {
    for (figure, request) in all() {
        let plan = planned(&figure, &request);
        let [stance, flight] = off(&figure, &plan).map(|force| force / plan.weight());
        println!("{request:?}: {stance:.4} and in flight {flight:.4} of the weight");
        assert!(stance < 6e-2 && flight < 3e-2, "{request:?}: {stance} {flight}");
    }
}

/// Planted points stand, soles stay above the ground, knees bend the right way, forces hold and press inside of the soles.
#[test]
fn soles_and_knees_do_what_they_can() {
    for (figure, request) in all() {
        let plan = planned(&figure, &request);
        let height = plan.stature();
        let (motion, _) = StyledPlan::Run(Box::new(plan)).loaded(&figure, 240.0).expect("forces");
        let found = measure(&figure, &motion).expect("measures").extremes;
        println!(
            "{request:?}: slide {:.1e} m, sink {:.1e} m, friction {:.2}, knee {:.1}°, pressure {:.1e} m outside",
            found.slide.value,
            found.sink.value,
            found.foot_friction.value,
            found.least_knee.value.to_degrees(),
            found.cop_outside.value
        );
        assert!(found.slide.value < 1e-4 && found.sink.value < 1e-3);
        assert!(found.foot_friction.value < RUN_FRICTION && found.least_knee.value > 0.0);
        assert!(found.cop_outside.value < 0.0125 * height);
    }
}

/// The times (s) at which a walk ends and begins: the seams, where the planner changes.
fn seams(plan: &RunPlan, figure: &Figure, from: RunWalk) -> f64 {
    // The walk by itself, planned on far enough that the step in question is like the others.
    let alone =
        WalkRequest { speed: from.speed, extent: Extent::Steps(from.steps + 5), ..WalkRequest::default() };
    let alone = walk(figure, &alone).expect("a walk");
    let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
    let differs = |time: f64, a: &mut [f64], b: &mut [f64]| {
        plan.configuration(time, a);
        alone.configuration(time, b);
        a.iter().zip(b.iter()).any(|(a, b)| (a - b).abs() > 1e-12)
    };
    let (mut same, mut other) = (0.0, plan.duration());
    assert!(!differs(same, &mut a, &mut b) && differs(other, &mut a, &mut b));
    while other - same > 1e-9 {
        let middle = 0.5 * (same + other);
        if differs(middle, &mut a, &mut b) { other = middle } else { same = middle }
    }
    other
}

/// Until it runs it is the walk that [`walk`] plans, and postures, rates and accelerations go on over the seam.
#[test]
fn it_is_the_walk_and_goes_on_from_it() {
    let figure = human(1.75, 73.0).expect("a person");
    let from = RunWalk { steps: 4, speed: Some(1.6) };
    let plan = planned(&figure, &request(2.5, 8, RunEnd::Walking(from), RunEnd::Running));
    let seam = seams(&plan, &figure, from);
    // While one foot stands alone, after the fourth contact.
    let landed: Vec<f64> = plan
        .events()
        .iter()
        .filter(|event| matches!(event.kind, EventKind::TouchDown { .. }))
        .map(|event| event.time)
        .collect();
    assert!(landed[3] < seam && seam < landed[4], "{seam} {landed:?}");
    let nq = figure.layout().nq();
    let at = |time: f64| {
        let mut q = vec![0.0; nq];
        plan.configuration(time, &mut q);
        q
    };
    // Differences of second order to either side.
    let h = 1e-3;
    let rows: Vec<Vec<f64>> = (-4..=4).map(|k| at(seam + h * f64::from(k))).collect();
    let (mut jump, mut rate, mut acceleration) = (0.0_f64, 0.0_f64, 0.0_f64);
    for k in 0..nq {
        let q: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        let rates = |o: [f64; 3]| (-1.5 * o[0] + 2.0 * o[1] - 0.5 * o[2]) / h;
        let bends = |o: [f64; 4]| (2.0 * o[0] - 5.0 * o[1] + 4.0 * o[2] - o[3]) / (h * h);
        jump = jump.max((q[4] - q[3] - (q[5] - q[3]) / 2.0).abs());
        rate = rate.max((rates([q[4], q[5], q[6]]) + rates([q[4], q[3], q[2]])).abs());
        acceleration =
            acceleration.max((bends([q[4], q[5], q[6], q[7]]) - bends([q[4], q[3], q[2], q[1]])).abs());
    }
    println!("at {seam} s: {jump:.1e} rad, {rate:.1e} rad/s, {acceleration:.1e} rad/s²");
    assert!(jump < 2e-4 && rate < 0.05 && acceleration < 25.0, "{jump} {rate} {acceleration}");
}

/// Feet land in turn; each but the first and the last stance begins and ends.
#[test]
fn feet_land_in_turn() {
    for (figure, request) in all() {
        let plan = planned(&figure, &request);
        let mut landed = Vec::new();
        for event in plan.events() {
            if let EventKind::TouchDown { link } = event.kind {
                landed.push(link);
            }
        }
        assert!(landed.windows(2).all(|pair| pair[0] != pair[1]), "{request:?}: {landed:?}");
        let steps = |end: RunEnd| if let RunEnd::Walking(walk) = end { walk.steps } else { 0 };
        let Extent::Steps(run) = request.extent else { unreachable!("steps") };
        assert_eq!(plan.steps(), steps(request.from) + run + steps(request.to), "{request:?}");
        let prints: Vec<f64> = plan.prints().collect();
        assert!(prints.windows(2).all(|pair| pair[1] > pair[0]), "{request:?}: {prints:?}");
    }
}

#[test]
fn what_does_not_go_is_refused() {
    let figure = human(1.75, 73.0).expect("a person");
    let refused = |request: RunRequest| run(&figure, &request).map(|_| ()).expect_err("no run").to_string();
    for (steps, speed, why) in [
        (2, 1.4, "a walk of 2 steps beside a run; it must be 3 to 30"),
        (31, 1.4, "a walk of 31 steps beside a run; it must be 3 to 30"),
        (
            4,
            0.8,
            "a walk at 0.8 m/s beside a run; it must be 0.95 m/s at least: a slower one has no way into a flight",
        ),
        (
            4,
            f64::NAN,
            "a walk at NaN m/s beside a run; it must be 0.95 m/s at least: a slower one has no way into a flight",
        ),
        (4, 1.7, "a run at 1.5 m/s beside a walk at 1.70 m/s; it must be no slower than the walk"),
    ] {
        assert_eq!(refused(request(1.5, 8, walking(steps, speed), RunEnd::Running)), why);
        assert_eq!(refused(request(1.5, 8, RunEnd::Running, walking(steps, speed))), why);
    }
    let fast = refused(request(3.0, 12, walking(4, 2.5), RunEnd::Running));
    assert!(fast.starts_with("of the walk beside the run: step frequency"), "{fast}");
    let few = refused(request(3.0, 3, walking(4, 1.5), RunEnd::Running));
    assert!(few.contains("takes 5 at least"), "{few}");
}

/// Random people of 1.45 to 1.95 m, walks from the slowest to the fastest beside runs up to 4.5 m/s, before them, after them and both: at most one
/// in twenty is refused, and of those that are planned none slides, sinks, bends a
/// knee back, needs more friction than soles have or presses beside them.
fn obey(count: usize, seed: u64) {
    let mut random = Random(seed);
    let (mut planned, mut refused) = (0, 0);
    while planned + refused < count {
        let height = random.within(1.45, 1.95);
        let figure = human(height, random.within(18.0, 30.0) * height * height).expect("a person");
        let scale = (height / 1.75).sqrt();
        let slow = scale * random.within(0.95, 1.8);
        let speed = (slow + random.within(0.1, 3.0)).min(4.5);
        let walk = walking(3 + random.pick(4), slow);
        let (from, to) = match random.pick(3) {
            0 => (walk, RunEnd::Running),
            1 => (RunEnd::Running, walk),
            _ => (walk, walk),
        };
        let steps = least_run_steps(speed, from, to) + random.pick(5);
        let request = RunRequest { left_first: random.often(0.5), ..request(speed, steps, from, to) };
        let plan = match run(&figure, &request) {
            Ok(plan) => plan,
            // Too fast a walk for these legs.
            Err(GaitError::BesideRun { .. }) => continue,
            Err(why) => {
                println!("{height:.2} m, {request:?}: {why}");
                refused += 1;
                continue;
            }
        };
        planned += 1;
        let (motion, _) = StyledPlan::Run(Box::new(plan)).loaded(&figure, 240.0).expect("forces");
        let found = measure(&figure, &motion).expect("measures").extremes;
        assert!(
            found.slide.value < 1e-4
                && found.sink.value < 1e-3
                && found.least_knee.value > -0.5_f64.to_radians()
                && found.foot_friction.value < RUN_FRICTION
                && found.cop_outside.value < 0.0125 * height,
            "{height} m, {request:?}: {found:?}"
        );
    }
    println!("{planned} planned, {refused} refused");
    assert!(20 * refused <= count, "{refused} refused of {count}");
}

#[test]
fn random_walks_beside_runs_obey() {
    obey(24, 1991);
}

/// With `cargo lab gaits`.
#[test]
#[ignore = "long: cargo xtask nightly"]
fn thousands_of_walks_beside_runs_obey() {
    obey(1000, 2026);
}
