//! Everything that a figure lacks to walk.

use super::leg::LegGeometry;
use super::roles::{ARM, LEG, MIDDLE, PELVIS_ANGLES, SIDED_ANGLES, SIDES};
use super::segments::segment;
use crate::error::GaitError;
use solaris_model::{Figure, SolePart};

/// The points of the soles that the walker stands on, and the link of each.
const SOLES: [(&str, SolePart); 6] = [
    ("left_foot", SolePart::Heel),
    ("left_foot", SolePart::Ball),
    ("left_toes", SolePart::ToeTip),
    ("right_foot", SolePart::Heel),
    ("right_foot", SolePart::Ball),
    ("right_toes", SolePart::ToeTip),
];

/// Everything that `figure` lacks to walk and to have its walk measured; nothing for [`solaris_model::human()`].
pub fn missing_for_walking(figure: &Figure) -> Vec<GaitError> {
    let mut lacks = of_body(figure);
    let angles = SIDES.iter().flat_map(|side| SIDED_ANGLES.map(|angle| format!("{side}{angle}")));
    for angle in angles.chain(PELVIS_ANGLES.map(|angle| format!("pelvis.{angle}"))) {
        let missing = figure.anatomical_angle(&angle).is_none();
        lacks.extend(missing.then_some(GaitError::MissingAngle { angle }));
    }
    lacks
}

/// Refuses a figure that cannot walk: the one thing that is amiss, or [`GaitError::CannotWalk`] with the list.
pub(crate) fn check(figure: &Figure) -> Result<(), GaitError> {
    refuse(figure, of_body(figure))
}

/// The error of what is lacking, if anything is.
pub(crate) fn refuse(figure: &Figure, mut lacks: Vec<GaitError>) -> Result<(), GaitError> {
    match lacks.len() {
        0 => Ok(()),
        1 => Err(lacks.remove(0)),
        _ => Err(GaitError::CannotWalk { figure: figure.name().to_owned(), lacks }),
    }
}

/// Links, joints, soles and legs that are amiss.
fn of_body(figure: &Figure) -> Vec<GaitError> {
    let mut lacks = Vec::new();
    let mut parent = None;
    for name in MIDDLE {
        lacks.extend(segment(figure, name, parent).err());
        parent = Some(name);
    }
    for side in SIDES {
        for (limb, from) in [(ARM, "thorax"), (LEG, "pelvis")] {
            let mut parent = from.to_owned();
            for name in limb {
                let name = format!("{side}{name}");
                lacks.extend(segment(figure, &name, Some(&parent)).err());
                parent = name;
            }
        }
    }
    for (link, part) in SOLES {
        let missing = figure.link(link).is_some_and(|foot| foot.sole_point(part).is_none());
        lacks.extend(missing.then_some(GaitError::MissingSolePoint { link, part }));
    }
    let known = MIDDLE.len() + 2 * (ARM.len() + LEG.len());
    if figure.links().len() > known {
        let (figure, links) = (figure.name().to_owned(), figure.links().len());
        lacks.push(GaitError::OtherLinks { figure, links, known });
    }
    let mut lacks = gathered(figure, lacks);
    // What needs all of these comes last.
    if lacks.is_empty() {
        lacks.extend(LegGeometry::of(figure).err());
    }
    lacks
}

/// The same with the links that are missing as one.
fn gathered(figure: &Figure, lacks: Vec<GaitError>) -> Vec<GaitError> {
    let (mut missing, mut others) = (Vec::new(), Vec::new());
    for lack in lacks {
        match lack {
            GaitError::MissingLinks { links, .. } => missing.extend(links),
            other => others.push(other),
        }
    }
    if !missing.is_empty() {
        others.insert(0, GaitError::MissingLinks { figure: figure.name().to_owned(), links: missing });
    }
    others
}
