//! Problems whose answers others have published, solved here: the tables of docs/benchmarks.md.

mod kernel;
mod linkages;
mod motions;

use super::page;
use crate::table::{self, Table};
use crate::workspace::{read, write};
use solaris_model::Motion;
use solaris_modes::{Method, Run, RunError, Settings, Simulation};
use std::time::Instant;

const PAGE: &str = "docs/benchmarks.md";

/// A problem whose motion is known.
struct Problem {
    name: &'static str,
    simulation: Simulation,
    /// How long (s), and in how many frames a second (1/s).
    duration: f64,
    rate: f64,
    /// How far off a motion is (rad or m).
    off: Box<dyn Fn(&Motion) -> f64>,
}

/// What a problem comes to by one setting.
struct Outcome {
    /// (rad or m)
    off: f64,
    run: Run,
    /// (ms)
    time: f64,
}

impl Problem {
    /// Of a scene of fixtures/scenes.
    fn of_scene(
        name: &'static str,
        file: &str,
        off: impl Fn(&Motion) -> f64 + 'static,
    ) -> Result<Self, String> {
        let path = format!("fixtures/scenes/{file}.ron");
        let scene = solaris_scene::read(&read(&path)?, &mut solaris_scene::NoFiles)
            .map_err(|error| format!("{path}: {error:?}"))?;
        let Settings { duration, rate, .. } = *scene.settings();
        Ok(Self { name, simulation: scene.simulation().clone(), duration, rate, off: Box::new(off) })
    }

    fn solve(&self, method: Method) -> Result<Outcome, RunError> {
        eprintln!("report: {}, {method:?}", self.name);
        let estimate = matches!(method, Method::Automatic { .. });
        let mut settings =
            Settings { method, estimate, forces: false, ..Settings::new(self.duration, self.rate) };
        // Small steps are measured that nobody would wait for.
        settings.guard.evaluations = 100_000_000;
        let begun = Instant::now();
        let run = self.simulation.run(&settings)?;
        let time = begun.elapsed().as_secs_f64() * 1e3;
        Ok(Outcome { off: (self.off)(&run.motion), run, time })
    }
}

/// The greatest distance between the frames of a motion and what is known, each frame by `distance` of its time and positions.
fn worst(motion: &Motion, distance: impl Fn(f64, &[f64]) -> f64) -> f64 {
    motion.time().iter().enumerate().map(|(i, t)| distance(*t, motion.q(i))).fold(0.0, f64::max)
}

/// Measures everything and writes the page.
pub(super) fn run() -> Result<(), String> {
    let mut text = table::replace(&read(PAGE)?, "when", &page::circumstances())?;
    for (name, table) in all()? {
        text = table::replace(&text, name, &table.markdown()).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    write(PAGE, &text)
}

fn all() -> Result<[(&'static str, Table); 3], String> {
    Ok([
        ("kernel", kernel::table()?),
        ("tolerances", motions::table()?),
        ("impulses", linkages::by_impulses()?),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn single_evaluations_give_what_others_publish() {
        let table = kernel::table().expect("every figure is valid");
        let page = read(PAGE).expect("the page");
        let differences = table.differences(table::block(&page, "kernel").expect("a table"));
        assert!(
            differences.is_empty(),
            "{PAGE}: `cargo lab report published` is due:\n{}",
            differences.join("\n")
        );
    }

    #[test]
    #[ignore = "all problems by all settings, a minute: cargo xtask nightly"]
    fn the_page_says_what_is_measured() {
        let page = read(PAGE).expect("the page");
        for (name, table) in all().expect("every problem runs") {
            let differences = table.differences(table::block(&page, name).expect("a table"));
            assert!(
                differences.is_empty(),
                "{PAGE}, {name}: `cargo lab report published` is due:\n{}",
                differences.join("\n")
            );
        }
    }
}
