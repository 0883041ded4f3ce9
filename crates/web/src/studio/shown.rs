//! A motion as it is looked at and taken away.

use super::anatomy::anatomy;
use super::shown_data;
use crate::failed;
use crate::figure::Figure;
use crate::motion::Motion;
use solaris::analysis::ground::soles;
use solaris::io::record::positions_in_degrees;
use solaris::io::{bvh, csv, glb, sto, usd};
use solaris::model;
use solaris::skin::{Detail, skin};
use solaris::view::{PageOptions, TableRow, Viewer, page_by};
use wasm_bindgen::prelude::*;

/// A motion with all that a page says of it.
#[wasm_bindgen]
pub struct Shown {
    pub(crate) figure: Figure,
    pub(crate) motion: model::Motion,
    pub(crate) options: PageOptions,
}

impl Shown {
    pub(crate) fn new(figure: Figure, motion: model::Motion, title: String) -> Self {
        let people = figure.parts.clone();
        Self { figure, motion, options: PageOptions { title, people, ..PageOptions::default() } }
    }
}

#[wasm_bindgen]
impl Shown {
    /// A motion under a title.
    #[wasm_bindgen(constructor)]
    pub fn of_motion(motion: &Motion, title: String) -> Shown {
        Self::new(motion.figure.clone(), motion.motion.clone(), title)
    }

    /// Who moves.
    #[wasm_bindgen(getter)]
    pub fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// Its title.
    #[wasm_bindgen(getter)]
    pub fn title(&self) -> String {
        self.options.title.clone()
    }

    /// How long it lasts (s).
    #[wasm_bindgen(getter)]
    pub fn duration(&self) -> f64 {
        let time = self.motion.time();
        time.last().zip(time.first()).map_or(0.0, |(last, first)| last - first)
    }

    /// The configuration of a sample.
    pub fn q(&self, sample: usize) -> Result<Vec<f64>, JsError> {
        if sample >= self.motion.len() {
            return Err(failed(format!("sample {sample}: there are {}", self.motion.len())));
        }
        Ok(self.motion.q(sample).to_vec())
    }

    /// What the figure is made of, as JSON: of each link its centre of mass, the ellipsoid of its inertia, named points, axes of its joint; and
    /// lines of soles, all in the frames of links.
    pub fn anatomy(&self) -> String {
        anatomy(&self.figure.figure, &soles(&self.figure.figure))
    }

    /// What a page holds of it, as JSON; `skinned`: with the skin of a person (see `skinOf`).
    pub fn data(&self, skinned: bool) -> Result<String, JsError> {
        shown_data(&self.figure.figure, &self.motion, &self.options, skinned)
    }

    /// A page that shows it, by the viewer's script and style, with rows of a table: label, value, unit and note, one after the other.
    pub fn page(&self, script: &str, style: &str, rows: Vec<String>) -> Result<String, JsError> {
        let rows = rows.chunks_exact(4).map(|row| TableRow::new(&row[0], &row[1], &row[2], &row[3]));
        let options = PageOptions { table: rows.collect(), ..self.options.clone() };
        page_by(&Viewer { script, style }, &self.figure.figure, &self.motion, &options).map_err(failed)
    }

    /// The bytes of a file: `"csv"`, `"mot"`, `"sto"`, `"bvh"`, `"glb"` or `"usda"`.
    pub fn save(&self, format: &str) -> Result<Vec<u8>, JsError> {
        let (figure, motion) = (&self.figure.figure, &self.motion);
        let mut bytes = Vec::new();
        let clip = if self.options.title.is_empty() { figure.name() } else { &self.options.title };
        match format {
            "csv" => csv::write(figure, motion, &mut bytes).map_err(failed)?,
            "mot" | "sto" => {
                sto::write(&positions_in_degrees(figure, motion), &mut bytes).map_err(failed)?;
            }
            "bvh" => bvh::write(figure, motion, bvh::Unit::default(), &mut bytes).map_err(failed)?,
            "glb" => {
                let actor = glb::Actor { name: figure.name(), figure, skin: None };
                let clips = [glb::Clip { name: clip, motions: vec![(0, motion)] }];
                glb::write(&[actor], &clips, glb::Options::default(), &mut bytes).map_err(failed)?;
            }
            "usda" => {
                let skin = skin(figure, Detail::default());
                usd::write(figure, &skin, clip, motion, &mut bytes).map_err(failed)?;
            }
            other => {
                return Err(failed(format!(
                    "format is '{other}'; it must be 'csv', 'mot', 'sto', 'bvh', 'glb' or 'usda'"
                )));
            }
        }
        Ok(bytes)
    }
}
