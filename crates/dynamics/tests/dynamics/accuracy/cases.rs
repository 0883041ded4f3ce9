//! The cases that are measured, with what other programs lose in them.

use super::samples::{
    Random, Sample, chain, distant_chain, fast_chain, near_lock, person, person_near_lock, tipped_chain,
    uneven_chain,
};

/// Errors in f64 and f32.
pub(super) type Errors = [f64; 2];

/// A kind of figure and state.
pub(super) struct Case {
    pub(super) name: &'static str,
    pub(super) sample: fn(&mut Random) -> Result<Sample, String>,
    pub(super) inverse: Option<OtherInverse>,
    pub(super) forward: Option<OtherForward>,
}

/// What other programs lose in inverse dynamics.
#[derive(Clone, Copy)]
pub(super) struct OtherInverse {
    pub(super) lagrangian: Errors,
    /// Newton and Euler's equations in the links' own frames.
    pub(super) local: Errors,
    /// The same with spatial vectors about the world's origin.
    pub(super) world: Errors,
}

/// What other programs lose in forward dynamics.
#[derive(Clone, Copy)]
pub(super) struct OtherForward {
    /// By articulated bodies, in O(n).
    pub(super) articulated: Errors,
    /// By a factorisation of the mass matrix; infinite where that fails.
    pub(super) matrix: Errors,
}

const fn inverse(lagrangian: Errors, local: Errors, world: Errors) -> OtherInverse {
    OtherInverse { lagrangian, local, world }
}

const fn forward(articulated: Errors, matrix: Errors) -> OtherForward {
    OtherForward { articulated, matrix }
}

/// Figures in ordinary states: those that are also timed.
#[rustfmt::skip]
pub(super) const ORDINARY: [Case; 4] = [
    Case { name: "human, 66", sample: person, inverse: None, forward: Some(forward([3e-16, 1e-7], [1e-14, 6e-6])) },
    Case {
        name: "chain of 10",
        sample: |random| chain(random, 10),
        inverse: Some(inverse([2.5e-16, 1.4e-7], [5.6e-16, 2.0e-7], [5.5e-16, 3.3e-7])),
        forward: Some(forward([2e-16, 1.3e-7], [3e-14, 1.3e-5])),
    },
    Case {
        name: "chain of 100",
        sample: |random| chain(random, 100),
        inverse: Some(inverse([8.8e-16, 4.2e-7], [5.6e-16, 4.6e-7], [1.7e-15, 7.3e-7])),
        forward: Some(forward([9e-14, 2.2e-5], [1.8e-10, 1.6e-2])),
    },
    Case {
        name: "chain of 1000",
        sample: |random| chain(random, 1000),
        inverse: Some(inverse([1.9e-15, 1.6e-6], [4.3e-15, 2.2e-6], [2.3e-15, 1.8e-6])),
        forward: None,
    },
];

/// Of what is published for ratios of masses as a range, the upper end.
const RATIOS: OtherInverse = inverse([4.5e-16, 2.6e-7], [5e-16, 2.8e-7], [7.5e-16, 4.0e-7]);

/// Figures and states that break careless recursions.
#[rustfmt::skip]
pub(super) const HARD: [Case; 10] = [
    Case {
        name: "chain of 30",
        sample: |random| chain(random, 30),
        inverse: None,
        forward: Some(forward([3e-15, 1.3e-6], [1.5e-12, 1.4e-3])),
    },
    Case {
        name: "10, tip 2²⁰ times as heavy",
        sample: |random| tipped_chain(random, 10, 2.0_f64.powi(20)),
        inverse: Some(RATIOS),
        forward: Some(forward([6e-12, 7e-3], [4e-9, f64::INFINITY])),
    },
    Case {
        name: "10, tip 2²⁰ times as light",
        sample: |random| tipped_chain(random, 10, 2.0_f64.powi(-20)),
        inverse: Some(RATIOS),
        forward: Some(forward([5e-17, 2.3e-8], [4e-17, 1.8e-8])),
    },
    Case {
        name: "20, masses of 1e-6 to 1e6 kg",
        sample: |random| uneven_chain(random, 20),
        inverse: Some(RATIOS),
        forward: None,
    },
    Case {
        name: "20, speeds to 1000 rad/s",
        sample: |random| fast_chain(random, 20),
        inverse: Some(inverse([5.1e-16, 2.4e-7], [3.8e-16, 2.7e-7], [8.1e-16, 4.7e-7])),
        forward: None,
    },
    Case {
        name: "20, root 100 km away",
        sample: |random| distant_chain(random, 20, 1e5),
        inverse: Some(inverse([3.7e-16, 2.4e-7], [3.8e-16, 2.0e-7], [3.1e-7, 160.0])),
        forward: None,
    },
    Case {
        name: "Z-Y-X joint, 1e-2 rad from lock",
        sample: |random| near_lock(random, 1e-2),
        inverse: None,
        forward: Some(forward([5e-15, 6e-6], [1e-11, 2e-3])),
    },
    Case {
        name: "Z-Y-X joint, 1e-4 rad from lock",
        sample: |random| near_lock(random, 1e-4),
        inverse: None,
        forward: Some(forward([1e-12, 3e-4], [7e-8, 2.3])),
    },
    Case {
        name: "human, shoulder 1e-2 rad from lock",
        sample: |random| person_near_lock(random, 1e-2),
        inverse: None,
        forward: Some(forward([4e-14, 1e-5], [1e-10, 0.09])),
    },
    Case {
        name: "human, shoulder 1e-4 rad from lock",
        sample: |random| person_near_lock(random, 1e-4),
        inverse: None,
        forward: Some(forward([7e-12, 1e-3], [1e-6, 1.4])),
    },
];
