//! Where something stands: a point and a rotation.

use super::{Fields, Reader};
use crate::euler::EulerOrder;
use crate::joint::Placement;
use crate::text::node::{Content, Node};
use nalgebra::{Quaternion, Translation3, Unit, UnitQuaternion, Vector3};

/// How rotations are written.
const ROTATIONS: [&str; 8] = ["About", "Quaternion", "Xyz", "Xzy", "Yxz", "Yzx", "Zxy", "Zyx"];

/// What a quaternion's length may miss by because it was written with few digits.
const FEW_DIGITS: f64 = 1e-3;
/// What a figure takes as a quaternion of length 1.
const UNIT: f64 = 1e-6;

impl Reader {
    /// The fields `at` and `turned`.
    pub fn placement(&mut self, fields: &Fields<'_, '_>) -> Placement {
        let at = fields.get("at").and_then(|node| self.vector(node, "at"));
        let turned = fields.get("turned").and_then(|node| self.rotation(node));
        let (at, turned) = (at.unwrap_or_default(), turned.unwrap_or_else(UnitQuaternion::identity));
        Placement::from_parts(Translation3::from(at), turned)
    }

    /// A rotation: `About(axis: (x, y, z), angle: …)`, `Quaternion(x, y, z, w)`, `Zyx(a, b, c)` and the like.
    pub fn rotation(&mut self, node: &Node<'_>) -> Option<UnitQuaternion<f64>> {
        match self.kind(node, &ROTATIONS)? {
            "About" => self.about(node),
            "Quaternion" => self.quaternion(node),
            order => {
                let order = EulerOrder::ALL.into_iter().find(|known| format!("{known:?}") == order)?;
                self.euler(node, order)
            }
        }
    }

    /// `About(axis: (0, 1, 0), angle: deg(30))`
    fn about(&mut self, node: &Node<'_>) -> Option<UnitQuaternion<f64>> {
        let fields = self.fields(node, &["About"], &["axis", "angle"])?;
        let axis_node = self.required(&fields, "axis", "(0, 1, 0)");
        let axis = axis_node.and_then(|node| self.vector(node, "the axis"));
        let angle = self.required(&fields, "angle", "deg(30)").and_then(|node| self.angle(node, "the angle"));
        let (axis, angle) = (axis?, angle?);
        let direction = Unit::try_new(axis, 1e-12).filter(|unit| unit.iter().all(|x| x.is_finite()));
        if direction.is_none() {
            let message = format!("the axis ({:?}, {:?}, {:?}) is no direction", axis.x, axis.y, axis.z);
            self.fault(axis_node.map_or(node.place(), |node| node.span.clone()), message);
        }
        direction.map(|axis| UnitQuaternion::from_axis_angle(&axis, angle))
    }

    /// `Quaternion(x, y, z, w)`
    fn quaternion(&mut self, node: &Node<'_>) -> Option<UnitQuaternion<f64>> {
        let [x, y, z, w] = match &node.group()?.content {
            Content::Tuple(items) if items.len() == 4 => {
                let parts: Vec<Option<f64>> = ["x", "y", "z", "w"]
                    .iter()
                    .zip(items)
                    .map(|(part, item)| self.number(item, format_args!("{part} of the quaternion")))
                    .collect();
                [parts[0]?, parts[1]?, parts[2]?, parts[3]?]
            }
            _ => {
                self.fault(node.span.clone(), "Quaternion(x, y, z, w) takes four numbers, w last");
                return None;
            }
        };
        let quaternion = Quaternion::new(w, x, y, z);
        let miss = (quaternion.norm() - 1.0).abs();
        if miss <= UNIT {
            return Some(UnitQuaternion::new_unchecked(quaternion));
        }
        if miss <= FEW_DIGITS {
            return Some(UnitQuaternion::new_normalize(quaternion));
        }
        let message =
            format!("this quaternion is no rotation: its length is {}, and must be 1", quaternion.norm());
        self.fault(node.span.clone(), message);
        None
    }

    /// `Zyx(deg(90), 0, 0)`
    fn euler(&mut self, node: &Node<'_>, order: EulerOrder) -> Option<UnitQuaternion<f64>> {
        let Some(Content::Tuple(items)) = node
            .group()
            .map(|group| &group.content)
            .filter(|content| matches!(content, Content::Tuple(items) if items.len() == 3))
        else {
            let message = format!("{order:?}(a, b, c) takes three angles, in the order of its axes");
            self.fault(node.span.clone(), message);
            return None;
        };
        let angles: Vec<Option<f64>> =
            items.iter().map(|item| self.angle(item, "an angle of the rotation")).collect();
        Some(order.rotation(&[angles[0]?, angles[1]?, angles[2]?]))
    }

    /// A direction that is not yet of unit length.
    pub fn direction(&mut self, node: &Node<'_>) -> Option<Vector3<f64>> {
        let axis = self.vector(node, "the axis")?;
        if axis.try_normalize(1e-12).is_none_or(|unit| unit.iter().any(|x| !x.is_finite())) {
            let message = format!("the axis ({:?}, {:?}, {:?}) is no direction", axis.x, axis.y, axis.z);
            self.fault(node.span.clone(), message);
            return None;
        }
        Some(axis)
    }
}
