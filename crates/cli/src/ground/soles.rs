//! Whose soles stand on the ground: those of a file, the figure's own, or a guess.

pub(crate) use solaris::files::SolesFrom as From;

use crate::error::CliError;
use crate::given::Given;
use crate::words::some;
use solaris::analysis::ground::Sole;
use solaris::files::Source;
use solaris::model::Figure;
use std::path::Path;

/// The soles and who says so.
pub(crate) fn find(soles: Option<&Path>, given: &Given) -> Result<(Vec<Sole>, From), CliError> {
    known(soles, given)?.ok_or_else(|| CliError::input(&given.of, &missing(&given.body.figure)))
}

/// The same of a figure that may have none.
pub(crate) fn known(soles: Option<&Path>, given: &Given) -> Result<Option<(Vec<Sole>, From)>, CliError> {
    Ok(Source::disk().soles(soles, &given.body.figure)?)
}

/// What to do about a figure of which nobody knows the feet.
fn missing(figure: &Figure) -> String {
    let links = figure.links();
    let is_last = |i: &usize| links.iter().all(|link| link.parent() != Some(*i));
    let last: Vec<String> = (0..links.len()).filter(is_last).map(|i| links[i].name().to_owned()).collect();
    let example = last.first().cloned().unwrap_or_default();
    format!(
        "figure '{}' has no soles, and no bodies calcn_r and toes_r, calcn_l and toes_l to guess them by.
Write down where its feet meet the ground, in a file for --soles, such as

Soles(version: 1, soles: [
    // Points in m, in the frame of the link or body that is named; hindmost, below the toes' joint, foremost.
    // width: breadth in m; without it the centre of pressure is not judged. toes: \"LINK\" if the tip is on another.
    Sole(name: \"right\", foot: \"{example}\", heel: (-0.05, -0.04, 0), ball: (0.13, -0.04, 0), tip: (0.2, -0.04, 0)),
])

Links at the ends of the figure: {}",
        figure.name(),
        some(&last)
    )
}
