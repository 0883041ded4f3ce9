//! Errors of a walker that is steered.

/// Why a live walker does not take what it is given; it stays as it is.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum LiveError {
    #[error(
        "figure '{figure}' turns about z first, and a live walker turns without end: give its root the order Yzx, in a figure's text \
         Human(..., root: Yzx), in the library Human::root(RootOrder::Yzx)"
    )]
    Root { figure: String },
    #[error("{what} {value}: it must be a number below a million")]
    NotFinite { what: &'static str, value: f64 },
    #[error("a frame of {seconds} s: it must last more than 0 and at most {most} s")]
    Frame { seconds: f64, most: f64 },
    #[error("there is no coordinate '{dof}' that can be told{}; all but those of the root and the legs can", meant(nearest.as_ref()))]
    NotFree { dof: String, nearest: Option<String> },
    #[error("there is no joint '{joint}' that can be loosened; all but those of the root and the legs can")]
    NotLoose { joint: String },
    #[error("there is no link '{link}'{}", meant(nearest.as_ref()))]
    NoLink { link: String, nearest: Option<String> },
    #[error("a push of {force} N: it must be at most the weight, {most:.0} N")]
    Push { force: f64, most: f64 },
    #[error("what hangs loose from the walk: {why}")]
    Loose { why: String },
    #[error("what is to be reached for: {why}")]
    Reach { why: String },
    #[error("a clip that is to be played: {why}")]
    Clip { why: String },
    #[error("the forces of a frame: {why}")]
    Forces { why: String },
    #[error("{given} numbers for {wanted} coordinates")]
    Length { given: usize, wanted: usize },
}

/// What may have been meant.
fn meant(nearest: Option<&String>) -> String {
    nearest.map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
}
