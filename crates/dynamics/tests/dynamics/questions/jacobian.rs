//! Jacobians, their rates, drifts and accelerations, against differences of positions and velocities.

use crate::questions::case::{Case, derivative, difference, matrix, unit};
use nalgebra::{DMatrix, DVector, Vector3, Vector6};
use proptest::prelude::*;
use solaris_dynamics::{
    Frame, JacobianAxes, Pose, Twist, accelerations, bias_accelerations, jacobian, jacobian_rate,
    joint_jacobians, point_columns,
};

const BOTH: [JacobianAxes; 2] = [JacobianAxes::World, JacobianAxes::Frame];

fn six(twist: &Twist<f64>) -> Vector6<f64> {
    Vector6::from_iterator(twist.linear.iter().chain(twist.angular.iter()).copied())
}

/// The six numbers along the axes of the frame.
fn seen(twist: &Twist<f64>, pose: &Pose<f64>, axes: JacobianAxes) -> Vector6<f64> {
    let turn = |v| if axes == JacobianAxes::Frame { pose.rotation.transpose() * v } else { v };
    six(&Twist { linear: turn(twist.linear), angular: turn(twist.angular) })
}

impl Case {
    fn jacobian(&mut self, q: &[f64], frame: &Frame<f64>, axes: JacobianAxes) -> DMatrix<f64> {
        let mut j = matrix(6, self.nv());
        jacobian(&self.kernel.tree, &mut self.kernel.workspace, q, frame, axes, &mut j).expect("valid");
        j
    }

    fn jacobian_rate(&mut self, frame: &Frame<f64>, axes: JacobianAxes) -> DMatrix<f64> {
        let mut rate = matrix(6, self.nv());
        let (tree, ws) = (&self.kernel.tree, &mut self.kernel.workspace);
        jacobian_rate(tree, ws, &self.q, &self.v, frame, axes, &mut rate).expect("valid");
        rate
    }

    fn velocity(&mut self, frame: &Frame<f64>, q: &[f64], v: &[f64]) -> Twist<f64> {
        self.kernel.velocities(q, v);
        frame.velocity(&self.kernel.workspace)
    }

    fn acceleration(&mut self, frame: &Frame<f64>) -> Twist<f64> {
        let (tree, ws) = (&self.kernel.tree, &mut self.kernel.workspace);
        accelerations(tree, ws, &self.q, &self.v, &self.a).expect("valid");
        frame.acceleration(ws)
    }
}

fn same_joint(case: &Case, i: usize, j: usize) -> bool {
    case.figure
        .layout()
        .joints()
        .iter()
        .any(|at| (at.v..at.v + at.nv).contains(&i) && (at.v..at.v + at.nv).contains(&j))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Column by column, the Jacobian is the motion of the frame that a unit rate brings.
    #[test]
    fn a_jacobian_is_the_slope_of_the_frame(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let frame = case.frame();
        let q = case.q.clone();
        let j = case.jacobian(&q, &frame, JacobianAxes::World);
        for k in 0..case.nv() {
            let rates = unit(case.nv(), k);
            let pose = |case: &mut Case, t: f64| {
                let q = case.moved(&rates, t);
                case.kernel.place(&q);
                frame.pose(&case.kernel.workspace)
            };
            let linear = derivative(|t| pose(&mut case, t).translation);
            let turning = derivative(|t| pose(&mut case, t).rotation) * pose(&mut case, 0.0).rotation.transpose();
            let slope = [linear.x, linear.y, linear.z, turning[(2, 1)], turning[(0, 2)], turning[(1, 0)]];
            let error = difference(&j.column(k).into_owned(), &DVector::from_row_slice(&slope), 1.0);
            prop_assert!(error < 1e-9, "column {k}: {error:e}");
        }
    }

    /// `J·v` is the velocity of the frame, along the world's axes or its own.
    #[test]
    fn a_jacobian_times_the_velocity_is_the_frame_s(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (frame, q, v) = (case.frame(), case.q.clone(), case.v.clone());
        let twist = case.velocity(&frame, &q, &v);
        let pose = frame.pose(&case.kernel.workspace);
        for axes in BOTH {
            let product = case.jacobian(&q, &frame, axes) * DVector::from_row_slice(&v);
            let error = difference(&product, &DVector::from_row_slice(seen(&twist, &pose, axes).as_slice()), 1.0);
            prop_assert!(error < 1e-13, "{axes:?} {error:e}");
        }
    }

    /// The rate of the Jacobian is the slope of the Jacobian along the motion.
    #[test]
    fn the_rate_of_a_jacobian_is_its_slope(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let frame = case.frame();
        for axes in BOTH {
            let rate = case.jacobian_rate(&frame, axes);
            let slope = derivative(|t| {
                let (q, _) = case.after(t);
                case.jacobian(&q, &frame, axes)
            });
            let error = difference(&rate, &slope, 1.0);
            prop_assert!(error < 1e-8, "{axes:?} {error:e}");
        }
    }

    /// The columns that are visited are the Jacobian's, and the second derivatives that they give are the slope of its
    /// product with the step.
    #[test]
    fn visited_columns_are_those_of_the_jacobian(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (frame, q, v) = (case.frame(), case.q.clone(), case.v.clone());
        let mut columns = vec![Twist { linear: Vector3::zeros(), angular: Vector3::zeros() }; v.len()];
        joint_jacobians(&case.kernel.tree, &mut case.kernel.workspace, &q).expect("valid");
        point_columns(&case.kernel.tree, &case.kernel.workspace, &frame, |dof, column| columns[dof] = column);
        let j = case.jacobian(&q, &frame, JacobianAxes::World);
        for (k, column) in columns.iter().enumerate() {
            prop_assert_eq!(six(column), j.column(k));
        }
        let mut bent = Vector3::zeros();
        for j in 0..v.len() {
            for i in 0..j {
                // The mean of both ways round, twice: for a pair of one ball it matters, and else the other way is another joint's.
                let spherical = case.figure.layout().coordinate(i).is_none() && same_joint(&case, i, j);
                let (there, back) =
                    (columns[i].angular.cross(&columns[j].linear), columns[j].angular.cross(&columns[i].linear));
                bent += if spherical { there + back } else { there * 2.0 } * (v[i] * v[j]);
            }
            bent += columns[j].angular.cross(&columns[j].linear) * (v[j] * v[j]);
        }
        let slope = derivative(|t| {
            let moved = case.moved(&v, t);
            case.jacobian(&moved, &frame, JacobianAxes::World) * DVector::from_row_slice(&v)
        });
        prop_assert!((bent - slope.fixed_rows::<3>(0)).norm() < 1e-8 * (1.0 + bent.norm()), "{bent} {slope}");
    }

    /// Accelerations are slopes of velocities, and `J·a + J̇·v`; without `a` they are the bias accelerations.
    #[test]
    fn accelerations_are_slopes_of_velocities(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let frame = case.frame();
        let found = six(&case.acceleration(&frame));
        let slope = derivative(|t| {
            let (q, v) = case.after(t);
            six(&case.velocity(&frame, &q, &v))
        });
        prop_assert!(difference(&found, &slope, 1.0) < 1e-8, "{found} {slope}");

        let q = case.q.clone();
        let j = case.jacobian(&q, &frame, JacobianAxes::World);
        let bent = case.jacobian_rate(&frame, JacobianAxes::World) * DVector::from_row_slice(&case.v);
        let found = DVector::from_row_slice(found.as_slice());
        let sum = j * DVector::from_row_slice(&case.a) + &bent;
        prop_assert!(difference(&sum, &found, 1.0) < 1e-13, "{sum} {found}");

        bias_accelerations(&case.kernel.tree, &mut case.kernel.workspace, &case.q, &case.v).expect("valid");
        let bias = six(&frame.acceleration(&case.kernel.workspace));
        prop_assert!(difference(&DVector::from_row_slice(bias.as_slice()), &bent, 1.0) < 1e-13);
    }

    /// Along the frame's own axes, `J·a + J̇·v` is the rate of the numbers `J·v`.
    #[test]
    fn along_its_own_axes_the_rate_is_that_of_the_numbers(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (frame, q) = (case.frame(), case.q.clone());
        let j = case.jacobian(&q, &frame, JacobianAxes::Frame);
        let rate = case.jacobian_rate(&frame, JacobianAxes::Frame);
        let found = j * DVector::from_row_slice(&case.a) + rate * DVector::from_row_slice(&case.v);
        let slope = derivative(|t| {
            let (q, v) = case.after(t);
            case.jacobian(&q, &frame, JacobianAxes::Frame) * DVector::from_row_slice(&v)
        });
        let error = difference(&found, &slope, 1.0);
        prop_assert!(error < 1e-8, "{error:e}");
    }
}

/// Far away, the Jacobian has the same last digits.
#[test]
fn a_jacobian_does_not_depend_on_the_place() {
    let figure = solaris_model::human(1.75, 73.0).expect("within range");
    let random = crate::support::random::Random::new(3);
    let mut case = Case::of(figure, nalgebra::Vector3::zeros(), random);
    let frame = Frame::named(&case.figure, "left_hand").expect("a link");
    let here = case.q.clone();
    let mut there = here.clone();
    there[0] += 1e5;
    let near = case.jacobian(&here, &frame, JacobianAxes::World);
    let far = case.jacobian(&there, &frame, JacobianAxes::World);
    assert!(near.iter().zip(far.iter()).all(|(a, b)| a.to_bits() == b.to_bits()));
}
