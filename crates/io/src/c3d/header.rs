//! The first 512 bytes.

use super::bytes::{Bytes, Machine};
use super::error::C3dError;

/// Bytes of a block.
pub(super) const BLOCK: usize = 512;

/// What the header says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Header {
    /// Where the parameters begin (bytes).
    pub(super) parameters: usize,
    pub(super) points: u16,
    /// Analog samples of a frame, of all channels.
    pub(super) analog: u16,
    pub(super) first: u16,
    pub(super) last: u16,
    pub(super) scale: f32,
    /// The block in which the frames begin, from 1.
    pub(super) data: u16,
    /// Analog samples of a frame and channel.
    pub(super) samples: u16,
    pub(super) rate: f32,
}

/// The header, and the bytes with the machine that the parameters say.
pub(super) fn header(bytes: &[u8]) -> Result<(Header, Bytes<'_>), C3dError> {
    let found = bytes.get(1).copied().unwrap_or(0);
    if found != 0x50 {
        return Err(C3dError::Key { found });
    }
    let block = usize::from(bytes[0]);
    if block < 2 {
        let advice = "the parameters begin in block 2 or later; export the trial again";
        return Err(field("the number of the parameters' block", &block, 0, advice));
    }
    let parameters = (block - 1) * BLOCK;
    let mut all = Bytes { bytes, machine: Machine::Intel };
    let kind = all.slice("the beginning of the parameters", parameters, 4)?[3];
    all.machine = match kind {
        84 => Machine::Intel,
        85 => Machine::Dec,
        86 => Machine::Mips,
        _ => {
            let advice = "it must be 84 (Intel), 85 (DEC) or 86 (MIPS); the header or the parameters are broken: export the \
                          trial again";
            return Err(field("the kind of processor", &kind, parameters + 3, advice));
        }
    };
    let word = |name, number: usize| all.word(name, 2 * (number - 1));
    let header = Header {
        parameters,
        points: word("the header's number of points", 2)?,
        analog: word("the header's number of analog samples", 3)?,
        first: word("the header's first frame", 4)?,
        last: word("the header's last frame", 5)?,
        scale: all.real("the header's scale", 12)?,
        data: word("the header's first block of data", 9)?,
        samples: word("the header's analog samples per frame", 10)?,
        rate: all.real("the header's rate", 20)?,
    };
    Ok((header, all))
}

/// A fault of a field.
pub(super) fn field(name: &str, value: &dyn ToString, offset: usize, advice: &'static str) -> C3dError {
    C3dError::Field { field: name.to_owned(), value: value.to_string(), offset, advice }
}
