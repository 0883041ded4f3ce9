//! Runs that come out of a walk and go over into one, by laws that know no plan.

use super::random::Random;
use super::running_changes::{holds_together, off, planned};
use solaris_gait::{
    Extent, GaitError, Prescribing, RUN_FRICTION, RunEnd, RunPlan, RunRequest, RunWalk, StyledPlan,
    WalkRequest, Walking, least_run_steps, measure, run, walk,
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

#[test]
fn soles_and_knees_do_what_they_can() {
    for (figure, request) in all() {
        holds_together(&figure, planned(&figure, &request), &request);
    }
}

/// When (s) the plan is no longer the walk before the run, or again the walk after it; and by how much it differs from that walk at a time. The
/// walks by themselves are planned on, or begin earlier, so that the step in question is like the others.
fn seam<'a>(
    plan: &'a RunPlan,
    figure: &Figure,
    beside: RunWalk,
    before: bool,
) -> (f64, impl Fn(f64) -> Vec<f64> + use<'a>) {
    let nq = figure.layout().nq();
    // Either foot may be first.
    for left_first in [false, true] {
        let extent = Extent::Steps(beside.steps + 5);
        let alone = WalkRequest { speed: beside.speed, extent, left_first, ..WalkRequest::default() };
        let alone = walk(figure, &alone).expect("a walk");
        let later = if before { 0.0 } else { plan.duration() - alone.duration() };
        let differs = move |time: f64| {
            let (mut a, mut b) = (vec![0.0; nq], vec![0.0; nq]);
            plan.configuration(time, &mut a);
            alone.configuration(time - later, &mut b);
            // But for how far along.
            b[2] = a[2];
            a.iter().zip(&b).map(|(a, b)| a - b).collect::<Vec<f64>>()
        };
        let is_it = |time: f64| differs(time).iter().all(|by| by.abs() < 1e-9);
        if !is_it(if before { 1.0 } else { plan.duration() - 1.0 }) {
            continue;
        }
        let (mut walked, mut ran) = if before { (0.0, plan.duration()) } else { (plan.duration(), 0.0) };
        while (walked - ran).abs() > 1e-9 {
            let middle = 0.5 * (walked + ran);
            if is_it(middle) { walked = middle } else { ran = middle }
        }
        return (ran, differs);
    }
    panic!("it is neither walk");
}

/// Beside the run it is the walk that [`walk`] plans, and it leaves it at the seams without a rate or an acceleration.
#[test]
fn it_is_the_walk_and_goes_on_from_it() {
    let figure = human(1.75, 73.0).expect("a person");
    let beside = RunWalk { steps: 4, speed: Some(1.6) };
    let ends = RunEnd::Walking(beside);
    let plan = planned(&figure, &request(2.5, 8, ends, ends));
    for before in [true, false] {
        let (seam, differs) = seam(&plan, &figure, beside, before);
        // While one foot stands alone.
        let bearing = plan.contacts(seam).iter().filter(|foot| foot.force.y > 0.0).count();
        assert!(bearing == 1 && seam > 1.0 && seam < plan.duration() - 1.0, "{bearing} at {seam} s");
        // Differences of second order on the run's side.
        let h = if before { 1e-3 } else { -1e-3 };
        let rows: Vec<Vec<f64>> = (0..4).map(|k| differs(seam + h * f64::from(k))).collect();
        let (mut rate, mut acceleration) = (0.0_f64, 0.0_f64);
        for k in 0..figure.layout().nq() {
            let [a, b, c, d] = [0, 1, 2, 3].map(|row| rows[row][k]);
            rate = rate.max(((-1.5 * a + 2.0 * b - 0.5 * c) / h).abs());
            acceleration = acceleration.max(((2.0 * a - 5.0 * b + 4.0 * c - d) / (h * h)).abs());
        }
        println!("at {seam} s: {rate:.1e} rad/s, {acceleration:.1e} rad/s²");
        assert!(rate < 2e-2 && acceleration < 20.0, "at {seam} s: {rate} {acceleration}");
    }
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
        // One more lands in the walk; in full run the first one begins with a contact.
        let begun = request.from != RunEnd::Running;
        let more = usize::from(begun && matches!(request.to, RunEnd::Walking(_)));
        assert_eq!(plan.steps(), steps(request.from) + run + more + steps(request.to), "{request:?}");
        if matches!(request.to, RunEnd::Walking(_)) {
            // The last foot closes.
            assert_eq!(landed.len(), plan.steps() + 1 + usize::from(!begun), "{request:?}");
        }
        let prints: Vec<f64> = plan.prints().collect();
        assert!(prints.windows(2).all(|pair| pair[1] > pair[0]), "{request:?}: {prints:?}");
    }
}

#[test]
fn what_does_not_go_is_refused() {
    let figure = human(1.75, 73.0).expect("a person");
    let refused = |request: RunRequest| run(&figure, &request).map(|_| ()).expect_err("no run").to_string();
    for (steps, speed, why) in [
        (2, 1.4, "2 steps; it must be 3 to 30"),
        (31, 1.4, "31 steps; it must be 3 to 30"),
        (4, 0.8, "a speed of 0.8 m/s; it must be 0.95 to 1.82 m/s"),
        (4, f64::NAN, "a speed of NaN m/s; it must be 0.95 to 1.82 m/s"),
        (4, 1.7, "a run at 1.5 m/s beside a walk at 1.70 m/s; it must be no slower than the walk"),
    ] {
        let beside = |which: &str| {
            if why.starts_with("a run") {
                why.to_owned()
            } else {
                format!("of the walk {which} the run: {why}")
            }
        };
        assert_eq!(refused(request(1.5, 8, walking(steps, speed), RunEnd::Running)), beside("before"));
        assert_eq!(refused(request(1.5, 8, RunEnd::Running, walking(steps, speed))), beside("after"));
    }
    let few = refused(request(3.0, 3, walking(4, 1.5), RunEnd::Running));
    assert!(few.contains("takes 6 at least"), "{few}");
}

/// Random people of 1.45 to 1.95 m, walks from the slowest to the fastest beside runs up to 4.5 m/s, before them, after them and both: at most one
/// in twenty is refused, and of those that are planned none slides, sinks, bends a
/// knee back, needs more friction than soles have or presses farther beside
/// them than a fortieth of the height, and at most one in twenty by more than an eightieth.
fn obey(count: usize, seed: u64) {
    let mut random = Random(seed);
    let (mut planned, mut refused, mut beside) = (0, 0, 0);
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
                && found.cop_outside.value < 0.025 * height,
            "{height} m, {request:?}: {found:?}"
        );
        beside += usize::from(found.cop_outside.value > 0.0125 * height);
    }
    println!("{planned} planned, {refused} refused, {beside} pressed beside a sole");
    assert!(20 * refused <= count && 20 * beside <= count, "{refused} refused, {beside} beside, of {count}");
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
