//! The request of `solaris ground`, and its options that `solaris inverse` and `solaris metrics` have as well.

use super::given::{self, CyclesArgs, FrameArgs, RecordArgs};
use super::subject::SubjectArgs;
use super::{Number, wrap};
use clap::Args;
use clap::builder::PossibleValuesParser;
use clap::builder::TypedValueParser;
use solaris::analysis::ground::{ConsistencyOptions, Split, StanceOptions};
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris ground subject.osim walk.mot --soles soles.ron --filter 6Hz -o grf.mot
      forces under both feet of a measured walk, without force plates; OpenSim reads them
  solaris ground subject.osim walk.mot --soles soles.ron --filter 6Hz --split transition --json
      another assumption of how two feet share what both bear; numbers for a program
  solaris ground subject.osim walk.mot --soles soles.ron --filter 6Hz \\
      --against plates.mot --plate right= --plate left=1_ -o forces.svg
      how far they are from what plates measured, and a picture of both
  solaris ground human.ron walk.csv -o grf.csv
      a walk of `solaris walk`; the figure has soles of its own
  solaris ground human.ron clip.csv --consistent --motion-out moved.csv
      an animation that floats or leans too far: its root moved by the least after which the ground can bear it
  solaris inverse subject.osim walk.mot --ground --soles soles.ron --filter 6Hz -o moments.sto
      joint moments with these forces, in one command";

/// What `--stances` is.
pub(super) const STANCES: &str = "When which foot stands, where that is known: a table with the columns foot (the name of a sole), from and to \
     (s), a line for each stance [default: found from the motion]";

/// A figure in a motion, of which the ground's forces are found.
#[derive(Debug, Args)]
#[command(about = "What the ground does to the feet in a given motion, without force plates", after_help = EXAMPLES)]
pub(crate) struct GroundCommandArgs {
    #[arg(value_name = "FIGURE", help = wrap(given::FIGURE))]
    pub(crate) figure: PathBuf,
    #[arg(value_name = "MOTION", help = wrap(given::MOTION))]
    pub(crate) motion: PathBuf,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write force, moment and centre of pressure of each foot: .mot or .sto with OpenSim's names (NAME_ground_force_vx), \
         .csv with NAME.fx; draw the forces: .svg; or show all of it on a page: .html [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, value_name = "FILE", requires = "plates", help = wrap(
        "Measured forces to hold the found ones against, in the summary and the picture: .mot, .sto or .csv, as \
         --external of `solaris inverse`"
    ))]
    pub(crate) against: Option<PathBuf>,
    #[arg(long = "plate", value_name = "FOOT=PREFIX", requires = "against", value_parser = parse_plate, help = wrap(
        "Which columns of that file were measured under which sole, by its name: PREFIX is what stands before \
         ground_force_vx (may be empty) or before .fx, or within, as r in ground_force_r_vx. Several are allowed"
    ))]
    pub(crate) plates: Vec<AskedPlate>,
    #[arg(long = "external-loads", value_name = "FILE.xml", conflicts_with = "against", help = wrap(
        "The same as OpenSim's ExternalLoads file: measured forces, and the bodies of the soles that they act on"
    ))]
    pub(crate) loads: Option<PathBuf>,
    #[arg(long, help = "Print the summary as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten, next_help_heading = "The ground")]
    pub(crate) ground: GroundArgs,
    #[arg(long, value_name = "FILE", help = wrap(STANCES))]
    pub(crate) stances: Option<PathBuf>,
    #[command(flatten, next_help_heading = "Strides")]
    pub(crate) cycles: CyclesArgs,
    #[command(flatten, next_help_heading = "A motion that the ground can bear")]
    pub(crate) consistent: ConsistentArgs,
    #[command(flatten, next_help_heading = "The motion")]
    pub(crate) record: RecordArgs,
    #[command(flatten, next_help_heading = "A figure that is brought to a person's size")]
    pub(crate) subject: SubjectArgs,
    #[command(flatten, next_help_heading = "The figure")]
    pub(crate) frame: FrameArgs,
}

/// What was measured under a sole.
#[derive(Clone, Debug)]
pub(crate) struct AskedPlate {
    /// The name of the sole.
    pub(crate) foot: String,
    /// What its columns begin with.
    pub(crate) prefix: String,
}

fn parse_plate(text: &str) -> Result<AskedPlate, String> {
    let (foot, prefix) = text.split_once('=').ok_or("it must be FOOT=PREFIX, such as right= or left=1_")?;
    Ok(AskedPlate { foot: foot.trim().to_owned(), prefix: prefix.to_owned() })
}

/// How the ground treadmills, and how that was typed.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum AskedBelt {
    Auto,
    Still,
    /// Its speed (m/s).
    Speed(Number),
}

impl AskedBelt {
    pub(crate) fn typed(&self) -> &str {
        match self {
            Self::Auto => "auto",
            Self::Still => "still",
            Self::Speed(speed) => &speed.typed,
        }
    }
}

/// How the ground's forces are found.
#[derive(Debug, Args)]
pub(crate) struct GroundArgs {
    #[arg(
        long, value_name = "NAME", hide_possible_values = true,
        value_parser = PossibleValuesParser::new(Split::ALL.map(Split::name)).try_map(|name| {
            Split::named(&name).ok_or("no such assumption")
        }),
        help = wrap(&format!(
            "How two feet share what both bear, an assumption: transition (the smooth curves of people who walk), pivot \
             (forces that point at one point above the centre of mass), effort (least joint moments) [default: {}]",
            Split::default().name()
        ))
    )]
    pub(crate) split: Option<Split>,
    #[arg(long, value_name = "FILE", help = wrap(
        "Where the feet meet the ground: heel, ball and tip of each sole, as text (docs/ground.md has one) \
         [default: the figure's own, or a guess by the bodies calcn and toes]"
    ))]
    pub(crate) soles: Option<PathBuf>,
    #[arg(long, value_name = "SPEED|auto|still", allow_hyphen_values = true, value_parser = parse_belt, help = wrap(
        "How the ground itself moves, on a treadmill: its speed in m/s, along the feet on it; still; or as the feet on \
         it tell [default: auto]"
    ))]
    pub(crate) belt: Option<AskedBelt>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(&format!(
        "How far above its lowest place a point of the sole may be and still stand, in m [default: {}, or more where feet \
         are lifted high]",
        StanceOptions::HEIGHT
    )))]
    pub(crate) stance_height: Option<Number>,
    #[arg(long, value_name = "M/S", allow_hyphen_values = true, help = wrap(
        "How fast it may be against the ground and still stand, in m/s [default: shares of its speed in the swing before \
         and after]"
    ))]
    pub(crate) stance_speed: Option<Number>,
    #[arg(long, value_name = "S", allow_hyphen_values = true, help = wrap(&format!(
        "Stances and gaps between them that are shorter than this are none, in s [default: {}]",
        StanceOptions::default().shortest
    )))]
    pub(crate) stance_shortest: Option<Number>,
}

/// Options of [`GroundArgs`] that say when feet stand, by their ids.
pub(super) const STANCE_OPTIONS: [&str; 4] = ["belt", "stance_height", "stance_speed", "stance_shortest"];
/// The other ones, and those of [`ConsistentArgs`].
pub(super) const GROUND_OPTIONS: [&str; 5] =
    ["split", "stances", "consistent", "consistent_limit", "motions"];

/// How the motion is changed before forces are found.
#[derive(Debug, Args)]
pub(crate) struct ConsistentArgs {
    #[arg(long, help = wrap(&format!(
        "First move the root by the least that keeps the ground from pulling and the centre of pressure {} mm inside of the \
         soles that stand; all else stays, so the feet go with it",
        ConsistencyOptions::default().margin * 1e3
    )))]
    pub(crate) consistent: bool,
    #[arg(long, value_name = "M", allow_hyphen_values = true, requires = "consistent", help = wrap(&format!(
        "How far it may be moved, in m, or inf; where that does not suffice it stops there, and the summary says what stays \
         impossible [default: {}]",
        ConsistencyOptions::default().limit
    )))]
    pub(crate) consistent_limit: Option<Number>,
    #[arg(long = "motion-out", value_name = "FILE", requires = "consistent", help = wrap(
        "Write the motion that was moved: .csv with DOF.q, .v and .a; .mot, .sto (positions); .bvh, .glb, .usda [default: none]"
    ))]
    pub(crate) motions: Vec<PathBuf>,
}

fn parse_belt(text: &str) -> Result<AskedBelt, String> {
    match text {
        "auto" => Ok(AskedBelt::Auto),
        "still" => Ok(AskedBelt::Still),
        _ => match text.parse::<Number>() {
            Ok(speed) if speed.value > 0.0 && speed.value.is_finite() => Ok(AskedBelt::Speed(speed)),
            _ => Err("it must be a speed above zero in m/s, such as 1.2, or auto, or still".to_owned()),
        },
    }
}
