//! Scaling of a figure to another subject's height, mass and segment lengths, or by factors for the axes of its links.

mod contents;
mod error;
mod factors;
mod links;
mod mass;
mod stretch;

pub(crate) use mass::exact_total;

pub use contents::stretched_inertia;
pub use error::ScaleError;
pub use stretch::{MassShares, Stretching};

use crate::figure::Figure;
use crate::lint::sides::mates;
use std::collections::HashMap;

/// Factors that lengths and masses may be scaled by.
const RANGE: (f64, f64) = (1e-6, 1e6);

/// The targets of scaling a figure; what is `None` or not named stays.
///
/// ```
/// use solaris_model::{Scaling, human};
/// let scaling = Scaling { height: Some(1.62), mass: Some(54.3), segments: vec![("thigh".into(), 0.41)] };
/// let ann = human(1.75, 73.0)?.scaled(&scaling)?;
/// assert_eq!((ann.stature(), ann.mass()), (Some(1.62), 54.3));
/// assert!((ann.segment_length("left_thigh").unwrap() - 0.41).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "scale factors")]
#[doc(alias = "ScaleTool")]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scaling {
    /// Standing height (m).
    pub height: Option<f64>,
    /// Total mass (kg).
    pub mass: Option<f64>,
    /// Lengths of single segments (m), by link: see [`Figure::segment_length`]. Where no link has the name, it may be
    /// that of a left and a right one without their side (`thigh`, `femur`). Of several lengths for one link the last
    /// counts.
    pub segments: Vec<(String, f64)>,
}

impl Figure {
    /// The length of a link as scaling knows it (m): from its joint to the joint of its child, to the farthest one where
    /// it has several; where it has none away from its own joint, to its tip. `None` where it has neither, and for a name
    /// that is no link's.
    pub fn segment_length(&self, link: &str) -> Option<f64> {
        self.link_index(link).and_then(|link| links::reaches(self)[link])
    }

    /// The links that are a left and a right one of the same name, as `left_thigh` and `right_thigh`, `femur_l` and `femur_r`:
    /// their indices, the left one first.
    pub fn mates(&self) -> Vec<[usize; 2]> {
        mates(&self.links).into_iter().map(|pair| [pair.left, pair.right]).collect()
    }

    /// The figure scaled to a height, a mass, and lengths of segments.
    ///
    /// Every link scales alike in all directions, by its own factor `s`: that of the height (`height / stature`), or for
    /// a segment with a length of its own, that length over the one it has. `s` scales its centre of mass, shape, tip,
    /// sole and frames, where its children's joints sit, and what their slides measure: limits, springs' rests, and the
    /// curves of slides that follow (the place of the root's joint and its slides scale with the height). Masses scale by
    /// one factor, so that each keeps its share, and inertias by mass times `s²`:
    ///
    /// ```text
    /// m′ = m·M′/M        I′ = I·(m′/m)·s²
    /// ```
    ///
    /// The total is the asked mass to the last bit: what rounding leaves goes to the heaviest link. Without a mass in
    /// `scaling` all masses stay. Angles, their limits, and everything of joints that is no length — armature, stiffness,
    /// damping, friction — stay as they are; so does the stature where no height is asked for. Scaling by one changes no
    /// bit.
    ///
    /// # Errors
    ///
    /// [`ScaleError`] for numbers that are no lengths or masses, a height where the figure has no stature, a mass where it has
    /// none, names that are no links' and links without a length.
    #[doc(alias = "scale")]
    #[doc(alias = "anthropometry")]
    #[doc(alias = "ScaleTool")]
    pub fn scaled(&self, scaling: &Scaling) -> Result<Self, ScaleError> {
        let all = self.height_factor(scaling.height)?;
        let lengths = self.length_factors(&scaling.segments, all)?;
        let masses = self.scaled_masses(scaling.mass)?;
        let scaled = links::scaled(self, all, &lengths, &masses);
        if let Some(bad) = scaled.iter().find(|link| !links::is_finite(link)) {
            return Err(ScaleError::NotFinite { link: bad.name.clone() });
        }
        let figure = self.with_links(scaled);
        Ok(Self { stature: scaling.height.or(self.stature), ..figure })
    }

    fn height_factor(&self, height: Option<f64>) -> Result<f64, ScaleError> {
        let Some(height) = height else { return Ok(1.0) };
        if !(height > 0.0 && height.is_finite()) {
            return Err(ScaleError::Height { height });
        }
        let stature = self.stature.ok_or_else(|| ScaleError::NoStature { figure: self.name.clone() })?;
        in_range("height", stature, height)
    }

    /// The factor of every link's lengths.
    fn length_factors(&self, segments: &[(String, f64)], all: f64) -> Result<Vec<f64>, ScaleError> {
        let mut factors = vec![all; self.links.len()];
        if segments.is_empty() {
            return Ok(factors);
        }
        let (mates, reaches) = (mates(&self.links), links::reaches(self));
        let mut pairs: HashMap<&str, Vec<usize>> = HashMap::new();
        for mate in &mates {
            pairs.entry(&mate.stem).or_default().extend([mate.left, mate.right]);
        }
        for (name, length) in segments {
            let named = match self.link_index(name) {
                Some(link) => vec![link],
                None => pairs.get(name.as_str()).cloned().unwrap_or_default(),
            };
            if named.is_empty() {
                let links = self.links.iter().map(|link| link.name.as_str());
                let nearest = crate::nearest(name, links.chain(pairs.keys().copied()));
                return Err(ScaleError::UnknownSegment { name: name.clone(), nearest });
            }
            for link in named {
                let name = || self.links[link].name.clone();
                if !(*length > 0.0 && length.is_finite()) {
                    return Err(ScaleError::SegmentLength { name: name(), length: *length });
                }
                let reach = reaches[link].ok_or_else(|| ScaleError::NoLength { name: name() })?;
                factors[link] = in_range(&format!("length of segment '{}'", name()), reach, *length)?;
            }
        }
        Ok(factors)
    }

    fn scaled_masses(&self, mass: Option<f64>) -> Result<Vec<f64>, ScaleError> {
        let mut masses: Vec<f64> = self.links.iter().map(|link| link.mass).collect();
        let Some(mass) = mass else { return Ok(masses) };
        if !(mass > 0.0 && mass.is_finite()) {
            return Err(ScaleError::Mass { mass });
        }
        let from = self.mass();
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

/// `to / from`, if that is a factor to scale by.
fn in_range(what: &str, from: f64, to: f64) -> Result<f64, ScaleError> {
    let factor = to / from;
    if (RANGE.0..=RANGE.1).contains(&factor) {
        return Ok(factor);
    }
    Err(ScaleError::Factor { what: what.to_owned(), from, to, factor })
}
