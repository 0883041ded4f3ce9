//! The natural quintic spline through unequally spaced samples.

use crate::error::{ProfileError, check_finite};
use crate::sample::{Boundary, Sample};
use alloc::{vec, vec::Vec};

/// The C⁴ curve of quintic pieces through samples at any rising times, with third and fourth derivatives that are zero at
/// both ends: of all curves through the samples, the one with the least `∫ (d³x/dt³)² dt`.
///
/// Three samples or more decide it; three make a parabola, two a line, one rests. Inside, its error in a smooth curve
/// falls with the sixth power of the step in position, the fifth in velocity, the fourth in acceleration; towards the
/// ends it is that of a curve without jerk. Beyond its ends it goes on as the parabolas that touch it there, which keeps
/// it C⁴.
///
/// ```
/// use solaris_profiles::NaturalSpline;
///
/// let time = [0.0, 0.1, 0.25, 0.3, 0.5];
/// let thrown = time.map(|t| 2.0 + 3.0 * t - 4.9 * t * t);
/// let curve = NaturalSpline::new(&time, &thrown)?;
/// assert!((curve.at(0.4).velocity - (3.0 - 9.8 * 0.4)).abs() < 1e-12);
/// assert!((curve.nodes()[2].acceleration + 9.8).abs() < 1e-11);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "gcv spline")]
#[doc(alias = "quintic spline")]
#[doc(alias = "spline")]
#[derive(Clone, Debug)]
pub struct NaturalSpline {
    knots: Vec<f64>,
    nodes: Vec<Boundary>,
}

impl NaturalSpline {
    /// Through `values` at the rising times `knots`; takes time and memory in proportion to their number.
    ///
    /// The velocities `v` and accelerations `a` at the knots are the unknowns. With `h` the length of a piece and `d` the
    /// difference of its ends' positions, its third and fourth derivatives are, at its start and at its end,
    ///
    /// ```text
    /// x‴(0) = 60 d/h³ − (36 v₀ + 24 v₁)/h² − (9 a₀ − 3 a₁)/h
    /// x‴(h) = 60 d/h³ − (24 v₀ + 36 v₁)/h² − (3 a₀ − 9 a₁)/h
    /// x⁗(0) = −360 d/h⁴ + (192 v₀ + 168 v₁)/h³ + (36 a₀ − 24 a₁)/h²
    /// x⁗(h) =  360 d/h⁴ − (168 v₀ + 192 v₁)/h³ − (24 a₀ − 36 a₁)/h²
    /// ```
    ///
    /// That both go on over every knot, and vanish at the ends, is a symmetric system of 2×2 blocks in three diagonals.
    /// It is the gradient of `∫ x‴² dt`, hence positive definite, and elimination without exchange of rows is stable.
    ///
    /// # Errors
    ///
    /// No samples, as many values as knots, knots that do not rise, numbers that are not finite.
    pub fn new(knots: &[f64], values: &[f64]) -> Result<Self, ProfileError> {
        if knots.is_empty() {
            return Err(ProfileError::Count { what: "samples", found: 0, needed: 1 });
        }
        if values.len() != knots.len() {
            return Err(ProfileError::Count { what: "values", found: values.len(), needed: knots.len() });
        }
        check_finite("knot", knots)?;
        check_finite("sample", values)?;
        if let Some(index) = (1..knots.len()).find(|&i| knots[i] <= knots[i - 1]) {
            return Err(ProfileError::Knots { index, time: knots[index], before: knots[index - 1] });
        }
        let nodes = match values {
            [value] => vec![Boundary::rest(*value)],
            [first, second] => {
                let slope = (second - first) / (knots[1] - knots[0]);
                values.iter().map(|&x| Boundary::new(x, slope, 0.0)).collect()
            }
            _ => solve(knots, values),
        };
        let numbers = nodes.iter().flat_map(Boundary::numbers);
        match numbers.into_iter().find(|number| !number.is_finite()) {
            Some(value) => Err(ProfileError::NotFinite { what: "a derivative at a knot", value }),
            None => Ok(Self { knots: knots.to_vec(), nodes }),
        }
    }

    /// The times of the samples.
    pub fn knots(&self) -> &[f64] {
        &self.knots
    }

    /// Position, velocity and acceleration at each sample.
    pub fn nodes(&self) -> &[Boundary] {
        &self.nodes
    }

    /// Position and three derivatives at any time; NaN at NaN.
    pub fn at(&self, t: f64) -> Sample {
        if t.is_nan() {
            return Sample::from_array([t; 4]);
        }
        let last = self.knots.len() - 1;
        if t <= self.knots[0] {
            return touching(&self.nodes[0], t - self.knots[0]);
        }
        if t >= self.knots[last] {
            return touching(&self.nodes[last], t - self.knots[last]);
        }
        let piece = self.knots.partition_point(|knot| *knot <= t) - 1;
        let h = self.knots[piece + 1] - self.knots[piece];
        between(&self.nodes[piece], &self.nodes[piece + 1], h, t - self.knots[piece])
    }
}

/// The parabola through a node, `s` later.
fn touching(node: &Boundary, s: f64) -> Sample {
    let Boundary { position: x, velocity: v, acceleration: a } = *node;
    Sample { position: x + s * (v + s * a / 2.0), velocity: v + s * a, acceleration: a, jerk: 0.0 }
}

/// The quintic between two nodes that are `h` apart, `s` after the first.
fn between(start: &Boundary, end: &Boundary, h: f64, s: f64) -> Sample {
    let [[x0, v0, a0], [x1, v1, a1]] = [start.numbers(), end.numbers()];
    // In units of the piece's length, what the parabola of the start misses at the end.
    let miss = (x1 - x0) - h * (v0 + h * a0 / 2.0);
    let [e0, e1, e2] = [miss, (v1 - v0 - h * a0) * h, (a1 - a0) * h * h];
    let c3 = 10.0 * e0 - 4.0 * e1 + 0.5 * e2;
    let c4 = -15.0 * e0 + 7.0 * e1 - e2;
    let c5 = 6.0 * e0 - 3.0 * e1 + 0.5 * e2;
    let u = s / h;
    let cubic = u * u * u * (c3 + u * (c4 + u * c5));
    let slope = u * u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5));
    let bend = u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5));
    let jerk = 6.0 * c3 + u * (24.0 * c4 + u * 60.0 * c5);
    let parabola = touching(start, s);
    Sample {
        position: parabola.position + cubic,
        velocity: parabola.velocity + slope / h,
        acceleration: parabola.acceleration + bend / (h * h),
        jerk: jerk / (h * h * h),
    }
}

type Block = [[f64; 2]; 2];
type Pair = [f64; 2];

/// The nodes through three samples or more.
fn solve(knots: &[f64], values: &[f64]) -> Vec<Boundary> {
    let n = knots.len();
    // Time in units of the mean step, so that no power of a step leaves the range of numbers.
    let unit = (knots[n - 1] - knots[0]) / (n - 1) as f64;
    let pieces: Vec<Piece> =
        (1..n).map(|i| Piece::new((knots[i] - knots[i - 1]) / unit, values[i] - values[i - 1])).collect();
    // Outwards: of each knot, the block that couples it to the next and its right side, both times the diagonal's inverse.
    let mut swept: Vec<(Block, Pair)> = Vec::with_capacity(n);
    for i in 0..n {
        let (mut diagonal, mut right, mut coupling) = ([[0.0; 2]; 2], [0.0; 2], [[0.0; 2]; 2]);
        if i > 0 {
            let piece = &pieces[i - 1];
            let (before, (next, y)) = (transposed(&piece.coupling), swept[i - 1]);
            add(&mut diagonal, &piece.end, 1.0);
            add(&mut diagonal, &product(&before, &next), -1.0);
            let carried = apply(&before, &y);
            right = [piece.right_end[0] - carried[0], piece.right_end[1] - carried[1]];
        }
        if i + 1 < n {
            let piece = &pieces[i];
            add(&mut diagonal, &piece.start, 1.0);
            right = [right[0] + piece.right_start[0], right[1] + piece.right_start[1]];
            coupling = piece.coupling;
        }
        let inverse = inverse(&diagonal);
        swept.push((product(&inverse, &coupling), apply(&inverse, &right)));
    }
    let mut nodes = vec![Boundary::default(); n];
    let mut next = [0.0; 2];
    for i in (0..n).rev() {
        let (coupling, y) = &swept[i];
        let carried = apply(coupling, &next);
        next = [y[0] - carried[0], y[1] - carried[1]];
        nodes[i] = Boundary::new(values[i], next[0] / unit, next[1] / (unit * unit));
    }
    nodes
}

/// What one piece adds to the system, in the unknowns (v, a) of its start and its end.
struct Piece {
    start: Block,
    end: Block,
    /// From the start's rows to the end's unknowns.
    coupling: Block,
    right_start: Pair,
    right_end: Pair,
}

impl Piece {
    /// Of length `h` and rise `d`: rows are the jump of x⁗ and the jump of −x‴, over 12.
    #[rustfmt::skip]
    fn new(h: f64, d: f64) -> Self {
        let (i1, i2, i3) = (1.0 / h, 1.0 / (h * h), 1.0 / (h * h * h));
        Self {
            start:    [[16.0 * i3,  3.0 * i2], [ 3.0 * i2,  0.75 * i1]],
            end:      [[16.0 * i3, -3.0 * i2], [-3.0 * i2,  0.75 * i1]],
            coupling: [[14.0 * i3, -2.0 * i2], [ 2.0 * i2, -0.25 * i1]],
            right_start: [30.0 * d * i3 * i1,  5.0 * d * i3],
            right_end:   [30.0 * d * i3 * i1, -5.0 * d * i3],
        }
    }
}

fn add(sum: &mut Block, other: &Block, factor: f64) {
    for (row, other) in sum.iter_mut().zip(other) {
        for (x, y) in row.iter_mut().zip(other) {
            *x += factor * y;
        }
    }
}

fn transposed([[a, b], [c, d]]: &Block) -> Block {
    [[*a, *c], [*b, *d]]
}

fn product(a: &Block, b: &Block) -> Block {
    [0, 1].map(|i| [0, 1].map(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

fn apply(a: &Block, x: &Pair) -> Pair {
    [0, 1].map(|i| a[i][0] * x[0] + a[i][1] * x[1])
}

/// Of a positive definite block.
fn inverse([[a, b], [_, d]]: &Block) -> Block {
    let determinant = a * d - b * b;
    [[d / determinant, -b / determinant], [-b / determinant, a / determinant]]
}
