//! Right digits and times: the numbers and the picture of docs/accuracy.md.
//!
//! Errors are the same on every run; a test holds the page to them. Times are what they were on the day that the page
//! names.

mod moments;
pub(crate) mod page;
mod plot;
mod profiles;
mod published;
mod simulation;
mod speed;

// What is measured stands with the kernel's tests, which hold it to what other programs lose.
#[path = "../../crates/dynamics/tests/dynamics/accuracy/cases.rs"]
mod cases;
#[path = "../../crates/dynamics/tests/dynamics/accuracy/measured.rs"]
mod measured;
#[path = "../../crates/dynamics/tests/dynamics/accuracy/samples.rs"]
mod samples;

use crate::docs;
use crate::table;
use crate::workspace::{read, write};
use cases::{Case, HARD, ORDINARY};
use measured::Accuracy;
use page::{LONG, Measured};
use samples::{Random, chain};
use speed::Speed;

/// Measures everything and writes the pages.
pub(crate) fn run() -> Result<(), String> {
    moments()?;
    docs::run(docs::Options::default())?;
    profiles::run()?;
    simulation::run()?;
    published::run()?;
    let measured = measure(|case| {
        eprintln!("report: times, {}", case.name);
        speeds(case, speed::measure)
    })?;
    let when = page::circumstances();
    let pages = [
        (
            "docs/accuracy.md",
            vec![
                ("when", when.clone()),
                ("calls", measured.calls().markdown()),
                ("inverse dynamics", measured.inverse().markdown()),
                ("forward dynamics", measured.forward().markdown()),
                ("growth", measured.growth().markdown()),
            ],
        ),
        ("docs/operations.md", vec![("when", when), ("times", measured.times().markdown())]),
    ];
    for (path, tables) in pages {
        let mut text = read(path)?;
        for (name, table) in tables {
            text = table::replace(&text, name, &table).map_err(|error| format!("{path}: {error}"))?;
        }
        write(path, &text)?;
    }
    write("docs/accuracy.svg", &plot::draw(&measured))
}

/// Writes the moments of a measured walk beside OpenSim's, where the data are at hand.
pub(crate) fn moments() -> Result<(), String> {
    let Some(curves) = moments::measure()? else { return Ok(()) };
    let text = read("docs/bodies.md")?;
    let text = table::replace(&text, "moments", &moments::table(&curves).markdown())
        .map_err(|error| format!("docs/bodies.md: {error}"))?;
    write("docs/bodies.md", &text)?;
    write("docs/moments.svg", &moments::draw(&curves))
}

/// Measures the thesis's curves and writes their page.
pub(crate) fn profiles() -> Result<(), String> {
    profiles::run()
}

/// Measures simulations where more or less is known of the answer, and writes their page.
pub(crate) fn simulation() -> Result<(), String> {
    simulation::run()
}

/// The part of that page which needs the methods that choose their steps; built with the feature `stiff`.
pub(crate) fn adaptive() -> Result<(), String> {
    simulation::adaptive()
}

/// What a tolerance of the run costs beside the cheapest setting.
pub(crate) fn chosen() -> Result<(), String> {
    simulation::chosen()
}

/// Problems whose answers others have published.
pub(crate) fn published() -> Result<(), String> {
    published::run()
}

/// Simulations beside MuJoCo's, where it is at hand.
pub(crate) fn stepping() -> Result<(), String> {
    simulation::stepping()
}

/// The accuracy of every case, with the speeds that `speed` finds.
fn measure(speed: impl Fn(&Case) -> Result<Speed, String>) -> Result<Measured, String> {
    let accuracies = |cases: &[Case]| -> Result<Vec<Accuracy>, String> {
        let measure = |case: &Case| {
            eprintln!("report: errors, {}", case.name);
            measured::measure(case)
        };
        cases.iter().map(measure).collect()
    };
    let long =
        Case { name: "chain of 300", sample: |random| chain(random, LONG), inverse: None, forward: None };
    Ok(Measured {
        ordinary: accuracies(&ORDINARY)?,
        hard: accuracies(&HARD)?,
        speeds: ORDINARY.iter().map(&speed).collect::<Result<_, _>>()?,
        long: speed(&long)?,
    })
}

/// What `find` says of one sample of a case.
fn speeds<E: ToString>(
    case: &Case,
    find: impl Fn(&samples::Sample) -> Result<Speed, E>,
) -> Result<Speed, String> {
    let sample = (case.sample)(&mut Random::new(1))?;
    find(&sample).map_err(|error| format!("{}: {}", case.name, error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pages_say_what_is_measured() {
        let count =
            |sample: &_| speed::count(sample).map(|operations| Speed { operations, ..Speed::default() });
        let measured = measure(|case| speeds(case, count)).expect("every case has an answer");
        let pages = [
            ("docs/accuracy.md", "calls", measured.calls()),
            ("docs/accuracy.md", "inverse dynamics", measured.inverse()),
            ("docs/accuracy.md", "forward dynamics", measured.forward()),
            ("docs/accuracy.md", "growth", measured.growth()),
            ("docs/operations.md", "times", measured.times()),
        ];
        for (path, name, table) in pages {
            let page = read(path).expect("a page");
            let differences = table.differences(table::block(&page, name).expect("a table"));
            assert!(
                differences.is_empty(),
                "{path}, {name}: `cargo lab report` is due:\n{}",
                differences.join("\n")
            );
        }
    }
}
