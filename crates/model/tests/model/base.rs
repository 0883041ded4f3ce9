//! A figure on another base: what is added, what stays, what is refused.

use solaris_model::{
    Base, BaseError, Curve, Figure, FigureBuilder, Joint, JointKind, LinkSpec, Placement, Vector3, human,
};

fn leg(root: Joint) -> Figure {
    FigureBuilder::new("leg")
        .link(LinkSpec::root("thigh", root.at(Vector3::new(0.1, 0.2, 0.3))).mass(7.0))
        .link(
            LinkSpec::child(
                "shank",
                "thigh",
                Joint::new("knee").rx().ty().following("knee.rx", Curve::linear(0.1, 0.2)),
            )
            .mass(3.0)
            .frame("marker", Placement::translation(0.0, 0.1, 0.0)),
        )
        .angle("knee.flexion", "knee.rx", true)
        .stature(1.8)
        .build()
        .expect("a valid figure")
}

fn refused(figure: &Figure, base: Base) -> String {
    figure.on_base(base).expect_err("no such base").to_string()
}

#[test]
fn a_welded_root_gets_six_coordinates_or_seven() {
    let fixed = leg(Joint::new("ground"));
    let floating = fixed.on_base(Base::Floating).expect("welded");
    let free = fixed.on_base(Base::Free).expect("welded");
    insta::assert_snapshot!(floating.layout().q_names().join(" "), @"root.tx root.ty root.tz root.rz root.ry root.rx knee.rx knee.ty");
    insta::assert_snapshot!(free.layout().q_names().join(" "), @"root.px root.py root.pz root.qx root.qy root.qz root.qw knee.rx knee.ty");
    assert!(matches!(free.links()[0].joint().kind(), JointKind::Free { .. }));
    for (figure, shift) in [(&floating, 0), (&free, 1)] {
        assert_eq!(figure.links()[0].joint().placement(), fixed.links()[0].joint().placement());
        assert_eq!(figure.links()[1], fixed.links()[1]);
        assert_eq!((figure.name(), figure.stature(), figure.mass()), ("leg", Some(1.8), 10.0));
        let angle = figure.anatomical_angle("knee.flexion").expect("kept");
        assert_eq!((angle.dof, angle.coordinate, angle.sign), (6, 6 + shift, -1.0));
        let follower = &figure.followers()[0];
        assert_eq!(
            [follower.dof, follower.coordinate, follower.leader, follower.leader_coordinate],
            [7, 7 + shift, 6, 6 + shift]
        );
        assert_ne!(figure.fingerprint(), fixed.fingerprint());
    }
}

#[test]
fn a_base_that_is_there_stays() {
    let fixed = leg(Joint::new("ground"));
    assert_eq!(fixed.on_base(Base::Fixed).expect("itself").fingerprint(), fixed.fingerprint());
    let person = human(1.75, 73.0).expect("in range");
    for base in [Base::Fixed, Base::Floating] {
        let same = person.on_base(base).expect("its own");
        assert_eq!(same.fingerprint(), person.fingerprint());
    }
    let free = leg(Joint::free("pelvis"));
    assert_eq!(free.on_base(Base::Free).expect("its own").fingerprint(), free.fingerprint());
    let twice = fixed.on_base(Base::Floating).and_then(|floating| floating.on_base(Base::Floating));
    assert_eq!(twice.expect("the same again").layout().nv(), 8);
}

#[test]
fn what_moves_otherwise_or_has_the_name_is_refused() {
    let massless = FigureBuilder::new("frame").link(LinkSpec::root("a", Joint::new("weld"))).build();
    let with = |joint: Joint| {
        FigureBuilder::new("f")
            .link(LinkSpec::root("a", Joint::new("weld")).mass(1.0))
            .link(LinkSpec::child("b", "a", joint).mass(1.0))
            .build()
            .expect("valid")
    };
    let answers = [
        refused(&leg(Joint::new("hip").rx()), Base::Floating),
        refused(&leg(Joint::free("pelvis")), Base::Floating),
        refused(&human(1.75, 73.0).expect("in range"), Base::Free),
        refused(&massless.expect("welded"), Base::Free),
        refused(&with(Joint::new("root").rx()), Base::Free),
        refused(&with(Joint::new("root").rx()), Base::Floating),
        refused(&with(Joint::new("j").rx().named("root.tz")), Base::Floating),
        refused(&with(Joint::new("root.ty").rx()), Base::Floating),
    ];
    insta::assert_snapshot!(answers.join("\n"));
    // What is another's name on one base is none on the other.
    assert!(with(Joint::new("root.ty").rx()).on_base(Base::Free).is_ok());
    let taken = with(Joint::new("root")).on_base(Base::Free).expect_err("two joints of one name");
    assert!(matches!(taken, BaseError::Taken { kind: "joint", .. }));
}

#[test]
fn a_root_without_mass_may_float_with_what_it_carries() {
    let world = FigureBuilder::new("robot")
        .link(LinkSpec::root("world", Joint::new("weld")))
        .link(LinkSpec::child("a", "world", Joint::new("j").rx()).mass(1.0))
        .link(LinkSpec::child("b", "world", Joint::new("k").rx()).mass(2.0))
        .build()
        .expect("valid");
    assert_eq!(world.on_base(Base::Free).expect("mass enough").layout().nv(), 8);
}
