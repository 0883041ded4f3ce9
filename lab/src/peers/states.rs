//! States as the driver has them: raw little-endian doubles, row after row.

use solaris_model::{Figure, StateLayout};
use std::fs;
use std::path::{Path, PathBuf};

/// States of one figure: `PREFIX_q.f64`, `_v.f64`, `_a.f64`, `_tau.f64`.
#[derive(Clone, Debug)]
pub(crate) struct States {
    pub(crate) count: usize,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    pub(crate) tau: Vec<f64>,
}

impl States {
    /// States that are the same wherever they are made: angles within ±1.3 rad, rates of the size of 2, accelerations of 10, forces of 20.
    pub(crate) fn random(figure: &Figure, count: usize) -> Self {
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
        let mut spread = |count: usize, most: f64| {
            let number = |_| {
                // xorshift64*: G. Marsaglia, "Xorshift RNGs", J. Statistical Software 8 (2003).
                seed ^= seed >> 12;
                seed ^= seed << 25;
                seed ^= seed >> 27;
                let bits = seed.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11;
                most * (bits as f64 / (1_u64 << 52) as f64 - 1.0)
            };
            (0..count).map(number).collect::<Vec<_>>()
        };
        let mut q = spread(count * nq, 1.3);
        // A length that is right and no quaternion of zero: no figure refuses it.
        q.chunks_exact_mut(nq).for_each(|q| figure.normalize(q).expect("the layout's own length"));
        let [v, a, tau] = [3.0, 15.0, 30.0].map(|most| spread(count * nv, most));
        Self { count, q, v, a, tau }
    }

    /// Writes the four files.
    pub(crate) fn write(&self, prefix: &Path) -> Result<(), String> {
        let Self { q, v, a, tau, .. } = self;
        [("q", q), ("v", v), ("a", a), ("tau", tau)]
            .into_iter()
            .try_for_each(|(what, values)| write(&file(prefix, what), values))
    }

    /// Reads the four files, of which each must have a row for every state.
    pub(crate) fn read(prefix: &Path, layout: &StateLayout) -> Result<Self, String> {
        let rows = |what: &str, width: usize| read(&file(prefix, what), width);
        let (nq, nv) = (layout.nq(), layout.nv());
        let states =
            Self { count: 0, q: rows("q", nq)?, v: rows("v", nv)?, a: rows("a", nv)?, tau: rows("tau", nv)? };
        let counts = [&states.v, &states.a, &states.tau].map(|values| values.len() / nv);
        let count = states.q.len() / nq;
        if counts.iter().any(|&other| other != count) {
            return Err(format!("{}: {count} rows of q, but {counts:?} of v, a, tau", prefix.display()));
        }
        Ok(Self { count, ..states })
    }

    pub(crate) fn q(&self, state: usize) -> &[f64] {
        self.row(&self.q, state)
    }

    pub(crate) fn v(&self, state: usize) -> &[f64] {
        self.row(&self.v, state)
    }

    pub(crate) fn a(&self, state: usize) -> &[f64] {
        self.row(&self.a, state)
    }

    pub(crate) fn tau(&self, state: usize) -> &[f64] {
        self.row(&self.tau, state)
    }

    fn row<'a>(&self, values: &'a [f64], state: usize) -> &'a [f64] {
        let width = values.len() / self.count;
        &values[width * state..][..width]
    }
}

/// The file of positions, velocities, accelerations or forces.
fn file(prefix: &Path, what: &str) -> PathBuf {
    let mut path = prefix.as_os_str().to_owned();
    path.push(format!("_{what}.f64"));
    path.into()
}

/// Reads rows of doubles.
pub(crate) fn read(path: &Path, width: usize) -> Result<Vec<f64>, String> {
    let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
    decode(&bytes, width).map_err(|error| format!("{}: {error}", path.display()))
}

/// Writes doubles as the driver reads them.
pub(crate) fn write(path: &Path, values: &[f64]) -> Result<(), String> {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    fs::write(path, bytes).map_err(|error| format!("{}: {error}", path.display()))
}

/// The numbers of a file, which must be whole rows, at least one.
fn decode(bytes: &[u8], width: usize) -> Result<Vec<f64>, String> {
    if bytes.is_empty() || !bytes.len().is_multiple_of(8 * width) {
        return Err(format!("{} bytes are no rows of {width} doubles", bytes.len()));
    }
    let (numbers, _) = bytes.as_chunks::<8>();
    Ok(numbers.iter().map(|number| f64::from_le_bytes(*number)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_rows_are_read() {
        let bytes: Vec<u8> = [1.5_f64, -2.0].iter().flat_map(|x| x.to_le_bytes()).collect();
        let bits = |values: Vec<f64>| values.into_iter().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(decode(&bytes, 1).map(bits), Ok(vec![1.5_f64.to_bits(), (-2.0_f64).to_bits()]));
        assert!(decode(&bytes, 3).is_err());
        assert!(decode(&[], 1).is_err());
    }
}
