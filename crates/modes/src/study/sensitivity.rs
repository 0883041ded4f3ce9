//! The test of whether a motion can be compared to its end.

use super::compare::{Answer, compare};
use super::outlook::Outlook;
use super::reference::{Beside, Found};
use crate::drive::Drive;
use crate::failure::RunError;
use crate::settings::Settings;
use crate::simulation::Simulation;
use solaris_model::Motion;

/// What a small change at the beginning comes to, and how long motions can be compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensitivity {
    /// By how much a change of [`Sensitivity::CHANGE`] at the beginning is greater at the worst frame; nothing where
    /// dynamics move nothing from the beginning, or where the changed run failed.
    pub growth: Option<f64>,
    /// The time (s) up to which errors are given: the last frame at which the reference is known to a tenth of the wanted
    /// error; later, rounding and the last digits of the start decide where the figure is.
    pub comparable_until: f64,
    /// Whether that is before the end.
    pub is_chaotic: bool,
}

impl Sensitivity {
    /// The change at the beginning (rad or m) that [`growth`](Self::growth) is of.
    pub const CHANGE: f64 = 1e-8;
}

pub(super) fn of(
    simulation: &Simulation,
    settings: &Settings,
    found: &Found,
    observer: &mut Outlook<'_>,
) -> Result<Sensitivity, RunError> {
    let end = settings.duration;
    let Some(Beside { method, motion }) = &found.beside else {
        return Ok(Sensitivity { growth: None, comparable_until: end, is_chaotic: false });
    };
    let growth = match changed(simulation) {
        None => None,
        Some(changed) => {
            match changed.run_observed(&Settings { method: *method, ..settings.clone() }, observer) {
                Ok(run) => Some(apart(simulation, &run.motion, motion) / Sensitivity::CHANGE),
                Err(RunError::Cancelled) => return Err(RunError::Cancelled),
                Err(_) => None,
            }
        }
    };
    Ok(Sensitivity { growth, comparable_until: found.until.min(end), is_chaotic: found.until < end })
}

/// The greatest difference of positions.
fn apart(simulation: &Simulation, motion: &Motion, other: &Motion) -> f64 {
    compare(simulation.figure(), motion, &Answer::Motion(other), f64::INFINITY).0
}

/// The simulation with what dynamics move a little elsewhere at the beginning; nothing where they move nothing.
fn changed(simulation: &Simulation) -> Option<Simulation> {
    let figure = simulation.figure();
    let (q, v) = simulation.state();
    let mut step = vec![0.0; v.len()];
    let mut sign = Sensitivity::CHANGE;
    for (dof, drives) in simulation.drives.iter().enumerate() {
        let first = drives.first().map(|step| &step.drive);
        if matches!(
            first,
            Some(
                Drive::Free
                    | Drive::Torque(_)
                    | Drive::FreeStyle { .. }
                    | Drive::Intensive { .. }
                    | Drive::Servo(_)
                    | Drive::Sum(_)
            )
        ) {
            step[dof] = sign;
            // To and fro: a change of all angles alike may be a turn of the whole.
            sign = -sign;
        }
    }
    if step.iter().all(|x| x.abs() <= 0.0) {
        return None;
    }
    let mut start = vec![0.0; q.len()];
    figure.integrate(q, &step, &mut start).ok()?;
    let mut changed = simulation.clone();
    changed.set_start(&start, v).ok()?;
    Some(changed)
}
