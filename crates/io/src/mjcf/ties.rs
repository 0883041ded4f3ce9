//! `<equality>`: what holds bodies together.

use super::assembly::Assembly;
use super::defaults::Resolved;
use super::model::Model;
use super::springs::Sprung;
use super::{DEEPEST, assembled};
use crate::loader::{FilesError, Loader};
use crate::xml::{self, Node, Reader, elements, elements_called, tag};
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{
    Figure, JointKind, Placement, Rotation3, TextError, Tie, TieEnd, TieLaw, UnitQuaternion, Vector3,
};
use std::collections::HashMap;

/// What `<connect>` and `<weld>` of an MJCF model hold together in the pose of the file (`qpos0`), in its order; those of models that it
/// attaches, and what is not `active`, are not among them.
///
/// A `<connect>` holds its anchor of one body at the point of the other that is there in that pose, a `<weld>` the other's anchor, or where
/// its `relpose` says; sites hold their origins. How axes stand to each other is not in it: whoever closes the loop holds them as they begin.
/// Anything else is [`TieLaw::Other`].
///
/// # Errors
///
/// [`FilesError`] as [`read_with`](super::read_with), and for bodies and sites that there are not.
///
/// # Examples
///
/// ```
/// use solaris_io::{NoFiles, mjcf};
/// use solaris_model::{TieLaw, Vector3};
///
/// let text = r#"<mujoco><worldbody><body name="rod" pos="0 0 1"><joint axis="0 1 0"/><geom type="sphere" size="0.1"/></body></worldbody>
///     <equality><connect name="held" body1="rod" anchor="0.5 0 0"/></equality></mujoco>"#;
/// let found = mjcf::ties(text, &mut NoFiles)?;
/// assert_eq!((found[0].name.as_str(), &found[0].law), ("held", &TieLaw::Points));
/// assert_eq!(found[0].between[0].link.as_deref(), Some("rod"));
/// assert_eq!(found[0].between[1].point, Vector3::new(0.5, 0.0, 1.0));
/// # Ok::<(), solaris_io::FilesError>(())
/// ```
pub fn ties(text: &str, loader: &mut dyn Loader) -> Result<Vec<Tie>, FilesError> {
    let assembly = Assembly::of(text, loader)?;
    let (loaded, sprung) =
        assembled(&assembly, loader, HashMap::new()).map_err(|error| assembly.error(error))?;
    read(&assembly, &loaded.import.figure, &sprung).map_err(|error| assembly.error(error))
}

fn read(assembly: &Assembly, figure: &Figure, sprung: &Sprung) -> Result<Vec<Tie>, TextError> {
    let document = xml::parse(assembly.text.as_ref(), DEEPEST)?;
    let root = document.root_element();
    let mut reader = Reader::new(assembly.text.as_ref());
    let models = Model::all(&mut reader, root, assembly);
    let mut found = Vec::new();
    if let Some(model) = models.first() {
        let mut nodes = elements_called(model.root, "equality").flat_map(elements).peekable();
        let frames = if nodes.peek().is_some() { Frames::of(figure, sprung) } else { Frames::default() };
        for (i, node) in nodes.enumerate() {
            let said = model.defaults.resolve_as(&mut reader, node, 0, "equality");
            if said.text("active") != Some("false") {
                let element = node.tag_name().name();
                let name = node.attribute("name").map_or_else(|| format!("{element}{i}"), str::to_owned);
                found.extend(tie(&mut reader, node, &said, &frames, name));
            }
        }
    }
    reader.error().map_or(Ok(found), Err)
}

fn tie(reader: &mut Reader, node: Node, said: &Resolved, frames: &Frames, name: String) -> Option<Tie> {
    let law = match node.tag_name().name() {
        "connect" => TieLaw::Points,
        "weld" => TieLaw::Axes,
        other => {
            let law = TieLaw::Other(format!("<{other}>"));
            return Some(Tie { name, between: Default::default(), law });
        }
    };
    let between = if said.text("site1").is_some() || said.text("site2").is_some() {
        let ends = ["site1", "site2"].map(|end| frames.named(reader, node, said.text(end), end, Kind::Site));
        let [first, second] = ends;
        [first?, second?].map(|at| at.end(&Vector3::zeros()))
    } else {
        let first = frames.named(reader, node, said.text("body1"), "body1", Kind::Body)?;
        let second = match said.text("body2") {
            None | Some("world") => Frame::default(),
            name => frames.named(reader, node, name, "body2", Kind::Body)?,
        };
        let anchor = Vector3::from(said.numbers::<3>(reader, "anchor").unwrap_or_default());
        if law == TieLaw::Points {
            let point = moved(&second.world.inverse(), &moved(&first.world, &anchor));
            [first.end(&anchor), second.end(&point)]
        } else {
            let relative = first.world.inv_mul(&second.world);
            let held = relpose(reader, said).unwrap_or_else(|| moved(&relative, &anchor));
            [first.end(&held), second.end(&anchor)]
        }
    };
    Some(Tie { name, between, law })
}

/// Where in the first body the second's anchor is to be, where the file says that; a quaternion of zeros says that it does not. How the axes
/// are to stand to each other is not read of it.
fn relpose(reader: &mut Reader, said: &Resolved) -> Option<Vector3<f64>> {
    let [x, y, z, turn @ ..] = said.numbers::<7>(reader, "relpose")?;
    turn.iter().any(|part| part.abs() > 0.0).then(|| Vector3::new(x, y, z))
}

/// A point of a frame in the frame that it stands in.
fn moved(frame: &Placement, point: &Vector3<f64>) -> Vector3<f64> {
    frame.rotation * point + frame.translation.vector
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Body,
    Site,
}

/// A body's or a site's frame: in its link, and in the world in the pose of the file.
#[derive(Clone, Default)]
struct Frame {
    link: Option<String>,
    within: Placement,
    world: Placement,
}

impl Frame {
    fn end(&self, point: &Vector3<f64>) -> TieEnd {
        TieEnd { link: self.link.clone(), point: moved(&self.within, point) }
    }
}

/// The frames of bodies and sites, by their names; a body's comes before a site's.
#[derive(Default)]
struct Frames(HashMap<String, Frame>);

impl Frames {
    fn of(figure: &Figure, sprung: &Sprung) -> Self {
        let poses = poses(figure, sprung);
        let mut all = HashMap::new();
        for (link, pose) in figure.links().iter().zip(&poses) {
            let frame = |within: Placement| Frame {
                link: Some(link.name().to_owned()),
                within,
                world: pose * within,
            };
            for named in link.frames() {
                all.insert(named.name.clone(), frame(named.placement));
            }
            // A body whose frame is not its link's has one of its name.
            all.entry(link.name().to_owned()).or_insert_with(|| frame(Placement::identity()));
        }
        Self(all)
    }

    fn named(
        &self,
        reader: &mut Reader,
        node: Node,
        name: Option<&str>,
        attribute: &str,
        kind: Kind,
    ) -> Option<Frame> {
        let what = if kind == Kind::Body { "body" } else { "site of a body" };
        let Some(name) = name else {
            reader.fault(tag(node), format!("<{}> has no '{attribute}'", node.tag_name().name()));
            return None;
        };
        let found = self.0.get(name).cloned();
        if found.is_none() {
            let hint = reader.hint(name, self.0.keys().map(String::as_str));
            reader.fault(tag(node), format!("there is no {what} '{name}'{hint}"));
        }
        found
    }
}

/// Where links stand in the pose of the file; where the kernel does not know the figure, at the world's origin.
fn poses(figure: &Figure, sprung: &Sprung) -> Vec<Placement> {
    let mut q = vec![0.0; figure.layout().nq()];
    // What is refused is a wrong length.
    let _ = figure.neutral(&mut q);
    for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
        if let (JointKind::Free { .. }, Some(place)) =
            (link.joint().kind(), sprung.places.get(link.joint().name()))
        {
            let (at, turn) = (&mut q[at.q..at.q + 7], place.rotation);
            at[..3].copy_from_slice(place.translation.vector.as_slice());
            at[3..].copy_from_slice(&[turn.i, turn.j, turn.k, turn.w]);
        }
        for (i, dof) in link.joint().kind().axes().iter().enumerate() {
            let reference = dof.name.as_ref().and_then(|name| sprung.references.get(name));
            q[at.q + i] = reference.copied().unwrap_or(0.0);
        }
    }
    let found = Tree::<f64>::new(figure, Vector3::zeros()).and_then(|tree| {
        let mut workspace = Workspace::new(&tree);
        forward_kinematics(&tree, &mut workspace, &q)?;
        let pose = |link: usize| {
            let pose = workspace.pose(link);
            let turn = Rotation3::from_matrix_unchecked(pose.rotation);
            Placement::from_parts(pose.translation.into(), UnitQuaternion::from_rotation_matrix(&turn))
        };
        Ok((0..figure.links().len()).map(pose).collect())
    });
    found.unwrap_or_else(|_| vec![Placement::identity(); figure.links().len()])
}
