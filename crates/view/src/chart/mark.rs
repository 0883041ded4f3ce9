//! Marks of points.

use super::SERIES;

/// How a point is marked; its colour and shape are those of its series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A filled shape.
    Filled,
    /// The shape's outline.
    Hollow,
    /// A cross: what came to nothing.
    Failed,
}

/// Square, triangles, circle, diamond, plus.
const SHAPES: [&str; SERIES] = [
    "M-4.3-4.3H4.3V4.3H-4.3Z",
    "M0-5.4L5.4 4.3H-5.4Z",
    "M0 5.4L5.4-4.3H-5.4Z",
    "M-4.8 0A4.8 4.8 0 1 0 4.8 0A4.8 4.8 0 1 0-4.8 0Z",
    "M0-6L6 0L0 6L-6 0Z",
    "M-2-5.4H2V-2H5.4V2H2V5.4H-2V2H-5.4V-2H-2Z",
];

impl Mark {
    /// Class and path about the origin.
    pub(super) fn look(self, series: usize) -> (String, &'static str) {
        let series = series % SERIES;
        match self {
            Self::Filled => (format!("mark f{series}"), SHAPES[series]),
            Self::Hollow => (format!("hollow s{series}"), SHAPES[series]),
            Self::Failed => (format!("failed s{series}"), "M-4-4L4 4M-4 4L4-4"),
        }
    }
}
