//! Numbers and words as pictures have them.

/// A number with so many significant digits, zeros at the end left out; "unbounded" where it is infinite.
pub fn number(x: f64, digits: usize) -> String {
    if !x.is_finite() {
        return if x.is_nan() { "undefined" } else { "unbounded" }.to_owned();
    }
    let scientific = format!("{x:.*e}", digits.saturating_sub(1));
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let short = |text: &str| {
        let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text };
        if text == "-0" { "0".to_owned() } else { text.to_owned() }
    };
    if (-4..digits as i32 + 1).contains(&exponent) {
        short(&format!("{x:.*}", (digits as i32 - 1 - exponent).max(0) as usize))
    } else {
        format!("{}e{exponent}", short(mantissa))
    }
}

/// The same for people who look at a picture: with a minus sign and powers of ten.
pub fn shown(x: f64, digits: usize) -> String {
    let text = number(x, digits).replace('-', "−");
    match text.split_once('e') {
        Some((mantissa, exponent)) if x.is_finite() => format!("{mantissa} · 10{}", superscript(exponent)),
        _ => text,
    }
}

/// Digits of an exponent.
pub fn superscript(exponent: &str) -> String {
    let raised = |c: char| match c {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '-' | '−' => '⁻',
        digit => digit.to_digit(10).and_then(|d| char::from_u32(0x2070 + d)).unwrap_or(digit),
    };
    exponent.chars().map(raised).collect()
}

/// Text for elements and quoted attributes.
pub fn escape(text: &str) -> String {
    crate::html::escape(text)
}

/// Two words with a space between them; one alone where the other is empty.
pub(crate) fn joined(a: &str, b: &str) -> String {
    if a.is_empty() || b.is_empty() { format!("{a}{b}") } else { format!("{a} {b}") }
}

/// About how wide a text is in the fonts of the picture (px), rather more than less.
pub fn width(text: &str, size: f64) -> f64 {
    let em = |c: char| match c {
        'i' | 'j' | 'l' | '\'' | '|' => 0.25,
        ' ' | '.' | ',' | ':' | ';' | 't' | 'f' | 'I' | '(' | ')' | '/' | '-' | 'r' | '·' => 0.36,
        'm' | 'w' | 'M' | 'W' | '%' | '@' => 0.92,
        'A'..='Z' => 0.74,
        '¹' | '²' | '³' | '⁰'..='ⁿ' => 0.4,
        '\u{0}'..='\u{2fff}' => 0.6,
        _ => 1.1,
    };
    size * text.chars().map(em).sum::<f64>()
}

/// A text cut to a width, with an ellipsis where something is missing.
pub fn cut(text: &str, size: f64, most: f64) -> String {
    if width(text, size) <= most {
        return text.to_owned();
    }
    let mut short = String::new();
    for c in text.chars() {
        if width(&short, size) + width("…", size) + size > most {
            break;
        }
        short.push(c);
    }
    short.trim_end().to_owned() + "…"
}

/// A text in lines of a width, at most so many.
pub fn lines(text: &str, size: f64, most: f64, count: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let full = lines.len() == count;
        match lines.last_mut() {
            // What does not fit into the last line is cut off there.
            Some(line) if full || width(&format!("{line} {word}"), size) <= most => {
                *line = joined(line, word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| cut(line, size, most)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_as_short_as_their_digits() {
        let texts = [0.0, -0.0, 0.5, 1.875, 1e-9, 123_456.0, 2.0 / 3.0, -4e20].map(|x| number(x, 4));
        assert_eq!(texts, ["0", "0", "0.5", "1.875", "1e-9", "1.235e5", "0.6667", "-4e20"]);
        assert_eq!(number(99_999.6, 4), "1e5");
        assert_eq!(number(f64::NEG_INFINITY, 4), "unbounded");
        assert_eq!(shown(-1.5e-9, 3), "−1.5 · 10⁻⁹");
    }

    #[test]
    fn long_texts_are_broken_and_cut() {
        let text = "start velocity 1, end velocity 2, stiffness 3";
        assert_eq!(lines(text, 10.0, 1e3, 2), [text]);
        let broken = lines(text, 10.0, 90.0, 2);
        assert_eq!(broken.len(), 2);
        assert!(
            broken[1].ends_with('…') && broken.iter().all(|line| width(line, 10.0) <= 90.0),
            "{broken:?}"
        );
    }
}
