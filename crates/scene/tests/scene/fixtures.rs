//! The scenes of the fixtures.

use solaris_model::Figure;
use solaris_modes::{EndCondition, Method};
use solaris_scene::{Loader, Scene, is_scene, read};
use std::path::{Path, PathBuf};

/// Texts beside the scenes of the fixtures.
pub(crate) struct Beside;

pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/scenes")
}

impl Loader for Beside {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("figures of other formats are not read here".to_owned())
    }

    fn text(&mut self, path: &str) -> Result<String, String> {
        std::fs::read_to_string(folder().join(path)).map_err(|error| error.to_string())
    }
}

/// The scene of a fixture.
pub(crate) fn fixture(name: &str) -> Scene {
    let text = std::fs::read_to_string(folder().join(name)).expect("a fixture");
    assert!(is_scene(&text), "{name}");
    read(&text, &mut Beside).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn near(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= tolerance, "{found:?} is off by {off:e} from {expected:?}");
}

#[test]
fn every_fixture_is_a_scene() {
    let entries =
        std::fs::read_dir(folder()).expect("the fixtures").map(|entry| entry.expect("an entry").path());
    // What scenes include stands in a folder of its own.
    let names = entries.filter(|path| path.is_file()).filter_map(|path| Some(path.file_name()?.to_owned()));
    let names: Vec<String> = names.map(|name| name.to_string_lossy().into_owned()).collect();
    assert!(names.len() >= 6, "{names:?}");
    for name in names {
        let scene = fixture(&name);
        assert!(scene.settings().duration > 0.0, "{name}");
    }
}

#[test]
fn the_governor_starts_as_the_benchmark_has_it() {
    let scene = fixture("governor.ron");
    let (q, v) = scene.simulation().state();
    assert_eq!(scene.figure().layout().v_names(), ["spin.rz", "slide.tz", "right.r", "left.ry"]);
    near(q, &[0.0, 0.5, std::f64::consts::FRAC_PI_3, std::f64::consts::FRAC_PI_3], 1e-15);
    near(v, &[std::f64::consts::TAU, 0.0, 0.0, 0.0], 1e-15);
    near(scene.simulation().gravity().as_slice(), &[0.0, 0.0, -9.81], 0.0);
    assert_eq!(scene.settings().method, Method::Automatic { tolerance: 1e-6 });
}

#[test]
fn ball_and_free_joints_start_with_rotations() {
    let tops = fixture("tops.ron");
    let (q, v) = tops.simulation().state();
    let half = -std::f64::consts::FRAC_PI_6;
    near(&q[..8], &[0.0, 0.0, half.sin(), half.cos(), 0.0, 0.0, 0.0, 1.0], 1e-15);
    near(&v[3..], &[1.0, 20.0, 0.0, 0.006, 6.0, 0.006], 0.0);
    let cat = fixture("falling_cat.ron");
    near(&cat.simulation().state().0[..7], &[0.0, 4.0, 0.0, 0.0, 0.0, 1.0, 0.0], 1e-15);
}

#[test]
fn a_walk_drives_what_has_no_drive() {
    let scene = fixture("walk_loose_arm.ron");
    let layout = scene.figure().layout();
    let drive =
        |name: &str| scene.simulation().driven_by(layout.dof_index(name).expect("a dof"))[0].drive.name();
    assert_eq!(
        [drive("right_shoulder.rx"), drive("left_shoulder.rx"), drive("right_wrist.rx")],
        ["free", "recorded", "recorded"]
    );
    let plan = scene.walk().expect("a walk");
    let duration = solaris_model::Trajectory::duration(plan);
    assert!((scene.settings().duration - duration).abs() < 1e-12);
    // Two degrees of freedom of the shoulder, and the elbow's.
    assert_eq!(scene.walked() + 3, layout.nv());
    // It begins as the walk does.
    let mut first = vec![0.0; layout.nq()];
    solaris_model::Trajectory::configuration(plan, 0.0, &mut first);
    // But for the arm that the scene lifts off the flank.
    first[layout.dof_index("right_shoulder.rz").expect("a dof")] = (-5_f64).to_radians();
    near(scene.simulation().state().0, &first, 1e-12);
}

#[test]
fn every_mode_is_there() {
    let scene = fixture("arm_modes.ron");
    let names: Vec<&str> = (0..scene.figure().layout().nv())
        .map(|dof| scene.simulation().driven_by(dof)[0].drive.name())
        .collect();
    assert_eq!(
        names,
        [
            "kinematic",
            "frozen",
            "target-angle",
            "time-oriented",
            "accelerate-decelerate (i)",
            "accelerate-decelerate (ii)",
            "accelerate-decelerate (iii)",
            "free-style",
            "intensive, literal",
            "intensive, cubic",
            "intensive, quintic",
            "torque",
            "free"
        ]
    );
    assert!((0..13).all(|dof| scene.simulation().driven_by(dof)[0].until == EndCondition::Done));
}
