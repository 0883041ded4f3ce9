//! Carriers of the forces on soles: the links that bear them.

use crate::carrier::Carrier;
use crate::ground::{GroundError, PlacedFeet, Sole, soles};
use crate::prepared::PreparedMotion;
use solaris_dynamics::{Workspace, forward_kinematics};

/// What carries each of these feet.
///
/// The figure's own soles have ball and tip in the toes' link, or the foot carries all. Of a sole from elsewhere the ball is
/// known in the foot's frame; in that of the toes' link it is where it is with all joints at zero.
pub(super) fn carriers(feet: &PlacedFeet<'_>) -> Result<Vec<Carrier>, GroundError> {
    let PreparedMotion { figure, tree, .. } = feet.prepared();
    let mut q = vec![0.0; tree.nq()];
    // What is refused is a wrong length.
    let _ = figure.neutral(&mut q);
    let mut workspace = Workspace::new(tree);
    forward_kinematics(tree, &mut workspace, &q).map_err(GroundError::Tree)?;
    let own = soles(figure);
    let carrier = |sole: &Sole| {
        let alone = Carrier::of_one(sole.foot);
        let Some(toes) = sole.toes else { return alone };
        if own.contains(sole) {
            return Carrier::of_two(figure, sole.foot, toes).unwrap_or(alone);
        }
        let (ball, frame) = (workspace.pose(sole.foot).transform(&sole.ball), workspace.pose(toes));
        let ball = frame.rotation.transpose() * (ball - frame.translation);
        // Toes that end where they begin carry nothing.
        if ball == sole.tip { alone } else { Carrier::of_points(sole.foot, toes, [ball, sole.tip]) }
    };
    Ok(feet.soles().iter().map(carrier).collect())
}
