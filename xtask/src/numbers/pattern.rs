//! Patterns: a text in which `#` is the number that is looked for and `*` any other one.

use super::prose::flat;

/// The number where the pattern first fits a text; blanks and line ends are alike.
pub(super) fn found(pattern: &str, text: &str) -> Option<f64> {
    let (pattern, text) = (flat(pattern), flat(text));
    let starts = text.char_indices().map(|(at, _)| at);
    // A number that is only the end of another one is none.
    starts
        .filter(|&at| {
            !(pattern.starts_with(['#', '*'])
                && text[..at].ends_with(|c: char| c.is_ascii_digit() || c == '.'))
        })
        .find_map(|at| fit(&pattern, &text[at..], None))
}

fn fit(pattern: &str, text: &str, number: Option<f64>) -> Option<f64> {
    let Some(first) = pattern.chars().next() else { return number };
    let rest = &pattern[first.len_utf8()..];
    if first == '#' || first == '*' {
        let piece = piece(text);
        let here = piece.parse().ok()?;
        return fit(rest, &text[piece.len()..], if first == '#' { Some(here) } else { number });
    }
    fit(rest, text.strip_prefix(first)?, number)
}

/// What may be a number at the beginning: `-2.5`, `9.9e-4`; the point at the end of a sentence is none of it.
fn piece(text: &str) -> &str {
    let digits = |from: usize, also: &[char]| {
        let end = text[from..].find(|c: char| !c.is_ascii_digit() && !also.contains(&c));
        end.map_or(text.len(), |end| from + end)
    };
    let signed = usize::from(text.starts_with('-'));
    let plain = text[..digits(signed, &['.'])].trim_end_matches('.');
    let Some(exponent) = text[plain.len()..].strip_prefix('e') else { return plain };
    let from = plain.len() + 1 + usize::from(exponent.starts_with('-'));
    let end = digits(from, &[]);
    if end > from { &text[..end] } else { plain }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_is_found_where_the_pattern_fits() {
        let text = "error: --height 0.79: a human figure is 0.8 to\n  2.3 m tall";
        assert_eq!(found("is # to * m tall", text), Some(0.8));
        assert_eq!(found("is * to # m tall", text), Some(2.3));
        assert_eq!(found("is # m tall", text), None);
        assert_eq!(found("TOLD: f64 = #;", "const TOLD: f64 = 0.01;"), Some(0.01));
        assert_eq!(found("# bytes", "1679613 bytes"), Some(1_679_613.0));
        assert_eq!(found("| x | # |", "| x | 9.9e-4 |"), Some(9.9e-4));
        assert_eq!(found("# else", "2 else"), Some(2.0));
        assert_eq!(found("comes to #", "it comes to -2.5."), Some(-2.5));
    }
}
