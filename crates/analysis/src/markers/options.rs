//! What inverse kinematics may be asked, and what is wrong with it.

use solaris_dynamics::DynamicsError;
use solaris_model::ConfigurationError;

/// What to weigh and hold in [`super::inverse_kinematics`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IkOptions {
    /// Weights of markers by name, none below 0: those not named have weight 0. `None`: all markers weigh 1.
    pub weights: Option<Vec<(String, f64)>>,
    /// Values that coordinates are drawn to.
    pub tasks: Vec<CoordinateTask>,
    /// Degrees of freedom (index in `v`) that stay at a value (rad or m).
    pub held: Vec<(usize, f64)>,
    /// Degrees of freedom (index in `v`) that stay between two values (rad or m).
    pub bounds: Vec<(usize, f64, f64)>,
    /// The positions to begin at, and where what no marker tells of stays (length `nq`); the figure's neutral ones without.
    pub rest: Option<Vec<f64>>,
    /// Takes labels as they are, even where two are clearly exchanged.
    pub keep_labels: bool,
}

/// A value that a coordinate is drawn to: `½·weight·(q − value)²` beside the mean square of the markers' distances (m²).
#[doc(alias = "IKCoordinateTask")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoordinateTask {
    /// Index in `v`.
    pub dof: usize,
    /// Where to (rad or m).
    pub value: f64,
    /// How strongly (m²/rad², or none for slides), 0 or more.
    pub weight: f64,
}

/// Why positions cannot be found from markers.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum IkError {
    /// Figure and trial have no marker in common that weighs anything.
    #[error(
        "no marker of the model is in the trial{}; the model has {model}, the trial {trial}; rename one or the other",
        if *.weighted { " with a weight above 0" } else { "" }
    )]
    NoMarkers {
        /// The first markers of the figure.
        model: String,
        /// The first markers of the trial.
        trial: String,
        /// Whether there would be some without the weights.
        weighted: bool,
    },
    /// A figure without anything to find.
    #[error("nothing of the figure '{figure}' can move: no degree of freedom is left that is not held")]
    NothingMoves {
        /// The figure.
        figure: String,
    },
    /// A trial without frames.
    #[error("the trial has no frame; record at least one")]
    NoFrames,
    /// A marker of a link that the figure does not have, or without a place.
    #[error("the marker '{name}' sits at {position} of link {link}, which is no place on this figure")]
    Marker {
        /// The marker.
        name: String,
        /// Its place.
        position: String,
        /// Its link.
        link: usize,
    },
    /// A weight that is none.
    #[error("the weight of '{name}' is {weight}; give 0 or more")]
    Weight {
        /// Marker or coordinate.
        name: String,
        /// Its weight.
        weight: f64,
    },
    /// A value that no coordinate can have, or bounds that are none.
    #[error("'{name}' cannot be held {value}; {why}")]
    Value {
        /// The coordinate.
        name: String,
        /// What was asked.
        value: String,
        /// Why not.
        why: &'static str,
    },
    /// A rest that is no configuration.
    #[error(transparent)]
    Rest(#[from] ConfigurationError),
    /// The figure cannot be computed with.
    #[error(transparent)]
    Figure(#[from] DynamicsError),
}
