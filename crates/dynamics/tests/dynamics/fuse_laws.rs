//! Fusing changes no result: the small figure moves like the full one with the fused degrees of freedom at rest.

use crate::support::random::{Random, Root, State, tree_on};
use crate::support::{Kernel, is_whole, largest, rebuilt, relative_error};
use nalgebra::Vector3;
use proptest::prelude::*;
use solaris_dynamics::scalar::{Counted, Operations};
use solaris_dynamics::{FusedForces, Scalar, relink};
use solaris_model::{Figure, Fused, human};

/// A figure, its fused one, and a state of both with the fused degrees of freedom at rest.
struct Case {
    fused: Fused,
    full: Kernel<f64>,
    small: Kernel<f64>,
    state: State,
    less: State,
    external: Vec<(usize, solaris_dynamics::Wrench<f64>)>,
}

impl Case {
    fn random(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let figure = tree_on(Root::Any, &mut random);
        let gravity = random.vector(10.0);
        let mut state = State::random(&figure, &mut random);
        let mut dofs = Vec::new();
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            let together = is_whole(link.joint().kind()) || random.below(3) == 0;
            let all = random.below(2) == 0;
            for dof in at.v..at.v + at.nv {
                let one = random.below(2) == 0;
                if if together { all } else { one } {
                    dofs.push(dof);
                    (state.v[dof], state.a[dof]) = (0.0, 0.0);
                }
            }
        }
        let fused = figure.fuse_at(&dofs, &state.q).expect("whole joints");
        let links = figure.links().len();
        let external = vec![random.wrench(links), random.wrench(links)];
        Self::of(&figure, fused, gravity, state, external)
    }

    fn of(
        figure: &Figure,
        fused: Fused,
        gravity: Vector3<f64>,
        state: State,
        external: Vec<(usize, solaris_dynamics::Wrench<f64>)>,
    ) -> Self {
        let mut less = State::zeros(fused.figure());
        fused.q_to_small(&state.q, &mut less.q).expect("lengths");
        fused.v_to_small(&state.v, &mut less.v).expect("lengths");
        fused.v_to_small(&state.a, &mut less.a).expect("lengths");
        let (full, small) = (Kernel::new(figure, gravity), Kernel::new(fused.figure(), gravity));
        Self { fused, full, small, state, less, external }
    }

    /// Entries of the full figure that are left.
    fn kept(&self, full: &[f64]) -> Vec<f64> {
        self.fused.kept_v().iter().map(|&k| full[k]).collect()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// The remaining forces are those of the full figure, the fused ones are found when asked for, and the world carries
    /// the same.
    #[test]
    fn forces_are_those_of_the_full_figure(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let State { q, v, a } = &case.state;
        let tau = case.full.inverse(q, v, a, &case.external).expect("valid");
        let mut external = case.external.clone();
        relink(&mut external, case.fused.links()).expect("links");
        let State { q, v, a } = &case.less;
        let found = case.small.inverse(q, v, a, &external).expect("valid");
        let kept = case.kept(&tau);
        let scale = largest(&tau).max(1.0);
        for (found, expected) in found.iter().zip(&kept) {
            prop_assert!((found - expected).abs() < 1e-12 * scale, "{found} {expected} {scale}");
        }
        let (base, small_base) = (case.full.workspace.base_wrench(), case.small.workspace.base_wrench());
        prop_assert!((base.force - small_base.force).amax() < 1e-12 * base.force.amax().max(100.0));
        prop_assert!((base.moment - small_base.moment).amax() < 1e-12 * base.moment.amax().max(100.0));
        let mut forces = FusedForces::new(&case.fused, &case.full.tree).expect("its tree");
        let mut all = vec![0.0; tau.len()];
        forces.solve(&case.full.tree, q, v, a, &case.external, &mut all).expect("valid");
        prop_assert!(all.iter().zip(&tau).all(|(x, y)| (x - y).abs() < 1e-12 * scale), "{all:?} {tau:?}");
    }

    /// The mass matrix is the part of the full one that is left.
    #[test]
    fn the_mass_matrix_is_a_part_of_the_full_one(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let full = case.full.mass_matrix(&case.state.q).expect("valid");
        let small = case.small.mass_matrix(&case.less.q).expect("valid");
        let scale = full.amax();
        for (i, &k) in case.fused.kept_v().iter().enumerate() {
            for (j, &l) in case.fused.kept_v().iter().enumerate() {
                prop_assert!((small[(i, j)] - full[(k, l)]).abs() < 1e-12 * scale, "{i} {j}");
            }
        }
    }

    /// Energies, momentum, centre of mass, and every link of the full figure, wherever it is carried.
    #[test]
    fn matter_moves_alike(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (State { q, v, .. }, State { q: less_q, v: less_v, .. }) = (&case.state, &case.less);
        let energies = [case.full.kinetic(q, v), case.full.potential(q)];
        let small = [case.small.kinetic(less_q, less_v), case.small.potential(less_q)];
        prop_assert!((energies[0] - small[0]).abs() < 1e-12 * energies[0].max(1.0));
        prop_assert!((energies[1] - small[1]).abs() < 1e-12 * energies[1].abs().max(100.0));
        let center = case.full.center_of_mass(q) - case.small.center_of_mass(less_q);
        prop_assert!(center.amax() < 1e-12);
        let (momentum, small) = (case.full.momentum(q, v), case.small.momentum(less_q, less_v));
        prop_assert!((momentum.linear - small.linear).amax() < 1e-12 * momentum.linear.amax().max(1.0));
        prop_assert!((momentum.angular - small.angular).amax() < 1e-12 * momentum.angular.amax().max(1.0));
        for (link, place) in case.fused.links().iter().enumerate() {
            let (pose, twist) = (case.full.workspace.pose(link), case.full.workspace.velocity(link));
            let (carried, moved) = (case.small.workspace.pose_of(place), case.small.workspace.velocity_of(place));
            prop_assert!((pose.rotation - carried.rotation).amax() < 1e-12);
            prop_assert!((pose.translation - carried.translation).amax() < 1e-12);
            let scale = twist.linear.amax().max(1.0);
            prop_assert!((twist.linear - moved.linear).amax() < 1e-12 * scale);
            prop_assert!((twist.angular - moved.angular).amax() < 1e-12 * scale);
        }
    }

    /// The builder finds nothing wrong with it.
    #[test]
    fn the_small_figure_is_valid(seed in any::<u64>()) {
        let case = Case::random(seed);
        let again = rebuilt(case.fused.figure());
        prop_assert!(again.is_ok(), "{again:?}");
        let again = again.expect("valid");
        prop_assert_eq!(again.layout().v_names(), case.fused.figure().layout().v_names());
    }

    /// States come back, with the fused values in place.
    #[test]
    fn states_come_back(seed in any::<u64>()) {
        let case = Case::random(seed);
        let mut back = State { q: vec![f64::NAN; case.state.q.len()], ..case.state.clone() };
        case.fused.q_to_full(&case.less.q, &mut back.q).expect("lengths");
        case.fused.v_to_full(&case.less.v, &mut back.v).expect("lengths");
        case.fused.v_to_full(&case.less.a, &mut back.a).expect("lengths");
        prop_assert!(relative_error(&back.q, &case.state.q) < 1e-15);
        prop_assert_eq!((back.v, back.a), (case.state.v, case.state.a));
    }
}

/// The human with some joints frozen.
fn frozen(joints: &[&str]) -> (Figure, Fused) {
    let figure = human(1.75, 73.0).expect("in range");
    let names = figure.layout().v_names();
    let dofs: Vec<usize> =
        (0..names.len()).filter(|&k| joints.iter().any(|joint| names[k].contains(joint))).collect();
    let q: Vec<f64> = (0..names.len()).map(|k| 0.01 * k as f64 - 0.3).collect();
    let fused = figure.fuse_at(&dofs, &q).expect("dofs");
    (figure, fused)
}

const ARMS: [&str; 4] = ["clavicle", "shoulder", "elbow", "wrist"];

/// Operations of one inverse dynamics.
fn operations(figure: &Figure) -> Operations {
    let mut kernel = Kernel::<Counted>::new(figure, Vector3::new(0.0, -9.806_65, 0.0));
    let n = figure.layout().nv();
    let state: Vec<Counted> = (0..n).map(|k| Counted::from_f64(0.1 + 0.01 * k as f64)).collect();
    Counted::measure(|| kernel.inverse(&state, &state, &state, &[]).expect("valid")).1
}

/// Fewer degrees of freedom and fewer links cost less in the same proportion.
#[test]
fn the_cost_drops_in_proportion() {
    let whole = human(1.75, 73.0).expect("in range");
    let all = operations(&whole);
    let rows: [(&str, &[&str]); 4] = [
        ("toes", &["toes"]),
        ("arms", &ARMS),
        ("arms, neck, head", &["clavicle", "shoulder", "elbow", "wrist", "neck", "head"]),
        (
            "all but the left leg",
            &["clavicle", "shoulder", "elbow", "wrist", "neck", "head", "lumbar", "thorax", "right_"],
        ),
    ];
    let mut table = vec![row("nothing", 66, all, 1.0)];
    let mut shares = Vec::new();
    for (name, joints) in rows {
        let (_, fused) = frozen(joints);
        let (nv, ops) = (fused.figure().layout().nv(), operations(fused.figure()));
        let share =
            (ops.multiplications + ops.additions) as f64 / (all.multiplications + all.additions) as f64;
        table.push(row(name, nv, ops, share));
        shares.push((share, nv as f64 / 66.0));
        assert_eq!(ops.sines as usize, nv, "{table:?}");
    }
    for (share, dofs) in shares {
        assert!(share <= dofs && share > dofs - 0.04, "{all:?}\n{table:?}");
    }
    let table = table.concat();
    for page in [include_str!("../../../../docs/dynamics.md"), include_str!("../../README.md")] {
        assert!(page.contains(&table), "docs/dynamics.md and the crate's README should say\n\n{table}\n");
    }
}

/// A row of the table of the documentation.
fn row(name: &str, dofs: usize, operations: Operations, share: f64) -> String {
    let Operations { multiplications, additions, .. } = operations;
    format!("| {name} | {dofs} | {multiplications} | {additions} | {:.0} % |\n", 100.0 * share)
}

/// Between one posture and the next the frozen arms cost nothing, and the torques that hold them are there.
#[test]
fn a_human_with_frozen_arms_moves_like_one_that_holds_them_still() {
    let (figure, fused) = frozen(&ARMS);
    let mut random = Random::new(5);
    let mut state = State::random(&figure, &mut random);
    for k in 0..66 {
        if fused.dof(k).is_none() {
            (state.q[k], state.v[k], state.a[k]) = (fused.rest()[k], 0.0, 0.0);
        }
    }
    let external = vec![random.wrench(21), random.wrench(21)];
    let mut case = Case::of(&figure, fused, Vector3::new(0.0, -9.806_65, 0.0), state, external);
    let State { q, v, a } = &case.state;
    let tau = case.full.inverse(q, v, a, &case.external).expect("valid");
    relink(&mut case.external, case.fused.links()).expect("links");
    let State { q, v, a } = &case.less;
    let found = case.small.inverse(q, v, a, &case.external).expect("valid");
    assert!(relative_error(&found, &case.kept(&tau)) < 1e-13);
    assert_eq!(case.fused.figure().links().len(), 13);
}
