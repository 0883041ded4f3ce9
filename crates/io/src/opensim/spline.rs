//! Interpolating cubic splines, as pieces.

use solaris_model::Curve;

/// A spline through points, whose abscissae rise strictly (two at least).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ends {
    /// The third derivative at each end is that of the cubic through the four points nearest to it; with three points, one
    /// parabola.
    FourPoints,
    /// No curvature at the ends.
    Natural,
    /// Straight from point to point.
    Straight,
}

/// The curve through the points `(x, y)`; points on a line give the line itself.
///
/// ```text
/// hᵢ = xᵢ₊₁ − xᵢ        sᵢ = (yᵢ₊₁ − yᵢ)/hᵢ
/// hᵢ₋₁·σᵢ₋₁ + 2·(hᵢ₋₁ + hᵢ)·σᵢ + hᵢ·σᵢ₊₁ = sᵢ − sᵢ₋₁            σ = f″/6 at the knots
/// FourPoints:  h₀·(σ₁ − σ₀) = h₀²·Δ₀      Δ₀ = third divided difference of the first four points, and so at the other end
/// Natural:     σ₀ = σₙ = 0
/// fᵢ(t) = yᵢ + (sᵢ − hᵢ·(σᵢ₊₁ + 2·σᵢ))·t + 3·σᵢ·t² + (σᵢ₊₁ − σᵢ)/hᵢ·t³
/// ```
///
/// # Source
///
/// `FourPoints` is the spline of G. E. Forsythe, M. A. Malcolm, C. B. Moler, *Computer Methods for Mathematical
/// Computations* (1977), §4.4, which SIMM and OpenSim use; OpenSim, too, goes straight on beyond the ends.
pub(super) fn through(x: &[f64], y: &[f64], ends: Ends) -> Curve {
    let last = x.len() - 1;
    let h: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let slope: Vec<f64> = (0..last).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    if let Some(line) = line(x, y) {
        return line;
    }
    let sigma = match ends {
        Ends::Straight => vec![0.0; x.len()],
        _ => curvatures(x, &h, &slope, ends),
    };
    let piece = |i: usize| {
        let (now, next) = (sigma[i], sigma[i + 1]);
        [y[i], slope[i] - h[i] * (next + 2.0 * now), 3.0 * now, (next - now) / h[i]]
    };
    Curve::Cubics { knots: x.to_vec(), pieces: (0..last).map(piece).collect() }
}

/// `σ` at every knot, by elimination.
fn curvatures(x: &[f64], h: &[f64], slope: &[f64], ends: Ends) -> Vec<f64> {
    let last = x.len() - 1;
    let mut diagonal = vec![1.0; last + 1];
    let mut right = vec![0.0; last + 1];
    // What stands beside the diagonal; symmetric, so one row serves both sides.
    let mut beside = h.to_vec();
    for i in 1..last {
        diagonal[i] = 2.0 * (h[i - 1] + h[i]);
        right[i] = slope[i] - slope[i - 1];
    }
    let natural = ends == Ends::Natural;
    if !natural {
        (diagonal[0], diagonal[last]) = (-h[0], -h[last - 1]);
        if last > 2 {
            let second = |i: usize| right[i] / (x[i + 1] - x[i - 1]);
            let first = (second(2) - second(1)) / (x[3] - x[0]);
            let end = (second(last - 1) - second(last - 2)) / (x[last] - x[last - 3]);
            right[0] = h[0] * h[0] * first;
            right[last] = -h[last - 1] * h[last - 1] * end;
        }
    }
    let (mut before, mut after) = (beside.clone(), std::mem::take(&mut beside));
    if natural {
        (after[0], before[last - 1]) = (0.0, 0.0);
    }
    for i in 1..=last {
        let factor = before[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * after[i - 1];
        right[i] -= factor * right[i - 1];
    }
    right[last] /= diagonal[last];
    for i in (0..last).rev() {
        right[i] = (right[i] - after[i] * right[i + 1]) / diagonal[i];
    }
    right
}

/// The line that the points lie on, if they do to rounding.
fn line(x: &[f64], y: &[f64]) -> Option<Curve> {
    let (first, last) = ((x[0], y[0]), (x[x.len() - 1], y[y.len() - 1]));
    let slope = (last.1 - first.1) / (last.0 - first.0);
    let size = y.iter().fold(0.0_f64, |size, y| size.max(y.abs()));
    let off = |(x, y): (&f64, &f64)| (first.1 + slope * (x - first.0) - y).abs();
    let on = x.iter().zip(y).all(|point| off(point) <= 1e-14 * size);
    on.then(|| Curve::linear(slope, first.1 - slope * first.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const X: [f64; 5] = [-2.0, -1.2, -0.5, 0.4, 2.0];

    /// Four points fix the ends, so a cubic is its own spline.
    #[test]
    fn a_cubic_comes_back() {
        let cubic = |x: f64| 0.5 - x + 0.3 * x * x + 0.2 * x * x * x;
        let curve = through(&X, &X.map(cubic), Ends::FourPoints);
        for x in [-2.0, -1.9, -0.7, 0.0, 1.3, 2.0] {
            let [value, first, second] = curve.at(x);
            assert_relative_eq!(value, cubic(x), epsilon = 1e-14);
            assert_relative_eq!(first, -1.0 + 0.6 * x + 0.6 * x * x, epsilon = 1e-13);
            assert_relative_eq!(second, 0.6 + 1.2 * x, epsilon = 1e-12);
        }
        // Straight on, with the slope at the end: −1 + 0.6·2 + 0.6·4 = 2.6 and f(2) = 1.3.
        assert_relative_eq!(curve.at(3.0)[0], 1.3 + 2.6, epsilon = 1e-13);
    }

    /// By hand: three points 0, 1, 0 at 0, 1, 2 have σ₁ = (−1 − 1)/4 = −½ between natural ends.
    #[test]
    fn a_natural_spline_has_no_curvature_at_its_ends() {
        let curve = through(&[0.0, 1.0, 2.0], &[0.0, 1.0, 0.0], Ends::Natural);
        let near =
            |found: [f64; 3], expected: [f64; 3]| (0..3).all(|i| (found[i] - expected[i]).abs() < 1e-15);
        assert!(near(curve.at(0.0), [0.0, 1.5, 0.0]));
        assert!(near(curve.at(1.0), [1.0, 0.0, -3.0]));
        assert_relative_eq!(curve.at(0.5)[0], 0.75 - 0.5 * 0.125, epsilon = 1e-15);
    }

    #[test]
    fn three_points_make_a_parabola() {
        let curve = through(&[0.0, 1.0, 3.0], &[0.0, 1.0, 9.0], Ends::FourPoints);
        assert_relative_eq!(curve.at(2.0)[0], 4.0, epsilon = 1e-14);
        assert_relative_eq!(curve.at(2.0)[2], 2.0, epsilon = 1e-14);
    }

    #[test]
    fn splines_go_through_their_points_smoothly() {
        let y = [0.3, -0.1, 0.25, 0.2, 1.0];
        for ends in [Ends::FourPoints, Ends::Natural] {
            let curve = through(&X, &y, ends);
            for (x, y) in X.iter().zip(y) {
                assert_relative_eq!(curve.at(*x)[0], y, epsilon = 1e-14);
            }
            for x in &X[1..4] {
                let (before, after) = (curve.at(x - 1e-9), curve.at(x + 1e-9));
                assert_relative_eq!(before[1], after[1], epsilon = 1e-8);
                assert_relative_eq!(before[2], after[2], epsilon = 1e-7);
            }
        }
    }

    #[test]
    fn points_on_a_line_are_the_line() {
        assert_eq!(through(&[-2.0, 2.0], &[-2.0, 2.0], Ends::FourPoints), Curve::linear(1.0, 0.0));
        assert_eq!(through(&[0.0, 1.0, 4.0], &[1.0, 3.0, 9.0], Ends::Straight), Curve::linear(2.0, 1.0));
    }
}
