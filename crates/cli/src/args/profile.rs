//! Requests of `solaris profile`: a command for each kind of curve, made from the table of kinds.

mod kind;

pub(crate) use kind::{KeySource, KindArgs, KindCommand, amplitude, example, option};

use super::value::{ValueError, number};
use super::{Number, RATE, wrap};
use clap::{Args, Subcommand, ValueEnum};
use solaris::profiles::blend::{FadeKind, Leaving};
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris profile list
      all kinds of curves; `solaris profile tension --help` has the parameters of one
  solaris profile minimum-jerk --from 0 --to 1.2 --duration 2 --unit rad
      a table of position, velocity, acceleration and jerk, and what the whole curve answers
  solaris profile catmull-rom --keys '0:5, 1:7, 2:-9' -o curve.svg -o curve.html -o curve.csv
      a picture, a page with a crosshair, and a table for other programs
  solaris profile cubic --from 0 --to 5 --duration 2 --v1 5 --free v0
      with which start velocities the motion never turns round";

const READ_EXAMPLES: &str = "Examples:
  solaris profile minimum-jerk --from 0 --to 1.2 --duration 2 -o curve.ron
      writes a profile as text: MinimumJerk(from: 0.0, to: 1.2, duration: 2.0)
  solaris profile read curve.ron -o curve.svg
      draws the profile of a text; blends and weighted means too";

const BLEND_EXAMPLES: &str = "Examples:
  solaris profile blend --curve 'MinimumJerk(from: 0, to: 5, duration: 2)' \\
      --curve 'Power(from: 0, to: 5, duration: 2, exponent: 3)' --fade smooth --window 0.5:1.5 -o blend.svg
      the first motion fades into the second
  solaris profile blend --curve 'Line(from: 0, to: 1, duration: 1)' \\
      --curve '(profile: Line(from: 1, to: 0, duration: 1), start: 1.5)' --fade linear --window 1:1.5
      the second begins at 1.5 s; before and after its own span a motion rests at its ends";

/// The curve that is asked for.
#[derive(Debug, Subcommand)]
#[command(
    about = "Tabulates or draws one motion curve: position, velocity, acceleration, jerk",
    after_help = EXAMPLES
)]
pub(crate) enum ProfileCommand {
    List(ListArgs),
    #[command(flatten)]
    Kind(KindCommand),
    Blend(BlendArgs),
    Read(ReadArgs),
}

/// The kinds of curves.
#[derive(Debug, Args)]
#[command(about = "All kinds of curves, one a line")]
pub(crate) struct ListArgs {
    #[arg(long, help = "Print the kinds with their parameters, units and ranges as JSON")]
    pub(crate) json: bool,
}

/// A curve from a text.
#[derive(Debug, Args)]
#[command(
    about = "A curve from a text (.ron): any kind, blends and weighted means",
    after_help = READ_EXAMPLES
)]
pub(crate) struct ReadArgs {
    #[arg(value_name = "FILE", help = "A profile's text (.ron)")]
    pub(crate) file: PathBuf,
    #[command(flatten)]
    pub(crate) curve: CurveArgs,
}

/// One curve that fades into another.
#[derive(Debug, Args)]
#[command(
    about = "One curve that fades into another",
    after_help = BLEND_EXAMPLES,
    override_usage = "solaris profile blend --curve <RON> --curve <RON> --fade <HOW> --window <START:END> [OPTIONS]"
)]
pub(crate) struct BlendArgs {
    #[arg(
        long = "curve", value_name = "RON", required = true, help_heading = BLEND, help = wrap(
            "A profile's text, as `-o FILE.ron` writes it, or (profile: …, start: S, outside: Hold|Extrapolate|Repeat|\
             Mirror); twice: what fades out, what fades in"
        )
    )]
    pub(crate) curves: Vec<String>,
    #[arg(long, value_name = "HOW", value_enum, hide_possible_values = true, help_heading = BLEND, help = wrap(
        "How: smooth (velocity and acceleration stay continuous), linear, exponential, sinh, trigonometric"
    ))]
    pub(crate) fade: FadeName,
    #[arg(
        long, visible_alias = "k", value_name = "NUMBER", allow_hyphen_values = true, help_heading = BLEND, help = wrap(
            "Stiffness of the last three, at least 0; above ln 2 (exponential) and π/2 (trigonometric) the share of the first \
             leaves 0 to 1 [default: 1, exponential: ln 2]"
        )
    )]
    pub(crate) stiffness: Option<Number>,
    #[arg(
        long, value_name = "START:END", allow_hyphen_values = true, value_parser = parse_window, help_heading = BLEND,
        help = "When, in s: 0.5:1.5"
    )]
    pub(crate) window: Window,
    #[arg(long, value_name = "HOW", value_enum, hide_possible_values = true, help_heading = BLEND, help = wrap(
        "Where the share of the first leaves 0 to 1 (trigonometric beyond π/2): refuse, clamp, allow [default: refuse]"
    ))]
    pub(crate) leaving: Option<LeavingName>,
    #[command(flatten)]
    pub(crate) curve: CurveArgs,
}

const BLEND: &str = "The blend";

/// How one motion may fade into another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum FadeName {
    Smooth,
    Linear,
    Exponential,
    Sinh,
    Trigonometric,
}

impl FadeName {
    /// The fade with this stiffness, where it has one.
    pub(crate) fn kind(self, stiffness: f64) -> FadeKind {
        match self {
            Self::Smooth => FadeKind::Smooth,
            Self::Linear => FadeKind::Linear,
            Self::Exponential => FadeKind::Exponential { stiffness },
            Self::Sinh => FadeKind::Sinh { stiffness },
            Self::Trigonometric => FadeKind::Trigonometric { stiffness },
        }
    }
}

/// What to do with a fade that leaves 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum LeavingName {
    Refuse,
    Clamp,
    Allow,
}

impl From<LeavingName> for Leaving {
    fn from(leaving: LeavingName) -> Self {
        match leaving {
            LeavingName::Refuse => Self::Refuse,
            LeavingName::Clamp => Self::Clamp,
            LeavingName::Allow => Self::Allow,
        }
    }
}

/// A window of time (s), and how it was typed.
#[derive(Clone, Debug)]
pub(crate) struct Window {
    pub(crate) start: f64,
    pub(crate) end: f64,
    pub(crate) typed: String,
}

#[derive(Clone, Copy, Debug, thiserror::Error)]
enum WindowError {
    #[error("it must be START:END, such as 0.5:1.5")]
    NotAPair,
    #[error("it must be START:END, such as 0.5:1.5: two numbers")]
    NotNumbers,
}

fn parse_window(text: &str) -> Result<Window, WindowError> {
    let (start, end) = text.split_once(':').ok_or(WindowError::NotAPair)?;
    let read = |text: &str| number(text.trim()).map_err(|_: ValueError| WindowError::NotNumbers);
    Ok(Window { start: read(start)?, end: read(end)?, typed: text.to_owned() })
}

/// What all curves can be asked.
#[derive(Debug, Args)]
pub(crate) struct CurveArgs {
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the curve: .svg picture, .html page, .csv table, .ron text; several -o are allowed \
         [default: none, a table is printed]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, help = wrap("Print the table and the answers as JSON; null is a number that is not finite"))]
    pub(crate) json: bool,
    #[arg(
        long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1_000_000),
        help = "Rows of the table, evenly in time [default: 11]"
    )]
    pub(crate) samples: Option<u32>,
    #[arg(
        long, value_name = "ROWS/S", allow_hyphen_values = true, conflicts_with = "samples",
        help = wrap(&format!("Rows a second of the table, in place of their number [default: {} for .csv]", RATE.0))
    )]
    pub(crate) rate: Option<Number>,
    #[arg(long, value_name = "UNIT", help = "Unit of positions, only a label: rad, m [default: none]")]
    pub(crate) unit: Option<String>,
    #[arg(long, value_name = "TEXT", help = "Title of the picture [default: the kind's name]")]
    pub(crate) title: Option<String>,
    #[arg(long, value_name = "PARAMETER", help = wrap(
        "Print with which values of this parameter (v0, v1, s, vm, T1) the motion neither turns round nor stands still \
         inside; of vm and T1: with which there is an arc. Its own value may be left out"
    ))]
    pub(crate) free: Vec<String>,
    #[arg(long, help = "Exit with 1 if the motion turns round")]
    pub(crate) monotone: bool,
}
