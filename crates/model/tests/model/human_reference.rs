//! The human of 1.75 m and 73 kg against numbers of an independent program (`fixtures/reference/smooth`).
//!
//! Those numbers are of a body whose trunk, neck and head were stacked 6 % too high: `figure.ron` is that body.

use serde_json::Value;
use solaris_model::{Figure, Link, SolePart, Vector3, human};

fn reference_figure() -> Figure {
    let text = include_str!("../../../../fixtures/reference/smooth/figure.ron");
    solaris_model::text::read(text).expect("a figure")
}

fn reference() -> Value {
    let text = include_str!("../../../../fixtures/reference/smooth/golden.json");
    serde_json::from_str::<Value>(text).expect("JSON")["figure"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_fn(|i, _| number(&value[i]))
}

/// `upperarm_l` of the reference is `left_upper_arm` here.
fn our_name(name: &str) -> String {
    let name = name.replace("upperarm", "upper_arm");
    match name.rsplit_once('_') {
        Some((segment, "l")) => format!("left_{segment}"),
        Some((segment, "r")) => format!("right_{segment}"),
        _ => name,
    }
}

/// Half a unit in the last of `decimals` places, and a little for the other program's own rounding.
fn rounding(decimals: i32) -> f64 {
    0.501 * 10_f64.powi(-decimals)
}

#[test]
fn every_segment_is_that_of_the_reference() {
    let (figure, reference) = (reference_figure(), reference());
    let segments = reference["segments"].as_array().expect("a list");
    assert_eq!(segments.len(), figure.links().len());
    for segment in segments {
        let name = our_name(segment["name"].as_str().expect("a name"));
        let link = figure.link(&name).expect("a link of that name");
        let parent = link.parent().map(|parent| figure.links()[parent].name().to_owned());
        assert_eq!(parent, segment["parent"].as_str().map(our_name), "{name}");
        let near = |ours: Vector3<f64>, theirs: &Value, decimals| {
            let off = (ours - vector(theirs)).amax();
            assert!(off <= rounding(decimals), "{name}: {ours:?} against {theirs}");
        };
        near(link.joint().placement().translation.vector, &segment["offset"], 7);
        near(*link.com(), &segment["com"], 7);
        near(link.inertia().diagonal(), &segment["inertia_diag"], 8);
        assert!((link.mass() - number(&segment["mass"])).abs() <= rounding(7), "{name}: {} kg", link.mass());
        assert!(link.joint().placement().rotation.angle() == 0.0, "{name} is not turned");
        assert!(
            (link.inertia() - solaris_model::Matrix3::from_diagonal(&link.inertia().diagonal())).amax()
                == 0.0
        );
    }
}

#[test]
fn the_legs_measures_are_those_of_the_reference() {
    let (figure, reference) = (human(1.75, 73.0).expect("an ordinary human"), reference());
    let origin = |figure: &Figure, link: &str| link_of(figure, link).joint().placement().translation.vector;
    for side in ["left", "right"] {
        let shank = origin(&figure, &format!("{side}_shank"));
        let foot = origin(&figure, &format!("{side}_foot"));
        let toes = origin(&figure, &format!("{side}_toes"));
        let heel = point(&figure, &format!("{side}_foot"), SolePart::Heel);
        let ball = point(&figure, &format!("{side}_foot"), SolePart::Ball);
        let under_toes = point(&figure, &format!("{side}_toes"), SolePart::Ball);
        let tip = point(&figure, &format!("{side}_toes"), SolePart::ToeTip);
        let measures = [
            ("L1", shank.norm()),
            ("L2", foot.norm()),
            ("a1", (-shank.z).atan2(-shank.y)),
            ("a2", (-foot.z).atan2(-foot.y)),
            ("ha", -heel.y),
            ("ha", -ball.y),
            ("hz", -heel.z),
            ("tz", toes.z),
            ("tz", ball.z),
            ("ty", -toes.y),
            ("sole", -under_toes.y),
            ("sole", -tip.y),
            ("toe", tip.z),
            ("foot", toes.z + tip.z - heel.z),
            ("leg", shank.norm() + foot.norm() - heel.y),
        ];
        for (name, ours) in measures {
            let theirs = number(&reference[name]);
            assert!((ours - theirs).abs() <= rounding(8), "{side} {name}: {ours} against {theirs}");
        }
    }
}

/// What was changed since: heights above the pelvis, by one factor, and the shoulder's. Nothing else.
#[test]
fn the_human_is_the_reference_stacked_to_its_height() {
    let (human, reference) = (human(1.75, 73.0).expect("an ordinary human"), reference_figure());
    let scale = 1.75 / 1.741;
    let stack = (1.741 - 1.010) / 0.840;
    for (now, then) in human.links().iter().zip(reference.links()) {
        let name = now.name();
        let origin = |link: &Link| link.joint().placement().translation.vector;
        let (mut offset, mut com) = (origin(then), *then.com());
        if ["abdomen", "thorax", "neck", "head", "left_clavicle", "right_clavicle"].contains(&name) {
            offset.y *= stack;
        }
        if name.ends_with("upper_arm") {
            offset.y = scale * (0.818 * 1.741 - 1.010 - stack * 0.500);
        }
        if ["abdomen", "thorax", "neck", "head"].contains(&name) {
            com.y *= stack;
        }
        assert!((origin(now) - offset).amax() < 1e-15, "{name}");
        assert!((now.com() - com).amax() < 1e-15, "{name}");
        assert!((now.mass() - then.mass()).abs() < 1e-14, "{name}");
        assert!((now.inertia() - then.inertia()).amax() < 1e-15, "{name}");
    }
}

fn link_of<'a>(figure: &'a Figure, name: &str) -> &'a Link {
    figure.link(name).expect("a link of that name")
}

fn point(figure: &Figure, link: &str, part: SolePart) -> Vector3<f64> {
    *link_of(figure, link).sole_point(part).expect("a point of the sole")
}
