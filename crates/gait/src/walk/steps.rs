//! Step lengths of a walk of n steps, and the number of steps to a distance.

use super::numbers::STEP_FACTORS;

/// Lengths of `n` steps (m): `S` in the middle; the first is shorter, and two shorter ones brake at the end.
pub(crate) fn lengths(n: usize, step_length: f64) -> Vec<f64> {
    let (first, before, last) = STEP_FACTORS;
    let mut factors = vec![1.0; n];
    if n > 1 {
        factors[0] = first;
    }
    if let Some(factor) = factors.last_mut() {
        *factor = last;
    }
    if n > 1 {
        factors[n - 2] = before.min(factors[n - 2]);
    }
    factors.iter().map(|factor| factor * step_length).collect()
}

/// Sum of the factors of `n` steps.
fn total(n: usize) -> f64 {
    let (first, before, last) = STEP_FACTORS;
    match n {
        1 => last,
        2 => first.min(before) + last,
        _ => first + (n - 3) as f64 + before + last,
    }
}

/// Number of steps for a distance, and their length S, so that the distance is met exactly: as few steps as need no
/// length above 1.02 of the default one.
pub(crate) fn for_distance(distance: f64, default: f64) -> (usize, f64) {
    // Solved for n > 2, then corrected: the factors of the ends are constants.
    let guess = (distance / (1.02 * default) - total(3)).ceil() + 3.0;
    let mut n = if guess > 3.0 { guess as usize } else { 1 };
    while distance > 1.02 * default * total(n) {
        n += 1;
    }
    (n, distance / total(n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_is_met_exactly_by_the_fewest_steps() {
        for distance in [0.1, 0.5, 0.9, 1.1, 2.0, 5.0, 123.4] {
            let (n, step) = for_distance(distance, 0.7);
            let sum: f64 = lengths(n, step).iter().sum();
            assert!((sum - distance).abs() < 1e-12 * distance.max(1.0));
            assert!(step <= 1.02 * 0.7 + 1e-12);
            assert!(n == 1 || distance > 1.02 * 0.7 * total(n - 1), "{distance} m in {n} steps");
        }
    }
}
