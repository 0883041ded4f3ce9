//! Rows of a condition: how points and axes of links move with the degrees of freedom.

use crate::body::Body;
use crate::convex::Convex;
use nalgebra::Vector3;

/// A velocity (m/s or rad/s) for a unit rate that is rounding.
const NOTHING: f64 = 1e-13;

/// The axes of the world.
pub(super) const WORLD: [Vector3<f64>; 3] =
    [Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 1.0)];

/// Up to three rows of a condition, by degree of freedom of the small figure; of what moves both of two links alike nothing is left.
#[derive(Clone)]
pub(super) struct Rows {
    rows: Vec<[f64; 3]>,
    /// Which of them are not zero.
    columns: Vec<usize>,
}

/// Whose velocities are sought: the place of each degree of freedom, and the velocities after the step of all others.
#[derive(Clone, Copy)]
pub(super) struct Sought<'a> {
    pub(super) places: &'a [Option<usize>],
    pub(super) given: &'a [f64],
}

impl Rows {
    /// For so many degrees of freedom.
    pub(super) fn new(nv: usize) -> Self {
        Self { rows: vec![[0.0; 3]; nv], columns: Vec::with_capacity(nv) }
    }

    /// Adds the velocity of a link's material at a point of the world along three axes, times `sign`.
    pub(super) fn add_point(
        &mut self,
        body: &Body<f64>,
        (link, point): (usize, &Vector3<f64>),
        axes: &[Vector3<f64>; 3],
        sign: f64,
    ) {
        body.columns(link, point, |k, column| self.add(k, &column.linear, axes, sign));
    }

    /// Adds the angular velocity of a link along the axes of the world, times `sign`.
    pub(super) fn add_turn(&mut self, body: &Body<f64>, link: usize, sign: f64) {
        let origin = body.pose(link).translation;
        body.columns(link, &origin, |k, column| self.add(k, &column.angular, &WORLD, sign));
    }

    fn add(&mut self, k: usize, velocity: &Vector3<f64>, axes: &[Vector3<f64>; 3], sign: f64) {
        if !self.columns.contains(&k) {
            self.columns.push(k);
        }
        for (row, axis) in self.rows[k].iter_mut().zip(axes) {
            *row += sign * axis.dot(velocity);
        }
    }

    /// Begins a condition with these rows, and clears them; the part of its velocity that is not sought.
    pub(super) fn begin(&mut self, convex: &mut Convex, sought: Sought<'_>) -> [f64; 3] {
        convex.condition();
        let mut bias = [0.0; 3];
        for k in self.columns.drain(..) {
            let rows = std::mem::take(&mut self.rows[k]);
            if rows.iter().all(|row| row.abs() < NOTHING) {
                continue;
            }
            if let Some(place) = sought.places[k] {
                convex.entry(place, rows);
            } else {
                bias.iter_mut().zip(rows).for_each(|(bias, row)| *bias += row * sought.given[k]);
            }
        }
        bias
    }
}
