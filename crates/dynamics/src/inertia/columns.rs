//! Columns of a matrix over degrees of freedom, several at a time: side by side in the lanes of arrays, which the compiler keeps in
//! vector registers.

use crate::scalar::Scalar;
use crate::tree::Tree;
use nalgebra::Vector3;

/// How many columns of plain numbers are taken at a time; of other scalars one.
pub(crate) const LANES: usize = 8;

/// A vector in each lane: its `x`, its `y`, its `z`.
pub(crate) type Vectors<T, const W: usize> = [[T; W]; 3];

/// Room for the columns that are taken at a time, all of it zero between two uses but the rows.
#[derive(Clone, Debug)]
pub(crate) struct Columns<T> {
    /// By degree of freedom.
    rows: Vec<T>,
    /// By link: force and moment about its origin, world axes.
    loads: Vec<T>,
    /// By link: acceleration of its origin and angular acceleration, world axes.
    motions: Vec<T>,
    /// Which links bear a load in any lane.
    loaded: Vec<bool>,
    dofs: usize,
    links: usize,
}

/// That room, `W` lanes wide.
pub(crate) struct Lanes<'a, T, const W: usize> {
    pub(crate) rows: &'a mut [[T; W]],
    pub(crate) loads: &'a mut [[[T; W]; 6]],
    pub(crate) motions: &'a mut [[[T; W]; 6]],
    pub(crate) loaded: &'a mut [bool],
}

impl<T: Scalar> Columns<T> {
    pub(crate) fn new(tree: &Tree<T>) -> Self {
        let (width, dofs, links) = (if T::IS_FLOAT { LANES } else { 1 }, tree.nv(), tree.link_count());
        // A line more, to begin at the beginning of one.
        let zeros = |count: usize| vec![T::zero(); count * width + LINE / size_of::<T>().max(1)];
        Self {
            rows: zeros(dofs),
            loads: zeros(6 * links),
            motions: zeros(6 * links),
            loaded: vec![false; links],
            dofs,
            links,
        }
    }

    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(crate) fn lanes<const W: usize>(&mut self) -> Lanes<'_, T, W> {
        Lanes {
            rows: aligned(&mut self.rows, self.dofs * W).as_chunks_mut().0,
            loads: aligned(&mut self.loads, self.links * 6 * W).as_chunks_mut().0.as_chunks_mut().0,
            motions: aligned(&mut self.motions, self.links * 6 * W).as_chunks_mut().0.as_chunks_mut().0,
            loaded: &mut self.loaded,
        }
    }
}

/// As many bytes as the caches take at once.
const LINE: usize = 64;

/// The first `len` numbers that begin with a line of the cache, so that no register is read from two; of all where that does not go.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
fn aligned<T>(numbers: &mut [T], len: usize) -> &mut [T] {
    let skipped = numbers.as_ptr().align_offset(LINE);
    let is_room = skipped.checked_add(len).is_some_and(|end| end <= numbers.len());
    &mut numbers[if is_room { skipped } else { 0 }..][..len]
}

/// The part of a load or a motion that comes first, force or acceleration, and the one that comes last, moment or angular acceleration.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn halves<T: Scalar, const W: usize>(both: &[[T; W]; 6]) -> (Vectors<T, W>, Vectors<T, W>) {
    ([both[0], both[1], both[2]], [both[3], both[4], both[5]])
}

/// `to + e·v`, where `e` is the same in all lanes.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn plus_along<T: Scalar, const W: usize>(
    mut to: [T; W],
    e: &Vector3<T>,
    v: &Vectors<T, W>,
) -> [T; W] {
    for lane in 0..W {
        // In pairs: the sum waits less.
        let rest = e.z.times_plus(v[2][lane], to[lane]);
        to[lane] = e.y.times_plus(v[1][lane], e.x * v[0][lane]) + rest;
    }
    to
}

/// `to ← to + e·k`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn add_scaled<T: Scalar, const W: usize>(to: &mut Vectors<T, W>, e: &Vector3<T>, k: &[T; W]) {
    for lane in 0..W {
        to[0][lane] = e.x.times_plus(k[lane], to[0][lane]);
        to[1][lane] = e.y.times_plus(k[lane], to[1][lane]);
        to[2][lane] = e.z.times_plus(k[lane], to[2][lane]);
    }
}

/// `to ← to + r × v`
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn add_cross<T: Scalar, const W: usize>(
    to: &mut Vectors<T, W>,
    r: &Vector3<T>,
    v: &Vectors<T, W>,
) {
    for lane in 0..W {
        let (x, y, z) = (v[0][lane], v[1][lane], v[2][lane]);
        to[0][lane] += r.z.times_from(y, r.y * z);
        to[1][lane] += r.x.times_from(z, r.z * x);
        to[2][lane] += r.y.times_from(x, r.x * y);
    }
}

/// Adds a force and a moment to a load.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn add_load<T: Scalar, const W: usize>(
    to: &mut [[T; W]; 6],
    force: &Vectors<T, W>,
    moment: &Vectors<T, W>,
) {
    for axis in 0..3 {
        for lane in 0..W {
            to[axis][lane] += force[axis][lane];
            to[3 + axis][lane] += moment[axis][lane];
        }
    }
}

/// Writes columns `first..end` of a symmetric matrix as far as the diagonal, and its rows with them; `first` is a multiple of `W`.
#[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
pub(crate) fn write_mirrored<T: Scalar, const W: usize>(
    rows: &[[T; W]],
    first: usize,
    end: usize,
    n: usize,
    matrix: &mut [T],
) {
    let count = end - first;
    for (k, row) in rows[..first].iter().enumerate() {
        let to = &mut matrix[k * n + first..k * n + end];
        // Of a length that the compiler knows where there is one.
        match to.first_chunk_mut::<W>() {
            Some(to) => *to = *row,
            None => to.copy_from_slice(&row[..count]),
        }
    }
    for (at, tile) in rows[..first].as_chunks::<W>().0.iter().enumerate() {
        for lane in 0..count {
            let entries = &mut matrix[(first + lane) * n + at * W..][..W];
            for k in 0..W {
                entries[k] = tile[k][lane];
            }
        }
    }
    for k in first..end {
        for lane in k - first..count {
            let j = first + lane;
            matrix[k * n + j] = rows[k][lane];
            matrix[j * n + k] = rows[k][lane];
        }
    }
}
