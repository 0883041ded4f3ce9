//! Functions of one coordinate: what ties one degree of freedom to another.

/// A function of one coordinate with two derivatives, such as the slide of a knee's centre over its angle.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Curve {
    /// `c₀ + c₁·x + c₂·x² + …`; no coefficients are zero everywhere.
    Polynomial(Vec<f64>),
    /// Cubic pieces, straight on beyond the first and the last knot.
    Cubics {
        /// Where the pieces meet, rising; one more than there are pieces.
        knots: Vec<f64>,
        /// Of each piece `c₀ + c₁·t + c₂·t² + c₃·t³`, with `t` from the piece's first knot on.
        pieces: Vec<[f64; 4]>,
    },
    /// Pieces of degree five, parabolas on beyond the first and the last knot.
    Quintics {
        /// Where the pieces meet, rising; one more than there are pieces.
        knots: Vec<f64>,
        /// Of each piece `c₀ + c₁·t + … + c₅·t⁵`, with `t` from the piece's first knot on.
        pieces: Vec<[f64; 6]>,
    },
    /// `offset + amplitude·sin(frequency·x + phase)`.
    Sine {
        /// Half of what it swings.
        amplitude: f64,
        /// Radians of the wave per unit of `x`.
        frequency: f64,
        /// Of the wave at `x = 0` (rad).
        phase: f64,
        /// The middle.
        offset: f64,
    },
    /// One after the other, each of the value of the one before; none of them is a chain itself.
    Chain(Vec<Curve>),
}

impl Curve {
    /// `offset + slope·x`.
    pub fn linear(slope: f64, offset: f64) -> Self {
        Self::Polynomial(vec![offset, slope])
    }

    /// The value at `x` and its first and second derivative.
    ///
    /// ```
    /// use solaris_model::Curve;
    /// assert_eq!(Curve::Polynomial(vec![1.0, 0.0, 3.0]).at(2.0), [13.0, 12.0, 6.0]);
    /// ```
    pub fn at(&self, x: f64) -> [f64; 3] {
        match self {
            Self::Polynomial(coefficients) => horner(coefficients, x),
            Self::Cubics { knots, pieces } => in_pieces(knots, pieces, x, 1),
            Self::Quintics { knots, pieces } => in_pieces(knots, pieces, x, 2),
            Self::Sine { amplitude, frequency, phase, offset } => {
                let (sin, cos) = (frequency * x + phase).sin_cos();
                let [swing, rate] = [amplitude * sin, amplitude * frequency * cos];
                [offset + swing, rate, -frequency * frequency * swing]
            }
            // y = f(u):  y′ = f′·u′      y″ = f″·u′² + f′·u″
            Self::Chain(curves) => curves.iter().fold([x, 1.0, 0.0], |[u, du, ddu], curve| {
                let [value, first, second] = curve.at(u);
                [value, first * du, second * du * du + first * ddu]
            }),
        }
    }

    /// The same function times `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Polynomial(coefficients) => {
                Self::Polynomial(coefficients.iter().map(|c| c * factor).collect())
            }
            Self::Cubics { knots, pieces } => {
                let pieces = pieces.iter().map(|piece| piece.map(|c| c * factor)).collect();
                Self::Cubics { knots: knots.clone(), pieces }
            }
            Self::Quintics { knots, pieces } => {
                let pieces = pieces.iter().map(|piece| piece.map(|c| c * factor)).collect();
                Self::Quintics { knots: knots.clone(), pieces }
            }
            Self::Sine { amplitude, frequency, phase, offset } => Self::Sine {
                amplitude: amplitude * factor,
                frequency: *frequency,
                phase: *phase,
                offset: offset * factor,
            },
            Self::Chain(curves) => match curves.split_last() {
                Some((last, before)) => {
                    Self::Chain(before.iter().cloned().chain([last.scaled(factor)]).collect())
                }
                None => Self::linear(factor, 0.0),
            },
        }
    }

    /// The same function of `x/factor`: what it is when its coordinate is measured `factor` times as long.
    pub(crate) fn stretch(&mut self, factor: f64) {
        match self {
            Self::Polynomial(coefficients) => shrink(coefficients, factor),
            Self::Cubics { knots, pieces } => stretch_pieces(knots, pieces, factor),
            Self::Quintics { knots, pieces } => stretch_pieces(knots, pieces, factor),
            Self::Sine { frequency, .. } => *frequency /= factor,
            Self::Chain(curves) => match curves.first_mut() {
                Some(first) => first.stretch(factor),
                None => *self = Self::linear(factor.recip(), 0.0),
            },
        }
    }

    /// What is wrong with it, if anything is.
    pub(crate) fn fault(&self) -> Option<String> {
        if let Self::Chain(curves) = self {
            if curves.iter().any(|curve| matches!(curve, Self::Chain(_))) {
                return Some("a chain stands in a chain; write one".to_owned());
            }
            return curves.iter().find_map(Self::fault);
        }
        if let Some(bad) = self.numbers().into_iter().find(|number| !number.is_finite()) {
            return Some(format!("{bad} is no finite number"));
        }
        let (knots, pieces) = match self {
            Self::Cubics { knots, pieces } => (knots, pieces.len()),
            Self::Quintics { knots, pieces } => (knots, pieces.len()),
            _ => return None,
        };
        if pieces == 0 || knots.len() != pieces + 1 {
            return Some(format!("{} knots for {pieces} pieces; there must be one more knot", knots.len()));
        }
        let pair = knots.windows(2).find(|pair| pair[0] >= pair[1])?;
        Some(format!("knot {} does not rise above {}", pair[1], pair[0]))
    }

    /// Its numbers, for the fingerprint, with a mark of the kind before them; the oldest two kinds have none.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Polynomial(coefficients) => coefficients.clone(),
            Self::Cubics { knots, pieces } => knots.iter().chain(pieces.iter().flatten()).copied().collect(),
            Self::Quintics { knots, pieces } => {
                [5.0].iter().chain(knots).chain(pieces.iter().flatten()).copied().collect()
            }
            Self::Sine { amplitude, frequency, phase, offset } => {
                vec![1.0, *amplitude, *frequency, *phase, *offset]
            }
            Self::Chain(curves) => {
                let counted = |curve: &Self| {
                    let numbers = curve.numbers();
                    [numbers.len() as f64].into_iter().chain(numbers)
                };
                curves.iter().flat_map(counted).collect()
            }
        }
    }
}

/// The piece at `x`, or beyond the knots what its end is like up to the derivative `beyond` (1 or 2).
fn in_pieces<const N: usize>(knots: &[f64], pieces: &[[f64; N]], x: f64, beyond: usize) -> [f64; 3] {
    let last = pieces.len() - 1;
    if x < knots[0] {
        return on_from(horner(&pieces[0], 0.0), x - knots[0], beyond);
    }
    if x > knots[last + 1] {
        let end = horner(&pieces[last], knots[last + 1] - knots[last]);
        return on_from(end, x - knots[last + 1], beyond);
    }
    let piece = knots.partition_point(|knot| *knot <= x).clamp(1, last + 1) - 1;
    horner(&pieces[piece], x - knots[piece])
}

/// The polynomial's value and two derivatives.
fn horner(coefficients: &[f64], x: f64) -> [f64; 3] {
    let [mut value, mut first, mut second] = [0.0; 3];
    for c in coefficients.iter().rev() {
        second = second * x + 2.0 * first;
        first = first * x + value;
        value = value * x + c;
    }
    [value, first, second]
}

/// On from a value with its slope, and its second derivative where `degree` is 2.
fn on_from([value, slope, second]: [f64; 3], by: f64, degree: usize) -> [f64; 3] {
    if degree < 2 {
        return [value + slope * by, slope, 0.0];
    }
    [value + by * (slope + 0.5 * second * by), slope + second * by, second]
}

/// Knots and pieces of a curve, of `x/factor`.
fn stretch_pieces<const N: usize>(knots: &mut [f64], pieces: &mut [[f64; N]], factor: f64) {
    for knot in knots {
        *knot *= factor;
    }
    for piece in pieces {
        shrink(piece, factor);
    }
}

/// Makes `Σ cₖ·xᵏ` what it is of `x/factor`.
fn shrink(coefficients: &mut [f64], factor: f64) {
    let mut power = 1.0;
    for c in coefficients {
        *c /= power;
        power *= factor;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn bend() -> Curve {
        // Two pieces that meet in value, slope and curvature.
        Curve::Cubics {
            knots: vec![-1.0, 0.0, 2.0],
            pieces: vec![[0.5, -0.2, 0.3, 0.4], [1.0, 1.6, 1.5, -0.2]],
        }
    }

    fn wave() -> Curve {
        Curve::Sine { amplitude: 1.5, frequency: 0.8, phase: 0.3, offset: -0.2 }
    }

    fn quintics() -> Curve {
        Curve::Quintics { knots: vec![-0.5, 1.0], pieces: vec![[0.2, 0.4, -0.3, 0.1, 0.2, -0.1]] }
    }

    #[test]
    fn derivatives_are_those_of_the_value() {
        let h = 1e-5;
        let polynomial = Curve::Polynomial(vec![0.3, -1.0, 0.5, 2.0, 0.1]);
        let chain = Curve::Chain(vec![wave(), bend(), quintics()]);
        for curve in [bend(), polynomial, bend().scaled(-3.0), wave(), quintics(), chain] {
            for x in [-3.0, -0.7, 0.4, 1.9, 2.7] {
                let [before, at, after] = [x - h, x, x + h].map(|x| curve.at(x));
                assert_relative_eq!(
                    at[1],
                    (after[0] - before[0]) / (2.0 * h),
                    max_relative = 1e-7,
                    epsilon = 1e-7
                );
                assert_relative_eq!(
                    at[2],
                    (after[1] - before[1]) / (2.0 * h),
                    max_relative = 1e-7,
                    epsilon = 1e-7
                );
            }
        }
    }

    #[test]
    fn beyond_the_knots_it_goes_straight_on() {
        let at_end = bend().at(2.0);
        let beyond = bend().at(5.0);
        assert_relative_eq!(beyond[0], at_end[0] + 3.0 * at_end[1], max_relative = 1e-15);
        assert_eq!(bend().at(-3.0).map(f64::to_bits), [0.5 + 0.2 * 2.0, -0.2, 0.0].map(f64::to_bits));
    }

    /// By hand: (2x + 1)³ at 1 is 27, its derivatives 3·9·2 = 54 and 6·3·4 = 72.
    #[test]
    fn a_chain_is_one_after_the_other() {
        let cube = Curve::Polynomial(vec![0.0, 0.0, 0.0, 1.0]);
        let chain = Curve::Chain(vec![Curve::linear(2.0, 1.0), cube]);
        let found = |curve: &Curve| curve.at(1.0).map(|x| x as i64);
        assert_eq!(found(&chain), [27, 54, 72]);
        assert_eq!(found(&chain.scaled(2.0)), [54, 108, 144]);
        assert_eq!(found(&Curve::Chain(Vec::new()).scaled(3.0)), [3, 3, 0]);
        assert!(Curve::Chain(vec![chain]).fault().is_some_and(|why| why.contains("chain")));
        assert!(Curve::Chain(vec![Curve::linear(f64::NAN, 0.0)]).fault().is_some());
    }

    #[test]
    fn a_stretched_curve_is_the_same_over_a_longer_coordinate() {
        let chain = Curve::Chain(vec![bend(), wave()]);
        for curve in [bend(), quintics(), wave(), Curve::Polynomial(vec![0.3, -1.0, 0.5]), chain] {
            let mut long = curve.clone();
            long.stretch(3.0);
            for x in [-1.4, 0.3, 2.2] {
                let ([y, first, second], found) = (curve.at(x), long.at(3.0 * x));
                for (found, expected) in found.into_iter().zip([y, first / 3.0, second / 9.0]) {
                    assert_relative_eq!(found, expected, max_relative = 1e-12, epsilon = 1e-13);
                }
            }
        }
    }
}
