//! Errors of figures: why one cannot walk, or cannot be measured as it walks.

use solaris_model::SolePart;

/// Why the walker cannot move a figure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum BodyError {
    #[error("figure '{figure}' has no link {}; the walker needs the links of the human figure", quoted(.links))]
    MissingLinks { figure: String, links: Vec<String> },
    #[error(
        "figure '{figure}' has {links} links; the walker knows what to do with the {known} of the human figure"
    )]
    OtherLinks { figure: String, links: usize, known: usize },
    #[error(
        "joint '{joint}': the walker needs a cane that turns about z, then x in the hand, and whose tip is straight below"
    )]
    OtherCane { joint: String },
    #[error(
        "figure '{figure}' holds a cane: with one only walks over level ground are planned, from standing to standing"
    )]
    HoldsCane { figure: String },
    #[error("figure '{figure}' cannot walk; {} things are amiss:{}", .missing.len(), listed(.missing))]
    CannotWalk { figure: String, missing: Vec<BodyError> },
    #[error("link '{link}' hangs on {parent}; the walker needs it on {wanted}")]
    OtherParent { link: String, parent: String, wanted: String },
    #[error(
        "joint '{joint}': the walker needs rotations about z, y, x in this order (the root slides along x, y, z first, and \
         may turn about y, z, x), with axes parallel to the parent's"
    )]
    OtherJoint { joint: String },
    #[error(
        "link '{link}' has no sole point {part:?}; the walker needs heel and ball on the foot, the tip on the toes"
    )]
    MissingSolePoint { link: &'static str, part: SolePart },
    #[error(
        "the legs differ: left and right {joint} joint are {difference:.2e} m from being mirror images; only thigh and shank may be of \
         unequal length, and only in walks that are planned in people's style"
    )]
    LegsDiffer { joint: &'static str, difference: f64 },
    #[error(
        "the {} leg is {:.1} cm shorter than the other one; the walker can do with {:.1} cm",
        if *.difference < 0.0 { "left" } else { "right" }, 100.0 * .difference.abs(), 100.0 * .most
    )]
    LegsTooUnequal { difference: f64, most: f64 },
    #[error(
        "the {joint} joint lies {offset:.2e} m to the side of the leg's plane; the walker needs hip, knee, ankle \
         and toes in one plane"
    )]
    OutOfPlane { joint: &'static str, offset: f64 },
    #[error("the figure has no anatomical angle '{angle}'")]
    MissingAngle { angle: String },
}

fn listed(missing: &[BodyError]) -> String {
    missing.iter().map(|one| format!("\n  - {one}")).collect::<Vec<_>>().concat()
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ")
}
