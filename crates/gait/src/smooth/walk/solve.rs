//! The way of the centre of mass from rest to rest.

use crate::grid::SECOND;
use crate::smooth::band::Band;
use nalgebra::{Matrix4, Vector3, Vector4};

/// The equation at the nodes, along the ground: `c̈ = k(c − P − Σ aⱼ Bⱼ eⱼ) + h`.
pub(super) struct Way<'a> {
    /// Centre of pressure (m).
    pub(super) centre: &'a [Vector3<f64>],
    /// The body's own part, from its angular momentum (m/s²).
    pub(super) own: &'a [Vector3<f64>],
    /// Shapes B of the four shifts whose amplitudes are free, and their directions e.
    pub(super) shapes: [&'a [f64]; 4],
    pub(super) axes: [Vector3<f64>; 4],
    /// Rest before and after (m).
    pub(super) rest: [Vector3<f64>; 2],
}

/// Columns of the right sides: x, z, and the responses to the four shapes.
const COLUMNS: usize = 6;

/// Finds the way between the nodes `first` and `last`, at rest there and beyond.
///
/// `D²c − kc = −k(P + Σ aⱼBⱼeⱼ) + h` at the inner nodes, with the seven-point second difference; the same equation imposed at
/// the two end nodes as well decides the four amplitudes. One banded factorisation serves six right sides. Returns the
/// way at all nodes (its height is zero), and the amplitudes.
pub(super) fn rest_to_rest(
    factor: &Band,
    stiffness: &[f64],
    (first, last): (usize, usize),
    unit: f64,
    way: &Way<'_>,
) -> (Vec<Vector3<f64>>, [f64; 4]) {
    let inner = last - first - 1;
    let rest = way.rest.map(|at| [at.x, at.z, 0.0, 0.0, 0.0, 0.0]);
    let weight = |k: usize| SECOND[k] * unit;
    let forcing = |node: usize| -> [f64; COLUMNS] {
        let (k, p, h) = (stiffness[node], &way.centre[node], &way.own[node]);
        let [a, b, c, d] = way.shapes.map(|shape| k * shape[node]);
        [k * p.x - h.x, k * p.z - h.z, a, b, c, d]
    };
    // The factored matrix is k − D²: every sign is turned.
    let mut x: Vec<[f64; COLUMNS]> = (first + 1..last).map(forcing).collect();
    for i in 0..3 {
        for k in 0..3 - i {
            for column in 0..2 {
                x[i][column] += weight(k) * rest[0][column];
                x[inner - 1 - i][column] += weight(k) * rest[1][column];
            }
        }
    }
    factor.solve(&mut x);
    // The particular solutions rest at their ends, the responses at zero.
    let value = |node: isize| {
        let i = node - first as isize - 1;
        if i < 0 { &rest[0] } else { x.get(i as usize).unwrap_or(&rest[1]) }
    };
    let residual = |node: usize| -> [f64; COLUMNS] {
        let (k, forcing, here) = (stiffness[node], forcing(node), value(node as isize));
        std::array::from_fn(|column| {
            let difference: f64 =
                (0..7).map(|j| weight(j) * value(node as isize + j as isize - 3)[column]).sum();
            difference - k * here[column] + forcing[column]
        })
    };
    let [start, end] = [first, last].map(residual);
    let row = |residual: &[f64; COLUMNS], axis: usize| {
        let e = way.axes.map(|e| [e.x, e.z][axis]);
        [e[0] * residual[2], e[1] * residual[3], e[2] * residual[4], e[3] * residual[5]]
    };
    let rows = [row(&start, 0), row(&end, 0), row(&start, 1), row(&end, 1)];
    let matrix = Matrix4::from_fn(|i, j| rows[i][j]);
    let wanted = -Vector4::new(start[0], end[0], start[1], end[1]);
    // Numbers that are none are refused where the plan is judged.
    let a = matrix.lu().solve(&wanted).unwrap_or_else(|| Vector4::repeat(f64::NAN));
    let way = (0..stiffness.len())
        .map(|i| match i {
            i if i <= first => way.rest[0],
            i if i >= last => way.rest[1],
            i => {
                let x = &x[i - first - 1];
                let shifted: Vector3<f64> = (0..4).map(|j| way.axes[j] * (a[j] * x[2 + j])).sum();
                Vector3::new(x[0], 0.0, x[1]) + shifted
            }
        })
        .collect();
    (way, a.into())
}

/// Factors `k − D²` at the nodes between `first` and `last`.
pub(super) fn factor(stiffness: &[f64], (first, last): (usize, usize), unit: f64) -> Band {
    Band::factor(
        (first + 1..last)
            .map(|i| {
                let row = [SECOND[0], SECOND[1], SECOND[2], SECOND[3]].map(|w| -w * unit);
                [row[0], row[1], row[2], row[3] + stiffness[i]]
            })
            .collect(),
    )
}
