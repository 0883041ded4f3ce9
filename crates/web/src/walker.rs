//! The walker that is steered while it walks.

use crate::failed;
use crate::figure::Figure;
use solaris::analysis::Goal;
use solaris::gait::{self, Command};
use solaris::model::Vector3;
use wasm_bindgen::prelude::*;

/// A figure that walks as it is told while it walks, frame after frame. The level is x left and z forward of the world.
#[wasm_bindgen]
pub struct Walker {
    pub(crate) walker: gait::Walker,
    command: Command,
}

#[wasm_bindgen]
impl Walker {
    /// One that stands at the origin and faces along z; of a figure of `Figure.human`.
    #[wasm_bindgen(constructor)]
    pub fn new(figure: &Figure) -> Result<Walker, JsError> {
        Ok(Self { walker: gait::Walker::new(&figure.figure).map_err(failed)?, command: Command::stop() })
    }

    /// From the next `step` on: to come to a stand.
    pub fn stop(&mut self) {
        self.command = Command::stop();
    }

    /// From the next `step` on: with a velocity in the world (m/s).
    pub fn go(&mut self, x: f64, z: f64) {
        self.command = Command::velocity(x, z);
    }

    /// From the next `step` on: with a velocity to the left and forward of the way it faces (m/s).
    #[wasm_bindgen(js_name = goOwn)]
    pub fn go_own(&mut self, left: f64, forward: f64) {
        self.command = Command::own_velocity(left, forward);
    }

    /// From the next `step` on: to a point (m) with a speed (m/s), where it stops.
    #[wasm_bindgen(js_name = goTo)]
    pub fn go_to(&mut self, x: f64, z: f64, speed: f64) {
        self.command = Command::to_point(x, z, speed);
    }

    /// With what was told last: to face a heading (rad, to the left of z).
    pub fn face(&mut self, heading: f64) {
        self.command = self.command.facing(heading);
    }

    /// With what was told last: to face a point (m).
    #[wasm_bindgen(js_name = faceTo)]
    pub fn face_to(&mut self, x: f64, z: f64) {
        self.command = self.command.facing_point(x, z);
    }

    /// Lets a joint of arms or head hang loose, or takes it back.
    pub fn loosen(&mut self, joint: &str, loose: bool) -> Result<(), JsError> {
        if loose { self.walker.loosen(joint) } else { self.walker.tighten(joint) }.map_err(failed)
    }

    /// A point of a link (three numbers, m in its frame) reaches for a place (three numbers, m in the world) from now on, by the joints of its arm, or of neck and head.
    pub fn reach(&mut self, link: &str, at: &[f64], to: &[f64]) -> Result<(), JsError> {
        self.walker.reach(link, vector(at)?, &[], Goal::Place(vector(to)?)).map_err(failed)
    }

    /// The z axis of a link looks at a place, as it is seen from a point of the link, by the same joints.
    pub fn look(&mut self, link: &str, at: &[f64], to: &[f64]) -> Result<(), JsError> {
        let goal = Goal::Look { axis: Vector3::z_axis(), at: vector(to)? };
        self.walker.reach(link, vector(at)?, &[], goal).map_err(failed)
    }

    /// A link that reaches or looks comes back into the walk.
    pub fn withdraw(&mut self, link: &str) -> Result<(), JsError> {
        self.walker.withdraw(link).map_err(failed)
    }

    /// Pushes a point of a link (three numbers each: m in its frame, N in the world) from the next `step` on, until it is pushed otherwise or let go.
    pub fn push(&mut self, link: &str, at: &[f64], force: &[f64]) -> Result<(), JsError> {
        self.walker.push(link, vector(at)?, vector(force)?).map_err(failed)
    }

    /// Pushes no more.
    #[wasm_bindgen(js_name = letGo)]
    pub fn let_go(&mut self) {
        self.walker.let_go();
    }

    /// In what the command was bent to what can be walked: `fast`, `aside`, `sharp`, `sudden`, `balance`.
    pub fn bent(&self) -> Vec<String> {
        self.walker.bent().map(|bent| format!("{bent:?}").to_ascii_lowercase()).collect()
    }

    /// Goes on by `dt` (s, up to a quarter), and gives the configuration there.
    pub fn step(&mut self, dt: f64) -> Result<Vec<f64>, JsError> {
        self.walker.step(dt, &self.command).map(<[f64]>::to_vec).map_err(failed)
    }

    /// Where it is (x, z, m).
    #[wasm_bindgen(getter)]
    pub fn place(&self) -> Vec<f64> {
        self.walker.place().to_vec()
    }

    /// Which way it faces (rad, to the left of z, not wrapped).
    #[wasm_bindgen(getter)]
    pub fn heading(&self) -> f64 {
        self.walker.heading()
    }

    /// The velocity that the present step makes (x, z, m/s).
    #[wasm_bindgen(getter)]
    pub fn velocity(&self) -> Vec<f64> {
        self.walker.velocity().to_vec()
    }

    /// Whether both feet stand and no step has begun.
    #[wasm_bindgen(getter, js_name = isStanding)]
    pub fn is_standing(&self) -> bool {
        self.walker.is_standing()
    }

    /// One that goes on from here by itself, to the same bits.
    pub fn copy(&self) -> Walker {
        Self { walker: self.walker.clone(), command: self.command }
    }
}

fn vector(given: &[f64]) -> Result<Vector3<f64>, JsError> {
    let numbers = <[f64; 3]>::try_from(given).map(Into::into);
    numbers.map_err(|_| JsError::new("places, points and forces have three numbers each"))
}
