//! The table of a figure's constants.

use crate::denavit_hartenberg::figures::branching_arm;
use solaris_dynamics::denavit_hartenberg::Summary;
use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3, human};

#[test]
fn a_branching_arm() {
    insta::assert_snapshot!(Summary::of(&branching_arm()).expect("known joints"));
}

#[test]
fn the_page_holds_the_summary_of_the_arm() {
    let page = include_str!("../../../../../docs/dynamics.md");
    let (_, rest) =
        page.split_once("compared by the test denavit_hartenberg -->\n```text\n").expect("a summary");
    let (found, _) = rest.split_once("```\n<!-- end of table -->").expect("its end");
    let printed = Summary::of(&branching_arm()).expect("known joints").to_string();
    assert!(found == printed, "docs/dynamics.md should say\n\n{printed}\n");
}

#[test]
fn the_human_of_66_dofs() {
    insta::assert_snapshot!(Summary::of(&human(1.75, 73.0).expect("within range")).expect("known joints"));
}

#[test]
fn a_free_body_with_a_ball_and_a_weld() {
    let figure = FigureBuilder::new("satellite")
        .link(LinkSpec::root("hub", Joint::free("root")).mass(5.0))
        .link(LinkSpec::child("dish", "hub", Joint::ball("gimbal").at(Vector3::new(0.0, 0.5, 0.0))).mass(1.0))
        .link(LinkSpec::child("antenna", "dish", Joint::new("clamp").at(Vector3::z())).mass(0.1))
        .link(LinkSpec::child("panel", "hub", Joint::new("hinge").at(Vector3::x()).rx()).mass(1.0))
        .build()
        .expect("valid");
    insta::assert_snapshot!(Summary::of(&figure).expect("known joints"));
}

#[test]
fn joints_that_are_apart_by_nearly_nothing_have_constants() {
    for apart in [-1e-300, 5e-324, 1e-200, 1e-160] {
        for place in
            [Vector3::new(0.0, 0.0, apart), Vector3::new(apart, 0.0, 0.0), Vector3::new(0.0, apart, -apart)]
        {
            let figure = FigureBuilder::new("f")
                .link(LinkSpec::root("a", Joint::new("i").at(place).rx().rz()).mass(1.0))
                .link(LinkSpec::child("b", "a", Joint::new("j").at(place).rz().rx()).mass(1.0))
                .link(LinkSpec::child("c", "b", Joint::free("k").at(place)).mass(1.0))
                .build()
                .expect("valid");
            let said = Summary::of(&figure).expect("known joints").to_string();
            assert!(!said.contains("NaN") && !said.contains("inf"), "{place}: {said}");
        }
    }
}
