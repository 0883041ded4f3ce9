//! Where links stand, the long way: for the tests of what changes figures.

use solaris_model::{AxisKind, Figure, Isometry3, JointKind, UnitQuaternion, Vector3};

/// Where the frames of all links stand in the world at the configuration `q`, of a figure without ball and free joints.
pub(crate) fn places(figure: &Figure, q: &[f64]) -> Vec<Isometry3<f64>> {
    let mut places: Vec<Isometry3<f64>> = Vec::new();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        let JointKind::Axes(dofs) = link.joint().kind() else { panic!("a joint of axes") };
        let parent = link.parent().map_or_else(Isometry3::identity, |parent| places[parent]);
        let moved =
            dofs.iter().zip(&q[at.q..]).fold(parent * link.joint().placement(), |place, (dof, value)| {
                let by: Vector3<f64> = dof.axis.direction * *value;
                place
                    * match dof.axis.kind {
                        AxisKind::Rotation => Isometry3::new(Vector3::zeros(), by),
                        AxisKind::Translation => Isometry3::from_parts(by.into(), UnitQuaternion::identity()),
                    }
            });
        places.push(moved);
    }
    places
}
