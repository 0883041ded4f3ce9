//! Walks of all speeds, lengths and sizes.

use crate::cases::{Case, assert_all_walk, person, steps};

fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for height in [1.2, 1.5, 1.75, 2.0] {
        // Slower ones of somebody of 1.2 m are refused.
        let slowest = if height < 1.45 { 64.0 } else { 60.0 };
        for frequency in [slowest, 80.0, 95.0, 110.0, 118.0, 130.0] {
            for n in [10, 3, 2, 1] {
                let name = format!("{height} m, {frequency}/min, {n} steps");
                cases.push(Case { name, figure: person(height), request: steps(frequency, n) });
            }
        }
    }
    cases
}

/// Every seventh: each height, each frequency and each number of steps comes up.
#[test]
fn walks_of_some_speeds_lengths_and_sizes_obey_the_laws() {
    let cases: Vec<Case> = cases().into_iter().step_by(7).collect();
    assert_all_walk("some speeds, lengths and sizes", &cases);
}

#[test]
#[ignore = "the whole grid, half a minute: cargo xtask nightly"]
fn walks_of_all_speeds_lengths_and_sizes_obey_the_laws() {
    assert_all_walk("all speeds, lengths and sizes", &cases());
}
