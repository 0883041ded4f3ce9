//! The checks of a single link and its joint.

use super::LinkSpec;
use crate::fault::Fault;
use crate::figure::Figure;
use crate::inertia::Inertia;
use crate::joint::{Joint, JointKind, Passive};
use crate::layout::velocity_names;

/// Everything that is wrong with a link, but its place in the tree.
pub(super) fn link(link: &LinkSpec, faults: &mut Vec<Fault>) {
    let before = faults.len();
    check_numbers(link, faults);
    check_joint(&link.joint, faults);
    check_inertia(link, faults);
    if faults.len() == before {
        check_range(link, faults);
    }
}

/// Numbers that are finite, and beyond all range together: a solid's mass times its lengths, an inertia with its mirror image.
fn check_range(link: &LinkSpec, faults: &mut Vec<Fault>) {
    if let Some(value) = link.symmetric_tensor().iter().find(|value| !value.is_finite()) {
        faults.push(Fault::NotFinite { link: link.name.clone(), what: "inertia".into(), value: *value });
    }
}

fn check_numbers(link: &LinkSpec, faults: &mut Vec<Fault>) {
    let too_long = |what: &str, values: &[f64]| {
        let value = values.iter().find(|value| value.is_finite() && value.abs() > Figure::LONGEST)?;
        Some(Fault::TooLong { link: link.name.clone(), what: what.to_owned(), value: *value })
    };
    let mut check = |what: String, values: &[f64], are_lengths: bool| {
        faults.extend(too_long(&what, values).filter(|_| are_lengths));
        if let Some(value) = values.iter().find(|value| !value.is_finite()) {
            faults.push(Fault::NotFinite { link: link.name.clone(), what, value: *value });
        }
    };
    check("mass".into(), &[link.mass], false);
    check("centre of mass".into(), link.com.as_slice(), true);
    if let Inertia::Tensor(tensor) = &link.inertia {
        check("inertia".into(), tensor.as_slice(), false);
    }
    let placements = [("joint origin".to_owned(), link.joint.placement())].into_iter();
    let frames = link.frames.iter().map(|frame| (format!("frame '{}'", frame.name), &frame.placement));
    let shape = link.shape.iter().map(|shape| ("place of its shape".to_owned(), &shape.placement));
    let mut lengths = Vec::new();
    for (what, placement) in placements.chain(frames).chain(shape) {
        check(what.clone(), placement.translation.vector.as_slice(), true);
        check(what.clone(), placement.rotation.coords.as_slice(), false);
        lengths.push((what, placement.rotation.coords.norm()));
    }
    if let Some(tip) = &link.tip {
        check("tip".into(), tip.as_slice(), true);
    }
    for point in &link.sole {
        check(format!("sole point {:?}", point.part), point.position.as_slice(), true);
    }
    for (what, length) in lengths.into_iter().filter(|(_, length)| (length - 1.0).abs() > 1e-6) {
        faults.push(Fault::NotRotation { link: link.name.clone(), what, length });
    }
    let uniform = if let Inertia::Uniform(shape) = &link.inertia { Some(shape) } else { None };
    let drawn = link.shape.as_ref().filter(|shape| Some(*shape) != uniform);
    for shape in uniform.into_iter().chain(drawn) {
        for (what, value) in shape.kind.lengths() {
            if value.is_nan() || value <= 0.0 || value.is_infinite() {
                faults.push(Fault::ShapeNotPositive { link: link.name.clone(), what, value });
            }
            faults.extend(too_long(&format!("{what} of its shape"), &[value]));
        }
    }
}

fn check_joint(joint: &Joint, faults: &mut Vec<Fault>) {
    let dofs = joint.kind().axes();
    if dofs.len() > Joint::MOST_DOFS {
        faults.push(Fault::TooManyDofs { joint: joint.name().to_owned(), count: dofs.len() });
    }
    for what in &joint.misfits {
        faults.push(Fault::NotForThisJoint { joint: joint.name().to_owned(), what });
    }
    let names = velocity_names(joint.name(), joint.kind());
    for (index, name) in names.iter().enumerate() {
        let armature = joint.kind().armature(index);
        if !(armature >= 0.0 && armature.is_finite()) {
            faults.push(Fault::Armature { dof: name.clone(), armature });
        }
        check_passive(name, joint.kind(), joint.kind().passive(index), faults);
    }
    for (index, (dof, name)) in dofs.iter().zip(names).enumerate() {
        // Every direction that is one has been normalised.
        if (dof.axis.direction.norm() - 1.0).abs().partial_cmp(&1e-9).is_none_or(std::cmp::Ordering::is_gt) {
            let (joint, axis) = (joint.name().to_owned(), dof.axis.direction.into());
            faults.push(Fault::ZeroAxis { joint, index: index + 1, axis });
        }
        if let Some(limits) = dof.limits
            && limits.lower.partial_cmp(&limits.upper).is_none_or(std::cmp::Ordering::is_gt)
        {
            faults.push(Fault::LimitsReversed { dof: name, lower: limits.lower, upper: limits.upper });
        }
    }
}

fn check_passive(dof: &str, kind: &JointKind, passive: &Passive, faults: &mut Vec<Fault>) {
    let Passive { stiffness, rest, damping, friction } = *passive;
    let (any, positive) = ("", ", zero or more");
    let (spring, rested) = match kind {
        JointKind::Axes(_) => (true, true),
        JointKind::Ball { .. } => (true, false),
        JointKind::Free { .. } => (false, false),
    };
    let mut check = |what, value: f64, good: bool, rule| {
        if !(good && value.is_finite()) {
            faults.push(Fault::Passive { dof: dof.to_owned(), what, value, rule });
        }
    };
    check("damping", damping, damping >= 0.0, positive);
    check("friction", friction, friction >= 0.0, positive);
    if spring {
        check("stiffness", stiffness, true, any);
    } else {
        check("stiffness", stiffness, stiffness.abs() == 0.0, ", and a free joint has no spring: zero");
    }
    let rule =
        if rested { any } else { ", and such a joint's spring rests at its neutral orientation: zero" };
    check("the spring's rest", rest, rested || rest.abs() == 0.0, rule);
}

fn check_inertia(link: &LinkSpec, faults: &mut Vec<Fault>) {
    if link.mass.is_finite() && link.mass > Figure::HEAVIEST {
        faults.push(Fault::TooHeavy { link: link.name.clone(), mass: link.mass });
    }
    if link.mass < 0.0 {
        faults.push(Fault::NegativeMass { link: link.name.clone(), mass: link.mass });
    }
    let Inertia::Tensor(tensor) = &link.inertia else { return };
    if !tensor.iter().all(|entry| entry.is_finite()) {
        return;
    }
    let scale = tensor.amax();
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let difference = tensor[(row, column)] - tensor[(column, row)];
        // Numbers may be printed with few digits.
        if difference.abs() > 1e-6 * scale {
            let name = |i: usize| ['x', 'y', 'z'][i];
            let (row, column) = (name(row), name(column));
            faults.push(Fault::InertiaNotSymmetric { link: link.name.clone(), row, column, difference });
        }
    }
}
