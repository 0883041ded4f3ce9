//! The faults of a figure, where the text caused them.

use super::{FigureReader, Lost};
use crate::fault::Part;
use crate::fault::{Fault, FigureError};
use crate::source::SourceMap;
use std::collections::{HashMap, HashSet};
use std::mem::discriminant;
use std::ops::Range;

impl FigureReader<'_> {
    /// Adds the faults that building the figure has found.
    pub(super) fn locate(&mut self, error: &FigureError) {
        if !self.places.kept {
            return;
        }
        let mut said = HashSet::new();
        for fault in error.faults.iter().filter(|fault| !self.lost.explains(fault)) {
            let span = self.places.of(fault);
            // A ball or free joint has one armature, one damper for all of its degrees of freedom.
            let once = matches!(fault, Fault::Armature { .. } | Fault::Passive { .. });
            if !once || said.insert((span.start, span.end, discriminant(fault))) {
                let instead = self.places.map.instead(fault);
                self.reader.fault_meaning(span, fault.to_string(), instead);
            }
        }
    }
}

/// Where in the text the parts of the figure stand.
#[derive(Default)]
pub(super) struct Places {
    kept: bool,
    map: SourceMap,
    /// Where a name stands for the second time.
    repeats: HashMap<(Part, String), Range<usize>>,
}

impl Places {
    /// Places that are kept; without this, none are.
    pub(super) fn kept() -> Self {
        Self { kept: true, ..Self::default() }
    }

    /// Whether they are kept.
    pub(super) fn are_kept(&self) -> bool {
        self.kept
    }

    /// Says where a part stands.
    pub(super) fn put(&mut self, part: Part, name: &str, span: Range<usize>) {
        self.put_field(part, name, "", span);
    }

    /// Says where a field of a part stands.
    pub(super) fn put_field(&mut self, part: Part, name: &str, field: &'static str, span: Range<usize>) {
        if self.kept {
            self.map.put_field(part, name, field, span);
        }
    }

    /// Says where a name stands, or that it stands there again.
    pub(super) fn put_name(&mut self, part: Part, name: &str, span: Range<usize>) {
        if self.map.get(part, name).is_some() {
            self.repeats.entry((part, name.to_owned())).or_insert(span);
        } else {
            self.put(part, name, span);
        }
    }

    /// The place of what a fault is about.
    pub(super) fn of(&self, fault: &Fault) -> Range<usize> {
        let closer = match fault {
            // The first of a name is likely to be meant.
            Fault::DuplicateName { name, .. } => self.repeats.get(&(fault.subject().0, name.clone())),
            Fault::UnknownDof { angle, .. } => self.map.field(Part::Angle, angle, "dof"),
            Fault::Curve { dof, .. } => self.map.field(Part::Dof, dof, "along"),
            Fault::TooManyDofs { joint, .. } => self.map.field(Part::Joint, joint, "axes"),
            _ => None,
        };
        let found = closer.cloned().or_else(|| self.map.find(fault));
        found.or_else(|| self.map.get(Part::Figure, "").cloned()).unwrap_or(0..0)
    }
}

impl Lost {
    /// Whether a fault may come from what could not be read, or has been told already.
    fn explains(&self, fault: &Fault) -> bool {
        match fault {
            Fault::EmptyName { .. } => true,
            Fault::Empty | Fault::UnknownParent { .. } => self.links,
            Fault::NoRoot => self.links || self.parents,
            Fault::ManyRoots { .. } => self.parents,
            Fault::UnknownDof { .. } | Fault::UnknownLeader { .. } => self.dofs || self.links,
            _ => false,
        }
    }
}
