//! Cursors, which evaluate a spline at times near to one another without a search.

use super::cubic::CubicSpline;
use super::piece::Piece;
use crate::Elementary;
use crate::sample::Sample;

/// A cursor, which remembers the piece of a spline in which the last time was: the next time in it, or in the piece after it, needs no
/// search.
///
/// The answers are those of [`Curve::at_time`](crate::Curve::at_time), to the bit.
///
/// ```
/// use solaris_profiles::{Curve, spline::CubicSpline};
///
/// let curve = CubicSpline::natural(&[(0.0, 0.0), (1.0, 2.0), (3.0, 1.0)])?;
/// let mut cursor = curve.cursor();
/// for frame in 0..90 {
///     let t = f64::from(frame) / 30.0;
///     assert_eq!(cursor.at_time(t), curve.at_time(t));
/// }
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Cursor<'a, F = f64> {
    spline: &'a CubicSpline<F>,
    index: usize,
    piece: &'a Piece<F>,
    /// Where the piece begins and ends.
    span: [f64; 2],
}

impl<F: Elementary> CubicSpline<F> {
    /// For times that mostly lie near to the one before.
    pub fn cursor(&self) -> Cursor<'_, F> {
        let times = self.knots.times();
        Cursor { spline: self, index: 0, piece: &self.pieces[0], span: [times[0], times[1]] }
    }
}

impl<F: Elementary> Cursor<'_, F> {
    /// Position, velocity, acceleration and jerk at `t`, a time since the curve's beginning; outside of the span at the
    /// nearer end, NaN at NaN.
    #[inline]
    pub fn at_time(&mut self, t: f64) -> Sample<F> {
        if !(self.span[0] <= t && t < self.span[1]) {
            if !self.spline.knots.span(t) {
                return self.spline.outside(t);
            }
            self.move_to(t);
        }
        self.piece.at(t - self.span[0], self.span[1] - t, F::from_f64(0.0))
    }

    /// To the piece of a time within the span.
    fn move_to(&mut self, t: f64) {
        let knots = &self.spline.knots;
        let times = knots.times();
        self.index = match times.get(self.index + 1..self.index + 3) {
            Some(&[from, to]) if from <= t && t < to => self.index + 1,
            _ => knots.piece(t),
        };
        self.piece = &self.spline.pieces[self.index];
        self.span = [times[self.index], times[self.index + 1]];
    }
}
