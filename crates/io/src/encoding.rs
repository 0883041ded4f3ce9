//! The bytes of a file as text.

/// How the letters of a text were written as bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Encoding {
    /// UTF-8, as all texts should be.
    Utf8,
    /// UTF-16, which a mark at the beginning says.
    Utf16,
    /// Windows-1252, of which ISO 8859-1 (Latin-1) is a part: what older programs of Western languages write.
    Windows1252,
}

impl Encoding {
    /// What people call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Utf8 => "UTF-8",
            Self::Utf16 => "UTF-16",
            Self::Windows1252 => "Windows-1252",
        }
    }
}

/// The text of a file of markup, and how it was written: UTF-8 where it is that, UTF-16 where a mark says so, and else
/// Windows-1252, in which every byte but zero may stand.
///
/// # Errors
///
/// The bytes, where they are no text: with zeros in them, or half a letter of UTF-16.
///
/// ```
/// use solaris_io::{Encoding, decode};
/// assert_eq!(decode(b"Universit\xe9".to_vec()), Ok(("Université".to_owned(), Encoding::Windows1252)));
/// ```
pub fn decode(bytes: Vec<u8>) -> Result<(String, Encoding), Vec<u8>> {
    let units = |of: fn([u8; 2]) -> u16| {
        let (pairs, rest) = bytes[2..].as_chunks::<2>();
        let text: Option<String> =
            char::decode_utf16(pairs.iter().map(|pair| of(*pair))).map(Result::ok).collect();
        text.filter(|_| rest.is_empty())
    };
    let wide = match bytes[..] {
        [0xff, 0xfe, ..] => Some(units(u16::from_le_bytes)),
        [0xfe, 0xff, ..] => Some(units(u16::from_be_bytes)),
        _ => None,
    };
    if let Some(wide) = wide {
        return wide.map(|text| (text, Encoding::Utf16)).ok_or(bytes);
    }
    match String::from_utf8(bytes) {
        Ok(text) => Ok((text, Encoding::Utf8)),
        Err(error) if error.as_bytes().contains(&0) => Err(error.into_bytes()),
        Err(error) => {
            Ok((error.as_bytes().iter().map(|byte| letter(*byte)).collect(), Encoding::Windows1252))
        }
    }
}

/// The letter of a byte of Windows-1252; the five bytes that it leaves free are those of Latin-1.
fn letter(byte: u8) -> char {
    const FROM_80: [char; 32] = [
        '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
        '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
    ];
    match byte {
        0x80..=0x9f => FROM_80[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_of_other_times_are_read() {
        let text = "é “fémur” ü";
        assert_eq!(decode(text.into()), Ok((text.to_owned(), Encoding::Utf8)));
        let latin = b"\xe9 \x93f\xe9mur\x94 \xfc".to_vec();
        assert_eq!(decode(latin), Ok((text.to_owned(), Encoding::Windows1252)));
        for (mark, of) in
            [([0xff, 0xfe], u16::to_le_bytes as fn(u16) -> [u8; 2]), ([0xfe, 0xff], u16::to_be_bytes)]
        {
            let mut bytes = mark.to_vec();
            bytes.extend(text.encode_utf16().flat_map(of));
            assert_eq!(decode(bytes.clone()), Ok((text.to_owned(), Encoding::Utf16)));
            bytes.pop();
            assert!(decode(bytes).is_err());
        }
        assert!(decode(b"\x00\xff\x10".to_vec()).is_err());
        assert!(decode(Vec::new()).is_ok());
    }
}
