//! The request of `solaris inverse`.

use super::given::{self, CyclesArgs, FrameArgs, RecordArgs};
use super::ground::{ConsistentArgs, GROUND_OPTIONS, GroundArgs, STANCE_OPTIONS, STANCES};
use super::subject::SubjectArgs;
use super::wrap;
use clap::{Arg, ArgGroup, Args, ValueEnum};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "Examples:
  solaris inverse subject.osim walk.mot --external grf.mot --plate calcn_r= --plate calcn_l=1_ --filter 6Hz \\
      --filter-order 3 -o moments.sto
      joint moments of a measured walk on force plates; the left foot's columns begin with 1_
  solaris inverse subject.osim walk.mot --external-loads loads.xml --filter 6Hz -o moments.sto
      the same, with OpenSim's own description of the forces
  solaris inverse subject.osim trials/*.mot --external-loads loads/{}.xml --filter 6Hz -o out/ -o out/{}.html -o all.csv
      many motions on all cores: moments and a page of each, and a table with a row for each; {} is the motion's name
  solaris inverse subject.osim walk.mot --ground --soles soles.ron --cycles right --cycles-out stride.csv --cycles-out stride.svg
      angles and moments over the stride: mean and standard deviation at every percent
  solaris inverse generic.osim --markers walk.c3d --static static.c3d --mass 72.6 --filter 6Hz -o page.html
      from markers to moments: the model is brought to the person's size, plates are found under the feet
  solaris inverse robot.urdf trajectory.csv -o tau.csv
      motor torques of a robot
  solaris inverse human.ron walk.csv --external walk.csv --plate left_foot+left_toes=left_foot \\
      --plate right_foot+right_toes=right_foot -o tau.csv
      a walk of `solaris walk`: the toes carry the force once the centre of pressure has passed the ball
  solaris inverse subject.osim walk.mot --ground --soles soles.ron --filter 6Hz -o moments.sto
      joint moments without force plates: the ground's forces are found from the motion (solaris ground)
  solaris inverse human.ron clip.csv --ground --consistent --motion-out moved.csv -o tau.csv
      joint torques of an animation whose root is moved before, by the least after which the ground can bear it";

/// A figure in a motion, of which the joints' forces are found.
#[derive(Debug, Args)]
#[command(
    about = "Joint torques of a given motion, or of many",
    after_help = EXAMPLES,
    mut_args(needs_ground),
    group = ArgGroup::new("feet").args(["ground", "foot"]).multiple(true),
    group = ArgGroup::new("pushed").args(["ground", "foot", "forces", "loads"]).multiple(true)
)]
pub(crate) struct InverseArgs {
    #[arg(value_name = "FIGURE", help = wrap(given::FIGURE))]
    pub(crate) figure: PathBuf,
    #[arg(id = "trials", value_name = "MOTION", required_unless_present = "marker_files", num_args = 1.., help = wrap(&format!(
        "{}. Several are allowed: they are taken at once, on all cores", given::MOTION
    )))]
    motions: Vec<PathBuf>,
    #[arg(id = "marker_files", long = "markers", value_name = "FILE", conflicts_with = "trials", help = wrap(
        "The same as MOTION, of markers: .c3d (with its force plates) or .trc; several are allowed"
    ))]
    marker_files: Vec<PathBuf>,
    #[arg(short = 'o', long = "output", value_name = "FILE", help = wrap(
        "Write the torques: .csv with columns DOF.tau, or .sto with OpenSim's names; draw them: .svg; or show all of it on a \
         page: .html. Of several motions: a folder for NAME.sto, a file for each (out/{}.html, where {} is the motion's name), or \
         .csv with a row for each [default: none]"
    ))]
    pub(crate) outputs: Vec<PathBuf>,
    #[arg(long, help = "Print the summary as JSON instead of a table")]
    pub(crate) json: bool,
    #[command(flatten, next_help_heading = "Forces from outside")]
    pub(crate) external: ExternalArgs,
    #[command(flatten, next_help_heading = "Forces found from the motion")]
    pub(crate) predicted: PredictedArgs,
    #[command(flatten, next_help_heading = "Strides")]
    pub(crate) cycles: CyclesArgs,
    #[command(flatten, next_help_heading = "The motion")]
    pub(crate) record: RecordArgs,
    #[command(flatten, next_help_heading = "A figure that is brought to a person's size")]
    pub(crate) subject: SubjectArgs,
    #[command(flatten, next_help_heading = "The figure")]
    pub(crate) frame: FrameArgs,
    #[arg(
        long, value_name = "ON|OFF", value_enum, default_value_t, hide_default_value = true, hide_possible_values = true,
        help = wrap("Whether armature, damping, springs and friction of the joints, and a fluid around, count [default: on]")
    )]
    pub(crate) passive: Switch,
    #[arg(long, value_name = "ON|OFF", value_enum, hide_possible_values = true, help = wrap(
        "Whether to find how far angles and moments may be off, by what markers leave over, by the choice of the filter's cut-off and \
         by the residual [default: on for markers]"
    ))]
    pub(crate) bands: Option<Switch>,
}

impl InverseArgs {
    /// The motions' files.
    pub(crate) fn motions(&self) -> Vec<&PathBuf> {
        self.motions.iter().chain(&self.marker_files).collect()
    }

    /// The same as paths.
    pub(crate) fn trials(&self) -> Vec<&Path> {
        self.motions().into_iter().map(PathBuf::as_path).collect()
    }
}

/// Where neither the ground nor strides are asked for, nothing is asked of feet.
fn needs_ground(arg: Arg) -> Arg {
    match arg.get_id().as_str() {
        // A page draws them in any case.
        "soles" => arg.requires("pushed"),
        id if GROUND_OPTIONS.contains(&id) => arg.requires("ground"),
        id if STANCE_OPTIONS.contains(&id) => arg.requires("feet"),
        _ => arg,
    }
}

/// What pushes from outside.
#[derive(Debug, Args)]
pub(crate) struct ExternalArgs {
    #[arg(long = "external", value_name = "FILE", conflicts_with = "loads", help = wrap(
        "Measured forces: .mot, .sto (forces, centre of pressure, free moment) or .csv (as `solaris walk` writes). Without --plate \
         its columns push the links that they are called by, or else the feet that the soles find on its plates. Of several motions {} stands \
         for each one's name: grf/{}.mot"
    ))]
    pub(crate) forces: Option<PathBuf>,
    #[arg(
        long = "plate", value_name = "LINK=PREFIX", requires = "forces", conflicts_with = "loads", value_parser = parse_plate,
        help = wrap(
            "Which link which columns push: PREFIX is what stands before ground_force_vx (may be empty) or before .fx, or within, \
             as r in ground_force_r_vx; LINK may be two, HEEL+TOES: the second once the centre of pressure has passed the ball. Several are allowed"
        )
    )]
    pub(crate) plates: Vec<(Vec<String>, String)>,
    #[arg(
        long = "external-loads",
        value_name = "FILE.xml",
        help = "The same as OpenSim's ExternalLoads file"
    )]
    pub(crate) loads: Option<PathBuf>,
}

/// Whether and how the ground's forces are found.
#[derive(Debug, Args)]
pub(crate) struct PredictedArgs {
    #[arg(long, conflicts_with_all = ["forces", "loads", "plates"], help = wrap(
        "Find the ground's forces on the feet from the motion itself, as `solaris ground` does"
    ))]
    pub(crate) ground: bool,
    #[command(flatten)]
    pub(crate) how: GroundArgs,
    #[arg(long, value_name = "FILE", help = wrap(STANCES))]
    pub(crate) stances: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) consistent: ConsistentArgs,
}

/// Whether something counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Switch {
    #[default]
    On,
    Off,
}

/// The links that a plate pushes, and what its columns begin with.
fn parse_plate(text: &str) -> Result<(Vec<String>, String), String> {
    let (links, prefix) = text
        .split_once('=')
        .ok_or("it must be LINK=PREFIX, such as calcn_r= or left_foot+left_toes=left_foot")?;
    let links: Vec<String> = links.split('+').map(|link| link.trim().to_owned()).collect();
    if links.iter().any(String::is_empty) || links.len() > 2 {
        return Err("before '=' stands one link, or two with '+' between them".to_owned());
    }
    Ok((links, prefix.to_owned()))
}
