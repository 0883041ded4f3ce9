//! Forces of a fluid, and of what carries bodies, against MuJoCo's (`models/mujoco.json`, `medium`).

use crate::data::numbers;
use serde_json::Value;
use solaris_analysis::{InverseOptions, Loads, PreparedMotion, inverse_motion, medium_forces};
use solaris_io::NoFiles;
use solaris_io::mjcf::{self, Loaded};
use solaris_model::{FindingKind, Known, Motion, MotionInfo};

const TEXT: &str = include_str!("models/fluid.xml");

/// The largest difference, over the largest force.
fn difference(model: &str, text: &str) -> f64 {
    let reference: Value = serde_json::from_str(include_str!("models/mujoco.json")).expect("JSON");
    let Loaded { import, medium } =
        mjcf::read_with(text, &mut NoFiles).unwrap_or_else(|error| panic!("{error}"));
    let figure = &import.figure;
    let mut worst = 0.0_f64;
    for sample in reference["models"][model]["samples"].as_array().expect("samples") {
        let [qpos, qvel, qacc, expected] =
            ["qpos", "qvel", "qacc", "medium"].map(|name| numbers(&sample[name]));
        let (q, v, a) = mjcf::state_from_mujoco(figure, &qpos, &qvel, &qacc).expect("a state");
        let info = MotionInfo::recorded(figure, import.gravity, &[0.0]);
        let known = Known::all(v.len());
        let motion = Motion::recorded(figure, info, vec![0.0], [q.clone(), v, a], known).expect("a motion");
        let prepared = PreparedMotion::new(figure, &motion).expect("prepared");
        let forces =
            |loads: &Loads| inverse_motion(&prepared, loads, InverseOptions::default()).expect("forces").tau;
        let with = forces(&medium_forces(&prepared, &medium).expect("a medium"));
        let less: Vec<f64> =
            forces(&Loads::none()).iter().zip(&with).map(|(none, with)| none - with).collect();
        let found = mjcf::forces_to_mujoco(figure, &q, &less).expect("forces");
        let most = expected.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
        let error = found.iter().zip(&expected).map(|(a, b)| (a - b).abs());
        worst = error.fold(worst, |worst, error| worst.max(error / most));
    }
    worst
}

#[test]
fn a_fluid_resists_bodies_as_in_mujoco() {
    let boxes = difference("fluid_boxes", &TEXT.replace(" fluidshape=\"ellipsoid\"", ""));
    assert!(boxes < 1e-12, "{boxes:e}");
    let ellipsoid = difference("fluid", TEXT);
    assert!(ellipsoid < 1e-12, "{ellipsoid:e}");
}

#[test]
fn without_the_medium_it_is_said_to_be_missing() {
    let import = mjcf::read(TEXT).unwrap_or_else(|error| panic!("{error}"));
    assert!(
        import.findings.iter().any(|finding| finding.kind == FindingKind::Missing),
        "{:?}",
        import.findings
    );
}
