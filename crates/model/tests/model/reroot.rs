//! Re-rooting: what the view is made of, what it is called, and what is refused.

use solaris_model::{
    Figure, FigureBuilder, Isometry3, Joint, JointInView, JointKind, LinkSpec, RootAt, SolePart, Vector3,
    human,
};

fn person() -> Figure {
    human(1.75, 73.0).expect("in range")
}

fn down(x: f64) -> Vector3<f64> {
    Vector3::new(0.0, -x, 0.0)
}

/// Trunk, thigh and shank, with a tail.
fn leg() -> Figure {
    FigureBuilder::new("leg")
        .link(
            LinkSpec::root("trunk", Joint::new("root").tx().ty().tz().rz().ry().rx())
                .mass(30.0)
                .com(down(-0.3)),
        )
        .link(LinkSpec::child("thigh", "trunk", Joint::ball("hip").at(down(0.1))).mass(7.0).com(down(0.2)))
        .link(
            LinkSpec::child("shank", "thigh", Joint::new("knee").at(down(0.4)).rx().ry().limited(-0.5, 0.5))
                .mass(3.0)
                .com(down(0.2))
                .tip(down(0.45)),
        )
        .link(
            LinkSpec::child("tail", "trunk", Joint::new("tail").at(Vector3::z()).rx())
                .mass(1.0)
                .com(Vector3::z()),
        )
        .angle("flexion", "knee.rx", true)
        .angle("tilt", "root.rx", false)
        .build()
        .expect("a valid figure")
}

#[test]
fn the_path_is_turned_round() {
    let figure = leg();
    let view = figure.reroot_named("shank", RootAt::Tip).expect("massive links");
    let seen = view.figure();
    let names = |i: usize| (seen.links()[i].name(), seen.links()[i].joint().name(), seen.links()[i].parent());
    assert_eq!(names(0), ("shank", "world~shank", None));
    assert_eq!(names(1), ("thigh", "knee", Some(0)));
    assert_eq!(names(2), ("trunk", "hip", Some(1)));
    assert_eq!(names(3), ("tail", "tail", Some(2)));
    assert_eq!(view.path(), [2, 1, 0]);
    let joints =
        view.joints().iter().map(|joint| joint.map(|JointInView { link, reversed }| (link, reversed)));
    assert_eq!(joints.collect::<Vec<_>>(), [None, Some((2, true)), Some((1, true)), Some((3, false))]);
    assert!(matches!(seen.links()[0].joint().kind(), JointKind::Free { .. }));
    insta::assert_snapshot!(seen.layout().v_names().join(" "), @"world~shank.vx world~shank.vy world~shank.vz world~shank.wx world~shank.wy world~shank.wz knee.ry knee.rx hip.wx hip.wy hip.wz tail.rx");
    // The knee's axes are opposite, and keep their limits.
    let knee = seen.links()[1].joint().kind().axes();
    assert_eq!((knee[0].axis.direction, knee[1].axis.direction), (-Vector3::y(), -Vector3::x()));
    assert!(knee[0].limits.is_some() && knee[1].limits.is_none());
    // The thigh's frame is now at the knee, the trunk's at the hip.
    assert_eq!(*seen.links()[1].com(), down(-0.2));
    assert!((seen.links()[2].com() - down(-0.4)).amax() < 1e-15);
    assert_eq!(seen.links()[1].joint().placement().translation.vector, down(-0.45));
    assert_eq!(seen.links()[2].joint().placement().translation.vector, down(-0.4));
    // Its own frame stays, by name.
    assert_eq!(seen.links()[1].frames()[0].name, "thigh");
    assert_eq!(seen.links()[1].frames()[0].placement, Isometry3::translation(0.0, 0.4, 0.0));
    assert_eq!(view.links()[1].placement, Isometry3::translation(0.0, 0.4, 0.0));
    assert_eq!(*seen.links()[0].tip().expect("kept"), Vector3::zeros());
    // Angles stay with their joints; those of the old root are gone.
    let flexion = seen.anatomical_angle("flexion").expect("kept");
    assert_eq!((flexion.dof, flexion.coordinate), (7, 8));
    assert!(seen.anatomical_angle("tilt").is_none());
    assert!((seen.mass() - figure.mass()).abs() < 1e-12);
}

#[test]
fn a_human_can_stand_on_any_link_or_point() {
    let figure = person();
    for link in 0..21 {
        let view = figure.reroot(link, RootAt::Joint).expect("massive links");
        let seen = view.figure();
        assert_eq!((seen.links().len(), seen.layout().nv(), seen.layout().nq()), (21, 66, 67));
        assert!(
            seen.links().iter().enumerate().all(|(i, link)| link.parent().is_none_or(|parent| parent < i))
        );
        assert_eq!(view.links()[link].link, 0);
        for name in &figure.layout().v_names()[6..] {
            assert!(seen.layout().dof_index(name).is_some(), "{name}");
        }
        for (i, place) in view.links().iter().enumerate() {
            assert_eq!(seen.links()[place.link].name(), figure.links()[i].name());
        }
    }
    let ball = *figure.link("left_foot").expect("a link").sole_point(SolePart::Ball).expect("a point");
    let view = figure.reroot_named("left_foot", RootAt::Point(ball)).expect("massive links");
    let foot = &view.figure().links()[0];
    assert_eq!(*foot.sole_point(SolePart::Ball).expect("kept"), Vector3::zeros());
    assert_eq!(foot.joint().name(), "world~left_foot");
}

#[test]
fn the_old_root_again_only_gets_a_free_joint() {
    let figure = leg();
    let view = figure.reroot(0, RootAt::Joint).expect("massive links");
    assert_eq!(view.figure().layout().v_names()[6..], figure.layout().v_names()[6..]);
    assert_eq!(view.figure().links()[1..], figure.links()[1..]);
}

#[test]
fn what_cannot_be_the_root_is_refused() {
    let figure = leg();
    let hollow = FigureBuilder::new("hollow")
        .link(LinkSpec::root("a", Joint::new("slide").tx()))
        .link(LinkSpec::child("b", "a", Joint::new("turn").rx()).mass(1.0))
        .build()
        .expect("a valid figure");
    let geared = FigureBuilder::new("geared")
        .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::free("float").armature(0.1)).mass(1.0))
        .build()
        .expect("a valid figure");
    let answers = [
        figure.reroot_named("shnk", RootAt::Joint),
        figure.reroot_named("wing", RootAt::Joint),
        figure.reroot(4, RootAt::Joint),
        figure.reroot(1, RootAt::Tip),
        figure.reroot(1, RootAt::Point(Vector3::new(0.0, f64::NAN, 0.0))),
        hollow.reroot(1, RootAt::Joint),
        geared.reroot(1, RootAt::Joint),
    ]
    .map(|answer| answer.expect_err("not a root").to_string());
    insta::assert_snapshot!(answers.join("\n"), @r"
    link 'shnk' cannot be the root: the figure has none of that name; did you mean 'shank'?
    link 'wing' cannot be the root: the figure has none of that name
    link 4 cannot be the root: the figure's links are 0 to 3
    link 'thigh' has no tip to be the root by; take its joint or one of its points
    link 'thigh' cannot be the root by a point at NaN m; give finite numbers
    joint 'turn' would move links without mass if 'b' were the root, so no force could be found for it; give the links on its other side mass
    free joint 'float' between 'b' and the old root has armature, which is that of one direction; only a joint without can be turned round
    ");
}
