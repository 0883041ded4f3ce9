//! The markers of the frames.

use super::bytes::Bytes;
use super::layout::Layout;
use super::parameters::Parameters;
use super::read::Said;
use crate::markers::{counted, unique};
use solaris_model::{FindingKind, Vector3};
use std::collections::HashSet;

/// The markers of the frames, in the file's units.
pub(super) struct Points {
    pub(super) names: Vec<String>,
    /// Frame by frame; NaN where hidden.
    pub(super) places: Vec<Vector3<f64>>,
    pub(super) residuals: Vec<f64>,
}

/// Reads the markers.
pub(super) fn points(bytes: &Bytes<'_>, layout: &Layout, all: &Parameters<'_>, said: &mut Said) -> Points {
    let (kept, names) = names(layout, all, said);
    let mut found = Points { names, places: Vec::new(), residuals: Vec::new() };
    for frame in 0..layout.frames {
        for point in &kept {
            let (place, residual) = one(bytes, layout, layout.point(frame, *point));
            found.places.push(place);
            found.residuals.push(residual);
        }
    }
    found
}

/// A point and its residual, whose numbers begin at `at`.
fn one(bytes: &Bytes<'_>, layout: &Layout, at: usize) -> (Vector3<f64>, f64) {
    // The frames were counted by the file's length, so that nothing is missing here; if it were, the point is hidden.
    let number = |i: usize| {
        let at = at + i * layout.size();
        if layout.is_real {
            bytes.real("a point", at).map_or(f64::NAN, f64::from)
        } else {
            bytes.word("a point", at).map_or(f64::NAN, |word| f64::from(word as i16))
        }
    };
    let last = number(3);
    // Cameras in the high byte, and the residual in the low one; negative where the point is hidden.
    if last < 0.0 || last.is_nan() {
        return (Vector3::repeat(f64::NAN), f64::NAN);
    }
    let residual = f64::from(last as i32 & 0xff) * layout.scale;
    let factor = if layout.is_real { 1.0 } else { layout.scale };
    (Vector3::new(number(0), number(1), number(2)) * factor, residual)
}

/// Which points are markers, and their names.
fn names(layout: &Layout, all: &Parameters<'_>, said: &mut Said) -> (Vec<usize>, Vec<String>) {
    let labels = all.continued("POINT", "LABELS", Parameters::texts);
    let mut others = HashSet::new();
    for list in ["ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS"] {
        others.extend(
            all.continued("POINT", list, Parameters::texts).into_iter().filter(|name| !name.is_empty()),
        );
    }
    let label = |point: usize| labels.get(point).map_or("", String::as_str);
    let (kept, left): (Vec<usize>, Vec<usize>) =
        (0..layout.points).partition(|point| !others.contains(label(*point)));
    if let Some(first) = left.first() {
        let message = format!(
            "{} of {} are results of a model, such as '{}', and no markers; left out",
            left.len(),
            layout.points,
            label(*first)
        );
        said.say(FindingKind::Note, "points", message);
    }
    let mut names: Vec<String> = kept.iter().map(|point| label(*point).to_owned()).collect();
    strip_subject(&mut names, said);
    let (names, changed) = unique(names);
    if let Some((was, is)) = changed.first() {
        let message = format!(
            "{} without a name of its own: '{was}' is called '{is}', for one",
            counted(changed.len(), "marker")
        );
        said.say(FindingKind::Note, "markers", message);
    }
    (kept, names)
}

/// Takes off the subject's name before all names of markers, such as `Anna:` of `Anna:LASI`.
fn strip_subject(names: &mut [String], said: &mut Said) {
    let Some((subject, _)) = names.first().and_then(|name| name.split_once(':')) else { return };
    let subject = format!("{subject}:");
    if names.iter().all(|name| name.len() > subject.len() && name.starts_with(&subject)) {
        for name in names {
            name.drain(..subject.len());
        }
        let message = format!("all begin with '{subject}', which is left out");
        said.say(FindingKind::Note, "markers", message);
    }
}
