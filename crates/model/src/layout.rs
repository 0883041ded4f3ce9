//! The layout of the state vectors: where each joint's coordinates stand in `q` and `v`, and their names.

use crate::joint::{AxisKind, JointKind};
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
/// Joints follow the order of the links. A degree of freedom is called `joint.axis` (`left_knee.rx`), unless it was given
/// a name of its own; a repeated axis gets a number (`wrist.rx2`); a one-dof joint also answers to its own name. A ball
/// joint has `joint.qx … qw` in `q` and `joint.wx, wy, wz` in `v`; a free joint has `joint.px, py, pz` and `joint.vx, vy,
/// vz` before these.
#[doc(alias = "idx_q")]
#[doc(alias = "idx_v")]
#[doc(alias = "configuration")]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StateLayout {
    joints: Vec<JointLayout>,
    q_names: Vec<String>,
    v_names: Vec<String>,
    coordinates: Vec<Option<usize>>,
    axis_kinds: Vec<AxisKind>,
    by_name: HashMap<String, usize>,
}

impl StateLayout {
    pub(crate) fn of(links: &[Link]) -> Self {
        let mut layout = Self::default();
        for link in links {
            let (name, kind) = (link.joint.name(), link.joint.kind());
            let (q, v) = (layout.q_names.len(), layout.v_names.len());
            layout.joints.push(JointLayout { q, nq: kind.nq(), v, nv: kind.nv() });
            let names = velocity_names(name, kind);
            if names.len() == 1 {
                // A full name wins over a joint's short one.
                layout.by_name.entry(name.to_owned()).or_insert(v);
            }
            for (i, dof) in names.iter().enumerate() {
                layout.by_name.insert(dof.clone(), v + i);
                // Where there is a coordinate that is the integral of the velocity.
                layout.coordinates.push(kind.quaternion().is_none().then_some(q + i));
            }
            let slides: Vec<usize> = kind.slides().collect();
            let axis_kind =
                |i: usize| if slides.contains(&i) { AxisKind::Translation } else { AxisKind::Rotation };
            layout.axis_kinds.extend((0..kind.nv()).map(axis_kind));
            layout.q_names.extend(position_names(name, kind));
            layout.v_names.extend(names);
        }
        layout
    }

    /// Length of `q`.
    #[doc(alias = "configuration size")]
    pub fn nq(&self) -> usize {
        self.q_names.len()
    }

    /// Length of `v`, `a` and `tau`.
    #[doc(alias = "degrees of freedom")]
    #[doc(alias = "dof")]
    #[doc(alias = "DoF")]
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

    /// Index in `q` of the coordinate whose rate is `v[dof]`; `None` for the velocities of ball and free joints, which are
    /// the rates of no coordinate.
    pub fn coordinate(&self, dof: usize) -> Option<usize> {
        self.coordinates[dof]
    }

    /// Whether a degree of freedom turns or slides: its velocity is in rad/s or m/s, its force in N m or N.
    pub fn axis_kind(&self, dof: usize) -> AxisKind {
        self.axis_kinds[dof]
    }

    /// Index in `v` of the degree of freedom called `name`.
    #[doc(alias = "idx_v")]
    pub fn dof_index(&self, name: &str) -> Option<usize> {
        self.by_name.get(name).copied()
    }
}

/// Names of the position coordinates of one joint.
fn position_names(joint: &str, kind: &JointKind) -> Vec<String> {
    match kind {
        JointKind::Axes(_) => velocity_names(joint, kind),
        JointKind::Ball { .. } => suffixed(joint, &["qx", "qy", "qz", "qw"]),
        JointKind::Free { .. } => suffixed(joint, &["px", "py", "pz", "qx", "qy", "qz", "qw"]),
    }
}

/// Names of the degrees of freedom of one joint: `joint.rx`, and `joint.rx2` for the second of a kind.
pub(crate) fn velocity_names(joint: &str, kind: &JointKind) -> Vec<String> {
    let dofs = match kind {
        JointKind::Axes(dofs) => dofs,
        JointKind::Ball { .. } => return suffixed(joint, &["wx", "wy", "wz"]),
        JointKind::Free { .. } => return suffixed(joint, &["vx", "vy", "vz", "wx", "wy", "wz"]),
    };
    let mut seen: HashMap<&str, usize> = HashMap::new();
    let names = dofs.iter().map(|dof| {
        let stem = dof.axis.stem();
        let count = seen.entry(stem).and_modify(|n| *n += 1).or_insert(1);
        dof.name.clone().unwrap_or_else(|| match *count {
            1 => format!("{joint}.{stem}"),
            count => format!("{joint}.{stem}{count}"),
        })
    });
    names.collect()
}

fn suffixed(joint: &str, parts: &[&str]) -> Vec<String> {
    parts.iter().map(|part| format!("{joint}.{part}")).collect()
}

#[cfg(test)]
mod tests {
    use crate::{AxisKind, FigureBuilder, Joint, LinkSpec};

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

    #[test]
    fn ball_and_free_joints_have_more_positions_than_velocities() {
        let figure = FigureBuilder::new("f")
            .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
            .link(LinkSpec::child("b", "a", Joint::ball("hip")).mass(1.0))
            .link(LinkSpec::child("c", "b", Joint::new("knee").rx().named("flexion")).mass(1.0))
            .build()
            .expect("valid");
        let layout = figure.layout();
        assert_eq!((layout.nq(), layout.nv()), (12, 10));
        assert_eq!(layout.q_names()[7..], ["hip.qx", "hip.qy", "hip.qz", "hip.qw", "flexion"]);
        assert_eq!(
            layout.v_names()[3..],
            ["root.wx", "root.wy", "root.wz", "hip.wx", "hip.wy", "hip.wz", "flexion"]
        );
        assert_eq!((layout.dof_index("knee"), layout.dof_index("flexion")), (Some(9), Some(9)));
        assert_eq!((layout.coordinate(9), layout.coordinate(6)), (Some(11), None));
    }

    #[test]
    fn a_free_joint_slides_first_and_axes_are_what_they_are_called() {
        let figure = FigureBuilder::new("f")
            .link(LinkSpec::root("a", Joint::free("root")).mass(1.0))
            .link(LinkSpec::child("b", "a", Joint::ball("hip")).mass(1.0))
            .link(LinkSpec::child("c", "b", Joint::new("knee").rx().ty()).mass(1.0))
            .build()
            .expect("valid");
        let slides = |dof: &usize| figure.layout().axis_kind(*dof) == AxisKind::Translation;
        assert_eq!((0..11).filter(slides).collect::<Vec<_>>(), [0, 1, 2, 10]);
    }
}
