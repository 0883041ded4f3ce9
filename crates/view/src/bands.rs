//! Half widths of the areas around curves.

use crate::error::ViewError;
use crate::pack::{Packed, stepped};
use solaris_model::{Figure, Motion};

/// How far the truth may be from a motion's numbers, to each side: one half width a sample and degree of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bands<'a> {
    values: Option<&'a [f64]>,
    dofs: usize,
}

impl<'a> Bands<'a> {
    /// Bands around `what`; none are fine.
    ///
    /// # Errors
    ///
    /// Not one number for each sample and degree of freedom, a number that is negative or not finite.
    pub(crate) fn checked(
        values: Option<&'a [f64]>,
        what: &'static str,
        figure: &Figure,
        motion: &Motion,
    ) -> Result<Self, ViewError> {
        let dofs = figure.layout().nv();
        let all = values.unwrap_or_default();
        let (found, expected) = (all.len(), motion.len() * dofs);
        if values.is_some() && found != expected {
            return Err(ViewError::BandLength { what, found, expected, dofs });
        }
        match all.iter().position(|value| !value.is_finite() || *value < 0.0) {
            Some(at) => Err(ViewError::BandWidth {
                what,
                dof: figure.layout().v_names()[at % dofs].clone(),
                time: motion.time()[at / dofs],
                value: all[at],
            }),
            None => Ok(Self { values, dofs }),
        }
    }

    /// Those of one degree of freedom, `factor` times as wide; `None` where nothing is known.
    pub(crate) fn around(&self, dof: usize, chosen: &[usize], factor: f64) -> Option<Packed> {
        let all = self.values?;
        let widths: Vec<f64> =
            chosen.iter().map(|sample| factor.abs() * all[sample * self.dofs + dof]).collect();
        let widest = widths.iter().copied().fold(0.0, f64::max);
        // In steps from zero, so that zero stays zero: the page says nothing there.
        (widest > 0.0).then(|| stepped(&widths, widest / f64::from(i16::MAX), 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_known_at_a_time_is_exactly_zero_there() {
        let widths = [9.0, 0.0, 9.0, 0.3, 9.0, 0.1];
        let bands = Bands { values: Some(&widths), dofs: 2 };
        let spread = bands.around(1, &[0, 1, 2], -2.0).expect("some is known").unpack();
        assert_eq!(spread[0].to_bits(), 0.0_f64.to_bits());
        assert!((spread[1] - 0.6).abs() < 1e-12 && (spread[2] - 0.2).abs() < 0.6 / 65_534.0, "{spread:?}");
    }

    #[test]
    fn where_nothing_is_known_there_is_no_band() {
        assert_eq!(Bands { values: Some(&[0.0; 6]), dofs: 2 }.around(0, &[0, 2], 1.0), None);
        assert_eq!(Bands { values: None, dofs: 2 }.around(0, &[0, 2], 1.0), None);
    }
}
