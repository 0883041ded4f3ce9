//! From the tree of a text to a figure, with every fault on the way.

mod body;
mod exact;
mod fields;
mod joint;
mod link;
mod locate;
mod placement;
mod values;

use super::node::{Content, Node};
use super::parse::parse;
use crate::builder::FigureBuilder;
use crate::fault::Part;
use crate::figure::Figure;
use crate::source::TextError;
use exact::Exact;
use fields::Fields;
use locate::Places;
use std::ops::Range;

/// The version of the grammar.
pub(super) const VERSION: u32 = 1;

/// What is gathered while the tree is read.
#[derive(Default)]
pub(super) struct Reader {
    faults: Vec<(Range<usize>, String)>,
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
    masses: bool,
}

/// The figure that `text` describes.
pub(super) fn read(text: &str) -> Result<Figure, TextError> {
    let tree = parse(text).map_err(|(span, message)| TextError::one(text, span, message))?;
    let mut reader = Reader::default();
    match reader.figure(&tree) {
        Some(figure) if reader.faults.is_empty() => Ok(figure),
        _ => {
            // Most texts are good, and only faults need places.
            let mut again = Reader { places: Places::kept(), ..Reader::default() };
            again.figure(&tree);
            Err(TextError::new(text, again.faults))
        }
    }
}

const FIELDS: [&str; 7] = ["version", "name", "stature", "gravity", "links", "angles", "body"];

impl Reader {
    fn fault(&mut self, span: Range<usize>, message: impl Into<String>) {
        self.faults.push((span, message.into()));
    }

    fn figure(&mut self, tree: &Node<'_>) -> Option<Figure> {
        let fields = self.fields(tree, &["Figure"], &[])?;
        // A later version may mean anything by the rest.
        if self.is_later(&fields) {
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

    /// Whether the text is of a later version; one that is none is a fault.
    fn is_later(&mut self, fields: &Fields<'_, '_>) -> bool {
        let known = f64::from(VERSION);
        let Some(node) = fields.get("version") else {
            self.fault(fields.at.clone(), format!("the figure has no version; add version: {VERSION}"));
            return false;
        };
        let Some(version) = self.number(node, "the version") else { return false };
        if version > known {
            let message = format!(
                "this figure is written in version {version} of the grammar, and only version {VERSION} is known here; \
                 read it with a later Solaris"
            );
            self.fault(node.span.clone(), message);
        } else if version < known {
            let message = format!("there is no version {version}; the only one is {VERSION}");
            self.fault(node.span.clone(), message);
        }
        version > known
    }

    fn links(&mut self, node: &Node<'_>, mut builder: FigureBuilder) -> FigureBuilder {
        self.places.put_field(Part::Figure, "", "links", node.place());
        let Some(items) = node.items() else {
            self.lost.links = true;
            self.fault(node.place(), format!("links must be a list [Link(…), …], not {}", node.describe()));
            return builder;
        };
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
        let Some(Content::Map(entries)) = node.group().map(|group| &group.content) else {
            let message =
                format!("angles must be a map {{\"knee.flexion\": \"-knee.rx\"}}, not {}", node.describe());
            self.fault(node.place(), message);
            return builder;
        };
        for (key, value) in entries {
            let name = self.name(key, "the name of an angle");
            let dof = self.name(value, "the degree of freedom of an angle");
            let (Some(name), Some(dof)) = (name, dof) else { continue };
            self.places.put_name(Part::Angle, name, key.span.clone());
            // Where it is unknown, the degree of freedom is to be looked at.
            self.places.put_field(Part::Angle, name, "dof", value.span.clone());
            let negative = dof.starts_with('-');
            builder = builder.angle(name, dof.strip_prefix(['-', '+']).unwrap_or(dof).trim_start(), negative);
        }
        builder
    }
}
