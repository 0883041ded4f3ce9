//! Which curve is asked for.

use super::feasible::Feasible;
use super::written;
use crate::args::{FADES, Keys, LEAVING, amplitude, option};
use crate::error::CliError;
use crate::input;
use clap::ArgMatches;
use solaris::profiles::blend::Fade;
use solaris::profiles::{Kind, Parameter, Profile, ProfileCurve, ProfileError};
use std::path::PathBuf;

/// Stiffness of a fade when none is given.
const STIFFNESS: f64 = 1.0;

/// A curve that is asked for.
pub(super) struct Request {
    pub(super) profile: Profile,
    pub(super) free: Vec<&'static Parameter>,
    /// Whether all of its parameters have values; else only what the free ones may be can be said.
    pub(super) is_complete: bool,
    /// The file that it is read from.
    pub(super) reads: Option<PathBuf>,
    /// The text that it is read from, and its name.
    text: Option<(PathBuf, String)>,
}

impl Request {
    pub(super) fn of(name: &str, matches: &ArgMatches) -> Result<Self, CliError> {
        match Kind::named(name) {
            Some(kind) => Self::of_kind(kind, matches),
            None if name == "read" => Self::of_file(matches),
            None => Self::of_blend(matches),
        }
    }

    fn of_kind(kind: &'static Kind, matches: &ArgMatches) -> Result<Self, CliError> {
        let free = free(matches, &kind.parameters().collect::<Vec<_>>())?;
        let (keys, reads) = keys(kind, matches)?;
        let given = |parameter: &Parameter| matches.get_one::<f64>(&option(parameter)).copied();
        let to = amplitude(kind).and_then(|_| matches.get_one::<f64>("to").copied());
        // A free parameter without a value is not looked at.
        let stands_in = |parameter: &Parameter| {
            free.iter().any(|free| free.name == parameter.name)
                || (to.is_some() && amplitude(kind).is_some_and(|follows| follows.name == parameter.name))
        };
        let value = |parameter: &Parameter| given(parameter).or(stands_in(parameter).then_some(0.0));
        let missing = kind.required.iter().filter(|parameter| value(parameter).is_none());
        let missing: Vec<String> = missing.map(|parameter| format!("\n  --{}", option(parameter))).collect();
        if !missing.is_empty() {
            let missing = missing.concat();
            let why = format!("the following required arguments were not provided:{missing}");
            return Err(CliError::Usage(why));
        }
        let refuse = |error: ProfileError| CliError::of_profile(&error, matches);
        let mut profile = kind.profile(value, keys).map_err(refuse)?;
        if let Some(to) = to {
            profile = profile.reach(to).map_err(refuse)?;
        }
        let is_complete = free.iter().all(|parameter| given(parameter).is_some());
        Ok(Self { profile, free, is_complete, reads, text: None })
    }

    fn of_file(matches: &ArgMatches) -> Result<Self, CliError> {
        let path = matches.get_one::<PathBuf>("file").cloned().unwrap_or_default();
        let text = input::text(&path)?;
        let profile = written::read(&path, &text)?;
        let parameters: Vec<&'static Parameter> = profile.values().into_iter().map(|(p, _)| p).collect();
        let free = free(matches, &parameters)?;
        let reads = Some(path.clone());
        Ok(Self { profile, free, is_complete: true, reads, text: Some((path, text)) })
    }

    fn of_blend(matches: &ArgMatches) -> Result<Self, CliError> {
        let texts: Vec<&String> = matches.get_many("curve").unwrap_or_default().collect();
        let [first, second] = texts[..] else {
            let why = format!("--curve is given {} times; a blend has two curves", texts.len());
            return Err(CliError::Usage(why));
        };
        let refuse = |error: ProfileError| CliError::of_profile(&error, matches);
        let fade = matches.get_one::<String>("fade").map_or("", String::as_str);
        // Unless asked for, no stiffness that makes a fade leave 0 to 1.
        let most = FADES
            .iter()
            .find(|(name, _)| *name == fade)
            .map_or(STIFFNESS, |(_, make)| make(STIFFNESS).largest_stiffness_within().min(STIFFNESS));
        let stiffness = matches.get_one::<f64>("stiffness").copied().unwrap_or(most);
        let &(start, end) = matches.get_one::<(f64, f64)>("window").unwrap_or(&(0.0, 0.0));
        let kind = FADES.iter().find(|(name, _)| *name == fade).unwrap_or(&FADES[0]).1(stiffness);
        let leaving = matches.get_one::<String>("leaving").map_or("", String::as_str);
        let leaving = LEAVING.iter().find(|(name, _)| *name == leaving).unwrap_or(&LEAVING[0]).1;
        let profile = Profile::Blend {
            first: Box::new(written::read_layer(first)?),
            second: Box::new(written::read_layer(second)?),
            fade: Fade::new(kind, start, end).map_err(refuse)?,
            leaving,
        };
        let free = free(matches, &[])?;
        Ok(Self { profile, free, is_complete: true, reads: None, text: None })
    }

    pub(super) fn curve(&self, matches: &ArgMatches) -> Result<ProfileCurve, CliError> {
        self.profile.curve().map_err(|error| self.refuse(&error, matches))
    }

    /// What the free parameters may be.
    pub(super) fn feasible(&self, matches: &ArgMatches) -> Result<Vec<Feasible>, CliError> {
        let one = |&parameter: &&'static Parameter| {
            let ranges = self.profile.feasible(parameter).map_err(|error| self.refuse(&error, matches))?;
            Ok(Feasible { parameter, ranges })
        };
        self.free.iter().map(one).collect()
    }

    /// Why there is no such curve: said of the place in the text, or of the option.
    pub(super) fn refuse(&self, error: &ProfileError, matches: &ArgMatches) -> CliError {
        match &self.text {
            Some((path, text)) => written::refuse(path, text, error),
            None => CliError::of_profile(error, matches),
        }
    }
}

/// The parameters that are to be free, by symbol or name.
fn free(matches: &ArgMatches, known: &[&'static Parameter]) -> Result<Vec<&'static Parameter>, CliError> {
    let asked = matches.get_many::<String>("free").unwrap_or_default();
    let find = |name: &String| {
        let said = name.trim_start_matches('-').replace(['-', '_'], " ");
        let found = known.iter().find(|parameter| parameter.symbol == *name || parameter.name == said);
        found.copied().ok_or_else(|| {
            let symbols: Vec<&str> = known.iter().map(|parameter| parameter.symbol).collect();
            let why = if symbols.is_empty() {
                "this profile has no parameter that may be free".to_owned()
            } else {
                format!("there is no such parameter; there are {}", symbols.join(", "))
            };
            CliError::Option { option: "free".to_owned(), value: name.clone(), why }
        })
    };
    asked.map(find).collect()
}

/// Keys, and the file that they are from.
type Source = (Vec<(f64, f64)>, Option<PathBuf>);

/// The keys of a kind that has keys.
fn keys(kind: &Kind, matches: &ArgMatches) -> Result<Source, CliError> {
    if !kind.has_keys() {
        return Ok((Vec::new(), None));
    }
    match matches.get_one::<Keys>("keys") {
        Some(Keys::Given(keys)) => Ok((keys.clone(), None)),
        Some(Keys::File(path)) => {
            let text = input::text(path)?;
            let first = text.lines().next().unwrap_or_default();
            if first.split(',').all(|field| field.trim().parse::<f64>().is_ok()) {
                let why = "line 1 has numbers; the first line must name the columns, such as: time,position";
                return Err(CliError::input(path, &why));
            }
            let table = input::table(path)?;
            let count = table.columns.len();
            if count != 2 {
                let why = format!("it has {count} columns; keys have two, times and positions");
                return Err(CliError::input(path, &why));
            }
            let keys = table.values.chunks_exact(2).map(|row| (row[0], row[1])).collect();
            Ok((keys, Some(path.clone())))
        }
        None => Ok((Vec::new(), None)),
    }
}
