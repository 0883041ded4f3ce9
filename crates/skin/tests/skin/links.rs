//! Machines: each link's shape as it is.

use nalgebra::Vector3;
use solaris_model::{FigureBuilder, Human, Joint, LinkSpec, Placement, Shape, ShapeKind};
use solaris_skin::{Detail, skin};

fn shaped(kind: ShapeKind) -> LinkSpec {
    let placement = Placement::translation(0.3, -0.2, 0.1);
    LinkSpec::root("thing", Joint::new("stands").rx()).mass(1.0).shape(Shape { kind, placement })
}

#[test]
fn shapes_have_their_own_volumes_less_what_facets_cut_off() {
    let kinds = [
        (ShapeKind::Box { size: Vector3::new(0.2, 0.4, 0.6) }, 1e-12),
        (ShapeKind::Cylinder { radius: 0.2, length: 0.5 }, 0.02),
        (ShapeKind::Capsule { radius: 0.2, length: 0.5 }, 0.03),
        (ShapeKind::Sphere { radius: 0.2 }, 0.04),
        (ShapeKind::Ellipsoid { radii: Vector3::new(0.1, 0.3, 0.2) }, 0.04),
    ];
    for (kind, off) in kinds {
        let figure = FigureBuilder::new("machine").link(shaped(kind)).build().expect("a figure");
        let skin = skin(&figure, Detail::Fine);
        let share = skin.volume() / kind.volume();
        assert!(share <= 1.0 + 1e-9 && share >= 1.0 - off - 1e-9, "{kind:?}: {share}");
        for (t, normal) in skin.triangles.iter().map(|t| (t, skin.normals[t[0] as usize])) {
            let [a, b, c] = t.map(|i| skin.points[i as usize]);
            let across = (b - a).cross(&(c - a));
            assert!(across.norm() > 1e-9 && across.dot(&normal) > 0.0, "{kind:?}: {a:?} {b:?} {c:?}");
        }
    }
}

#[test]
fn links_without_shape_have_nothing_and_nothing_fails() {
    let figure = FigureBuilder::new("bare")
        .link(LinkSpec::root("a", Joint::free("flies")).mass(1.0))
        .build()
        .expect("a figure");
    let skin = skin(&figure, Detail::Fine);
    assert!(skin.points.is_empty() && skin.bind.len() == 1);
}

#[test]
fn what_a_person_holds_is_as_its_shape_is() {
    let person = Human::new(1.75, 73.0);
    let figure = person.clone().cane("left").build().expect("a person with a cane");
    let (with, without) =
        (skin(&figure, Detail::Coarse), skin(&person.build().expect("a person"), Detail::Coarse));
    let (cane, own) = (figure.link_index("cane").expect("a cane"), without.points.len());
    assert_eq!(with.points[..own], without.points[..]);
    assert!(
        with.points.len() > own && with.influences[own..].iter().all(|at| usize::from(at[0].link) == cane)
    );
    assert!(
        with.influences[..own].iter().flatten().all(|at| at.share == 0.0 || usize::from(at.link) != cane)
    );
    // Nowhere farther from its axis than it is thick.
    let to_axis = |point: &Vector3<f64>| {
        let own = with.bind[cane].inverse_transform_point(&(*point).into());
        own.x.hypot(own.z)
    };
    let thick = with.points[own..].iter().map(to_axis).fold(0.0, f64::max);
    assert!((thick - 0.009).abs() < 1e-6, "{thick}");
}
