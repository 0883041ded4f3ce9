//! A chain of any length, for counts and times that must grow with the length alone.

use nalgebra::Vector3;
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec};

/// Links of 1 kg and 0.1 m, turning about x, y and z by turns.
pub(crate) fn chain(links: usize) -> Figure {
    let mut builder = FigureBuilder::new("chain");
    for i in 0..links {
        let axis = Axis::rotation(Vector3::ith(i % 3, 1.0));
        let joint = Joint::new(format!("joint {i}")).at(Vector3::new(0.0, -0.1, 0.02)).axis(axis);
        let link = match i.checked_sub(1) {
            None => LinkSpec::root("link 0", joint),
            Some(parent) => LinkSpec::child(format!("link {i}"), format!("link {parent}"), joint),
        };
        let inertia = Inertia::diagonal(1e-3, 2e-3, 1.5e-3);
        builder = builder.link(link.mass(1.0).com(Vector3::new(0.01, -0.05, 0.0)).inertia(inertia));
    }
    builder.build().expect("a valid figure")
}
