//! Texts of models scaled to a subject, against OpenSim's own (`fixtures/reference/opensim_rescaled.json`).

use crate::data::numbers;
use crate::opensim::{pose, read};
use serde_json::Value;
use solaris_io::opensim::{MarkerPlace, Rescaling, rescale};
use solaris_model::{MassShares, Stretching, Vector3};

fn reference() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/opensim_rescaled.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("part of the project")).expect("JSON")
}

fn text_of(reference: &Value) -> &str {
    reference["text"].as_str().expect("a model")
}

fn factors(reference: &Value) -> Vec<(String, Vector3<f64>)> {
    let factors = reference["factors"].as_object().expect("factors");
    factors.iter().map(|(name, s)| (name.clone(), Vector3::from_column_slice(&numbers(s)))).collect()
}

fn cases(reference: &Value) -> Vec<(Rescaling, &Value)> {
    let rescaling = |case: &Value| Rescaling {
        factors: factors(reference),
        mass: case["mass"].as_f64(),
        shares: if case["keep"] == true { MassShares::Kept } else { MassShares::Volumes },
        ..Rescaling::default()
    };
    reference["cases"].as_array().expect("cases").iter().map(|case| (rescaling(case), case)).collect()
}

/// The numbers in all elements called so, in the order of the text.
fn all(text: &str, tag: &str) -> Vec<f64> {
    let (open, close) = (format!("<{tag}>"), format!("</{tag}>"));
    let held = text.split(&open).skip(1).map(|rest| rest.split(&close).next().unwrap_or_default());
    held.flat_map(str::split_whitespace).map(|word| word.parse().expect("a number")).collect()
}

#[test]
fn every_number_is_that_of_opensim() {
    let reference = reference();
    for (rescaling, case) in cases(&reference) {
        let (scaled, _) = rescale(text_of(&reference), &rescaling).expect("a model");
        let kinds = case["numbers"].as_object().expect("kinds");
        assert_eq!(kinds.len(), 16);
        for (kind, expected) in kinds {
            let (found, expected) = (all(&scaled, kind), numbers(expected));
            assert_eq!(found.len(), expected.len(), "{kind}");
            let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (i, (found, expected)) in found.into_iter().zip(expected).enumerate() {
                // The third muscle's path may wrap.
                let is_left =
                    i == 2 && ["optimal_fiber_length", "tendon_slack_length"].contains(&kind.as_str());
                assert!((found - expected).abs() < 1e-14 * size || is_left, "{kind} {i}: {found} {expected}");
            }
        }
        let import = read(&scaled);
        for state in case["states"].as_array().expect("states") {
            let q: Vec<(&str, f64)> = state["q"]
                .as_object()
                .expect("values")
                .iter()
                .map(|(name, value)| (name.as_str(), value.as_f64().expect("a number")))
                .collect();
            for (body, expected) in state["bodies"].as_object().expect("bodies") {
                let found = pose(&import, body, &q).to_homogeneous();
                let position = numbers(&expected["position"]);
                let off = (0..3).map(|i| (found[(i, 3)] - position[i]).abs()).fold(0.0, f64::max);
                assert!(off < 1e-13, "{body}: off by {off:e}");
            }
        }
    }
}

/// What is read of a scaled text is what is read, stretched; but where bodies are one link, its inertia is not the sum of
/// their cylinders.
#[test]
fn the_scaled_text_is_the_stretched_figure() {
    let reference = reference();
    let figure = read(text_of(&reference)).figure;
    for (rescaling, _) in cases(&reference) {
        let (scaled, _) = rescale(text_of(&reference), &rescaling).expect("a model");
        let scaled = read(&scaled).figure;
        let factors = figure.stretch_factors(&rescaling.factors).expect("bodies");
        let stretching = Stretching { factors, mass: rescaling.mass, shares: rescaling.shares };
        let stretched = figure.stretched(&stretching).expect("a figure");
        for (a, b) in stretched.links().iter().zip(scaled.links()) {
            let name = a.name();
            assert_eq!((name, a.frames().len()), (b.name(), b.frames().len()));
            assert!(
                (a.mass() - b.mass()).abs() < 1e-14 * b.mass().max(1.0),
                "{name}: {} {}",
                a.mass(),
                b.mass()
            );
            assert!((a.com() - b.com()).amax() < 1e-15, "{name}: {} {}", a.com(), b.com());
            if name != "foot" {
                assert!(
                    (a.inertia() - b.inertia()).amax() < 1e-15,
                    "{name}: {} {}",
                    a.inertia(),
                    b.inertia()
                );
            }
            let [one, other] = [a, b].map(|link| link.joint().placement().translation.vector);
            assert!((one - other).amax() < 1e-15, "{name}: {one} {other}");
            for (one, other) in a.frames().iter().zip(b.frames()) {
                let off = one.placement.translation.vector - other.placement.translation.vector;
                assert!(off.amax() < 1e-15, "{name}, {}", one.name);
            }
        }
        for (a, b) in stretched.followers().iter().zip(scaled.followers()) {
            for x in [-1.2, 0.0, 0.4] {
                let ([a, ..], [b, ..]) = (a.curve.at(x), b.curve.at(x));
                assert!((a - b).abs() < 1e-15, "{a} {b}");
            }
        }
    }
}

#[test]
fn what_does_not_change_keeps_its_bytes() {
    let reference = reference();
    let text = text_of(&reference).replace('\n', "\r\n").replace("<mass>", "<!-- kg -->\t<mass> +");
    let one = Rescaling { factors: vec![("femur".into(), Vector3::repeat(1.0))], ..Rescaling::default() };
    assert!(rescale(&text, &one).expect("a model").0 == text);
    let toes =
        Rescaling { factors: vec![("toes".into(), Vector3::new(2.0, 1.0, 1.0))], ..Rescaling::default() };
    let (scaled, _) = rescale(&text, &toes).expect("a model");
    let changed: Vec<(&str, &str)> =
        text.split('<').zip(scaled.split('<')).filter(|(old, new)| old != new).collect();
    let expected = [
        ("mass_center>0.034 0.006 -0.0175", "mass_center>0.068 0.006 -0.0175"),
        (
            "inertia>0.0001 0.0002 0.0001 0 0 0",
            "inertia>0.0001 0.0006500000000000001 0.0006500000000000001 0 0 0",
        ),
    ];
    assert_eq!(changed, expected);
}

fn place(name: &str, body: &str, position: [f64; 3], is_fixed: bool) -> MarkerPlace {
    MarkerPlace { name: name.into(), body: body.into(), position: position.into(), is_fixed }
}

#[test]
fn markers_go_where_they_are_told() {
    let reference = reference();
    let markers = vec![
        place("asis", "pelvis", [0.1, 0.2, 0.3], true),
        place("thigh", "femur", [0.05, -0.2, 0.07], false),
        place("knee <1>", "tibia", [0.0, 0.01, 0.05], true),
    ];
    let rescaling = Rescaling {
        factors: factors(&reference),
        markers,
        removed: vec!["heel".into()],
        ..Rescaling::default()
    };
    let (scaled, _) = rescale(text_of(&reference), &rescaling).expect("a model");
    let set: Vec<&str> = scaled.lines().filter(|line| line.contains("<Marker ")).map(str::trim).collect();
    // The thigh's frame is moved with the femur: 0.05 − 0.01·1.1, −0.2 − 0.02·1.05, 0.07 + 0.01·0.93.
    insta::assert_snapshot!(set.join("\n"));
    // On another body, and without a set of markers.
    let other = place("asis", "tibia", [0.0, 0.0, 0.05], false);
    let rescaling = Rescaling { markers: vec![other.clone()], ..Rescaling::default() };
    let (scaled, _) = rescale(text_of(&reference), &rescaling).expect("a model");
    assert!(
        scaled.contains(
            "<socket_parent_frame>/bodyset/tibia</socket_parent_frame><location>0 0 0.05</location>"
        )
    );
    let bare = text_of(&reference)
        .replace("MarkerSet", "notes")
        .replace("<Marker ", "<note ")
        .replace("</Marker>", "</note>");
    let (scaled, _) = rescale(&bare, &rescaling).expect("a model");
    assert!(
        scaled.contains("<MarkerSet name=\"markerset\">") && read(&scaled).figure.locate("tibia").is_some()
    );
}

/// Bodies hold their joints, points name bodies, and what they look like has sizes of its own.
#[test]
fn older_versions_are_scaled_too() {
    let text = r#"<OpenSimDocument Version="20303"><Model name="old">
<BodySet><objects>
 <Body name="ground"/>
 <Body name="rod"><mass>2</mass><mass_center>0 -0.5 0</mass_center><inertia_xx>0.1</inertia_xx><inertia_yy>0.01</inertia_yy><inertia_zz>0.1</inertia_zz>
  <Joint><PinJoint name="pivot"><parent_body>ground</parent_body><location_in_parent>0 1 0</location_in_parent>
   <location>0 0.1 0</location><CoordinateSet><objects><Coordinate name="angle"/></objects></CoordinateSet></PinJoint></Joint>
  <VisibleObject><GeometrySet><objects><DisplayGeometry><geometry_file>rod.vtp</geometry_file><transform>0 0 1 0 0.2 0</transform></DisplayGeometry></objects></GeometrySet></VisibleObject>
  <WrapObjectSet><objects><WrapCylinder name="w"><translation>0 0.3 0</translation><radius>0.1</radius><length>1</length></WrapCylinder></objects></WrapObjectSet>
 </Body>
 <Body name="bob"><mass>1</mass><mass_center>0 0 0</mass_center>
  <Joint><CustomJoint name="slide"><parent_body>rod</parent_body><location_in_parent>0 -1 0</location_in_parent>
   <CoordinateSet><objects><Coordinate name="turn"/></objects></CoordinateSet>
   <SpatialTransform><TransformAxis name="rotation1"><coordinates>turn</coordinates><axis>0 0 1</axis><function><LinearFunction><coefficients>1 0</coefficients></LinearFunction></function></TransformAxis>
   <TransformAxis name="translation2"><coordinates>turn</coordinates><axis>0 1 0</axis><function><NaturalCubicSpline><x>0 1</x><y>0 0.1</y></NaturalCubicSpline></function></TransformAxis></SpatialTransform></CustomJoint></Joint></Body>
</objects></BodySet>
<ForceSet><objects><Thelen2003Muscle name="m"><GeometryPath><PathPointSet><objects>
 <PathPoint name="a"><location>0 2 0</location><body>ground</body></PathPoint>
 <PathPoint name="b"><location>0 -0.4 0</location><body>rod</body></PathPoint>
</objects></PathPointSet></GeometryPath><optimal_fiber_length>0.3</optimal_fiber_length></Thelen2003Muscle></objects></ForceSet>
<MarkerSet><objects><Marker name="m"><body>rod</body><location>0.1 -0.2 0</location></Marker></objects></MarkerSet>
</Model></OpenSimDocument>"#;
    let factors = vec![("rod".to_owned(), Vector3::new(1.0, 2.0, 1.0))];
    let markers = vec![place("new", "bob", [0.0, 0.0, 0.1], false)];
    let rescaling = Rescaling { factors, mass: Some(6.0), markers, ..Rescaling::default() };
    let (scaled, findings) = rescale(text, &rescaling).expect("a model");
    assert!(findings.is_empty(), "{findings:?}");
    insta::assert_snapshot!(scaled);
}

#[test]
fn what_cannot_be_scaled_is_refused_with_what_to_do() {
    let reference = reference();
    let refused =
        |rescaling: Rescaling| rescale(text_of(&reference), &rescaling).expect_err("refused").to_string();
    let scaled = |name: &str, x: f64| Rescaling {
        factors: vec![(name.to_owned(), Vector3::new(x, 1.0, 1.0))],
        ..Rescaling::default()
    };
    let with = |marker: MarkerPlace| refused(Rescaling { markers: vec![marker], ..Rescaling::default() });
    let answers = [
        refused(scaled("femu", 1.1)),
        refused(scaled("femur", -1.1)),
        refused(scaled("femur", f64::NAN)),
        refused(Rescaling { mass: Some(0.0), ..Rescaling::default() }),
        refused(Rescaling { removed: vec!["hell".into()], ..Rescaling::default() }),
        with(place("m", "femu", [0.0; 3], false)),
        with(place("m", "femur", [f64::NAN, 0.0, 0.0], false)),
    ];
    insta::assert_snapshot!(answers.join("\n"));
    assert!(rescale("<a/>", &Rescaling::default()).is_err());
}
