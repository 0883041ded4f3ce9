//! Where elements stand: `pos` and the five ways of giving an orientation.

use super::compiler::Compiler;
use super::defaults::{Resolved, SPECIFIERS};
use crate::xml::{Reader, tag};
use solaris_model::{Placement, UnitQuaternion, Vector3};

/// The placement that an element gives by `pos` and an orientation.
pub(super) fn placement(reader: &mut Reader, element: &Resolved, compiler: &Compiler) -> Placement {
    let position = element.numbers(reader, "pos").unwrap_or_default();
    Placement::from_parts(Vector3::from(position).into(), orientation(reader, element, compiler))
}

/// The orientation that an element gives; none is the identity.
pub(super) fn orientation(
    reader: &mut Reader,
    element: &Resolved,
    compiler: &Compiler,
) -> UnitQuaternion<f64> {
    let said: Vec<&str> = SPECIFIERS.into_iter().filter(|way| element.said(way).is_some()).collect();
    let way = match said.as_slice() {
        [] => return UnitQuaternion::identity(),
        [way] => *way,
        _ => {
            let message = format!(
                "its orientation is given {} times ({}); one of them must go",
                said.len(),
                said.join(", ")
            );
            reader.fault(tag(element.node), message);
            return UnitQuaternion::identity();
        }
    };
    let counts = if matches!(way, "euler" | "zaxis") {
        3
    } else if way == "xyaxes" {
        6
    } else {
        4
    };
    let Some(numbers) = element.list(reader, way, counts..=counts) else { return UnitQuaternion::identity() };
    turn(way, &numbers, compiler).unwrap_or_else(|| {
        reader.fault(
            element.span(way),
            format!("'{way}' is no orientation: it has a direction of length zero"),
        );
        UnitQuaternion::identity()
    })
}

/// The turn of one of the five ways, where its numbers are one.
pub(super) fn turn(way: &str, numbers: &[f64], compiler: &Compiler) -> Option<UnitQuaternion<f64>> {
    let vector = |from: usize| Vector3::new(numbers[from], numbers[from + 1], numbers[from + 2]);
    match way {
        "quat" => wxyz(numbers),
        "axisangle" => {
            let axis = direction(&vector(0))?;
            Some(UnitQuaternion::from_scaled_axis(axis * (numbers[3] * compiler.angle)))
        }
        "euler" => Some(compiler.euler.iter().zip(numbers).fold(
            UnitQuaternion::identity(),
            |turn, (axis, angle)| {
                let direction = match axis.to_ascii_lowercase() {
                    'x' => Vector3::x(),
                    'y' => Vector3::y(),
                    _ => Vector3::z(),
                };
                let next = UnitQuaternion::from_scaled_axis(direction * (angle * compiler.angle));
                // Axes that move with the turns before them, or fixed ones.
                if axis.is_lowercase() { turn * next } else { next * turn }
            },
        )),
        "xyaxes" => {
            let x = direction(&vector(0))?;
            let y = direction(&(vector(3) - x * x.dot(&vector(3))))?;
            let columns = solaris_model::Matrix3::from_columns(&[x, y, x.cross(&y)]);
            Some(UnitQuaternion::from_rotation_matrix(&solaris_model::Rotation3::from_matrix_unchecked(
                columns,
            )))
        }
        _ => Some(to_direction(&direction(&vector(0))?)),
    }
}

/// A quaternion in MuJoCo's order, of any length.
pub(super) fn wxyz(numbers: &[f64]) -> Option<UnitQuaternion<f64>> {
    let [w, x, y, z] = *numbers else { return None };
    let length = w.hypot(x).hypot(y.hypot(z));
    let unit = length > 1e-14 && length.is_finite();
    let parts = [w, x, y, z].map(|part| part / length);
    unit.then(|| UnitQuaternion::new_unchecked([parts[1], parts[2], parts[3], parts[0]].into()))
}

/// The shortest turn that leads z to a unit vector; half a turn about x where that is −z.
pub(super) fn to_direction(axis: &Vector3<f64>) -> UnitQuaternion<f64> {
    let across = Vector3::z().cross(axis);
    let angle = across.norm().atan2(axis.z);
    let about = across.try_normalize(1e-14).unwrap_or_else(Vector3::x);
    UnitQuaternion::from_scaled_axis(about * angle)
}

/// A unit vector, where there is one.
pub(super) fn direction(vector: &Vector3<f64>) -> Option<Vector3<f64>> {
    vector.try_normalize(1e-14).filter(|unit| unit.iter().all(|part| part.is_finite()))
}
