//! The commands, and what each of them is asked: one struct a command, parsed once, here.

mod chair;
mod crowd;
mod figure;
mod gait;
mod given;
mod ground;
mod ik;
mod inverse;
mod markers;
mod metrics;
mod parameters;
mod profile;
mod program;
mod report;
mod retarget;
mod rig;
mod run;
mod studio;
mod subject;
mod sweep;
mod value;
mod walk;

pub(crate) use chair::ChairArgs;
pub(crate) use crowd::{CrowdArgs, CrowdFormat, MOST_IN_ONE, PLACES};
pub(crate) use figure::{BonesArgs, CheckArgs, ConvertArgs, FigureCommand, HumanArgs, UpArg};
pub(crate) use gait::{
    ExplainArgs, GaitCommand, MapArgs, PeopleArgs, PosturesArgs, SetArgs, TableArgs, TableFormat, Whose,
};
pub(crate) use given::{FrameArgs, RecordArgs, Span};
pub(crate) use ground::{AskedBelt, AskedPlate, ConsistentArgs, GroundArgs, GroundCommandArgs};
pub(crate) use ik::IkArgs;
pub(crate) use inverse::{InverseArgs, Switch};
pub(crate) use markers::MarkerArgs;
pub(crate) use metrics::{AskedLevel, MetricsArgs, StancesFrom};
pub(crate) use parameters::key_options;
pub(crate) use profile::{
    BlendArgs, CurveArgs, KeySource, KindArgs, KindCommand, ListArgs, ProfileCommand, ReadArgs, amplitude,
    example, option,
};
pub(crate) use program::{CompletionsArgs, DoctorArgs, ManArgs};
pub(crate) use report::ReportArgs;
pub(crate) use retarget::RetargetArgs;
pub(crate) use rig::{AskedRig, RigArgs};
pub(crate) use run::RunArgs;
pub(crate) use studio::StudioArgs;
pub(crate) use subject::{ScaleArgs, SubjectArgs};
pub(crate) use sweep::{SweepArgs, columns, walk_options};
pub(crate) use value::{Number, ValueError};
pub(crate) use walk::{
    DeterminantCount, DoubleSupportLaw, EveryoneArgs, FilmArgs, Gait, InBetweens, Loop, MotionFiles,
    PaceArgs, PersonArgs, RootLink, RunBound, Side, StyleName, TerrainArgs, Then, WalkArgs, WhoArgs,
};

use clap::{Args, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::ffi::OsString;

/// Height of the person when none is given (m).
pub(crate) const HEIGHT: f64 = 1.75;
/// Mass over the squared height when no mass is given (kg/m²).
pub(crate) const BODY_MASS_INDEX: f64 = 23.8;
/// Heights of people (m), as the library takes them.
pub(crate) const HEIGHTS: (f64, f64) = (0.8, 2.3);
/// Masses of people over their squared heights (kg/m²), as the library takes them.
pub(crate) const BODY_MASS_INDICES: (f64, f64) = (8.0, 80.0);
/// Number of steps when neither steps nor a distance are given.
pub(crate) const DEFAULT_STEPS: usize = 10;
/// Samples a second of the motion (1/s): default and range.
pub(crate) const RATE: (f64, f64, f64) = (120.0, 10.0, 1000.0);

const EXAMPLES: &str = "Examples:
  solaris walk --height 1.75 --mass 73 --step-frequency 110 --steps 10 -o walk.html
  solaris run scene.ron -o motion.html
  solaris inverse subject.osim walk.mot --external grf.mot --plate calcn_r= --plate calcn_l=1_ -o moments.sto
  solaris check robot.urdf
  solaris profile minimum-jerk --from 0 --to 1.2 --duration 2 -o curve.svg";

/// What is typed.
#[derive(Debug, Parser)]
#[command(
    name = "solaris",
    version,
    about = "Motion of articulated figures that obeys physics",
    long_about = None,
    after_help = EXAMPLES
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Walk(Box<WalkArgs>),
    Chair(Box<ChairArgs>),
    Sweep(SweepArgs),
    Crowd(CrowdArgs),
    Run(RunArgs),
    Inverse(Box<InverseArgs>),
    Ik(Box<IkArgs>),
    Scale(Box<ScaleArgs>),
    Ground(Box<GroundCommandArgs>),
    Metrics(Box<MetricsArgs>),
    #[command(subcommand)]
    Figure(FigureCommand),
    Check(CheckArgs),
    Convert(ConvertArgs),
    Retarget(Box<RetargetArgs>),
    #[command(subcommand)]
    Gait(GaitCommand),
    #[command(subcommand)]
    Profile(Box<ProfileCommand>),
    Report(ReportArgs),
    Studio(StudioArgs),
    Doctor(DoctorArgs),
    Completions(CompletionsArgs),
    Man(ManArgs),
}

/// The words of the command among those that were typed: `profile blend`.
pub(crate) fn command_words(typed: impl Iterator<Item = OsString>) -> String {
    let (mut at, mut words) = (Cli::command(), Vec::new());
    for word in typed.skip(1) {
        let Some(inner) = at.find_subcommand(&word).cloned() else { break };
        words.push(inner.get_name().to_owned());
        at = inner;
    }
    words.join(" ")
}

/// The arguments of `T` out of words without the name of a program.
pub(crate) fn parse<T: Args + FromArgMatches>(
    command: &clap::Command,
    words: impl IntoIterator<Item = String>,
) -> Result<T, clap::Error> {
    T::from_arg_matches(&command.clone().try_get_matches_from(words)?)
}

/// Columns of a help text; with the widest option before it a line has 110.
const HELP_WIDTH: usize = 72;

/// Breaks a help text into lines; the default in brackets at its end stays in one piece.
fn wrap(text: &str) -> String {
    let (words, default) = text.split_once(" [").unwrap_or((text, ""));
    let default = if default.is_empty() { String::new() } else { format!("[{default}") };
    let (mut lines, mut width) = (String::new(), 0);
    for piece in words.split(' ').chain([default.as_str()]).filter(|piece| !piece.is_empty()) {
        let length = piece.chars().count();
        if width > 0 && width + 1 + length > HELP_WIDTH {
            lines.push('\n');
            width = 0;
        } else if width > 0 {
            lines.push(' ');
            width += 1;
        }
        lines.push_str(piece);
        width += length;
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_commands_are_as_clap_asks() {
        Cli::command().debug_assert();
    }

    #[test]
    fn the_words_of_a_command_end_where_its_arguments_begin() {
        let words = |line: &str| command_words(line.split(' ').map(OsString::from));
        assert_eq!(words("solaris walk --rate 5"), "walk");
        assert_eq!(words("solaris profile blend --curve walk"), "profile blend");
        assert_eq!(words("solaris walks"), "");
    }
}
