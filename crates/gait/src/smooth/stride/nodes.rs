//! The laws of a stride at its nodes, and the way of the centre of mass that follows from them.

use crate::body::Body;
use crate::body::foot::{FootPlane, mirror};
use crate::error::{GaitError, PlanError};
use crate::smooth::grid::{Grid, SECOND};
use crate::smooth::laws;
use crate::smooth::style::Style;
use crate::walking::G;
use nalgebra::{DMatrix, Vector3};
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
}

impl Laws {
    pub(super) fn new(body: &Body, style: &Style, n: usize) -> Result<Self, GaitError> {
        let length = body.leg.foot_length();
        let plane = FootPlane::new(style.foot_yaw);
        let cop = laws::cop(style)?;
        let clock = |i: usize| i as f64 / n as f64;
        let step = style.step_length;
        // The left foot's print; the right one's is the mirror image, one step away.
        let left = |u: f64| {
            let along = cop.at(u.clamp(0.0, style.toe_off())).position * length;
            Vector3::new(style.step_width / 2.0, 0.0, 0.0) + plane.forward * along
        };
        let feet: Vec<[FootSupport; 2]> = (0..n)
            .map(|i| {
                let u = clock(i);
                let right = mirror(&left(clock((i + n / 2) % n)));
                let ahead = if u < 0.5 { -step } else { step };
                let share = laws::share(style, u);
                [
                    FootSupport { share, cop: left(u) },
                    FootSupport { share: 1.0 - share, cop: right + Vector3::new(0.0, 0.0, ahead) },
                ]
            })
            .collect();
        let heights = (0..n).map(|i| laws::height(style, body.leg.length(), clock(i)));
        let (height, acceleration): (Vec<f64>, Vec<f64>) = heights.unzip();
        let centre = feet
            .iter()
            .enumerate()
            .map(|(i, [l, r])| {
                l.cop * l.share + r.cop * r.share - Vector3::new(0.0, 0.0, 2.0 * step * clock(i))
            })
            .collect();
        let vertical = acceleration.iter().map(|a| body.mass * (G + a)).collect();
        Ok(Self { mass: body.mass, height, vertical, feet, centre })
    }

    /// Sets x and z of the centre of mass: the periodic solution of
    ///
    /// ```text
    /// z̈ = k(z − P_z) − Ḣ_x/(m y)      ẍ = k(x − P_x) + Ḣ_z/(m y)      k = F_y/(m y)
    /// ```
    ///
    /// It is unique, and nothing in it grows: the matrix D² − diag(k) is negative definite.
    pub(super) fn centre_of_mass(
        &self,
        grid: &Grid,
        momentum_rate: &[Vector3<f64>],
        com: &mut [Vector3<f64>],
    ) -> Result<(), GaitError> {
        let n = com.len();
        let unit = 1.0 / (180.0 * grid.step * grid.step);
        let mut matrix = DMatrix::zeros(n, n);
        let mut rhs = DMatrix::zeros(n, 2);
        for i in 0..n {
            for (k, weight) in SECOND.iter().enumerate() {
                matrix[(i, (i + n + k - 3) % n)] += weight * unit;
            }
            let my = self.mass * com[i].y;
            let k = self.vertical[i] / my;
            matrix[(i, i)] -= k;
            rhs[(i, 0)] = -k * self.centre[i].x + momentum_rate[i].z / my;
            rhs[(i, 1)] = -k * self.centre[i].z - momentum_rate[i].x / my;
        }
        if !matrix.lu().solve_mut(&mut rhs) {
            return Err(PlanError::NoPath.into());
        }
        for (i, c) in com.iter_mut().enumerate() {
            (c.x, c.z) = (rhs[(i, 0)], rhs[(i, 1)]);
        }
        Ok(())
    }
}
