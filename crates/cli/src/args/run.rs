//! The options of `solaris run`.

use super::{input, json, path, wrap};
use clap::{Arg, ArgAction, Command};

const EXAMPLES: &str = "Examples:
  solaris run walk_loose_arm.ron -o walk.html
      a person walks with one loose arm; open walk.html in a browser
  solaris run pendulum.ron -o swing.csv -o swing.mot --report swing.json
      tables of the motion, and all that there is to say of the run as JSON
  solaris run arm_modes.ron --plan
      what is computed in which part of the run, what is left out, and what that saves";

pub(super) fn command() -> Command {
    Command::new("run")
        .about("Runs a scene: a figure, what drives it, and for how long")
        .after_help(EXAMPLES)
        .arg(input("scene", "SCENE.ron", "The scene; figures that it names as files are sought beside it"))
        .arg(path("output").short('o').action(ArgAction::Append).help(wrap(
            "Write the motion: .html page, .svg picture of the coordinates, .csv table, .bvh motion capture, .sto or .mot \
             coordinates for OpenSim; several -o are allowed [default: none]",
        )))
        .arg(
            path("report")
                .value_name("FILE.json")
                .help("Write what there is to say of the run as JSON [default: none]"),
        )
        .arg(Arg::new("plan").long("plan").action(ArgAction::SetTrue).help(wrap(
            "Print what was computed, what was left out, and the cost of one evaluation with and without that",
        )))
        .arg(json("Print what there is to say of the run as JSON instead of a table"))
}
