//! Each scalar through the kernel, against `f64` and against one another.

use crate::support::random::{Random, tree};
use crate::support::{Kernel, largest, relative_error};
use nalgebra::Vector3;
use solaris_dynamics::scalar::{Counted, DoubleDouble, Dual, Lanes};
use solaris_dynamics::{Scalar, Wrench};
use solaris_model::Figure;
use std::array::from_fn;

/// Positions, velocities, accelerations and wrenches.
struct State<T> {
    q: Vec<T>,
    v: Vec<T>,
    a: Vec<T>,
    wrenches: Vec<(usize, Wrench<T>)>,
}

impl State<f64> {
    fn random(figure: &Figure, random: &mut Random) -> Self {
        let links = figure.links().len();
        Self {
            q: random.slice(figure.layout().nq(), 2.0),
            v: random.slice(figure.layout().nv(), 3.0),
            a: random.slice(figure.layout().nv(), 5.0),
            wrenches: vec![random.wrench(links), random.wrench(links)],
        }
    }
}

impl<T: Scalar> State<T> {
    /// A state of which every number is made from the place and the value of one of `self`.
    fn map<U: Scalar>(&self, number: impl Fn(Part, usize, T) -> U) -> State<U> {
        let list = |part, list: &[T]| list.iter().enumerate().map(|(i, x)| number(part, i, *x)).collect();
        let vector = |v: &Vector3<T>| v.map(|x| number(Part::Wrench, 0, x));
        let wrench = |w: &Wrench<T>| Wrench { force: vector(&w.force), moment: vector(&w.moment) };
        State {
            q: list(Part::Position, &self.q),
            v: list(Part::Velocity, &self.v),
            a: list(Part::Acceleration, &self.a),
            wrenches: self.wrenches.iter().map(|(link, w)| (*link, wrench(w))).collect(),
        }
    }

    /// `f64` exactly as another scalar.
    fn lift<U: Scalar>(&self) -> State<U>
    where
        T: Into<f64>,
    {
        self.map(|_, _, x| U::from_f64(x.into()))
    }

    fn forces(&self, kernel: &mut Kernel<T>) -> Vec<T> {
        kernel.inverse(&self.q, &self.v, &self.a, &self.wrenches).expect("a valid state")
    }
}

/// Where a number of a state stands.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    Position,
    Velocity,
    Acceleration,
    Wrench,
}

fn kernel<T: Scalar>(figure: &Figure) -> Kernel<T> {
    Kernel::new(figure, Vector3::new(0.5, -9.5, 1.0))
}

fn bits(values: impl IntoIterator<Item = f64>) -> Vec<u64> {
    values.into_iter().map(f64::to_bits).collect()
}

/// 30 random trees, each with two random states.
fn each_case(mut check: impl FnMut(&Figure, &State<f64>, &mut Random)) {
    let mut random = Random::new(4);
    for case in 0..30 {
        let figure = tree(&mut random, 1 + case % 9, 1.0);
        for _ in 0..2 {
            let state = State::random(&figure, &mut random);
            check(&figure, &state, &mut random);
        }
    }
}

#[test]
fn values_of_dual_and_counting_scalars_are_those_of_double_precision_bit_for_bit() {
    each_case(|figure, state, _| {
        let expected = bits(state.forces(&mut kernel(figure)));
        let one = state.lift::<Dual<1>>().forces(&mut kernel(figure));
        let eight = state.lift::<Dual<8>>().forces(&mut kernel(figure));
        let (counted, operations) = Counted::measure(|| state.lift::<Counted>().forces(&mut kernel(figure)));
        assert_eq!(bits(one.iter().map(|x| x.value())), expected);
        assert_eq!(bits(eight.iter().map(|x| x.value())), expected);
        assert_eq!(bits(counted.iter().map(|x| x.value())), expected);
        assert!(one.iter().all(|x| x.partials() == [0.0]), "nothing was varied");
        assert!(operations.multiplications > 0 && operations.additions > 0);
    });
}

#[test]
fn each_lane_is_a_state_of_double_precision_bit_for_bit() {
    each_case(|figure, first, random| {
        let mut states = vec![first.lift::<f64>()];
        while states.len() < 4 {
            // One wrench has one link: the lanes share it.
            let mut other = State::random(figure, random);
            for (wrench, of_first) in other.wrenches.iter_mut().zip(&first.wrenches) {
                wrench.0 = of_first.0;
            }
            states.push(other);
        }
        let pack =
            |of: fn(&State<f64>) -> &[f64], i: usize| Lanes::<4>::new(from_fn(|lane| of(&states[lane])[i]));
        let vector = |of: &dyn Fn(&State<f64>) -> Vector3<f64>| {
            Vector3::from_fn(|row, _| Lanes::new(from_fn(|lane| of(&states[lane])[row])))
        };
        let packed = State {
            q: (0..figure.layout().nq()).map(|i| pack(|state| &state.q, i)).collect(),
            v: (0..figure.layout().nv()).map(|i| pack(|state| &state.v, i)).collect(),
            a: (0..figure.layout().nv()).map(|i| pack(|state| &state.a, i)).collect(),
            wrenches: (0..2)
                .map(|i| {
                    let force = vector(&|state| state.wrenches[i].1.force);
                    let moment = vector(&|state| state.wrenches[i].1.moment);
                    (first.wrenches[i].0, Wrench { force, moment })
                })
                .collect(),
        };
        let tau = packed.forces(&mut kernel(figure));
        let matrix = kernel::<Lanes<4>>(figure).mass_matrix(&packed.q).expect("a valid state");
        for (lane, state) in states.iter().enumerate() {
            let expected = state.forces(&mut kernel(figure));
            assert_eq!(bits(tau.iter().map(|x| x.lane(lane))), bits(expected));
            let expected = kernel::<f64>(figure).mass_matrix(&state.q).expect("a valid state");
            assert_eq!(bits(matrix.iter().map(|x| x.lane(lane))), bits(expected.iter().copied()));
        }
    });
}

#[test]
fn twice_the_digits_agree_with_double_precision_as_far_as_that_goes() {
    let mut largest_error = 0.0_f64;
    each_case(|figure, state, _| {
        let found = state.forces(&mut kernel(figure));
        let reference = state.lift::<DoubleDouble>().forces(&mut kernel(figure));
        let rounded: Vec<f64> = reference.iter().map(|x| x.to_f64()).collect();
        let error = relative_error(&found, &rounded);
        assert!(error < 1e-12, "{error:e}");
        largest_error = largest_error.max(error);
    });
    // The reference is not double precision in disguise.
    assert!(largest_error > 0.0);
}

/// The step of central differences in double-double: they are off by about its square, and by the last digit over it.
const STEP: f64 = 1e-10;

/// Central differences of `f` at zero.
fn differences(f: impl Fn(DoubleDouble) -> Vec<DoubleDouble>) -> Vec<f64> {
    let (step, twice) = (DoubleDouble::from_f64(STEP), DoubleDouble::from_f64(2.0 * STEP));
    f(step).into_iter().zip(f(-step)).map(|(ahead, behind)| ((ahead - behind) / twice).to_f64()).collect()
}

#[test]
fn the_derivative_of_inverse_dynamics_along_one_direction_is_that_of_central_differences() {
    each_case(|figure, state, random| {
        let (dq, dv) = (random.slice(figure.layout().nq(), 1.0), random.slice(figure.layout().nv(), 1.0));
        let da = random.slice(figure.layout().nv(), 1.0);
        let direction = |part: Part, i: usize| match part {
            Part::Position => dq[i],
            Part::Velocity => dv[i],
            Part::Acceleration => da[i],
            Part::Wrench => 0.5,
        };
        let dual = state.map(|part, i, x| Dual::new(x, [direction(part, i)])).forces(&mut kernel(figure));
        let derivative: Vec<f64> = dual.iter().map(|x| x.partial(0)).collect();
        let expected = differences(|step| {
            let moved =
                |part, i, x| DoubleDouble::from_f64(x) + step * DoubleDouble::from_f64(direction(part, i));
            state.map(moved).forces(&mut kernel(figure))
        });
        let error = relative_error(&derivative, &expected);
        assert!(error < 1e-12, "{error:e}");
    });
}

#[test]
fn eight_directions_at_once_are_those_of_one_by_one() {
    each_case(|figure, state, random| {
        let directions: Vec<Vec<f64>> =
            (0..8).map(|_| random.slice(figure.layout().nq() + 2 * figure.layout().nv(), 1.0)).collect();
        let place = |part: Part, i: usize| match part {
            Part::Position => Some(i),
            Part::Velocity => Some(figure.layout().nq() + i),
            Part::Acceleration => Some(figure.layout().nq() + figure.layout().nv() + i),
            Part::Wrench => None,
        };
        let along = |k: usize, part, i| place(part, i).map_or(0.0, |place| directions[k][place]);
        let together = state.map(|part, i, x| Dual::<8>::new(x, from_fn(|k| along(k, part, i))));
        let together = together.forces(&mut kernel(figure));
        for k in 0..8 {
            let alone = state.map(|part, i, x| Dual::new(x, [along(k, part, i)])).forces(&mut kernel(figure));
            assert_eq!(bits(together.iter().map(|x| x.partial(k))), bits(alone.iter().map(|x| x.partial(0))));
        }
    });
}

/// Everything that [`Scalar`] can do, once.
fn expression<T: Scalar>(x: T, y: T) -> T {
    let ((s, c), mut sum) = ((x * y - y).sin_cos(), T::one());
    sum += s / (x + c * y);
    sum -= (-c * x).recip_above(y * y - T::from_f64(100.0));
    sum *= x + (x * x - y).recip_above(T::from_f64(1e6)) + T::zero();
    sum
}

#[test]
fn derivatives_of_an_expression_are_those_of_central_differences() {
    let mut random = Random::new(8);
    for _ in 0..200 {
        let (x, y) = (3.0 + random.unit(), 0.8 * random.unit());
        let z = expression(Dual::<2>::variable(x, 0), Dual::variable(y, 1));
        let (x, y) = (DoubleDouble::from_f64(x), DoubleDouble::from_f64(y));
        let by_x = differences(|step| vec![expression(x + step, y)])[0];
        let by_y = differences(|step| vec![expression(x, y + step)])[0];
        let error = largest(&[z.partial(0) - by_x, z.partial(1) - by_y]);
        // Where a cosine vanishes, its reciprocal is steep.
        assert!(error < 1e-10 * (1.0 + largest(&[by_x, by_y])), "{z:?}, {by_x}, {by_y}");
        assert!((z.value() - expression(x, y).to_f64()).abs() < 1e-11 * (1.0 + z.value().abs()));
    }
}
