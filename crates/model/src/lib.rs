#![doc = include_str!("../README.md")]

mod anatomy;
mod builder;
mod chains;
mod configuration;
mod euler;
mod fault;
mod figure;
mod fuse;
mod human;
mod inertia;
mod joint;
mod layout;
mod link;
mod motion;
mod reroot;

pub use anatomy::AnatomicalAngle;
pub use builder::{FigureBuilder, LinkSpec};
pub use chains::{Chain, Chains};
pub use configuration::ConfigurationError;
pub use euler::{BallState, EulerError, EulerOrder, EulerState, GimbalDistance};
pub use fault::{Fault, FigureError, nearest};
pub use figure::Figure;
pub use fuse::{FuseError, Fused, LinkPlace};
pub use human::{Human, HumanError, human};
pub use inertia::{Inertia, Shape, ShapeKind};
pub use joint::{Axis, AxisKind, Dof, Joint, JointKind, Limits, Placement};
pub use layout::{JointLayout, StateLayout};
pub use link::{Link, NamedFrame, SolePart, SolePoint};
pub use motion::{
    Contact, ContactTrack, DifferenceStep, Event, EventKind, Ground, Interval, Motion, MotionError,
    MotionInfo, Trajectory,
};
pub use reroot::{JointInView, RerootError, Rerooted, RootAt};

pub use nalgebra::{Isometry3, Matrix3, Rotation3, UnitQuaternion, Vector3};
