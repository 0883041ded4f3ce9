//! A robot with everything in it, against the torques that Pinocchio 4.1.0 finds for it (`models/pinocchio.json`; the
//! angle of its continuous joint written as one number).

use crate::data::numbers;
use crate::urdf::robots::{order, placed};
use serde_json::Value;
use solaris_dynamics::{Tree, Workspace, inverse_dynamics};
use solaris_io::urdf;
use solaris_model::{FindingKind, Limits, ShapeKind, Vector3};

#[test]
fn turned_frames_and_fused_links_need_the_torques_of_pinocchio() {
    let import = urdf::read(include_str!("models/arm.urdf")).unwrap_or_else(|error| panic!("{error}"));
    let figure = &import.figure;
    let reference: Value = serde_json::from_str(include_str!("models/pinocchio.json")).expect("JSON");
    let joints: Vec<&str> =
        reference["joints"].as_array().expect("a list").iter().filter_map(Value::as_str).collect();
    let (positions, velocities) = order(figure, &joints);
    let tree = Tree::<f64>::new(figure, import.gravity).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    for sample in reference["samples"].as_array().expect("a list") {
        let q = placed(&numbers(&sample["q"]), &positions);
        let [v, a, expected] = ["v", "a", "tau"].map(|name| placed(&numbers(&sample[name]), &velocities));
        let mut tau = vec![0.0; v.len()];
        inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau).expect("forces");
        let scale = expected.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
        assert!(
            tau.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-12 * scale),
            "{tau:?} {expected:?}"
        );
    }
}

#[test]
fn what_the_file_says_is_in_the_figure_or_in_the_findings() {
    let import = urdf::read(include_str!("models/arm.urdf")).unwrap_or_else(|error| panic!("{error}"));
    let figure = &import.figure;
    let links: Vec<&str> = figure.links().iter().map(solaris_model::Link::name).collect();
    assert_eq!(links, ["base", "upper", "slider", "wheel", "drone"]);
    assert_eq!(figure.layout().v_names()[..3], ["shoulder", "rail", "axle"]);
    let upper = figure.link("upper").expect("a link");
    let frames: Vec<&str> = upper.frames().iter().map(|frame| frame.name.as_str()).collect();
    assert_eq!(frames, ["bracket", "camera"]);
    let dof = &upper.joint().kind().axes()[0];
    assert_eq!(dof.limits, Some(Limits { lower: -1.5, upper: 2.5 }));
    assert!((dof.passive.damping - 0.3).abs() < 1e-15 && (dof.passive.friction - 0.1).abs() < 1e-15);
    // A cylinder along z is one of ours along y, turned.
    let shape = upper.shape().expect("a shape");
    assert_eq!(shape.kind, ShapeKind::Cylinder { radius: 0.05, length: 0.4 });
    assert!((shape.placement.rotation * Vector3::y() - Vector3::z()).norm() < 1e-15);
    assert!(!import.gravity_is_given);
    let said: Vec<String> =
        import.findings.iter().map(|finding| format!("{:?}: {finding}", finding.kind)).collect();
    insta::assert_snapshot!(said.join("\n"));
    assert!(import.findings.iter().all(|finding| finding.kind != FindingKind::Suspect));
}

#[test]
fn a_planar_joint_slides_twice_and_turns() {
    let text = include_str!("models/arm.urdf").replace("type=\"floating\"", "type=\"planar\"");
    let import = urdf::read(&text).unwrap_or_else(|error| panic!("{error}"));
    // The default axis is x: the plane is that of y and z.
    assert_eq!(import.figure.layout().v_names()[3..], ["flight.ty", "flight.tz", "flight.rx"]);
}
