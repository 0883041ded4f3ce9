//! Which links of a sole carry what acts on it.

use crate::ground::given::Given;
use crate::ground::{GroundError, Sole, soles};
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, forward_kinematics};
use solaris_model::{Figure, SolePart};

/// The links of a sole, as a [`solaris_model::ForceRecord`] names them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Carried {
    pub(super) links: Vec<String>,
    /// Ball and tip (m) in the frame of the toes' link, where the figure itself does not say them.
    pub(super) ball_and_tip: Option<[Vector3<f64>; 2]>,
}

/// What carries each of these soles.
///
/// The figure's own soles have ball and tip in the toes' link, or the foot carries all. Of a sole from elsewhere the ball is
/// known in the foot's frame; in that of the toes' link it is where it is with all joints at zero.
pub(super) fn carried(given: &Given<'_>, of: &[Sole]) -> Result<Vec<Carried>, GroundError> {
    let figure = given.figure;
    let mut q = vec![0.0; given.tree.nq()];
    // What is refused is a wrong length.
    let _ = figure.neutral(&mut q);
    let mut workspace = Workspace::new(&given.tree);
    forward_kinematics(&given.tree, &mut workspace, &q).map_err(GroundError::Tree)?;
    let own = soles(figure);
    let carried = of.iter().map(|sole| {
        let by = |toes: Option<usize>, ball_and_tip| {
            let links = std::iter::once(sole.foot).chain(toes);
            let links = links.map(|link| figure.links()[link].name().to_owned()).collect();
            Carried { links, ball_and_tip }
        };
        let Some(toes) = sole.toes else { return by(None, None) };
        if own.contains(sole) {
            return by(has_ball_and_tip(figure, toes).then_some(toes), None);
        }
        let (ball, frame) = (workspace.pose(sole.foot).transform(&sole.ball), workspace.pose(toes));
        let ball = frame.rotation.transpose() * (ball - frame.translation);
        // Toes that end where they begin carry nothing.
        if ball == sole.tip { by(None, None) } else { by(Some(toes), Some([ball, sole.tip])) }
    });
    Ok(carried.collect())
}

fn has_ball_and_tip(figure: &Figure, toes: usize) -> bool {
    let toes = &figure.links()[toes];
    [SolePart::Ball, SolePart::ToeTip].iter().all(|part| toes.sole_point(*part).is_some())
}
