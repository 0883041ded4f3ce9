//! Cubic splines through keys: Hermite, Catmull-Rom, Kochanek-Bartels, monotone, natural, clamped.

use super::keys::{Bend, Chord, Key, chords};
use super::knots::Knots;
use super::piece::Piece;
use super::tangents;
use crate::Elementary;
use crate::clip::Clip;
use crate::curve::Curve;
use crate::error::{ProfileError, check_finite};
use crate::sample::Sample;
use alloc::vec::Vec;

/// The curve of cubic pieces through keys at any rising times, each given as its time and its position.
///
/// The curve begins at the first key: [`at`](Curve::at) takes the time since then, and [`into_clip`](Self::into_clip)
/// puts it back to the keys' own times. At a key the curve has the key's position and velocity to the last digit, on both
/// sides. Where the velocity jumps there, [`at`](Curve::at) answers with that after the key and [`before`](Curve::before)
/// with that before it. Beyond its ends the curve goes on as its tangent.
///
/// Times are in double precision whatever the positions are in, and [`at_time`](Curve::at_time) rounds only what is left
/// of a time after the nearest key, so that a curve in `f32` is as good after an hour as at its start. A [`Cursor`](super::Cursor)
/// remembers the piece from one time to the next.
///
/// A spline that comes back after a rest between equal keys turns round at the beginning of the rest, in
/// [`Answers::stationary`](crate::Answers::stationary).
///
/// # Errors
///
/// Of all constructors: fewer than two keys, times that do not rise, numbers that are not finite, and keys so near to
/// each other in time that a derivative between them leaves the range of numbers.
///
/// # Examples
///
/// ```
/// use solaris_profiles::{Answers, Curve, spline::CubicSpline};
///
/// let keys = [(10.0, 0.0), (11.0, 1.0), (12.0, 1.0), (14.0, 3.0)];
/// let curve = CubicSpline::monotone(&keys)?;
/// assert_eq!(curve.at(1.5).position, 1.0); // between the equal keys
/// assert_eq!(curve.stationary().rests, [(1.0, 2.0)]);
/// assert_eq!(curve.into_clip().at(14.0).position, 3.0);
/// # Ok::<(), solaris_profiles::ProfileError>(())
/// ```
#[doc(alias = "spline")]
#[doc(alias = "interpolation")]
#[doc(alias = "keyframes")]
#[derive(Clone, Debug, PartialEq)]
pub struct CubicSpline<F = f64> {
    start: f64,
    pub(super) knots: Knots,
    pub(super) pieces: Vec<Piece<F>>,
}

impl<F: Elementary> CubicSpline<F> {
    /// The spline with the velocities that the keys name.
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors).
    #[doc(alias = "hermite spline")]
    pub fn hermite(keys: &[Key<F>]) -> Result<Self, ProfileError> {
        let (start, knots) = Knots::new(keys.iter().map(|key| key.time))?;
        for key in keys {
            check_finite("key", &[key.position])?;
            check_finite("velocity at a key", &[key.velocity_in, key.velocity_out])?;
        }
        let leaves = |i: usize| (keys[i].position, keys[i].velocity_out);
        let arrives = |i: usize| (keys[i].position, keys[i].velocity_in);
        Self::new(start, knots, leaves, arrives)
    }

    /// The velocity at a key is the mean velocity from the key before it to the key after it (Catmull and Rom, carried
    /// over to keys at unequal times); at an end, that which makes the outermost piece a parabola, or the chord where
    /// there are only two.
    ///
    /// ```text
    /// vᵢ = (xᵢ₊₁ − xᵢ₋₁)/(tᵢ₊₁ − tᵢ₋₁)        v₀ = 2 m₀ − v₁ = m₀ + h₁ (m₀ − m₁)/(h₀ + h₁)
    /// ```
    ///
    /// h: durations of the pieces, m: mean velocities. Through equally spaced keys of a parabola it is that parabola,
    /// which is why the ends are taken so; a neighbour that is short beside the outermost piece counts for as little as it does at the
    /// key between.
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors).
    #[doc(alias = "catmull-rom")]
    #[doc(alias = "cardinal spline")]
    pub fn catmull_rom(keys: &[(f64, F)]) -> Result<Self, ProfileError> {
        Self::smooth(keys, tangents::catmull_rom)
    }

    /// The velocity at a key is the mean of the mean velocities on both sides, each weighted with the root of the other
    /// side's way; at an end it is the chord's.
    ///
    /// ```text
    /// vᵢ = (τ₊ m₋ + τ₋ m₊)/(τ₋ + τ₊)        τ = √|Δx|
    /// ```
    ///
    /// Beside a hold (two equal keys) the velocity is zero, between pieces of equal duration and direction it is the
    /// geometric mean. An end along the chord does not swing out when the next way is much steeper, as a parabola would.
    ///
    /// The weights are those of the centripetal parameter of a curve in space (Yuksel, Schaefer and Keyser,
    /// *Parameterization and applications of Catmull-Rom curves*, Computer-Aided Design 43 (2011) 747–755). There the
    /// parameter is free; here time is given, so that only the weights are carried over. They do not depend on any unit.
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors).
    #[doc(alias = "catmull-rom")]
    pub fn centripetal(keys: &[(f64, F)]) -> Result<Self, ProfileError> {
        Self::smooth(keys, tangents::centripetal)
    }

    /// The curve that rises, falls and rests only where the keys do: it never turns between two of them.
    ///
    /// ```text
    /// vᵢ = 3(h₋ + h₊)/((2h₊ + h₋)/m₋ + (h₊ + 2h₋)/m₊)    where m₋ and m₊ have the same sign, else 0
    /// ```
    ///
    /// h: durations of the pieces, m: mean velocities before and after the key. At an end it is the velocity of the
    /// parabola through the three nearest keys, unless the curve would turn with it: then 0, or three times the mean one.
    ///
    /// # Source
    ///
    /// Fritsch and Butland, *A method for constructing local monotone piecewise cubic interpolants*, SIAM Journal on
    /// Scientific and Statistical Computing 5 (1984) 300–304.
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors).
    #[doc(alias = "pchip")]
    #[doc(alias = "Fritsch-Carlson")]
    #[doc(alias = "Akima")]
    pub fn monotone(keys: &[(f64, F)]) -> Result<Self, ProfileError> {
        Self::smooth(keys, tangents::monotone)
    }

    /// The spline bent at all keys by tension T, continuity C and bias B, with the velocities `start` and `end` at its ends.
    ///
    /// ```text
    /// in:  (1−T)[(1−C)(1+B) Δ₋ + (1+C)(1−B) Δ₊]/(tᵢ₊₁ − tᵢ₋₁)        Δ: way to the key, way from it
    /// out: (1−T)[(1+C)(1+B) Δ₋ + (1−C)(1−B) Δ₊]/(tᵢ₊₁ − tᵢ₋₁)
    /// ```
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), §5.7, after Kochanek and Bartels, *Interpolating splines with local tension, continuity,
    /// and bias control*, SIGGRAPH 1984. The thesis counts keys; here they have times, and both tangents are divided by
    /// the mean duration of the two pieces, so that the velocity is continuous with C = 0 between pieces of unequal
    /// duration too. With C ≠ 0 it always jumps (E28), and the acceleration jumps at every key with any T, C and B. The
    /// loops of a curve with T > 1 (E29) are turns in time here.
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors); also a bend or a velocity that is not finite.
    #[doc(alias = "tcb")]
    #[doc(alias = "tcb spline")]
    pub fn kochanek_bartels(
        keys: &[(f64, F)],
        bend: Bend<F>,
        (start, end): (F, F),
    ) -> Result<Self, ProfileError> {
        let (first, knots) = Knots::new(keys.iter().map(|key| key.0))?;
        let chords = chords(keys, knots.times())?;
        check_finite("tension", &[bend.tension])?;
        check_finite("continuity", &[bend.continuity])?;
        check_finite("bias", &[bend.bias])?;
        check_finite("start velocity", &[start])?;
        check_finite("end velocity", &[end])?;
        let bent = |i: usize| tangents::bent(&chords[i - 1], &chords[i], bend);
        let leaves = |i: usize| (keys[i].1, if i == 0 { start } else { bent(i)[1] });
        let arrives = |i: usize| (keys[i].1, if i == chords.len() { end } else { bent(i)[0] });
        Self::new(first, knots, leaves, arrives)
    }

    /// The curve whose acceleration does not jump and is zero at both ends: of all curves through the keys, the one with
    /// the least ∫ a² dt.
    ///
    /// ```text
    /// h₊ vᵢ₋₁ + 2(h₋ + h₊) vᵢ + h₋ vᵢ₊₁ = 3(h₊ m₋ + h₋ m₊)        2v₀ + v₁ = 3m₀
    /// ```
    ///
    /// The system is tridiagonal and its diagonal dominates, so that elimination in order is stable. Every key moves the
    /// whole curve, by a quarter as much from one key to the next.
    ///
    /// # Source
    ///
    /// Vasilonikolidakis (1991), §2.3.2, asks for it; the system is tridiagonal, not triangular (E34).
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors).
    #[doc(alias = "natural spline")]
    pub fn natural(keys: &[(f64, F)]) -> Result<Self, ProfileError> {
        Self::smooth(keys, |chords| tangents::continuous(chords, None))
    }

    /// The curve whose acceleration does not jump, with the velocities `start` and `end` at its ends; inside as
    /// [`natural`](Self::natural).
    ///
    /// # Errors
    ///
    /// [As all constructors](Self#errors); also a velocity that is not finite.
    #[doc(alias = "clamped spline")]
    pub fn clamped(keys: &[(f64, F)], start: F, end: F) -> Result<Self, ProfileError> {
        check_finite("start velocity", &[start])?;
        check_finite("end velocity", &[end])?;
        Self::smooth(keys, |chords| tangents::continuous(chords, Some((start, end))))
    }

    /// The time of the first key, where the curve begins.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The curve at the times of its keys: a clip that begins with the first of them.
    pub fn into_clip(self) -> Clip<Self, F> {
        let start = self.start;
        Clip::at_start(self, start)
    }

    /// The keys, with the velocities that the curve has there; their times to rounding.
    pub fn keys(&self) -> impl ExactSizeIterator<Item = Key<F>> {
        let last = self.pieces.len();
        self.knots.times().iter().enumerate().map(move |(i, time)| {
            let after = self.pieces[i.min(last - 1)].ends[usize::from(i == last)];
            let before = if i == 0 { after } else { self.pieces[i - 1].ends[1] };
            Key {
                time: self.start + time,
                position: after.position,
                velocity_in: before.velocity,
                velocity_out: after.velocity,
            }
        })
    }

    fn smooth(
        keys: &[(f64, F)],
        velocities: impl FnOnce(&[Chord<F>]) -> Vec<F>,
    ) -> Result<Self, ProfileError> {
        let (start, knots) = Knots::new(keys.iter().map(|key| key.0))?;
        let velocities = velocities(&chords(keys, knots.times())?);
        let end = |i: usize| (keys[i].1, velocities[i]);
        Self::new(start, knots, end, end)
    }

    /// Of the position and the velocity with which each key is left, and those with which it is come to.
    fn new(
        start: f64,
        knots: Knots,
        leaves: impl Fn(usize) -> (F, F),
        arrives: impl Fn(usize) -> (F, F),
    ) -> Result<Self, ProfileError> {
        let durations = knots.times().windows(2).map(|pair| F::from_f64(pair[1] - pair[0])).enumerate();
        let pieces = durations.map(|(i, duration)| Piece::new(duration, leaves(i), arrives(i + 1)));
        let pieces = pieces.collect::<Result<_, _>>()?;
        Ok(Self { start, knots, pieces })
    }

    /// A piece at a time of its span; `with` has the value 0 and the derivatives of the time.
    #[inline]
    pub(super) fn piece_at(&self, piece: usize, t: f64, with: F) -> Sample<F> {
        let times = self.knots.times();
        self.pieces[piece].at(t - times[piece], times[piece + 1] - t, with)
    }

    /// The answer outside of the span: the nearer end, or NaN.
    #[cold]
    pub(super) fn outside(&self, t: f64) -> Sample<F> {
        let zero = F::from_f64(0.0);
        if t < 0.0 {
            self.piece_at(0, 0.0, zero)
        } else if t > self.knots.end() {
            self.piece_at(self.knots.pieces() - 1, self.knots.end(), zero)
        } else {
            Sample::from_array([F::from_f64(f64::NAN); 4])
        }
    }
}

impl<F: Elementary> Curve<F> for CubicSpline<F> {
    fn duration(&self) -> F {
        F::from_f64(self.knots.end())
    }

    fn span(&self) -> f64 {
        self.knots.end()
    }

    #[inline]
    fn at(&self, t: F) -> Sample<F> {
        let value = t.value();
        if self.knots.span(value) {
            self.piece_at(self.knots.piece(value), value, t - F::from_f64(value))
        } else {
            self.outside(value)
        }
    }

    #[inline]
    fn at_time(&self, t: f64) -> Sample<F> {
        if self.knots.span(t) {
            self.piece_at(self.knots.piece(t), t, F::from_f64(0.0))
        } else {
            self.outside(t)
        }
    }

    fn before(&self, t: F) -> Sample<F> {
        let value = t.value();
        if self.knots.span(value) {
            self.piece_at(self.knots.piece_before(value), value, t - F::from_f64(value))
        } else {
            self.outside(value)
        }
    }
}
