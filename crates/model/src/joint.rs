//! Joints: ordered lists of one-axis degrees of freedom, ball joints and free joints.

use crate::curve::Curve;
use nalgebra::{Isometry3, Vector3};

/// The placement of a joint's frame in its parent link's frame when the joint is at zero: rotation and translation (m).
#[doc(alias = "SE3")]
#[doc(alias = "origin")]
pub type Placement = Isometry3<f64>;

/// The kind of an axis: whether its degree of freedom turns or slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxisKind {
    /// Turns about the axis; its coordinate is in rad.
    Rotation,
    /// Slides along the axis; its coordinate is in m.
    Translation,
}

/// The axis of one degree of freedom, a unit vector in the frame that the degrees of freedom before it have moved.
#[doc(alias = "revolute")]
#[doc(alias = "prismatic")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Turning or sliding.
    pub kind: AxisKind,
    /// Direction, unit length in a built figure.
    pub direction: Vector3<f64>,
}

impl Axis {
    /// A rotation about `direction`, which the builder normalises.
    #[doc(alias = "revolute")]
    #[doc(alias = "hinge")]
    pub const fn rotation(direction: Vector3<f64>) -> Self {
        Self { kind: AxisKind::Rotation, direction }
    }

    /// A translation along `direction`, which the builder normalises.
    #[doc(alias = "prismatic")]
    #[doc(alias = "slider")]
    pub const fn translation(direction: Vector3<f64>) -> Self {
        Self { kind: AxisKind::Translation, direction }
    }

    /// The stem of the degree of freedom's name: `rx … tz` for a coordinate axis, `r` or `t` for any other.
    pub(crate) fn stem(&self) -> &'static str {
        let coordinate = [Vector3::x(), Vector3::y(), Vector3::z()].iter().position(|e| self.direction == *e);
        match (self.kind, coordinate) {
            (AxisKind::Rotation, Some(0)) => "rx",
            (AxisKind::Rotation, Some(1)) => "ry",
            (AxisKind::Rotation, Some(_)) => "rz",
            (AxisKind::Rotation, None) => "r",
            (AxisKind::Translation, Some(0)) => "tx",
            (AxisKind::Translation, Some(1)) => "ty",
            (AxisKind::Translation, Some(_)) => "tz",
            (AxisKind::Translation, None) => "t",
        }
    }
}

/// The interval that a coordinate is meant to stay in (rad or m).
#[doc(alias = "joint limits")]
#[doc(alias = "range")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Smallest value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
}

/// The passive forces of a degree of freedom: a spring, a damper, dry friction.
///
/// ```text
/// τ = stiffness·(q − rest) + damping·v + friction·sign(v)
/// ```
///
/// is what a motion needs against it, besides what the links need.
#[doc(alias = "stiffness")]
#[doc(alias = "damping")]
#[doc(alias = "friction")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passive {
    /// Of the spring (N m/rad or N/m).
    pub stiffness: f64,
    /// The coordinate at which the spring is at rest (rad or m).
    pub rest: f64,
    /// Of the damper (N m s/rad or N s/m).
    pub damping: f64,
    /// Dry friction (N m or N).
    pub friction: f64,
}

impl Passive {
    /// Whether nothing acts.
    pub fn is_none(&self) -> bool {
        [self.stiffness, self.damping, self.friction].iter().all(|x| x.abs() == 0.0)
    }
}

/// The tie of a degree of freedom to another one of the figure: see [`crate::Follower`].
#[derive(Clone, Debug, PartialEq)]
pub struct Follow {
    /// Name of the degree of freedom that leads.
    pub dof: String,
    /// The follower's coordinate over that of its leader.
    pub curve: Curve,
}

/// One degree of freedom of a joint.
#[doc(alias = "DoF")]
#[doc(alias = "degree of freedom")]
#[doc(alias = "coordinate")]
#[derive(Clone, Debug, PartialEq)]
pub struct Dof {
    /// Its axis.
    pub axis: Axis,
    /// Its range, if it has one.
    pub limits: Option<Limits>,
    /// Inertia of what turns or slides with the coordinate besides the links, such as a rotor seen through its gear
    /// (kg m² or kg): it adds to the diagonal of the mass matrix.
    pub armature: f64,
    /// Its name where it has one of its own; otherwise it is called `joint.axis`.
    pub name: Option<String>,
    /// Spring, damper, friction.
    pub passive: Passive,
    /// What it follows, where it has no freedom of its own.
    pub follows: Option<Follow>,
}

/// The kind of a joint: which motions it lets its link have.
///
/// Ball and free joints have more position coordinates (`nq`) than velocity coordinates (`nv`): a unit quaternion
/// (x, y, z, w) turns link coordinates into those of the joint's frame. Their velocities are along the **link's own** axes.
#[doc(alias = "JointType")]
#[doc(alias = "revolute")]
#[doc(alias = "prismatic")]
#[doc(alias = "spherical")]
#[doc(alias = "free flyer")]
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum JointKind {
    /// Zero (a weld) to six one-axis degrees of freedom, applied in order: the first is nearest to the parent.
    Axes(Vec<Dof>),
    /// Any rotation: `q` is a unit quaternion, `v` the angular velocity (rad/s) along the link's axes.
    Ball {
        /// Added to each of the three diagonal entries of the mass matrix (kg m²).
        armature: f64,
        /// Acts on the angular velocity, and with its stiffness on the rotation vector from the neutral orientation.
        passive: Passive,
    },
    /// Any motion: `q` is the place of the link's origin in the joint's frame (m), then a unit quaternion; `v` the
    /// velocity of the link's origin (m/s), then the angular velocity (rad/s), both along the link's axes.
    Free {
        /// Added to each of the six diagonal entries of the mass matrix (kg, kg m²).
        armature: f64,
        /// Acts on all six velocities; a free joint has no spring.
        passive: Passive,
    },
}

impl JointKind {
    /// Number of position coordinates.
    pub fn nq(&self) -> usize {
        match self {
            Self::Axes(dofs) => dofs.len(),
            Self::Ball { .. } => 4,
            Self::Free { .. } => 7,
        }
    }

    /// Number of velocity coordinates.
    pub fn nv(&self) -> usize {
        match self {
            Self::Axes(dofs) => dofs.len(),
            Self::Ball { .. } => 3,
            Self::Free { .. } => 6,
        }
    }

    /// The one-axis degrees of freedom, in order; none for a ball or free joint.
    pub fn axes(&self) -> &[Dof] {
        match self {
            Self::Axes(dofs) => dofs,
            Self::Ball { .. } | Self::Free { .. } => &[],
        }
    }

    /// Where in the joint's `q` its unit quaternion (x, y, z, w) begins, if it has one.
    pub fn quaternion(&self) -> Option<usize> {
        match self {
            Self::Axes(_) => None,
            Self::Ball { .. } => Some(0),
            Self::Free { .. } => Some(3),
        }
    }

    /// Where in the joint's `q` its slides (m) are.
    pub fn slides(&self) -> impl Iterator<Item = usize> + '_ {
        let count = match self {
            Self::Axes(dofs) => dofs.len(),
            Self::Ball { .. } => 0,
            Self::Free { .. } => 3,
        };
        (0..count).filter(move |i| match self {
            Self::Axes(dofs) => dofs[*i].axis.kind == AxisKind::Translation,
            Self::Ball { .. } | Self::Free { .. } => true,
        })
    }

    /// Whether it places what hangs on it, rather than hold it as a hinge does: it is free, or it slides along two axes at least and turns
    /// besides.
    pub fn is_floating(&self) -> bool {
        let slides = self.slides().count();
        matches!(self, Self::Free { .. }) || (slides >= 2 && self.axes().len() > slides)
    }

    /// What the velocity coordinate `index` of this joint adds to the diagonal of the mass matrix (kg or kg m²).
    #[doc(alias = "rotor inertia")]
    #[doc(alias = "reflected inertia")]
    pub fn armature(&self, index: usize) -> f64 {
        match self {
            Self::Axes(dofs) => dofs[index].armature,
            Self::Ball { armature, .. } | Self::Free { armature, .. } => *armature,
        }
    }

    /// What acts on the velocity coordinate `index` of this joint.
    pub fn passive(&self, index: usize) -> &Passive {
        match self {
            Self::Axes(dofs) => &dofs[index].passive,
            Self::Ball { passive, .. } | Self::Free { passive, .. } => passive,
        }
    }
}

/// A named joint: what moves a link against its parent.
///
/// ```
/// use solaris_model::{Joint, Vector3};
/// // A hip in the order Z-Y-X (bend, twist, flexion), 9 cm to the left of the pelvis' origin.
/// let hip = Joint::new("left_hip").at(Vector3::new(0.09, -0.08, 0.0)).rz().ry().rx().limited(-2.1, 0.5);
/// assert_eq!(hip.kind().nv(), 3);
/// ```
#[doc(alias = "JointModel")]
#[doc(alias = "articulation")]
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    pub(crate) name: String,
    pub(crate) placement: Placement,
    pub(crate) kind: JointKind,
    /// What was asked of it that its kind does not take.
    pub(crate) misfits: Vec<&'static str>,
}

impl Joint {
    /// The most degrees of freedom of a joint.
    pub const MOST_DOFS: usize = 6;

    /// A weld called `name` at the parent's origin; add degrees of freedom with the methods below.
    pub fn new(name: impl Into<String>) -> Self {
        Self::of_kind(name.into(), JointKind::Axes(Vec::new()))
    }

    /// A ball joint called `name` at the parent's origin: see [`JointKind::Ball`].
    #[doc(alias = "spherical")]
    pub fn ball(name: impl Into<String>) -> Self {
        Self::of_kind(name.into(), JointKind::Ball { armature: 0.0, passive: Passive::default() })
    }

    /// A free joint called `name` at the parent's origin: see [`JointKind::Free`].
    #[doc(alias = "floating")]
    #[doc(alias = "free flyer")]
    #[doc(alias = "six degrees of freedom")]
    pub fn free(name: impl Into<String>) -> Self {
        Self::of_kind(name.into(), JointKind::Free { armature: 0.0, passive: Passive::default() })
    }

    fn of_kind(name: String, kind: JointKind) -> Self {
        Self { name, placement: Placement::identity(), kind, misfits: Vec::new() }
    }

    /// Places the joint's centre in the parent's frame (m); its axes stay as they are, parallel to the parent's where
    /// nothing else was said.
    pub fn at(mut self, origin: Vector3<f64>) -> Self {
        self.placement.translation.vector = origin;
        self
    }

    /// Places the joint's frame in the parent's frame.
    pub fn placed(mut self, placement: Placement) -> Self {
        self.placement = placement;
        self
    }

    /// Adds a degree of freedom after those there already.
    pub fn axis(mut self, axis: Axis) -> Self {
        match &mut self.kind {
            JointKind::Axes(dofs) => {
                let (limits, name, follows) = (None, None, None);
                dofs.push(Dof { axis, limits, armature: 0.0, name, passive: Passive::default(), follows });
            }
            _ => self.misfits.push("an axis"),
        }
        self
    }

    /// Adds a rotation about x.
    pub fn rx(self) -> Self {
        self.axis(Axis::rotation(Vector3::x()))
    }

    /// Adds a rotation about y.
    pub fn ry(self) -> Self {
        self.axis(Axis::rotation(Vector3::y()))
    }

    /// Adds a rotation about z.
    pub fn rz(self) -> Self {
        self.axis(Axis::rotation(Vector3::z()))
    }

    /// Adds a translation along x.
    pub fn tx(self) -> Self {
        self.axis(Axis::translation(Vector3::x()))
    }

    /// Adds a translation along y.
    pub fn ty(self) -> Self {
        self.axis(Axis::translation(Vector3::y()))
    }

    /// Adds a translation along z.
    pub fn tz(self) -> Self {
        self.axis(Axis::translation(Vector3::z()))
    }

    /// Gives the degree of freedom added last a range (rad or m).
    pub fn limited(self, lower: f64, upper: f64) -> Self {
        self.with_last("limits", |dof| dof.limits = Some(Limits { lower, upper }))
    }

    /// Gives the degree of freedom added last a name of its own, in place of `joint.axis`.
    pub fn named(self, name: impl Into<String>) -> Self {
        self.with_last("a name for a dof", |dof| dof.name = Some(name.into()))
    }

    /// Gives the degree of freedom added last, or every one of a ball or free joint, an armature (kg m² or kg).
    pub fn armature(mut self, inertia: f64) -> Self {
        match &mut self.kind {
            JointKind::Ball { armature, .. } | JointKind::Free { armature, .. } => *armature = inertia,
            JointKind::Axes(_) => return self.with_last("an armature", |dof| dof.armature = inertia),
        }
        self
    }

    /// Gives the degree of freedom added last, or every one of a ball or free joint, a spring, a damper, friction.
    pub fn passive(mut self, acts: Passive) -> Self {
        match &mut self.kind {
            JointKind::Ball { passive, .. } | JointKind::Free { passive, .. } => *passive = acts,
            JointKind::Axes(_) => return self.with_last("a spring or damper", |dof| dof.passive = acts),
        }
        self
    }

    /// Makes the degree of freedom added last follow the one called `dof`, along `curve`: see [`crate::Follower`].
    #[doc(alias = "mimic")]
    pub fn following(self, dof: impl Into<String>, curve: Curve) -> Self {
        self.with_last("a leader", |last| last.follows = Some(Follow { dof: dof.into(), curve }))
    }

    /// Changes the degree of freedom added last; a joint without one cannot take `what`.
    fn with_last(mut self, what: &'static str, change: impl FnOnce(&mut Dof)) -> Self {
        match &mut self.kind {
            JointKind::Axes(dofs) if !dofs.is_empty() => {
                let last = dofs.len() - 1;
                change(&mut dofs[last]);
            }
            _ => self.misfits.push(what),
        }
        self
    }

    /// Gives every axis that is a direction unit length.
    pub(crate) fn normalize_axes(&mut self) {
        let JointKind::Axes(dofs) = &mut self.kind else { return };
        for dof in dofs {
            if let Some(unit) =
                dof.axis.direction.try_normalize(1e-12).filter(|unit| unit.iter().all(|x| x.is_finite()))
            {
                dof.axis.direction = unit;
            }
        }
    }

    /// The joint's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where its frame stands in the parent's frame at zero.
    pub fn placement(&self) -> &Placement {
        &self.placement
    }

    /// What it lets its link do.
    pub fn kind(&self) -> &JointKind {
        &self.kind
    }
}
