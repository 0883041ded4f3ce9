//! Requests of `solaris gait`: tables, maps and postures of the thesis's models.

use super::parameters::{KeyArgs, key_options};
use super::value::count;
use super::value::within;
use super::walk::{Count, DeterminantCount, EveryoneArgs, Loop, PersonArgs, WhoArgs};
use super::{HEIGHT, Number, RigArgs, wrap};
use clap::builder::PossibleValuesParser;
use clap::{Args, Subcommand, ValueEnum};
use solaris::gait::determinants::TABLES;
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris gait table 7.7
      a table of the thesis computed anew, with what is printed beside it
  solaris gait explain --determinants 5 --step-frequency 110 -o postures.svg
      the key postures as stick figures, and how much room each inequality leaves
  solaris gait map --x heel-strike-angle --y tilt --step-frequency 110 -o map.svg
      where postures exist, and which inequality forbids them elsewhere
  solaris gait set -o ann.glb -o ann.json
      clips for a character of a game: standing, starts, walks, turns, stops";

const TABLE_EXAMPLES: &str = "Examples:
  solaris gait table 7.8
      one table; without a number all of them
  solaris gait table 8.1 --format markdown
      for a document";

const MAP_EXAMPLES: &str = "Examples:
  solaris gait map --x heel-strike-angle --y thigh-swing --step-frequency 110 -o map.svg
      five determinants; what is not on an axis is chosen, or given as an option
  solaris gait map --determinants 3 --x flexion --y tilt --body fit --step-frequency 100 --x-span 1:50 -o map.html
      three determinants with the thesis's proportions, as a page";

const EXPLAIN_EXAMPLES: &str = "Examples:
  solaris gait explain --determinants 3 --step-frequency 100 -o postures.svg
      the postures with their angles
  solaris gait explain --heel-strike-angle 32
      what fails, and the nearest value of each parameter at which all would hold (it exits with 1)";

const PEOPLE_EXAMPLES: &str = "Examples:
  solaris gait people
      a person of 1.75 m
  solaris gait people --height 1.5 --determinants 3 --format csv
      a smaller one without pelvic rotation, for a spreadsheet";

const SET_EXAMPLES: &str = "Examples:
  solaris gait set -o ann.glb -o ann.json
      one body with all clips, and how they fit together
  solaris gait set --height 1.65 --mass 58 --manner happy:0.5 --rig mixamo --rate 24 -o clips/
      a .bvh for each clip, on Mixamo's bones, and clips/set.json
  solaris gait set --speeds 0.8,1.2,1.6 --loop in-place -o loops.glb
      loops at these speeds that stay where they are";

#[derive(Debug, Subcommand)]
#[command(
    about = "The thesis's walking models: tables, feasible regions, postures; walks beside people; clips for games",
    after_help = EXAMPLES
)]
pub(crate) enum GaitCommand {
    Table(TableArgs),
    Map(Box<MapArgs>),
    Explain(Box<ExplainArgs>),
    People(PeopleArgs),
    Set(Box<SetArgs>),
}

/// Tables of the thesis.
#[derive(Debug, Args)]
#[command(
    about = "Tables 7.1 to 7.8 and 8.1 to 8.7 of the thesis, computed anew beside what is printed",
    after_help = TABLE_EXAMPLES
)]
pub(crate) struct TableArgs {
    #[arg(
        value_name = "NUMBER", value_parser = PossibleValuesParser::new(TABLES), hide_possible_values = true,
        help = "7.1 to 7.8, 8.1 to 8.7 [default: all]"
    )]
    pub(crate) number: Option<String>,
    #[command(flatten)]
    pub(crate) format: FormatArgs,
}

/// How a table is written.
#[derive(Debug, Args)]
pub(crate) struct FormatArgs {
    #[arg(
        long,
        value_name = "FORMAT",
        value_enum,
        default_value_t,
        hide_default_value = true,
        hide_possible_values = true,
        help = "text, csv or markdown [default: text]"
    )]
    pub(crate) format: TableFormat,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum TableFormat {
    #[default]
    Text,
    Csv,
    Markdown,
}

/// A map of where postures exist.
#[derive(Debug, Args)]
#[command(
    about = "Where postures exist, over two parameters, and which inequality forbids them elsewhere",
    after_help = MAP_EXAMPLES
)]
pub(crate) struct MapArgs {
    #[arg(
        long, value_name = "PARAMETER", value_parser = PossibleValuesParser::new(key_options()), hide_possible_values = true,
        help = "The parameter that goes across, by the name of its option"
    )]
    pub(crate) x: String,
    #[arg(
        long, value_name = "PARAMETER", value_parser = PossibleValuesParser::new(key_options()), hide_possible_values = true,
        help = "The parameter that goes up, by the name of its option"
    )]
    pub(crate) y: String,
    #[arg(
        long, value_name = "FROM:TO", allow_hyphen_values = true, value_parser = parse_span,
        help = "What of the parameter of x is shown, in its unit [default: its range]"
    )]
    pub(crate) x_span: Option<(f64, f64)>,
    #[arg(
        long, value_name = "FROM:TO", allow_hyphen_values = true, value_parser = parse_span,
        help = "What of the parameter of y is shown, in its unit [default: its range]"
    )]
    pub(crate) y_span: Option<(f64, f64)>,
    #[arg(
        long, value_name = "N", allow_hyphen_values = true, value_parser = count("places", 2, 2000), default_value = "160",
        hide_default_value = true,
        help = wrap("Places a side at which is looked, 2 to 2000; boundaries are exact whatever it is [default: 160]")
    )]
    pub(crate) places: Count,
    #[arg(
        short = 'o',
        long = "output",
        value_name = "FILE",
        help = "Write the map: .svg picture, .html page; several -o are allowed [default: none]"
    )]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, help = "Print the places and the boundary as JSON")]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) postures: PosturesArgs,
}

/// Key postures to be told.
#[derive(Debug, Args)]
#[command(
    about = "The key postures with their angles, and how much room each inequality leaves",
    after_help = EXPLAIN_EXAMPLES
)]
pub(crate) struct ExplainArgs {
    #[arg(
        short = 'o',
        long = "output",
        value_name = "FILE",
        help = "Write the postures: .svg picture, .html page; several -o are allowed [default: none]"
    )]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, help = "Print parameters, angles and inequalities as JSON")]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) postures: PosturesArgs,
}

/// A person beside people.
#[derive(Debug, Args)]
#[command(
    about = "Every fact that is known of people's walking, beside smooth walks at 80 to 130 steps/min",
    after_help = PEOPLE_EXAMPLES
)]
pub(crate) struct PeopleArgs {
    #[command(flatten)]
    pub(crate) determinants: DeterminantsArgs,
    #[command(flatten)]
    pub(crate) person: PersonArgs,
    #[command(flatten)]
    pub(crate) format: FormatArgs,
}

#[derive(Debug, Args)]
pub(crate) struct DeterminantsArgs {
    #[arg(
        long = "determinants",
        value_name = "N",
        value_enum,
        default_value_t,
        hide_default_value = true,
        hide_possible_values = true,
        help = "Determinants of gait, 3 or 5 [default: 5]"
    )]
    pub(crate) count: DeterminantCount,
}

/// Clips of a character.
#[derive(Debug, Args)]
#[command(
    about = "Clips for a character of a game: standing, starts, walks at some speeds, turns, stops, and how they fit together",
    after_help = SET_EXAMPLES
)]
pub(crate) struct SetArgs {
    #[arg(short = 'o', long = "output", value_name = "FILE", required = true, help = wrap(
        "Write the set: .glb body with all clips, .json names, speeds, phases and seams; several -o are allowed; or name a folder that ends in / \
         for a .bvh of each clip and set.json"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, value_name = "M/S,…", value_delimiter = ',', allow_hyphen_values = true, help = wrap(
        "Speeds of the loops, one to twenty, negative ones backward [default: five, of 64 to 110 % of people's usual step frequency, and two backward]"
    ))]
    pub(crate) speeds: Vec<Number>,
    #[arg(
        long, value_name = "FRAMES/S", allow_hyphen_values = true, default_value_t = 30.0, hide_default_value = true,
        value_parser = within("rate", 1.0, 1000.0, " frames/s"),
        help = "Frames a second; strides are fitted to whole frames [default: 30]"
    )]
    pub(crate) rate: f64,
    #[arg(long = "loop", value_name = "HOW", value_enum, hide_possible_values = true, help = wrap(
        "Loops that go on (moving) or stay on the spot (in-place); other clips go where they go [default: moving]"
    ))]
    pub(crate) repeats: Option<Loop>,
    #[arg(long, help = "Print the set as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) bones: RigArgs,
    #[command(flatten, next_help_heading = "The person")]
    pub(crate) who: WhoArgs,
    #[command(flatten, next_help_heading = "In which manner")]
    pub(crate) everyone: EveryoneArgs,
}

/// Whose postures, how fast, and with which parameters.
#[derive(Debug, Args)]
pub(crate) struct PosturesArgs {
    #[command(flatten)]
    pub(crate) determinants: DeterminantsArgs,
    #[arg(
        long, value_name = "WHOSE", value_enum, default_value_t, hide_default_value = true, hide_possible_values = true,
        help = wrap(
            "human: a person's own segments and feet; thesis: the ankle on the ground, lengths by Drillis and Contini; fit: the \
             proportions that give back tables 7.7 and 7.8, in units of the leg, of which --step-length and --speed are then too \
             [default: human]"
        )
    )]
    pub(crate) body: Whose,
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(&format!(
        "Standing height in m [default: {HEIGHT}]"
    )))]
    pub(crate) height: Option<Number>,
    #[arg(long, visible_alias = "cadence", value_name = "STEPS/MIN", allow_hyphen_values = true, help = wrap(
        "Steps a minute [default: 110, or what speed and step length say]"
    ))]
    pub(crate) step_frequency: Option<Number>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(
        "S: from heel print to heel print [default: 0.004·height·frequency]"
    ))]
    pub(crate) step_length: Option<Number>,
    #[arg(long, value_name = "M/S", allow_hyphen_values = true, help = wrap(
        "Speed; two of speed, frequency and length decide the third"
    ))]
    pub(crate) speed: Option<Number>,
    #[command(flatten)]
    pub(crate) parameters: KeyArgs,
}

/// Whose proportions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Whose {
    #[default]
    Human,
    Thesis,
    Fit,
}

/// From one number to another.
fn parse_span(text: &str) -> Result<(f64, f64), String> {
    let wrong = || format!("'{text}' is no span; write two numbers as 5:30");
    let (from, to) = text.split_once(':').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(wrong);
    Ok((number(from)?, number(to)?))
}
