//! Contacts with unknown wrenches, against the dense equations and by the law they answer to.

use crate::support::random::{Random, tree};
use crate::support::{Kernel, largest};
use nalgebra::{DMatrix, DVector, Vector3};
use proptest::prelude::*;
use solaris_dynamics::{ContactConstraint, Contacts, DynamicsError, Scalar, Tree, Wrench, contact_dynamics};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.81, 0.0);

/// Accelerations, forces, wrenches and residuals.
type Solved<T> = (Vec<T>, Vec<T>, Vec<(usize, Wrench<T>)>, Vec<T>);

fn solve<T: Scalar>(
    kernel: &mut Kernel<T>,
    list: &[ContactConstraint<T>],
    [q, v]: [&[T]; 2],
    prescribed: &[bool],
    [a, tau]: [&[T]; 2],
) -> Result<Solved<T>, DynamicsError> {
    let mut contacts = Contacts::new(&kernel.tree, list.to_vec());
    let (mut a, mut tau) = (a.to_vec(), tau.to_vec());
    let Kernel { tree, workspace } = kernel;
    let missing = contact_dynamics(tree, workspace, &mut contacts, q, v, prescribed, &[], &mut a, &mut tau)?;
    let largest =
        contacts.residuals().iter().fold(0.0_f64, |most, x| most.max(x.greatest()).max((-*x).greatest()));
    assert_eq!(missing.to_bits(), largest.to_bits());
    Ok((a, tau, contacts.wrenches().to_vec(), contacts.residuals().to_vec()))
}

/// Acceleration of a point of a link by differences of its velocity along the motion.
fn acceleration(
    kernel: &mut Kernel<f64>,
    contact: &ContactConstraint<f64>,
    [q, v, a]: [&[f64]; 3],
) -> Vector3<f64> {
    let step = 1e-4;
    let mut velocity = |t: f64| {
        let at = |x: &[f64], dx: &[f64], ddx: &[f64]| -> Vec<f64> {
            (0..x.len()).map(|k| x[k] + t * dx[k] + 0.5 * t * t * ddx[k]).collect()
        };
        let zeros = vec![0.0; v.len()];
        kernel.velocities(&at(q, v, a), &at(v, a, &zeros));
        let (pose, twist) = (kernel.workspace.pose(contact.link), kernel.workspace.velocity(contact.link));
        twist.linear + twist.angular.cross(&(pose.rotation * contact.point))
    };
    let difference =
        |h: f64, velocity: &mut dyn FnMut(f64) -> Vector3<f64>| (velocity(h) - velocity(-h)) / (2.0 * h);
    (difference(step, &mut velocity) * 4.0 - difference(2.0 * step, &mut velocity)) / 3.0
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 60, max_global_rejects: 10_000, failure_persistence: None, ..ProptestConfig::default()
    })]

    /// The contact moves as prescribed, and hybrid dynamics under the wrench found gives the same accelerations.
    #[test]
    fn the_contact_moves_as_prescribed_under_the_wrench_found(seed in any::<u64>(), links in 3_usize..9) {
        let mut random = Random::new(seed);
        let figure = tree(&mut random, links, 0.3);
        let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
        let n = kernel.tree.nv();
        let (q, v) = (random.slice(n, 2.0), random.slice(n, 1.0));
        let (a, tau) = (random.slice(n, 2.0), random.slice(n, 10.0));
        let prescribed: Vec<bool> = (0..n).map(|_| random.below(4) == 0).collect();
        let matrix = kernel.mass_matrix(&q).expect("valid");
        let eigenvalues = if n == 0 { DVector::zeros(1) } else { matrix.symmetric_eigenvalues() };
        prop_assume!(eigenvalues.min() > 1e-4 * eigenvalues.max());
        let link = links - 1;
        let contact = ContactConstraint {
            acceleration: random.vector(2.0),
            ..ContactConstraint::point(link, random.vector(0.3))
        };
        let solved = solve(&mut kernel, &[contact], [&q, &v], &prescribed, [&a, &tau]).expect("valid");
        let (found_a, found_tau, wrenches, residuals) = solved;
        // A tip that cannot move as prescribed (too few free joints before it) is told by the residual.
        prop_assume!(largest(&residuals) < 1e-9);
        prop_assume!(largest(&found_a) < 1e3);
        let moved = acceleration(&mut kernel, &contact, [&q, &v, &found_a]);
        prop_assert!((moved - contact.acceleration).norm() < 1e-5 * (1.0 + largest(&found_a)), "{moved:?}");
        let again = kernel.hybrid([&q, &v], &prescribed, [&a, &tau], &wrenches).expect("valid");
        for (x, y) in again[0].iter().zip(&found_a).chain(again[1].iter().zip(&found_tau)) {
            prop_assert!((x - y).abs() <= 1e-9 * (1.0 + y.abs()));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 60, max_global_rejects: 10_000, failure_persistence: None, ..ProptestConfig::default()
    })]

    /// Two links that are held together part with the acceleration that is asked, and turn so, under opposite wrenches at their points.
    #[test]
    fn links_held_together_part_as_prescribed(seed in any::<u64>(), links in 4_usize..9, as_a_whole in any::<bool>()) {
        let mut random = Random::new(seed);
        let figure = tree(&mut random, links, 0.3);
        let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
        let n = kernel.tree.nv();
        let (q, v) = (random.slice(n, 2.0), random.slice(n, 1.0));
        let tau = random.slice(n, 10.0);
        let matrix = kernel.mass_matrix(&q).expect("valid");
        let eigenvalues = if n == 0 { DVector::zeros(1) } else { matrix.symmetric_eigenvalues() };
        prop_assume!(eigenvalues.min() > 1e-4 * eigenvalues.max());
        let (link, other) = (links - 1, random.below(links - 1));
        let (own, theirs) = (random.vector(0.3), random.vector(0.3));
        let held = if as_a_whole { ContactConstraint::fixed(link, own) } else { ContactConstraint::point(link, own) };
        let contact = ContactConstraint { acceleration: random.vector(2.0), ..held.to(other, theirs) };
        let (free, nothing) = (vec![false; n], vec![0.0; n]);
        let solved = solve(&mut kernel, &[contact], [&q, &v], &free, [&nothing, &tau]).expect("valid");
        let (found, _, wrenches, residuals) = solved;
        prop_assume!(largest(&residuals) < 1e-9 && largest(&found) < 1e3);
        let first = acceleration(&mut kernel, &contact, [&q, &v, &found]);
        let second = acceleration(&mut kernel, &ContactConstraint::point(other, theirs), [&q, &v, &found]);
        let apart = first - second - contact.acceleration;
        prop_assert!(apart.norm() < 1e-5 * (1.0 + largest(&found)), "{:?}", apart);
        kernel.velocities(&q, &v);
        let place = |link: usize, point: &Vector3<f64>| kernel.workspace.pose(link).transform(point);
        let (_, wrench) = wrenches[0];
        let moment = wrench.moment_about(&place(link, &own));
        prop_assert!(as_a_whole || moment.norm() < 1e-9 * (1.0 + wrench.force.norm()));
        let opposite = Wrench::at(&place(other, &theirs), -wrench.force, -moment);
        let both = [(link, wrench), (other, opposite)];
        let again = kernel.hybrid([&q, &v], &free, [&nothing, &tau], &both).expect("valid");
        for (x, y) in again[0].iter().zip(&found) {
            prop_assert!((x - y).abs() <= 1e-9 * (1.0 + y.abs()));
        }
    }

    /// A point that is held along one direction does not move along it, and the force on it has no other direction.
    #[test]
    fn a_point_held_along_a_direction_slides_across_it(seed in any::<u64>(), links in 3_usize..9) {
        let mut random = Random::new(seed);
        let figure = tree(&mut random, links, 0.3);
        let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
        let n = kernel.tree.nv();
        let (q, v) = (random.slice(n, 2.0), random.slice(n, 1.0));
        let tau = random.slice(n, 10.0);
        let matrix = kernel.mass_matrix(&q).expect("valid");
        let eigenvalues = if n == 0 { DVector::zeros(1) } else { matrix.symmetric_eigenvalues() };
        prop_assume!(eigenvalues.min() > 1e-4 * eigenvalues.max());
        let along = random.vector(1.0).normalize();
        let contact = ContactConstraint {
            acceleration: random.vector(2.0),
            ..ContactConstraint::along(links - 1, random.vector(0.3), along)
        };
        let (free, nothing) = (vec![false; n], vec![0.0; n]);
        let solved = solve(&mut kernel, &[contact], [&q, &v], &free, [&nothing, &tau]).expect("valid");
        let (found, _, wrenches, residuals) = solved;
        prop_assert_eq!(residuals.len(), 1);
        prop_assume!(residuals[0].abs() < 1e-9 && largest(&found) < 1e3);
        let moved = acceleration(&mut kernel, &contact, [&q, &v, &found]);
        prop_assert!((moved - contact.acceleration).dot(&along).abs() < 1e-5 * (1.0 + largest(&found)));
        let force = wrenches[0].1.force;
        prop_assert!(force.cross(&along).norm() <= 1e-12 * force.norm());
        let again = kernel.hybrid([&q, &v], &free, [&nothing, &tau], &wrenches).expect("valid");
        for (x, y) in again[0].iter().zip(&found) {
            prop_assert!((x - y).abs() <= 1e-9 * (1.0 + y.abs()));
        }
    }
}

/// A table of four legs on a floor that does not give.
fn table() -> (Figure, Vec<Vector3<f64>>) {
    let top = LinkSpec::root("top", Joint::free("root")).mass(20.0).inertia(Inertia::diagonal(2.0, 3.0, 2.5));
    let feet = [(0.5, 0.4), (-0.5, 0.4), (-0.5, -0.4), (0.5, -0.4)];
    let figure = FigureBuilder::new("table").link(top).build().expect("valid");
    (figure, feet.map(|(x, z)| Vector3::new(x, -0.7, z)).to_vec())
}

const AT_REST: [f64; 7] = [0.1, 0.7, 0.2, 0.0, 0.0, 0.0, 1.0];

#[test]
fn four_feet_of_a_table_share_the_load_with_the_least_squares() {
    let (figure, feet) = table();
    let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
    let contacts: Vec<_> = feet.iter().map(|foot| ContactConstraint::point(0, *foot)).collect();
    // A push sideways and a moment, so that the feet carry different loads.
    let tau = [7.0, -3.0, 5.0, 2.0, 1.5, -4.0];
    let free = [false; 6];
    let (a, _, wrenches, residuals) =
        solve(&mut kernel, &contacts, [&AT_REST, &[0.0; 6]], &free, [&[0.0; 6], &tau]).expect("valid");
    assert!(largest(&a) < 1e-10 && largest(&residuals) < 1e-10, "{a:?} {residuals:?}");
    // The least-norm answer to the balance of forces and moments, by singular values.
    let mut map = DMatrix::zeros(6, 12);
    for (i, foot) in feet.iter().enumerate() {
        map.view_mut((0, 3 * i), (3, 3)).fill_with_identity();
        map.view_mut((3, 3 * i), (3, 3)).copy_from(&foot.cross_matrix());
    }
    let right = DVector::from_iterator(
        6,
        tau.iter().enumerate().map(|(k, t)| if k == 1 { 20.0 * 9.81 - t } else { -t }),
    );
    let expected = map.svd(true, true).solve(&right, 1e-12).expect("solved");
    for (i, (_, wrench)) in wrenches.iter().enumerate() {
        let wanted = Vector3::new(expected[3 * i], expected[3 * i + 1], expected[3 * i + 2]);
        assert!((wrench.force - wanted).norm() < 1e-8, "foot {i}: {:?}, {wanted:?}", wrench.force);
    }
}

#[test]
fn lanes_of_different_rank_are_solved_at_once() {
    use solaris_dynamics::scalar::Lanes;
    let (figure, feet) = table();
    let mut kernel = Kernel::<Lanes<2>>::new(&figure, GRAVITY);
    // In the second lane two feet stand at the same place.
    let contacts: Vec<_> = [(feet[0], feet[0]), (feet[1], feet[0])]
        .iter()
        .map(|(first, second)| {
            ContactConstraint::point(0, Vector3::from_fn(|i, _| Lanes::new([first[i], second[i]])))
        })
        .collect();
    let splat = |values: &[f64]| values.iter().map(|x| Lanes::splat(*x)).collect::<Vec<_>>();
    let (q, zero, tau) = (splat(&AT_REST), splat(&[0.0; 6]), splat(&[7.0, -3.0, 5.0, 2.0, 1.5, -4.0]));
    let (a, _, wrenches, _) =
        solve(&mut kernel, &contacts, [&q, &zero], &[false; 6], [&zero, &tau]).expect("valid");
    for (lane, places) in [[feet[0], feet[1]], [feet[0], feet[0]]].iter().enumerate() {
        let mut single = Kernel::<f64>::new(&figure, GRAVITY);
        let contacts = places.map(|place| ContactConstraint::point(0, place));
        let tau = [7.0, -3.0, 5.0, 2.0, 1.5, -4.0];
        let (expected, _, single_wrenches, _) =
            solve(&mut single, &contacts, [&AT_REST, &[0.0; 6]], &[false; 6], [&[0.0; 6], &tau])
                .expect("valid");
        for (x, y) in a.iter().zip(&expected) {
            assert!((x.lane(lane) - y).abs() < 1e-10);
        }
        for ((_, x), (_, y)) in wrenches.iter().zip(&single_wrenches) {
            assert!((x.force.map(|force| force.lane(lane)) - y.force).norm() < 1e-8);
        }
    }
}

#[test]
fn contacts_that_contradict_each_other_tell_what_they_miss() {
    let (figure, feet) = table();
    let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
    let up = ContactConstraint {
        acceleration: Vector3::new(0.0, 3.0, 0.0),
        ..ContactConstraint::point(0, feet[0])
    };
    let contacts = [ContactConstraint::point(0, feet[0]), up];
    let (_, _, _, residuals) =
        solve(&mut kernel, &contacts, [&AT_REST, &[0.0; 6]], &[false; 6], [&[0.0; 6]; 2]).expect("valid");
    assert!(largest(&residuals[..3]) < 1e-10 && (residuals[4] - 3.0).abs() < 1e-9, "{residuals:?}");
}

#[test]
fn a_fixed_link_hands_on_its_whole_weight_and_moment() {
    let (figure, _) = table();
    let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
    let held = [ContactConstraint::fixed(0, Vector3::new(0.3, 0.0, 0.0))];
    let (a, _, wrenches, _) =
        solve(&mut kernel, &held, [&AT_REST, &[0.0; 6]], &[false; 6], [&[0.0; 6]; 2]).expect("valid");
    let (_, wrench) = &wrenches[0];
    assert!(largest(&a) < 1e-12);
    assert!((wrench.force - Vector3::new(0.0, 196.2, 0.0)).norm() < 1e-10, "{wrench:?}");
    // About the world's origin: the weight acts at the centre of mass, wherever the link is held.
    let moment = Vector3::new(0.1, 0.7, 0.2).cross(&Vector3::new(0.0, 196.2, 0.0));
    assert!((wrench.moment - moment).norm() < 1e-9, "{wrench:?}");
}

#[test]
fn a_contact_of_no_link_is_refused() {
    let (figure, _) = table();
    let mut kernel = Kernel::<f64>::new(&figure, GRAVITY);
    let wrong = [ContactConstraint::point(3, Vector3::zeros())];
    let error = solve(&mut kernel, &wrong, [&AT_REST, &[0.0; 6]], &[false; 6], [&[0.0; 6]; 2])
        .expect_err("no link 3");
    assert!(matches!(error, DynamicsError::Contact { index: 0, last: 0, .. }), "{error}");
    let other = Tree::<f64>::new(&tree(&mut Random::new(3), 5, 0.0), GRAVITY).expect("valid");
    let mut contacts = Contacts::new(&other, vec![]);
    let Kernel { tree, workspace } = &mut kernel;
    let (mut a, mut tau) = ([0.0; 6], [0.0; 6]);
    let result = contact_dynamics(
        tree,
        workspace,
        &mut contacts,
        &AT_REST,
        &[0.0; 6],
        &[false; 6],
        &[],
        &mut a,
        &mut tau,
    );
    assert_eq!(result, Err(DynamicsError::Workspace));
}

/// Points under both feet of a person who stands bent, with no force in any joint: most of what
/// the points hold is held several times over, along directions that are none of the coordinate axes.
#[test]
fn many_points_under_both_feet_hold_to_rounding() {
    use solaris_dynamics::scalar::DoubleDouble;
    use solaris_model::human;
    let person = human(1.75, 73.0).expect("within range");
    let n = person.layout().nv();
    let mut random = Random::new(8);
    // At rest: points of a foot that turns cannot all stay where they are.
    let (q, v) = (random.slice(n, 0.05), vec![0.0; n]);
    let feet = ["left_foot", "right_foot"].map(|name| person.link_index(name).expect("a foot"));
    for points in [2, 3, 4] {
        let mut kernel = Kernel::<f64>::new(&person, GRAVITY);
        let corners = [(-0.03, -0.05), (0.04, -0.05), (0.04, 0.12), (-0.03, 0.12)];
        let list: Vec<_> = feet
            .iter()
            .flat_map(|&foot| {
                corners[..points]
                    .iter()
                    .map(move |(x, z)| ContactConstraint::point(foot, Vector3::new(*x, -0.06, *z)))
            })
            .collect();
        let free = vec![false; n];
        let zero = vec![0.0; n];
        let (a, _, wrenches, residuals) =
            solve(&mut kernel, &list, [&q, &v], &free, [&zero, &zero]).expect("valid");
        let scale = largest(&a);
        assert!(largest(&residuals) < 1e-9 * scale, "{points} points: {:e} of {scale}", largest(&residuals));

        let wide = |values: &[f64]| values.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
        let wide_list: Vec<_> = list
            .iter()
            .map(|c| ContactConstraint::point(c.link, c.point.map(DoubleDouble::from_f64)))
            .collect();
        let mut wide_kernel = Kernel::<DoubleDouble>::new(&person, GRAVITY);
        let (_, _, expected, _) =
            solve(&mut wide_kernel, &wide_list, [&wide(&q), &wide(&v)], &free, [&wide(&zero), &wide(&zero)])
                .expect("valid");
        let greatest = wrenches.iter().map(|(_, w)| w.force.norm()).fold(0.0, f64::max);
        for ((_, found), (_, wanted)) in wrenches.iter().zip(&expected) {
            let error = (found.force - wanted.force.map(DoubleDouble::to_f64)).norm();
            assert!(error < 1e-7 * greatest, "{points} points: {error:e} N of {greatest} N");
        }
    }
}

#[test]
fn a_contact_can_change_its_link_but_not_its_kind() {
    let leg = LinkSpec::child("leg", "top", Joint::new("hinge").rx())
        .mass(2.0)
        .inertia(Inertia::diagonal(0.1, 0.1, 0.1));
    let top = LinkSpec::root("top", Joint::free("root")).mass(20.0).inertia(Inertia::diagonal(2.0, 3.0, 2.5));
    let two = FigureBuilder::new("two")
        .link(top)
        .link(leg.com(Vector3::new(0.0, -0.3, 0.1)))
        .build()
        .expect("valid");
    let mut kernel = Kernel::<f64>::new(&two, GRAVITY);
    let mut contacts = Contacts::new(&kernel.tree, vec![ContactConstraint::point(0, Vector3::y())]);
    let q: Vec<f64> = AT_REST.iter().copied().chain([0.3]).collect();
    let Kernel { tree, workspace } = &mut kernel;
    contacts.contacts_mut()[0] = ContactConstraint::point(1, Vector3::x());
    let (mut a, mut tau, free) = ([0.0; 7], [0.0; 7], [false; 7]);
    let mut solve = |contacts: &mut Contacts<f64>| {
        contact_dynamics(tree, workspace, contacts, &q, &[0.0; 7], &free, &[], &mut a, &mut tau)
    };
    let missing = solve(&mut contacts).expect("valid");
    assert!(missing < 1e-12 && contacts.wrenches()[0].0 == 1, "{missing}");
    contacts.contacts_mut()[0] = ContactConstraint::fixed(1, Vector3::x());
    let error = solve(&mut contacts).expect_err("six conditions in place of three");
    assert!(matches!(error, DynamicsError::Length { expected: 3, found: 6, .. }), "{error}");
}
