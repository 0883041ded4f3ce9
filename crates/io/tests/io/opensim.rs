//! Models of OpenSim: every kind of joint and function, as the documentation of OpenSim says it moves.

use solaris_dynamics::{Pose, Tree, Workspace, forward_kinematics};
use solaris_io::{Import, opensim};
use solaris_model::{FindingKind, Isometry3, Matrix3, Rotation3, UnitQuaternion, Vector3};

/// A body as version 4 writes it.
pub(crate) fn body(name: &str, mass: f64) -> String {
    format!(
        "<Body name=\"{name}\"><mass>{mass}</mass><mass_center>0.01 -0.2 0.03</mass_center>\
         <inertia>0.02 0.015 0.021 0.001 -0.002 0.0005</inertia></Body>\n"
    )
}

/// A document of version 4 with these bodies and joints, and more in its model.
pub(crate) fn document(bodies: &str, joints: &str, more: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<OpenSimDocument Version=\"40000\">\n<Model name=\"toy\">\n\
         <BodySet name=\"bodyset\"><objects>\n{bodies}</objects></BodySet>\n\
         <JointSet name=\"jointset\"><objects>\n{joints}</objects></JointSet>\n{more}</Model>\n</OpenSimDocument>\n"
    )
}

/// A joint of version 4 between two components, with its coordinates and more.
pub(crate) fn joint(kind: &str, name: &str, ends: [&str; 2], coordinates: &[&str], more: &str) -> String {
    let coordinates: Vec<String> =
        coordinates.iter().map(|name| format!("<Coordinate name=\"{name}\"/>")).collect();
    let coordinates = coordinates.concat();
    format!(
        "<{kind} name=\"{name}\"><socket_parent_frame>{}</socket_parent_frame>\
         <socket_child_frame>{}</socket_child_frame><coordinates>{coordinates}</coordinates>{more}</{kind}>\n",
        ends[0], ends[1]
    )
}

pub(crate) const OFFSETS: &str = "<frames>\
    <PhysicalOffsetFrame name=\"below\"><socket_parent>/ground</socket_parent>\
      <translation>0.1 0.2 -0.3</translation><orientation>0.4 -0.5 0.6</orientation></PhysicalOffsetFrame>\
    <PhysicalOffsetFrame name=\"on\"><socket_parent>/bodyset/rod</socket_parent>\
      <translation>-0.05 0.3 0.02</translation><orientation>-0.2 0.7 0.1</orientation></PhysicalOffsetFrame></frames>";

/// A single body `rod` on a joint between two offset frames.
pub(crate) fn rod(kind: &str, coordinates: &[&str], more: &str) -> Import {
    let joint = joint(kind, "pivot", ["below", "on"], coordinates, &format!("{OFFSETS}{more}"));
    read(&document(&body("rod", 2.0), &joint, ""))
}

pub(crate) fn read(text: &str) -> Import {
    opensim::read(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// A turn by `angle` about a unit vector, by the formula of Rodrigues.
pub(crate) fn turn(axis: [f64; 3], angle: f64) -> Isometry3<f64> {
    let a = Vector3::from(axis).normalize();
    let cross = a.cross_matrix();
    let matrix = Matrix3::identity() + cross * angle.sin() + cross * cross * (1.0 - angle.cos());
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix));
    Isometry3::from_parts(Vector3::zeros().into(), rotation)
}

pub(crate) fn slide(by: [f64; 3]) -> Isometry3<f64> {
    Isometry3::translation(by[0], by[1], by[2])
}

pub(crate) const X: [f64; 3] = [1.0, 0.0, 0.0];
pub(crate) const Y: [f64; 3] = [0.0, 1.0, 0.0];
pub(crate) const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// A frame at a place, turned by three body-fixed angles.
pub(crate) fn offset(at: [f64; 3], angles: [f64; 3]) -> Isometry3<f64> {
    slide(at) * turn(X, angles[0]) * turn(Y, angles[1]) * turn(Z, angles[2])
}

/// The pose of a body's frame with the named coordinates at these values, followers in their places.
pub(crate) fn pose(import: &Import, name: &str, values: &[(&str, f64)]) -> Isometry3<f64> {
    let figure = &import.figure;
    let tree = Tree::<f64>::new(figure, import.gravity).expect("a figure");
    let mut workspace = Workspace::new(&tree);
    let (mut q, mut v, mut a) = (vec![0.0; tree.nq()], vec![0.0; tree.nv()], vec![0.0; tree.nv()]);
    for (coordinate, value) in values {
        q[figure.layout().dof_index(coordinate).expect("a coordinate of the file")] = *value;
    }
    figure.follow(&mut q, &mut v, &mut a);
    forward_kinematics(&tree, &mut workspace, &q).expect("a state");
    let frame = figure.links().iter().enumerate().find_map(|(i, link)| {
        let frame = link.frames().iter().find(|frame| frame.name == name).map(|frame| frame.placement);
        frame.or_else(|| (link.name() == name).then(Isometry3::identity)).map(|within| (i, within))
    });
    let own = figure.links().iter().enumerate().find_map(|(i, link)| {
        link.frames().iter().find(|frame| frame.name == name).map(|frame| (i, frame.placement))
    });
    let (link, within) = own.or(frame).expect("a body of the file");
    let Pose { rotation, translation } = workspace.pose(link).then(&Pose::of(&within));
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation));
    Isometry3::from_parts(translation.into(), turn)
}

#[track_caller]
pub(crate) fn assert_near(found: &Isometry3<f64>, expected: &Isometry3<f64>, what: &str) {
    let off = (found.to_homogeneous() - expected.to_homogeneous()).amax();
    assert!(off < 1e-13, "{what}: {off:e}\n{found}\n{expected}");
}

/// The rod's pose is that of the chain of frames: offset, joint, offset back.
#[track_caller]
pub(crate) fn check(import: &Import, values: &[(&str, f64)], moved: Isometry3<f64>, what: &str) {
    let below = offset([0.1, 0.2, -0.3], [0.4, -0.5, 0.6]);
    let on = offset([-0.05, 0.3, 0.02], [-0.2, 0.7, 0.1]);
    assert_near(&pose(import, "rod", values), &(below * moved * on.inverse()), what);
}

#[test]
fn joints_move_as_their_kinds_say() {
    let [p, r, s, u, v, w] = [0.3, -0.7, 1.1, 0.25, -0.4, 0.6];
    let xyz = turn(X, p) * turn(Y, r) * turn(Z, s);
    let cases: [(&str, &[f64], Isometry3<f64>); 8] = [
        ("PinJoint", &[p], turn(Z, p)),
        ("SliderJoint", &[p], slide([p, 0.0, 0.0])),
        ("WeldJoint", &[], Isometry3::identity()),
        ("UniversalJoint", &[p, r], turn(X, p) * turn(Y, r)),
        ("BallJoint", &[p, r, s], xyz),
        ("GimbalJoint", &[p, r, s], xyz),
        ("PlanarJoint", &[p, r, s], slide([r, s, 0.0]) * turn(Z, p)),
        ("FreeJoint", &[p, r, s, u, v, w], slide([u, v, w]) * xyz),
    ];
    for (kind, values, moved) in cases {
        let names = ["one", "two", "three", "four", "five", "six"];
        let import = rod(kind, &names[..values.len()], "");
        let values: Vec<_> = names.into_iter().zip(values.iter().copied()).collect();
        check(&import, &values, moved, kind);
        assert_eq!(import.figure.layout().nv(), values.len(), "{kind}");
        // OpenSim names what the file does not.
        let import = rod(kind, &[], "");
        let mut named: Vec<String> = import.figure.layout().v_names().to_vec();
        named.sort();
        assert_eq!(
            named,
            (0..values.len()).map(|i| format!("pivot_coord_{i}")).collect::<Vec<_>>(),
            "{kind}"
        );
    }
}

/// A `TransformAxis` of version 4.
pub(crate) fn axis(name: &str, coordinates: &str, direction: &str, function: &str) -> String {
    format!(
        "<TransformAxis name=\"{name}\"><coordinates>{coordinates}</coordinates><axis>{direction}</axis>{function}</TransformAxis>"
    )
}

#[test]
fn a_custom_joint_slides_along_fixed_axes_and_turns_about_moved_ones() {
    // Every function once, oblique axes, constants before, between and after.
    let spline = "<SimmSpline><x>-1 -0.3 0.4 1.2</x><y>0.02 0.05 -0.01 0.03</y></SimmSpline>";
    let axes = [
        axis(
            "rotation1",
            "bend",
            "1 2 3",
            "<LinearFunction name=\"function\"><coefficients>-1 0.3</coefficients></LinearFunction>",
        ),
        axis("rotation2", "", "0 1 0", "<Constant name=\"function\"><value>0.8</value></Constant>"),
        axis("rotation3", "twist", "3 -1 0.5", ""),
        axis(
            "translation1",
            "bend",
            "1 0.2 0",
            &format!(
                "<MultiplierFunction name=\"function\"><function>{spline}</function><scale>1.5</scale></MultiplierFunction>"
            ),
        ),
        axis(
            "translation2",
            "twist",
            "0 1 0",
            "<PolynomialFunction name=\"function\"><coefficients>0.2 -0.1 0.05</coefficients></PolynomialFunction>",
        ),
        axis(
            "translation3",
            "bend",
            "0 0 2",
            "<function><PiecewiseLinearFunction><x>-1 0 1</x><y>0.1 0 0.3</y></PiecewiseLinearFunction></function>",
        ),
    ];
    let import = rod(
        "CustomJoint",
        &["bend", "twist"],
        &format!("<SpatialTransform>{}</SpatialTransform>", axes.concat()),
    );
    let figure = &import.figure;
    assert_eq!(figure.followers().len(), 3);
    assert_eq!(figure.layout().nv(), 5);
    // Four points fix one cubic, which the spline is.
    let cubic = |x: f64| {
        let (xs, ys) = ([-1.0, -0.3, 0.4, 1.2], [0.02, 0.05, -0.01, 0.03]);
        (0..4)
            .map(|i| (0..4).filter(|j| *j != i).fold(ys[i], |p, j| p * (x - xs[j]) / (xs[i] - xs[j])))
            .sum::<f64>()
    };
    for (bend, twist) in [(0.0, 0.0), (0.7, -0.4), (-0.9, 1.3)] {
        let hinge = if bend < 0.0 { -0.1 * bend } else { 0.3 * bend };
        let by = Vector3::new(1.0, 0.2, 0.0).normalize() * 1.5 * cubic(bend)
            + Vector3::y() * (0.2 * twist * twist - 0.1 * twist + 0.05)
            + Vector3::z() * hinge;
        let moved = slide(by.into())
            * turn([1.0, 2.0, 3.0], 0.3 - bend)
            * turn(Y, 0.8)
            * turn([3.0, -1.0, 0.5], twist);
        check(&import, &[("bend", bend), ("twist", twist)], moved, "custom");
    }
}

/// A kneecap: a coordinate all of whose axes are functions of it, by itself and tied to a knee.
#[test]
fn a_coordinate_may_move_axes_by_functions_alone() {
    let spline = |y: &str| format!("<SimmSpline name=\"function\"><x>-1 0 1</x><y>{y}</y></SimmSpline>");
    let turn_and_slide =
        axis("rotation1", "", "0 0 1", "<Constant name=\"function\"><value>0.2</value></Constant>")
            + &axis("rotation2", "beta", "1 0 0", &spline("0.5 0.1 0.5"))
            + &axis("translation2", "beta", "0 1 0", &spline("0.01 0.04 0.09"));
    let transform = format!("<SpatialTransform>{turn_and_slide}</SpatialTransform>");
    // Parabolas through three points, straight on beyond them.
    let tilt = |beta: f64| if beta > 1.0 { 0.5 + 0.8 * (beta - 1.0) } else { 0.1 + 0.4 * beta * beta };
    let rise = |beta: f64| {
        if beta > 1.0 { 0.09 + 0.06 * (beta - 1.0) } else { 0.04 + 0.04 * beta + 0.01 * beta * beta }
    };
    let moved = |beta: f64| slide([0.0, rise(beta), 0.0]) * turn(Z, 0.2) * turn(X, tilt(beta));
    let import = rod("CustomJoint", &["beta"], &transform);
    assert_eq!((import.figure.layout().nv(), import.figure.followers().len()), (3, 2));
    for beta in [-0.8, 0.0, 0.3, 1.7] {
        check(&import, &[("beta", beta)], moved(beta), "by itself");
    }
    // Of a function that its coordinate cannot be a part of, it is turned forth and back.
    let wave =
        axis("translation3", "beta", "0 0 1", "<Sine name=\"function\"><amplitude>0.3</amplitude></Sine>");
    let swung = rod("CustomJoint", &["beta"], &format!("<SpatialTransform>{wave}</SpatialTransform>"));
    check(&swung, &[("beta", 0.7)], slide([0.0, 0.0, 0.3 * 0.7_f64.sin()]), "a wave alone");
    // What OpenSim calls neither angle nor length.
    assert!(import.findings.iter().any(|finding| finding.message.contains("in radians")));

    let knee = joint("PinJoint", "knee", ["/ground", "/bodyset/shank"], &["bend"], "");
    let kneecap = joint("CustomJoint", "pivot", ["below", "on"], &["beta"], &format!("{OFFSETS}{transform}"));
    let coupler = |function: &str| {
        format!(
            "<ConstraintSet><objects><CoordinateCouplerConstraint name=\"tie\">\
             <coupled_coordinates_function>{function}</coupled_coordinates_function>\
             <independent_coordinate_names>bend</independent_coordinate_names>\
             <dependent_coordinate_name>beta</dependent_coordinate_name></CoordinateCouplerConstraint></objects></ConstraintSet>"
        )
    };
    let bodies = body("rod", 2.0) + &body("shank", 3.0);
    let line = coupler("<LinearFunction><coefficients>-0.5 0.1</coefficients></LinearFunction>");
    let bent = coupler("<SimmSpline><x>-1 0 1</x><y>1 0 1</y></SimmSpline>");
    let same = |x: f64| if x.abs() > 1.0 { 1.0 + 2.0 * (x.abs() - 1.0) } else { x * x };
    for bend in [-1.4, -0.3, 0.0, 0.8] {
        let import = read(&document(&bodies, &(knee.clone() + &kneecap), &line));
        check(&import, &[("bend", bend)], moved(0.1 - 0.5 * bend), "tied by a line");
        let import = read(&document(&bodies, &(knee.clone() + &kneecap), &bent));
        check(&import, &[("bend", bend)], moved(same(bend)), "tied by a spline");
        assert!(import.figure.layout().q_names().contains(&"beta".to_owned()));
    }
}

#[test]
fn rotations_may_follow_too() {
    let spline =
        "<GCVSpline name=\"function\"><half_order>2</half_order><x>0 1 2</x><y>0 1 0</y></GCVSpline>";
    let axes = [axis("rotation1", "knee", "0 0 1", ""), axis("rotation2", "knee", "0 1 0", spline)];
    let import =
        rod("CustomJoint", &["knee"], &format!("<SpatialTransform>{}</SpatialTransform>", axes.concat()));
    // σ₁ = −½ by hand: f(½) = 1.5·½ − 0.5·⅛.
    check(&import, &[("knee", 0.5)], turn(Z, 0.5) * turn(Y, 0.6875), "natural cubic");
    check(&import, &[("knee", -1.0)], turn(Z, -1.0) * turn(Y, -1.5), "straight on");
    // Without an order it is a quintic, which a parabola comes back from.
    let quintic = spline.replace(
        "<half_order>2</half_order><x>0 1 2</x><y>0 1 0</y>",
        "<x>-2 -1 0 1 2 3</x><y>4 1 0 1 4 9</y>",
    );
    let wave = "<Sine name=\"function\"><amplitude>0.5</amplitude><omega>2</omega><phase>0.1</phase><offset>0.2</offset></Sine>";
    let axes = [
        axis("rotation1", "knee", "0 0 1", ""),
        axis("rotation2", "knee", "0 1 0", &quintic),
        axis("translation1", "knee", "1 0 0", wave),
    ];
    let import =
        rod("CustomJoint", &["knee"], &format!("<SpatialTransform>{}</SpatialTransform>", axes.concat()));
    let to_side = slide([0.2 + 0.5 * 0.9_f64.sin(), 0.0, 0.0]);
    check(&import, &[("knee", 0.4)], to_side * turn(Z, 0.4) * turn(Y, 0.16), "quintic and wave");
}

#[test]
fn a_limb_keeps_names_limits_masses_and_frames() {
    let femur = "<frames><PhysicalOffsetFrame name=\"hip\"><socket_parent>/bodyset/pelvis</socket_parent>\
        <translation>0 -0.1 0.08</translation></PhysicalOffsetFrame></frames>";
    let foot = "<frames><PhysicalOffsetFrame name=\"tip\"><socket_parent>../../../bodyset/femur</socket_parent>\
        <translation>0 -0.4 0</translation></PhysicalOffsetFrame></frames>";
    let joints = joint(
        "FreeJoint",
        "root",
        ["/ground", "/bodyset/pelvis"],
        &["rx", "ry", "rz", "tx", "ty", "tz"],
        "",
    ) + &joint(
        "PinJoint",
        "hip",
        ["hip", "../../bodyset/femur"],
        &[],
        &format!(
            "{femur}<coordinates><Coordinate name=\"flexion\"><default_value>0.2</default_value><range>-1 2</range>\
             <locked>true</locked><clamped>false</clamped></Coordinate></coordinates>"
        ),
    ) + &joint("WeldJoint", "ankle", ["tip", "/bodyset/foot"], &[], foot);
    let more = "<gravity>0 0 -9.81</gravity>";
    let bodies = body("pelvis", 11.0) + &body("femur", 9.0) + &body("foot", 1.5);
    let import = read(&document(&bodies, &joints, more));
    let figure = &import.figure;
    assert_eq!(figure.links().len(), 2);
    assert!((figure.mass() - 21.5).abs() < 1e-12);
    assert_eq!(figure.layout().q_names(), ["tx", "ty", "tz", "rx", "ry", "rz", "flexion"]);
    let hip = figure.links()[1].joint();
    assert_eq!(hip.name(), "hip");
    let limits = hip.kind().axes()[0].limits.expect("a range");
    assert_eq!((limits.lower, limits.upper), (-1.0, 2.0));
    assert_eq!((import.gravity, import.gravity_is_given), (Vector3::new(0.0, 0.0, -9.81), true));
    let expected =
        offset([0.3, 0.0, 0.0], [0.0; 3]) * slide([0.0, -0.1, 0.08]) * turn(Z, 0.5) * slide([0.0, -0.4, 0.0]);
    assert_near(&pose(&import, "foot", &[("tx", 0.3), ("flexion", 0.5)]), &expected, "foot");
    let said: Vec<_> = import.findings.iter().map(|f| (f.kind, f.subject.as_str())).collect();
    assert!(said.contains(&(FindingKind::Unsupported, "coordinate 'flexion'")), "{said:?}");
    assert!(said.contains(&(FindingKind::Note, "joint 'root'")), "{said:?}");
}

/// The same leg in the layout of version 3 and in that of version 4.
#[test]
fn older_models_are_the_same_figure() {
    let older = "<OpenSimDocument Version=\"30000\"><Model name=\"toy\"><BodySet><objects>\
        <Body name=\"ground\"><mass>0</mass><mass_center>0 0 0</mass_center><Joint/></Body>\
        <Body name=\"rod\"><mass>2</mass><mass_center>0.01 -0.2 0.03</mass_center>\
          <inertia_xx>0.02</inertia_xx><inertia_yy>0.015</inertia_yy><inertia_zz>0.021</inertia_zz>\
          <inertia_xy>0.001</inertia_xy><inertia_xz>-0.002</inertia_xz><inertia_yz>0.0005</inertia_yz>\
          <Joint><CustomJoint name=\"pivot\"><parent_body>ground</parent_body>\
            <location_in_parent>0.1 0.2 -0.3</location_in_parent><orientation_in_parent>0.4 -0.5 0.6</orientation_in_parent>\
            <location>-0.05 0.3 0.02</location><orientation>-0.2 0.7 0.1</orientation>\
            <CoordinateSet><objects><Coordinate name=\"bend\"><motion_type>rotational</motion_type><range>-2 1</range></Coordinate></objects></CoordinateSet>\
            <reverse>false</reverse>\
            <SpatialTransform>\
              <TransformAxis name=\"rotation1\"><coordinates>bend</coordinates><axis>0 0 1</axis>\
                <function><LinearFunction><coefficients>1 0</coefficients></LinearFunction></function></TransformAxis>\
              <TransformAxis name=\"translation1\"><coordinates>bend</coordinates><axis>1 0 0</axis>\
                <function><natCubicSpline><x>-1 0 1</x><y>1 0 1</y></natCubicSpline></function></TransformAxis>\
            </SpatialTransform></CustomJoint></Joint></Body>\
        </objects></BodySet></Model></OpenSimDocument>";
    let old = read(older);
    // A parabola through three points.
    check(&old, &[("bend", 0.6)], slide([0.36, 0.0, 0.0]) * turn(Z, 0.6), "version 3");
    let axes = axis("rotation1", "bend", "0 0 1", "")
        + &axis(
            "translation1",
            "bend",
            "1 0 0",
            "<SimmSpline name=\"function\"><x>-1 0 1</x><y>1 0 1</y></SimmSpline>",
        );
    let new = rod("CustomJoint", &["bend"], &format!("<SpatialTransform>{axes}</SpatialTransform>"));
    assert_eq!(old.figure.fingerprint(), new.figure.fingerprint());
}

#[test]
fn what_is_not_read_is_listed() {
    let more = "<ForceSet><objects><Millard2012EquilibriumMuscle name=\"a\"/><Millard2012EquilibriumMuscle name=\"b\"/>\
        <CoordinateLimitForce name=\"c\"/><SpringGeneralizedForce name=\"d\"/></objects></ForceSet>\
        <ControllerSet><objects><PrescribedController name=\"e\"/></objects></ControllerSet>\
        <MarkerSet><objects><Marker name=\"f\"/><Marker name=\"g\"/></objects></MarkerSet>\
        <ConstraintSet><objects><WeldConstraint name=\"h\"/></objects></ConstraintSet>\
        <length_units>inches</length_units><Sundial>noon</Sundial>\n";
    let joints = joint("PinJoint", "pivot", ["/ground", "/bodyset/rod"], &["angle"], "");
    let rod = body("rod", 2.0).replace(
        "</Body>",
        "<WrapObjectSet><objects><WrapCylinder name=\"w\"/></objects></WrapObjectSet><attached_geometry><Mesh/></attached_geometry></Body>",
    );
    let import = read(&document(&rod, &joints, more));
    let list: Vec<String> =
        import.findings.iter().map(|f| format!("{:?} {}: {}", f.kind, f.subject, f.message)).collect();
    insta::assert_snapshot!(list.join("\n"));
}
