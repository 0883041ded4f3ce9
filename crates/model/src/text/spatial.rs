//! Points, directions and rotations.

use crate::euler::EulerOrder;
use crate::joint::Placement;
use nalgebra::{Quaternion, Translation3, Unit, UnitQuaternion, Vector3};
use solaris_text::{Content, Fields, Node, Reader};
use std::fmt::Display;

/// How rotations are written.
const ROTATIONS: [&str; 8] = ["About", "Quaternion", "Xyz", "Xzy", "Yxz", "Yzx", "Zxy", "Zyx"];

/// What a quaternion's length may miss by because it was written with few digits.
const FEW_DIGITS: f64 = 1e-3;
/// What a figure takes as a quaternion of length 1.
const UNIT: f64 = 1e-6;

/// Reads vectors, rotations and placements, beside the single values that any [`Reader`] reads.
pub trait ReadSpatial {
    /// A vector: `(x, y, z)`.
    fn vector(&mut self, node: &Node<'_>, what: impl Display) -> Option<Vector3<f64>>;

    /// The fields `at` and `turned`.
    fn placement(&mut self, fields: &Fields<'_, '_>) -> Placement;

    /// A rotation: `About(axis: (x, y, z), angle: …)`, `Quaternion(x, y, z, w)`, `Zyx(a, b, c)` and the like.
    fn rotation(&mut self, node: &Node<'_>) -> Option<UnitQuaternion<f64>>;

    /// A direction that is not yet of unit length.
    fn direction(&mut self, node: &Node<'_>) -> Option<Vector3<f64>>;
}

impl ReadSpatial for Reader {
    fn vector(&mut self, node: &Node<'_>, what: impl Display) -> Option<Vector3<f64>> {
        self.numbers(node, what, ["x", "y", "z"]).map(Vector3::from)
    }

    fn placement(&mut self, fields: &Fields<'_, '_>) -> Placement {
        let at = fields.get("at").and_then(|node| self.vector(node, "at"));
        let turned = fields.get("turned").and_then(|node| self.rotation(node));
        let (at, turned) = (at.unwrap_or_default(), turned.unwrap_or_else(UnitQuaternion::identity));
        Placement::from_parts(Translation3::from(at), turned)
    }

    fn rotation(&mut self, node: &Node<'_>) -> Option<UnitQuaternion<f64>> {
        match self.kind(node, &ROTATIONS)? {
            "About" => about(self, node),
            "Quaternion" => quaternion(self, node),
            order => {
                let order = EulerOrder::ALL.into_iter().find(|known| format!("{known:?}") == order)?;
                euler(self, node, order)
            }
        }
    }

    fn direction(&mut self, node: &Node<'_>) -> Option<Vector3<f64>> {
        let axis = self.vector(node, "the axis")?;
        if axis.try_normalize(1e-12).is_none_or(|unit| unit.iter().any(|x| !x.is_finite())) {
            let message = format!("the axis ({:?}, {:?}, {:?}) is no direction", axis.x, axis.y, axis.z);
            self.fault(node.span.clone(), message);
            return None;
        }
        Some(axis)
    }
}

/// `About(axis: (0, 1, 0), angle: deg(30))`
fn about(reader: &mut Reader, node: &Node<'_>) -> Option<UnitQuaternion<f64>> {
    let fields = reader.fields(node, &["About"], &["axis", "angle"])?;
    let axis_node = reader.required(&fields, "axis", "(0, 1, 0)");
    let axis = axis_node.and_then(|node| reader.vector(node, "the axis"));
    let angle = reader.required(&fields, "angle", "deg(30)").and_then(|node| reader.angle(node, "the angle"));
    let (axis, angle) = (axis?, angle?);
    let direction = Unit::try_new(axis, 1e-12).filter(|unit| unit.iter().all(|x| x.is_finite()));
    if direction.is_none() {
        let message = format!("the axis ({:?}, {:?}, {:?}) is no direction", axis.x, axis.y, axis.z);
        reader.fault(axis_node.map_or(node.place(), |node| node.span.clone()), message);
    }
    direction.map(|axis| UnitQuaternion::from_axis_angle(&axis, angle))
}

/// `Quaternion(x, y, z, w)`
fn quaternion(reader: &mut Reader, node: &Node<'_>) -> Option<UnitQuaternion<f64>> {
    let [x, y, z, w] = match &node.group()?.content {
        Content::Tuple(items) if items.len() == 4 => {
            let parts: Vec<Option<f64>> = ["x", "y", "z", "w"]
                .iter()
                .zip(items)
                .map(|(part, item)| reader.number(item, format_args!("{part} of the quaternion")))
                .collect();
            [parts[0]?, parts[1]?, parts[2]?, parts[3]?]
        }
        _ => {
            reader.fault(node.span.clone(), "Quaternion(x, y, z, w) takes four numbers, w last");
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
    reader.fault(node.span.clone(), message);
    None
}

/// `Zyx(deg(90), 0, 0)`
fn euler(reader: &mut Reader, node: &Node<'_>, order: EulerOrder) -> Option<UnitQuaternion<f64>> {
    let Some(Content::Tuple(items)) = node
        .group()
        .map(|group| &group.content)
        .filter(|content| matches!(content, Content::Tuple(items) if items.len() == 3))
    else {
        let message = format!("{order:?}(a, b, c) takes three angles, in the order of its axes");
        reader.fault(node.span.clone(), message);
        return None;
    };
    let angles: Vec<Option<f64>> =
        items.iter().map(|item| reader.angle(item, "an angle of the rotation")).collect();
    Some(order.rotation(&[angles[0]?, angles[1]?, angles[2]?]))
}
