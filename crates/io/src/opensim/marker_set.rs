//! Markers of a model, or of a file of their own.

use super::element::{child_flag, child_vector, child_words, members, name_of, objects, words_at};
use super::frames::Frames;
use super::layout::bodies;
use super::{DEEPEST, component};
use crate::xml::{self, Node, Reader, element, tag};
use solaris_model::{Figure, Finding, Marker, Placement, TextError, nearest};

/// Markers, and what there is to say about them.
#[derive(Clone, Debug, Default)]
pub struct MarkerSet {
    /// The markers, on the links of the figure.
    pub markers: Vec<Marker>,
    /// What was left out or looks wrong.
    pub findings: Vec<Finding>,
}

impl MarkerSet {
    /// These markers with those of another set: one of the same name takes the place of the first, others come after.
    #[must_use]
    pub fn with(mut self, other: Self) -> Self {
        for marker in other.markers {
            match self.markers.iter_mut().find(|known| known.name == marker.name) {
                Some(known) => *known = marker,
                None => self.markers.push(marker),
            }
        }
        self.findings.extend(other.findings);
        self
    }
}

/// Reads the markers of an OpenSim model, or of a file that holds a `MarkerSet` alone, onto the `figure` that
/// [`super::read`] made of the model.
///
/// # Errors
///
/// [`TextError`] with every fault and its place: text that is no XML or holds neither a model nor markers, markers without a
/// name, on bodies that the figure does not have, or at places that are no three numbers.
///
/// # Examples
///
/// ```
/// use solaris_model::{FigureBuilder, Joint, LinkSpec};
/// let figure = FigureBuilder::new("f").link(LinkSpec::root("pelvis", Joint::new("ground").rx()).mass(1.0)).build()?;
/// let text = r#"<OpenSimDocument Version="30000"><MarkerSet><objects><Marker name="R.ASIS">
///   <body>pelvis</body><location>0.02 0.03 0.13</location><fixed>true</fixed>
/// </Marker></objects></MarkerSet></OpenSimDocument>"#;
/// let set = solaris_io::opensim::markers(text, &figure)?;
/// assert_eq!((set.markers[0].link, set.markers[0].position.z, set.markers[0].is_fixed), (0, 0.13, true));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn markers(text: &str, figure: &Figure) -> Result<MarkerSet, TextError> {
    let strict = xml::mended(text);
    let document = xml::parse(&strict, DEEPEST)?;
    let root = document.root_element();
    let mut reader = Reader::new(text);
    let is_set = root.tag_name().name() == "MarkerSet" || element(root, "MarkerSet").is_some();
    let holder = if root.tag_name().name() == "MarkerSet" { None } else { Some(root) };
    let (nodes, mut frames, model) = match (element(root, "Model"), is_set) {
        (Some(model), _) => {
            let of = bodies(&mut reader, members(model, "BodySet", |tag| tag == "Body"));
            let nodes: Vec<Node> = of.iter().map(|(_, node)| *node).collect();
            let names: Vec<&str> = of.iter().map(|(name, _)| *name).collect();
            let markers = members(model, "MarkerSet", |tag| tag == "Marker");
            (markers, Some((Frames::of(model, &nodes), names)), model)
        }
        (None, true) => {
            let list = holder.map_or_else(|| set_of(root), |holder| objects(holder, "MarkerSet"));
            (list, None, root)
        }
        (None, false) => {
            let message = format!("<{}> holds neither a <Model> nor a <MarkerSet>", root.tag_name().name());
            return Err(TextError::one(text, tag(root), message));
        }
    };
    let mut markers: Vec<Marker> = Vec::new();
    for node in nodes.into_iter().filter(|node| node.tag_name().name() == "Marker") {
        let Some(marker) = marker(&mut reader, node, figure, frames.as_mut(), model) else { continue };
        if markers.iter().any(|known| known.name == marker.name) {
            let message = "another marker has this name; that one counts".to_owned();
            reader.suspect(tag(node), format!("marker '{}'", marker.name), message);
        } else {
            markers.push(marker);
        }
    }
    reader.error().map_or(Ok(()), Err)?;
    Ok(MarkerSet { markers, findings: reader.findings() })
}

/// The members of a set that is the document.
fn set_of(set: Node<'_>) -> Vec<Node<'_>> {
    xml::elements_called(set, "objects").flat_map(xml::elements).collect()
}

/// A marker; nothing for one that is at fault or stands on ground.
fn marker(
    reader: &mut Reader,
    node: Node,
    figure: &Figure,
    frames: Option<&mut (Frames, Vec<&str>)>,
    model: Node,
) -> Option<Marker> {
    const SOCKET: &str = "socket_parent_frame";
    let name = name_of(reader, node)?.to_owned();
    let owner = format!("marker '{name}'");
    let (body, within, at) = match (child_words(node, "body"), frames) {
        (Some(body), _) => (body, Placement::identity(), "body"),
        (None, Some((frames, bodies))) => {
            let path = component::path_of(node, model);
            let anchor = frames.socket(reader, node, &path, SOCKET, &owner)?;
            (anchor.body.map_or("ground", |body| bodies[body]), anchor.within, SOCKET)
        }
        (None, None) => {
            let Some(path) = child_words(node, SOCKET) else {
                reader.fault(tag(node), format!("{owner} has neither a <body> nor a <{SOCKET}>"));
                return None;
            };
            (path.rsplit('/').next().unwrap_or(path), Placement::identity(), SOCKET)
        }
    };
    let position = child_vector(reader, node, "location");
    let is_fixed = child_flag(reader, node, "fixed", false);
    if body == "ground" {
        reader.note(
            tag(node),
            owner,
            "it stands on ground, so it tells nothing of the figure; it is left out",
        );
        return None;
    }
    let Some((link, in_link)) = figure.locate(body) else {
        let span = element(node, at).map_or_else(|| tag(node), words_at);
        let frames =
            figure.links().iter().flat_map(|link| link.frames().iter().map(|frame| frame.name.as_str()));
        let names = figure.links().iter().map(solaris_model::Link::name).chain(frames);
        let near = nearest(body, names).map_or_else(String::new, |near| format!("; did you mean '{near}'?"));
        reader.fault(
            span,
            format!("{owner} sits on '{}', which is no body of the model{near}", xml::shown(body)),
        );
        return None;
    };
    let position = (in_link * within).transform_point(&position.into()).coords;
    Some(Marker { name, link, position, is_fixed })
}
