//! The figure of a scene: a person, a file, or written out.

use super::SceneReader;
use solaris_model::text::{Fields, Node, read_node};
use solaris_model::{Base, Figure};

const EXAMPLE: &str = "{\"ann\": Human(height: 1.75, mass: 73.0)}";

impl SceneReader<'_> {
    /// The one figure, and what the scene calls it.
    pub(super) fn figures(&mut self, fields: &Fields<'_, '_>) -> Option<(String, Figure)> {
        let node = self.reader.required(fields, "figures", EXAMPLE)?;
        let entries = self.reader.entries(node, "figures", EXAMPLE)?;
        if entries.is_empty() {
            self.reader.fault(node.place(), format!("there is no figure; write {EXAMPLE}"));
        }
        for (key, _) in entries.iter().skip(1) {
            self.reader.fault(key.span.clone(), "a scene has one figure for now; remove the others");
        }
        let mut found = None;
        for (key, value) in entries {
            let name = self.reader.name(key, "the name of a figure");
            let figure = self.one_figure(value);
            if found.is_none() {
                found = name.map(str::to_owned).zip(figure);
            }
        }
        found
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
