//! No result depends on the choice of the root.

use crate::support::random::{Random, Root, State, tree_on};
use crate::support::{Kernel, is_whole, largest, rebuilt, relative_error};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use proptest::prelude::*;
use solaris_dynamics::scalar::Dual;
use solaris_dynamics::{RootView, RootViewError, relink};
use solaris_model::{Axis, Figure, FigureBuilder, Joint, LinkSpec, RerootError, RootAt, SolePart, human};

/// A figure and a view of it in the same state.
struct Case {
    figure: Figure,
    view: RootView<f64>,
    declared: Kernel<f64>,
    seen: Kernel<f64>,
    state: State,
    there: State,
}

impl Case {
    /// A random tree from a random link; `None` where that link cannot be the root.
    fn random(seed: u64, root: Root) -> Option<Self> {
        let mut random = Random::new(seed);
        let figure = tree_on(root, &mut random);
        let gravity = random.vector(10.0);
        let link = random.below(figure.links().len());
        let at = [RootAt::Joint, RootAt::Tip, RootAt::Point(random.vector(0.3))][random.below(3)];
        let state = State::random(&figure, &mut random);
        match RootView::new(&figure, link, at) {
            Ok(view) => Some(Self::of(figure, view, gravity, state)),
            Err(RootViewError::Reroot(RerootError::Massless { .. })) => None,
            Err(error) => panic!("{error}"),
        }
    }

    fn of(figure: Figure, view: RootView<f64>, gravity: Vector3<f64>, state: State) -> Self {
        let mut there = State::zeros(view.figure());
        view.to_view(&state.q, &state.v, &state.a, &mut there.q, &mut there.v, &mut there.a).expect("valid");
        let (declared, seen) = (Kernel::new(&figure, gravity), Kernel::new(view.figure(), gravity));
        Self { figure, view, declared, seen, state, there }
    }
}

fn close(a: &Vector3<f64>, b: &Vector3<f64>, scale: f64) -> bool {
    (a - b).amax() < 1e-9 * scale.max(a.amax())
}

fn near(found: &[f64], expected: &[f64], scale: f64) -> bool {
    found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-9 * scale)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// The same motion takes the same forces, through whatever root they are found.
    #[test]
    fn forces_do_not_depend_on_the_root(seed in any::<u64>(), root in 0..3_usize) {
        let Some(mut case) = Case::random(seed, [Root::Free, Root::Six, Root::Any][root]) else { return Ok(()) };
        let mut random = Random::new(!seed);
        let links = case.figure.links().len();
        let mut external = [random.wrench(links), random.wrench(links)];
        let (State { q, v, a }, there) = (&case.state, &case.there);
        let tau = case.declared.inverse(q, v, a, &external).expect("valid");
        relink(&mut external, case.view.rerooted().links()).expect("links");
        let seen = case.seen.inverse(&there.q, &there.v, &there.a, &external).expect("valid");
        let mut back = vec![0.0; tau.len()];
        case.view.forces_from_view(&there.q, &seen, q, a, &mut back).expect("valid");
        let (base, base_there) = (case.declared.workspace.base_wrench(), case.seen.workspace.base_wrench());
        let scale = largest(&tau).max(base.force.amax()).max(1.0);
        prop_assert!(near(&back, &tau, scale), "{back:?} {tau:?}");
        prop_assert!(close(&base.force, &base_there.force, scale));
        prop_assert!(close(&base.moment, &base_there.moment, scale));
        let mut forth = vec![0.0; seen.len()];
        case.view.forces_to_view(&tau, &base, &there.q, &mut forth).expect("valid");
        prop_assert!(near(&forth, &seen, scale), "{forth:?} {seen:?}");
    }

    /// With the same forces from outside, nothing left over, every joint has the same force from every root.
    #[test]
    fn joint_forces_do_not_depend_on_the_root(seed in any::<u64>(), root in 0..3_usize) {
        let Some(mut case) = Case::random(seed, [Root::Free, Root::Six, Root::Any][root]) else { return Ok(()) };
        let mut random = Random::new(!seed);
        let links = case.figure.links().len();
        let mut external = vec![random.wrench(links), random.wrench(links)];
        let (State { q, v, a }, there) = (&case.state, &case.there);
        // What is left over goes to any link: then it is left over no more.
        case.declared.inverse(q, v, a, &external).expect("valid");
        external.push((random.below(links), case.declared.workspace.base_wrench()));
        let tau = case.declared.inverse(q, v, a, &external).expect("valid");
        relink(&mut external, case.view.rerooted().links()).expect("links");
        let seen = case.seen.inverse(&there.q, &there.v, &there.a, &external).expect("valid");
        let scale = largest(&tau).max(external[2].1.force.amax()).max(1.0);
        prop_assert!(largest(&seen[..6]) < 1e-9 * scale);
        let mut back = vec![f64::NAN; tau.len()];
        case.view.joint_forces_from_view(&seen, q, &mut back).expect("valid");
        let armature = case.figure.links()[0].joint().kind();
        for (k, found) in back[..armature.nv()].iter_mut().enumerate() {
            *found += armature.armature(k) * a[k];
        }
        prop_assert!(near(&back, &tau, scale), "{back:?} {tau:?}");
    }

    /// What the new root carries in the view, the declared figure is given from outside.
    #[test]
    fn the_new_root_carries_what_is_left_over(seed in any::<u64>()) {
        let Some(mut case) = Case::random(seed, Root::Free) else { return Ok(()) };
        let (State { q, v, a }, there) = (&case.state, &case.there);
        let seen = case.seen.inverse(&there.q, &there.v, &there.a, &[]).expect("valid");
        let external = [(case.view.rerooted().path()[0], case.seen.workspace.base_wrench())];
        let tau = case.declared.inverse(q, v, a, &external).expect("valid");
        let mut back = vec![f64::NAN; tau.len()];
        case.view.joint_forces_from_view(&seen, q, &mut back).expect("valid");
        prop_assert!(near(&back, &tau, largest(&seen).max(1.0)), "{back:?} {tau:?}");
    }

    /// Energies, momentum, centre of mass, and the pose and velocity of every link.
    #[test]
    fn matter_moves_alike_from_every_root(seed in any::<u64>(), root in 0..3_usize) {
        let Some(mut case) = Case::random(seed, [Root::Free, Root::Six, Root::Any][root]) else { return Ok(()) };
        let (State { q, v, .. }, there) = (&case.state, &case.there);
        let kinetic = case.declared.kinetic(q, v);
        let armature: f64 = (0..case.figure.links()[0].joint().kind().nv())
            .map(|k| case.figure.links()[0].joint().kind().armature(k) * v[k] * v[k] / 2.0)
            .sum();
        // The declared root's own armature is none of the view's.
        prop_assert!((kinetic - armature - case.seen.kinetic(&there.q, &there.v)).abs() < 1e-9 * kinetic.max(1.0));
        let potential = case.declared.potential(q);
        prop_assert!((potential - case.seen.potential(&there.q)).abs() < 1e-9 * potential.abs().max(10.0));
        prop_assert!(close(&case.declared.center_of_mass(q), &case.seen.center_of_mass(&there.q), 1.0));
        let (momentum, seen) = (case.declared.momentum(q, v), case.seen.momentum(&there.q, &there.v));
        prop_assert!(close(&momentum.linear, &seen.linear, 1.0));
        prop_assert!(close(&momentum.angular, &seen.angular, 1.0));
        for (link, place) in case.view.rerooted().links().iter().enumerate() {
            let (pose, twist) = (case.declared.workspace.pose(link), case.declared.workspace.velocity(link));
            let (carried, moved) = (case.seen.workspace.pose_of(place), case.seen.workspace.velocity_of(place));
            prop_assert!((pose.rotation - carried.rotation).amax() < 1e-9);
            prop_assert!(close(&pose.translation, &carried.translation, 1.0));
            prop_assert!(close(&twist.linear, &moved.linear, 1.0));
            prop_assert!(close(&twist.angular, &moved.angular, 1.0));
        }
    }

    /// Every link accelerates alike: a view from it has the same free root whether it is made of the figure or of a view.
    #[test]
    fn links_accelerate_alike_from_every_root(seed in any::<u64>()) {
        let Some(case) = Case::random(seed, Root::Any) else { return Ok(()) };
        for link in 0..case.figure.links().len() {
            let place = case.view.rerooted().links()[link];
            let Ok(one) = RootView::<f64>::new(&case.figure, link, RootAt::Joint) else { continue };
            let at = RootAt::Point(place.placement.translation.vector);
            let two = RootView::<f64>::new(case.view.figure(), place.link, at).expect("as good as from the figure");
            let [from_one, from_two] = [(&one, &case.state), (&two, &case.there)].map(|(view, state)| {
                let mut seen = State::zeros(view.figure());
                view.to_view(&state.q, &state.v, &state.a, &mut seen.q, &mut seen.v, &mut seen.a).expect("valid");
                seen
            });
            // The second may stand turned in the link by a fixed rotation.
            let turn = place.placement.rotation.to_rotation_matrix();
            let three = |values: &[f64], from: usize| Vector3::new(values[from], values[from + 1], values[from + 2]);
            prop_assert!(close(&three(&from_one.q, 0), &three(&from_two.q, 0), 1.0));
            for from in [0, 3] {
                let (x, y) = (three(&from_one.v, from), turn.inverse() * three(&from_two.v, from));
                prop_assert!(close(&x, &y, 1.0), "velocity {x} {y}");
                let (x, y) = (three(&from_one.a, from), turn.inverse() * three(&from_two.a, from));
                prop_assert!(close(&x, &y, 10.0), "acceleration {x} {y}");
            }
        }
    }

    /// The builder finds nothing wrong with it.
    #[test]
    fn the_views_figure_is_valid(seed in any::<u64>()) {
        let Some(case) = Case::random(seed, Root::Any) else { return Ok(()) };
        let again = rebuilt(case.view.figure());
        prop_assert!(again.is_ok(), "{again:?}");
        let again = again.expect("valid");
        prop_assert_eq!(again.layout().v_names(), case.view.figure().layout().v_names());
    }

    /// To the view and back, and from the view there and back.
    #[test]
    fn states_come_back(seed in any::<u64>(), free in any::<bool>()) {
        let Some(case) = Case::random(seed, if free { Root::Free } else { Root::Six }) else { return Ok(()) };
        let State { q, v, a } = &case.there;
        // The configuration of a moment ago tells which of several equal ones is meant.
        let mut back = State { q: case.state.q.iter().map(|x| x + 0.01).collect(), ..State::zeros(&case.figure) };
        case.view.from_view(q, v, a, &mut back.q, &mut back.v, &mut back.a).expect("far from the lock");
        // Near the lock the rates of a root of three turns grow with its secant.
        let loss = if free { 1.0 } else { secant(&case) };
        prop_assert!(relative_error(&back.q, &case.state.q) < 1e-12 * loss, "{:?} {:?}", back.q, case.state.q);
        prop_assert!(relative_error(&back.v, &case.state.v) < 1e-12 * loss, "{:?} {:?}", back.v, case.state.v);
        prop_assert!(relative_error(&back.a, &case.state.a) < 1e-11 * loss * loss, "{:?} {:?}", back.a, case.state.a);
    }

    /// No force does other work in the view: power of the inner joints and of the root together.
    #[test]
    fn power_does_not_depend_on_the_root(seed in any::<u64>()) {
        let Some(mut case) = Case::random(seed, Root::Free) else { return Ok(()) };
        let (State { q, v, a }, there) = (&case.state, &case.there);
        let tau = case.declared.inverse(q, v, a, &[]).expect("valid");
        let seen = case.seen.inverse(&there.q, &there.v, &there.a, &[]).expect("valid");
        let power = |tau: &[f64], v: &[f64]| tau.iter().zip(v).map(|(tau, v)| tau * v).sum::<f64>();
        let scale: f64 = tau.iter().zip(v).map(|(tau, v)| (tau * v).abs()).sum();
        prop_assert!((power(&tau, v) - power(&seen, &there.v)).abs() < 1e-9 * scale.max(1.0));
    }
}

/// One over the cosine of the declared root's middle turn.
fn secant(case: &Case) -> f64 {
    case.state.q[4].cos().abs().recip()
}

fn person() -> Figure {
    human(1.75, 73.0).expect("in range")
}

/// The thesis walks with the stance foot as root.
#[test]
fn a_human_on_its_left_foot() {
    let figure = person();
    let gravity = Vector3::new(0.0, -9.806_65, 0.0);
    let foot = figure.link_index("left_foot").expect("a link");
    let ball = *figure.links()[foot].sole_point(SolePart::Ball).expect("a point");
    let state = State::random(&figure, &mut Random::new(3));
    let view = RootView::new(&figure, foot, RootAt::Point(ball)).expect("massive links");
    let mut case = Case::of(figure, view, gravity, state);
    let (State { q, v, a }, there) = (&case.state, &case.there);
    let tau = case.declared.inverse(q, v, a, &[]).expect("valid");
    let seen = case.seen.inverse(&there.q, &there.v, &there.a, &[]).expect("valid");
    let mut back = vec![0.0; 66];
    case.view.forces_from_view(&there.q, &seen, q, a, &mut back).expect("valid");
    assert!(relative_error(&back, &tau) < 1e-12, "{}", relative_error(&back, &tau));
    // The view's root stands where the ball of the foot stands.
    case.declared.place(q);
    let at = case.declared.workspace.pose(foot).transform(&ball);
    assert!((at - Vector3::new(there.q[0], there.q[1], there.q[2])).amax() < 1e-13);
    // The names of the columns stay, but for the root's.
    for (k, name) in case.figure.layout().v_names().iter().enumerate().skip(6) {
        let dof = case.view.figure().layout().dof_index(name).expect("the same name");
        assert!((there.v[dof] - v[k]).abs() < 1e-15, "{name}");
    }
}

/// Through dual numbers along time, the velocities of the view are the rates of its positions, its accelerations those of
/// its velocities: no recursion of the accelerations is asked.
#[test]
fn accelerations_of_the_view_are_rates_of_its_velocities() {
    let figure = person();
    let state = State::random(&figure, &mut Random::new(21));
    let along = |x: &[f64], rate: &[f64]| {
        x.iter().zip(rate).map(|(x, r)| Dual::new(*x, [*r])).collect::<Vec<Dual<1>>>()
    };
    let still = |x: &[f64]| along(x, &vec![0.0; x.len()]);
    let (q, v, a) = (along(&state.q, &state.v), along(&state.v, &state.a), still(&state.a));
    let view = RootView::<Dual<1>>::new(&figure, 12, RootAt::Joint).expect("massive links");
    let (mut q_view, mut v_view, mut a_view) = (still(&[0.0; 67]), still(&[0.0; 66]), still(&[0.0; 66]));
    view.to_view(&q, &v, &a, &mut q_view, &mut v_view, &mut a_view).expect("valid");
    for (v, a) in v_view.iter().zip(&a_view) {
        assert!((v.partial(0) - a.value()).abs() < 1e-11, "{v:?} {a:?}");
    }
    let turn = UnitQuaternion::from_quaternion(Quaternion::new(
        q_view[6].value(),
        q_view[3].value(),
        q_view[4].value(),
        q_view[5].value(),
    ));
    let moves = turn * Vector3::new(v_view[0].value(), v_view[1].value(), v_view[2].value());
    for (i, x) in q_view[..3].iter().enumerate() {
        assert!((x.partial(0) - moves[i]).abs() < 1e-12);
    }
}

/// At 100 km from the world's origin the declared root's forces keep their digits.
#[test]
fn forces_are_taken_home_from_far_away() {
    let figure = person();
    let mut random = Random::new(8);
    let mut state = State::random(&figure, &mut random);
    state.q[..3].copy_from_slice(&[1e5, 2e4, -6e4]);
    let view = RootView::new(&figure, 20, RootAt::Joint).expect("massive links");
    let mut case = Case::of(figure, view, Vector3::new(0.0, -9.806_65, 0.0), state);
    let (State { q, v, a }, there) = (&case.state, &case.there);
    let tau = case.declared.inverse(q, v, a, &[]).expect("valid");
    let seen = case.seen.inverse(&there.q, &there.v, &there.a, &[]).expect("valid");
    let mut back = vec![0.0; 66];
    case.view.forces_from_view(&there.q, &seen, q, a, &mut back).expect("valid");
    assert!(relative_error(&back, &tau) < 1e-10, "{}", relative_error(&back, &tau));
}

fn two_links(root: Joint) -> Figure {
    let child = LinkSpec::child("b", "a", Joint::new("hinge").rx()).mass(1.0);
    FigureBuilder::new("two").link(LinkSpec::root("a", root).mass(1.0)).link(child).build().expect("valid")
}

/// A root that cannot take every motion is named, and its gimbal lock too.
#[test]
fn what_the_declared_root_cannot_take_is_refused() {
    let narrow = [
        Joint::new("base").tx().ty().tz(),
        Joint::ball("base"),
        Joint::new("base").rx().ry().rz().tx().ty().tz(),
        Joint::new("base").tx().ty().tz().rz().rx().rz(),
        Joint::new("base").tx().ty().tz().rz().ry().axis(Axis::rotation(Vector3::new(1.0, 1.0, 0.0))),
    ];
    let solve = |root: Joint, q: &[f64]| {
        let figure = two_links(root);
        let view = RootView::<f64>::new(&figure, 1, RootAt::Joint).expect("massive links");
        let (mut there, mut back) = (State::zeros(view.figure()), State::zeros(&figure));
        back.q.copy_from_slice(q);
        let state = back.clone();
        view.to_view(&state.q, &state.v, &state.a, &mut there.q, &mut there.v, &mut there.a).expect("valid");
        view.from_view(&there.q, &there.v, &there.a, &mut back.q, &mut back.v, &mut back.a)
    };
    for joint in narrow {
        let mut q = vec![0.0; joint.kind().nq() + 1];
        if is_whole(joint.kind()) {
            q[3] = 1.0;
        }
        assert_eq!(solve(joint, &q), Err(RootViewError::Root { joint: "base".into() }));
    }
    let lock = solve(
        Joint::new("base").tx().ty().tz().rz().ry().rx(),
        &[0.0, 0.0, 0.0, 0.3, std::f64::consts::FRAC_PI_2, 0.2, 0.1],
    );
    assert!(matches!(lock, Err(RootViewError::Lock { .. })), "{lock:?}");
}
