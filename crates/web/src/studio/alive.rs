//! A simulation that goes on while it is looked at.

use super::still;
use crate::failed;
use crate::figure::Figure;
use solaris::model::{Ground, Vector3};
use solaris::modes::{Push, Running};
use solaris::view::Live;
use wasm_bindgen::prelude::*;

/// A scene's simulation on its way.
#[wasm_bindgen]
pub struct Alive {
    figure: Figure,
    running: Running,
    live: Live,
    ground: Option<Ground>,
}

impl Alive {
    pub(crate) fn new(figure: Figure, running: Running, ground: Option<Ground>) -> Result<Self, JsError> {
        let live = Live::new(&figure.figure, figure.gravity).map_err(failed)?;
        Ok(Self { figure, running, live, ground })
    }
}

#[wasm_bindgen]
impl Alive {
    /// What a page holds of it now, as JSON.
    pub fn data(&self) -> Result<String, JsError> {
        still(&self.figure, self.running.q(), self.ground, true)
    }

    /// Goes on by `dt` (s), and gives the poses of all links: seven numbers each.
    pub fn step(&mut self, dt: f64) -> Result<Vec<f32>, JsError> {
        self.running.step(dt).map_err(failed)?;
        self.poses()
    }

    /// The poses of all links: seven numbers each.
    pub fn poses(&mut self) -> Result<Vec<f32>, JsError> {
        Ok(self.live.poses(self.running.q()).map_err(failed)?.to_vec())
    }

    /// How long it has run (s).
    #[wasm_bindgen(getter)]
    pub fn time(&self) -> f64 {
        self.running.time()
    }

    /// The configuration.
    #[wasm_bindgen(getter)]
    pub fn q(&self) -> Vec<f64> {
        self.running.q().to_vec()
    }

    /// Energy of motion, of height and springs, and the sum (J).
    pub fn energy(&mut self) -> Result<Vec<f64>, JsError> {
        let energy = self.running.energy().map_err(failed)?;
        Ok(vec![energy.kinetic, energy.potential, energy.kinetic + energy.potential])
    }

    /// The forces of the joints (`nv`; N m, N).
    pub fn forces(&mut self) -> Result<Vec<f64>, JsError> {
        Ok(self.running.forces().map_err(failed)?.to_vec())
    }

    /// What the ground does: of each link that it presses the link, its force (N) and centre of pressure (m) in the picture, seven numbers.
    pub fn contacts(&mut self) -> Result<Vec<f64>, JsError> {
        let touching = self.running.contacts().map_err(failed)?;
        let all = touching.iter().flat_map(|touch| {
            let [f, p] = [touch.contact.force, touch.contact.cop].map(|own| self.live.shown(&own));
            [touch.link as f64, f[0], f[1], f[2], p[0], p[1], p[2]]
        });
        Ok(all.collect())
    }

    /// A point (m) of the picture in the frame of a link.
    #[wasm_bindgen(js_name = inLink)]
    pub fn in_link(&self, link: usize, x: f64, y: f64, z: f64) -> Vec<f64> {
        self.live.in_link(link, [x, y, z]).as_slice().to_vec()
    }

    /// Pulls a point (three numbers, m, in the frame of a link) towards a place of the picture (three numbers, m) as a spring of `stiffness`
    /// (N/m) does, until something else is said; gives the force (N) in the picture.
    pub fn pull(
        &mut self,
        link: usize,
        point: &[f64],
        place: &[f64],
        stiffness: f64,
    ) -> Result<Vec<f64>, JsError> {
        crate::check("point", point.len(), 3)?;
        crate::check("place", place.len(), 3)?;
        let point = Vector3::from_column_slice(point);
        let at = self.live.from_link(link, &point);
        let shown: Vec<f64> = at.iter().zip(place).map(|(at, to)| stiffness * (to - at)).collect();
        let force = self.live.own([shown[0], shown[1], shown[2]]);
        self.running.set_pushes(&[Push::steady(link, point, force)]).map_err(failed)?;
        Ok(shown)
    }

    /// Lets go.
    #[wasm_bindgen(js_name = letGo)]
    pub fn let_go(&mut self) -> Result<(), JsError> {
        self.running.set_pushes(&[]).map_err(failed)
    }

    /// Another target (rad, m) for the servo of a degree of freedom (index in `v`).
    #[wasm_bindgen(js_name = setTarget)]
    pub fn set_target(&mut self, dof: usize, to: f64) -> Result<(), JsError> {
        self.running.set_target(dof, to).map_err(failed)
    }

    /// Another force (N m, N) on a degree of freedom (index in `v`) that is free.
    #[wasm_bindgen(js_name = setForce)]
    pub fn set_force(&mut self, dof: usize, force: f64) -> Result<(), JsError> {
        self.running.set_force(dof, force).map_err(failed)
    }

    /// One that goes on from here by itself, to the same bits.
    pub fn copy(&self) -> Alive {
        let (figure, running, live) = (self.figure.clone(), self.running.clone(), self.live.clone());
        Self { figure, running, live, ground: self.ground }
    }
}
