//! Models of MuJoCo with other files beside them, from outside: what is read, what is not, and what `inverse` says of it.

use crate::inverse::{failed, json, solaris, succeeded};
use std::fs;
use tempfile::TempDir;

/// An arm whose mass is a mesh of a folder beside its own, in a fluid.
const ARM: &str = r#"<mujoco model="arm">
  <compiler meshdir="../meshes"/>
  <include file="parts/option.xml"/>
  <asset><mesh name="block" file="block.obj"/></asset>
  <worldbody>
    <body name="arm"><joint name="turn" axis="0 1 0"/><geom type="mesh" mesh="block" pos="0.5 0 0"/></body>
  </worldbody>
</mujoco>
"#;

/// The hull of a block of 0.5 × 0.4 × 0.2 m, near enough in 32 bits: 40 kg at MuJoCo's own density.
const BLOCK: &str = "v 0 0 0\nv .5 0 0\nv 0 .4 0\nv .5 .4 0\nv 0 0 .2\nv .5 0 .2\nv 0 .4 .2\nv .5 .4 .2\n";
/// Of 32 bits.
const NEAR: f64 = 1e-6;

fn models() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("written");
    };
    write("robots/mjcf/arm.xml", ARM);
    write(
        "robots/mjcf/parts/option.xml",
        "<mujocoinclude><option gravity='0 0 -10' density='1.2'/></mujocoinclude>",
    );
    write("robots/meshes/block.obj", BLOCK);
    write("robots/mjcf/swing.csv", "time,turn.q,turn.v,turn.a\n0,0,2,0\n");
    folder
}

#[test]
fn files_are_read_in_the_folder_that_is_named_and_no_other() {
    let folder = models();
    let check = |line: &str| json(&succeeded(&solaris(folder.path(), line)));
    // Of itself, the model's own folder.
    let missing = |facts: &serde_json::Value| {
        let findings = facts["findings"].as_array().expect("a list").iter();
        findings.filter(|finding| finding["kind"] == "missing").count()
    };
    let own = check("check robots/mjcf/arm.xml --json");
    assert_eq!((own["mass_kg"].as_f64(), missing(&own)), (Some(0.0), 1), "{own}");
    for files in ["robots", "."] {
        let read = check(&format!("check robots/mjcf/arm.xml --json --files {files}"));
        let mass = read["mass_kg"].as_f64().expect("a mass");
        assert!((mass - 40.0).abs() < 40.0 * NEAR && missing(&read) == 0, "{read}");
    }
    let beside = failed(&solaris(folder.path(), "check robots/mjcf/arm.xml --files robots/meshes"), 1);
    assert!(beside.contains("robots/mjcf/arm.xml is not in it"), "{beside}");
    let strict = solaris(folder.path(), "check robots/mjcf/arm.xml --strict");
    assert_eq!(strict.status.code(), Some(1));
}

#[test]
#[cfg(unix)]
fn no_link_leads_out_of_the_folder() {
    let folder = models();
    let part = folder.path().join("robots/mjcf/parts/option.xml");
    fs::rename(&part, folder.path().join("secret.xml")).expect("moved");
    std::os::unix::fs::symlink(folder.path().join("secret.xml"), &part).expect("a link");
    let said = failed(&solaris(folder.path(), "check robots/mjcf/arm.xml --files robots"), 1);
    assert!(said.contains("it is a link that leads out of the folder"), "{said}");
    assert!(solaris(folder.path(), "check robots/mjcf/arm.xml --files .").status.success());
}

#[test]
fn faults_of_other_files_are_shown_in_them() {
    let folder = models();
    fs::write(folder.path().join("robots/mjcf/parts/option.xml"), "<a>\n  <option gravity='0 0'/>\n</a>")
        .expect("written");
    let said = failed(&solaris(folder.path(), "check robots/mjcf/arm.xml"), 1);
    assert!(
        said.contains("robots/mjcf/parts/option.xml:2:20") && said.contains("'gravity' holds 2 numbers"),
        "{said}"
    );
}

/// What is missing, and what moves through a fluid, is said where forces are printed.
#[test]
fn inverse_says_what_is_missing_and_what_resists() {
    let folder = models();
    let line = "inverse robots/mjcf/arm.xml robots/mjcf/swing.csv";
    let without = succeeded(&solaris(folder.path(), line));
    let missing = "mass: of 1 of 1 bodies that move, some is not known, as meshes were not read (arm); 1 of them have no other mass";
    assert!(without.contains(missing), "{without}");
    let torque = |line: &str| {
        let report = json(&succeeded(&solaris(folder.path(), line)));
        report["joints"][0]["greatest"].as_f64().expect("a number")
    };
    let [with, off] =
        ["on", "off"].map(|passive| torque(&format!("{line} --files robots --json --passive {passive}")));
    // 40 kg at 0.75 m, held against 10 m/s².
    assert!((off + 300.0).abs() < 300.0 * NEAR, "{off}");
    // A box of half sides r = (0.25, 0.2, 0.1) m whose centre, at x = 0.75 and z = 0.1 m of the axis, moves at 1.5 m/s along z
    // and 0.2 m/s along x: forces of 2·ρ·rⱼ·rₖ·v² with their arms, and a moment of ½·ρ·r·(rⱼ⁴ + rₖ⁴)·ω².
    let forces = 2.0 * 1.2 * (0.25 * 0.2 * 1.5_f64.powi(2) * 0.75 + 0.2 * 0.1 * 0.2_f64.powi(2) * 0.1);
    let drag = forces + 0.5 * 1.2 * 0.2 * (0.25_f64.powi(4) + 0.1_f64.powi(4)) * 4.0;
    assert!((with - off - drag).abs() < drag * NEAR, "{with} {off} {drag}");
    let said = succeeded(&solaris(folder.path(), &format!("{line} --files robots")));
    assert!(said.contains("a fluid of 1.2 kg/m³ and 0 Pa s resists 1 body"), "{said}");
}
