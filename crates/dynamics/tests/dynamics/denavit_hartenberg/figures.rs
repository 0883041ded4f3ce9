//! Small figures with a purpose.

use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3};

/// A turret with an upper arm on it, and on the upper arm a forearm and, beside it, a lamp that slides: y is up.
pub(crate) fn branching_arm() -> Figure {
    FigureBuilder::new("arm")
        .link(LinkSpec::root("turret", Joint::new("base").ry()).mass(4.0))
        .link(
            LinkSpec::child(
                "upper_arm",
                "turret",
                Joint::new("shoulder").at(Vector3::new(0.15, 0.4, 0.0)).rx(),
            )
            .mass(2.0)
            .com(Vector3::new(0.0, 0.0, 0.3)),
        )
        .link(
            LinkSpec::child("forearm", "upper_arm", Joint::new("elbow").at(Vector3::new(0.0, 0.0, 0.6)).rx())
                .mass(1.0)
                .com(Vector3::new(0.0, 0.0, 0.25))
                .tip(Vector3::new(0.0, 0.0, 0.5)),
        )
        .link(
            LinkSpec::child(
                "lamp",
                "upper_arm",
                Joint::new("rail").at(Vector3::new(0.0, 0.12, 0.3)).tz().ry(),
            )
            .mass(0.5)
            .com(Vector3::new(0.0, 0.05, 0.0))
            .tip(Vector3::new(0.0, 0.1, 0.15)),
        )
        .build()
        .expect("valid")
}
