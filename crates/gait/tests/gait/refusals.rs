//! What no walk can be made of is refused by name.

use solaris_analysis::{ReactionError, ground_reactions};
use solaris_gait::{
    Extent, FEET, GaitError, LegGeometry, RequestError, Resolution, StridePlan, Style, WALK_RATIO,
    WalkRequest, walk,
};
use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec, human};

fn refused(request: &WalkRequest) -> String {
    walk(&human(1.75, 73.0).expect("a person"), request).err().expect("a refusal").to_string()
}

#[test]
fn out_of_range_values_are_named_with_their_range() {
    let default = WalkRequest::default();
    let answers = [
        refused(&WalkRequest { step_frequency: Some(500.0), ..default.clone() }),
        refused(&WalkRequest { step_frequency: Some(f64::NAN), ..default.clone() }),
        refused(&WalkRequest { step_frequency: Some(110.0), step_length: Some(1.35), ..default.clone() }),
        refused(&WalkRequest { step_frequency: Some(110.0), speed: Some(2.5), ..default.clone() }),
        refused(&WalkRequest { extent: Extent::Steps(0), ..default.clone() }),
        refused(&WalkRequest { extent: Extent::Steps(10_001), ..default.clone() }),
        refused(&WalkRequest { extent: Extent::Distance(0.05), ..default.clone() }),
        refused(&WalkRequest { parameters: vec![("heel-strike-angle", 40.0)], ..default.clone() }),
        refused(&WalkRequest { parameters: vec![("heel-angle", 20.0)], ..default.clone() }),
        refused(&WalkRequest {
            resolution: Resolution { nodes: 99, ..Resolution::default() },
            ..default.clone()
        }),
        refused(&WalkRequest {
            resolution: Resolution { walk_passes: 3, ..Resolution::default() },
            ..default
        }),
    ];
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn a_style_without_a_number_is_refused_by_name() {
    let figure = human(1.75, 73.0).expect("a person");
    let leg = LegGeometry::of(&figure).expect("legs");
    let mut style = Style::of(&leg, 1.75, 110.0, WALK_RATIO * 1.75 * 110.0);
    style.knee_push = f64::NAN;
    let error = StridePlan::new(&figure, &style, Resolution::default()).err();
    assert!(matches!(
        error,
        Some(GaitError::Request(RequestError::StyleNotFinite { name: "knee_push", .. }))
    ));
}

#[test]
fn a_plan_moves_its_own_figure_only() {
    let figure = human(1.75, 73.0).expect("a person");
    let plan =
        walk(&figure, &WalkRequest { extent: Extent::Steps(1), ..WalkRequest::default() }).expect("a step");
    let other = human(1.2, 30.0).expect("a child");
    assert!(matches!(plan.motion(&other, 120.0), Err(ReactionError::Motion(_))));
    let mut motion = plan.motion(&figure, 120.0).expect("its own figure");
    let twice = ground_reactions(&figure, &mut motion, [FEET[0]; 2], &plan);
    assert!(matches!(twice, Err(ReactionError::OneFootTwice { .. })));
    let nobody = ground_reactions(&figure, &mut motion, ["left_foot", "tail"], &plan);
    assert!(matches!(nobody, Err(ReactionError::MissingLink { .. })));
}

#[test]
fn a_figure_that_is_no_person_is_refused() {
    let pendulum = FigureBuilder::new("pendulum")
        .link(LinkSpec::root("bob", Joint::new("pivot").rx()).mass(1.0))
        .build()
        .expect("a figure");
    let error = walk(&pendulum, &WalkRequest::default()).err().expect("a refusal");
    let text = error.to_string();
    assert!(text.starts_with("figure 'pendulum' has no link 'pelvis', 'abdomen', 'thorax',"), "{text}");
    assert!(
        text.ends_with("'right_foot', 'right_toes'; the walker needs the links of the human figure"),
        "{text}"
    );
}

#[test]
fn all_that_a_figure_lacks_is_said_at_once() {
    let ann = solaris_model::human(1.75, 73.0).expect("within range");
    assert_eq!(solaris_gait::missing_for_walking(&ann), []);
    // The same links, but without soles, without angles, without arms, and with one knee a hinge.
    let mut builder = FigureBuilder::new("robot");
    for link in
        ann.links().iter().filter(|link| !link.name().contains("arm") && !link.name().contains("hand"))
    {
        let joint = link.joint().clone();
        let joint = if joint.name() == "left_knee" {
            Joint::new("left_knee").placed(*joint.placement()).rx()
        } else {
            joint
        };
        let spec = match link.parent() {
            Some(parent) => LinkSpec::child(link.name(), ann.links()[parent].name(), joint),
            None => LinkSpec::root(link.name(), joint),
        };
        builder =
            builder.link(spec.mass(link.mass()).com(*link.com()).inertia(Inertia::Tensor(*link.inertia())));
    }
    let robot = builder.build().expect("a figure");
    let error = walk(&robot, &WalkRequest::default()).err().expect("a refusal");
    insta::assert_snapshot!(error);
    // To measure its walk, angles are needed as well.
    let all: Vec<String> =
        solaris_gait::missing_for_walking(&robot).iter().map(ToString::to_string).collect();
    assert!(all.contains(&"the figure has no anatomical angle 'left_hip.flexion'".to_owned()), "{all:?}");
}
