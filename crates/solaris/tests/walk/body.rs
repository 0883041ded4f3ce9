//! Kinematics and momentum of a figure from placements, axes and masses alone: matrices and the product rule.

use solaris::model::{AxisKind, Dof, Figure, Link, Matrix3, Motion, Vector3};

/// A frame that moves: rotation and origin in the world, each with its first and second derivative in time.
#[derive(Clone, Debug)]
pub(crate) struct Moving {
    pub(crate) turn: [Matrix3<f64>; 3],
    pub(crate) origin: [Vector3<f64>; 3],
}

impl Moving {
    /// One that stands still.
    fn still(turn: Matrix3<f64>, origin: Vector3<f64>) -> Self {
        Self {
            turn: [turn, Matrix3::zeros(), Matrix3::zeros()],
            origin: [origin, Vector3::zeros(), Vector3::zeros()],
        }
    }

    /// What one degree of freedom does: Rodrigues' formula `1 + sin q K + (1 − cos q) K²`, or a slide.
    fn of_dof(dof: &Dof, [q, v, a]: [f64; 3]) -> Self {
        let axis = dof.axis.direction;
        let mut moving = Self::still(Matrix3::identity(), Vector3::zeros());
        match dof.axis.kind {
            AxisKind::Translation => moving.origin = [axis * q, axis * v, axis * a],
            AxisKind::Rotation => {
                let k = axis.cross_matrix();
                let (sin, cos) = q.sin_cos();
                let by_angle = k * cos + k * k * sin;
                moving.turn = [
                    Matrix3::identity() + k * sin + k * k * (1.0 - cos),
                    by_angle * v,
                    by_angle * a + (k * k * cos - k * sin) * (v * v),
                ];
            }
        }
        moving
    }

    /// The frame `next`, given in this one, in the world: products and their derivatives.
    fn then(&self, next: &Self) -> Self {
        let ([r, r1, r2], [p, p1, p2]) = (&self.turn, &self.origin);
        let ([s, s1, s2], [x, x1, x2]) = (&next.turn, &next.origin);
        Self {
            turn: [r * s, r1 * s + r * s1, r2 * s + r1 * s1 * 2.0 + r * s2],
            origin: [p + r * x, p1 + r1 * x + r * x1, p2 + r2 * x + r1 * x1 * 2.0 + r * x2],
        }
    }

    /// A point fixed to the frame: position, velocity, acceleration.
    pub(crate) fn point(&self, at: &Vector3<f64>) -> [Vector3<f64>; 3] {
        [0, 1, 2].map(|k| self.origin[k] + self.turn[k] * at)
    }
}

/// The frames of all links.
pub(crate) fn frames(figure: &Figure, q: &[f64], v: &[f64], a: &[f64]) -> Vec<Moving> {
    let mut frames: Vec<Moving> = Vec::with_capacity(figure.links().len());
    for (link, layout) in figure.links().iter().zip(figure.layout().joints()) {
        let placement = link.joint().placement();
        let turn = placement.rotation.to_rotation_matrix().into_inner();
        let mut frame = Moving::still(turn, placement.translation.vector);
        if let Some(parent) = link.parent() {
            frame = frames[parent].then(&frame);
        }
        for (k, dof) in link.joint().kind().axes().iter().enumerate() {
            let state = [q[layout.q + k], v[layout.v + k], a[layout.v + k]];
            frame = frame.then(&Moving::of_dof(dof, state));
        }
        frames.push(frame);
    }
    frames
}

/// The frames of all links at a sample of a motion.
pub(crate) fn frames_at(figure: &Figure, motion: &Motion, sample: usize) -> Vec<Moving> {
    frames(figure, motion.q(sample), motion.v(sample), motion.a(sample))
}

/// The second moments `S = ∫ r rᵀ dm` of a link about its centre of mass, along its axes.
pub(crate) fn second_moments(link: &Link) -> Matrix3<f64> {
    Matrix3::identity() * (link.inertia().trace() / 2.0) - link.inertia()
}

/// The vector `∫ x × y dm` of the matrix `∫ x yᵀ dm`.
fn crossed(m: &Matrix3<f64>) -> Vector3<f64> {
    Vector3::new(m[(1, 2)] - m[(2, 1)], m[(2, 0)] - m[(0, 2)], m[(0, 1)] - m[(1, 0)])
}

/// What the whole body does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Whole {
    /// Centre of mass: position, velocity, acceleration.
    pub(crate) com: [Vector3<f64>; 3],
    /// Rate of the angular momentum about the world's origin.
    pub(crate) spin_rate: Vector3<f64>,
}

impl Whole {
    /// Sums over the links: `m c`, and `m c × c̈ + ∫ R r × R̈ r dm`.
    pub(crate) fn of(figure: &Figure, frames: &[Moving]) -> Self {
        let mut whole = Self { com: [Vector3::zeros(); 3], spin_rate: Vector3::zeros() };
        for (link, frame) in figure.links().iter().zip(frames) {
            let com = frame.point(link.com());
            for (sum, com) in whole.com.iter_mut().zip(&com) {
                *sum += com * (link.mass() / figure.mass());
            }
            let turning = frame.turn[0] * second_moments(link) * frame.turn[2].transpose();
            whole.spin_rate += com[0].cross(&com[2]) * link.mass() + crossed(&turning);
        }
        whole
    }
}

/// A turning arm whose numbers can be found by hand: a 2 kg point 0.5 m from a hinge that turns by ω = 3, ω̇ = 4.
#[test]
fn a_point_on_a_hinge_accelerates_outwards_and_along() {
    use solaris::prelude::{FigureBuilder, Joint, LinkSpec};
    let arm = FigureBuilder::new("arm")
        .link(LinkSpec::root("arm", Joint::new("hinge").rz()).mass(2.0).com(Vector3::new(0.5, 0.0, 0.0)))
        .build()
        .expect("a figure");
    let whole = Whole::of(&arm, &frames(&arm, &[0.0], &[3.0], &[4.0]));
    assert!((whole.com[2] - Vector3::new(-4.5, 2.0, 0.0)).norm() < 1e-14);
    assert!((whole.spin_rate - Vector3::new(0.0, 0.0, 2.0)).norm() < 1e-14);
}
