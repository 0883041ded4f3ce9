//! Masses that no matter has are told and not refused, and what moves is judged.

use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, MassDoubt, Vector3};

fn root(name: &str) -> LinkSpec {
    LinkSpec::root(name, Joint::new(format!("{name}_joint")).rx()).mass(1.0)
}

fn child(name: &str, parent: &str) -> LinkSpec {
    LinkSpec::child(name, parent, Joint::new(format!("{name}_joint")).rx()).mass(1.0)
}

fn welded(name: &str, parent: &str) -> LinkSpec {
    LinkSpec::child(name, parent, Joint::new(format!("{name}_joint"))).mass(1.0)
}

fn figure(links: impl IntoIterator<Item = LinkSpec>) -> Figure {
    links.into_iter().fold(FigureBuilder::new("f"), FigureBuilder::link).build().expect("a figure")
}

fn said(figure: &Figure) -> String {
    figure.mass_doubts().iter().map(|doubt| doubt.finding().to_string()).collect::<Vec<_>>().join("\n")
}

#[test]
fn every_doubt_says_what_and_what_it_means() {
    let all = [
        figure([root("a").inertia(Inertia::diagonal(1.0, 1.0, 3.0))]),
        figure([root("a").inertia(Inertia::diagonal(-1.0, 1.0, 1.0))]),
        figure([root("a"), child("b", "a").mass(0.0).inertia(Inertia::diagonal(1.0, 1.0, 1.0))]),
        figure([root("a"), child("b", "a").mass(0.0), child("c", "b").mass(0.0)]),
        figure([root("a").mass(0.0)]),
    ];
    let all: Vec<String> = all.iter().map(said).collect();
    insta::assert_snapshot!(all.join("\n"));
    // They are part of what lint says.
    assert!(figure([root("a").mass(0.0)]).lint().iter().any(|f| f.message.contains("moves link 'a'")));
}

/// Iz exceeds Ix + Iy by a share of itself.
fn excess(share: f64) -> Figure {
    figure([root("a").inertia(Inertia::diagonal(1.0, 1.0, 2.0 * (1.0 + share)))])
}

#[test]
fn what_printing_leaves_is_no_doubt() {
    assert_eq!(said(&excess(2e-7)), "");
    assert!(matches!(excess(1e-3).mass_doubts()[..], [MassDoubt::NotPhysical { relative, .. }]
        if (relative - 5e-4).abs() < 1e-6));
}

#[test]
fn what_is_welded_together_is_judged_together() {
    // A rod whose own numbers are impossible, beside a ball that makes up for it; and alone.
    let rod = |link: LinkSpec| link.inertia(Inertia::diagonal(0.1, 0.1, 0.3));
    let ball = welded("ball", "rod").inertia(Inertia::diagonal(1.0, 1.0, 1.0));
    assert_eq!(said(&figure([rod(root("rod")), ball.clone()])), "");
    assert_eq!(
        said(&figure([root("rod").inertia(Inertia::Point), rod(welded("ball", "rod"))])).lines().count(),
        1
    );
    // Two sound bodies, whose inertia without mass would be none on its own: 2 kg, 1 m apart, and a rotor.
    let rotor = welded("rotor", "arm").mass(0.0).inertia(Inertia::diagonal(0.1, 0.1, 0.1));
    let far = welded("load", "arm").com(Vector3::new(1.0, 0.0, 0.0));
    assert_eq!(said(&figure([root("arm"), rotor, far])), "");
    // A weld holds the parent's mass too: nothing without mass moves here.
    assert_eq!(said(&figure([root("a"), child("b", "a").mass(0.0), welded("c", "b")])), "");
}

#[test]
fn what_the_world_holds_is_not_judged() {
    let base = LinkSpec::root("base", Joint::new("weld")).inertia(Inertia::diagonal(1.0, 1.0, 9.0));
    let plate = welded("plate", "base").mass(0.0).inertia(Inertia::diagonal(1.0, 1.0, 9.0));
    assert_eq!(said(&figure([base, plate, child("arm", "base")])), "");
}

#[test]
fn an_armature_is_inertia_enough() {
    let rotor = |armature| LinkSpec::child("b", "a", Joint::new("j").rx().armature(armature));
    assert_eq!(said(&figure([root("a"), rotor(0.1)])), "");
    assert!(matches!(figure([root("a"), rotor(0.0)]).mass_doubts()[..], [MassDoubt::MovesNothing { .. }]));
    // The joint below has none.
    let below = figure([root("a"), rotor(0.1), child("c", "b").mass(0.0)]);
    assert!(
        matches!(&below.mass_doubts()[..], [MassDoubt::MovesNothing { joint, .. }] if joint == "c_joint")
    );
}

#[test]
fn inertia_without_mass_is_kept_in_what_is_fused() {
    let rotor = child("b", "a").mass(0.0).inertia(Inertia::diagonal(0.1, 0.2, 0.25));
    let whole = figure([root("a").mass(0.0).inertia(Inertia::diagonal(0.3, 0.3, 0.3)), rotor]);
    let fused = whole.fuse_named(&[("b_joint", 0.0)]).expect("a dof");
    let inertia = fused.figure().links()[0].inertia().diagonal();
    assert!((inertia - Vector3::new(0.4, 0.5, 0.55)).amax() < 1e-15, "{inertia}");
}
