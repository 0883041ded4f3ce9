//! The palette of skins as a picture: PNG without compression, for a strip has next to nothing to compress.

use solaris_skin::colour_at;

/// Pixels of the strip along and across.
const WIDE: u32 = 576;
const HIGH: u32 = 4;

pub(super) fn png() -> Vec<u8> {
    let mut rows = Vec::new();
    for _ in 0..HIGH {
        // Each row says first that it is not filtered.
        rows.push(0);
        rows.extend((0..WIDE).flat_map(|i| colour_at((i as f32 + 0.5) / WIDE as f32)));
    }
    let mut png = b"\x89PNG\r\n\x1a\n".to_vec();
    let [wide, high] = [WIDE, HIGH].map(u32::to_be_bytes);
    // Eight bits, red, green and blue.
    chunk(&mut png, *b"IHDR", &[&wide[..], &high, &[8, 2, 0, 0, 0]].concat());
    // Of the colour space that palettes are given in.
    chunk(&mut png, *b"sRGB", &[0]);
    chunk(&mut png, *b"IDAT", &zlib(&rows));
    chunk(&mut png, *b"IEND", &[]);
    png
}

fn chunk(png: &mut Vec<u8>, kind: [u8; 4], data: &[u8]) {
    png.extend((data.len() as u32).to_be_bytes());
    let start = png.len();
    png.extend(kind);
    png.extend(data);
    let sum = crc(&png[start..]);
    png.extend(sum.to_be_bytes());
}

/// One stored block (RFC 1950, 1951); it holds up to 65535 bytes.
fn zlib(data: &[u8]) -> Vec<u8> {
    let length = data.len() as u16;
    let mut out = vec![0x78, 0x01, 1];
    out.extend(length.to_le_bytes());
    out.extend((!length).to_le_bytes());
    out.extend(data);
    let sums = data.iter().fold((1_u32, 0_u32), |(a, b), byte| {
        let a = (a + u32::from(*byte)) % 65_521;
        (a, (b + a) % 65_521)
    });
    out.extend((sums.1 << 16 | sums.0).to_be_bytes());
    out
}

/// The check sum of PNG (ISO 3309).
fn crc(bytes: &[u8]) -> u32 {
    let step = |sum: u32, _| if sum & 1 == 1 { sum >> 1 ^ 0xEDB8_8320 } else { sum >> 1 };
    !bytes.iter().fold(u32::MAX, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), step))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_of_an_empty_last_chunk_is_known() {
        assert_eq!(crc(b"IEND"), 0xAE42_6082);
        assert_eq!(crc(b"123456789"), 0xCBF4_3926);
    }
}
