//! Joints: ordered lists of one-axis degrees of freedom.

use nalgebra::{Isometry3, Vector3};

/// Where a joint's frame stands in its parent link's frame when the joint is at zero: rotation and translation (m).
pub type Placement = Isometry3<f64>;

/// Whether a degree of freedom turns or slides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxisKind {
    /// Turns about the axis; its coordinate is in rad.
    Rotation,
    /// Slides along the axis; its coordinate is in m.
    Translation,
}

/// The axis of one degree of freedom, a unit vector in the frame that the degrees of freedom before it have moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Turning or sliding.
    pub kind: AxisKind,
    /// Direction, unit length in a built figure.
    pub direction: Vector3<f64>,
}

impl Axis {
    /// A rotation about `direction`, which the builder normalises.
    pub const fn rotation(direction: Vector3<f64>) -> Self {
        Self { kind: AxisKind::Rotation, direction }
    }

    /// A translation along `direction`, which the builder normalises.
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Smallest value.
    pub lower: f64,
    /// Largest value.
    pub upper: f64,
}

/// One degree of freedom of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dof {
    /// Its axis.
    pub axis: Axis,
    /// Its range, if it has one.
    pub limits: Option<Limits>,
}

/// What a joint lets its link do.
///
/// Ball and free joints, whose `nq` differs from their `nv`, will be further variants: nothing outside this crate may
/// assume that the two agree.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum JointKind {
    /// Zero (a weld) to six one-axis degrees of freedom, applied in order: the first is nearest to the parent.
    Axes(Vec<Dof>),
}

impl JointKind {
    /// Number of position coordinates.
    pub fn nq(&self) -> usize {
        match self {
            Self::Axes(dofs) => dofs.len(),
        }
    }

    /// Number of velocity coordinates.
    pub fn nv(&self) -> usize {
        match self {
            Self::Axes(dofs) => dofs.len(),
        }
    }

    /// The one-axis degrees of freedom, in order.
    pub fn axes(&self) -> &[Dof] {
        match self {
            Self::Axes(dofs) => dofs,
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
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    pub(crate) name: String,
    pub(crate) placement: Placement,
    pub(crate) kind: JointKind,
}

impl Joint {
    /// A weld called `name` at the parent's origin; add degrees of freedom with the methods below.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), placement: Placement::identity(), kind: JointKind::Axes(Vec::new()) }
    }

    /// Places the joint's centre in the parent's frame (m), the axes parallel to the parent's.
    pub fn at(mut self, origin: Vector3<f64>) -> Self {
        self.placement = Placement::translation(origin.x, origin.y, origin.z);
        self
    }

    /// Places the joint's frame in the parent's frame.
    pub fn placed(mut self, placement: Placement) -> Self {
        self.placement = placement;
        self
    }

    /// Adds a degree of freedom after those there already.
    pub fn axis(mut self, axis: Axis) -> Self {
        let JointKind::Axes(dofs) = &mut self.kind;
        dofs.push(Dof { axis, limits: None });
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

    /// Gives the degree of freedom added last a range (rad or m). Without one before it, nothing happens.
    pub fn limited(mut self, lower: f64, upper: f64) -> Self {
        let JointKind::Axes(dofs) = &mut self.kind;
        if let Some(dof) = dofs.last_mut() {
            dof.limits = Some(Limits { lower, upper });
        }
        self
    }

    /// Gives every axis that is a direction unit length.
    pub(crate) fn normalize_axes(&mut self) {
        let JointKind::Axes(dofs) = &mut self.kind;
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
