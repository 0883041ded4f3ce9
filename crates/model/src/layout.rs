//! Where each joint's coordinates stand in `q` and `v`, and what they are called.

use crate::joint::JointKind;
use crate::link::Link;
use std::collections::HashMap;

/// The slices of one joint in the state vectors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointLayout {
    /// First entry in `q`.
    pub q: usize,
    /// Number of entries in `q`.
    pub nq: usize,
    /// First entry in `v`, `a` and `tau`.
    pub v: usize,
    /// Number of entries in `v`.
    pub nv: usize,
}

/// Sizes and names of the state vectors `q` (length `nq`) and `v, a, tau` (length `nv`).
///
/// Joints follow the order of the links. A degree of freedom is called `joint.axis` (`left_knee.rx`); a repeated axis
/// gets a number (`wrist.rx2`); a one-dof joint also answers to its own name.
#[derive(Clone, Debug, Default)]
pub struct StateLayout {
    joints: Vec<JointLayout>,
    q_names: Vec<String>,
    v_names: Vec<String>,
    by_name: HashMap<String, usize>,
}

impl StateLayout {
    pub(crate) fn of(links: &[Link]) -> Self {
        let mut layout = Self::default();
        for link in links {
            let (name, kind) = (link.joint.name(), link.joint.kind());
            let (q, v) = (layout.q_names.len(), layout.v_names.len());
            layout.joints.push(JointLayout { q, nq: kind.nq(), v, nv: kind.nv() });
            let names = coordinate_names(name, kind);
            if names.len() == 1 {
                // A full name wins over a joint's short one.
                layout.by_name.entry(name.to_owned()).or_insert(v);
            }
            for (i, dof) in names.iter().enumerate() {
                layout.by_name.insert(dof.clone(), v + i);
            }
            layout.q_names.extend(names.iter().cloned());
            layout.v_names.extend(names);
        }
        layout
    }

    /// Length of `q`.
    pub fn nq(&self) -> usize {
        self.q_names.len()
    }

    /// Length of `v`, `a` and `tau`.
    pub fn nv(&self) -> usize {
        self.v_names.len()
    }

    /// The slices of every joint, by link index.
    pub fn joints(&self) -> &[JointLayout] {
        &self.joints
    }

    /// Names of the entries of `q`.
    pub fn q_names(&self) -> &[String] {
        &self.q_names
    }

    /// Names of the entries of `v`, `a` and `tau`.
    pub fn v_names(&self) -> &[String] {
        &self.v_names
    }

    /// Index in `v` of the degree of freedom called `name`.
    pub fn dof_index(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }
}

/// Names of the coordinates of one joint: `joint.rx`, and `joint.rx2` for the second of a kind.
pub(crate) fn coordinate_names(joint: &str, kind: &JointKind) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    let mut seen: HashMap<&str, usize> = HashMap::new();
    for dof in kind.axes() {
        let stem = dof.axis.stem();
        let count = seen.entry(stem).and_modify(|n| *n += 1).or_insert(1);
        names.push(if *count == 1 { format!("{joint}.{stem}") } else { format!("{joint}.{stem}{count}") });
    }
    names
}

#[cfg(test)]
mod tests {
    use crate::{FigureBuilder, Joint, LinkSpec};

    #[test]
    fn a_repeated_axis_gets_a_number() {
        let figure = FigureBuilder::new("f")
            .link(LinkSpec::root("a", Joint::new("wrist").rx().rz().rx()).mass(1.0))
            .build()
            .expect("valid");
        assert_eq!(figure.layout().v_names(), ["wrist.rx", "wrist.rz", "wrist.rx2"]);
        assert_eq!(figure.layout().dof_index("wrist.rx2"), Some(2));
        assert_eq!(figure.layout().dof_index("wrist"), None);
    }
}
