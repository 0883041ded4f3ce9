//! A robot from its URDF: the torques that hold and move it, and a PD loop with gravity compensation around its simulation.
//!
//! ```sh
//! cargo run --release -p solaris --example robot_torques
//! ```

use solaris::prelude::*;
use std::error::Error;

const ARM: &str = include_str!("../../../fixtures/figures/arm.urdf");

#[allow(clippy::print_stdout, reason = "what it comes to")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let arm = solaris::io::urdf::read(ARM)?;
    let tree = Tree::<f64>::new(&arm.figure, arm.gravity)?;
    let mut workspace = Workspace::new(&tree);

    // What the motors give to move both joints at 1 rad/s² from here.
    let (q, v, a) = ([0.3, -0.5], [0.0; 2], [1.0, 1.0]);
    let mut tau = [0.0; 2];
    inverse_dynamics(&tree, &mut workspace, &q, &v, &a, &[], &mut tau)?;
    println!("to accelerate: {:.3} and {:.3} N m", tau[0], tau[1]);

    // A PD loop at 1 kHz: the controller asks the model what gravity takes, and adds its own.
    let target = [1.0, 0.4];
    let (mut q, mut v, mut a) = (q, v, [0.0; 2]);
    let dt = 1e-3;
    for _ in 0..3000 {
        let mut command = [0.0; 2];
        inverse_dynamics(&tree, &mut workspace, &q, &[0.0; 2], &[0.0; 2], &[], &mut command)?;
        for i in 0..2 {
            command[i] += 20.0 * (target[i] - q[i]) - 4.0 * v[i];
        }
        forward_dynamics(&tree, &mut workspace, &q, &v, &command, &[], &mut a)?;
        for i in 0..2 {
            v[i] += a[i] * dt;
            q[i] += v[i] * dt;
        }
    }
    println!("after 3 s at {:.4} and {:.4} rad", q[0], q[1]);
    assert!((q[0] - target[0]).abs() < 1e-3 && (q[1] - target[1]).abs() < 1e-3);
    Ok(())
}
