//! The reader of figures: from the tree of a text, with every fault on the way.

mod body;
mod exact;
mod joint;
mod link;
mod locate;

use super::spatial::ReadSpatial as _;
use crate::builder::FigureBuilder;
use crate::fault::Part;
use crate::figure::Figure;
use exact::Exact;
use locate::Places;
use solaris_text::{Node, Reader, TextError, parse};
use std::ops::{Deref, DerefMut};

/// The version of the grammar.
pub(super) const VERSION: u32 = 1;
/// The most links of a figure: all that is kept of as many takes less than a gigabyte.
const MOST_LINKS: usize = 1 << 17;

/// What is gathered while the tree of a figure is read.
struct FigureReader<'r> {
    reader: &'r mut Reader,
    /// Whether the figure is the whole text, so that it says its version.
    is_whole: bool,
    places: Places,
    /// What stands in the text as it is to be kept.
    exact: Vec<Exact>,
    lost: Lost,
}

/// What could not be read, so that nothing can be said about what needs it.
#[derive(Default)]
#[allow(clippy::struct_excessive_bools, reason = "any of them may be lost")]
struct Lost {
    links: bool,
    parents: bool,
    dofs: bool,
}

impl Deref for FigureReader<'_> {
    type Target = Reader;

    fn deref(&self) -> &Reader {
        self.reader
    }
}

/// A figure is read by the same methods as everything else.
impl DerefMut for FigureReader<'_> {
    fn deref_mut(&mut self) -> &mut Reader {
        self.reader
    }
}

impl<'r> FigureReader<'r> {
    fn new(reader: &'r mut Reader, is_whole: bool, places: Places) -> Self {
        Self { reader, is_whole, places, exact: Vec::new(), lost: Lost::default() }
    }
}

/// The figure that `text` describes.
pub(super) fn read(text: &str) -> Result<Figure, TextError> {
    let tree = parse(text, "figure", "Figure(version: 1, …)")?;
    let mut reader = Reader::default();
    let figure = read_tree(&mut reader, &tree, true);
    reader.finish(text)?;
    figure.ok_or_else(|| TextError::one(text, tree.span, "the figure cannot be used"))
}

/// The figure of `node`, or nothing where that has faults.
pub(super) fn read_tree(reader: &mut Reader, node: &Node<'_>, is_whole: bool) -> Option<Figure> {
    let mut first = Reader::default();
    let found = FigureReader::new(&mut first, is_whole, Places::default()).figure(node);
    if let Some(figure) = found
        && first.count() == 0
    {
        return Some(figure);
    }
    // Most texts are good, and only faults need places.
    let mut again = reader.beside();
    FigureReader::new(&mut again, is_whole, Places::kept()).figure(node);
    reader.append(again);
    None
}

/// The figure of `Human(…)` inside of another text.
pub(super) fn read_human(reader: &mut Reader, node: &Node<'_>) -> Option<Figure> {
    FigureReader::new(reader, false, Places::default()).body(node, None, None)
}

const FIELDS: [&str; 7] = ["version", "name", "stature", "gravity", "links", "angles", "body"];

impl FigureReader<'_> {
    fn figure(&mut self, tree: &Node<'_>) -> Option<Figure> {
        let fields = self.fields(tree, &["Figure"], &[])?;
        // A later version may mean anything by the rest.
        let is_whole = self.is_whole;
        if self.is_later(&fields, "figure", VERSION, is_whole) {
            return None;
        }
        self.lost.links |= self.only_known(&fields, &FIELDS);
        self.places.put(Part::Figure, "", fields.at.clone());
        let name = fields.get("name").and_then(|node| self.text(node, "the name"));
        let stature = fields.get("stature").and_then(|node| {
            self.places.put_field(Part::Figure, "", "stature", node.span.clone());
            self.number(node, "stature")
        });
        let gravity = fields.get("gravity").and_then(|node| self.vector(node, "gravity"));
        if let Some(body) = fields.get("body") {
            for other in ["links", "angles"] {
                if let Some(node) = fields.get(other) {
                    let message = format!("a figure has a body or {other}, not both; remove one of them");
                    self.fault(node.place(), message);
                }
            }
            let figure = self.body(body, name, stature)?;
            return Some(Figure { gravity, ..figure });
        }
        let mut builder = FigureBuilder::new(name.unwrap_or("figure"));
        if let Some(stature) = stature {
            builder = builder.stature(stature);
        }
        if let Some(gravity) = gravity {
            builder = builder.gravity(gravity);
        }
        if let Some(links) = fields.get("links") {
            builder = self.links(links, builder);
        } else {
            self.lost.links = true;
            let message = "the figure has no links; add links: […], or body: Human(height: 1.75, mass: 73.0)";
            self.fault(fields.at.clone(), message);
        }
        if let Some(angles) = fields.get("angles") {
            builder = self.angles(angles, builder);
        }
        let mut figure = builder.build().map_err(|error| self.locate(&error)).ok()?;
        exact::restore(&mut figure, &self.exact);
        Some(figure)
    }

    fn links(&mut self, node: &Node<'_>, mut builder: FigureBuilder) -> FigureBuilder {
        self.places.put_field(Part::Figure, "", "links", node.place());
        let Some(items) = self.items(node, "links", "[Link(…), …]") else {
            self.lost.links = true;
            return builder;
        };
        if let Some(item) = items.get(MOST_LINKS) {
            self.lost.links = true;
            let message = format!("there are more than {MOST_LINKS} links, the most that are read");
            self.fault(item.span.clone(), message);
            return builder;
        }
        for (index, item) in items.iter().enumerate() {
            match self.link(item, index) {
                Some(link) => builder = builder.link(link),
                None => self.lost.links = true,
            }
        }
        builder
    }

    /// `{"knee.flexion": "-knee.rx", …}`
    fn angles(&mut self, node: &Node<'_>, mut builder: FigureBuilder) -> FigureBuilder {
        let entries = self.entries(node, "angles", "{\"knee.flexion\": \"-knee.rx\"}");
        for (key, value) in entries.unwrap_or_default() {
            let name = self.name(key, "the name of an angle");
            let dof = self.name(value, "the degree of freedom of an angle");
            let (Some(name), Some(dof)) = (name, dof) else { continue };
            self.places.put_name(Part::Angle, name, key.span.clone());
            // Where it is unknown, the degree of freedom is to be looked at.
            self.places.put_field(Part::Angle, name, "dof", value.span.clone());
            let negative = dof.starts_with('-');
            builder = builder.angle(name, dof.strip_prefix(['-', '+']).unwrap_or(dof), negative);
        }
        builder
    }
}
