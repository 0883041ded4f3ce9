//! The model of the file, and those that it attaches.

use super::assembly::Assembly;
use super::compiler::Compiler;
use super::defaults::Defaults;
use crate::xml::{Node, Reader, elements, elements_called, tag, value_span};
use std::collections::HashMap;

/// A mesh of an `<asset>`.
pub(super) struct Mesh<'a> {
    pub(super) node: Node<'a>,
    /// The folder of the file that names it, from that of the main file.
    pub(super) beside: String,
}

/// A model with what its numbers and names mean.
pub(super) struct Model<'a> {
    pub(super) root: Node<'a>,
    pub(super) compiler: Compiler,
    pub(super) defaults: Defaults<'a>,
    /// The models of its `<asset>`, by their names, as places in the list of all.
    models: HashMap<&'a str, usize>,
    /// The meshes of its `<asset>`, by their names.
    pub(super) meshes: HashMap<&'a str, Mesh<'a>>,
    /// Its folder, from that of the main file.
    pub(super) folder: String,
}

impl<'a> Model<'a> {
    /// The main model, which is the first, and all that are named by others.
    pub(super) fn all(reader: &mut Reader, root: Node<'a>, assembly: &Assembly) -> Vec<Self> {
        let mut models: Vec<Self> = Vec::new();
        // Each with the model that names it, and how.
        let mut open = vec![(root, None)];
        while let Some((root, named)) = open.pop() {
            let index = models.len();
            let compiler = Compiler::read(reader, root);
            let defaults = Defaults::read(reader, root);
            let folder = assembly.folder(root.range().start).to_owned();
            let mut meshes = HashMap::new();
            for asset in elements_called(root, "asset").flat_map(elements) {
                match asset.tag_name().name() {
                    "model" => {
                        if let Some(child) = elements_called(asset, "mujoco").next() {
                            let name = asset.attribute("name").or_else(|| child.attribute("model"));
                            open.push((child, Some((index, name.unwrap_or_default(), asset))));
                        }
                    }
                    "mesh" => {
                        let file = || asset.attribute("file").map(stem);
                        if let Some(name) = asset.attribute("name").or_else(file) {
                            let beside = || assembly.folder(asset.range().start).to_owned();
                            meshes.entry(name).or_insert_with(|| Mesh { node: asset, beside: beside() });
                        }
                    }
                    _ => {}
                }
            }
            models.push(Self { root, compiler, defaults, models: HashMap::new(), meshes, folder });
            if let Some((parent, name, asset)) = named
                && models[parent].models.insert(name, index).is_some()
            {
                reader.fault(tag(asset), format!("model '{name}' is there already; names must be unique"));
            }
        }
        models
    }

    /// The model that an `<attach>` names; an unknown one is a fault.
    pub(super) fn attached(&self, reader: &mut Reader, node: Node, own: usize) -> Option<usize> {
        let Some(name) = node.attribute("model") else { return Some(own) };
        let found = self.models.get(name).copied();
        if found.is_none() {
            let hint = reader.hint(name, self.models.keys().copied());
            let message = format!("there is no <model> '{name}' in the <asset>{hint}");
            reader.fault(value_span(node, "model"), message);
        }
        found
    }
}

/// The name of a file without its folders and extension.
fn stem(file: &str) -> &str {
    let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}
