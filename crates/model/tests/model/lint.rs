//! What lint says: nothing of sound figures, and each mistake by its link and values.

use proptest::prelude::*;
use solaris_model::{
    Curve, Figure, FigureBuilder, Finding, FindingKind, Human, Inertia, Isometry3, Joint, LinkSpec,
    MassDoubt, Matrix3, Placement, Shape, ShapeKind, UnitQuaternion, Vector3, human,
};

fn shape(kind: ShapeKind) -> Shape {
    Shape { kind, placement: Placement::identity() }
}

/// One link.
fn single(link: impl FnOnce(LinkSpec) -> LinkSpec) -> Figure {
    FigureBuilder::new("f").link(link(LinkSpec::root("a", Joint::new("j").rx()))).build().expect("valid")
}

fn said(figure: &Figure) -> String {
    let line = |finding: &Finding| format!("{:?} {finding}", finding.kind);
    figure.lint().iter().map(line).collect::<Vec<_>>().join("\n")
}

fn is_suspect(figure: &Figure, words: &str) -> bool {
    figure.lint().iter().any(|f| f.kind == FindingKind::Suspect && f.message.contains(words))
}

#[test]
fn sound_figures_have_nothing_to_be_said() {
    for figure in [
        human(1.75, 73.0),
        human(1.55, 50.0),
        human(1.95, 110.0),
        Human::new(1.75, 73.0).segment_length("thigh", 0.47).segment_length("forearm", 0.22).build(),
    ] {
        assert_eq!(said(&figure.expect("in range")), "");
    }
    let uniform = |kind, density: f64| {
        let at = Isometry3::new(Vector3::new(0.1, 0.2, 0.3), Vector3::new(0.4, -1.0, 2.0));
        let solid = Shape { kind, placement: at };
        single(|link| link.mass(density * kind.volume()).inertia(Inertia::Uniform(solid)))
    };
    for kind in [
        ShapeKind::Box { size: Vector3::new(0.1, 0.02, 1.5) },
        ShapeKind::Cylinder { radius: 0.2, length: 0.01 },
        ShapeKind::Ellipsoid { radii: Vector3::new(0.1, 0.3, 0.01) },
        ShapeKind::Capsule { radius: 0.01, length: 0.9 },
        ShapeKind::Sphere { radius: 0.1 },
    ] {
        for density in [301.0, 1000.0, 2999.0] {
            assert_eq!(said(&uniform(kind, density)), "", "{kind:?}");
        }
    }
}

#[test]
fn densities_that_nothing_has_are_told() {
    let ball = ShapeKind::Sphere { radius: 0.1 };
    let [light, heavy] = [299.0, 3001.0].map(|density| {
        single(|link| link.mass(density * ball.volume()).inertia(Inertia::Uniform(shape(ball))))
    });
    insta::assert_snapshot!(format!("{}\n{}", said(&light), said(&heavy)), @r"
    Suspect a: its density is 299 kg/m³, 1.252 kg in 0.004189 m³; most bodies have 300 to 3000: check its mass and the size of its shape
    Suspect a: its density is 3001 kg/m³, 12.57 kg in 0.004189 m³; most bodies have 300 to 3000: check its mass and the size of its shape
    ");
}

#[test]
fn limits_are_told_that_are_none_or_exclude_the_zero_pose() {
    let figure = FigureBuilder::new("f")
        .link(
            LinkSpec::root(
                "a",
                Joint::new("j").rx().limited(0.0, 0.0).ry().limited(-3.07, -0.07).rz().limited(0.0, 1.0),
            )
            .mass(1.0),
        )
        .link(
            // A slide that follows stands where its leader puts it at the zero pose.
            LinkSpec::child(
                "b",
                "a",
                Joint::new("k")
                    .ty()
                    .limited(0.4, 0.6)
                    .following("j.rx", Curve::linear(1.0, 0.5))
                    .tx()
                    .limited(-0.1, 0.1)
                    .following("j.rx", Curve::linear(1.0, 0.5)),
            )
            .mass(1.0),
        )
        .build()
        .expect("valid");
    insta::assert_snapshot!(said(&figure), @r"
    Suspect j.rx: its limits are both 0, so that it cannot move; weld it, or give it a range
    Suspect j.ry: its limits -3.07 to -0.07 exclude 0, the zero pose
    Suspect k.tx: its limits -0.1 to 0.1 exclude 0.5, where it follows to at the zero pose
    ");
}

#[test]
fn inertias_are_told_that_nothing_of_the_links_size_has() {
    let rod = |scale: f64| Inertia::diagonal(scale * 0.03, scale * 0.001, scale * 0.03);
    let plain = |inertia| {
        single(|link| {
            link.mass(1.0).com(Vector3::new(0.0, 0.2, 0.0)).tip(Vector3::new(0.0, 0.5, 0.0)).inertia(inertia)
        })
    };
    assert_eq!(said(&plain(rod(1.0))), "");
    let capsule = shape(ShapeKind::Capsule { radius: 0.02, length: 0.6 });
    let drawn = |inertia, com| single(|link| link.mass(0.8).com(com).shape(capsule).inertia(inertia));
    assert_eq!(said(&drawn(rod(0.8), Vector3::zeros())), "");
    let turned = UnitQuaternion::from_euler_angles(0.3, 0.4, 0.5).to_rotation_matrix();
    let oblique = turned.matrix()
        * Matrix3::from_diagonal(&Vector3::new(0.01, 0.02, 0.03))
        * turned.matrix().transpose();
    let answers = [
        plain(rod(40.0)),
        drawn(rod(8.0), Vector3::zeros()),
        drawn(rod(1e-3), Vector3::zeros()),
        drawn(rod(0.8), Vector3::new(0.021, 0.0, 0.0)),
        plain(Inertia::Tensor(oblique)),
    ];
    insta::assert_snapshot!(answers.iter().map(said).collect::<Vec<_>>().join("\n"), @r"
    Suspect a: its radius of gyration is 1.095 m, but nothing on it is farther than 0.3 m from its centre of mass: check the units of its inertia
    Suspect a: its inertia has its mass spread 0.5431 m on average along its longest axis, and inside of its shape that is 0.32 m at most: check the factor of the formula, the point of reference (the centre of mass) and the units
    Suspect a: its inertia is 0.001157 times that of a uniform solid of its shape and mass; check its units
    Suspect a: its centre of mass lies 0.021 m from the centre of its shape along the shape's x, which ends at 0.02 m: one of the two is misplaced, or the shape is not all of the link
    Suspect a: its products of inertia are as large as they can be: along (-0.468, 0.081, -0.880) it has no extension at all; check their signs and the axes they are given along
    ");
    // A link of which nothing but its origin is known has no size to compare with.
    assert_eq!(said(&single(|link| link.mass(1.0).inertia(rod(40.0)))), "");
    // A plate along the link's axes and a thin rod in any direction are bodies.
    assert_eq!(said(&plain(Inertia::diagonal(0.01, 0.02, 0.03))), "");
    let rod = turned.matrix()
        * Matrix3::from_diagonal(&Vector3::new(0.0, 0.03, 0.03))
        * turned.matrix().transpose();
    assert_eq!(said(&plain(Inertia::Tensor(rod))), "");
}

/// `∫ p pᵀ dm` of a box along x with its origin in the middle of one end, as the thesis prints it or in parts.
struct Printed {
    /// Factor of M·α²: 1/3 for a box, 2/3 as printed.
    along: f64,
    /// Whether the products are those printed; they are zero for a box.
    products: bool,
}

impl Printed {
    fn second_moments(&self, mass: f64, size: &Vector3<f64>) -> Matrix3<f64> {
        let [a, g, b] = [size.x, size.y, size.z];
        let [xy, xz, yz] = if self.products { [a * g / 4.0, a * b / 4.0, b * g / 16.0] } else { [0.0; 3] };
        #[rustfmt::skip]
        let j = Matrix3::new(
            self.along * a * a, xy,             xz,
            xy,                 g * g / 12.0,   yz,
            xz,                 yz,             b * b / 12.0,
        );
        j * mass
    }

    /// The box with the inertia about its centre of mass that follows from them, or with the one about its end taken for
    /// it.
    fn link(&self, mass: f64, size: &Vector3<f64>, about_end: bool) -> LinkSpec {
        let centre = Vector3::new(size.x / 2.0, 0.0, 0.0);
        let carried = if about_end { Matrix3::zeros() } else { centre * centre.transpose() * mass };
        let moments = self.second_moments(mass, size) - carried;
        let inertia = Matrix3::identity() * moments.trace() - moments;
        let solid = Shape {
            kind: ShapeKind::Box { size: *size },
            placement: Placement::translation(centre.x, 0.0, 0.0),
        };
        LinkSpec::root("a", Joint::new("j").rx())
            .mass(mass)
            .com(centre)
            .shape(solid)
            .inertia(Inertia::Tensor(inertia))
    }
}

proptest! {
    /// The formula of §3.7 of the thesis, as printed and in parts, for boxes of any form: each is found.
    #[test]
    fn the_printed_inertia_of_a_box_is_caught(
        x in -2.0_f64..0.3, y in -2.0_f64..0.3, z in -2.0_f64..0.3, density in 400.0_f64..2500.0, about_end in any::<bool>()
    ) {
        let size = Vector3::new(x, y, z).map(|exponent| 10.0_f64.powf(exponent));
        let mass = density * size.product();
        let build = |along, products, about_end| {
            let link = Printed { along, products }.link(mass, &size, about_end);
            FigureBuilder::new("f").link(link).build().expect("a figure")
        };
        let is_impossible = |figure: &Figure| {
            matches!(figure.mass_doubts()[..], [MassDoubt::NotPhysical { .. }])
                && is_suspect(figure, "not that of any mass distribution")
        };
        // As it should be: nothing to be said.
        let right = build(1.0 / 3.0, false, false);
        prop_assert_eq!(said(&right), "");
        // As printed, no mass distribution; in the slimmest boxes printed digits hide that, and the coefficient is told.
        let printed = build(2.0 / 3.0, true, about_end);
        prop_assert!(is_impossible(&printed) || is_suspect(&printed, "spread"), "{}", said(&printed));
        // The printed products alone: none either.
        prop_assert!(is_impossible(&build(1.0 / 3.0, true, false)));
        // The coefficient alone: five times the spread along the box about its centre, eight times taken for that.
        let coefficient = build(2.0 / 3.0, false, about_end);
        prop_assert!(is_suspect(&coefficient, "spread"), "{}", said(&coefficient));
        // About the end, taken for about the centre: four times.
        let end = build(1.0 / 3.0, false, true);
        prop_assert!(is_suspect(&end, "spread"), "{}", said(&end));
        // 1/12 about the end: less than nothing is left about the centre.
        prop_assert!(is_impossible(&build(1.0 / 12.0, false, false)));
    }
}

/// Two arms on a trunk that stands turned; `change` changes the links of the left one.
fn arms(change: impl Fn(&str, LinkSpec) -> LinkSpec) -> Figure {
    let mut builder = FigureBuilder::new("arms").link(LinkSpec::root(
        "trunk",
        Joint::new("root").placed(Isometry3::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.3, 0.2, 0.1))),
    ));
    let round = |name: &str, parent: &str, joint: Joint, side: f64, turn: UnitQuaternion<f64>| {
        // The frames of the right side are turned: what stands in them is turned back.
        let back = turn.inverse().to_rotation_matrix();
        let tensor = Matrix3::new(
            0.02,
            0.001 * side,
            0.002 * side,
            0.001 * side,
            0.03,
            0.003,
            0.002 * side,
            0.003,
            0.04,
        );
        LinkSpec::child(name, parent, joint)
            .mass(2.0)
            .com(back * Vector3::new(0.1 * side, 0.02, -0.1))
            .inertia(Inertia::Tensor(back.matrix() * tensor * back.matrix().transpose()))
    };
    let turns = [UnitQuaternion::identity(), UnitQuaternion::from_euler_angles(0.5, 1.0, -2.0)];
    for (prefix, side, turn) in [("l_", 1.0, turns[0]), ("r_", -1.0, turns[1])] {
        let shoulder = Placement::from_parts(Vector3::new(0.25 + 0.2 * side, 0.4, 0.0).into(), turn);
        let elbow = turn.inverse() * Vector3::new(0.03 * side, -0.3, 0.01);
        let upper = round(
            &format!("{prefix}upper"),
            "trunk",
            Joint::new(format!("{prefix}shoulder")).placed(shoulder).rx(),
            side,
            turn,
        );
        let fore = round(
            &format!("{prefix}fore"),
            &format!("{prefix}upper"),
            Joint::new(format!("{prefix}elbow")).at(elbow).ry(),
            side,
            turn,
        );
        for (name, link) in [("upper", upper), ("fore", fore)] {
            builder = builder.link(if side > 0.0 { change(name, link) } else { link });
        }
    }
    builder.build().expect("valid")
}

#[test]
fn mirror_images_are_seen_through_turned_frames_and_about_any_plane() {
    assert_eq!(said(&arms(|_, link| link)), "");
}

#[test]
fn what_is_no_mirror_image_is_told_with_both_values() {
    let only = |which: &'static str, change: fn(LinkSpec) -> LinkSpec| {
        said(&arms(|name, link| if name == which { change(link) } else { link }))
    };
    let answers = [
        only("upper", |link| link.mass(2.000_003)),
        only("fore", |link| link.com(Vector3::new(0.1, 0.020_003, -0.1))),
        only("fore", |link| link.inertia(Inertia::diagonal(0.02, 0.03, 0.04))),
        said(&arms(|name, link| match name {
            "fore" => LinkSpec::child(
                "l_fore",
                "l_upper",
                Joint::new("l_elbow").at(Vector3::new(0.03, -0.301, 0.01)).ry(),
            )
            .mass(2.0)
            .com(Vector3::new(0.1, 0.02, -0.1))
            .inertia(Inertia::Tensor(Matrix3::new(
                0.02, 0.001, 0.002, 0.001, 0.03, 0.003, 0.002, 0.003, 0.04,
            ))),
            _ => link,
        })),
    ];
    insta::assert_snapshot!(answers.join("\n"), @r"
    Suspect l_upper: it is no mirror image of 'r_upper' in the plane x = 0.25 m of 'trunk': masses 2.000003 and 2 kg
    Suspect l_fore: it is no mirror image of 'r_fore' in the plane x = 0.25 m of 'trunk': centre of mass at (0.1000000, 0.0200030, -0.1000000) m from its joint, the image at (0.1000000, 0.0200000, -0.1000000) m, 3e-6 m apart
    Suspect l_fore: it is no mirror image of 'r_fore' in the plane x = 0.25 m of 'trunk': inertias yz 0 and 0.003 kg m²
    Suspect l_fore: it is no mirror image of 'r_fore' in the plane x = 0.25 m of 'trunk': joint origin at (0.0300000, -0.3010000, 0.0100000) m from the parent's, the image at (0.0300000, -0.3000000, 0.0100000) m, 0.001 m apart
    ");
    // A millionth of all is as good as none.
    assert_eq!(only("upper", |link| link.mass(2.000_001)), "");
}

#[test]
fn a_gripper_may_be_symmetric_to_its_own_hand() {
    let hand = Placement::from_parts(
        Vector3::new(0.1, 0.0, 0.5).into(),
        UnitQuaternion::from_euler_angles(0.0, 0.0, 0.785),
    );
    let gripper = |mass: f64| {
        let finger = |name: &str, side: f64| {
            let joint =
                Joint::new(format!("{name}_joint")).at(Vector3::new(0.0, 0.0, 0.06)).ty().limited(0.0, 0.04);
            LinkSpec::child(name, "hand", joint).mass(0.1).com(Vector3::new(0.0, 0.01 * side, 0.02))
        };
        FigureBuilder::new("gripper")
            .link(LinkSpec::root("base", Joint::new("weld")).mass(3.0))
            .link(LinkSpec::child("hand", "base", Joint::new("wrist").placed(hand).rz()).mass(1.0))
            .link(finger("hand_leftfinger", 1.0))
            .link(finger("hand_rightfinger", -1.0).mass(mass))
            .build()
            .expect("valid")
    };
    assert_eq!(said(&gripper(0.1)), "");
    insta::assert_snapshot!(said(&gripper(0.2)), @r"Suspect hand_leftfinger: it is no mirror image of 'hand_rightfinger' in the plane y = 0 of 'hand', nor in the others: masses 0.1 and 0.2 kg");
}

#[test]
fn a_side_without_its_other_is_noted() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("trunk", Joint::new("root").rx()).mass(1.0))
        .link(LinkSpec::child("left_arm", "trunk", Joint::new("shoulder").rx()).mass(1.0))
        .build()
        .expect("valid");
    insta::assert_snapshot!(said(&figure), @"Note left_arm: its name has a side, but there is no 'right_arm'");
}

#[test]
fn the_extent_is_that_of_shapes_and_points_along_up() {
    let boxed = Shape {
        kind: ShapeKind::Box { size: Vector3::new(0.2, 0.4, 0.6) },
        placement: Placement::translation(0.0, 0.2, 0.0),
    };
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("world", Joint::new("weld")))
        .link(
            LinkSpec::child("a", "world", Joint::new("j").at(Vector3::new(0.0, 1.0, 0.0)).rx())
                .mass(2.0)
                .shape(boxed),
        )
        .link(
            LinkSpec::child("b", "a", Joint::new("k").at(Vector3::new(0.0, 0.4, 0.0)).rx())
                .mass(1.0)
                .tip(Vector3::new(0.0, 0.3, 0.0)),
        )
        .build()
        .expect("valid");
    let extent = figure.extent(&Vector3::y());
    assert_eq!((extent.mass, extent.stature), (3.0, None));
    assert!((extent.height - 0.7).abs() < 1e-15);
    assert!((figure.extent(&(Vector3::z() * 9.0)).height - 0.6).abs() < 1e-15);
    // As wide as it is from one hand's drawn side to the other's.
    let person = human(1.75, 73.0).expect("in range").extent(&Vector3::x());
    assert_eq!(person.stature, Some(1.75));
    assert!(
        (person.height - 2.0 * 1.75 / 1.741 * (0.025 + 0.155 + 0.002 + 0.001 + 0.022)).abs() < 0.1,
        "{} m",
        person.height
    );
}
