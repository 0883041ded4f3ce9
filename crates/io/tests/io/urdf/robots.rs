//! Robots that people have, against Pinocchio's torques.

use crate::data::{json, numbers, text};
use solaris_dynamics::{Tree, Workspace, Wrench, inverse_dynamics};
use solaris_io::urdf;
use solaris_model::{Figure, Vector3};

/// Where each of the reference's coordinates stands in ours: by the joints' names, the free joint first.
pub(crate) fn order(figure: &Figure, joints: &[&str]) -> (Vec<usize>, Vec<usize>) {
    let (mut positions, mut velocities) = (Vec::new(), Vec::new());
    for joint in joints {
        let name = if *joint == "root_joint" { "root" } else { joint };
        let link = figure.joint_index(name).expect("a joint of the file");
        let at = figure.layout().joints()[link];
        positions.extend(at.q..at.q + at.nq);
        velocities.extend(at.v..at.v + at.nv);
    }
    (positions, velocities)
}

/// Values in our order.
pub(crate) fn placed(values: &[f64], order: &[usize]) -> Vec<f64> {
    let mut out = vec![0.0; values.len()];
    order.iter().zip(values).for_each(|(&at, value)| out[at] = *value);
    out
}

/// Compares every sample, without and with the wrench, to 1e-9 of the largest torque.
fn check(robot: &str, reference: &str, free: Option<&str>) {
    let (Some(text), Some(reference)) =
        (text(&format!("robots/{robot}.urdf")), json(&format!("robots/{reference}.json")))
    else {
        return;
    };
    let text = match free {
        None => text,
        // The reference's free root, as URDF says it.
        Some(base) => text.replace(
            "</robot>",
            &format!(
                "<link name='universe'/><joint name='root' type='floating'><parent link='universe'/><child link='{base}'/>\
                 </joint></robot>"
            ),
        ),
    };
    let import = urdf::read(&text).unwrap_or_else(|error| panic!("{robot}: {error}"));
    let figure = &import.figure;
    let joints: Vec<&str> =
        reference["joints"].as_array().expect("a list").iter().filter_map(|name| name.as_str()).collect();
    let (positions, velocities) = order(figure, &joints);
    assert_eq!(figure.layout().nv(), joints.len() + if free.is_some() { 5 } else { 0 });
    let tree = Tree::<f64>::new(figure, Vector3::new(0.0, 0.0, -9.81)).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let convention = reference["convention"].as_str().expect("a text");
    let pushed = convention.split('"').nth(1).expect("a joint's name");
    let pushed = figure.joint_index(pushed).expect("a joint");
    let mut worst = 0.0_f64;
    for sample in reference["samples"].as_array().expect("a list") {
        let q = placed(&numbers(&sample["q"]), &positions);
        let v = placed(&numbers(&sample["v"]), &velocities);
        let a = placed(&numbers(&sample["a"]), &velocities);
        let w = numbers(&sample["wrench_world_origin"]);
        let wrench = Wrench { force: Vector3::new(w[0], w[1], w[2]), moment: Vector3::new(w[3], w[4], w[5]) };
        for (external, expected) in [(vec![], "tau"), (vec![(pushed, wrench)], "tau_with_wrench")] {
            let mut tau = vec![0.0; v.len()];
            inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &external, &mut tau).expect("forces");
            let expected = placed(&numbers(&sample[expected]), &velocities);
            let scale = expected.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
            let error = tau.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
            worst = worst.max(error / scale);
        }
    }
    assert!(worst < 1e-9, "{robot}: {worst:e} of the largest torque");
    #[expect(clippy::print_stderr, reason = "captured unless somebody asks for it")]
    {
        eprintln!("{robot}: {worst:.1e} of the largest torque");
    }
}

#[test]
fn the_ur5_needs_the_torques_of_pinocchio() {
    check("ur5_robot", "ur5_robot_rnea", None);
}

#[test]
fn the_panda_needs_the_torques_of_pinocchio() {
    check("panda", "panda_rnea", None);
}

#[test]
fn the_double_pendulum_needs_the_torques_of_pinocchio() {
    check("double_pendulum", "double_pendulum_rnea", None);
}

#[test]
fn the_free_humanoid_needs_the_torques_of_pinocchio() {
    check("simple_humanoid", "simple_humanoid_ff_rnea", Some("base_link"));
}
