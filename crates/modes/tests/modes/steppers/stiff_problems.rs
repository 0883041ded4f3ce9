//! Stiff equations whose solutions are known to many digits.

use crate::steppers::problems::Equations;
use nalgebra::DMatrix;
use solaris_modes::time::{RateError, System};

/// The oscillator of van der Pol, `ẍ = μ(1 − x²)ẋ − x`.
pub(crate) fn van_der_pol(stiffness: f64) -> impl System {
    Equations {
        len: 2,
        rate: move |_: f64, y: &[f64], rate: &mut [f64]| {
            rate[0] = y[1];
            rate[1] = stiffness * (1.0 - y[0] * y[0]) * y[1] - y[0];
            Ok(())
        },
        jacobian: move |_: f64, y: &[f64], jacobian: &mut DMatrix<f64>| {
            let (by_x, by_v) = (-2.0 * stiffness * y[0] * y[1] - 1.0, stiffness * (1.0 - y[0] * y[0]));
            *jacobian = DMatrix::from_row_slice(2, 2, &[0.0, 1.0, by_x, by_v]);
        },
    }
}

/// Robertson's chemical reaction, with rates nine powers of ten apart.
pub(crate) fn robertson() -> impl System {
    Equations {
        len: 3,
        rate: |_: f64, y: &[f64], rate: &mut [f64]| {
            rate[0] = -0.04 * y[0] + 1e4 * y[1] * y[2];
            rate[2] = 3e7 * y[1] * y[1];
            rate[1] = -rate[0] - rate[2];
            Ok(())
        },
        jacobian: |_: f64, y: &[f64], jacobian: &mut DMatrix<f64>| {
            let (a, b, c) = (1e4 * y[2], 1e4 * y[1], 6e7 * y[1]);
            #[rustfmt::skip]
            let entries = [
                -0.04,  a,     b,
                 0.04, -a - c, -b,
                 0.0,   c,     0.0,
            ];
            *jacobian = DMatrix::from_row_slice(3, 3, &entries);
        },
    }
}

/// A flyball governor whose two rods move alike: height of its base, angle of its rods, turning of its shaft, and their
/// rates.
///
/// The parameters are those of the stiff problem of the `IFToMM` library of benchmarks (`OpenSim`'s version of it): a
/// shaft of 0.3 kg, a base of 3 kg that slides on it, two rods of 1 m and 0.3 kg with 5 kg at their ends, springs of 8e5
/// N/m and 4e4 N s/m and 0.5 m from the base to the middles of the rods.
pub(crate) struct Governor;

impl Governor {
    pub(crate) const START: [f64; 6] =
        [0.5, std::f64::consts::FRAC_PI_3, 0.0, 0.0, 0.0, std::f64::consts::TAU];
}

impl System for Governor {
    fn len(&self) -> usize {
        6
    }

    fn rate(&mut self, _: f64, y: &[f64], rate: &mut [f64]) -> Result<(), RateError> {
        let (g, stiffness, damping, rest) = (9.81, 8e5, 4e4, 0.5);
        let (s, (sin, cos)) = (y[0], y[1].sin_cos());
        let (height, swing, spin) = (y[3], y[4], y[5]);
        // A box of mass m and half sizes a, b has m(a² + b²)/3 about the third axis; that of the base is 3 kg.
        let (across, along) = (0.3 / 3.0 * (0.005_f64.powi(2) + 0.25), 0.3 / 3.0 * 2.0 * 0.005_f64.powi(2));
        let inertia = 2.0 * (0.3 * 0.25 + across + 5.0);
        let (middle, end) = (0.05 + 0.5 * sin, 0.05 + sin);
        let about = 0.3 / 3.0 * 2.0 * 0.005_f64.powi(2)
            + 2.0 * 0.05_f64.powi(2)
            + 2.0 * (0.3 * middle * middle + 5.0 * end * end + across * sin * sin + along * cos * cos);
        let slope = 2.0 * (0.3 * middle * cos + 10.0 * end * cos + 2.0 * (across - along) * sin * cos);
        let (x, z) = (0.5 * sin, 1.0 - 0.5 * cos - s);
        let length = x.hypot(z);
        let (by_swing, by_height) = (0.5 * (x * cos + z * sin) / length, -z / length);
        let speed = by_swing * swing + by_height * height;
        let tension = stiffness * (length - rest) + damping * speed;
        rate[..3].copy_from_slice(&y[3..]);
        rate[3] = -g - 2.0 * tension * by_height / 3.0;
        rate[4] = (0.5 * slope * spin * spin - 2.0 * 5.15 * g * sin - 2.0 * tension * by_swing) / inertia;
        rate[5] = -slope * swing * spin / about;
        Ok(())
    }

    fn jacobian(&mut self, t: f64, y: &[f64], jacobian: &mut DMatrix<f64>) -> Result<(), RateError> {
        let (mut at, mut above, mut below) = (y.to_vec(), [0.0; 6], [0.0; 6]);
        for column in 0..6 {
            let h = 1e-6 * y[column].abs().max(1.0);
            at[column] = y[column] + h;
            self.rate(t, &at, &mut above)?;
            at[column] = y[column] - h;
            self.rate(t, &at, &mut below)?;
            at[column] = y[column];
            for row in 0..6 {
                jacobian[(row, column)] = (above[row] - below[row]) / (2.0 * h);
            }
        }
        Ok(())
    }
}
