//! Errors of showing a motion.

use crate::chart::number;
use solaris_dynamics::DynamicsError;
use solaris_model::MotionError;

/// Why there is no page of this motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ViewError {
    /// The motion was made for another figure.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// The links cannot be placed.
    #[error("the links cannot be placed: {0}")]
    Dynamics(#[from] DynamicsError),
    /// There is nothing to show.
    #[error("the motion of '{figure}' has no samples; a page needs at least one")]
    Empty {
        /// The figure's name.
        figure: String,
    },
    /// A span of time that is none, or that the motion does not have.
    #[error(
        "from {from} to {to} s: the motion goes from {} to {} s; name a span of it, its beginning first",
        number(*.first, 5), number(*.last, 5)
    )]
    Span {
        /// Its beginning (s).
        from: f64,
        /// Its end (s).
        to: f64,
        /// When the motion begins (s).
        first: f64,
        /// When it ends (s).
        last: f64,
    },
    /// A contact track names a link that the figure does not have.
    #[error(
        "a contact track names the link '{link}', which figure '{figure}' does not have; its links are {known}"
    )]
    UnknownLink {
        /// The name.
        link: String,
        /// The figure's name.
        figure: String,
        /// Names of its links.
        known: String,
    },
    /// A contact track is longer or shorter than the motion.
    #[error(
        "the contact track of '{link}' has {found} samples, the motion {expected}; give it one contact a sample"
    )]
    ContactLength {
        /// The track's link.
        link: String,
        /// Its samples.
        found: usize,
        /// The motion's samples.
        expected: usize,
    },
    /// A line goes with a link that the figure does not have.
    #[error("a line is to go with link {link}, and figure '{figure}' has {links}; name one of them")]
    LineLink {
        /// The index.
        link: usize,
        /// The figure's name.
        figure: String,
        /// How many links it has.
        links: usize,
    },
    /// A curve is longer or shorter than the motion.
    #[error("the curve '{label}' has {found} values, the motion {expected} samples; give it one a sample")]
    CurveLength {
        /// What the curve is called.
        label: String,
        /// Its values.
        found: usize,
        /// The motion's samples.
        expected: usize,
    },
    /// A band is longer or shorter than the motion.
    #[error(
        "the {what} bands are {found} numbers, the motion asks for {expected}; give {dofs} for each of its samples, one a \
         degree of freedom"
    )]
    BandLength {
        /// What the bands are around: `angle`, `moment`.
        what: &'static str,
        /// The numbers.
        found: usize,
        /// As many as the motion's samples times the figure's degrees of freedom.
        expected: usize,
        /// The figure's degrees of freedom.
        dofs: usize,
    },
    /// A band cannot be that wide.
    #[error(
        "the {what} band of '{dof}' at {time} s is {value} to each side; it must be a finite number that is not negative"
    )]
    BandWidth {
        /// What the bands are around: `angle`, `moment`.
        what: &'static str,
        /// The degree of freedom's name.
        dof: String,
        /// When (s).
        time: f64,
        /// The half width.
        value: f64,
    },
    /// A number cannot be shown.
    #[error("{what} at {time} s is {value}; it must be a finite number")]
    NotFinite {
        /// What it is.
        what: String,
        /// When (s).
        time: f64,
        /// The number.
        value: f64,
    },
}

/// Refuses numbers that are not finite.
pub(crate) fn finite(what: impl Fn() -> String, time: f64, values: &[f64]) -> Result<(), ViewError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(&value) => Err(ViewError::NotFinite { what: what(), time, value }),
        None => Ok(()),
    }
}
