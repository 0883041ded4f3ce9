//! Masses whose sum is a given number, to the last bit.

/// The sum in the order of the links, as [`crate::Figure::mass`] has it.
fn total(masses: &[f64]) -> f64 {
    masses.iter().sum()
}

/// Changes masses by what rounding leaves until they add up to `wanted`; whether they do.
///
/// Nearly always the heaviest one alone is changed. Where no number in its place gives the sum (a sum half way between two
/// numbers is rounded to an even one), the lightest ones help by their last bits.
pub(crate) fn exact_total(masses: &mut [f64], wanted: f64) -> bool {
    let mut heaviest_first: Vec<usize> = (0..masses.len()).filter(|&i| masses[i] > 0.0).collect();
    heaviest_first.sort_by(|&i, &j| masses[j].total_cmp(&masses[i]));
    let Some((&heaviest, others)) = heaviest_first.split_first() else { return false };
    if solve(masses, heaviest, wanted) {
        return true;
    }
    for &other in others.iter().rev().cycle().take(8 * others.len().min(8)) {
        masses[other] = masses[other].next_up();
        if solve(masses, heaviest, wanted) {
            return true;
        }
    }
    false
}

/// Finds the number in place `at` that makes the sum `wanted`. The sum never falls as the number rises, so that halving an
/// interval finds it wherever there is one.
fn solve(masses: &mut [f64], at: usize, wanted: f64) -> bool {
    let start = masses[at];
    let mut sum = |mass: f64| {
        masses[at] = mass;
        total(masses)
    };
    let mut error = wanted - sum(start);
    if error.abs() == 0.0 {
        return true;
    }
    let (mut low, mut high) = (start, start);
    while error.signum() * (wanted - sum(if error > 0.0 { high } else { low })) > 0.0 {
        if error > 0.0 {
            high += error;
        } else {
            low = (low + error).max(f64::MIN_POSITIVE);
        }
        error *= 2.0;
        if !error.is_finite() {
            return false;
        }
    }
    loop {
        let middle = low + (high - low) / 2.0;
        let found = sum(middle);
        if (wanted - found).abs() == 0.0 {
            return true;
        }
        let (ends_low, ends_high) = (middle <= low, middle >= high);
        if found < wanted {
            low = middle;
        } else {
            high = middle;
        }
        if ends_low || ends_high {
            // The two ends are neighbours; the other end may be the one.
            return [low, high].into_iter().any(|end| (wanted - sum(end)).abs() == 0.0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_half_way_between_two_numbers_are_reached_too() {
        // 1 + ε/2 is half way, and 1 + 3ε/2 as well: both round to even ones, and the first number moves by ε at least.
        let half = f64::EPSILON / 2.0;
        for wanted in [1.5, 1.5 + f64::EPSILON, 1.5 + 2.0 * f64::EPSILON] {
            let mut masses = vec![1.5, half];
            assert!(exact_total(&mut masses, wanted), "{wanted:e}");
            assert_eq!(total(&masses).to_bits(), wanted.to_bits());
        }
    }

    #[test]
    fn masses_of_nothing_have_no_sum() {
        assert!(!exact_total(&mut [], 1.0));
        assert!(!exact_total(&mut [0.0], 1.0));
        let mut one = [2.0, 0.0];
        assert!(exact_total(&mut one, 3.0));
        assert_eq!(one.map(f64::to_bits), [3.0_f64, 0.0].map(f64::to_bits));
    }
}
