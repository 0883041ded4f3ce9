//! The curve that is asked for.

use super::feasible::Feasible;
use super::refused::{of_blend, of_kind};
use super::written;
use crate::args::{BlendArgs, CurveArgs, KeySource, KindArgs, ReadArgs, amplitude, option};
use crate::error::{CliError, UsageError};
use crate::input;
use solaris::profiles::blend::{Fade, Leaving};
use solaris::profiles::{Parameter, Profile, ProfileCurve, ProfileError};
use std::path::PathBuf;

/// Stiffness of a fade when none is given.
const STIFFNESS: f64 = 1.0;

/// A curve that is asked for.
pub(super) struct Request<'a> {
    pub(super) profile: Profile,
    pub(super) free: Vec<&'static Parameter>,
    /// Whether all of its parameters have values; else only what the free ones may be can be said.
    pub(super) is_complete: bool,
    /// The file that it is read from.
    pub(super) reads: Option<PathBuf>,
    from: Source<'a>,
}

/// Who says what the curve is.
enum Source<'a> {
    Kind(&'a KindArgs),
    Blend(&'a BlendArgs),
    /// A text, and its name.
    Text(PathBuf, String),
}

impl<'a> Request<'a> {
    pub(super) fn of_kind(args: &'a KindArgs) -> Result<Self, CliError> {
        let kind = args.kind;
        let free = free(&args.curve, &kind.parameters().collect::<Vec<_>>())?;
        let (keys, reads) = keys(args)?;
        let given = |parameter: &Parameter| args.value(parameter.name).map(|number| number.value);
        // A free parameter without a value is not looked at.
        let stands_in = |parameter: &Parameter| {
            free.iter().any(|free| free.name == parameter.name)
                || (args.to.is_some()
                    && amplitude(kind).is_some_and(|follows| follows.name == parameter.name))
        };
        let value = |parameter: &Parameter| given(parameter).or(stands_in(parameter).then_some(0.0));
        let missing = kind.required.iter().filter(|parameter| value(parameter).is_none());
        let options: Vec<String> = missing.map(|parameter| format!("--{}", option(parameter))).collect();
        if !options.is_empty() {
            return Err(UsageError::Missing { options }.into());
        }
        let refuse = |error: ProfileError| of_kind(&error, args);
        let mut profile = kind.profile(value, keys).map_err(refuse)?;
        if let Some(to) = &args.to {
            profile = profile.reach(to.value).map_err(refuse)?;
        }
        let is_complete = free.iter().all(|parameter| given(parameter).is_some());
        Ok(Self { profile, free, is_complete, reads, from: Source::Kind(args) })
    }

    pub(super) fn of_file(args: &ReadArgs) -> Result<Self, CliError> {
        let path = &args.file;
        let text = input::text(path)?;
        let profile = written::read(path, &text)?;
        let parameters: Vec<&'static Parameter> = profile.values().into_iter().map(|(p, _)| p).collect();
        let free = free(&args.curve, &parameters)?;
        let (reads, from) = (Some(path.clone()), Source::Text(path.clone(), text));
        Ok(Self { profile, free, is_complete: true, reads, from })
    }

    pub(super) fn of_blend(args: &'a BlendArgs) -> Result<Self, CliError> {
        let [first, second] = &args.curves[..] else {
            return Err(UsageError::Curves { found: args.curves.len() }.into());
        };
        // Unless asked for, no stiffness that makes a fade leave 0 to 1.
        let most = args.fade.kind(STIFFNESS).largest_stiffness_within().min(STIFFNESS);
        let stiffness = args.stiffness.as_ref().map_or(most, |stiffness| stiffness.value);
        let fade = Fade::new(args.fade.kind(stiffness), args.window.start, args.window.end);
        let profile = Profile::Blend {
            first: Box::new(written::read_layer(first)?),
            second: Box::new(written::read_layer(second)?),
            fade: fade.map_err(|error| of_blend(&error, args))?,
            leaving: args.leaving.map_or(Leaving::Refuse, Leaving::from),
        };
        let free = free(&args.curve, &[])?;
        Ok(Self { profile, free, is_complete: true, reads: None, from: Source::Blend(args) })
    }

    pub(super) fn curve(&self) -> Result<ProfileCurve, CliError> {
        self.profile.curve().map_err(|error| self.refuse(&error))
    }

    /// What the free parameters may be.
    pub(super) fn feasible(&self) -> Result<Vec<Feasible>, CliError> {
        let one = |&parameter: &&'static Parameter| {
            let ranges = self.profile.feasible(parameter).map_err(|error| self.refuse(&error))?;
            Ok(Feasible { parameter, ranges })
        };
        self.free.iter().map(one).collect()
    }

    /// Why there is no such curve: said of the place in the text, or of the option.
    pub(super) fn refuse(&self, error: &ProfileError) -> CliError {
        match &self.from {
            Source::Kind(args) => of_kind(error, args),
            Source::Blend(args) => of_blend(error, args),
            Source::Text(path, text) => written::refuse(path, text, error),
        }
    }
}

/// The parameters that are to be free, by symbol or name.
fn free(args: &CurveArgs, known: &[&'static Parameter]) -> Result<Vec<&'static Parameter>, CliError> {
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
            CliError::option("free", name, why)
        })
    };
    args.free.iter().map(find).collect()
}

/// Keys, and the file that they are from.
type Sourced = (Vec<(f64, f64)>, Option<PathBuf>);

/// The keys of a kind that has keys.
fn keys(args: &KindArgs) -> Result<Sourced, CliError> {
    match args.keys.as_ref().map(|keys| &keys.source) {
        Some(KeySource::Given(keys)) => Ok((keys.clone(), None)),
        Some(KeySource::File(path)) => {
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
