//! Numbers as people read them.

use crate::table::fixed;

/// At most four decimals, and no zeros at the end: `110`, `72.8875`.
pub(crate) fn short(value: f64) -> String {
    let text = fixed(value, 4);
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Decimals enough to see on which side of its band a value lies: 13.01 beside 9 to 13.
pub(super) fn beside(value: f64, (lower, upper): (f64, f64), decimals: usize) -> String {
    let inside = |value: f64| (lower..=upper).contains(&value);
    let shows = |text: &String| text.parse().is_ok_and(|shown| inside(shown) == inside(value));
    let mut tries = (decimals..decimals + 6).map(|decimals| fixed(value, decimals));
    tries.clone().find(shows).or_else(|| tries.next_back()).unwrap_or_default()
}

/// Items with commas between, broken into lines of `width` columns that begin with `indent` spaces.
pub(super) fn wrapped(items: &[String], indent: usize, width: usize) -> String {
    let (mut text, mut column) = (String::new(), indent);
    for (i, item) in items.iter().enumerate() {
        let comma = if i + 1 < items.len() { "," } else { "" };
        let length = item.chars().count() + comma.len();
        if column > indent && column + 1 + length > width {
            text.push('\n');
            text.extend(std::iter::repeat_n(' ', indent));
            column = indent;
        } else if column > indent {
            text.push(' ');
            column += 1;
        }
        text.push_str(item);
        text.push_str(comma);
        column += length;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_no_needless_digits() {
        let cases = [(110.0, "110"), (73.0, "73"), (72.8875, "72.8875"), (1.0 / 3.0, "0.3333"), (-1e-9, "0")];
        for (value, text) in cases {
            assert_eq!(short(value), text);
        }
        assert_eq!((fixed(-0.0004, 3), fixed(-0.0006, 3)), ("0.000".to_owned(), "-0.001".to_owned()));
    }

    #[test]
    fn a_value_near_its_band_shows_its_side() {
        assert_eq!(beside(12.96, (9.0, 13.0), 1), "13.0");
        assert_eq!(beside(13.012, (9.0, 13.0), 1), "13.01");
        assert_eq!(beside(108.17, (100.0, 120.0), 1), "108.2");
        assert_eq!(beside(9.0 - 1e-12, (9.0, 13.0), 1), "9.000000");
    }

    #[test]
    fn lines_break_between_items() {
        let items = ["knee", "hip range", "ankle"].map(str::to_owned);
        assert_eq!(wrapped(&items, 2, 17), "knee,\n  hip range,\n  ankle");
        assert_eq!(wrapped(&items, 2, 18), "knee, hip range,\n  ankle");
        assert_eq!(wrapped(&[], 2, 20), "");
    }
}
