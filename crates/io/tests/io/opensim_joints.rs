//! Models of OpenSim as other programs and older versions write them: turned joints, ellipsoids, bodies that float, names
//! that are missing or there twice.

use crate::opensim::{
    OFFSETS, X, Y, Z, assert_near, axis, body, check, document, joint, offset, pose, read, rod, slide, turn,
};
use solaris_io::Import;
use solaris_model::{FindingKind, Isometry3};

fn says(import: &Import, subject: &str, words: &str) -> bool {
    import.findings.iter().any(|found| found.subject == subject && found.message.contains(words))
}

/// `T(a·n_x, b·n_y, c·n_z)·R` with the normal `n` that is the z axis of `R`.
fn on_ellipsoid(radii: [f64; 3], [p, r, s]: [f64; 3]) -> Isometry3<f64> {
    let rotation = turn(X, p) * turn(Y, r) * turn(Z, s);
    let normal = rotation.rotation * solaris_model::Vector3::z();
    slide([radii[0] * normal.x, radii[1] * normal.y, radii[2] * normal.z]) * rotation
}

#[test]
fn an_ellipsoid_is_glided_on() {
    for radii in [[0.06, 0.15, 0.08], [0.1, 0.2, 0.2]] {
        let more = format!("<radii_x_y_z>{} {} {}</radii_x_y_z>", radii[0], radii[1], radii[2]);
        let import = rod("EllipsoidJoint", &["a", "b", "c"], &more);
        let free = import.figure.layout().nv() - import.figure.followers().len();
        assert_eq!((free, import.figure.mass()), (3, 2.0));
        for angles in [[0.0; 3], [0.4, -0.7, 1.1], [-1.3, 0.5, 0.2]] {
            let values: Vec<_> = ["a", "b", "c"].into_iter().zip(angles).collect();
            check(&import, &values, on_ellipsoid(radii, angles), "ellipsoid");
        }
    }
}

#[test]
fn a_shoulder_blade_glides_and_wings() {
    let more = "<thoracic_ellipsoid_radii_x_y_z>0.07 0.15 0.08</thoracic_ellipsoid_radii_x_y_z>\
        <scapula_winging_axis_origin>-0.03 0.02</scapula_winging_axis_origin>\
        <scapula_winging_axis_direction>0.4</scapula_winging_axis_direction>";
    let import = rod("ScapulothoracicJoint", &["abduction", "elevation", "upward", "winging"], more);
    let angles = [0.3, -0.5, 0.7];
    let quarter = std::f64::consts::FRAC_PI_2;
    let to_axis = slide([-0.03, 0.02, 0.0]);
    let winged = to_axis * turn([-0.4_f64.sin(), 0.4_f64.cos(), 0.0], -0.6) * to_axis.inverse();
    let moved = turn(Z, quarter) * on_ellipsoid([0.15, 0.07, 0.08], angles) * turn(Z, -quarter) * winged;
    let names = ["abduction", "elevation", "upward", "winging"];
    let values: Vec<_> = names.into_iter().zip([0.3, -0.5, 0.7, -0.6]).collect();
    check(&import, &values, moved, "shoulder blade");
    // More axes than one joint has, and an axis beside the others: links without mass stand between.
    assert_eq!(import.figure.links().len(), 3);
}

/// The child of a joint may be nearer to ground: `X_PC(q)` stays what it is.
#[test]
fn joints_may_be_turned_round() {
    let axes = axis("rotation1", "bend", "0 0 1", "")
        + &axis("rotation2", "twist", "1 0 0", "")
        + &axis(
            "translation2",
            "bend",
            "0 1 0",
            "<PolynomialFunction name=\"function\"><coefficients>0.2 0.3 0.1</coefficients></PolynomialFunction>",
        );
    let more = format!("{OFFSETS}<SpatialTransform>{axes}</SpatialTransform>");
    let turned = joint("CustomJoint", "pivot", ["on", "below"], &["bend", "twist"], &more);
    let import = read(&document(&body("rod", 2.0), &turned, ""));
    let moved = |bend: f64, twist: f64| {
        slide([0.0, 0.2 * bend * bend + 0.3 * bend + 0.1, 0.0]) * turn(Z, bend) * turn(X, twist)
    };
    for (bend, twist) in [(0.0, 0.0), (0.7, -0.4), (-1.1, 0.9)] {
        check(&import, &[("bend", bend), ("twist", twist)], moved(bend, twist).inverse(), "turned");
    }
    assert!(says(&import, "joint 'pivot'", "turned round"));

    // Version 3 says so itself: its motion is from the body to the parent.
    let old = "<OpenSimDocument Version=\"30000\"><Model name=\"toy\"><BodySet><objects>\
        <Body name=\"rod\"><mass>2</mass><mass_center>0.01 -0.2 0.03</mass_center><inertia_xx>0.1</inertia_xx>\
        <inertia_yy>0.1</inertia_yy><inertia_zz>0.1</inertia_zz><Joint><PinJoint name=\"\"><parent_body>ground</parent_body>\
        <location_in_parent>0.1 0.2 -0.3</location_in_parent><orientation_in_parent>0.4 -0.5 0.6</orientation_in_parent>\
        <location>-0.05 0.3 0.02</location><orientation>-0.2 0.7 0.1</orientation>\
        <CoordinateSet><objects><Coordinate name=\"bend\"/></objects></CoordinateSet><reverse>true</reverse></PinJoint></Joint>\
        </Body></objects></BodySet></Model></OpenSimDocument>";
    let import = read(old);
    check(&import, &[("bend", 0.6)], turn(Z, -0.6), "version 3");
    // Nor does it name the joint.
    assert!(says(&import, "<PinJoint>", "'pinjoint'"));
    assert_eq!(import.figure.links()[0].joint().name(), "pinjoint");
}

#[test]
fn bodies_without_joints_float_and_models_without_bodies_rest() {
    let pivot = joint("PinJoint", "pivot", ["/bodyset/rod", "/bodyset/bob"], &["bend"], "");
    let import = read(&document(&(body("bob", 1.0) + &body("rod", 2.0)), &pivot, ""));
    assert!(says(&import, "body 'rod'", "it floats"));
    let names: Vec<String> = (0..6).map(|i| format!("free_rod_coord_{i}")).collect();
    let values: Vec<_> = names.iter().map(String::as_str).zip([0.3, -0.7, 1.1, 0.25, -0.4, 0.6]).collect();
    let moved = slide([0.25, -0.4, 0.6]) * turn(X, 0.3) * turn(Y, -0.7) * turn(Z, 1.1);
    assert_near(&pose(&import, "rod", &values), &moved, "free");
    let import = read(&document("", "", ""));
    assert!(says(&import, "model", "no bodies"));
    assert_eq!((import.figure.layout().nv(), import.figure.mass()), (0, 0.0));
}

#[test]
fn coordinates_of_several_joints_may_have_one_name() {
    let joints = joint("PinJoint", "left", ["/ground", "/bodyset/rod"], &["bend"], "")
        + &joint("PinJoint", "right", ["/ground", "/bodyset/bob"], &["bend"], "");
    let import = read(&document(&(body("rod", 2.0) + &body("bob", 1.0)), &joints, ""));
    assert_eq!(import.figure.layout().q_names(), ["bend", "right.bend"]);
    assert!(says(&import, "coordinate 'bend'", "'right.bend'"));
}

/// Bodies and joints in a model's list of components, a frame through points, and a range the wrong way.
#[test]
fn parts_may_stand_among_the_components() {
    let coordinate = "<coordinates><Coordinate name=\"bend\"><range>1 -2</range></Coordinate></coordinates>";
    let pivot = joint("PinJoint", "pivot", ["/corner", "/rod"], &[], coordinate);
    let station = |name: &str, at: &str| {
        format!(
            "<Station name=\"{name}\"><socket_parent_frame>/ground</socket_parent_frame><location>{at}</location></Station>"
        )
    };
    let corner = "<StationDefinedFrame name=\"corner\"><socket_point_a>/a</socket_point_a><socket_point_b>/b</socket_point_b>\
        <socket_point_c>/c</socket_point_c><socket_origin_point>/o</socket_origin_point>\
        <ab_axis>-z</ab_axis><ab_x_ac_axis>x</ab_x_ac_axis></StationDefinedFrame>";
    let points = station("a", "1 0 0")
        + &station("b", "1 3 0")
        + &station("c", "0 2 0")
        + &station("o", "0.1 0.2 0.3");
    let parts = format!("<components>{}{pivot}{points}{corner}</components>", body("rod", 2.0));
    let import = read(&document("", "", &parts));
    // z is −(b − a) = −y and x is (b − a)×(c − a) = z of ground, so y is z×x = −x.
    let corner = slide([0.1, 0.2, 0.3]) * turn(Z, std::f64::consts::PI) * turn(X, 0.0);
    let corner = Isometry3::from_parts(
        corner.translation,
        solaris_model::UnitQuaternion::from_basis_unchecked(&[
            solaris_model::Vector3::z(),
            -solaris_model::Vector3::x(),
            -solaris_model::Vector3::y(),
        ]),
    );
    assert_near(&pose(&import, "rod", &[("bend", 0.4)]), &(corner * turn(Z, 0.4)), "among components");
    let limits = import.figure.links()[0].joint().kind().axes()[0].limits.expect("a range");
    assert_eq!((limits.lower, limits.upper), (-2.0, 1.0));
    assert!(says(&import, "coordinate 'bend'", "exchanged"));
    assert!(import.findings.iter().all(|found| !found.subject.starts_with("<Body>")));
}

/// The versions between 3.3 and 4.0: joints of their own, with connectors and the offsets beside them.
#[test]
fn versions_between_three_and_four_are_read() {
    let connector = |name: &str, path: &str| {
        format!(
            "<Connector_PhysicalFrame_ name=\"{name}\"><connectee_name>{path}</connectee_name></Connector_PhysicalFrame_>"
        )
    };
    let text = |ends: &str| {
        document(
            &body("rod", 2.0),
            &format!(
                "<PinJoint name=\"pivot\">{ends}\
                 <location_in_parent>0.1 0.2 -0.3</location_in_parent><orientation_in_parent>0.4 -0.5 0.6</orientation_in_parent>\
                 <location_in_child>-0.05 0.3 0.02</location_in_child><orientation_in_child>-0.2 0.7 0.1</orientation_in_child>\
                 <CoordinateSet><objects><Coordinate name=\"bend\"/></objects></CoordinateSet><reverse>false</reverse></PinJoint>"
            ),
            "",
        )
        .replace("40000", "30501")
    };
    let connectors = format!(
        "<connectors>{}{}</connectors>",
        connector("parent_body", "../ground"),
        connector("child_body", "rod")
    );
    let longer = "<socket_parent_frame_connectee_name>../ground</socket_parent_frame_connectee_name>\
        <socket_child_frame_connectee_name>../rod</socket_child_frame_connectee_name>";
    for ends in [connectors.as_str(), longer] {
        check(&read(&text(ends)), &[("bend", 0.6)], turn(Z, 0.6), "between versions");
    }
}

#[test]
fn names_of_classes_and_late_declarations_are_read() {
    let force = "<ForceSet><objects><HuntCrossleyForce name=\"c\"><HuntCrossleyForce::ContactParametersSet>\
        <objects><HuntCrossleyForce::ContactParameters/></objects></HuntCrossleyForce::ContactParametersSet>\
        </HuntCrossleyForce></objects></ForceSet>";
    let pivot = joint("PinJoint", "pivot", ["/ground", "/bodyset/rod"], &["bend"], "");
    let text = format!("\u{feff}\n\n{}", document(&body("rod", 2.0), &pivot, force));
    let import = read(&text);
    let found = import.findings.iter().find(|found| found.kind == FindingKind::Unsupported).expect("a force");
    assert_eq!(found.subject, "<HuntCrossleyForce>");
    // Places are those of the text as it is.
    assert_eq!(&text[found.place.clone().expect("a place").span], "<HuntCrossleyForce");
    assert_near(
        &pose(&import, "rod", &[("bend", 0.1)]),
        &(offset([0.0; 3], [0.0; 3]) * turn(Z, 0.1)),
        "pendulum",
    );
}
