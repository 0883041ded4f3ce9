//! The commands about figures: `figure`, `check`, `convert`.

use super::{BODY_MASS_INDEX, HEIGHT, input, json, path, size};
use clap::{Arg, ArgAction, Command};

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
      exit code 1 if anything looks wrong";

const CONVERT_EXAMPLES: &str = "Examples:
  solaris convert robot.urdf robot.ron
      a model of another program as a figure's text
  solaris convert human.ron child.ron --height 1.2 --mass 25
      the same figure in another size
  solaris convert walk.csv walk.mot
      a motion for OpenSim: the positions, in radians
  solaris convert ik.mot ik.csv --figure subject.osim
      degrees become radians where the figure says that a coordinate turns";

pub(super) fn commands() -> [Command; 3] {
    [figure(), check(), convert()]
}

fn figure() -> Command {
    let human = Command::new("human")
        .about("A human of 21 segments and 66 degrees of freedom")
        .after_help(FIGURE_EXAMPLES)
        .args(size().map(|arg| match arg.get_id().as_str() {
            "height" => arg.help(format!("Standing height, 0.8 to 2.3 m [default: {HEIGHT}]")),
            "mass" => arg.help(format!("Body mass in kg, met exactly [default: {BODY_MASS_INDEX}·height²]")),
            _ => arg.help("A segment's own length in m (thigh: both, left_thigh: one); several are allowed"),
        }))
        .arg(path("output").short('o').required(true).help("Where to write the figure: .ron"));
    Command::new("figure")
        .about("Writes a figure as text")
        .after_help(FIGURE_EXAMPLES)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand(human)
}

fn check() -> Command {
    let flag = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).action(ArgAction::SetTrue).help(help)
    };
    Command::new("check")
        .about("Says what a figure or a scene is and what looks wrong with it, or every fault of its text")
        .after_help(CHECK_EXAMPLES)
        .arg(input(
            "figure",
            "FILE",
            "A figure or a scene (.ron), URDF (.urdf), MuJoCo (.xml, .mjcf) or OpenSim (.osim) model",
        ))
        .arg(
            flag("dh", "Print the rationalised links: the Denavit-Hartenberg table of every chain")
                .conflicts_with("json"),
        )
        .arg(flag("strict", "Exit with 1 if anything looks wrong"))
        .arg(json("Print the summary as JSON instead of text"))
}

fn convert() -> Command {
    Command::new("convert")
        .about("A figure or a motion from one format to another")
        .after_help(CONVERT_EXAMPLES)
        .arg(input("from", "IN", "A figure (.ron, .urdf, .xml, .mjcf, .osim) or a motion (.csv, .mot, .sto)"))
        .arg(input("to", "OUT", "A figure as .ron, or a motion as .csv, .mot or .sto"))
        .arg(path("figure").help("Whose motion it is; needed where the motion is in degrees"))
        .next_help_heading("A figure in another size")
        .args(size())
}
