//! The Lagrangian formulations on random figures and on hard ones, against other ways to the same number.

use crate::support::oracle::Oracle;
use crate::support::random::{Joints, Random, Sample, State, random_configuration, tree_of};
use crate::support::{largest, relative_error};
use nalgebra::{Matrix3, Matrix4, UnitQuaternion, Vector3};
use proptest::prelude::*;
use solaris_dynamics::denavit_hartenberg::{Carried, DenavitHartenberg};
use solaris_dynamics::lagrange::{Lagrangian, LagrangianWorkspace, Products, chain_wise, tree_wise};
use solaris_dynamics::scalar::{DoubleDouble, Dual, Lanes};
use solaris_dynamics::{Formulation, InverseDynamics, Scalar, Wrench};
use solaris_model::{Axis, Figure, FigureBuilder, Inertia, Joint, LinkSpec, human};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

/// The forces in every formulation.
fn solve(
    figure: &Figure,
    gravity: Vector3<f64>,
    [q, v, a]: [&[f64]; 3],
    external: &[(usize, Wrench<f64>)],
) -> [Vec<f64>; 3] {
    Formulation::ALL.map(|formulation| {
        let mut dynamics = InverseDynamics::new(figure, gravity, formulation).expect("finite constants");
        let mut tau = vec![0.0; v.len()];
        dynamics.solve(q, v, a, external, &mut tau).expect("a valid state");
        tau
    })
}

/// The worst difference of the Lagrangian formulations from virtual work on a random tree.
fn off_virtual_work(seed: u64, decades: f64) -> f64 {
    let Sample { figure, gravity, state: State { q, v, a }, external } = Sample::random(seed, decades);
    let oracle = Oracle::new(&figure, gravity, &q, &v, &a);
    let mut worst = 0.0_f64;
    for external in [&[][..], &external] {
        for tau in &solve(&figure, gravity, [&q, &v, &a], external)[..2] {
            worst = worst.max(oracle.error_of(tau, external));
        }
    }
    worst
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn they_agree_with_virtual_work(seed in any::<u64>()) {
        let error = off_virtual_work(seed, 1.0);
        prop_assert!(error < 1e-12, "{error:e}");
    }

    /// Masses between a milligram and a tonne in one figure.
    #[test]
    fn mass_ratios_of_twelve_decades_do_no_harm(seed in any::<u64>()) {
        let error = off_virtual_work(seed, 6.0);
        prop_assert!(error < 1e-12, "{error:e}");
    }

    /// Ball and free joints and armature too, against the fast formulation.
    #[test]
    fn they_agree_on_every_kind_of_joint(seed in any::<u64>()) {
        let mut random = Random::new(seed);
        let links = 1 + random.below(9);
        let figure = tree_of(Joints::EveryArmed, &mut random, links, 1.0);
        let (q, n) = (random_configuration(&mut random, &figure), figure.layout().nv());
        let (v, a) = (random.slice(n, 3.0), random.slice(n, 10.0));
        let external = [random.wrench(links), random.wrench(links)];
        let gravity = random.vector(10.0);
        for external in [&[][..], &external] {
            let [chains, tree, fast] = solve(&figure, gravity, [&q, &v, &a], external);
            let error = relative_error(&chains, &fast).max(relative_error(&tree, &fast));
            prop_assert!(error < 1e-12, "{error:e}");
        }
    }

    #[test]
    fn uickers_sums_are_the_same_forces(seed in any::<u64>()) {
        let mut random = Random::new(seed);
        let figure = serial(&mut random);
        let n = figure.layout().nv();
        let (q, v, a) = (random.slice(n, 2.0), random.slice(n, 3.0), random.slice(n, 10.0));
        let oracle = Oracle::new(&figure, GRAVITY, &q, &v, &a);
        let expected = Uicker::new(&figure, &q).forces(&GRAVITY, &v, &a);
        prop_assert!(oracle.error_of(&expected, &[]) < 1e-12, "{expected:?}");
        for tau in solve(&figure, GRAVITY, [&q, &v, &a], &[]) {
            prop_assert!(oracle.error_of(&tau, &[]) < 1e-12, "{tau:?}; by his sums {expected:?}");
        }
    }
}

/// A chain of one to four links with a turn or a slide each.
fn serial(random: &mut Random) -> Figure {
    let mut builder = FigureBuilder::new("chain");
    for i in 0..=random.below(4) {
        let kind = if random.below(3) == 0 { Axis::translation } else { Axis::rotation };
        let axis = kind(random.vector(1.0) + Vector3::new(0.1, 1.1, 0.0));
        let joint = Joint::new(format!("j{i}")).at(random.vector(0.5)).axis(axis);
        let link = match i.checked_sub(1) {
            None => LinkSpec::root("l0", joint),
            Some(parent) => LinkSpec::child(format!("l{i}"), format!("l{parent}"), joint),
        };
        let inertia = Inertia::diagonal(0.3, 0.4, 0.5);
        builder = builder.link(link.mass(1.5 + random.unit()).com(random.vector(0.3)).inertia(inertia));
    }
    builder.build().expect("a valid figure")
}

/// Lagrange's equations as Uicker (1965) left them, with nothing computed twice for the better:
///
/// ```text
/// F_i = Σ_j [ Σ_k tr(∂W_j/∂q_i·J_j·(∂W_j/∂q_k)ᵀ)·q̈_k + Σ_k Σ_l tr(∂W_j/∂q_i·J_j·(∂²W_j/∂q_k∂q_l)ᵀ)·q̇_k·q̇_l
///             − gᵀ·∂W_j/∂q_i·m_j·r_j ]
/// ```
///
/// where a derivative by `q_k` puts the generator `Q_k` of the motion before `A_k`.
struct Uicker {
    /// `B_j`, `A_j`, `Q_j` and `J_j` of a chain.
    links: Vec<[Matrix4<f64>; 4]>,
}

impl Uicker {
    fn new(figure: &Figure, q: &[f64]) -> Self {
        let frames = DenavitHartenberg::of(figure).expect("a figure of turns and slides");
        let links = frames.links.iter().zip(q).map(|(link, coordinate)| {
            let mut generator = Matrix4::zeros();
            if link.slides {
                generator.m34 = 1.0;
            } else {
                (generator.m12, generator.m21) = (-1.0, 1.0);
            }
            let (base, a) = (link.base.at(q), link.transform(*coordinate));
            let inertia = link.carried.iter().map(|carried| pseudo_inertia(figure, carried)).sum();
            [base.to_homogeneous(), a.to_homogeneous(), generator, inertia]
        });
        Self { links: links.collect() }
    }

    /// The derivative of `W_j` by the coordinates `by`.
    fn derivative(&self, j: usize, by: &[usize]) -> Matrix4<f64> {
        if by.iter().any(|k| *k > j) {
            return Matrix4::zeros();
        }
        (0..=j).fold(Matrix4::identity(), |w, i| {
            let [base, a, generator, _] = &self.links[i];
            let times = by.iter().filter(|k| **k == i).count();
            (0..times).fold(w * base, |w, _| w * generator) * a
        })
    }

    fn forces(&self, g: &Vector3<f64>, v: &[f64], a: &[f64]) -> Vec<f64> {
        let n = self.links.len();
        let force = |i: usize| -> f64 {
            let on_link = |j: usize| -> f64 {
                let (by, inertia) = (self.derivative(j, &[i]), &self.links[j][3]);
                let along = |other: Matrix4<f64>| (by * inertia * other.transpose()).trace();
                let inertial: f64 = (0..n).map(|k| along(self.derivative(j, &[k])) * a[k]).sum();
                let coriolis: f64 = (0..n)
                    .flat_map(|k| (0..n).map(move |l| (k, l)))
                    .map(|(k, l)| along(self.derivative(j, &[k, l])) * v[k] * v[l])
                    .sum();
                inertial + coriolis - (by * inertia.column(3)).xyz().dot(g)
            };
            (0..n).map(on_link).sum()
        };
        (0..n).map(force).collect()
    }
}

/// `X·J·Xᵀ`, with `J = ∫ (r 1)ᵀ(r 1) dm` in the link's own frame.
fn pseudo_inertia(figure: &Figure, carried: &Carried) -> Matrix4<f64> {
    let (link, x) = (&figure.links()[carried.link], carried.placement.to_homogeneous());
    let c = link.com().push(1.0);
    let mut j = c * c.transpose() * link.mass();
    let second = Matrix3::identity() * (link.inertia().trace() / 2.0) - link.inertia();
    let mut corner = j.fixed_view_mut::<3, 3>(0, 0);
    corner += second;
    x * j * x.transpose()
}

/// Newton and Euler's equations of one body, in its own axes about its own origin.
#[test]
fn a_free_body_obeys_newton_and_euler() {
    let (m, c) = (3.0, Vector3::new(0.1, -0.2, 0.3));
    let inertia = Matrix3::new(0.5, 0.02, -0.03, 0.02, 0.6, 0.04, -0.03, 0.04, 0.7);
    let joint = Joint::free("body").at(Vector3::new(1.0, 2.0, 3.0)).armature(0.25);
    let link = LinkSpec::root("body", joint).mass(m).com(c).inertia(Inertia::Tensor(inertia));
    let figure = FigureBuilder::new("body").link(link).build().expect("a valid figure");
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.4, -1.1, 0.7));
    let q = [vec![0.3, -0.5, 0.7], turn.coords.as_slice().to_vec()].concat();
    let (u, w) = (Vector3::new(1.0, -2.0, 0.5), Vector3::new(3.0, 1.0, -2.0));
    let (du, dw) = (Vector3::new(-4.0, 5.0, 6.0), Vector3::new(7.0, -8.0, 9.0));
    let (v, a) =
        ([u, w].map(|x| x.as_slice().to_vec()).concat(), [du, dw].map(|x| x.as_slice().to_vec()).concat());
    // Of the centre, less gravity.
    let acceleration = du + w.cross(&u) + dw.cross(&c) + w.cross(&w.cross(&c)) - turn.inverse() * GRAVITY;
    let force = acceleration * m;
    let moment = inertia * dw + w.cross(&(inertia * w)) + c.cross(&force);
    let expected = [force + du * 0.25, moment + dw * 0.25].map(|x| x.as_slice().to_vec()).concat();
    for tau in solve(&figure, GRAVITY, [&q, &v, &a], &[]) {
        assert!(relative_error(&tau, &expected) < 1e-14, "{tau:?}, not {expected:?}");
    }
}

/// A thousand links, straight, coiled and about axes in turn.
#[test]
fn long_chains_agree() {
    for (links, axes) in [(300, 1), (300, 3), (1000, 1)] {
        let mut builder = FigureBuilder::new("chain");
        for i in 0..links {
            let axis = Axis::rotation(Vector3::ith(i % axes, 1.0));
            let joint = Joint::new(format!("j{i}")).at(Vector3::new(0.02, -0.1, 0.3)).axis(axis);
            let link = match i.checked_sub(1) {
                None => LinkSpec::root("l0", joint),
                Some(parent) => LinkSpec::child(format!("l{i}"), format!("l{parent}"), joint),
            };
            let inertia = Inertia::diagonal(0.01, 0.02, 0.02);
            builder = builder.link(link.mass(2.0).com(Vector3::new(0.0, 0.02, 0.15)).inertia(inertia));
        }
        let figure = builder.build().expect("a valid figure");
        let mut random = Random::new(links as u64);
        let (q, v, a) = (random.slice(links, 0.3), random.slice(links, 0.2), random.slice(links, 1.0));
        let [chains, tree, fast] = solve(&figure, GRAVITY, [&q, &v, &a], &[]);
        assert_eq!(chains, tree, "one chain is its tree");
        let error = relative_error(&chains, &fast);
        assert!(error < 1e-12, "{links} links about {axes} axes: {error:e}");
    }
}

/// Derivatives along one direction, several states at once, and twice the digits.
#[test]
fn other_scalars_run_through_the_same_code() {
    let mut random = Random::new(21);
    let figure = tree_of(Joints::OneAxis, &mut random, 7, 1.0);
    let n = figure.layout().nv();
    let [q, v, a] = [2.0, 3.0, 5.0].map(|scale| random.slice(n, scale));
    let plain = solve(&figure, GRAVITY, [&q, &v, &a], &[]);
    let [_, _, dual] = in_scalar(&figure, [&q, &v, &a], |x| Dual::<1>::new(x, [x]));
    let exact = in_scalar(&figure, [&q, &v, &a], DoubleDouble::from_f64);
    for (i, tau) in in_scalar(&figure, [&q, &v, &a], |x| Dual::<1>::new(x, [x])).iter().enumerate() {
        let parts = |tau: &[Dual<1>]| tau.iter().map(|tau| tau.partial(0)).collect::<Vec<_>>();
        assert!(relative_error(&parts(tau), &parts(&dual)) < 1e-12);
        assert!(tau.iter().zip(&plain[i]).all(|(tau, plain)| tau.value().to_bits() == plain.to_bits()));
    }
    for (i, tau) in in_scalar(&figure, [&q, &v, &a], |x| Lanes::<2>::new([x, 0.5 * x])).iter().enumerate() {
        assert!(tau.iter().zip(&plain[i]).all(|(tau, plain)| tau.lane(0).to_bits() == plain.to_bits()));
    }
    // α, θ⁰, a and s are derived in double precision: both walks share their rounding, the fast formulation does not.
    let digits = |tau: &[DoubleDouble]| tau.iter().map(|tau| tau.to_f64()).collect::<Vec<_>>();
    let apart: Vec<f64> = exact[0].iter().zip(&exact[1]).map(|(x, y)| (*x - *y).to_f64()).collect();
    let scale = largest(&digits(&exact[2]));
    assert!(largest(&apart) < 1e-28 * scale && largest(&apart) > 0.0, "{apart:?}");
    assert!(relative_error(&digits(&exact[0]), &digits(&exact[2])) < 1e-13);
}

fn in_scalar<T: Scalar>(figure: &Figure, state: [&[f64]; 3], number: impl Fn(f64) -> T) -> [Vec<T>; 3] {
    let [q, v, a] = state.map(|values| values.iter().map(|x| number(*x)).collect::<Vec<_>>());
    Formulation::ALL.map(|formulation| {
        let mut dynamics = InverseDynamics::new(figure, GRAVITY, formulation).expect("finite constants");
        let mut tau = vec![T::zero(); v.len()];
        dynamics.solve(&q, &v, &a, &[], &mut tau).expect("a valid state");
        tau
    })
}

/// Full and short products differ by products with zero and one alone.
#[test]
fn full_products_change_nothing() {
    let figure = human(1.75, 73.0).expect("within range");
    let mut random = Random::new(9);
    let (q, v, a) = (random.slice(66, 1.0), random.slice(66, 2.0), random.slice(66, 5.0));
    let external = [random.wrench(21)];
    let lagrangian = Lagrangian::new(&figure, GRAVITY).expect("finite constants");
    let full = lagrangian.clone().with_full_products();
    let state = [&q[..], &v, &a];
    let (short, full) = (both(&lagrangian, state, &external), both(&full, state, &external));
    for i in 0..2 {
        assert!(relative_error(&full[i], &short[i]) < 1e-14);
    }
}

fn both<P: Products>(
    lagrangian: &Lagrangian<f64, P>,
    [q, v, a]: [&[f64]; 3],
    external: &[(usize, Wrench<f64>)],
) -> [Vec<f64>; 2] {
    let mut workspace = LagrangianWorkspace::new(lagrangian);
    [chain_wise, tree_wise].map(|formulation| {
        let mut tau = vec![0.0; v.len()];
        formulation(lagrangian, &mut workspace, q, v, a, external, &mut tau).expect("a valid state");
        tau
    })
}

/// A workspace remembers nothing of the call before.
#[test]
fn a_workspace_can_be_used_again() {
    let figure = human(1.75, 73.0).expect("within range");
    let mut random = Random::new(10);
    let state = |random: &mut Random| [1.0, 2.0, 5.0].map(|scale| random.slice(66, scale));
    let (first, second) = (state(&mut random), state(&mut random));
    let external = [random.wrench(21)];
    let lagrangian = Lagrangian::new(&figure, GRAVITY).expect("finite constants");
    let mut workspace = LagrangianWorkspace::new(&lagrangian);
    for formulation in [chain_wise, tree_wise] {
        let mut call = |[q, v, a]: &[Vec<f64>; 3], external: &[_]| {
            let mut tau = vec![0.0; 66];
            formulation(&lagrangian, &mut workspace, q, v, a, external, &mut tau).expect("a valid state");
            tau
        };
        let fresh = call(&first, &[]);
        call(&second, &external);
        assert_eq!(call(&first, &[]), fresh);
    }
}

#[test]
fn there_is_one_chain_for_each_end_effector() {
    let figure = human(1.75, 73.0).expect("within range");
    let lagrangian = Lagrangian::<f64>::new(&figure, GRAVITY).expect("finite constants");
    let mut lengths: Vec<usize> = lagrangian.chain_lengths().collect();
    lengths.sort_unstable();
    // Head, two legs, two arms.
    assert_eq!(lengths, [18, 18, 18, 24, 24]);
}
