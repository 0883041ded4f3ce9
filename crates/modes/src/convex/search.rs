//! The least value of a convex function of one number.

/// Rounds of the search.
const MOST_ROUNDS: usize = 60;

/// How exact the place of the minimum has to be.
const NEAR: f64 = 1e-12;

/// Where, from 0 on, a convex function that falls at 0 is least; `slopes` are its first and second derivatives.
pub(super) fn minimum(slopes: impl Fn(f64) -> (f64, f64)) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    let (mut first, mut second) = slopes(high);
    for _ in 0..MOST_ROUNDS {
        if first >= 0.0 {
            break;
        }
        low = high;
        high *= 2.0;
        (first, second) = slopes(high);
    }
    // Newton's steps, kept within the bracket by halving it.
    let mut alpha = high;
    for _ in 0..MOST_ROUNDS {
        if first == 0.0 || high - low <= NEAR * high {
            break;
        }
        if first > 0.0 {
            high = alpha;
        } else {
            low = alpha;
        }
        let newton = alpha - first / second;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - alpha).abs() <= NEAR * alpha {
            return next;
        }
        alpha = next;
        (first, second) = slopes(alpha);
    }
    alpha
}
