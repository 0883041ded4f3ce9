//! The mass of bodies: from `<inertial>` or geoms, then bounded, balanced, scaled.

use super::compiler::{Compiler, FromGeoms};
use super::defaults::{Resolved, SPECIFIERS};
use super::geom::Geom;
use super::model::Model;
use super::orientation::placement;
use crate::tree::{Body, Lump, combined};
use crate::xml::{Node, Reader, tag, value_span};
use solaris_model::{Matrix3, Placement, UnitQuaternion, Vector3};

/// What a body weighs.
pub(super) struct Weight {
    pub(super) lump: Lump,
    /// The axes of its inertia, where the file says them.
    pub(super) axes: Option<UnitQuaternion<f64>>,
}

/// What a body weighs by its `<inertial>` (with the frame it stands in) or its geoms; `None` where neither says anything.
pub(super) fn of_body(
    reader: &mut Reader,
    inertial: Option<(Node, Placement)>,
    geoms: &[Geom],
    compiler: &Compiler,
) -> Option<Weight> {
    let read = inertial.map(|(node, frame)| read(reader, node, &frame, compiler));
    match compiler.from_geoms {
        FromGeoms::Never => read,
        FromGeoms::Auto if read.is_some() => read,
        _ => {
            let (first, last) = compiler.groups;
            let counted =
                geoms.iter().filter(|geom| (first..=last).contains(&geom.group) && geom.lump.mass > 0.0);
            let counted: Vec<&Geom> = counted.collect();
            let lumps: Vec<&Lump> = counted.iter().map(|geom| &geom.lump).collect();
            let axes = if let [geom] = counted.as_slice() { Some(geom.axes) } else { None };
            if lumps.is_empty() { None } else { Some(Weight { lump: combined(&lumps), axes }) }
        }
    }
}

/// Unreadable numbers have been reported, and are replaced by such as no further fault follows from.
fn read(reader: &mut Reader, node: Node, frame: &Placement, compiler: &Compiler) -> Weight {
    let mut known = vec!["pos", "mass", "diaginertia", "fullinertia"];
    known.extend(SPECIFIERS);
    reader.check_attributes(node, &known);
    reader.need(node, "pos");
    reader.need(node, "mass");
    let full: Option<[f64; 6]> = reader.numbers(node, "fullinertia");
    let diagonal: Option<[f64; 3]> = reader.numbers(node, "diaginertia");
    let turned = SPECIFIERS.iter().find(|way| node.has_attribute(**way));
    if let (Some(_), Some(way)) = (full, turned) {
        let message = format!("'fullinertia' is along the body's axes and leaves no room for '{way}'");
        reader.fault(value_span(node, way), message);
    }
    if node.has_attribute("fullinertia") && node.has_attribute("diaginertia") {
        reader.fault(
            value_span(node, "fullinertia"),
            "both 'diaginertia' and 'fullinertia' are given; one must go",
        );
    }
    let at = frame * placement(reader, &Resolved::plain(node), compiler);
    let mass = reader.number(node, "mass").unwrap_or(1.0);
    let own = match (full, diagonal) {
        (Some([xx, yy, zz, xy, xz, yz]), _) => Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
        (None, Some(diagonal)) => Matrix3::from_diagonal(&Vector3::from(diagonal)),
        (None, None) => Matrix3::zeros(),
    };
    if own.amax() == 0.0 && mass > 0.0 && !reader.has_faults() {
        let message = format!(
            "its inertia is zero with a mass of {mass} kg; it counts as a point mass, MuJoCo refuses it"
        );
        reader.suspect(tag(node), "<inertial>", message);
    }
    let turn = *at.rotation.to_rotation_matrix().matrix();
    let turned = if turn == Matrix3::identity() { own } else { turn * own * turn.transpose() };
    let lump = Lump { mass, com: at.translation.vector, inertia: (turned + turned.transpose()) / 2.0 };
    Weight { lump, axes: full.is_none().then_some(at.rotation) }
}

/// What the compiler's settings make of the masses of the file's bodies, each with those of its model.
pub(super) fn adjust(reader: &mut Reader, bodies: &mut [(&mut Body, &Compiler)], models: &[Model]) {
    let (main, root) = (&models[0].compiler, models[0].root);
    let mut bounded = 0;
    for (body, compiler) in bodies.iter_mut() {
        let before = (body.mass, body.inertia);
        body.mass = body.mass.max(compiler.least_mass);
        if body.inertia.iter().all(|entry| entry.abs() < 1e150)
            && (compiler.least_inertia > 0.0 || compiler.balance)
        {
            let eigen = body.inertia.symmetric_eigen();
            let mut moments = eigen.eigenvalues.map(|moment| moment.max(compiler.least_inertia));
            let unbalanced = moments.max() > moments.sum() - moments.max();
            if compiler.balance && unbalanced {
                moments = Vector3::repeat(moments.sum() / 3.0);
            }
            if moments != eigen.eigenvalues {
                let axes = eigen.eigenvectors;
                body.inertia = axes * Matrix3::from_diagonal(&moments) * axes.transpose();
                body.inertia = (body.inertia + body.inertia.transpose()) / 2.0;
            }
        }
        bounded += usize::from(before != (body.mass, body.inertia));
    }
    if bounded > 0 {
        let message = format!(
            "boundmass, boundinertia or balanceinertia changed the mass or inertia of {bounded} bodies, as in MuJoCo"
        );
        reader.note(tag(root), "<compiler>", message);
    }
    let sum: f64 = bodies.iter().map(|(body, _)| body.mass).sum();
    if let Some((total, span)) = &main.total
        && sum > 0.0
    {
        let factor = total / sum;
        for (body, _) in bodies.iter_mut() {
            body.mass *= factor;
            body.inertia *= factor;
        }
        reader.note(
            span.clone(),
            "<compiler>",
            format!("settotalmass scaled all masses by {factor}, from {sum} kg to {total} kg"),
        );
    }
}
