//! `<default>`: attributes that elements have where they say nothing else.

use crate::xml::{Node, Reader, elements, tag, value_span};
use std::collections::HashMap;

/// The attributes of which one gives an orientation.
pub(super) const SPECIFIERS: [&str; 5] = ["quat", "axisangle", "euler", "xyaxes", "zaxis"];

/// The kinds of elements that have defaults here.
pub(super) const KINDS: [&str; 17] = [
    "joint",
    "geom",
    "site",
    "mesh",
    "tendon",
    "general",
    "motor",
    "position",
    "velocity",
    "intvelocity",
    "damper",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
    "pid",
    "equality",
];

/// The defaults of one kind: of each attribute, the element that says it.
type Set<'a> = HashMap<&'a str, Node<'a>>;

/// One class, with what it inherits.
#[derive(Clone, Default)]
struct Class<'a> {
    sets: [Set<'a>; KINDS.len()],
}

/// All classes of a file.
pub(super) struct Defaults<'a> {
    classes: Vec<Class<'a>>,
    by_name: HashMap<String, usize>,
}

/// An element with its defaults.
pub(super) struct Resolved<'a> {
    /// The element itself.
    pub(super) node: Node<'a>,
    set: Option<&'a Set<'a>>,
}

impl<'a> Resolved<'a> {
    /// An element that has no defaults.
    pub(super) fn plain(node: Node<'a>) -> Self {
        Self { node, set: None }
    }

    /// The element that says an attribute: this one, or one of its defaults.
    pub(super) fn said(&self, attribute: &str) -> Option<Node<'a>> {
        if self.node.has_attribute(attribute) {
            return Some(self.node);
        }
        // One way of giving an orientation replaces all others.
        let turned =
            SPECIFIERS.contains(&attribute) && SPECIFIERS.iter().any(|way| self.node.has_attribute(*way));
        if turned { None } else { self.set?.get(attribute).copied() }
    }

    /// The value of an attribute.
    pub(super) fn text(&self, attribute: &str) -> Option<&'a str> {
        self.said(attribute)?.attribute(attribute)
    }

    /// The number of an attribute.
    pub(super) fn number(&self, reader: &mut Reader, attribute: &str) -> Option<f64> {
        reader.number(self.said(attribute)?, attribute)
    }

    /// The numbers of an attribute.
    pub(super) fn numbers<const N: usize>(&self, reader: &mut Reader, attribute: &str) -> Option<[f64; N]> {
        reader.numbers(self.said(attribute)?, attribute)
    }

    /// The numbers of an attribute, as many as `counts` allows.
    pub(super) fn list(
        &self,
        reader: &mut Reader,
        attribute: &str,
        counts: std::ops::RangeInclusive<usize>,
    ) -> Option<Vec<f64>> {
        reader.number_list(self.said(attribute)?, attribute, counts)
    }

    /// Where an attribute stands, or else the element.
    pub(super) fn span(&self, attribute: &str) -> std::ops::Range<usize> {
        self.said(attribute).map_or_else(|| tag(self.node), |node| value_span(node, attribute))
    }
}

impl<'a> Defaults<'a> {
    pub(super) fn read(reader: &mut Reader, root: Node<'a>) -> Self {
        let mut defaults =
            Self { classes: vec![Class::default()], by_name: HashMap::from([("main".to_owned(), 0)]) };
        let tops = elements(root).filter(|node| node.tag_name().name() == "default");
        for top in tops {
            if top.attribute("class").is_some_and(|name| name != "main") {
                reader.fault(value_span(top, "class"), "the outermost <default> is always the class 'main'");
            }
            defaults.add(reader, top, 0);
            // Classes inherit what their parent says, also after them: parents first.
            let mut open = vec![(top, 0)];
            while let Some((node, parent)) = open.pop() {
                for child in elements(node).filter(|child| child.tag_name().name() == "default") {
                    let class = defaults.classes.len();
                    defaults.classes.push(defaults.classes[parent].clone());
                    let name = reader.need(child, "class").unwrap_or_default();
                    if defaults.by_name.insert(name.to_owned(), class).is_some() {
                        reader.fault(
                            value_span(child, "class"),
                            format!("the class '{name}' is there already"),
                        );
                    }
                    defaults.add(reader, child, class);
                    open.push((child, class));
                }
            }
        }
        defaults
    }

    /// Adds what a `<default>` says to a class that has what it inherits.
    fn add(&mut self, reader: &mut Reader, node: Node<'a>, class: usize) {
        reader.check_attributes(node, &["class"]);
        for child in elements(node) {
            let name = child.tag_name().name();
            let Some(kind) = KINDS.iter().position(|kind| *kind == name) else {
                if name != "default" {
                    reader.aside(format!("<{name}> of <default>"), tag(child));
                }
                continue;
            };
            let set = &mut self.classes[class].sets[kind];
            if child.attributes().any(|attribute| SPECIFIERS.contains(&attribute.name())) {
                set.retain(|attribute, _| !SPECIFIERS.contains(attribute));
            }
            for attribute in child.attributes() {
                // No element has more; a file cannot make every class copy thousands of names.
                if set.len() < 100 {
                    set.insert(attribute.name(), child);
                }
            }
        }
    }

    /// The class called `name`, which `node` names in `attribute`; an unknown one is a fault.
    pub(super) fn class(&self, reader: &mut Reader, node: Node, attribute: &str) -> Option<usize> {
        let name = node.attribute(attribute)?;
        let class = self.by_name.get(name).copied();
        if class.is_none() {
            let hint = reader.hint(name, self.by_name.keys().map(String::as_str));
            reader.fault(value_span(node, attribute), format!("there is no default class '{name}'{hint}"));
        }
        class
    }

    /// An element with the defaults of its class, or else of the class of the body around it.
    pub(super) fn resolve<'d>(&'d self, reader: &mut Reader, node: Node<'d>, around: usize) -> Resolved<'d> {
        self.resolve_as(reader, node, around, node.tag_name().name())
    }

    /// An element with what its class says of elements called `kind`.
    pub(super) fn resolve_as<'d>(
        &'d self,
        reader: &mut Reader,
        node: Node<'d>,
        around: usize,
        kind: &str,
    ) -> Resolved<'d> {
        let class = self.class(reader, node, "class").unwrap_or(around);
        let kind = KINDS.iter().position(|known| *known == kind);
        Resolved { node, set: kind.map(|kind| &self.classes[class].sets[kind]) }
    }
}
