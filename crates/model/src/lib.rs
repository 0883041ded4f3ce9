#![doc = include_str!("../README.md")]

mod actuator;
mod anatomy;
mod apart;
mod base;
mod builder;
mod chains;
mod configuration;
mod coupling;
mod curve;
mod euler;
mod fault;
mod figure;
mod follower;
mod fuse;
mod hull;
mod human;
mod inertia;
mod joint;
mod layout;
mod limits;
mod link;
mod lint;
mod load;
mod markers;
mod measured;
mod medium;
mod motion;
mod pose;
mod prune;
mod relief;
mod reroot;
pub mod rig;
mod scale;
mod source;
#[cfg(feature = "ron")]
pub mod text;
mod tie;
mod together;

pub use actuator::{Actuator, ActuatorLaw};
pub use anatomy::AnatomicalAngle;
pub use base::{Base, BaseError};
pub use builder::{FigureBuilder, LinkSpec};
pub use chains::{Chain, Chains};
pub use configuration::ConfigurationError;
pub use curve::Curve;
pub use euler::{BallState, EulerError, EulerOrder, EulerState, GimbalDistance};
pub use fault::{Fault, FigureError, Part};
pub use figure::Figure;
pub use follower::Follower;
pub use fuse::{FuseError, Fused, LinkPlace};
pub use hull::{GroundAxes, convex_hull};
pub use human::{Human, HumanError, Portion, RootOrder, human};
pub use inertia::{Inertia, Shape, ShapeKind};
pub use joint::{Axis, AxisKind, Dof, Follow, Joint, JointKind, Limits, Passive, Placement};
pub use layout::{JointLayout, StateLayout};
pub use limits::LimitExcess;
pub use link::{Link, NamedFrame, SolePart, SolePoint};
pub use lint::{Extent, MassDoubt};
pub use load::{Load, LoadError};
pub use markers::{Marker, MarkerTrial, MarkerTrialError};
pub use measured::MeasuredForce;
pub use medium::{Carried, Immersed, ImmersedShape, Medium};
pub use motion::{
    Contact, ContactTrack, DifferenceStep, Event, EventKind, Ground, Interval, Known, Motion, MotionError,
    MotionInfo, Trajectory,
};
pub use prune::{PruneError, Pruned};
pub use relief::{Relief, ReliefError};

pub use reroot::{JointInView, RerootError, Rerooted, RootAt};
pub use scale::{MassShares, ScaleError, Scaling, Stretching, stretched_inertia};
pub use source::SourceMap;

pub use nalgebra::{Isometry3, Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};
pub use solaris_text::{
    Finding, FindingKind, Place, Suggestion, TextError, TextFault, did_you_mean, is_unseen, nearest, plain,
};
pub use tie::{Tie, TieEnd, TieLaw};
