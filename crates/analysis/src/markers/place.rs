//! Markers where a person wears them.

use nalgebra::{Isometry3, Point3, Rotation3};
use solaris_dynamics::{DynamicsError, Tree, Workspace, forward_kinematics};
use solaris_model::{Figure, Marker, MarkerTrial, Vector3};

/// Where `markers` are on the figure at `q` (length `nq`), in world axes (m).
///
/// # Errors
///
/// A `q` that is no configuration, links that the figure does not have.
pub fn places(figure: &Figure, markers: &[Marker], q: &[f64]) -> Result<Vec<Vector3<f64>>, DynamicsError> {
    let poses = poses(figure, q)?;
    let place = |marker: &Marker| {
        let last = poses.len() - 1;
        let pose = poses.get(marker.link).ok_or(DynamicsError::UnknownLink { link: marker.link, last })?;
        Ok((pose * Point3::from(marker.position)).coords)
    };
    markers.iter().map(place).collect()
}

/// Puts the markers that are not fixed where frame 0 of `trial` saw them while the figure was at `q` (length `nq`); those that
/// it did not see are left away, and their names are told.
///
/// # Errors
///
/// As [`places`].
#[doc(alias = "MarkerPlacer")]
pub fn place_markers(
    figure: &Figure,
    markers: &[Marker],
    q: &[f64],
    trial: &MarkerTrial,
) -> Result<(Vec<Marker>, Vec<String>), DynamicsError> {
    let poses = poses(figure, q)?;
    let (mut placed, mut lost) = (Vec::new(), Vec::new());
    for marker in markers {
        let seen = trial.marker(&marker.name).and_then(|column| trial.point(0, column));
        match (seen, poses.get(marker.link)) {
            (Some(_), Some(_)) if marker.is_fixed => placed.push(marker.clone()),
            (Some(seen), Some(pose)) => {
                let position = pose.inverse_transform_point(&Point3::from(seen)).coords;
                placed.push(Marker { position, ..marker.clone() });
            }
            _ => lost.push(marker.name.clone()),
        }
    }
    Ok((placed, lost))
}

/// Where the links are.
fn poses(figure: &Figure, q: &[f64]) -> Result<Vec<Isometry3<f64>>, DynamicsError> {
    let tree = Tree::<f64>::new(figure, Vector3::zeros())?;
    let mut workspace = Workspace::new(&tree);
    forward_kinematics(&tree, &mut workspace, q)?;
    let pose = |link: usize| {
        let pose = workspace.pose(link);
        let rotation = Rotation3::from_matrix_unchecked(pose.rotation);
        Isometry3::from_parts(pose.translation.into(), rotation.into())
    };
    Ok((0..figure.links().len()).map(pose).collect())
}
