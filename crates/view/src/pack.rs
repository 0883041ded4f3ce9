//! Arrays of numbers as text: base64 of little-endian floats or integers.

use base64::{Engine as _, engine::general_purpose::STANDARD};
use serde::Serialize;

/// An array as it stands in the page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(crate) enum Packed {
    /// 32-bit floats.
    Floats {
        /// Base64.
        f32: String,
    },
    /// `value = offset + scale · integer` of 16 bits.
    Integers {
        /// Value of one step.
        scale: f64,
        /// Value of zero.
        offset: f64,
        /// Base64.
        i16: String,
    },
    /// Numbers from 0 to 255.
    Bytes {
        /// Base64.
        u8: String,
    },
    /// Numbers from 0 to 65 535.
    Words {
        /// Base64.
        u16: String,
    },
}

/// As bytes.
pub(crate) fn bytes(values: impl IntoIterator<Item = u8>) -> Packed {
    Packed::Bytes { u8: STANDARD.encode(values.into_iter().collect::<Vec<u8>>()) }
}

/// As two bytes each.
pub(crate) fn words(values: impl IntoIterator<Item = u16>) -> Packed {
    let bytes: Vec<u8> = values.into_iter().flat_map(u16::to_le_bytes).collect();
    Packed::Words { u16: STANDARD.encode(bytes) }
}

/// As 32-bit floats.
pub(crate) fn floats(values: impl IntoIterator<Item = f64>) -> Packed {
    let bytes: Vec<u8> = values.into_iter().flat_map(|value| (value as f32).to_le_bytes()).collect();
    Packed::Floats { f32: STANDARD.encode(bytes) }
}

/// As 16-bit integers over the values' own range: off by at most `(max − min)/131 070`.
pub(crate) fn ranged(values: &[f64]) -> Packed {
    let (low, high) = values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| (value.min(low), value.max(high)));
    if values.is_empty() || (high - low) / STEPS < f64::MIN_POSITIVE {
        return stepped(values, 0.0, low.min(high));
    }
    stepped(values, (high - low) / STEPS, f64::midpoint(low, high))
}

/// Steps between −32 767 and 32 767.
const STEPS: f64 = 65_534.0;

/// As 16-bit integers in steps of `scale` from `offset`; values out of reach are clamped.
pub(crate) fn stepped(values: &[f64], scale: f64, offset: f64) -> Packed {
    let integer = |value: f64| if scale > 0.0 { ((value - offset) / scale).round() as i16 } else { 0 };
    let bytes: Vec<u8> = values.iter().flat_map(|&value| integer(value).to_le_bytes()).collect();
    Packed::Integers {
        scale,
        offset: if offset.is_finite() { offset } else { 0.0 },
        i16: STANDARD.encode(bytes),
    }
}

#[cfg(test)]
impl Packed {
    /// The numbers again, as the page reads them.
    pub(crate) fn unpack(&self) -> Vec<f64> {
        let decode = |text: &String| STANDARD.decode(text).expect("own base64");
        match self {
            Self::Floats { f32: text } => {
                let bytes = decode(text);
                bytes.as_chunks::<4>().0.iter().map(|four| f64::from(f32::from_le_bytes(*four))).collect()
            }
            Self::Bytes { u8: text } => decode(text).iter().map(|byte| f64::from(*byte)).collect(),
            Self::Words { u16: text } => {
                let bytes = decode(text);
                bytes.as_chunks::<2>().0.iter().map(|two| f64::from(u16::from_le_bytes(*two))).collect()
            }
            Self::Integers { scale, offset, i16: text } => {
                let bytes = decode(text);
                bytes
                    .as_chunks::<2>()
                    .0
                    .iter()
                    .map(|two| offset + scale * f64::from(i16::from_le_bytes(*two)))
                    .collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::{assert_abs_diff_eq, assert_relative_eq};

    #[test]
    fn a_range_comes_back_within_half_a_step() {
        let values: Vec<f64> = (0..1000).map(|i| 900.0 * (f64::from(i) * 0.37).sin() + 250.0).collect();
        let back = ranged(&values).unpack();
        let worst = values.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst <= 1800.0 / 131_068.0 * 1.000_001, "{worst}");
        assert!(worst > 1800.0 / 131_068.0 * 0.9, "the range is used: {worst}");
    }

    #[test]
    fn a_constant_comes_back_exactly() {
        assert_eq!(ranged(&[0.1; 3]), Packed::Integers { scale: 0.0, offset: 0.1, i16: "AAAAAAAA".into() });
        assert_relative_eq!(ranged(&[-7.25; 2]).unpack()[1], -7.25);
        assert!(ranged(&[]).unpack().is_empty());
        assert_relative_eq!(ranged(&[0.0, 1e-320]).unpack()[0], 0.0);
    }

    #[test]
    fn floats_are_little_endian() {
        assert_eq!(floats([1.0]), Packed::Floats { f32: "AACAPw==".into() });
        assert_abs_diff_eq!(floats([0.1, 2.5]).unpack()[1], 2.5);
    }
}
