//! The pictures of docs/trust.md: error against time.

use super::figures::{self, Case};
use super::{ground, solutions};
use crate::report::write;
use solaris_modes::study::{StudyOptions, study};
use solaris_modes::{Observer, Settings};
use solaris_view::precision::{Against, diagram, svg};
use std::f64::consts::FRAC_PI_2;
use std::fs;
use std::time::Instant;

/// A clock.
struct Clock(Instant);

impl Observer for Clock {
    fn now(&self) -> Option<f64> {
        Some(self.0.elapsed().as_secs_f64())
    }
}

/// Draws them.
pub(super) fn draw() -> Result<(), String> {
    let pendulum = Case {
        name: "pendulum, 10 s",
        simulation: figures::pendulum()?,
        duration: 10.0,
        rate: 100.0,
        solution: Some(solutions::pendulum(FRAC_PI_2, 9.81_f64.sqrt())),
    };
    let folder = crate::workspace::root().join("docs/trust");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    eprintln!("report: on the ground");
    for (file, picture) in ground::picture::diagrams()? {
        write(&format!("docs/trust/{file}.svg"), &svg(&picture, Against::Evaluations))?;
    }
    for (file, case) in [("pendulum", pendulum), ("governor", figures::governor()?)] {
        eprintln!("report: {}, all settings", case.name);
        let options = StudyOptions {
            solution: case.solution.as_deref().map(|solution| solution as _),
            ..StudyOptions::default()
        };
        let settings = Settings::new(case.duration, case.rate);
        let mut clock = Clock(Instant::now());
        let study = study(&case.simulation, &settings, &options, &mut clock, &mut |_| {})
            .map_err(|error| format!("{}: {error}", case.name))?;
        let picture = diagram(&study, case.name, case.duration, case.rate);
        write(&format!("docs/trust/{file}.svg"), &svg(&picture, Against::Seconds))?;
        write(&format!("docs/trust/{file}-evaluations.svg"), &svg(&picture, Against::Evaluations))?;
    }
    Ok(())
}
