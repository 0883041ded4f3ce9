//! MuJoCo's humanoid, against its own torques.

use crate::data::{json, numbers, text};
use crate::mjcf::models::check_torques;
use solaris_io::mjcf;

#[test]
fn the_humanoid_needs_the_torques_of_mujoco() {
    let (Some(text), Some(reference)) =
        (text("robots/mujoco_humanoid.xml"), json("robots/mujoco_humanoid_inverse.json"))
    else {
        return;
    };
    let original = mjcf::read(&text).unwrap_or_else(|error| panic!("{error}"));
    let mass = reference["original"]["mass"].as_f64().expect("a number");
    assert!((original.figure.mass() - mass).abs() < 1e-12 * mass);
    assert_eq!((original.figure.layout().nq(), original.figure.layout().nv()), (28, 27));
    // The reference was made without armature.
    let without = text.replace("armature=\".01\"", "");
    assert_ne!(without, text);
    let import = mjcf::read(&without).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(import.gravity.as_slice(), numbers(&reference["gravity"]));
    let worst = check_torques(&import, &reference["samples"]);
    #[expect(clippy::print_stderr, reason = "captured unless somebody asks for it")]
    {
        eprintln!("mujoco_humanoid: {worst:.1e} of the largest torque");
    }
    assert!(worst < 1e-9, "{worst:e} of the largest torque");
}
