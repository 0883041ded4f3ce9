//! Running, against the golden numbers of its recipe and by laws that know no plan.

use crate::golden::{Differences, Worst, golden, golden_figure, number, running_golden, vector};
use serde_json::Value;
use solaris_dynamics::{Tree, Workspace, center_of_mass, inverse_dynamics};
use solaris_gait::{
    Extent, Prescribing, RUN_FRICTION, RunEnd, RunPlan, RunRequest, RunResolution, RunStride, RunStyle,
    SteadyRun, StyledPlan, Walking, measure, measure_run, run, run_bands,
};
use solaris_model::{Figure, Motion, SolePart, Trajectory, Vector3, human};

/// Returns the greatest difference of the angular momentum (N m s).
fn compare(figure: &Figure, golden: &Value, stride: &RunStride, differences: &mut Differences) -> Worst {
    let mut momentum = Worst::default();
    let n = stride.node_count();
    let mut q = vec![0.0; figure.layout().nq()];
    let way = 2.0 * stride.style().step_length;
    for i in 0..=100 {
        let u = i as f64 / 100.0;
        stride.configuration(u, &mut q);
        for axis in 0..3 {
            let place = |what: &'static str| move || format!("{what} {axis}, u = {u}");
            let off = q[axis] - number(&golden["pelvis_pos"][i][axis]);
            differences.length.note(off.abs(), place("pelvis"));
            if (i * n).is_multiple_of(100) {
                let node = i * n / 100 % n;
                let wrapped = if i == 100 && axis == 2 { way } else { 0.0 };
                let off = stride.com(node)[axis] + wrapped - number(&golden["com"][i][axis]);
                differences.length.note(off.abs(), place("com"));
                let off = stride.angular_momentum(node)[axis] - number(&golden["angular_momentum"][i][axis]);
                momentum.note(off.abs(), place("angular momentum"));
            }
        }
        differences.note_joints(figure, golden, i, &q);
        let (foot, toes) = stride.foot_pitches(u)[0];
        differences.note_pitches(golden, i, "left", (foot, toes));
        let forces = stride.forces(u);
        let mut free = 0.0;
        for (side, name) in ["left", "right"].into_iter().enumerate() {
            let (contact, wanted) = (forces[side], vector(&golden[format!("F_{name}")][i]));
            differences.force.note((contact.force - wanted).amax(), || format!("F {name}, u = {u}"));
            free += (contact.moment - contact.cop.cross(&contact.force)).y;
            if wanted.y > 1.0 {
                let cop = &golden[format!("cop_{name}")][i];
                for (found, wanted) in [(contact.cop.x, &cop[0]), (contact.cop.z, &cop[1])] {
                    differences
                        .length
                        .note((found - number(wanted)).abs(), || format!("cop {name}, u = {u}"));
                }
            }
        }
        differences.force.note((free - number(&golden["free_moment"][i])).abs(), || format!("T, u = {u}"));
    }
    momentum
}

/// The style of the golden strides, whose arms hang closer: our hands pass the thighs.
fn recipe(speed: f64) -> RunStyle {
    let [arm_abduction, arm_inward] = [12.0_f64.to_radians(), 25.0_f64.to_radians()];
    RunStyle { arm_abduction, arm_inward, ..RunStyle::of(1.75, speed) }
}

/// Limits of lengths (m), angles (degrees), forces (N and N m), momentum (N m s).
fn check(resolution: RunResolution, [length, angle, force, momentum]: [f64; 4]) {
    let figure = golden_figure(&golden());
    let golden = running_golden();
    for speed in [2.5, 3.5, 5.0] {
        let stride = RunStride::new(&figure, &recipe(speed), resolution).expect("a stride");
        let mut differences = Differences::default();
        let golden = &golden["strides"][format!("{speed:.1}")];
        let worst = compare(&figure, golden, &stride, &mut differences);
        println!("{speed} m/s, {} nodes, {} passes:", resolution.nodes, resolution.passes);
        differences.assert_below([length, angle, force, 0.0]);
        println!("  angular momentum (N m s): {:.2e} at {}", worst.0, worst.1);
        assert!(worst.0 < momentum);
    }
}

#[test]
fn with_the_golden_discretisation() {
    check(RunResolution { nodes: 400, passes: 25 }, [2e-5, 2e-3, 0.1, 1e-3]);
}

#[test]
fn with_the_resolution_that_ships() {
    check(RunResolution::default(), [1e-3, 0.2, 20.0, 0.1]);
}

/// What the whole body needs from outside at each sample of a steady run: force, and moment about the centre of mass.
fn needed(figure: &Figure, motion: &Motion) -> Vec<(Vector3<f64>, Vector3<f64>, Vector3<f64>)> {
    let tree = Tree::<f64>::new(figure, motion.info.gravity).expect("a tree");
    let (mut workspace, mut tau) = (Workspace::new(&tree), vec![0.0; tree.nv()]);
    (0..motion.len())
        .map(|i| {
            let (q, v, a) = (motion.q(i), motion.v(i), motion.a(i));
            inverse_dynamics(&tree, &mut workspace, q, v, a, &[], &mut tau).expect("forces");
            let base = workspace.base_wrench();
            let com = center_of_mass(&tree, &mut workspace, q).expect("a centre of mass");
            (base.force, base.moment - com.cross(&base.force), com)
        })
        .collect()
}

/// A run of a person of a height (m) and a mass (kg) at a speed (m/s), on the heel or the forefoot.
fn runner(height: f64, mass: f64, (speed, forefoot): (f64, bool)) -> (Figure, RunPlan) {
    let figure = human(height, mass).expect("a person");
    let request = RunRequest { speed, forefoot, extent: Extent::Steps(4), ..RunRequest::default() };
    let plan = run(&figure, &request).expect("a run");
    (figure, plan)
}

const PEOPLE: [(f64, f64); 3] = [(1.75, 73.0), (1.5, 48.0), (1.9, 85.0)];
/// Speeds (m/s), and whether on the forefoot.
const SPEEDS: [(f64, bool); 14] = [
    (1.0, false),
    (1.5, false),
    (2.2, false),
    (2.5, false),
    (3.0, false),
    (3.5, false),
    (4.5, false),
    (5.0, false),
    (6.0, false),
    (1.0, true),
    (2.0, true),
    (2.8, true),
    (3.5, true),
    (3.3, true),
];

/// The force of the whole body is the law's, and none in flight, by inverse dynamics that knows no plan; velocities and accelerations
/// are differences of the configuration.
#[test]
fn the_body_needs_the_prescribed_forces_and_none_in_flight() {
    for (height, mass) in PEOPLE {
        for speed in SPEEDS {
            let (figure, plan) = runner(height, mass, speed);
            let motion = plan.motion(&figure, 1.0 / plan.resolution()).expect("samples");
            let (mut stance, mut flight, mut moment) = (0.0_f64, 0.0_f64, 0.0_f64);
            let mut rotating = 0.0_f64;
            for ((force, about, com), &time) in needed(&figure, &motion).iter().zip(motion.time()) {
                let feet = plan.contacts(time);
                let law = feet[0].force + feet[1].force;
                let law_about: Vector3<f64> =
                    feet.iter().map(|foot| foot.moment - com.cross(&foot.force)).sum();
                let off = (about - law_about).norm();
                if law == Vector3::zeros() {
                    (flight, moment) = (flight.max(force.norm()), moment.max(off));
                } else {
                    (stance, rotating) = (stance.max((force - law).norm()), rotating.max(off));
                }
            }
            println!(
                "{height} m at {speed:?} m/s: {stance:.2} N off in stance, {flight:.2} N in flight; {rotating:.1} and {moment:.1} N m"
            );
            let weight = plan.weight();
            assert!(flight < 5e-4 * weight && stance < 5e-4 * weight, "{height} m, {speed:?} m/s");
            assert!(moment < 0.01 * weight * height && rotating < 0.02 * weight * height);
        }
    }
}

/// Planted points stand, soles stay above the ground, knees bend the right way, and forces press inside of the soles with no more
/// friction than soles have.
#[test]
fn soles_and_knees_do_what_they_can() {
    for (height, mass) in PEOPLE {
        for speed in SPEEDS {
            let (figure, plan) = runner(height, mass, speed);
            let style = *plan.style();
            let (motion, forces) = StyledPlan::Run(Box::new(plan)).loaded(&figure, 240.0).expect("forces");
            let measured = measure(&figure, &motion).expect("measures");
            let found = &measured.extremes;
            println!(
                "{height} m at {speed:?} m/s: slide {:.1e} m, sink {:.1e} m, friction {:.2}, knee {:.1}°, pressure {:.1e} m outside, clearance {:.1e} m; {forces:?}",
                found.slide.value,
                found.sink.value,
                found.foot_friction.value,
                found.least_knee.value.to_degrees(),
                found.cop_outside.value,
                found.clearance.value
            );
            assert!(found.slide.value < 1e-4 && found.sink.value < if speed.1 { 5e-4 } else { 1e-9 });
            assert!(found.foot_friction.value < RUN_FRICTION && found.least_knee.value > 0.05);
            assert!(found.cop_outside.value < 0.0105 * height && found.clearance.value > 0.01);
            assert_eq!((measured.steps, measured.double_supports.len()), (4, 0));
            assert!((measured.distance - 4.0 * style.step_length).abs() < 0.02);
        }
    }
}

/// The measures of a steady stride in a style.
fn steady(figure: &Figure, style: &RunStyle, resolution: RunResolution) -> SteadyRun {
    let stride = RunStride::new(figure, style, resolution).expect("a stride");
    let plan = RunPlan::new(stride, 2, true);
    let rate = 1.0 / plan.resolution();
    let (motion, _) = StyledPlan::Run(Box::new(plan)).loaded_stride(figure, rate).expect("forces");
    measure_run(figure, &motion).expect("measures")
}

/// As many bands as the recipe has of its own measures.
#[test]
fn bands_of_people_hold_as_in_the_recipe() {
    let figure = human(1.75, 73.0).expect("a person");
    for (speed, least) in [(2.2, 22), (2.5, 22), (3.0, 22), (3.5, 22), (4.0, 21), (5.0, 19), (6.0, 20)] {
        let found = steady(&figure, &RunStyle::of(1.75, speed), RunResolution::default());
        let report = run_bands(&found);
        let outside = report.checks.iter().filter(|check| !check.inside);
        let outside: Vec<String> =
            outside.map(|c| format!("{} {:.2} {:?}", c.name, c.value, c.range)).collect();
        println!("{speed} m/s: {} of {} inside; {outside:?}\n  {found:?}", report.inside, report.of);
        assert!(report.inside >= least && report.of == 22, "{speed} m/s: {outside:?}");
    }
}

/// The measures of the golden strides: those of our code, which knows no plan, against the recipe's own. (Its ankle is that of the
/// leg's plane, ours the joint's.)
#[test]
fn measures_are_the_golden_ones() {
    let (figure, all) = (golden_figure(&golden()), running_golden());
    for speed in [2.5, 3.5, 5.0] {
        let golden = &all["measures"][format!("{speed:.1}")];
        let found = steady(&figure, &recipe(speed), RunResolution { nodes: 400, passes: 25 });
        #[rustfmt::skip]
        let pairs = [
            ("cad", found.cadence, 1e-3), ("tc", 1e-3 * found.contact, 1e-4), ("tf", 1e-3 * found.flight, 1e-4),
            ("Fpk", found.vertical, 1e-3), ("brk", found.braking, 1e-3), ("psh", found.pushing, 1e-3),
            ("ML", found.lateral, 1e-3), ("bob", found.com_vertical, 1e-3), ("kc", found.knee_contact, 1e-2),
            ("kpk", found.knee_stance, 1e-2), ("kmin", found.knee_least, 1e-2), ("ksw", found.knee_swing, 1e-2),
            ("hip0", found.hip_contact, 1e-2), ("hipr", found.hip_range, 1e-2), ("ank0", found.ankle_contact, 0.2),
            ("DF", found.ankle_stance, 0.2), ("PF", found.ankle_least, 0.2), ("lean", found.thorax_lean, 1e-2),
            ("mank", found.ankle_plantarflexor, 0.01), ("mknee", found.knee_extensor, 0.01),
            ("mhipe", found.hip_extensor, 0.01), ("mhipf", found.hip_flexor, 0.01), ("mhipa", found.hip_abductor, 0.01),
        ];
        for (name, value, limit) in pairs {
            let wanted = number(&golden[name]);
            println!("{speed} {name} {value:.4} {wanted} {:.1e}", value - wanted);
            assert!((value - wanted).abs() < limit, "{speed} m/s, {name}: {value} is not {wanted}");
        }
    }
}

/// What is out of range is refused with the range, and a speed that cannot be run with the nearest that can.
#[test]
fn what_cannot_be_run_is_refused() {
    let figure = human(1.75, 73.0).expect("a person");
    let refused = |request: RunRequest| run(&figure, &request).map(|_| ()).expect_err("no run").to_string();
    for speed in [0.9, 6.1, -3.0, f64::NAN, f64::INFINITY] {
        let why = refused(RunRequest { speed, ..RunRequest::default() });
        assert!(why.contains(&format!("speed {speed} m/s: it must be 1 to 6 m/s")), "{why}");
    }
    for extent in [Extent::Steps(0), Extent::Steps(10_001), Extent::Distance(0.0), Extent::Distance(f64::NAN)]
    {
        let why = refused(RunRequest { extent, ..RunRequest::default() });
        assert!(why.contains("it must be"), "{why}");
    }
    for (nodes, passes) in [(201, 25), (10, 25), (4000, 25), (200, 0)] {
        let resolution = RunResolution { nodes, passes };
        let why = refused(RunRequest { resolution, ..RunRequest::default() });
        assert!(why.contains(" of a run") || why.contains("for a run"), "{why}");
    }
    // Two passes do not bring body and forces together at any speed.
    let resolution = RunResolution { nodes: 60, passes: 2 };
    let why = refused(RunRequest { speed: 6.0, resolution, ..RunRequest::default() });
    println!("{why}");
    assert!(why.contains("do not come to agree") && why.contains("speed"), "{why}");
    let mut style = RunStyle::of(1.75, 3.5);
    style.knee_push = f64::NAN;
    assert!(RunStride::new(&figure, &style, RunResolution::default()).is_err());
}

/// The last contact of a distance lies at or beyond it, by less than a step.
#[test]
fn a_distance_is_reached_in_whole_steps() {
    let figure = human(1.75, 73.0).expect("a person");
    for distance in [0.1, 5.0, 12.34] {
        let extent = Extent::Distance(distance);
        let plan = run(&figure, &RunRequest { extent, ..RunRequest::default() }).expect("a run");
        let last = plan.prints().last().expect("a print");
        assert!(last >= distance && last < distance + plan.style().step_length, "{distance}: {last}");
    }
    let step = RunStyle::of(1.75, 3.5).step_length;
    let extent = Extent::Distance(7.0 * step);
    let plan = run(&figure, &RunRequest { extent, ..RunRequest::default() }).expect("a run");
    assert_eq!(plan.steps(), 7);
}

/// Right foot first is the mirror image of left foot first, forces too.
#[test]
fn the_other_foot_first_is_the_mirror_image() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan =
        |left_first: bool| run(&figure, &RunRequest { left_first, ..RunRequest::default() }).expect("a run");
    let (left, right) = (plan(true), plan(false));
    let joint = |name: &str| figure.layout().joints()[figure.link_index(name).expect("a link")];
    let (mut a, mut b) = (vec![0.0; figure.layout().nq()], vec![0.0; figure.layout().nq()]);
    for time in [0.0, 0.1, 0.33, 1.0] {
        left.configuration(time, &mut a);
        right.configuration(time, &mut b);
        assert!((a[0] + b[0]).abs() < 1e-12 && (a[2] - b[2]).abs() < 1e-12);
        let (l, r) = (joint("left_thigh").q, joint("right_thigh").q);
        assert!((a[l] + b[r]).abs() < 1e-12 && (a[l + 2] - b[r + 2]).abs() < 1e-12);
        let (l, r) = (left.contacts(time), right.contacts(time));
        assert!((l[0].force.x + r[1].force.x).abs() < 1e-9 && (l[0].force.y - r[1].force.y).abs() < 1e-9);
        assert!((l[0].moment.y + r[1].moment.y).abs() < 1e-9);
    }
    assert_eq!(right.events().len(), 21);
}

/// Soles that give let the standing knee and ankle bend less: the leg reaches so much farther down. Forces and swing stay, and the body moves as they have it.
#[test]
fn soles_that_give_spare_the_knee() {
    let figure = human(1.75, 73.0).expect("a person");
    let planned = |give: f64| {
        let request = RunRequest { speed: 3.5, give, extent: Extent::Steps(2), ..RunRequest::default() };
        run(&figure, &request).expect("a run")
    };
    let (rigid, soft) = (planned(0.0), planned(0.015));
    let style = soft.style();
    // Its lowest point is as far below the ground as was asked for in mid-stance, and not at all as the foot touches and leaves.
    let tree = Tree::<f64>::new(&figure, Vector3::new(0.0, -9.80665, 0.0)).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut lowest = |plan: &RunPlan, u: f64| {
        let mut q = vec![0.0; figure.layout().nq()];
        plan.stride().configuration(u, &mut q);
        center_of_mass(&tree, &mut workspace, &q).expect("poses");
        let heights = ["left_foot", "left_toes"].into_iter().flat_map(|name| {
            let link = figure.link_index(name).expect("a link");
            let parts = [SolePart::Heel, SolePart::Ball, SolePart::ToeTip];
            let points = parts.into_iter().filter_map(|part| figure.links()[link].sole_point(part));
            points.map(|point| workspace.pose(link).transform(point).y).collect::<Vec<f64>>()
        });
        heights.fold(f64::INFINITY, f64::min)
    };
    for part in [0.0, 0.2, 0.45, 0.999] {
        let law = 0.015 * f64::sin(std::f64::consts::PI * part).powi(3);
        let (rigid, soft) = (lowest(&rigid, part * style.duty), lowest(&soft, part * style.duty));
        assert!(rigid.abs() < 2e-5 && (soft + law).abs() < 2e-5, "{part}: {rigid}, {soft}, not {law}");
    }
    let [hard, given] = [&rigid, &soft].map(|plan| steady(&figure, plan.style(), RunResolution::default()));
    // A leg of two like bones t is 2t cos(k/2) long, which changes by t sin(k/2), 3 mm, a degree at 48°: 15 mm are 5°, and less as the knee bends the most before mid-stance.
    assert!((2.5..5.0).contains(&(hard.knee_stance - given.knee_stance)), "{hard:?} {given:?}");
    assert!((2.0..4.0).contains(&(hard.ankle_stance - given.ankle_stance)), "{hard:?} {given:?}");
    assert!((hard.hip_extensor - given.hip_extensor).abs() < 0.2, "{hard:?} {given:?}");
    for u in [0.1, 0.2, 0.6] {
        let (a, b) = (rigid.stride().forces(u), soft.stride().forces(u));
        let off = (a[0].force - b[0].force).norm().max((a[1].force - b[1].force).norm());
        assert!(off < 0.02 * 73.0 * 9.80665, "{off} at {u}");
    }
    assert!(soft.stride().extremes(400).momentum_excess < 2.0);

    let refused = |request: RunRequest| run(&figure, &request).map(|_| ()).expect_err("no run").to_string();
    let usual = || RunRequest { speed: 3.0, ..RunRequest::default() };
    assert_eq!(refused(RunRequest { give: 0.02, ..usual() }), "give 0.02 m: it must be 0 to 0.015 m");
    assert!(refused(RunRequest { give: f64::NAN, ..usual() }).contains("it must be 0 to 0.015 m"));
    let started = refused(RunRequest { give: 0.01, from: RunEnd::Standing, ..usual() });
    assert!(started.contains("give is given, which is not of a run that changes"), "{started}");
}

/// On the forefoot the ball touches before the heel, the force rises once, and the knee is more bent; a foot on the forefoot is asked for in full run alone.
#[test]
fn the_forefoot_lands_before_the_heel() {
    let (figure, plan) = runner(1.75, 73.0, (3.0, true));
    let motion = plan.motion(&figure, 1000.0).expect("samples");
    let tree = Tree::<f64>::new(&figure, motion.info.gravity).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let foot = figure.link_index("right_foot").expect("a foot");
    let mut height = |time: f64, part: SolePart| {
        let row = motion.time().partition_point(|t| *t < time - 1e-9);
        center_of_mass(&tree, &mut workspace, motion.q(row)).expect("poses");
        let point = figure.links()[foot].sole_point(part).expect("a point of the sole");
        workspace.pose(foot).transform(point).y
    };
    let style = *plan.style();
    let (touches, flat) = (0.0, style.foot_flat * style.contact_time());
    assert!(height(touches, SolePart::Heel) > 0.02 && height(touches, SolePart::Ball) < 1e-3);
    assert!(height(flat, SolePart::Heel) < 1e-3);
    // Up to its greatest value, and down.
    let vertical: Vec<f64> =
        (0..200).map(|i| plan.contacts(f64::from(i) / 200.0 * style.contact_time())[1].force.y).collect();
    let turns = vertical.windows(3).filter(|w| (w[1] - w[0]) * (w[2] - w[1]) < 0.0).count();
    assert_eq!(turns, 1);
    assert!(style.knee_contact > RunStyle::of(1.75, 3.0).knee_contact);

    // Of bands two are of heels.
    let request = RunRequest { speed: 3.0, forefoot: true, ..RunRequest::default() };
    let styled = StyledPlan::Run(Box::new(run(&figure, &request).expect("a run")));
    let steady = styled.steady_run(&figure).expect("measures").expect("a run");
    let report = run_bands(&steady);
    assert!(steady.on_forefoot && report.of == 20 && report.inside >= 19, "{report:?}");
    assert!(!self::steady(&figure, &RunStyle::of(1.75, 3.0), RunResolution::default()).on_forefoot);

    let refused = |request: RunRequest| {
        run(&figure, &RunRequest { forefoot: true, ..request }).map(|_| ()).expect_err("no run").to_string()
    };
    let fast = refused(RunRequest { speed: 4.2, ..RunRequest::default() });
    assert_eq!(fast, "speed 4.2 m/s: it must be 1 to 3.5 m/s on the forefoot");
    let started = refused(RunRequest { speed: 3.0, from: RunEnd::Standing, ..RunRequest::default() });
    assert!(started.contains("forefoot is given, which is not of a run that changes"), "{started}");
}

/// One stride repeats itself without a seam, and there is one of any run of two steps.
#[test]
fn a_stride_repeats_itself() {
    let figure = human(1.75, 73.0).expect("a person");
    let request = RunRequest { extent: Extent::Steps(2), ..RunRequest::default() };
    let plan = StyledPlan::Run(Box::new(run(&figure, &request).expect("a run")));
    let (motion, _) = plan.loaded_stride(&figure, 120.0).expect("forces");
    let (first, last) = (motion.q(0), motion.q(motion.len() - 1));
    for (i, (a, b)) in first.iter().zip(last).enumerate() {
        let way = if i == 2 { 2.0 * plan.step_length() } else { 0.0 };
        assert!((b - a - way).abs() < 1e-9, "coordinate {i}");
    }
    let single = RunRequest { extent: Extent::Steps(1), ..RunRequest::default() };
    let single = StyledPlan::Run(Box::new(run(&figure, &single).expect("a run")));
    assert!(single.loaded_stride(&figure, 120.0).is_err());
}
