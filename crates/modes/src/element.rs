//! Passive elements of a scene, besides the springs and dampers that the figure's joints have of their own.

use nalgebra::Vector3;

/// A point of a link, or of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Index of the link; `None` for the world.
    pub link: Option<usize>,
    /// The point in the link's frame, or in the world (m).
    pub point: Vector3<f64>,
}

/// A spring and damper between two points.
///
/// ```text
/// F = k·(l − l₀) + c·l̇
/// ```
///
/// pulls the two towards each other along the line between them, `l` being their distance.
#[doc(alias = "spring-damper")]
#[doc(alias = "linear spring")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSpring {
    /// The two points.
    pub between: [Anchor; 2],
    /// `k` (N/m).
    pub stiffness: f64,
    /// `c` (N s/m).
    pub damping: f64,
    /// `l₀` (m).
    pub rest: f64,
}

/// Two points, and perhaps the axes of their links, that are held together: what closes a loop that the figure's tree has open.
///
/// By [`Method::Impulses`](crate::Method::Impulses) impulses hold it, and draw together what begins apart. By all other methods forces do, found
/// together with the accelerations, as exactly as the method is; they want it closed where a run begins.
#[doc(alias = "loop closure")]
#[doc(alias = "equality constraint")]
#[doc(alias = "connect")]
#[doc(alias = "weld")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loop {
    /// The two points.
    pub between: [Anchor; 2],
    /// What is held together.
    pub kind: LoopKind,
    /// From when on (s). What is taken hold of later loses the velocity between its ends in an instant, as in a plastic impact.
    pub from: f64,
    /// Until when (s), infinite for the rest of the run. Letting go changes no velocity.
    pub until: f64,
}

impl Loop {
    /// One that holds for the whole run.
    pub fn new(between: [Anchor; 2], kind: LoopKind) -> Self {
        Self { between, kind, from: 0.0, until: f64::INFINITY }
    }
}

/// What a [`Loop`] holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum LoopKind {
    /// The points; the links turn about them.
    Connect,
    /// The points, and the axes of both links as they stand to each other at the beginning.
    Weld,
}

/// What a joint's limits do to a degree of freedom that dynamics move.
#[doc(alias = "joint limit")]
#[doc(alias = "joint stop")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LimitLaw {
    /// Nothing.
    Ignore,
    /// They stop it: `v⁺ = −e·v⁻`, with the impulse that this takes.
    Hard {
        /// `e`, 0 to 1.
        restitution: f64,
    },
    /// They push back, `k·x + c·ẋ` at a depth `x`, and never pull.
    Spring {
        /// `k` (N m/rad or N/m).
        stiffness: f64,
        /// `c` (N m s/rad or N s/m).
        damping: f64,
    },
}

impl Default for LimitLaw {
    fn default() -> Self {
        Self::Hard { restitution: 0.0 }
    }
}
