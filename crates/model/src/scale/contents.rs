//! What a link holds, scaled along its axes.

use crate::inertia::{Shape, ShapeKind};
use crate::joint::Placement;
use crate::link::Link;
use nalgebra::{Matrix3, Vector3};

/// Gives a link another mass and scales all that it holds by `s` along its x, y and z.
pub(super) fn contents(link: &mut Link, s: &Vector3<f64>, mass: f64) {
    let place = |placement: &mut Placement| placement.translation.vector.component_mul_assign(s);
    let share = if link.mass > 0.0 { mass / link.mass } else { 1.0 };
    link.mass = mass;
    link.inertia = stretched_inertia(&link.inertia, s, share);
    link.com.component_mul_assign(s);
    if let Some(shape) = &mut link.shape {
        shape.kind = sized(shape, s);
        place(&mut shape.placement);
    }
    link.tip.iter_mut().for_each(|tip| tip.component_mul_assign(s));
    link.sole.iter_mut().for_each(|point| point.position.component_mul_assign(s));
    link.frames.iter_mut().for_each(|frame| place(&mut frame.placement));
}

/// The factor of all three axes, where they have the same.
pub(super) fn alike(s: &Vector3<f64>) -> Option<f64> {
    // As bits: one number, not nearly one.
    s.iter().all(|other| other.to_bits() == s.x.to_bits()).then_some(s.x)
}

/// How much longer something along the unit vector `direction` becomes: `‖direction∘s‖`.
pub(super) fn along(direction: &Vector3<f64>, s: &Vector3<f64>) -> f64 {
    alike(s).unwrap_or_else(|| direction.component_mul(s).norm())
}

/// The inertia about the centre of mass (kg m²) of a body that is `factors` times as long along its x, y and z, with `share`
/// times the mass.
///
/// ```text
/// s_x = s_y = s_z = s:   I′ = share·s²·I
/// else, of a cylinder about the axis a with the smallest I_aa (of several, the first), with b and c the other axes,
///   I′_aa = share·s_b·s_c·I_aa
///   I′_bb = I′_cc = share·(s_a²·max(0, I_oo − I_aa/2) + s_b·s_c·I_aa/2)          o = y if a is x, else x
///   I′_ij = share·s_i·s_j·I_ij
/// ```
///
/// # Source
///
/// `Body::scaleInertialProperties` of OpenSim 4.6, which goes by the cylinder's radius and length, `r² = 2·I_aa/m` and
/// `L² = 12·(I_oo − m·r²/4)/m`; here they are put in.
pub fn stretched_inertia(inertia: &Matrix3<f64>, factors: &Vector3<f64>, share: f64) -> Matrix3<f64> {
    let s = factors;
    if let Some(s) = alike(s) {
        return inertia * (share * (s * s));
    }
    let mut stretched = *inertia;
    let diagonal = inertia.diagonal();
    let along = diagonal.imin();
    let [across, other] = [(along + 1) % 3, (along + 2) % 3];
    let seen = diagonal[usize::from(along == 0)];
    let widened = s[across] * s[other];
    let thin = share * widened * diagonal[along];
    let long = share * (s[along] * s[along] * (seen - diagonal[along] / 2.0).max(0.0));
    for i in 0..3 {
        for j in 0..3 {
            // In this order `I_ij` and `I_ji` are the same to the last bit.
            stretched[(i, j)] *= share * (s[i] * s[j]);
        }
    }
    stretched[(along, along)] = thin;
    stretched[(across, across)] = long + thin / 2.0;
    stretched[(other, other)] = long + thin / 2.0;
    stretched
}

/// The shape with each of its own axes as much longer as the link is along it; what is round stays round, but a sphere
/// that is drawn out becomes an ellipsoid.
fn sized(shape: &Shape, s: &Vector3<f64>) -> ShapeKind {
    let [x, y, z] =
        [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| along(&(shape.placement.rotation * axis), s));
    let round = alike(s).unwrap_or(f64::midpoint(x, z));
    match shape.kind {
        ShapeKind::Box { size } => ShapeKind::Box { size: size.component_mul(&Vector3::new(x, y, z)) },
        ShapeKind::Cylinder { radius, length } => {
            ShapeKind::Cylinder { radius: radius * round, length: length * y }
        }
        ShapeKind::Ellipsoid { radii } => {
            ShapeKind::Ellipsoid { radii: radii.component_mul(&Vector3::new(x, y, z)) }
        }
        ShapeKind::Capsule { radius, length } => {
            ShapeKind::Capsule { radius: radius * round, length: length * y }
        }
        ShapeKind::Sphere { radius } => match alike(s) {
            Some(s) => ShapeKind::Sphere { radius: radius * s },
            None => ShapeKind::Ellipsoid { radii: Vector3::new(x, y, z) * radius },
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: a rod of mass 12 along z with r² = 0.04 and L² = 1 has 0.24 about z and 1 + 0.12 across.
    #[test]
    fn a_cylinder_scales_along_and_across() {
        let rod = Matrix3::from_diagonal(&Vector3::new(1.12, 1.12, 0.24));
        let rod = stretched_inertia(&rod, &Vector3::new(2.0, 3.0, 5.0), 0.5);
        // Half the mass: 6·(0.04·6)/2 = 0.72 along, 6·(25/12 + 0.24/4) = 12.86 across.
        assert_relative_eq!(
            rod,
            Matrix3::from_diagonal(&Vector3::new(12.86, 12.86, 0.72)),
            max_relative = 1e-15
        );
    }

    #[test]
    fn a_sphere_that_is_drawn_out_is_an_ellipsoid() {
        let ball = Shape { kind: ShapeKind::Sphere { radius: 2.0 }, placement: Placement::identity() };
        let drawn = sized(&ball, &Vector3::new(1.0, 2.0, 0.5));
        assert_eq!(drawn, ShapeKind::Ellipsoid { radii: Vector3::new(2.0, 4.0, 1.0) });
        assert_eq!(sized(&ball, &Vector3::repeat(3.0)), ShapeKind::Sphere { radius: 6.0 });
    }
}
