//! The poses of the links in the neutral configuration.

use crate::figure::Figure;
use crate::joint::{AxisKind, JointKind, Placement};
use nalgebra::{Matrix3, Unit, UnitQuaternion, Vector3};

/// A figure at its zero pose: every coordinate zero but those that follow others, which are where these put them.
pub(super) struct Neutral {
    /// Of every coordinate its value (rad or m); quaternions are the identity.
    pub(super) q: Vec<f64>,
    /// Where every link's frame stands in the world.
    pub(super) places: Vec<Placement>,
}

impl Neutral {
    pub(super) fn of(figure: &Figure) -> Self {
        let layout = figure.layout();
        let mut q = vec![0.0; layout.nq()];
        let mut rates = [vec![0.0; layout.nv()], vec![0.0; layout.nv()]];
        let [v, a] = &mut rates;
        figure.follow(&mut q, v, a);
        let mut places: Vec<Placement> = Vec::with_capacity(figure.links.len());
        for (link, at) in figure.links.iter().zip(layout.joints()) {
            let mut place = link.parent.map_or_else(Placement::identity, |parent| places[parent]);
            place *= link.joint.placement;
            if let JointKind::Axes(dofs) = &link.joint.kind {
                for (dof, value) in dofs.iter().zip(&q[at.q..]).filter(|(_, value)| **value != 0.0) {
                    let by = dof.axis.direction * *value;
                    match dof.axis.kind {
                        AxisKind::Translation => place.translation.vector += place.rotation * by,
                        AxisKind::Rotation => {
                            let axis = Unit::new_unchecked(dof.axis.direction);
                            place.rotation *= UnitQuaternion::from_axis_angle(&axis, *value);
                        }
                    }
                }
            } else if let Some(at) = link.joint.kind.quaternion().map(|quaternion| at.q + quaternion + 3) {
                q[at] = 1.0;
            }
            place.rotation.renormalize();
            places.push(place);
        }
        Self { q, places }
    }

    /// A point of the link, in the world.
    pub(super) fn point(&self, link: usize, point: &Vector3<f64>) -> Vector3<f64> {
        self.places[link].transform_point(&(*point).into()).coords
    }

    /// A tensor along the link's axes, along the world's.
    pub(super) fn tensor(&self, link: usize, tensor: &Matrix3<f64>) -> Matrix3<f64> {
        let turn = self.places[link].rotation.to_rotation_matrix();
        turn.matrix() * tensor * turn.matrix().transpose()
    }
}
