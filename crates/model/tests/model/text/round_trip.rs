//! Written and read back, a figure is the same to the last bit.

use crate::text::random;
use proptest::prelude::*;
use solaris_model::text::{read, write};
use solaris_model::{
    Figure, FigureBuilder, Human, Joint, LinkSpec, Placement, RootAt, UnitQuaternion, Vector3, human,
};

/// All that a figure holds, in digits that tell any two numbers apart (and −0 from 0).
fn bits(figure: &Figure) -> String {
    let angles = figure.anatomical_angles();
    format!(
        "{:?} {:?} {:#?} {angles:#?} {:?} {:?}",
        figure.name(),
        figure.stature(),
        figure.links(),
        figure.followers(),
        figure.layout().v_names()
    )
}

fn check(figure: &Figure) {
    let text = write(figure);
    let back = read(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let (before, after) = (bits(figure), bits(&back));
    if let Some((a, b)) = before.lines().zip(after.lines()).find(|(a, b)| a != b) {
        panic!("{a}\nhas become\n{b}\nin\n{text}");
    }
    assert_eq!(before, after);
    assert_eq!(back.fingerprint(), figure.fingerprint());
    assert!(back == *figure, "equal digits are equal figures");
    assert_eq!(write(&back), text);
}

#[test]
fn humans_of_many_sizes_come_back() {
    for (height, mass) in [(1.75, 73.0), (1.741, 73.0), (0.8, 12.3), (2.3, 150.0), (1.633_333_3, 58.1)] {
        check(&human(height, mass).expect("a human"));
        let long = Human::new(height, mass)
            .segment_length("thigh", 0.25 * height)
            .segment_length("left_hand", 0.05 * height);
        check(&long.build().expect("a human"));
    }
}

/// Found by the fuzzer: names that begin with a space, in angles with a sign and without one.
#[test]
fn people_with_any_names_come_back() {
    let ann = human(1.65, 58.0).expect("a human");
    let at = Placement::identity();
    for name in ["\ta", " a", "a b", "-a", "+a"] {
        check(&Figure::together(&[(name, &ann, at), ("b", &ann, at)]).expect("two people"));
    }
}

#[test]
fn fused_and_rerooted_humans_come_back() {
    let ann = human(1.65, 58.0).expect("a human");
    let some: Vec<(usize, f64)> =
        (6..ann.layout().nv()).step_by(3).map(|dof| (dof, 0.1 * dof as f64)).collect();
    check(ann.fuse(&some).expect("it can be fused").figure());
    let all: Vec<(usize, f64)> = (6..ann.layout().nv() - 1).map(|dof| (dof, 0.3)).collect();
    check(ann.fuse(&all).expect("it can be fused").figure());
    for link in ["left_foot", "head", "right_toes", "thorax"] {
        let at = ann.link_index(link).expect("a link");
        check(ann.reroot(at, RootAt::Joint).expect("it can be rerooted").figure());
    }
}

#[test]
fn a_human_is_a_text_that_people_can_read() {
    let text = write(&human(1.75, 73.0).expect("a human"));
    let widest = text.lines().map(|line| line.chars().count()).max();
    assert!(widest <= Some(130), "{widest:?}");
    let foot = text.find("name: \"left_foot\"").expect("a foot");
    insta::assert_snapshot!(format!("{}\n…\n{}", &text[..1500], &text[foot..foot + 900]));
}

/// Lengths that a second normalisation would change.
#[test]
fn rotations_keep_their_last_bits() {
    let mut moved = 0;
    for k in 0..200 {
        let k = f64::from(k);
        let turn = UnitQuaternion::new(Vector3::new(0.1 * k, 1.0 - 0.03 * k, 0.7))
            * UnitQuaternion::new(Vector3::new(k, 1.0, 0.2));
        let joint = Joint::new("j").placed(Placement::from_parts(Vector3::zeros().into(), turn)).rx();
        let figure =
            FigureBuilder::new("f").link(LinkSpec::root("a", joint).mass(1.0)).build().expect("a figure");
        let mut again = figure.links()[0].joint().placement().rotation;
        again.renormalize();
        moved += usize::from(again.coords != figure.links()[0].joint().placement().rotation.coords);
        check(&figure);
    }
    assert!(moved > 0, "no rotation here tests anything");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn random_figures_come_back(seed in any::<u64>()) {
        check(&random::figure(seed));
    }

    #[test]
    fn random_figures_on_another_root_come_back(seed in any::<u64>(), link in 0_usize..12) {
        let figure = random::figure(seed);
        // Followers of the root's joint have no leader on another root.
        if figure.followers().is_empty()
            && let Ok(view) = figure.reroot(link % figure.links().len(), RootAt::Joint)
        {
            check(view.figure());
        }
    }

    #[test]
    fn random_figures_with_fused_joints_come_back(seed in any::<u64>(), step in 1_usize..5) {
        let figure = random::figure(seed);
        let still: Vec<(usize, f64)> = (2..figure.layout().nv())
            .step_by(step)
            .filter(|dof| figure.layout().coordinate(*dof).is_some() && !figure.follows(*dof))
            .map(|dof| (dof, 0.37 * dof as f64 - 1.0))
            .collect();
        if let Ok(fused) = figure.fuse(&still) {
            check(fused.figure());
        }
    }

    #[test]
    fn what_is_written_is_ron(seed in any::<u64>()) {
        let text = write(&random::figure(seed));
        let value = ron::from_str::<ron::Value>(&text);
        prop_assert!(value.is_ok(), "{:?}\n{text}", value.err());
    }
}
