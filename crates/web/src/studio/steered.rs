//! The walker as the studio draws it: with a picture of every frame and the force of the ground.

use super::still;
use crate::failed;
use crate::figure::Figure;
use solaris::dynamics::{Tree, Workspace, inverse_dynamics};
use solaris::gait::{Command, Walker};
use solaris::model::Ground;
use solaris::view::Live;
use wasm_bindgen::prelude::*;

/// Forces below this part of the weight have no centre of pressure.
const LEAST: f64 = 0.01;

/// Somebody who walks as told, frame after frame.
#[wasm_bindgen]
pub struct Steered {
    figure: Figure,
    walker: Walker,
    command: Command,
    live: Live,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
}

#[wasm_bindgen]
impl Steered {
    /// One that stands at the origin and faces along z; of a figure of `Figure.human`.
    #[wasm_bindgen(constructor)]
    pub fn new(figure: &Figure) -> Result<Steered, JsError> {
        let tree = Tree::new(&figure.figure, figure.gravity).map_err(failed)?;
        let nv = figure.figure.layout().nv();
        Ok(Self {
            walker: Walker::new(&figure.figure).map_err(failed)?,
            command: Command::stop(),
            live: Live::new(&figure.figure, figure.gravity).map_err(failed)?,
            workspace: Workspace::new(&tree),
            tree,
            v: vec![0.0; nv],
            a: vec![0.0; nv],
            tau: vec![0.0; nv],
            figure: figure.clone(),
        })
    }

    /// What a page holds of the first frame, as JSON.
    pub fn data(&self) -> Result<String, JsError> {
        still(&self.figure, self.walker.configuration(), Some(Ground { height: 0.0, friction: None }))
    }

    /// To come to a stand.
    pub fn stop(&mut self) {
        self.command = Command::stop();
    }

    /// With a velocity in the world (m/s).
    pub fn go(&mut self, x: f64, z: f64) {
        self.command = Command::velocity(x, z);
    }

    /// With a velocity to the left and forward of the way it faces (m/s).
    #[wasm_bindgen(js_name = goOwn)]
    pub fn go_own(&mut self, left: f64, forward: f64) {
        self.command = Command::own_velocity(left, forward);
    }

    /// To a point (m) with a speed (m/s).
    #[wasm_bindgen(js_name = goTo)]
    pub fn go_to(&mut self, x: f64, z: f64, speed: f64) {
        self.command = Command::to_point(x, z, speed);
    }

    /// With what was told last: to face a heading (rad, to the left of z).
    pub fn face(&mut self, heading: f64) {
        self.command = self.command.facing(heading);
    }

    /// Lets a joint of arms or head hang loose, or takes it back.
    pub fn loosen(&mut self, joint: &str, loose: bool) -> Result<(), JsError> {
        if loose { self.walker.loosen(joint) } else { self.walker.tighten(joint) }.map_err(failed)
    }

    /// Goes on by `dt` (s, up to a quarter), and gives the poses of all links: seven numbers each.
    pub fn step(&mut self, dt: f64) -> Result<Vec<f32>, JsError> {
        let q = self.walker.step(dt, &self.command).map_err(failed)?;
        Ok(self.live.poses(q).map_err(failed)?.to_vec())
    }

    /// The force of the ground on both feet (N) and its centre of pressure (m): what the motion of this frame needs.
    pub fn ground(&mut self) -> Result<Vec<f64>, JsError> {
        self.walker.derivatives(&mut self.v, &mut self.a).map_err(failed)?;
        let q = self.walker.configuration();
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

    /// Where it is (x, z; m), which way it faces (rad), with which velocity it goes (x, z; m/s), whether it stands (1), and its
    /// centre of mass (m).
    pub fn state(&self) -> Vec<f64> {
        let ([x, z], [vx, vz], com) = (self.walker.place(), self.walker.velocity(), self.live.com());
        let stands = f64::from(u8::from(self.walker.is_standing()));
        vec![x, z, self.walker.heading(), vx, vz, stands, com[0], com[1], com[2]]
    }

    /// In what the command was bent to what can be walked.
    pub fn bent(&self) -> Vec<String> {
        self.walker.bent().map(|bent| format!("{bent:?}").to_lowercase()).collect()
    }
}
