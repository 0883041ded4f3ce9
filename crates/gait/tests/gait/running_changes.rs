//! Runs that change their speed, begin in standing and end there, by laws that know no plan.

use solaris_dynamics::{Tree, Workspace, center_of_mass, inverse_dynamics};
use solaris_gait::{
    CHANGING_RUN_STEPS, Extent, Prescribing, RUN_FRICTION, RunEnd, RunPart, RunPlan, RunRequest, StyledPlan,
    Walking, least_run_steps, measure, run,
};
use solaris_model::{Figure, Human, Trajectory, Vector3, human};

const STANDING: (RunEnd, RunEnd) = (RunEnd::Standing, RunEnd::Standing);
const RUNNING: (RunEnd, RunEnd) = (RunEnd::Running, RunEnd::Running);

fn request(speed: f64, steps: usize, then: &[(usize, f64)], (from, to): (RunEnd, RunEnd)) -> RunRequest {
    let then = then.iter().map(|&(steps, speed)| RunPart { steps, speed }).collect();
    RunRequest { speed, extent: Extent::Steps(steps), then, from, to, ..RunRequest::default() }
}

pub(super) fn planned(figure: &Figure, request: &RunRequest) -> RunPlan {
    run(figure, request).unwrap_or_else(|why| panic!("{request:?}: {why}"))
}

/// By how much the whole body's force differs from the law's at the plan's nodes, while a foot stands and in flight (N), by inverse dynamics
/// on differences of the configuration.
pub(super) fn off(figure: &Figure, plan: &RunPlan) -> [f64; 2] {
    let motion = plan.motion(figure, 1.0 / plan.resolution()).expect("samples");
    let tree = Tree::<f64>::new(figure, motion.info.gravity).expect("a tree");
    let (mut workspace, mut tau) = (Workspace::new(&tree), vec![0.0; tree.nv()]);
    let mut off = [0.0_f64; 2];
    for i in 0..motion.len() {
        inverse_dynamics(&tree, &mut workspace, motion.q(i), motion.v(i), motion.a(i), &[], &mut tau)
            .expect("forces");
        let law: Vector3<f64> = plan.contacts(motion.time()[i]).iter().map(|foot| foot.force).sum();
        let of = &mut off[usize::from(law == Vector3::zeros())];
        *of = of.max((workspace.base_wrench().force - law).norm());
    }
    off
}

/// What the force is off by at most, as a part of the weight: where passes have settled, and where they have not quite.
const SETTLED: f64 = 1e-3;
const UNSETTLED: f64 = 1e-2;

#[test]
fn the_body_needs_the_prescribed_forces() {
    let figure = human(1.75, 73.0).expect("a person");
    let cases = [
        (request(1.0, 4, &[(18, 3.4)], RUNNING), SETTLED),
        (request(3.4, 4, &[(18, 1.0)], RUNNING), SETTLED),
        (request(2.8, 4, &[(12, 4.2), (10, 2.8)], RUNNING), UNSETTLED),
        (request(1.5, 8, &[], STANDING), SETTLED),
        (request(3.0, 15, &[], STANDING), UNSETTLED),
        (request(3.5, 24, &[], STANDING), UNSETTLED),
        (request(4.5, 38, &[], STANDING), UNSETTLED),
        (request(3.0, 12, &[], (RunEnd::Running, RunEnd::Standing)), SETTLED),
    ];
    for (request, limit) in cases {
        let plan = planned(&figure, &request);
        let [stance, flight] = off(&figure, &plan).map(|force| force / plan.weight());
        println!("{request:?}: {stance:.4} and in flight {flight:.4} of the weight");
        assert!(stance < limit && flight < limit, "{request:?}: {stance} {flight}");
    }
}

/// Planted points stand, soles stay above the ground, knees bend the right way, forces hold and press inside of the soles.
pub(super) fn holds_together(figure: &Figure, plan: RunPlan, request: &RunRequest) {
    let height = plan.stature();
    let (motion, _) = StyledPlan::Run(Box::new(plan)).loaded(figure, 240.0).expect("forces");
    let found = measure(figure, &motion).expect("measures").extremes;
    println!(
        "{height} m, {request:?}: slide {:.1e} m, sink {:.1e} m, friction {:.2}, knee {:.1}°, pressure {:.1e} m outside",
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

#[test]
fn soles_and_knees_do_what_they_can() {
    for (height, mass) in [(1.75, 73.0), (1.6, 55.0), (1.9, 85.0)] {
        let figure = human(height, mass).expect("a person");
        for request in [
            request(2.5, 4, &[(12, 3.5)], RUNNING),
            request(2.5, 14, &[], STANDING),
            request(1.6, 8, &[], STANDING),
        ] {
            holds_together(&figure, planned(&figure, &request), &request);
        }
    }
}

/// In standing nothing moves, both feet bear half the weight side by side, and the centre of mass is over where they press.
#[test]
fn it_begins_and_ends_at_rest() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = planned(&figure, &request(2.0, 10, &[], STANDING));
    let motion = plan.motion(&figure, 200.0).expect("samples");
    let tree = Tree::<f64>::new(&figure, motion.info.gravity).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    for i in [0, motion.len() - 2] {
        let fastest = motion.v(i).iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        assert!(fastest < 2e-3, "{fastest}");
        let [left, right] = plan.contacts(motion.time()[i]);
        let com = center_of_mass(&tree, &mut workspace, motion.q(i)).expect("a centre of mass");
        for foot in [&left, &right] {
            assert!((foot.force - Vector3::y() * (0.5 * plan.weight())).norm() < 1e-3 * plan.weight());
        }
        let pressed = (left.cop + right.cop) * 0.5;
        assert!((pressed.x - com.x).abs() < 1e-3 && (pressed.z - com.z).abs() < 1e-3, "{pressed} {com}");
        assert!((left.cop.z - right.cop.z).abs() < 1e-9 && left.cop.x - right.cop.x > 0.08);
    }
    // Each foot lands once and leaves once, but for the two that stand at either end.
    assert_eq!(plan.events().len(), 2 * (plan.steps() + 2));
}

/// Where nothing changes the chain is the steady run.
#[test]
fn a_chain_of_like_steps_is_the_steady_run() {
    let figure = human(1.75, 73.0).expect("a person");
    let steady = planned(&figure, &request(3.5, 8, &[], RUNNING));
    let chain = planned(&figure, &request(3.5, 4, &[(4, 3.5)], RUNNING));
    let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
    let (mut far, mut turned) = (0.0_f64, 0.0_f64);
    for k in 0..=200 {
        let time = steady.duration() * f64::from(k) / 200.0;
        steady.configuration(time, &mut a);
        chain.configuration(time, &mut b);
        // Slightly slower: its mean speed is not exact.
        let along = (b[2] - a[2])
            - time * (chain.prints().last().unwrap_or_default() - steady.prints().last().unwrap_or_default())
                / steady.duration();
        far = far.max((b[0] - a[0]).abs()).max((b[1] - a[1]).abs()).max(along.abs());
        turned = (3..a.len()).fold(turned, |most, i| most.max((b[i] - a[i]).abs()));
    }
    println!("{far} m, {}°", turned.to_degrees());
    assert!(far < 0.01 && turned.to_degrees() < 3.0);
}

#[test]
fn its_speed_is_what_is_asked() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan = planned(&figure, &request(1.5, 6, &[(16, 3.0)], RUNNING));
    let prints: Vec<f64> = plan.prints().collect();
    assert_eq!(prints.len(), 23);
    let step = |k: usize| prints[k + 1] - prints[k];
    let wanted = |speed: f64| solaris_gait::RunStyle::of(1.75, speed).step_length;
    assert!((step(1) / wanted(1.5) - 1.0).abs() < 0.02, "{} {}", step(1), wanted(1.5));
    assert!((step(21) / wanted(3.0) - 1.0).abs() < 0.02, "{} {}", step(21), wanted(3.0));
}

/// How many steps are enough is told of speeds that no run has, too.
#[test]
fn steps_are_counted_for_any_speed() {
    let of = |speed: f64| least_run_steps(speed, RunEnd::Standing, RunEnd::Running);
    assert_eq!([of(1.5), of(2.8), of(3.1), of(6.0)], [2, 7, 9, 28]);
    assert!(of(f64::INFINITY) > CHANGING_RUN_STEPS && of(1e12) > CHANGING_RUN_STEPS);
    assert_eq!([of(f64::NAN), of(-1.0), of(1.0)], [1; 3]);
}

#[test]
fn what_cannot_be_run_is_refused() {
    let figure = human(1.75, 73.0).expect("a person");
    let refused = |request: RunRequest| run(&figure, &request).map(|_| ()).expect_err("no run").to_string();
    let least = least_run_steps(3.5, RunEnd::Standing, RunEnd::Standing);
    let why = refused(request(3.5, least - 1, &[], STANDING));
    assert!(why.contains(&format!("takes {least} at least")), "{why}");
    let why = refused(request(1.0, 4, &[(3, 3.5)], RUNNING));
    assert!(why.contains("3 steps to change from 1 to 3.5 m/s: it takes 16 at least"), "{why}");
    let why = refused(request(2.0, 4, &[(20, 7.0)], RUNNING));
    assert!(why.contains("speed 7 m/s: it must be 1 to 6 m/s"), "{why}");
    let why = refused(request(2.0, CHANGING_RUN_STEPS, &[(1, 2.0)], RUNNING));
    assert!(why.contains("it is planned whole, and has 60 at most"), "{why}");
    let distance = RunRequest { extent: Extent::Distance(20.0), ..request(2.0, 4, &[(4, 2.0)], RUNNING) };
    assert!(refused(distance).contains("say how many they are"));
}

/// No stride of somebody with a load in one hand is its own mirror image: the steps are planned one by one.
#[test]
fn whoever_carries_something_in_one_hand_runs_step_by_step() {
    for (hand, load, request) in
        [("right", 5.0, request(3.0, 8, &[], RUNNING)), ("left", 3.0, request(2.5, 6, &[], RUNNING))]
    {
        let figure = Human::new(1.75, 73.0).load(hand, load).build().expect("a person");
        let plan = planned(&figure, &request);
        assert!(plan.changes() && plan.stride_loop().is_none());
        let styled = StyledPlan::Run(Box::new(plan.clone()));
        let why = styled.loaded_stride(&figure, 30.0).map(|_| ()).expect_err("no stride").to_string();
        assert!(why.contains("a load in one hand"), "{why}");
        let [stance, flight] = off(&figure, &plan).map(|force| force / plan.weight());
        println!("{load} kg in the {hand} hand: {stance:.4} and in flight {flight:.4} of the weight");
        assert!(stance < 8e-2 && flight < 8e-2, "{load} kg in the {hand} hand: {stance} {flight}");
    }
}
