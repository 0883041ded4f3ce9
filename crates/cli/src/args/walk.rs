//! The request of `solaris walk`.

mod bound;
mod everyone;
mod film;
mod terrain;
mod then;

pub(crate) use bound::RunBound;
pub(crate) use everyone::EveryoneArgs;
pub(crate) use film::FilmArgs;
pub(crate) use terrain::TerrainArgs;
pub(crate) use then::Then;

use super::parameters::StyleArgs;
use super::value::{Number, count, number, within};
use super::{BODY_MASS_INDEX, BODY_MASS_INDICES, DEFAULT_STEPS, HEIGHT, HEIGHTS, RATE, RigArgs, wrap};
use clap::{Args, ValueEnum};
use solaris::gait::determinants::{Determinants, THESIS_WALK_RATIO};
use solaris::gait::{
    DEFAULT_STEP_FREQUENCY, FOREFOOT_SPEED, RUN_SPEED, SHORTEST_DISTANCE, SOLE_GIVE, STEP_FREQUENCY, STEPS,
    THESIS_STEP_FREQUENCY, TURN, TURN_IN_ALL, WALK_RATIO,
};
use std::path::PathBuf;

const EXAMPLES: &str = "Examples:
  solaris walk -o walk.html
      a person of 1.75 m walks ten steps; open walk.html in a browser
  solaris walk --height 1.2 --mass 25 --step-frequency 100 --distance 5 -o child.html -o child.csv
      a child walks five metres, as a page and as a table
  solaris walk --speed 1.2 --arm-swing 5 -o stiff.bvh --report stiff.json
      motion capture for an animation tool, and the numbers of the walk as JSON
  solaris walk --style thesis --determinants 3 --step-frequency 95 -o thesis.html
      through the key postures of three determinants, from rest to rest
  solaris walk --steps 4 --then steps=3,turn=20 --then stand=1 --then steps=3,step-frequency=90 -o corner.html
      round a corner to the left, a stop, and on more slowly
  solaris walk --path way.csv -o way.html
      along a way: way.csv has the columns x and z, its points in m
  solaris walk --turn 30 --step-length 0 --steps 6 -o about.html
      half a turn to the left, on the spot
  solaris walk --steps 4 --then stand=1 --then steps=4,backward -o back.html
      four steps, a stop, and backward again
  solaris walk --loop in-place -o loop.glb
      one stride that repeats, for a game
  solaris walk --manner sad:0.7 --variability --seed 3 -o sad.html
      rather sad, and no step like another
  solaris walk --gait run --speed 3.5 -o run.html
      ten steps of a run, with its flights
  solaris walk --between 2.3:3.4 -o strip.svg
      a stride of it in twelve pictures
  solaris walk --gait run --speed 3 --from standing --to standing --steps 16 -o start.html
      from standing into a run, and to a stop";

/// A walk, and what to make of it.
#[derive(Debug, Args)]
#[command(about = "A person walks: from standing, some steps, to standing", after_help = EXAMPLES)]
pub(crate) struct WalkArgs {
    #[command(flatten)]
    pub(crate) files: MotionFiles,
    #[command(flatten, next_help_heading = "The person")]
    pub(crate) who: WhoArgs,
    #[command(flatten, next_help_heading = "The walk")]
    pub(crate) pace: PaceArgs,
    #[command(flatten)]
    pub(crate) extent: ExtentArgs,
    #[command(flatten)]
    pub(crate) manner: MannerArgs,
    #[command(flatten, next_help_heading = "Whose walk, and in which manner (style smooth)")]
    pub(crate) everyone: EveryoneArgs,
    #[command(flatten, next_help_heading = "The ground (style smooth)")]
    pub(crate) ground: TerrainArgs,
    #[command(flatten, next_help_heading = "Changes on the way (style smooth)")]
    pub(crate) changes: ChangeArgs,
    #[command(flatten)]
    pub(crate) style: StyleArgs,
}

/// Where to write what.
#[derive(Debug, Args)]
pub(crate) struct MotionFiles {
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the motion: .html page, .csv table, .bvh motion capture, .glb or .usda body and animation, .svg film strip of twelve pictures; several -o are allowed [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, value_name = "FILE.json", help = "Write its numbers as JSON [default: none]")]
    pub(crate) report: Option<PathBuf>,
    #[arg(long, help = "Print its numbers as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) bones: RigArgs,
    #[command(flatten)]
    pub(crate) film: FilmArgs,
}

/// Who walks.
#[derive(Debug, Args)]
pub(crate) struct WhoArgs {
    #[arg(long, value_name = "FILE", conflicts_with_all = ["height", "mass", "age", "loads", "shorter", "cane"], help = wrap(
        "Who walks: a figure's text (.ron) with the segments of a human [default: a human of this height and mass]"
    ))]
    pub(crate) figure: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) person: PersonArgs,
}

/// A person's size.
#[derive(Debug, Args)]
pub(crate) struct PersonArgs {
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(&format!(
        "Standing height, {} to {} m [default: {HEIGHT}]", HEIGHTS.0, HEIGHTS.1
    )))]
    pub(crate) height: Option<Number>,
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help = wrap(&format!(
        "Body mass in kg, {} to {} times the squared height [default: {BODY_MASS_INDEX}·height²]", BODY_MASS_INDICES.0, BODY_MASS_INDICES.1
    )))]
    pub(crate) mass: Option<Number>,
    #[arg(long, value_name = "YEARS", allow_hyphen_values = true, help = wrap(
        "Age in years, from 6 on: a child's proportions; from 18 on an adult's [default: an adult]"
    ))]
    pub(crate) age: Option<Number>,
    #[arg(long = "load", value_name = "SIDE=KG", value_parser = parse_load, help = wrap(
        "What a hand carries: right=5, a point mass in the fist of up to 0.3 of the body mass; the trunk leans away and that arm swings less; \
         several are allowed [default: nothing]"
    ))]
    pub(crate) loads: Vec<(String, f64)>,
    #[arg(long = "shorter-leg", value_name = "SIDE=M", value_parser = parse_shorter, help = wrap(
        "By how much a leg is shorter: left=0.02, thigh and shank by the same part; the pelvis hangs down to it [default: legs alike]"
    ))]
    pub(crate) shorter: Vec<(String, f64)>,
    #[arg(long, value_name = "SIDE", value_enum, hide_possible_values = true, help = wrap(
        "A cane in the left or the right hand, which helps the other leg: walks over level ground; that foot goes first [default: none]"
    ))]
    pub(crate) cane: Option<Side>,
}

/// A hand and what it carries (kg).
pub(super) fn parse_load(text: &str) -> Result<(String, f64), String> {
    parse_side(text, "SIDE=KG, such as right=5", "the load")
}

/// A leg, and by how much it is shorter (m).
pub(super) fn parse_shorter(text: &str) -> Result<(String, f64), String> {
    parse_side(text, "SIDE=M, such as left=0.02", "by how much")
}

fn parse_side(text: &str, example: &str, what: &str) -> Result<(String, f64), String> {
    let (side, amount) = text.split_once('=').ok_or_else(|| format!("it must be {example}"))?;
    Ok((side.trim().to_owned(), number(amount.trim()).map_err(|why| format!("{what}: {why}"))?))
}

/// Step frequency, step length and speed, of which two decide the third.
#[derive(Debug, Args)]
pub(crate) struct PaceArgs {
    #[arg(long, visible_alias = "cadence", value_name = "STEPS/MIN", allow_hyphen_values = true, help = wrap(&format!(
        "Steps a minute, {} to {} [default: {DEFAULT_STEP_FREQUENCY}, or what speed and step length say]",
        STEP_FREQUENCY.0, STEP_FREQUENCY.1
    )))]
    pub(crate) step_frequency: Option<Number>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(&format!(
        "From one heel print to the other foot's next in m, 12 % shorter to 12 % longer than people's (2 % at {} steps/min); \
         on a slope along the level, as the speed [default: people's, {WALK_RATIO}·height·frequency]",
        STEP_FREQUENCY.1
    )))]
    pub(crate) step_length: Option<Number>,
    #[arg(long, value_name = "M/S", allow_hyphen_values = true, help = wrap(&format!(
        "Speed of the steady part, {:.2} to {:.2} m/s at a height of {HEIGHT} m on level ground; two of speed, frequency and \
         length decide the third [default: frequency·length]",
        speed(STEP_FREQUENCY.0), speed(STEP_FREQUENCY.1)
    )))]
    pub(crate) speed: Option<Number>,
}

/// Speed of people of usual height at a step frequency (steps/min).
fn speed(frequency: f64) -> f64 {
    WALK_RATIO * HEIGHT * frequency * frequency / 60.0
}

/// How far, and how finely.
#[derive(Debug, Args)]
pub(crate) struct ExtentArgs {
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = count("steps", STEPS.0, STEPS.1), help = format!(
        "Number of steps, {} to {} [default: {DEFAULT_STEPS}]", STEPS.0, STEPS.1
    ))]
    pub(crate) steps: Option<Count>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, conflicts_with = "steps", help = wrap(&format!(
        "How far to walk, met exactly but where feet have to find places, instead of a number of steps: {SHORTEST_DISTANCE} m to {} steps [default: as far as \
         the steps go]",
        STEPS.1
    )))]
    pub(crate) distance: Option<Number>,
    /// Asked for often, and answered with what there is.
    #[arg(long, value_name = "S", allow_hyphen_values = true, hide = true)]
    pub(crate) duration: Option<Number>,
    #[arg(
        long, value_name = "FRAMES/S", allow_hyphen_values = true, value_parser = within("rate", RATE.1, RATE.2, " frames/s"),
        help = wrap(&format!("Samples a second of the motion, {} to {} [default: {}]", RATE.1, RATE.2, RATE.0))
    )]
    pub(crate) rate: Option<f64>,
}

/// A number of steps.
pub(crate) type Count = usize;

/// In which manner it walks.
#[derive(Debug, Args)]
pub(crate) struct MannerArgs {
    #[arg(long, value_name = "GAIT", value_enum, default_value_t, hide_default_value = true, hide_possible_values = true, help = wrap(&format!(
        "walk, or run: --speed is {} to {} m/s then, and as many steps as are asked for go by in full run, from a contact to a contact; \
         --from and --to let it begin and end in standing or in a walk, --then change its speed [default: walk]",
        RUN_SPEED.0, RUN_SPEED.1
    )))]
    pub(crate) gait: Gait,
    #[arg(long, help = wrap(&format!(
        "Gait run: land on the forefoot, in full run and up to {FOREFOOT_SPEED} m/s [default: on the heel]"
    )))]
    pub(crate) forefoot: bool,
    #[arg(long, value_name = "M", allow_hyphen_values = true, value_parser = within("give", SOLE_GIVE.0, SOLE_GIVE.1, " m"), help = wrap(&format!(
        "Gait run: by how much shoe, heel pad and floor give under a foot, up to {} m (people's: 0.010 to 0.015), in full run [default: 0]",
        SOLE_GIVE.1
    )))]
    pub(crate) give: Option<f64>,
    #[arg(long, value_name = "HOW", value_parser = bound::parse, help = wrap(
        "Gait run: how it begins, in full run (running), in standing, or in a walk that begins in standing: walking, or such as \
         walking,steps=6,speed=1.4; from standing or walking it takes some steps to reach its speed [default: running]"
    ))]
    pub(crate) from: Option<RunBound>,
    #[arg(long, value_name = "HOW", value_parser = bound::parse, help = wrap(
        "Gait run: how it ends, running, standing, or walking as above [default: running]"
    ))]
    pub(crate) to: Option<RunBound>,
    #[arg(long, value_name = "LINK", value_enum, default_value_t, hide_default_value = true, hide_possible_values = true, help = wrap(
        "What the forces are computed from: the pelvis outwards, or the foot that stands, as the thesis does; no force \
         depends on it [default: pelvis]"
    ))]
    pub(crate) root: RootLink,
    #[arg(long, value_name = "STYLE", value_enum, default_value_t, hide_default_value = true, hide_possible_values = true, help = wrap(&format!(
        "smooth: forces first, as people walk; thesis: through key postures, the body stopping at each, {} to {} \
         steps/min, {THESIS_WALK_RATIO}·height·frequency a step [default: smooth]",
        THESIS_STEP_FREQUENCY.0, THESIS_STEP_FREQUENCY.1
    )))]
    pub(crate) style: StyleName,
    #[arg(long, value_name = "N", value_enum, default_value_t, hide_default_value = true, hide_possible_values = true, help = wrap(
        "5: pelvic rotation, pelvic tilt, flexion of the stance knee, the foot's plantar flexion, compass gait; 3: without \
         the first and the foot's [default: 5]"
    ))]
    pub(crate) determinants: DeterminantCount,
    #[arg(
        long,
        value_name = "SIDE",
        value_enum,
        hide_possible_values = true,
        help = wrap("Which foot makes the first step [default: right, the inner one into a turn, the one that a cane helps]")
    )]
    pub(crate) first: Option<Side>,
    #[arg(long = "loop", value_name = "HOW", value_enum, hide_possible_values = true,
        conflicts_with_all = ["steps", "distance", "duration", "turn", "then", "path"], help = wrap(
        "One stride that repeats instead of a walk: on the spot (in-place), or going on (moving); its first frame does not come \
         again as its last. With --rate the step frequency is fitted to whole frames, without it the rate [default: a walk]"
    ))]
    pub(crate) repeats: Option<Loop>,
    #[arg(long, value_name = "HOW", value_enum, hide_possible_values = true, help = wrap(
        "Style thesis: from posture to posture by minimum jerk, at rest in each, or at an even pace (linear) [default: rest]"
    ))]
    pub(crate) in_betweens: Option<InBetweens>,
    #[arg(long, value_name = "LAW", value_enum, hide_possible_values = true, help = wrap(
        "Style thesis: how long both feet stand: the thesis's law, the measured one, or as long as the pelvis takes at an \
         even pace (travel) [default: thesis]"
    ))]
    pub(crate) double_support: Option<DoubleSupportLaw>,
    #[arg(long, value_name = "M", allow_hyphen_values = true, help = wrap(
        "Style thesis: amplitude of the pelvis' way to the sides, towards the foot that stands [default: 0]"
    ))]
    pub(crate) sway: Option<Number>,
}

/// With or without flight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Gait {
    #[default]
    Walk,
    Run,
}

/// Out of which link the forces are computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum RootLink {
    #[default]
    Pelvis,
    Foot,
}

/// How a walk is made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum StyleName {
    #[default]
    Smooth,
    Thesis,
}

impl StyleName {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Smooth => "smooth",
            Self::Thesis => "thesis",
        }
    }
}

/// How many determinants of gait.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum DeterminantCount {
    #[value(name = "3")]
    Three,
    #[default]
    #[value(name = "5")]
    Five,
}

impl From<DeterminantCount> for Determinants {
    fn from(count: DeterminantCount) -> Self {
        match count {
            DeterminantCount::Three => Self::Three,
            DeterminantCount::Five => Self::Five,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Side {
    Left,
    Right,
}

impl Side {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// One stride, and whether it stays on the spot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Loop {
    InPlace,
    Moving,
}

/// How a body goes from one key posture to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum InBetweens {
    Rest,
    Linear,
}

/// How long both feet stand between key postures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DoubleSupportLaw {
    Thesis,
    Measured,
    Travel,
}

/// What changes on the way.
#[derive(Debug, Args)]
pub(crate) struct ChangeArgs {
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true, help = wrap(&format!(
        "By how much each step turns to the left, -{turn} to {turn}°; beyond {in_all}° in all the root turns by its heading first. With \
         --step-length 0 it turns on the spot [default: 0]",
        turn = TURN.to_degrees().round(), in_all = TURN_IN_ALL.to_degrees().round()
    )))]
    pub(crate) turn: Option<Number>,
    #[arg(long, help = wrap(
        "Walk backward: on level ground, a slope or stairs, which rise along the way that it goes; of what comes next after standing, \
         --then steps=4,backward [default: forward]"
    ))]
    pub(crate) backward: bool,
    #[arg(long, value_name = "FILE.csv", conflicts_with_all = ["steps", "distance", "duration", "turn", "then"], help = wrap(
        "Walk along a way: a table with the columns x (to the left) and z (ahead) in m, points as the walker sees them who stands at 0, 0 \
         and faces along z. Corners are rounded, steps shorter in bends, and it ends at the last point [default: straight on]"
    ))]
    pub(crate) path: Option<PathBuf>,
    #[arg(long, value_name = "WHAT", value_parser = then::parse, help = wrap(
        "What comes next; several are allowed. steps=4,step-frequency=95,step-length=0.6,speed=1,turn=15: steps of another \
         pace or direction (with neither frequency, length nor speed the pace stays; else what is left out is people's); a short \
         step-length is a half step. Of a run: steps=10,speed=4. stand=2: stop and \
         stand for 2 s; what follows starts anew, and may be distance=3 instead of steps [default: nothing]"
    ))]
    pub(crate) then: Vec<Then>,
}
