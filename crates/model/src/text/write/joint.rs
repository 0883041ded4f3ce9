//! A joint as text.

use super::number::{coordinate, is_plain_zero, placement, plain, tuple};
use crate::curve::Curve;
use crate::joint::{AxisKind, Dof, Follow, Joint, JointKind, Passive};
use solaris_text::layout::{Doc, field, group, quoted};

/// A joint on one line, or a field a line.
pub(super) fn joint(joint: &Joint) -> Doc {
    let mut fields = vec![field("name", Doc::Atom(quoted(&joint.name)))];
    fields.extend(placement(&joint.placement));
    let open = match &joint.kind {
        JointKind::Axes(dofs) => {
            if !dofs.is_empty() {
                fields.push(field("axes", group("[", dofs.iter().map(axis).collect(), "]")));
            }
            "Joint("
        }
        JointKind::Ball { armature, passive } => {
            fields.extend(acting(*armature, passive, false));
            "Ball("
        }
        JointKind::Free { armature, passive } => {
            fields.extend(acting(*armature, passive, false));
            "Free("
        }
    };
    group(open, fields, ")")
}

/// `rx`, `rx(limits: …)`, `Turn(axis: …)`
fn axis(dof: &Dof) -> Doc {
    let direction = dof.axis.direction;
    let turns = dof.axis.kind == AxisKind::Rotation;
    // The name of a coordinate axis stands for just these bits.
    let zeros = direction.iter().filter(|x| x.to_bits() == 0).count();
    let coordinate_axis = (zeros == 2 && direction.iter().any(|x| x.to_bits() == 1.0_f64.to_bits()))
        .then(|| dof.axis.stem().to_owned());
    let mut fields = Vec::new();
    if coordinate_axis.is_none() {
        fields.push(field("axis", tuple(direction.as_slice())));
    }
    if let Some(name) = &dof.name {
        fields.push(field("name", Doc::Atom(quoted(name))));
    }
    if let Some(limits) = dof.limits {
        let (lower, upper) = (coordinate(limits.lower, turns), coordinate(limits.upper, turns));
        fields.push(field("limits", Doc::Atom(format!("({lower}, {upper})"))));
    }
    fields.extend(acting(dof.armature, &dof.passive, turns));
    if let Some(Follow { dof, curve: along }) = &dof.follows {
        let parts = vec![field("dof", Doc::Atom(quoted(dof))), field("along", curve(along))];
        fields.push(field("follows", group("Follow(", parts, ")")));
    }
    match (coordinate_axis, turns) {
        (Some(axis), _) if fields.is_empty() => Doc::Atom(axis),
        (Some(axis), _) => group(&format!("{axis}("), fields, ")"),
        (None, true) => group("Turn(", fields, ")"),
        (None, false) => group("Slide(", fields, ")"),
    }
}

/// Armature, spring, damper and friction, where there are any.
fn acting(armature: f64, passive: &Passive, turns: bool) -> Vec<Doc> {
    let Passive { stiffness, rest, damping, friction } = *passive;
    let rested = Doc::Atom(coordinate(rest, turns));
    [
        ("armature", armature, plain(armature)),
        ("stiffness", stiffness, plain(stiffness)),
        ("rest", rest, rested),
        ("damping", damping, plain(damping)),
        ("friction", friction, plain(friction)),
    ]
    .into_iter()
    .filter(|(_, value, _)| !is_plain_zero(&[*value]))
    .map(|(name, _, written)| field(name, written))
    .collect()
}

fn curve(written: &Curve) -> Doc {
    match written {
        Curve::Polynomial(coefficients) if coefficients.len() == 2 => {
            let parts = vec![field("slope", plain(coefficients[1])), field("offset", plain(coefficients[0]))];
            group("Line(", parts, ")")
        }
        Curve::Polynomial(coefficients) => {
            let list = group("[", coefficients.iter().map(|c| plain(*c)).collect(), "]");
            group("Polynomial(", vec![list], ")")
        }
        Curve::Cubics { knots, pieces } => in_pieces("Cubics(", knots, pieces),
        Curve::Quintics { knots, pieces } => in_pieces("Quintics(", knots, pieces),
        Curve::Sine { amplitude, frequency, phase, offset } => {
            let numbers =
                [("amplitude", amplitude), ("frequency", frequency), ("phase", phase), ("offset", offset)];
            let parts = numbers.into_iter().map(|(name, number)| field(name, plain(*number))).collect();
            group("Sine(", parts, ")")
        }
        Curve::Chain(curves) => {
            let list = group("[", curves.iter().map(curve).collect(), "]");
            group("Chain(", vec![list], ")")
        }
    }
}

fn in_pieces<const N: usize>(open: &'static str, knots: &[f64], pieces: &[[f64; N]]) -> Doc {
    let knots = group("[", knots.iter().map(|knot| plain(*knot)).collect(), "]");
    let pieces = group("[", pieces.iter().map(|piece| tuple(piece)).collect(), "]");
    group(open, vec![field("knots", knots), field("pieces", pieces)], ")")
}
