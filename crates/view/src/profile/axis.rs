//! Axes with round numbers.

use super::text;

/// The values that a side of a panel shows, and which of them are written.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    pub(crate) low: f64,
    pub(crate) high: f64,
    step: f64,
    /// What is written is the value over this power of ten.
    power: i32,
}

/// Numbers nearer to zero than this are not told apart from it.
const TINY: f64 = 1e-280;

impl Axis {
    /// From `low` to `high` with about `count` round numbers; around a single value where they are the same.
    pub(crate) fn new(low: f64, high: f64, count: f64) -> Self {
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
            return Self { low: low - around, high: low + around, step: 0.0, power };
        }
        let rough = half / (0.5 * count);
        let tens = 10f64.powf(rough.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|round| round * tens).into_iter().find(|step| *step >= rough);
        Self { low, high, step: step.unwrap_or(10.0 * tens), power }
    }

    /// The same with `share` of the span added on both sides, where round numbers stay where they are.
    pub(crate) fn padded(self, share: f64) -> Self {
        let pad = share * (self.high - self.low);
        Self { low: self.low - pad, high: self.high + pad, ..self }
    }

    /// Round numbers with their texts, rising.
    pub(crate) fn ticks(&self) -> Vec<(f64, String)> {
        if self.step <= 0.0 {
            let middle = 0.5 * self.low + 0.5 * self.high;
            return vec![(middle, text::shown(middle / self.scale(), 6))];
        }
        let unit = self.step / self.scale();
        let decimals = (-(unit.log10() + 1e-9).floor()).max(0.0) as usize;
        let (first, last) = ((self.low / self.step).ceil(), (self.high / self.step).floor());
        let count = (last - first).clamp(0.0, 20.0) as usize;
        (0..=count)
            .map(|i| {
                let index = first + i as f64;
                // A zero without a sign.
                let label = format!("{:.decimals$}", index * unit + 0.0).replace('-', "−");
                (index * self.step, label)
            })
            .collect()
    }

    /// Where a value is, from 0 to 1.
    pub(crate) fn share(&self, value: f64) -> f64 {
        let span = 0.5 * self.high - 0.5 * self.low;
        if span > 0.0 { (0.5 * value - 0.5 * self.low) / span } else { 0.0 }
    }

    /// The unit of what is written: "10⁻³ rad".
    pub(crate) fn unit(&self, unit: &str) -> String {
        if self.power == 0 {
            return unit.to_owned();
        }
        text::joined(&format!("10{}", text::superscript(&self.power.to_string())), unit)
    }

    fn scale(&self) -> f64 {
        10f64.powi(self.power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(low: f64, high: f64) -> Vec<String> {
        Axis::new(low, high, 4.0).ticks().into_iter().map(|(_, label)| label).collect()
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
        assert_eq!(Axis::new(0.0, 4e6, 4.0).unit("m/s"), "10⁶ m/s");
        assert_eq!(labels(0.0, 2e-9), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(Axis::new(0.0, 2e-9, 4.0).unit(""), "10⁻⁹");
        assert!(labels(-1e308, 1e308).len() > 2);
    }

    #[test]
    fn one_value_has_one_tick() {
        assert_eq!(labels(3.0, 3.0), ["3"]);
        assert_eq!(labels(0.0, 0.0), ["0"]);
    }
}
