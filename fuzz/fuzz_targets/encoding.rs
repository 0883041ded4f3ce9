//! Bytes as text.
#![no_main]

use solaris_fuzz::target;
use solaris_io::{Encoding, decode};

target!(|bytes: &[u8]| match decode(bytes.to_vec()) {
    Ok((text, Encoding::Utf8)) => assert_eq!(text.as_bytes(), bytes),
    Ok((text, Encoding::Utf16)) => assert_eq!(text.encode_utf16().count(), bytes.len() / 2 - 1),
    Ok((text, _)) => assert_eq!(text.chars().count(), bytes.len()),
    Err(back) => assert_eq!(back, bytes),
});
