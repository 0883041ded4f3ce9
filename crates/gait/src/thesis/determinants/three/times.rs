//! The durations of the phases.

use crate::thesis::determinants::{Cycle, DoubleSupport};

/// How the first and the last phase of a walk are timed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Division {
    /// Like those between: what the text of §7.5 suggests for uniformity.
    #[default]
    Uniform,
    /// Half as long: what table 7.5 prints.
    Halved,
}

/// The parts of a step's time that phases 1 and 2 last (table 7.5).
///
/// ```text
/// phase 1: t_ds        phase 2: t_swing = t − t_ds
/// ```
///
/// [`Division::Halved`] halves phase 1 of the starting and phase 2 of the finishing cycle. Step frequency in steps/min; one
/// that is no positive number has no times: NaN.
pub fn parts_of_step(
    cycle: Cycle,
    double_support: DoubleSupport,
    division: Division,
    step_frequency: f64,
) -> [f64; 2] {
    if !(step_frequency > 0.0 && step_frequency.is_finite()) {
        return [f64::NAN; 2];
    }
    let support = double_support.part_of_step(step_frequency);
    let parts = [support, 1.0 - support];
    match (division, cycle) {
        (Division::Halved, Cycle::Starting) => [0.5 * parts[0], parts[1]],
        (Division::Halved, Cycle::Finishing) => [parts[0], 0.5 * parts[1]],
        _ => parts,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn phases_last_a_step_but_for_the_halved_ones() {
        let law = DoubleSupport::Thesis;
        for cycle in [Cycle::Starting, Cycle::Intermediate, Cycle::Finishing] {
            let [first, second] = parts_of_step(cycle, law, Division::Uniform, 110.0);
            assert_relative_eq!(first, 0.2296, epsilon = 1e-12);
            assert_relative_eq!(first + second, 1.0, epsilon = 1e-12);
        }
        let [first, _] = parts_of_step(Cycle::Starting, law, Division::Halved, 110.0);
        let [_, last] = parts_of_step(Cycle::Finishing, law, Division::Halved, 110.0);
        assert_relative_eq!(first, 0.1148, epsilon = 1e-12);
        assert_relative_eq!(last, 0.3852, epsilon = 1e-12);
    }
}
