//! Joint moments of what was opened: what `solaris inverse` does while nobody says more.

use crate::error::FileError;
use crate::external::External;
use crate::forces::{Acting, JointForces, check_measured, joint_forces};
use crate::open::Opened;
use crate::plates::OwnPlates;
use crate::words::short;
use solaris_analysis::ground::{GroundOptions, PlacedFeet, Sole, ground_forces};
use solaris_analysis::plausibility::{check_angles, check_residual};
use solaris_analysis::{Filter, InverseReport, PreparedMotion, differentiate};
use solaris_model::{Ground, Motion};
use std::path::Path;

/// Where the forces of the ground come from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AskedGround {
    /// What was measured: a table of forces, or plates of the recording; without any there are none.
    #[default]
    Measured,
    /// They are found from the motion and the soles.
    Predicted,
    /// None act.
    None,
}

/// How joint moments are found.
#[derive(Clone, Debug)]
pub struct MomentOptions {
    /// What positions are filtered by before they are differentiated.
    pub filter: Option<Filter>,
    /// Where the forces of the ground come from.
    pub ground: AskedGround,
    /// Whether armature, damping, springs and friction of the joints, and a fluid around, count.
    pub passive: bool,
}

impl Default for MomentOptions {
    fn default() -> Self {
        Self { filter: None, ground: AskedGround::default(), passive: true }
    }
}

/// A motion with its joint moments.
#[derive(Clone, Debug)]
pub struct Moments {
    /// The motion: positions, velocities, accelerations, forces of every degree of freedom (`tau`), and what acts on links from outside.
    pub motion: Motion,
    /// The joints' forces one by one, and what is left over at a root that nothing holds.
    pub forces: InverseReport,
    /// The soles that stood on the ground, as far as they are known.
    pub soles: Vec<Sole>,
    /// The forces from outside, in a line.
    pub external: String,
    /// What there is to look at, a line each: what does not fit, what was left out, what is left over.
    pub findings: Vec<String>,
}

impl Opened {
    /// The joint moments of the motion that is open.
    ///
    /// # Errors
    ///
    /// No figure or no motion; feet that nobody knows, where the ground is predicted; what the analysis refuses.
    pub fn moments(&self, options: &MomentOptions) -> Result<Moments, FileError> {
        let nothing = |why: &str| FileError::input(Path::new("moments"), &why);
        let body = self.body.as_ref().filter(|_| !self.is_cloud);
        let body = body.ok_or_else(|| nothing("there is no figure; open one"))?;
        let opened =
            self.motion.as_ref().ok_or_else(|| nothing("there is no motion of the figure; open one"))?;
        let (path, figure) = (opened.path.as_path(), &body.figure);
        let refuse = |error: &dyn ToString| FileError::input(path, error);
        let found = differentiate(figure, &opened.motion, options.filter).map_err(|error| refuse(&error))?;
        let motion = &found.motion;
        let prepared = PreparedMotion::new(figure, motion).map_err(|error| refuse(&error))?;
        let soles = self.soles.as_ref().map(|(soles, _)| soles.clone());
        let mut findings: Vec<String> = body.doubts().map(ToString::to_string).collect();
        let in_degrees = opened.table.as_ref().and_then(|table| table.in_degrees);
        findings.extend(check_angles(figure, motion, in_degrees).map(|found| found.to_string()));
        let (mut measured, mut external, mut ground, mut level) = (Vec::new(), "none".to_owned(), None, None);
        match options.ground {
            AskedGround::None => {}
            AskedGround::Measured if !matches!(self.external, External::None) => {
                let records = self.external.records(figure);
                measured = records.map_err(|error| refuse(&error))?;
                external = self.external.describe();
                findings.extend(self.external.notes());
            }
            AskedGround::Measured => {
                let plates = self.recording.as_ref().map_or(&[][..], |recording| &recording.plates);
                let unknown =
                    "plates are there, and the feet on them are not known: open a text of soles with them";
                let own = if self.plates.is_empty() {
                    OwnPlates::of(plates, (motion, &prepared), soles.clone(), unknown)
                } else {
                    OwnPlates::of_records(&self.plates, &prepared, soles.clone(), unknown)
                };
                let own = own.map_err(|error| refuse(&error))?;
                if !own.words.is_empty() {
                    external = own.words.join("; ");
                }
                measured = own.forces;
            }
            AskedGround::Predicted => {
                let why = "nobody knows the figure's feet; open a text of soles with it";
                let soles = soles.clone().ok_or_else(|| refuse(&why))?;
                let feet = PlacedFeet::new(&prepared, soles).map_err(|error| refuse(&error))?;
                let forces =
                    ground_forces(&feet, &GroundOptions::default()).map_err(|error| refuse(&error))?;
                "the ground's, found from the motion".clone_into(&mut external);
                level = Some(forces.stances.level);
                ground = Some(forces.loads());
            }
        }
        let acting = Acting { measured: &measured, ground, medium: &body.medium, passive: options.passive };
        let JointForces { loads, forces, .. } =
            joint_forces(path, (figure, motion), &prepared, acting, None)?;
        let plates = check_measured(figure, &prepared, soles.clone(), &measured, true)
            .map_err(|error| refuse(&error))?;
        let mut residual = None;
        if let Some(plates) = &plates {
            level = level.or(Some(plates.level));
            findings.extend(plates.findings.iter().map(ToString::to_string));
            if figure.root_is_free() {
                residual = check_residual(&prepared, &forces, &measured, plates.level, found.unsettled)
                    .map_err(|error| refuse(&error))?;
            }
        }
        if figure.root_is_free() {
            let left = &forces.residual;
            let cause = residual.map_or_else(String::new, |checked| format!("; {}", checked.cause()));
            findings.push(format!(
                "left over at the root: at most {} N at {} s and {} N m at {} s{cause}",
                short(left.force),
                short(left.force_time),
                short(left.moment),
                short(left.moment_time)
            ));
        }
        let mut motion = motion.clone();
        motion.contacts = loads.contacts(figure);
        motion.info.ground = level.map(|height| Ground { height, friction: None });
        motion.set_tau(forces.tau.clone()).map_err(|error| refuse(&error))?;
        Ok(Moments { motion, forces, soles: soles.unwrap_or_default(), external, findings })
    }
}
