//! The way of the centre of mass from rest to rest.

use super::band::Band;
use crate::grid::SECOND;

/// One coordinate's equation at the nodes: `ẍ = k(x − P − Σ aⱼ Bⱼ) + h`.
pub(super) struct Coordinate<'a> {
    /// Centre of pressure (m).
    pub(super) centre: &'a [f64],
    /// The body's own part, from its angular momentum (m/s²).
    pub(super) own: &'a [f64],
    /// Shapes of the two shifts whose amplitudes are free.
    pub(super) shapes: [&'a [f64]; 2],
    /// Rest before and after (m).
    pub(super) rest: (f64, f64),
}

/// Solves one coordinate between the nodes `first` and `last`, at rest there and beyond.
///
/// `D²x − kx = −k(P + Σ aⱼBⱼ) + h` at the inner nodes, with the seven-point second difference; the same equation imposed at
/// the two end nodes as well decides the two amplitudes. One banded factorisation serves three right sides. Returns the
/// coordinate at all nodes, and the amplitudes.
pub(super) fn rest_to_rest(
    factor: &Band,
    stiffness: &[f64],
    (first, last): (usize, usize),
    unit: f64,
    coordinate: &Coordinate<'_>,
) -> (Vec<f64>, [f64; 2]) {
    let inner = last - first - 1;
    let (before, after) = coordinate.rest;
    let [b1, b2] = coordinate.shapes;
    let weight = |k: usize| SECOND[k] * unit;
    // The factored matrix is k − D²: every sign is turned.
    let mut x: Vec<[f64; 3]> = (first + 1..last)
        .map(|i| {
            let k = stiffness[i];
            [k * coordinate.centre[i] - coordinate.own[i], k * b1[i], k * b2[i]]
        })
        .collect();
    for i in 0..3 {
        for k in 0..3 - i {
            x[i][0] += weight(k) * before;
            x[inner - 1 - i][0] += weight(k) * after;
        }
    }
    factor.solve(&mut x);
    // The particular solution rests at its ends, the two others at zero.
    let value = |node: isize, column: usize| {
        let i = node - first as isize - 1;
        let rest = |x: f64| if column == 0 { x } else { 0.0 };
        if i < 0 {
            rest(before)
        } else if i >= inner as isize {
            rest(after)
        } else {
            x[i as usize][column]
        }
    };
    let residual = |node: usize, column: usize| {
        let k = stiffness[node];
        let difference: f64 = (0..7).map(|j| weight(j) * value(node as isize + j as isize - 3, column)).sum();
        let forcing = match column {
            0 => k * coordinate.centre[node] - coordinate.own[node],
            1 => k * b1[node],
            _ => k * b2[node],
        };
        difference - k * value(node as isize, column) + forcing
    };
    let [e, f] = [first, last].map(|node| [0, 1, 2].map(|column| residual(node, column)));
    let determinant = e[1] * f[2] - e[2] * f[1];
    let amplitudes = [(e[2] * f[0] - e[0] * f[2]) / determinant, (e[0] * f[1] - e[1] * f[0]) / determinant];
    let solution = (0..stiffness.len())
        .map(|i| match i {
            i if i <= first => before,
            i if i >= last => after,
            i => {
                x[i - first - 1][0]
                    + x[i - first - 1][1] * amplitudes[0]
                    + x[i - first - 1][2] * amplitudes[1]
            }
        })
        .collect();
    (solution, amplitudes)
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
