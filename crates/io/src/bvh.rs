//! BVH: the skeleton animation that every 3D tool opens.
//!
//! BVH names no unit and no axes. What is written here is right-handed with **y up**, as most tools expect (x left and z
//! forward for a generated human), and **1 unit = 1 cm** unless another [`Unit`] is asked for. Angles are in degrees.
//!
//! - A `JOINT` is a link; its channels turn in the joint's own order (`Zrotation Yrotation Xrotation` for Z-Y-X), written
//!   from the parent outwards. Axes that a joint lacks follow with zeros, because many readers want three.
//! - A ball or free joint turns in the order Z-Y-X, its angles found from its quaternion so that they go on from frame to frame.
//! - Angles are those of the motion: never wrapped, so they run past 180° without a flip.
//! - The root has three position channels, in world coordinates, and no offset.
//! - Held are ball joints and joints that turn at most once about each of x, y, z (or against them), without a turned placement,
//!   below a root that may be free or slide before it turns. Any other joint is refused by name.
//! - An end-effector ends at its tip; a link without one ends in a stub of 5 cm towards its centre of mass.
//! - Velocities, forces, contacts and events have no place in BVH.

mod skeleton;
mod write;

pub use write::write;

/// What one unit of length of the file is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unit {
    /// 1 unit = 1 cm, what most tools assume.
    #[default]
    Centimetres,
    /// 1 unit = 1 m.
    Metres,
    /// 1 unit = 1 inch (2.54 cm).
    Inches,
}

impl Unit {
    /// Units of the file in one metre (1/m).
    pub fn per_metre(self) -> f64 {
        match self {
            Self::Centimetres => 100.0,
            Self::Metres => 1.0,
            Self::Inches => 1.0 / 0.0254,
        }
    }
}
