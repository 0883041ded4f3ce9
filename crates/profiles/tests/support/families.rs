//! One curve of every family, of one second or as long as it takes.

use solaris_profiles::blend::{Blend, Fade, FadeKind, Layer, Leaving};
use solaris_profiles::spline::{Bend, CubicSpline};
use solaris_profiles::{
    Boundary, Clip, CubicHermite, Curve, ProfileError, Quintic, acceleration, displacement, legacy, limited,
    velocity,
};

/// A curve by its name.
pub(crate) type Family = (&'static str, Box<dyn Curve>);

/// All families.
pub(crate) fn families() -> Result<Vec<Family>, ProfileError> {
    let mut all = polynomials_and_displacements()?;
    all.extend(accelerations_velocities_and_limits()?);
    all.extend(splines_and_blends()?);
    Ok(all)
}

fn polynomials_and_displacements() -> Result<Vec<Family>, ProfileError> {
    let (start, end) = ((0.0, 0.5), (1.0, -0.25));
    Ok(vec![
        (
            "quintic",
            Box::new(Quintic::new(1.0, Boundary::new(0.0, 0.5, 1.0), Boundary::new(1.0, -0.25, 2.0))?),
        ),
        ("cubic", Box::new(CubicHermite::new(1.0, start, end)?)),
        ("displacement line", Box::new(displacement::Line::new(1.0, 0.0, 1.0)?)),
        ("displacement trigonometric", Box::new(displacement::Trigonometric::new(1.0, 0.0, 1.0)?)),
        ("trigonometric velocities", Box::new(displacement::TrigonometricVelocities::new(1.0, start, end)?)),
        ("power", Box::new(displacement::Power::new(1.0, 0.0, 1.0, 3.5)?)),
        ("exponential", Box::new(displacement::Exponential::new(1.0, 0.0, 1.0, 3.5, -2.0)?)),
        (
            "exponential velocities",
            Box::new(displacement::ExponentialVelocities::new(1.0, start, end, 5, -2.0)?),
        ),
        ("hyperbolic", Box::new(displacement::Hyperbolic::new(1.0, 0.0, 1.0, 2.0)?)),
        ("tension", Box::new(displacement::Tension::new(1.0, start, end, 2.0)?)),
        ("legacy hyperbolic", Box::new(legacy::Hyperbolic::new(2.0, start, end)?)),
    ])
}

fn accelerations_velocities_and_limits() -> Result<Vec<Family>, ProfileError> {
    let start = (0.0, 0.5);
    Ok(vec![
        ("acceleration constant", Box::new(acceleration::Constant::new(1.0, start, 2.0)?)),
        ("acceleration trigonometric", Box::new(acceleration::Trigonometric::new(1.0, start, 2.0)?)),
        ("acceleration quarter ellipse", Box::new(acceleration::Ellipse::quarter(1.0, start, 2.0)?)),
        ("acceleration half ellipse", Box::new(acceleration::Ellipse::half(1.0, start, 2.0)?)),
        ("velocity line", Box::new(velocity::Line::new(1.0, 0.0, (0.5, 2.0))?)),
        ("velocity circle", Box::new(velocity::Circle::new(1.0, 0.0, (1.0, 3.0), (0.4, 2.0))?)),
        ("velocity faired", Box::new(velocity::Faired::new(1.0, 0.0, 2.0, (0.3, 0.8))?)),
        ("trapezoidal", Box::new(limited::Trapezoidal::new(0.0, 1.0, 1.5, 5.0)?)),
        ("S-curve", Box::new(limited::SCurve::new(0.0, 1.0, 1.5, 5.0, 40.0)?)),
    ])
}

fn splines_and_blends() -> Result<Vec<Family>, ProfileError> {
    let keys = [(0.0, 0.0), (0.2, 1.0), (0.3, 0.5), (0.7, 0.5), (1.0, 2.0)];
    let bend = Bend { tension: 0.3, continuity: -0.4, bias: 0.2 };
    let tension = |stiffness| displacement::Tension::new(1.0, (0.0, 0.5), (1.0, -0.25), stiffness);
    let fade = Fade::new(FadeKind::Smooth, 0.2, 0.8)?;
    let fading = Layer { fade_out: Some(fade), ..Layer::new(Clip::new(tension(1.0)?)) };
    Ok(vec![
        ("Catmull-Rom", Box::new(CubicSpline::catmull_rom(&keys)?)),
        ("centripetal", Box::new(CubicSpline::centripetal(&keys)?)),
        ("monotone", Box::new(CubicSpline::monotone(&keys)?)),
        ("Kochanek-Bartels", Box::new(CubicSpline::kochanek_bartels(&keys, bend, (0.0, 0.0))?)),
        ("natural", Box::new(CubicSpline::natural(&keys)?)),
        (
            "blend of two",
            Box::new(Blend::between(
                Clip::new(tension(1.0)?),
                Clip::new(tension(2.0)?),
                fade,
                Leaving::Refuse,
            )?),
        ),
        ("weighted blend", Box::new(Blend::weighted(vec![fading, Layer::new(Clip::new(tension(2.0)?))])?)),
    ])
}
