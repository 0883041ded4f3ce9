//! The kernel.

use crate::figure::Figure;
use crate::{check, failed};
use solaris::dynamics::{self as kernel, DMatrix, DynamicsError, Tree, Workspace};
use solaris::model::{Rotation3, UnitQuaternion, Vector3};
use wasm_bindgen::prelude::*;

/// The dynamics of a figure under gravity.
#[wasm_bindgen]
pub struct Dynamics {
    tree: Tree<f64>,
    workspace: Workspace<f64>,
}

type Solve = fn(
    &Tree<f64>,
    &mut Workspace<f64>,
    &[f64],
    &[f64],
    &[f64],
    &[(usize, kernel::Wrench<f64>)],
    &mut [f64],
) -> Result<(), DynamicsError>;

impl Dynamics {
    fn solve(&mut self, solve: Solve, q: &[f64], v: &[f64], given: &[f64]) -> Result<Vec<f64>, JsError> {
        let mut out = vec![0.0; self.tree.nv()];
        solve(&self.tree, &mut self.workspace, q, v, given, &[], &mut out).map_err(failed)?;
        Ok(out)
    }
}

#[wasm_bindgen]
impl Dynamics {
    /// Of a figure under its own gravity, or under another one (m/s², three numbers).
    #[wasm_bindgen(constructor)]
    pub fn new(figure: &Figure, gravity: Option<Vec<f64>>) -> Result<Dynamics, JsError> {
        let gravity = match gravity {
            None => figure.gravity,
            Some(given) => {
                check("gravity", given.len(), 3)?;
                Vector3::from_column_slice(&given)
            }
        };
        let tree = Tree::new(&figure.figure, gravity).map_err(failed)?;
        let workspace = Workspace::new(&tree);
        Ok(Self { tree, workspace })
    }

    /// Inverse dynamics: the generalized forces (N m, N) of a motion.
    pub fn inverse(&mut self, q: &[f64], v: &[f64], a: &[f64]) -> Result<Vec<f64>, JsError> {
        self.solve(kernel::inverse_dynamics, q, v, a)
    }

    /// Forward dynamics: the accelerations that forces bring about.
    pub fn forward(&mut self, q: &[f64], v: &[f64], tau: &[f64]) -> Result<Vec<f64>, JsError> {
        self.solve(kernel::forward_dynamics, q, v, tau)
    }

    /// The mass matrix, `nv * nv` numbers; it is symmetric.
    #[wasm_bindgen(js_name = massMatrix)]
    pub fn mass_matrix(&mut self, q: &[f64]) -> Result<Vec<f64>, JsError> {
        let nv = self.tree.nv();
        let mut matrix = DMatrix::zeros(nv, nv);
        kernel::mass_matrix(&self.tree, &mut self.workspace, q, &mut matrix).map_err(failed)?;
        Ok(matrix.as_slice().to_vec())
    }

    /// Where all links stand in the world: seven numbers a link, its place (m) and its quaternion (x, y, z, w), as three.js has them.
    pub fn poses(&mut self, q: &[f64]) -> Result<Vec<f64>, JsError> {
        kernel::forward_kinematics(&self.tree, &mut self.workspace, q).map_err(failed)?;
        let pose = |link: usize| {
            let pose = self.workspace.pose(link);
            let rotation = Rotation3::from_matrix_unchecked(pose.rotation);
            let turned = UnitQuaternion::from_rotation_matrix(&rotation);
            let [x, y, z, w]: [f64; 4] = turned.coords.into();
            let [px, py, pz]: [f64; 3] = pose.translation.into();
            [px, py, pz, x, y, z, w]
        };
        Ok((0..self.tree.link_count()).flat_map(pose).collect())
    }

    /// The centre of mass (m).
    #[wasm_bindgen(js_name = centerOfMass)]
    pub fn center_of_mass(&mut self, q: &[f64]) -> Result<Vec<f64>, JsError> {
        let com = kernel::center_of_mass(&self.tree, &mut self.workspace, q).map_err(failed)?;
        Ok(com.as_slice().to_vec())
    }
}
