//! Momentum where nothing but gravity acts from outside.

use crate::drive::Drive;
use crate::simulation::Simulation;
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, center_of_mass, momentum};
use solaris_model::{AxisKind, JointKind, Motion};

/// How far momentum was, at the worst frame, from what it was at the beginning and what gravity has added.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MomentumDrift {
    /// Linear momentum (N s).
    pub linear: f64,
    /// Angular momentum about the world's origin (N m s).
    pub angular: f64,
}

/// The drift over a motion; nothing where more than gravity acts from outside.
///
/// ```text
/// P = P₀ + m·g·t        L = L₀ + (m·c₀·t + P₀·t²/2) × g
/// ```
pub(super) fn drift(simulation: &Simulation, motion: &Motion) -> Option<MomentumDrift> {
    if !is_adrift(simulation) || motion.is_empty() {
        return None;
    }
    let gravity = *simulation.gravity();
    let tree: Tree<f64> = Tree::new(simulation.figure(), gravity).ok()?;
    let mut workspace = Workspace::new(&tree);
    let start = momentum(&tree, &mut workspace, motion.q(0), motion.v(0)).ok()?;
    let center = center_of_mass(&tree, &mut workspace, motion.q(0)).ok()?;
    let mass = tree.mass();
    let mut worst = MomentumDrift::default();
    for sample in 1..motion.len() {
        let t = motion.time()[sample] - motion.time()[0];
        let now = momentum(&tree, &mut workspace, motion.q(sample), motion.v(sample)).ok()?;
        let linear: Vector3<f64> = start.linear + gravity * (mass * t);
        let angular = start.angular + (center * (mass * t) + start.linear * (0.5 * t * t)).cross(&gravity);
        worst.linear = worst.linear.max((now.linear - linear).norm());
        worst.angular = worst.angular.max((now.angular - angular).norm());
    }
    Some(worst)
}

/// Whether every root moves freely in all directions, with nothing that drives or holds it, no spring ends in the
/// world, and the world neither pushes nor hands anything over.
fn is_adrift(simulation: &Simulation) -> bool {
    let figure = simulation.figure();
    let joints = figure.links().iter().zip(figure.layout().joints());
    let mut roots = joints.filter(|(link, _)| link.parent().is_none());
    let is_free = roots.all(|(link, at)| {
        let undriven = (at.v..at.v + at.nv)
            .all(|dof| matches!(simulation.drives[dof].as_slice(), [step] if step.drive == Drive::Free));
        let kind = link.joint().kind();
        let bare = (0..at.nv).all(|index| kind.passive(index).is_none() && kind.armature(index).abs() <= 0.0);
        undriven && bare && moves_freely(kind)
    });
    let held =
        simulation.springs.iter().flat_map(|spring| &spring.between).any(|anchor| anchor.link.is_none());
    let pushed = !simulation.pushes.is_empty() || !simulation.carries.is_empty();
    is_free && !held && !pushed
}

fn moves_freely(kind: &JointKind) -> bool {
    match kind {
        JointKind::Free { .. } => true,
        JointKind::Axes(dofs) => {
            let sliding = dofs.iter().filter(|dof| dof.axis.kind == AxisKind::Translation).count();
            let unlimited = dofs.iter().all(|dof| dof.limits.is_none() && dof.follows.is_none());
            sliding == 3 && dofs.len() == 6 && unlimited
        }
        _ => false,
    }
}
