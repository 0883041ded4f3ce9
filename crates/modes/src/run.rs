//! A simulation from its beginning to its end.

use crate::report::{Run, Watch};
use crate::settings::Settings;
use crate::simulation::Simulation;
use crate::trouble::RunError;

pub(crate) fn run(simulation: &Simulation, settings: &Settings, watch: &mut dyn Watch) -> Result<Run, RunError> {
    let _ = (simulation, settings, watch);
    unimplemented!()
}
