//! Links that touch each other.

use super::SceneReader;
use super::names::matches;
use solaris_model::Link;
use solaris_model::text::{ExpectedKind, Fields, Node};
use solaris_modes::Collisions;

const FIELDS: [&str; 3] = ["friction", "between", "except"];
const PAIR: &str = "(\"left_thigh\", \"right_*\")";

/// Two patterns of names.
type Patterns<'n> = [&'n str; 2];

impl SceneReader<'_> {
    /// Lets links of the simulation touch each other: `Collisions(friction: 0.5)`.
    pub(super) fn collisions(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("collisions") else { return };
        let Some(fields) = self.reader.fields(node, &["Collisions"], &FIELDS) else { return };
        let friction = self.reader.required_number(&fields, "friction", "0.5");
        let between = fields.get("between").map(|node| (node, self.pairs(node, "between")));
        let except = fields.get("except").map(|node| self.pairs(node, "except"));
        let (Some(friction), Some(figure)) = (friction, self.figure().cloned()) else { return };
        let Some(mut collisions) = self.setup(&node.place(), Collisions::of(&figure, friction)) else {
            return;
        };
        let name = |link: usize| figure.links()[link].name();
        let is_of = |patterns: &[Patterns<'_>], pair: &[usize; 2]| {
            let [a, b] = pair.map(name);
            patterns.iter().any(|[x, y]| matches(x, a) && matches(y, b) || matches(x, b) && matches(y, a))
        };
        if let Some((node, patterns)) = between {
            let Some(patterns) = patterns else { return };
            // What is named touches though it is joined, or overlaps where everything is at zero.
            if patterns.iter().flatten().any(|pattern| pattern.contains('*')) {
                collisions.pairs.retain(|pair| is_of(&patterns, pair));
            } else {
                let index = |name: &&str| figure.link_index(name);
                let named = patterns.iter().filter_map(|[a, b]| Some([index(a)?, index(b)?]));
                collisions.pairs = named.collect();
            }
            if collisions.pairs.is_empty() {
                let message = "no two links that can come to each other are called like this; links can that have a shape and are not \
                               joined to each other";
                self.reader.fault(node.place(), message);
                return;
            }
        }
        if let Some(patterns) = except {
            let Some(patterns) = patterns else { return };
            collisions.pairs.retain(|pair| !is_of(&patterns, pair));
        }
        if collisions.pairs.is_empty() {
            let message = format!(
                "no two links of figure '{}' can touch each other: those can that have a shape (a box, capsule, cylinder, ellipsoid or \
                 sphere), are not joined to each other, and do not overlap where everything is at zero",
                figure.name()
            );
            self.reader.fault(node.place(), message);
            return;
        }
        if let Some(simulation) = &mut self.simulation {
            let result = simulation.set_collisions(collisions);
            self.setup(&node.place(), result);
        }
    }

    /// `[("left_thigh", "right_*"), …]`: each name that of a link, or a pattern that some links are called like.
    fn pairs<'n>(&mut self, node: &'n Node<'_>, what: &str) -> Option<Vec<Patterns<'n>>> {
        let items = self.reader.items(node, what, &format!("[{PAIR}, …]"))?;
        let found: Vec<Option<Patterns<'n>>> = items.iter().map(|item| self.pair(item)).collect();
        found.into_iter().collect()
    }

    fn pair<'n>(&mut self, node: &'n Node<'_>) -> Option<Patterns<'n>> {
        let Some([first, second]) = node.items() else {
            let message = format!("a pair is two names of links {PAIR}, not {}", node.describe());
            self.reader.fault(node.place(), message);
            return None;
        };
        let (first, second) = (self.pattern(first), self.pattern(second));
        Some([first?, second?])
    }

    fn pattern<'n>(&mut self, node: &'n Node<'_>) -> Option<&'n str> {
        let name = self.reader.name(node, "the name of a link")?;
        if !name.contains('*') {
            return self.link(node, name, None).map(|_| name);
        }
        let figure = self.simulation.as_ref()?.figure();
        self.reader.expect(&node.span, ExpectedKind::Name, "link", figure.links().iter().map(Link::name));
        if figure.links().iter().any(|link| matches(name, link.name())) {
            return Some(name);
        }
        let message = format!("no link of figure '{}' is called like '{name}'", figure.name());
        self.reader.unknown_name(node.span.clone(), &message, name, figure.links().iter().map(Link::name));
        None
    }
}
