//! What inverse kinematics weighs.

use super::{file, held, place, time_range, tool};
use crate::opensim::DEEPEST;
use crate::opensim::element::{child_flag, child_number, child_words, name_of};
use crate::xml::{self, Node, Reader, elements, elements_called, tag};
use solaris_model::{Finding, TextError};

/// The setup of an `InverseKinematicsTool`.
#[derive(Clone, Debug)]
pub struct IkSetup {
    /// The model's file, as it is named there.
    pub model_file: Option<String>,
    /// The trial's file.
    pub marker_file: Option<String>,
    /// A file of coordinates, which tasks may refer to.
    pub coordinate_file: Option<String>,
    /// From when to when (s); all of the trial without.
    pub time_range: Option<(f64, f64)>,
    /// The file that it writes.
    pub output_motion_file: Option<String>,
    /// Weights of markers that apply, in the order of the file.
    pub markers: Vec<MarkerTask>,
    /// Coordinates that are drawn somewhere and apply.
    pub coordinates: Vec<CoordinateTask>,
    /// What has no effect.
    pub findings: Vec<Finding>,
}

/// The weight of a marker.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkerTask {
    /// The marker.
    pub name: String,
    /// Its weight; 0 where the file gives none, as in OpenSim.
    pub weight: f64,
}

/// A coordinate that is drawn to a value.
#[derive(Clone, Debug, PartialEq)]
pub struct CoordinateTask {
    /// The coordinate.
    pub name: String,
    /// How strongly (m²/rad²).
    pub weight: f64,
    /// To which value.
    pub value: TaskValue,
}

/// The value that a coordinate is drawn to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TaskValue {
    /// The model's default.
    Default,
    /// This one (rad or m).
    Manual(f64),
    /// That of the file of coordinates, at each time.
    FromFile,
}

/// Reads the setup of an `InverseKinematicsTool`.
///
/// # Errors
///
/// [`TextError`] with every fault and its place: text that is no XML or no such setup, tasks without a name, weights and values that
/// are no numbers.
///
/// # Examples
///
/// ```
/// use solaris_io::opensim::{TaskValue, ik_setup};
/// let text = r#"<OpenSimDocument Version="40000"><InverseKinematicsTool name="walk">
///   <IKTaskSet><objects>
///     <IKMarkerTask name="R.ASIS"><apply>true</apply><weight>10</weight></IKMarkerTask>
///     <IKCoordinateTask name="mtp_angle_r"><apply>true</apply><weight>1000</weight>
///       <value_type>manual_value</value_type><value>0.1</value></IKCoordinateTask>
///   </objects></IKTaskSet><time_range>0.4 1.6</time_range>
/// </InverseKinematicsTool></OpenSimDocument>"#;
/// let setup = ik_setup(text)?;
/// assert_eq!((setup.markers[0].weight, setup.time_range), (10.0, Some((0.4, 1.6))));
/// assert_eq!(setup.coordinates[0].value, TaskValue::Manual(0.1));
/// # Ok::<(), solaris_model::TextError>(())
/// ```
#[doc(alias = "InverseKinematicsTool")]
pub fn ik_setup(text: &str) -> Result<IkSetup, TextError> {
    let strict = xml::mended(text);
    let document = xml::parse(&strict, DEEPEST)?;
    let root = document.root_element();
    let mut reader = Reader::new(text);
    let Some(node) = tool(root, "InverseKinematicsTool") else {
        let message = format!("{} is no setup of an <InverseKinematicsTool>", held(root));
        return Err(TextError::one(text, tag(root), message));
    };
    let (markers, coordinates) = tasks(&mut reader, node);
    no_effect(&mut reader, node);
    let setup = IkSetup {
        model_file: file(node, "model_file"),
        marker_file: file(node, "marker_file"),
        coordinate_file: file(node, "coordinate_file"),
        time_range: time_range(&mut reader, node),
        output_motion_file: file(node, "output_motion_file"),
        markers,
        coordinates,
        findings: Vec::new(),
    };
    reader.error().map_or(Ok(()), Err)?;
    Ok(IkSetup { findings: reader.findings(), ..setup })
}

/// The tasks of a tool that apply.
pub(super) fn tasks(reader: &mut Reader, tool: Node) -> (Vec<MarkerTask>, Vec<CoordinateTask>) {
    let (mut markers, mut coordinates) = (Vec::new(), Vec::new());
    let sets = elements_called(tool, "IKTaskSet").flat_map(|set| elements_called(set, "objects"));
    for node in sets.flat_map(elements) {
        let kind = node.tag_name().name();
        if !["IKMarkerTask", "IKCoordinateTask"].contains(&kind) {
            reader.unread_element(node);
            continue;
        }
        let Some(name) = name_of(reader, node).map(str::to_owned) else { continue };
        let weight = child_number(reader, node, "weight").unwrap_or(0.0);
        if weight < 0.0 {
            reader
                .fault(place(node, "weight"), format!("the weight of '{name}' is {weight}; give 0 or more"));
        }
        if !child_flag(reader, node, "apply", true) {
            continue;
        }
        if kind == "IKMarkerTask" {
            markers.push(MarkerTask { name, weight });
        } else {
            let value = value(reader, node, &name);
            coordinates.push(CoordinateTask { name, weight, value });
        }
    }
    (markers, coordinates)
}

fn value(reader: &mut Reader, node: Node, name: &str) -> TaskValue {
    match child_words(node, "value_type") {
        None | Some("default_value") => TaskValue::Default,
        Some("manual_value") => TaskValue::Manual(child_number(reader, node, "value").unwrap_or(0.0)),
        Some("from_file") => TaskValue::FromFile,
        Some(other) => {
            let message = format!(
                "<value_type> of '{name}' is '{}'; it must be default_value, manual_value or from_file",
                xml::shown(other)
            );
            reader.fault(place(node, "value_type"), message);
            TaskValue::Default
        }
    }
}

/// Says what the tool of OpenSim 4 does not heed, or what is met here in any case.
fn no_effect(reader: &mut Reader, node: Node) {
    if child_words(node, "constraint_weight")
        .is_some_and(|told| !told.to_ascii_lowercase().starts_with("inf"))
    {
        let message = "it has no effect: couplings of coordinates are exact here, and in OpenSim 4 too";
        reader.note(place(node, "constraint_weight"), "constraint_weight", message);
    }
    if child_words(node, "accuracy").is_some() {
        let message = "it has no effect: every frame is solved to rounding";
        reader.note(place(node, "accuracy"), "accuracy", message);
    }
}
