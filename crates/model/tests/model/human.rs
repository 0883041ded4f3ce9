//! The human figure: counts, mass, symmetry, ranges.

use solaris_model::{Figure, Human, HumanError, Link, SolePart, Vector3, human};

fn ordinary() -> Figure {
    human(1.75, 73.0).expect("an ordinary human")
}

/// Heights (m) and masses (kg) over the whole range of both.
fn bodies() -> Vec<(f64, f64)> {
    let heights = (0..=30).map(|i| 0.8 + 1.5 * f64::from(i) / 30.0);
    heights.flat_map(|h| (0..=40).map(move |i| (h, (8.0 + 72.0 * f64::from(i) / 40.0) * h * h))).collect()
}

#[test]
fn there_are_21_links_and_66_dofs() {
    let figure = ordinary();
    assert_eq!(figure.links().len(), 21);
    assert_eq!((figure.layout().nq(), figure.layout().nv()), (66, 66));
    let joints: Vec<&str> = figure.links().iter().map(|link| link.joint().name()).collect();
    insta::assert_snapshot!(joints.join(" "), @"root lumbar thorax neck head left_clavicle left_shoulder left_elbow left_wrist left_hip left_knee left_ankle left_toes right_clavicle right_shoulder right_elbow right_wrist right_hip right_knee right_ankle right_toes");
    for link in figure.links().iter().skip(1) {
        let name = link.joint().name();
        let joint = figure.layout().joints()[figure.joint_index(name).expect("its own joint")];
        let names = &figure.layout().v_names()[joint.v..joint.v + joint.nv];
        assert_eq!(names, ["rz", "ry", "rx"].map(|axis| format!("{name}.{axis}")));
    }
}

#[test]
fn the_mass_is_the_one_asked_for() {
    for (height, mass) in bodies().into_iter().filter(|(h, m)| (8.0..=80.0).contains(&(m / (h * h)))) {
        let figure = human(height, mass).expect("in range");
        let total: f64 = figure.links().iter().map(Link::mass).sum();
        assert!((total / mass - 1.0).abs() < 1e-14, "{height} m, {mass} kg: {total} kg");
        assert!((figure.mass() / mass - 1.0).abs() < 1e-14);
        assert!(figure.links().iter().all(|link| link.mass() > 0.0));
    }
}

#[test]
fn lengths_follow_the_height_and_masses_the_mass() {
    let (small, large) = (ordinary(), human(0.875, 36.5).expect("in range"));
    for (a, b) in small.links().iter().zip(large.links()) {
        let close = |x: Vector3<f64>, y: Vector3<f64>| (x - y).norm() < 1e-15;
        assert!(close(a.com() / 2.0, *b.com()), "{}", a.name());
        assert!(close(
            a.joint().placement().translation.vector / 2.0,
            b.joint().placement().translation.vector
        ));
        assert!((a.mass() / 2.0 - b.mass()).abs() < 1e-14);
        // m k² L²: half the mass, a quarter of the length's square.
        assert!((a.inertia() / 8.0 - b.inertia()).amax() < 1e-15);
    }
}

#[test]
fn left_and_right_are_mirror_images() {
    let figure = ordinary();
    let mirror = |v: &Vector3<f64>| Vector3::new(-v.x, v.y, v.z);
    let mut pairs = 0;
    for left in figure.links().iter().filter(|link| link.name().starts_with("left_")) {
        let right = figure.link(&left.name().replace("left_", "right_")).expect("a right one");
        assert_eq!(right.com(), &mirror(left.com()), "{}", left.name());
        assert_eq!((right.mass(), right.inertia()), (left.mass(), left.inertia()));
        let origin = |link: &Link| link.joint().placement().translation.vector;
        assert_eq!(origin(right), mirror(&origin(left)));
        assert_eq!(right.tip().copied(), left.tip().map(mirror));
        let soles =
            |link: &Link| link.sole().iter().map(|point| (point.part, point.position)).collect::<Vec<_>>();
        let mirrored: Vec<_> = soles(left).iter().map(|(part, p)| (*part, mirror(p))).collect();
        assert_eq!(soles(right), mirrored);
        // Turns about the axes in the plane of symmetry change their sign, those about x keep it.
        for (l, r) in left.joint().kind().axes().iter().zip(right.joint().kind().axes()) {
            assert_eq!(l.axis, r.axis);
            let (l_limits, r_limits) = (l.limits.expect("a range"), r.limits.expect("a range"));
            let same = l.axis.direction == Vector3::x();
            let expected =
                if same { (l_limits.lower, l_limits.upper) } else { (-l_limits.upper, -l_limits.lower) };
            assert_eq!((r_limits.lower, r_limits.upper), expected, "{}", left.joint().name());
        }
        pairs += 1;
    }
    assert_eq!(pairs, 8);
    for middle in figure.links().iter().filter(|link| !link.name().contains('_')) {
        assert_eq!(
            (middle.com().x, middle.joint().placement().translation.x),
            (0.0, 0.0),
            "{}",
            middle.name()
        );
    }
}

#[test]
fn anatomical_angles_come_in_pairs_with_the_mirrors_sign() {
    let figure = ordinary();
    for left in figure.anatomical_angles().iter().filter(|angle| angle.name.starts_with("left_")) {
        let right = figure.anatomical_angle(&left.name.replace("left_", "right_")).expect("a right one");
        let dof = &figure.layout().v_names()[left.dof];
        assert_eq!(figure.layout().v_names()[right.dof], dof.replace("left_", "right_"));
        let expected = if dof.rsplit('.').next() == Some("rx") { left.sign } else { -left.sign };
        assert_eq!(right.sign.to_bits(), expected.to_bits(), "{}", left.name);
    }
}

#[test]
fn the_feet_stand_on_one_plane() {
    for (height, mass) in [(0.8, 10.0), (1.75, 73.0), (2.3, 200.0)] {
        let figure = human(height, mass).expect("in range");
        let part = |link: &str, part| *figure.link(link).expect("a link").sole_point(part).expect("a point");
        let toes = figure.link("left_toes").expect("a link").joint().placement().translation.vector;
        let heel = part("left_foot", SolePart::Heel);
        for point in [
            part("left_foot", SolePart::Ball),
            toes + part("left_toes", SolePart::Ball),
            toes + part("left_toes", SolePart::ToeTip),
        ] {
            assert!((point.y - heel.y).abs() < 1e-15, "{height} m: {point:?}");
        }
    }
}

#[test]
fn a_segment_may_have_its_own_length() {
    let long =
        Human::new(1.75, 73.0).segment_length("thigh", 0.46).segment_length("left_shank", 0.40).build();
    let figure = long.expect("in range");
    let drop = |link: &str| figure.link(link).expect("a link").joint().placement().translation.y;
    assert!((drop("left_shank") + 0.46).abs() < 1e-12, "the knee hangs 0.46 m below the hip");
    assert!((drop("right_shank") + 0.46).abs() < 1e-12);
    assert!((drop("left_foot") + 0.40).abs() < 1e-12);
    assert!((drop("right_foot") + 0.434 * 1.75 / 1.741).abs() < 1e-12);
    assert!((figure.mass() - 73.0).abs() < 1e-12);
}

/// Whatever a fall does to it, no joint comes near lock as long as it stays near its range.
#[test]
fn a_limp_human_has_no_lock_within_its_range() {
    let limp = Human::new(1.75, 73.0).limp().build().expect("in range");
    assert_eq!((limp.links().len(), limp.layout().nq(), limp.layout().nv()), (21, 69, 66));
    for link in limp.links() {
        let [_, middle, _] = link.joint().kind().axes() else {
            assert!(link.joint().kind().quaternion().is_some(), "{}", link.joint().name());
            continue;
        };
        let range = middle.limits.expect("a range");
        let farthest = range.upper.max(-range.lower).to_degrees();
        assert!(farthest < 45.001, "{} turns by {farthest}° about its middle axis", link.joint().name());
    }
}

/// Masses, places and ranges are those of anybody.
#[test]
fn a_limp_human_is_the_same_body() {
    let (figure, limp) = (ordinary(), Human::new(1.75, 73.0).limp().build().expect("in range"));
    for (one, other) in figure.links().iter().zip(limp.links()) {
        assert_eq!((one.mass(), one.com(), one.inertia()), (other.mass(), other.com(), other.inertia()));
        let (one, other) = (one.joint(), other.joint());
        assert_eq!((one.name(), one.placement()), (other.name(), other.placement()));
        for dof in other.kind().axes() {
            let same = one.kind().axes().iter().find(|one| one.axis == dof.axis).expect("the same axis");
            assert_eq!(same.limits, dof.limits, "{}", one.name());
            assert!(dof.passive.damping > 0.0 && same.passive.is_none(), "{}", one.name());
        }
    }
    let left = limp.anatomical_angle("left_elbow.flexion").expect("an angle");
    assert_eq!(limp.layout().v_names()[left.dof], "left_elbow.rx");
    assert!(limp.anatomical_angle("left_shoulder.flexion").is_none());
    assert_eq!(figure.anatomical_angles().len() - limp.anatomical_angles().len(), 9);
}

/// Torques go with `m·g·h`, times with `√(h/g)`.
#[test]
fn damping_goes_with_the_size() {
    let damping = |height: f64, mass: f64| {
        let limp = Human::new(height, mass).limp().build().expect("in range");
        let knee = limp.joint_index("left_knee").expect("a knee");
        limp.links()[knee].joint().kind().passive(0).damping
    };
    assert!((damping(1.741, 73.0) - 0.5).abs() < 1e-15);
    let expected = damping(1.75, 73.0) * 0.5 * 0.5_f64.powf(1.5);
    assert!((damping(0.875, 36.5) - expected).abs() < 1e-15);
}

#[test]
fn what_is_no_human_is_refused_with_the_range() {
    let bmi = |index: f64| human(1.75, index * 1.75 * 1.75);
    let segment = |name: &str, length| Human::new(1.75, 73.0).segment_length(name, length).build();
    let answers = [
        human(0.79, 10.0),
        human(2.31, 100.0),
        human(f64::NAN, 73.0),
        human(1.75, f64::NAN),
        human(1.75, f64::INFINITY),
        bmi(7.9),
        bmi(81.0),
        segment("thihg", 0.4),
        segment("tail", 0.4),
        segment("left_head", 0.2),
        segment("thigh", 0.86),
        segment("left_thigh", 0.2),
        segment("thigh", f64::NAN),
    ]
    .map(|answer: Result<Figure, HumanError>| answer.expect_err("not a human").to_string());
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn the_ends_of_the_ranges_are_allowed() {
    for height in [0.8, 2.3] {
        for index in [8.0, 80.0] {
            assert!(human(height, index * height * height).is_ok(), "{height} m, index {index}");
        }
    }
}
