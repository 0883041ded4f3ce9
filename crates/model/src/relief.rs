//! Ground that is not level: its height along the way.

/// Heights of the ground along z, the way that walkers of generated figures go; it is as high across. Between its points the ground is
/// straight, before the first and after the last one level. Two points at one place are a riser.
///
/// ```
/// use solaris_model::Relief;
///
/// // A ramp of 5 % after two metres, and a kerb at the end of it.
/// let ramp = Relief::new(vec![[2.0, 0.0], [6.0, 0.2], [6.0, 0.1]])?;
/// assert!((ramp.height(4.0) - 0.1).abs() < 1e-12 && ramp.height(7.0) == 0.1);
/// # Ok::<(), solaris_model::ReliefError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "terrain")]
#[doc(alias = "height field")]
pub struct Relief {
    /// Place along z and height (m).
    points: Vec<[f64; 2]>,
}

/// The error of a relief.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReliefError {
    /// Nothing was given.
    #[error("a relief without points; give it one at least: [place along z, height] in m")]
    Empty,
    /// A number is none.
    #[error("point {number} of the relief is [{z}, {height}]; both must be finite numbers (m)")]
    NotFinite {
        /// Which one, from 1 on.
        number: usize,
        /// Its place (m).
        z: f64,
        /// Its height (m).
        height: f64,
    },
    /// The points do not go forward.
    #[error(
        "point {number} of the relief is at {z} m, before the one before it at {before} m; their places must not fall"
    )]
    Backward {
        /// Which one, from 1 on.
        number: usize,
        /// Its place (m).
        z: f64,
        /// That of the one before (m).
        before: f64,
    },
}

impl Relief {
    /// Of points [place along z, height] (m) whose places do not fall.
    ///
    /// # Errors
    ///
    /// No points, numbers that are not finite, places that fall.
    pub fn new(points: Vec<[f64; 2]>) -> Result<Self, ReliefError> {
        if points.is_empty() {
            return Err(ReliefError::Empty);
        }
        for (index, &[z, height]) in points.iter().enumerate() {
            let number = index + 1;
            if !z.is_finite() || !height.is_finite() {
                return Err(ReliefError::NotFinite { number, z, height });
            }
            if let Some(&[before, _]) = index.checked_sub(1).and_then(|i| points.get(i))
                && z < before
            {
                return Err(ReliefError::Backward { number, z, before });
            }
        }
        Ok(Self { points })
    }

    /// Its points: place along z and height (m).
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Height of the ground at a place along z (m); at a riser that of its top.
    pub fn height(&self, z: f64) -> f64 {
        let at = self.points.partition_point(|point| point[0] < z);
        let Some(&[z1, y1]) = self.points.get(at) else {
            return self.points[self.points.len() - 1][1];
        };
        if z1 > z || z.is_nan() {
            let Some(&[z0, y0]) = at.checked_sub(1).map(|before| &self.points[before]) else { return y1 };
            return y0 + (y1 - y0) * (z - z0) / (z1 - z0);
        }
        // All points at this very place.
        self.points[at..].iter().take_while(|point| point[0] <= z).fold(y1, |top, point| top.max(point[1]))
    }

    /// The lowest that the ground is within `reach` of a place (m).
    pub fn lowest_near(&self, z: f64, reach: f64) -> f64 {
        self.near(z, reach).fold(f64::INFINITY, f64::min)
    }

    /// The highest that the ground is within `reach` of a place (m).
    pub fn highest_near(&self, z: f64, reach: f64) -> f64 {
        self.near(z, reach).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Heights at both ends of a stretch about a place, and of every point inside of it.
    fn near(&self, z: f64, reach: f64) -> impl Iterator<Item = f64> {
        let (from, to) = (z - reach, z + reach);
        let first = self.points.partition_point(|point| point[0] <= from);
        let inside = self.points[first..].iter().take_while(move |point| point[0] < to).map(|point| point[1]);
        inside.chain([self.height(from), self.height(to)])
    }

    /// Greatest and least height (m).
    pub fn range(&self) -> (f64, f64) {
        let heights = || self.points.iter().map(|point| point[1]);
        (heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_those_of_the_lines() {
        let relief =
            Relief::new(vec![[0.0, 0.0], [1.0, 0.5], [1.0, 0.2], [3.0, 0.2], [3.0, 0.4]]).expect("a relief");
        for (z, height) in [(-5.0, 0.0), (0.5, 0.25), (1.0, 0.5), (1.5, 0.2), (3.0, 0.4), (9.0, 0.4)] {
            assert!((relief.height(z) - height).abs() < 1e-15, "{z}");
        }
        assert!((relief.lowest_near(3.0, 0.1) - 0.2).abs() < 1e-15);
        assert!((relief.highest_near(0.9, 0.2) - 0.5).abs() < 1e-15);
        assert_eq!(relief.range(), (0.0, 0.5));
    }

    #[test]
    fn what_is_no_relief_is_refused_by_its_number() {
        assert_eq!(Relief::new(Vec::new()), Err(ReliefError::Empty));
        let backward = Relief::new(vec![[0.0, 0.0], [1.0, 0.0], [0.5, 0.0]]).expect_err("backward");
        assert!(backward.to_string().contains("point 3"), "{backward}");
        assert!(matches!(Relief::new(vec![[0.0, f64::NAN]]), Err(ReliefError::NotFinite { number: 1, .. })));
    }
}
