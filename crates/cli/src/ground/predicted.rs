//! The ground's forces of a motion that was given, as the options ask for them.

use super::moved::Moved;
use super::soles::{self, From};
use super::told;
use crate::args::{AskedBelt, FrameArgs, GroundArgs, Number};
use crate::error::CliError;
use crate::findings::of_medium;
use crate::given::Given;
use solaris::analysis::PreparedMotion;
use solaris::analysis::ground::{
    Belt, GroundError, GroundForces, GroundOption, GroundOptions, PlacedFeet, Sole, StanceOptions, Stances,
    find_stances, ground_forces,
};
use solaris::model::{Finding, FindingKind};
use std::path::Path;

/// What is asked of the ground, and of the figure's frame, for these soles.
pub(crate) struct Ground<'a> {
    pub(crate) how: &'a GroundArgs,
    pub(crate) frame: &'a FrameArgs,
    /// A file that says when they stand.
    pub(crate) told: Option<&'a Path>,
    pub(crate) soles: Vec<Sole>,
    pub(crate) from: From,
}

/// When feet stand, as the options ask.
pub(crate) struct Standing {
    pub(crate) stances: Stances,
    /// How the ground's own motion is known.
    pub(crate) belt_from: &'static str,
}

/// The ground's forces, and what they are found from.
pub(crate) struct Predicted {
    pub(crate) soles: Vec<Sole>,
    pub(super) from: From,
    /// How the ground's own motion is known.
    pub(super) belt_from: &'static str,
    /// What was changed of the motion, where that was asked for.
    pub(super) moved: Option<Moved>,
    pub(crate) forces: GroundForces,
}

/// Says that what resists or carries the figure's bodies is not counted.
pub(crate) fn say_medium(given: &mut Given) {
    let uncounted = of_medium(&given.body.medium, FindingKind::Missing);
    given.body.findings.extend(uncounted.map(|finding| Finding {
        message:
            "what resists or carries bodies is not counted where the ground's forces are found".to_owned(),
        ..finding
    }));
}

/// Refuses a motion without times.
pub(crate) fn needs_times(given: &Given) -> Result<(), CliError> {
    if given.table.column("time").is_none() {
        let why = "it has no column 'time', and which foot stands is found from how the feet move";
        return Err(CliError::input(&given.from, &why));
    }
    Ok(())
}

impl<'a> Ground<'a> {
    /// For the soles of a figure that has to have some, in a motion that has to have times.
    pub(crate) fn new(
        how: &'a GroundArgs,
        frame: &'a FrameArgs,
        told: Option<&'a Path>,
        given: &Given,
    ) -> Result<Self, CliError> {
        needs_times(given)?;
        let (soles, from) = soles::find(how.soles.as_deref(), given)?;
        Ok(Self { how, frame, told, soles, from })
    }

    /// The feet in a motion of the figure.
    pub(crate) fn feet<'m>(
        &self,
        given: &Given,
        prepared: &'m PreparedMotion<'m>,
    ) -> Result<PlacedFeet<'m>, CliError> {
        PlacedFeet::new(prepared, &*self.soles).map_err(|error| self.refused(&error, given))
    }

    /// The forces under the feet of a motion, which may have been moved for them before.
    pub(crate) fn predict(
        self,
        given: &Given,
        prepared: &PreparedMotion<'_>,
        moved: Option<(Moved, Standing)>,
    ) -> Result<Predicted, CliError> {
        let feet = self.feet(given, prepared)?;
        let (moved, standing) = match moved {
            Some((moved, standing)) => (Some(moved), standing),
            None => (None, self.standing(given, &feet, 0.0)?),
        };
        let forces = self.forces(given, &feet, standing.stances)?;
        Ok(Predicted { soles: self.soles, from: self.from, belt_from: standing.belt_from, moved, forces })
    }

    /// The forces under these feet while they stand.
    pub(crate) fn forces(
        &self,
        given: &Given,
        feet: &PlacedFeet<'_>,
        stances: Stances,
    ) -> Result<GroundForces, CliError> {
        let split = self.how.split.unwrap_or_default();
        let options = GroundOptions { split, stances: Some(stances), ..GroundOptions::default() };
        ground_forces(feet, &options).map_err(|error| self.refused(&error, given))
    }

    /// When which of the feet stands. Where nobody says how the ground moves, a belt that is slower than `least` (m/s) is none.
    pub(crate) fn standing(
        &self,
        given: &Given,
        feet: &PlacedFeet<'_>,
        least: f64,
    ) -> Result<Standing, CliError> {
        let asked = |number: &Option<Number>| number.as_ref().map(|number| number.value);
        let mut options = StanceOptions {
            height: asked(&self.how.stance_height),
            speed: asked(&self.how.stance_speed),
            shortest: asked(&self.how.stance_shortest).unwrap_or(StanceOptions::default().shortest),
            belt: Belt::Auto,
        };
        let find = |options: &StanceOptions| {
            find_stances(feet, options).map_err(|error| self.refused(&error, given))
        };
        let belt_from = match &self.how.belt {
            Some(AskedBelt::Auto) => "as the feet on it move",
            None if least <= 0.0 => "as the feet on it move",
            None => {
                let stances = find(&options)?;
                if stances.belt.norm() >= least {
                    return Ok(Standing { stances, belt_from: "as the feet on it move" });
                }
                options.belt = Belt::Still;
                "since no foot on it is too fast to stand"
            }
            Some(AskedBelt::Still) => {
                options.belt = Belt::Still;
                "as asked"
            }
            Some(AskedBelt::Speed(speed)) => {
                let along = find(&options)?.belt.try_normalize(0.0).ok_or_else(|| no_belt(speed))?;
                options.belt = Belt::Speed(along * speed.value);
                "as fast as asked, along the feet on it"
            }
        };
        let mut stances = find(&options)?;
        if let Some(path) = self.told {
            stances.list = told::read(path, &self.soles)?;
            stances.footings = feet.footings(&stances.list, &stances.belt);
            stances.method = "the file of --stances";
        }
        Ok(Standing { stances, belt_from })
    }

    /// The option or the file that is at fault.
    pub(super) fn refused(&self, error: &GroundError, given: &Given) -> CliError {
        if let Some((option, value, why)) = self.at_fault(error) {
            return CliError::option(option, value, why);
        }
        let path = match (error, &self.from) {
            (GroundError::Sole { .. }, From::File(path)) => path,
            (
                GroundError::Sole { .. }
                | GroundError::NoMass { .. }
                | GroundError::NoGravity { .. }
                | GroundError::Tree(_),
                _,
            ) => &given.of,
            _ => &given.from,
        };
        CliError::input(path, error)
    }

    /// The option that was given and is at fault, its value, and what is wrong with it.
    fn at_fault(&self, error: &GroundError) -> Option<(&'static str, String, String)> {
        let Self { how, frame, .. } = self;
        match error {
            GroundError::Option { option, range, .. } => {
                let why = format!("it must be {range}");
                let (name, number) = match option {
                    GroundOption::Height => ("stance-height", &how.stance_height),
                    GroundOption::Speed => ("stance-speed", &how.stance_speed),
                    GroundOption::Shortest => ("stance-shortest", &how.stance_shortest),
                    GroundOption::Belt => return Some(("belt", how.belt.as_ref()?.typed().to_owned(), why)),
                    // Nobody types it.
                    _ => return None,
                };
                Some((name, number.as_ref()?.typed.clone(), why))
            }
            GroundError::TooManyFeet { .. } => {
                Some(("split", how.split?.name().to_owned(), error.to_string()))
            }
            GroundError::NoGravity { .. } => {
                Some(("gravity", frame.gravity.as_ref()?.typed.clone(), error.to_string()))
            }
            _ => None,
        }
    }
}

/// A belt where there is none.
fn no_belt(speed: &Number) -> CliError {
    let why = format!(
        "the feet do not move with a belt: where they are down they are slower than {} m/s, and nothing says which way it \
         would run; leave --belt out",
        Belt::LEAST
    );
    CliError::option("belt", &speed.typed, why)
}
