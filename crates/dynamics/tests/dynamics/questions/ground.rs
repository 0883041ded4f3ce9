//! The ground's acceleration in closed form, against the pass that it saves and the dense equations.

use crate::questions::case::{Case, difference};
use crate::support::Kernel;
use crate::support::random::{Random, tree};
use nalgebra::{DVector, Vector3};
use proptest::prelude::*;
use solaris_dynamics::{DynamicsError, Twist, accelerations, ground_acceleration};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec};

/// The root's joint: three translations in any directions and up to three turns, or a free joint.
fn root(random: &mut Random, armature: f64) -> Joint {
    let placed = random.placement();
    if random.below(3) == 0 {
        return Joint::free("root").armature(armature).placed(placed);
    }
    let mut joint = Joint::new("root").placed(placed);
    let skew = if random.below(2) == 0 { 0.0 } else { 0.3 };
    for i in 0..3 {
        let direction = Vector3::ith((i + random.below(1)) % 3, 1.0) + random.vector(skew);
        joint = joint.axis(Axis::translation(direction)).armature(armature);
    }
    (0..random.below(4)).fold(joint, |joint, _| joint.axis(Axis::rotation(random.vector(1.0))))
}

/// A random tree on such a root.
fn figure(random: &mut Random, armature: f64) -> Figure {
    let links = 1 + random.below(6);
    let branch = tree(random, links, 0.5);
    let trunk = LinkSpec::root("trunk", root(random, armature)).mass(3.0).com(random.vector(0.3));
    branch
        .links()
        .iter()
        .fold(FigureBuilder::new("walker").link(trunk), |builder, link| {
            let parent = link.parent().map_or("trunk", |parent| branch.links()[parent].name());
            let child = LinkSpec::child(link.name(), parent, link.joint().clone());
            let massive = child.clone().mass(link.mass()).com(*link.com());
            builder.link(if link.mass() > 0.0 {
                massive.inertia(Inertia::Tensor(*link.inertia()))
            } else {
                child
            })
        })
        .build()
        .expect("a valid figure")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// The root accelerates as the force asks, and the forces are those of the whole motion.
    #[test]
    fn one_pass_is_as_good_as_two(seed in any::<u64>(), loaded in any::<bool>(), armed in any::<bool>()) {
        let mut random = Random::new(seed);
        let figure = figure(&mut random, if armed { 0.4 } else { 0.0 });
        let (gravity, force) = (random.vector(10.0), random.vector(100.0));
        let mut case = Case::of(figure, gravity, random);
        if !loaded {
            case.external.clear();
        }
        let (mut a, mut tau) = (case.a.clone(), vec![f64::NAN; case.nv()]);
        a[..3].fill(f64::NAN); // not read
        let Kernel { tree, workspace } = &mut case.kernel;
        let (q, v) = (&case.q, &case.v);
        ground_acceleration(tree, workspace, q, v, &mut a, &case.external, &force, &mut tau).expect("valid");
        prop_assert_eq!(&a[3..], &case.a[3..]);

        let whole = case.kernel.inverse(&case.q, &case.v, &a, &case.external).expect("valid");
        let error = difference(&DVector::from_row_slice(&tau), &DVector::from_vec(whole), 1.0);
        prop_assert!(error < 1e-12, "{error:e}");
        let base = case.kernel.workspace.base_wrench().force;
        prop_assert!((base - force).amax() < 1e-11 * (1.0 + tau.iter().fold(0.0, |s: f64, t| s.max(t.abs()))), "{base} {force}");

        // Newton's law of the whole: m·c̈ = m·g + force + external wrenches.
        accelerations(&case.kernel.tree, &mut case.kernel.workspace, &case.q, &case.v, &a).expect("valid");
        let mut rate = Vector3::zeros();
        for (i, link) in case.figure.links().iter().enumerate() {
            let ws = &case.kernel.workspace;
            let arm = ws.pose(i).rotation * link.com();
            let (spin, Twist { linear, angular }) = (ws.velocity(i).angular, ws.acceleration(i));
            rate += (linear + angular.cross(&arm) + spin.cross(&spin.cross(&arm))) * link.mass();
        }
        let acting = case.external.iter().fold(force + gravity * case.figure.mass(), |sum, (_, w)| sum + w.force);
        prop_assert!((rate - acting).amax() < 1e-11 * (1.0 + acting.amax()) * 10.0, "{rate} {acting}");
    }
}

/// It is hybrid dynamics with the root's translations free.
#[test]
fn the_closed_form_is_hybrid_dynamics() {
    let figure = solaris_model::human(1.75, 73.0).expect("within range");
    let gravity = Vector3::new(0.0, -9.80665, 0.0);
    let mut case = Case::of(figure, gravity, Random::new(5));
    let force = Vector3::new(30.0, 700.0, -80.0);
    let (mut a, mut tau) = (case.a.clone(), vec![f64::NAN; case.nv()]);
    let Kernel { tree, workspace } = &mut case.kernel;
    let (q, v) = (&case.q, &case.v);
    ground_acceleration(tree, workspace, q, v, &mut a, &case.external, &force, &mut tau).expect("valid");
    let prescribed: Vec<bool> = (0..case.nv()).map(|k| k >= 3).collect();
    // The root slides along x, y, z.
    let given: Vec<f64> = force.iter().copied().chain(std::iter::repeat_n(f64::NAN, case.nv() - 3)).collect();
    let state = [case.q.as_slice(), &case.v];
    let [there, forces] =
        case.kernel.hybrid(state, &prescribed, [&case.a, &given], &case.external).expect("valid");
    assert!(crate::support::relative_error(&a, &there) < 1e-12);
    assert!(crate::support::relative_error(&tau, &forces) < 1e-12);
}

#[test]
fn a_root_that_the_ground_cannot_push_is_refused() {
    let of = |joint: Joint| {
        let figure =
            FigureBuilder::new("f").link(LinkSpec::root("cart", joint).mass(1.0)).build().expect("valid");
        let mut kernel = Kernel::<f64>::new(&figure, Vector3::zeros());
        let (n, nq) = (figure.layout().nv(), figure.layout().nq());
        let mut q = vec![0.0; nq];
        figure.neutral(&mut q).expect("its own length");
        let (v, mut a, mut tau) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        let Kernel { tree, workspace } = &mut kernel;
        ground_acceleration(tree, workspace, &q, &v, &mut a, &[], &Vector3::zeros(), &mut tau)
    };
    let leaning = |z: Vector3<f64>| Joint::new("j").tx().ty().axis(Axis::translation(z)).rz();
    let refused = Err(DynamicsError::Root { link: "cart".to_owned() });
    assert_eq!(of(Joint::new("j").tx().ty()), refused);
    assert_eq!(of(Joint::new("j").rx().ry().rz()), refused);
    assert_eq!(of(Joint::ball("j")), refused);
    assert_eq!(of(leaning(Vector3::new(1.0, 1.0, 0.0))), refused);
    assert_eq!(of(leaning(Vector3::new(1.0, 1.0, 1.0))), Ok(()));
    assert_eq!(of(Joint::free("j")), Ok(()));
    let message = of(Joint::new("j").rx()).expect_err("refused").to_string();
    assert!(message.starts_with("the root 'cart' does not begin with three translations"), "{message}");
}
