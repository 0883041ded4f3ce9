//! Damped Gauss–Newton steps (Levenberg, Marquardt) on the coefficients of all style numbers at once.

use super::targets::Stride;
use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use solaris_gait::StyleTable;

/// Weight of the pull of each coefficient towards the recipe's, in tenths of its row's greatest one.
const PULL: f64 = 0.08;
/// Steps of the differences, in a row's scale. Maxima over samples and limits of the legs have kinks: where one step leads
/// nowhere, the next one may.
const STEPS: [f64; 4] = [5e-3, 5e-2, 1.5e-2, 0.15];

/// What the table of the fit comes to.
struct State {
    table: StyleTable,
    residuals: Vec<Vec<f64>>,
    cost: f64,
}

/// A row's scale: a tenth of its greatest coefficient.
fn scale(row: &[f64; 4]) -> f64 {
    0.1 * row.iter().fold(0.0_f64, |most, c| most.max(c.abs()))
}

fn square(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum()
}

/// The table that `iterations` steps from `start` come to.
pub(crate) fn fit(
    recipe: &StyleTable,
    start: &StyleTable,
    targets: &[Stride],
    iterations: usize,
) -> Result<StyleTable, String> {
    let scales: Vec<f64> = recipe.rows.iter().map(scale).collect();
    let pull = |table: &StyleTable| -> Vec<f64> {
        let rows = table.rows.iter().zip(&recipe.rows).zip(&scales);
        rows.flat_map(|((row, recipe), scale)| (0..4).map(move |k| PULL * (row[k] - recipe[k]) / scale))
            .collect()
    };
    let state = |table: StyleTable| -> Result<State, String> {
        let residuals: Vec<Vec<f64>> =
            targets.par_iter().map(|target| target.residuals(&table)).collect::<Result<_, _>>()?;
        let cost = residuals.iter().map(|r| square(r)).sum::<f64>() + square(&pull(&table));
        Ok(State { table, residuals, cost })
    };
    let mut now = state(start.clone())?;
    let (mut damping, mut tried, mut failed, mut slow) = (1e-2, 0, 0, 0);
    eprintln!("fit: cost {:.2}", now.cost);
    for iteration in 1..=iterations {
        let (matrix, gradient) =
            normal(&now, targets, &scales, &pull(&now.table), STEPS[tried % STEPS.len()])?;
        let mut better = None;
        for _ in 0..7 {
            let mut damped = matrix.clone();
            for i in 0..damped.nrows() {
                damped[(i, i)] += damping * (matrix[(i, i)] + 0.05);
            }
            let step = damped.cholesky().ok_or("the normal equations are singular")?.solve(&gradient);
            let mut table = now.table.clone();
            for (i, step) in step.iter().enumerate() {
                table.rows[i / 4][i % 4] -= step * scales[i / 4];
            }
            // A table in which a stride does not close is no better.
            if let Ok(next) = state(table)
                && next.cost < now.cost
            {
                better = Some(next);
                break;
            }
            damping *= 4.0;
        }
        let Some(next) = better else {
            (tried, failed, damping) = (tried + 1, failed + 1, 1.0);
            if failed == STEPS.len() {
                break;
            }
            continue;
        };
        failed = 0;
        if next.cost > 0.998 * now.cost {
            tried += 1;
            slow += 1;
        } else {
            slow = 0;
        }
        eprintln!(
            "fit: iteration {iteration}, cost {:.2}, damping {damping:.1e}, differences {}",
            next.cost,
            STEPS[tried % 4]
        );
        now = next;
        if slow > 2 * STEPS.len() {
            break;
        }
        damping = (damping / 3.0).max(1e-6);
    }
    explain(&now, targets);
    Ok(now.table)
}

/// Prints what costs most in each target.
fn explain(state: &State, targets: &[Stride]) {
    for (target, residuals) in targets.iter().zip(&state.residuals) {
        let mut most: Vec<(usize, f64)> = residuals.iter().map(|r| r * r).enumerate().collect();
        most.sort_by(|a, b| b.1.total_cmp(&a.1));
        let most: Vec<String> =
            most.iter().take(8).map(|(i, r)| format!("{} {r:.1}", target.name(*i))).collect();
        let case = target.case();
        eprintln!(
            "{:.2} m {:5.1} /min {:8.1}: {}",
            case.height,
            case.step_frequency,
            square(residuals),
            most.join(", ")
        );
    }
}

/// `JᵀJ` and `Jᵀr` by coefficients in their rows' scales. A number is a sum over its row, so its derivative serves all four.
fn normal(
    now: &State,
    targets: &[Stride],
    scales: &[f64],
    pull: &[f64],
    step: f64,
) -> Result<(DMatrix<f64>, DVector<f64>), String> {
    let (numbers, size) = (scales.len(), 4 * scales.len());
    let jobs: Vec<(usize, usize)> =
        (0..targets.len()).flat_map(|target| (0..numbers).map(move |number| (target, number))).collect();
    let columns: Vec<Vec<f64>> = jobs
        .par_iter()
        .map(|&(target, number)| {
            let mut table = now.table.clone();
            table.rows[number][0] += step * scales[number];
            // A stride that does not close says nothing about the slope.
            let Ok(moved) = targets[target].residuals(&table) else {
                return Ok(vec![0.0; now.residuals[target].len()]);
            };
            Ok(moved.iter().zip(&now.residuals[target]).map(|(a, b)| (a - b) / step).collect())
        })
        .collect::<Result<_, String>>()?;
    let mut matrix = DMatrix::identity(size, size) * (PULL * PULL);
    let mut gradient = DVector::from_iterator(size, pull.iter().map(|pull| PULL * pull));
    for (t, target) in targets.iter().enumerate() {
        let residuals = DVector::from_column_slice(&now.residuals[t]);
        let slopes =
            DMatrix::from_fn(residuals.len(), numbers, |row, number| columns[t * numbers + number][row]);
        let (product, right) = (slopes.tr_mul(&slopes), slopes.tr_mul(&residuals));
        let basis = target.case().basis();
        for i in 0..size {
            gradient[i] += right[i / 4] * basis[i % 4];
            for j in 0..size {
                matrix[(i, j)] += product[(i / 4, j / 4)] * basis[i % 4] * basis[j % 4];
            }
        }
    }
    Ok((matrix, gradient))
}
