//! A logarithmic axis.

use crate::profile::text::superscript;

/// The decades that a side of the picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Decades {
    first: i32,
    last: i32,
}

/// Numbers nearer to zero than this are drawn as if they were this.
pub(super) const LEAST: f64 = 1e-17;

impl Decades {
    /// The whole decades that hold all of `values` (above zero), two at least, and at most those from `within`.
    pub(super) fn around(values: impl IntoIterator<Item = f64>, within: (i32, i32)) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.into_iter().filter(|value| value.is_finite()) {
            let power = value.max(LEAST).log10();
            (low, high) = (low.min(power), high.max(power));
        }
        if low > high {
            return Self { first: -3, last: 0 };
        }
        // Rounded, so that a power of ten itself is no decade more.
        let (mut first, mut last) = ((low + 1e-9).floor() as i32, (high - 1e-9).ceil() as i32);
        first = first.clamp(within.0, within.1 - 1);
        last = last.clamp(first + 1, within.1.max(first + 1));
        if last - first < 2 && first > within.0 {
            first -= 1;
        }
        Self { first, last }
    }

    /// Where a value is, from 0 to 1; held at the ends.
    pub(super) fn share(self, value: f64) -> f64 {
        let power = value.max(LEAST).log10() - f64::from(self.first);
        (power / f64::from(self.last - self.first)).clamp(0.0, 1.0)
    }

    /// The decades with their texts, so few that about `most` are written.
    pub(super) fn ticks(self, most: usize) -> Vec<(f64, Option<String>)> {
        let every = ((self.last - self.first) as usize).div_ceil(most.max(1)).max(1) as i32;
        let label = |power: i32| (power.rem_euclid(every) == 0).then(|| power_of_ten(power));
        (self.first..=self.last).map(|power| (10_f64.powi(power), label(power))).collect()
    }

    /// Two to nine of every decade, where there are few enough of them.
    pub(super) fn between(self) -> Vec<f64> {
        if self.last - self.first > 5 {
            return Vec::new();
        }
        (self.first..self.last)
            .flat_map(|power| (2..10).map(move |digit| f64::from(digit) * 10_f64.powi(power)))
            .collect()
    }
}

/// `10⁻³`; plain numbers near one.
fn power_of_ten(power: i32) -> String {
    match power {
        0 => "1".to_owned(),
        1 => "10".to_owned(),
        _ => format!("10{}", superscript(&power.to_string())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDE: (i32, i32) = (-20, 20);

    #[test]
    fn decades_hold_their_values_and_no_more() {
        let of = |values: &[f64], within| Decades::around(values.iter().copied(), within);
        assert_eq!(of(&[2e-7, 0.3], WIDE), Decades { first: -7, last: 0 });
        assert_eq!(of(&[1e-6, 1e-3], WIDE), Decades { first: -6, last: -3 });
        assert_eq!(of(&[5.0], WIDE), Decades { first: -1, last: 1 });
        assert_eq!(of(&[], WIDE), Decades { first: -3, last: 0 });
        assert_eq!(of(&[0.0, 1e9, f64::NAN], (-17, 1)), Decades { first: -17, last: 1 });
    }

    #[test]
    fn shares_run_from_zero_to_one() {
        let axis = Decades { first: -4, last: 0 };
        for (x, share) in [(1e-4, 0.0), (1e-3, 0.25), (1.0, 1.0), (1e3, 1.0), (0.0, 0.0)] {
            assert!((axis.share(x) - share).abs() < 1e-15, "{x}");
        }
    }

    #[test]
    fn few_decades_are_written() {
        let axis = Decades { first: -9, last: 1 };
        let texts: Vec<String> = axis.ticks(5).into_iter().filter_map(|(_, text)| text).collect();
        assert_eq!(texts, ["10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "1"]);
    }
}
