//! A game's walk: two strides that repeat, blended for every frame as the speed changes; no file, no allocation in the frame.
//!
//! ```sh
//! cargo run --release -p solaris --example game_walk
//! ```

use solaris::prelude::*;
use std::error::Error;

/// A walk at this many steps a minute, planned once.
fn walk_at(figure: &Figure, step_frequency: f64) -> Result<WalkPlan, Box<dyn Error>> {
    // Long enough for a stride in the middle that repeats.
    let extent = Extent::Steps(60);
    let request = WalkRequest { step_frequency: Some(step_frequency), extent, ..WalkRequest::default() };
    Ok(walk(figure, &request)?)
}

#[allow(clippy::print_stdout, reason = "what a game would draw")]
pub(crate) fn main() -> Result<(), Box<dyn Error>> {
    let ann = human(1.65, 58.0)?;
    let plans = [walk_at(&ann, 80.0)?, walk_at(&ann, 110.0)?];
    let [slow, fast] =
        plans.each_ref().map(|plan| plan.stride_loop().ok_or("the walk has no stride that repeats"));
    let (slow, fast) = (slow?, fast?);
    let length = |of: &StrideLoop<'_, WalkPlan>| of.duration();

    let nq = ann.layout().nq();
    let [mut a, mut b, mut pose] = [(); 3].map(|()| vec![0.0; nq]);
    let (mut phase, mut travelled, mut speed) = (0.0, 0.0, 0.0);
    let dt = 1.0 / 60.0;
    for frame in 0..180 {
        // From the slow walk to the fast one within a second.
        let blend = (f64::from(frame) * dt - 1.0).clamp(0.0, 1.0);
        slow.configuration(phase * length(&slow), &mut a);
        fast.configuration(phase * length(&fast), &mut b);
        ann.interpolate(&a, &b, blend, &mut pose)?;
        // Each stride starts again at z = 0, so that the distance walked is summed here.
        speed = slow.speed() + blend * (fast.speed() - slow.speed());
        travelled += speed * dt;
        pose[2] = travelled;
        phase = (phase + dt / (length(&slow) + blend * (length(&fast) - length(&slow)))).fract();
        // … here a game gives `pose` to its skeleton.
    }
    println!("after 3 s at {travelled:.2} m, walking at {speed:.2} m/s");
    assert!(pose.iter().all(|x| x.is_finite()) && (speed - fast.speed()).abs() < 1e-12);
    assert!((2.5..4.5).contains(&travelled));
    Ok(())
}
