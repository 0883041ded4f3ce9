//! The state of the declared root's joint, found from the motion of its link.

use super::RootViewError;
use super::path::{Moving, product};
use nalgebra::{Matrix3, Vector3};
use solaris_model::{AxisKind, Dof, Figure, JointKind, JointLayout, Placement};

/// The declared root's joint.
#[derive(Clone, Debug)]
pub(super) struct DeclaredRoot {
    joint: String,
    at: JointLayout,
    placement: Placement,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Free,
    /// Slides, then turns: for each its coordinate axis and its sense.
    Euler {
        slides: [(usize, f64); 3],
        turns: [(usize, f64); 3],
    },
    /// It cannot take every motion.
    Narrow,
}

/// Smallest cosine of the middle turn at which rates are still found.
const LOCK: f64 = 1e-10;

impl DeclaredRoot {
    pub(super) fn new(figure: &Figure) -> Self {
        let joint = figure.links()[0].joint();
        let kind = match joint.kind() {
            JointKind::Free { .. } => Kind::Free,
            JointKind::Axes(dofs) => euler(dofs).unwrap_or(Kind::Narrow),
            _ => Kind::Narrow,
        };
        let at = figure.layout().joints()[0];
        Self { joint: joint.name().to_owned(), at, placement: *joint.placement(), kind }
    }

    /// Writes the joint's part of `q`, `v` and `a` for a root link that moves as `link` says. Of all the coordinates that
    /// mean the same, `q` gets the nearest to those that it holds.
    pub(super) fn solve(
        &self,
        link: &Moving<f64>,
        q: &mut [f64],
        v: &mut [f64],
        a: &mut [f64],
    ) -> Result<(), RootViewError> {
        let own = self.inside(link);
        let at = self.at;
        let (q, v, a) = (&mut q[at.q..][..at.nq], &mut v[at.v..][..at.nv], &mut a[at.v..][..at.nv]);
        match self.kind {
            Kind::Free => {
                let alike: f64 = q[3..].iter().zip(&own.quaternion).map(|(near, x)| near * x).sum();
                own.write_free(q, v, a);
                if alike < 0.0 {
                    q[3..].iter_mut().for_each(|x| *x = -*x);
                }
                Ok(())
            }
            Kind::Euler { slides, turns } => {
                for (i, (axis, sense)) in slides.into_iter().enumerate() {
                    q[i] = own.translation[axis] * sense;
                    v[i] = own.linear[axis] * sense;
                    a[i] = own.acceleration[axis] * sense;
                }
                self.turns(turns, &own, &mut q[3..], &mut v[3..], &mut a[3..])
            }
            Kind::Narrow => Err(RootViewError::Root { joint: self.joint.clone() }),
        }
    }

    /// The motion in the frame in which the joint is placed.
    fn inside(&self, link: &Moving<f64>) -> Moving<f64> {
        let into = self.placement.rotation.inverse();
        let turn: Matrix3<f64> = *into.to_rotation_matrix().matrix();
        Moving {
            quaternion: product(&into.coords.into(), &link.quaternion),
            rotation: turn * link.rotation,
            translation: turn * (link.translation - self.placement.translation.vector),
            angular: turn * link.angular,
            linear: turn * link.linear,
            angular_acceleration: turn * link.angular_acceleration,
            acceleration: turn * link.acceleration,
        }
    }

    /// The angles of `R = E(i, α)·E(j, β)·E(k, γ)` with their rates. With `σ = ±1` the parity of i, j, k,
    ///
    /// ```text
    /// R_ik = σ·sin β      R_jk, R_kk = −σ·sin α·cos β, cos α·cos β      R_ij, R_ii = −σ·sin γ·cos β, cos γ·cos β
    /// E(i, α)ᵀ·ω = e_i·(α̇ + σ·sin β·γ̇) + e_j·β̇ + e_k·cos β·γ̇
    /// ```
    fn turns(
        &self,
        turns: [(usize, f64); 3],
        own: &Moving<f64>,
        q: &mut [f64],
        v: &mut [f64],
        a: &mut [f64],
    ) -> Result<(), RootViewError> {
        let [i, j, k] = turns.map(|(axis, _)| axis);
        let parity = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        let r = &own.rotation;
        let sine = parity * r[(i, k)];
        let cosine = r[(i, i)].hypot(r[(i, j)]);
        let angles = [
            (-parity * r[(j, k)]).atan2(r[(k, k)]),
            sine.atan2(cosine),
            (-parity * r[(i, j)]).atan2(r[(i, i)]),
        ];
        let near = [0, 1, 2].map(|n| if q[n].is_finite() { q[n] * turns[n].1 } else { 0.0 });
        let [alpha, beta, gamma] = nearest(angles, near);
        let (sine, cosine) = beta.sin_cos();
        if cosine.abs() < LOCK {
            return Err(RootViewError::Lock { joint: self.joint.clone(), cosine });
        }
        // The axes of the turns, in the joint's frame.
        let (first, second) = (Vector3::ith(i, 1.0), axis_after(i, alpha, j));
        let third = first * (parity * sine) + axis_after(i, alpha, k) * cosine;
        let solve = |w: &Vector3<f64>| {
            let last = axis_after(i, alpha, k).dot(w) / cosine;
            [first.dot(w) - parity * sine * last, second.dot(w), last]
        };
        let rates = solve(&own.angular);
        // What the turning axes add: α = Σ e·q̈ + Σ ė·q̇.
        let after_first = first * rates[0];
        let turning = after_first.cross(&second) * rates[1]
            + (after_first + second * rates[1]).cross(&third) * rates[2];
        let accelerations = solve(&(own.angular_acceleration - turning));
        for (n, angle) in [alpha, beta, gamma].into_iter().enumerate() {
            let sense = turns[n].1;
            (q[n], v[n], a[n]) = (angle * sense, rates[n] * sense, accelerations[n] * sense);
        }
        Ok(())
    }
}

/// `E(i, angle)·e_j` for different coordinate axes.
fn axis_after(i: usize, angle: f64, j: usize) -> Vector3<f64> {
    let (e, axis) = (Vector3::ith(i, 1.0), Vector3::ith(j, 1.0));
    axis * angle.cos() + e.cross(&axis) * angle.sin()
}

/// Of the triples of angles that mean the same rotation, the nearest to `near`: (α, β, γ) and (α + π, π − β, γ + π), with
/// any number of whole turns.
fn nearest(angles: [f64; 3], near: [f64; 3]) -> [f64; 3] {
    use std::f64::consts::{PI, TAU};
    let [alpha, beta, gamma] = angles;
    let [one, other] = [angles, [alpha + PI, PI - beta, gamma + PI]].map(|triple| {
        let unwound = [0, 1, 2].map(|n| triple[n] + ((near[n] - triple[n]) / TAU).round() * TAU);
        let distance: f64 = (0..3).map(|n| (unwound[n] - near[n]).powi(2)).sum();
        (distance, unwound)
    });
    if other.0 < one.0 { other.1 } else { one.1 }
}

/// Three slides along different coordinate axes, then three turns about different coordinate axes.
fn euler(dofs: &[Dof]) -> Option<Kind> {
    let along = |dof: &Dof, kind: AxisKind| {
        let direction = dof.axis.direction;
        let axis = (0..3).find(|&i| (0..3).all(|j| i == j || direction[j].abs() == 0.0))?;
        (dof.axis.kind == kind).then(|| (axis, direction[axis].signum()))
    };
    let three = |dofs: &[Dof], kind| {
        let found = [along(&dofs[0], kind)?, along(&dofs[1], kind)?, along(&dofs[2], kind)?];
        (0..3).all(|axis| found.iter().any(|(a, _)| *a == axis)).then_some(found)
    };
    if dofs.len() != 6 {
        return None;
    }
    let slides = three(&dofs[..3], AxisKind::Translation)?;
    let turns = three(&dofs[3..], AxisKind::Rotation)?;
    Some(Kind::Euler { slides, turns })
}
