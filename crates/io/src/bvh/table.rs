//! A clip as a table, of its own figure or of another one with the same bones; and the table of masses that people write.

use super::error::BvhError;
use crate::clip::Clip;
use crate::clip::coordinates::coordinates;
use crate::table::{TIME, Table};
use solaris_model::{AxisKind, Figure, Joint, JointKind, Motion, TextError, Vector3};
use std::collections::HashMap;
use std::ops::Range;

/// How far (rad) a channel may turn about an axis that the figure's joint lacks: printed digits.
const NO_TURN: f64 = 1e-6;

impl Clip {
    /// Times and positions (rad, m), headed `time` and `DOF.q`.
    pub fn table(&self) -> Table {
        let names = self.figure.layout().q_names().iter();
        let columns: Vec<Column> = (0..names.len()).map(Column::Own).collect();
        table(&self.motion, names.cloned(), &columns)
    }

    /// Times and positions of another `figure`, whose links have the names of the clip's joints: such as the figure that a
    /// clip was written of.
    ///
    /// The joints must slide and turn about the same axes in the same order; axes that the figure lacks may not turn in the
    /// clip. A joint that is a ball in the clip may be one about axes x, y, z in the figure. Bones that the figure lacks are not used.
    ///
    /// # Errors
    ///
    /// [`BvhError::NotTheFigure`] with the first link that is not in the clip, or moves otherwise.
    pub fn table_of(&self, figure: &Figure) -> Result<Table, BvhError> {
        if figure.fingerprint() == self.figure.fingerprint() {
            return Ok(self.table());
        }
        let own: HashMap<&str, usize> =
            self.figure.links().iter().enumerate().map(|(i, link)| (link.name(), i)).collect();
        let (mut columns, mut names): (Vec<Column>, Vec<String>) = (Vec::new(), Vec::new());
        for (link, at) in figure.links().iter().zip(figure.layout().joints()) {
            if at.nq == 0 {
                continue;
            }
            let refuse = |why: String| BvhError::NotTheFigure {
                figure: figure.name().to_owned(),
                link: link.name().to_owned(),
                why,
            };
            let word = link.name().replace(char::is_whitespace, "_");
            let Some(&bone) = own.get(word.as_str()) else {
                return Err(refuse("the clip has no joint of that name".to_owned()));
            };
            let first = self.figure.layout().joints()[bone].q;
            let from = self.figure.links()[bone].joint();
            let found = if from.kind().quaternion().is_some() {
                coordinates(link.joint(), from, &self.motion, first)
                    .map(|columns| columns.into_iter().map(Column::Found).collect::<Vec<_>>())
            } else {
                self.matched(link.joint(), from, first)
                    .map(|places| places.into_iter().map(Column::Own).collect())
            };
            columns.extend(found.map_err(|why| {
                refuse(format!(
                    "its joint '{}' does not move as the clip's does ({why})",
                    link.joint().name()
                ))
            })?);
            names.extend(figure.layout().q_names()[at.q..at.q + at.nq].iter().cloned());
        }
        Ok(table(&self.motion, names.into_iter(), &columns))
    }

    /// Where the coordinates of `joint` are among the clip's, whose joint is `bone` with coordinates from `first` on; or the axis
    /// that differs.
    fn matched(&self, joint: &Joint, bone: &Joint, first: usize) -> Result<Vec<usize>, String> {
        let JointKind::Axes(wanted) = joint.kind() else { return Err("a ball or free joint".to_owned()) };
        let mut places = Vec::new();
        let mut rest = wanted.iter().peekable();
        for (i, dof) in bone.kind().axes().iter().enumerate() {
            let same = rest.peek().is_some_and(|next| {
                next.axis.kind == dof.axis.kind && next.axis.direction.dot(&dof.axis.direction) > 1.0 - 1e-9
            });
            if same {
                places.push(first + i);
                rest.next();
            } else if dof.axis.kind == AxisKind::Rotation {
                let column = (0..self.motion.len()).map(|row| self.motion.q(row)[first + i].abs());
                if column.fold(0.0, f64::max) > NO_TURN {
                    return Err(format!("about {}", direction(&dof.axis.direction)));
                }
            }
        }
        match rest.next() {
            Some(missing) => Err(format!("about {}", direction(&missing.axis.direction))),
            None => Ok(places),
        }
    }
}

/// A column of a table: a coordinate of the clip, or one that was found.
enum Column {
    Own(usize),
    Found(Vec<f64>),
}

fn direction(axis: &Vector3<f64>) -> String {
    format!("({}, {}, {})", axis.x, axis.y, axis.z)
}

fn table(motion: &Motion, names: impl Iterator<Item = String>, columns: &[Column]) -> Table {
    let mut table = Table { header_line: 1, ..Table::default() };
    table.columns.push(TIME.to_owned());
    table.columns.extend(names.map(|name| format!("{name}.q")));
    for row in 0..motion.len() {
        table.values.push(motion.time()[row]);
        table.values.extend(columns.iter().map(|column| match column {
            Column::Own(at) => motion.q(row)[*at],
            Column::Found(values) => values[row],
        }));
        table.lines.push(row as u64 + 2);
    }
    table
}

/// The masses of a text with a bone and its mass (kg) a line, a comma between them; the first line may be a heading.
///
/// # Errors
///
/// [`TextError`] with every line that is none.
///
/// ```
/// let masses = solaris_io::bvh::masses("bone,kg\nHips,12\nLeftUpLeg,9.5\n")?;
/// assert_eq!(masses[1], ("LeftUpLeg".to_owned(), 9.5));
/// # Ok::<(), solaris_model::TextError>(())
/// ```
pub fn masses(text: &str) -> Result<Vec<(String, f64)>, TextError> {
    let (mut found, mut faults, mut at) = (Vec::new(), Vec::<(Range<usize>, String)>::new(), 0);
    for (i, line) in text.split_inclusive('\n').enumerate() {
        let span = at..at + line.trim_end().len();
        at += line.len();
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() {
            continue;
        }
        let pair = line
            .rsplit_once([',', ';', '\t'])
            .map(|(name, mass)| (name.trim().trim_matches('"'), mass.trim()));
        match pair.map(|(name, mass)| (name, mass.parse::<f64>())) {
            Some((name, Ok(mass))) => found.push((name.to_owned(), mass)),
            Some(_) if i == 0 => {}
            _ => faults.push((span, "a line is the name of a bone, a comma, and its mass in kg".to_owned())),
        }
    }
    if faults.is_empty() { Ok(found) } else { Err(TextError::new(text, faults)) }
}
