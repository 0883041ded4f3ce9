#![doc = include_str!("../README.md")]

mod direction;
mod dof;
mod energy;
mod error;
mod inverse;
mod kinematics;
mod mass_matrix;
mod matter;
mod momentum;
pub mod scalar;
mod spatial;
mod tree;
mod workspace;

pub use energy::{kinetic_energy, potential_energy};
pub use error::DynamicsError;
pub use inverse::{bias, inverse_dynamics};
pub use kinematics::{forward_kinematics, velocities};
pub use mass_matrix::mass_matrix;
pub use momentum::{center_of_mass, momentum};
pub use scalar::Real;
pub use spatial::{Momentum, Pose, Twist, Wrench};
pub use tree::Tree;
pub use workspace::Workspace;
