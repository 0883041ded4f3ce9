//! Files that were dropped together: what they are, and what comes of them.

use super::anatomy::anatomy;
use super::{Posed, Shelf, Shown};
use crate::failed;
use crate::figure::Figure;
use serde_json::{Value, json};
use solaris::analysis::Filter;
use solaris::analysis::ground::{Sole, soles};
use solaris::files::{AskedGround, External, MomentOptions, OpenOptions, Opened, open};
use solaris::view::{LinkLine, PageOptions};
use std::mem::take;
use wasm_bindgen::prelude::*;

/// Poles of a pass of the filter, as OpenSim has them.
const ORDER: usize = 3;

/// What files came to.
#[wasm_bindgen]
pub struct Dropped {
    opened: Opened,
}

#[wasm_bindgen]
impl Dropped {
    /// Opens files together.
    #[wasm_bindgen(constructor)]
    pub fn new(files: &Shelf) -> Dropped {
        Self { opened: open(&files.files, OpenOptions::default()) }
    }

    /// More files, of the figure that is open where they have none of their own.
    pub fn and(&mut self, files: &Shelf) {
        let figure = take(&mut self.opened.body).filter(|_| !self.opened.is_cloud);
        self.opened = open(&files.files, OpenOptions { figure, ..OpenOptions::default() });
    }

    /// What each is, as JSON: files with their roles, faults, the figure's and the motion's findings, and which of figure, motion, forces,
    /// soles, scene, page and profile there are.
    pub fn outline(&self) -> String {
        let opened = &self.opened;
        let files: Vec<Value> = opened
            .files
            .iter()
            .map(|file| json!({ "name": file.name, "what": file.what, "used": file.is_used }))
            .collect();
        let mut findings: Vec<String> = Vec::new();
        if let Some(body) = &opened.body {
            findings.extend(body.findings.iter().map(ToString::to_string));
        }
        if let Some(motion) = &opened.motion {
            findings.extend(motion.findings.iter().map(ToString::to_string));
            findings.extend(motion.ignored.iter().map(|name| format!("column '{name}' means nothing here")));
        }
        let plates = opened.recording.as_ref().map_or(0, |recording| recording.plates.len());
        json!({
            "files": files,
            "faults": opened.faults.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "findings": findings,
            "figure": opened.body.as_ref().map(|body| body.figure.name()),
            "isCloud": opened.is_cloud,
            "motion": opened.motion.as_ref().map(|motion| motion.path.to_string_lossy()),
            "measured": !matches!(opened.external, External::None) || !opened.plates.is_empty() || plates > 0,
            "soles": opened.soles.is_some(),
            "scene": opened.scene.as_ref().map(|scene| &scene.text),
            "page": opened.page.as_ref().map(|page| &page.text),
            "profile": opened.profile.as_ref().map(|profile| &profile.text),
        })
        .to_string()
    }

    /// The figure where its coordinates are while nobody says anything else.
    pub fn posed(&self) -> Result<Posed, JsError> {
        let body = self.opened.body.as_ref().ok_or_else(|| failed("there is no figure among these files"))?;
        Posed::at(self.figure()?, body.rest(), None)
    }

    /// What its figure is made of, with its markers and soles, as JSON (see `Shown::anatomy`).
    pub fn anatomy(&self) -> Result<String, JsError> {
        let body = self.opened.body.as_ref().ok_or_else(|| failed("there is no figure among these files"))?;
        let given = self.opened.soles.as_ref().map(|(soles, _)| soles.clone());
        Ok(anatomy(&body.marked(), &given.unwrap_or_else(|| soles(&body.figure))))
    }

    /// The motion as it was recorded.
    pub fn shown(&self) -> Result<Shown, JsError> {
        let motion =
            self.opened.motion.as_ref().ok_or_else(|| failed("there is no motion among these files"))?;
        let title =
            motion.path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        let soles = self.opened.soles.as_ref().map_or(&[][..], |(soles, _)| soles.as_slice());
        Ok(self.shows(Shown::new(self.figure()?, motion.motion.clone(), title), soles))
    }

    /// The motion with its joint moments: forces of the ground as `"measured"`, `"predicted"` or `"none"`, positions filtered by `cutoff`
    /// (Hz), where there is one.
    pub fn moments(&self, ground: &str, cutoff: Option<f64>) -> Result<Moments, JsError> {
        let ground = match ground {
            "measured" => AskedGround::Measured,
            "predicted" => AskedGround::Predicted,
            "none" => AskedGround::None,
            other => {
                return Err(failed(format!(
                    "ground is '{other}'; it must be 'measured', 'predicted' or 'none'"
                )));
            }
        };
        let filter = cutoff.map(|cutoff| Filter { cutoff, order: ORDER });
        let options = MomentOptions { filter, ground, ..MomentOptions::default() };
        let found = self.opened.moments(&options).map_err(failed)?;
        let title = self.shown()?.title();
        let shown = self.shows(Shown::new(self.figure()?, found.motion, title), &found.soles);
        Ok(Moments { shown: Some(shown), external: found.external, findings: found.findings })
    }

    fn figure(&self) -> Result<Figure, JsError> {
        let body = self.opened.body.as_ref().ok_or_else(|| failed("there is no figure among these files"))?;
        let mut figure = Figure::own(body.figure.clone());
        figure.gravity = body.gravity;
        Ok(figure)
    }

    fn shows(&self, shown: Shown, soles: &[Sole]) -> Shown {
        let lines = soles.iter().flat_map(Sole::lines).map(|(link, ends)| LinkLine { link, ends }).collect();
        let forward = self.opened.body.as_ref().and_then(solaris::files::Body::forward);
        let options = PageOptions { lines, forward, ..shown.options };
        Shown { options, ..shown }
    }
}

/// A motion with its joint moments.
#[wasm_bindgen]
pub struct Moments {
    shown: Option<Shown>,
    external: String,
    findings: Vec<String>,
}

#[wasm_bindgen]
impl Moments {
    /// The motion; it can be taken once.
    pub fn shown(&mut self) -> Result<Shown, JsError> {
        self.shown.take().ok_or_else(|| failed("the motion was taken before"))
    }

    /// The forces from outside, in a line.
    #[wasm_bindgen(getter)]
    pub fn external(&self) -> String {
        self.external.clone()
    }

    /// What there is to look at.
    #[wasm_bindgen(getter)]
    pub fn findings(&self) -> Vec<String> {
        self.findings.clone()
    }
}
