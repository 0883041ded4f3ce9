//! How a model is scaled to a person.

use super::tasks::{CoordinateTask, MarkerTask, tasks};
use super::{file, held, place, time_range, tool};
use crate::opensim::DEEPEST;
use crate::opensim::element::{child_flag, child_number, child_words, name_of};
use crate::xml::{self, Node, Reader, element, elements, elements_called, tag};
use solaris_model::{Finding, TextError, Vector3};

/// The setup of a `ScaleTool`.
#[derive(Clone, Debug)]
pub struct ScaleSetup {
    /// The person's mass (kg), if it is above zero.
    pub mass: Option<f64>,
    /// The unscaled model's file, as it is named there.
    pub model_file: Option<String>,
    /// A file of markers that join the model's.
    pub marker_set_file: Option<String>,
    /// What scales the model, in its order; what comes later takes the place of what came before, axis by axis.
    pub steps: Vec<ScalingStep>,
    /// Measurements by pairs of markers that apply.
    pub measurements: Vec<Measurement>,
    /// Factors that are given and apply.
    pub manual: Vec<ManualScale>,
    /// The trial that is measured.
    pub marker_file: Option<String>,
    /// From when to when (s).
    pub time_range: Option<(f64, f64)>,
    /// Whether each segment keeps its share of the mass; otherwise they scale with their volume.
    pub keeps_mass_distribution: bool,
    /// The scaled model's file.
    pub output_model_file: Option<String>,
    /// How markers are placed, if they are.
    pub placer: Option<PlacerSetup>,
    /// What has no effect.
    pub findings: Vec<Finding>,
}

/// A kind of scaling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalingStep {
    /// By pairs of markers.
    Measurements,
    /// By given factors.
    Manual,
}

/// A factor by pairs of markers, and what it scales.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// Its name.
    pub name: String,
    /// Pairs of markers.
    pub pairs: Vec<[String; 2]>,
    /// Bodies.
    pub bodies: Vec<BodyAxes>,
}

/// Axes of a body that are scaled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BodyAxes {
    /// The body.
    pub body: String,
    /// Whether x, y and z are.
    pub axes: [bool; 3],
}

/// Given factors of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct ManualScale {
    /// The body.
    pub body: String,
    /// The factors of its x, y and z.
    pub factors: Vector3<f64>,
}

/// How markers are placed by a static trial.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacerSetup {
    /// Weights of markers.
    pub markers: Vec<MarkerTask>,
    /// Coordinates that are drawn somewhere.
    pub coordinates: Vec<CoordinateTask>,
    /// The static trial.
    pub marker_file: Option<String>,
    /// A file of coordinates, which tasks may refer to.
    pub coordinate_file: Option<String>,
    /// From when to when its mean is taken (s).
    pub time_range: Option<(f64, f64)>,
    /// The file of the model with placed markers.
    pub output_model_file: Option<String>,
    /// The file of the static pose.
    pub output_motion_file: Option<String>,
}

/// Reads the setup of a `ScaleTool`.
///
/// # Errors
///
/// [`TextError`] with every fault and its place: text that is no XML or no such setup, pairs that are not two markers, axes and
/// factors that are none.
///
/// # Examples
///
/// ```
/// let text = r#"<OpenSimDocument Version="40000"><ScaleTool name="ann"><mass>72.6</mass>
///   <ModelScaler><scaling_order>measurements</scaling_order><MeasurementSet><objects>
///     <Measurement name="thigh"><apply>true</apply>
///       <MarkerPairSet><objects><MarkerPair><markers>R.ASIS R.Knee</markers></MarkerPair></objects></MarkerPairSet>
///       <BodyScaleSet><objects><BodyScale name="femur_r"><axes>X Y Z</axes></BodyScale></objects></BodyScaleSet>
///     </Measurement></objects></MeasurementSet></ModelScaler>
/// </ScaleTool></OpenSimDocument>"#;
/// let setup = solaris_io::opensim::scale_setup(text)?;
/// assert_eq!((setup.mass, setup.placer), (Some(72.6), None));
/// assert_eq!(setup.measurements[0].bodies[0].axes, [true; 3]);
/// # Ok::<(), solaris_model::TextError>(())
/// ```
#[doc(alias = "ScaleTool")]
pub fn scale_setup(text: &str) -> Result<ScaleSetup, TextError> {
    let strict = xml::mended(text);
    let document = xml::parse(&strict, DEEPEST)?;
    let root = document.root_element();
    let mut reader = Reader::new(text);
    let Some(node) = tool(root, "ScaleTool") else {
        let message = format!("{} is no setup of a <ScaleTool>", held(root));
        return Err(TextError::one(text, tag(root), message));
    };
    let mass = child_number(&mut reader, node, "mass").filter(|mass| *mass > 0.0);
    for name in ["height", "age"] {
        if child_number(&mut reader, node, name).is_some_and(|told| told > 0.0) {
            reader.note(place(node, name), name, "it has no effect, as in OpenSim");
        }
    }
    let maker = element(node, "GenericModelMaker").unwrap_or(node);
    let scaler = applied(&mut reader, element(node, "ModelScaler"));
    let placer =
        applied(&mut reader, element(node, "MarkerPlacer")).map(|placer| placer_of(&mut reader, placer));
    let (measurements, manual) = match scaler {
        Some(scaler) => (measurements(&mut reader, scaler), manual(&mut reader, scaler)),
        None => (Vec::new(), Vec::new()),
    };
    let of_scaler = |name: &str| scaler.and_then(|scaler| file(scaler, name));
    let setup = ScaleSetup {
        mass,
        model_file: file(maker, "model_file"),
        marker_set_file: file(maker, "marker_set_file"),
        steps: scaler.map_or_else(Vec::new, |scaler| steps(&mut reader, scaler)),
        measurements,
        manual,
        marker_file: of_scaler("marker_file"),
        time_range: scaler.and_then(|scaler| time_range(&mut reader, scaler)),
        keeps_mass_distribution: scaler
            .is_some_and(|scaler| child_flag(&mut reader, scaler, "preserve_mass_distribution", false)),
        output_model_file: of_scaler("output_model_file"),
        placer,
        findings: Vec::new(),
    };
    reader.error().map_or(Ok(()), Err)?;
    Ok(ScaleSetup { findings: reader.findings(), ..setup })
}

/// A part of the tool, unless it is switched off.
fn applied<'a>(reader: &mut Reader, part: Option<Node<'a>>) -> Option<Node<'a>> {
    part.filter(|part| child_flag(reader, *part, "apply", true))
}

fn steps(reader: &mut Reader, scaler: Node) -> Vec<ScalingStep> {
    let told = child_words(scaler, "scaling_order").unwrap_or_default();
    let mut steps = Vec::new();
    for word in told.split_whitespace() {
        match word {
            "measurements" => steps.push(ScalingStep::Measurements),
            "manualScale" => steps.push(ScalingStep::Manual),
            other => {
                let message = format!(
                    "<scaling_order> says '{}'; it may say measurements and manualScale",
                    xml::shown(other)
                );
                reader.fault(place(scaler, "scaling_order"), message);
            }
        }
    }
    steps
}

/// The members of the set `name` that apply.
fn set<'a>(reader: &mut Reader, holder: Node<'a>, name: &str) -> Vec<Node<'a>> {
    let sets = elements_called(holder, name).flat_map(|set| elements_called(set, "objects"));
    sets.flat_map(elements).filter(|node| child_flag(reader, *node, "apply", true)).collect()
}

fn measurements(reader: &mut Reader, scaler: Node) -> Vec<Measurement> {
    let mut found = Vec::new();
    for node in set(reader, scaler, "MeasurementSet") {
        let Some(name) = name_of(reader, node).map(str::to_owned) else { continue };
        let mut pairs = Vec::new();
        for pair in set(reader, node, "MarkerPairSet") {
            let words = child_words(pair, "markers").unwrap_or_default().split_whitespace();
            let words: Vec<String> = words.map(str::to_owned).collect();
            match <[String; 2]>::try_from(words) {
                Ok(pair) => pairs.push(pair),
                Err(words) => {
                    let message = format!(
                        "a pair of measurement '{name}' has {} markers; it must have two",
                        words.len()
                    );
                    reader.fault(place(pair, "markers"), message);
                }
            }
        }
        let mut bodies = Vec::new();
        for scale in set(reader, node, "BodyScaleSet") {
            let Some(body) = name_of(reader, scale).map(str::to_owned) else { continue };
            let told = child_words(scale, "axes").unwrap_or_default().to_ascii_uppercase();
            let axes = ["X", "Y", "Z"].map(|axis| told.split_whitespace().any(|word| word == axis));
            if told.split_whitespace().any(|word| !["X", "Y", "Z"].contains(&word)) {
                let message =
                    format!("<axes> of '{body}' are '{}'; they may be X, Y and Z", xml::shown(&told));
                reader.fault(place(scale, "axes"), message);
            }
            bodies.push(BodyAxes { body, axes });
        }
        found.push(Measurement { name, pairs, bodies });
    }
    found
}

fn manual(reader: &mut Reader, scaler: Node) -> Vec<ManualScale> {
    let mut found = Vec::new();
    for node in set(reader, scaler, "ScaleSet") {
        let Some(body) = child_words(node, "segment").map(str::to_owned) else {
            reader.fault(tag(node), "a <Scale> has no <segment>: the body that it scales");
            continue;
        };
        let numbers = element(node, "scales").and_then(|scales| reader.text_numbers(scales, 3..=3));
        if let Some(numbers) = numbers {
            found.push(ManualScale { body, factors: Vector3::from_row_slice(&numbers) });
        }
    }
    found
}

fn placer_of(reader: &mut Reader, node: Node) -> PlacerSetup {
    let (markers, coordinates) = tasks(reader, node);
    if child_number(reader, node, "max_marker_movement").is_some_and(|most| most >= 0.0) {
        let message = "it has no effect: how far markers move is told in any case";
        reader.note(place(node, "max_marker_movement"), "max_marker_movement", message);
    }
    PlacerSetup {
        markers,
        coordinates,
        marker_file: file(node, "marker_file"),
        coordinate_file: file(node, "coordinate_file"),
        time_range: time_range(reader, node),
        output_model_file: file(node, "output_model_file"),
        output_motion_file: file(node, "output_motion_file"),
    }
}
