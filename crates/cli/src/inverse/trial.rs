//! One motion and its files.

use super::bands::{Bands, Outside};
use super::report::{Asked, Report};
use super::tables;
use crate::args::{InverseArgs, Switch};
use crate::convert::TableFormat;
use crate::cycles::{Column, Cycles};
use crate::error::CliError;
use crate::given::Given;
use crate::ground::{Content, Ground, GroundReport, known_soles, say_medium, write_motion};
use crate::input::Body;
use crate::output::Outputs;
use crate::plausible::Plausibility;
use crate::progress::Progress;
use crate::recording::is_one as is_markers;
use crate::shown::{Shown, stem};
use crate::subject::SubjectReport;
use crate::words::counted;
use solaris::analysis::ground::{Sole, Stances};
use solaris::analysis::{InverseReport, PreparedMotion};
use solaris::files::{Acting, External, JointForces, OwnPlates, Source, joint_forces};
use solaris::io::{csv, sto};
use solaris::model::{AxisKind, MeasuredForce, Medium};
use std::path::{Path, PathBuf};

/// A motion, the files of the forces in it, and what is to be written of it.
pub(super) struct Trial {
    pub(super) motion: PathBuf,
    /// The file of `--external`.
    pub(super) forces: Option<PathBuf>,
    /// The file of `--external-loads`.
    pub(super) loads: Option<PathBuf>,
    pub(super) outputs: Outputs<Content>,
}

/// What is said of plates in the motion's own file where nobody knows the feet.
const UNKNOWN_FEET: &str = "the feet on them are not known; name soles by --soles, or plates by --plate";

/// The feet, as far as they are known.
struct Feet {
    soles: Vec<Sole>,
    stances: Option<Stances>,
}

impl Trial {
    /// Finds the joints' forces and writes the files.
    pub(super) fn analyse(
        &self,
        args: &InverseArgs,
        body: (Body, Option<SubjectReport>),
        progress: &Progress,
    ) -> Result<Report, CliError> {
        let (predicted, from) = (&args.predicted, self.motion.as_path());
        let mut given = Given::of(body, [&args.figure, from], &args.record, &args.frame, progress)?;
        let external = External::read(
            Source::disk(),
            &args.external.plates,
            [self.forces.as_deref(), self.loads.as_deref()],
        )?;
        let mut measured = external.records(&given.body.figure)?;

        progress.stage("finding the forces");
        if predicted.ground {
            say_medium(&mut given);
        }
        let asked = || Ground::new(&predicted.how, &args.frame, predicted.stances.as_deref(), &given);
        let ground = predicted.ground.then(asked).transpose()?;
        let moved = match &ground {
            Some(ground) => ground.make_consistent(&predicted.consistent, &mut given)?,
            None => None,
        };
        let prepared = given.prepared()?;
        let ground = ground.map(|ground| ground.predict(&given, &prepared, moved)).transpose()?;
        let own = if measured.is_empty() && ground.is_none() {
            self.own_plates(&external, predicted.how.soles.as_deref(), &given, &prepared)?
        } else {
            OwnPlates::default()
        };
        measured.extend(own.forces);
        let figure = &given.body.figure;
        let passive = args.passive == Switch::On;
        let medium = &given.body.medium;
        let rows = progress.rows(given.motion().len());
        let mut count = |done: usize| rows.at(done);
        let of_ground = ground.as_ref().map(|ground| ground.forces.loads());
        let acting = Acting { measured: &measured, ground: of_ground, medium, passive };
        let JointForces { plates, loads, forces } =
            joint_forces(from, (figure, given.motion()), &prepared, acting, Some(&mut count))?;

        let feet = match &ground {
            Some(ground) => {
                Feet { soles: ground.soles.clone(), stances: Some(ground.forces.stances.clone()) }
            }
            None => Feet::of(args, &given, &prepared)?,
        };
        let plausible = plausibility(args, &given, &prepared, &measured, &forces)?;
        let cycles = match (&args.cycles.foot, &feet.stances) {
            (Some(foot), Some(stances)) => {
                let columns = columns(&given, &forces);
                Some(Cycles::of(foot, (&feet.soles, stances), given.motion().time(), columns)?)
            }
            _ => None,
        };
        let split = predicted.how.split.unwrap_or_default();
        let outside = Outside {
            measured: (!measured.is_empty()).then_some(&plates),
            ground: ground.as_ref().map(|ground| (&*ground.soles, &ground.forces.stances, split)),
            passive,
        };
        let bands = self.wants_bands(args)?.then(|| {
            progress.stage("finding how far they may be off");
            Bands::of(&given, &outside, &forces)
        });
        let bands = bands.transpose()?;
        let is_measured = ground.is_none();
        let asked = Asked {
            passive,
            medium: describe(medium),
            unused: external.unused(&given.table),
            notes: external.notes(),
            external: match &ground {
                Some(_) => "the ground's, found from the motion".to_owned(),
                None if !own.words.is_empty() => own.words.join("; "),
                None => external.describe(),
            },
            ground: ground.map(|ground| GroundReport::new(ground, &given)),
            plausible,
            cycles,
            bands: bands.as_ref().map(|bands| bands.report.clone()),
        };
        let report = Report::new(&given, asked, &forces);

        progress.stage("writing");
        let contacts = loads.contacts(figure);
        let shown = Shown {
            given: &given,
            contacts: &contacts,
            is_measured,
            soles: &feet.soles,
            level: feet.stances.as_ref().map(|stances| stances.level),
            forces: Some(&forces),
            bands: bands.as_ref().map(Bands::half_widths),
        };
        self.write(&shown, &report, &forces, bands.as_ref())?;
        Ok(report)
    }

    /// The feet on plates of which nobody says who stands on them: of the table of forces, or of the motion's own file.
    fn own_plates(
        &self,
        external: &External,
        soles: Option<&Path>,
        given: &Given,
        prepared: &PreparedMotion<'_>,
    ) -> Result<OwnPlates, CliError> {
        let soles = known_soles(soles, given)?.map(|(soles, _)| soles);
        let table = external.unassigned(&given.body.figure)?;
        let own = match &self.forces {
            Some(file) if soles.is_none() && !table.is_empty() => {
                let why = "which foot stood on which of its plates cannot be told without soles; name them by --soles, or plates by \
                           --plate";
                return Err(CliError::input(file, &why));
            }
            Some(_) => OwnPlates::of_records(&table, prepared, soles, UNKNOWN_FEET),
            None => {
                let plates = given.fitted.as_ref().map_or(&[][..], |fitted| &fitted.recording.plates);
                OwnPlates::of(plates, (given.motion(), prepared), soles, UNKNOWN_FEET)
            }
        };
        own.map_err(|error| CliError::input(&self.motion, &error))
    }

    /// Whether it is to be found how far angles and moments may be off.
    pub(super) fn wants_bands(&self, args: &InverseArgs) -> Result<bool, CliError> {
        let is_moved = args.predicted.consistent.consistent;
        match args.bands {
            Some(Switch::On) if is_moved => {
                let why = "--consistent moves the root to where it balances, and how uncertain that is is not known; leave out one \
                           of them";
                Err(CliError::option("bands", "on", why))
            }
            Some(asked) => Ok(asked == Switch::On),
            None => Ok(is_markers(&self.motion) && !is_moved),
        }
    }

    fn write(
        &self,
        shown: &Shown<'_>,
        report: &Report,
        forces: &InverseReport,
        bands: Option<&Bands>,
    ) -> Result<(), CliError> {
        let errors = bands.map(|bands| &*bands.found.total.forces);
        let (figure, motion) = (&shown.given.body.figure, shown.given.motion());
        let what = "joint moments";
        self.outputs.write(|content, mut writer| {
            let text = match content {
                Content::Forces(TableFormat::Csv) => {
                    let table = tables::torques(figure, motion, forces, errors);
                    return csv::write_table(&table, &mut writer).map_err(CliError::other);
                }
                Content::Forces(TableFormat::Sto) => {
                    let table = tables::moments(figure, motion, forces);
                    return sto::write(&table, &mut writer).map_err(CliError::other);
                }
                #[cfg(feature = "parquet")]
                Content::Forces(TableFormat::Parquet) => {
                    let table = tables::torques(figure, motion, forces, errors);
                    return solaris::io::parquet::write_table(&table, &mut writer).map_err(CliError::other);
                }
                Content::Motion(format) => return write_motion(format, writer, shown.given),
                Content::Cycles(format) => {
                    let title = stem(shown.given);
                    return report
                        .cycles
                        .iter()
                        .try_for_each(|cycles| cycles.write_file(format, &title, &mut *writer));
                }
                Content::Page => shown.page(what, report.page_rows())?,
                Content::Picture => shown.picture(what),
            };
            writer.write_all(text.as_bytes()).map_err(CliError::other)
        })
    }
}

/// Whether measured forces fit the motion, where there are some.
fn plausibility(
    args: &InverseArgs,
    given: &Given,
    prepared: &PreparedMotion<'_>,
    measured: &[MeasuredForce],
    forces: &InverseReport,
) -> Result<Option<Plausibility>, CliError> {
    if measured.is_empty() {
        return Ok(None);
    }
    let soles = known_soles(args.predicted.how.soles.as_deref(), given)?.map(|(soles, _)| soles);
    Plausibility::of(given, prepared, soles, measured)?
        .map(|plausible| plausible.with_residual(given, prepared, forces, measured))
        .transpose()
}

impl Feet {
    /// The soles where somebody knows them; when they stand, where strides are asked for.
    fn of(args: &InverseArgs, given: &Given, prepared: &PreparedMotion<'_>) -> Result<Self, CliError> {
        let how = &args.predicted.how;
        if args.cycles.foot.is_some() {
            let ground = Ground::new(how, &args.frame, args.predicted.stances.as_deref(), given)?;
            let stances = ground.standing(given, &ground.feet(given, prepared)?, 0.0)?.stances;
            return Ok(Self { soles: ground.soles, stances: Some(stances) });
        }
        let soles = known_soles(how.soles.as_deref(), given)?.map(|(soles, _)| soles).unwrap_or_default();
        Ok(Self { soles, stances: None })
    }
}

/// Positions and forces of all degrees of freedom that are free.
fn columns(given: &Given, forces: &InverseReport) -> Vec<Column> {
    let (figure, motion) = (&given.body.figure, given.motion());
    let layout = figure.layout();
    let mut columns = Vec::new();
    for (link, joint) in figure.links().iter().zip(layout.joints()) {
        for axis in 0..joint.nv {
            let (dof, load) = (joint.v + axis, &forces.dofs[joint.v + axis]);
            let turns = layout.axis_kind(dof) == AxisKind::Rotation;
            // A picture of strides is of joints: how far the root has gone, and what is left over there, is in the table.
            let own = (!load.is_residual).then(|| load.dof.clone());
            if figure.follows(dof) {
                continue;
            }
            // Orientations of ball and free joints have no angle of one axis.
            if joint.nq == joint.nv && link.joint().kind().axes().len() == joint.nv {
                let values = (0..motion.len()).map(|frame| motion.q(frame)[joint.q + axis]);
                columns.push(Column {
                    heading: format!("{}.q", load.dof),
                    name: own.clone().or_else(|| turns.then(|| load.dof.clone())),
                    unit: if turns { "°" } else { "m" },
                    factor: if turns { 1_f64.to_degrees() } else { 1.0 },
                    values: values.collect(),
                });
            }
            let values = forces.tau.iter().skip(dof).step_by(layout.nv().max(1));
            columns.push(Column {
                heading: format!("{}.tau", load.dof),
                name: own,
                unit: load.unit,
                factor: 1.0,
                values: values.copied().collect(),
            });
        }
    }
    columns
}

/// What the medium is, for the summary; none where there is none.
fn describe(medium: &Medium) -> Option<String> {
    let Medium { density, viscosity, wind, immersed, carried } = medium;
    let fluid = (!immersed.is_empty()).then(|| {
        let [x, y, z]: [f64; 3] = (*wind).into();
        let blows = wind.norm_squared() > 0.0;
        let wind = if blows { format!(", wind ({x}, {y}, {z}) m/s") } else { String::new() };
        let bodies = counted(immersed.len(), "body", "bodies");
        format!("a fluid of {density} kg/m³ and {viscosity} Pa s{wind} resists {bodies}")
    });
    let carried = (!carried.is_empty())
        .then(|| format!("{} carried against gravity", counted(carried.len(), "body is", "bodies are")));
    let parts: Vec<String> = fluid.into_iter().chain(carried).collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}
