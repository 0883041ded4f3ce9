//! A subject's joint moments from a model, its motion and two force plates: what `solaris inverse` does, as a library.
//!
//! ```sh
//! cargo run --release -p solaris --example subject_moments
//! ```

use solaris::io::{opensim, record, sto};
use solaris::prelude::*;
use std::error::Error;

const MODEL: &str = include_str!("../../../fixtures/subject/subject.osim");
const MOTION: &str = include_str!("../../../fixtures/subject/walk.mot");
const PLATES: &str = include_str!("../../../fixtures/subject/grf.mot");

#[allow(clippy::print_stdout, reason = "what it comes to")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let subject = opensim::read(MODEL)?;
    let figure = &subject.figure;
    let recorded = record::read(figure, subject.gravity, &sto::read(MOTION)?)?.motion;
    // Velocities and accelerations as OpenSim finds them: filtered at 6 Hz, by splines.
    let motion = differentiate(figure, &recorded, Some(Filter { cutoff: 6.0, order: 3 }))?.motion;

    let plates = sto::read(PLATES)?;
    let plate = |body: &str, prefix: &str| record::forces(&plates, &[body.to_owned()], prefix);
    let measured = [plate("calcn_r", "")?, plate("calcn_l", "1_")?];
    let loads = Loads::at_times(figure, &measured, motion.time())?;

    let options = InverseOptions { passive: true, progress: None };
    let report = inverse_motion(&PreparedMotion::new(figure, &motion)?, &loads, options)?;
    for (name, load) in figure.layout().v_names().iter().zip(&report.dofs) {
        println!("{name:<24} {:>9.2} at {:.2} s", load.greatest, load.time);
    }
    println!(
        "missing for balance: {:.1} N, {:.1} N m",
        report.residual.force_rms, report.residual.moment_rms
    );
    assert!(report.tau.iter().all(|tau| tau.is_finite()));
    Ok(())
}
