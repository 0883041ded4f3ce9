//! Links: the rigid bodies of a figure.

use crate::inertia::Shape;
use crate::joint::{Joint, Placement};
use nalgebra::{Matrix3, Vector3};

/// A named point of a sole.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SolePart {
    /// Hindmost point of the foot.
    Heel,
    /// Below the joint between foot and toes (the metatarsal heads).
    Ball,
    /// Foremost point.
    ToeTip,
}

/// A point that can touch the ground, in its link's frame (m).
#[doc(alias = "contact point")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolePoint {
    /// Which part of the sole it is.
    pub part: SolePart,
    /// Where it is.
    pub position: Vector3<f64>,
}

/// A frame fixed to a link.
#[doc(alias = "site")]
#[doc(alias = "operational frame")]
#[derive(Clone, Debug, PartialEq)]
pub struct NamedFrame {
    /// Its name, unique in the figure.
    pub name: String,
    /// Where it stands in the link's frame.
    pub placement: Placement,
}

/// A rigid body of a built figure, with the joint that moves it against its parent.
///
/// The link's frame is the joint's frame after the joint has moved.
#[doc(alias = "body")]
#[doc(alias = "bone")]
#[doc(alias = "segment")]
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    pub(crate) name: String,
    pub(crate) parent: Option<usize>,
    pub(crate) joint: Joint,
    pub(crate) mass: f64,
    pub(crate) com: Vector3<f64>,
    pub(crate) inertia: Matrix3<f64>,
    pub(crate) shape: Option<Shape>,
    pub(crate) tip: Option<Vector3<f64>>,
    pub(crate) sole: Vec<SolePoint>,
    pub(crate) frames: Vec<NamedFrame>,
}

impl Link {
    /// The link's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Index of the parent link, always smaller than this link's own; `None` for the root, whose parent is the world.
    pub fn parent(&self) -> Option<usize> {
        self.parent
    }

    /// The joint between the parent and this link.
    pub fn joint(&self) -> &Joint {
        &self.joint
    }

    /// Mass (kg), zero or more.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Centre of mass in the link's frame (m).
    #[doc(alias = "center of mass")]
    pub fn com(&self) -> &Vector3<f64> {
        &self.com
    }

    /// Rotational inertia about the centre of mass, along the link's axes (kg m²), symmetric.
    pub fn inertia(&self) -> &Matrix3<f64> {
        &self.inertia
    }

    /// What the link looks like, for drawing; its inertia need not be that of the shape.
    pub fn shape(&self) -> Option<&Shape> {
        self.shape.as_ref()
    }

    /// The far end of an end-effector, in the link's frame (m).
    pub fn tip(&self) -> Option<&Vector3<f64>> {
        self.tip.as_ref()
    }

    /// The points of the link that can touch the ground.
    pub fn sole(&self) -> &[SolePoint] {
        &self.sole
    }

    /// A point of the sole, in the link's frame (m).
    pub fn sole_point(&self, part: SolePart) -> Option<&Vector3<f64>> {
        self.sole.iter().find(|point| point.part == part).map(|point| &point.position)
    }

    /// The named frames fixed to the link.
    pub fn frames(&self) -> &[NamedFrame] {
        &self.frames
    }
}
