//! Functions of functions.

use solaris_model::Curve;

/// The most coefficients that a polynomial of a polynomial may have.
const MOST: usize = 64;

/// How near to ±1 a slope is taken for it.
pub(super) const UNIT: f64 = 1e-9;

/// Slope and offset of a curve that is a line.
pub(super) fn line(curve: &Curve) -> Option<(f64, f64)> {
    let Curve::Polynomial(coefficients) = curve else { return None };
    let at = |i: usize| coefficients.get(i).copied().unwrap_or(0.0);
    coefficients.iter().skip(2).all(|c| *c == 0.0).then(|| (at(1), at(0)))
}

/// The value of a curve that has the same everywhere.
pub(super) fn constant(curve: &Curve) -> Option<f64> {
    line(curve).filter(|(slope, _)| *slope == 0.0).map(|(_, offset)| offset)
}

/// `f(x) − x`, where it is a curve of the same kind.
pub(super) fn beside_identity(curve: &Curve) -> Option<Curve> {
    match curve {
        Curve::Polynomial(coefficients) => {
            let mut coefficients = coefficients.clone();
            coefficients.resize(coefficients.len().max(2), 0.0);
            coefficients[1] -= 1.0;
            Some(Curve::Polynomial(coefficients))
        }
        Curve::Cubics { knots, pieces } => {
            Some(Curve::Cubics { knots: knots.clone(), pieces: less_identity(knots, pieces) })
        }
        Curve::Quintics { knots, pieces } => {
            Some(Curve::Quintics { knots: knots.clone(), pieces: less_identity(knots, pieces) })
        }
        _ => None,
    }
}

fn less_identity<const N: usize>(knots: &[f64], pieces: &[[f64; N]]) -> Vec<[f64; N]> {
    let mut pieces = pieces.to_vec();
    for (piece, knot) in pieces.iter_mut().zip(knots) {
        piece[0] -= knot;
        piece[1] -= 1.0;
    }
    pieces
}

/// `outer(inner(x))`: of one kind where it is (everything of a line, a line of everything, polynomials), else a chain.
pub(super) fn compose(outer: &Curve, inner: &Curve) -> Curve {
    if let Some((slope, offset)) = line(outer) {
        return raised(inner.scaled(slope), offset);
    }
    match (outer, inner, line(inner)) {
        (_, _, Some((0.0, offset))) => Curve::Polynomial(vec![outer.at(offset)[0]]),
        (Curve::Cubics { knots, pieces }, _, Some((slope, offset))) => of_line(knots, pieces, slope, offset),
        (Curve::Polynomial(outer), Curve::Polynomial(inner), _)
            if outer.len().saturating_mul(inner.len()) <= MOST =>
        {
            Curve::Polynomial(substituted(outer, inner))
        }
        _ => Curve::Chain(links(inner).chain(links(outer)).cloned().collect()),
    }
}

/// The curves of a chain, or the only one.
pub(super) fn links(curve: &Curve) -> std::slice::Iter<'_, Curve> {
    match curve {
        Curve::Chain(curves) => curves.iter(),
        one => std::slice::from_ref(one).iter(),
    }
}

/// A curve plus `offset`.
fn raised(curve: Curve, offset: f64) -> Curve {
    match curve {
        Curve::Cubics { knots, mut pieces } => {
            lift(&mut pieces, offset);
            Curve::Cubics { knots, pieces }
        }
        Curve::Quintics { knots, mut pieces } => {
            lift(&mut pieces, offset);
            Curve::Quintics { knots, pieces }
        }
        Curve::Polynomial(mut coefficients) => {
            coefficients.resize(coefficients.len().max(1), 0.0);
            coefficients[0] += offset;
            Curve::Polynomial(coefficients)
        }
        other if offset == 0.0 => other,
        other => Curve::Chain(links(&other).cloned().chain([Curve::linear(1.0, offset)]).collect()),
    }
}

fn lift<const N: usize>(pieces: &mut [[f64; N]], by: f64) {
    for piece in pieces {
        piece[0] += by;
    }
}

/// Cubic pieces over `slope·u + offset`.
fn of_line(knots: &[f64], pieces: &[[f64; 4]], slope: f64, offset: f64) -> Curve {
    let mut over: Vec<f64> = knots.iter().map(|knot| (knot - offset) / slope).collect();
    let stretched = |[a, b, c, d]: [f64; 4]| [a, b * slope, c * slope * slope, d * slope * slope * slope];
    if slope > 0.0 {
        return Curve::Cubics { knots: over, pieces: pieces.iter().map(|piece| stretched(*piece)).collect() };
    }
    over.reverse();
    // Each piece now begins where it ended.
    let turned = |(piece, pair): (&[f64; 4], &[f64])| {
        let ([a, b, c, d], h) = (*piece, pair[1] - pair[0]);
        stretched([a + h * (b + h * (c + h * d)), b + h * (2.0 * c + 3.0 * h * d), c + 3.0 * h * d, d])
    };
    let pieces = pieces.iter().zip(knots.windows(2)).rev().map(turned).collect();
    Curve::Cubics { knots: over, pieces }
}

fn substituted(outer: &[f64], inner: &[f64]) -> Vec<f64> {
    outer.iter().rev().fold(Vec::new(), |sum: Vec<f64>, c| {
        let mut next = vec![0.0; (sum.len() + inner.len()).saturating_sub(1).max(1)];
        for (i, a) in sum.iter().enumerate() {
            for (j, b) in inner.iter().enumerate() {
                next[i + j] += a * b;
            }
        }
        next[0] += c;
        next
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn composed_curves_are_the_one_of_the_other() {
        let bend = Curve::Cubics {
            knots: vec![-1.0, 0.0, 2.0],
            pieces: vec![[0.5, -0.2, 0.3, 0.4], [1.0, 1.6, 1.5, -0.2]],
        };
        let (square, up, down) =
            (Curve::Polynomial(vec![1.0, 0.5, 2.0]), Curve::linear(0.7, 0.2), Curve::linear(-1.5, 0.3));
        let wave = Curve::Sine { amplitude: 0.7, frequency: 1.3, phase: 0.2, offset: 0.1 };
        let pairs = [
            (&bend, &up),
            (&bend, &down),
            (&down, &bend),
            (&square, &square),
            (&square, &down),
            (&bend, &square),
            (&square, &bend),
            (&up, &wave),
            (&wave, &down),
        ];
        for (outer, inner) in pairs {
            let both = compose(outer, inner);
            for x in [-3.0, -1.1, -0.4, 0.05, 0.9, 2.5] {
                let [i, di, ddi] = inner.at(x);
                let [o, d, dd] = outer.at(i);
                let expected = [o, d * di, dd * di * di + d * ddi];
                for k in 0..3 {
                    assert_relative_eq!(both.at(x)[k], expected[k], epsilon = 1e-12, max_relative = 1e-12);
                }
            }
        }
        assert_eq!(compose(&bend, &Curve::linear(0.0, 0.0)), Curve::Polynomial(vec![1.0]));
        // Chains grow at their ends.
        let long = compose(&square, &compose(&bend, &compose(&wave, &square)));
        assert_eq!(links(&long).len(), 4);
        assert_relative_eq!(
            long.at(0.3)[0],
            square.at(bend.at(wave.at(square.at(0.3)[0])[0])[0])[0],
            max_relative = 1e-15
        );
        for curve in [&bend, &square, &up] {
            let beside = beside_identity(curve).expect("of the same kind");
            for x in [-2.0, -0.3, 1.1, 4.0] {
                let ([y, first, second], found) = (curve.at(x), beside.at(x));
                assert_relative_eq!(found[0], y - x, epsilon = 1e-14);
                assert_relative_eq!(found[1], first - 1.0, epsilon = 1e-14);
                assert_relative_eq!(found[2], second, epsilon = 1e-14);
            }
        }
    }
}
