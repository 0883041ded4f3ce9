//! Scaling to a subject: lengths, masses to the last bit, and what is refused.

use super::poses::places;
use proptest::prelude::*;
use solaris_model::{
    Curve, Figure, FigureBuilder, Inertia, Joint, Limits, LinkSpec, Passive, Placement, ScaleError, Scaling,
    Shape, ShapeKind, SolePart, Vector3, human,
};

fn person() -> Figure {
    human(1.75, 73.0).expect("in range")
}

fn to(height: Option<f64>, mass: Option<f64>, segments: &[(&str, f64)]) -> Scaling {
    let segments = segments.iter().map(|(name, length)| ((*name).to_owned(), *length)).collect();
    Scaling { height, mass, segments }
}

fn scaled(figure: &Figure, scaling: &Scaling) -> Figure {
    figure.scaled(scaling).expect("in range")
}

/// A slide with everything that a slide can have, a knee whose centre moves, and a turn that follows a slide.
fn machine() -> Figure {
    let spring = Passive { stiffness: 5.0, rest: 0.2, damping: 1.0, friction: 0.5 };
    let bent = Curve::Cubics {
        knots: vec![-1.0, 0.0, 2.0],
        pieces: vec![[0.5, -0.2, 0.3, 0.4], [1.0, 1.6, 1.5, -0.2]],
    };
    let shape = Shape {
        kind: ShapeKind::Capsule { radius: 0.1, length: 0.4 },
        placement: Placement::translation(0.0, 0.2, 0.0),
    };
    FigureBuilder::new("machine")
        .link(
            LinkSpec::root(
                "bed",
                Joint::new("rail").at(Vector3::new(0.3, 0.0, 0.0)).tx().limited(-1.0, 2.0).passive(spring),
            )
            .mass(10.0)
            .inertia(Inertia::diagonal(1.0, 1.0, 1.5)),
        )
        .link(
            LinkSpec::child(
                "sledge",
                "bed",
                Joint::new("guide")
                    .at(Vector3::new(0.0, 0.5, 0.0))
                    .tz()
                    .limited(-0.1, 0.3)
                    .passive(spring)
                    .armature(0.7),
            )
            .mass(2.0)
            .com(Vector3::new(0.0, 0.1, 0.02))
            .shape(shape)
            .inertia(Inertia::diagonal(0.1, 0.2, 0.1))
            .frame("marker", Placement::translation(0.1, 0.1, 0.0)),
        )
        .link(
            LinkSpec::child(
                "rod",
                "sledge",
                Joint::new("knee")
                    .at(Vector3::new(0.0, 0.0, 0.4))
                    .rx()
                    .limited(-1.0, 1.0)
                    .ty()
                    .following("knee.rx", bent.clone())
                    .rz()
                    .following("guide.tz", bent)
                    .ry()
                    .following("guide.tz", Curve::Polynomial(vec![0.1, 2.0, -3.0])),
            )
            .mass(1.0)
            .tip(Vector3::new(0.0, 0.0, 0.7))
            .sole(SolePart::Heel, Vector3::new(0.0, 0.0, 0.6)),
        )
        .stature(2.0)
        .build()
        .expect("a valid figure")
}

#[test]
fn scaling_by_one_changes_no_bit() {
    for figure in [person(), machine()] {
        let lengths: Vec<(String, f64)> = figure
            .links()
            .iter()
            .filter_map(|link| Some((link.name().to_owned(), figure.segment_length(link.name())?)))
            .collect();
        let one = Scaling { height: figure.stature(), mass: Some(figure.mass()), segments: lengths };
        for scaling in [Scaling::default(), one] {
            let same = scaled(&figure, &scaling);
            assert_eq!(same.links(), figure.links());
            assert_eq!((same.fingerprint(), same.stature()), (figure.fingerprint(), figure.stature()));
            assert_eq!(same.anatomical_angles(), figure.anatomical_angles());
        }
    }
}

#[test]
fn the_mass_is_the_one_asked_for_to_the_last_bit() {
    let (figure, machine) = (person(), machine());
    for i in 0..5000_u32 {
        let mass = 30.0 + f64::from(i) * 0.017_3;
        assert_eq!(scaled(&figure, &to(None, Some(mass), &[])).mass().to_bits(), mass.to_bits(), "{mass} kg");
        assert_eq!(
            scaled(&machine, &to(None, Some(mass), &[])).mass().to_bits(),
            mass.to_bits(),
            "{mass} kg"
        );
        let ann = human(1.75, mass).expect("in range");
        assert_eq!(ann.mass().to_bits(), mass.to_bits(), "{mass} kg");
    }
    assert_eq!(human(1.75, 79.0).expect("in range").mass().to_bits(), 79.0_f64.to_bits());
    // Each keeps its share.
    let heavy = scaled(&figure, &to(None, Some(146.0), &[]));
    for (a, b) in figure.links().iter().zip(heavy.links()) {
        assert!((b.mass() / a.mass() - 2.0).abs() < 1e-14, "{}", a.name());
        assert!((b.inertia() - 2.0 * a.inertia()).amax() <= 1e-14 * a.inertia().amax());
        assert_eq!((a.com(), a.joint(), a.shape()), (b.com(), b.joint(), b.shape()));
    }
}

#[test]
fn segments_have_the_lengths_asked_for_and_the_others_those_of_the_height() {
    let figure = person();
    let scaling = to(
        Some(1.6),
        Some(60.0),
        &[("thigh", 0.45), ("left_shank", 0.39), ("head", 0.25), ("left_thigh", 0.44)],
    );
    let ann = scaled(&figure, &scaling);
    let length = |name: &str| ann.segment_length(name).expect("a length");
    for (name, asked) in [("right_thigh", 0.45), ("left_thigh", 0.44), ("left_shank", 0.39), ("head", 0.25)] {
        assert!((length(name) - asked).abs() < 1e-15, "{name}: {} m", length(name));
    }
    let shank = figure.segment_length("right_shank").expect("a length");
    assert!((length("right_shank") - shank * 1.6 / 1.75).abs() < 1e-15);
    assert_eq!((ann.stature(), ann.mass()), (Some(1.6), 60.0));
    // The thigh scales alike in all directions; its parent says where it sits.
    let [before, after] = [&figure, &ann].map(|figure| figure.link("right_thigh").expect("a link"));
    let s = 0.45 / figure.segment_length("right_thigh").expect("a length");
    assert!((after.com() - before.com() * s).amax() < 1e-15);
    let share = 60.0 / 73.0;
    assert!((after.inertia() - before.inertia() * (share * s * s)).amax() < 1e-15);
    let [hip, was] = [after, before].map(|link| link.joint().placement().translation.vector);
    assert!((hip - was * (1.6 / 1.75)).amax() < 1e-15);
}

#[test]
fn slides_and_their_followers_measure_what_they_slide_on() {
    let figure = machine();
    let big = scaled(&figure, &to(Some(4.0), None, &[("sledge", 1.2)]));
    let dof = |link: &str, i: usize| big.link(link).expect("a link").joint().kind().axes()[i].clone();
    // The world and the bed are twice as large, the sledge three times.
    let rail = dof("bed", 0);
    assert_eq!((rail.limits, rail.passive.rest), (Some(Limits { lower: -2.0, upper: 4.0 }), 0.4));
    let guide = dof("sledge", 0);
    assert_eq!(guide.limits, Some(Limits { lower: -0.2, upper: 0.6 }));
    assert_eq!(
        (guide.passive.stiffness, guide.passive.damping, guide.passive.friction, guide.armature),
        (5.0, 1.0, 0.5, 0.7)
    );
    assert_eq!(dof("rod", 0).limits, Some(Limits { lower: -1.0, upper: 1.0 }));
    for (k, (factor, of)) in [(3.0, 1.0), (1.0, 2.0), (1.0, 2.0)].into_iter().enumerate() {
        let [old, new] = [&figure, &big].map(|figure| figure.followers()[k].curve.clone());
        for x in [-1.7, -0.4, 0.0, 0.3, 1.9, 2.5] {
            let (old, new) = (old.at(x), new.at(x * of));
            for (order, (old, new)) in old.into_iter().zip(new).enumerate() {
                let expected = old * factor / f64::powi(of, order as i32);
                assert!(
                    (new - expected).abs() <= 1e-14 * expected.abs().max(1.0),
                    "follower {k} at {x}: {new} {expected}"
                );
            }
        }
    }
    let rod = big.link("rod").expect("a link");
    assert_eq!(rod.tip(), Some(&Vector3::new(0.0, 0.0, 1.4)));
    assert_eq!(rod.sole()[0].position, Vector3::new(0.0, 0.0, 1.2));
    let sledge = big.link("sledge").expect("a link");
    let s = 1.2 / 0.4;
    assert_eq!(sledge.frames()[0].placement.translation.vector, Vector3::new(0.1 * s, 0.1 * s, 0.0));
    assert_eq!(
        sledge.shape().expect("a shape").kind,
        ShapeKind::Capsule { radius: 0.1 * s, length: 0.4 * s }
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn there_and_back_is_where_it_was(height in 0.5_f64..3.0, mass in 5.0_f64..300.0, thigh in 0.2_f64..0.8) {
        let figure = person();
        let there = scaled(&figure, &to(Some(height), Some(mass), &[("thigh", thigh)]));
        let own = figure.segment_length("left_thigh").expect("a length");
        let back = scaled(&there, &to(Some(1.75), Some(73.0), &[("thigh", own)]));
        prop_assert_eq!(back.mass().to_bits(), 73.0_f64.to_bits());
        for (a, b) in figure.links().iter().zip(back.links()) {
            prop_assert!((a.mass() - b.mass()).abs() <= 1e-14 * a.mass());
            prop_assert!((a.com() - b.com()).amax() <= 1e-14);
            prop_assert!((a.inertia() - b.inertia()).amax() <= 1e-14 * a.inertia().amax());
            let [a, b] = [a, b].map(|link| link.joint().placement().translation.vector);
            prop_assert!((a - b).amax() <= 1e-14);
        }
    }

    #[test]
    fn the_scaled_figure_moves_as_the_figure_does(s in 0.3_f64..3.0, m in 0.3_f64..3.0, seed in 0_u64..1000) {
        for figure in [person(), machine()] {
            let stature = figure.stature().expect("said");
            let other = scaled(&figure, &to(Some(s * stature), Some(m * figure.mass()), &[]));
            let mut q: Vec<f64> = (0..figure.layout().nq()).map(|i| (i as f64 * 1.7 + seed as f64).sin()).collect();
            let (mut v, mut a) = (vec![0.0; figure.layout().nv()], vec![0.0; figure.layout().nv()]);
            figure.follow(&mut q, &mut v, &mut a);
            let slides = |figure: &Figure| -> Vec<bool> {
                figure.layout().v_names().iter().map(|name| name.contains(".t")).collect()
            };
            let mut large: Vec<f64> = q.iter().zip(slides(&figure)).map(|(q, slides)| if slides { q * s } else { *q }).collect();
            other.follow(&mut large, &mut v, &mut a);
            for ((one, two), link) in places(&figure, &q).iter().zip(places(&other, &large)).zip(other.links()) {
                let apart = one.translation.vector * s - two.translation.vector;
                prop_assert!(apart.amax() < 1e-13, "{}: {apart:?}", link.name());
                prop_assert!(one.rotation.angle_to(&two.rotation) < 1e-7);
            }
            for (a, b) in figure.links().iter().zip(other.links()) {
                prop_assert!((a.inertia() * (m * s * s) - b.inertia()).amax() <= 1e-14 * b.inertia().amax());
            }
        }
    }
}

#[test]
fn what_cannot_be_scaled_is_refused_with_what_to_do() {
    let plain = FigureBuilder::new("plain")
        .link(LinkSpec::root("a", Joint::new("j").rx()).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::new("k").rx()).mass(1.0))
        .build()
        .expect("valid");
    let frame =
        FigureBuilder::new("frame").link(LinkSpec::root("a", Joint::new("weld"))).build().expect("welded");
    let (person, vast) = (person(), human(2.3, 400.0).expect("in range"));
    let refused =
        |figure: &Figure, scaling: Scaling| -> ScaleError { figure.scaled(&scaling).expect_err("refused") };
    let answers = [
        refused(&person, to(Some(-1.0), None, &[])),
        refused(&person, to(Some(f64::NAN), None, &[])),
        refused(&plain, to(Some(1.8), None, &[])),
        refused(&person, to(None, Some(0.0), &[])),
        refused(&person, to(None, Some(f64::INFINITY), &[])),
        refused(&frame, to(None, Some(1.0), &[])),
        refused(&person, to(None, None, &[("left_tigh", 0.4)])),
        refused(&person, to(None, None, &[("tigh", 0.4)])),
        refused(&person, to(None, None, &[("qwertyuiop", 0.4)])),
        refused(&person, to(None, None, &[("thigh", f64::NAN)])),
        refused(&plain, to(None, None, &[("a", 0.4)])),
        refused(&plain, to(None, None, &[("b", 0.4)])),
        refused(&person, to(Some(1.75e9), None, &[])),
        refused(&person, to(None, None, &[("thigh", 4e-8)])),
        refused(&vast, to(None, Some(1e-9), &[])),
    ];
    insta::assert_snapshot!(answers.map(|answer| answer.to_string()).join("\n"));
}

#[test]
fn numbers_at_the_end_of_their_range_do_not_leave_it() {
    let far = FigureBuilder::new("far")
        .link(
            LinkSpec::root("a", Joint::new("j").rx())
                .mass(1.0)
                .inertia(Inertia::diagonal(1e300, 1e300, 1e300))
                .tip(Vector3::x()),
        )
        .build()
        .expect("valid");
    let error = far.scaled(&to(None, None, &[("a", 1e6)])).expect_err("too large");
    assert_eq!(error, ScaleError::NotFinite { link: "a".to_owned() });
}
