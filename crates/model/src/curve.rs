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
            Self::Cubics { knots, pieces } => {
                let last = pieces.len() - 1;
                if x < knots[0] {
                    return straight(horner(&pieces[0], 0.0), x - knots[0]);
                }
                if x > knots[last + 1] {
                    return straight(
                        horner(&pieces[last], knots[last + 1] - knots[last]),
                        x - knots[last + 1],
                    );
                }
                let piece = knots.partition_point(|knot| *knot <= x).clamp(1, last + 1) - 1;
                horner(&pieces[piece], x - knots[piece])
            }
        }
    }

    /// The same function times `factor`.
    pub fn scaled(&self, factor: f64) -> Self {
        match self {
            Self::Polynomial(coefficients) => {
                Self::Polynomial(coefficients.iter().map(|c| c * factor).collect())
            }
            Self::Cubics { knots, pieces } => Self::Cubics {
                knots: knots.clone(),
                pieces: pieces.iter().map(|p| p.map(|c| c * factor)).collect(),
            },
        }
    }

    /// What is wrong with it, if anything is.
    pub(crate) fn fault(&self) -> Option<String> {
        let (numbers, pieces): (Vec<f64>, &[[f64; 4]]) = match self {
            Self::Polynomial(coefficients) => (coefficients.clone(), &[]),
            Self::Cubics { knots, pieces } => (knots.clone(), pieces),
        };
        if let Some(bad) = numbers.iter().chain(pieces.iter().flatten()).find(|number| !number.is_finite()) {
            return Some(format!("{bad} is no finite number"));
        }
        let Self::Cubics { knots, pieces } = self else { return None };
        if pieces.is_empty() || knots.len() != pieces.len() + 1 {
            return Some(format!(
                "{} knots for {} pieces; there must be one more knot",
                knots.len(),
                pieces.len()
            ));
        }
        let pair = knots.windows(2).find(|pair| pair[0] >= pair[1])?;
        Some(format!("knot {} does not rise above {}", pair[1], pair[0]))
    }

    /// Its numbers, for the fingerprint.
    pub(crate) fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Polynomial(coefficients) => coefficients.clone(),
            Self::Cubics { knots, pieces } => knots.iter().chain(pieces.iter().flatten()).copied().collect(),
        }
    }
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

/// Straight on from a value and a slope.
fn straight([value, slope, _]: [f64; 3], by: f64) -> [f64; 3] {
    [value + slope * by, slope, 0.0]
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

    #[test]
    fn derivatives_are_those_of_the_value() {
        let h = 1e-5;
        for curve in [bend(), Curve::Polynomial(vec![0.3, -1.0, 0.5, 2.0, 0.1]), bend().scaled(-3.0)] {
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
}
