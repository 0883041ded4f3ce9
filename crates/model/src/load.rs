//! Loads: what a link carries.

use crate::fault::FigureError;
use crate::figure::Figure;
use crate::fuse::carried::Matter;
use nalgebra::{Matrix3, Vector3};

/// Something rigid that a link carries.
#[doc(alias = "payload")]
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Index of the link.
    pub link: usize,
    /// Its centre of mass in the link's frame (m).
    pub at: Vector3<f64>,
    /// Its mass (kg).
    pub mass: f64,
    /// Its rotational inertia about its centre of mass, along the link's axes (kg m²); zero for that of a point.
    pub inertia: Matrix3<f64>,
}

/// Why a load cannot be carried.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// No such link.
    #[error("figure '{figure}' has no link number {link}")]
    NoLink {
        /// The figure.
        figure: String,
        /// The index.
        link: usize,
    },
    /// A number out of its range.
    #[error("the {what} of the load on '{link}' is {value}; it must be {range}")]
    Range {
        /// What.
        what: &'static str,
        /// The link that carries it.
        link: String,
        /// Its value.
        value: f64,
        /// What it has to be.
        range: &'static str,
    },
    /// A figure that cannot be.
    #[error(transparent)]
    Figure(#[from] FigureError),
}

impl Figure {
    /// The figure with a load on one of its links: mass, centre of mass and inertia of both together, the inertia by Steiner's
    /// theorem; nothing else is changed.
    ///
    /// ```text
    /// c = (m₁·c₁ + m₂·c₂)/m      I = Σ Iᵢ + mᵢ·(|cᵢ − c|²·E − (cᵢ − c)·(cᵢ − c)ᵀ)
    /// ```
    ///
    /// # Errors
    ///
    /// [`LoadError`] for a link that there is not, numbers that are not finite, a mass below zero, an inertia that no body has.
    pub fn carrying(&self, load: &Load) -> Result<Self, LoadError> {
        let Some(link) = self.links.get(load.link) else {
            return Err(LoadError::NoLink { figure: self.name.clone(), link: load.link });
        };
        let refuse =
            |what, value, range| Err(LoadError::Range { what, link: link.name.clone(), value, range });
        if !(load.mass.is_finite() && load.mass >= 0.0) {
            return refuse("mass", load.mass, "a finite number, zero or more");
        }
        if let Some(value) = load.at.iter().find(|x| !x.is_finite()) {
            return refuse("place", *value, "finite numbers");
        }
        if let Some(value) = load.inertia.iter().find(|x| !x.is_finite()) {
            return refuse("inertia", *value, "finite numbers");
        }
        // Of a body: no principal inertia below zero, and none above the sum of the others.
        let principal = load.inertia.symmetric_eigenvalues();
        let rounding = 1e-9 * principal.amax();
        if let Some(value) = principal.iter().find(|x| **x < -rounding) {
            return refuse("least inertia", *value, "zero or more");
        }
        if 2.0 * principal.max() > principal.sum() + rounding {
            return refuse("greatest inertia", principal.max(), "no more than the sum of the two others");
        }
        let other = Matter { mass: load.mass, com: load.at, inertia: load.inertia };
        let Matter { mass, com, inertia } = Matter::of(link).with(&other);
        let mut loaded = self.clone();
        let link = &mut loaded.links[load.link];
        (link.mass, link.com, link.inertia) = (mass, com, inertia);
        Ok(loaded)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{FigureBuilder, Inertia, Joint, LinkSpec};

    fn rod() -> Figure {
        let link = LinkSpec::root("rod", Joint::new("pivot").rx())
            .mass(2.0)
            .com(Vector3::new(0.0, -0.25, 0.0))
            .inertia(Inertia::diagonal(0.04, 0.001, 0.04));
        FigureBuilder::new("rod").link(link).build().expect("valid")
    }

    #[test]
    fn a_point_at_the_end_of_a_rod_adds_its_own_about_the_pivot() {
        let load = Load { link: 0, at: Vector3::new(0.0, -0.5, 0.0), mass: 3.0, inertia: Matrix3::zeros() };
        let loaded = rod().carrying(&load).expect("a load");
        let link = &loaded.links()[0];
        assert!((link.mass() - 5.0).abs() < 1e-15);
        assert!((link.com().y - (2.0 * -0.25 + 3.0 * -0.5) / 5.0).abs() < 1e-15);
        // About the pivot: I₁ + m₁·c₁² + m₂·c₂².
        let about = link.inertia()[(0, 0)] + 5.0 * link.com().y.powi(2);
        assert!((about - (0.04 + 2.0 * 0.0625 + 3.0 * 0.25)).abs() < 1e-14);
        assert!(loaded.fingerprint() != rod().fingerprint());
    }

    #[test]
    fn what_is_no_body_is_refused() {
        let load = |mass, inertia| Load { link: 0, at: Vector3::zeros(), mass, inertia };
        for (load, said) in [
            (
                load(-1.0, Matrix3::zeros()),
                "the mass of the load on 'rod' is -1; it must be a finite number, zero or more",
            ),
            (
                load(1.0, Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, 3.0))),
                "the greatest inertia of the load on 'rod' is 3; it must be no more than the sum of the two others",
            ),
            (Load { link: 4, ..load(1.0, Matrix3::zeros()) }, "figure 'rod' has no link number 4"),
        ] {
            assert_eq!(rod().carrying(&load).expect_err("refused").to_string(), said);
        }
    }
}
