//! Fusing: what the small figure is made of, what it is called, and what is refused.

use solaris_model::{
    Axis, Figure, FigureBuilder, FuseError, Fused, Inertia, Isometry3, Joint, JointKind, Link, LinkSpec,
    Shape, ShapeKind, SolePart, Vector3, human,
};
use std::f64::consts::FRAC_PI_2;

fn person() -> Figure {
    human(1.75, 73.0).expect("in range")
}

/// The human with all dofs fused whose name has one of these parts.
fn frozen(figure: &Figure, parts: &[&str]) -> Fused {
    let names = figure.layout().v_names();
    let dofs: Vec<usize> =
        (0..names.len()).filter(|&k| parts.iter().any(|part| names[k].contains(part))).collect();
    figure.fuse_at(&dofs, &vec![0.0; names.len()]).expect("dofs of the figure")
}

/// One joint between two massive links.
fn hinged(joint: Joint) -> Figure {
    let foot = Isometry3::translation(0.0, -0.2, 0.0);
    let shank = LinkSpec::child("shank", "thigh", joint.at(Vector3::new(0.0, -0.4, 0.0)))
        .mass(3.0)
        .com(Vector3::new(0.0, -0.1, 0.02))
        .inertia(Inertia::diagonal(0.03, 0.01, 0.03))
        .tip(Vector3::new(0.0, -0.4, 0.0))
        .frame("marker", foot);
    FigureBuilder::new("leg")
        .link(
            LinkSpec::root("thigh", Joint::new("hip").rz().rx())
                .mass(7.0)
                .inertia(Inertia::diagonal(0.1, 0.1, 0.1)),
        )
        .link(shank)
        .angle("flexion", "hip.rx", true)
        .build()
        .expect("a valid figure")
}

/// `joint: placement [dofs]` of every link.
fn structure(figure: &Figure) -> String {
    let line = |i: usize| {
        let link = &figure.links()[i];
        let parent = link.parent().map_or("the world", |parent| figure.links()[parent].name());
        let at = link.joint().placement().translation.vector;
        let dofs = figure.layout().joints()[i];
        let dofs: Vec<String> = (0..dofs.nv)
            .map(|k| {
                let name = &figure.layout().v_names()[dofs.v + k];
                link.joint().kind().axes().get(k).map_or_else(
                    || name.clone(),
                    |dof| {
                        let e = dof.axis.direction;
                        format!("{name} ({:.2} {:.2} {:.2})", e.x, e.y, e.z)
                    },
                )
            })
            .collect();
        let (name, joint, dofs) = (link.name(), link.joint().name(), dofs.join(", "));
        format!("{name} on {parent} by {joint} at ({:.2} {:.2} {:.2}): {dofs}", at.x, at.y, at.z)
    };
    // No minus at zeros that are left of rounding.
    (0..figure.links().len()).map(line).collect::<Vec<_>>().join("\n").replace("-0.00", "0.00")
}

#[test]
fn fusing_nothing_changes_nothing() {
    let figure = person();
    let fused = figure.fuse(&[]).expect("nothing to refuse");
    assert_eq!(fused.figure().fingerprint(), figure.fingerprint());
    assert_eq!(fused.figure().links(), figure.links());
    assert_eq!(fused.figure().anatomical_angles(), figure.anatomical_angles());
    assert_eq!((fused.kept_q().len(), fused.full_nq(), fused.full_nv()), (66, 66, 66));
}

#[test]
fn frozen_arms_become_part_of_the_thorax() {
    let figure = person();
    let fused = frozen(&figure, &["clavicle", "shoulder", "elbow", "wrist"]);
    let small = fused.figure();
    assert_eq!((small.links().len(), small.layout().nv()), (13, 42));
    assert!((small.mass() - 73.0).abs() < 1e-12);
    let thorax = small.link("thorax").expect("a link");
    let names: Vec<&str> = thorax.frames().iter().map(|frame| frame.name.as_str()).collect();
    insta::assert_snapshot!(names.join(" "), @"left_clavicle left_upper_arm left_forearm left_hand right_clavicle right_upper_arm right_forearm right_hand right_hand.tip");
    // The arms hang down symmetrically.
    assert!(thorax.com().x.abs() < 1e-15 && thorax.com().y < figure.link("thorax").expect("a link").com().y);
    let hand = figure.link("left_hand").expect("a link").tip().expect("a tip");
    assert_eq!(thorax.tip().expect("the left hand's").z.to_bits(), {
        let place = fused.links()[figure.link_index("left_hand").expect("a link")].placement;
        (place.translation.vector + hand).z.to_bits()
    });
    // Angles of the legs are kept, those of the arms gone.
    assert!(small.anatomical_angle("left_shoulder.flexion").is_none());
    let knee = small.anatomical_angle("left_knee.flexion").expect("kept");
    assert_eq!(small.layout().v_names()[knee.dof], "left_knee.rx");
    assert_eq!((small.stature(), small.name()), (figure.stature(), figure.name()));
    for (k, &full) in fused.kept_v().iter().enumerate() {
        assert_eq!(small.layout().v_names()[k], figure.layout().v_names()[full]);
        assert_eq!(fused.dof(full), Some(k));
    }
}

/// Mass, centre of mass and inertia of two rods that become one.
#[test]
fn a_composite_of_two_rods_is_one_rod() {
    let rod = |length: f64, mass: f64| {
        Inertia::diagonal(mass * length * length / 12.0, 0.0, mass * length * length / 12.0)
    };
    let along = |x: f64| Vector3::new(0.0, x, 0.0);
    let figure = FigureBuilder::new("rods")
        .link(LinkSpec::root("a", Joint::new("a").rx()).mass(2.0).com(along(1.0)).inertia(rod(2.0, 2.0)))
        .link(
            LinkSpec::child("b", "a", Joint::new("b").at(along(2.0)).rx())
                .mass(1.0)
                .com(Vector3::new(0.0, 0.0, 0.5))
                .inertia(Inertia::diagonal(1.0 / 12.0, 1.0 / 12.0, 0.0)),
        )
        .build()
        .expect("a valid figure");
    let fused = figure.fuse_named(&[("b", -FRAC_PI_2)]).expect("a dof");
    let whole = &fused.figure().links()[0];
    assert_eq!(fused.figure().links().len(), 1);
    assert!((whole.mass() - 3.0).abs() < 1e-15);
    assert!((whole.com() - along(1.5)).amax() < 1e-15);
    // 3 kg over 3 m: m·l²/12.
    let expected = Vector3::new(2.25, 0.0, 2.25);
    assert!((whole.inertia().diagonal() - expected).amax() < 1e-14, "{}", whole.inertia());
}

#[test]
fn a_turn_between_others_turns_their_axes_and_leaves_the_frame() {
    let figure = hinged(Joint::new("knee").rz().ry().rx());
    let fused = figure.fuse_named(&[("knee.ry", FRAC_PI_2)]).expect("a dof");
    insta::assert_snapshot!(structure(fused.figure()), @r"
    thigh on the world by hip at (0.00 0.00 0.00): hip.rz (0.00 0.00 1.00), hip.rx (1.00 0.00 0.00)
    shank on thigh by knee at (0.00 -0.40 0.00): knee.rz (-1.00 0.00 0.00), knee.rx (1.00 0.00 0.00)
    ");
    // What a quarter turn leaves of a coordinate axis is one, to the last digit.
    let axis = fused.figure().links()[1].joint().kind().axes()[0].axis.direction;
    assert_eq!(axis, -Vector3::x());
    assert_eq!(fused.links()[1].placement, Isometry3::identity());
    assert_eq!(fused.figure().links()[1].com(), figure.links()[1].com());
}

#[test]
fn a_slide_between_turns_splits_the_joint() {
    let figure = hinged(Joint::new("knee").rz().tx().rx());
    let fused = figure.fuse_named(&[("knee.tx", 0.03)]).expect("a dof");
    insta::assert_snapshot!(structure(fused.figure()), @r"
    thigh on the world by hip at (0.00 0.00 0.00): hip.rz (0.00 0.00 1.00), hip.rx (1.00 0.00 0.00)
    shank~1 on thigh by knee~1 at (0.00 -0.40 0.00): knee.rz (0.00 0.00 1.00)
    shank on shank~1 by knee at (0.03 0.00 0.00): knee.rx (1.00 0.00 0.00)
    ");
    // At zero, or along the axis, nothing is displaced.
    for (dof, value) in [("knee.tx", 0.0), ("knee.rx", 0.4)] {
        assert_eq!(figure.fuse_named(&[(dof, value)]).expect("a dof").figure().links().len(), 2);
    }
    let along = hinged(Joint::new("knee").rx().tx().rx());
    let fused = along.fuse_named(&[("knee.tx", 0.03)]).expect("a dof");
    insta::assert_snapshot!(structure(fused.figure()), @r"
    thigh on the world by hip at (0.00 0.00 0.00): hip.rz (0.00 0.00 1.00), hip.rx (1.00 0.00 0.00)
    shank on thigh by knee at (0.03 -0.40 0.00): knee.rx (1.00 0.00 0.00), knee.rx2 (1.00 0.00 0.00)
    ");
}

#[test]
fn a_slide_after_the_last_turn_moves_the_links_origin() {
    let figure = hinged(Joint::new("knee").rz().tx().ty());
    let fused = figure.fuse_named(&[("knee.tx", 0.03)]).expect("a dof");
    insta::assert_snapshot!(structure(fused.figure()), @r"
    thigh on the world by hip at (0.00 0.00 0.00): hip.rz (0.00 0.00 1.00), hip.rx (1.00 0.00 0.00)
    shank on thigh by knee at (0.00 -0.40 0.00): knee.rz (0.00 0.00 1.00), knee.ty (0.00 1.00 0.00)
    ");
    let offset = Vector3::new(0.03, 0.0, 0.0);
    assert_eq!(fused.links()[1].placement, Isometry3::translation(0.03, 0.0, 0.0));
    let (before, after) = (&figure.links()[1], &fused.figure().links()[1]);
    assert_eq!(*after.com(), before.com() + offset);
    assert_eq!(after.tip().copied(), before.tip().map(|tip| tip + offset));
    let frames: Vec<_> =
        after.frames().iter().map(|frame| (frame.name.as_str(), frame.placement.translation.x)).collect();
    assert_eq!(frames, [("marker", 0.03), ("shank", 0.03)]);
}

#[test]
fn the_first_of_two_like_axes_leaves_the_second_its_name() {
    let figure = hinged(Joint::new("knee").rx().ry().rx().rz());
    let fused = figure.fuse_named(&[("knee.rx", 0.2)]).expect("a dof");
    assert_eq!(fused.figure().layout().v_names()[2..], ["knee.ry", "knee.rx2", "knee.rz"]);
    assert_eq!(fused.figure().layout().q_names()[2..], ["knee.ry", "knee.rx2", "knee.rz"]);
}

#[test]
fn ball_and_free_joints_are_fused_as_a_whole() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::ball("hip").at(Vector3::x())).mass(1.0).com(Vector3::y()))
        .link(LinkSpec::child("c", "b", Joint::new("knee").at(Vector3::y()).rx()).mass(1.0))
        .build()
        .expect("a valid figure");
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let mut q = vec![0.0; 12];
    // A quarter turn about z, of twice the length.
    q[7..11].copy_from_slice(&[0.0, 0.0, 2.0 * half, 2.0 * half]);
    q[3..7].copy_from_slice(&[0.0, 0.0, 0.0, 1.0]);
    q[..3].copy_from_slice(&[5.0, 6.0, 7.0]);
    let fused = figure.fuse_at(&[6, 7, 8], &q).expect("a whole joint");
    insta::assert_snapshot!(structure(fused.figure()), @r"
    a on the world by root at (0.00 0.00 0.00): root.vx, root.vy, root.vz, root.wx, root.wy, root.wz
    c on a by knee at (0.00 0.00 0.00): knee.rx (1.00 0.00 0.00)
    ");
    assert!((fused.figure().links()[0].com() - Vector3::new(0.0, 0.0, 0.0)).amax() < 1e-15);
    assert_eq!(
        fused.rest(),
        [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, half, half, 0.0].map(|x: f64| x + 0.0)
    );
    // A root that stands still is welded to the world.
    let fixed = figure.fuse_at(&[0, 1, 2, 3, 4, 5], &q).expect("a whole joint");
    let root = &fixed.figure().links()[0];
    assert_eq!(
        (root.joint().kind().nv(), root.joint().placement().translation.vector),
        (0, Vector3::new(5.0, 6.0, 7.0))
    );
    assert!(matches!(root.joint().kind(), JointKind::Axes(_)));
    assert_eq!(fixed.figure().layout().nq(), 5);
}

#[test]
fn soles_and_shapes_move_to_the_link_that_carries_them() {
    let figure = person();
    let fused = frozen(&figure, &["toes"]);
    let foot = fused.figure().link("left_foot").expect("a link");
    let parts: Vec<SolePart> = foot.sole().iter().map(|point| point.part).collect();
    assert_eq!(parts, [SolePart::Heel, SolePart::Ball, SolePart::ToeTip]);
    assert_eq!(foot.shape(), figure.link("left_foot").expect("a link").shape());
    assert!(
        (foot.tip().expect("the toes'") - foot.sole_point(SolePart::ToeTip).expect("a point")).amax() < 1e-15
    );
    let shape = Shape { kind: ShapeKind::Sphere { radius: 0.1 }, placement: Isometry3::identity() };
    let drawn = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::new("a").rx()).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::new("b").at(Vector3::y()).rx()).mass(1.0).shape(shape))
        .build()
        .expect("a valid figure");
    let fused = drawn.fuse(&[(1, 0.0)]).expect("a dof");
    assert_eq!(
        fused.figure().links()[0].shape().expect("b's").placement.translation.y.to_bits(),
        1.0_f64.to_bits()
    );
}

#[test]
fn names_that_are_taken_are_left_alone() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("b~1", Joint::new("b~2").rx()).mass(1.0).frame("b", Isometry3::identity()))
        .link(LinkSpec::child("b", "b~1", Joint::new("b").rx().ty().rx()).mass(1.0))
        .build()
        .expect("a valid figure");
    let fused = figure.fuse_named(&[("b.ty", 0.1)]).expect("a dof");
    let links: Vec<&str> = fused.figure().links().iter().map(Link::name).collect();
    let joints: Vec<&str> = fused.figure().links().iter().map(|link| link.joint().name()).collect();
    assert_eq!((links, joints), (vec!["b~1", "b~3", "b"], vec!["b~2", "b~3", "b"]));
    let fused = figure.fuse_named(&[("b.rx", 0.1), ("b.ty", 0.1), ("b.rx2", 0.0)]).expect("dofs");
    assert_eq!(fused.figure().links()[0].frames().len(), 1);
}

#[test]
fn states_are_mapped_both_ways() {
    let figure = hinged(Joint::new("knee").rz().tx().rx());
    let fused = figure.fuse_named(&[("knee.tx", 0.03)]).expect("a dof");
    let full = [1.0, 2.0, 3.0, 9.0, 5.0];
    let (mut small, mut back) = ([0.0; 4], [0.0; 5]);
    fused.q_to_small(&full, &mut small).expect("lengths");
    fused.q_to_full(&small, &mut back).expect("lengths");
    assert_eq!((small, back), ([1.0, 2.0, 3.0, 5.0], [1.0, 2.0, 3.0, 0.03, 5.0]));
    fused.v_to_small(&full, &mut small).expect("lengths");
    fused.v_to_full(&small, &mut back).expect("lengths");
    assert_eq!((small, back), ([1.0, 2.0, 3.0, 5.0], [1.0, 2.0, 3.0, 0.0, 5.0]));
    let error = |result: Result<(), FuseError>| result.expect_err("a wrong length").to_string();
    assert_eq!(error(fused.q_to_full(&full, &mut back)), "q has 5 entries, but 4 are needed");
    assert_eq!(error(fused.v_to_full(&[], &mut [])), "the full figure's v has 0 entries, but 5 are needed");
}

#[test]
fn what_cannot_be_fused_is_refused() {
    let figure = FigureBuilder::new("f")
        .link(LinkSpec::root("a", Joint::ball("hip")).mass(1.0))
        .link(
            LinkSpec::child(
                "b",
                "a",
                Joint::new("knee").rx().axis(Axis::rotation(Vector3::new(1.0, 1.0, 0.0))),
            )
            .mass(1.0),
        )
        .build()
        .expect("a valid figure");
    let q = [0.0, 0.0, 0.0, 1.0, 0.0, f64::NAN];
    let answers = [
        figure.fuse_named(&[("knee.ry", 0.0)]),
        figure.fuse_named(&[("tail", 0.0)]),
        figure.fuse(&[(5, 0.0)]),
        figure.fuse(&[(3, 0.0), (3, 0.1)]),
        figure.fuse(&[(3, f64::INFINITY)]),
        figure.fuse(&[(0, 0.0)]),
        figure.fuse_at(&[0, 1], &q),
        figure.fuse_at(&[0, 1, 2], &[0.0; 6]),
        figure.fuse_at(&[4], &q),
        figure.fuse_at(&[3, 3], &q),
        figure.fuse_at(&[3], &q[..5]),
        figure.fuse_at(&[7], &q),
    ]
    .map(|answer| answer.expect_err("not to be fused").to_string());
    insta::assert_snapshot!(answers.join("\n"), @r"
    dof 'knee.ry' cannot be fused: the figure has none of that name; did you mean 'knee.r'?
    dof 'tail' cannot be fused: the figure has none of that name
    dof 5 cannot be fused: the figure has 5, numbered from 0
    dof 'knee.rx' is to be fused twice; name it once
    coordinate 'knee.rx' cannot be fused at inf; give a finite number (rad or m)
    dof 'hip.wx' has no coordinate of its own: fuse its joint 'hip' as a whole, at a configuration (fuse_at)
    joint 'hip' can be fused only as a whole: name all of its 3 dofs, not 2
    joint 'hip' cannot be fused: its quaternion has the length 0, which is no rotation
    coordinate 'knee.r' cannot be fused at NaN; give a finite number (rad or m)
    dof 'knee.rx' is to be fused twice; name it once
    q has 5 entries, but 6 are needed
    dof 7 cannot be fused: the figure has 5, numbered from 0
    ");
}
