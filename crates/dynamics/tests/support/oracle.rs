//! A second way to every number, short enough to be seen to be right: products of 4×4 matrices, and virtual work.
//!
//! With `W` the matrix of a link and `J = ∫ (r 1)ᵀ(r 1) dm` its pseudo-inertia,
//!
//! ```text
//! tau_k = Σ tr(∂W/∂q_k · J · Ẅᵀ) − gᵀ·∂W/∂q_k·∫(r 1) dm − power of the wrenches in the motion ∂W/∂q_k
//! ```

use super::largest;
use nalgebra::{DMatrix, Matrix3, Matrix4, Vector3};
use solaris_dynamics::Wrench;
use solaris_model::{AxisKind, Dof, Figure, Link};

/// The matrices of one link and its derivatives.
pub(crate) struct Body {
    pub(crate) w: Matrix4<f64>,
    pub(crate) rate: Matrix4<f64>,
    pub(crate) acceleration: Matrix4<f64>,
    /// `∂W/∂q_k`, zero for dofs that do not move the link.
    pub(crate) by: Vec<Matrix4<f64>>,
    pseudo_inertia: Matrix4<f64>,
}

pub(crate) struct Oracle {
    pub(crate) bodies: Vec<Body>,
    gravity: Vector3<f64>,
}

impl Oracle {
    pub(crate) fn new(figure: &Figure, gravity: Vector3<f64>, q: &[f64], v: &[f64], a: &[f64]) -> Self {
        let mut bodies: Vec<Body> = Vec::new();
        for (link, joint) in figure.links().iter().zip(figure.layout().joints()) {
            let zero = Matrix4::zeros();
            let placement = link.joint().placement().to_homogeneous();
            let (mut w, mut rate, mut acceleration, mut by) = match link.parent() {
                None => (placement, zero, zero, vec![zero; v.len()]),
                Some(parent) => {
                    let Body { w, rate, acceleration, by, .. } = &bodies[parent];
                    let by = by.iter().map(|by| by * placement).collect();
                    (w * placement, rate * placement, acceleration * placement, by)
                }
            };
            for (i, dof) in link.joint().kind().axes().iter().enumerate() {
                let k = joint.v + i;
                let (e, first, second) = elementary(dof, q[joint.q + i]);
                // Product rule: (W·E)˙ = Ẇ·E + W·E'·q̇ and once more.
                acceleration = acceleration * e
                    + rate * first * (2.0 * v[k])
                    + w * (second * v[k].powi(2) + first * a[k]);
                rate = rate * e + w * first * v[k];
                for by in &mut by {
                    *by *= e;
                }
                by[k] = w * first;
                w *= e;
            }
            bodies.push(Body { w, rate, acceleration, by, pseudo_inertia: pseudo_inertia(link) });
        }
        Self { bodies, gravity }
    }

    pub(crate) fn inverse_dynamics(&self, external: &[(usize, Wrench<f64>)]) -> Vec<f64> {
        let dofs = self.bodies[0].by.len();
        (0..dofs)
            .map(|k| {
                let body_terms: f64 = self.bodies.iter().map(|body| self.virtual_work(body, k)).sum();
                let wrenches: f64 =
                    external.iter().map(|(link, wrench)| self.wrench_work(*link, wrench, k)).sum();
                body_terms - wrenches
            })
            .collect()
    }

    /// The greatest difference of `found` from [`inverse_dynamics`](Self::inverse_dynamics), relative to the largest sum of
    /// products of magnitudes that these forces go through: what is left when they cancel is as uncertain as they are.
    pub(crate) fn error_of(&self, found: &[f64], external: &[(usize, Wrench<f64>)]) -> f64 {
        let terms = (0..found.len()).map(|k| {
            let of_body = |body: &Body| {
                let inertial = body.by[k].norm() * body.pseudo_inertia.norm() * body.acceleration.norm();
                inertial + (body.by[k] * body.pseudo_inertia.column(3)).norm() * self.gravity.norm()
            };
            let body_terms: f64 = self.bodies.iter().map(of_body).sum();
            let wrenches: f64 =
                external.iter().map(|(link, wrench)| self.wrench_work(*link, wrench, k).abs()).sum();
            body_terms + wrenches
        });
        let (scale, expected) = (terms.fold(0.0, f64::max), self.inverse_dynamics(external));
        assert_eq!(found.len(), expected.len(), "lengths");
        assert!(scale.is_finite(), "{scale}");
        let differences: Vec<f64> =
            found.iter().zip(expected).map(|(found, expected)| found - expected).collect();
        assert!(differences.iter().all(|difference| difference.is_finite()), "not finite: {found:?}");
        largest(&differences) / scale.max(f64::MIN_POSITIVE)
    }

    fn virtual_work(&self, body: &Body, k: usize) -> f64 {
        let inertial = (body.by[k] * body.pseudo_inertia * body.acceleration.transpose()).trace();
        inertial - (body.by[k] * body.pseudo_inertia.column(3)).xyz().dot(&self.gravity)
    }

    /// Force times velocity at the world's origin, plus moment times angular velocity.
    fn wrench_work(&self, link: usize, wrench: &Wrench<f64>, k: usize) -> f64 {
        let body = &self.bodies[link];
        let motion = body.by[k] * body.w.try_inverse().expect("a rigid motion");
        let angular = Vector3::new(motion[(2, 1)], motion[(0, 2)], motion[(1, 0)]);
        wrench.force.dot(&motion.column(3).xyz()) + wrench.moment.dot(&angular)
    }

    pub(crate) fn mass_matrix(&self) -> DMatrix<f64> {
        let dofs = self.bodies[0].by.len();
        DMatrix::from_fn(dofs, dofs, |j, k| {
            self.bodies
                .iter()
                .map(|body| (body.by[j] * body.pseudo_inertia * body.by[k].transpose()).trace())
                .sum()
        })
    }

    pub(crate) fn kinetic_energy(&self) -> f64 {
        self.bodies
            .iter()
            .map(|body| (body.rate * body.pseudo_inertia * body.rate.transpose()).trace() / 2.0)
            .sum()
    }

    pub(crate) fn potential_energy(&self) -> f64 {
        -self
            .bodies
            .iter()
            .map(|body| (body.w * body.pseudo_inertia.column(3)).xyz().dot(&self.gravity))
            .sum::<f64>()
    }

    /// Linear momentum, and angular momentum `∫ x × ẋ dm` about the world's origin.
    pub(crate) fn momentum(&self) -> (Vector3<f64>, Vector3<f64>) {
        let linear = self.bodies.iter().map(|body| (body.rate * body.pseudo_inertia.column(3)).xyz()).sum();
        let angular = self.bodies.iter().map(|body| {
            let m = body.rate * body.pseudo_inertia * body.w.transpose(); // ∫ ẋ·xᵀ dm
            Vector3::new(m[(2, 1)] - m[(1, 2)], m[(0, 2)] - m[(2, 0)], m[(1, 0)] - m[(0, 1)])
        });
        (linear, angular.sum())
    }
}

/// `E = exp(q·G)` with its first two derivatives by `q`.
fn elementary(dof: &Dof, q: f64) -> (Matrix4<f64>, Matrix4<f64>, Matrix4<f64>) {
    let mut generator = Matrix4::zeros();
    let e = match dof.axis.kind {
        AxisKind::Rotation => {
            generator.fixed_view_mut::<3, 3>(0, 0).copy_from(&dof.axis.direction.cross_matrix());
            Matrix4::identity() + generator * q.sin() + generator * generator * (1.0 - q.cos())
        }
        AxisKind::Translation => {
            generator.fixed_view_mut::<3, 1>(0, 3).copy_from(&dof.axis.direction);
            Matrix4::identity() + generator * q
        }
    };
    (e, generator * e, generator * generator * e)
}

fn pseudo_inertia(link: &Link) -> Matrix4<f64> {
    let (m, c) = (link.mass(), link.com());
    let second =
        Matrix3::identity() * (link.inertia().trace() / 2.0) - link.inertia() + c * c.transpose() * m;
    let mut j = Matrix4::zeros();
    j.fixed_view_mut::<3, 3>(0, 0).copy_from(&second);
    j.fixed_view_mut::<3, 1>(0, 3).copy_from(&(c * m));
    j.fixed_view_mut::<1, 3>(3, 0).copy_from(&(c * m).transpose());
    j[(3, 3)] = m;
    j
}
