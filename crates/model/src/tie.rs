//! What files hold together that a tree of links cannot.

use nalgebra::Vector3;

/// Two points that a file holds together: what closes a loop that the figure's tree has open.
#[doc(alias = "equality constraint")]
#[doc(alias = "loop closure")]
#[derive(Clone, Debug, PartialEq)]
pub struct Tie {
    /// What the file calls it.
    pub name: String,
    /// Its two ends.
    pub between: [TieEnd; 2],
    /// What is held together.
    pub law: TieLaw,
}

/// A point of a link, or of the world.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TieEnd {
    /// Name of the link; `None` for the world.
    pub link: Option<String>,
    /// The point in the link's frame, or in the world (m).
    pub point: Vector3<f64>,
}

/// What a [`Tie`] holds together.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum TieLaw {
    /// The points; the links turn about them.
    Points,
    /// The points, and the axes of both links as they stand to each other.
    Axes,
    /// Something else, by the words of the file.
    Other(String),
}
