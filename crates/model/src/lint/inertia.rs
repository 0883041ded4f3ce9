//! The lint of masses and inertias that no body of the link's size has.

use super::mass::PRINTED;
use super::{short, suspect};
use crate::figure::Figure;
use crate::inertia::{Shape, ShapeKind, second_moments};
use crate::link::Link;
use nalgebra::{Matrix3, Vector3};
use solaris_text::Finding;

/// Densities that links have (kg/m³): from loose foam and hollow shells to stone and light metal.
const DENSITY: (f64, f64) = (300.0, 3000.0);
/// How much less than the uniform solid's second moments a link's may be.
const LEAST_SPREAD: f64 = 0.01;
/// How many times as long as the way to the farthest thing on it a link's radius of gyration may be.
const MOST_GYRATION: f64 = 3.0;
/// What rounding may do.
const ROUNDING: f64 = 1.0 + 1e-9;

pub(super) fn check(figure: &Figure, findings: &mut Vec<Finding>) {
    let mut farthest: Vec<f64> = figure.links.iter().map(own_reach).collect();
    for link in &figure.links {
        if let Some(parent) = link.parent {
            let way = link.joint.placement.translation.vector - figure.links[parent].com;
            farthest[parent] = farthest[parent].max(way.norm());
        }
    }
    for (link, farthest) in figure.links.iter().zip(farthest).filter(|(link, _)| link.mass > 0.0) {
        let mut say = |message| findings.push(suspect(&link.name, message));
        // A shape that does not hold the centre of mass is not all of the link, and the rest is not known.
        let outside = link.shape.as_ref().and_then(|shape| outside(link, shape));
        let shape = link.shape.as_ref().filter(|_| outside.is_none());
        let is_bare = link.shape.is_none();
        outside.into_iter().chain(shape.and_then(|shape| density(link, shape))).for_each(&mut say);
        if link.inertia.amax() > 0.0 && is_physical(link) {
            let spread = shape.and_then(|shape| against_shape(link, shape));
            let wide = is_bare.then(|| gyration(link, farthest)).flatten();
            spread.into_iter().chain(wide).for_each(&mut say);
            products(link).into_iter().for_each(&mut say);
        }
    }
}

/// Whether some mass distribution has the inertia; what none has is told by itself.
fn is_physical(link: &Link) -> bool {
    second_moments(&link.inertia).0.min() >= -PRINTED * link.inertia.amax()
}

/// From the centre of mass to the farthest of the link's own points (m).
fn own_reach(link: &Link) -> f64 {
    let points = link.frames.iter().map(|frame| frame.placement.translation.vector);
    let points = points.chain(link.tip).chain(link.sole.iter().map(|point| point.position));
    points.chain([Vector3::zeros()]).map(|point| (point - link.com).norm()).fold(0.0, f64::max)
}

fn density(link: &Link, shape: &Shape) -> Option<String> {
    let volume = shape.kind.volume();
    let density = link.mass / volume;
    if (DENSITY.0..=DENSITY.1).contains(&density) {
        return None;
    }
    Some(format!(
        "its density is {} kg/m³, {} kg in {} m³; most bodies have {} to {}: check its mass and the size of its shape",
        short(density),
        short(link.mass),
        short(volume),
        DENSITY.0,
        DENSITY.1
    ))
}

/// The centre of mass from the shape's centre, along the shape's axes.
fn offset(link: &Link, shape: &Shape) -> Vector3<f64> {
    shape.placement.inverse_transform_point(&link.com.into()).coords
}

/// All shapes are convex: what lies inside of one has its centre of mass there.
fn outside(link: &Link, shape: &Shape) -> Option<String> {
    let (offset, half) = (offset(link, shape), shape.kind.half_extents());
    let axis = (0..3).find(|&i| offset[i].abs() > half[i] * ROUNDING)?;
    Some(format!(
        "its centre of mass lies {} m from the centre of its shape along the shape's {}, which ends at {} m: one \
         of the two is misplaced, or the shape is not all of the link",
        short(offset[axis].abs()),
        ['x', 'y', 'z'][axis],
        short(half[axis])
    ))
}

/// The second moments about the centre of mass, per mass and along the shape's axes, against what masses inside of the
/// shape can have.
///
/// ```text
/// S/m = (½ tr(I)·1 − I)/m        0 ≤ S_ii/m ≤ h_i² − r_i²
/// ```
///
/// holds for any mass inside a box of half lengths `h` whose centre of mass lies at `r`; a uniform solid has `h²/3`. The
/// formula of the thesis for `∫x² dm` has `5h²/3`, and one about the end taken for one about the centre `4h²/3`.
fn against_shape(link: &Link, shape: &Shape) -> Option<String> {
    let turn = shape.placement.rotation.to_rotation_matrix();
    let tensor = turn.matrix().transpose() * link.inertia * turn.matrix();
    let moments = (Matrix3::identity() * (tensor.trace() / 2.0) - tensor) / link.mass;
    let (half, offset) = (shape.kind.half_extents(), offset(link, shape));
    let solid = shape.kind.gyration_squared().sum() / 2.0;
    let found = moments.trace();
    if found < LEAST_SPREAD * solid {
        return Some(format!(
            "its inertia is {} times that of a uniform solid of its shape and mass; check its units",
            short(found / solid)
        ));
    }
    let too_wide = |what: &str, found: f64, most: f64| {
        format!(
            "its inertia has its mass spread {} m on average {what}, and inside of its shape that is {} m at most: check the \
             factor of the formula, the point of reference (the centre of mass) and the units",
            short(found.sqrt()),
            short(most.max(0.0).sqrt())
        )
    };
    if let ShapeKind::Box { .. } = shape.kind {
        let most = |i: usize| half[i] * half[i] - offset[i] * offset[i];
        let axis = (0..3).find(|&i| moments[(i, i)] > most(i).max(0.0) * ROUNDING)?;
        let what = format!("along its shape's {}", ['x', 'y', 'z'][axis]);
        return Some(too_wide(&what, moments[(axis, axis)], most(axis)));
    }
    // Round shapes draw limbs, and need not follow their outline across: they are asked for their length only.
    let (found, most) = (second_moments(&tensor).0.max() / link.mass, half.max() * half.max());
    (found > most * ROUNDING).then(|| too_wide("along its longest axis", found, most))
}

fn gyration(link: &Link, farthest: f64) -> Option<String> {
    let radius = (link.inertia.symmetric_eigenvalues().max() / link.mass).sqrt();
    // A link without anything but its own origin has no size to compare with.
    (farthest > 0.0 && radius > MOST_GYRATION * farthest).then(|| {
        format!(
            "its radius of gyration is {} m, but nothing on it is farther than {} m from its centre of mass: check the units \
             of its inertia",
            short(radius),
            short(farthest)
        )
    })
}

/// A body without any extension along one axis is a plate; one that lies oblique in its frame is more likely a tensor with
/// products that are as large as they can be.
fn products(link: &Link) -> Option<String> {
    let (values, axes) = second_moments(&link.inertia);
    let (least, most) = (values.imin(), values.max());
    let middle = values.sum() - values[least] - most;
    let axis = axes.column(least);
    let is_flat = values[least] <= 1e-6 * most && middle > 1e-3 * most;
    (is_flat && axis.amax() < 0.999).then(|| {
        format!(
            "its products of inertia are as large as they can be: along ({:.3}, {:.3}, {:.3}) it has no extension at all; check \
             their signs and the axes they are given along",
            axis[0], axis[1], axis[2]
        )
    })
}
