//! Laws that hold for every figure.

use super::Body;
use super::random::{Random, configuration, figure, ground, limits, springs};
use crate::element::{Anchor, LimitLaw, PointSpring};
use approx::assert_relative_eq;
use nalgebra::{DMatrix, DVector, Vector3};
use solaris_dynamics::scalar::Dual;
use solaris_dynamics::{Tree, Workspace, momentum};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Passive};

struct Scene {
    figure: Figure,
    body: Body<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
}

fn scene(random: &mut Random) -> Scene {
    let figure = figure(random);
    let (springs, limits) = (springs(random, &figure), limits(random, &figure));
    let gravity = Vector3::new(0.3, -9.81, 1.0);
    let body = Body::new(&figure, gravity, &springs, &limits).expect("a valid figure");
    let (q, v) = (configuration(random, &figure), random.numbers(figure.layout().nv(), 2.0));
    let body = body.on(ground(random, &figure).as_ref());
    Scene { figure, body, q, v }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

#[test]
fn inverse_dynamics_turn_hybrid_dynamics_round() {
    for seed in 0..200 {
        let random = &mut Random(seed);
        let Scene { mut body, q, v, .. } = scene(random);
        let n = v.len();
        let (mut a, mut tau) = (random.numbers(n, 5.0), random.numbers(n, 20.0));
        let prescribed: Vec<bool> = (0..n).map(|_| random.chance(0.4)).collect();
        let given = (a.clone(), tau.clone());
        body.hybrid(&q, &v, &prescribed, &mut a, &mut tau).expect("a state with inertia");
        for k in 0..n {
            let (kept, before) = if prescribed[k] { (a[k], given.0[k]) } else { (tau[k], given.1[k]) };
            assert_eq!(kept.to_bits(), before.to_bits());
        }
        let mut back = vec![0.0; n];
        let heat = body.heat();
        body.inverse(&q, &v, &a, &[], &mut back).expect("finite");
        assert_eq!(heat.to_bits(), body.heat().to_bits());
        for k in 0..n {
            assert_relative_eq!(back[k], tau[k], epsilon = 1e-10 * (1.0 + largest(&tau)));
        }
    }
}

/// The energy of a figure grows by what drives do and falls by what dampers take.
#[test]
fn energy_is_neither_made_nor_lost() {
    for seed in 0..200 {
        let random = &mut Random(seed);
        let Scene { figure, mut body, q, v } = scene(random);
        let n = v.len();
        let (mut a, mut tau) = (vec![0.0; n], random.numbers(n, 20.0));
        body.hybrid(&q, &v, &vec![false; n], &mut a, &mut tau).expect("a state with inertia");
        let power = tau.iter().zip(&v).map(|(tau, v)| tau * v).sum::<f64>() - body.heat();
        let step = 1e-5 / (1.0 + largest(&a) + largest(&v));
        let mut at = |time: f64| {
            let moved: Vec<f64> = v.iter().zip(&a).map(|(v, a)| v * time + a * time * time / 2.0).collect();
            let mut then = q.clone();
            figure.integrate(&q, &moved, &mut then).expect("finite");
            let rate: Vec<f64> = v.iter().zip(&a).map(|(v, a)| v + a * time).collect();
            body.energy(&then, &rate).expect("finite")
        };
        let (before, after) = (at(-step), at(step));
        let found = (after.total() - before.total()) / (2.0 * step);
        let scale = [after.kinetic, after.potential.abs(), after.elastic].iter().sum::<f64>() * 1e-16 / step;
        assert_relative_eq!(found, power, max_relative = 1e-6, epsilon = 1e-6 + 20.0 * scale);
    }
}

#[test]
fn an_impulse_is_the_mass_matrix_times_the_jump() {
    for seed in 0..100 {
        let random = &mut Random(seed);
        let Scene { mut body, q, v, .. } = scene(random);
        let n = v.len();
        let (mut jump, mut impulse) = (random.numbers(n, 2.0), random.numbers(n, 2.0));
        let prescribed: Vec<bool> = (0..n).map(|_| random.chance(0.4)).collect();
        body.impact((&q, &v), &prescribed, &mut jump, &mut impulse).expect("a state with inertia");
        let mut matrix = DMatrix::zeros(n, n);
        body.mass_matrix(&q, &mut matrix).expect("finite");
        let product = matrix * DVector::from_vec(jump);
        for k in 0..n {
            assert_relative_eq!(product[k], impulse[k], epsilon = 1e-10 * (1.0 + largest(&impulse)));
        }
    }
}

/// Impulses between the links of a figure that floats leave its momentum as it is.
#[test]
fn impulses_inside_keep_the_momentum() {
    let leg = |name: &str, joint: Joint| {
        LinkSpec::child(name, "trunk", joint).mass(3.0).com(Vector3::new(0.1, -0.3, 0.0))
    };
    let figure = FigureBuilder::new("floats")
        .link(
            LinkSpec::root("trunk", Joint::free("root"))
                .mass(10.0)
                .inertia(solaris_model::Inertia::Tensor(nalgebra::Matrix3::identity())),
        )
        .link(leg("left", Joint::new("l").at(Vector3::new(0.2, 0.0, 0.0)).rx().rz()))
        .link(leg("right", Joint::ball("r").armature(0.01)))
        .build()
        .expect("valid");
    let random = &mut Random(5);
    let (q, v) = (configuration(random, &figure), random.numbers(figure.layout().nv(), 2.0));
    let mut body = Body::<f64>::new(&figure, Vector3::zeros(), &[], &[LimitLaw::Ignore; 11]).expect("valid");
    let (mut jump, mut impulse) = (vec![0.0; 11], random.numbers(11, 4.0));
    impulse[..6].fill(0.0);
    body.impact((&q, &v), &[false; 11], &mut jump, &mut impulse).expect("a state with inertia");
    let after: Vec<f64> = v.iter().zip(&jump).map(|(v, jump)| v + jump).collect();
    let tree = Tree::<f64>::new(&figure, Vector3::zeros()).expect("valid");
    let mut workspace = Workspace::new(&tree);
    let [before, after] = [&v, &after].map(|v| momentum(&tree, &mut workspace, &q, v).expect("finite"));
    assert!(largest(&jump) > 0.1);
    assert_relative_eq!(before.linear, after.linear, epsilon = 1e-12);
    assert_relative_eq!(before.angular, after.angular, epsilon = 1e-12);
}

/// Two masses on a line, 2 kg and 3 kg, 0.7 m apart.
fn two_masses() -> Figure {
    let slide = |name: &str| Joint::new(name).tx();
    FigureBuilder::new("two")
        .link(LinkSpec::root("rail", Joint::new("weld")).mass(1.0))
        .link(LinkSpec::child("a", "rail", slide("a")).mass(2.0))
        .link(LinkSpec::child("b", "rail", slide("b")).mass(3.0))
        .build()
        .expect("valid")
}

fn between(stiffness: f64, damping: f64, rest: f64) -> PointSpring {
    let end = |link| Anchor { link: Some(link), point: Vector3::new(0.0, 0.2, 0.0) };
    PointSpring { between: [end(1), end(2)], stiffness, damping, rest }
}

#[test]
fn a_spring_pulls_two_masses_together() {
    let spring = between(50.0, 4.0, 0.5);
    let mut body =
        Body::<f64>::new(&two_masses(), Vector3::zeros(), &[spring], &[LimitLaw::Ignore; 2]).expect("valid");
    let (mut a, mut tau) = ([0.0; 2], [0.0; 2]);
    body.hybrid(&[0.1, 0.8], &[1.0, -0.5], &[false; 2], &mut a, &mut tau).expect("finite");
    // 50·0.2 − 4·1.5 = 4 N.
    assert_relative_eq!(a[0], 2.0, max_relative = 1e-13);
    assert_relative_eq!(a[1], -4.0 / 3.0, max_relative = 1e-13);
    assert_relative_eq!(body.heat(), 9.0, max_relative = 1e-13);
    let energy = body.energy(&[0.1, 0.8], &[1.0, -0.5]).expect("finite");
    assert_relative_eq!(energy.elastic, 1.0, max_relative = 1e-13);
    assert_relative_eq!(energy.kinetic, 1.375, max_relative = 1e-13);
}

#[test]
fn two_points_in_one_place_have_no_direction_but_derivatives() {
    let constant = Dual::<2>::constant;
    for (rest, slope) in [(0.0, -25.0), (0.5, 0.0)] {
        let spring = between(50.0, 4.0, rest);
        let body = Body::<Dual<2>>::new(&two_masses(), Vector3::zeros(), &[spring], &[LimitLaw::Ignore; 2]);
        let mut body = body.expect("valid");
        let (mut a, mut tau) = ([constant(0.0); 2], [constant(0.0); 2]);
        let q = [Dual::variable(0.3, 0), Dual::variable(0.3, 1)];
        body.hybrid(&q, &[constant(1.0), constant(-1.0)], &[false; 2], &mut a, &mut tau).expect("finite");
        assert_relative_eq!(a[0].value(), 0.0);
        assert_relative_eq!(a[0].partial(0), slope, max_relative = 1e-13);
        assert_relative_eq!(body.heat().value(), 0.0);
    }
}

#[test]
fn a_limit_pushes_and_never_pulls() {
    let cart = LinkSpec::root("cart", Joint::new("x").tx().limited(-1.0, 1.0)).mass(2.0);
    let figure = FigureBuilder::new("cart").link(cart).build().expect("valid");
    let law = LimitLaw::Spring { stiffness: 100.0, damping: 10.0 };
    let mut body = Body::<f64>::new(&figure, Vector3::zeros(), &[], &[law]).expect("valid");
    // Position, velocity, force, heat.
    let cases = [
        (0.999, 5.0, 0.0, 0.0),
        (1.1, 0.5, -15.0, 2.5),
        (1.1, -0.5, -5.0, 2.5),
        (1.1, -2.0, 0.0, 20.0),
        (-1.2, 0.5, 15.0, 2.5),
        (-1.2, -0.5, 25.0, 2.5),
        (-1.2, 3.0, 0.0, 60.0),
    ];
    for (position, velocity, force, heat) in cases {
        let mut a = [0.0];
        body.hybrid(&[position], &[velocity], &[false], &mut a, &mut [0.0]).expect("finite");
        assert_relative_eq!(2.0 * a[0], force, epsilon = 1e-12);
        assert_relative_eq!(body.heat(), heat, epsilon = 1e-12);
    }
}

#[test]
fn dry_friction_is_smooth_and_nearly_whole() {
    let acts = Passive { friction: 3.0, ..Passive::default() };
    let disc = LinkSpec::root("disc", Joint::new("spin").tx().passive(acts)).mass(1.0);
    let figure = FigureBuilder::new("disc").link(disc).build().expect("valid");
    let mut body = Body::<f64>::new(&figure, Vector3::zeros(), &[], &[LimitLaw::Ignore]).expect("valid");
    for (velocity, force) in [(0.0, 0.0), (0.01, -3.0 * 0.5_f64.sqrt()), (-1.0, 3.0)] {
        let mut a = [0.0];
        body.hybrid(&[0.0], &[velocity], &[false], &mut a, &mut [0.0]).expect("finite");
        assert_relative_eq!(a[0], force, max_relative = 1e-4);
    }
}

#[test]
fn what_is_prescribed_is_driven_against_springs_too() {
    let acts = Passive { stiffness: 10.0, rest: 0.1, damping: 2.0, friction: 0.0 };
    let cart = LinkSpec::root("cart", Joint::new("x").tx().passive(acts)).mass(2.0);
    let figure = FigureBuilder::new("cart").link(cart).build().expect("valid");
    let mut body =
        Body::<f64>::new(&figure, Vector3::new(-1.0, 0.0, 0.0), &[], &[LimitLaw::Ignore]).expect("valid");
    let mut tau = [f64::NAN];
    body.hybrid(&[0.4], &[0.5], &[true], &mut [3.0], &mut tau).expect("finite");
    // 2·(3 + 1) + 10·0.3 + 2·0.5
    assert_relative_eq!(tau[0], 12.0, max_relative = 1e-14);
}

#[test]
fn a_state_of_another_length_is_refused() {
    let mut body =
        Body::<f64>::new(&two_masses(), Vector3::zeros(), &[], &[LimitLaw::Ignore; 2]).expect("valid");
    let (mut a, mut tau) = ([0.0; 2], [0.0; 2]);
    assert!(body.hybrid(&[0.0; 3], &[0.0; 2], &[false; 2], &mut a, &mut tau).is_err());
    assert!(body.hybrid(&[0.0; 2], &[0.0; 1], &[false; 2], &mut a, &mut tau).is_err());
    assert!(body.hybrid(&[0.0; 2], &[f64::NAN; 2], &[false; 2], &mut a, &mut tau).is_err());
    assert!(body.hybrid(&[0.0; 2], &[0.0; 2], &[false; 1], &mut a, &mut tau).is_err());
    assert!(body.hybrid(&[0.0; 2], &[0.0; 2], &[false; 2], &mut a, &mut tau[..1]).is_err());
}
