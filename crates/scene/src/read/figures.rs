//! The figures of a scene: people, files, or written out.

use super::SceneReader;
use nalgebra::{Unit, UnitQuaternion, Vector3};
use solaris_model::text::{Fields, Node, ReadSpatial as _, read_node};
use solaris_model::{Base, Figure, Placement, did_you_mean};
use std::collections::HashMap;

const EXAMPLE: &str = "{\"ann\": Human(height: 1.75, mass: 73.0)}";

const PLACES: &str = "{\"bob\": (at: (0, 0, 1.5), facing: deg(180))}";

/// Where each figure stands, by its name, and the place of that in the text.
type Places<'n> = HashMap<&'n str, Placement>;

impl SceneReader<'_> {
    /// The figure, or all figures as one, and what the scene calls it; under this gravity, where the scene says one.
    pub(super) fn figures(
        &mut self,
        fields: &Fields<'_, '_>,
        gravity: Option<Vector3<f64>>,
    ) -> Option<(String, Figure)> {
        let node = self.reader.required(fields, "figures", EXAMPLE)?;
        let entries = self.reader.entries(node, "figures", EXAMPLE)?;
        if entries.is_empty() {
            self.reader.fault(node.place(), format!("there is no figure; write {EXAMPLE}"));
        }
        let mut found: Vec<(&str, Figure)> = Vec::new();
        let mut whole = true;
        for (key, value) in entries {
            let name = self.reader.name(key, "the name of a figure");
            let figure = self.one_figure(value);
            if let Some(name) = name.filter(|name| found.iter().any(|(other, _)| other == name)) {
                self.reader.fault(
                    key.span.clone(),
                    format!("two figures are called '{name}'; give each its own name"),
                );
                whole = false;
            } else if let Some(pair) = name.zip(figure) {
                found.push(pair);
            } else {
                whole = false;
            }
        }
        let gravity = gravity.or_else(|| found.iter().find_map(|(_, figure)| figure.gravity().copied()));
        let up = Unit::try_new(-gravity.unwrap_or(super::GRAVITY), 0.0).unwrap_or_else(Vector3::y_axis);
        let names: Vec<&str> = entries
            .iter()
            .filter_map(|(key, _)| match key.value {
                solaris_model::text::Value::Text(ref name) => Some(name.as_ref()),
                _ => None,
            })
            .collect();
        let places = self.places(fields, &names, &up);
        if !whole || found.is_empty() {
            return None;
        }
        let at = |name: &str| places.get(name).copied().unwrap_or_else(Placement::identity);
        if let [(name, figure)] = &found[..] {
            let place = at(name);
            if place != Placement::identity() && fields.get("walk").is_some() {
                let message = "a walk begins at the world's origin; leave its figure out of 'places'";
                self.reader.fault(fields.get("places").map_or(node.place(), Node::place), message);
            }
            let figure = if place == Placement::identity() { figure.clone() } else { figure.placed(&place) };
            return Some(((*name).to_owned(), figure));
        }
        if fields.get("walk").is_some() {
            let message = "a walk is of one figure; walk each in a scene of its own, or leave 'walk' out";
            self.reader.fault(node.place(), message);
        }
        let all: Vec<(&str, &Figure, Placement)> =
            found.iter().map(|(name, figure)| (*name, figure, at(name))).collect();
        let figure = Figure::together(&all)
            .map_err(|error| self.reader.fault(node.place(), error.to_string()))
            .ok()?;
        Some((figure.name().to_owned(), figure))
    }

    /// `{"bob": (at: (0, 0, 1.5), facing: deg(180))}`: an angle about the direction against gravity, to the left.
    fn places<'n>(&mut self, fields: &Fields<'n, '_>, names: &[&str], up: &Unit<Vector3<f64>>) -> Places<'n> {
        let mut places = Places::new();
        let Some(node) = fields.get("places") else { return places };
        for (key, value) in self.reader.entries(node, "places", PLACES).unwrap_or_default() {
            let name = self.reader.name(key, "the name of a figure");
            let Some(place) = self.reader.fields(value, &["Place"], &["at", "facing"]) else { continue };
            let at = place.get("at").map_or(Some(Vector3::zeros()), |node| self.reader.vector(node, "at"));
            let facing = place.get("facing").map_or(Some(0.0), |node| self.reader.angle(node, "facing"));
            let (Some(name), Some(at), Some(facing)) = (name, at, facing) else { continue };
            if !names.contains(&name) {
                let hint = did_you_mean(name, names.iter().copied());
                self.reader.fault(key.span.clone(), format!("there is no figure '{name}'{hint}"));
            }
            let turned = UnitQuaternion::from_axis_angle(up, facing);
            if places.insert(name, Placement::from_parts(at.into(), turned)).is_some() {
                self.reader.fault(key.span.clone(), format!("'{name}' has two places; keep one of them"));
            }
        }
        places
    }

    fn one_figure(&mut self, node: &Node<'_>) -> Option<Figure> {
        if self.reader.kind(node, &["Human", "File", "Figure"])? != "File" {
            return read_node(&mut self.reader, node);
        }
        let (path, base) = match node.tuple() {
            Some([path]) => (path, Base::Fixed),
            Some(_) => {
                let message = "File(\"…\") takes the path of one file, or File(path: \"…\", base: Free)";
                self.reader.fault(node.span.clone(), message);
                return None;
            }
            None => {
                let fields = self.reader.fields(node, &["File"], &["path", "base"])?;
                let path = self.reader.required(&fields, "path", "\"robot.urdf\"");
                let base = match self.reader.choice(&fields, "base", &["Fixed", "Floating", "Free"])? {
                    "Floating" => Base::Floating,
                    "Free" => Base::Free,
                    _ => Base::Fixed,
                };
                (path?, base)
            }
        };
        let name = self.reader.name(path, "the path of a figure")?;
        let loaded = self.loader.figure(name).map_err(|why| format!("'{name}': {why}"));
        let based = loaded.and_then(|figure| figure.on_base(base).map_err(|why| format!("'{name}': {why}")));
        based.map_err(|why| self.reader.fault(path.span.clone(), why)).ok()
    }
}
