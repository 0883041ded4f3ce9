//! Markers alone as a figure of points, so that a recording can be shown before anybody says whose it is.

use solaris_model::{
    Figure, FigureBuilder, FigureError, Finding, FindingKind, Joint, Known, LinkSpec, MarkerTrial, Motion,
    MotionError, MotionInfo, Placement, Shape, ShapeKind, Vector3,
};

/// How large a marker is drawn (m).
const RADIUS: f64 = 0.01;

/// Markers as a figure: a link each, which slides along the world's axes.
#[derive(Clone, Debug)]
pub struct Cloud {
    /// A root that stands, and on it a link for each marker that was seen, under its name; nothing weighs.
    pub figure: Figure,
    /// Where they were seen; nothing else is known. Where one was hidden it stays where it was last seen, or where it will first be.
    pub motion: Motion,
    /// Which were hidden, and for how long; which were never seen, and are left out.
    pub findings: Vec<Finding>,
}

/// Why markers are no figure of points.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CloudError {
    /// No frames, or nothing in them.
    #[error("no marker was ever seen: there is nothing to show")]
    NoMarkers,
    /// Names that links cannot have.
    #[error(transparent)]
    Figure(#[from] FigureError),
    /// Places that are no motion.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// The figure of points of a trial, in a world with this gravity (m/s²).
///
/// # Errors
///
/// A trial without frames, or of which no marker was ever seen.
pub fn cloud(trial: &MarkerTrial, gravity: Vector3<f64>) -> Result<Cloud, CloudError> {
    let seen: Vec<usize> = (0..trial.names().len()).filter(|marker| trial.seen(*marker) > 0).collect();
    let mut findings = gaps(trial);
    if seen.is_empty() {
        return Err(CloudError::NoMarkers);
    }
    let names: Vec<String> = seen.iter().map(|marker| name(trial, *marker)).collect();
    let mut root = "laboratory".to_owned();
    while names.contains(&root) {
        root.push('_');
    }
    let mut builder =
        FigureBuilder::new("markers").link(LinkSpec::root(&root, Joint::new(format!("{root} fixed"))));
    for name in &names {
        let joint = Joint::new(name).tx().ty().tz();
        let shape = Shape { kind: ShapeKind::Sphere { radius: RADIUS }, placement: Placement::identity() };
        builder = builder.link(LinkSpec::child(name, &root, joint).shape(shape));
    }
    let figure = builder.build()?;
    let mut q = Vec::with_capacity(3 * seen.len() * trial.len());
    let mut last: Vec<Vector3<f64>> = seen
        .iter()
        .map(|marker| (0..trial.len()).find_map(|frame| trial.point(frame, *marker)).unwrap_or_default())
        .collect();
    for frame in 0..trial.len() {
        for (last, marker) in last.iter_mut().zip(&seen) {
            *last = trial.point(frame, *marker).unwrap_or(*last);
            q.extend(last.iter());
        }
    }
    let time = trial.time().to_vec();
    let nv = figure.layout().nv();
    let still = vec![0.0; time.len() * nv];
    let info = MotionInfo::recorded(&figure, gravity, &time);
    let known = Known { v: vec![false; nv], a: vec![false; nv] };
    let motion = Motion::recorded(&figure, info, time, [q, still.clone(), still], known)?;
    findings.sort_by_key(|finding| finding.kind);
    Ok(Cloud { figure, motion, findings })
}

/// A marker's name, or its number where it has none.
fn name(trial: &MarkerTrial, marker: usize) -> String {
    let name = trial.names()[marker].trim();
    if name.is_empty() { format!("marker {}", marker + 1) } else { name.to_owned() }
}

/// What there is to say of frames in which markers were hidden.
fn gaps(trial: &MarkerTrial) -> Vec<Finding> {
    let frames = trial.len();
    let said = (0..trial.names().len()).filter_map(|marker| {
        let seen = trial.seen(marker);
        let message = match frames - seen {
            0 => return None,
            _ if seen == 0 => "it was never seen, and is left out".to_owned(),
            hidden => {
                format!("it was hidden in {hidden} of {frames} frames, and stays where it was last seen")
            }
        };
        Some(Finding { kind: FindingKind::Note, subject: name(trial, marker), message, place: None })
    });
    said.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hidden_marker_stays_where_it_was_last_seen() {
        let nowhere = Vector3::repeat(f64::NAN);
        let at = |x: f64| Vector3::new(x, 2.0, 3.0);
        let names = ["knee", "laboratory", "ghost"].map(str::to_owned).to_vec();
        let points = vec![nowhere, at(5.0), nowhere, at(1.0), at(6.0), nowhere, nowhere, at(7.0), nowhere];
        let trial = MarkerTrial::new(names, vec![0.0, 0.1, 0.2], points).expect("a trial");
        let Cloud { figure, motion, findings } = cloud(&trial, Vector3::zeros()).expect("a cloud");
        let links: Vec<&str> = figure.links().iter().map(solaris_model::Link::name).collect();
        assert_eq!(links, ["laboratory_", "knee", "laboratory"]);
        assert_eq!(figure.layout().v_names()[..3], ["knee.tx", "knee.ty", "knee.tz"]);
        let x: Vec<[f64; 2]> = (0..3).map(|frame| [motion.q(frame)[0], motion.q(frame)[3]]).collect();
        assert_eq!(x, [[1.0, 5.0], [1.0, 6.0], [1.0, 7.0]]);
        let said: Vec<String> = findings.iter().map(ToString::to_string).collect();
        assert_eq!(
            said,
            [
                "knee: it was hidden in 2 of 3 frames, and stays where it was last seen",
                "ghost: it was never seen, and is left out"
            ]
        );
        let none = MarkerTrial::new(vec!["ghost".to_owned()], vec![0.0], vec![nowhere]).expect("a trial");
        assert!(cloud(&none, Vector3::zeros()).is_err());
    }
}
