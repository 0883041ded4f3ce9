//! A figure that is posed by hand.

use super::anatomy::anatomy;
use super::{joints, still};
use crate::figure::Figure;
use crate::{check, failed};
use serde_json::json;
use solaris::analysis::ground::soles;
use solaris::analysis::{Goal, Reach};
use solaris::dynamics::{Tree, Workspace, inverse_dynamics};
use solaris::model::{Ground, Link, Vector3};
use solaris::view::Live;
use wasm_bindgen::prelude::*;

/// A figure in a pose.
#[wasm_bindgen]
pub struct Posed {
    figure: Figure,
    q: Vec<f64>,
    live: Live,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    ground: Option<Ground>,
}

impl Posed {
    pub(crate) fn at(figure: Figure, q: Vec<f64>, ground: Option<Ground>) -> Result<Self, JsError> {
        let tree = Tree::new(&figure.figure, figure.gravity).map_err(failed)?;
        let mut live = Live::new(&figure.figure, figure.gravity).map_err(failed)?;
        live.poses(&q).map_err(failed)?;
        Ok(Self { workspace: Workspace::new(&tree), tree, live, q, figure, ground })
    }
}

#[wasm_bindgen]
impl Posed {
    /// With every joint at zero.
    #[wasm_bindgen(constructor)]
    pub fn new(figure: &Figure) -> Result<Posed, JsError> {
        Self::at(figure.clone(), figure.neutral()?, None)
    }

    /// What a page holds of it, as JSON.
    pub fn data(&self) -> Result<String, JsError> {
        still(&self.figure, &self.q, self.ground, true)
    }

    /// The figure: its name, its mass, its links with their parents, its joints with their degrees of freedom, as JSON.
    pub fn outline(&self) -> String {
        let figure = &self.figure.figure;
        let links: Vec<_> = figure
            .links()
            .iter()
            .map(|link: &Link| json!({ "name": link.name(), "parent": link.parent(), "mass": link.mass() }))
            .collect();
        json!({
            "name": figure.name(),
            "mass": figure.mass(),
            "links": links,
            "joints": joints(&self.figure),
            "findings": self.figure.findings(),
        })
        .to_string()
    }

    /// What the figure is made of, as JSON (see `Shown::anatomy`).
    pub fn anatomy(&self) -> String {
        anatomy(&self.figure.figure, &soles(&self.figure.figure))
    }

    /// The configuration.
    #[wasm_bindgen(getter)]
    pub fn q(&self) -> Vec<f64> {
        self.q.clone()
    }

    /// Another configuration.
    #[wasm_bindgen(js_name = setQ)]
    pub fn set_q(&mut self, q: Vec<f64>) -> Result<(), JsError> {
        check("q", q.len(), self.q.len())?;
        self.live.poses(&q).map_err(failed)?;
        self.q = q;
        Ok(())
    }

    /// The poses of all links: seven numbers each.
    pub fn poses(&mut self) -> Result<Vec<f32>, JsError> {
        Ok(self.live.poses(&self.q).map_err(failed)?.to_vec())
    }

    /// What holds it up without moving (`nv`; N m, N).
    pub fn moments(&mut self) -> Result<Vec<f64>, JsError> {
        let zero = vec![0.0; self.tree.nv()];
        let mut tau = zero.clone();
        inverse_dynamics(&self.tree, &mut self.workspace, &self.q, &zero, &zero, &[], &mut tau)
            .map_err(failed)?;
        Ok(tau)
    }

    /// A point (m) of the picture in the frame of a link.
    #[wasm_bindgen(js_name = inLink)]
    pub fn in_link(&self, link: usize, x: f64, y: f64, z: f64) -> Result<Vec<f64>, JsError> {
        self.known(link)?;
        Ok(self.live.in_link(link, [x, y, z]).as_slice().to_vec())
    }

    /// Brings a point (three numbers, m, in the frame of a link) to a place of the picture (three numbers, m) by the `reach` nearest joints
    /// between it and the root, within their limits; gives how far it still is (m).
    pub fn drag(&mut self, link: usize, point: &[f64], place: &[f64], reach: usize) -> Result<f64, JsError> {
        self.known(link)?;
        check("point", point.len(), 3)?;
        check("place", place.len(), 3)?;
        let figure = &self.figure.figure;
        let layout = figure.layout();
        let mut dofs: Vec<usize> = Vec::new();
        let (mut at, mut left) = (link, reach);
        // The root stays where it is.
        while let Some(parent) = figure.links()[at].parent().filter(|_| left > 0) {
            let joint = layout.joints()[at];
            let movable = |dof: &usize| layout.coordinate(*dof).is_some() && !figure.follows(*dof);
            let before = dofs.len();
            dofs.extend((joint.v..joint.v + joint.nv).filter(movable));
            left -= usize::from(dofs.len() > before);
            at = parent;
        }
        let mut q = self.q.clone();
        let mut reach = Reach::new(figure, link, Vector3::from_column_slice(point), &dofs).map_err(failed)?;
        let place = self.live.own([place[0], place[1], place[2]]);
        let reached = reach.solve(&mut q, &Goal::Place(place)).map_err(failed)?;
        self.set_q(q)?;
        Ok(reached.off)
    }

    fn known(&self, link: usize) -> Result<(), JsError> {
        let links = self.figure.figure.links().len();
        if link < links { Ok(()) } else { Err(failed(format!("link {link}: there are {links}"))) }
    }
}
