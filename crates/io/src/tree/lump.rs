//! The mass of several bodies together.

use solaris_model::{Matrix3, Vector3};

/// A mass with its centre and its inertia about that.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lump {
    /// Mass (kg).
    pub(crate) mass: f64,
    /// Centre of mass (m).
    pub(crate) com: Vector3<f64>,
    /// Rotational inertia about the centre of mass, along the axes of the frame that `com` is in (kg m²).
    pub(crate) inertia: Matrix3<f64>,
}

/// All of them as one; a single one stays as it is, to the bit.
///
/// ```text
/// m = Σ mᵢ      c = Σ mᵢ·cᵢ / m      I = Σ Iᵢ + mᵢ·(|dᵢ|²·1 − dᵢ·dᵢᵀ)      dᵢ = cᵢ − c
/// ```
pub(crate) fn combined(lumps: &[&Lump]) -> Lump {
    if let [lump] = lumps {
        return **lump;
    }
    // An empty sum is −0.
    let mass = lumps.iter().map(|lump| lump.mass).sum::<f64>() + 0.0;
    let com = if mass == 0.0 {
        Vector3::zeros()
    } else {
        lumps.iter().fold(Vector3::zeros(), |sum, lump| sum + lump.com * (lump.mass / mass))
    };
    let inertia = lumps.iter().fold(Matrix3::zeros(), |sum, lump| {
        let d = lump.com - com;
        sum + lump.inertia + (Matrix3::identity() * d.norm_squared() - d * d.transpose()) * lump.mass
    });
    Lump { mass, com, inertia: (inertia + inertia.transpose()) / 2.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two points of 1 kg, 2 m apart: 1 kg m² each about the axes across them.
    #[test]
    fn two_points_are_a_dumb_bell() {
        let point = |x| Lump { mass: 1.0, com: Vector3::new(x, 0.0, 3.0), inertia: Matrix3::zeros() };
        let both = combined(&[&point(-1.0), &point(1.0)]);
        assert_eq!((both.mass, both.com), (2.0, Vector3::new(0.0, 0.0, 3.0)));
        assert_eq!(both.inertia, Matrix3::from_diagonal(&Vector3::new(0.0, 2.0, 2.0)));
    }
}
