//! Whether loops are closed where a run begins.

use crate::body::Body;
use crate::element::{Anchor, Loop, LoopKind};
use crate::failure::{OPEN, SetupError};
use crate::simulation::Simulation;
use nalgebra::Vector3;

/// Refuses loops that begin open, or open up, further than [`OPEN`]: forces that are to hold them closed would throw the links together.
pub(super) fn check(
    simulation: &Simulation,
    body: &mut Body<f64>,
    q: &[f64],
    v: &[f64],
) -> Result<(), SetupError> {
    if simulation.loops.is_empty() {
        return Ok(());
    }
    body.velocities(q, v)?;
    for Loop { between, kind } in &simulation.loops {
        let [first, second] = between.map(|anchor| moving(body, anchor));
        let apart = (first[0] - second[0]).norm();
        let turning = if *kind == LoopKind::Weld { (first[2] - second[2]).norm() } else { 0.0 };
        let speed = (first[1] - second[1]).norm().max(turning);
        if apart > OPEN || speed > OPEN {
            let name = |anchor: Anchor| {
                anchor.link.map_or_else(
                    || "world".to_owned(),
                    |link| simulation.figure.links()[link].name().to_owned(),
                )
            };
            return Err(SetupError::OpenLoop { links: between.map(name), apart, speed });
        }
    }
    Ok(())
}

/// Where a point is, its velocity, and that with which its link turns.
fn moving(body: &Body<f64>, Anchor { link, point }: Anchor) -> [Vector3<f64>; 3] {
    let Some(link) = link else { return [point, Vector3::zeros(), Vector3::zeros()] };
    let (pose, twist) = (body.pose(link), body.velocity(link));
    let arm = pose.rotation * point;
    [pose.translation + arm, twist.linear + twist.angular.cross(&arm), twist.angular]
}
