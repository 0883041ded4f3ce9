//! The figure of `fixtures/reference/smooth/golden.json`, and readers of its numbers.

use serde_json::Value;
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, SolePart, Vector3};

/// The golden numbers.
pub(crate) fn golden() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/smooth/golden.json");
    serde_json::from_str(&std::fs::read_to_string(path).expect("the fixture is there")).expect("it is JSON")
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn vector(value: &Value) -> Vector3<f64> {
    Vector3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}

/// `thigh_l` is `left_thigh` here.
pub(crate) fn link_name(golden: &str) -> String {
    let name = golden.replace("upperarm", "upper_arm");
    match name.rsplit_once('_') {
        Some((stem, "l")) => format!("left_{stem}"),
        Some((stem, "r")) => format!("right_{stem}"),
        _ => name,
    }
}

/// The figure that the golden numbers belong to.
pub(crate) fn golden_figure(golden: &Value) -> Figure {
    let figure = &golden["figure"];
    let of = |key: &str| number(&figure[key]);
    let mut builder = FigureBuilder::new("golden").stature(1.75);
    for segment in figure["segments"].as_array().expect("segments") {
        let name = link_name(segment["name"].as_str().expect("a name"));
        let joint = Joint::new(format!("{name}_joint")).at(vector(&segment["offset"]));
        let inertia = vector(&segment["inertia_diag"]);
        let link = match segment["parent"].as_str() {
            Some(parent) => LinkSpec::child(&name, link_name(parent), joint.rz().ry().rx()),
            None => LinkSpec::root(&name, joint.tx().ty().tz().rz().ry().rx()),
        };
        let mut link = link
            .mass(number(&segment["mass"]))
            .com(vector(&segment["com"]))
            .inertia(Inertia::diagonal(inertia.x, inertia.y, inertia.z));
        if name.ends_with("foot") {
            link = link
                .sole(SolePart::Heel, Vector3::new(0.0, -of("ha"), -of("hz")))
                .sole(SolePart::Ball, Vector3::new(0.0, -of("ha"), of("tz")));
        } else if name.ends_with("toes") {
            link = link
                .sole(SolePart::Ball, Vector3::new(0.0, -of("sole"), 0.0))
                .sole(SolePart::ToeTip, Vector3::new(0.0, -of("sole"), of("toe")));
        }
        builder = builder.link(link);
    }
    builder.build().expect("a valid figure")
}

/// The largest difference met so far, and where.
#[derive(Default)]
pub(crate) struct Worst(pub(crate) f64, pub(crate) String);

impl Worst {
    pub(crate) fn note(&mut self, difference: f64, place: impl FnOnce() -> String) {
        assert!(difference.is_finite(), "not a number at {}", place());
        if difference > self.0 {
            *self = Self(difference, place());
        }
    }
}

/// Largest differences of lengths (m), angles (degrees), shares and forces (N).
#[derive(Default)]
pub(crate) struct Differences {
    pub(crate) length: Worst,
    pub(crate) angle: Worst,
    pub(crate) share: Worst,
    pub(crate) force: Worst,
}

impl Differences {
    pub(crate) fn assert_below(&self, length: f64, angle: f64, force: f64) {
        for (what, worst, limit) in [
            ("length (m)", &self.length, length),
            ("angle (degrees)", &self.angle, angle),
            ("share", &self.share, 1e-3),
            ("force (N)", &self.force, force),
        ] {
            println!("  {what}: {:.2e} at {}", worst.0, worst.1);
            assert!(worst.0 <= limit, "{what} is off by {} at {}; the limit is {limit}", worst.0, worst.1);
        }
    }
}
