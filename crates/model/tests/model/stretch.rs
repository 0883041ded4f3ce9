//! Stretching by a factor for each axis of each link, against OpenSim's numbers and against scaling alike.

use super::poses::places;
use proptest::prelude::*;
use serde_json::Value;
use solaris_model::{
    Axis, Curve, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Marker, MassShares, Matrix3, Placement,
    ScaleError, Scaling, Shape, ShapeKind, SolePart, Stretching, Vector3, human,
};

fn stretched(figure: &Figure, factors: &[Vector3<f64>], mass: Option<f64>, shares: MassShares) -> Figure {
    figure.stretched(&Stretching { factors: factors.to_vec(), mass, shares }).expect("in range")
}

/// A leg whose knee moves as it bends, placed askew; and a foot whose joint turns before it slides.
fn leg() -> Figure {
    let bent = Curve::Polynomial(vec![0.01, 0.02, -0.03]);
    let askew =
        Placement::new(Vector3::new(0.01, -0.4, 0.02), Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
    let ball =
        Shape { kind: ShapeKind::Sphere { radius: 0.05 }, placement: Placement::translation(0.0, 0.1, 0.0) };
    let oblique = Vector3::new(0.6, 0.8, 0.0);
    FigureBuilder::new("leg")
        .link(
            LinkSpec::root("thigh", Joint::new("hip").tx().rz())
                .mass(7.0)
                .com(Vector3::new(0.01, -0.2, 0.005))
                .inertia(Inertia::Tensor(Matrix3::new(0.13, 0.01, 0.0, 0.01, 0.03, 0.002, 0.0, 0.002, 0.14)))
                .shape(ball),
        )
        .link(
            LinkSpec::child(
                "shank",
                "thigh",
                Joint::new("knee")
                    .placed(askew)
                    .tx()
                    .following("knee.rz", bent.clone())
                    .axis(Axis::translation(oblique))
                    .named("slope")
                    .following("knee.rz", bent.clone())
                    .rz()
                    .ty()
                    .following("knee.rz", bent),
            )
            .mass(3.0)
            .com(Vector3::new(0.0, -0.15, 0.0))
            .inertia(Inertia::diagonal(0.05, 0.005, 0.05))
            .tip(Vector3::new(0.1, -0.4, 0.2))
            .sole(SolePart::Heel, Vector3::new(-0.1, -0.4, 0.0))
            .frame("ankle", Placement::translation(0.0, -0.38, 0.01)),
        )
        .stature(1.8)
        .build()
        .expect("a valid figure")
}

fn ones(figure: &Figure) -> Vec<Vector3<f64>> {
    vec![Vector3::repeat(1.0); figure.links().len()]
}

#[test]
fn factors_of_one_change_no_bit() {
    for figure in [human(1.75, 73.0).expect("in range"), leg()] {
        for (mass, shares) in [(None, MassShares::Volumes), (Some(figure.mass()), MassShares::Kept)] {
            let same = stretched(&figure, &ones(&figure), mass, shares);
            assert_eq!(same.links(), figure.links());
            assert_eq!((same.fingerprint(), same.stature()), (figure.fingerprint(), figure.stature()));
        }
    }
}

#[test]
fn every_length_follows_its_own_axis() {
    let (thigh, shank) = (Vector3::new(2.0, 3.0, 5.0), Vector3::new(7.0, 11.0, 13.0));
    let long = stretched(&leg(), &[thigh, shank], None, MassShares::Kept);
    assert_eq!(long.stature(), None);
    let [upper, lower] = [&long.links()[0], &long.links()[1]];
    assert_eq!(upper.com(), &Vector3::new(0.02, -0.2 * 3.0, 0.005 * 5.0));
    assert_eq!(upper.shape().expect("one").kind, ShapeKind::Ellipsoid { radii: thigh * 0.05 });
    assert_eq!(lower.joint().placement().translation.vector, Vector3::new(0.02, -0.4 * 3.0, 0.1));
    assert_eq!(lower.joint().placement().rotation, leg().links()[1].joint().placement().rotation);
    assert_eq!(lower.tip(), Some(&Vector3::new(0.1 * 7.0, -0.4 * 11.0, 0.2 * 13.0)));
    assert_eq!(lower.sole()[0].position, Vector3::new(-0.1 * 7.0, -0.4 * 11.0, 0.0));
    assert_eq!(lower.frames()[0].placement.translation.vector, Vector3::new(0.0, -0.38 * 11.0, 0.01 * 13.0));
    // The knee's x is the thigh's y; what slides after the turn slides along the shank.
    let factors = [3.0, Vector3::new(-0.8 * 2.0, 0.6 * 3.0, 0.0).norm(), 11.0];
    for (k, factor) in factors.into_iter().enumerate() {
        let [old, new] = [&leg(), &long].map(|figure| figure.followers()[k].curve.at(0.7));
        for (old, new) in old.into_iter().zip(new) {
            assert!((new - factor * old).abs() < 1e-13, "slide {k}: {new} {}", factor * old);
        }
    }
    let marker = Marker { name: "m".into(), link: 1, position: Vector3::new(1.0, 2.0, 3.0), is_fixed: true };
    let stretching = Stretching { factors: vec![thigh, shank], mass: None, shares: MassShares::Kept };
    let moved = stretching.markers(std::slice::from_ref(&marker)).expect("its link has factors");
    assert_eq!(moved, [Marker { position: Vector3::new(7.0, 22.0, 39.0), ..marker.clone() }]);
    let lost = stretching.markers(&[Marker { link: 2, ..marker }]).expect_err("no such link");
    assert_eq!(lost, ScaleError::MarkerLink { marker: "m".into(), link: 2 });
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn one_factor_everywhere_is_scaling(s in 0.3_f64..3.0, mass in 5.0_f64..300.0, volumes in any::<bool>()) {
        let figure = human(1.75, 73.0).expect("in range");
        let shares = if volumes { MassShares::Volumes } else { MassShares::Kept };
        let one = stretched(&figure, &vec![Vector3::repeat(s); figure.links().len()], Some(mass), shares);
        let height = 1.75 * s;
        let other = figure.scaled(&Scaling { height: Some(height), mass: Some(mass), segments: vec![] }).expect("in range");
        prop_assert_eq!(one.mass().to_bits(), mass.to_bits());
        prop_assert!((one.stature().expect("said") - height).abs() < 1e-15 * height);
        for (a, b) in one.links().iter().zip(other.links()) {
            prop_assert!((a.mass() - b.mass()).abs() <= 1e-13 * b.mass());
            prop_assert!((a.com() - b.com()).amax() <= 1e-14);
            prop_assert!((a.inertia() - b.inertia()).amax() <= 1e-13 * b.inertia().amax());
            prop_assert_eq!(a.joint().kind(), b.joint().kind());
        }
        let q: Vec<f64> = (0..figure.layout().nq()).map(|i| (i as f64 * 1.7).sin()).collect();
        for (a, b) in places(&one, &q).iter().zip(places(&other, &q)) {
            prop_assert!((a.translation.vector - b.translation.vector).amax() < 1e-13);
        }
    }

    #[test]
    fn there_and_back_is_where_it_was(x in 0.5_f64..2.0, y in 0.5_f64..2.0, z in 0.5_f64..2.0) {
        let (figure, s) = (leg(), Vector3::new(x, y, z));
        let there = stretched(&figure, &[s, s], None, MassShares::Volumes);
        let back = s.map(f64::recip);
        let back = stretched(&there, &[back, back], None, MassShares::Volumes);
        for (a, b) in figure.links().iter().zip(back.links()) {
            prop_assert!((a.mass() - b.mass()).abs() <= 1e-14 * a.mass());
            prop_assert!((a.com() - b.com()).amax() <= 1e-14);
            let [a, b] = [a, b].map(|link| link.joint().placement().translation.vector);
            prop_assert!((a - b).amax() <= 1e-14);
        }
    }
}

#[test]
fn a_body_is_a_link_or_a_frame_of_one() {
    // The kneecap's joint is split: `between` has no body.
    let figure = FigureBuilder::new("knee")
        .link(LinkSpec::root("thigh", Joint::new("hip").rx()).mass(1.0))
        .link(LinkSpec::child("between", "thigh", Joint::new("first").at(Vector3::x()).rx()))
        .link(
            LinkSpec::child("cap", "between", Joint::new("second").ry())
                .mass(0.1)
                .frame("bone", Placement::translation(0.1, 0.0, 0.0))
                .frame("askew", Placement::rotation(Vector3::x())),
        )
        .build()
        .expect("valid");
    let (long, even) = (Vector3::new(1.0, 2.0, 3.0), Vector3::repeat(1.5));
    let factors = |bodies: &[(&str, Vector3<f64>)]| {
        let bodies: Vec<(String, Vector3<f64>)> =
            bodies.iter().map(|(name, s)| ((*name).into(), *s)).collect();
        figure.stretch_factors(&bodies)
    };
    let one = Vector3::repeat(1.0);
    assert_eq!(factors(&[("bone", long), ("ground", one)]), Ok(vec![one, long, long]));
    assert_eq!(factors(&[("between", even), ("cap", long)]), Ok(vec![one, even, long]));
    assert_eq!(factors(&[("askew", even), ("cap", even)]), Ok(vec![one, even, even]));
    let refused = |bodies: &[(&str, Vector3<f64>)]| factors(bodies).expect_err("refused").to_string();
    let stretched = |factors: Vec<Vector3<f64>>| {
        let stretching = Stretching { factors, mass: None, shares: MassShares::Kept };
        figure.stretched(&stretching).expect_err("refused").to_string()
    };
    let answers = [
        refused(&[("bon", long)]),
        refused(&[("bone", long), ("cap", even)]),
        refused(&[("askew", long)]),
        stretched(vec![one]),
        stretched(vec![one, Vector3::new(1.0, 0.0, 1.0), one]),
        stretched(vec![one, one, Vector3::new(1.0, 1.0, f64::NAN)]),
    ];
    insta::assert_snapshot!(answers.join("\n"));
}

/// Every body of two models that OpenSim scaled, as links side by side: the numbers are rounded to 6 decimals, the factors
/// to 6 digits.
#[test]
fn masses_and_inertias_are_those_of_opensim() {
    struct Body {
        name: String,
        factors: Vector3<f64>,
        mass: Vec<f64>,
        inertia: Vec<Matrix3<f64>>,
    }
    let tensor = |of: &[f64]| Matrix3::new(of[0], of[3], of[4], of[3], of[1], of[5], of[4], of[5], of[2]);
    let text = include_str!("../../../../fixtures/reference/opensim_scaled.json");
    let file: Value = serde_json::from_str(text).expect("the reference");
    let list = |value: &Value, key: &str| value[key].as_array().expect("a list").clone();
    let numbers = |value: &Value| -> Vec<f64> {
        value.as_array().expect("numbers").iter().map(|number| number.as_f64().expect("a number")).collect()
    };
    assert_eq!(list(&file, "cases").len(), 2);
    for case in list(&file, "cases") {
        let body = |body: &Value| Body {
            name: body["name"].as_str().expect("a name").to_owned(),
            factors: Vector3::from_column_slice(&numbers(&body["factors"])),
            mass: numbers(&body["mass"]),
            inertia: list(body, "inertia").iter().map(|inertia| tensor(&numbers(inertia))).collect(),
        };
        let bodies: Vec<Body> = list(&case, "bodies").iter().map(body).collect();
        let mut builder =
            FigureBuilder::new("side by side").link(LinkSpec::root("world", Joint::new("root")));
        for body in &bodies {
            let link = LinkSpec::child(&body.name, "world", Joint::new(format!("at {}", body.name)).rx());
            builder = builder.link(link.mass(body.mass[0]).inertia(Inertia::Tensor(body.inertia[0])));
        }
        let figure = builder.build().expect("valid");
        let named: Vec<_> = bodies.iter().map(|body| (body.name.clone(), body.factors)).collect();
        let total = bodies.iter().map(|body| body.mass[1]).sum();
        let factors = figure.stretch_factors(&named).expect("links");
        let scaled = stretched(&figure, &factors, Some(total), MassShares::Kept);
        for body in &bodies {
            let (link, name) =
                (scaled.link(&body.name).expect("a link"), format!("{}: {}", case["name"], body.name));
            assert!((link.mass() - body.mass[1]).abs() < 2e-6, "{name} weighs {}", link.mass());
            let off = (link.inertia() - body.inertia[1]).amax();
            assert!(off < 4e-6 * link.inertia().amax() + 6e-7, "{name} has {}", link.inertia());
        }
    }
}
