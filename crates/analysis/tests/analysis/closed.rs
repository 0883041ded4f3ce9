//! Joint forces with loops closed: a four-bar linkage that is a parallelogram, in closed form.

use approx::assert_relative_eq;
use solaris_analysis::{ClosedError, closed_forces};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Tie, TieEnd, TieLaw, Vector3};

const G: f64 = 9.81;

/// A uniform rod of 1 kg and 0.5 m, down from its joint.
fn rod(link: LinkSpec) -> LinkSpec {
    let across = 0.25 / 12.0;
    link.mass(1.0).com(Vector3::y() * -0.25).inertia(Inertia::diagonal(across, 1e-3 * across, across))
}

/// Two such rods for cranks, 0.8 m apart, with a coupler of 2 kg between their ends; open where the coupler meets the second.
fn four_bar() -> (Figure, [Tie; 1]) {
    let coupler = LinkSpec::child("coupler", "first", Joint::new("coupler").at(Vector3::y() * -0.5).rz());
    let figure = FigureBuilder::new("four-bar")
        .link(LinkSpec::root("frame", Joint::new("frame")).mass(1.0))
        .link(rod(LinkSpec::child("first", "frame", Joint::new("first").rz())))
        .link(coupler.mass(2.0).com(Vector3::x() * 0.4).inertia(Inertia::diagonal(1e-4, 0.1, 0.1)))
        .link(rod(LinkSpec::child("second", "frame", Joint::new("second").at(Vector3::x() * 0.8).rz())))
        .build()
        .expect("valid");
    let end = |link: &str, point| TieEnd { link: Some(link.to_owned()), point };
    let between = [end("coupler", Vector3::x() * 0.8), end("second", Vector3::y() * -0.5)];
    (figure, [Tie { name: "closing".to_owned(), between, law: TieLaw::Points }])
}

/// `τ = (2m/3 + M)·L²·α + (m + M)·g·L·sin θ` for cranks `m`, a coupler `M` and the length `L` of the cranks.
fn needed(angle: f64, acceleration: f64) -> f64 {
    (2.0 / 3.0 + 2.0) * 0.25 * acceleration + 3.0 * G * 0.5 * angle.sin()
}

fn state(angle: f64, rate: f64, acceleration: f64) -> [Vec<f64>; 3] {
    [angle, rate, acceleration].map(|x| vec![x, -x, x])
}

#[test]
fn a_crank_alone_bears_what_the_whole_linkage_needs() {
    let (figure, ties) = four_bar();
    for (angle, rate, acceleration) in [(0.0, 0.0, 0.0), (0.7, 2.0, -3.0), (-1.2, -4.0, 10.0)] {
        let [q, v, a] = state(angle, rate, acceleration);
        let needed = needed(angle, acceleration);
        for (driven, sign) in
            [([true, false, false], 1.0), ([false, true, false], -1.0), ([false, false, true], 1.0)]
        {
            let found =
                closed_forces(&figure, Vector3::y() * -G, &ties, &driven, [&q, &v, &a]).expect("forces");
            let expected: Vec<f64> = driven.iter().map(|is| if *is { sign * needed } else { 0.0 }).collect();
            for (found, expected) in found.tau.iter().zip(&expected) {
                assert_relative_eq!(*found, *expected, epsilon = 1e-9);
            }
        }
    }
}

/// What all bear together with the least sum of squares is along the one motion that there is; loops do no work (d'Alembert).
#[test]
fn all_joints_share_it_with_the_least_force() {
    let (figure, ties) = four_bar();
    let [q, v, a] = state(0.7, 2.0, -3.0);
    let found = closed_forces(&figure, Vector3::y() * -G, &ties, &[true; 3], [&q, &v, &a]).expect("forces");
    let needed = needed(0.7, -3.0);
    for (found, sign) in found.tau.iter().zip([1.0, -1.0, 1.0]) {
        assert_relative_eq!(*found, sign * needed / 3.0, epsilon = 1e-9);
    }
    let power: f64 = found.tau.iter().zip(&v).map(|(tau, v)| tau * v).sum();
    assert_relative_eq!(power, needed * 2.0, epsilon = 1e-9);
}

/// Where two of three are driven the third bears nothing, and the two have the least sum of squares all the same.
#[test]
fn two_joints_of_three_share_it_with_the_least_force() {
    let (figure, ties) = four_bar();
    let [q, v, a] = state(0.7, 2.0, -3.0);
    let needed = needed(0.7, -3.0);
    for idle in 0..3 {
        let driven: Vec<bool> = (0..3).map(|dof| dof != idle).collect();
        let found = closed_forces(&figure, Vector3::y() * -G, &ties, &driven, [&q, &v, &a]).expect("forces");
        for (dof, sign) in [1.0, -1.0, 1.0].into_iter().enumerate() {
            let expected = if dof == idle { 0.0 } else { sign * needed / 2.0 };
            assert_relative_eq!(found.tau[dof], expected, epsilon = 1e-9);
        }
    }
}

/// At rest with the cranks upright on one side: the force in the loop carries half of the coupler, and nothing across the plane.
#[test]
fn the_loop_bears_its_share_of_the_weight() {
    let (figure, ties) = four_bar();
    let [q, v, a] = state(0.0, 0.0, 0.0);
    let found = closed_forces(&figure, Vector3::y() * -G, &ties, &[true, false, false], [&q, &v, &a])
        .expect("forces");
    assert_relative_eq!(found.held[0][0], Vector3::new(0.0, G, 0.0), epsilon = 1e-9);
}

#[test]
fn what_has_no_answer_is_refused_by_name() {
    let (figure, ties) = four_bar();
    let refused = |ties: &[Tie], driven: &[bool], v: [f64; 3]| {
        let [q, _, a] = state(0.7, 0.0, 0.0);
        closed_forces(&figure, Vector3::y() * -G, ties, driven, [&q, &v, &a]).expect_err("refused")
    };
    let open = refused(&ties, &[true; 3], [1.0, 0.0, 0.0]);
    assert!(matches!(&open, ClosedError::Opens { tie, .. } if tie == "closing"), "{open}");
    let idle = refused(&ties, &[false; 3], [0.0; 3]);
    assert!(matches!(&idle, ClosedError::Undriven { .. }), "{idle}");
    assert!(matches!(refused(&ties, &[true; 2], [0.0; 3]), ClosedError::Driven { found: 2, expected: 3 }));
    let mut other = ties.clone();
    other[0].between[0].link = Some("copler".to_owned());
    assert_eq!(
        refused(&other, &[true; 3], [0.0; 3]).to_string(),
        "the tie 'closing' holds a link 'copler', which the figure does not have"
    );
    other[0].law = TieLaw::Other("<joint>".to_owned());
    assert!(matches!(refused(&other, &[true; 3], [0.0; 3]), ClosedError::NotPoints { .. }));
}
