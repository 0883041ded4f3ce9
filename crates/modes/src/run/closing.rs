//! Whether loops are closed where a run begins, and where they are taken hold of.

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
    if simulation.closed().next().is_none() {
        return Ok(());
    }
    body.velocities(q, v)?;
    for (_, Loop { between, kind, .. }) in simulation.closed() {
        let [first, second] = between.map(|anchor| moving(body, anchor));
        let apart = (first[0] - second[0]).norm();
        let turning = if *kind == LoopKind::Weld { (first[2] - second[2]).norm() } else { 0.0 };
        let speed = (first[1] - second[1]).norm().max(turning);
        if apart > OPEN || speed > OPEN {
            return Err(SetupError::OpenLoop { links: links(simulation, between), apart, speed });
        }
    }
    Ok(())
}

/// The names of the links that a loop holds together.
pub(super) fn links(simulation: &Simulation, between: &[Anchor; 2]) -> [String; 2] {
    between.map(|anchor| {
        let link = anchor.link.map(|link| simulation.figure.links()[link].name().to_owned());
        link.unwrap_or_else(|| "world".to_owned())
    })
}

/// How far the points of a loop are apart (m), where `body` is.
pub(super) fn apart(body: &Body<f64>, between: &[Anchor; 2]) -> f64 {
    let [first, second] = between.map(|anchor| moving(body, anchor)[0]);
    (first - second).norm()
}

/// Where a point is, its velocity, and that with which its link turns.
fn moving(body: &Body<f64>, Anchor { link, point }: Anchor) -> [Vector3<f64>; 3] {
    let Some(link) = link else { return [point, Vector3::zeros(), Vector3::zeros()] };
    let (pose, twist) = (body.pose(link), body.velocity(link));
    let arm = pose.rotation * point;
    [pose.translation + arm, twist.linear + twist.angular.cross(&arm), twist.angular]
}
