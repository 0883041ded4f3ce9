//! A person holds still and lets one arm fall: what is driven, what is free, how far the result can be trusted.
//!
//! ```sh
//! cargo run --release -p solaris --example free_arm
//! ```

use solaris::prelude::*;
use std::error::Error;

#[allow(clippy::print_stdout, reason = "what it comes to")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let ann = human(1.65, 58.0)?;
    let mut simulation = Simulation::new(&ann, Vector3::new(0.0, -9.80665, 0.0));
    let arm = ann.layout().dof_index("left_shoulder.rx").ok_or("the figure has no left_shoulder.rx")?;
    let (mut q, v) = (vec![0.0; ann.layout().nq()], vec![0.0; ann.layout().nv()]);
    q[arm] = -1.0;
    simulation.set_start(&q, &v)?;
    // What has no drive is free: hold all joints, then let go of this one.
    for dof in ann.layout().v_names() {
        simulation.drive(dof, [Drive::Frozen])?;
    }
    simulation.drive("left_shoulder.rx", [Drive::Free])?;

    let run = simulation.run(&Settings::new(2.0, 60.0))?;
    for frame in (0..run.motion.len()).step_by(12) {
        println!("{:.1} s  {:6.1}°", run.motion.time()[frame], run.motion.q(frame)[arm].to_degrees());
    }
    let error = run.report.error.ok_or("the run has no error estimate")?;
    println!("by {}: off by {:.0e} rad at most", run.report.method, error.position);
    assert!(error.position < 1e-3);
    Ok(())
}
