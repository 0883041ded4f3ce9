//! Changes that leave a text nearly what it was: bytes turned at random are no XML any more, and the readers behind it
//! would never be asked.

use libfuzzer_sys::fuzzer_mutate;

/// Numbers that formulas trip over.
const NUMBERS: [&str; 20] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "2",
    "0.5",
    "1e-8",
    "1e-17",
    "1e-300",
    "5e-324",
    "1e8",
    "1e17",
    "1e154",
    "1e300",
    "-1e308",
    "1e999",
    "NaN",
    "inf",
    "4294967296",
    "1000000000000",
];

/// Changes the `size` bytes at the beginning of `data`, which has room for `most`, and returns how many they are then.
pub fn mutate(data: &mut [u8], size: usize, most: usize, seed: u32) -> usize {
    let mut random = Random(seed);
    let input = &data[..size];
    let changed = match random.below(4) {
        0 => number(input, &mut random),
        1 => element(input, &mut random),
        2 => line(input, &mut random),
        _ => None,
    };
    match changed {
        Some(changed) if changed.len() <= most => {
            data[..changed.len()].copy_from_slice(&changed);
            changed.len()
        }
        _ => fuzzer_mutate(data, size, most),
    }
}

/// Splitmix, in 64 bits.
struct Random(u32);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let mut x = u64::from(self.0).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 29)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x >> 32) as usize) % end.max(1)
    }
}

/// The input with a number in place of another, of its own or from the list.
fn number(input: &[u8], random: &mut Random) -> Option<Vec<u8>> {
    let is_digit = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+');
    let from = random.below(input.len());
    let start = from + input[from..].iter().position(|byte| is_digit(*byte))?;
    let in_number = |byte: &u8| is_digit(*byte) || matches!(*byte, b'e' | b'E');
    let length = input[start..].iter().take_while(|byte| in_number(byte)).count();
    let with = NUMBERS[random.below(NUMBERS.len())];
    Some([&input[..start], with.as_bytes(), &input[start + length..]].concat())
}

/// The input with one of its elements left out, doubled, moved, or in place of another.
fn element(input: &[u8], random: &mut Random) -> Option<Vec<u8>> {
    let (from, to) = (any_element(input, random)?, any_element(input, random)?);
    let copy = &input[from.0..from.1];
    Some(match random.below(4) {
        0 => [&input[..from.0], &input[from.1..]].concat(),
        1 => [&input[..to.0], copy, &input[to.0..]].concat(),
        2 => [&input[..to.0], copy, &input[to.1..]].concat(),
        // Inside of another, at its beginning.
        _ => {
            let inside = to.0 + input[to.0..].iter().position(|byte| *byte == b'>')? + 1;
            [&input[..inside], copy, &input[inside..]].concat()
        }
    })
}

/// Where an element begins and ends, found by counting tags.
fn any_element(input: &[u8], random: &mut Random) -> Option<(usize, usize)> {
    let opens =
        |at: usize| input[at] == b'<' && input.get(at + 1).is_some_and(|next| next.is_ascii_alphabetic());
    let from = random.below(input.len());
    let start = (from..input.len()).chain(0..from).find(|at| opens(*at))?;
    let (mut depth, mut at) = (0_usize, start);
    while at < input.len() {
        let end = at + input[at..].iter().position(|byte| *byte == b'>')?;
        if opens(at) && input[end - 1] != b'/' {
            depth += 1;
        } else if input[at..].starts_with(b"</") {
            depth = depth.checked_sub(1)?;
        }
        if depth == 0 {
            return Some((start, end + 1));
        }
        at = end + input[end..].iter().position(|byte| *byte == b'<')?;
    }
    None
}

/// The input with one of its lines left out, doubled or moved.
fn line(input: &[u8], random: &mut Random) -> Option<Vec<u8>> {
    let mut lines: Vec<&[u8]> = input.split_inclusive(|byte| *byte == b'\n').collect();
    if lines.len() < 2 {
        return None;
    }
    let (from, to) = (random.below(lines.len()), random.below(lines.len()));
    match random.below(3) {
        0 => drop(lines.remove(from)),
        1 => lines.insert(to, lines[from]),
        _ => lines.swap(from, to),
    }
    Some(lines.concat())
}
