//! Times of operations, measured in blocks that take turns.

use std::time::Instant;

/// Something to do with the state of an index.
pub(crate) type Operation<C, E> = fn(&mut C, usize) -> Result<(), E>;

/// Time of one call (ns), over the rounds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Time {
    pub(crate) median: f64,
    pub(crate) least: f64,
}

/// Times every operation in `rounds` blocks of about `block` ms, cycling through the states 0 to `count − 1`.
///
/// In each round every operation has one block, so that a slow spell of the machine strikes all of them.
pub(crate) fn run<C, E>(
    case: &mut C,
    operations: &[(&str, Operation<C, E>)],
    count: usize,
    block: f64,
    rounds: usize,
) -> Result<Vec<Time>, E> {
    let mut repeats = Vec::with_capacity(operations.len());
    for (_, operation) in operations {
        repeats.push(calibrate(case, *operation, count, block)?);
    }
    let mut times = vec![Vec::with_capacity(rounds); operations.len()];
    for _ in 0..rounds {
        for (((_, operation), repeats), times) in operations.iter().zip(&repeats).zip(&mut times) {
            times.push(time(case, *operation, count, *repeats)? / *repeats as f64);
        }
    }
    Ok(times.into_iter().map(summary).collect())
}

/// How many calls fill a block.
fn calibrate<C, E>(case: &mut C, operation: Operation<C, E>, count: usize, block: f64) -> Result<usize, E> {
    let wanted = block * 1e6;
    let mut repeats = 1;
    loop {
        let taken = time(case, operation, count, repeats)?;
        if taken > wanted / 2.0 || repeats > 1 << 26 {
            return Ok(((repeats as f64 * wanted / taken) as usize).max(1));
        }
        repeats *= 2;
    }
}

/// Time of `repeats` calls together (ns).
fn time<C, E>(case: &mut C, operation: Operation<C, E>, count: usize, repeats: usize) -> Result<f64, E> {
    let start = Instant::now();
    let mut state = 0;
    for _ in 0..repeats {
        operation(case, state)?;
        state += 1;
        if state == count {
            state = 0;
        }
    }
    Ok(start.elapsed().as_secs_f64() * 1e9)
}

fn summary(mut times: Vec<f64>) -> Time {
    times.sort_by(f64::total_cmp);
    Time { median: times[times.len() / 2], least: times[0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;

    #[test]
    fn every_state_has_its_turn() {
        let mut seen = vec![0_usize; 5];
        let visit: Operation<Vec<usize>, Infallible> = |seen, state| {
            seen[state] += 1;
            Ok(())
        };
        time(&mut seen, visit, 5, 12).expect("no operation fails");
        assert_eq!(seen, [3, 3, 2, 2, 2]);
        let times = run(&mut seen, &[("visit", visit), ("again", visit)], 5, 0.01, 3).expect("none fails");
        assert_eq!(times.len(), 2);
        assert!(times.iter().all(|time| 0.0 < time.least && time.least <= time.median));
    }

    #[test]
    fn the_middle_and_the_least_are_kept() {
        assert_eq!(summary(vec![3.0, 1.0, 9.0]), Time { median: 3.0, least: 1.0 });
    }
}
