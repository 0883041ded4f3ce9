#![doc = include_str!("../README.md")]

mod acceleration;
mod articulated;
mod centroidal;
mod climb;
mod contact;
mod coriolis;
pub mod denavit_hartenberg;
mod derivatives;
mod direction;
mod dof;
mod energy;
mod error;
mod formulation;
mod forward;
mod frame;
mod fused;
mod ground;
mod inverse;
mod jacobian;
mod kinematics;
pub mod lagrange;
mod load;
mod mass_matrix;
mod matter;
mod momentum;
mod propagation;
mod reactions;
mod regressor;
mod root_view;
pub mod scalar;
mod spatial;
mod symmetric;
mod tree;
mod workspace;

pub use acceleration::{accelerations, drift};
pub use centroidal::{
    CompositeBody, center_of_mass_jacobian, centroidal_momentum, centroidal_momentum_matrix,
    centroidal_momentum_rate, composite_body,
};
pub use contact::{ContactConstraint, Contacts, contact_dynamics};
pub use coriolis::{coriolis_matrix, gravity_torques};
pub use derivatives::{Along, Derivatives, Operation, Partials};
pub use energy::{kinetic_energy, potential_energy};
pub use error::DynamicsError;
pub use formulation::{Formulation, InverseDynamics};
pub use forward::{forward_dynamics, hybrid_dynamics, inverse_mass_matrix};
pub use frame::Frame;
pub use fused::{FusedForces, relink};
pub use ground::ground_acceleration;
pub use inverse::{bias, inverse_dynamics};
pub use jacobian::{JacobianAxes, jacobian, jacobian_rate};
pub use kinematics::{forward_kinematics, velocities};
pub use mass_matrix::mass_matrix;
pub use momentum::{center_of_mass, momentum};
pub use reactions::joint_reactions;
pub use regressor::{INERTIAL_PARAMETERS, inertial_parameters, torque_regressor};
pub use root_view::{RootView, RootViewError};
pub use scalar::Real;
pub use spatial::{Momentum, Pose, Twist, Wrench};
pub use tree::Tree;
pub use workspace::Workspace;

pub use nalgebra::{DMatrix, IsometryMatrix3, Matrix3, Vector3};
