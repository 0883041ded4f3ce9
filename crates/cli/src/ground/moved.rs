//! The motion of `--consistent`: the root's path changed by as little as the ground asks for.

use super::predicted::{Ground, Standing};
use super::soles::From;
use crate::args::ConsistentArgs;
use crate::error::CliError;
use crate::given::Given;
use crate::words::{counted, row, short};
use serde::Serialize;
use solaris::analysis::ground::{
    Consistency, ConsistencyError, ConsistencyOptions, ConsistencyOutcome, GroundError, ShiftError,
    Violation, consistent_shift, shift_root,
};
use std::io::{Result, Write};

/// How it is to be done, where it is asked for.
fn asked(args: &ConsistentArgs) -> std::result::Result<Option<ConsistencyOptions>, CliError> {
    if !args.consistent {
        return Ok(None);
    }
    let default = ConsistencyOptions::default();
    match &args.consistent_limit {
        None => Ok(Some(default)),
        Some(limit) if limit.value > 0.0 => Ok(Some(ConsistencyOptions { limit: limit.value, ..default })),
        Some(limit) => {
            let why = "it must be more than 0 m, or inf for as far as it takes";
            Err(CliError::option("consistent-limit", &limit.typed, why))
        }
    }
}

impl Ground<'_> {
    /// Moves the root of the given motion where that is asked for; what was changed, and the stances that it was changed for.
    pub(crate) fn make_consistent(
        &self,
        args: &ConsistentArgs,
        given: &mut Given,
    ) -> std::result::Result<Option<(Moved, Standing)>, CliError> {
        let Some(options) = asked(args)? else { return Ok(None) };
        let prepared = given.prepared()?;
        let feet = self.feet(given, &prepared)?;
        let standing = self.standing(given, &feet, 0.0)?;
        let found = consistent_shift(&feet, &standing.stances, &options)
            .map_err(|error| self.too_bare(&error, given).unwrap_or_else(|| self.refused(&error, given)))?;
        shift_root(&given.body.figure, &mut given.found.motion, &found)
            .map_err(|error| held(&error, given))?;
        Ok(Some((Moved::new(&found, &options, given.motion().time()), standing)))
    }

    /// Why soles do not say enough for it.
    fn too_bare(&self, error: &GroundError, given: &Given) -> Option<CliError> {
        let why = match error {
            GroundError::NoBreadth { sole } => format!(
                "--consistent keeps the centre of pressure within the soles, and sole '{sole}' has no breadth; give it a \
                 width"
            ),
            GroundError::Consistency(ConsistencyError::Narrow { margin, .. }) => format!(
                "--consistent keeps the centre of pressure {} mm inside of the soles, and there are narrower ones; give \
                 them their width",
                short(margin * 1e3)
            ),
            _ => return None,
        };
        Some(match &self.from {
            From::File(path) => CliError::input(path, &why),
            _ => CliError::input(&given.of, &format!("{why}, in a file for --soles")),
        })
    }
}

/// Why a root cannot be moved.
fn held(error: &ShiftError, given: &Given) -> CliError {
    let ShiftError::NoSlides { joint } = error else { return CliError::input(&given.from, error) };
    let what_to_do = if given.body.figure.links()[0].joint().kind().nv() == 0 {
        "it is fixed: --base floating or --base free lets it go, and the motion then has the root's columns"
    } else {
        "write the figure as text (solaris convert), let that joint begin with tx, ty and tz, or be free, and give the \
         motion their columns"
    };
    let why = format!(
        "--consistent moves the root along three axes at right angles, and joint '{joint}' has not that freedom; \
         {what_to_do}"
    );
    CliError::input(&given.of, &why)
}

/// What was changed, as numbers.
#[derive(Serialize)]
pub(crate) struct Moved {
    /// Absent where there is none.
    limit_mm: Option<f64>,
    outcome: &'static str,
    /// How far beyond the limit it would have to go, and when; absent where the limit suffices.
    beyond_limit: Option<Peak>,
    rms_mm: f64,
    greatest: Peak,
    /// Along the world's axes.
    axes: [Along; 3],
    before: Violation,
    after: Violation,
    iterations: usize,
}

/// Of a way nobody sees less than a micrometre.
fn millimetres(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-3 {
        "less than 0.001 mm".to_owned()
    } else {
        format!("{} mm", short(value))
    }
}

/// The furthest of a way.
#[derive(Clone, Copy, Serialize)]
struct Peak {
    mm: f64,
    at_s: f64,
}

/// The change along one axis of the world.
#[derive(Serialize)]
struct Along {
    axis: &'static str,
    rms_mm: f64,
    /// With its sign.
    greatest: Peak,
}

impl Moved {
    pub(super) fn new(found: &Consistency, options: &ConsistencyOptions, time: &[f64]) -> Self {
        let (outcome, beyond_limit) = match found.outcome {
            ConsistencyOutcome::Reached => ("reached", None),
            ConsistencyOutcome::Short { frame, by } => {
                ("short", Some(Peak { mm: by * 1e3, at_s: time[frame] }))
            }
            _ => ("unsettled", None),
        };
        let peak = |value: &dyn Fn(usize) -> f64| {
            let mut greatest = Peak { mm: 0.0, at_s: time.first().copied().unwrap_or_default() };
            for (frame, &at_s) in time.iter().enumerate() {
                let mm = value(frame) * 1e3;
                if mm.abs() > greatest.mm.abs() {
                    greatest = Peak { mm, at_s };
                }
            }
            greatest
        };
        let axis = |k: usize| {
            let squares: f64 = found.shift.iter().map(|shift| shift[k] * shift[k]).sum();
            let rms_mm = (squares / found.shift.len() as f64).sqrt() * 1e3;
            Along { axis: ["x", "y", "z"][k], rms_mm, greatest: peak(&|frame| found.shift[frame][k]) }
        };
        Self {
            limit_mm: options.limit.is_finite().then_some(options.limit * 1e3),
            outcome,
            beyond_limit,
            rms_mm: found.rms * 1e3,
            greatest: peak(&|frame| found.shift[frame].norm()),
            axes: [0, 1, 2].map(axis),
            before: found.before,
            after: found.after,
            iterations: found.iterations,
        }
    }

    /// What was changed, for people.
    pub(super) fn write(&self, out: &mut dyn Write) -> Result<()> {
        row(out, "made consistent", &self.describe())?;
        if self.greatest.mm == 0.0 {
            return Ok(());
        }
        let line = |out: &mut dyn Write, what: &str, value: &str| writeln!(out, "    {what:<20}{value}");
        let moved = |rms: f64, Peak { mm, at_s }: Peak| {
            let greatest = format!("greatest {} at {} s", millimetres(mm), short(at_s));
            if mm == 0.0 { "0 mm".to_owned() } else { format!("{} rms, {greatest}", millimetres(rms)) }
        };
        line(out, "root moved", &moved(self.rms_mm, self.greatest))?;
        for Along { axis, rms_mm, greatest } in &self.axes {
            line(out, &format!("  along {axis}"), &moved(*rms_mm, *greatest))?;
        }
        line(out, "before", &impossible(self.before))?;
        line(out, "after", &impossible(self.after))
    }

    fn describe(&self) -> String {
        let (iterations, within) = (self.iterations, self.limit_mm.map(short));
        match (self.outcome, &self.beyond_limit, within) {
            ("reached", ..) if self.greatest.mm == 0.0 => {
                "nothing to change: every frame in which a foot stands is possible".to_owned()
            }
            ("reached", _, Some(within)) => {
                format!("every frame in which a foot stands is possible, within {within} mm")
            }
            ("reached", ..) => "every frame in which a foot stands is possible".to_owned(),
            (_, Some(Peak { mm, at_s }), Some(within)) => {
                let (by, at) = (short(*mm), short(*at_s));
                format!(
                    "stopped at {within} mm, which does not make every frame possible: that would take {by} mm more at {at} s"
                )
            }
            _ => format!("not settled after {iterations} iterations; frames may be impossible still"),
        }
    }

    /// What a person should look at.
    pub(super) fn doubts(&self) -> Vec<String> {
        match (&self.beyond_limit, self.outcome) {
            (Some(Peak { mm, at_s }), _) => {
                let (by, at) = (short(*mm), short(*at_s));
                let left = impossible(self.after);
                vec![format!(
                    "--consistent stopped at its limit and leaves {left}: the root would have to go {by} mm further at {at} s; \
                     look at stances and soles, or ask for more with --consistent-limit"
                )]
            }
            (None, "unsettled") => {
                let what = "the search for a consistent motion did not settle: the change is not the least, and may not do";
                vec![what.to_owned()]
            }
            _ => Vec::new(),
        }
    }
}

/// What the ground cannot do, in words.
fn impossible(Violation { frames, outside, pull }: Violation) -> String {
    if frames == 0 {
        return "no impossible frame".to_owned();
    }
    let mut what = Vec::new();
    if outside > 0.0 {
        what.push(format!("pressure {} mm outside of what stands", short(outside * 1e3)));
    }
    if pull > 0.0 {
        what.push(format!("a pull of {} N", short(pull)));
    }
    let frames = counted(frames, "impossible frame", "impossible frames");
    format!("{frames}: {}, at worst", what.join(", "))
}
