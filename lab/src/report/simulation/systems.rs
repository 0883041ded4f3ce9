//! Stiff equations that are no figures, by the same steppers.

use crate::table::{Cell, Table};
use nalgebra::DMatrix;
use solaris_modes::Counts;
use solaris_modes::time::{RateError, Stepping, System, advance};

/// Van der Pol's oscillator, μ = 1000.
struct VanDerPol;

const MU: f64 = 1000.0;

impl System for VanDerPol {
    fn len(&self) -> usize {
        2
    }

    fn rate(&mut self, _: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        rate.copy_from_slice(&[y[1], MU * (1.0 - y[0] * y[0]) * y[1] - y[0]]);
        Ok(())
    }

    fn jacobian(&mut self, _: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        let row = [-2.0 * MU * y[0] * y[1] - 1.0, MU * (1.0 - y[0] * y[0])];
        jacobian.copy_from_slice(&[0.0, row[0], 1.0, row[1]]);
        Ok(())
    }
}

/// Robertson's chemical kinetics.
struct Robertson;

impl System for Robertson {
    fn len(&self) -> usize {
        3
    }

    fn rate(&mut self, _: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        let (slow, fast) = (0.04 * y[0], 3e7 * y[1] * y[1]);
        let back = 1e4 * y[1] * y[2];
        rate.copy_from_slice(&[back - slow, slow - back - fast, fast]);
        Ok(())
    }

    fn jacobian(&mut self, _: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        let (b, c) = (1e4 * y[2], 1e4 * y[1]);
        let fast = 6e7 * y[1];
        *jacobian = DMatrix::from_row_slice(3, 3, &[-0.04, b, c, 0.04, -b - fast, -c, 0.0, fast, 0.0]);
        Ok(())
    }
}

/// An error at the end, and the evaluations that it took.
fn measured(
    system: &mut dyn System,
    start: &[f64],
    (entry, time, known): (usize, f64, f64),
    tolerance: f64,
) -> Result<(f64, u64), String> {
    let (mut y, mut counts) = (start.to_vec(), Counts::default());
    let stepping = Stepping::Stiff { tolerance };
    advance(system, stepping, (0.0, time), &mut y, &[], &mut |_, _, _| Ok(()), 10_000_000, &mut counts)
        .map_err(|error| error.to_string())?;
    Ok(((y[entry] - known).abs() / known.abs(), counts.evaluations))
}

/// Errors at the end as a share of the answer, and evaluations.
pub(super) fn table() -> Result<Table, String> {
    // Hairer and Wanner, Solving Ordinary Differential Equations II: the test set's reference solutions.
    let van_der_pol = (0, 2000.0, 1.706_167_732_170_483);
    let robertson = (0, 40.0, 0.715_827_068_718_903_2);
    let row = |tolerance: f64| {
        let (error, evaluations) = measured(&mut VanDerPol, &[2.0, 0.0], van_der_pol, tolerance)?;
        let (other, others) = measured(&mut Robertson, &[1.0, 0.0, 0.0], robertson, tolerance)?;
        let numbers = |x: f64| Cell::Numbers(vec![x]);
        let [evaluations, others] = [evaluations, others].map(|count| numbers(count as f64));
        Ok(vec![Cell::text(format!("{tolerance:.0e}")), numbers(error), evaluations, numbers(other), others])
    };
    Ok(Table {
        header: vec![
            "tolerance",
            "van der Pol, μ = 1000, t = 2000",
            "evaluations",
            "Robertson, t = 40",
            "evaluations",
        ],
        rows: [1e-4, 1e-6, 1e-8, 1e-10].into_iter().map(row).collect::<Result<_, String>>()?,
    })
}
