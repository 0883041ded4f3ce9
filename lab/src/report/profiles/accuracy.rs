//! Right digits of a position, in either form and either precision.

use super::family::{Family, Stable};
use super::printed::{Number, Printed};
use super::reference::{Reference, Truth};
use solaris_profiles::Elementary;

/// The worst error over the times of a case, in f64 and f32: infinite where a form gives no number, [`EXACT`] where it is
/// right to the last digit, nothing where the parameters of the case have no such numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Accuracy {
    pub(super) printed: [Option<f64>; 2],
    pub(super) stable: [Option<f64>; 2],
}

/// What an exact answer counts as.
const EXACT: f64 = 1e-20;

/// Measures the case of a family that has this name in the reference.
pub(super) fn measure<K: Family>(reference: &Reference, name: &str) -> Result<Accuracy, String> {
    let (double, single) = (one::<K, f64>(reference, name, 64)?, one::<K, f32>(reference, name, 32)?);
    let columns = [double, single]
        .map(|errors| errors.map_or([None; 2], |errors| errors.map(|error| Some(error.max(EXACT)))));
    if double.is_none() && single.is_none() {
        return Err(format!("the reference has no case '{name}'"));
    }
    Ok(Accuracy { printed: columns.map(|column| column[0]), stable: columns.map(|column| column[1]) })
}

/// Errors of the printed and the library's form.
fn one<K: Family, F: Number + Elementary>(
    reference: &Reference,
    name: &str,
    width: u32,
) -> Result<Option<[f64; 2]>, String> {
    let [for_printed, for_stable] = K::PROFILES.map(|profile| reference.get(name, profile, width));
    let Some(for_stable) = for_stable else { return Ok(None) };
    let given = |truth: &Truth| truth.parameters.map(F::from_f64);
    let printed = K::printed(&given(for_printed.unwrap_or(for_stable)));
    let found = |t: f64| Elementary::value(printed.at(F::from_f64(t))[0]);
    let printed = match for_printed {
        Some(truth) => truth.error(found),
        // The profile has no such curve, and the form must not pretend one.
        None if for_stable.times.iter().any(|t| found(*t).is_finite()) => {
            return Err(format!("'{name}': an answer, and nothing to compare it with"));
        }
        None => f64::INFINITY,
    };
    let stable = K::stable(&given(for_stable)).map_err(|error| format!("'{name}': {error}"))?;
    let time = <K::Stable<F> as Stable<F>>::time;
    Ok(Some([printed, for_stable.error(|t| Elementary::value(stable.at(time(t))[0]))]))
}
