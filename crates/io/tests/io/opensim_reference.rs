//! Small models of OpenSim against OpenSim's own numbers (`fixtures/reference/opensim.json`).

use crate::data::numbers;
use crate::opensim::{pose, read};
use serde_json::Value;
use solaris_dynamics::{Tree, Workspace, inverse_dynamics};
use solaris_io::Import;
use std::path::Path;

fn named(values: &Value) -> Vec<(&str, f64)> {
    let values = values.as_object().expect("an object").iter();
    values.map(|(name, value)| (name.as_str(), value.as_f64().expect("a number"))).collect()
}

/// What the coordinates need at rest with these accelerations.
fn forces(import: &Import, q: &[(&str, f64)], a: &[(&str, f64)]) -> Vec<f64> {
    let tree = Tree::<f64>::new(&import.figure, import.gravity).expect("a figure");
    let dof = |name: &str| import.figure.layout().dof_index(name).expect("a coordinate of the file");
    let spread = |values: &[(&str, f64)]| {
        let mut spread = vec![0.0; tree.nv()];
        for (name, value) in values {
            spread[dof(name)] = *value;
        }
        spread
    };
    let (mut q, mut v, mut a) = (spread(q), vec![0.0; tree.nv()], spread(a));
    import.figure.follow(&mut q, &mut v, &mut a);
    let mut tau = vec![0.0; tree.nv()];
    inverse_dynamics(&tree, &mut Workspace::new(&tree), &q, &v, &a, &[], &mut tau).expect("a state");
    import.figure.fold_forces(&q, &mut tau);
    tau
}

#[test]
fn models_move_and_need_forces_as_in_opensim() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/reference/opensim.json");
    let text = std::fs::read_to_string(path).expect("part of the project");
    let reference: Value = serde_json::from_str(&text).expect("JSON");
    let mut compared = [0, 0];
    for case in reference["cases"].as_array().expect("cases") {
        let name = case["name"].as_str().expect("a name");
        let import = read(case["text"].as_str().expect("a model"));
        for state in case["states"].as_array().expect("states") {
            let (q, a) = (named(&state["q"]), named(&state["a"]));
            for (body, expected) in state["bodies"].as_object().expect("bodies") {
                let found = pose(&import, body, &q).to_homogeneous();
                let position = numbers(&expected["position"]);
                let rotation: Vec<f64> =
                    expected["rotation"].as_array().expect("rows").iter().flat_map(numbers).collect();
                for i in 0..3 {
                    let row = (0..3).map(|j| (found[(i, j)] - rotation[3 * i + j]).abs());
                    let off = row.fold((found[(i, 3)] - position[i]).abs(), f64::max);
                    assert!(off < 1e-13, "{name}, {body}: off by {off:e}");
                }
                compared[0] += 1;
            }
            let Some(expected) = state.get("tau") else { continue };
            let (tau, expected) = (forces(&import, &q, &a), named(expected));
            let size = expected.iter().fold(1.0, |size: f64, (_, value)| size.max(value.abs()));
            for (coordinate, expected) in expected {
                let dof = import.figure.layout().dof_index(coordinate).expect("a coordinate");
                let off = (tau[dof] - expected).abs() / size;
                assert!(off < 1e-13, "{name}, {coordinate}: {} instead of {expected}", tau[dof]);
                compared[1] += 1;
            }
        }
    }
    assert_eq!(compared, [42, 30]);
}
