//! The ground's forces of a motion that was given, as the options ask for them.

use super::moved::{self, Moved};
use super::soles::{self, From};
use crate::args::{AskedBelt, ConsistentArgs, FrameArgs, GroundArgs, Number};
use crate::error::CliError;
use crate::findings::of_medium;
use crate::given::Given;
use solaris::analysis::ground::{
    Belt, GroundError, GroundForces, GroundOption, GroundOptions, Sole, StanceOptions, Stances, find_stances,
    ground_forces, make_consistent,
};
use solaris::model::{Finding, FindingKind};

/// What is asked of the ground, and of the figure's frame.
#[derive(Clone, Copy)]
pub(crate) struct Ground<'a> {
    pub(crate) how: &'a GroundArgs,
    pub(crate) frame: &'a FrameArgs,
}

/// The ground's forces, and what they are found from.
pub(crate) struct Predicted {
    pub(super) soles: Vec<Sole>,
    pub(super) from: From,
    /// How the ground's own motion is known.
    pub(super) belt_from: &'static str,
    /// What was changed of the motion, where that was asked for.
    pub(super) moved: Option<Moved>,
    pub(crate) forces: GroundForces,
}

impl Predicted {
    /// Finds them; with `--consistent` in a motion whose root is moved before.
    pub(crate) fn find(
        asked: Ground<'_>,
        consistent: &ConsistentArgs,
        given: &mut Given,
    ) -> Result<Self, CliError> {
        needs_times(given)?;
        let unasked = of_medium(&given.body.medium, FindingKind::Missing);
        given.body.findings.extend(
            unasked.map(|finding| Finding {
                message: "what resists or carries bodies is not counted where the ground's forces are found"
                    .to_owned(),
                ..finding
            }),
        );
        let consistent = moved::asked(consistent)?;
        let (soles, from) = soles::find(asked.how.soles.as_deref(), given)?;
        let (stances, stance, belt_from) = standing(asked, given, &soles, &from, 0.0)?;
        let mut moved = None;
        if let Some(options) = consistent {
            let (figure, motion) = (&given.body.figure, &mut given.found.motion);
            let found = make_consistent(figure, motion, &soles, &stances, &options);
            let found = found.map_err(|error| {
                moved::refused(&error, given, &from).unwrap_or_else(|| refused(&error, asked, given, &from))
            })?;
            moved = Some(Moved::new(&found, &options, given.motion().time()));
        }
        let options =
            GroundOptions { split: asked.how.split.unwrap_or_default(), stance, stances: Some(stances) };
        let forces = ground_forces(&given.prepared()?, &soles, &options)
            .map_err(|error| refused(&error, asked, given, &from))?;
        Ok(Self { soles, from, belt_from, moved, forces })
    }
}

/// Refuses a motion without times.
pub(crate) fn needs_times(given: &Given) -> Result<(), CliError> {
    if given.table.column("time").is_none() {
        let why = "it has no column 'time', and which foot stands is found from how the feet move";
        return Err(CliError::input(&given.from, &why));
    }
    Ok(())
}

/// When which of the soles stands, as the options ask, what counts as standing, and how the ground's own motion is known.
/// Where nobody says how the ground moves, a belt that is slower than `least` (m/s) is none.
pub(crate) fn standing(
    asked: Ground<'_>,
    given: &Given,
    soles: &[Sole],
    from: &From,
    least: f64,
) -> Result<(Stances, StanceOptions, &'static str), CliError> {
    let default = StanceOptions::default();
    let or = |number: &Option<Number>, default| number.as_ref().map_or(default, |number| number.value);
    let mut stance = StanceOptions {
        height: or(&asked.how.stance_height, default.height),
        speed: or(&asked.how.stance_speed, default.speed),
        shortest: or(&asked.how.stance_shortest, default.shortest),
        belt: Belt::Auto,
    };
    let prepared = given.prepared()?;
    let find = |stance: &StanceOptions| {
        find_stances(&prepared, soles, stance).map_err(|error| refused(&error, asked, given, from))
    };
    let belt_from = match &asked.how.belt {
        Some(AskedBelt::Auto) => "as the feet on it move",
        None if least <= 0.0 => "as the feet on it move",
        None => {
            let found = find(&stance)?;
            if found.belt.norm() >= least {
                return Ok((found, stance, "as the feet on it move"));
            }
            stance.belt = Belt::Still;
            "since no foot on it is too fast to stand"
        }
        Some(AskedBelt::Still) => {
            stance.belt = Belt::Still;
            "as asked"
        }
        Some(AskedBelt::Speed(speed)) => {
            let along = find(&stance)?.belt.try_normalize(0.0).ok_or_else(|| no_belt(speed))?;
            stance.belt = Belt::Speed(along * speed.value);
            "as fast as asked, along the feet on it"
        }
    };
    Ok((find(&stance)?, stance, belt_from))
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

/// The option or the file that is at fault.
pub(crate) fn refused(error: &GroundError, asked: Ground<'_>, given: &Given, soles: &From) -> CliError {
    if let Some((option, value, why)) = at_fault(error, asked) {
        return CliError::option(option, value, why);
    }
    let path = match (error, soles) {
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
fn at_fault(
    error: &GroundError,
    Ground { how, frame }: Ground<'_>,
) -> Option<(&'static str, String, String)> {
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
        GroundError::TooManyFeet { .. } => Some(("split", how.split?.name().to_owned(), error.to_string())),
        GroundError::NoGravity { .. } => {
            Some(("gravity", frame.gravity.as_ref()?.typed.clone(), error.to_string()))
        }
        _ => None,
    }
}
