#![doc = include_str!("../README.md")]
#![allow(
    clippy::inline_always,
    reason = "what runs in vector registers is compiled whole, for the instructions at hand"
)]
// WebAssembly has one set of instructions; there the compiler chooses what to inline, and the engine is smaller by a fifth. So it does where
// things are tried, which run as fast and compile in a quarter of the time, for there are ten kinds of numbers. Hence
// `cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))` everywhere.

#[cfg(feature = "batch")]
pub mod batch;
mod coupling;
pub mod denavit_hartenberg;
mod derivatives;
mod error;
mod formulation;
mod forward;
mod fused;
mod inertia;
mod inverse;
mod kinematics;
pub mod lagrange;
mod passive;
mod root_view;
pub mod scalar;
mod spatial;
mod tree;
mod wide;
mod workspace;

pub use coupling::Coupling;
pub use derivatives::{Along, Derivatives, Operation, Partials};
pub use error::DynamicsError;
pub use formulation::{Formulation, InverseDynamics};
pub use forward::contact::{ContactConstraint, Contacts, contact_dynamics};
pub use forward::{forward_dynamics, hybrid_dynamics, inverse_mass_matrix};
pub use fused::{FusedForces, relink};
pub use inertia::centroidal::{
    CompositeBody, center_of_mass_jacobian, centroidal_momentum, centroidal_momentum_matrix,
    centroidal_momentum_rate, composite_body,
};
pub use inertia::coriolis::{coriolis_matrix, gravity_torques};
pub use inertia::energy::{kinetic_energy, potential_energy};
pub use inertia::mass_matrix::mass_matrix;
pub use inertia::momentum::{center_of_mass, momentum};
pub use inverse::ground::ground_acceleration;
pub use inverse::reacting::inverse_dynamics_with;
pub use inverse::reactions::joint_reactions;
pub use inverse::regressor::{INERTIAL_PARAMETERS, inertial_parameters, torque_regressor};
pub use inverse::{bias_forces, inverse_dynamics};
pub use kinematics::acceleration::{accelerations, bias_accelerations};
pub use kinematics::frame::Frame;
pub use kinematics::jacobian::{JacobianAxes, jacobian, jacobian_rate};
pub use kinematics::points::{joint_jacobians, point_columns};
pub use kinematics::{forward_kinematics, velocities};
pub use passive::{add_passive_forces, rotation_vector};
pub use root_view::{RootView, RootViewError};
pub use scalar::Scalar;
pub use spatial::{Momentum, Pose, Twist, Wrench};
pub use tree::Tree;
pub use workspace::Workspace;

pub use nalgebra::{DMatrix, IsometryMatrix3, Matrix3, Vector3};
