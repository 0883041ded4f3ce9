//! Scenes: the motion script.

use crate::failed;
use crate::figure::Figure;
use crate::motion::Motion;
use solaris::scene::{NoFiles, read};
use wasm_bindgen::prelude::*;

/// Runs the text of a scene, which names no files, and gives its motion; its report says how it was found.
#[wasm_bindgen]
pub fn run(source: &str) -> Result<Motion, JsError> {
    let mut scene = read(source, &mut NoFiles).map_err(failed)?;
    scene.settings_mut().forces = true;
    let done = scene.simulate(&mut ()).map_err(failed)?;
    let report = serde_json::to_string(&done.report).map_err(failed)?;
    Ok(Motion { figure: Figure::own(scene.figure().clone()), motion: done.motion, report, repeats: false })
}
