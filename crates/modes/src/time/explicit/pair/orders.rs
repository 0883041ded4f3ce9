//! The order of the coefficients, by the conditions of Butcher: a tree for each.
//!
//! # Source
//!
//! J. C. Butcher: Numerical Methods for Ordinary Differential Equations, 3rd edition (2016), §31: a formula is of order `p` where
//! `Σ bᵢ·Φᵢ(τ) = 1/γ(τ)` for every rooted tree `τ` with up to `p` vertices, with `Φ(τ) = Π Σⱼ aᵢⱼ·Φⱼ` over the subtrees at its root
//! and `γ(τ)` the number of its vertices times the product of `γ` of these subtrees.

use super::super::tableau::{A, ALL_STAGES, B, D, E3, E5, EXTRA, NODES, Row, STAGES};

/// A tree: its subtrees, as indices of trees before it, the greatest first.
struct Tree {
    size: usize,
    children: Vec<usize>,
}

/// Every rooted tree with up to `most` vertices.
fn trees(most: usize) -> Vec<Tree> {
    let mut all = vec![Tree { size: 1, children: Vec::new() }];
    for size in 2..=most {
        let mut forests = Vec::new();
        forest(&all, size - 1, all.len(), &mut Vec::new(), &mut forests);
        all.extend(forests.into_iter().map(|children| Tree { size, children }));
    }
    all
}

/// Every way to fill `left` vertices with trees before `end`.
fn forest(all: &[Tree], left: usize, end: usize, chosen: &mut Vec<usize>, found: &mut Vec<Vec<usize>>) {
    if left == 0 {
        found.push(chosen.clone());
        return;
    }
    for next in (0..end).filter(|next| all[*next].size <= left) {
        chosen.push(next);
        forest(all, left - all[next].size, next + 1, chosen, found);
        chosen.pop();
    }
}

/// `aᵢⱼ` of all stages.
fn matrix() -> Vec<Row> {
    let mut rows: Vec<Row> = vec![&[]];
    rows.extend(A);
    rows.push(B);
    rows.extend(EXTRA);
    rows
}

/// `Φᵢ(τ)` by tree and stage, and `γ(τ)`.
fn weights(all: &[Tree]) -> Vec<(Vec<f64>, f64)> {
    let rows = matrix();
    let mut found: Vec<(Vec<f64>, f64)> = Vec::new();
    for tree in all {
        let mut gamma = tree.size as f64;
        let mut phi = vec![1.0; ALL_STAGES];
        for child in &tree.children {
            let (below, of) = &found[*child];
            gamma *= of;
            for (phi, row) in phi.iter_mut().zip(&rows) {
                *phi *= row.iter().map(|(j, a)| a * below[*j]).sum::<f64>();
            }
        }
        found.push((phi, gamma));
    }
    found
}

/// By how much the worst condition of trees with this many vertices is missed, for weights of a formula.
fn missed(row: &[(usize, f64)], size: usize) -> f64 {
    let all = trees(size);
    let of = weights(&all);
    let of = all.iter().zip(&of).filter(|(tree, _)| tree.size == size);
    of.map(|(_, (phi, gamma))| (row.iter().map(|(i, b)| b * phi[*i]).sum::<f64>() - gamma.recip()).abs())
        .fold(0.0, f64::max)
}

/// The weights of the formula that an error tells of.
fn embedded(error: Row) -> Vec<(usize, f64)> {
    let mut weights = [0.0; STAGES];
    for (i, b) in B {
        weights[*i] += b;
    }
    for (i, e) in error {
        weights[*i] -= e;
    }
    weights.into_iter().enumerate().collect()
}

#[test]
fn there_are_as_many_trees_as_there_should_be() {
    let all = trees(8);
    let count = |size| all.iter().filter(|tree| tree.size == size).count();
    assert_eq!([1, 2, 3, 4, 5, 6, 7, 8].map(count), [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn stages_are_where_their_rows_say() {
    for (row, node) in matrix().into_iter().zip(NODES) {
        approx::assert_abs_diff_eq!(row.iter().map(|(_, a)| a).sum::<f64>(), node, epsilon = 1e-14);
    }
}

#[test]
fn the_formula_is_of_order_eight_and_no_more() {
    for size in 1..=8 {
        assert!(missed(B, size) < 1e-14, "{size}: {:e}", missed(B, size));
    }
    assert!(missed(B, 9) > 1e-8, "{:e}", missed(B, 9));
}

#[test]
fn its_errors_are_those_of_orders_five_and_three() {
    for (error, order) in [(E5, 5), (E3, 3)] {
        let formula = embedded(error);
        for size in 1..=order {
            assert!(missed(&formula, size) < 1e-14, "{order}, {size}: {:e}", missed(&formula, size));
        }
        assert!(missed(&formula, order + 1) > 1e-5, "{order}: {:e}", missed(&formula, order + 1));
    }
}

/// `b(θ)` of the interpolation meets `Σ bᵢ(θ)·Φᵢ(τ) = θ^|τ|/γ(τ)` for every tree with up to seven vertices.
#[test]
fn the_interpolation_is_of_order_seven_everywhere() {
    let all = trees(8);
    let of = weights(&all);
    for fraction in [0.1, 0.25, 0.5, 0.7, 0.95, 1.0] {
        let weights = interpolation(fraction);
        let mut worst = [0.0_f64; 9];
        for (tree, (phi, gamma)) in all.iter().zip(&of) {
            let sum: f64 = weights.iter().zip(phi).map(|(b, phi)| b * phi).sum();
            let wanted = f64::powi(fraction, tree.size as i32) / gamma;
            worst[tree.size] = worst[tree.size].max((sum - wanted).abs());
        }
        assert!(worst[..8].iter().all(|missed| *missed < 1e-14), "{fraction}: {worst:?}");
        if fraction < 1.0 {
            assert!(worst[8] > 1e-9, "{fraction}: {worst:?}");
        }
    }
}

/// `bᵢ(θ)`, from what [`super::Pair::at`] does with steps of length 1.
fn interpolation(fraction: f64) -> [f64; ALL_STAGES] {
    let mut terms = [[0.0; ALL_STAGES]; 7];
    for (i, b) in B {
        terms[0][*i] = *b;
    }
    for i in 0..ALL_STAGES {
        let (first, last) = (f64::from(i == 0), f64::from(i == STAGES));
        terms[1][i] = first - terms[0][i];
        terms[2][i] = 2.0 * terms[0][i] - first - last;
    }
    for (term, row) in terms[3..].iter_mut().zip(D) {
        for (i, d) in row {
            term[*i] = *d;
        }
    }
    let mut weights = [0.0; ALL_STAGES];
    for (index, term) in terms.iter().enumerate().rev() {
        let factor = if index % 2 == 0 { fraction } else { 1.0 - fraction };
        for (weight, term) in weights.iter_mut().zip(term) {
            *weight = (*weight + term) * factor;
        }
    }
    weights
}
