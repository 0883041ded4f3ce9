//! Motions.

#[cfg(feature = "usual")]
use crate::failed;
use crate::figure::Figure;
#[cfg(feature = "full")]
use solaris::io::glb;
use solaris::model;
use wasm_bindgen::prelude::*;
#[cfg(feature = "usual")]
use {
    js_sys::JSON,
    solaris::io::{bvh, csv},
    std::borrow::Cow,
};

/// A sampled motion, with what is known of its forces.
#[wasm_bindgen]
pub struct Motion {
    pub(crate) figure: Figure,
    pub(crate) motion: model::Motion,
    /// JSON.
    #[cfg(feature = "usual")]
    pub(crate) report: String,
    /// Whether its last sample is its first one again.
    #[cfg(feature = "usual")]
    pub(crate) repeats: bool,
}

#[cfg(feature = "usual")]
impl Motion {
    /// What is written frame after frame: a loop without its first frame a second time.
    fn frames(&self) -> Cow<'_, model::Motion> {
        if self.repeats { Cow::Owned(self.motion.without_last()) } else { Cow::Borrowed(&self.motion) }
    }
}

#[wasm_bindgen]
impl Motion {
    /// Who moves.
    #[wasm_bindgen(getter)]
    pub fn figure(&self) -> Figure {
        self.figure.clone()
    }

    /// Number of samples.
    #[wasm_bindgen(getter)]
    pub fn length(&self) -> usize {
        self.motion.len()
    }

    /// Times (s).
    #[wasm_bindgen(getter)]
    pub fn time(&self) -> Vec<f64> {
        self.motion.time().to_vec()
    }

    /// Positions (rad, m), `nq` a sample, one after the other.
    #[wasm_bindgen(getter)]
    pub fn q(&self) -> Vec<f64> {
        self.motion.columns()[0].to_vec()
    }

    /// Velocities, `nv` a sample.
    #[wasm_bindgen(getter)]
    pub fn v(&self) -> Vec<f64> {
        self.motion.columns()[1].to_vec()
    }

    /// Accelerations, `nv` a sample.
    #[wasm_bindgen(getter)]
    pub fn a(&self) -> Vec<f64> {
        self.motion.columns()[2].to_vec()
    }

    /// Generalized forces (N m, N), `nv` a sample; empty where they are not known.
    #[wasm_bindgen(getter)]
    pub fn tau(&self) -> Vec<f64> {
        self.motion.taus().unwrap_or_default().to_vec()
    }

    /// Names of the links that touch the ground.
    #[wasm_bindgen(getter)]
    pub fn contacts(&self) -> Vec<String> {
        self.motion.contacts.iter().map(|track| track.link.clone()).collect()
    }

    /// What the ground does to one of them, nine numbers a sample: force (N), moment about the world's origin (N m), centre of pressure
    /// (m); empty where it does nothing.
    pub fn contact(&self, link: &str) -> Vec<f64> {
        let samples = self.motion.contact(link).map(|track| track.samples.iter()).into_iter().flatten();
        samples
            .flat_map(|at| [at.force, at.moment, at.cop].into_iter().flat_map(|v| [v.x, v.y, v.z]))
            .collect()
    }
}

#[cfg(feature = "usual")]
#[wasm_bindgen]
impl Motion {
    /// What was measured of it, or how it was found and how far it can be trusted.
    #[wasm_bindgen(getter)]
    pub fn report(&self) -> Result<JsValue, JsError> {
        JSON::parse(&self.report).map_err(|_| JsError::new("the report cannot be read"))
    }

    /// The table of it, as CSV.
    #[wasm_bindgen(js_name = toCsv)]
    pub fn to_csv(&self) -> Result<String, JsError> {
        let mut bytes = Vec::new();
        csv::write(&self.figure.figure, &self.frames(), &mut bytes).map_err(failed)?;
        String::from_utf8(bytes).map_err(failed)
    }

    /// Motion capture, as BVH.
    #[wasm_bindgen(js_name = toBvh)]
    pub fn to_bvh(&self) -> Result<String, JsError> {
        let mut bytes = Vec::new();
        bvh::write(&self.figure.figure, &self.frames(), bvh::Unit::default(), &mut bytes).map_err(failed)?;
        String::from_utf8(bytes).map_err(failed)
    }
}

#[cfg(feature = "full")]
#[wasm_bindgen]
impl Motion {
    /// The body with the motion as its clip (named so, or as the figure), as the bytes of a GLB.
    #[wasm_bindgen(js_name = toGlb)]
    pub fn to_glb(&self, clip: Option<String>) -> Result<Vec<u8>, JsError> {
        let figure = &self.figure.figure;
        let actor = glb::Actor { name: figure.name(), figure, skin: None };
        let name = clip.as_deref().unwrap_or_else(|| figure.name());
        let clips = [glb::Clip { name, motions: vec![(0, &self.motion)] }];
        let mut bytes = Vec::new();
        glb::write(&[actor], &clips, glb::Options::default(), &mut bytes).map_err(failed)?;
        Ok(bytes)
    }
}
