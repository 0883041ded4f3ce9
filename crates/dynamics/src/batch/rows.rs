//! How states are taken out of slices and put into them.

use super::Layout;
use super::vector::Register;
use num_traits::Zero;
use std::ops::Range;

/// The most lanes that a register has.
const MOST: usize = 16;

/// Where squares of as many entries as a register has lanes begin, so that every entry of a state is in one but such as are always zero.
/// The last one may go back over others, so that it is full; of fewer entries there is none.
pub(super) fn squares(are_zero: &[bool], lanes: usize) -> Vec<usize> {
    let (mut starts, mut end) = (Vec::new(), 0);
    for (k, is_zero) in are_zero.iter().enumerate() {
        if !is_zero && k >= end && are_zero.len() >= lanes {
            let from = k.min(are_zero.len() - lanes);
            starts.push(from);
            end = from + lanes;
        }
    }
    starts
}

/// Numbers of many states, to be read.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a, F> {
    pub(super) data: &'a [F],
    /// Entries of one state.
    pub(super) width: usize,
    pub(super) states: usize,
    pub(super) layout: Layout,
}

impl<F: Copy> Columns<'_, F> {
    /// Packs the states from `first` on, one a lane, in [`squares`] without a gap, if there are any; the last stands in for those that are
    /// not there.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(super) fn pack<R: Register<Lane = F>>(&self, first: usize, packed: &mut [R], squares: &[usize]) {
        let last = self.states - 1;
        match self.layout {
            Layout::Rows => {
                let mut rows = [&self.data[..0]; MOST];
                for (lane, row) in rows[..R::LANES].iter_mut().enumerate() {
                    *row = &self.data[(first + lane).min(last) * self.width..][..self.width];
                }
                for &from in squares {
                    let square = &mut packed[from..][..R::LANES];
                    for (entry, row) in square.iter_mut().zip(&rows) {
                        entry.lanes_mut().copy_from_slice(&row[from..][..R::LANES]);
                    }
                    let transposed = R::transposed(square);
                    square.copy_from_slice(transposed.as_ref());
                }
                if squares.is_empty() {
                    for (k, entry) in packed[..self.width].iter_mut().enumerate() {
                        for (lane, row) in entry.lanes_mut().iter_mut().zip(&rows) {
                            *lane = row[k];
                        }
                    }
                }
            }
            Layout::Columns => {
                for (column, entry) in self.data.chunks_exact(self.states).zip(packed) {
                    if let Some(lanes) = column.get(first..first + R::LANES) {
                        entry.lanes_mut().copy_from_slice(lanes);
                    } else {
                        for (lane, value) in entry.lanes_mut().iter_mut().enumerate() {
                            *value = column[(first + lane).min(last)];
                        }
                    }
                }
            }
        }
    }

    /// The numbers of `count` states from `first` on that are there, if they stand together.
    pub(super) fn stretch(&self, first: usize, count: usize) -> &[F] {
        match self.layout {
            Layout::Rows => {
                let end = self.states.min(first + count);
                &self.data[first.min(end) * self.width..end * self.width]
            }
            Layout::Columns => &[],
        }
    }

    /// One state by itself.
    pub(super) fn copy(&self, row: usize, state: &mut [F]) {
        for (k, entry) in state.iter_mut().enumerate() {
            *entry = match self.layout {
                Layout::Rows => self.data[row * self.width + k],
                Layout::Columns => self.data[k * self.states + row],
            };
        }
    }
}

/// Where results go: those of a range of all states.
pub(super) struct Output<'a, F> {
    pub(super) range: Range<usize>,
    width: usize,
    slots: Slots<'a, F>,
}

enum Slots<'a, F> {
    Rows(&'a mut [F]),
    /// All columns in one slice, each of as many entries as there are states.
    Columns(&'a mut [F]),
    /// A part of every column.
    #[cfg(feature = "parallel")]
    Parts(Vec<&'a mut [F]>),
}

impl<'a, F: Copy + Zero> Output<'a, F> {
    /// All states.
    pub(super) fn whole(data: &'a mut [F], width: usize, states: usize, layout: Layout) -> Self {
        let slots = match layout {
            Layout::Rows => Slots::Rows(data),
            Layout::Columns => Slots::Columns(data),
        };
        Self { range: 0..states, width, slots }
    }

    /// All states, `share` after `share`.
    #[cfg(feature = "parallel")]
    pub(super) fn split(
        data: &'a mut [F],
        width: usize,
        states: usize,
        share: usize,
        layout: Layout,
    ) -> Vec<Self> {
        let ranges = (0..states).step_by(share).map(|first| first..states.min(first + share));
        let slots: Vec<Slots<'a, F>> = match layout {
            Layout::Rows => data.chunks_mut((share * width).max(1)).map(Slots::Rows).collect(),
            Layout::Columns => {
                let mut parts: Vec<Vec<&mut [F]>> =
                    ranges.clone().map(|_| Vec::with_capacity(width)).collect();
                for column in data.chunks_mut(states.max(1)) {
                    for (part, piece) in parts.iter_mut().zip(column.chunks_mut(share)) {
                        part.push(piece);
                    }
                }
                parts.into_iter().map(Slots::Parts).collect()
            }
        };
        ranges.zip(slots).map(|(range, slots)| Self { range, width, slots }).collect()
    }

    /// As [`Columns::stretch`].
    pub(super) fn stretch(&self, first: usize, count: usize) -> &[F] {
        match &self.slots {
            Slots::Rows(data) => {
                let end = self.range.end.min(first + count);
                let from = first.min(end);
                &data[(from - self.range.start) * self.width..(end - self.range.start) * self.width]
            }
            Slots::Columns(_) => &[],
            #[cfg(feature = "parallel")]
            Slots::Parts(_) => &[],
        }
    }

    /// Writes the lanes of the states from `first` on, in [`squares`], if there are any, the last of which ends with the last entry; those
    /// beyond the range are left out.
    #[cfg_attr(not(any(target_family = "wasm", debug_assertions)), inline(always))]
    pub(super) fn unpack<R: Register<Lane = F>>(&mut self, first: usize, packed: &[R], squares: &[usize]) {
        let (width, from) = (self.width, first - self.range.start);
        let count = R::LANES.min(self.range.end - first);
        match &mut self.slots {
            Slots::Rows(data) => {
                let rows = &mut data[from * width..][..count * width];
                if count < R::LANES {
                    for (lane, row) in rows.chunks_exact_mut(width).enumerate() {
                        for (value, entry) in row.iter_mut().zip(packed) {
                            *value = entry.lanes()[lane];
                        }
                    }
                    return;
                }
                if squares.is_empty() {
                    for (k, entry) in packed[..width].iter().enumerate() {
                        for (lane, value) in entry.lanes().iter().enumerate() {
                            rows[lane * width + k] = *value;
                        }
                    }
                    return;
                }
                let (zeros, mut done) = (R::zero(), 0);
                for &from in squares {
                    while done < from {
                        for row in rows.chunks_exact_mut(width) {
                            row[done..][..R::LANES].copy_from_slice(zeros.lanes());
                        }
                        done += R::LANES;
                    }
                    let transposed = R::transposed(&packed[from..][..R::LANES]);
                    for (row, entries) in rows.chunks_exact_mut(width).zip(transposed.as_ref()) {
                        row[from..][..R::LANES].copy_from_slice(entries.lanes());
                    }
                    done = from + R::LANES;
                }
            }
            Slots::Columns(data) => {
                let states = self.range.end;
                for (column, entry) in data.chunks_exact_mut(states).zip(packed) {
                    column[from..][..count].copy_from_slice(&entry.lanes()[..count]);
                }
            }
            #[cfg(feature = "parallel")]
            Slots::Parts(columns) => {
                for (column, entry) in columns.iter_mut().zip(packed) {
                    column[from..][..count].copy_from_slice(&entry.lanes()[..count]);
                }
            }
        }
    }

    /// Writes one state.
    pub(super) fn write(&mut self, row: usize, state: impl Fn(usize) -> F) {
        let (width, from) = (self.width, row - self.range.start);
        let states = self.range.end;
        for k in 0..width {
            let slot = match &mut self.slots {
                Slots::Rows(data) => &mut data[from * width + k],
                Slots::Columns(data) => &mut data[k * states + from],
                #[cfg(feature = "parallel")]
                Slots::Parts(columns) => &mut columns[k][from],
            };
            *slot = state(k);
        }
    }
}
