//! Small figures and records.

use crate::states::Record;
use solaris_model::{Contact, Figure, FigureBuilder, Joint, LinkSpec, MeasuredForce, Vector3};

pub(crate) const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.80665, 0.0);

pub(crate) fn build(links: impl IntoIterator<Item = LinkSpec>) -> Figure {
    links.into_iter().fold(FigureBuilder::new("test"), FigureBuilder::link).build().expect("valid")
}

/// A body with three different moments of inertia (kg m²) and its centre of mass off the origin.
pub(crate) fn body(spec: LinkSpec) -> LinkSpec {
    let inertia = solaris_model::Matrix3::from_diagonal(&Vector3::new(0.4, 0.5, 0.7));
    spec.mass(3.0).com(Vector3::new(0.1, -0.2, 0.05)).inertia(solaris_model::Inertia::Tensor(inertia))
}

/// A hinge about x with a bob of 2 kg half a metre below it.
pub(crate) fn pendulum() -> Figure {
    build([LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0))])
}

/// Positions alone, `nq` a row.
pub(crate) fn positions(figure: &Figure, time: Vec<f64>, q: impl Fn(f64) -> Vec<f64>) -> Record {
    let (nv, rows) = (figure.layout().nv(), time.len());
    Record {
        q: time.iter().flat_map(|&t| q(t)).collect(),
        v: vec![0.0; rows * nv],
        a: vec![0.0; rows * nv],
        known_v: vec![false; nv],
        known_a: vec![false; nv],
        time,
    }
}

pub(crate) fn equally(rows: usize, rate: f64) -> Vec<f64> {
    (0..rows).map(|i| i as f64 / rate).collect()
}

pub(crate) fn forces(links: &[&str], rows: &[(f64, Contact)]) -> MeasuredForce {
    let links = links.iter().map(|link| (*link).to_owned()).collect();
    MeasuredForce {
        links,
        ball_and_tip: None,
        time: rows.iter().map(|row| row.0).collect(),
        samples: rows.iter().map(|row| row.1).collect(),
    }
}

/// A force through a point.
pub(crate) fn push(force: [f64; 3], at: [f64; 3]) -> Contact {
    let (force, cop) = (Vector3::from(force), Vector3::from(at));
    Contact { force, moment: cop.cross(&force), cop }
}
