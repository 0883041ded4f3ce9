//! Masses that no matter has, figures in which nothing moves, and models that include others: what the program makes of
//! them.

use crate::inverse::{column, json, read, refused, solaris, succeeded, table, write};
use std::fs;
use tempfile::TempDir;

/// An arm whose inertia is that of nothing, and a joint on it that moves nothing.
const ARM: &str = r#"<robot name="arm"><link name="base"/>
<link name="arm"><inertial><origin xyz="0 0 -0.5"/><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="-0.9" iyz="0" izz="0.1"/></inertial></link>
<joint name="pivot" type="continuous"><parent link="base"/><child link="arm"/><axis xyz="0 1 0"/></joint>
<link name="tip"/><joint name="idle" type="continuous"><parent link="arm"/><child link="tip"/><axis xyz="0 1 0"/></joint>
</robot>"#;

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, text) in files {
        write(folder.path(), name, text);
    }
    folder
}

/// `τ = (Iyy + m·c²)·q̈ + m·g·c·sin q`, though the first is below zero.
#[test]
fn inverse_dynamics_takes_masses_as_they_are_and_says_so() {
    let rows = "time,pivot.q,pivot.v,pivot.a,idle.q,idle.v,idle.a\n0,0.3,0,1,0,0,4\n";
    let folder = folder(&[("arm.urdf", ARM), ("swing.csv", rows)]);
    let said = succeeded(&solaris(folder.path(), "inverse arm.urdf swing.csv -o tau.csv"));
    assert_eq!(said.matches("suspect           arm, idle: masses that no matter has").count(), 1, "{said}");
    let tau = table(folder.path(), "tau.csv");
    let expected = (-0.9 + 2.0 * 0.25) + 2.0 * 9.80665 * 0.5 * 0.3_f64.sin();
    assert!((column(&tau, "pivot.tau")[0] - expected).abs() < 1e-12);
    assert_eq!(column(&tau, "idle.tau"), [0.0]);
    let facts = json(&succeeded(&solaris(folder.path(), "inverse arm.urdf swing.csv --json")));
    let doubts = facts["mass_doubts"].as_array().expect("a list");
    assert_eq!((doubts.len(), doubts[0]["subject"].as_str()), (2, Some("arm")));
    // A figure without any says nothing.
    let sound = ARM.replace("iyy=\"-0.9\"", "iyy=\"0.1\"").replace(
        "<link name=\"tip\"/>",
        "<link name=\"tip\"><inertial><mass value=\"1\"/></inertial></link>",
    );
    write(folder.path(), "sound.urdf", &sound);
    let facts = json(&succeeded(&solaris(folder.path(), "inverse sound.urdf swing.csv --json")));
    assert_eq!(facts["mass_doubts"].as_array().map(Vec::len), Some(0));
}

#[test]
fn check_lists_them_and_strict_refuses_them() {
    let folder = folder(&[("arm.urdf", ARM)]);
    let said = succeeded(&solaris(folder.path(), "check arm.urdf"));
    assert!(said.contains("arm: its inertia is not that of any mass distribution"), "{said}");
    assert!(said.contains("idle: it moves link 'tip', which has no mass"), "{said}");
    let strict = solaris(folder.path(), "check arm.urdf --strict");
    assert_eq!(strict.status.code(), Some(1));
}

/// What needs a positive mass matrix refuses where it is not, and only there.
#[test]
fn a_simulation_refuses_by_the_joint() {
    let scene = |drives: &str| {
        format!("Scene(version: 1, figures: {{\"it\": File(\"arm.urdf\")}}, {drives}duration: 0.1)")
    };
    let folder = folder(&[
        ("arm.urdf", ARM),
        ("fall.ron", &scene("")),
        ("held.ron", &scene("drives: {\"pivot\": Frozen, \"idle\": Frozen}, ")),
    ]);
    let said = refused(&solaris(folder.path(), "run fall.ron"));
    assert!(said.contains("the mass matrix is not positive") && said.contains("worst about pivot"), "{said}");
    succeeded(&solaris(folder.path(), "run held.ron"));
}

#[test]
fn figures_in_which_nothing_moves_are_answered() {
    let block = r#"<robot name="block"><link name="base"><inertial><mass value="2"/><inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link></robot>"#;
    let scene = "Scene(version: 1, figures: {\"it\": File(\"block.urdf\")}, duration: 0.1)";
    let folder = folder(&[("block.urdf", block), ("still.csv", "time\n0\n0.1\n"), ("scene.ron", scene)]);
    for line in [
        "check block.urdf",
        "check block.urdf --dh",
        "check block.urdf --json",
        "check scene.ron",
        "convert block.urdf block.ron",
        "inverse block.urdf still.csv",
        "inverse block.urdf still.csv --json",
        "inverse block.urdf still.csv -o tau.csv",
        "inverse block.urdf still.csv -o tau.sto",
        "metrics block.urdf still.csv",
        "run scene.ron",
        "run scene.ron -o motion.csv",
        "run scene.ron -o motion.html",
    ] {
        let output = solaris(folder.path(), line);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!((output.status.code(), said.as_ref()), (Some(0), ""), "{line}");
    }
    assert_eq!(read(&folder.path().join("tau.csv")), "time\n0\n0.1\n");
    for line in [
        "ground block.urdf still.csv",
        "inverse block.urdf still.csv --base free",
        "convert still.csv x.csv --figure block.urdf",
    ] {
        refused(&solaris(folder.path(), line));
    }
}

/// A joint that closes a loop is left open, and forces say so.
#[test]
fn an_open_loop_is_said_beside_the_forces() {
    let joint = |name: &str, parent: &str, child: &str| {
        format!(
            "<joint name='{name}' type='revolute'><parent>{parent}</parent><child>{child}</child><axis><xyz>0 1 0</xyz></axis></joint>"
        )
    };
    let loops = format!(
        "<sdf version='1.9'><model name='bars'><link name='a'/><link name='b'/>{}{}{}</model></sdf>",
        joint("left", "world", "a"),
        joint("top", "a", "b"),
        joint("right", "world", "b")
    );
    let folder = folder(&[("bars.sdf", &loops), ("swing.csv", "time,left.q,top.q\n0,0,0\n1,1,0\n2,1,1\n")]);
    let said = succeeded(&solaris(folder.path(), "inverse bars.sdf swing.csv"));
    assert!(
        said.contains("missing           right: it closes a loop at 'b', which joint 'top' holds already"),
        "{said}"
    );
    assert_eq!(solaris(folder.path(), "check bars.sdf --strict").status.code(), Some(1));
}

/// A world with a cart whose wheel stands in a file of its own, and a sun that is not there.
#[test]
fn worlds_are_read_with_the_models_beside_them() {
    let world = "<sdf version='1.9'><world name='yard'><include><uri>model://sun</uri></include><model name='cart'><link name='body'/>\
                 <joint name='rail' type='prismatic'><parent>world</parent><child>body</child><axis><xyz>1 0 0</xyz></axis></joint>\
                 <include><uri>model://wheel</uri></include>\
                 <joint name='axle' type='revolute'><parent>body</parent><child>wheel::rim</child><axis><xyz>0 1 0</xyz></axis></joint>\
                 </model></world></sdf>";
    let wheel = "<sdf version='1.9'><model name='wheel'><link name='rim'><inertial><mass>3</mass></inertial></link></model></sdf>";
    let folder =
        folder(&[("yard.world", world), ("swing.csv", "time,rail.q,axle.q\n0,0,0\n1,1,0\n2,4,0\n3,9,0\n")]);
    fs::create_dir(folder.path().join("wheel")).expect("a folder");
    write(folder.path(), "wheel/model.sdf", wheel);
    let said = succeeded(&solaris(folder.path(), "check yard.world"));
    assert!(said.starts_with("SDF model 'cart'\n") && said.contains("wheel::rim"), "{said}");
    assert!(said.contains("model://sun: it cannot be included, and is left out"), "{said}");
    let said = succeeded(&solaris(folder.path(), "inverse yard.world swing.csv -o tau.csv"));
    assert!(said.contains("2 degrees of freedom, 4 kg"), "{said}");
    // Out of the folder, by name or by a link.
    let out = world.replace("model://wheel", "../wheel/model.sdf");
    fs::create_dir(folder.path().join("inner")).expect("a folder");
    write(folder.path(), "inner/out.sdf", &out);
    let said = refused(&solaris(folder.path(), "check inner/out.sdf"));
    assert!(said.contains("leads out of the folder"), "{said}");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../wheel", folder.path().join("inner/wheel")).expect("a link");
        write(folder.path(), "inner/link.sdf", world);
        let said = refused(&solaris(folder.path(), "check inner/link.sdf"));
        assert!(said.contains("a link that leads out"), "{said}");
    }
}
