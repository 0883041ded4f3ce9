//! Numbers in the bytes of three kinds of machines.

use super::error::C3dError;

/// The machine whose numbers a file has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Machine {
    /// Little endian, IEEE.
    Intel,
    /// Little endian words; reals as in a VAX.
    Dec,
    /// Big endian, IEEE.
    Mips,
}

/// The bytes of a file and how their numbers are read.
#[derive(Clone, Copy)]
pub(super) struct Bytes<'a> {
    pub(super) bytes: &'a [u8],
    pub(super) machine: Machine,
}

impl<'a> Bytes<'a> {
    /// `length` bytes from `offset`, called `field` where they are missing.
    pub(super) fn slice(&self, field: &str, offset: usize, length: usize) -> Result<&'a [u8], C3dError> {
        let end = offset.saturating_add(length);
        self.bytes.get(offset..end).ok_or_else(|| C3dError::Cut {
            field: field.to_owned(),
            offset,
            end,
            length: self.bytes.len(),
        })
    }

    /// The 16 bits at `offset`.
    pub(super) fn word(&self, field: &str, offset: usize) -> Result<u16, C3dError> {
        let slice = self.slice(field, offset, 2)?;
        Ok(self.machine.word([slice[0], slice[1]]))
    }

    /// The real number at `offset`.
    pub(super) fn real(&self, field: &str, offset: usize) -> Result<f32, C3dError> {
        let slice = self.slice(field, offset, 4)?;
        Ok(self.machine.real([slice[0], slice[1], slice[2], slice[3]]))
    }
}

impl Machine {
    /// The 16 bits of two bytes.
    pub(super) fn word(self, bytes: [u8; 2]) -> u16 {
        match self {
            Self::Intel | Self::Dec => u16::from_le_bytes(bytes),
            Self::Mips => u16::from_be_bytes(bytes),
        }
    }

    /// The real number of four bytes.
    pub(super) fn real(self, bytes: [u8; 4]) -> f32 {
        match self {
            Self::Intel => f32::from_le_bytes(bytes),
            Self::Mips => f32::from_be_bytes(bytes),
            Self::Dec => {
                // A VAX's words are the other way round, and its exponent is greater by two.
                let bits = u32::from_le_bytes([bytes[2], bytes[3], bytes[0], bytes[1]]);
                let exponent = (bits >> 23) & 0xff;
                if exponent <= 2 { 0.0 } else { f32::from_bits(bits - (2 << 23)) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Machine;

    #[test]
    fn a_real_of_each_machine_is_the_same_number() {
        // 1.0 is 0x3f800000 in IEEE and 0x40800000 in a VAX, whose words are swapped.
        let bits = |machine: Machine, bytes| machine.real(bytes).to_bits();
        let one = 1.0_f32.to_bits();
        assert_eq!(bits(Machine::Intel, [0, 0, 0x80, 0x3f]), one);
        assert_eq!(bits(Machine::Mips, [0x3f, 0x80, 0, 0]), one);
        assert_eq!(bits(Machine::Dec, [0x80, 0x40, 0, 0]), one);
        assert_eq!(bits(Machine::Dec, [0x80, 0xc0, 0, 0]), (-1.0_f32).to_bits());
        assert_eq!(bits(Machine::Dec, [0, 0, 0, 0]), 0);
        assert_eq!(Machine::Mips.word([1, 2]), 0x0102);
    }
}
