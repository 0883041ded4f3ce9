//! Meshes: what a solid of triangles weighs.

mod files;
mod hull;
mod integrals;
mod obj;
mod stl;

pub(super) use integrals::Solid;

use super::defaults::Resolved;
use super::model::{Mesh, Model};
use super::orientation::wxyz;
use crate::loader::{Loader, within};
use crate::xml::{Reader, elements_called};
use integrals::Counted;
use solaris_model::{Figure, UnitQuaternion, Vector3};
use std::collections::HashMap;
use std::rc::Rc;

/// Three corners.
pub(super) type Triangle = [Vector3<f64>; 3];

/// The most bytes of a file.
const MOST_BYTES: usize = 1 << 26;

/// The meshes of all models, read when something needs their mass.
pub(super) struct Meshes<'l> {
    loader: &'l mut dyn Loader,
    /// By model and name.
    read: HashMap<(usize, String), Result<Rc<Solid>, String>>,
}

impl<'l> Meshes<'l> {
    pub(super) fn new(loader: &'l mut dyn Loader) -> Self {
        Self { loader, read: HashMap::new() }
    }

    /// The solid of a mesh, at unit density, or why there is none.
    pub(super) fn solid(
        &mut self,
        reader: &mut Reader,
        models: &[Model],
        model: usize,
        name: &str,
    ) -> Result<Rc<Solid>, String> {
        let key = (model, name.to_owned());
        if let Some(known) = self.read.get(&key) {
            return known.clone();
        }
        let solid = self.read(reader, &models[model], name).map(Rc::new);
        self.read.insert(key, solid.clone());
        solid
    }

    fn read(&mut self, reader: &mut Reader, model: &Model, name: &str) -> Result<Solid, String> {
        let Some(asset) = model.meshes.get(name) else {
            return Err(format!("there is no <mesh> '{name}' in the <asset>"));
        };
        let element = model.defaults.resolve(reader, asset.node, 0);
        let mut triangles = self.triangles(reader, model, asset, &element)?;
        // As MuJoCo, which holds corners in 32 bits.
        for corner in triangles.iter_mut().flatten() {
            *corner = corner.map(|x| f64::from(x as f32));
        }
        let scale = element.numbers(reader, "scale").map_or_else(|| Vector3::repeat(1.0), Vector3::from);
        let shift = element.numbers(reader, "refpos").map_or_else(Vector3::zeros, Vector3::from);
        let turn: Option<[f64; 4]> = element.numbers(reader, "refquat");
        let turn = turn.and_then(|numbers| wxyz(&numbers)).unwrap_or_else(UnitQuaternion::identity);
        let is_within = |corner: &Vector3<f64>| corner.iter().all(|x| x.abs() <= Figure::LONGEST);
        for triangle in &mut triangles {
            for corner in triangle.iter_mut() {
                *corner = (turn.inverse() * (*corner - shift)).component_mul(&scale);
                // What areas and volumes are made of has to stay finite.
                if !is_within(corner) {
                    return Err(format!(
                        "a corner lies more than {:e} m away along an axis; is its 'scale' right, and its file whole?",
                        Figure::LONGEST
                    ));
                }
            }
            if scale.product() < 0.0 {
                triangle.swap(1, 2);
            }
        }
        let counted = match element.text("inertia") {
            None if model.compiler.meshes.exact => Counted::Signed,
            None | Some("legacy") => Counted::Pyramids,
            Some("exact") => Counted::Signed,
            Some("shell") => Counted::Surface,
            Some("convex") => Counted::Hull,
            Some(other) => {
                return Err(format!("its 'inertia' is '{other}'; it must be convex, exact, legacy or shell"));
            }
        };
        Solid::of(&triangles, counted)
    }

    fn triangles(
        &mut self,
        reader: &mut Reader,
        model: &Model,
        Mesh { node: asset, beside }: &Mesh,
        element: &Resolved,
    ) -> Result<Vec<Triangle>, String> {
        let asset = *asset;
        if let Some(kind) = asset.attribute("builtin").filter(|kind| *kind != "none") {
            return Err(format!("the builtin mesh '{kind}' is not made here"));
        }
        let is_made = elements_called(asset, "plugin").next().is_some();
        if is_made {
            return Err("its shape is a plugin's".to_owned());
        }
        if asset.has_attribute("vertex") {
            let corners = reader
                .number_list(asset, "vertex", 12..=usize::MAX)
                .ok_or("its 'vertex' holds no corners")?;
            let faces = reader.number_list(asset, "face", 0..=usize::MAX).unwrap_or_default();
            return files::indexed(&corners, &faces);
        }
        let file = element.text("file").ok_or("it has neither a file nor corners")?;
        self.file(model, beside, file)
    }

    /// From the mesh folder of the model, or from that beside the file that names it.
    fn file(&mut self, model: &Model, beside: &str, file: &str) -> Result<Vec<Triangle>, String> {
        let settings = &model.compiler.meshes;
        let name = if settings.strip_path { file.rsplit(['/', '\\']).next().unwrap_or(file) } else { file };
        let mut first = None;
        for folder in [model.folder.as_str(), beside] {
            let path = within(folder, &settings.folder).and_then(|folder| within(&folder, name));
            match path.and_then(|path| self.loader.load(&path)) {
                Ok(bytes) if bytes.len() > MOST_BYTES => {
                    return Err(format!("{file}: it has more than {MOST_BYTES} bytes"));
                }
                Ok(bytes) => return files::read(name, &bytes).map_err(|why| format!("{file}: {why}")),
                Err(why) => first = first.or(Some(why)),
            }
        }
        Err(format!("{file}: {}", first.unwrap_or_default()))
    }
}
