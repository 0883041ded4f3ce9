//! What a figure is made of besides its shapes: masses, axes, soles, markers, for whoever draws them.

use serde_json::{Value, json};
use solaris::analysis::ground::Sole;
use solaris::model::{self, AxisKind, Link, Vector3};

/// Moments of inertia below this share of the greatest are none (a thin rod about itself).
const THIN: f64 = 1e-9;

/// Each link's centre of mass (m) and mass (kg), half axes (m) and quaternion of the homogeneous ellipsoid that has its inertia, named points (m);
/// its joint's centre and turning axes; and the lines of soles; all in the frames of links, as JSON.
///
/// The first axis of a joint is fixed to the parent (`"on"` says to which link), the last to the link; those between are fixed to neither, and
/// are left out.
pub(crate) fn anatomy(figure: &model::Figure, soles: &[Sole]) -> String {
    let links: Vec<Value> = figure.links().iter().enumerate().map(|(at, link)| of_link(at, link)).collect();
    let soles: Vec<Value> = soles
        .iter()
        .flat_map(Sole::lines)
        .map(|(link, [from, to])| json!({ "link": link, "from": three(&from), "to": three(&to) }))
        .collect();
    json!({ "links": links, "soles": soles }).to_string()
}

fn of_link(at: usize, link: &Link) -> Value {
    let points: Vec<Value> = link
        .frames()
        .iter()
        .map(|frame| json!({ "name": frame.name, "at": three(&frame.placement.translation.vector) }))
        .collect();
    json!({
        "name": link.name(),
        "mass": link.mass(),
        "com": three(link.com()),
        "ellipsoid": ellipsoid(link),
        "axes": axes(at, link),
        "points": points,
    })
}

fn ellipsoid(link: &Link) -> Option<Value> {
    if link.mass() <= 0.0 {
        return None;
    }
    let principal = link.inertia().symmetric_eigen();
    let moments = principal.eigenvalues;
    let greatest = moments.max();
    if greatest.is_nan() || greatest <= 0.0 {
        return None;
    }
    // Of a homogeneous ellipsoid: I = m (b² + c²) / 5 about the half axis a.
    let half = |i: usize| {
        let squared = 2.5 * (moments.sum() - 2.0 * moments[i]) / link.mass();
        squared.max(THIN * greatest / link.mass()).sqrt()
    };
    let mut turn = principal.eigenvectors;
    if turn.determinant() < 0.0 {
        turn.column_mut(2).neg_mut();
    }
    let columns: Vec<[f64; 3]> = (0..3).map(|i| three(&turn.column(i).into_owned())).collect();
    Some(json!({ "half": [half(0), half(1), half(2)], "along": columns }))
}

/// Of the root, which stands in the world, those fixed to itself alone.
fn axes(at: usize, link: &Link) -> Vec<Value> {
    let joint = link.joint();
    let turning: Vec<(usize, &Vector3<f64>)> = joint
        .kind()
        .axes()
        .iter()
        .enumerate()
        .filter(|(_, dof)| dof.axis.kind == AxisKind::Rotation)
        .map(|(i, dof)| (i, &dof.axis.direction))
        .collect();
    let mut found = Vec::new();
    if let (Some(parent), Some((_, first))) = (link.parent(), turning.first()) {
        let placement = joint.placement();
        let direction = placement.rotation * **first;
        found.push(
            json!({ "on": parent, "at": three(&placement.translation.vector), "along": three(&direction) }),
        );
    }
    if let Some((_, last)) = turning.last().filter(|_| turning.len() > 1 || found.is_empty()) {
        found.push(json!({ "on": at, "at": three(&Vector3::zeros()), "along": three(last) }));
    }
    found
}

fn three(v: &Vector3<f64>) -> [f64; 3] {
    [v.x, v.y, v.z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris::model::{FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape, ShapeKind};

    #[test]
    fn the_ellipsoid_of_an_ellipsoid_is_itself() {
        let kind = ShapeKind::Ellipsoid { radii: Vector3::new(0.1, 0.2, 0.3) };
        let egg = LinkSpec::root("egg", Joint::new("spin").ry()).mass(2.0);
        let egg = egg.inertia(Inertia::Uniform(Shape { kind, placement: Placement::identity() }));
        let figure = FigureBuilder::new("egg").link(egg).build().expect("a figure");
        let found: Value = serde_json::from_str(&anatomy(&figure, &[])).expect("JSON");
        let mut half: Vec<f64> =
            (0..3).filter_map(|i| found["links"][0]["ellipsoid"]["half"][i].as_f64()).collect();
        half.sort_by(f64::total_cmp);
        assert!(half.iter().zip([0.1, 0.2, 0.3]).all(|(a, b)| (a - b).abs() < 1e-12), "{half:?}");
    }
}
