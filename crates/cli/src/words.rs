//! Numbers and names as people read them, and lines of a summary.

pub(crate) use solaris::files::short;

use solaris::profiles::{Range, Ranges};
use std::io::{Result, Write};

/// A line of a summary; what has no name goes on with the line before it.
pub(crate) fn row(out: &mut dyn Write, what: &str, value: &str) -> Result<()> {
    writeln!(out, "  {what:<18}{value}")
}

/// A mass as people read it: to a milligram. JSON has all digits.
pub(crate) fn rounded(mass: f64) -> String {
    let text = format!("{mass:.6}");
    text.trim_end_matches('0').trim_end_matches('.').trim_start_matches('-').to_owned()
}

/// As labels begin.
pub(crate) fn capital(what: &str) -> String {
    let mut letters = what.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Names as far as a person reads them.
pub(crate) fn some(names: &[String]) -> String {
    const MANY: usize = 8;
    let shown = names[..names.len().min(MANY)].join(", ");
    if names.len() > MANY { format!("{shown} and {} more", names.len() - MANY) } else { shown }
}

/// A count with its noun.
pub(crate) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// Digits of a bound that people read.
const DIGITS: usize = 7;

/// The nearest number of few digits that is not greater.
pub(crate) fn inward(x: f64) -> f64 {
    let parse = |text: String| text.parse::<f64>().unwrap_or(x);
    let near = parse(format!("{x:.*e}", DIGITS - 1));
    if near <= x || !x.is_finite() {
        return near;
    }
    let unit = 10f64.powf(x.abs().log10().floor() - (DIGITS as f64 - 1.0));
    parse(format!("{:.*e}", DIGITS - 1, x - unit))
}

/// An upper bound with few digits: as it is typed it is not beyond.
pub(crate) fn at_most(x: f64) -> String {
    digits(inward(x))
}

/// A lower bound with few digits: as it is typed it is not below.
pub(crate) fn at_least(x: f64) -> String {
    digits(-inward(-x))
}

/// Ranges with few digits, rounded inwards: what is read is in them.
pub(crate) fn ranges(all: &[Range]) -> String {
    let inside = |range: &Range| Range::new(range.low.map(|x| -inward(-x)), range.high.map(inward));
    Ranges::new(all.iter().map(inside)).to_string()
}

/// A number of few digits as it is typed; sizes that nobody counts zeros of by their power.
fn digits(x: f64) -> String {
    let x = x + 0.0;
    if x != 0.0 && !(1e-5..1e15).contains(&x.abs()) { format!("{x:e}") } else { x.to_string() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::Bound;

    #[test]
    fn bounds_are_rounded_inwards() {
        let range = Range::new(Bound::Included(0.1), Bound::Excluded(9.330_127_018_922_193));
        assert_eq!(ranges(&[range]), "at least 0.1 and less than 9.330127");
        let outside = Ranges::outside(-2.0 / 3.0, 2.0 / 3.0);
        assert_eq!(ranges(outside.as_slice()), "at most -0.6666667, or at least 0.6666667");
        assert_eq!(ranges(&[Range::at_least(1.0 / 3.0)]), "at least 0.3333334");
        assert_eq!([at_least(2.0 / 3.0), at_most(2.0 / 3.0)], ["0.6666667", "0.6666666"]);
        assert_eq!([at_least(1e-13), at_most(7122.0), at_most(0.1)], ["1e-13", "7122", "0.1"]);
    }
}
