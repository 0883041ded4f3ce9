//! Soles as text: where the feet of a figure meet the ground.

use nalgebra::{Point3, Vector3};
use solaris_analysis::ground::Sole;
use solaris_model::text::{Fields, Node, ReadSpatial as _, Reader, parse};
use solaris_model::{Figure, Link, Placement, TextError};

/// The version of the grammar.
const VERSION: u32 = 1;

const EXAMPLE: &str = "[Sole(name: \"right\", foot: \"right_foot\", heel: (-0.05, -0.04, 0), …)]";

/// The soles that `text` gives to `figure`:
///
/// ```
/// use solaris_model::human;
/// let text = r#"
/// Soles(version: 1, soles: [
///     Sole(
///         name: "left",             // what its columns are called
///         foot: "left_foot",        // the link or body that carries heel and ball
///         toes: "left_toes",        // what carries the tip, if it is another; may be left out
///         heel: (-0.03, -0.07, 0),  // hindmost point (m), in the frame of `foot`
///         ball: (0.14, -0.07, 0),   // below the joint of the toes (m), there too
///         tip: (0.06, -0.01, 0),    // foremost point (m), in the frame of `toes`, or of `foot` where there are none
///         width: 0.09,              // breadth (m); without it the centre of pressure is not judged
///     ),
/// ])"#;
/// let ann = human(1.65, 58.0)?;
/// let soles = solaris_scene::read_soles(text, &ann)?;
/// assert_eq!((soles[0].name.as_str(), soles[0].toes), ("left", ann.link_index("left_toes")));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// `foot` and `toes` are links, or frames fixed to them (bodies that cannot move against each other are one link): then the points
/// are given in that frame. Toes that are fixed to the foot's own link are a part of it, and the sole has no toes of its own.
///
/// # Errors
///
/// [`TextError`] with every fault, in the order of the text: what is no RON, what is unknown, missing, of the wrong kind or
/// out of range, names that the figure has not, two soles of one name.
pub fn read_soles(text: &str, figure: &Figure) -> Result<Vec<Sole>, TextError> {
    let tree = parse(text, "list of soles", "Soles(version: 1, soles: […])")?;
    let mut reader = SolesReader { reader: Reader::default(), figure };
    let soles = reader.soles(&tree);
    reader.reader.finish(text)?;
    // Where there are none there is a fault.
    soles.ok_or_else(|| TextError::one(text, tree.span, "these soles cannot be used"))
}

struct SolesReader<'f> {
    reader: Reader,
    figure: &'f Figure,
}

impl SolesReader<'_> {
    fn soles(&mut self, tree: &Node<'_>) -> Option<Vec<Sole>> {
        let fields = self.reader.fields(tree, &["Soles"], &[])?;
        // A later version may mean anything by the rest.
        if self.reader.is_later(&fields, "list of soles", VERSION, true) {
            return None;
        }
        self.reader.only_known(&fields, &["version", "soles"]);
        let node = self.reader.required(&fields, "soles", EXAMPLE)?;
        let items = self.reader.items(node, "soles", EXAMPLE)?;
        if items.is_empty() {
            self.reader.fault(node.span.clone(), format!("there are no soles; give one at least: {EXAMPLE}"));
        }
        let mut names: Vec<&str> = Vec::new();
        // All of them are read, for their faults, before any is missed.
        let soles: Vec<Option<Sole>> = items.iter().map(|item| self.sole(item, &mut names)).collect();
        soles.into_iter().collect()
    }

    fn sole<'n>(&mut self, node: &'n Node<'_>, names: &mut Vec<&'n str>) -> Option<Sole> {
        let known = ["name", "foot", "toes", "heel", "ball", "tip", "width"];
        let fields = self.reader.fields(node, &["Sole"], &known)?;
        let name = self.reader.required(&fields, "name", "\"right\"");
        let name = name.and_then(|node| self.name(node, names));
        let foot = self.reader.required(&fields, "foot", "\"right_foot\"");
        let foot = foot.and_then(|node| self.place(node, "foot"));
        let toes = match fields.get("toes") {
            Some(node) => self.place(node, "toes").map(Some),
            None => Some(None),
        };
        let heel = self.point(&fields, "heel", "(-0.05, -0.04, 0)");
        let ball = self.point(&fields, "ball", "(0.13, -0.04, 0)");
        let tip = self.point(&fields, "tip", "(0.2, -0.04, 0)");
        let width = match fields.get("width") {
            Some(node) => self.width(node).map(Some),
            None => Some(None),
        };
        let ((link, within), toes) = (foot?, toes?);
        let (beyond, at_tip) = match toes {
            Some((other, at)) => ((other != link).then_some(other), at),
            None => (None, within),
        };
        let carried = |point: Vector3<f64>, within: &Placement| (within * Point3::from(point)).coords;
        Some(Sole {
            name: name?.to_owned(),
            foot: link,
            toes: beyond,
            heel: carried(heel?, &within),
            ball: carried(ball?, &within),
            tip: carried(tip?, &at_tip),
            width: width?,
        })
    }

    /// What a sole's columns are called.
    fn name<'n>(&mut self, node: &'n Node<'_>, names: &mut Vec<&'n str>) -> Option<&'n str> {
        let name = self.reader.name(node, "the name of a sole")?;
        if name.contains(char::is_whitespace) {
            let message = format!("a sole's name begins headings of columns, and '{name}' holds a blank");
            self.reader.fault(node.span.clone(), message);
            return None;
        }
        if names.contains(&name) {
            let message = format!("two soles are called '{name}'; give each its own name");
            self.reader.fault(node.span.clone(), message);
            return None;
        }
        names.push(name);
        Some(name)
    }

    /// The link of this name, or that of the frame, and where the frame stands in it.
    fn place(&mut self, node: &Node<'_>, what: &str) -> Option<(usize, Placement)> {
        let name = self.reader.name(node, format_args!("the {what} of a sole"))?;
        let found = self.figure.locate(name);
        if found.is_none() {
            let frames = self.figure.links().iter().flat_map(Link::frames).map(|frame| frame.name.as_str());
            let names = self.figure.links().iter().map(Link::name).chain(frames);
            let message = format!("figure '{}' has no link and no frame '{name}'", self.figure.name());
            self.reader.unknown_name(node.span.clone(), &message, name, names);
        }
        found
    }

    fn point(&mut self, fields: &Fields<'_, '_>, what: &str, example: &str) -> Option<Vector3<f64>> {
        let node = self.reader.required(fields, what, example)?;
        self.reader.vector(node, format_args!("the {what}"))
    }

    fn width(&mut self, node: &Node<'_>) -> Option<f64> {
        let width = self.reader.number(node, "the width")?;
        if width > 0.0 {
            return Some(width);
        }
        let message = format!("the width is {width} m; it must be more than 0, or left out");
        self.reader.fault(node.span.clone(), message);
        None
    }
}
