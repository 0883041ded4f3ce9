//! Units of the forces of a figure's degrees of freedom.

use solaris::model::{AxisKind, Figure, JointKind};

/// Of each degree of freedom, whether it slides: its force is in N, the others' in N m.
pub(crate) fn slides(figure: &Figure) -> Vec<bool> {
    let mut slides = Vec::with_capacity(figure.layout().nv());
    for link in figure.links() {
        match link.joint().kind() {
            JointKind::Free { .. } => slides.extend([true, true, true, false, false, false]),
            JointKind::Axes(dofs) => {
                slides.extend(dofs.iter().map(|dof| dof.axis.kind == AxisKind::Translation));
            }
            kind => slides.extend((0..kind.nv()).map(|_| false)),
        }
    }
    slides
}
