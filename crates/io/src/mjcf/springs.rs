//! Springs and dampers that `springdamper` sets by what their joint feels of the whole model.

use super::sections::World;
use solaris_dynamics::{Tree, Workspace, forward_dynamics};
use solaris_model::{Figure, Placement, Vector3};
use std::collections::HashMap;

/// The most joints of which they are found: each asks for the accelerations of the whole figure.
const MOST: usize = 1000;

/// What was met of them while bodies were read.
#[derive(Default)]
pub(super) struct Sprung {
    /// Of joints by their names, the time constant (s) and the damping ratio.
    pub(super) joints: Vec<(String, [f64; 2])>,
    /// Of joints that have one, MuJoCo's coordinate in the pose of the file (rad, m).
    pub(super) references: HashMap<String, f64>,
    /// Where bodies on free joints stand in that pose, by the names of the joints.
    pub(super) places: HashMap<String, Placement>,
}

/// Stiffness (N m/rad, N/m) and damping by the names of the joints; none for those that the kernel refuses.
///
/// ```text
/// k = I/(t·ζ)²      d = 2·I/t      I = 1/(M⁻¹)ᵢᵢ
/// ```
///
/// with the mass matrix `M`, armature in it, in the pose of the file, the time constant `t` and the damping ratio `ζ`.
///
/// # Source
///
/// MuJoCo 4.0's documentation, `body/joint/springdamper` and, for the formula, Computation, "Solver parameters" (`solref`).
pub(super) fn find(figure: &Figure, sprung: &Sprung) -> HashMap<String, [f64; 2]> {
    let mut found = HashMap::new();
    let Ok(tree) = Tree::<f64>::new(figure, Vector3::zeros()) else { return found };
    let mut workspace = Workspace::new(&tree);
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let mut q = vec![0.0; nq];
    let mut dofs: HashMap<&str, usize> = HashMap::new();
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        if let Some(first) = link.joint().kind().quaternion() {
            q[at.q + first + 3] = 1.0;
        }
        for (i, dof) in link.joint().kind().axes().iter().enumerate() {
            let Some(name) = dof.name.as_deref() else { continue };
            q[at.q + i] = sprung.references.get(name).copied().unwrap_or(0.0);
            dofs.insert(name, at.v + i);
        }
    }
    for (name, [time, ratio]) in sprung.joints.iter().take(MOST) {
        let Some(&dof) = dofs.get(name.as_str()) else { continue };
        let (mut tau, mut a) = (vec![0.0; nv], vec![0.0; nv]);
        tau[dof] = 1.0;
        if forward_dynamics(&tree, &mut workspace, &q, &vec![0.0; nv], &tau, &[], &mut a).is_err() {
            continue;
        }
        let inertia = 1.0 / a[dof];
        if inertia.is_finite() && inertia > 0.0 {
            found.insert(name.clone(), [inertia / (time * ratio).powi(2), 2.0 * inertia / time]);
        }
    }
    found
}

impl World {
    /// What is found for a joint.
    pub(super) fn sprung(&self, name: &str) -> Option<[f64; 2]> {
        self.sprung.get(name).copied()
    }
}
