//! The walker as the studio draws it: a picture of every frame, and the force of the ground.

use super::still;
use crate::failed;
use crate::figure::Figure;
use crate::walker::Walker;
use solaris::dynamics::{Tree, Workspace, inverse_dynamics};
use solaris::model::Ground;
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

    /// The force of the ground on both feet (N) and its centre of pressure (m): what the motion of this frame needs.
    pub fn ground(&mut self, walker: &mut Walker) -> Result<Vec<f64>, JsError> {
        let walker = &mut walker.walker;
        walker.derivatives(&mut self.v, &mut self.a).map_err(failed)?;
        let q = walker.configuration();
        inverse_dynamics(&self.tree, &mut self.workspace, q, &self.v, &self.a, &[], &mut self.tau)
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
