//! Rotations and directions that are to be kept as they are written.
//!
//! Building a figure brings rotations and axes to unit length. Done again, that may move their last bits, so what is of
//! unit length to rounding in the text is put back: writing a figure and reading it gives the same bits.

use crate::figure::Figure;
use crate::joint::{Axis, JointKind, Placement};
use nalgebra::{UnitQuaternion, Vector3};

/// Of unit length to rounding: what is left after a few products of rotations.
const ROUNDING: f64 = 1e-14;

/// What stands in the text of one joint.
pub(super) struct Exact {
    link: String,
    rotation: Option<UnitQuaternion<f64>>,
    /// With how many axes stand before.
    axes: Vec<(usize, Vector3<f64>)>,
    count: usize,
}

impl Exact {
    /// Of the joint of `link`.
    pub(super) fn new(link: &str, placement: &Placement) -> Self {
        let rotation = placement.rotation;
        let kept = is_unit(rotation.coords.norm()) && rotation != UnitQuaternion::identity();
        Self { link: link.to_owned(), rotation: kept.then_some(rotation), axes: Vec::new(), count: 0 }
    }

    /// Adds an axis.
    pub(super) fn axis(&mut self, axis: &Axis) {
        let coordinate = axis.direction.iter().filter(|x| x.abs() == 0.0).count() == 2;
        if is_unit(axis.direction.norm()) && !coordinate {
            self.axes.push((self.count, axis.direction));
        }
        self.count += 1;
    }

    /// Itself, if there is anything to keep.
    pub(super) fn filled(self) -> Option<Self> {
        (self.rotation.is_some() || !self.axes.is_empty()).then_some(self)
    }
}

fn is_unit(length: f64) -> bool {
    (length - 1.0).abs() <= ROUNDING
}

/// Puts back what was written.
pub(super) fn restore(figure: &mut Figure, written: &[Exact]) {
    for exact in written {
        let Some(&link) = figure.by_name.get(&exact.link) else { continue };
        let joint = &mut figure.links[link].joint;
        if let Some(rotation) = exact.rotation {
            joint.placement.rotation = rotation;
        }
        let JointKind::Axes(dofs) = &mut joint.kind else { continue };
        for &(at, direction) in &exact.axes {
            let written = Axis { direction, ..dofs[at].axis };
            // The name of a degree of freedom hangs on its axis.
            if written.stem() == dofs[at].axis.stem() {
                dofs[at].axis = written;
            }
        }
    }
}
