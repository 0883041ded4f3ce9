//! Scaling by a factor for each axis of each link, by the rules of OpenSim's `ScaleTool`.

use super::contents::{alike, along, contents};
use super::{RANGE, ScaleError, exact_total, in_range, links};
use crate::figure::Figure;
use crate::joint::{AxisKind, JointKind};
use crate::link::Link;
use crate::markers::Marker;
use nalgebra::Vector3;

/// Factors for the lengths of a figure along the axes of its links, and what becomes of the masses.
///
/// ```
/// use solaris_model::{MassShares, Stretching, Vector3, human};
/// let figure = human(1.75, 73.0)?;
/// let pelvis = ("pelvis".to_owned(), Vector3::new(1.0, 0.98, 1.12));
/// let factors = figure.stretch_factors(&[pelvis])?;
/// let ann = figure.stretched(&Stretching { factors, mass: Some(54.3), shares: MassShares::Kept })?;
/// assert_eq!(ann.mass(), 54.3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ScaleSet")]
#[doc(alias = "scale factors")]
#[doc(alias = "ScaleTool")]
#[derive(Clone, Debug, PartialEq)]
pub struct Stretching {
    /// Of each link along its x, y and z: see [`Figure::stretch_factors`].
    pub factors: Vec<Vector3<f64>>,
    /// Total mass (kg); without one it is what the masses add up to.
    pub mass: Option<f64>,
    /// How the mass is shared out.
    pub shares: MassShares,
}

/// How a stretched figure shares its mass out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum MassShares {
    /// Each link keeps its share of the total.
    #[doc(alias = "preserve_mass_distribution")]
    #[default]
    Kept,
    /// Masses grow as volumes do, by `s_x·s_y·s_z`, before the total is set.
    Volumes,
}

impl Stretching {
    /// The markers where the stretched links have them.
    ///
    /// # Errors
    ///
    /// [`ScaleError::MarkerLink`] for a marker on a link without factors.
    pub fn markers(&self, markers: &[Marker]) -> Result<Vec<Marker>, ScaleError> {
        let moved = |marker: &Marker| {
            let unknown = || ScaleError::MarkerLink { marker: marker.name.clone(), link: marker.link };
            let s = self.factors.get(marker.link).ok_or_else(unknown)?;
            Ok(Marker { position: marker.position.component_mul(s), ..marker.clone() })
        };
        markers.iter().map(moved).collect()
    }
}

impl Figure {
    /// The figure with the lengths of its links times a factor for each of their axes.
    ///
    /// With `s` the factors of a link, along its own axes, and `‖u∘s‖` how much longer the unit vector `u` becomes:
    ///
    /// | what | becomes |
    /// |---|---|
    /// | its centre of mass, tip, sole, frames, where its children's joints sit | elementwise times `s` |
    /// | its shape | as `s` makes its own axes longer |
    /// | its slides that follow another degree of freedom | times `‖u∘s‖` of the parent; of the link itself once the joint has turned |
    /// | free slides, turns, ranges, springs, axes | the same |
    /// | masses | each its share, or first times `s_x·s_y·s_z`; then all by one factor to the total, to the last bit |
    /// | its inertia | times `s²` and as its mass changes; where the axes have several factors, that of a stretched cylinder |
    ///
    /// The world is not stretched. The stature is multiplied where all factors are one and the same, and forgotten where they
    /// are not. Factors of one change no bit; the same factor everywhere does what [`scaled`](Self::scaled) does, but for the
    /// ranges and springs of free slides and for where the root sits.
    ///
    /// # Source
    ///
    /// `Model::scale` of OpenSim 4.6, with one difference: for a slide along `u` it takes `Σ|u_i|·s_i` with `u` in the joint's own
    /// frame, which is not one along an oblique axis where the factors are, and of other axes than the body's where that frame
    /// is turned. Along an axis of the body, and for a body with one factor, both are the same. Bodies that cannot move against
    /// each other are one link, whose inertia is scaled as one.
    ///
    /// # Errors
    ///
    /// [`ScaleError`] for another number of factors than of links, factors that are none, a mass where the figure has none, and
    /// numbers that become too large.
    #[doc(alias = "scale")]
    #[doc(alias = "ScaleTool")]
    pub fn stretched(&self, stretching: &Stretching) -> Result<Self, ScaleError> {
        let factors = &stretching.factors;
        self.check_factors(factors)?;
        let masses = self.stretched_masses(stretching)?;
        let mut stretched = self.links.clone();
        for (i, link) in stretched.iter_mut().enumerate() {
            contents(link, &factors[i], masses[i]);
            let carrier = link.parent.map_or_else(|| Vector3::repeat(1.0), |parent| factors[parent]);
            joint(link, &carrier, &factors[i]);
        }
        if let Some(bad) = stretched.iter().find(|link| !links::is_finite(link)) {
            return Err(ScaleError::NotFinite { link: bad.name.clone() });
        }
        let same = alike(&factors[0]).filter(|_| factors.iter().all(|other| *other == factors[0]));
        let stature = same.and_then(|factor| Some(self.stature? * factor));
        Ok(Self { stature, ..self.with_links(stretched) })
    }

    fn check_factors(&self, factors: &[Vector3<f64>]) -> Result<(), ScaleError> {
        if factors.len() != self.links.len() {
            return Err(ScaleError::FactorCount { links: self.links.len(), factors: factors.len() });
        }
        for (link, s) in self.links.iter().zip(factors) {
            for (axis, &factor) in ['x', 'y', 'z'].into_iter().zip(s) {
                if !(RANGE.0..=RANGE.1).contains(&factor) {
                    return Err(ScaleError::AxisFactor { name: link.name.clone(), axis, factor });
                }
            }
        }
        Ok(())
    }

    fn stretched_masses(&self, stretching: &Stretching) -> Result<Vec<f64>, ScaleError> {
        let grown = |(link, s): (&Link, &Vector3<f64>)| match stretching.shares {
            MassShares::Kept => link.mass,
            MassShares::Volumes => link.mass * s.product(),
        };
        let mut masses: Vec<f64> = self.links.iter().zip(&stretching.factors).map(grown).collect();
        let Some(mass) = stretching.mass else { return Ok(masses) };
        if !(mass > 0.0 && mass.is_finite()) {
            return Err(ScaleError::Mass { mass });
        }
        let from: f64 = masses.iter().sum();
        if from <= 0.0 {
            return Err(ScaleError::Massless { figure: self.name.clone() });
        }
        let factor = in_range("mass", from, mass)?;
        for m in &mut masses {
            *m *= factor;
        }
        if exact_total(&mut masses, mass) { Ok(masses) } else { Err(ScaleError::Mass { mass }) }
    }
}

/// Where the link's joint sits on what carries it, and how far its slides go that follow something.
fn joint(link: &mut Link, carrier: &Vector3<f64>, own: &Vector3<f64>) {
    let placement = &mut link.joint.placement;
    placement.translation.vector.component_mul_assign(carrier);
    let JointKind::Axes(dofs) = &mut link.joint.kind else { return };
    let mut turned = false;
    for dof in dofs {
        turned |= dof.axis.kind == AxisKind::Rotation;
        let Some(follow) = dof.follows.as_mut().filter(|_| dof.axis.kind == AxisKind::Translation) else {
            continue;
        };
        // Before the joint turns, a slide is along the carrier; after it has, along the link that it moves.
        let direction = dof.axis.direction;
        let factor =
            if turned { along(&direction, own) } else { along(&(placement.rotation * direction), carrier) };
        follow.curve = follow.curve.scaled(factor);
    }
}
