//! Figures.

use crate::failed;
use crate::options::human_options;
#[cfg(feature = "usual")]
use solaris::io::{Import, mjcf, urdf};
#[cfg(feature = "full")]
use solaris::io::{opensim, sdf};
use solaris::model::{self, Human, Link, RootOrder, Vector3, text};
use wasm_bindgen::prelude::*;

/// What texts of figures can be, by entry.
const FORMATS: &str = if cfg!(feature = "full") {
    "'ron', 'urdf', 'mjcf', 'osim' or 'sdf'"
} else if cfg!(feature = "usual") {
    "'ron', 'urdf' or 'mjcf', or with solaris-motion/full 'osim' or 'sdf'"
} else {
    "'ron', or with solaris-motion 'urdf' or 'mjcf', or with solaris-motion/full 'osim' or 'sdf'"
};

/// Gravity where no text says it: y is up (m/s²).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);

#[wasm_bindgen(typescript_custom_section)]
const OPTIONS: &str = r"
/** What is more to say of a person. */
export interface HumanOptions {
  /** What each hand carries (kg). */
  load?: { left?: number; right?: number };
  /** By how much a leg is shorter (m). */
  shorterLeg?: { left?: number; right?: number };
  /** Which hand holds a cane. */
  cane?: 'left' | 'right';
}
";

#[wasm_bindgen]
extern "C" {
    /// What is more to say of a person.
    #[wasm_bindgen(typescript_type = "HumanOptions")]
    pub type HumanOptions;
}

/// An articulated figure. It never changes.
#[wasm_bindgen]
#[derive(Clone)]
pub struct Figure {
    pub(crate) figure: model::Figure,
    pub(crate) gravity: Vector3<f64>,
    findings: Vec<String>,
    /// The figures that it is made of, where it is several: each with its first link.
    #[cfg(feature = "studio")]
    pub(crate) parts: Vec<solaris::view::PagePerson>,
}

impl Figure {
    pub(crate) fn own(figure: model::Figure) -> Self {
        let gravity = figure.gravity().copied().unwrap_or(GRAVITY);
        Self {
            figure,
            gravity,
            findings: Vec::new(),
            #[cfg(feature = "studio")]
            parts: Vec::new(),
        }
    }
}

#[cfg(feature = "usual")]
impl Figure {
    /// A model of another program.
    fn read(import: Import) -> Result<Self, JsError> {
        let findings = import.findings.iter().map(ToString::to_string).collect();
        let figure = import.figure.with_gravity(import.gravity).map_err(failed)?;
        Ok(Self { gravity: import.gravity, findings, ..Self::own(figure) })
    }
}

#[wasm_bindgen]
impl Figure {
    /// A person of this height (m) and mass (kg), with a child's proportions below 18 years; the root turns by its heading first, as
    /// `Walker` needs it. `more`: what hands carry (kg), by how much a leg is shorter (m), and which hand holds a cane: `{ load: { right: 5 }, shorterLeg: { left: 0.02 }, cane: "left" }`.
    pub fn human(
        height: f64,
        mass: f64,
        age: Option<f64>,
        more: Option<HumanOptions>,
    ) -> Result<Figure, JsError> {
        let human = Human::new(height, mass).root(RootOrder::Yzx);
        let human = match age {
            Some(age) => human.age(age),
            None => human,
        };
        human_options(human, more)?.build().map(Self::own).map_err(failed)
    }

    /// A figure from a text: `"ron"` (Solaris' own, the default), `"urdf"` or `"mjcf"`; with the entry `solaris-motion/full` also `"osim"` or `"sdf"`;
    /// with `solaris-motion/lean` only `"ron"`.
    #[wasm_bindgen(js_name = fromText)]
    pub fn from_text(source: &str, format: Option<String>) -> Result<Figure, JsError> {
        match format.as_deref().unwrap_or("ron") {
            "ron" => text::read(source).map(Self::own).map_err(failed),
            #[cfg(feature = "usual")]
            "urdf" => urdf::read(source).map_err(failed).and_then(Self::read),
            #[cfg(feature = "usual")]
            "mjcf" => mjcf::read(source).map_err(failed).and_then(Self::read),
            #[cfg(feature = "full")]
            "osim" => opensim::read(source).map_err(failed).and_then(Self::read),
            #[cfg(feature = "full")]
            "sdf" => sdf::read(source).map_err(failed).and_then(Self::read),
            other => Err(failed(format!("format is '{other}'; it must be {FORMATS}"))),
        }
    }

    /// Its text, which `Figure.fromText` reads back.
    #[cfg(feature = "usual")]
    #[wasm_bindgen(js_name = toText)]
    pub fn to_text(&self) -> String {
        text::write(&self.figure)
    }

    /// Its name.
    #[wasm_bindgen(getter)]
    pub fn name(&self) -> String {
        self.figure.name().to_owned()
    }

    /// Total mass (kg).
    #[wasm_bindgen(getter)]
    pub fn mass(&self) -> f64 {
        self.figure.mass()
    }

    /// Length of a configuration `q`.
    #[wasm_bindgen(getter)]
    pub fn nq(&self) -> usize {
        self.figure.layout().nq()
    }

    /// Length of `v`, `a` and `tau`.
    #[wasm_bindgen(getter)]
    pub fn nv(&self) -> usize {
        self.figure.layout().nv()
    }

    /// Names of the links, the root first.
    #[wasm_bindgen(getter)]
    pub fn links(&self) -> Vec<String> {
        self.figure.links().iter().map(|link| link.name().to_owned()).collect()
    }

    /// Index of each link's parent; -1 of the root's.
    #[wasm_bindgen(getter)]
    pub fn parents(&self) -> Vec<i32> {
        self.figure.links().iter().map(Link::parent).map(|parent| parent.map_or(-1, |at| at as i32)).collect()
    }

    /// Names of the entries of `q`.
    #[wasm_bindgen(getter, js_name = qNames)]
    pub fn q_names(&self) -> Vec<String> {
        self.figure.layout().q_names().to_vec()
    }

    /// Names of the entries of `v`, `a` and `tau`.
    #[wasm_bindgen(getter, js_name = vNames)]
    pub fn v_names(&self) -> Vec<String> {
        self.figure.layout().v_names().to_vec()
    }

    /// What its reader had to say.
    #[wasm_bindgen(getter)]
    pub fn findings(&self) -> Vec<String> {
        self.findings.clone()
    }

    /// The configuration in which every joint is at zero.
    pub fn neutral(&self) -> Result<Vec<f64>, JsError> {
        let mut q = vec![0.0; self.nq()];
        self.figure.neutral(&mut q).map_err(failed)?;
        Ok(q)
    }
}
