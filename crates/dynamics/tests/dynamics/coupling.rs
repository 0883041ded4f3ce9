//! Degrees of freedom that follow others.

use solaris_dynamics::{
    Coupling, DMatrix, DynamicsError, Tree, Workspace, forward_dynamics, inverse_mass_matrix, kinetic_energy,
    potential_energy,
};
use solaris_model::{Curve, Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// A thigh and a shank whose knee moves along cubic curves as it bends, with a turn that follows too.
fn leg() -> Figure {
    let slide = |a: f64, b: f64| Curve::Cubics {
        knots: vec![-2.0, -0.5, 1.0],
        pieces: vec![[a, 0.01, 0.02, -0.01], [b, -0.03, 0.015, 0.004]],
    };
    let knee =
        Joint::new("knee").at(Vector3::new(0.0, -0.42, 0.0)).tx().following("knee_angle", slide(0.0, 0.02));
    let knee = knee.ty().following("knee_angle", slide(-0.01, 0.005)).rz().named("knee_angle").ry();
    let knee = knee.following("knee_angle", Curve::Polynomial(vec![0.1, 0.2, -0.3]));
    let link = |link: LinkSpec, mass: f64| {
        link.mass(mass).com(Vector3::new(0.01, -0.2, 0.02)).inertia(Inertia::diagonal(0.12, 0.02, 0.11))
    };
    FigureBuilder::new("leg")
        .link(link(LinkSpec::root("thigh", Joint::new("hip").rz().ry().rx()), 8.0))
        .link(link(LinkSpec::child("shank", "thigh", knee), 4.0))
        .build()
        .expect("valid")
}

#[test]
fn forward_undoes_inverse() {
    let figure = leg();
    let tree = Tree::new(&figure, GRAVITY).expect("a tree");
    let (mut workspace, mut coupling) = (Workspace::new(&tree), Coupling::new(&figure));
    assert_eq!(coupling.free(), [0, 1, 2, 5]);
    for i in 0..20 {
        let wave = |k: usize, f: f64| (f * (i * 7 + k) as f64).sin();
        let q: Vec<f64> = (0..7).map(|k| wave(k, 1.3)).collect();
        let v: Vec<f64> = (0..7).map(|k| 3.0 * wave(k, 2.1)).collect();
        let a: Vec<f64> = (0..7).map(|k| 20.0 * wave(k, 0.7)).collect();
        let (mut tau, mut back) = ([0.0; 7], [0.0; 7]);
        coupling.inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau).expect("forces");
        assert!([tau[3], tau[4], tau[6]].iter().all(|tau| tau.to_bits() == 0));
        coupling.forward_dynamics(&tree, &mut workspace, &q, &v, &tau, &[], &mut back).expect("a motion");
        for &dof in coupling.free() {
            assert!((back[dof] - a[dof]).abs() < 1e-11 * 20.0, "{} is not {}", back[dof], a[dof]);
        }
        // The followers' accelerations are the second differences along the motion.
        let (h, path) = (1e-4, |t: f64| q[5] + t * v[5] + t * t / 2.0 * a[5]);
        for f in figure.followers() {
            let at = |t: f64| f.curve.at(path(t))[0];
            let second = (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h);
            assert!(
                (back[f.dof] - second).abs() < 2e-5 * (1.0 + second.abs()),
                "{} is not {second}",
                back[f.dof]
            );
        }
    }
}

/// A bead of mass m on the parabola y = x² slides as `(1 + 4x²)·ẍ + 4x·ẋ² + 2·g·x = 0` says.
#[test]
fn a_bead_slides_along_its_parabola() {
    let joint = Joint::new("wire").tx().ty().following("wire.tx", Curve::Polynomial(vec![0.0, 0.0, 1.0]));
    let figure =
        FigureBuilder::new("bead").link(LinkSpec::root("bead", joint).mass(0.3)).build().expect("valid");
    let tree = Tree::new(&figure, GRAVITY).expect("a tree");
    let (mut workspace, mut coupling) = (Workspace::new(&tree), Coupling::new(&figure));
    for (x, rate) in [(0.0, 2.0), (0.7, -1.5), (-3.0, 0.0), (1e-9, 1e3)] {
        let mut a = [0.0; 2];
        coupling
            .forward_dynamics(&tree, &mut workspace, &[x, 9.0], &[rate, 9.0], &[0.0, 9.0], &[], &mut a)
            .expect("a motion");
        let exact = -(4.0 * x * rate * rate + 2.0 * 9.806_65 * x) / (1.0 + 4.0 * x * x);
        assert!((a[0] - exact).abs() <= 1e-13 * (1.0 + exact.abs()), "{} is not {exact}", a[0]);
        assert!((a[1] - (2.0 * x * a[0] + 2.0 * rate * rate)).abs() <= 1e-13 * (1.0 + a[1].abs()));
    }
}

/// The forces are those of Lagrange, `d/dt ∂L/∂ẋ − ∂L/∂x`, with the energies taken along the bound motion.
#[test]
fn inverse_dynamics_is_lagranges() {
    let figure = leg();
    let tree = Tree::new(&figure, GRAVITY).expect("a tree");
    let (mut workspace, mut coupling) = (Workspace::new(&tree), Coupling::new(&figure));
    let mut lagrangian = |q: &[f64], v: &[f64]| {
        let (mut q, mut v, mut a) = (q.to_vec(), v.to_vec(), vec![0.0; 7]);
        figure.follow(&mut q, &mut v, &mut a);
        kinetic_energy(&tree, &mut workspace, &q, &v).expect("energy")
            - potential_energy(&tree, &mut workspace, &q).expect("energy")
    };
    let (q, v, a) = (
        [0.3, -0.4, 0.2, 0.0, 0.0, -0.8, 0.0],
        [1.0, 0.5, -2.0, 0.0, 0.0, 3.0, 0.0],
        [4.0, -3.0, 2.0, 0.0, 0.0, -5.0, 0.0],
    );
    let free = coupling.free().to_vec();
    let shifted = |x: &[f64; 7], k: usize, by: f64| {
        let mut y = *x;
        y[k] += by;
        y
    };
    let along = |t: f64| -> ([f64; 7], [f64; 7]) {
        (
            std::array::from_fn(|k| q[k] + t * v[k] + t * t / 2.0 * a[k]),
            std::array::from_fn(|k| v[k] + t * a[k]),
        )
    };
    let h = 1e-4;
    let mut expected = [0.0; 7];
    for &k in &free {
        let mut momentum = |t: f64| {
            let (q, v) = along(t);
            (lagrangian(&q, &shifted(&v, k, h)) - lagrangian(&q, &shifted(&v, k, -h))) / (2.0 * h)
        };
        let rate = (momentum(h) - momentum(-h)) / (2.0 * h);
        let slope = (lagrangian(&shifted(&q, k, h), &v) - lagrangian(&shifted(&q, k, -h), &v)) / (2.0 * h);
        expected[k] = rate - slope;
    }
    let mut tau = [0.0; 7];
    let mut workspace = Workspace::new(&tree);
    coupling.inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau).expect("forces");
    for k in 0..7 {
        assert!((tau[k] - expected[k]).abs() < 1e-5, "dof {k}: {} is not {}", tau[k], expected[k]);
    }
}

#[test]
fn what_is_bound_is_not_accelerated_as_if_it_were_free() {
    let figure = leg();
    let tree = Tree::new(&figure, GRAVITY).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut a = [0.0; 7];
    let refused = [
        forward_dynamics(&tree, &mut workspace, &[0.0; 7], &[0.0; 7], &[0.0; 7], &[], &mut a),
        inverse_mass_matrix(&tree, &mut workspace, &[0.0; 7], &mut DMatrix::zeros(7, 7)),
    ];
    for error in refused {
        let error = error.expect_err("bound");
        assert!(matches!(error, DynamicsError::Follower { .. }));
        assert!(error.to_string().starts_with("dof 'knee.tx' follows 'knee_angle'"), "{error}");
    }
    let mut coupling = Coupling::new(&figure);
    let error = coupling
        .forward_dynamics(&tree, &mut workspace, &[0.0; 7], &[0.0; 7], &[f64::NAN; 7], &[], &mut a)
        .expect_err("no force");
    assert_eq!(error.to_string(), "tau of dof 'hip.rz' is NaN; it must be a finite number");
}

/// Who is refused, with what inertia is left for it: an arm of 1 kg, this hand on it, and a nail that follows the shoulder.
fn refused(hand: LinkSpec) -> (String, f64) {
    let arm = LinkSpec::root("arm", Joint::new("shoulder").rz()).mass(1.0).com(Vector3::new(0.5, 0.0, 0.0));
    let tip = Joint::new("tip").rx().following("shoulder", Curve::linear(1.0, 0.0));
    let figure = [arm, hand, LinkSpec::child("nail", "hand", tip)]
        .into_iter()
        .fold(FigureBuilder::new("f"), FigureBuilder::link)
        .build()
        .expect("a figure");
    let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("finite");
    let (mut workspace, mut coupling) = (Workspace::new(&tree), Coupling::new(&figure));
    let zero = [0.0; 3];
    let error = coupling
        .forward_dynamics(&tree, &mut workspace, &zero, &zero, &zero, &[], &mut [0.0; 3])
        .expect_err("not positive");
    let DynamicsError::NoInertia { dof, inertia } = error else { panic!("{error}") };
    (dof, inertia)
}

/// A mass matrix that is not positive is refused by the first degree of freedom that shows it, with what is left for it.
#[test]
fn an_inertia_below_zero_is_refused_by_name() {
    let hand = LinkSpec::child("hand", "arm", Joint::new("wrist").rz());
    let (dof, inertia) = refused(hand.inertia(Inertia::diagonal(1.0, 1.0, -2.0)));
    assert_eq!(dof, "shoulder.rz");
    assert!((inertia - (0.25 - 2.0)).abs() < 1e-14, "{inertia}");
}

/// The same where the matrix' diagonal is above zero, and what is left of it once the shoulder is taken out is not.
#[test]
fn an_inertia_that_is_missing_further_out_is_refused_by_that_name() {
    let hand = LinkSpec::child("hand", "arm", Joint::new("wrist").at(Vector3::x()).rz());
    let hand = hand.mass(1.0).com(Vector3::new(0.5, 0.0, 0.0));
    let (dof, inertia) = refused(hand.inertia(Inertia::diagonal(1.0, 1.0, -0.2)));
    assert_eq!(dof, "wrist.rz");
    // M = [2.3 0.55; 0.55 0.05]: m·l² of both, less 0.2.
    assert!((inertia - (0.05 - 0.55 * 0.55 / 2.3)).abs() < 1e-14, "{inertia}");
}
