//! How many digits are right and how long they take: the numbers and the picture of docs/accuracy.md.
//!
//! Errors are the same on every run; a test holds the page to them. Times are what they were on the day that the page
//! names.

mod accuracy;
mod cases;
#[cfg(test)]
mod currency;
mod moments;
mod page;
mod people;
mod plot;
mod profiles;
mod samples;
mod simulation;
mod speed;
mod table;

use crate::workspace;
use accuracy::Accuracy;
use cases::{Case, HARD, ORDINARY};
use page::{LONG, Measured};
use samples::{Random, chain};
use solaris_gait::determinants::Determinants;
use speed::Speed;
use std::fs;

/// Measures everything and writes the pages.
pub(crate) fn run() -> Result<(), String> {
    moments()?;
    people()?;
    profiles::run()?;
    simulation::run()?;
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

/// Writes how walks compare with people.
pub(crate) fn people() -> Result<(), String> {
    const PAGE: &str = "docs/people.md";
    let mut text = read(PAGE)?;
    let tables = [
        ("five", people::facts(Determinants::Five)?),
        ("three", people::facts(Determinants::Three)?),
        ("bodies", people::counts()?.markdown()),
    ];
    for (name, table) in tables {
        text = table::replace(&text, name, &table).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    write(PAGE, &text)
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

/// The accuracy of every case, with the speeds that `speed` finds.
fn measure(speed: impl Fn(&Case) -> Result<Speed, String>) -> Result<Measured, String> {
    let accuracies = |cases: &[Case]| -> Result<Vec<Accuracy>, String> {
        let measure = |case: &Case| {
            eprintln!("report: errors, {}", case.name);
            accuracy::measure(case)
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

fn read(path: &str) -> Result<String, String> {
    fs::read_to_string(workspace::root().join(path)).map_err(|error| format!("{path}: {error}"))
}

fn write(path: &str, text: &str) -> Result<(), String> {
    eprintln!("report: writing {path}");
    fs::write(workspace::root().join(path), text).map_err(|error| format!("{path}: {error}"))
}

#[cfg(test)]
mod tests {
    use super::accuracy::{forward, inverse, inverse_of};
    use super::*;
    use solaris_dynamics::scalar::DoubleDouble;
    use solaris_dynamics::{Formulation, Real};
    use std::sync::LazyLock;

    /// How much more than other programs with the same formulation may be lost.
    const FACTOR: f64 = 10.0;

    static MEASURED: LazyLock<Measured> = LazyLock::new(|| {
        let count =
            |sample: &_| speed::count(sample).map(|operations| Speed { operations, ..Speed::default() });
        measure(|case| speeds(case, count)).expect("every case has an answer")
    });

    fn measured() -> impl Iterator<Item = (&'static Case, &'static Accuracy)> {
        ORDINARY.iter().zip(&MEASURED.ordinary).chain(HARD.iter().zip(&MEASURED.hard))
    }

    #[test]
    fn inverse_dynamics_loses_no_more_digits_than_others() {
        for (case, accuracy) in measured() {
            let Some(other) = case.inverse else { continue };
            for (formulation, errors) in Formulation::ALL.into_iter().zip(accuracy.inverse) {
                let others =
                    if formulation == Formulation::NewtonEuler { other.local } else { other.lagrangian };
                for (error, other) in errors.into_iter().zip(others) {
                    assert!(
                        error <= FACTOR * other,
                        "{}, {formulation:?}: {error:e}, others {other:e}",
                        case.name
                    );
                }
            }
        }
    }

    #[test]
    fn forward_dynamics_loses_no_more_digits_than_others() {
        for (case, accuracy) in measured() {
            let Some(other) = case.forward else { continue };
            for (error, other) in accuracy.forward.into_iter().zip(other.articulated) {
                assert!(error <= FACTOR * other, "{}: {error:e}, others {other:e}", case.name);
            }
        }
    }

    /// What nobody has published: inverse dynamics knows no gimbal lock, forward dynamics no speed and no distance.
    #[test]
    fn what_is_hard_for_others_is_not_hard() {
        let [double, single] = [f64::EPSILON, f64::from(f32::EPSILON)];
        for (case, accuracy) in measured().filter(|(case, _)| case.name.contains("lock")) {
            for [f64_error, f32_error] in accuracy.inverse {
                assert!(f64_error < 4.0 * double && f32_error < 4.0 * single, "{}: {accuracy:?}", case.name);
            }
        }
        for (case, accuracy) in measured()
            .filter(|(case, _)| case.name.starts_with("20, root") || case.name.starts_with("20, speeds"))
        {
            assert!(
                accuracy.forward[0] < 10.0 * double && accuracy.forward[1] < 10.0 * single,
                "{}: {accuracy:?}",
                case.name
            );
        }
    }

    /// A factor of the mass matrix loses digits with its condition; the recursion does not.
    #[test]
    fn forward_dynamics_keeps_digits_that_the_mass_matrix_loses() {
        for (case, accuracy) in
            measured().filter(|(_, accuracy)| accuracy.condition.is_some_and(|condition| condition > 1e6))
        {
            let [by_matrix, _] = accuracy.matrix.expect("as large as its condition");
            assert!(by_matrix > 5.0 * accuracy.forward[0], "{}: {accuracy:?}", case.name);
        }
    }

    /// The reference: other recursions give the same digits, and inverse dynamics takes forward dynamics back.
    #[test]
    fn the_reference_has_digits_to_spare() {
        let difference = |found: &[DoubleDouble], right: &[DoubleDouble]| {
            let largest = right.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
            found.iter().zip(right).map(|(a, b)| (*a - *b).abs().to_f64() / largest).fold(0.0, f64::max)
        };
        for case in ORDINARY.iter().chain(&HARD).filter(|case| !case.name.ends_with("1000")) {
            let sample = (case.sample)(&mut Random::new(7)).expect("a valid figure");
            let [chain_wise, tree_wise, newton_euler] = Formulation::ALL
                .map(|formulation| inverse::<DoubleDouble>(&sample, formulation).expect("a valid state"));
            // In chains some axes are parallel: the D-H angle between them is no multiple of 90°, and rounded to f64 when
            // the figure is compiled.
            let has_parallels = !case.name.contains("human") && !case.name.contains("lock");
            let tolerance = if has_parallels { 1e-14 } else { 1e-28 };
            assert!(difference(&chain_wise, &tree_wise) < 1e-25, "{}", case.name);
            assert!(difference(&tree_wise, &newton_euler) < tolerance, "{}", case.name);
            let a: Vec<DoubleDouble> = forward(&sample).expect("a valid state");
            let tau = inverse_of(&sample, Formulation::NewtonEuler, &a).expect("a valid state");
            let given: Vec<DoubleDouble> = sample.tau.iter().map(|x| Real::from_f64(*x)).collect();
            assert!(difference(&tau, &given) < 1e-19, "{}", case.name);
        }
    }

    #[test]
    fn the_pages_say_what_is_measured() {
        let pages = [
            ("docs/accuracy.md", "calls", MEASURED.calls()),
            ("docs/accuracy.md", "inverse dynamics", MEASURED.inverse()),
            ("docs/accuracy.md", "forward dynamics", MEASURED.forward()),
            ("docs/accuracy.md", "growth", MEASURED.growth()),
            ("docs/operations.md", "times", MEASURED.times()),
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
