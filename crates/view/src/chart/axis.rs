//! Axes with round numbers.

use super::{joined, shown, superscript};

/// The values that a side of a panel shows, and which of them are written.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Least and greatest: of the values, or of their decimal logarithms.
    low: f64,
    high: f64,
    scale: Scale,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    /// Multiples of `step` are written (none where it is 0), over a power of ten.
    Linear { step: f64, power: i32 },
    /// About `count` of these decades are written.
    Logarithmic { count: usize, first: i32, last: i32 },
    /// Logarithmic, of few decades: 1, 2 and 5 of each are written.
    Decimal,
}

/// Numbers nearer to zero than this are not told apart from it.
const TINY: f64 = 1e-280;
/// What a logarithmic axis draws numbers as that are nearer to zero.
const LEAST: f64 = 1e-30;
/// From so many decades on there are no lines between them.
const MANY_DECADES: i32 = 6;

impl Axis {
    /// From `low` to `high` with about `count` round numbers; around a single value where they are the same.
    ///
    /// ```
    /// use solaris_view::chart::Axis;
    ///
    /// let texts: Vec<String> = Axis::linear(-9.0, 7.0, 4.0).ticks().into_iter().map(|(_, text)| text).collect();
    /// assert_eq!(texts, ["−5", "0", "5"]);
    /// ```
    pub fn linear(low: f64, high: f64, count: f64) -> Self {
        let most = low.abs().max(high.abs());
        let power = match most {
            _ if most < TINY => 0,
            1e-2..1e5 => 0,
            _ => (most.log10() / 3.0).floor() as i32 * 3,
        };
        // Halved, because the difference of large numbers may overflow.
        let half = 0.5 * high - 0.5 * low;
        if half <= 1e-13 * most || half < TINY {
            let around = if most < TINY { 1.0 } else { 0.5 * most };
            return Self { low: low - around, high: low + around, scale: Scale::Linear { step: 0.0, power } };
        }
        let rough = half / (0.5 * count);
        let tens = 10f64.powf(rough.log10().floor());
        let round = [1.0, 2.0, 5.0, 10.0].map(|round| round * tens).into_iter().find(|step| *step >= rough);
        let step = round.unwrap_or(10.0 * tens);
        Self { low, high, scale: Scale::Linear { step, power } }
    }

    /// The linear axis that holds all of `values` (those that are finite), with about `count` round numbers.
    pub fn around(values: impl IntoIterator<Item = f64>, count: f64) -> Self {
        let (low, high) = ends(values);
        if low <= high { Self::linear(low, high, count) } else { Self::linear(0.0, 1.0, count) }
    }

    /// The whole decades that hold all of `values` (above zero), two at least, and at most those from `within`; about
    /// `count` of them are written.
    pub fn logarithmic(values: impl IntoIterator<Item = f64>, within: (i32, i32), count: usize) -> Self {
        let (low, high) = ends(values.into_iter().map(|value| value.max(LEAST).log10()));
        let (mut first, mut last) = if low <= high {
            // Rounded, so that a power of ten itself is no decade more.
            ((low + 1e-9).floor() as i32, (high - 1e-9).ceil() as i32)
        } else {
            (-3, 0)
        };
        first = first.clamp(within.0, within.1 - 1);
        last = last.clamp(first + 1, within.1.max(first + 1));
        if last - first < 2 && first > within.0 {
            first -= 1;
        }
        Self { low: first.into(), high: last.into(), scale: Scale::Logarithmic { count, first, last } }
    }

    /// A logarithmic axis of few decades, between numbers of 1, 2, 5, 10, 20, …, which are written: those that hold all of
    /// `values` (above zero).
    pub fn decimal(values: impl IntoIterator<Item = f64>) -> Self {
        let (low, high) = ends(values.into_iter().map(|value| value.max(LEAST).log10()));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 1.0) };
        let numbers: Vec<f64> =
            decimals(low.floor() as i32 - 1..=high.ceil() as i32).map(f64::log10).collect();
        let below = numbers.iter().rev().find(|number| **number <= low + 1e-9);
        let above = numbers.iter().find(|number| **number >= high - 1e-9 && **number > low + 1e-9);
        let [low, high] = [below.copied().unwrap_or(low), above.copied().unwrap_or(high + 1.0)];
        Self { low, high, scale: Scale::Decimal }
    }

    /// The same with `share` of the span added on both sides, where round numbers stay where they are.
    pub fn padded(self, share: f64) -> Self {
        let pad = share * (self.high - self.low);
        Self { low: self.low - pad, high: self.high + pad, ..self }
    }

    /// Round numbers with their texts, rising; the text is empty where there are too many.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        match self.scale {
            Scale::Linear { step, power } if step <= 0.0 => {
                let middle = 0.5 * self.low + 0.5 * self.high;
                vec![(middle, shown(middle / 10f64.powi(power), 6))]
            }
            Scale::Linear { step, power } => {
                let unit = step / 10f64.powi(power);
                let decimals = (-(unit.log10() + 1e-9).floor()).max(0.0) as usize;
                let (first, last) = ((self.low / step).ceil(), (self.high / step).floor());
                let count = (last - first).clamp(0.0, 20.0) as usize;
                (0..=count)
                    .map(|i| {
                        let index = first + i as f64;
                        // A zero without a sign.
                        (index * step, format!("{:.decimals$}", index * unit + 0.0).replace('-', "−"))
                    })
                    .collect()
            }
            Scale::Decimal => {
                let inside = |value: &f64| (self.low - 1e-9..=self.high + 1e-9).contains(&value.log10());
                decimals(self.low.floor() as i32..=self.high.ceil() as i32)
                    .filter(inside)
                    .map(|value| (value, shown(value, 3)))
                    .collect()
            }
            Scale::Logarithmic { count, first, last } => {
                let every = last.abs_diff(first).div_ceil(count.max(1) as u32).max(1) as i32;
                let text = |power: i32| {
                    if power.rem_euclid(every) == 0 { power_of_ten(power) } else { String::new() }
                };
                (first..=last).map(|power| (10f64.powi(power), text(power))).collect()
            }
        }
    }

    /// Two to nine of every decade, where there are few enough of them; nothing on other axes.
    pub fn between(&self) -> Vec<f64> {
        let Scale::Logarithmic { first, last, .. } = self.scale else { return Vec::new() };
        if last - first >= MANY_DECADES {
            return Vec::new();
        }
        let of_decade = |power| (2..10).map(move |digit| f64::from(digit) * 10f64.powi(power));
        (first..last).flat_map(of_decade).collect()
    }

    /// Where a value is, from 0 to 1 between the ends. A logarithmic axis holds values at its ends.
    pub fn share(&self, value: f64) -> f64 {
        if self.is_logarithmic() {
            let power = value.max(LEAST).log10() - self.low;
            return (power / (self.high - self.low)).clamp(0.0, 1.0);
        }
        let span = 0.5 * self.high - 0.5 * self.low;
        if span > 0.0 { (0.5 * value - 0.5 * self.low) / span } else { 0.0 }
    }

    /// The unit of what is written: "10⁻³ rad".
    pub fn unit(&self, unit: &str) -> String {
        match self.scale {
            Scale::Linear { power, .. } if power != 0 => {
                joined(&format!("10{}", superscript(&power.to_string())), unit)
            }
            _ => unit.to_owned(),
        }
    }

    pub(super) fn is_logarithmic(&self) -> bool {
        !matches!(self.scale, Scale::Linear { .. })
    }
}

/// 1, 2 and 5 of every decade.
fn decimals(decades: std::ops::RangeInclusive<i32>) -> impl Iterator<Item = f64> {
    decades.flat_map(|power| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(power)))
}

/// The least and the greatest that are finite.
fn ends(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
    let finite = values.into_iter().filter(|value| value.is_finite());
    finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
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

    fn texts(axis: &Axis) -> Vec<String> {
        axis.ticks().into_iter().map(|(_, label)| label).filter(|label| !label.is_empty()).collect()
    }

    fn labels(low: f64, high: f64) -> Vec<String> {
        texts(&Axis::linear(low, high, 4.0))
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(labels(-0.3, 1.1), ["0.0", "0.5", "1.0"]);
        assert_eq!(labels(-9.0, 7.0), ["−5", "0", "5"]);
        assert_eq!(labels(0.0, 2.0), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
    }

    #[test]
    fn very_large_and_very_small_numbers_have_a_power_of_ten() {
        assert_eq!(labels(0.0, 4e6), ["0", "1", "2", "3", "4"]);
        assert_eq!(Axis::linear(0.0, 4e6, 4.0).unit("m/s"), "10⁶ m/s");
        assert_eq!(labels(0.0, 2e-9), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(Axis::linear(0.0, 2e-9, 4.0).unit(""), "10⁻⁹");
        assert!(labels(-1e308, 1e308).len() > 2);
    }

    #[test]
    fn one_value_has_one_tick() {
        assert_eq!(labels(3.0, 3.0), ["3"]);
        assert_eq!(labels(0.0, 0.0), ["0"]);
    }

    #[test]
    fn decades_hold_their_values_and_no_more() {
        let of = |values: &[f64], within| {
            let axis = Axis::logarithmic(values.iter().copied(), within, 9);
            (axis.low as i32, axis.high as i32)
        };
        let wide = (-20, 20);
        assert_eq!(of(&[2e-7, 0.3], wide), (-7, 0));
        assert_eq!(of(&[1e-6, 1e-3], wide), (-6, -3));
        assert_eq!(of(&[5.0], wide), (-1, 1));
        assert_eq!(of(&[], wide), (-3, 0));
        assert_eq!(of(&[0.0, 1e9, f64::NAN], (-17, 1)), (-17, 1));
    }

    #[test]
    fn shares_run_from_zero_to_one() {
        let axis = Axis::logarithmic([1e-4, 1.0], (-20, 20), 9);
        for (x, share) in [(1e-4, 0.0), (1e-3, 0.25), (1.0, 1.0), (1e3, 1.0), (0.0, 0.0)] {
            assert!((axis.share(x) - share).abs() < 1e-15, "{x}");
        }
        assert!((Axis::linear(-1.0, 3.0, 4.0).share(0.0) - 0.25).abs() < 1e-15);
    }

    #[test]
    fn an_axis_of_few_decades_ends_at_numbers_that_are_written() {
        assert_eq!(texts(&Axis::decimal([7.0, 160.0])), ["5", "10", "20", "50", "100", "200"]);
        assert_eq!(texts(&Axis::decimal([10.0, 20.0])), ["10", "20"]);
        assert_eq!(texts(&Axis::decimal([1.0])), ["1", "2"]);
    }

    #[test]
    fn few_decades_are_written_and_lines_stand_between_few() {
        let axis = Axis::logarithmic([1e-9, 10.0], (-20, 20), 5);
        assert_eq!(texts(&axis), ["10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "1"]);
        assert!(axis.between().is_empty());
        assert_eq!(Axis::logarithmic([1.0, 100.0], (-20, 20), 5).between().len(), 16);
    }
}
