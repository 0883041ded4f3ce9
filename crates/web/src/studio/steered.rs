//! The walker as the studio draws it: a picture of every frame, and the force of the ground.

use super::still;
use crate::failed;
use crate::figure::Figure;
use crate::walker::Walker;
use solaris::dynamics::{Pose, Tree, Workspace, forward_kinematics, inverse_dynamics};
use solaris::model::{Ground, Vector3};
use solaris::view::Live;
use wasm_bindgen::prelude::*;

/// Forces below this part of the weight have no centre of pressure.
const LEAST: f64 = 0.01;

/// Draws a walker of the same figure, frame after frame.
#[wasm_bindgen]
pub struct Steered {
    figure: Figure,
    live: Live,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
}

#[wasm_bindgen]
impl Steered {
    /// Of the walker's figure.
    #[wasm_bindgen(constructor)]
    pub fn new(figure: &Figure) -> Result<Steered, JsError> {
        let tree = Tree::new(&figure.figure, figure.gravity).map_err(failed)?;
        let nv = figure.figure.layout().nv();
        Ok(Self {
            live: Live::new(&figure.figure, figure.gravity).map_err(failed)?,
            workspace: Workspace::new(&tree),
            tree,
            v: vec![0.0; nv],
            a: vec![0.0; nv],
            tau: vec![0.0; nv],
            figure: figure.clone(),
        })
    }

    /// What a page holds of the first frame, as JSON without the skin.
    pub fn data(&self, walker: &Walker) -> Result<String, JsError> {
        let ground = Ground { height: 0.0, friction: None };
        still(&self.figure, walker.walker.configuration(), Some(ground), false)
    }

    /// The poses of all links where the walker is: seven numbers each.
    pub fn poses(&mut self, walker: &Walker) -> Result<Vec<f32>, JsError> {
        Ok(self.live.poses(walker.walker.configuration()).map_err(failed)?.to_vec())
    }

    /// Where a point of the world is in a link (m, by its index), as the walker stands.
    #[wasm_bindgen(js_name = inLink)]
    pub fn in_link(
        &mut self,
        walker: &Walker,
        link: usize,
        x: f64,
        y: f64,
        z: f64,
    ) -> Result<Vec<f64>, JsError> {
        let pose = self.pose(walker, link)?;
        Ok((pose.rotation.transpose() * (Vector3::new(x, y, z) - pose.translation)).as_slice().to_vec())
    }

    /// Draws a point of a link (m, in its frame) to a place (m) by a spring (N/m), up to a force (N), until the next frame; gives the force.
    pub fn pull(
        &mut self,
        walker: &mut Walker,
        link: usize,
        point: &[f64],
        place: &[f64],
        stiffness: f64,
        most: f64,
    ) -> Result<Vec<f64>, JsError> {
        let vector = |given: &[f64]| {
            <[f64; 3]>::try_from(given)
                .map(Vector3::from)
                .map_err(|_| JsError::new("a place has three numbers"))
        };
        let (point, place) = (vector(point)?, vector(place)?);
        let pose = *self.pose(walker, link)?;
        let force = (place - pose.translation - pose.rotation * point) * stiffness;
        let force = force * (most / force.norm().max(f64::MIN_POSITIVE)).min(1.0);
        walker.walker.push(self.figure.figure.links()[link].name(), point, force).map_err(failed)?;
        Ok(force.as_slice().to_vec())
    }

    fn pose(&mut self, walker: &Walker, link: usize) -> Result<&Pose<f64>, JsError> {
        if link >= self.figure.figure.links().len() {
            return Err(JsError::new(&format!("there is no link {link}")));
        }
        forward_kinematics(&self.tree, &mut self.workspace, walker.walker.configuration()).map_err(failed)?;
        Ok(self.workspace.pose(link))
    }

    /// The force of the ground on both feet (N) and its centre of pressure (m): what the motion of this frame needs
    /// besides what pushes the walker.
    pub fn ground(&mut self, walker: &mut Walker) -> Result<Vec<f64>, JsError> {
        let walker = &mut walker.walker;
        walker.derivatives(&mut self.v, &mut self.a).map_err(failed)?;
        let q = walker.configuration();
        let pushed = walker.push_felt();
        let pushed = pushed.as_slice();
        inverse_dynamics(&self.tree, &mut self.workspace, q, &self.v, &self.a, pushed, &mut self.tau)
            .map_err(failed)?;
        let wrench = self.workspace.base_wrench();
        let (f, m) = (wrench.force, wrench.moment);
        if f.y < LEAST * self.figure.figure.mass() * self.figure.gravity.norm() {
            return Ok(vec![0.0; 6]);
        }
        // Where the moment about the level's axes is zero: m = p × f with p.y = 0.
        Ok(vec![f.x, f.y, f.z, m.z / f.y, 0.0, -m.x / f.y])
    }
}
