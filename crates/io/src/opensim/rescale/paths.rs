//! How long muscles and springs are in the default pose, and what they measure of it.

use super::bodies::Bodies;
use super::drives::location;
use super::edits::Edits;
use super::lengths::ON;
use super::wraps::Wraps;
use crate::opensim::defaults::coordinate_defaults;
use crate::opensim::element::{child_vector, child_words};
use crate::opensim::frames::Anchor;
use crate::opensim::function;
use crate::xml::{Node, Reader, element, elements, elements_called, tag};
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{Placement, Vector3};
use std::collections::HashMap;

/// What is as much longer as the path is.
const LENGTHS: [&str; 4] = ["optimal_fiber_length", "tendon_slack_length", "resting_length", "slack_length"];

/// How near to the ends of its range a conditional point is still there, as in OpenSim.
const EDGE: f64 = 1e-5;

/// The default pose of a model.
pub(super) struct Pose {
    /// Where the bodies stand in the world.
    bodies: HashMap<String, Placement>,
    /// The coordinates' values.
    values: HashMap<String, f64>,
}

impl Pose {
    /// The default pose of the model that `text` is; nothing where it is no figure.
    pub(super) fn of(text: &str, names: impl Iterator<Item = String>) -> Option<Self> {
        let figure = crate::opensim::read(text).ok()?.figure;
        let layout = figure.layout();
        let (mut q, mut v, mut a) = (vec![0.0; layout.nq()], vec![0.0; layout.nv()], vec![0.0; layout.nv()]);
        let mut values = HashMap::new();
        for default in coordinate_defaults(text) {
            if let Some(at) = layout.dof_index(&default.name).and_then(|dof| layout.coordinate(dof)) {
                q[at] = default.value;
            }
            values.insert(default.name, default.value);
        }
        figure.follow(&mut q, &mut v, &mut a);
        for (dof, name) in layout.v_names().iter().enumerate() {
            if let Some(at) = layout.coordinate(dof) {
                values.insert(name.clone(), q[at]);
            }
        }
        let tree = Tree::<f64>::new(&figure, Vector3::zeros()).ok()?;
        let mut workspace = Workspace::new(&tree);
        forward_kinematics(&tree, &mut workspace, &q).ok()?;
        let place = |name: String| {
            let (link, within) = figure.locate(&name)?;
            let pose = workspace.pose(link);
            let rotation = solaris_model::Rotation3::from_matrix_unchecked(pose.rotation);
            let at = Placement::from_parts(
                pose.translation.into(),
                solaris_model::UnitQuaternion::from_rotation_matrix(&rotation),
            );
            Some((name, at * within))
        };
        Some(Self { bodies: names.filter_map(place).collect(), values })
    }

    /// Where a frame stands in the world.
    pub(super) fn frame(&self, bodies: &Bodies, at: &Anchor) -> Option<Placement> {
        let body = match at.body {
            None => Placement::identity(),
            body => *self.bodies.get(bodies.name(body))?,
        };
        Some(body * at.within)
    }
}

/// How long a path is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Length {
    /// So long (m), straight from point to point.
    Straight(f64),
    /// It may lie on wrap objects.
    Wraps,
    /// A point of it cannot be placed.
    Unknown,
}

/// The lengths of all paths of a model, in the order of the file.
pub(super) fn lengths(reader: &mut Reader, bodies: &mut Bodies, pose: &Pose) -> Vec<Length> {
    let wraps = Wraps::of(bodies.model);
    sets(bodies.model).map(|set| length(reader, bodies, pose, &wraps, set)).collect()
}

/// The sets of points of all paths.
fn sets(model: Node<'_>) -> impl Iterator<Item = Node<'_>> {
    let is_set = |node: &Node| matches!(node.tag_name().name(), "PathPointSet" | "MusclePointSet");
    let is_default = |node: &Node| node.ancestors().any(|above| above.has_tag_name("defaults"));
    model.descendants().filter(move |node| is_set(node) && !is_default(node))
}

fn length(reader: &mut Reader, bodies: &mut Bodies, pose: &Pose, wraps: &Wraps, set: Node) -> Length {
    let mut points = Vec::new();
    for node in elements_called(set, "objects").flat_map(elements) {
        let found = match is_there(reader, pose, node) {
            Some(true) => point(reader, bodies, pose, node).map(Some),
            Some(false) => Some(None),
            None => None,
        };
        let Some(found) = found else { return Length::Unknown };
        points.push(found);
    }
    for beside in set.parent().into_iter().flat_map(elements) {
        if matches!(beside.tag_name().name(), "PathWrapSet" | "MuscleWrapSet")
            && !wraps.leave_straight(reader, bodies, pose, beside, &points)
        {
            return Length::Wraps;
        }
    }
    let points: Vec<Vector3<f64>> = points.into_iter().flatten().collect();
    Length::Straight(points.array_windows().map(|[a, b]| (b - a).norm()).sum())
}

/// The value of the coordinate that an element names by one of these children.
fn value(pose: &Pose, node: Node, names: [&str; 2]) -> Option<f64> {
    let told = names.into_iter().find_map(|name| child_words(node, name))?;
    pose.values.get(told.rsplit('/').next().unwrap_or(told)).copied()
}

/// Whether a point is a part of its path in the pose.
fn is_there(reader: &mut Reader, pose: &Pose, node: Node) -> Option<bool> {
    if !matches!(node.tag_name().name(), "ConditionalPathPoint" | "MuscleViaPoint") {
        return Some(true);
    }
    let value = value(pose, node, ["socket_coordinate", "coordinate"])?;
    let range = reader.text_numbers(element(node, "range")?, 2..=2)?;
    Some((range[0] - EDGE..=range[1] + EDGE).contains(&value))
}

/// Where a point is in the world.
fn point(reader: &mut Reader, bodies: &mut Bodies, pose: &Pose, node: Node) -> Option<Vector3<f64>> {
    let at = bodies.holder(reader, node, &ON)?;
    let frame = pose.frame(bodies, &at)?;
    let mut place = child_vector(reader, node, "location");
    if matches!(node.tag_name().name(), "MovingPathPoint" | "MovingMusclePoint") {
        for (i, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let told = [format!("socket_{axis}_coordinate"), format!("{axis}_coordinate")];
            let over = value(pose, node, [&told[0], &told[1]])?;
            place[i] = function::read(reader, location(node, axis)?, "point")?.at(over)[0];
        }
    }
    Some(frame.transform_point(&place.into()).coords)
}

/// Scales what muscles and springs measure of their paths, by how much longer those become.
pub(super) fn scale(
    edits: &mut Edits,
    reader: &mut Reader,
    model: Node,
    before: &[Length],
    after: &[Length],
) {
    let (mut wrapped, mut unknown) = (Vec::new(), Vec::new());
    for ((set, before), after) in sets(model).zip(before).zip(after) {
        let Some(owner) = set.ancestors().skip(1).find(|node| node.tag_name().name() != "GeometryPath")
        else {
            continue;
        };
        let fields: Vec<Node> = LENGTHS.iter().filter_map(|name| element(owner, name)).collect();
        if fields.is_empty() {
            continue;
        }
        match (before, after) {
            (Length::Straight(before), Length::Straight(after)) if *before > 0.0 => {
                // A path that is as long to rounding keeps its digits.
                let factor = after / before;
                for field in fields.into_iter().filter(|_| (factor - 1.0).abs() > 1e-12) {
                    edits.scale(reader, field, &[factor]);
                }
            }
            (Length::Wraps, _) | (_, Length::Wraps) => wrapped.push(owner),
            _ => unknown.push(owner),
        }
    }
    let why = "their lengths of fibres, tendons and springs at rest are as they were; set them from their paths in OpenSim";
    tell(
        reader,
        &wrapped,
        &format!(
            "their paths lie on wrap objects in the default pose, or may, and such paths are not measured here: {why}"
        ),
    );
    tell(
        reader,
        &unknown,
        &format!("their paths cannot be measured here (points or a pose that a figure does not have): {why}"),
    );
}

/// Says something about muscles and springs, of which the first few are named.
fn tell(reader: &mut Reader, owners: &[Node], message: &str) {
    let Some(first) = owners.first() else { return };
    let mut names: Vec<&str> = owners.iter().take(6).filter_map(|owner| owner.attribute("name")).collect();
    if owners.len() > names.len() {
        names.push("…");
    }
    let subject = format!("{} muscles and springs ({})", owners.len(), names.join(", "));
    reader.unsupported(tag(*first), subject, message);
}

/// The paths of a model whose pose is not known.
pub(super) fn unknown(model: Node) -> Vec<Length> {
    sets(model).map(|_| Length::Unknown).collect()
}
