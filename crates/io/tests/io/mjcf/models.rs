//! Small models against the numbers that MuJoCo 4.0.0 finds for them (`models/mujoco.json`).

use crate::data::numbers;
use crate::mjcf::files::Parts;
use serde_json::Value;
use solaris_dynamics::{Tree, Workspace, center_of_mass, inverse_dynamics};
use solaris_io::mjcf::Loaded;
use solaris_io::{Import, Loader, NoFiles, mjcf};
use solaris_model::{Dof, FindingKind, JointKind};

/// Torques, in one of MuJoCo's samples, with the largest error of its kind.
pub(crate) fn check_torques(import: &Import, samples: &Value) -> f64 {
    let figure = &import.figure;
    let tree = Tree::<f64>::new(figure, import.gravity).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut worst = 0.0_f64;
    for sample in samples.as_array().expect("a list") {
        let [qpos, qvel, qacc, expected] = ["qpos", "qvel", "qacc", "tau"].map(|name| numbers(&sample[name]));
        let (q, v, a) = mjcf::state_from_mujoco(figure, &qpos, &qvel, &qacc).expect("a state");
        let mut tau = vec![0.0; v.len()];
        inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau).expect("forces");
        let found = mjcf::forces_to_mujoco(figure, &q, &tau).expect("forces");
        let scale = expected.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
        let error = found.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        worst = worst.max(error / scale);

        let back = mjcf::state_to_mujoco(figure, &q, &v, &a).expect("a state");
        for (back, given) in [(back.0, qpos), (back.1, qvel), (back.2, qacc)] {
            assert!(back.iter().zip(&given).all(|(a, b)| (a - b).abs() < 1e-12 * (1.0 + b.abs())));
        }
        let again = mjcf::forces_from_mujoco(figure, &q, &found).expect("forces");
        assert!(again.iter().zip(&tau).all(|(a, b)| (a - b).abs() < 1e-12 * scale));
        if let Some(com) = sample.get("com") {
            let place = center_of_mass(&tree, &mut workspace, &q).expect("a centre");
            let com = numbers(com);
            assert!((0..3).all(|i| (place[i] - com[i]).abs() < 1e-9), "{place} {com:?}");
        }
    }
    worst
}

/// What MuJoCo says of a degree of freedom.
fn check_dof(dof: &Dof, name: &str, said: &Value) {
    let number = |name: &str| said[name].as_f64().expect("a number");
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * (1.0 + b.abs());
    assert!(near(dof.armature, number("armature")), "{name}");
    assert!(near(dof.passive.damping, number("damping")), "{name}");
    assert!(near(dof.passive.stiffness, number("stiffness")), "{name}");
    assert!(near(dof.passive.friction, number("friction")), "{name}");
    if dof.passive.stiffness != 0.0 {
        assert!(near(dof.passive.rest, number("rest")), "{name}");
    }
    let range = said["range"].as_array().map(|_| numbers(&said["range"]));
    let limits = dof.limits.map(|limits| vec![limits.lower, limits.upper]);
    match (range, limits) {
        (None, None) => {}
        (Some(range), Some(limits)) => {
            assert!(near(range[0], limits[0]) && near(range[1], limits[1]), "{name}");
        }
        (range, limits) => panic!("{name}: {range:?} and {limits:?}"),
    }
}

fn check(model: &str, text: &str) -> Import {
    check_with(model, text, &mut NoFiles).import
}

fn check_with(model: &str, text: &str, loader: &mut dyn Loader) -> Loaded {
    let reference: Value = serde_json::from_str(include_str!("models/mujoco.json")).expect("JSON");
    let reference = &reference["models"][model];
    let loaded = mjcf::read_with(text, loader).unwrap_or_else(|error| panic!("{model}: {error}"));
    let import = &loaded.import;
    let mass = reference["mass"].as_f64().expect("a number");
    assert!((import.figure.mass() - mass).abs() < 1e-12 * mass, "{} {mass}", import.figure.mass());
    assert_eq!(import.gravity.as_slice(), numbers(&reference["gravity"]));
    let said = reference["dofs"].as_array().expect("a list");
    let mut said = said.iter();
    for link in import.figure.links() {
        let joint = link.joint();
        let dofs = joint.kind().axes();
        for dof in dofs {
            let said = said.next().expect("as many joints");
            let name = dof.name.as_deref().expect("a name");
            let given = said["name"].as_str().expect("a text");
            assert!(given.is_empty() || given == name, "{given} {name}");
            check_dof(dof, name, said);
        }
        if !matches!(joint.kind(), JointKind::Axes(_)) {
            let given = said.next().expect("as many joints")["name"].as_str().expect("a text");
            assert!(given.is_empty() || given == joint.name());
        }
    }
    assert!(said.next().is_none());
    let worst = check_torques(import, &reference["samples"]);
    assert!(worst < 1e-12, "{model}: {worst:e} of the largest torque");
    loaded
}

#[test]
fn joints_in_sequence_need_the_torques_of_mujoco() {
    let import = check("anchors", include_str!("models/anchors.xml"));
    // Two anchors, and a ball after a hinge: massless links between the joints, named after what moves them.
    let names: Vec<&str> = import.figure.links().iter().map(solaris_model::Link::name).collect();
    assert_eq!(names, ["hip", "shin_glide", "shin_twist", "shin", "foot", "toe_toe_bend", "toe"]);
    let joints: Vec<&str> = import.figure.links().iter().map(|link| link.joint().name()).collect();
    assert_eq!(joints, ["hip", "shin", "twist", "bend", "foot", "toe_bend", "toe_ball"]);
}

#[test]
fn geoms_weigh_what_they_weigh_in_mujoco() {
    let import = check("geoms", include_str!("models/geoms.xml"));
    let two = import.figure.link("two").expect("a link");
    let frames: Vec<&str> = two.frames().iter().map(|frame| frame.name.as_str()).collect();
    assert_eq!(frames, ["fixed", "tip"]);
}

#[test]
fn defaults_and_classes_mean_what_they_mean_in_mujoco() {
    let import = check("classes", include_str!("models/classes.xml"));
    assert_eq!(import.figure.layout().v_names(), ["shoulder", "slide", "elbow", "wrist", "body3_joint"]);
}

#[test]
fn springdampers_are_set_by_the_inertia_that_they_are_in_mujoco() {
    check("springs", include_str!("models/springs.xml"));
}

#[test]
fn inertials_bounds_and_scales_mean_what_they_mean_in_mujoco() {
    let import = check("inertials", include_str!("models/inertials.xml"));
    let joints: Vec<&str> = import.figure.links().iter().map(|link| link.joint().name()).collect();
    // The world's own weld gives the free joint's name away.
    assert_eq!(joints, ["root_2", "root", "swing", "spin", "swing2"]);
    let world = &import.figure.links()[0];
    assert_eq!((world.name(), world.frames()[0].name.as_str()), ("world", "table"));
}

/// Included files, replicas of replicas with oblique turns, attached bodies and frames of a model with other units and
/// defaults, and solids of meshes in four formats, convex or not, as solid, shell or hull.
#[test]
fn models_in_several_files_with_meshes_weigh_what_they_weigh_in_mujoco() {
    let import = check_with("files", include_str!("models/files/main.xml"), &mut Parts).import;
    let names: Vec<&str> = import.figure.links().iter().map(solaris_model::Link::name).collect();
    let (first, last) = (&names[..6], &names[names.len() - 5..]);
    assert_eq!(first, ["world", "base", "post_0", "leaf0_0", "leaf1_0", "leaf2_0"]);
    assert_eq!(last, ["left_upper", "left_lower", "far_grip", "holder", "again_base"]);
    let suspect = import.findings.iter().find(|finding| finding.kind == FindingKind::Suspect);
    assert!(suspect.is_none(), "{}", suspect.expect("one"));
}
