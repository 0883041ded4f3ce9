//! What a figure moves in: a fluid, and what carries links against gravity.

use crate::joint::Placement;
use nalgebra::Vector3;

/// A fluid that links move in, and what carries them against gravity.
///
/// Forces of it are `solaris_analysis::medium_forces`; a figure itself knows nothing of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Medium {
    /// Density of the fluid (kg/m³).
    pub density: f64,
    /// Its viscosity (Pa s).
    pub viscosity: f64,
    /// Its velocity (m/s, world axes).
    pub wind: Vector3<f64>,
    /// What it acts on.
    pub immersed: Vec<Immersed>,
    /// What is carried.
    pub carried: Vec<Carried>,
}

/// A solid of a link that a fluid acts on.
#[derive(Clone, Debug, PartialEq)]
pub struct Immersed {
    /// The link's name.
    pub link: String,
    /// The solid's centre and axes in the link's frame.
    pub at: Placement,
    /// What the fluid meets.
    pub shape: ImmersedShape,
}

/// What a fluid meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ImmersedShape {
    /// A box of these half sides (m).
    Box(Vector3<f64>),
    /// An ellipsoid.
    Ellipsoid {
        /// Its radii (m).
        radii: Vector3<f64>,
        /// Coefficients of drag of a blunt and a slender body, of drag in turning, of Kutta's and of Magnus' lift.
        coefficients: [f64; 5],
    },
}

/// What carries a link against gravity.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// The link's name.
    pub link: String,
    /// Where it is carried, in the link's frame (m).
    pub at: Vector3<f64>,
    /// The mass that is carried (kg).
    pub mass: f64,
}

impl Medium {
    /// Whether it acts on nothing.
    pub fn is_empty(&self) -> bool {
        self.immersed.is_empty() && self.carried.is_empty()
    }
}
