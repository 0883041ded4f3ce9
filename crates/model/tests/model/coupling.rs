//! Degrees of freedom that follow others: their motion and forces, and what fusing and re-rooting make of them.

use super::poses::places;
use solaris_model::{Curve, Figure, FigureBuilder, FuseError, Inertia, Joint, LinkSpec, RootAt, Vector3};

/// Along x from −1 on, two pieces that meet in value, slope and curvature.
fn bent() -> Curve {
    Curve::Cubics { knots: vec![-1.0, 0.0, 2.0], pieces: vec![[0.5, -0.2, 0.3, 0.4], [1.0, 1.6, 1.5, -0.2]] }
}

/// A leg whose knee slides as it bends, with a kneecap that turns as the knee does.
fn leg() -> Figure {
    let knee = Joint::new("knee").at(Vector3::new(0.0, -0.4, 0.0));
    let knee = knee
        .ty()
        .following("knee.rz", bent().scaled(0.02))
        .rz()
        .tx()
        .following("knee.rz", Curve::Polynomial(vec![0.01, 0.03, -0.02]));
    FigureBuilder::new("leg")
        .link(
            LinkSpec::root("thigh", Joint::new("hip").rx().rz())
                .mass(7.0)
                .inertia(Inertia::diagonal(0.1, 0.05, 0.1)),
        )
        .link(
            LinkSpec::child("shank", "thigh", knee)
                .mass(3.0)
                .com(Vector3::new(0.0, -0.2, 0.0))
                .inertia(Inertia::diagonal(0.03, 0.01, 0.03)),
        )
        .link(
            LinkSpec::child(
                "patella",
                "thigh",
                Joint::new("patella")
                    .at(Vector3::new(0.05, -0.4, 0.0))
                    .rz()
                    .following("knee.rz", bent().scaled(0.3)),
            )
            .mass(0.1)
            .com(Vector3::new(0.0, -0.02, 0.0)),
        )
        .link(
            LinkSpec::child("foot", "shank", Joint::new("ankle").at(Vector3::new(0.0, -0.4, 0.0)).rz())
                .mass(1.0)
                .inertia(Inertia::diagonal(0.001, 0.001, 0.001)),
        )
        .build()
        .expect("a valid figure")
}

fn dof(figure: &Figure, name: &str) -> usize {
    figure.layout().dof_index(name).expect("a dof of the figure")
}

/// Positions of all followers at a time on a smooth path of the knee, through the knots of the curve.
fn on_path(figure: &Figure, t: f64) -> [Vec<f64>; 3] {
    let n = figure.layout().nv();
    let [mut q, mut v, mut a] = [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
    let knee = dof(figure, "knee.rz");
    (q[knee], v[knee], a[knee]) = (0.3 + 1.5 * t.sin(), 1.5 * t.cos(), -1.5 * t.sin());
    figure.follow(&mut q, &mut v, &mut a);
    [q, v, a]
}

#[test]
fn followers_move_as_the_differences_of_their_places_say() {
    let figure = leg();
    assert_eq!(figure.followers().len(), 3);
    let h = 1e-4;
    for step in 0..40 {
        let t = 0.17 * f64::from(step);
        let [before, at, after] = [t - h, t, t + h].map(|t| on_path(&figure, t));
        for follower in figure.followers() {
            let k = follower.dof;
            let rate = (after[0][k] - before[0][k]) / (2.0 * h);
            let second = (after[1][k] - before[1][k]) / (2.0 * h);
            assert!((at[1][k] - rate).abs() < 1e-6, "{t} s: {} {rate}", at[1][k]);
            // The curve's third derivative jumps at a knot, and its second at the first one.
            let knot = follower.curve != bent().scaled(0.02) && follower.curve != bent().scaled(0.3);
            let near = |x: f64| (x + 1.0).abs() < 1e-3;
            if knot || !near(at[0][follower.leader]) {
                assert!((at[2][k] - second).abs() < 1e-5, "{t} s: {} {second}", at[2][k]);
            }
        }
        assert!(figure.follows(figure.followers()[0].dof) && !figure.follows(dof(&figure, "knee.rz")));
    }
}

#[test]
fn folded_forces_are_the_slope_of_the_energy_along_the_path() {
    let figure = leg();
    let n = figure.layout().nv();
    // V(q) = ½ Σ w·(q_i − c_i)², whose slope along q_i is w·(q_i − c_i).
    let slope = |q: &[f64]| -> Vec<f64> {
        q.iter().enumerate().map(|(i, q)| (1.0 + i as f64) * (q - 0.1 * i as f64)).collect()
    };
    let energy = |q: &[f64]| -> f64 {
        q.iter().enumerate().map(|(i, q)| 0.5 * (1.0 + i as f64) * (q - 0.1 * i as f64).powi(2)).sum()
    };
    let knee = dof(&figure, "knee.rz");
    for x in [-2.0, -0.6, 0.0, 0.7, 1.9, 2.6] {
        let at = |x: f64| {
            let mut q = vec![0.05; n];
            q[knee] = x;
            figure.follow(&mut q, &mut vec![0.0; n], &mut vec![0.0; n]);
            q
        };
        let mut tau = slope(&at(x));
        let others = [tau[0], tau[1]];
        figure.fold_forces(&at(x), &mut tau);
        let h = 1e-6;
        let expected = (energy(&at(x + h)) - energy(&at(x - h))) / (2.0 * h);
        assert!(
            (tau[knee] - expected).abs() < 1e-7 * expected.abs().max(1.0),
            "at {x}: {} {expected}",
            tau[knee]
        );
        assert!(figure.followers().iter().all(|follower| tau[follower.dof].to_bits() == 0));
        assert_eq!([tau[0], tau[1]].map(f64::to_bits), others.map(f64::to_bits));
    }
}

#[test]
fn a_leader_that_is_fused_takes_its_followers_along() {
    let figure = leg();
    let fused = figure.fuse_named(&[("knee.rz", 0.7)]).expect("a leader");
    let small = fused.figure();
    assert_eq!(small.layout().v_names(), ["hip.rx", "hip.rz", "ankle.rz"]);
    assert!(small.followers().is_empty());
    let mut q = vec![0.3, -0.2, 0.0, 0.7, 0.0, 0.0, 0.4];
    figure.follow(&mut q, &mut [0.0; 7], &mut [0.0; 7]);
    let [full, of_small] = [places(&figure, &q), places(small, &[0.3, -0.2, 0.4])];
    for (link, place) in fused.links().iter().enumerate() {
        let here = of_small[place.link] * place.placement;
        assert!((here.translation.vector - full[link].translation.vector).amax() < 1e-14, "link {link}");
        assert!(here.rotation.angle_to(&full[link].rotation) < 1e-7);
    }
    // The same at a configuration in which the followers stand elsewhere: they go where the leader puts them.
    let knee = dof(&figure, "knee.rz");
    let fused_at = figure.fuse_at(&[knee], &[0.3, -0.2, 9.0, 0.7, 9.0, 9.0, 0.4]).expect("a leader");
    assert_eq!(fused_at.figure().fingerprint(), small.fingerprint());
}

#[test]
fn a_follower_alone_cannot_be_fused() {
    let figure = leg();
    let error = figure.fuse_named(&[("patella", 0.1)]).expect_err("a follower");
    insta::assert_snapshot!(error, @"dof 'patella.rz' follows 'knee.rz', so it cannot stand still alone; fuse 'knee.rz', and it comes along");
    let slide = dof(&figure, "knee.tx");
    let error = figure.fuse_at(&[slide, 0], &[0.0; 7]).expect_err("a follower");
    assert!(matches!(error, FuseError::Follower { .. }));
    // Fusing others leaves the followers what they are.
    let fused = figure.fuse_named(&[("hip.rx", 0.2), ("ankle", 0.1)]).expect("no leaders");
    let [small, full] = [fused.figure(), &figure].map(|figure| {
        figure
            .followers()
            .iter()
            .map(|follower| {
                let names = figure.layout().v_names();
                (names[follower.dof].clone(), names[follower.leader].clone(), follower.curve.clone())
            })
            .collect::<Vec<_>>()
    });
    assert_eq!(small, full);
}

#[test]
fn another_root_keeps_followers_and_leaders() {
    let figure = leg();
    let mut q = vec![0.0, 0.0, 0.0, 0.7, 0.0, 0.0, 0.4];
    figure.follow(&mut q, &mut [0.0; 7], &mut [0.0; 7]);
    let declared = places(&figure, &q);
    for root in ["foot", "patella"] {
        let view = figure.reroot_named(root, RootAt::Joint).expect("massive links");
        let seen = view.figure();
        assert_eq!(seen.followers().len(), 3, "{root}");
        let (nq, nv) = (seen.layout().nq(), seen.layout().nv());
        let mut there = vec![0.0; nq];
        there[6] = 1.0;
        for name in ["knee.rz", "ankle.rz"] {
            let coordinate = |figure: &Figure| figure.layout().coordinate(dof(figure, name)).expect("a turn");
            there[coordinate(seen)] = q[coordinate(&figure)];
        }
        seen.follow(&mut there, &mut vec![0.0; nv], &mut vec![0.0; nv]);
        for follower in figure.followers() {
            let name = &figure.layout().v_names()[follower.dof];
            let coordinate = seen.layout().coordinate(dof(seen, name)).expect("one axis");
            assert_eq!(there[coordinate].to_bits(), q[follower.coordinate].to_bits(), "{name}");
        }
        // Links stand against each other as they do in the declared figure; the view's root is welded, so to say, at zero.
        let welded = seen.fuse_at(&[0, 1, 2, 3, 4, 5], &there).expect("the free joint as a whole");
        let on_view = places(welded.figure(), &there[7..]);
        let here = |link: usize| {
            let place = view.links()[link];
            on_view[place.link] * place.placement
        };
        for (link, place) in declared.iter().enumerate() {
            let [one, two] = [declared[0].inverse() * place, here(0).inverse() * here(link)];
            assert!((one.translation.vector - two.translation.vector).amax() < 1e-14, "{root}: link {link}");
            assert!(one.rotation.angle_to(&two.rotation) < 1e-7, "{root}: link {link}");
        }
    }
}

#[test]
fn what_follows_the_roots_joint_keeps_the_root() {
    let wire = Joint::new("wire").tx().ty().following("wire.tx", Curve::Polynomial(vec![0.0, 0.0, 1.0]));
    let figure = FigureBuilder::new("beads")
        .link(LinkSpec::root("bead", wire).mass(1.0))
        .link(LinkSpec::child("bob", "bead", Joint::new("string").rx()).mass(1.0).com(-Vector3::y()))
        .build()
        .expect("valid");
    let error = figure.reroot_named("bob", RootAt::Joint).expect_err("a follower without its leader");
    assert!(
        error.to_string().starts_with("dof 'wire.ty' follows 'wire.tx', and one of them belongs"),
        "{error}"
    );
}
