//! Contents of a body, through all that groups and repeats: `<frame>`, `<replicate>`, `<attach>`.

use crate::mjcf::defaults::{Resolved, SPECIFIERS};
use crate::mjcf::model::Model;
use crate::mjcf::orientation::{placement, turn};
use crate::xml::{Node, Reader, elements, elements_called, tag, value_span};
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::rc::Rc;

/// The most elements that `<replicate>` and `<attach>` make in a model.
const MOST_MADE: usize = 300_000;
/// How deep `<replicate>` and `<attach>` may be nested.
const DEEPEST: usize = 100;

/// What stands around an element.
#[derive(Clone)]
pub(super) struct Around {
    /// The frame, in that of the body.
    pub(super) frame: Placement,
    /// The class of defaults.
    pub(super) class: usize,
    /// The model that the element is of.
    pub(super) model: usize,
    /// What is put before and behind its name.
    affix: Option<Rc<(String, String)>>,
    /// How many of `<replicate>` and `<attach>` it is in.
    depth: usize,
}

impl Around {
    /// Of the elements of the world.
    pub(super) fn world() -> Self {
        Self { frame: Placement::identity(), class: 0, model: 0, affix: None, depth: 0 }
    }

    /// Of the elements of a body: its class (but for its own `childclass`), model and name stay, frames begin anew.
    pub(super) fn body(around: &Self) -> Self {
        Self { frame: Placement::identity(), ..around.clone() }
    }

    /// The same with another class of defaults.
    pub(super) fn of_class(self, class: usize) -> Self {
        Self { class, ..self }
    }

    /// The name of an element, if it has one.
    pub(super) fn name(&self, node: Node) -> Option<String> {
        let name = node.attribute("name").filter(|name| !name.trim().is_empty())?;
        Some(match &self.affix {
            None => name.to_owned(),
            Some(affix) => format!("{}{name}{}", affix.0, affix.1),
        })
    }

    fn renamed(&self, prefix: &str, suffix: &str) -> Rc<(String, String)> {
        let (before, after) = self.affix.as_deref().map_or(("", ""), |affix| (&affix.0, &affix.1));
        Rc::new((format!("{before}{prefix}"), format!("{suffix}{after}")))
    }
}

/// An element and what stands around it.
pub(super) type Item<'a> = (Node<'a>, Around);

/// The elements of a body, each in the order of the file.
#[derive(Default)]
pub(super) struct Contents<'a> {
    pub(super) joints: Vec<Item<'a>>,
    pub(super) geoms: Vec<Item<'a>>,
    pub(super) sites: Vec<Item<'a>>,
    pub(super) inertials: Vec<Item<'a>>,
    pub(super) bodies: Vec<Item<'a>>,
}

/// What is open while the contents are gone through.
enum Open<'a> {
    /// The rest of some elements.
    Elements(Box<dyn Iterator<Item = Node<'a>> + 'a>, Around),
    /// The rest of the copies of a `<replicate>`.
    Copies(Copies<'a>),
}

struct Copies<'a> {
    node: Node<'a>,
    around: Around,
    count: usize,
    next: usize,
    /// Of the next copy, in the frame around all.
    position: Vector3<f64>,
    offset: Vector3<f64>,
    euler: [f64; 3],
    separator: &'a str,
}

/// Goes through bodies; counts what is made beyond the text.
pub(super) struct Walk<'m, 'a> {
    pub(super) models: &'m [Model<'a>],
    made: usize,
}

impl<'m, 'a> Walk<'m, 'a> {
    pub(super) fn new(models: &'m [Model<'a>]) -> Self {
        Self { models, made: 0 }
    }

    /// The contents of a body (or the world); `around` has the body's own class and frame.
    pub(super) fn contents(&mut self, reader: &mut Reader, body: Node<'a>, around: Around) -> Contents<'a> {
        let mut contents = Contents::default();
        // Innermost last.
        let mut open = vec![Open::Elements(Box::new(elements(body)), around)];
        while let Some(last) = open.last_mut() {
            let (node, around) = match last {
                Open::Copies(copies) => {
                    let Some(around) = copies.next(self.models) else {
                        open.pop();
                        continue;
                    };
                    let node = copies.node;
                    if !self.make(reader, node) {
                        return contents;
                    }
                    open.push(Open::Elements(Box::new(elements(node)), around));
                    continue;
                }
                Open::Elements(rest, around) => {
                    let Some(node) = rest.next() else {
                        open.pop();
                        continue;
                    };
                    (node, around.clone())
                }
            };
            if around.affix.is_some() && !self.make(reader, node) {
                return contents;
            }
            let item = (node, around);
            match node.tag_name().name() {
                "joint" | "freejoint" => contents.joints.push(item),
                "geom" => contents.geoms.push(item),
                "site" => contents.sites.push(item),
                "inertial" => contents.inertials.push(item),
                "body" => contents.bodies.push(item),
                "replicate" | "attach" if item.1.depth == DEEPEST => {
                    reader.fault(
                        tag(node),
                        format!("<replicate> and <attach> are nested more than {DEEPEST} deep"),
                    );
                }
                "frame" => open.push(self.frame(reader, item)),
                "replicate" => open.extend(self.replicate(reader, item).map(Open::Copies)),
                "attach" => open.extend(self.attach(reader, item)),
                "composite" => {
                    let advice = "<composite>: the bodies that it makes are not made here (MuJoCo 4 has dropped it, too): write them out";
                    reader.fault(tag(node), advice);
                }
                "flexcomp" => {
                    let advice = "<flexcomp>: a soft body is a grid of many small ones with elastic forces between them; figures have rigid links: leave it out, or put a rigid <body> in its place";
                    reader.fault(tag(node), advice);
                }
                "plugin" => {
                    let name = node.attribute("plugin").unwrap_or("plugin");
                    reader.lacks(
                        "plugins",
                        "what they do to their bodies is not in the figure",
                        tag(node),
                        name,
                    );
                }
                "camera" | "light" => reader.aside(format!("<{}>", node.tag_name().name()), tag(node)),
                _ => reader.unread_element(node),
            }
        }
        contents
    }

    /// Whether one more element may be made.
    fn make(&mut self, reader: &mut Reader, node: Node) -> bool {
        self.made += 1;
        if self.made == MOST_MADE {
            let what =
                format!("<replicate> and <attach> make more than {MOST_MADE} elements; make fewer copies");
            let maker =
                node.ancestors().find(|node| matches!(node.tag_name().name(), "replicate" | "attach"));
            reader.fault(tag(maker.unwrap_or(node)), what);
        }
        self.made < MOST_MADE
    }

    fn frame(&self, reader: &mut Reader, (node, around): Item<'a>) -> Open<'a> {
        let model = &self.models[around.model];
        let mut known = vec!["name", "pos", "childclass"];
        known.extend(SPECIFIERS);
        reader.check_attributes(node, &known);
        let frame = around.frame * placement(reader, &Resolved::plain(node), &model.compiler);
        let class = model.defaults.class(reader, node, "childclass").unwrap_or(around.class);
        Open::Elements(Box::new(elements(node)), Around { frame, class, ..around })
    }

    fn replicate(&self, reader: &mut Reader, (node, around): Item<'a>) -> Option<Copies<'a>> {
        reader.check_attributes(node, &["count", "sep", "offset", "euler", "childclass"]);
        for joint in elements(node).filter(|node| matches!(node.tag_name().name(), "joint" | "freejoint")) {
            reader.fault(
                tag(joint),
                "a <replicate> repeats no joints of the body that it stands in; put them into a <body>",
            );
        }
        reader.need(node, "count")?;
        let count = reader.number(node, "count")?;
        if !(count >= 1.0 && count.fract() == 0.0) {
            let message = format!("'count' is {count}; it must be a whole number, one or more");
            reader.fault(value_span(node, "count"), message);
            return None;
        }
        if count > MOST_MADE as f64 {
            let message =
                format!("<replicate> asks for {count} copies; at most {MOST_MADE} elements are made");
            reader.fault(value_span(node, "count"), message);
            return None;
        }
        let class =
            self.models[around.model].defaults.class(reader, node, "childclass").unwrap_or(around.class);
        Some(Copies {
            node,
            around: Around { class, ..around },
            count: count as usize,
            next: 0,
            position: Vector3::zeros(),
            offset: reader.numbers(node, "offset").map_or_else(Vector3::zeros, Vector3::from),
            euler: reader.numbers(node, "euler").unwrap_or_default(),
            separator: node.attribute("sep").unwrap_or_default(),
        })
    }

    /// What an `<attach>` brings: a body, what is in a frame, or all that is in the world of a model.
    fn attach(&self, reader: &mut Reader, (node, around): Item<'a>) -> Option<Open<'a>> {
        reader.check_attributes(node, &["model", "body", "frame", "prefix"]);
        let prefix = reader.need(node, "prefix")?;
        let own = around.model;
        let index = self.models[own].attached(reader, node, own)?;
        let root = self.models[index].root;
        let affix = Some(around.renamed(prefix, ""));
        let around = Around { class: 0, model: index, affix, depth: around.depth + 1, ..around };
        let Some((kind, name)) =
            ["body", "frame"].iter().find_map(|kind| Some((*kind, node.attribute(*kind)?)))
        else {
            if index == own {
                let message =
                    "an <attach> without a model attaches a part of this one: 'body' or 'frame' must name it";
                reader.fault(tag(node), message);
                return None;
            }
            let all = elements_called(root, "worldbody").flat_map(elements);
            return Some(Open::Elements(Box::new(all), around));
        };
        let mut parts = elements_called(root, "worldbody").flat_map(|world| world.descendants());
        let named = |part: &Node| part.tag_name().name() == kind && part.attribute("name") == Some(name);
        let Some(part) = parts.find(named) else {
            let of =
                node.attribute("model").map_or_else(String::new, |model| format!(" of the model '{model}'"));
            reader.fault(value_span(node, kind), format!("there is no {kind} '{name}'{of} to attach"));
            return None;
        };
        if index == own && part.range().end > node.range().start {
            let message = format!(
                "{kind} '{name}' does not end before the <attach> that names it; only what is complete can be attached"
            );
            reader.fault(value_span(node, kind), message);
            return None;
        }
        // The class that the part has where it stands.
        let defaults = &self.models[index].defaults;
        let above = part.ancestors().skip(1).find(|above| above.has_attribute("childclass"));
        let class = above.and_then(|above| defaults.class(reader, above, "childclass")).unwrap_or(0);
        Some(Open::Elements(Box::new(std::iter::once(part)), Around { class, ..around }))
    }
}

impl Copies<'_> {
    /// What stands around the next copy.
    fn next(&mut self, models: &[Model]) -> Option<Around> {
        if self.next == self.count {
            return None;
        }
        let compiler = &models[self.around.model].compiler;
        // As in MuJoCo, the angles are multiplied, which with several of them is not the same turn repeated.
        let angles = self.euler.map(|angle| angle * self.next as f64);
        let rotation = turn("euler", &angles, compiler).unwrap_or_else(UnitQuaternion::identity);
        let here = Placement::from_parts(self.position.into(), rotation);
        self.position += rotation * self.offset;
        let digits = self.count.to_string().len();
        let suffix = format!("{}{:0digits$}", self.separator, self.next);
        self.next += 1;
        let affix = Some(self.around.renamed("", &suffix));
        let depth = self.around.depth + 1;
        Some(Around { frame: self.around.frame * here, affix, depth, ..self.around.clone() })
    }
}
