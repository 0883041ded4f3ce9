//! Forces of a fluid on a solid that moves through it, along the solid's own axes.

use nalgebra::Vector3;
use solaris_model::{Immersed, ImmersedShape, Medium};
use std::f64::consts::PI;

/// What is smaller is zero.
const LEAST: f64 = 1e-15;

/// Points of Gauss and Kronrod's rule on (0, ½), and their weights, which those on (½, 1) have, too.
const POINTS: [(f64, f64); 8] = [
    (0.004_272_31, 0.011_467_66),
    (0.025_446_04, 0.031_546_05),
    (0.067_567_79, 0.052_395_01),
    (0.129_234_41, 0.070_326_63),
    (0.206_956_38, 0.084_502_36),
    (0.297_077_42, 0.095_175_29),
    (0.396_107_52, 0.102_216_47),
    (0.5, 0.104_741_07),
];

/// A fluid around a solid.
pub(super) struct Fluid {
    density: f64,
    viscosity: f64,
    shape: ImmersedShape,
    /// Of an ellipsoid, what moves with it: the volume (m³), and that times squares of lengths (m⁵).
    added: [Vector3<f64>; 2],
}

impl Fluid {
    pub(super) fn of(medium: &Medium, part: &Immersed) -> Self {
        let added = match part.shape {
            ImmersedShape::Box(_) => [Vector3::zeros(); 2],
            ImmersedShape::Ellipsoid { radii, .. } => added(&radii),
        };
        Self { density: medium.density, viscosity: medium.viscosity, shape: part.shape, added }
    }

    /// Force (N) and moment (N m) about the solid's centre, of its velocity against the fluid (m/s) and its angular velocity
    /// (rad/s).
    pub(super) fn act(&self, v: &Vector3<f64>, omega: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        match &self.shape {
            ImmersedShape::Box(half) => self.on_box(half, v, omega),
            ImmersedShape::Ellipsoid { radii, coefficients } => {
                self.on_ellipsoid(radii, coefficients, v, omega)
            }
        }
    }

    /// ```text
    /// fᵢ = −2·ρ·rⱼ·rₖ·|vᵢ|·vᵢ − 6·π·β·r·vᵢ      gᵢ = −½·ρ·rᵢ·(rⱼ⁴ + rₖ⁴)·|ωᵢ|·ωᵢ − 8·π·β·r³·ωᵢ
    /// ```
    ///
    /// with the half sides `rᵢ` and their mean `r`.
    fn on_box(
        &self,
        r: &Vector3<f64>,
        v: &Vector3<f64>,
        omega: &Vector3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let (rho, beta, mean) = (self.density, self.viscosity, r.mean());
        let component = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let force = -2.0 * rho * r[j] * r[k] * v[i].abs() * v[i] - 6.0 * PI * beta * mean * v[i];
            let round = r[i] * (r[j].powi(4) + r[k].powi(4));
            let moment =
                -0.5 * rho * round * omega[i].abs() * omega[i] - 8.0 * PI * beta * mean.powi(3) * omega[i];
            (force, moment)
        };
        let parts = [component(0), component(1), component(2)];
        (Vector3::from(parts.map(|part| part.0)), Vector3::from(parts.map(|part| part.1)))
    }

    /// ```text
    /// f = ρ·(m∘v) × ω + C_M·ρ·V·ω × v + Γ × v − (6·π·β·r + ρ·|v|·(C_blunt·A + C_slender·(A_max − A)))·v
    /// g = ρ·(m∘v) × v + ρ·(J∘ω) × ω − (8·π·β·r³ + ρ·|ω∘(C_angular·I + C_slender·(I_max − I))|)·ω
    /// ```
    ///
    /// with the added mass `m` and inertia `J` over the density, the area `A` that the ellipsoid shows to its velocity, and
    /// Kutta's circulation `Γ = C_K·ρ·cos α·A·n × v` of the normal `n` where the stream parts.
    fn on_ellipsoid(
        &self,
        r: &Vector3<f64>,
        &[blunt, slender, angular, kutta, magnus]: &[f64; 5],
        v: &Vector3<f64>,
        omega: &Vector3<f64>,
    ) -> (Vector3<f64>, Vector3<f64>) {
        let (rho, beta) = (self.density, self.viscosity);
        let (greatest, least) = (r.max(), r.min());
        let middle = r.sum() - greatest - least;
        // Squares of the products of two radii.
        let square = Vector3::new(r.y * r.z, r.z * r.x, r.x * r.y).map(|product| product * product);
        let normal = square.component_mul(v);
        let (above, below) = (normal.norm_squared(), normal.dot(v));
        let (area, cosine) =
            if below > 0.0 { (PI * (above / below).sqrt(), below / (v.norm() * above)) } else { (0.0, 0.0) };
        let circulation = normal.cross(v) * (kutta * rho * cosine * area);
        let volume = 4.0 / 3.0 * PI * r.product();
        let mean = r.mean();
        let drag = 6.0 * PI * beta * mean
            + rho * v.norm() * (area * blunt + slender * (PI * greatest * middle - area));

        let moment_of = |i: usize| 8.0 / 15.0 * PI * r[i] * r[(i + 1) % 3].max(r[(i + 2) % 3]).powi(4);
        let most = 8.0 / 15.0 * PI * middle * greatest.powi(4);
        let resistance = Vector3::from(
            [0, 1, 2].map(|i| omega[i] * (angular * moment_of(i) + slender * (most - moment_of(i)))),
        );
        let turning = 8.0 * PI * beta * mean.powi(3) + rho * resistance.norm();

        let [mass, inertia] = self.added;
        let (linear, spin) = (mass.component_mul(v) * rho, inertia.component_mul(omega) * rho);
        let lift = omega.cross(v) * (magnus * rho * volume) + circulation.cross(v);
        (linear.cross(omega) + lift - v * drag, linear.cross(v) + spin.cross(omega) - omega * turning)
    }
}

/// The fluid that moves with an ellipsoid of these radii, over its density.
///
/// ```text
/// κᵢ = rx·ry·rz·∫₀^∞ dλ / ((rᵢ² + λ)·√((rx² + λ)(ry² + λ)(rz² + λ)))      mᵢ = V·κᵢ/(2 − κᵢ)
/// Jᵢ = V/5·(rⱼ² − rₖ²)²·|κₖ − κⱼ| / |2·(rⱼ² − rₖ²) + (rⱼ² + rₖ²)·(κⱼ − κₖ)|
/// ```
///
/// # Source
///
/// As the module; H. Lamb, Hydrodynamics (1932), articles 114 and 115.
fn added(r: &Vector3<f64>) -> [Vector3<f64>; 2] {
    let volume = 4.0 / 3.0 * PI * r.product();
    let kappa = [0, 1, 2].map(|i| kappa(r, i));
    let mass = kappa.map(|kappa| volume * kappa / (2.0 - kappa).max(LEAST));
    let inertia = [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (difference, sum) = (r[j] * r[j] - r[k] * r[k], r[j] * r[j] + r[k] * r[k]);
        let below = (2.0 * difference + sum * (kappa[j] - kappa[k])).abs().max(LEAST);
        volume / 5.0 * difference * difference * (kappa[k] - kappa[j]).abs() / below
    });
    [Vector3::from(mass), Vector3::from(inertia)]
}

/// As MuJoCo integrates it, so that forces are the same: by the substitution `λ = s·x³/(1−x)²` with `s = (rᵢ²·rx·ry·rz)^⅖`
/// and Gauss and Kronrod's rule of 15 points to eight digits. For an ellipsoid that is a hundred times longer
/// than thick the integral is some percent off.
fn kappa(r: &Vector3<f64>, i: usize) -> f64 {
    let scale = (r[i] * r[i] * r.product()).powf(0.4);
    let term = |(x, weight): (f64, f64)| {
        let rest = 1.0 - x;
        let lambda = scale * x.powi(3) / (rest * rest);
        let rate = scale * x * x * (3.0 - x) / rest.powi(3);
        let ratios = r.map(|r| 1.0 + lambda / (r * r));
        weight * rate / (ratios[i] * ratios.product().sqrt())
    };
    let both = |(x, weight): (f64, f64)| {
        // The middle is one point.
        let twin = if x < 0.5 { term((1.0 - x, weight)) } else { 0.0 };
        term((x, weight)) + twin
    };
    let sum: f64 = POINTS.into_iter().map(both).sum();
    sum / (r[i] * r[i])
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::Placement;

    /// A sphere drags half its own volume of fluid along, and no fluid turns with it.
    #[test]
    fn a_sphere_moves_half_its_volume_of_fluid() {
        let [mass, inertia] = added(&Vector3::repeat(0.3));
        let volume = 4.0 / 3.0 * PI * 0.027;
        assert!((mass / volume - Vector3::repeat(0.5)).norm() < 1e-6, "{mass}");
        assert_eq!(inertia, Vector3::zeros());
    }

    /// The three κ of any ellipsoid are 2 together, but for the error of the rule.
    #[test]
    fn the_integrals_of_an_ellipsoid_are_two_together() {
        for (r, error) in [(Vector3::new(1.0, 2.0, 3.0), 1e-5), (Vector3::new(0.1, 1.0, 0.3), 1e-3)] {
            let sum: f64 = (0..3).map(|i| kappa(&r, i)).sum();
            assert!((sum - 2.0).abs() < error, "{sum}");
        }
    }

    fn fluid(density: f64, viscosity: f64, shape: ImmersedShape) -> Fluid {
        let part = Immersed { link: String::new(), at: Placement::identity(), shape };
        Fluid::of(&Medium { density, viscosity, ..Medium::default() }, &part)
    }

    /// Worked out by hand for half sides of 1, 2 and 3 m: products of two are 6, 3 and 2, and the mean is 2.
    #[test]
    fn a_box_is_held_back_by_each_side_that_it_shows() {
        let shape = ImmersedShape::Box(Vector3::new(1.0, 2.0, 3.0));
        let (v, omega) = (Vector3::new(1.0, -2.0, 3.0), Vector3::new(-1.0, 0.5, 2.0));
        let (force, moment) = fluid(10.0, 0.0, shape).act(&v, &omega);
        assert!((force - Vector3::new(-120.0, 240.0, -360.0)).norm() < 1e-11, "{force}");
        // Sums of fourth powers of two: 97, 82, 17.
        assert!((moment - Vector3::new(485.0, -205.0, -1020.0)).norm() < 1e-11, "{moment}");
        let (force, moment) = fluid(0.0, 0.5, shape).act(&v, &omega);
        assert!((force + v * (6.0 * PI)).norm() < 1e-12, "{force}");
        assert!((moment + omega * (32.0 * PI)).norm() < 1e-12, "{moment}");
    }

    /// Magnus' lift, less that of the half volume of fluid that goes along: a ball that spins without either goes straight.
    #[test]
    fn a_spinning_ball_is_lifted_by_its_volume_of_fluid() {
        let (radius, density) = (0.2, 3.0);
        let volume = 4.0 / 3.0 * PI * 0.008;
        let (v, omega) = (Vector3::new(3.0, -1.0, 0.5), Vector3::new(0.2, 4.0, -7.0));
        for magnus in [0.0, 0.5, 2.0] {
            let coefficients = [0.0, 0.0, 0.0, 0.0, magnus];
            let shape = ImmersedShape::Ellipsoid { radii: Vector3::repeat(radius), coefficients };
            let (force, moment) = fluid(density, 0.0, shape).act(&v, &omega);
            let expected = omega.cross(&v) * ((magnus - 0.5) * density * volume);
            assert!((force - expected).norm() < 1e-6, "{magnus}: {force}");
            assert!(moment.norm() < 1e-12, "{magnus}: {moment}");
        }
    }

    /// Worked out by hand for radii of 1, 2 and 3 m: in units of 8·π/15 m⁵ the moments are 81, 162 and 48, and the most is 162.
    #[test]
    fn a_turning_ellipsoid_is_held_back_by_the_moment_that_it_shows() {
        let radii = Vector3::new(1.0, 2.0, 3.0);
        let resistance = |angular: f64, slender: f64, omega: Vector3<f64>| {
            let shape = ImmersedShape::Ellipsoid { radii, coefficients: [0.0, slender, angular, 0.0, 0.0] };
            let (force, moment) = fluid(15.0, 0.0, shape).act(&Vector3::zeros(), &omega);
            assert_eq!(force, Vector3::zeros());
            // What turns with the solid does no work.
            -moment.dot(&omega) / (8.0 * PI * omega.norm_squared())
        };
        for (axis, own, rest) in [(0, 81.0, 81.0), (1, 162.0, 0.0), (2, 48.0, 114.0)] {
            let omega = Vector3::ith(axis, -2.0);
            assert!((resistance(1.0, 0.0, omega) - 2.0 * own).abs() < 1e-9, "axis {axis}");
            assert!((resistance(0.0, 1.0, omega) - 2.0 * rest).abs() < 1e-9, "axis {axis}");
            assert!((resistance(0.25, 3.0, omega) - (0.5 * own + 6.0 * rest)).abs() < 1e-9, "axis {axis}");
        }
        let oblique = resistance(1.0, 1.0, Vector3::new(2.0, -3.0, 6.0));
        assert!((oblique - 7.0 * 162.0).abs() < 1e-9, "{oblique}");
    }
}
