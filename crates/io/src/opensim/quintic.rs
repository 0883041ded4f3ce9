//! Interpolating splines of degree five, as pieces.

use solaris_model::Curve;

type Pair = [f64; 2];
type Square = [Pair; 2];

/// The natural quintic spline through the points `(x, y)`, six at least, whose abscissae rise: of all curves through them the
/// one with the least `∫ f‴²`, a parabola beyond its ends.
///
/// ```text
/// h = xᵢ₊₁ − xᵢ      Δ = yᵢ₊₁ − yᵢ      d = f′, s = f″ at the knots
/// f⁗ at a piece's beginning and end:  (−360·Δ + 192·h·d₀ + 168·h·d₁ + 36·h²·s₀ − 24·h²·s₁)/h⁴
///                                     ( 360·Δ − 168·h·d₀ − 192·h·d₁ − 24·h²·s₀ + 36·h²·s₁)/h⁴
/// f‴ at a piece's beginning and end:  (  60·Δ −  36·h·d₀ −  24·h·d₁ −  9·h²·s₀ +  3·h²·s₁)/h³
///                                     (  60·Δ −  24·h·d₀ −  36·h·d₁ −  3·h²·s₀ +  9·h²·s₁)/h³
/// ```
///
/// Both are continuous at the knots and zero at the ends: two equations for the two unknowns of every knot, symmetric and
/// positive definite.
///
/// # Source
///
/// H. J. Woltring, *A Fortran package for generalized, cross-validatory spline smoothing and differentiation*, Adv. Eng.
/// Software 8 (1986), 104–113: the spline of `half_order` 3 without smoothing, which is OpenSim's `GCVSpline`.
pub(super) fn through(x: &[f64], y: &[f64]) -> Curve {
    let last = x.len() - 1;
    let step = |i: usize| (x[i + 1] - x[i], y[i + 1] - y[i]);
    // Of every knot its own block, that beside it to the right, and the right side.
    let mut own = vec![[[0.0; 2]; 2]; last + 1];
    let mut beside = vec![[[0.0; 2]; 2]; last];
    let mut right = vec![[0.0; 2]; last + 1];
    for i in 0..last {
        let (h, rise) = step(i);
        let [a, b, c] = [h * h * h, h * h, h];
        add(&mut own[i], [[192.0 / a, 36.0 / b], [36.0 / b, 9.0 / c]]);
        add(&mut own[i + 1], [[192.0 / a, -36.0 / b], [-36.0 / b, 9.0 / c]]);
        beside[i] = [[168.0 / a, -24.0 / b], [24.0 / b, -3.0 / c]];
        let (fourth, third) = (360.0 * rise / (a * h), 60.0 * rise / a);
        right[i] = [right[i][0] + fourth, right[i][1] + third];
        right[i + 1] = [right[i + 1][0] + fourth, right[i + 1][1] - third];
    }
    // Elimination downward, block by block; below stands what is beside, transposed.
    for i in 0..last {
        let inverse = inverted(own[i]);
        let factor = product(transposed(beside[i]), inverse);
        let down = product(factor, beside[i]);
        add(&mut own[i + 1], down.map(|row| row.map(|x| -x)));
        let by = times(factor, right[i]);
        right[i + 1] = [right[i + 1][0] - by[0], right[i + 1][1] - by[1]];
    }
    let mut at = vec![[0.0; 2]; last + 1];
    at[last] = times(inverted(own[last]), right[last]);
    for i in (0..last).rev() {
        let by = times(beside[i], at[i + 1]);
        at[i] = times(inverted(own[i]), [right[i][0] - by[0], right[i][1] - by[1]]);
    }
    let piece = |i: usize| {
        let (h, rise) = step(i);
        let ([d0, s0], [d1, s1]) = (at[i], at[i + 1]);
        let [e0, e1, w0, w1] = [d0 * h, d1 * h, s0 * h * h, s1 * h * h];
        [
            y[i],
            d0,
            0.5 * s0,
            (20.0 * rise - 12.0 * e0 - 8.0 * e1 - 3.0 * w0 + w1) / (2.0 * h.powi(3)),
            (-30.0 * rise + 16.0 * e0 + 14.0 * e1 + 3.0 * w0 - 2.0 * w1) / (2.0 * h.powi(4)),
            (12.0 * rise - 6.0 * e0 - 6.0 * e1 - w0 + w1) / (2.0 * h.powi(5)),
        ]
    };
    Curve::Quintics { knots: x.to_vec(), pieces: (0..last).map(piece).collect() }
}

fn add(to: &mut Square, other: Square) {
    for (row, other) in to.iter_mut().zip(other) {
        *row = [row[0] + other[0], row[1] + other[1]];
    }
}

fn transposed([[a, b], [c, d]]: Square) -> Square {
    [[a, c], [b, d]]
}

fn inverted([[a, b], [c, d]]: Square) -> Square {
    let determinant = a * d - b * c;
    [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
}

fn times(matrix: Square, [x, y]: Pair) -> Pair {
    matrix.map(|[a, b]| a * x + b * y)
}

fn product(a: Square, b: Square) -> Square {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| row[0] * column[0] + row[1] * column[1]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// The values of OpenSim 4.6.
    #[test]
    fn it_is_the_spline_of_opensim() {
        let x = [-1.0, -0.4, 0.1, 0.7, 1.5, 1.9, 2.6];
        let y = [0.3, -0.1, 0.4, 0.2, 0.5, 0.45, -0.2];
        let curve = through(&x, &y);
        let cases = [
            (-2.0, [5.979_700_574_781_45, -8.869_200_071_011_115, 6.378_998_992_459_326]),
            (-0.9, [0.082_867_929_909_134_11, -1.852_649_039_204_978, 6.365_084_596_494_408]),
            (0.5, [0.304_876_254_682_273_75, -0.618_772_051_048_612_3, 0.003_559_187_222_871_018_6]),
            (1.7, [0.518_440_405_085_610_4, -0.138_855_377_023_432_7, -2.228_430_353_493_701_3]),
            (3.4, [-1.481_618_741_005_014_1, -1.947_547_672_891_718_5, -0.863_810_616_588_627_3]),
        ];
        for (x, expected) in cases {
            for (found, expected) in curve.at(x).into_iter().zip(expected) {
                assert_relative_eq!(found, expected, epsilon = 1e-12, max_relative = 1e-12);
            }
        }
    }

    /// A parabola bends by no third derivative, so it is its own spline.
    #[test]
    fn a_parabola_comes_back() {
        let parabola = |x: f64| 0.3 - 0.5 * x + 2.0 * x * x;
        let x = [-1.0, 0.0, 0.5, 2.0, 2.2, 5.0];
        let curve = through(&x, &x.map(parabola));
        for x in [-3.0, -0.5, 0.7, 2.1, 4.0, 7.0] {
            let expected = [parabola(x), -0.5 + 4.0 * x, 4.0];
            for (found, expected) in curve.at(x).into_iter().zip(expected) {
                assert_relative_eq!(found, expected, epsilon = 1e-11, max_relative = 1e-11);
            }
        }
    }
}
