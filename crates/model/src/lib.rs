#![doc = include_str!("../README.md")]

mod anatomy;
mod builder;
mod fault;
mod figure;
mod human;
mod inertia;
mod joint;
mod layout;
mod link;
mod motion;

pub use anatomy::AnatomicalAngle;
pub use builder::{FigureBuilder, LinkSpec};
pub use fault::{Fault, FigureError};
pub use figure::Figure;
pub use human::{Human, HumanError, human};
pub use inertia::{Inertia, Shape, ShapeKind};
pub use joint::{Axis, AxisKind, Dof, Joint, JointKind, Limits, Placement};
pub use layout::{JointLayout, StateLayout};
pub use link::{Link, NamedFrame, SolePart, SolePoint};
pub use motion::{
    Contact, ContactTrack, DifferenceStep, Event, EventKind, Ground, Interval, Motion, MotionError,
    MotionInfo, Trajectory,
};

pub use nalgebra::{Isometry3, Matrix3, Rotation3, Vector3};
