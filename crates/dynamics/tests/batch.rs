//! Many states at once against one at a time.

#![cfg(feature = "batch")]

#[path = "support/allocations.rs"]
mod allocations;
mod support;

use allocations::allocations;
use nalgebra::{DMatrix, Vector3};
use solaris_dynamics::batch::{Batch, BatchError, BatchPartials, Instructions, Layout};
use solaris_dynamics::{Derivatives, DynamicsError, Wrench};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, human};
use support::random::{Joints, Random, random_configuration, tree_of};
use support::{Kernel, largest};

const GRAVITY: Vector3<f64> = Vector3::new(0.3, -9.7, 1.1);

/// States of a figure, each with its forces and what acts on two links.
struct States {
    count: usize,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    links: [usize; 2],
    wrenches: [Vec<Wrench<f64>>; 2],
}

impl States {
    fn random(figure: &Figure, random: &mut Random, count: usize) -> Self {
        let (nv, links) = (figure.layout().nv(), figure.links().len());
        let mut wrenches = || (0..count).map(|_| random.wrench(links).1).collect();
        let wrenches = [wrenches(), wrenches()];
        Self {
            count,
            q: (0..count).flat_map(|_| random_configuration(random, figure)).collect(),
            v: random.slice(count * nv, 2.0),
            a: random.slice(count * nv, 10.0),
            links: [random.below(links), random.below(links)],
            wrenches,
        }
    }

    fn external(&self) -> [(usize, &[Wrench<f64>]); 2] {
        [(self.links[0], &self.wrenches[0]), (self.links[1], &self.wrenches[1])]
    }

    /// The forces that accelerations take.
    fn forces(&self, figure: &Figure, a: &[f64]) -> Vec<f64> {
        let mut kernel = Kernel::<f64>::new(figure, GRAVITY);
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let of = |i: usize| {
            let (q, v, a) = (&self.q[i * nq..][..nq], &self.v[i * nv..][..nv], &a[i * nv..][..nv]);
            let external = self.external().map(|(link, wrenches)| (link, wrenches[i]));
            kernel.inverse(q, v, a, &external).expect("a valid state")
        };
        (0..self.count).flat_map(of).collect()
    }

    /// What one operation finds for each state, and the accelerations that these forces bring.
    fn one_by_one(&self, figure: &Figure) -> [Vec<f64>; 2] {
        let mut kernel = Kernel::<f64>::new(figure, GRAVITY);
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let (mut tau, mut a) = (Vec::new(), Vec::new());
        for i in 0..self.count {
            let (q, v) = (&self.q[i * nq..][..nq], &self.v[i * nv..][..nv]);
            let external = self.external().map(|(link, wrenches)| (link, wrenches[i]));
            tau.extend(kernel.inverse(q, v, &self.a[i * nv..][..nv], &external).expect("a valid state"));
            let forces = &tau[i * nv..];
            a.extend(kernel.forward(q, v, forces, &external).expect("a valid state"));
        }
        [tau, a]
    }
}

/// Forces and their derivatives: of every state first the one, then the others.
#[derive(Clone)]
struct Partials([Vec<f64>; 4]);

impl Partials {
    /// Numbers that no result leaves as they are.
    fn unwritten(figure: &Figure, count: usize) -> Self {
        let nv = figure.layout().nv();
        Self([nv, nv * nv, nv * nv, nv * nv].map(|width| vec![-7.0; width * count]))
    }

    fn one_by_one(figure: &Figure, states: &States) -> Self {
        let mut derivatives = Derivatives::new(figure, GRAVITY).expect("finite constants");
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let mut all = Self([const { Vec::new() }; 4]);
        for i in 0..states.count {
            let external = states.external().map(|(link, wrenches)| (link, wrenches[i]));
            let (v, a) = (&states.v[i * nv..][..nv], &states.a[i * nv..][..nv]);
            let partials = derivatives.inverse_dynamics(&states.q[i * nq..][..nq], v, a, &external);
            let partials = partials.expect("a valid state");
            let matrices = [&partials.by_q, &partials.by_v, &partials.by_input].map(DMatrix::as_slice);
            let parts = [&partials.value[..], matrices[0], matrices[1], matrices[2]];
            all.0.iter_mut().zip(parts).for_each(|(all, part)| all.extend(part));
        }
        all
    }

    fn slices(&mut self) -> BatchPartials<'_, f64> {
        let [value, by_q, by_v, by_input] = &mut self.0;
        BatchPartials { value, by_q, by_v, by_input }
    }
}

fn figures(random: &mut Random) -> Vec<Figure> {
    let mut figures: Vec<Figure> =
        (0..8).map(|i| tree_of(Joints::EveryArmed, random, 2 + 2 * i, 0.5)).collect();
    figures.push(human(1.75, 73.0).expect("an ordinary person"));
    figures
}

fn transposed(values: &[f64], states: usize) -> Vec<f64> {
    let width = values.len() / states.max(1);
    (0..width).flat_map(|k| (0..states).map(move |i| values[i * width + k])).collect()
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|x| x.to_bits()).collect()
}

fn worst(found: &[f64], expected: &[f64]) -> f64 {
    let differences: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    assert!(differences.iter().all(|x| x.is_finite()) && found.len() == expected.len());
    largest(&differences) / largest(expected).max(1e-300)
}

#[test]
fn all_states_have_what_each_has_alone() {
    let mut random = Random::new(77);
    for figure in figures(&mut random) {
        for count in [0, 1, 2, 3, 7, 8, 9, 16, 33] {
            let states = States::random(&figure, &mut random, count);
            let [tau, a] = states.one_by_one(&figure);
            for instructions in Instructions::available() {
                let mut batch =
                    Batch::<f64>::with_instructions(&figure, GRAVITY, instructions).expect("finite");
                let mut found = [vec![f64::NAN; tau.len()], vec![f64::NAN; tau.len()]];
                let State { q, v, given, external } = State::of(&states);
                batch.inverse_dynamics(q, v, given, &external, &mut found[0]).expect("valid states");
                batch.forward_dynamics(q, v, &tau, &external, &mut found[1]).expect("valid states");
                if instructions == Instructions::Baseline && cfg!(target_arch = "x86_64") {
                    assert_eq!(bits(&found[0]), bits(&tau), "{}", figure.name());
                    assert_eq!(bits(&found[1]), bits(&a));
                } else if count > 0 {
                    let error = worst(&found[0], &tau);
                    assert!(error < 2e-14, "{instructions:?}: {error:e}");
                    // The accelerations need the forces that were given, as nearly as those of one state do.
                    let [left, alone] = [&found[1], &a].map(|a| worst(&states.forces(&figure, a), &tau));
                    assert!(left < 4.0 * alone + 1e-14, "{instructions:?}: {left:e}, alone {alone:e}");
                }
            }
        }
    }
}

#[test]
fn all_states_have_the_derivatives_that_each_has_alone() {
    let mut random = Random::new(84);
    for figure in figures(&mut random) {
        for count in [0, 1, 3, 8, 17] {
            let states = States::random(&figure, &mut random, count);
            let alone = Partials::one_by_one(&figure, &states);
            let State { q, v, given, external } = State::of(&states);
            for instructions in Instructions::available() {
                let mut batch =
                    Batch::<f64>::with_instructions(&figure, GRAVITY, instructions).expect("finite");
                let mut found = Partials::unwritten(&figure, count);
                let result = batch.inverse_dynamics_derivatives(q, v, given, &external, &mut found.slices());
                result.expect("valid states");
                for (found, alone) in found.0.iter().zip(&alone.0) {
                    if instructions == Instructions::Baseline && cfg!(target_arch = "x86_64") {
                        assert_eq!(bits(found), bits(alone), "{}", figure.name());
                    } else if count > 0 {
                        let error = worst(found, alone);
                        assert!(error < 1e-13, "{instructions:?}: {error:e}");
                    }
                }
            }
        }
    }
}

/// Slices of states, as a batch takes them.
struct State<'a> {
    q: &'a [f64],
    v: &'a [f64],
    given: &'a [f64],
    external: [(usize, &'a [Wrench<f64>]); 2],
}

impl<'a> State<'a> {
    fn of(states: &'a States) -> Self {
        Self { q: &states.q, v: &states.v, given: &states.a, external: states.external() }
    }
}

#[test]
fn columns_and_threads_change_no_bit() {
    let mut random = Random::new(78);
    for figure in figures(&mut random) {
        for count in [1, 5, 40, 101] {
            let states = States::random(&figure, &mut random, count);
            let State { q, v, given, external } = State::of(&states);
            let mut expected = vec![0.0; v.len()];
            let batch = || Batch::<f64>::new(&figure, GRAVITY).expect("finite constants");
            batch().inverse_dynamics(q, v, given, &external, &mut expected).expect("valid states");
            let columns = [q, v, given].map(|values| transposed(values, count));
            for threads in [1, 2, 3, 7] {
                let mut found = vec![0.0; v.len()];
                let mut rows = batch().threads(threads);
                rows.inverse_dynamics(q, v, given, &external, &mut found).expect("valid states");
                assert_eq!(bits(&found), bits(&expected), "{threads} threads");
                let mut by_column = batch().layout(Layout::Columns).threads(threads);
                let [q, v, given] = &columns;
                by_column.inverse_dynamics(q, v, given, &external, &mut found).expect("valid states");
                assert_eq!(bits(&found), bits(&transposed(&expected, count)), "columns, {threads} threads");
            }
        }
    }
}

#[test]
fn columns_and_threads_change_no_bit_of_a_derivative() {
    let mut random = Random::new(85);
    for figure in figures(&mut random) {
        let count = 29;
        let states = States::random(&figure, &mut random, count);
        let State { q, v, given, external } = State::of(&states);
        let batch = || Batch::<f64>::new(&figure, GRAVITY).expect("finite constants");
        let mut expected = Partials::unwritten(&figure, count);
        let result = batch().inverse_dynamics_derivatives(q, v, given, &external, &mut expected.slices());
        result.expect("valid states");
        let [q_columns, v_columns, given_columns] = [q, v, given].map(|values| transposed(values, count));
        for threads in [1, 3, 7] {
            let mut found = Partials::unwritten(&figure, count);
            let mut rows = batch().threads(threads);
            let result = rows.inverse_dynamics_derivatives(q, v, given, &external, &mut found.slices());
            result.expect("valid states");
            let mut by_column = batch().layout(Layout::Columns).threads(threads);
            let (q, v, given) = (&q_columns, &v_columns, &given_columns);
            let mut columns = Partials::unwritten(&figure, count);
            let result =
                by_column.inverse_dynamics_derivatives(q, v, given, &external, &mut columns.slices());
            result.expect("valid states");
            for ((found, columns), expected) in found.0.iter().zip(&columns.0).zip(&expected.0) {
                assert_eq!(bits(found), bits(expected), "{threads} threads");
                assert_eq!(bits(columns), bits(&transposed(expected, count)), "columns, {threads} threads");
            }
        }
    }
}

#[test]
fn single_precision_keeps_its_digits() {
    let mut random = Random::new(79);
    let figure = human(1.75, 73.0).expect("an ordinary person");
    let states = States::random(&figure, &mut random, 50);
    let [tau, _] = states.one_by_one(&figure);
    let single = |values: &[f64]| -> Vec<f32> { values.iter().map(|x| *x as f32).collect() };
    let wrenches = states.wrenches.each_ref().map(|wrenches| -> Vec<Wrench<f32>> {
        let single = |v: Vector3<f64>| v.map(|x| x as f32);
        wrenches.iter().map(|w| Wrench { force: single(w.force), moment: single(w.moment) }).collect()
    });
    let external = [(states.links[0], &wrenches[0][..]), (states.links[1], &wrenches[1][..])];
    let (q, v, a) = (single(&states.q), single(&states.v), single(&states.a));
    let alone = Partials::one_by_one(&figure, &states);
    let mut scalar = Kernel::<f32>::new(&figure, GRAVITY);
    for instructions in Instructions::available() {
        let mut batch = Batch::<f32>::with_instructions(&figure, GRAVITY, instructions).expect("finite");
        let mut found = vec![0.0_f32; v.len()];
        batch.inverse_dynamics(&q, &v, &a, &external, &mut found).expect("valid states");
        let doubles: Vec<f64> = found.iter().map(|x| f64::from(*x)).collect();
        let error = worst(&doubles, &tau);
        assert!(error < 2e-6, "{instructions:?}: {error:e}");
        let mut partials = alone.0.each_ref().map(|all| vec![f32::NAN; all.len()]);
        let [value, by_q, by_v, by_input] = &mut partials;
        let mut slices = BatchPartials { value, by_q, by_v, by_input };
        batch.inverse_dynamics_derivatives(&q, &v, &a, &external, &mut slices).expect("valid states");
        for (found, alone) in partials.iter().zip(&alone.0) {
            let doubles: Vec<f64> = found.iter().map(|x| f64::from(*x)).collect();
            let error = worst(&doubles, alone);
            assert!(error < 4e-6, "{instructions:?}: {error:e}");
        }
        if instructions == Instructions::Baseline {
            let nv = figure.layout().nv();
            let first = external.map(|(link, wrenches)| (link, wrenches[0]));
            let expected = scalar.inverse(&q[..nv], &v[..nv], &a[..nv], &first).expect("a valid state");
            assert!(found[..nv].iter().zip(&expected).all(|(x, y)| x.to_bits() == y.to_bits()));
        }
    }
}

#[test]
fn angles_of_many_turns_are_those_of_one_state() {
    let figure = human(1.75, 73.0).expect("an ordinary person");
    let mut random = Random::new(80);
    let mut states = States::random(&figure, &mut random, 9);
    let nq = figure.layout().nq();
    (states.q[3 * nq + 20], states.q[5 * nq + 30]) = (1e9, -3e15);
    let [tau, _] = states.one_by_one(&figure);
    let State { q, v, given, external } = State::of(&states);
    for instructions in Instructions::available() {
        let mut found = vec![0.0; v.len()];
        let mut batch = Batch::<f64>::with_instructions(&figure, GRAVITY, instructions).expect("finite");
        batch.inverse_dynamics(q, v, given, &external, &mut found).expect("valid states");
        assert!(worst(&found, &tau) < 2e-14);
    }
}

#[test]
fn a_state_that_is_refused_spoils_no_other() {
    let mut random = Random::new(81);
    for figure in figures(&mut random) {
        let (nq, nv, count) = (figure.layout().nq(), figure.layout().nv(), 37);
        let mut states = States::random(&figure, &mut random, count);
        for threads in [1, 3] {
            let mut batch = Batch::<f64>::new(&figure, GRAVITY).expect("finite constants").threads(threads);
            let mut good = vec![0.0; nv * count];
            let State { q, v, given, external } = State::of(&states);
            batch.inverse_dynamics(q, v, given, &external, &mut good).expect("valid states");
            let kept = states.q.clone();
            states.q[4 * nq] = f64::NAN;
            states.q[5 * nq + nq - 1] = f64::INFINITY;
            states.q[36 * nq] = f64::NEG_INFINITY;
            states.v[17 * nv] = f64::INFINITY;
            let mut found = vec![0.0; nv * count];
            let State { q, v, given, external } = State::of(&states);
            let error = batch.inverse_dynamics(q, v, given, &external, &mut found).expect_err("bad rows");
            let BatchError::Rows { states: all, rows, first } = error else { panic!("{error}") };
            assert_eq!((all, &rows[..]), (count, &[4, 5, 17, 36][..]), "{}", figure.name());
            assert!(matches!(first, DynamicsError::NotFinite { what: "q", .. }), "{first}");
            for i in 0..count {
                let (found, good) = (&found[i * nv..][..nv], &good[i * nv..][..nv]);
                if rows.contains(&i) {
                    assert!(found.iter().all(|x| x.is_nan()));
                } else {
                    assert_eq!(bits(found), bits(good), "row {i}");
                }
            }
            (states.q, states.v[17 * nv]) = (kept, 0.5);
        }
    }
}

#[test]
fn derivatives_of_a_state_that_is_refused_spoil_no_other() {
    let mut random = Random::new(86);
    let (figure, count) = (human(1.75, 73.0).expect("an ordinary person"), 19);
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let mut states = States::random(&figure, &mut random, count);
    for threads in [1, 3] {
        let mut batch = Batch::<f64>::new(&figure, GRAVITY).expect("finite constants").threads(threads);
        let mut good = Partials::unwritten(&figure, count);
        let State { q, v, given, external } = State::of(&states);
        let result = batch.inverse_dynamics_derivatives(q, v, given, &external, &mut good.slices());
        result.expect("valid states");
        let kept = (states.q.clone(), states.v.clone());
        states.q[4 * nq + 7] = f64::NAN;
        states.v[9 * nv + 20] = 1e200;
        let mut found = Partials::unwritten(&figure, count);
        let State { q, v, given, external } = State::of(&states);
        let error = batch.inverse_dynamics_derivatives(q, v, given, &external, &mut found.slices());
        let BatchError::Rows { states: all, rows, first } = error.expect_err("bad rows") else { panic!() };
        assert_eq!((all, &rows[..]), (count, &[4, 9][..]));
        assert!(matches!(first, DynamicsError::NotFinite { what: "q", .. }), "{first}");
        for (found, good) in found.0.iter().zip(&good.0) {
            let width = found.len() / count;
            for i in 0..count {
                let (found, good) = (&found[i * width..][..width], &good[i * width..][..width]);
                if rows.contains(&i) {
                    assert!(found.iter().all(|x| x.is_nan()), "row {i}");
                } else {
                    assert_eq!(bits(found), bits(good), "row {i}");
                }
            }
        }
        (states.q, states.v) = kept;
    }
}

#[test]
fn what_cannot_be_asked_is_said() {
    let figure = human(1.75, 73.0).expect("an ordinary person");
    let mut batch = Batch::<f64>::new(&figure, GRAVITY).expect("finite constants");
    let (state, mut tau) = ([0.0; 132], [0.0; 132]);
    let error = batch.inverse_dynamics(&state[1..], &state, &state, &[], &mut tau).expect_err("too short");
    assert_eq!(error.to_string(), "q has 131 entries; 2 states of 66 need 132");
    let error = batch.inverse_dynamics(&state, &state[2..], &state, &[], &mut tau).expect_err("too short");
    assert_eq!(error.to_string(), "v has 130 entries; 1 states of 66 need 66");
    let wrench = [Wrench { force: Vector3::x(), moment: Vector3::zeros() }; 2];
    let error =
        batch.inverse_dynamics(&state, &state, &state, &[(99, &wrench)], &mut tau).expect_err("no link");
    assert!(error.to_string().contains("link 99"), "{error}");
    let few = &[(0, &wrench[1..])];
    let error = batch.inverse_dynamics(&state, &state, &state, few, &mut tau).expect_err("too few");
    assert_eq!(error.to_string(), "the wrenches on a link has 1 entries; 2 states of 1 need 2");
    let mut found = Partials::unwritten(&figure, 2);
    let short = BatchPartials { by_v: &mut [], ..found.slices() };
    let error = batch.inverse_dynamics_derivatives(&state, &state, &state, &[], &mut { short });
    let error = error.expect_err("too short");
    assert_eq!(error.to_string(), "the derivatives by v has 0 entries; 2 states of 4356 need 8712");
    let mut state = state;
    state[70] = f64::NAN;
    let error = batch.inverse_dynamics(&state, &[0.0; 132], &[0.0; 132], &[], &mut tau).expect_err("NaN");
    assert!(
        error.to_string().starts_with("1 of 2 states was refused, the first in row 1: q of dof"),
        "{error}"
    );
}

#[test]
fn a_figure_that_cannot_move_and_one_that_cannot_be_pushed() {
    let statue = FigureBuilder::new("statue")
        .link(LinkSpec::root("stone", Joint::new("fixed")).mass(1.0))
        .build()
        .expect("a figure");
    let mut batch = Batch::<f64>::new(&statue, GRAVITY).expect("finite constants");
    assert_eq!(batch.inverse_dynamics(&[], &[], &[], &[], &mut []), Ok(()));
    let mut nothing = BatchPartials { value: &mut [], by_q: &mut [], by_v: &mut [], by_input: &mut [] };
    assert_eq!(batch.inverse_dynamics_derivatives(&[], &[], &[], &[], &mut nothing), Ok(()));
    // A slide without mass has nothing to be accelerated by.
    let ghost = FigureBuilder::new("ghost")
        .link(LinkSpec::root("cart", Joint::new("rail").tx()))
        .build()
        .expect("a figure");
    let mut batch = Batch::<f64>::new(&ghost, GRAVITY).expect("finite constants");
    let mut a = [0.0; 3];
    let error = batch.forward_dynamics(&[0.0; 3], &[0.0; 3], &[1.0; 3], &[], &mut a).expect_err("no inertia");
    let BatchError::Rows { rows, first, .. } = error else { panic!("{error}") };
    assert_eq!(rows, [0, 1, 2]);
    assert!(matches!(first, DynamicsError::NoInertia { .. }), "{first}");
}

#[test]
fn a_batch_allocates_when_it_is_made() {
    let mut random = Random::new(13);
    let figure = tree_of(Joints::EveryArmed, &mut random, 12, 1.0);
    let (n, states) = (figure.layout().nv(), 21);
    let q: Vec<f64> = (0..states).flat_map(|_| random_configuration(&mut random, &figure)).collect();
    let (v, a, mut tau) =
        (random.slice(states * n, 1.0), random.slice(states * n, 1.0), vec![0.0; states * n]);
    let wrenches: Vec<Wrench<f64>> = (0..states).map(|_| random.wrench(12).1).collect();
    for layout in [Layout::Rows, Layout::Columns] {
        let gravity = Vector3::new(0.0, -9.81, 0.0);
        let mut batch = Batch::<f64>::new(&figure, gravity).expect("finite constants").layout(layout);
        // How many wrenches there are is known from the first call on.
        let (q, external) =
            (if layout == Layout::Rows { q.clone() } else { rest(&figure, states) }, [(3, &wrenches[..])]);
        batch.inverse_dynamics(&q, &v, &a, &external, &mut tau).expect("valid states");
        let mut partials = Partials::unwritten(&figure, states);
        let mut derive = |batch: &mut Batch<f64>| {
            let result = batch.inverse_dynamics_derivatives(&q, &v, &a, &external, &mut partials.slices());
            result.expect("valid states");
        };
        // What derivatives take is known from the first call on, too.
        derive(&mut batch);
        let count = allocations(|| {
            derive(&mut batch);
            batch.inverse_dynamics(&q, &v, &a, &external, &mut tau).expect("valid states");
            let mut accelerations = a.clone();
            batch.forward_dynamics(&q, &v, &tau, &external, &mut accelerations).expect("valid states");
        });
        assert_eq!(count, 1, "the copy of `a` alone");
    }
}

/// Every joint at zero, entry by entry.
fn rest(figure: &solaris_model::Figure, states: usize) -> Vec<f64> {
    let mut q = vec![0.0; figure.layout().nq()];
    figure.neutral(&mut q).expect("the right length");
    q.iter().flat_map(|x| std::iter::repeat_n(*x, states)).collect()
}
