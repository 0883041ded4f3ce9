//! Coordinates of a joint about axes, of one that turns as a ball.

use solaris_model::{Axis, AxisKind, EulerOrder, Joint, JointKind, Motion, UnitQuaternion, Vector3};

/// How far (m, rad) a joint may move in a way that the other one lacks: floats.
const NONE: f64 = 1e-4;

/// The coordinates of `joint` where it moves as the joint `ball` does, whose own begin at `first` in each row of `motion`: a column each; or
/// what it cannot do.
///
/// Both joints stand in the same parent and move links with the same axes; a joint that does not slide stays where it is.
pub(crate) fn coordinates(
    joint: &Joint,
    ball: &Joint,
    motion: &Motion,
    first: usize,
) -> Result<Vec<Vec<f64>>, String> {
    let places = (0..motion.len()).map(|row| {
        let place = ball.placement() * ball.moved(&motion.q(row)[first..]);
        joint.placement().inverse() * place
    });
    let mut columns = vec![Vec::with_capacity(motion.len()); joint.kind().nq()];
    let turns = match joint.kind() {
        JointKind::Axes(dofs) => {
            let axes: Vec<Axis> = dofs.iter().map(|dof| dof.axis).collect();
            Some((slides(&axes)?, Turns::of(&axes)?))
        }
        _ => None,
    };
    let (mut near, mut before) = ([0.0; 3], UnitQuaternion::identity());
    for place in places {
        let mut row = Vec::with_capacity(columns.len());
        if let Some((slides, turns)) = &turns {
            row.extend(slides.iter().map(|axis| axis.dot(&place.translation.vector)));
            let missed: Vector3<f64> = place.translation.vector
                - slides.iter().zip(&row).map(|(axis, by)| axis * *by).sum::<Vector3<f64>>();
            if !slides.is_empty() && missed.norm() > NONE {
                return Err(format!("it slides by {} m across its axes", missed.norm()));
            }
            near = turns.order.angles_near(&place.rotation, &near);
            if let Some(more) = near[turns.count..].iter().find(|angle| angle.abs() > NONE) {
                return Err(format!("it turns by {:.2}° about an axis that it lacks", more.to_degrees()));
            }
            row.extend(&near[..turns.count]);
        } else {
            if joint.kind().nq() == 7 {
                row.extend(place.translation.vector.iter());
            }
            let turn = *place.rotation.quaternion();
            let turn = if turn.dot(before.quaternion()) < 0.0 { -turn } else { turn };
            before = UnitQuaternion::new_unchecked(turn);
            row.extend(turn.coords.iter());
        }
        columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
    }
    Ok(columns)
}

/// The axes along which a joint slides, which must come before those about which it turns and stand square.
fn slides(axes: &[Axis]) -> Result<Vec<Vector3<f64>>, String> {
    let count = axes.iter().take_while(|axis| axis.kind == AxisKind::Translation).count();
    let slides: Vec<Vector3<f64>> = axes[..count].iter().map(|axis| axis.direction).collect();
    let square = |i: usize| slides[..i].iter().all(|other| other.dot(&slides[i]).abs() < 1e-9);
    let is_in_order = axes[count..].iter().all(|axis| axis.kind == AxisKind::Rotation);
    if is_in_order && (0..count).all(square) {
        Ok(slides)
    } else {
        Err("its axes to slide along are not square, or come after others".to_owned())
    }
}

/// The first axes of an order about which a joint turns.
struct Turns {
    order: EulerOrder,
    count: usize,
}

impl Turns {
    fn of(axes: &[Axis]) -> Result<Self, String> {
        let turns: Vec<&Axis> = axes.iter().filter(|axis| axis.kind == AxisKind::Rotation).collect();
        let fits = |order: &EulerOrder| {
            let same =
                |(axis, turn): (usize, &&Axis)| turn.direction.dot(&Vector3::ith(axis, 1.0)) > 1.0 - 1e-9;
            turns.len() <= 3 && order.axes().into_iter().zip(&turns).all(same)
        };
        let order = EulerOrder::ALL.into_iter().find(fits);
        let order = order.ok_or("it turns about other axes than x, y and z once each")?;
        Ok(Self { order, count: turns.len() })
    }
}
