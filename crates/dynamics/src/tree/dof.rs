//! Degrees of freedom, and how a recursion steps over one or over three.

use crate::scalar::Scalar;
use crate::spatial::direction::Moved;
use nalgebra::Vector3;
use solaris_model::{Axis, AxisKind, EulerOrder};

/// One degree of freedom.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dof<T> {
    pub(crate) kind: Kind,
    /// −1 where the axis points against its coordinate axis, otherwise 1.
    pub(crate) sign: T,
    /// The unit vector along the axis, its sign included.
    pub(crate) axis: Vector3<T>,
    /// Its coordinate's place in `q`.
    pub(crate) q: usize,
    /// Its place among the axes that need a rotation matrix.
    pub(crate) slot: usize,
    /// Whether it slides, or a later one of its joint does, so that its rate gives the link's origin a velocity.
    pub(crate) has_lever: bool,
    /// Inertia that turns or slides with it besides the links'.
    pub(crate) armature: T,
}

/// Turning or sliding, along which axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    TurnX,
    TurnY,
    TurnZ,
    TurnSkew,
    SlideX,
    SlideY,
    SlideZ,
    SlideSkew,
}

/// The order of the three turns about different coordinate axes that a joint's degrees of freedom end with, if they do, the axes
/// pointing along the coordinate axes: what most joints of living things are. The recursions step over them at once; the
/// formula of each turn is the same.
pub(crate) fn triple<T: Scalar>(dofs: &[Dof<T>]) -> Option<EulerOrder> {
    let last = dofs.last_chunk::<3>()?;
    if last.iter().any(|dof| dof.sign != T::one()) {
        return None;
    }
    match last.map(|dof| dof.kind) {
        [Kind::TurnX, Kind::TurnY, Kind::TurnZ] => Some(EulerOrder::Xyz),
        [Kind::TurnX, Kind::TurnZ, Kind::TurnY] => Some(EulerOrder::Xzy),
        [Kind::TurnY, Kind::TurnX, Kind::TurnZ] => Some(EulerOrder::Yxz),
        [Kind::TurnY, Kind::TurnZ, Kind::TurnX] => Some(EulerOrder::Yzx),
        [Kind::TurnZ, Kind::TurnX, Kind::TurnY] => Some(EulerOrder::Zxy),
        [Kind::TurnZ, Kind::TurnY, Kind::TurnX] => Some(EulerOrder::Zyx),
        _ => None,
    }
}

/// Runs a formula with `$a`, `$b`, `$c` as the directions of `$triple`.
macro_rules! along_three {
    ($triple:expr, |$a:ident, $b:ident, $c:ident| $formula:expr) => {{
        use solaris_model::EulerOrder;
        use $crate::spatial::direction::Along;
        let (x, y, z) = (Along::<0>, Along::<1>, Along::<2>);
        match $triple {
            EulerOrder::Xyz => {
                let ($a, $b, $c) = (x, y, z);
                $formula
            }
            EulerOrder::Xzy => {
                let ($a, $b, $c) = (x, z, y);
                $formula
            }
            EulerOrder::Yxz => {
                let ($a, $b, $c) = (y, x, z);
                $formula
            }
            EulerOrder::Yzx => {
                let ($a, $b, $c) = (y, z, x);
                $formula
            }
            EulerOrder::Zxy => {
                let ($a, $b, $c) = (z, x, y);
                $formula
            }
            EulerOrder::Zyx => {
                let ($a, $b, $c) = (z, y, x);
                $formula
            }
        }
    }};
}
pub(crate) use along_three;

/// Runs one of two formulas with `$e` as the direction of the degree of freedom `$dof`.
macro_rules! along {
    ($dof:expr, $rotations:expr, |$e:ident| turn $turn:expr, slide $slide:expr) => {{
        use $crate::spatial::direction::{Along, GeneralAxis};
        use $crate::tree::dof::Kind;
        let dof = $dof;
        match dof.kind {
            Kind::TurnX => {
                let $e = Along::<0>;
                $turn
            }
            Kind::TurnY => {
                let $e = Along::<1>;
                $turn
            }
            Kind::TurnZ => {
                let $e = Along::<2>;
                $turn
            }
            Kind::TurnSkew => {
                let $e = GeneralAxis { axis: &dof.axis, rotation: &$rotations[dof.slot] };
                $turn
            }
            Kind::SlideX => {
                let $e = Along::<0>;
                $slide
            }
            Kind::SlideY => {
                let $e = Along::<1>;
                $slide
            }
            Kind::SlideZ => {
                let $e = Along::<2>;
                $slide
            }
            Kind::SlideSkew => {
                let $e = GeneralAxis { axis: &dof.axis, rotation: &$rotations[dof.slot] };
                $slide
            }
        }
    }};
}
pub(crate) use along;

impl<T: Scalar> Dof<T> {
    /// The degree of freedom of this axis, at coordinate `q`, with `slot` for its matrix if it needs one.
    pub(crate) fn new(axis: &Axis, q: usize, slot: usize) -> Self {
        // Normalised once more in double precision, so that no rounding of an input is left.
        let direction = axis.direction.normalize();
        let coordinate = (0..3).find(|&i| (0..3).all(|j| i == j || direction[j].abs() == 0.0));
        let kind = match (axis.kind, coordinate) {
            (AxisKind::Rotation, Some(0)) => Kind::TurnX,
            (AxisKind::Rotation, Some(1)) => Kind::TurnY,
            (AxisKind::Rotation, Some(_)) => Kind::TurnZ,
            (AxisKind::Rotation, None) => Kind::TurnSkew,
            (AxisKind::Translation, Some(0)) => Kind::SlideX,
            (AxisKind::Translation, Some(1)) => Kind::SlideY,
            (AxisKind::Translation, Some(_)) => Kind::SlideZ,
            (AxisKind::Translation, None) => Kind::SlideSkew,
        };
        let sign = T::from_f64(coordinate.map_or(1.0, |i| direction[i].signum()));
        Self {
            kind,
            sign,
            axis: direction.map(T::from_f64),
            q,
            slot,
            has_lever: !kind.turns(),
            armature: T::zero(),
        }
    }

    /// What it has done, from the pair kept for its coordinate.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn moved(&self, pair: (T, T)) -> Moved<T> {
        Moved { s: pair.0 * self.sign, c: pair.1 }
    }
}

impl Kind {
    pub(crate) fn turns(self) -> bool {
        matches!(self, Self::TurnX | Self::TurnY | Self::TurnZ | Self::TurnSkew)
    }

    pub(crate) fn is_skew(self) -> bool {
        matches!(self, Self::TurnSkew | Self::SlideSkew)
    }
}
