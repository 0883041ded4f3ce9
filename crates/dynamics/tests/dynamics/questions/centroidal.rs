//! The figure as one body, against sums over its links and differences along its motion.

use crate::questions::case::{Case, derivative, difference, matrix};
use crate::support::Kernel;
use nalgebra::{DVector, Matrix3, Vector3, Vector6};
use proptest::prelude::*;
use solaris_dynamics as dynamics;
use solaris_dynamics::{Momentum, Wrench};

fn six(linear: &Vector3<f64>, angular: &Vector3<f64>) -> Vector6<f64> {
    Vector6::from_iterator(linear.iter().chain(angular.iter()).copied())
}

impl Case {
    fn centroidal_momentum(&mut self, q: &[f64], v: &[f64]) -> Vector6<f64> {
        let Kernel { tree, workspace } = &mut self.kernel;
        let Momentum { linear, angular } =
            dynamics::centroidal_momentum(tree, workspace, q, v).expect("valid");
        six(&linear, &angular)
    }

    fn centroidal_rate(&mut self, a: &[f64]) -> Vector6<f64> {
        let Kernel { tree, workspace } = &mut self.kernel;
        let Wrench { force, moment } =
            dynamics::centroidal_momentum_rate(tree, workspace, &self.q, &self.v, a).expect("valid");
        six(&force, &moment)
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// `A_G·v` is the momentum, moved from the world's origin to the centre of mass, and its slope the rate.
    #[test]
    fn the_momentum_matrix_gives_the_momentum(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (q, v, a) = (case.q.clone(), case.v.clone(), case.a.clone());
        let mut map = matrix(6, case.nv());
        let Kernel { tree, workspace } = &mut case.kernel;
        dynamics::centroidal_momentum_matrix(tree, workspace, &q, &mut map).expect("valid");
        let product = &map * DVector::from_row_slice(&v);
        let Momentum { linear, angular } = case.kernel.momentum(&q, &v);
        let center = case.kernel.center_of_mass(&q);
        let expected = six(&linear, &(angular - center.cross(&linear)));
        let found = case.centroidal_momentum(&q, &v);
        prop_assert!(difference(&product, &DVector::from_row_slice(expected.as_slice()), 1.0) < 1e-12);
        prop_assert!(difference(&found, &expected, 1.0) < 1e-12);

        let rate = case.centroidal_rate(&a);
        let slope = derivative(|t| {
            let (q, v) = case.after(t);
            case.centroidal_momentum(&q, &v)
        });
        prop_assert!(difference(&rate, &slope, 1.0) < 1e-8, "{rate} {slope}");
        // Linear in a, with the matrix for a slope.
        let bias = case.centroidal_rate(&vec![0.0; v.len()]);
        let sum = &map * DVector::from_row_slice(&a) + DVector::from_row_slice(bias.as_slice());
        prop_assert!(difference(&sum, &DVector::from_row_slice(rate.as_slice()), 1.0) < 1e-12);
    }

    /// The rate of the centroidal momentum is what gravity, the wrenches and the root's joint do.
    #[test]
    fn the_rate_of_momentum_is_what_acts_from_outside(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let (a, center) = (case.a.clone(), case.kernel.center_of_mass(&case.q));
        case.kernel.inverse(&case.q, &case.v, &case.a, &case.external).expect("valid");
        let weight = Wrench::at(&center, case.gravity * case.figure.mass(), Vector3::zeros());
        let acting = case.external.iter().map(|(_, wrench)| *wrench);
        let sum = acting.chain([weight, case.kernel.workspace.base_wrench()]).fold(
            Vector6::zeros(),
            |sum, wrench| sum + six(&wrench.force, &wrench.moment_about(&center)),
        );
        let rate = case.centroidal_rate(&a);
        prop_assert!(difference(&rate, &sum, 50.0) < 1e-12, "{rate} {sum}");
    }

    #[test]
    fn the_jacobian_of_the_centre_of_mass_is_its_slope(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let mut j = matrix(3, case.nv());
        let Kernel { tree, workspace } = &mut case.kernel;
        dynamics::center_of_mass_jacobian(tree, workspace, &case.q, &mut j).expect("valid");
        let found = j * DVector::from_row_slice(&case.v);
        let slope = derivative(|t| {
            let (q, _) = case.after(t);
            case.kernel.center_of_mass(&q)
        });
        prop_assert!(difference(&found, &DVector::from_row_slice(slope.as_slice()), 1.0) < 1e-9);
    }

    /// The composite body is the sum of the links, each moved to the common centre.
    #[test]
    fn the_composite_body_is_the_sum_of_the_links(seed in any::<u64>()) {
        let mut case = Case::random(seed);
        let Kernel { tree, workspace } = &mut case.kernel;
        let body = dynamics::composite_body(tree, workspace, &case.q).expect("valid");
        let center = case.kernel.center_of_mass(&case.q);
        let mut inertia = Matrix3::zeros();
        for (i, link) in case.figure.links().iter().enumerate() {
            let pose = case.kernel.workspace.pose(i);
            let r = pose.transform(link.com()) - center;
            inertia += pose.rotation * link.inertia() * pose.rotation.transpose()
                + (Matrix3::identity() * r.norm_squared() - r * r.transpose()) * link.mass();
        }
        prop_assert!((body.mass - case.figure.mass()).abs() < 1e-12 * body.mass);
        prop_assert!((body.center - center).amax() < 1e-12);
        prop_assert!(difference(&body.inertia, &inertia, 0.1) < 1e-12, "{} {inertia}", body.inertia);
    }
}
