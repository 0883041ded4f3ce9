//! The same numbers, bit for bit, however often and on however many threads.

use crate::cases::{RATE, person, steps, walked};
use rayon::ThreadPoolBuilder;
use solaris::model::{Figure, Motion};

/// All numbers of a motion.
fn bits(motion: &Motion) -> Vec<u64> {
    let mut numbers = motion.time().to_vec();
    for i in 0..motion.len() {
        let tau = motion.tau(i).expect("forces of the joints");
        for row in [motion.q(i), motion.v(i), motion.a(i), tau] {
            numbers.extend_from_slice(row);
        }
        for contact in motion.contacts.iter().map(|track| &track.samples[i]) {
            for vector in [contact.force, contact.moment, contact.cop] {
                numbers.extend(vector.iter());
            }
        }
    }
    numbers.extend(motion.events.iter().map(|event| event.time));
    numbers.extend(motion.planted.iter().flat_map(|interval| [interval.start, interval.end]));
    numbers.into_iter().map(f64::to_bits).collect()
}

fn on_threads(figure: &Figure, threads: usize) -> Vec<u64> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool of threads");
    pool.install(|| bits(&walked(figure, &steps(105.0, 3), RATE).1))
}

#[test]
fn threads_and_repetition_change_no_bit() {
    let figure = person(1.68);
    let once = on_threads(&figure, 1);
    assert!(once.len() > 100_000);
    for threads in [1, 4, 4, 3] {
        assert!(on_threads(&figure, threads) == once, "{threads} threads give other numbers");
    }
    // One bit would be seen: a neighbouring step frequency gives other numbers.
    let other = bits(&walked(&figure, &steps(f64::from_bits(105.0_f64.to_bits() + 1), 3), RATE).1);
    assert!(other != once);
}
