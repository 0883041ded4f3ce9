//! Masses, mass centres and inertias.

use super::Rescaling;
use super::bodies::Bodies;
use super::edits::Edits;
use crate::opensim::layout::inertia;
use crate::xml::{Node, Reader, element, tag};
use solaris_model::{MassShares, Vector3, stretched_inertia};

/// Scales what the bodies say of their masses.
pub(super) fn scale(edits: &mut Edits, reader: &mut Reader, bodies: &Bodies, rescaling: &Rescaling) {
    let mass = |reader: &mut Reader, node: Node| {
        element(node, "mass").map_or(Some(0.0), |mass| reader.text_number(mass))
    };
    let before: Option<Vec<f64>> = bodies.list.iter().map(|(_, node)| mass(reader, *node)).collect();
    let Some(before) = before else { return };
    let share = |body: usize| match rescaling.shares {
        MassShares::Kept => 1.0,
        MassShares::Volumes => bodies.factors(Some(body)).product(),
    };
    let sum: f64 = before.iter().enumerate().map(|(body, mass)| mass * share(body)).sum();
    let all = match rescaling.mass {
        None => 1.0,
        Some(total) if total > 0.0 && total.is_finite() && sum > 0.0 => total / sum,
        Some(total) => {
            let message =
                format!("the mass is to be {total} kg from {sum} kg; both must be finite and above zero");
            reader.fault(tag(bodies.model), message);
            return;
        }
    };
    for (body, (_, node)) in bodies.list.iter().enumerate() {
        let (s, share) = (bodies.factors(Some(body)), share(body) * all);
        if let Some(mass) = element(*node, "mass") {
            edits.scale(reader, mass, &[share]);
        }
        if let Some(center) = element(*node, "mass_center") {
            edits.scale(reader, center, s.as_slice());
        }
        let Some(tensor) = inertia(reader, *node) else { continue };
        // OpenSim: what is scaled and has no mass has no inertia.
        let no_mass = before[body] <= f64::EPSILON && s != Vector3::repeat(1.0);
        let i = if no_mass { tensor * 0.0 } else { stretched_inertia(&tensor, &s, share) };
        let numbers = [i.m11, i.m22, i.m33, i.m12, i.m13, i.m23];
        if let Some(inertia) = element(*node, "inertia") {
            edits.set(reader, inertia, &numbers);
            continue;
        }
        for (pair, number) in ["xx", "yy", "zz", "xy", "xz", "yz"].into_iter().zip(numbers) {
            if let Some(moment) = element(*node, &format!("inertia_{pair}")) {
                edits.set(reader, moment, &[number]);
            }
        }
    }
}
