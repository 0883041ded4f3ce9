//! A scene as text: who, what drives it, for how long; one motion and one report come out.
//!
//! ```sh
//! cargo run --release -p solaris --example scene_text
//! ```

use solaris::scene::{self, NoFiles};
use std::error::Error;

/// A pendulum whose motion is known in closed form.
const SCENE: &str = include_str!("../../../fixtures/scenes/pendulum.ron");

#[allow(clippy::print_stdout, reason = "what it comes to")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let scene = scene::read(SCENE, &mut NoFiles)?;
    let simulated = scene.simulate(&mut ())?;
    let (motion, report) = (&simulated.motion, &simulated.report);
    let angle = motion.q(motion.len() - 1)[0];
    // By elliptic functions, as the scene says.
    let place = [angle.sin(), -angle.cos()];
    println!(
        "{} frames by {}; at the end at {:.6}, {:.6} m",
        motion.len(),
        report.method,
        place[0],
        place[1]
    );
    assert!(
        (place[0] + 0.275_087_462_576_116_9).abs() < 1e-6
            && (place[1] + 0.961_419_205_099_125_3).abs() < 1e-6
    );
    Ok(())
}
