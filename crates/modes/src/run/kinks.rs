//! Kinks of forces within steps.

use super::guard;
use super::pass::Passed;
use crate::body::Body;
use crate::failure::RunError;
use crate::simulation::Simulation;

/// Whether something met a ground of springs in a pass, or left it: its force begins at zero, so that nothing is located, and a step
/// over the beginning has an error that does not fall with the rule's order but by chance.
///
/// Where in every frame the same points touch, and nothing pushed if none do, nothing did.
pub(crate) fn has_kinks(simulation: &Simulation, passed: &Passed) -> Result<bool, RunError> {
    let Simulation { figure, gravity, springs, limits, surface, .. } = simulation;
    let Some(surface) = surface.as_ref().filter(|surface| !surface.plants()) else { return Ok(false) };
    let mut body = Body::<f64>::new(figure, *gravity, springs, limits)?.on(Some(surface));
    let record = &passed.record;
    let mut before: Option<Vec<bool>> = None;
    for frame in 0..record.done {
        let found = body.touching(record.q(frame), record.v(frame));
        let found = found.map_err(|error| guard::of_dynamics(record.times[frame], error))?;
        let now: Vec<bool> = found.map(|touch| touch.depth > 0.0).collect();
        if before.as_ref().is_some_and(|before| *before != now) {
            return Ok(true);
        }
        before = Some(now);
    }
    let contact_points = before.is_some_and(|last| last.contains(&true));
    Ok(!contact_points && passed.ground.iter().any(|sum| *sum != 0.0))
}
