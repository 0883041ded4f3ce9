//! Kinematics out of the figure's data alone: products of the joints' own translations and rotations.

use nalgebra::{Rotation3, Unit};
use solaris_model::{AxisKind, Figure, Vector3};

/// Where links are.
pub(crate) struct Walked;

impl Walked {
    /// Origin and orientation of every link of a figure whose joints are chains of axes.
    pub(crate) fn poses(figure: &Figure, q: &[f64]) -> Vec<(Vector3<f64>, Rotation3<f64>)> {
        let mut poses: Vec<(Vector3<f64>, Rotation3<f64>)> = Vec::new();
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            let (mut place, mut turn) =
                link.parent().map_or((Vector3::zeros(), Rotation3::identity()), |parent| poses[parent]);
            place += turn * link.joint().placement().translation.vector;
            for (dof, value) in link.joint().kind().axes().iter().zip(&q[at.q..]) {
                match dof.axis.kind {
                    AxisKind::Translation => place += turn * (dof.axis.direction * *value),
                    AxisKind::Rotation => {
                        turn *= Rotation3::from_axis_angle(&Unit::new_normalize(dof.axis.direction), *value);
                    }
                }
            }
            poses.push((place, turn));
        }
        poses
    }
}
