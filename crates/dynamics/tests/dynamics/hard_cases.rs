//! Figures that break careless recursions: long chains, welds, repeated axes, and figures far from the origin.

use crate::support::random::Random;
use crate::support::{Kernel, largest, relative_error};
use nalgebra::{DMatrix, DVector, Rotation2, Vector2, Vector3};
use solaris_dynamics::{Derivatives, inverse_dynamics};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec, human};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// Links of 2 kg and 0.3 m along x that all turn about z.
fn planar_chain(links: usize) -> Figure {
    let mut builder = FigureBuilder::new("chain");
    for i in 0..links {
        let joint = Joint::new(format!("j{i}")).rz();
        let link = match i.checked_sub(1) {
            None => LinkSpec::root("l0", joint),
            Some(parent) => {
                LinkSpec::child(format!("l{i}"), format!("l{parent}"), joint.at(Vector3::new(0.3, 0.0, 0.0)))
            }
        };
        let link =
            link.mass(2.0).com(Vector3::new(0.15, 0.02, 0.0)).inertia(Inertia::diagonal(0.01, 0.02, 0.02));
        builder = builder.link(link);
    }
    builder.build().expect("a valid figure")
}

/// The torques of such a chain by plane geometry: moments of `m·(c̈ − g)` about each joint, and spins.
fn planar_torques(q: &[f64], v: &[f64], a: &[f64]) -> Vec<f64> {
    let cross = |a: &Vector2<f64>, b: &Vector2<f64>| a.x * b.y - a.y * b.x;
    let (mut angle, mut rate, mut turn, mut joint, mut joint_acceleration) =
        (0.0, 0.0, 0.0, Vector2::zeros(), Vector2::zeros());
    let (mut joints, mut centers, mut forces, mut spins) = (vec![], vec![], vec![], vec![]);
    for k in 0..q.len() {
        (angle, rate, turn) = (angle + q[k], rate + v[k], turn + a[k]);
        let acceleration = |r: &Vector2<f64>| Vector2::new(-r.y, r.x) * turn - r * rate * rate;
        let along = |x: f64, y: f64| Rotation2::new(angle) * Vector2::new(x, y);
        let (center, end) = (along(0.15, 0.02), along(0.3, 0.0));
        joints.push(joint);
        centers.push(joint + center);
        forces.push((joint_acceleration + acceleration(&center) - GRAVITY.xy()) * 2.0);
        spins.push(0.02 * turn);
        joint_acceleration += acceleration(&end);
        joint += end;
    }
    (0..q.len())
        .map(|k| (k..q.len()).map(|i| cross(&(centers[i] - joints[k]), &forces[i]) + spins[i]).sum())
        .collect()
}

/// The greatest difference of two matrices over the greatest entry.
fn apart(a: &DMatrix<f64>, b: &DMatrix<f64>) -> f64 {
    (a - b).amax() / b.amax().max(f64::MIN_POSITIVE)
}

/// In closed form and through dual numbers: a chain of 100 links, and one whose masses differ by a million from link to link.
#[test]
fn derivatives_of_long_and_uneven_chains_agree() {
    let uneven = {
        let mut builder = FigureBuilder::new("uneven");
        for i in 0..12 {
            let joint = Joint::new(format!("j{i}")).axis(Axis::rotation(Vector3::ith(i % 3, 1.0)));
            let link = match i.checked_sub(1) {
                None => LinkSpec::root("l0", joint),
                Some(parent) => {
                    let at = Vector3::new(0.0, -0.3, 0.1);
                    LinkSpec::child(format!("l{i}"), format!("l{parent}"), joint.at(at))
                }
            };
            let mass = if i % 2 == 0 { 1e3 } else { 1e-3 };
            let com = Vector3::new(0.05, -0.1, 0.02);
            builder = builder.link(link.mass(mass).com(com).inertia(Inertia::diagonal(0.01, 0.02, 0.02)));
        }
        builder.build().expect("a valid figure")
    };
    for (figure, limit) in [(planar_chain(100), 1e-12), (uneven, 1e-12)] {
        let n = figure.layout().nv();
        let mut random = Random::new(n as u64);
        let (q, v, a) = (random.slice(n, 0.7), random.slice(n, 2.0), random.slice(n, 5.0));
        let mut derivatives = Derivatives::new(&figure, GRAVITY).expect("finite constants");
        let closed = derivatives.inverse_dynamics(&q, &v, &a, &[]).expect("valid").clone();
        let dual = derivatives.of(inverse_dynamics, &q, &v, &a, &[]).expect("valid");
        for (closed, dual) in
            [(&closed.by_q, &dual.by_q), (&closed.by_v, &dual.by_v), (&closed.by_input, &dual.by_input)]
        {
            let error = apart(closed, dual);
            assert!(error < limit, "{n} dofs: {error:e}");
        }
    }
}

/// A person a thousand kilometres away has the derivatives of one at hand.
#[test]
fn derivatives_do_not_know_where_the_figure_stands() {
    let figure = human(1.75, 73.0).expect("within range");
    let n = figure.layout().nv();
    let mut random = Random::new(3);
    let (mut q, v, a) = (random.slice(n, 0.4), random.slice(n, 2.0), random.slice(n, 5.0));
    let mut derivatives = Derivatives::new(&figure, GRAVITY).expect("finite constants");
    let near = derivatives.inverse_dynamics(&q, &v, &a, &[]).expect("valid").clone();
    (0..3).for_each(|i| q[i] += 1e6);
    let far = derivatives.inverse_dynamics(&q, &v, &a, &[]).expect("valid");
    for (near, far) in [(&near.by_q, &far.by_q), (&near.by_v, &far.by_v), (&near.by_input, &far.by_input)] {
        let error = apart(far, near);
        assert!(error < 1e-13, "{error:e}");
    }
}

#[test]
fn long_chains_agree_with_plane_geometry() {
    for links in [300, 1000] {
        let mut random = Random::new(links as u64);
        let (q, v, a) = (random.slice(links, 0.3), random.slice(links, 0.2), random.slice(links, 1.0));
        let mut kernel = Kernel::<f64>::new(&planar_chain(links), GRAVITY);
        let tau = kernel.inverse(&q, &v, &a, &[]).expect("valid");
        let error = relative_error(&tau, &planar_torques(&q, &v, &a));
        assert!(error < 1e-12, "{links} links: {error:e}");
    }
}

#[test]
fn the_mass_matrix_of_a_chain_of_300_is_positive_definite_and_linear() {
    let mut kernel = Kernel::<f64>::new(&planar_chain(300), GRAVITY);
    let mut random = Random::new(3);
    let (q, a, rest) = (random.slice(300, 0.5), random.slice(300, 1.0), vec![0.0; 300]);
    let matrix = kernel.mass_matrix(&q).expect("valid");
    let sum = &matrix * DVector::from_vec(a.clone())
        + DVector::from_vec(kernel.bias_forces(&q, &rest).expect("valid"));
    let tau = kernel.inverse(&q, &rest, &a, &[]).expect("valid");
    assert!(relative_error(sum.as_slice(), &tau) < 1e-12);
    assert!(matrix.cholesky().is_some());
}

/// The root's position is not in the forces of the joints, to the last bit; 100 km is where world axes lose 9 digits.
#[test]
fn the_torques_do_not_depend_on_the_place() {
    let mut kernel = Kernel::<f64>::new(&human(1.75, 73.0).expect("within range"), GRAVITY);
    let mut random = Random::new(5);
    let (mut q, v, a) = (random.slice(66, 1.0), random.slice(66, 2.0), random.slice(66, 5.0));
    q[..3].fill(0.0);
    let (near, matrix) =
        (kernel.inverse(&q, &v, &a, &[]).expect("valid"), kernel.mass_matrix(&q).expect("valid"));
    let energy = kernel.kinetic(&q, &v);
    q[..3].copy_from_slice(&[1e5, -2e5, 3e5]);
    assert_eq!(kernel.inverse(&q, &v, &a, &[]).expect("valid"), near);
    assert_eq!(kernel.mass_matrix(&q).expect("valid"), matrix);
    assert_eq!(kernel.kinetic(&q, &v).to_bits(), energy.to_bits());
}

/// Turning twice about one axis is turning once by the sum, and both feel the same torque.
#[test]
fn a_repeated_axis_shares_its_angle() {
    for (axis, number) in [(Vector3::x(), 0), (-Vector3::y(), 1), (Vector3::new(1.0, 2.0, -0.5), 2)] {
        let figure = |times: usize| {
            let arm =
                (0..times).fold(Joint::new("arm").ty(), |joint, _| joint.axis(Axis::rotation(axis))).rz();
            let link = LinkSpec::root("link", arm).mass(1.5).com(Vector3::new(0.1, 0.2, 0.3));
            FigureBuilder::new("f")
                .link(link.inertia(Inertia::diagonal(0.2, 0.3, 0.4)))
                .build()
                .expect("valid")
        };
        let (mut once, mut twice) =
            (Kernel::<f64>::new(&figure(1), GRAVITY), Kernel::<f64>::new(&figure(2), GRAVITY));
        let tau = once.inverse(&[0.2, 1.0, 0.4], &[1.0, 2.0, 3.0], &[4.0, 5.0, 6.0], &[]).expect("valid");
        let both = twice
            .inverse(&[0.2, 0.7, 0.3, 0.4], &[1.0, 1.5, 0.5, 3.0], &[4.0, 3.0, 2.0, 6.0], &[])
            .expect("valid");
        assert!(relative_error(&both, &[tau[0], tau[1], tau[1], tau[2]]) < 1e-14, "axis {number}");
    }
}

/// Two welded halves move as the whole, and a weld has no place in the state.
#[test]
fn a_weld_carries_its_load() {
    let shoulder = || Joint::new("shoulder").at(Vector3::new(0.3, 0.1, 0.0)).rx().rz();
    let half = |link: LinkSpec| link.mass(1.0).inertia(Inertia::diagonal(0.1, 0.2, 0.3));
    let welded = FigureBuilder::new("welded")
        .link(LinkSpec::root("ground", Joint::new("floor")))
        .link(half(LinkSpec::child("near", "ground", shoulder())).com(Vector3::new(0.0, -0.2, 0.0)))
        .link(
            half(LinkSpec::child("far", "near", Joint::new("weld").at(Vector3::new(0.0, -0.6, 0.1))))
                .com(Vector3::new(0.0, 0.2, -0.1)),
        )
        .build()
        .expect("a valid figure");
    // Centres 0.2 m below the middle, 0.2 m above it: the far half's is at (0, −0.4, 0).
    let inertia = Inertia::diagonal(0.2 + 0.02, 0.4, 0.6 + 0.02);
    let whole =
        LinkSpec::root("whole", shoulder()).mass(2.0).com(Vector3::new(0.0, -0.3, 0.0)).inertia(inertia);
    let whole = FigureBuilder::new("whole").link(whole).build().expect("a valid figure");
    let (mut welded, mut whole) = (Kernel::<f64>::new(&welded, GRAVITY), Kernel::<f64>::new(&whole, GRAVITY));
    assert_eq!((welded.tree.nv(), welded.tree.link_count()), (2, 3));
    let (q, v, a) = ([0.3, -0.8], [1.0, 2.0], [-3.0, 4.0]);
    let tau = whole.inverse(&q, &v, &a, &[]).expect("valid");
    assert!(relative_error(&welded.inverse(&q, &v, &a, &[]).expect("valid"), &tau) < 1e-14);
    let (parts, sum): (DMatrix<f64>, DMatrix<f64>) =
        (welded.mass_matrix(&q).expect("valid"), whole.mass_matrix(&q).expect("valid"));
    assert!(relative_error(parts.as_slice(), sum.as_slice()) < 1e-14);
}

/// A figure of welds alone has nothing to compute and everything to place.
#[test]
fn a_statue_has_no_state() {
    let figure = FigureBuilder::new("statue")
        .link(LinkSpec::root("statue", Joint::new("plinth").at(Vector3::new(0.0, 2.0, 0.0))).mass(3.0))
        .build()
        .expect("a valid figure");
    let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
    assert_eq!(kernel.inverse(&[], &[], &[], &[]).expect("valid"), Vec::<f64>::new());
    assert_eq!(kernel.mass_matrix(&[]).expect("valid").len(), 0);
    assert!((kernel.potential(&[]) - 3.0 * 9.806_65 * 2.0).abs() < 1e-12);
}

/// Standing on both feet: the weight from outside takes the weight off the root.
#[test]
fn a_wrench_that_carries_the_weight_frees_the_root() {
    let figure = human(1.75, 73.0).expect("within range");
    let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
    let (q, rest) = (vec![0.0; 66], vec![0.0; 66]);
    let center = kernel.center_of_mass(&q);
    let foot = figure.link_index("left_foot").expect("a human has feet");
    let weight = solaris_dynamics::Wrench::at(&center, -GRAVITY * 73.0, Vector3::zeros());
    let tau = kernel.inverse(&q, &rest, &rest, &[(foot, weight)]).expect("valid");
    assert!(largest(&tau[..6]) < 1e-11, "{:?}", &tau[..6]);
}
