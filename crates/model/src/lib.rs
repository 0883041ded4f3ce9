//! Articulated figures and their motion, as plain data.
//!
//! A [`Figure`] is a tree of [`Link`]s, each moved against its parent by a [`Joint`]. It is **valid by construction and
//! immutable**: [`FigureBuilder::build`] finds everything that can be wrong, all at once, so that no layer above checks
//! again. [`human()`] gives a person of any height and mass. A [`Motion`] is what every planner hands on and every
//! exporter reads: samples of `q, v, a, tau`, contact wrenches and events.
//!
//! Units are SI throughout (m, kg, s, rad). Nothing here knows which way is up: that is the gravity of a motion.
//!
//! ```
//! use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
//!
//! let figure = FigureBuilder::new("pendulum")
//!     .link(LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0)))
//!     .build()?;
//! assert_eq!(figure.layout().nv(), 1);
//! assert_eq!(figure.layout().dof_index("pivot.rx"), Some(0));
//! assert_eq!(figure.layout().dof_index("pivot"), Some(0)); // a one-dof joint also answers to its name
//! # Ok::<(), solaris_model::FigureError>(())
//! ```

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
