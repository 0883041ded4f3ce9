//! The laws of a stride at its nodes, and the way of the centre of mass that follows from them.

use crate::body::Body;
use crate::body::foot::{FootPlane, mirror};
use crate::error::{GaitError, PlanError};
use crate::grid::{Grid, SECOND};
use crate::smooth::band::Band;
use crate::smooth::laws;
use crate::smooth::prescribed::{normal_of, spread};
use crate::smooth::style::Style;
use crate::walking::G;
use nalgebra::{Matrix3, Matrix3x2, Vector3};
use solaris_analysis::FootSupport;

/// The laws at the nodes of a stride.
pub(super) struct Laws {
    mass: f64,
    /// Height of the centre of mass about its mean.
    pub(super) height: Vec<f64>,
    /// Vertical force.
    pub(super) vertical: Vec<f64>,
    pub(super) feet: Vec<[FootSupport; 2]>,
    /// Centre of pressure in the frame that moves with the walk.
    centre: Vec<Vector3<f64>>,
    /// See [`spread`].
    spread: Vec<Vector3<f64>>,
    pivot: f64,
}

impl Laws {
    pub(super) fn new(body: &Body, style: &Style, n: usize) -> Result<Self, GaitError> {
        let length = body.leg.foot_length();
        let axes = FootPlane::new(style.foot_yaw).tilted(style.slope);
        let [left_axis, forward]: [Vector3<f64>; 2] = [axes.column(0).into(), axes.column(2).into()];
        let normal = normal_of(style.slope);
        let cop = laws::cop(style)?;
        let clock = |i: usize| i as f64 / n as f64;
        let step = Vector3::new(0.0, style.rise(), style.step_length);
        // The left foot's print; the right one's is the mirror image, one step away.
        let left = |u: f64| {
            let along = cop.at(u.clamp(0.0, style.toe_off())).position * length;
            let outward = style.footfall.outward(u, style.toe_off()) * length;
            Vector3::new(style.step_width / 2.0, 0.0, 0.0) + forward * along + left_axis * outward
        };
        let feet: Vec<[FootSupport; 2]> = (0..n)
            .map(|i| {
                let u = clock(i);
                let right = mirror(&left(clock((i + n / 2) % n)));
                let ahead = if u < 0.5 { -step } else { step };
                let share = laws::share(style, u);
                [
                    FootSupport { share, cop: left(u), normal },
                    FootSupport { share: 1.0 - share, cop: right + ahead, normal },
                ]
            })
            .collect();
        let heights = (0..n).map(|i| laws::height(style, body.leg.length(), clock(i)));
        let (height, acceleration): (Vec<f64>, Vec<f64>) = heights.unzip();
        let centre = feet
            .iter()
            .enumerate()
            .map(|(i, [l, r])| l.cop * l.share + r.cop * r.share - step * (2.0 * clock(i)))
            .collect();
        let vertical = acceleration.iter().map(|a| body.mass * (G + a)).collect();
        let spread = feet.iter().map(spread).collect();
        Ok(Self { mass: body.mass, height, vertical, feet, centre, spread, pivot: style.pivot })
    }

    /// Sets x and z of the centre of mass: the periodic solution of
    ///
    /// ```text
    /// z̈ = k(z − P_z) − (Ḣ_x + C_z)/(m y')      ẍ = k(x − P_x) + (Ḣ_z − C_x)/(m y')      k = F_y/(m y')      y' = y − P_y
    /// ```
    ///
    /// with C of [`PrescribedNode::force`](super::PrescribedNode::force). `momentum_rate` is the body's without what free moments about
    /// leaning normals do to it.
    ///
    /// It is unique, and nothing in it grows: the matrix diag(k) − D² is positive definite.
    pub(super) fn centre_of_mass(
        &self,
        grid: &Grid,
        momentum_rate: &[Vector3<f64>],
        com: &mut [Vector3<f64>],
    ) -> Result<(), GaitError> {
        let (n, unit) = (com.len(), 1.0 / (180.0 * grid.step * grid.step));
        let (mut stiffness, mut forcing) = (Vec::with_capacity(n), Vec::with_capacity(n));
        for (i, com) in com.iter().enumerate() {
            let y = com.y - self.centre[i].y;
            let (my, k) = (self.mass * y, self.vertical[i] / (self.mass * y));
            let spread = self.spread[i] * (self.vertical[i] / (self.pivot * y));
            stiffness.push(k);
            forcing.push([
                k * self.centre[i].x - (momentum_rate[i].z - spread.x) / my,
                k * self.centre[i].z + (momentum_rate[i].x + spread.z) / my,
            ]);
        }
        let way = periodic(&stiffness, &forcing, unit).ok_or(PlanError::NoPath)?;
        for (com, [x, z]) in com.iter_mut().zip(way) {
            (com.x, com.z) = (x, z);
        }
        Ok(())
    }
}

/// Solves `(diag(k) − D²) x = f` on nodes that repeat; `None` where the matrix is not positive definite.
///
/// All but the last three nodes are a band, whose factor serves both right sides and the three columns that join it with the
/// last nodes: what it leaves of those is a system of three.
fn periodic(stiffness: &[f64], forcing: &[[f64; 2]], unit: f64) -> Option<Vec<[f64; 2]>> {
    let (n, inner) = (stiffness.len(), stiffness.len() - 3);
    let entry = |i: usize, j: usize| {
        let apart = i.abs_diff(j).min(n - i.abs_diff(j));
        let curved = if apart > 3 { 0.0 } else { -SECOND[3 - apart] * unit };
        if apart == 0 { curved + stiffness[i] } else { curved }
    };
    let row = |i: usize| [3, 2, 1, 0].map(|back| if back > i { 0.0 } else { entry(i, i - back) });
    let band = Band::factor((0..inner).map(row).collect());
    let last = [inner, inner + 1, inner + 2];
    let mut columns: Vec<[f64; 5]> = (0..inner)
        .map(|i| {
            let ([x, z], [a, b, c]) = (forcing[i], last.map(|j| entry(i, j)));
            [x, z, a, b, c]
        })
        .collect();
    band.solve(&mut columns);
    // Only the three nodes on either side are joined with the last ones.
    let joined = |j: usize, column: usize| -> f64 {
        (0..3).chain(inner - 3..inner).map(|i| entry(last[j], i) * columns[i][column]).sum()
    };
    let matrix = Matrix3::from_fn(|i, j| entry(last[i], last[j]) - joined(i, 2 + j));
    let rest = Matrix3x2::from_fn(|i, column| forcing[last[i]][column] - joined(i, column));
    let ends = matrix.cholesky()?.solve(&rest);
    let mut way: Vec<[f64; 2]> = columns
        .iter()
        .map(|x| [0, 1].map(|column| x[column] - (0..3).map(|j| x[2 + j] * ends[(j, column)]).sum::<f64>()))
        .collect();
    way.extend((0..3).map(|j| [ends[(j, 0)], ends[(j, 1)]]));
    way.iter().flatten().all(|x| x.is_finite()).then_some(way)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};

    #[test]
    fn a_way_that_repeats_solves_the_dense_equations() {
        let (n, unit) = (24, 3.7);
        let stiffness: Vec<f64> = (0..n).map(|i| 9.0 + 4.0 * (i as f64).sin()).collect();
        let forcing: Vec<[f64; 2]> = (0..n).map(|i| [(2.0 * i as f64).cos(), i as f64]).collect();
        let mut matrix = DMatrix::zeros(n, n);
        for i in 0..n {
            matrix[(i, i)] = stiffness[i];
            for (k, weight) in SECOND.iter().enumerate() {
                matrix[(i, (i + n + k - 3) % n)] -= weight * unit;
            }
        }
        let way = periodic(&stiffness, &forcing, unit).expect("positive definite");
        for column in [0, 1] {
            let found = DVector::from_fn(n, |i, _| way[i][column]);
            let wanted = DVector::from_fn(n, |i, _| forcing[i][column]);
            assert!((&matrix * found - wanted).amax() < 1e-10);
        }
        assert!(periodic(&vec![-1.0; n], &forcing, unit).is_none());
    }
}
