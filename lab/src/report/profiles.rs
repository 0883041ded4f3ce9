//! The thesis's curves as printed beside the library's: the numbers and the picture of docs/profiles-accuracy.md.

mod accuracy;
mod cases;
mod family;
mod page;
mod plot;
mod printed;
mod reference;
mod speed;

use super::page as calls;
use crate::table;
use crate::workspace::{read, write};
use page::Measured;

const PAGE: &str = "docs/profiles-accuracy.md";

/// Measures the curves and writes their page.
pub(super) fn run() -> Result<(), String> {
    let measured = Measured::new(|kind, reference| {
        eprintln!("report: times, {}", kind.name);
        (kind.speed)(reference, kind.ordinary)
    })?;
    let mut text = read(PAGE)?;
    text = table::replace(&text, "when", &calls::circumstances())?;
    for (name, table) in measured.tables() {
        text = table::replace(&text, name, &table.markdown()).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    write(PAGE, &text)?;
    write("docs/profiles-accuracy.svg", &plot::draw(&measured))
}

#[cfg(test)]
mod tests {
    use super::accuracy::Accuracy;
    use super::cases::{CLIPS, Case, HARD, KINDS};
    use super::*;
    use std::sync::LazyLock;

    static MEASURED: LazyLock<Measured> =
        LazyLock::new(|| Measured::new(|_, _| Ok(speed::Speed::default())).expect("every case has a curve"));

    /// The errors that there are of each hard case, with what is claimed of them.
    fn hard(of: impl Fn(&Case, &Accuracy) -> ([f64; 2], [Option<f64>; 2])) -> Vec<(String, f64, f64)> {
        let one = |(case, accuracy): (&Case, &Accuracy)| {
            let (claims, errors) = of(case, accuracy);
            let widths = ["f64", "f32"].into_iter().zip(claims).zip(errors);
            widths
                .filter_map(|((width, claim), error)| {
                    Some((format!("{}, {width}", case.name), claim, error?))
                })
                .collect::<Vec<_>>()
        };
        HARD.iter().zip(&MEASURED.hard).flat_map(one).collect()
    }

    #[test]
    fn the_library_loses_no_more_than_a_few_last_digits() {
        for (name, bound, error) in hard(|case, accuracy| (case.stable, accuracy.stable)) {
            assert!(error <= bound, "{name}: {error:e} of {bound:e}");
        }
    }

    #[test]
    fn the_printed_forms_lose_what_they_are_said_to_lose() {
        for (name, claim, error) in hard(|case, accuracy| (case.printed, accuracy.printed)) {
            assert!(error >= claim / 10.0, "{name}: {error:e} of {claim:e}");
        }
    }

    /// Neither form is handicapped where nothing is hard.
    #[test]
    fn both_forms_are_right_in_ordinary_cases() {
        for (kind, Accuracy { printed, stable }) in KINDS.iter().zip(&MEASURED.ordinary) {
            for (form, errors, factor) in [("printed", printed, 32.0), ("library", stable, 1.0)] {
                let [double, single] = errors.map(|error| error.expect("a case for both precisions"));
                assert!(double <= factor * f64::EPSILON, "{}, {form}: {double:e}", kind.ordinary);
                assert!(single <= factor * f64::from(f32::EPSILON), "{}, {form}: {single:e}", kind.ordinary);
            }
        }
    }

    #[test]
    fn a_clip_in_single_precision_does_not_know_how_late_it_is() {
        for (name, Accuracy { printed, stable }) in CLIPS.iter().zip(&MEASURED.clips) {
            assert!(stable[1].is_some_and(|error| error <= f64::from(f32::EPSILON)), "{name}: {stable:?}");
            let lost = match *name {
                "clip at 10 s" => 1e-5,
                "clip at 1e3 s" => 7e-4,
                "clip at 1e5 s" => 0.095,
                _ => 0.0,
            };
            assert!(printed[1].is_some_and(|error| error >= lost / 10.0), "{name}: {printed:?}");
        }
    }

    #[test]
    fn every_case_of_the_reference_is_measured() {
        let ordinary = KINDS.iter().map(|kind| kind.ordinary);
        let mut measured: Vec<&str> =
            HARD.iter().map(|case| case.name).chain(ordinary).chain(CLIPS).collect();
        let reference = reference::Reference::read().expect("the file");
        let mut known = reference.names();
        measured.sort_unstable();
        known.sort_unstable();
        known.dedup();
        assert_eq!(measured, known);
    }

    #[test]
    fn the_page_says_what_is_measured() {
        let page = read(PAGE).expect("the page");
        for (name, table) in MEASURED.tables() {
            let differences = table.differences(table::block(&page, name).expect("a table"));
            assert!(
                differences.is_empty(),
                "{PAGE}, {name}: `cargo lab report profiles` is due:\n{}",
                differences.join("\n")
            );
        }
    }
}
