//! Closed loops: points that are held together.

use super::SceneReader;
use solaris_model::text::{Fields, Node};
use solaris_model::{Figure, Tie, TieEnd, TieLaw};
use solaris_modes::{Anchor, Loop, LoopKind};

/// What a file holds together, with the figure that its names are of, where there are several.
pub(super) type Asked = Vec<(String, Tie)>;

const KINDS: [&str; 2] = ["Connect", "Weld"];
const EXAMPLE: &str = "((\"hand\", (0, -0.08, 0)), (\"bar\", (0.2, 0, 0)))";

impl SceneReader<'_> {
    /// Gives the loops of the scene to the simulation: `[Connect(between: …), Weld(between: …)]`.
    pub(super) fn loops(&mut self, fields: &Fields<'_, '_>) {
        let Some(node) = fields.get("loops") else { return };
        for item in self.reader.items(node, "loops", "[Connect(…), …]").unwrap_or_default() {
            let Some(closed) = self.closed(item) else { continue };
            if let Some(simulation) = &mut self.simulation {
                let result = simulation.add_loop(closed);
                self.setup(&item.place(), result);
            }
        }
    }

    /// Keeps what a file holds together for the figure of this name, if the scene asks for it.
    pub(super) fn ask_for_ties(&mut self, figure: &str, node: &Node<'_>) {
        let Some(Some(fields)) = node.tuple().is_none().then(|| self.reader.fields(node, &["File"], &[]))
        else {
            return;
        };
        let Some(asked) = fields.get("loops").filter(|node| self.reader.flag(node) == Some(true)) else {
            return;
        };
        let path = fields.get("path").and_then(|node| self.reader.name(node, "the path of a figure"));
        let Some(path) = path else { return };
        match self.loader.ties(path) {
            Ok(found) => self.ties.extend(found.into_iter().map(|tie| (figure.to_owned(), tie))),
            Err(why) => self.reader.fault(asked.span.clone(), format!("'{path}': {why}")),
        }
    }

    /// Closes the loops of the files; what there is to say of those that stay open.
    pub(super) fn place_ties(&mut self) -> Vec<String> {
        let mut said = Vec::new();
        for (figure, tie) in std::mem::take(&mut self.ties) {
            let Some(simulation) = &mut self.simulation else { continue };
            let closed = loop_of(simulation.figure(), &figure, &tie);
            let closed =
                closed.and_then(|closed| simulation.add_loop(closed).map_err(|error| error.to_string()));
            if let Err(why) = closed {
                said.push(format!("the loop '{}' of '{figure}' is left open: {why}", tie.name));
            }
        }
        said
    }

    /// `Connect(between: …, from: 1.0, until: 3.0)`
    fn closed(&mut self, node: &Node<'_>) -> Option<Loop> {
        let kind = match self.reader.kind(node, &KINDS)? {
            "Weld" => LoopKind::Weld,
            _ => LoopKind::Connect,
        };
        let fields = self.reader.fields(node, &KINDS, &["between", "from", "until"])?;
        let between = self.reader.required(&fields, "between", EXAMPLE)?;
        let between = self.two_anchors(between, "a loop", EXAMPLE)?;
        let from = self.reader.number_or(&fields, "from", 0.0)?;
        let until = match fields.get("until") {
            Some(node) => self.reader.number(node, "until")?,
            None => f64::INFINITY,
        };
        Some(Loop { from, until, ..Loop::new(between, kind) })
    }
}

/// A loop of a file's figure that is called `own`, or why it cannot be closed.
fn loop_of(figure: &Figure, own: &str, tie: &Tie) -> Result<Loop, String> {
    let kind = match &tie.law {
        TieLaw::Points => LoopKind::Connect,
        TieLaw::Axes => LoopKind::Weld,
        TieLaw::Other(what) => return Err(format!("it is {what}, not two points that are held together")),
        _ => return Err("it is of a kind that is not known".to_owned()),
    };
    let anchor = |TieEnd { link, point }: &TieEnd| {
        let Some(name) = link else { return Ok::<_, String>(Anchor { link: None, point: *point }) };
        let found = figure.link_index(name).or_else(|| figure.link_index(&format!("{own}.{name}")));
        let link = found.ok_or_else(|| format!("there is no link '{name}'"))?;
        Ok(Anchor { link: Some(link), point: *point })
    };
    let [first, second] = [0, 1].map(|end| anchor(&tie.between[end]));
    let between = [first?, second?];
    let is_placed = |anchor: &Anchor| {
        anchor.link.is_some_and(|link| figure.links()[link].name().starts_with(&format!("{own}.")))
    };
    if between.iter().any(|anchor| anchor.link.is_none()) && between.iter().any(is_placed) {
        return Err(
            "it holds a link to the world, and figures beside each other have places of their own".to_owned()
        );
    }
    Ok(Loop::new(between, kind))
}
