//! The check of a figure for everything that it needs to walk.

use super::leg::LegGeometry;
use super::roles::{ARM, CANE, LEG, MIDDLE, PELVIS_ANGLES, SIDED_ANGLES, SIDES};
use super::segments::{Cane, segment};
use crate::error::BodyError;
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

/// Everything that `figure` is missing to walk and to have its walk measured; nothing for [`solaris_model::human()`].
#[doc(alias = "lacks")]
#[doc(alias = "can_walk")]
pub fn missing_for_walking(figure: &Figure) -> Vec<BodyError> {
    let mut faults = of_body(figure);
    let angles = SIDES.iter().flat_map(|side| SIDED_ANGLES.map(|angle| format!("{side}{angle}")));
    for angle in angles.chain(PELVIS_ANGLES.map(|angle| format!("pelvis.{angle}"))) {
        let missing = figure.anatomical_angle(&angle).is_none();
        faults.extend(missing.then_some(BodyError::MissingAngle { angle }));
    }
    faults
}

/// Refuses a figure that cannot walk: the one thing that is amiss, or [`BodyError::CannotWalk`] with the list; and one that holds a cane.
pub(crate) fn check(figure: &Figure) -> Result<(), BodyError> {
    check_for_walk(figure)?;
    match figure.link(CANE) {
        Some(_) => Err(BodyError::HoldsCane { figure: figure.name().to_owned() }),
        None => Ok(()),
    }
}

/// The same of one that may hold a cane, where that is compiled in.
pub(crate) fn check_for_walk(figure: &Figure) -> Result<(), BodyError> {
    if !cfg!(feature = "cane") && figure.link(CANE).is_some() {
        return Err(BodyError::HoldsCane { figure: figure.name().to_owned() });
    }
    refuse(figure, of_body(figure))
}

/// The error of what is missing, if anything is.
pub(crate) fn refuse(figure: &Figure, mut faults: Vec<BodyError>) -> Result<(), BodyError> {
    match faults.len() {
        0 => Ok(()),
        1 => Err(faults.remove(0)),
        _ => Err(BodyError::CannotWalk { figure: figure.name().to_owned(), missing: faults }),
    }
}

/// Links, joints, soles and legs that are amiss.
fn of_body(figure: &Figure) -> Vec<BodyError> {
    let mut faults = Vec::new();
    let mut parent = None;
    for name in MIDDLE {
        faults.extend(segment(figure, name, parent).err());
        parent = Some(name);
    }
    for side in SIDES {
        for (limb, from) in [(ARM, "thorax"), (LEG, "pelvis")] {
            let mut parent = from.to_owned();
            for name in limb {
                let name = format!("{side}{name}");
                faults.extend(segment(figure, &name, Some(&parent)).err());
                parent = name;
            }
        }
    }
    for (link, part) in SOLES {
        let missing = figure.link(link).is_some_and(|foot| foot.sole_point(part).is_none());
        faults.extend(missing.then_some(BodyError::MissingSolePoint { link, part }));
    }
    let known = MIDDLE.len() + 2 * (ARM.len() + LEG.len());
    let held = usize::from(figure.link(CANE).is_some());
    faults.extend(Cane::of(figure).err());
    if figure.links().len() > known + held {
        let (figure, links) = (figure.name().to_owned(), figure.links().len());
        faults.push(BodyError::OtherLinks { figure, links, known });
    }
    let mut faults = gathered(figure, faults);
    // What needs all of these comes last.
    if faults.is_empty() {
        faults.extend(LegGeometry::of_sides(figure).err());
    }
    faults
}

/// The same with the links that are missing as one.
fn gathered(figure: &Figure, faults: Vec<BodyError>) -> Vec<BodyError> {
    let (mut missing, mut others) = (Vec::new(), Vec::new());
    for fault in faults {
        match fault {
            BodyError::MissingLinks { links, .. } => missing.extend(links),
            other => others.push(other),
        }
    }
    if !missing.is_empty() {
        others.insert(0, BodyError::MissingLinks { figure: figure.name().to_owned(), links: missing });
    }
    others
}
