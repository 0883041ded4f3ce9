//! The inverse of the mass matrix by factors that are zero wherever it is: between different branches.

use crate::error::DynamicsError;
use crate::inertia::mass_matrix::{mass_matrix, place_composites, write_entries};
use crate::scalar::Scalar;
use crate::spatial::symmetric::Symmetric;
use crate::tree::Tree;
use crate::wide::wide;
use crate::workspace::{Workspace, check_result};
use nalgebra::DMatrix;

/// The most degrees of freedom, each right behind the one before it, that are taken at once: those of most joints of living things.
pub(crate) const BLOCK: usize = 3;
/// How many entries of a column are taken at once by the factors, and by the inverse.
const FEW: usize = 4;
const MANY: usize = 6;

/// A pivot that keeps less than this part of what it was made of has lost too many digits.
const LEAST: f64 = 1e-9;

/// Writes the inverse of the mass matrix at `q`; `false` where too little of a pivot is left beside what it was made of, and then the
/// matrix means nothing. Also places the links.
///
/// `M = Lᵀ·D·L`, with `L` one on its diagonal and zero but on the paths to the root. First its entries stand at the heads of their columns,
/// those of the path one behind the other, with `1/D` behind them; then the inverse grows row by row, its symmetric half with it:
///
/// ```text
/// X_kj = −Σ L_ki·X_ij  for j < k          X_kk = 1/D_k − Σ L_ki·X_ki
/// ```
///
/// over `i` before `k` on its path. Both go block by block, so that what is read of the matrix serves several rows: of a block `K` with `A`
/// before it
///
/// ```text
/// X_Kj = −L_KK⁻¹·L_KA·X_Aj          X_KK = L_KK⁻¹·D_K⁻¹·L_KK⁻ᵀ − L_KK⁻¹·L_KA·X_AK
/// ```
///
/// # Source
///
/// R. Featherstone, "Efficient factorization of the joint-space inertia matrix for branched kinematic trees", Int. J. Robotics Research 24
/// (2005) 487–500, for the factors.
pub(crate) fn invert<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    q: &[T],
    matrix: &mut DMatrix<T>,
) -> Result<bool, DynamicsError> {
    let n = tree.nv();
    place_composites(tree, workspace, q, matrix)?;
    write_entries::<T, true>(tree, workspace, matrix);
    let entries = matrix.as_mut_slice();
    let pivot = |k: usize| k * n + tree.depth[k];
    for &(k, armature) in &tree.armature {
        entries[pivot(k)] += armature;
    }
    if !(0..n).fold(true, |finite, k| finite & entries[pivot(k)].is_finite()) {
        // It says which entry is not.
        mass_matrix(tree, workspace, q, matrix)?;
        return Ok(false);
    }
    wide::<T, _>(
        #[inline(always)]
        || invert_entries(tree, workspace, entries),
    )
}

/// Puts the inverse in the place of the entries up to the diagonal; as [`invert`].
#[inline(always)]
fn invert_entries<T: Scalar>(
    tree: &Tree<T>,
    workspace: &mut Workspace<T>,
    entries: &mut [T],
) -> Result<bool, DynamicsError> {
    let n = tree.nv();
    let Workspace { path, parts, composites, .. } = workspace;
    let mut path = Path { dofs: path, len: 0 };
    // The inertia that each pivot is a part of.
    for (body, composite) in tree.bodies.iter().zip(&*composites) {
        let Symmetric { xx, yy, zz, .. } = composite.inertia;
        for k in body.first..body.end {
            let whole = if tree.dofs[k].kind.turns() { xx + yy + zz } else { composite.mass };
            parts[k][0] = entries[k * n + tree.depth[k]] + whole;
        }
    }
    let (mut is_sound, mut end) = (true, n);
    while end > 0 {
        let mut first = end - 1;
        while end - first < BLOCK && tree.before[first].is_some_and(|before| before + 1 == first) {
            first -= 1;
        }
        let before = path.before(tree, first);
        is_sound &= match end - first {
            1 => factor::<T, 1>(entries, n, first, before, parts),
            2 => factor::<T, 2>(entries, n, first, before, parts),
            _ => factor::<T, 3>(entries, n, first, before, parts),
        };
        end = first;
    }
    if !is_sound {
        return Ok(false);
    }
    let (mut first, mut sum) = (0, T::zero());
    while first < n {
        let mut end = first + 1;
        while end - first < BLOCK && end < n && tree.before[end] == Some(end - 1) {
            end += 1;
        }
        let before = path.before(tree, first);
        sum += match end - first {
            1 => fill::<T, 1>(entries, n, first, before, parts),
            2 => fill::<T, 2>(entries, n, first, before, parts),
            _ => fill::<T, 3>(entries, n, first, before, parts),
        };
        first = end;
    }
    if !sum.is_finite() {
        // An entry is not, or their sum alone.
        check_result("the inverse mass matrix", entries)?;
    }
    Ok(true)
}

/// The degrees of freedom on the path to the one that was asked for last.
struct Path<'a> {
    dofs: &'a mut [usize],
    /// How many of them are on it.
    len: usize,
}

impl Path<'_> {
    /// Those before `k`.
    fn before<T: Scalar>(&mut self, tree: &Tree<T>, k: usize) -> &[usize] {
        let mut next = Some(k);
        while let Some(i) = next {
            let place = tree.depth[i];
            if place < self.len && self.dofs[place] == i {
                // So are all before it.
                break;
            }
            self.dofs[place] = i;
            next = tree.before[i];
        }
        self.len = tree.depth[k] + 1;
        &self.dofs[..tree.depth[k]]
    }
}

/// Factors the columns of `N` degrees of freedom from `first` on, each right behind the one before it, all of them behind those `before`;
/// whether enough is left of every pivot beside the whole that it was part of.
#[inline(always)]
fn factor<T: Scalar, const N: usize>(
    entries: &mut [T],
    n: usize,
    first: usize,
    before: &[usize],
    wholes: &[[T; BLOCK]],
) -> bool {
    let (above, mut is_sound) = (before.len(), true);
    for r in (0..N).rev() {
        let (others, own) = entries.split_at_mut((first + r) * n);
        let pivot = above + r;
        is_sound &= (own[pivot] / wholes[first + r][0]).all_within(LEAST, 2.0);
        own[pivot] = T::one() / own[pivot];
        for t in (0..r).rev() {
            let p = above + t;
            let part = own[p] * own[pivot];
            take_off(&mut others[(first + t) * n..][..n], p + 1, [part], [own]);
            own[p] = part;
        }
    }
    let (others, block) = entries.split_at_mut(first * n);
    let (mut columns, mut inverses) = ([&block[..0]; N], [T::zero(); N]);
    for r in 0..N {
        columns[r] = &block[r * n..][..n];
        inverses[r] = columns[r][above + r];
    }
    for (p, &i) in before.iter().enumerate() {
        let mut parts = inverses;
        for r in 0..N {
            parts[r] *= columns[r][p];
        }
        take_off(&mut others[i * n..][..n], p + 1, parts, columns);
    }
    for r in 0..N {
        for entry in &mut block[r * n..][..above] {
            *entry *= inverses[r];
        }
    }
    is_sound
}

/// Takes `Σ part·column` off the first `len` entries of a column. What stands behind them means nothing any more and may change.
#[inline(always)]
fn take_off<T: Scalar, const N: usize>(to: &mut [T], len: usize, parts: [T; N], columns: [&[T]; N]) {
    let (tiles, rest) = to.as_chunks_mut::<FEW>();
    let (whole, count) = (tiles.len() * FEW, len.div_ceil(FEW).min(tiles.len()));
    let mut taken = [&columns[0].as_chunks().0[..0]; N];
    for r in 0..N {
        taken[r] = &columns[r].as_chunks::<FEW>().0[..count];
    }
    for (at, tile) in tiles[..count].iter_mut().enumerate() {
        let mut left = *tile;
        for r in 0..N {
            for lane in 0..FEW {
                left[lane] = parts[r].times_from(taken[r][at][lane], left[lane]);
            }
        }
        *tile = left;
    }
    for (left, at) in rest.iter_mut().zip(whole..len) {
        for r in 0..N {
            *left = parts[r].times_from(columns[r][at], *left);
        }
    }
}

/// Writes rows and columns of the inverse for `N` degrees of freedom, as [`factor`] left them, as far as those before them go; the sum of
/// all that is found, finite only if all of it is.
#[inline(always)]
fn fill<T: Scalar, const N: usize>(
    entries: &mut [T],
    n: usize,
    first: usize,
    before: &[usize],
    parts: &mut [[T; BLOCK]],
) -> T {
    let above = before.len();
    let (others, block) = entries.split_at_mut(first * n);
    // L_KK⁻¹·L_KA and L_KK⁻¹.
    for (p, parts) in parts[..above].iter_mut().enumerate() {
        for r in 0..N {
            parts[r] = block[r * n + p];
            for t in 0..r {
                parts[r] = parts[t].times_from(block[r * n + above + t], parts[r]);
            }
        }
    }
    let mut own = [[T::zero(); N]; N];
    for r in 0..N {
        own[r][r] = T::one();
        for t in 0..r {
            for s in 0..=t {
                own[r][s] = own[t][s].times_from(block[r * n + above + t], own[r][s]);
            }
        }
    }
    // L_KK⁻¹·D_K⁻¹·L_KK⁻ᵀ
    let mut square = [[T::zero(); N]; N];
    for r in 0..N {
        for s in 0..N {
            for t in 0..=r.min(s) {
                square[r][s] += own[r][t] * own[s][t] * block[t * n + above + t];
            }
        }
    }
    let (mut j, mut sum) = (0, T::zero());
    while j < first {
        if first < MANY {
            sum += row(block, [[T::zero(); 1]; N], others, n, j, before, parts);
            j += 1;
        } else {
            // The last tile goes back over the one before it, so that it is full.
            j = j.min(first - MANY);
            sum += row(block, [[T::zero(); MANY]; N], others, n, j, before, parts);
            j += MANY;
        }
    }
    let mut rows = [&block[..0]; N];
    for r in 0..N {
        rows[r] = &block[r * n..][..first];
    }
    for (j, column) in others.chunks_exact_mut(n).enumerate() {
        let entries = &mut column[first..][..N];
        for r in 0..N {
            entries[r] = rows[r][j];
        }
    }
    sum + row(block, square, others, n, first, before, parts)
}

/// Writes `tile − Σ part·X_ij` over `i` in `before` to the block, at the entries from `j` on of its columns; their sum.
#[inline(always)]
fn row<T: Scalar, const N: usize, const W: usize>(
    block: &mut [T],
    mut tile: [[T; W]; N],
    inverse: &[T],
    n: usize,
    j: usize,
    before: &[usize],
    parts: &[[T; BLOCK]],
) -> T {
    for (&i, part) in before.iter().zip(parts) {
        let entries = &inverse[i * n + j..][..W];
        for r in 0..N {
            for lane in 0..W {
                tile[r][lane] = part[r].times_from(entries[lane], tile[r][lane]);
            }
        }
    }
    let mut sums = [T::zero(); W];
    for r in 0..N {
        block[r * n + j..][..W].copy_from_slice(&tile[r]);
        for lane in 0..W {
            sums[lane] += tile[r][lane];
        }
    }
    sums.iter().fold(T::zero(), |all, sum| all + *sum)
}
