//! Running, against the golden numbers of its recipe and by laws that know no plan.

use crate::golden::{Differences, Worst, golden, golden_figure, number, running_golden, vector};
use serde_json::Value;
use solaris_dynamics::{Tree, Workspace, center_of_mass, inverse_dynamics};
use solaris_gait::{
    Extent, Prescribing, RUN_FRICTION, RunPlan, RunRequest, RunResolution, RunStride, RunStyle, StyledPlan,
    measure, run,
};
use solaris_model::{Figure, Motion, Trajectory, Vector3, human};

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

/// Limits of lengths (m), angles (degrees), forces (N and N m), momentum (N m s).
fn check(resolution: RunResolution, [length, angle, force, momentum]: [f64; 4]) {
    let figure = golden_figure(&golden());
    let golden = running_golden();
    for speed in [2.5, 3.5, 5.0] {
        let stride = RunStride::new(&figure, &RunStyle::of(1.75, speed), resolution).expect("a stride");
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

/// A run of a person of a height (m) and a mass (kg) at a speed (m/s), four samples a node.
fn runner(height: f64, mass: f64, speed: f64) -> (Figure, RunPlan) {
    let figure = human(height, mass).expect("a person");
    let request = RunRequest { speed, extent: Extent::Steps(4), ..RunRequest::default() };
    let plan = run(&figure, &request).expect("a run");
    (figure, plan)
}

const PEOPLE: [(f64, f64); 3] = [(1.75, 73.0), (1.5, 48.0), (1.9, 85.0)];
const SPEEDS: [f64; 9] = [1.0, 1.5, 2.2, 2.5, 3.0, 3.5, 4.5, 5.0, 6.0];

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
                "{height} m at {speed} m/s: {stance:.2} N off in stance, {flight:.2} N in flight; {rotating:.1} and {moment:.1} N m"
            );
            let weight = plan.weight();
            assert!(flight < 5e-4 * weight && stance < 5e-4 * weight, "{height} m, {speed} m/s");
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
                "{height} m at {speed} m/s: slide {:.1e} m, sink {:.1e} m, friction {:.2}, knee {:.1}°, pressure {:.1e} m outside, clearance {:.1e} m; {forces:?}",
                found.slide.value,
                found.sink.value,
                found.foot_friction.value,
                found.least_knee.value.to_degrees(),
                found.cop_outside.value,
                found.clearance.value
            );
            assert!(found.slide.value < 1e-4 && found.sink.value < 1e-9);
            assert!(found.foot_friction.value < RUN_FRICTION && found.least_knee.value > 0.05);
            assert!(found.cop_outside.value < 0.018 && found.clearance.value > 0.01);
            assert_eq!((measured.steps, measured.double_supports.len()), (4, 0));
            assert!((measured.distance - 4.0 * style.step_length).abs() < 0.02);
        }
    }
}
