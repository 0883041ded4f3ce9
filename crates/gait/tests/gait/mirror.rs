//! A walk that begins with the left foot is the mirror image of one that begins with the right.

use solaris_analysis::ground_reactions;
use solaris_gait::{Extent, FEET, WalkRequest, measure, walk};
use solaris_model::{EventKind, human};

#[test]
fn left_first_is_the_mirror_image_with_its_forces() {
    let figure = human(1.75, 73.0).expect("a person");
    let walked = [false, true].map(|left_first| {
        let request = WalkRequest { left_first, extent: Extent::Steps(3), ..WalkRequest::default() };
        let plan = walk(&figure, &request).expect("it can be walked");
        let mut motion = plan.motion(&figure, 120.0).expect("sampled");
        let report = ground_reactions(&figure, &mut motion, FEET, &plan).expect("forces");
        assert!(report.from_prescribed.expect("prescribed").value < 60.0);
        (plan, motion)
    });
    let [(right_plan, right), (left_plan, left)] = &walked;
    let first = |motion: &solaris_model::Motion| match &motion.events[0].kind {
        EventKind::LiftOff { link } => link.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!((first(right).as_str(), first(left).as_str()), ("right_foot", "left_foot"));
    for frame in 0..right.len() {
        for (side, other) in [(0, 1), (1, 0)] {
            let a = right.contact(FEET[side]).expect("a foot").samples[frame];
            let b = left.contact(FEET[other]).expect("a foot").samples[frame];
            let off = [a.force.x + b.force.x, a.force.y - b.force.y, a.force.z - b.force.z];
            assert!(off.iter().all(|off| off.abs() < 1e-6), "{frame}: {off:?}");
            assert!((a.cop.x + b.cop.x).abs() < 1e-9 && (a.cop.z - b.cop.z).abs() < 1e-9);
        }
        // The knees change sides.
        let knee = |motion: &solaris_model::Motion, side: &str| {
            let link = figure.link_index(&format!("{side}_shank")).expect("a shank");
            motion.q(frame)[figure.layout().joints()[link].q + 2]
        };
        assert!((knee(right, "left") - knee(left, "right")).abs() < 1e-12);
        assert!((right.q(frame)[0] + left.q(frame)[0]).abs() < 1e-12);
    }
    let [a, b] = [(right_plan, right), (left_plan, left)].map(|(plan, motion)| {
        let node = plan.nodes().1.0 + 90;
        (measure(&figure, motion).expect("measured"), plan.forces(node), plan.momentum_rate(node))
    });
    assert!(
        (a.0.extremes.friction.value - b.0.extremes.friction.value).abs() < 1e-9
            && b.0.extremes.slide.value < 1e-6
    );
    assert!(
        (a.1[0].moment.x - b.1[1].moment.x).abs() < 1e-9 && (a.1[0].moment.y + b.1[1].moment.y).abs() < 1e-9
    );
    assert!((a.2.x - b.2.x).abs() < 1e-12 && (a.2.y + b.2.y).abs() < 1e-12);
}
