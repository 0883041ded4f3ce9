//! The ground's forces of a motion that was given, as the options ask for them.

use super::moved::{self, Moved};
use super::soles::{self, From};
use crate::args::AskedBelt;
use crate::error::{CliError, typed};
use crate::given::Given;
use clap::ArgMatches;
use solaris::analysis::ground::{
    Belt, GroundError, GroundForces, GroundOption, GroundOptions, Sole, Split, StanceOptions, Stances,
    find_stances, ground_forces, make_consistent,
};

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
    pub(crate) fn find(matches: &ArgMatches, given: &mut Given) -> Result<Self, CliError> {
        needs_times(given)?;
        let consistent = moved::asked(matches)?;
        let (soles, from) = soles::find(matches, given)?;
        let (stances, stance, belt_from) = standing(matches, given, &soles, &from, 0.0)?;
        let split = matches.get_one::<String>("split").and_then(|name| Split::named(name));
        let mut moved = None;
        if let Some(options) = consistent {
            let (figure, motion) = (&given.body.figure, &mut given.found.motion);
            let found = make_consistent(figure, motion, &soles, &stances, &options);
            let found = found.map_err(|error| {
                moved::refused(&error, given, &from).unwrap_or_else(|| refused(&error, matches, given, &from))
            })?;
            moved = Some(Moved::new(&found, &options, given.motion().time()));
        }
        let options = GroundOptions { split: split.unwrap_or_default(), stance, stances: Some(stances) };
        let forces = ground_forces(&given.prepared()?, &soles, &options)
            .map_err(|error| refused(&error, matches, given, &from))?;
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
    matches: &ArgMatches,
    given: &Given,
    soles: &[Sole],
    from: &From,
    least: f64,
) -> Result<(Stances, StanceOptions, &'static str), CliError> {
    let default = StanceOptions::default();
    let number = |option: &str, default| matches.get_one::<f64>(option).copied().unwrap_or(default);
    let mut stance = StanceOptions {
        height: number("stance-height", default.height),
        speed: number("stance-speed", default.speed),
        shortest: number("stance-shortest", default.shortest),
        belt: Belt::Auto,
    };
    let prepared = given.prepared()?;
    let find = |stance: &StanceOptions| {
        find_stances(&prepared, soles, stance).map_err(|error| refused(&error, matches, given, from))
    };
    let belt_from = match matches.get_one("belt") {
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
            let along = find(&stance)?.belt.try_normalize(0.0).ok_or_else(|| no_belt(matches))?;
            stance.belt = Belt::Speed(along * *speed);
            "as fast as asked, along the feet on it"
        }
    };
    Ok((find(&stance)?, stance, belt_from))
}

/// A belt where there is none.
fn no_belt(matches: &ArgMatches) -> CliError {
    let why = format!(
        "the feet do not move with a belt: where they are down they are slower than {} m/s, and nothing says which way it \
         would run; leave --belt out",
        Belt::LEAST
    );
    CliError::Option { option: "belt".to_owned(), value: typed(matches, "belt").unwrap_or_default(), why }
}

/// The option or the file that is at fault.
pub(crate) fn refused(error: &GroundError, matches: &ArgMatches, given: &Given, soles: &From) -> CliError {
    let of_option = |option: &str, why: String| {
        let value = typed(matches, option)?;
        Some(CliError::Option { option: option.to_owned(), value, why })
    };
    let (option, why) = match error {
        GroundError::Option { option, range, .. } => {
            let option = match option {
                GroundOption::Height => "stance-height",
                GroundOption::Speed => "stance-speed",
                GroundOption::Shortest => "stance-shortest",
                GroundOption::Belt => "belt",
                // Nobody types it.
                _ => "",
            };
            (option, format!("it must be {range}"))
        }
        GroundError::TooManyFeet { .. } => ("split", error.to_string()),
        GroundError::NoGravity { .. } => ("gravity", error.to_string()),
        _ => ("", String::new()),
    };
    if let Some(error) = of_option(option, why) {
        return error;
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
