//! Mass distributions, and constants rounded to the working precision.

use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::spatial::symmetric::Symmetric;
use nalgebra::{Matrix3, Vector3};
use solaris_model::Link;

/// The mass distribution of a link, in the link's frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MassDistribution<T> {
    pub(crate) mass: T,
    /// Centre of mass.
    pub(crate) com: Vector3<T>,
    /// `m·c`
    pub(crate) first: Vector3<T>,
    /// `∫ r·rᵀ dm` about the link's origin.
    pub(crate) second: Symmetric<T>,
    /// Rotational inertia about the centre of mass.
    pub(crate) inertia: Matrix3<T>,
    /// Rotational inertia about the link's origin.
    pub(crate) inertia_at_origin: Symmetric<T>,
}

/// The mass distribution of a link; every moment is formed in double precision and rounded once.
pub(crate) fn mass_distribution<T: Scalar>(
    link: &Link,
) -> Result<Option<MassDistribution<T>>, DynamicsError> {
    if link.mass() <= 0.0 && link.inertia().amax() <= 0.0 {
        return Ok(None);
    }
    let (m, c, inertia) = (link.mass(), link.com(), link.inertia());
    let second = Matrix3::identity() * (inertia.trace() / 2.0) - inertia + c * c.transpose() * m;
    let at_origin = inertia + (Matrix3::identity() * c.norm_squared() - c * c.transpose()) * m;
    for x in at_origin.iter().chain(second.iter()) {
        constant::<T>("the inertia of link ", link.name(), *x)?;
    }
    Ok(Some(MassDistribution {
        mass: constant("the mass of link ", link.name(), m)?,
        com: vector("the centre of mass of link ", link.name(), c)?,
        first: vector("mass times centre of mass of link ", link.name(), &(c * m))?,
        second: Symmetric::of(&second.map(T::from_f64)),
        inertia: inertia.map(T::from_f64),
        inertia_at_origin: Symmetric::of(&at_origin.map(T::from_f64)),
    }))
}

/// `x` as a `T`, refused where `T` cannot hold it.
pub(crate) fn constant<T: Scalar>(what: &str, name: &str, x: f64) -> Result<T, DynamicsError> {
    let constant = T::from_f64(x);
    if constant.is_finite() {
        return Ok(constant);
    }
    let quoted = if name.is_empty() { String::new() } else { format!("'{name}'") };
    Err(DynamicsError::Constant { what: format!("{what}{quoted}"), value: x })
}

pub(crate) fn vector<T: Scalar>(
    what: &str,
    name: &str,
    v: &Vector3<f64>,
) -> Result<Vector3<T>, DynamicsError> {
    Ok(Vector3::new(constant(what, name, v.x)?, constant(what, name, v.y)?, constant(what, name, v.z)?))
}
