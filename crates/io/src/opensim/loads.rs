//! External loads: which columns of a table are forces on which bodies.

use super::DEEPEST;
use super::element::{child_flag, child_words, words_at};
use crate::error::{ExternalForceProblem, IoError};
use crate::table::Table;
use crate::xml::{self, Node, Reader, element, elements_called, tag};
use solaris_model::{Contact, MeasuredForce, TextError, Vector3, nearest};

/// A table of measured forces and what they act on.
#[derive(Clone, Debug, PartialEq)]
pub struct ExternalLoads {
    /// The file of the table, as it is named there; nothing where it is not.
    pub data_file: Option<String>,
    /// The forces, in the order of the file.
    pub forces: Vec<ExternalForce>,
}

/// A force on a body, given by nine columns of a table, all along the axes of ground.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExternalForce {
    /// Its name; may be empty.
    pub name: String,
    /// The body that it acts on.
    pub body: String,
    /// What the headings of the force's three columns begin with (N); nothing for a torque alone.
    pub force: Option<String>,
    /// What the headings of the three columns of the point that it acts at begin with (m).
    pub point: Option<String>,
    /// What the headings of the torque's three columns begin with (N m), about that point; nothing for none.
    pub torque: Option<String>,
}

/// Reads an `ExternalLoads` document.
///
/// # Errors
///
/// [`TextError`] with every fault and its place: text that is no XML or holds no loads, forces without a body or without
/// columns, forces and points in any other frame than ground, and forces that name no point, which OpenSim lets act at the
/// body's origin.
///
/// # Examples
///
/// ```
/// let text = r#"<OpenSimDocument Version="40000"><ExternalLoads name="walk"><objects>
///   <ExternalForce name="right">
///     <applied_to_body>calcn_r</applied_to_body>
///     <force_identifier>ground_force_v</force_identifier>
///     <point_identifier>ground_force_p</point_identifier>
///     <torque_identifier>ground_torque_</torque_identifier>
///   </ExternalForce></objects>
///   <datafile>walk_grf.mot</datafile>
/// </ExternalLoads></OpenSimDocument>"#;
/// let loads = solaris_io::opensim::external_loads(text)?;
/// assert_eq!(loads.forces[0].body, "calcn_r");
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn external_loads(text: &str) -> Result<ExternalLoads, TextError> {
    let strict = xml::mended(text);
    let document = xml::parse(&strict, DEEPEST)?;
    let mut reader = Reader::new(text);
    let root = document.root_element();
    let held =
        if root.tag_name().name() == "ExternalLoads" { Some(root) } else { element(root, "ExternalLoads") };
    let Some(loads) = held else {
        let message = format!("<{}> holds no <ExternalLoads>", root.tag_name().name());
        return Err(TextError::one(text, tag(root), message));
    };
    let nodes =
        elements_called(loads, "objects").flat_map(|objects| elements_called(objects, "ExternalForce"));
    let forces: Vec<ExternalForce> = nodes.filter_map(|node| force(&mut reader, node)).collect();
    if forces.is_empty() && !reader.has_faults() {
        reader.fault(tag(loads), "the <ExternalLoads> hold no <ExternalForce> that applies");
    }
    reader.error().map_or(Ok(()), Err)?;
    Ok(ExternalLoads { data_file: child_words(loads, "datafile").map(str::to_owned), forces })
}

/// A force; nothing for one that is switched off or wrong.
fn force(reader: &mut Reader, node: Node) -> Option<ExternalForce> {
    let name = node.attribute("name").unwrap_or_default().trim().to_owned();
    let owner = format!("external force '{name}'");
    if !child_flag(reader, node, "appliesForce", true) || child_flag(reader, node, "isDisabled", false) {
        return None;
    }
    for frame in ["force_expressed_in_body", "point_expressed_in_body"] {
        let told = child_words(node, frame).unwrap_or("ground");
        if told.rsplit('/').next() != Some("ground") {
            let span = element(node, frame).map_or_else(|| tag(node), |node| words_at(node));
            let message = format!("{owner}: <{frame}> is '{}'; only 'ground' is read", xml::shown(told));
            reader.fault(span, message);
        }
    }
    let identifier =
        |what: &str| child_words(node, what).filter(|told| *told != "Unassigned").map(str::to_owned);
    let (force, point, torque) =
        (identifier("force_identifier"), identifier("point_identifier"), identifier("torque_identifier"));
    if force.is_none() && torque.is_none() {
        reader
            .fault(tag(node), format!("{owner} has neither a <force_identifier> nor a <torque_identifier>"));
    }
    if force.is_some() && point.is_none() {
        let message = format!(
            "{owner} has no <point_identifier>, so that it acts at the body's origin; that is not read: give the point as \
             columns of the table"
        );
        reader.fault(tag(node), message);
    }
    let Some(body) = child_words(node, "applied_to_body") else {
        reader.fault(tag(node), format!("{owner} has no <applied_to_body>"));
        return None;
    };
    // A path of which the name is what counts.
    let body = body.rsplit('/').next().unwrap_or(body).to_owned();
    Some(ExternalForce { name, body, force, point, torque })
}

impl ExternalLoads {
    /// The forces that a table holds, with moments about the world's origin.
    ///
    /// ```text
    /// m = t + p × f
    /// ```
    ///
    /// # Errors
    ///
    /// [`IoError::ExternalForce`] for a table without times or without three columns whose headings begin as an identifier
    /// says.
    pub fn records(&self, table: &Table) -> Result<Vec<MeasuredForce>, IoError> {
        self.forces.iter().map(|force| force.record(table)).collect()
    }
}

impl ExternalForce {
    fn record(&self, table: &Table) -> Result<MeasuredForce, IoError> {
        let fault = |problem| IoError::ExternalForce { force: self.name.clone(), problem };
        let time = table.column("time").ok_or_else(|| fault(ExternalForceProblem::NoTime))?;
        let columns = |what, identifier: &Option<String>| {
            identifier
                .as_deref()
                .map(|identifier| columns(table, what, identifier))
                .transpose()
                .map_err(fault)
        };
        let (force, point, torque) = (
            columns("force", &self.force)?,
            columns("point", &self.point)?,
            columns("torque", &self.torque)?,
        );
        let samples = (0..table.len()).map(|row| {
            let row = table.row(row);
            let read = |columns: Option<[usize; 3]>| {
                columns.map_or_else(Vector3::zeros, |[x, y, z]| Vector3::new(row[x], row[y], row[z]))
            };
            let (force, cop) = (read(force), read(point));
            Contact { force, moment: read(torque) + cop.cross(&force), cop }
        });
        let (links, time, samples) =
            (vec![self.body.clone()], table.values_of(time).collect(), samples.collect());
        Ok(MeasuredForce { links, ball_and_tip: None, time, samples })
    }
}

/// The three columns whose headings begin with `identifier`, in the order of the table.
fn columns(table: &Table, what: &'static str, identifier: &str) -> Result<[usize; 3], ExternalForceProblem> {
    let headings = table.columns.iter().enumerate();
    let found: Vec<usize> =
        headings.filter(|(_, name)| name.starts_with(identifier)).map(|(i, _)| i).collect();
    <[usize; 3]>::try_from(found).map_err(|found| ExternalForceProblem::Columns {
        what,
        identifier: identifier.to_owned(),
        found: found.len(),
        nearest: nearest(identifier, table.columns.iter().map(String::as_str)),
    })
}
