//! States as the driver has them: raw little-endian doubles, row after row.

use solaris_model::StateLayout;
use std::fs;
use std::path::Path;

/// States of one figure: `PREFIX_q.f64`, `_v.f64`, `_a.f64`, `_tau.f64`.
#[derive(Debug)]
pub(super) struct States {
    pub(super) count: usize,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
}

impl States {
    /// Reads the four files, of which each must have a row for every state.
    pub(super) fn read(prefix: &Path, layout: &StateLayout) -> Result<Self, String> {
        let file = |what: &str, width: usize| {
            let mut path = prefix.as_os_str().to_owned();
            path.push(format!("_{what}.f64"));
            let path = Path::new(&path);
            let bytes = fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
            decode(&bytes, width).map_err(|error| format!("{}: {error}", path.display()))
        };
        let (nq, nv) = (layout.nq(), layout.nv());
        let states =
            Self { count: 0, q: file("q", nq)?, v: file("v", nv)?, a: file("a", nv)?, tau: file("tau", nv)? };
        let counts = [&states.v, &states.a, &states.tau].map(|values| values.len() / nv);
        let count = states.q.len() / nq;
        if counts.iter().any(|&other| other != count) {
            return Err(format!("{}: {count} rows of q, but {counts:?} of v, a, tau", prefix.display()));
        }
        Ok(Self { count, ..states })
    }

    pub(super) fn q(&self, state: usize) -> &[f64] {
        self.row(&self.q, state)
    }

    pub(super) fn v(&self, state: usize) -> &[f64] {
        self.row(&self.v, state)
    }

    pub(super) fn a(&self, state: usize) -> &[f64] {
        self.row(&self.a, state)
    }

    pub(super) fn tau(&self, state: usize) -> &[f64] {
        self.row(&self.tau, state)
    }

    fn row<'a>(&self, values: &'a [f64], state: usize) -> &'a [f64] {
        let width = values.len() / self.count;
        &values[width * state..][..width]
    }
}

/// Writes doubles as the driver reads them.
pub(super) fn write(path: &Path, values: &[f64]) -> Result<(), String> {
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
