//! The faults of a figure, and the error that lists them.

use crate::figure::Figure;
use nalgebra::Vector3;
use std::fmt;

/// One fault of a figure: the thing, its value, why it cannot be, and what to do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum Fault {
    #[error("the figure has no links; add at least a root link")]
    Empty,
    #[error(
        "stature {stature} m: a standing height is a number above zero, and at most {:e}",
        Figure::LONGEST
    )]
    Stature { stature: f64 },
    #[error("gravity is ({:?}, {:?}, {:?}) m/s²; it must be three finite numbers", .gravity[0], .gravity[1], .gravity[2])]
    Gravity { gravity: [f64; 3] },
    #[error("no link is a root: every link names a parent; make one of them the root")]
    NoRoot,
    #[error("links {} are all roots; a figure has one root: give the others a parent", quoted(.links))]
    ManyRoots { links: Vec<String> },
    #[error("links {} are each other's ancestors (a cycle); one of them needs a parent outside of it", quoted(.links))]
    Cycle { links: Vec<String> },
    #[error("{kind} name '{name}' is used {count} times; names must be unique: rename all but one")]
    DuplicateName { kind: &'static str, name: String, count: usize },
    #[error("{kind} {index} has an empty name; give it one")]
    EmptyName { kind: &'static str, index: usize },
    #[error("link '{link}' names the parent '{parent}', which is not a link of this figure{}", hint(.nearest.as_ref()))]
    UnknownParent { link: String, parent: String, nearest: Option<String> },
    #[error("link '{link}': {what} is {value}; it must be a finite number")]
    NotFinite { link: String, what: String, value: f64 },
    #[error(
        "link '{link}': {what} is {value:e} m; it must be at most {:e}: are its units right?",
        Figure::LONGEST
    )]
    TooLong { link: String, what: String, value: f64 },
    #[error(
        "link '{link}': mass is {mass:e} kg; it must be at most {:e}: are its units right?",
        Figure::HEAVIEST
    )]
    TooHeavy { link: String, mass: f64 },
    #[error("link '{link}': mass is {mass} kg; it must be zero or more")]
    NegativeMass { link: String, mass: f64 },
    #[error(
        "link '{link}': the inertia is not symmetric: {row}{column} and {column}{row} differ by {difference:e} kg m²"
    )]
    InertiaNotSymmetric { link: String, row: char, column: char, difference: f64 },
    #[error("link '{link}': {what} of its shape is {value} m; it must be more than zero")]
    ShapeNotPositive { link: String, what: &'static str, value: f64 },
    #[error("joint '{joint}': axis {index} is ({:?}, {:?}, {:?}), which is no direction", .axis[0], .axis[1], .axis[2])]
    ZeroAxis { joint: String, index: usize, axis: [f64; 3] },
    #[error(
        "link '{link}': the rotation of its {what} is no rotation, its quaternion has the length {length}; it must be 1"
    )]
    NotRotation { link: String, what: String, length: f64 },
    #[error(
        "dof '{dof}': limits {lower} to {upper} are no range; they must be numbers, the lower not above the upper"
    )]
    LimitsReversed { dof: String, lower: f64, upper: f64 },
    #[error(
        "joint '{joint}' has {count} degrees of freedom; a joint has at most six: split it with a massless link"
    )]
    TooManyDofs { joint: String, count: usize },
    #[error(
        "joint '{joint}' was given {what}, which it cannot take: a ball or free joint has none, and a joint of axes needs \
         the axis first"
    )]
    NotForThisJoint { joint: String, what: &'static str },
    #[error("dof '{dof}': armature is {armature}; it must be a finite number, zero or more (kg m² or kg)")]
    Armature { dof: String, armature: f64 },
    #[error("dof '{dof}': {what} is {value}; it must be a finite number{rule}")]
    Passive { dof: String, what: &'static str, value: f64, rule: &'static str },
    #[error("dof '{dof}' follows '{leader}', which is not a coordinate of this figure{}", hint(.nearest.as_ref()))]
    UnknownLeader { dof: String, leader: String, nearest: Option<String> },
    #[error("dof '{dof}' follows '{leader}', which follows another one itself; let both follow that one")]
    FollowsFollower { dof: String, leader: String },
    #[error("dof '{dof}' follows '{leader}' along a curve that is none: {why}")]
    Curve { dof: String, leader: String, why: String },
    #[error("anatomical angle '{angle}' names the dof '{dof}', which is not a dof of this figure{}", hint(.nearest.as_ref()))]
    UnknownDof { angle: String, dof: String, nearest: Option<String> },
}

/// A part of a figure that a fault can be about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// The figure itself.
    Figure,
    /// A link.
    Link,
    /// A joint.
    Joint,
    /// A degree of freedom.
    Dof,
    /// A named frame.
    Frame,
    /// A named angle.
    Angle,
}

impl Fault {
    /// What is wrong with a gravity, if anything is.
    pub(crate) fn of_gravity(gravity: &Vector3<f64>) -> Option<Self> {
        let bad = gravity.iter().any(|x| !x.is_finite());
        bad.then(|| Self::Gravity { gravity: (*gravity).into() })
    }

    /// The part of the figure that the fault is about, its name, and the field of it, or an empty one.
    pub fn subject(&self) -> (Part, &str, &'static str) {
        fn first(names: &[String]) -> &str {
            names.first().map_or("", String::as_str)
        }
        match self {
            Self::Empty | Self::NoRoot => (Part::Figure, "", "links"),
            Self::Stature { .. } => (Part::Figure, "", "stature"),
            Self::Gravity { .. } => (Part::Figure, "", "gravity"),
            Self::ManyRoots { links } => (Part::Link, links.last().map_or("", String::as_str), "parent"),
            Self::Cycle { links } => (Part::Link, first(links), "parent"),
            Self::DuplicateName { kind, name, .. } => (part(kind), name, "name"),
            Self::EmptyName { kind, .. } => (part(kind), "", "name"),
            Self::UnknownParent { link, .. } => (Part::Link, link, "parent"),
            Self::NotFinite { link, what, .. }
            | Self::NotRotation { link, what, .. }
            | Self::TooLong { link, what, .. } => (Part::Link, link, field(what)),
            Self::NegativeMass { link, .. } | Self::TooHeavy { link, .. } => (Part::Link, link, "mass"),
            Self::InertiaNotSymmetric { link, .. } => (Part::Link, link, "inertia"),
            Self::ShapeNotPositive { link, .. } => (Part::Link, link, "shape"),
            Self::ZeroAxis { joint, .. }
            | Self::TooManyDofs { joint, .. }
            | Self::NotForThisJoint { joint, .. } => (Part::Joint, joint, ""),
            Self::LimitsReversed { dof, .. } => (Part::Dof, dof, "limits"),
            Self::Armature { dof, .. } => (Part::Dof, dof, "armature"),
            Self::Passive { dof, what, .. } => (Part::Dof, dof, what),
            Self::UnknownLeader { dof, .. } | Self::FollowsFollower { dof, .. } | Self::Curve { dof, .. } => {
                (Part::Dof, dof, "follows")
            }
            Self::UnknownDof { angle, .. } => (Part::Angle, angle, ""),
        }
    }
}

fn part(kind: &str) -> Part {
    match kind {
        "link" => Part::Link,
        "joint" => Part::Joint,
        "frame" => Part::Frame,
        "angle" => Part::Angle,
        _ => Part::Dof,
    }
}

/// The field of a link that a number belongs to.
fn field(what: &str) -> &'static str {
    match what {
        "mass" => "mass",
        "centre of mass" => "com",
        "inertia" => "inertia",
        "tip" => "tip",
        "joint origin" => "joint",
        _ if what.ends_with("of its shape") => "shape",
        _ if what.starts_with("sole") => "sole",
        _ => "frames",
    }
}

fn quoted(names: &[String]) -> String {
    names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ")
}

fn hint(nearest: Option<&String>) -> String {
    nearest.map_or_else(String::new, |name| format!("; did you mean '{name}'?"))
}

/// The error of a figure: everything that is wrong with it, all at once.
#[derive(Clone, Debug, PartialEq)]
pub struct FigureError {
    /// The figure's name.
    pub figure: String,
    /// Its faults, at least one.
    pub faults: Vec<Fault>,
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.faults.len();
        let faults = if count == 1 { "1 fault".to_owned() } else { format!("{count} faults") };
        write!(f, "figure '{}' has {faults}:", self.figure)?;
        self.faults.iter().try_for_each(|fault| write!(f, "\n  - {fault}"))
    }
}

impl std::error::Error for FigureError {}
