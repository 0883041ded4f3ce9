//! Times of either form, measured in blocks that take turns.

use super::family::{Family, Stable};
use super::printed::{Number, Printed};
use super::reference::{Parameters, Reference};
use crate::timing::{self, Operation};
use solaris_profiles::Elementary;
use std::convert::Infallible;
use std::hint::black_box;

/// Length of a timed block (ms), and number of blocks of which the fastest counts.
const BLOCK: f64 = 2.0;
const BLOCKS: usize = 40;

/// Times over the span at which a curve is asked, one after the other.
const TIMES: usize = 64;

/// Times (ns) in f64 and f32.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Speed {
    /// Of the printed and the library's form: one evaluation.
    pub(super) evaluation: [[f64; 2]; 2],
    /// The same: working out its constants.
    pub(super) construction: [[f64; 2]; 2],
}

/// Times the case of a family that has this name in the reference.
pub(super) fn measure<K: Family>(reference: &Reference, name: &str) -> Result<Speed, String> {
    let (double, single) = (one::<K, f64>(reference, name, 64)?, one::<K, f32>(reference, name, 32)?);
    let column = |operation: usize| [double[operation], single[operation]];
    Ok(Speed { evaluation: [column(0), column(1)], construction: [column(2), column(3)] })
}

/// Both forms of a curve, with times of either kind.
struct Pair<K: Family, F: Number + Elementary> {
    given: Parameters<F>,
    printed: K::Printed<F>,
    stable: K::Stable<F>,
    times: Vec<F>,
    stable_times: Vec<<K::Stable<F> as Stable<F>>::Time>,
}

impl<K: Family, F: Number + Elementary> Pair<K, F> {
    const OPERATIONS: [(&'static str, Operation<Self, Infallible>); 4] = [
        ("printed", |pair, _| {
            for t in black_box(&pair.times) {
                black_box(pair.printed.at(*t));
            }
            Ok(())
        }),
        ("stable", |pair, _| {
            for t in black_box(&pair.stable_times) {
                black_box(pair.stable.at(*t));
            }
            Ok(())
        }),
        ("printed constants", |pair, _| {
            for _ in 0..TIMES {
                black_box(K::printed(black_box(&pair.given)));
            }
            Ok(())
        }),
        ("stable constants", |pair, _| {
            for _ in 0..TIMES {
                let _ = black_box(K::stable(black_box(&pair.given)));
            }
            Ok(())
        }),
    ];
}

fn one<K: Family, F: Number + Elementary>(
    reference: &Reference,
    name: &str,
    width: u32,
) -> Result<[f64; 4], String> {
    let truth = reference
        .get(name, K::PROFILES[1], width)
        .ok_or_else(|| format!("the reference has no case '{name}' of {width} bits"))?;
    let given = truth.parameters;
    let length = if given.duration > 0.0 { given.duration } else { given.end - given.start };
    let times: Vec<f64> =
        (0..TIMES).map(|i| given.start + length * (i as f64 + 0.5) / TIMES as f64).collect();
    let given = given.map(F::from_f64);
    let mut pair = Pair::<K, F> {
        printed: K::printed(&given),
        stable: K::stable(&given).map_err(|error| format!("'{name}': {error}"))?,
        times: times.iter().map(|t| F::from_f64(*t)).collect(),
        stable_times: times.iter().map(|t| <K::Stable<F> as Stable<F>>::time(*t)).collect(),
        given,
    };
    let times = timing::run(&mut pair, &Pair::<K, F>::OPERATIONS, 1, BLOCK, BLOCKS);
    let Ok(times) = times;
    Ok(std::array::from_fn(|operation| times[operation].least / TIMES as f64))
}
