//! How what is planned anew takes over from what went on before, without a jump.

/// Step of the difference formulas (s).
pub(super) const STEP: f64 = 1e-3;

/// Values, rates and second derivatives of `N` numbers by time.
pub(super) type Jets<const N: usize> = [[f64; N]; 3];

/// The jets of `f` at `t`, by central differences of three points.
pub(super) fn jets<const N: usize>(t: f64, f: impl Fn(f64) -> [f64; N]) -> Jets<N> {
    let [before, at, after] = [t - STEP, t, t + STEP].map(f);
    [
        at,
        std::array::from_fn(|i| (after[i] - before[i]) / (2.0 * STEP)),
        std::array::from_fn(|i| (after[i] - 2.0 * at[i] + before[i]) / (STEP * STEP)),
    ]
}

/// The quintic from a jet (value, and derivatives by `s`) at `s` = 0 to rest at zero at 1,
///
/// ```text
/// e(s) = (1 − s)³ [p + (3p + v) s + (6p + 3v + ½a) s²]
/// ```
#[inline]
fn fade(p: f64, v: f64, a: f64, s: f64) -> f64 {
    (1.0 - s).powi(3) * (p + s * (3.0 * p + v + s * (6.0 * p + 3.0 * v + 0.5 * a)))
}

/// The difference of what was and what is to be, as it dies away: `law(t) + e(t)` goes on from any motion with position, velocity and
/// acceleration.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ease<const N: usize> {
    jet: Jets<N>,
    time: f64,
}

impl<const N: usize> Ease<N> {
    /// Nothing to take over.
    pub(super) const NONE: Self = Self { jet: [[0.0; N]; 3], time: 1.0 };

    /// From `was` to `is` within `time` (s).
    pub(super) fn new(was: &Jets<N>, is: &Jets<N>, time: f64) -> Self {
        let scale = [1.0, time, time * time];
        let jet = std::array::from_fn(|k| std::array::from_fn(|i| (was[k][i] - is[k][i]) * scale[k]));
        Self { jet, time }
    }

    /// The same of values and rates alone: what bends otherwise at once does so from the beginning.
    pub(super) fn of_rates(was: &Jets<N>, is: &Jets<N>, time: f64) -> Self {
        Self::new(&[was[0], was[1], [0.0; N]], &[is[0], is[1], [0.0; N]], time)
    }

    /// What is left of one number at the time `t`.
    #[inline]
    pub(super) fn of(&self, i: usize, t: f64) -> f64 {
        let s = t / self.time;
        if s >= 1.0 { 0.0 } else { fade(self.jet[0][i], self.jet[1][i], self.jet[2][i], s) }
    }

    /// What is left at the time `t`.
    #[inline]
    pub(super) fn at(&self, t: f64) -> [f64; N] {
        if t >= self.time { [0.0; N] } else { std::array::from_fn(|i| self.of(i, t)) }
    }
}

/// The quintic from one jet to another.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bridge<const N: usize> {
    start: Jets<N>,
    end: Jets<N>,
    time: f64,
}

impl<const N: usize> Bridge<N> {
    /// Within `time` (s).
    pub(super) fn new(start: &Jets<N>, end: &Jets<N>, time: f64) -> Self {
        let scaled = |jet: &Jets<N>, time: f64| {
            let scale = [1.0, time, time * time];
            std::array::from_fn(|k| jet[k].map(|x| x * scale[k]))
        };
        Self { start: scaled(start, time), end: scaled(end, -time), time }
    }

    /// At the time `t`, beyond its ends too.
    #[inline]
    pub(super) fn at(&self, t: f64) -> [f64; N] {
        let s = t / self.time;
        let of = |jet: &Jets<N>, i: usize, s: f64| fade(jet[0][i], jet[1][i], jet[2][i], s);
        std::array::from_fn(|i| of(&self.start, i, s) + of(&self.end, i, 1.0 - s))
    }
}
