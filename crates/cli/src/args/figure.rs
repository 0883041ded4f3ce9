//! Requests of the commands about figures: `figure`, `check`, `convert`.

use super::given::FILES;
use super::value::{count, number};
use super::walk::{parse_load, parse_shorter};
use super::{BODY_MASS_INDEX, HEIGHT, HEIGHTS, Number, RigArgs, Side, wrap};
use clap::{Args, Subcommand, ValueEnum};
use solaris::io::bvh::Unit;
use solaris::io::markers::Axes;
use std::path::PathBuf;

const FIGURE_EXAMPLES: &str = "Examples:
  solaris figure human --height 1.75 --mass 73 -o human.ron
      the figure that walks, as a text that people can read and change
  solaris figure human --height 1.62 --mass 55 --segment thigh=0.40 --segment left_shank=0.38 -o ann.ron
      a person with measured segments";

const CHECK_EXAMPLES: &str = "Examples:
  solaris check human.ron
      what the figure is: links, degrees of freedom, mass, chains, and what looks wrong
  solaris check robot.urdf --dh
      the same of a robot, with its Denavit-Hartenberg table
  solaris check subject.osim --strict
      exit code 1 if anything looks wrong
  solaris check walk.c3d
      what was recorded: markers and their gaps, force plates, events, and what is odd";

const CONVERT_EXAMPLES: &str = "Examples:
  solaris convert robot.urdf robot.ron
      a model of another program as a figure's text
  solaris convert human.ron child.ron --height 1.2 --mass 25
      the same figure in another size
  solaris convert walk.csv walk.mot
      a motion for OpenSim: the positions, in radians
  solaris convert ik.mot ik.csv --figure subject.osim
      degrees become radians where the figure says that a coordinate turns
  solaris convert dance.bvh dancer.ron --unit cm
      the skeleton of a BVH file as a figure, with a person's masses where its names are a person's
  solaris convert dance.bvh dance.csv --skip-frames 1
      its motion, without the reference pose in front
  solaris convert ik.mot ik.bvh --figure subject.osim
      a motion for animation programs
  solaris convert dancer.glb dance.bvh --clip dance
      one of the animations of a body of a 3D program
  solaris convert walk.c3d walk.trc
      markers for OpenSim, in mm, with y up and x forward
  solaris convert walk.c3d forces.mot --axes z,-y
      what the force plates measured, of a file in which z is up and the person walks along -y";

/// A figure to be written.
#[derive(Debug, Subcommand)]
#[command(about = "Writes a figure as text", after_help = FIGURE_EXAMPLES)]
pub(crate) enum FigureCommand {
    Human(HumanArgs),
}

/// A human of some size.
#[derive(Debug, Args)]
#[command(
    about = "A human of 21 segments and 66 degrees of freedom",
    after_help = FIGURE_EXAMPLES,
    mut_arg("height", |arg| arg.help(format!("Standing height, {} to {} m [default: {HEIGHT}]", HEIGHTS.0, HEIGHTS.1))),
    mut_arg("mass", |arg| arg.help(format!("Body mass in kg, met exactly [default: {BODY_MASS_INDEX}·height²]"))),
    mut_arg("segments", |arg| {
        arg.help("A segment's own length in m (thigh: both, left_thigh: one); several are allowed")
    })
)]
pub(crate) struct HumanArgs {
    #[command(flatten)]
    pub(crate) size: SizeArgs,
    #[arg(long, value_name = "YEARS", allow_hyphen_values = true, help = wrap(
        "Age in years, from 6 on: a child's proportions; from 18 on an adult's [default: an adult]"
    ))]
    pub(crate) age: Option<Number>,
    #[arg(long = "load", value_name = "SIDE=KG", value_parser = parse_load, help = wrap(
        "What a hand carries: right=5, a point mass in the fist; several are allowed [default: nothing]"
    ))]
    pub(crate) loads: Vec<(String, f64)>,
    #[arg(long = "shorter-leg", value_name = "SIDE=M", value_parser = parse_shorter, help = wrap(
        "By how much a leg is shorter: left=0.02, thigh and shank by the same part [default: legs alike]"
    ))]
    pub(crate) shorter: Vec<(String, f64)>,
    #[arg(long, value_name = "SIDE", value_enum, hide_possible_values = true, help = wrap(
        "A cane in the left or the right hand: a link more [default: none]"
    ))]
    pub(crate) cane: Option<Side>,
    #[arg(long, help = wrap(
        "Let the root turn by its heading first (about y, z, x) in place of z, y, x: for walks that turn by more than 75° in all"
    ))]
    pub(crate) heading_first: bool,
    #[arg(short = 'o', long, value_name = "FILE", help = "Where to write the figure: .ron")]
    pub(crate) output: PathBuf,
}

/// What makes a figure of a person's size, or changes one.
#[derive(Debug, Args)]
pub(crate) struct SizeArgs {
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = "Standing height in m")]
    pub(crate) height: Option<Number>,
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help = "Total mass in kg, met exactly")]
    pub(crate) mass: Option<Number>,
    #[arg(long = "segment", value_name = "NAME=LENGTH", value_parser = parse_segment, help = wrap(
        "A segment's own length in m; several are allowed"
    ))]
    pub(crate) segments: Vec<(String, f64)>,
}

impl SizeArgs {
    /// Whether any of it was asked for.
    pub(crate) fn is_asked(&self) -> bool {
        self.height.is_some() || self.mass.is_some() || !self.segments.is_empty()
    }
}

/// A segment and its length.
fn parse_segment(text: &str) -> Result<(String, f64), String> {
    let (name, length) = text.split_once('=').ok_or("it must be NAME=LENGTH, such as left_thigh=0.44")?;
    Ok((name.trim().to_owned(), number(length.trim()).map_err(|why| format!("the length: {why}"))?))
}

/// A figure or a scene to be looked at.
#[derive(Debug, Args)]
#[command(
    about = "Says what a figure, a scene or a recording is and what looks wrong with it, or every fault of its text",
    after_help = CHECK_EXAMPLES
)]
pub(crate) struct CheckArgs {
    #[arg(value_name = "FILE", help = wrap(
        "A figure or a scene (.ron), URDF (.urdf), SDF (.sdf), MuJoCo (.xml, .mjcf) or OpenSim (.osim) model, bones (.bvh, .glb), or \
         markers (.c3d, .trc)"
    ))]
    pub(crate) file: PathBuf,
    #[arg(
        long,
        conflicts_with = "json",
        help = "Print the rationalised links: the Denavit-Hartenberg table of every chain"
    )]
    pub(crate) dh: bool,
    #[arg(long, help = "Exit with 1 if anything looks wrong")]
    pub(crate) strict: bool,
    #[arg(long, value_name = "FOLDER", help = wrap(FILES))]
    pub(crate) files: Option<PathBuf>,
    #[arg(long, help = "Print the summary as JSON instead of text")]
    pub(crate) json: bool,
}

/// A file to be written in another format.
#[derive(Debug, Args)]
#[command(about = "A figure or a motion from one format to another", after_help = CONVERT_EXAMPLES)]
pub(crate) struct ConvertArgs {
    #[arg(value_name = "IN", help = wrap(
        "A figure (.ron, .urdf, .sdf, .xml, .mjcf, .osim), a motion (.csv, .mot, .sto), both (.bvh, .glb), or a recording of markers \
         (.c3d, .trc)"
    ))]
    pub(crate) from: PathBuf,
    #[arg(value_name = "OUT", help = wrap(
        "A figure as .ron, a motion as .csv, .mot, .sto, .bvh, .glb or .usda, markers as .trc or .csv, or their force plates as .mot"
    ))]
    pub(crate) to: PathBuf,
    #[arg(long, value_name = "FOLDER", help = wrap(FILES))]
    pub(crate) files: Option<PathBuf>,
    #[arg(long, value_name = "FILE", help = wrap(
        "Whose motion it is; needed where the motion is in degrees, and to write .bvh, .glb and .usda"
    ))]
    pub(crate) figure: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) bones: RigArgs,
    #[arg(
        long,
        value_name = "UP,FORWARD",
        allow_hyphen_values = true,
        help_heading = "What a file of markers does not say",
        help = wrap(
            "Which ways of IN are up and forward, such as z,-y; they become y and x [default: found by plates, names and \
             where the markers go]"
        )
    )]
    pub(crate) axes: Option<Axes>,
    #[command(flatten, next_help_heading = "A figure in another size")]
    pub(crate) size: SizeArgs,
    #[command(flatten, next_help_heading = "What a file of bones does not say")]
    pub(crate) skeleton: BonesArgs,
}

/// What a file of bones does not say.
#[derive(Debug, Args)]
pub(crate) struct BonesArgs {
    #[arg(long, value_name = "UNIT", value_parser = parse_unit, help = wrap(
        "Unit of its lengths, of markers too: cm, m, mm, inch, cmu (an inch over 0.45), or so many metres [default: the one in which \
         it is as large as a person]"
    ))]
    pub(crate) unit: Option<Unit>,
    #[arg(
        long,
        value_name = "AXIS",
        value_enum,
        help = wrap(
        "Axis that points up [default: y, or z where the head is above the feet along z]"
    )
    )]
    pub(crate) up: Option<UpArg>,
    #[arg(long, value_name = "FILE", help = wrap(
        "Masses of its bones: a text of lines BONE,KG [default: a person's, where its names are a person's]"
    ))]
    pub(crate) masses: Option<PathBuf>,
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = count("skip-frames", 0, 1_000_000_000), help = wrap(
        "Frames to leave out at the beginning, such as a reference pose"
    ))]
    pub(crate) skip_frames: usize,
    #[arg(long, value_name = "NAME", help = wrap(
        "Which of several animations of a .glb file is read [default: the first]"
    ))]
    pub(crate) clip: Option<String>,
}

impl BonesArgs {
    /// Whether any of it was asked for.
    pub(crate) fn is_asked(&self) -> bool {
        self.unit.is_some()
            || self.up.is_some()
            || self.masses.is_some()
            || self.skip_frames > 0
            || self.clip.is_some()
    }
}

/// The axis of a file that points up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum UpArg {
    Y,
    Z,
}

/// A unit by its name, or in metres.
fn parse_unit(text: &str) -> Result<Unit, String> {
    Ok(match text.to_ascii_lowercase().as_str() {
        "cm" => Unit::Centimetres,
        "m" => Unit::Metres,
        "mm" => Unit::Millimetres,
        "inch" | "in" => Unit::Inches,
        "cmu" => Unit::Cmu,
        other => match other.parse() {
            Ok(metres) if metres > 0.0 && f64::is_finite(metres) => Unit::Of(metres),
            _ => return Err("it must be cm, m, mm, inch, cmu or so many metres, such as 0.01".to_owned()),
        },
    })
}
