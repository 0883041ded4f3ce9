//! Curves made of polynomial pieces.

use crate::clip::Outside;
use crate::error::{ProfileError, check_finite};
use crate::float::rem_euclid;
use crate::polynomial::Polynomial;
use crate::sample::{Boundary, Sample};
use alloc::{vec, vec::Vec};

/// Polynomials joined at rising knots.
#[doc(alias = "spline")]
#[doc(alias = "piecewise polynomial")]
#[doc(alias = "ppoly")]
#[derive(Clone, Debug, PartialEq)]
pub struct Piecewise {
    knots: Vec<f64>,
    pieces: Vec<Polynomial>,
    outside: Outside,
}

impl Piecewise {
    /// The C⁴ curve of quintic pieces through `values` (one for each **inner** knot), with position, velocity and
    /// acceleration given at both ends.
    ///
    /// The unknowns are velocity and acceleration at the inner knots; that jerk and snap go through each of them without
    /// a jump makes a block-tridiagonal system of 2×2 blocks.
    ///
    /// # Errors
    ///
    /// Fewer than two knots, knots that do not rise, a wrong number of values, numbers that are not finite.
    ///
    /// ```
    /// use solaris_profiles::{Boundary, Piecewise};
    /// let (start, end) = (Boundary::rest(0.0), Boundary::rest(1.0));
    /// let curve = Piecewise::quintic_spline(&[0.0, 0.4, 1.0], &[0.9], start, end)?;
    /// assert!((curve.at(0.4).position - 0.9).abs() < 1e-15);
    /// assert!((curve.at(0.4 - 1e-9).jerk - curve.at(0.4).jerk).abs() < 1e-4);
    /// # Ok::<(), solaris_profiles::ProfileError>(())
    /// ```
    pub fn quintic_spline(
        knots: &[f64],
        values: &[f64],
        start: Boundary,
        end: Boundary,
    ) -> Result<Self, ProfileError> {
        check_knots(knots)?;
        let inner = knots.len() - 2;
        if values.len() != inner {
            return Err(ProfileError::Count {
                what: "values at inner knots",
                found: values.len(),
                needed: inner,
            });
        }
        check_finite("value", values)?;
        check_finite("start", &start.numbers())?;
        check_finite("end", &end.numbers())?;
        let mut jets = vec![start];
        jets.extend(values.iter().map(|&x| Boundary::rest(x)));
        jets.push(end);
        solve_inner_jets(knots, &mut jets);
        Self::through(knots, &jets)
    }

    /// The C² curve of quintic pieces with these positions, velocities and accelerations at its knots, one for each.
    ///
    /// # Errors
    ///
    /// As for [`Piecewise::quintic_spline`].
    ///
    /// ```
    /// use solaris_profiles::{Boundary, Piecewise};
    /// let jets = [Boundary::rest(0.0), Boundary::new(0.5, 1.0, 0.0), Boundary::rest(0.4)];
    /// let curve = Piecewise::quintic_hermite(&[0.0, 0.4, 1.0], &jets)?;
    /// assert!((curve.at(0.4).velocity - 1.0).abs() < 1e-15);
    /// # Ok::<(), solaris_profiles::ProfileError>(())
    /// ```
    #[doc(alias = "cspline")]
    pub fn quintic_hermite(knots: &[f64], jets: &[Boundary]) -> Result<Self, ProfileError> {
        check_knots(knots)?;
        if jets.len() != knots.len() {
            return Err(ProfileError::Count { what: "jets", found: jets.len(), needed: knots.len() });
        }
        jets.iter().try_for_each(|jet| check_finite("jet", &jet.numbers()))?;
        Self::through(knots, jets)
    }

    fn through(knots: &[f64], jets: &[Boundary]) -> Result<Self, ProfileError> {
        let pieces = knots
            .windows(2)
            .zip(jets.windows(2))
            .map(|(knots, jets)| Polynomial::quintic(knots[1] - knots[0], &jets[0], &jets[1]))
            .collect();
        Self::new(knots, pieces)
    }

    fn new(knots: &[f64], pieces: Vec<Polynomial>) -> Result<Self, ProfileError> {
        // Spans too short for their values overflow.
        pieces.iter().try_for_each(|piece| check_finite("coefficient", &piece.0))?;
        Ok(Self { knots: knots.to_vec(), pieces, outside: Outside::Hold })
    }

    /// Says what the curve does outside of its span.
    pub fn outside(mut self, outside: Outside) -> Self {
        self.outside = outside;
        self
    }

    /// First and last knot.
    pub fn span(&self) -> (f64, f64) {
        (self.knots[0], self.knots[self.knots.len() - 1])
    }

    /// The piece that answers at `t`, and where in it.
    #[inline]
    fn locate(&self, t: f64) -> (&Polynomial, f64) {
        let (first, last) = self.span();
        let inside = match self.outside {
            Outside::Repeat => first + rem_euclid(t - first, last - first),
            Outside::Hold => t.clamp(first, last),
            Outside::Extrapolate => t,
            Outside::Mirror => {
                let (span, rest) = (last - first, rem_euclid(t - first, 2.0 * (last - first)));
                first + if rest > span { 2.0 * span - rest } else { rest }
            }
        };
        let piece = self.knots[1..self.pieces.len()].partition_point(|&knot| knot <= inside);
        (&self.pieces[piece], inside - self.knots[piece])
    }

    /// The position at `t`. At a knot the piece that begins there answers.
    pub fn position(&self, t: f64) -> f64 {
        let (piece, inside) = self.locate(t);
        piece.position(inside)
    }

    /// The curve at `t`. At a knot the piece that begins there answers.
    pub fn at(&self, t: f64) -> Sample {
        let (piece, inside) = self.locate(t);
        let (sample, (first, last)) = (piece.at(inside), self.span());
        if self.outside == Outside::Hold && (t < first || t > last) {
            return Sample { position: sample.position, ..Sample::default() };
        }
        sample
    }
}

fn check_knots(knots: &[f64]) -> Result<(), ProfileError> {
    check_finite("knot", knots)?;
    if knots.len() < 2 {
        return Err(ProfileError::Count { what: "knots", found: knots.len(), needed: 2 });
    }
    match (1..knots.len()).find(|&i| knots[i] <= knots[i - 1]) {
        Some(index) => Err(ProfileError::Knots { index, time: knots[index], before: knots[index - 1] }),
        None => Ok(()),
    }
}

type Block = [[f64; 2]; 2];

/// Fills in velocity and acceleration of the inner jets: block Thomas elimination.
///
/// Jerk and snap of a quintic piece of length h at its ends, with Δ = x₁ − x₀:
///
/// ```text
/// j₀ =  60Δ/h³ − 36v₀/h² − 24v₁/h² − 9a₀/h + 3a₁/h      s₀ = −360Δ/h⁴ + 192v₀/h³ + 168v₁/h³ + 36a₀/h² − 24a₁/h²
/// j₁ =  60Δ/h³ − 24v₀/h² − 36v₁/h² − 3a₀/h + 9a₁/h      s₁ =  360Δ/h⁴ − 168v₀/h³ − 192v₁/h³ − 24a₀/h² + 36a₁/h²
/// ```
fn solve_inner_jets(knots: &[f64], jets: &mut [Boundary]) {
    let inner = jets.len() - 2;
    let mut factors: Vec<(Block, [f64; 2])> = Vec::with_capacity(inner);
    for i in 1..=inner {
        let (h, k) = (knots[i] - knots[i - 1], knots[i + 1] - knots[i]);
        let (left, right) =
            (jets[i].position - jets[i - 1].position, jets[i + 1].position - jets[i].position);
        // j₁ of the left piece minus j₀ of the right one, and the same for the snap: lower·u₋ + diagonal·u + upper·u₊.
        let lower = [[-24.0 / (h * h), -3.0 / h], [-168.0 / (h * h * h), -24.0 / (h * h)]];
        let mut diagonal = [
            [-36.0 / (h * h) + 36.0 / (k * k), 9.0 / h + 9.0 / k],
            [-192.0 / (h * h * h) - 192.0 / (k * k * k), 36.0 / (h * h) - 36.0 / (k * k)],
        ];
        let upper = [[24.0 / (k * k), -3.0 / k], [-168.0 / (k * k * k), 24.0 / (k * k)]];
        let mut rhs = [
            60.0 * (right / (k * k * k) - left / (h * h * h)),
            -360.0 * (right / (k * k * k * k) + left / (h * h * h * h)),
        ];
        let known = |jet: &Boundary| [jet.velocity, jet.acceleration];
        match factors.last() {
            None => subtract(&mut rhs, &lower, known(&jets[i - 1])),
            Some((above, value)) => {
                subtract(&mut rhs, &lower, *value);
                for (row, l) in diagonal.iter_mut().zip(&lower) {
                    for (c, entry) in row.iter_mut().enumerate() {
                        *entry -= l[0] * above[0][c] + l[1] * above[1][c];
                    }
                }
            }
        }
        if i == inner {
            subtract(&mut rhs, &upper, known(&jets[i + 1]));
        }
        let column = |c: usize| solve2(&diagonal, [upper[0][c], upper[1][c]]);
        let (c0, c1) = (column(0), column(1));
        factors.push(([[c0[0], c1[0]], [c0[1], c1[1]]], solve2(&diagonal, rhs)));
    }
    for i in (1..=inner).rev() {
        let (above, mut u) = factors[i - 1];
        if i < inner {
            subtract(&mut u, &above, [jets[i + 1].velocity, jets[i + 1].acceleration]);
        }
        [jets[i].velocity, jets[i].acceleration] = u;
    }
}

fn subtract(target: &mut [f64; 2], block: &Block, u: [f64; 2]) {
    for (t, row) in target.iter_mut().zip(block) {
        *t -= row[0] * u[0] + row[1] * u[1];
    }
}

/// Solves a 2×2 system by Cramer's rule, its rows scaled first (they differ by the knots' distance).
fn solve2(m: &Block, rhs: [f64; 2]) -> [f64; 2] {
    let scale = |row: &[f64; 2]| 1.0 / row[0].abs().max(row[1].abs());
    let (s0, s1) = (scale(&m[0]), scale(&m[1]));
    let (a, b, c, d) = (m[0][0] * s0, m[0][1] * s0, m[1][0] * s1, m[1][1] * s1);
    let (e, f) = (rhs[0] * s0, rhs[1] * s1);
    let determinant = a * d - b * c;
    [(e * d - b * f) / determinant, (a * f - e * c) / determinant]
}
